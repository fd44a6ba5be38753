"""Statics and a slow, heavily damped simulation of the same design end in the same shapes.

Both share only the pattern and the positions on the bars: statics descends a closed-form energy, and the simulation
integrates the motion with dampers that make inertia negligible. Every hinge has the same damping, so that the motion
follows the steepest descent of the energy by the joint angles, as statics does. If a torque that is applied at once can
lead to two states, both therefore lead to the same one.

The engine's stops are damped springs with a time constant of twice the timestep (MuJoCo's solref). They yield by an
angle proportional to its square, while the stops of statics are rigid.
"""

import math

import numpy as np
import pytest

import forficula as ff
from forficula.design import load_design, with_values
from forficula.dynamics import compile_model, simulate
from forficula.statics.tree.ensemble import ensemble_of
from forficula.statics.tree.lines import line_energy
from forficula.statics.tree.potential import rest
from forficula.statics.tree.quasi_static import at_goal, least_slow_torque, start_state
from forficula.statics.tree.sheet import sheet_energy
from forficula.structure import drive_of, goal_of, hinges_of

FOLDED = math.radians(160)


def stage(name, drive, until, time_limit):
    return {"name": name, "drive": drive, "until": until, "hold": 0.0, "time_limit": time_limit}


def damped_design(reference, stages, damping, timestep=5e-4, **torques):
    """A design with negligible inertia."""
    return with_values(
        reference,
        {
            "hinge.damping": damping,
            "tendon.damping": 0.0,
            "membrane.damping": 1e-4,
            "protocol.timestep": timestep,
            "stops.time_constant": 2e-3,
            "protocol.sample_interval": 0.1,
            "protocol.rest_speed": 1e-5,  # slower than its creep before it rests
            "protocol.folded_angle": FOLDED,
            "protocol.stages": [stage("settle", "none", "time", 1.0), *stages],
            **{f"protocol.{name}": torque for name, torque in torques.items()},
        },
    )


def damped(reference, stages, damping, timestep=5e-4, **torques):
    """Run of a damped design."""
    return ff.run(damped_design(reference, stages, damping, timestep, **torques), confirm=False)


def end_of(run, number):
    """Row of the record at the end of a stage."""
    return int(np.argmin(np.abs(run.time - run.stages[number].end)))


def angles(run, row):
    """Angles at the end, rad, (1, hinge)."""
    return run.series["hinge_angle"][row][None]


def energies(wings, position):
    """Energies of the tendons and of the membrane, J."""
    return wings.tendons.energy(position[:, wings.crossed]).sum(), sheet_energy(wings.sheet, position)[0][0]


def rings(wings, position):
    """Angles of the ring hinges, rad, (1, hinge)."""
    return position[:, list(hinges_of(wings.structure, "ring"))]


def driven(wings, name, torque):
    """Torques of a drive of this size on every motor, N m."""
    drive = drive_of(wings.structure, name)
    return torque / drive.strength * np.array(drive.strengths)


def gets_to(wings, goal, position):
    return at_goal(wings, position, goal_of(wings.structure, goal)).all()


def least_at_once(wings, start, drive, goal, most):
    """Least torque that brings a wing to its goal when applied at once, to 1 %."""
    low, high = 0.0, most
    while high - low > 0.01 * high:
        torque = (low + high) / 2
        present = gets_to(wings, goal, rest(wings, start, driven(wings, drive, torque)).position)
        low, high = (low, torque) if present else (torque, high)
    return high


@pytest.fixture(scope="module")
def wings(reference):
    return ensemble_of([with_values(reference, {"protocol.folded_angle": FOLDED})])


@pytest.fixture(scope="module")
def flat(wings):
    return start_state(wings).position


@pytest.fixture(scope="module")
def pushed(reference):
    """Runs under half the least fold torque, at two timesteps."""
    return [
        damped(reference, [stage("fold", "fold", "folded", 15.0)], 0.005, timestep, fold_torque=0.0035)
        for timestep in (4e-4, 2e-4)
    ]


