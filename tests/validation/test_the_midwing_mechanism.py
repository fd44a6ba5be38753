"""The mid-wing mechanism of four plates agrees with its closed form: gap, energy, states, barriers and snap.

Faber, Arrieta and Studart 2018, doi 10.1126/science.aap7753. Three creases are joints: two sides, with the fold angle
A, and the middle one, with the fold angle B. The fourth crease opens by the angle g, and with the sector alpha

    sin(g / 2) = 2 sin(alpha) cos(A / 2) (cos(alpha) cos(A / 2) cos(B / 2) - sin(A / 2) sin(B / 2))
    U = 2/3 k_e R^3 sin^2(g / 2) + k_r R (2 (A - A0)^2 + w (B - B0)^2) / 2
"""

import math

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.optimize import fsolve

from forficula.design import load_design, with_values
from forficula.dynamics import compile_model, energy_balance, simulate
from forficula.statics.net.driven.net_course import released
from forficula.statics.net.energy import expand, shape_at
from forficula.statics.net.minimum import minimum
from forficula.statics.net.net_landscape import slow_courses
from forficula.statics.net.net_of import is_net, net_of, start_shape
from forficula.statics.net.saddle import find_saddle
from forficula.structure import structure_of

DESIGN = load_design("earwig-midwing")
RADIUS, EXTENSION, BENDING, RATIO, SECTOR = 0.02, 1e5, 0.05, 20.0, math.radians(87.5)
REST = math.radians(-170)
GROUP = BENDING / (EXTENSION * RADIUS**2)  # k_r / (k_e R^2)
UNIT = EXTENSION * RADIUS**3  # J
SIDES, MIDDLE = (0, 2), 1  # numbers of the hinges


def gap(side, middle, sector=SECTOR):
    """sin(g / 2) with its first and second derivatives by both angles."""
    cosine, half = math.cos(sector), middle / 2
    scale = math.sin(sector)
    value = scale * (cosine * (1 + np.cos(side)) * np.cos(half) - np.sin(side) * np.sin(half))
    slope = scale * np.array(
        [
            -cosine * np.sin(side) * np.cos(half) - np.cos(side) * np.sin(half),
            (-cosine * (1 + np.cos(side)) * np.sin(half) - np.sin(side) * np.cos(half)) / 2,
        ]
    )
    mixed = scale * (cosine * np.sin(side) * np.sin(half) - np.cos(side) * np.cos(half)) / 2
    curvature = np.array(
        [[scale * (-cosine * np.cos(side) * np.cos(half) + np.sin(side) * np.sin(half)), mixed], [mixed, -value / 4]]
    )
    return value, slope, curvature


def energy(angles, group=GROUP, ratio=RATIO, sector=SECTOR):
    """U / (k_e R^3) with its gradient and its Hessian by A and B."""
    side, middle = angles
    value, slope, curvature = gap(side, middle, sector)
    away = np.array([side - REST, middle])
    springs = group * np.array([2, ratio])
    stored = 2 / 3 * value**2 + springs @ away**2 / 2
    return (
        stored,
        4 / 3 * value * slope + springs * away,
        (4 / 3 * (np.outer(slope, slope) + value * curvature) + np.diag(springs)),
    )


def equilibrium(start):
    """Angles without a gradient near the given ones, deg."""
    return fsolve(lambda angles: energy(angles)[1], np.radians(start), xtol=1e-11)


LOCKED, SADDLE, FOLDED = (equilibrium(start) for start in ([17, 18], [3, 7.5], [-170, 0]))


def snap_moment(driven, start):
    """Moment at which an equilibrium is lost, N m: about each side crease (0) or about the middle crease (1)."""

    def lost(angles):
        _, slope, curvature = energy(angles)
        return slope[1 - driven], np.linalg.det(curvature)

    angles = fsolve(lost, np.radians(start), xtol=1e-11)
    return energy(angles)[1][driven] * UNIT / (2 if driven == 0 else 1)


TRIGGER, OPENING = snap_moment(1, [14, 10]), snap_moment(0, [-8, -16])


def turned(axis, angle):
    """Rotation by Rodrigues' formula."""
    x, y, z = axis / np.linalg.norm(axis)
    skew = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + math.sin(angle) * skew + (1 - math.cos(angle)) * skew @ skew


def along(angle):
    return np.array([math.cos(angle), math.sin(angle), 0.0])


def frames(first, middle, second):
    """Rotations of the four flat-drawn plates; the second one is held."""
    back, fold = turned(along(SECTOR), -first), turned(along(2 * SECTOR), middle)
    return [back, np.eye(3), fold, fold @ turned(along(3 * SECTOR), second)]


@pytest.fixture(scope="module")
def structure():
    return structure_of(DESIGN)


@pytest.fixture(scope="module")
def net(structure):
    return net_of(structure)


