"""Pictures of structures: the part closest to the eye is visible, whatever it is."""

from dataclasses import replace

import numpy as np
import pytest
from matplotlib.colors import to_rgba

from forficula.show.structure.painted_shape import paint_shape
from forficula.show.structure.shape import shape_of
from forficula.show.structure.surface import DrawnSurface, surface_at
from forficula.show.structure.viewpoint import Viewpoint, page_view

FROM_ABOVE = Viewpoint(right=np.array([1.0, 0, 0]), up=np.array([0, 1.0, 0]), towards=np.array([0, 0, 1.0]))
RED = to_rgba("#ff0000")


def planted(sheet_height):
    """A square of 10 cm by 10 cm at a height, between two bars along x, each with a tendon."""
    square = np.array([[0, 0], [0.1, 0], [0.1, 0.1], [0, 0.1]])
    faces = [np.column_stack([square[:, 0] + shift, square[:, 1], np.full(4, sheet_height)]) for shift in (0, 0.1)]
    bars = [[[x, y, 0], [x + 0.1, y, 0]] for y in (0.05, 0.1) for x in (0, 0.1)]
    return DrawnSurface(
        faces=np.array(faces),
        regions=np.array([0, 1]),
        two_sided=False,
        bars=np.array(bars),
        radii=np.full(4, 2.5e-3),
        lines=np.zeros((0, 2, 3)),
        folds=np.zeros(0),
        held=np.zeros((0, 3)),
        tendons=np.array([[[0.02, y, 0], [0.18, y, 0]] for y in (0.05, 0.1)]),
        thickness=5e-3,
        span=0.2,
    )


def seen_at(painted, x, y):
    """Return the colour at a point: that of a picture of one pixel around it."""
    pixel = painted.picture(np.array([x, y]) - 5e-5, 1e-4, (1, 1))[0, 0]
    assert pixel[3] == 255
    return pixel[:3] / 255


@pytest.mark.parametrize(("height", "seen"), [(-0.05, True), (0.0, True), (0.05, False)])
def test_a_tendon_is_seen_on_and_above_a_sheet_and_not_through_it(height, seen):
    painted = paint_shape(planted(height), FROM_ABOVE, [RED, RED])
    assert (tuple(seen_at(painted, 0.0551, 0.0501)) == RED[:3]) == seen


@pytest.mark.parametrize(("beyond", "seen"), [(0.03, True), (-0.03, False)])
def test_an_end_of_a_tendon_behind_a_sheet_does_not_pierce_it(beyond, seen):
    # a tendon from the middle of a sheet towards the eye, or away from it
    square = np.array([[0, 0, 0], [0.1, 0, 0], [0.1, 0.1, 0], [0, 0.1, 0]])
    tendon = np.array([[[0.05, 0.05, 0], [0.09, 0.05, beyond]]])
    surface = replace(planted(0.0), faces=square[np.newaxis], regions=np.array([0]), tendons=tendon)
    bare = replace(surface, bars=np.zeros((0, 2, 3)), radii=np.zeros(0))
    painted = paint_shape(bare, FROM_ABOVE, RED)
    for x in (0.053, 0.06, 0.085):
        assert (tuple(seen_at(painted, x, 0.05)) == RED[:3]) == seen


def test_a_tendon_slightly_behind_a_bent_sheet_is_drawn_on_it():
    # as in a sheet that is bent by a few degrees, where the tendon lies in a slot
    faces = [
        [[0, 0, -1e-3], [0.05, 0, 0], [0.05, 0.1, 0], [0, 0.1, -1e-3]],
        [[0.05, 0, 0], [0.1, 0, -1e-3], [0.1, 0.1, -1e-3], [0.05, 0.1, 0]],
    ]
    surface = replace(planted(0.0), faces=np.array(faces), tendons=np.array([[[0, 0.05, -1e-3], [0.1, 0.05, -1e-3]]]))
    painted = paint_shape(replace(surface, bars=np.zeros((0, 2, 3)), radii=np.zeros(0)), FROM_ABOVE, RED)
    assert tuple(seen_at(painted, 0.05, 0.05)) == RED[:3]


def test_a_bar_that_passes_through_a_sheet_is_seen_on_the_side_where_it_is_nearer():
    bar = np.array([[[0.05, 0.02, -0.02], [0.05, 0.08, 0.02]]])
    surface = replace(planted(0.0), bars=bar, radii=np.array([2.5e-3]), tendons=np.zeros((0, 2, 3)))
    painted = paint_shape(surface, FROM_ABOVE, RED)
    sheet = seen_at(painted, 0.01, 0.05)
    shades = np.array([seen_at(painted, 0.05, y) for y in (0.025, 0.035, 0.043, 0.06, 0.07, 0.075)])
    assert np.abs(shades[:3] - sheet).max() < 0.01
    assert np.all(shades[3:] < 0.5)


def test_regions_differ_and_both_sides_look_the_same():
    painted = paint_shape(planted(0.0), FROM_ABOVE, RED)
    one, other = seen_at(painted, 0.0551, 0.0251), seen_at(painted, 0.1551, 0.0251)
    assert abs(one - other).max() > 0.1
    below = Viewpoint(right=FROM_ABOVE.right, up=-FROM_ABOVE.up, towards=-FROM_ABOVE.towards)
    turned = paint_shape(planted(0.0), below, RED)
    assert seen_at(turned, 0.0551, -0.0251) == pytest.approx(one)


def test_the_picture_of_a_structure_has_all_of_it(reference_run):
    structure = reference_run.structure
    surface, view = surface_at(reference_run, shape_of(structure), 0.32), page_view()
    places = view.project(np.concatenate([surface.faces.reshape(-1, 3), surface.bars.reshape(-1, 3)]))
    low, high = paint_shape(surface, view, RED).corners
    assert np.all(low <= places.min(axis=0) + 1e-12)
    assert high == pytest.approx(places.max(axis=0), abs=1.01 * surface.radii[0])


@pytest.mark.parametrize("turn", [0.0, 2.0])
def test_the_eye_sees_lengths_in_the_picture_as_they_are(turn):
    view = page_view(turn)
    axes = np.array([view.right, view.up, view.towards])
    assert axes @ axes.T == pytest.approx(np.eye(3), abs=1e-12)
    assert np.linalg.det(axes) == pytest.approx(1)
    assert view.project(np.array([0.3 * view.right + 0.2 * view.up + 7 * view.towards])) == pytest.approx(
        np.array([[0.3, 0.2]])
    )
    assert view.towards[2] > 0.5  # from above
