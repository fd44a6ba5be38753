"""Dry friction of hinges: a constant torque against the motion, which also holds a hinge at rest."""

import mujoco
import numpy as np
import pytest

from forficula.analysis import Verdict, measure
from forficula.design import load_design
from forficula.dynamics import Record, energy_balance
from forficula.dynamics.energies.stop_forces import friction_torques
from forficula.dynamics.engine.model import compile_model
from forficula.errors import InputError
from forficula.show.run.missed_goal import needed_torque
from forficula.statics import energy_landscape
from forficula.structure.mass import inertia_about
from forficula.study.running.runs import run

TORQUE, PUSHED = 0.02, 0.02  # N m; s


def pushed(friction: str, timestep: str = "0.1 ms") -> Record:
    """Push an undamped joint with a slack tendon by 2 N cm for 20 ms, then release it."""
    stages = [
        {"name": name, "drive": drive, "until": "time", "hold": "0 s", "time_limit": limit}
        for name, drive, limit in (("settle", "none", "1 ms"), ("fold", "fold", "20 ms"), ("release", "none", "0.2 s"))
    ]
    values = {
        "hinge.damping": "0 N m s/rad",
        "hinge.friction": friction,
        "tendon.rest_length": "30 cm",
        "protocol.fold_torque": "2 N cm",
        "protocol.rise": "0 s",
        "protocol.sample_interval": "0.1 ms",
        "protocol.window": "1 ms",
        "protocol.timestep": timestep,
        "protocol.stages": stages,
    }
    return run(load_design("binder2025-joint", values))


def travelled(record: Record) -> np.ndarray:
    """Return the hinge's angle from its start, rad, (time,)."""
    angle = record.series["hinge_angle"][:, 0]
    return angle[0] - angle


@pytest.mark.parametrize("friction", [0.005, 0.01])
def test_a_hinge_accelerates_by_the_torque_beyond_its_friction_and_slides_to_rest_on_the_friction_alone(friction):
    record = pushed(f"{friction} N m")
    acceleration = (TORQUE - friction) / inertia_about(record.structure, 0)
    folded = acceleration * PUSHED**2 / 2
    # at constant acceleration, semi-implicit steps of h travel too far by the share h / t
    assert travelled(record)[np.searchsorted(record.time, 0.001 + PUSHED)] == pytest.approx(
        folded * (1 + 1e-4 / PUSHED)
    )
    # friction dissipates the kinetic energy at the end of the push
    assert travelled(record)[-1] == pytest.approx(folded * TORQUE / friction, rel=5e-4)
    balance = energy_balance(record)
    assert balance.friction == pytest.approx(friction * travelled(record)[-1], rel=5e-4)
    assert balance.friction == pytest.approx(balance.work, rel=1e-9)
    assert balance.stops == pytest.approx(0.0, abs=1e-15)
    assert balance.residual < 1e-9


def test_a_torque_below_the_friction_moves_a_hinge_only_by_the_creep_of_the_constraint():
    record = pushed("2.02 N cm")
    stops = record.structure.stops
    creep = (1 - 0.9999) * TORQUE / inertia_about(record.structure, 0) * stops.time_constant / 2
    assert travelled(record)[-1] == pytest.approx(creep * PUSHED, rel=1e-3)
    assert np.degrees(travelled(record)[-1]) < 2e-4


def test_friction_computed_from_the_motion_is_that_of_the_engine_where_stops_and_contacts_act_too():
    values = {"hinge.friction": "1 N cm", "protocol.contact": True, "protocol.timestep": "0.05 ms"}
    model = compile_model(load_design("binder2025", values))
    data, rng = mujoco.MjData(model.engine), np.random.default_rng(3)
    friction = mujoco.mjtConstraint.mjCNSTR_FRICTION_DOF
    for _ in range(20):
        data.qpos = rng.normal(0, 1, model.engine.nq)
        data.qvel = rng.normal(0, 3, model.engine.nv) * rng.choice([1e-4, 1], model.engine.nv)
        mujoco.mj_forward(model.engine, data)
        expected = np.zeros(model.engine.nv)
        rows = np.flatnonzero(data.efc_type == friction)
        expected[data.efc_id[rows]] = data.efc_force[rows]
        computed = friction_torques(model, data.qvel[None], data.qacc[None], data.qfrc_constraint[None])[0]
        assert computed == pytest.approx(expected, abs=1e-6 * model.engine.dof_frictionloss.max())


def test_a_wing_with_dry_friction_folds_later_and_its_balance_has_a_row_for_it():
    smooth, rough = (run(load_design("binder2025", {"hinge.friction": f"{item} N cm"})) for item in (0, 1))
    balance = energy_balance(rough)
    assert energy_balance(smooth).friction is None
    path = sum(np.abs(np.diff(angle)).sum() for angle in rough.series["hinge_angle"].T)
    # samples miss part of the path of swinging hinges
    assert 0.9 * 0.01 * path < balance.friction < 1.3 * 0.01 * path
    assert balance.residual < 0.002


def test_no_torque_is_advised_that_leaves_the_friction_out():
    held = {"hinge.friction": "3 N cm", "protocol.fold_torque": "7 N cm"}
    record = run(load_design("binder2025-joint", held))
    outcome = measure(record)
    assert outcome.verdict is Verdict.STUCK
    # without friction 8.5 N cm fold it slowly
    assert not outcome.advice
    assert needed_torque(record) is None


def test_negative_friction_is_rejected():
    with pytest.raises(InputError, match=r"hinge\.friction.*-1 N cm"):
        load_design("binder2025", {"hinge.friction": "-1 N cm"})


def test_a_landscape_has_a_remark_that_it_ignores_dry_friction():
    remarks = energy_landscape(load_design("binder2025-joint", {"hinge.friction": "0.5 N cm"}), points=31).remarks
    assert any("ignores the dry friction of hinges of up to 0.5 N cm" in remark for remark in remarks)
