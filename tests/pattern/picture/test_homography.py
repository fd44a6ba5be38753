import math

import numpy as np
import pytest

from forficula import InputError
from forficula.pattern.picture.homography import (
    check_corners,
    homography,
    mapped_points,
    metres_per_pixel,
    side_ratio,
)

CORNERS = np.array([[110.0, 90.0], [1190.0, 130.0], [1130.0, 880.0], [70.0, 800.0]])
SHEET = np.array([[0, 0.21], [0.297, 0.21], [0.297, 0], [0, 0]])


def camera_view(ratio, tilt, focal=1500.0):
    """Corners of a rectangle with a width of `ratio` and a height of 1 as a pinhole camera sees them."""
    plane = np.array([[-ratio, 1.0, 0], [ratio, 1.0, 0], [ratio, -1.0, 0], [-ratio, -1.0, 0]]) / 2
    turn = np.array([[1, 0, 0], [0, math.cos(tilt), -math.sin(tilt)], [0, math.sin(tilt), math.cos(tilt)]])
    spin = np.array([[math.cos(0.3), -math.sin(0.3), 0], [math.sin(0.3), math.cos(0.3), 0], [0, 0, 1]])
    seen = plane @ spin.T @ turn.T + [0.05, 0.02, 3.0]
    return focal * seen[:, :2] / seen[:, 2:] * [1, -1] + [640, 480]


def test_a_homography_maps_its_points_exactly_and_its_inverse_back():
    matrix = homography(CORNERS, SHEET)
    np.testing.assert_allclose(mapped_points(matrix, CORNERS), SHEET, atol=1e-12)
    inside = np.array([[500.0, 400.0], [900.0, 700.0]])
    np.testing.assert_allclose(mapped_points(np.linalg.inv(matrix), mapped_points(matrix, inside)), inside)


def test_straight_lines_stay_straight():
    line = np.array([[100.0, 200.0], [600.0, 450.0], [1100.0, 700.0]])
    (a, b, c) = mapped_points(homography(CORNERS, SHEET), line)
    assert abs((b - a)[0] * (c - a)[1] - (b - a)[1] * (c - a)[0]) < 1e-14


def test_the_scale_of_a_pixel_agrees_with_the_area_of_its_image():
    matrix = homography(CORNERS, SHEET)
    square = np.array([[600, 400], [600.01, 400], [600.01, 400.01], [600, 400.01]])
    x, y = mapped_points(matrix, square).T
    area = abs(x @ np.roll(y, -1) - y @ np.roll(x, -1)) / 2
    assert metres_per_pixel(matrix, square.mean(axis=0)[np.newaxis])[0] * 0.01 == pytest.approx(
        math.sqrt(area), rel=1e-6
    )


@pytest.mark.parametrize("ratio", [0.6, 1.0, 1.414])
def test_a_tilted_rectangle_shows_the_ratio_of_its_sides(ratio):
    estimate, by_perspective = side_ratio(camera_view(ratio, 0.5), np.array([640.0, 480.0]))
    assert by_perspective
    assert estimate == pytest.approx(ratio, rel=1e-9)


def test_a_rectangle_seen_from_above_shows_its_ratio_without_perspective():
    estimate, by_perspective = side_ratio(camera_view(1.414, 0.0), np.array([640.0, 480.0]))
    assert not by_perspective
    assert estimate == pytest.approx(1.414, rel=1e-9)


@pytest.mark.parametrize(
    "corners",
    [CORNERS[::-1], CORNERS[[0, 2, 1, 3]], CORNERS[[0, 1, 2, 2]], CORNERS + 5000, np.full((4, 2), np.nan)],
)
def test_corners_that_are_no_view_of_a_sheet_are_refused(corners):
    with pytest.raises(InputError, match=r"^need"):
        check_corners(corners, 1280, 960)


def test_points_on_one_line_determine_no_homography():
    with pytest.raises(InputError, match="no three lie on a line"):
        homography(np.array([[0.0, 0], [1, 1], [2, 2], [3, 3]]), SHEET)
