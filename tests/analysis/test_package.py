"""The room that shapes take, compared with boxes, balls and tetrahedra in random orientations."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

from forficula.analysis.package import open_package, package_of, packages, smallest_package
from forficula.analysis.summary import summary
from forficula.design import load_design, with_values
from forficula.dynamics import compile_model, simulate

turn = st.tuples(*[st.floats(-math.pi, math.pi)] * 3)
turns = turn.map(lambda angles: Rotation.from_euler("xyz", angles).as_matrix())
sides = st.tuples(*[st.floats(0.1, 10.0)] * 3).map(sorted)


def box(lengths):
    return np.array([[x, y, z] for x in (0, lengths[0]) for y in (0, lengths[1]) for z in (0, lengths[2])])


@given(sides, turns, st.floats(0, 0.1))
def test_the_packaged_size_of_a_box_does_not_depend_on_its_orientation(lengths, turn, radius):
    result = package_of(box(lengths) @ turn.T, radius)
    low, middle, high = lengths
    assert (result.height, result.width) == pytest.approx((low + 2 * radius, middle + 2 * radius), rel=1e-9)
    assert result.length == pytest.approx(high + 2 * radius, rel=1e-9)
    # Steiner's formula for the outline of a rectangle with a margin
    outline = middle * high + 2 * radius * (middle + high) + math.pi * radius**2
    assert result.area == pytest.approx(outline, rel=1e-9)


def test_a_tetrahedron_is_thinnest_between_two_edges():
    """The width of a regular tetrahedron is its side / sqrt(2), between opposite edges, and not its height."""
    corners = np.array([[1, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1]]) / (2 * math.sqrt(2))
    assert package_of(corners, 0.0).height == pytest.approx(1 / math.sqrt(2))


def test_a_flat_sheet_is_as_high_as_its_bars():
    corners = np.array([[0, 0, 0], [2, 0, 0], [2, 1, 0], [0, 1, 0], [1, 0.5, 0]], dtype=float)
    result = package_of(corners, 0.01)
    assert result.height == pytest.approx(0.02)
    assert abs(result.upwards[2]) == pytest.approx(1)
    assert (result.width, result.length) == pytest.approx((1.02, 2.02))


def test_the_folded_wing_has_the_smallest_packaged_size_in_its_summary(reference_run, reference_outcome):
    name, time, package = smallest_package(reference_run)
    assert name == "folded"
    assert time == pytest.approx(reference_outcome.states["folded"].time, abs=2e-3)
    result = packages(reference_run)
    assert result["flat"][1].area_ratio == pytest.approx(1, abs=0.01)
    assert package.area_ratio == pytest.approx(package.area / open_package(reference_run).area)
    # thicker than three bars side by side, thinner than the wing's width
    assert 0.005 < package.height < package.width < package.length
    output = summary(reference_run, reference_outcome, versions={})["package"]
    assert (output["state"], output["height_m"]) == ("folded", package.height)
    assert set(output["states"]) == {"flat", "folded", "opened"}


def wing_of(values):
    """Return the wing as built, after one step."""
    stage = {"name": "wait", "drive": "none", "until": "time", "hold": 0.0, "time_limit": 2e-4}
    design = with_values(
        load_design("binder2025"), {"protocol.initial_overbend": 0.0, "protocol.stages": [stage]} | values
    )
    return simulate([compile_model(design)])[0]


@pytest.mark.parametrize("diameter", [0.005, 0.002])
def test_a_flat_wing_is_as_high_as_its_veins_are_thick(diameter):
    assert open_package(wing_of({"vein.diameter": diameter})).height == pytest.approx(diameter, rel=1e-9)


def test_two_plates_at_a_right_angle_have_the_packaged_size_of_their_sides_and_thickness():
    """Plates 3 and 4 cm long, 2 cm wide and 2 mm thick: smallest across the width plus twice the margin of 1 mm."""
    stage = {"name": "wait", "drive": "none", "until": "time", "hold": 0.0, "time_limit": 4e-5}
    design = with_values(
        load_design("force-clasp"),
        {
            "crease.start": math.pi / 2,
            "crease.fold_limit": math.pi,
            "protocol.stages": [stage],
            "crease.extension": None,
        }
        | {"crease.extension_damping": None, "crease.rest_angle": math.pi / 2, "tendon": [], "drive": []},
    )
    height = open_package(simulate([compile_model(design)])[0]).height
    assert height == pytest.approx(0.02 + 0.002, rel=1e-6)


def test_a_wing_that_did_not_fold_has_no_packaged_size_of_the_folded_state(reference_run):
    assert set(packages(reference_run)) == {"flat", "folded", "opened"}
    stuck = with_values(reference_run.design, {"protocol.fold_torque": 0.01, "protocol.stages.1.time_limit": 0.1})
    assert "folded" not in packages(simulate([compile_model(stuck)])[0])
