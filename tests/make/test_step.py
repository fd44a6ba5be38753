"""The same tree of solids in a second kernel, Open Cascade, with true cylinders."""

import math
import os
import re
import sys

import pytest

import forficula as ff
from forficula.make.files.step import check_step, shape_gap, shape_of, shape_volume, write_step
from forficula.make.hinge.joint import turned
from forficula.make.solid.mesh import placed
from forficula.make.solid.solids import moved

MISSING = 'Open Cascade is not there: pip install "forficula[step]", or make test-step'
# set by make test-step: these tests then fail without Open Cascade
DEMANDED = "FORFICULA_STEP" in os.environ


def test_missing_open_cascade_is_reported(monkeypatch):
    monkeypatch.setitem(sys.modules, "OCP", None)
    monkeypatch.setitem(sys.modules, "OCP.STEPCAFControl", None)
    with pytest.raises(ff.InputError, match=r'pip install "forficula\[step\]"'):
        check_step()


@pytest.fixture(scope="module")
def joint():
    if DEMANDED:
        import OCP.gp  # noqa: F401
    else:
        pytest.importorskip("OCP.gp", reason=MISSING)
    return ff.make.parts("binder2025-joint", "joint")


def test_both_kernels_have_the_same_volumes(joint):
    from OCP.BRepCheck import BRepCheck_Analyzer
    from OCP.TopAbs import TopAbs_ShapeEnum

    assert len(joint.parts) == 4
    for part in joint.parts:
        shape = shape_of(part.solid)
        assert BRepCheck_Analyzer(shape).IsValid()
        assert shape.ShapeType() == TopAbs_ShapeEnum.TopAbs_SOLID
        # circles are polygons of the same area: much closer than the required 0.5 %
        assert part.volume == pytest.approx(shape_volume(shape), rel=1e-5)


def test_both_kernels_have_the_same_gap_in_the_middle_of_the_range(joint):
    frame, origin = turned(joint.joints[0], math.radians(-90))
    proximal, distal = joint.parts[:2]
    theirs = shape_gap(shape_of(proximal.solid), shape_of(moved(distal.solid, frame, origin)))
    ours = placed(distal.shape, frame, origin).min_gap(proximal.shape, 2.0) / 1e3
    assert theirs == pytest.approx(0.4e-3, rel=1e-6)  # make.clearance
    assert ours == pytest.approx(theirs, rel=5e-3)


def test_a_step_file_is_silent_has_name_material_and_mm_and_the_same_bytes(joint, tmp_path, capfd):
    pin = next(part for part in joint.parts if part.kind == "pin")
    for name in ("one", "two"):
        write_step(pin, tmp_path / f"{name}.step")
    assert capfd.readouterr() == ("", "")
    text = (tmp_path / "one.step").read_text()
    assert text == (tmp_path / "two.step").read_text()
    assert "PRODUCT('pin_fold0','pin_fold0'" in text
    assert "DESCRIPTIVE_REPRESENTATION_ITEM('steel','steel')" in text
    assert "SI_UNIT(.MILLI.,.METRE.)" in text
    (radius,) = {float(item) for item in re.findall(r"CYLINDRICAL_SURFACE\('',#\d+,([\d.]+)\)", text)}
    assert radius == pytest.approx(1.0)
