"""Mass, centre and inertia of plates and bars, beside closed forms."""

import math

import numpy as np
import pytest

from forficula.structure import GROUND, Bar, Body, Plate, Point, Structure, mass_of

THICK, DENSE = 0.002, 1200.0


def of_parts(*polygons, bars=(), turn=None):
    """One body of plates with these corners, (corner, 3) each, and of bars."""
    frame = np.eye(3) if turn is None else turn
    points, plates = [], []
    for corners in polygons:
        first = len(points)
        points += [
            Point(name=f"p{first + n}", role="corner", body=0, place=frame @ np.asarray(place, dtype=float))
            for n, place in enumerate(corners)
        ]
        plates.append(Plate(body=0, points=tuple(range(first, len(points))), thickness=THICK, density=DENSE))
    structure = Structure(
        name="one",
        bodies=(Body(name="one", role="facet", parent=GROUND, position=np.zeros(3), frame=np.eye(3)),),
        points=tuple(points),
        plates=tuple(plates),
        bars=tuple(bars),
        hinges=(),
        span=1.0,
        mass=1.0,
    )
    return mass_of(structure, 0)


def rectangle(x, y, width, height):
    return [(x, y, 0), (x + width, y, 0), (x + width, y + height, 0), (x, y + height, 0)]


def turned(axis, angle):
    x, y, z = np.array(axis) / np.linalg.norm(axis)
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + math.sin(angle) * cross + (1 - math.cos(angle)) * cross @ cross


def test_a_rectangle_is_a_box():
    a, b = 0.3, 0.2
    mass, centre, inertia = of_parts(rectangle(0.05, -0.1, a, b))
    assert mass == pytest.approx(DENSE * a * b * THICK, rel=1e-14)
    assert centre == pytest.approx([0.2, 0, 0], abs=1e-16)
    box = mass / 12 * np.diag([b**2 + THICK**2, a**2 + THICK**2, a**2 + b**2])
    np.testing.assert_allclose(inertia, box, rtol=1e-13, atol=1e-18)


def test_a_corner_to_start_with_and_a_sense_make_no_difference():
    corners = [(0, 0, 0), (0.3, 0.05, 0), (0.25, 0.2, 0), (0.1, 0.3, 0), (-0.05, 0.1, 0)]
    one = of_parts(corners)
    for other in (of_parts(corners[2:] + corners[:2]), of_parts(corners[::-1])):
        for mine, theirs in zip(one, other, strict=True):
            np.testing.assert_allclose(mine, theirs, rtol=1e-13, atol=1e-17)


def test_parts_add_up_by_the_parallel_axis_theorem():
    """An L of one polygon, which is not convex, is two rectangles."""
    whole = of_parts([(0, 0, 0), (0.3, 0, 0), (0.3, 0.1, 0), (0.1, 0.1, 0), (0.1, 0.4, 0), (0, 0.4, 0)])
    parts = of_parts(rectangle(0, 0, 0.3, 0.1), rectangle(0, 0.1, 0.1, 0.3))
    for one, other in zip(whole, parts, strict=True):
        np.testing.assert_allclose(one, other, rtol=1e-13, atol=1e-17)


def test_a_plate_that_is_turned_has_turned_moments():
    corners = [(0, 0, 0), (0.3, 0.05, 0), (0.25, 0.2, 0), (-0.05, 0.1, 0)]
    turn = turned((1, 2, -1), 1.1)
    mass, centre, inertia = of_parts(corners)
    other = of_parts(corners, turn=turn)
    assert other[0] == pytest.approx(mass, rel=1e-13)
    np.testing.assert_allclose(other[1], turn @ centre, atol=1e-16)
    np.testing.assert_allclose(other[2], turn @ inertia @ turn.T, atol=1e-17)


def test_a_right_triangle_has_the_moments_of_the_handbook():
    a, b = 0.3, 0.2
    mass, centre, inertia = of_parts([(0, 0, 0), (a, 0, 0), (0, b, 0)])
    assert mass == pytest.approx(DENSE * THICK * a * b / 2, rel=1e-14)
    np.testing.assert_allclose(centre, [a / 3, b / 3, 0], atol=1e-16)
    # about the centre: m b^2 / 18, m a^2 / 18, product -m a b / 36, and the thickness
    thick = mass * THICK**2 / 12
    flat = mass * np.array([[b**2 / 18, a * b / 36, 0], [a * b / 36, a**2 / 18, 0], [0, 0, (a**2 + b**2) / 18]])
    np.testing.assert_allclose(inertia, flat + np.diag([thick, thick, 0]), rtol=1e-12, atol=1e-18)


def test_a_bar_is_a_cylinder():
    end, radius = np.array([0.1, 0.2, -0.05]), 0.003
    mass, centre, inertia = of_parts(bars=[Bar(body=0, end=end, diameter=2 * radius, density=DENSE, points=(0, 0))])
    length = np.linalg.norm(end)
    assert mass == pytest.approx(DENSE * math.pi * radius**2 * length, rel=1e-14)
    np.testing.assert_allclose(centre, end / 2)
    moments = np.linalg.eigvalsh(inertia)
    across = mass * (radius**2 / 4 + length**2 / 12)
    np.testing.assert_allclose(moments, [mass * radius**2 / 2, across, across], rtol=1e-12)
    assert inertia @ end == pytest.approx(mass * radius**2 / 2 * end, rel=1e-9)


def test_nothing_has_no_mass():
    mass, centre, inertia = of_parts()
    assert mass == 0.0
    assert not centre.any()
    assert not inertia.any()
