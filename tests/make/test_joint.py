"""A joint moves through its range and stops where the design says; parts that cannot be made are reported."""

import math
from dataclasses import replace

import numpy as np
import pytest

from forficula.design import load_design
from forficula.errors import InputError
from forficula.make.checks.printing_checks import printing_checks
from forficula.make.checks.range_checks import lug_checks, pin_checks, range_checks, stop_angles, strap_checks
from forficula.make.checks.strength_checks import strength_checks
from forficula.make.hinge.joint import turned
from forficula.make.hinge.joint_layout import joint_layouts
from forficula.make.hinge.strap_shape import strap_line
from forficula.make.make_parts import make_parts
from forficula.make.solid.mesh import placed
from forficula.structure import structure_of


def held(parts, name):
    return [check.ok for check in range_checks(parts) if check.name == name]


def test_a_joint_goes_through_its_range_and_keeps_its_clearance(made_joint):
    checks = list(range_checks(made_joint))
    assert [check.ok for check in checks] == [True] * len(checks)


@pytest.mark.parametrize(("overbend", "fold"), [(0.0, 180.0), (3.0, 180.0), (12.0, 150.0), (30.0, 90.0)])
def test_stops_are_where_the_design_has_them(joint_of, overbend, fold):
    parts = joint_of(**{"hinge.overbend": f"{overbend} deg", "hinge.fold_limit": f"{fold} deg",
                        "protocol.initial_overbend": "0 deg", "protocol.folded_angle": "60 deg"})  # fmt: skip
    assert np.degrees(stop_angles(parts, parts.joints[0])) == pytest.approx([-fold, overbend], abs=0.01)


def test_a_displaced_stop_is_detected(made_joint):
    joint = made_joint.joints[0]
    off = replace(joint, upper=joint.upper + math.radians(0.5))
    checks = {check.name: check.ok for check in range_checks(replace(made_joint, joints=(off,)))}
    # the layout has the stops of the design, but the parts are those of another one
    assert checks["overlap over the range"] is False


def test_a_pin_too_thick_for_its_hole_is_detected(made_joint):
    joint = made_joint.joints[0]
    (pin,) = (part for part in made_joint.parts if part.kind == "pin")
    thick = replace(pin, solid=replace(pin.solid, diameter=joint.make.pin_diameter + joint.play))
    others = tuple(part for part in made_joint.parts if part.kind != "pin")
    for parts, holds in ((made_joint, True), (replace(made_joint, parts=(*others, thick)), False)):
        assert [check.ok for check in pin_checks(parts)] == [holds]


def test_mountain_and_valley_joints_are_mirror_images(made_section):
    first, second = made_section.joints[:2]
    assert first.frame[2, 2] == pytest.approx(-second.frame[2, 2])
    volumes = [next(part for part in made_section.parts if part.body == joint.distal.body).volume
               for joint in (first, second)]  # fmt: skip
    assert volumes[0] == pytest.approx(volumes[1], rel=1e-6)


def test_one_strap_between_the_bars_collides_as_in_the_paper(joint_of):
    parts = joint_of(**{"make.straps": 1})
    (check,) = (check for check in strap_checks(parts) if check.name == "straps slack")
    assert check.ok is False
    assert "make.straps = 2" in check.text


def test_overlapping_pegs_in_the_folded_state_are_detected(joint_of):
    parts = joint_of(**{"tendon.proximal_attachment": "5.5 cm", "tendon.distal_attachment": "5.5 cm",
                        "hinge.overbend": "3 deg", "make.anchors": "as designed"})  # fmt: skip
    assert held(parts, "overlap over the range") == [False]


def test_a_joint_in_one_piece_keeps_its_clearance_around_its_axle(joint_of):
    parts = joint_of(**{"make.hinge": "print-in-place"})
    assert held(parts, "least gap") == [True]
    proximal, distal = parts.parts[:2]
    assert [part.kind for part in parts.parts] == ["bar", "bar", "strap"]
    middle = placed(distal.shape, *turned(parts.joints[0], -1.0))
    assert proximal.shape.min_gap(middle, 2.0) == pytest.approx(0.4, abs=0.005)
    assert len(proximal.shape.decompose()) == 1


