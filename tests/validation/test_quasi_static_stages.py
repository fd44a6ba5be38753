"""Quasi-static stages of a run against closed forms, energy landscapes, and slower and slower motions."""

import numpy as np
import pytest

from forficula.analysis import measure
from forficula.design import load_design, with_values
from forficula.statics.net.energy import shape_at
from forficula.statics.net.minimum import minimum, stationary
from forficula.statics.net.net_of import net_of, start_shape
from forficula.structure import structure_of
from forficula.study.running.runs import run
from tests.elastic_joint import FOLDED, STRENGTH, energy, joint, moment, peak, slow, stage
from tests.plate_sheets import miura, plates
from tests.pyramid import DEEP, RISE, pyramid

PRESS = {"name": "press", "kind": "displacement", "of": "vertex 0", "direction": [0, 0, -1], "rise": 0.05}


def stored(record):
    """Stored energy of the record, J, (time,)."""
    parts = [values for name, values in record.series.items() if name.endswith("_energy") and name != "kinetic_energy"]
    return sum(part.reshape(len(record.time), -1).sum(axis=1) for part in parts)


def row_at(record, moment):
    return int(np.argmin(np.abs(record.time - moment)))


@pytest.fixture(scope="module")
def opened():
    """The joint that is opened slowly from its stop to its other stop."""
    # the joint comes to rest before its goal counts as held
    values = {"protocol.least_hold": 1.0}
    return run(joint(slow("open", "unfold", "opened"), stage("release", "none", "rest", hold=0.02), **values))


def test_a_slowly_opened_joint_loses_its_equilibrium_at_the_largest_moment_of_its_tendon(opened, agree):
    end = opened.stages[3]
    assert len(end.lost) == 1
    agree("least torque", end.lost[0] * STRENGTH, moment(peak()), by="closed form", unit="N m", rel=1e-8)


def test_the_work_up_to_each_equilibrium_is_the_stored_energy(opened, agree):
    end, angle = opened.stages[3], -opened.series["hinge_angle"][:, 0]
    rests = (opened.time > end.start) & (opened.series["kinetic_energy"] == 0) & (angle > 1)
    agree("angle at the largest torque", angle[rests][-1], peak(), by="closed form", unit="rad", abs=1e-4)
    first = row_at(opened, end.start)
    work = opened.work[rests] - opened.work[first]
    agree("work", work, energy(angle[rests]) - energy(FOLDED), by="closed form", unit="J", rel=1e-6, abs=1e-9)


def test_a_snap_in_a_slow_stage_dissipates_what_the_torque_and_the_tendon_release(opened, agree):
    end, angle = opened.stages[3], -opened.series["hinge_angle"][:, 0]
    before, after = row_at(opened, end.start), row_at(opened, end.end)
    lost = sum(opened.series[f"{name}_work"] for name in ("hinge_damping", "stop"))
    # the snap begins slowly: the excess of the torque over the lost one, 1e-4 at first, doubles until the joint moves
    torque, turn, dissipated = end.share * STRENGTH, peak() - angle[after], lost[before] - lost[after]
    assert 0 < torque / moment(peak()) - 1 < 1e-3
    # in the simulation, the stop yields by 0.07 deg
    released = energy(peak()) - energy(angle[after])
    agree("energy released", dissipated, moment(peak()) * turn + released, by="closed form", unit="J", rel=5e-3)
    agree("energy released at the torque", dissipated, torque * turn + released, by="closed form", unit="J", rel=3e-3)
    balance = measure(opened).energy_balance
    assert balance.residual < 5e-4
    assert abs(balance.settling) < 1e-4 * balance.exchanged


def test_slower_and_slower_motions_converge_to_a_quasi_static_stage_with_the_order_of_their_damping(agree):
    goal = "distal_angle > -120 deg"
    record = run(joint(slow("open", "unfold", goal)))
    work, share = measure(record).stages[-1].work, record.stages[-1].share
    agree("work up to a goal", work, energy(np.radians(120)) - energy(FOLDED), by="closed form", unit="J", rel=1e-7)
    agree("torque at a goal", share * STRENGTH, moment(np.radians(120)), by="closed form", unit="N m", rel=1e-9)
    rises = (1.0, 2.0, 4.0)
    works = [
        measure(run(joint(stage("open", "unfold", goal, 2 * rise), **{"protocol.rise": rise}))).stages[-1].work
        for rise in rises
    ]
    excess = np.array(works) - work
    assert np.log2(excess[:-1] / excess[1:]) == pytest.approx(1, abs=0.05)
    agree("work of infinitely slow motion", 2 * works[2] - works[1], work, by="simulation", unit="J", rel=2e-3)


