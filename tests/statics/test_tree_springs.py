"""Trees of bodies with springs, creases between flaps and closures: closed forms, derivatives, and the net solver."""

import math
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from forficula.errors import InputError
from forficula.statics.tree.potential import ensemble, hinge_angles, largest_gap, potential, rest, stored_energy
from forficula.statics.tree.springs import spring_energy
from forficula.structure import (
    GROUND,
    Body,
    Closure,
    Coupling,
    Hinge,
    Motor,
    Point,
    Spring,
    crease_law,
    flap_angles,
    structure_of,
)
from tests.plate_sheets import plates, strip, vertex
from tests.statics.test_pose import turned_one_by_one
from tests.statics.test_potential import check_derivatives
from tests.statics.trees import rotation, tree

RADIUS, SECTOR = 0.02, math.radians(87.5)


def sprung_tree(seed, *, closures=False):
    """Return a random tree with tendons, springs, creases between its bodies, and closures."""
    random = np.random.default_rng(seed)
    built = tree(seed, 5, gravity=9.81, limit=100.0)
    count = len(built.points)
    springs = tuple(
        Spring(
            name=f"s{number}",
            role="spring",
            points=(number, int(random.integers(number + 1, count))),
            stiffness=float(random.uniform(10, 1e3)),
            rest_length=float(random.choice([0.0, 0.05])),
        )
        for number in range(5)
    )
    creases, points = [], list(built.points)
    for number, (one, other) in enumerate([(GROUND, 1), (0, 3), (2, 4)]):
        flaps = tuple(range(len(points), len(points) + 6))
        for body in (one, other):
            tail, along, corner = random.uniform(-0.05, 0.05, (3, 3))
            head = tail + 0.05 * along / np.linalg.norm(along)
            points += [Point(name="f", role="f", body=body, place=place) for place in (tail, head, corner)]
        law = {"stiffness": float(random.uniform(0.01, 0.1)), "rest_angle": float(random.uniform(-1, 1))}
        stops = {"lower": -1.0, "upper": 0.5, "stop_stiffness": 0.3} if number else {"lock_below": -0.5}
        creases.append(Hinge(name=f"c{number}", role="c", flaps=flaps, sense=(-1) ** number, **law, **stops))
    pins = [
        Closure(
            name=f"closure{number}",
            bodies=pair,
            position=random.uniform(-0.05, 0.05, 3),
            frame=rotation(random),
            points=((4 * pair[0] + 4, 4 * pair[1] + 4),),
        )
        for number, pair in enumerate([(1, 4), (2, 3)] if closures else [])
    ]
    return replace(built, points=tuple(points), springs=springs, hinges=(*built.hinges, *creases), closures=tuple(pins))


def test_two_plates_and_a_spring_store_the_energy_of_the_law_of_cosines():
    """Corners of two plates of 10 cm at a crease with a spring between them: d^2 = 2 a^2 (1 + cos(angle))."""
    plain = structure_of(strip(2, **{"crease.stiffness": 0.05, "crease.rest_angle": 0.3}))
    corners = [number for number, point in enumerate(plain.points) if abs(point.place[0]) < 1e-12]
    far = [
        next(number for number, point in enumerate(plain.points) if point.body == body and number not in corners)
        for body in (0, 1)
    ]
    for stiffness, length in ((40.0, 0.0), (40.0, 0.07)):
        spring = Spring(name="s", role="s", points=(far[0], far[1]), stiffness=stiffness, rest_length=length)
        structures = ensemble([replace(plain, springs=(spring,))])
        (joint,) = plain.hinges
        for angle in (0.0, 0.4, 2.0, 3.0):
            ends = turned_one_by_one(plain, [angle])[far]
            apart = float(np.linalg.norm(ends[1] - ends[0]))
            known = stiffness / 2 * (apart - length) ** 2 + joint.stiffness / 2 * (angle - joint.rest_angle) ** 2
            assert potential(structures, np.array([[angle]]))[0][0] == pytest.approx(known, rel=1e-10)


