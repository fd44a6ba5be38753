"""Rigid facets hinged in loops keep the loops closed and move along closed forms.

Flat-foldable vertices of four creases (Evans, Lang, Magleby and Howell 2015, doi 10.1098/rsos.150067): opposite fold
angles have the same magnitude, and the half-angle tangents of neighbouring ones have a constant ratio. Miura sheets:
Schenk and Guest 2013, doi 10.1073/pnas.1217998110.
"""

import math

import mujoco
import numpy as np
import pytest
import scipy
from hypothesis import given, settings
from hypothesis import strategies as st

from forficula.analysis import measure
from forficula.dynamics import compile_model, energy_balance, simulate
from forficula.pattern.families.miura_ori import miura_pattern
from forficula.structure import GROUND, mass_of, structure_of
from forficula.study.running.runs import run
from tests.plate_sheets import miura, plates, vertex

SIDE, ACUTE = 0.02, math.radians(60)
SPRINGS = 'stiffness = "1e-3 N m/rad/m"\nrest_angle = "75 deg"\ndamping = "0 N m s/rad/m"'


def swing(pattern, **more):
    (record,) = simulate([compile_model(plates(pattern, crease=more.pop("crease", SPRINGS), **more))])
    return record


def folds(record):
    """Fold angles by edge, in own senses, rad, (time, edge)."""
    order = np.argsort([int(hinge.name.removeprefix("crease")) for hinge in record.structure.hinges])
    return record.series["hinge_angle"][:, order]


@settings(deadline=None, max_examples=4)
@given(st.floats(45, 70), st.floats(85, 105))
def test_a_flat_foldable_vertex_satisfies_the_half_angle_tangent_relations(agree, one, two):
    crease = f'{SPRINGS}\nback_limit = "180 deg"'
    pattern = vertex([one, two, 180 - one, 180 - two], "VVVM", fold="25 deg")
    record = swing(pattern, crease=crease, stages=[{"name": "a", "limit": "0.1 s"}])
    angles = np.abs(folds(record))
    assert np.ptp(angles, axis=0).max() > math.radians(10)
    degrees, close = np.degrees(angles), {"unit": "deg", "abs": 0.05}
    agree("fold angles of a crease", degrees[:, :2], degrees[:, 2:], by="the opposite crease", **close)
    sine, cosine = math.sin(math.radians(one - two) / 2), math.cos(math.radians(one - two) / 2)
    # each of the two folding modes has its own constant ratio
    ratios = [abs(sine / math.sin(math.radians(one + two) / 2)), abs(math.cos(math.radians(one + two) / 2) / cosine)]
    ratios += [1 / ratio for ratio in ratios]
    started = math.tan(angles[0, 0] / 2) / math.tan(angles[0, 1] / 2)
    ratio = min(ratios, key=lambda item: abs(item - started))
    known = np.degrees(2 * np.arctan(ratio * np.tan(angles[:, 1] / 2)))
    agree("fold angles of its neighbour", degrees[:, 0], known, by="tan half angles", **close)


@pytest.fixture(scope="module")
def sheet():
    return swing(miura(4), step="0.1 ms", stages=[{"name": "swing", "limit": "0.4 s"}])


def test_a_miura_sheet_folds_with_one_degree_of_freedom(agree, sheet):
    pattern = sheet.design.sheet
    roles = np.array(pattern.edges_role)[[int(hinge.name.removeprefix("crease")) for hinge in sheet.structure.hinges]]
    angles = sheet.series["hinge_angle"]
    zigzag, straight = angles[:, roles == "zigzag"], angles[:, roles != "zigzag"]
    if np.ptp(zigzag[0]) > 1e-9 or zigzag[0, 0] < straight[0, 0]:
        zigzag, straight = straight, zigzag
    assert np.ptp(zigzag[:, 0]) > math.radians(40)
    close = {"unit": "deg", "abs": 0.05}
    agree("fold angles of zigzag creases", np.degrees(zigzag), np.degrees(zigzag[:, :1]), by="one of them", **close)
    # tan(straight / 2) = cos(acute angle) tan(zigzag / 2)
    expected = 2 * np.arctan(math.cos(math.radians(60)) * np.tan(zigzag[:, :1] / 2))
    by = "Schenk and Guest 2013"
    agree("fold angles of straight creases", np.degrees(straight), np.degrees(expected), by=by, **close)
    first, known, time = np.degrees(straight[:, 0]), np.degrees(expected[:, 0]), ("time (s)", sheet.time)
    agree("fold angle of a straight crease", first, known, by=by, over=time, **close)


