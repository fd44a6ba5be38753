"""Positions of bodies and points, compared with the simulator's record, rigid folding, and successive rotations."""

import dataclasses
import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.spatial.distance import pdist
from scipy.spatial.transform import Rotation

from forficula.design import load_design, with_values
from forficula.pattern import earwig_pattern, fan_fold_angles, folded_coordinates
from forficula.statics.tree.pose import carried_points, moves_of, places_of, pose, span, tree_of
from forficula.structure import GROUND, built_points, hinges_of, structure_of
from tests.statics.trees import tree

REFERENCE = load_design("binder2025")


def placed(structure, angles):
    """Return all points, m, (case, point, 3)."""
    laid = tree_of(structure)
    points = structure.points
    carried = carried_points(laid, [point.body for point in points], np.array([point.place for point in points]))
    return np.moveaxis(places_of(carried, pose(laid, angles)), 0, 2)


def nodes_at(structure, angles):
    """Return the nodes of all membranes, m, (case, node, 3)."""
    laid = tree_of(structure)
    bodies = np.concatenate([membrane.bodies for membrane in structure.membranes])
    places = np.concatenate([membrane.places for membrane in structure.membranes])
    return np.moveaxis(places_of(carried_points(laid, bodies, places), pose(laid, angles)), 0, 2)


def turned_one_by_one(structure, angles):
    """Return all points, m, (point, 3), computed by successive rotations, body by body."""
    origins, frames = [], []
    for number, body in enumerate(structure.bodies):
        origin, frame = (
            (np.zeros(3), np.eye(3)) if body.parent == GROUND else (origins[body.parent], frames[body.parent])
        )
        origins.append(origin + frame @ body.position)
        frame = frame @ body.frame
        for hinge, angle in zip(structure.hinges, angles, strict=True):
            if hinge.body == number:
                frame = frame @ Rotation.from_rotvec(hinge.sense * angle * hinge.axis).as_matrix()
        frames.append(frame)
    return np.array(
        [
            point.place if point.body == GROUND else origins[point.body] + frames[point.body] @ point.place
            for point in structure.points
        ]
    )


@given(st.integers(0, 10_000), st.integers(1, 9))
def test_points_of_any_tree_are_where_one_rotation_after_another_takes_them(seed, bodies):
    structure = tree(seed, bodies)
    angles = np.random.default_rng(seed).uniform(-math.pi, math.pi, (3, len(structure.hinges)))
    expected = [turned_one_by_one(structure, angle) for angle in angles]
    # rounding
    assert placed(structure, angles) == pytest.approx(np.array(expected), abs=1e-14)


@given(st.integers(0, 10_000))
def test_without_angles_points_are_where_they_are_built(seed):
    structure = tree(seed)
    # rounding
    assert placed(structure, np.zeros((1, len(structure.hinges))))[0] == pytest.approx(
        built_points(structure), abs=1e-15
    )


@given(st.integers(0, 10_000))
def test_the_moves_are_derivatives_of_the_points(seed):
    structure, small = tree(seed), 1e-6
    laid, points = tree_of(structure), structure.points
    carried = carried_points(laid, [point.body for point in points], np.array([point.place for point in points]))
    angles = np.random.default_rng(seed).uniform(-1, 1, (1, laid.size))
    at = pose(laid, angles)
    moves = moves_of(carried, at, places_of(carried, at))[:, 0]
    result = np.zeros((len(points), laid.size, 3))
    result[carried.pairs[0], carried.pairs[1]] = moves.T
    steps = small * np.eye(laid.size)
    differences = (placed(structure, angles + steps) - placed(structure, angles - steps)) / (2 * small)
    # central differences of points of 0.5 m, times 1e-12; rounding divided by 1e-6
    assert result == pytest.approx(np.swapaxes(differences, 0, 1), abs=1e-9)


def test_the_points_of_a_fan_are_where_the_simulator_has_them(reference_run):
    structure, data = reference_run.structure, reference_run.data
    angles = data["hinge_angle"].values
    assert np.degrees(np.ptp(angles, axis=0)).max() > 90
    # rounding of the engine's positions, in its units
    assert nodes_at(structure, angles) == pytest.approx(data["membrane_position"].values, abs=1e-12)
    tips = [number for number, point in enumerate(structure.points) if point.role == "tip"]
    simulated = data["point_position"].values
    assert placed(structure, angles)[:, tips] == pytest.approx(simulated[:, tips], abs=1e-12)


@settings(deadline=None)
@given(st.floats(0.01, 0.03), st.floats(10, 30), st.floats(0, 179.9))
def test_along_the_rigid_fold_a_margin_lies_on_its_vein_as_folded_paper_does(hub, sector, pleat):
    """Distances within a vein's margin are those of rigid panels (docs/model/theory.md, section Fan pattern)."""
    changes = {"pattern.hub_radius": hub, "pattern.sector_angle": math.radians(sector), "vein.diameter": 1e-4}
    design = with_values(REFERENCE, {**changes, "membrane.margin": 0.01})
    structure, fan = structure_of(design), design.fan
    pattern, folds = earwig_pattern(fan), fan_fold_angles(fan, math.radians(pleat))
    folded = folded_coordinates(pattern, folds)
    angles = np.zeros((1, len(structure.hinges)))
    angles[0, list(hinges_of(structure, "turn"))] = math.radians(pleat) / 2
    angles[0, list(hinges_of(structure, "ring"))] = -abs(folds[pattern.edges_role.index("ring")])
    nodes, points, panels = nodes_at(structure, angles)[0], placed(structure, angles)[0], len(structure.membranes)
    names = [point.name for point in structure.points]
    first = 0
    for panel, membrane in enumerate(structure.membranes):
        near = [number for number, body in enumerate(membrane.bodies) if body // 2 == panel]
        rigid = []
        for number in near:
            face = pattern.faces_vertices[panel + panels * (membrane.bodies[number] % 2)]
            corners = np.column_stack([pattern.vertices_coords[list(face), :2], np.ones(4)])
            onto = np.linalg.lstsq(corners, folded[list(face)])[0]
            rigid.append([*membrane.built[number, :2], 1] @ onto)
        ends = [points[names.index(f"hub{panel}")], points[names.index(f"tip{panel}")]]
        where = [*nodes[first + np.array(near)], *ends]
        rigid += [folded[panel], folded[panel + 2 * (panels + 1)]]
        # `folded_coordinates` closes to 1e-9 of the size
        assert pdist(where) == pytest.approx(pdist(rigid), abs=1e-9)
        first += len(membrane.bodies)


@given(st.lists(st.integers(0, 30), min_size=1, unique=True))
def test_a_span_picks_its_numbers(numbers):
    everything = np.arange(31)
    assert everything[span(numbers)].tolist() == numbers


def test_what_is_built_folded_is_where_it_is_built_at_the_angles_as_built():
    """A letter of rigid plates built folded by 60 deg: angles count from flat, the built shape is at 60 deg."""
    fold = math.radians(60)
    design = load_design("letter-fold")
    flat, folded = structure_of(design), structure_of(design)
    hinges = tuple(dataclasses.replace(hinge, built=fold) for hinge in folded.hinges)
    folded = dataclasses.replace(folded, hinges=hinges)
    angles = np.full((1, len(hinges)), 0.3)
    apart = pose(tree_of(folded), angles + fold).pivots - pose(tree_of(flat), angles).pivots
    assert np.abs(apart).max() < 1e-15
