"""The joint as a structure: its support, its folding sense, and its agreement with a vein of the fan."""

from dataclasses import replace

import numpy as np
import pytest

from forficula.design import load_design
from forficula.structure import built_points, structure_of
from forficula.structure.fans.joint import joint_vein
from forficula.structure.fans.veins import structure_of_veins
from tests.structures import supports

JOINT = "binder2025-joint"


def test_its_proximal_bar_is_held_and_one_hinge_is_all_that_moves():
    structure = structure_of(load_design(JOINT))
    assert supports(structure) == ["proximal0"]
    (hinge,) = structure.hinges
    assert (hinge.role, np.degrees([hinge.lower, hinge.upper])) == ("ring", pytest.approx([-180.0, 3.0]))
    assert not structure.membranes
    assert not structure.limits


def test_its_points_lie_on_its_sheet():
    design = load_design(JOINT)
    structure, sheet = structure_of(design), design.pattern.sheet
    places = dict(zip([point.name for point in structure.points], built_points(structure), strict=True))
    ends = [sheet.vertices_coords[vertex] for vertex in (1, 4, 7)]
    assert np.array([places[name] for name in ("hub0", "ring0", "tip0")]) == pytest.approx(np.array(ends), abs=1e-15)
    # off the sheet by their offsets, on the side of the overbend, which is below a valley
    assert places["proximal_attachment0"][2] == pytest.approx(-0.003)
    assert places["distal_attachment0"][2] == pytest.approx(-0.003)


@pytest.mark.parametrize(("sense", "up"), [("valley", 1), ("mountain", -1)])
def test_it_folds_up_as_a_valley_and_down_as_a_mountain(sense, up):
    vein = joint_vein(load_design(JOINT, {"pattern.sense": sense}))
    # a rotation to negative angles in its folding sense folds it
    moved = -vein.sense * np.cross(vein.axes[0], vein.places[2] - vein.places[1])
    assert np.sign(moved[2]) == up


def test_both_senses_are_mirror_images():
    crossings = [
        structure_of(load_design(JOINT, {"pattern.sense": sense})).tendons[0].crossing
        for sense in ("valley", "mountain")
    ]
    assert crossings[0] == crossings[1]


def test_with_the_angles_of_a_fan_it_is_that_fans_vein_with_its_base_held():
    fan = load_design("binder2025-built", {"membrane.density": "0 g/cm^3", "medium.density": "0 kg/m^3"})
    settings = {
        "pattern.proximal_sector": "87.12501635 deg",
        "pattern.distal_sector": "107.12501635 deg",
        **{f"vein.{key}": value for key, value in fan.vein.as_tables().items()},
        "hinge.armature": "0 kg m^2",
        "tendon": fan.tendon.as_tables(),
    }
    joint = load_design(JOINT, settings)
    alone = structure_of_veins(fan, (joint_vein(joint),))
    other = structure_of(fan).tendons[1].crossing
    for crossing in (structure_of(joint).tendons[0].crossing, alone.tendons[0].crossing):
        assert crossing.hinge == 0
        same = replace(crossing, hinge=other.hinge)
        for name in ("proximal_arm", "distal_arm", "axial_offset", "offset_angle", "inertia"):
            assert getattr(same, name) == pytest.approx(getattr(other, name), rel=1e-8), name