def test_the_flat_wing_rests_on_its_stops_in_statics_and_simulation(agree, holds, wings, flat, pushed):
    off = []
    for run in pushed:
        row = end_of(run, 0)
        off.append(np.abs(rings(wings, angles(run, row) - flat)).max())
        energy = run.series["tendon_energy"][row].sum()
        # the stops yield by 0.01 deg under each tendon's moment of 0.03 N m
        agree(
            "energy of the flat wing's tendons",
            energy,
            energies(wings, flat)[0],
            unit="J",
            by="statics",
            abs=3 * 0.03 * off[-1],
        )
    holds("deflection of stops", math.degrees(off[0]), below=0.01, unit="deg", by="rigid stops of the statics")
    agree(
        "deflection of stops divided by that at half the timestep",
        off[0] / off[1],
        1,
        by="stops with a time constant",
        rel=1e-3,
    )


def test_the_wing_under_half_its_least_torque_rests_at_the_same_angles_and_energies(agree, holds, wings, flat, pushed):
    static = rest(wings, flat, driven(wings, "fold", 0.0035))
    tendons, membrane = energies(wings, static.position)
    off = []
    for run in pushed:
        assert run.series["kinetic_energy"][-1] < 1e-9
        off.append(np.abs(angles(run, -1) - static.position).max())
        agree("energy of its tendons", run.series["tendon_energy"][-1].sum(), tendons, unit="J", by="statics", rel=1e-4)
        result = 1e3 * run.series["membrane_energy"][-1]
        agree("energy of its membrane", result, 1e3 * membrane, unit="mJ", by="statics", rel=1e-3)
    assert math.degrees(np.ptp(static.position)) > 90
    # the wing's softest mode amplifies the yielding of the stops ten times
    holds("difference of angles under half the least torque", math.degrees(off[0]), below=0.1, unit="deg", by="statics")
    agree(
        "this difference at half the timestep, divided by it",
        off[1] / off[0],
        1,
        by="stops with a time constant",
        rel=1e-3,
    )


def test_the_least_fold_torque_of_statics_is_that_of_a_damped_simulation(agree, reference, wings, flat):
    least = least_slow_torque(wings, flat, wings.structure.transitions[0], 0.5).torque[0]
    at_once = least_at_once(wings, flat, "fold", "folded", 0.5)
    # 1 % each
    agree("least torque applied at once", 100 * at_once, 100 * least, unit="N cm", by="least slow torque", rel=0.02)
    for share, folds in ((0.97, False), (1.03, True)):
        run = damped(reference, [stage("fold", "fold", "folded", 25.0)], 0.005, fold_torque=share * least)
        assert (run.stages[1].goal_time is not None) == folds
        assert (run.series["kinetic_energy"][-1] < 1e-9) or folds


def test_the_least_opening_torque_is_that_of_a_damped_simulation_and_below_it_the_wing_stays_partly_folded(
    agree, reference, wings
):
    fold = stage("fold", "fold", "folded", 60.0)
    opening = [fold, stage("unfold", "unfold", "time", 8.0), stage("release", "none", "time", 15.0)]
    folded = angles(damped(reference, [fold], 0.03, fold_torque=0.06), -1)
    assert rings(wings, folded).max() < -math.radians(159)
    least = least_at_once(wings, folded, "unfold", "opened", 0.5)
    designs = [
        damped_design(reference, opening, 0.03, fold_torque=0.06, unfold_torque=share * least) for share in (0.97, 1.03)
    ]
    # runs in one batch share the fold stage
    below, above = simulate([compile_model(design) for design in designs])
    assert angles(below, end_of(below, 1)) == pytest.approx(folded, abs=1e-12)
    opened = angles(above, end_of(above, 2))
    assert gets_to(wings, "opened", opened)
    under_torque = angles(below, end_of(below, 2))
    assert not gets_to(wings, "opened", under_torque)

    static = rest(wings, folded, driven(wings, "unfold", 0.97 * least))
    assert ((rings(wings, under_torque) < 0) == (rings(wings, static.position) < 0)).all()
    assert (rings(wings, static.position) < 0).sum() == 1
    by = "statics"
    ours, theirs = energies(wings, under_torque)[0], energies(wings, static.position)[0]
    agree("energy of its tendons under the torque", ours, theirs, unit="J", by=by, rel=0.01)

    released = rest(wings, static.position)
    tendons, membrane = energies(wings, released.position)
    assert released.rests.all()
    # hinges at their stops and one folded; a wing with a slack tendon, which no force holds, creeps
    result = below.series["tendon_energy"][-1].sum()
    agree("energy of its tendons, released", result, tendons, unit="J", by=by, rel=1e-4)
    result = 1e3 * below.series["membrane_energy"][-1]
    agree("energy of its membrane, released", result, 1e3 * membrane, unit="mJ", by=by, rel=0.01)


