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


def test_both_states_and_the_saddle_are_those_of_the_closed_form(agree, net, rests):
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
    snap, back = slow_courses(structure)
    agree("moment that unlocks", 100 * snap.least, -100 * TRIGGER, unit="N cm", by="closed form", rel=1e-3)
    agree("moment that opens", 100 * back.least, 100 * OPENING, unit="N cm", by="closed form", rel=1e-3)
    for course, state in ((snap, FOLDED), (back, LOCKED)):  # released at the goal
        sides = np.degrees(course.rest.shape.angles[list(SIDES)])
        agree("side angle after release", sides, math.degrees(state[0]), unit="deg", by="closed form", abs=5e-3)


def torque(name, creases, value, rise):
    return {"name": name, "kind": "torque", "of": creases, "value": value, "rise": rise}


def stage(name, drive, limit, until="time"):
    return {"name": name, "drive": drive, "until": until, "hold": 0.0, "time_limit": limit}


def run(values):
    (record,) = simulate([compile_model(with_values(DESIGN, values))])
    return record


def side_angle(record):
    return record.series["hinge_angle"][:, list(SIDES)].mean(axis=1)


@pytest.mark.parametrize(
    ("name", "creases", "known", "folds"),
    [("unlocks", "middle", TRIGGER, False), ("opens", "sides", OPENING, True)],
    ids=["unlocking", "opening"],
)
def test_a_slow_torque_in_a_run_snaps_at_the_moment_of_the_closed_form(agree, name, creases, known, folds):
    """From 99 % of the moment, the torque grows by 2 % in 0.4 s; the snap passes the side angle of the saddle."""
    drives = [torque("fold", "sides", -0.01, 0.0), torque("near", creases, 0.99 * known, 0.1)]
    drives.append(torque("grow", creases, 0.02 * known, 0.4))
    stages = [stage("near", "near", 0.12), stage("grow", ["near", "grow"], 0.4)]
    if folds:
        stages = [stage("fold", "fold", 1.0, "side angle < -150 deg"), stage("wait", "none", 0.06), *stages]
    record = run({"drive": drives, "protocol.timestep": 1e-4, "protocol.stages": stages})
    angle, begin = side_angle(record), np.searchsorted(record.time, record.stages[-1].start)
    beyond = (angle[begin:] > SADDLE[0]) == folds
    assert not beyond[0]
    moment = known * (0.99 + 0.05 * (record.time[begin + np.argmax(beyond)] - record.time[begin]))
    agree(f"moment that {name} in a run", 100 * abs(moment), 100 * abs(known), unit="N cm", by="closed form", rel=5e-3)


PLATE_MASS = 1270 * 5e-4 * RADIUS**2 * math.sin(SECTOR) / 2
BUILT = 2 * math.atan(math.sqrt(math.cos(SECTOR)))  # of all creases, closed


def mass_points(angles):
    """Three points of every plate, m, (12, 3): a triangle moves as a third of its mass in the middle of every side."""
    places = []
    for number, frame in enumerate(frames(*angles)):
        ends = RADIUS * np.array([along(number * SECTOR), along((number + 1) * SECTOR)])
        places.append(np.array([ends[0] / 2, ends[1] / 2, ends.mean(axis=0)]) @ frame.T)
    return np.concatenate(places)


def potential(angles):
    """Energy of three joints whose sides may differ, J."""
    turn = frames(*angles)
    opening = np.linalg.norm(turn[0] @ along(0) - turn[3] @ along(4 * SECTOR)) / 2
    away = np.array(angles) - [REST, 0, REST]
    return UNIT * (2 / 3 * opening**2 + GROUP / 2 * np.array([1, RATIO, 1]) @ away**2)


def accelerations(angles, speeds, moments):
    """Solve Lagrange's equations of the three joints without damping, rad/s^2."""
    steps, brief = 1e-5 * np.eye(3), 1e-7  # rad, s
    slopes = np.array([(mass_points(angles + step) - mass_points(angles - step)) / 2e-5 for step in steps])
    moved = mass_points(angles + brief * speeds) + mass_points(angles - brief * speeds)
    turning = (moved - 2 * mass_points(angles)) / brief**2
    force = moments - np.array([(potential(angles + step) - potential(angles - step)) / 2e-5 for step in steps])
    mass = PLATE_MASS / 3
    inertia = mass * np.einsum("ipx,jpx->ij", slopes, slopes)
    return np.linalg.solve(inertia, force - mass * np.einsum("ipx,px->i", slopes, turning))