@pytest.fixture(scope="module")
def rests(structure, net):
    """Locked and folded, at the minima of the net's energy."""
    locked, _ = released(net, start_shape(structure, net))
    folded = minimum(net, posed(structure, net, np.radians([-170.0, 0, -170])))
    return locked, folded


def posed(structure, net, angles):
    """Shape of the net with its plates turned rigidly to given angles of the three joints, rad."""
    placed = []
    for number, body in enumerate(structure.bodies):
        hinge = next(((h, angle) for h, angle in zip(structure.hinges, angles, strict=False) if h.body == number), None)
        at, frame, origin = placed[body.parent] if body.parent >= 0 else (np.zeros(3), np.eye(3), np.zeros(3))
        turn = np.eye(3) if hinge is None else turned(hinge[0].axis, hinge[1] - hinge[0].built)
        placed.append((at + frame @ body.position, frame @ turn, origin + body.position))
    nodes = net.nodes.copy()
    for number, (at, frame, origin) in enumerate(placed):
        rows = slice(4 * number, 4 * number + 4)
        nodes[rows] = at + (nodes[rows] - origin) @ frame.T
    return shape_at(net, nodes, np.array([*angles, 0.0]))


def test_the_gap_follows_from_rotations(agree):
    random = np.random.default_rng(34)
    ours, known = [], []
    for side, middle, sector in random.uniform([-3.1, -3.1, 0.3], [3.1, 3.1, 1.6], (200, 3)):
        turn = turned(along(sector), side) @ turned(along(2 * sector), middle) @ turned(along(3 * sector), side)
        ours.append(np.linalg.norm(along(0) - turn @ along(4 * sector)) / 2)
        known.append(abs(gap(side, middle, sector)[0]))
    agree("sin(g / 2)", ours, known, by="the gap formula", abs=1e-12)


def test_the_closed_branches_have_no_gap(agree):
    side = np.radians(np.linspace(-175, 175, 8))
    middle = 2 * np.arctan(math.cos(SECTOR) / np.tan(side / 2))
    agree("sin(g / 2)", gap(side, middle)[0], 0.0, by="tan(A/2) tan(B/2) = cos α", abs=1e-15)


def test_plates_with_a_held_facet_and_one_opening_crease_are_a_net(structure):
    assert is_net(structure)
    assert [hinge.flaps is None for hinge in structure.hinges] == [True, True, True, False]


def test_the_energy_of_turned_plates_is_the_closed_form(agree, structure, net):
    random = np.random.default_rng(35)
    angles = random.uniform(-1.5, 1.5, (50, 2)) - [1.5, 0]
    ours = [expand(net, posed(structure, net, [side, middle, side])).stored for side, middle in angles]
    known = [energy(pair)[0] * UNIT for pair in angles]
    agree("energy", ours, known, unit="J", by="the closed form", rel=1e-10)


def test_both_states_and_the_saddle_are_those_of_the_closed_form(agree, holds, net, rests):
    saddle = find_saddle(net, *rests)
    for name, shape, known in (
        ("locked", rests[0].shape, LOCKED),
        ("folded", rests[1].shape, FOLDED),
        ("saddle", saddle.rest.shape, SADDLE),
    ):
        sides, middle = shape.angles[list(SIDES)], shape.angles[MIDDLE]
        agree(f"side angle, {name}", np.degrees(sides), math.degrees(known[0]), unit="deg", by="closed form", abs=5e-3)
        agree(
            f"middle angle, {name}", np.degrees(middle), math.degrees(known[1]), unit="deg", by="closed form", abs=5e-3
        )
    heights = [1e3 * UNIT * (energy(SADDLE)[0] - energy(state)[0]) for state in (LOCKED, FOLDED)]
    # bars that stand for plates yield by 5e-6 of the energy
    agree("barrier of the locked state", 1e3 * saddle.barriers[0], heights[0], unit="mJ", by="closed form", rel=1e-3)
    agree("barrier of the folded state", 1e3 * saddle.barriers[1], heights[1], unit="mJ", by="closed form", rel=1e-4)


def test_slowly_growing_torques_snap_at_the_moments_of_the_closed_form(agree, structure):
    trigger, opening = (course.least for course in slow_courses(structure))
    agree("moment that unlocks", 100 * trigger, -100 * TRIGGER, unit="N cm", by="closed form", rel=1e-3)
    agree("moment that opens", 100 * opening, 100 * OPENING, unit="N cm", by="closed form", rel=1e-3)


def torque(name, creases, value, rise):
    return {"name": name, "kind": "torque", "of": creases, "value": value, "rise": rise}


def stage(name, drive, limit, until="time"):
    return {"name": name, "drive": drive, "until": until, "hold": 0.0, "time_limit": limit}


def run(**values):
    (record,) = simulate([compile_model(with_values(DESIGN, {"measure": [], **values}))])
    return record


def side_angle(record):
    return record.series["hinge_angle"][:, list(SIDES)].mean(axis=1)