@pytest.mark.parametrize("stiffness", ["rigid", 0.1])
def test_the_least_torque_of_one_motor_on_coupled_veins_is_that_of_a_damped_simulation(agree, stiffness):
    """The motor turns one vein, and couplings move the others."""
    coupled = with_values(load_design("binder2025-coupled"), {"coupling.stiffness": stiffness})
    wings = ensemble_of([with_values(coupled, {"protocol.folded_angle": FOLDED})])
    flat = start_state(wings).position
    least = least_slow_torque(wings, flat, wings.structure.transitions[0], 0.5).torque[0]
    result = 100 * least_at_once(wings, flat, "fold", "folded", 0.5)
    agree("least torque applied at once", result, 100 * least, unit="N cm", by="least slow torque", rel=0.02)
    for share, folds in ((0.97, False), (1.03, True)):
        run = damped(coupled, [stage("fold", "fold", "folded", 40.0)], 0.005, fold_torque=share * least)
        assert (run.stages[1].goal_time is not None) == folds
        assert (run.series["kinetic_energy"][-1] < 1e-9) or folds
        if not folds:
            static = rest(wings, flat, driven(wings, "fold", share * least))
            # the engine's stops yield, and the wing creeps
            ours, theirs = np.degrees(angles(run, -1)), np.degrees(static.position)
            agree("angles below the least torque", ours, theirs, unit="deg", by="statics", abs=1)


def test_two_ring_folds_held_partly_folded_by_a_torque_rest_as_in_statics(agree):
    """A torque that grows within 15 s leaves them partly folded; one that grows within 100 s folds them at 0.6 N cm."""
    thick = with_values(load_design("binder2025-thick"), {"protocol.contact": False, "protocol.rise": 15.0})
    wings = ensemble_of([with_values(thick, {"protocol.folded_angle": FOLDED})])
    torque = 0.0436  # N m, at which they rest partly folded
    below = damped(thick, [stage("fold", "fold", "folded", 40.0)], 0.005, fold_torque=torque)
    assert below.stages[1].goal_time is None
    # partly folded, at the rest state of the statics
    assert below.series["kinetic_energy"][-1] < 1e-9
    held = angles(below, -1)
    assert np.ptp(rings(wings, held)) > math.radians(80)
    static = rest(wings, held, driven(wings, "fold", torque)).position
    by = "simulation"
    agree("angles at rest", np.degrees(static), np.degrees(held), unit="deg", by=by, abs=0.2)
    result, known = line_energy(wings.lines, static)[0], below.series["tendon_energy"][-1].sum()
    agree("energy of its tendons", result, known, unit="J", by=by, rel=2e-3)
    result, known = 1e3 * sheet_energy(wings.sheet, static)[0], 1e3 * below.series["membrane_energy"][-1]
    agree("energy of its membrane", result, known, unit="mJ", by=by, rel=0.02)