def test_a_miura_sheet_swings_as_its_single_coordinate(agree, sheet):
    """The inertia of the fold angle follows from the closed form of the folded shape, without joints or loops."""
    roles = np.array(sheet.design.sheet.edges_role)
    edges = [int(hinge.name.removeprefix("crease")) for hinge in sheet.structure.hinges]
    zigzag = int(np.flatnonzero(roles[edges] == "zigzag")[0])
    known = single_coordinate_swing(4, sheet)
    angles, swept = np.degrees(sheet.series["hinge_angle"][:, zigzag]), np.degrees(known)
    assert np.ptp(swept) > 40
    time = ("time (s)", sheet.time)
    agree("fold angle", angles, swept, unit="deg", by="one coordinate", abs=2e-4, over=time)


def single_coordinate_swing(size, record):
    """Integrate the motion of a Miura sheet of one fold angle about its held plate, rad, (time,)."""
    held = next(int(body.name.removeprefix("facet")) for body in record.structure.bodies if body.parent == GROUND)
    cells = np.array(miura_pattern(size, size, SIDE, SIDE, ACUTE, 1.0).faces_vertices)
    gauss = (1 + np.array([-1, 1]) / math.sqrt(3)) / 2
    thickness, density = 0.5e-3, 1200.0
    mass = density * thickness * SIDE**2 * math.sin(ACUTE)

    def places(fold):
        """Return the Gauss points of all plates in the axes of the held plate, (plate, 8, 3)."""
        corners = miura_pattern(size, size, SIDE, SIDE, ACUTE, fold).vertices_coords[cells]
        first, last = corners[:, 1] - corners[:, 0], corners[:, 3] - corners[:, 0]
        normal = np.cross(first, last)
        normal /= np.linalg.norm(normal, axis=1)[:, None]
        points = np.stack(
            [
                corners[:, 0] + u * first + v * last + thickness * (w - 0.5) * normal
                for u in gauss
                for v in gauss
                for w in gauss
            ],
            axis=1,
        )
        x, z = first[held] / SIDE, normal[held]
        return (points - corners[held, 0]) @ np.stack([x, np.cross(z, x), z], axis=1)

    angles, step = np.linspace(math.radians(5), math.radians(175), 400), 1e-5
    speeds = [(places(fold + step) - places(fold - step)) / (2 * step) for fold in angles]
    inertia = scipy.interpolate.CubicSpline(angles, [mass / 8 * (speed**2).sum() for speed in speeds])
    # as many straight creases as zigzag creases
    stiffness, rest = size * (size - 1) * 1e-3 * SIDE, math.radians(75)

    def motion(_, state):
        fold, speed = state
        cosine = math.cos(ACUTE)
        straight = 2 * math.atan(cosine * math.tan(fold / 2))
        slope = cosine * (1 + math.tan(fold / 2) ** 2) / (1 + (cosine * math.tan(fold / 2)) ** 2)
        torque = rest - fold + (rest - straight) * slope
        return [speed, (stiffness * torque - inertia(fold, 1) * speed**2 / 2) / inertia(fold)]

    start, span = [math.radians(30), 0.0], (0.0, record.time[-1])
    return scipy.integrate.solve_ivp(motion, span, start, t_eval=record.time, rtol=1e-9, atol=1e-12).y[0]


def test_loops_stay_closed_to_a_hundred_thousandth_of_an_edge(agree, holds, sheet):
    gap = sheet.series["closure_gap"]
    holds("gap divided by an edge", gap[-1] / 0.02, above=0, below=1e-5, by="closed loops")
    assert (np.diff(gap) >= 0).all()
    # the corners of neighbouring facets confirm it
    names = [point.name for point in sheet.structure.points]
    places = sheet.series["point_position"]
    pairs = [pair for closure in sheet.structure.closures for pair in closure.points]
    apart = [np.linalg.norm(places[:, one] - places[:, other], axis=1).max() for one, other in pairs]
    agree("gap", 1e9 * max(apart), 1e9 * gap[-1], unit="nm", by="positions of corners", rel=0.5)
    assert len(names) == len(set(names))


def test_energy_is_conserved_and_closing_loops_does_no_work(agree, holds, sheet):
    energy = sheet.series["hinge_energy"].sum(axis=1) + sheet.series["kinetic_energy"]
    assert sheet.series["kinetic_energy"].max() > 0.5 * energy[0]
    agree("energy", 1e3 * energy, 1e3 * energy[0], unit="mJ", by="at the start", rel=1e-4)
    balance = energy_balance(sheet)
    assert balance.closures is not None
    share = abs(balance.closures) / balance.exchanged
    holds("work of closures divided by the exchanged energy", share, below=1e-4, by="constraints do no work")
    holds("missing energy", balance.residual, below=1e-4, by="conservation of energy")


