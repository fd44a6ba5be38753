"""The design as made has the pegs, stops, masses and inertias that are measured on solids."""

import math

import numpy as np
import pytest

from forficula.design import load_design
from forficula.errors import InputError
from forficula.make.as_made import as_made, changes, write_as_made
from forficula.make.checks.check_parts import coupling_checks
from forficula.make.files.bill import bill_of
from forficula.make.hinge.free_range import free_range
from forficula.make.hinge.joint import turned
from forficula.make.made_values import made_values
from forficula.make.make_parts import make_parts
from forficula.make.unkept import unkept
from forficula.statics import tendon_hinges
from forficula.structure import structure_of


@pytest.fixture(scope="module")
def made(made_joint):
    return as_made(made_joint)


def test_the_closed_form_of_the_design_as_made_is_the_distance_of_the_pegs(made_joint, made):
    joint, hinge = made_joint.joints[0], tendon_hinges(structure_of(made))[0]
    inner, outer = joint.peg_of(joint.proximal), joint.peg_of(joint.distal)
    for angle in np.linspace(joint.lower, joint.upper, 50):
        frame, origin = turned(joint, float(angle))
        apart = float(np.linalg.norm(frame @ outer + origin - inner))
        assert float(hinge.length(angle)) == pytest.approx(apart, abs=1e-12)


def test_measured_stops_equal_built_ones(made_joint):
    measured = np.degrees(free_range(made_joint, made_joint.joints[0]))
    assert measured == pytest.approx([-180.0, 3.0], abs=0.01)


def test_colliding_pegs_stop_a_joint_before_its_stop():
    parts = make_parts("binder2025", "joint")
    lower, _ = free_range(parts, parts.joints[0])
    assert -math.pi + math.radians(1) < lower < -math.radians(150)
    made = as_made(parts)
    assert made.hinge.fold_limit == pytest.approx(-lower, abs=math.radians(0.005))
    assert [change.key for change in changes(parts, made) if change.group == "stops"] == ["hinge.fold_limit"]


def test_parts_of_the_design_as_made_agree_with_it(made):
    parts = make_parts(made, "joint")
    # straps of whole layers have shorter pegs, which are lighter
    assert {change.group for change in changes(parts, as_made(parts))} <= {"masses"}


def test_parts_as_modelled_change_only_masses(joint_of):
    # straps of whole layers, pegs at the designed offsets
    values = {"tendon.stiffness": "9.84 N/cm", "tendon.proximal_offset": "3 mm", "tendon.distal_offset": "3 mm"}
    parts = joint_of(**values)
    changed = changes(parts, as_made(parts))
    assert {item.group for item in changed} == {"masses"}
    assert {item.key for item in changed} >= {"vein.density", "vein.added_mass", "tendon.density"}


def test_outer_halves_have_their_mass_and_inertia_about_the_hinge(made_joint, made):
    rows = {(item.part, item.name): item for item in unkept(made_joint, made)}
    for name in ("mass", "inertia about its hinge"):
        row = rows["distal0", name]
        assert row.modelled == pytest.approx(row.real, rel=1e-5)
    row = rows["distal0", "first moment along the bar"]
    assert row.modelled != pytest.approx(row.real, rel=0.02)


def test_mass_of_straps_is_included(made_joint, made):
    straps = [part for part in made_joint.parts if part.kind == "strap"]
    printed = made_values(made_joint).tendons[0].by_area
    assert made.tendon.mass == pytest.approx(printed * sum(part.count * part.mass for part in straps), rel=1e-5)


def test_some_groups_alone_are_taken_from_the_parts(made_joint):
    design = as_made(made_joint, ("offsets",))
    assert {change.group for change in changes(made_joint, design)} == {"offsets"}
    assert design.tendon.proximal_offset == pytest.approx(made_joint.joints[0].standoff)


def test_the_file_gives_the_same_design(made_joint, made, tmp_path):
    path = write_as_made(made_joint, tmp_path)
    assert path.name == "as-made.toml"
    assert load_design(path) == made
    assert made.name == "binder2025-as-made"
    assert made.source.startswith("binder2025 as its parts are made: ")


def test_parts_that_stop_before_the_folded_angle_are_rejected(joint_of):
    parts = joint_of(**{"protocol.folded_angle": "179 deg", "make.anchors": "as designed",
                        "tendon.proximal_attachment": "5.5 cm", "tendon.distal_attachment": "5.5 cm"})  # fmt: skip
    with pytest.raises(InputError, match=r"the design as made cannot be run: .*folded_angle"):
        as_made(parts)


def test_a_sheet_alone_has_nothing_to_measure():
    with pytest.raises(InputError, match="has no joints that could be measured"):
        as_made(make_parts("letter-fold", "sheet"))


def test_a_coupling_without_a_part_fails_its_check_and_is_not_in_the_design_as_made():
    parts = make_parts("binder2025-coupled", "section")
    made = as_made(parts, ("coupling",))
    assert [change.designed for change in changes(parts, made) if change.group == "coupling"] == ["rigid"]
    assert made.coupling is None
    assert [check.ok for check in coupling_checks(parts)] == [False]


def test_mass_of_straps_in_the_bill_equals_that_in_the_design_as_made(made_joint):
    (tendon,) = made_values(made_joint).tendons
    (row,) = [row for row in bill_of(made_joint) if row.kind == "strap"]
    assert tendon.mass is not None
    assert row.count * row.mass == pytest.approx(tendon.mass, rel=1e-6)