@given(st.floats(-3, 3), st.floats(-3, 3))
def test_four_plates_store_the_energy_of_the_gap_of_their_crease_that_opens(a, b):
    """Sectors of 87.5 deg, symmetric folds A (two) and B: with the gap angle g, U = 2/3 k_e R^3 sin^2(g / 2).

    sin(g / 2) = 2 sin(s) cos(A / 2) (cos(s) cos(A / 2) cos(B / 2) - sin(A / 2) sin(B / 2)).
    """
    structures = ensemble([FOUR])
    gap = math.cos(SECTOR) * math.cos(a / 2) * math.cos(b / 2) - math.sin(a / 2) * math.sin(b / 2)
    gap *= 2 * math.sin(SECTOR) * math.cos(a / 2)
    known = 2 / 3 * 1e4 * RADIUS**3 * gap**2
    assert structures.springs is not None
    energy = spring_energy(structures.springs, np.array([[a, b, a]]))[0][0]
    assert energy == pytest.approx(known, rel=1e-10, abs=1e-16)
    assert stored_energy(structures, np.array([[a, b, a]]))["openings"][0] == energy


@settings(deadline=None, max_examples=25)
@given(st.integers(0, 10_000))
def test_slope_and_curvature_with_springs_and_creases_are_the_derivatives_of_the_potential(seed):
    built = sprung_tree(seed)
    joints = len(built.hinges) - 3
    motors = (
        Motor(name="m", hinges=(0, joints, joints + 2), gains=(1.0, -2.0, 0.5)),
        Motor(name="r", kind="rest-angle", hinges=(1 % joints, joints + 1)),
    )
    structures = ensemble([replace(built, motors=motors)])
    angles = np.random.default_rng(seed).uniform(-1, 1, (1, joints))
    if np.abs(hinge_angles(structures, angles)[0, joints:]).max() < 3:
        check_derivatives(structures, angles, np.array([0.3, -0.1]))


@settings(deadline=None, max_examples=10)
@given(st.integers(0, 10_000))
def test_slope_and_curvature_of_closures_are_their_derivatives(seed):
    structures = ensemble([sprung_tree(seed, closures=True)])
    angles = np.random.default_rng(seed).uniform(-1, 1, (1, structures.size))
    check_derivatives(structures, angles, np.zeros(0))


@settings(deadline=None, max_examples=25)
@given(st.integers(0, 10_000))
def test_the_energy_is_the_sum_of_springs_by_their_lengths_and_creases_by_their_angles(seed):
    """Lengths and angles are those of points that are turned one by one."""
    built = sprung_tree(seed)
    joints = len(built.hinges) - 3
    angles = np.random.default_rng(seed).uniform(-2, 2, joints)
    points = turned_one_by_one(replace(built, hinges=built.hinges[:joints]), angles)
    senses = np.array([crease.sense for crease in built.hinges[joints:]])
    folded = senses * flap_angles(points[[crease.flaps for crease in built.hinges[joints:]]])
    # an angle is within half a turn of the middle between its stops
    folded[1:] += 2 * math.pi * np.round((-0.25 - folded[1:]) / (2 * math.pi))
    structures = ensemble([built])
    assert hinge_angles(structures, angles[None])[0] == pytest.approx(np.concatenate([angles, folded]), abs=1e-9)
    stored = stored_energy(structures, angles[None])
    law = crease_law(built, np.arange(joints, joints + 3), rigid_stops=True)
    assert stored["creases"][0] == pytest.approx(float(np.sum(law.energy(folded))), rel=1e-8)
    lengths = [float(np.linalg.norm(np.subtract(*points[list(spring.points)]))) for spring in built.springs]
    known = sum(
        spring.stiffness / 2 * (length - spring.rest_length) ** 2
        for spring, length in zip(built.springs, lengths, strict=True)
    )
    assert stored["openings"][0] == pytest.approx(known, rel=1e-9)
    whole, plain = (ensemble([structure]) for structure in (built, replace(built, springs=(), hinges=built.hinges[:joints])))
    more = potential(whole, angles[None])[0] - potential(plain, angles[None])[0]
    assert more[0] == pytest.approx(stored["creases"][0] + stored["openings"][0], rel=1e-8)


def four_plates(extension="1e4 N/m^2", more="", **hinge):
    """Return four plates around a vertex whose facet 0 is held and whose crease 0 opens."""
    opening = f'[[crease.group]]\nof = "crease 0"\nextension = "{extension}"\n[[support]]\nof = "facet 0"\n{more}'
    return structure_of(plates(vertex([87.5] * 4), crease='stiffness = "0 N m/rad/m"', more=opening))


FOUR = four_plates()


def test_four_plates_have_three_joints_and_then_a_crease_between_flaps():
    assert [crease.flaps is None for crease in FOUR.hinges] == [True, True, True, False]
    assert ensemble([FOUR]).size == 3
    built = np.array([[joint.built for joint in FOUR.hinges[:3]]])
    assert hinge_angles(ensemble([FOUR]), built)[0, 3] == pytest.approx(FOUR.hinges[3].start)
