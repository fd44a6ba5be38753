"""Rasterisation with a depth buffer: the nearest triangle is visible, sample by sample."""

import numpy as np
import pytest

from forficula.show.structure.raster import rasterise

RED, BLUE = np.eye(3)[0], np.eye(3)[2]
SQUARE = np.array([[0.0, 0, 0], [40, 0, 0], [40, 40, 0], [0, 40, 0]])


def square(depths):
    """Return two triangles over a square of 40 pixels, with a depth at every corner."""
    corners = SQUARE + np.outer(depths, [0, 0, 1.0])
    return corners[[[0, 1, 2], [0, 2, 3]]]


@pytest.mark.parametrize("later", [0, 1])
def test_planes_that_pass_through_one_another_hide_one_another_on_either_side_of_the_line_where_they_meet(later):
    level, tilted = square([0, 0, 0, 0]), square([-1, 1, 1, -1])
    layers = [(level, RED), (tilted, BLUE)]
    order = layers if later else layers[::-1]
    triangles = np.concatenate([item for item, _ in order])
    picture = rasterise(triangles, np.repeat([colour for _, colour in order], 2, axis=0), (40, 40))
    assert np.all(picture[:, :20] == [255, 0, 0, 255])
    assert np.all(picture[:, 20:] == [0, 0, 255, 255])


def test_a_fan_of_triangles_has_no_gaps_and_covers_its_area():
    turns = np.linspace(0, 2 * np.pi, 38)
    rim = np.column_stack([50 + 40 * np.cos(turns), 50 + 40 * np.sin(turns), np.zeros(38)])
    middle = np.broadcast_to([50.3, 49.8, 0], (37, 3))
    picture = rasterise(np.stack([middle, rim[:-1], rim[1:]], axis=1), np.tile(RED, (37, 1)), (100, 100))
    x, y = np.meshgrid(np.arange(100) + 0.5, np.arange(100) + 0.5)
    away = np.hypot(x - 50, y - 50)
    assert np.all(picture[away < 38.5] == [255, 0, 0, 255])
    assert not picture[away > 41].any()
    area = 0.5 * 37 * 40**2 * np.sin(2 * np.pi / 37)
    assert picture[..., 3].sum() / 255 == pytest.approx(area, rel=5e-3)


def test_an_edge_shares_a_pixel_by_its_samples():
    half = square([0, 0, 0, 0]) * [0.5125, 1, 1]  # up to 20.5 pixels
    picture = rasterise(half, np.tile(RED, (2, 1)), (40, 40), 2)
    assert np.all(picture[:, 20] == [255, 0, 0, 127])
    assert not picture[:, 21:].any()


def test_the_last_of_equally_near_triangles_is_visible():
    both = np.concatenate([square([1, 1, 1, 1])] * 2)
    assert np.all(rasterise(both, np.repeat([RED, BLUE], 2, axis=0), (40, 40)) == [0, 0, 255, 255])


def test_what_is_outside_the_picture_seen_from_its_edge_or_not_finite_is_left_out():
    outside, edge = square([0, 0, 0, 0]) - [1e7, 0, 0], square([0, 1, 2, 3]) * [0, 1, 1] + [7.25, 0, 0]
    lost = square([0, 0, 0, 0]) * [np.nan, 1, 1]
    triangles = np.concatenate([outside, edge, lost])
    assert not rasterise(triangles, np.tile(RED, (6, 1)), (40, 40)).any()
    assert not rasterise(np.zeros((0, 3, 3)), np.zeros((0, 3)), (4, 4)).any()
    far = square([0, 0, 0, 0]) * 1e9 - [1e9, 1e9, 0]  # the whole picture and far beyond
    assert np.all(rasterise(far, np.tile(BLUE, (2, 1)), (40, 40)) == [0, 0, 255, 255])
