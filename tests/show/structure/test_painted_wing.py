"""Painting from back to front: what is nearer to the eye is painted later, whatever it is."""

import numpy as np
import pytest
from matplotlib.colors import to_rgba

from forficula.design import load_design
from forficula.show.structure.painted_wing import View, paint_wing, wing_view
from forficula.show.structure.wing_surface import WingSurface, wing_surface

FROM_ABOVE = View(right=np.array([1.0, 0, 0]), up=np.array([0, 1.0, 0]), towards=np.array([0, 0, 1.0]))
RED = to_rgba("#ff0000")


def planted(membrane_height):
    """A square of 10 cm by 10 cm at a height, between two veins along x, and a tendon on one of them."""
    square = np.array([[0, 0], [0.1, 0], [0.1, 0.1], [0, 0.1]])
    quads = [
        np.column_stack([square[:, 0] + shift, square[:, 1], np.full(4, membrane_height)]) for shift in (0, 0, 0.1, 0.1)
    ]
    veins = [[[0, y, 0], [0.1, y, 0], [0.2, y, 0]] for y in (0.05, 0.1)]
    tendons = [[[0.02, y, 0], [0.18, y, 0]] for y in (0.05, 0.1)]
    return WingSurface(
        quads=np.array(quads),
        distal=np.array([False, False, True, True]),
        veins=np.array(veins),
        tendons=np.array(tendons),
    )


def last_at(painted, x, y):
    """The colour on top at a place: that of the last polygon around it."""
    corners = painted.polygons - [x, y]
    turns = corners[:, :, 0] * np.roll(corners[:, :, 1], -1, 1) - corners[:, :, 1] * np.roll(corners[:, :, 0], -1, 1)
    inside = (turns > 0).all(axis=1) | (turns < 0).all(axis=1)
    return painted.colours[np.flatnonzero(inside)[-1]]


@pytest.mark.parametrize(("height", "seen"), [(-0.05, True), (0.0, True), (0.05, False)])
def test_a_tendon_is_seen_on_and_above_the_membrane_and_not_through_it(reference, height, seen):
    painted = paint_wing(planted(height), reference, FROM_ABOVE, [RED, RED])
    assert (tuple(last_at(painted, 0.0551, 0.0501)) == RED) == seen


def test_proximal_and_distal_panels_differ_and_both_sides_look_alike(reference):
    painted = paint_wing(planted(0.0), reference, FROM_ABOVE, RED)
    proximal, distal = last_at(painted, 0.0551, 0.0251), last_at(painted, 0.1551, 0.0251)
    assert abs(proximal - distal).max() > 0.1
    below = View(right=FROM_ABOVE.right, up=-FROM_ABOVE.up, towards=-FROM_ABOVE.towards)
    turned = paint_wing(planted(0.0), reference, below, RED)
    assert last_at(turned, 0.0551, -0.0251) == pytest.approx(proximal)


def test_the_finer_the_cells_the_more_polygons_and_all_of_the_wing_at_any_number(reference_run):
    surface, design = wing_surface(reference_run, 0.32), reference_run.design
    view = wing_view(design)
    coarse, fine = (paint_wing(surface, design, view, RED, cells=cells).polygons for cells in (4, 40))
    assert len(fine) > 5 * len(coarse)
    radius = design.vein.diameter / 2
    places = view.project(np.concatenate([surface.quads.reshape(-1, 3), surface.veins.reshape(-1, 3)]))
    for polygons in (coarse, fine):
        corners = polygons.reshape(-1, 2)
        assert np.all(corners.min(axis=0) <= places.min(axis=0) + 1e-12)
        assert corners.max(axis=0) == pytest.approx(places.max(axis=0), abs=1.01 * radius)


@pytest.mark.parametrize("settings", [{}, {"pattern.units": 5, "pattern.sector_angle": "12 deg"}])
def test_the_eye_sees_lengths_in_the_picture_as_they_are(settings):
    view = wing_view(load_design("binder2025", settings))
    axes = np.array([view.right, view.up, view.towards])
    assert axes @ axes.T == pytest.approx(np.eye(3), abs=1e-12)
    assert np.linalg.det(axes) == pytest.approx(1)
    assert view.project(np.array([0.3 * view.right + 0.2 * view.up + 7 * view.towards])) == pytest.approx(
        np.array([[0.3, 0.2]])
    )
    assert view.towards[2] > 0.5  # from above
