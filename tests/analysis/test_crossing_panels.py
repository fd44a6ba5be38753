"""Depth to which panels pass through each other, compared with known cases in random orientations."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

import forficula as ff
from forficula.analysis.crossing_panels import PanelMesh, crossing_depths, panel_crossing, panel_positions
from forficula.analysis.run_warnings import run_warnings
from forficula.analysis.summary import summary
from forficula.quantities import show_value
from forficula.structure import Contact, Stops

turns = st.tuples(*[st.floats(-np.pi, np.pi)] * 3).map(lambda angles: Rotation.from_euler("xyz", angles).as_matrix())


def sheet(first, second, across=4, along=3):
    """Return a flat rectangle with one corner at the origin as a mesh, and its nodes, (node, 3)."""
    u, v = np.meshgrid(np.linspace(0, 1, along + 1), np.linspace(0, 1, across + 1), indexing="ij")
    nodes = u.ravel()[:, None] * np.asarray(first, float) + v.ravel()[:, None] * np.asarray(second, float)
    corners = np.arange(len(nodes)).reshape(u.shape)
    a, b, c, d = (item.ravel() for item in (corners[:-1, :-1], corners[1:, :-1], corners[1:, 1:], corners[:-1, 1:]))
    triangles = np.concatenate([np.stack([a, b, c], axis=1), np.stack([a, c, d], axis=1)])
    return PanelMesh(name="sheet", triangles=triangles), nodes


def moved(nodes, by):
    return nodes + np.array(by)


def depth(one, corners, other, other_corners, turn=None):
    places = [nodes if turn is None else nodes @ turn.T for nodes in (corners, other_corners)]
    result = [crossing_depths(one, places[0][None], other, places[1][None])[0]]
    result.append(crossing_depths(other, places[1][None], one, places[0][None])[0])
    assert result[0] == pytest.approx(result[1], abs=1e-12)
    return result[0]


@settings(max_examples=25)
@given(st.floats(1e-3, 0.9), turns, st.integers(1, 5))
def test_the_crossing_depth_of_a_blade_is_its_travel(far, turn, strips):
    floor, flat = sheet([4, 0, 0], [0, 3, 0])
    blade, upright = sheet([1.1, 0.2, 0], [0, 0, 2], across=strips)
    # nodes in the plane of the other panel are on neither side, so their edges do not pass through it
    assume(np.abs(upright[:, 2] - far).min() > 1e-5)
    assert depth(floor, flat, blade, moved(upright, [1.3, 1.1, -far]), turn) == pytest.approx(far, rel=1e-9)


@settings(max_examples=25)
@given(st.floats(1e-3, 1.0), turns)
def test_separate_panels_do_not_cross(gap, turn):
    floor, flat = sheet([4, 0, 0], [0, 3, 0])
    blade, upright = sheet([1.1, 0.2, 0], [0, 0, 2])
    assert depth(floor, flat, blade, moved(upright, [1.3, 1.1, gap]), turn) == 0
    assert depth(floor, flat, blade, moved(upright, [5, 1.1, -1]), turn) == 0
    # it passes outside the edge, with corners on both sides of the plane
    assert depth(floor, flat, blade, moved(upright, [1.3, -1.0, -1]), turn) == 0


@settings(max_examples=25)
@given(st.floats(0.05, 3.1), turns)
def test_two_panels_that_fold_at_a_common_edge_do_not_cross(angle, turn):
    floor, flat = sheet([1, 0, 0], [0, 3, 0])
    other, raised = sheet([np.cos(angle), 0, np.sin(angle)], [0, 3, 0])
    assert depth(floor, flat, other, raised, turn) == 0


@pytest.mark.parametrize("height", [-0.2, 0.2])
def test_plates_that_cross_in_the_middle_have_passed_by_the_part_that_reaches_less_far(height):
    """The ends of a plate that crosses another one at 30 deg reach length * sin(30 deg)."""
    floor, flat = sheet([4, 0, 0], [0, 3, 0])
    along = np.array([np.cos(np.pi / 6), 0, np.sin(np.pi / 6)])
    leaning, nodes = sheet(2 * along, [0, 1, 0])
    middle = nodes.mean(axis=0)
    result = depth(floor, flat, leaning, nodes - middle + [2, 1, height])
    assert result == pytest.approx(0.5 - abs(height), rel=1e-9)


def test_a_finer_mesh_gives_the_same_depth():
    result = []
    for fine in (1, 3, 8):
        floor, flat = sheet([4, 0, 0], [0, 3, 0], across=fine, along=fine)
        blade, upright = sheet([1.1, 0.2, 0], [0, 0.3, 2], across=fine, along=fine)
        result.append(depth(floor, flat, blade, moved(upright, [1.3, 1.1, -0.37])))
    assert result == pytest.approx([0.37] * 3, rel=1e-9)


def test_nodes_of_panels_move_with_their_bodies(reference_run):
    """Nodes at the edges of margins and on the axis of the next vein belong to the membrane, too."""
    row = int(np.argmin(reference_run.angles("ring")[:, 1]))
    proximal = panel_positions(reference_run, [row])[0][0]
    recorded = reference_run.series["membrane_position"][row]
    np.testing.assert_allclose(proximal[[2, 3, 14, 15]], recorded[:4], atol=1e-12)
    sides = np.linalg.norm(np.diff(proximal[0::4], axis=0), axis=1)
    np.testing.assert_allclose(sides, 0.12 * 0.7 / 3, rtol=1e-9)


def test_the_reference_wing_passes_through_itself_and_gives_a_warning(reference_run, reference_outcome):
    result = panel_crossing(reference_run)
    # the paper's simulation has no contact either; its authors report self-penetration
    assert 0.01 < result.depth < 0.03
    assert summary(reference_run, reference_outcome, {})["crossing"]["depth_m"] == result.depth
    output = [warning for warning in run_warnings(reference_run) if "pass through each other" in warning]
    assert output == [
        f"{' and '.join(result.names)} pass through each other by {show_value(result.depth, 'm')}"
        f" at {result.time:.3g} s:"
        " contact is switched off; protocol.contact = true keeps panels apart"
    ]


def test_thick_panels_that_contact_lets_through_give_a_warning(reference_run):
    """Their midplanes cross, so the depth grows with their thickness."""
    thick = replace(reference_run.structure, contact=Contact(thickness=0.03, stops=Stops(time_constant=4e-4)))
    (output,) = (
        warning for warning in run_warnings(replace(reference_run, structure=thick)) if "pass through" in warning
    )
    assert "more than contact should allow" in output


def test_structures_without_panels_and_diverged_runs_have_no_crossing():
    short = {"protocol.timestep": "5 ms"}
    record = ff.run(ff.load_design("binder2025", short), confirm=False)
    assert record.diverged_at is not None
    assert panel_crossing(record) is None


def test_the_deepest_crossing_is_found_between_the_rows_of_the_first_search(reference_run):
    result = panel_crossing(reference_run)
    near = np.flatnonzero(np.abs(reference_run.time - result.time) < 5e-3)
    assert result.depth == panel_crossing(reference_run, near.tolist()).depth
    # docs/model/findings.md
    assert result.depth == pytest.approx(0.0237, abs=5e-4)


def test_the_deepest_crossing_of_a_record_is_computed_once(reference_run, monkeypatch):
    record = replace(reference_run)
    first = panel_crossing(record)
    monkeypatch.setattr("forficula.analysis.crossing_panels.crossing_depths", None)
    assert panel_crossing(record) is first
    with pytest.raises(TypeError):  # another record is searched
        panel_crossing(replace(reference_run))
