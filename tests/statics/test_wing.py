"""Where the bars of a wing are, against the simulator's record, rigid folding, and numerical differentiation."""

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.spatial.distance import pdist

from forficula.design import load_design, with_values
from forficula.pattern import earwig_pattern, fan_fold_angles, folded_coordinates
from forficula.statics.wing import FOLD, TURN, flat_wing, pose

REFERENCE = load_design("binder2025")
JOINTS = ("sweep_angle", "lift_angle", "turn_angle", "distal_angle")


def some_angles(seed, veins, cases=1):
    return np.random.default_rng(seed).uniform(-1, 1, (cases, veins, 4))


def test_the_points_of_a_wing_are_where_the_simulator_has_them(reference_run):
    wing = flat_wing(reference_run.design)
    angles = np.stack([reference_run.series[name] for name in JOINTS], axis=2)
    assert np.degrees(np.ptp(angles, axis=0)).max() > 90
    points = pose(wing, angles).points
    nodes = reference_run.series["membrane_position"]
    # rounding of the engine's, in its own units
    assert points[:, : nodes.shape[1]] == pytest.approx(nodes, abs=1e-12)
    assert points[:, wing.tips] == pytest.approx(reference_run.series["vein_position"][:, :, 2], abs=1e-12)


@pytest.mark.parametrize(
    "changes", [{}, {"pattern.units": 3}, {"pattern.tangent": "left"}, {"pattern.hub_radius": 0.0}]
)
def test_without_angles_the_wing_is_flat(changes):
    wing = flat_wing(with_values(REFERENCE, changes))
    points = pose(wing, np.zeros((1, len(wing.hub), 4))).points[0]
    # rounding
    assert points == pytest.approx(wing.flat, abs=1e-15)
    assert points[:, 2] == pytest.approx(0, abs=1e-15)


@settings(deadline=None)
@given(st.integers(0, 1000))
def test_the_moves_are_derivatives_of_the_points(seed):
    wing, small = flat_wing(REFERENCE), 1e-6
    angles = some_angles(seed, len(wing.hub))
    at = pose(wing, angles)
    for vein in range(len(wing.hub)):
        for joint in range(4):
            step = np.zeros_like(angles)
            step[0, vein, joint] = small
            moved = (pose(wing, angles + step).points - pose(wing, angles - step).points)[0] / (2 * small)
            own = wing.carriers == vein
            # central differences: points of 0.2 m turn with third derivatives as long, times 1e-12; rounding by 1e-6
            assert moved[own] == pytest.approx(at.moves[0, own, joint], abs=1e-9)
            assert not moved[~own].any()


@settings(deadline=None)
@given(st.floats(0.01, 0.03), st.floats(10, 30), st.floats(0, 179.9))
def test_along_the_rigid_fold_a_margin_lies_on_its_vein_as_folded_paper_does(hub, sector, pleat):
    """Distances within what a vein carries are those of rigid panels, theory.md, section 2, mode I."""
    changes = {"pattern.hub_radius": hub, "pattern.sector_angle": math.radians(sector), "vein.diameter": 1e-4}
    wing = flat_wing(with_values(REFERENCE, {**changes, "membrane.margin": 0.01}))
    fan = wing.design.fan
    pattern, folds = earwig_pattern(fan), fan_fold_angles(fan, math.radians(pleat))
    folded = folded_coordinates(pattern, folds)
    angles = np.zeros((1, len(wing.hub), 4))
    angles[0, :, TURN] = math.radians(pleat) / 2
    angles[0, :, FOLD] = -abs(folds[pattern.edges_role.index("ring")])
    points = pose(wing, angles).points[0]
    panels = len(wing.hub) - 1
    of_panel = np.repeat(np.arange(panels), (len(wing.points) - len(wing.hub)) // panels)
    for panel in range(panels):
        near = np.flatnonzero((of_panel == panel) & (wing.carriers[: len(of_panel)] == panel)).tolist()
        rigid = []
        for point in near:
            face = pattern.faces_vertices[panel + panels * wing.beyond[point]]
            corners = np.column_stack([pattern.vertices_coords[list(face), :2], np.ones(4)])
            onto = np.linalg.lstsq(corners, folded[list(face)])[0]
            rigid.append([*wing.flat[point, :2], 1] @ onto)
        placed = [*points[near], wing.hub[panel], points[wing.tips[panel]]]
        rigid += [folded[panel], folded[panel + 2 * len(wing.hub)]]
        # `folded_coordinates` closes to 1e-9 of the size
        assert pdist(placed) == pytest.approx(pdist(rigid), abs=1e-9)