@pytest.mark.parametrize(
    ("checks", "values", "failing"),
    [
        (strength_checks, {"make.peg_diameter": "2 mm"}, "bending of the pegs"),
        (strength_checks, {"vein.diameter": "3 mm"}, "buckling of the bars"),
        (strength_checks, {"make.pin_diameter": "0.3 mm", "make.pin_material": "petg"}, "shear of the pin"),
        (strength_checks, {"make.hinge_wall": "0.05 mm"}, "knuckles tear"),
        (
            strength_checks,
            {"make.anchors": "as designed", "tendon.proximal_offset": "20 mm"},
            "bending of the peg's foot",
        ),
        (strength_checks, {"make.hinge": "print-in-place"}, "bending of the pin"),
        (printing_checks, {"make.hinge_wall": "0.5 mm"}, "thinnest wall"),
        (printing_checks, {"make.strap_thickness": "4 mm"}, "strap bends on its flat side"),
        (range_checks, {"tendon.proximal_attachment": "12 cm"}, "peg on its bar"),
        (range_checks, {"tendon.distal_attachment": "5 mm"}, "peg on its bar"),
        (range_checks, {"tendon.rest_length": "30 cm"}, "straps taut"),
    ],
)
def test_what_is_too_weak_or_too_thin_or_out_of_place_fails(joint_of, checks, values, failing):
    assert any(check.name == failing and check.ok is False for check in checks(joint_of(**values)))


def test_a_check_without_a_strength_is_skipped_with_a_reason(joint_of):
    parts = joint_of(**{"make.strap_material": "tpu-82a"})
    (check,) = (check for check in strength_checks(parts) if check.name == "straps tear")
    assert check.ok is None
    assert "no source gives the strength" in check.text


def test_the_hinges_width_must_have_room_for_its_knuckles(joint_of):
    with pytest.raises(InputError, match=r"make.hinge_width: no space for three knuckles: need >= 2.4 mm"):
        joint_of(**{"make.hinge_width": "2 mm"})


@pytest.mark.parametrize(
    ("values", "part"),
    [({"make.pin_diameter": "1e-9 mm"}, "pin_fold0")],
)
def test_an_empty_part_is_rejected_and_named(joint_of, values, part):
    with pytest.raises(InputError, match=rf"^{part}: nothing is left of this part; it is too thin"):
        _ = [part.shape for part in joint_of(**values).parts]


def test_a_strap_so_thin_that_it_is_wider_than_it_is_long_is_refused_before_anything_is_built(joint_of):
    said = r"^make\.strap_thickness: makes tendon a strap 3\.659e\+06 m wide and 9 cm long; need more, got 1e-06 µm$"
    with pytest.raises(InputError, match=said):
        joint_of(**{"make.strap_thickness": "1e-9 mm"})


def test_a_structure_without_bars_has_no_joint_and_says_what_to_do():
    with pytest.raises(InputError, match=r"miura-sheet: no bar is hinged to another.*--part sheet"):
        make_parts("miura-sheet", "joint")


def test_another_part_is_refused():
    with pytest.raises(InputError, match=r'part: need "all", "sheet", "joint" or "section".*joint'):
        make_parts("binder2025", "joints")


def test_pegs_as_designed_lie_where_the_tendon_of_the_model_ends():
    design = load_design("binder2025").with_values({"tendon.proximal_offset": "2 mm"})
    structure = structure_of(design)
    from forficula.structure import built_points

    places = built_points(structure)
    for joint in joint_layouts(design, structure):
        ends = [places[point] for point in structure.tendons[joint.tendon].points]
        assert joint.peg_of(joint.proximal) == pytest.approx(ends[0], abs=1e-12)
        assert joint.peg_of(joint.distal) == pytest.approx(ends[1], abs=1e-12)
        assert joint.proximal.height == pytest.approx(2e-3)


def test_a_slack_strap_keeps_its_length_and_its_ends(made_joint):
    (place,), joint = made_joint.straps, made_joint.joints[0]
    axis = joint.frame[:, 1]
    for angle in np.radians([-180, -120, -90]):
        frame, by = turned(joint, angle)
        for start, end in place.ends:
            line = strap_line(place, start, frame @ end + by, axis, 1)
            assert line[-1] == pytest.approx(frame @ end + by, abs=1e-9)
            length = np.linalg.norm(np.diff(line, axis=0), axis=1).sum()
            assert length == pytest.approx(place.strap.rest_length, rel=2e-3)


def test_gussets_shorter_than_their_two_lugs_are_named():
    output = {check.part: check.ok for check in lug_checks(make_parts("binder2025-thick", "section"))}
    assert [part for part, ok in output.items() if not ok] == ["gusset0", "gusset1"]


def test_first_joint_of_a_vein_with_two_folds_includes_all_joints_of_its_tendon():
    parts = make_parts("binder2025-thick", "joint")
    assert [joint.name for joint in parts.joints] == ["fold0", "outer_fold0"]
    assert [part.name for part in parts.parts if part.kind in ("bar", "strap")] == [
        "proximal0", "gusset0", "distal0", "strap0"]  # fmt: skip