def test_gaps_and_their_work_decrease_with_the_square_of_the_timestep(holds):
    gaps, lost = [], []
    for step in ("1 ms", "0.5 ms", "0.25 ms"):
        record = swing(miura(2), step=step, stages=[{"name": "swing", "limit": "0.1 s"}])
        gaps.append(float(record.series["closure_gap"][-1]))
        lost.append(energy_balance(record).residual)
    orders = np.log2(np.array(gaps[:-1]) / gaps[1:])
    holds("order of the gap in the timestep", orders, above=1.6, by="second order")
    holds("missing energy divided by that at four times the timestep", lost[2] / lost[0], below=1 / 4)


def test_the_energy_balance_of_a_driven_damped_sheet_on_its_stops_closes(agree, holds):
    drive = '[[drive]]\nname = "fold"\nkind = "torque"\nof = "creases"\nvalue = "2e-3 N cm"\nrise = "20 ms"'
    crease = 'stiffness = "1e-3 N m/rad/m"\ndamping = "1e-5 N m s/rad/m"\nfold_limit = "80 deg"'
    stages = [{"name": "fold", "drive": "fold", "limit": "0.3 s"}]
    record = swing(miura(2), crease=crease, more=drive, stages=stages, step="0.1 ms")
    most = np.degrees(record.series["hinge_angle"].max())
    agree("largest fold angle", most, 80, unit="deg", by="its stop", abs=1)
    balance = energy_balance(record)
    assert balance.stops > 0.01 * balance.work
    assert balance.hinge_damping > 0.01 * balance.work
    holds("missing energy", balance.residual, below=5e-3, by="conservation of energy")


def test_sparse_and_dense_constraints_give_the_same_motion_on_stops(agree):
    """The solver factorises a sparse matrix for loops; stops change its set of active constraints."""
    crease = 'stiffness = "1e-3 N m/rad/m"\nrest_angle = "75 deg"\nfold_limit = "50 deg"'
    stages = [{"name": "swing", "limit": "0.1 s"}]
    folded = []
    for jacobian in (mujoco.mjtJacobian.mjJAC_SPARSE, mujoco.mjtJacobian.mjJAC_DENSE):
        model = compile_model(plates(miura(3), crease=crease, step="0.2 ms", stages=stages))
        model.engine.opt.jacobian = jacobian
        folded.append(np.degrees(simulate([model])[0].series["hinge_angle"]))
    assert folded[0].max() > 50
    agree("fold angles", *folded, unit="deg", by="a dense factorisation", abs=1e-8)


def test_a_plate_and_its_copies_share_the_mass(agree):
    structure = structure_of(plates(miura(3)))
    alone = structure_of(plates(miura(3), crease='extension = "1e4 N/m^2"'))
    assert len(structure.closures) == 4
    total = sum(mass_of(structure, body)[0] for body in range(len(structure.bodies)))
    known = sum(mass_of(alone, body)[0] for body in range(len(alone.bodies)))
    agree("mass of a sheet in loops", 1e3 * total, 1e3 * known, unit="g", by="without copies", rel=1e-12)
    original, copy = structure.closures[0].bodies
    (mass, _, inertia), (other, _, same) = mass_of(structure, original), mass_of(structure, copy)
    assert mass == other
    np.testing.assert_allclose(inertia, same, rtol=1e-12, atol=1e-20)


def test_at_the_automatic_timestep_the_energy_balance_and_the_loops_close(holds):
    damped = SPRINGS.replace('damping = "0 N', 'damping = "1e-5 N')
    stages = [{"name": "swing", "limit": "60 ms"}]
    record = run(plates(miura(3), crease=damped, step="auto", stages=stages))
    limit = record.design.protocol.residual_limit
    holds("missing energy", energy_balance(record).residual, below=limit, by="conservation of energy")
    holds("gap divided by an edge", record.series["closure_gap"][-1] / 0.02, below=1e-4, by="closed loops")
    assert record.doubt == ""


def test_a_run_with_open_loops_is_unreliable():
    """The timestep is 100 times the longest stable one of its springs, so that welds cannot hold."""
    record = swing(
        miura(3), step="10 ms", crease=SPRINGS.replace("1e-3", "2e-2"), stages=[{"name": "a", "limit": "1 s"}]
    )
    assert record.diverged_at is not None or "come apart by" in record.doubt
    outcome = measure(record)
    assert not outcome.verdict.conclusive