def test_the_snap_takes_the_time_of_equations_of_motion_of_its_three_joints(agree, holds):
    """Without damping, from the built shape, under a torque on both sides that acts at once."""
    moments, end = np.array([-4e-3, 0, -4e-3]), math.radians(-150)

    def motion(_, state):
        return [*state[3:], *accelerations(state[:3], state[3:], moments)]

    def arrival(_, state):
        return (state[0] + state[2]) / 2 - end

    arrival.terminal = True
    known = solve_ivp(motion, (0, 0.02), [BUILT] * 3 + [0.0] * 3, events=arrival, rtol=1e-6, atol=1e-8)
    times = []
    for step in (4e-5, 2e-5, 1e-5):
        record = run(
            {
                "crease.damping": 0.0,
                "crease.group.opening.extension_damping": 0.0,
                "drive": [torque("push", "sides", -4e-3, 0.0)],
                "protocol.timestep": step,
                "protocol.sample_interval": 4e-5,
                "protocol.stages": [stage("push", "push", 0.02, "side angle < -155 deg")],
            }
        )
        times.append(1e3 * np.interp(-end, -side_angle(record), record.time))
    by = "Lagrange's equations"
    agree("time to a side angle of -150 deg", times[-1], 1e3 * known.t[-1], unit="ms", by=by, rel=2e-3)
    limit = 2 * times[-1] - times[-2]
    agree("its limit for small timesteps", limit, 1e3 * known.t[-1], unit="ms", by=by, rel=5e-4)
    shrinks = (times[2] - times[1]) / (times[1] - times[0])
    holds("change of the time by halving the timestep, divided by the change before", shrinks, above=0.4, below=0.6)


def test_the_named_design_locks_folds_and_locks_again_within_its_energy_balance(agree, holds):
    record = run({})
    ends = np.searchsorted(record.time, [record.stages[number].end - 1e-9 for number in (0, 2, 4)])
    for name, row, known in zip(("locked", "folded", "locked again"), ends, (LOCKED, FOLDED, LOCKED), strict=True):
        angles = record.series["hinge_angle"][row, : MIDDLE + 1]
        agree(f"angles, {name}", np.degrees(angles), np.degrees(known), unit="deg", by="closed form", abs=2e-3)
        stored = sum(record.series[part][row].sum() for part in ("hinge_energy", "spring_energy"))
        known_energy = 1e3 * UNIT * energy(known)[0]
        agree(f"energy, {name}", 1e3 * stored, known_energy, unit="mJ", by="closed form", rel=1e-8, abs=1e-7)
    holds("missing energy", energy_balance(record).residual, below=1e-3, by="conservation of energy")


def loses(values, angles):
    """Return whether statics leave the locked state, from given angles of sides and middle, deg."""
    structure = structure_of(with_values(DESIGN, values))
    net = net_of(structure)
    side, middle = np.radians(angles)
    return minimum(net, posed(structure, net, [side, middle, side])).shape.angles[0] < 0


def lost_where(start, moved):
    """Return angles and the moved value at which the equilibrium of the closed form is degenerate."""

    def conditions(unknown):
        _, slope, curvature = energy(unknown[:2], **moved(unknown[2]))
        return [*slope, np.linalg.det(curvature)]

    return fsolve(conditions, start, xtol=1e-11)[2]


def test_the_locked_state_is_lost_if_the_sectors_sum_to_more_than_352_deg(agree):
    limit = math.degrees(4 * lost_where(np.radians([9, 13, 88.2]), lambda sector: {"sector": sector}))
    known = (352.05, 352.1)
    assert [loses({"pattern.sector_sum": math.radians(total)}, (9, 13)) for total in known] == [False, True]
    agree("largest sum of sectors that locks", np.mean(known), limit, unit="deg", by="closed form", abs=0.025)


@pytest.mark.parametrize(
    ("ratio", "known", "angles"), [(20.0, (1.70e-3, 1.71e-3), (10, 13)), (1.0, (4.85e-3, 4.89e-3), (3, 38))]
)
def test_the_locked_state_needs_creases_that_are_soft_relative_to_their_extension(agree, ratio, known, angles):
    start = [*np.radians(angles), known[0]]
    limit = lost_where(start, lambda group: {"group": group, "ratio": ratio})
    lost = []
    for group in known:
        stiffness = group * EXTENSION * RADIUS**2
        values = {"crease.group.sides.stiffness": stiffness, "crease.group.middle.stiffness": ratio * stiffness}
        lost.append(loses(values, angles))
    assert lost == [False, True]
    words = f"largest k_r / (k_e R²) that locks, at w = {ratio:g}"
    agree(words, np.mean(known), limit, by="closed form", abs=np.ptp(known) / 2)