def test_a_structure_pushed_over_its_barrier_releases_the_energy_below_its_saddle(agree):
    """The apex is displaced to the saddle, then slightly further, and released."""
    structure = structure_of(pyramid())
    net = net_of(structure)
    up = minimum(net, start_shape(structure, net))
    places = up.shape.positions.copy()
    places[0, 2] = up.shape.positions[1, 2]
    saddle = stationary(net, shape_at(net, places, up.shape.angles))
    places[0, 2] -= RISE
    down = minimum(net, shape_at(net, places, up.shape.angles))
    assert (up.index, saddle.index, down.index) == (0, 1, 0)
    height = DEEP + saddle.shape.positions[0, 2]
    press = {"drive": "press", "limit": 10.0, "motion": "quasi-static"}
    design = pyramid(
        **{
            "drive": [{**PRESS, "distance": 1.5 * RISE}],
            "protocol.least_hold": 0.0,
            "protocol.stages": [
                stage("press", until=f"height < {height:.12f} m", **press),
                stage("press on", until=f"height < {height - 5e-5:.12f} m", state="down", **press),
                stage("release", "none", "rest", hold=0.05),
            ],
        }
    )
    record = run(design)
    outcome, energies, released = measure(record), stored(record), row_at(record, record.stages[1].end)
    rise, fall = saddle.energy - up.energy, saddle.energy - down.energy
    agree("work up to the saddle", outcome.stages[0].work, rise, by="equilibria of statics", unit="J", rel=1e-8)
    agree("energy released", energies[released] - energies[-1], fall, by="equilibria of statics", unit="J", rel=5e-4)
    balance = outcome.energy_balance
    lost = balance.hinge_damping + balance.elastic_damping
    agree("energy dissipated after the release", lost, fall, by="equilibria of statics", unit="J", rel=2e-3)
    assert balance.residual < 5e-3
    # four bars whose other ends are held; the creases are soft
    bars = [spring for spring in record.structure.springs if 0 in spring.points]
    flat = sum(bar.stiffness / 2 * (bar.rest_length - np.sqrt(bar.rest_length**2 - RISE**2)) ** 2 for bar in bars)
    agree("work up to the flat shape", outcome.stages[0].work, flat, by="von Mises' truss", unit="J", rel=2e-3)


def loop():
    """Two by two rigid parallelograms, which close a loop, folded by a torque on all creases."""
    crease = 'stiffness = "2e-2 N m/rad/m"\nrest_angle = "as built"\ndamping = "1e-3 N m s/rad/m"'
    drive = '[[drive]]\nname = "fold"\nkind = "torque"\nof = "creases"\nvalue = "1e-4 N m"'
    design = plates(miura(2), crease=crease, more=f'[[support]]\nof = "facet 0"\n{drive}')
    return with_values(design, {"protocol.stages": [slow("fold", "fold")], "protocol.rest_speed": 0.03})


def opening_plates():
    """Four free plates whose creases open, pushed with 80 % of the force at which they snap."""
    drives = ["push apex", "push rim"]
    values = {f"drive.{drive}.value": 0.002 for drive in drives}
    stages = [slow("push", drives)]
    return with_values(load_design("four-plate-snap"), values | {"protocol.timestep": 2e-4, "protocol.stages": stages})


# angles of creases that open by some percent of a plate differ by 0.006 deg between statics and engine
@pytest.mark.parametrize(("design", "share"), [(loop, 1e-5), (opening_plates, 2e-4)])
def test_the_work_on_plates_is_the_energy_that_the_engine_computes_for_their_equilibria(design, share, agree):
    record = run(design())
    (end,) = record.stages
    assert (end.share, end.lost) == (1.0, ())
    # statics begins after the plates have rested for a while
    energies, first = stored(record), np.flatnonzero((record.series["kinetic_energy"] == 0) & (record.time > 0))[0]
    what, change = "work of a slow stage on plates", energies[-1] - energies[first]
    agree(what, record.work[-1] - record.work[first], change, by="energies of the engine", unit="J", rel=share)
