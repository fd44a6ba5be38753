"""Tendons of a material in the compiled model and in the record of a run."""

import importlib
import json
from dataclasses import replace
from unittest import mock

import mujoco
import numpy as np
import pytest

import forficula as ff
from forficula.analysis.summary import summary
from forficula.design import with_values
from forficula.dynamics import compile_model, load_record, save_record, simulate, versions
from forficula.dynamics.stepping.stages import StageTracker
from forficula.structure import hinges_of
from tests.dynamics.protocols import on_protocol

MODULE = importlib.import_module("forficula.dynamics.stepping.simulate")
LAW = {
    "linear_modulus": 4.8e6,
    "quadratic_modulus": -1e6,
    "cubic_modulus": 1e6,
    "linear_viscosity": 480.0,
    "quadratic_viscosity": 2.0,
    "cubic_viscosity": 0.1,
    "branches": [{"modulus": 1e6, "time": 0.002}, {"modulus": 2e5, "time": 0.01}],
    "yield_strain": 0.15,
}
SHORT = {
    "tendon.rest_length": 0.09,
    "tendon.area": 18.75e-6,
    "protocol.timestep": 4e-4,
    "stops.time_constant": 2e-3,
    "protocol.window": 0.01,
    **{f"protocol.stages.{stage}.time_limit": 0.1 for stage in (1, 2, 3, 4)},
    **{f"protocol.stages.{stage}.hold": 0.01 for stage in (2, 3, 4)},
    "protocol.stages.0.time_limit": 0.02,
}


def design(*, pushes=True, **law):
    values = {"tendon.law": LAW | law, "tendon.pushes_when_slack": pushes}
    return with_values(ff.load_design("binder2025"), SHORT | values)


WING = compile_model(design())
RING = list(hinges_of(WING.structure, "ring"))


def assert_same_bits(record, other):
    assert record.stages == other.stages
    assert set(record.series) == set(other.series)
    for name, values in record.series.items():
        assert values.tobytes() == other.series[name].tobytes(), name


def test_the_engine_has_the_law_scaled_by_length_and_area():
    engine, units = WING.engine, WING.units
    force, length, time = units.energy / units.length, units.length, units.time
    # by hand: E A / L, and another 1 / L for every further power
    by_length = [18.75e-6 / 0.09**power for power in (1, 2, 3)]
    for tendon in WING.tendons:
        spring = [engine.tendon_stiffness[tendon], *engine.tendon_stiffnesspoly[tendon]]
        damper = [engine.tendon_damping[tendon], *engine.tendon_dampingpoly[tendon]]
        for power, (item, modulus, share) in enumerate(zip(spring, (4.8e6, -1e6, 1e6), by_length, strict=True), 1):
            assert item * force / length**power == pytest.approx(modulus * share, rel=1e-12)
        for power, (item, viscosity, share) in enumerate(zip(damper, (480.0, 2.0, 0.1), by_length, strict=True), 1):
            assert item * force / (length / time) ** power == pytest.approx(viscosity * share, rel=1e-12)
        assert engine.tendon_lengthspring[tendon] * length == pytest.approx([0, 0.09], rel=1e-12)
        assert engine.tendon_springyield[tendon] * length == pytest.approx(0.15 * 0.09, rel=1e-12)


def test_branches_need_no_control():
    engine = WING.engine
    plain = compile_model(with_values(ff.load_design("binder2025"), {"tendon.damping": 0.0}))
    assert engine.nu == plain.engine.nu
    assert engine.na == 3 * 2
    assert np.array_equal(WING.motors, plain.motors)
    assert np.array_equal(engine.actuator_ctrladr[: engine.nu], np.arange(engine.nu))
    followed = [WING.structure.motors[motor].name for motor in WING.motors]
    assert {engine.actuator(number).name: followed[number] for number in range(engine.nu)} == {
        f"{hinge}{vein}": motor for vein in range(3) for hinge, motor in (("turn", "proximal"), ("fold", "distal"))
    }
    for tendon, places in enumerate(WING.branches):
        for number, place in enumerate(places):
            branch = engine.actuator(f"tendon{tendon}_branch{number}")
            assert branch.actadr[0] == place
            assert branch.trnid[0] == WING.tendons[tendon]


LETTING_GO = {"quadratic_modulus": 1e6, "cubic_modulus": 0.0, "quadratic_viscosity": 0.0, "cubic_viscosity": 0.0}


def letting_go(**law):
    return design(pushes=False, **LETTING_GO | {"yield_strain": None} | law)


@pytest.mark.parametrize("moduli", [(1e6, 0.0), (-2e6, 1e6)])
def test_the_model_file_of_pull_only_tendons_gives_the_forces_of_the_compiled_model(moduli):
    wing = compile_model(letting_go(quadratic_modulus=moduli[0], cubic_modulus=moduli[1]))
    again = mujoco.MjModel.from_xml_string(wing.xml)
    for angle in (20, -40, -120):
        torques = []
        for engine in (wing.engine, again):
            data = mujoco.MjData(engine)
            data.qpos[RING] = np.radians(angle) * wing.folds.senses[RING]
            data.qvel[RING] = wing.folds.senses[RING]
            mujoco.mj_forward(engine, data)
            torques.append(data.qfrc_actuator[RING])
        # MuJoCo writes six digits; sums of stiffening and softening springs lose some of them
        np.testing.assert_allclose(torques[0], torques[1], rtol=1e-3, atol=1e-6)


def test_pull_only_tendons_give_the_same_bits_side_by_side():
    wings = [compile_model(letting_go(linear_modulus=modulus)) for modulus in (4.8e6, 3e6)]
    alone = [simulate([wing], threads=1)[0] for wing in wings]
    with mock.patch.object(MODULE, "_CHUNK", 7):
        for record, other in zip(simulate(wings, 2), alone, strict=True):
            assert_same_bits(record, other)
    assert alone[0].series["letting_go_work"][-1] > 0


def test_a_branch_acts_on_a_slack_tendon_that_yields_as_on_a_taut_one():
    data = mujoco.MjData(WING.engine)
    data.qpos[RING] = -np.radians(150) * WING.folds.senses[RING]
    data.act[WING.branches] = 1.0
    mujoco.mj_forward(WING.engine, data)
    assert np.all(data.ten_length[WING.tendons] < WING.elastic.rest_length)
    assert np.all(np.abs(data.qfrc_actuator[RING]) > 0)


def test_the_model_file_compiles_to_the_law_that_ran():
    again = mujoco.MjModel.from_xml_string(WING.xml)
    assert (again.nu, again.na, again.nplastic) == (WING.engine.nu, WING.engine.na, WING.engine.nplastic)
    for name in ("tendon_stiffnesspoly", "tendon_dampingpoly", "tendon_springyield"):
        # MuJoCo writes six digits
        np.testing.assert_allclose(getattr(again, name), getattr(WING.engine, name), rtol=1e-5)
    for name in ("actuator_dynprm", "actuator_gainprm"):
        np.testing.assert_allclose(getattr(again, name), getattr(WING.engine, name), rtol=1e-5)


@pytest.fixture(scope="module")
def run_alone():
    return simulate([WING], threads=1)[0]


@pytest.mark.parametrize("threads", [1, 2])
@pytest.mark.parametrize("chunk", [1, 7, 100])
def test_no_bit_depends_on_threads_or_on_where_chunks_end(run_alone, threads, chunk):
    others = [compile_model(design(linear_modulus=modulus)) for modulus in (3e6, 6e6)]
    with mock.patch.object(MODULE, "_CHUNK", chunk):
        records = simulate([others[0], WING, others[1]], threads)
    assert_same_bits(records[1], run_alone)


def test_wings_that_share_their_first_stages_share_branches_and_creep(run_alone):
    protocol = WING.design.protocol.model_copy(update={"unfold_torque": 0.5})
    softer = WING.design.model_copy(update={"protocol": protocol})
    follower = on_protocol(WING, softer)
    leader, followed = simulate([WING, follower])
    assert_same_bits(leader, run_alone)
    alone = replace(follower, engine=compile_model(softer).engine)
    assert_same_bits(followed, simulate([alone])[0])


def test_a_sparse_record_keeps_the_states(run_alone):
    (sparse,) = simulate([WING], sparse=True)
    for series in ("tendon_energy", "tendon_rest_length", "branch_energy", "yield_work"):
        assert sparse.series[series][-1].tobytes() == run_alone.series[series][-1].tobytes()
    ours, theirs = ff.measure(sparse), ff.measure(run_alone)
    # bit for bit
    assert repr(ours.energy_balance) == repr(theirs.energy_balance)
    assert ours.status == theirs.status
    assert ours.states["flat"].tendon_energy.tobytes() == theirs.states["flat"].tendon_energy.tobytes()


def test_energies_of_a_material_law_are_recorded_and_read_back(tmp_path, run_alone):
    save_record(run_alone, tmp_path / "record.nc")
    back = load_record(tmp_path / "record.nc")
    assert back.design == run_alone.design
    assert set(back.series) == set(run_alone.series)
    units = {name: back.data[name].attrs["units"] for name in ("branch_energy", "yield_work", "tendon_rest_length")}
    assert units == {"branch_energy": "J", "yield_work": "J", "tendon_rest_length": "m"}
    balance = summary(back, ff.measure(back), versions())["energy_balance"]
    json.dumps(balance)
    taken = {"branch_damping_J", "yielding_J"}
    assert taken | {"branch_energy_change_J"} <= set(balance)
    assert all(balance[name] > 0 for name in taken)
    # the parts add up
    stored = sum(value for name, value in balance.items() if name.endswith("_change_J"))
    lost = sum(balance[name] for name in ("hinge_damping_J", "elastic_damping_J", "stops_J", *taken))
    assert balance["work_J"] - stored - lost == pytest.approx(balance["missing_J"], abs=1e-11)
    assert balance["residual"] < 5e-3


def test_a_record_without_branches_and_yield_has_no_terms_for_them(reference_run, reference_outcome):
    assert not {"branch_energy", "yield_work"} & set(reference_run.series)
    balance = summary(reference_run, reference_outcome, versions())["energy_balance"]
    assert not [name for name in balance if "branch" in name or "yield" in name]


def test_a_tendon_that_the_flat_wing_stretches_beyond_its_yield_has_yielded_there():
    (record,) = simulate([WING])
    start = record.data.isel(time=0)
    # 11 cm are more than 1.15 * 9 cm
    assert start["tendon_length"].values.min() > 0.09 * 1.15
    expected = start["tendon_length"].values - 0.15 * 0.09
    assert start["tendon_rest_length"].values == pytest.approx(expected, abs=1e-12)
    assert start["yield_work"] == 0


def test_a_wing_is_not_stuck_before_its_branches_have_relaxed():
    """It rests short of its goal: without branches for the window of 10 ms, with one for three relaxation times."""
    waits = []
    for branches in ([], [{"modulus": 1e3, "time": 0.02}]):
        held = with_values(
            design(branches=branches), {"protocol.fold_torque": 0.0, "protocol.stages.1.time_limit": 1.0}
        )
        (record,) = simulate([compile_model(held)])
        (fold,) = [end for end in record.stages if end.stage.name == "fold"]
        waits.append(fold.end - fold.start)
    assert waits[1] - waits[0] == pytest.approx(0.05, abs=0.005)


def test_wings_with_other_numbers_of_branches_go_through_their_stages_side_by_side():
    assert len(StageTracker([WING, compile_model(design(branches=LAW["branches"][:1]))]).ended) == 2


def test_a_law_that_cannot_be_kept_from_pushing_is_refused_until_the_design_allows_it():
    for law in ({"yield_strain": 0.2}, {"cubic_viscosity": 0.1}):
        values = {"linear_modulus": 4e6, "branches": [{"modulus": 1e6, "time": 0.002}]} | law
        provided = with_values(ff.load_design("binder2025"), SHORT | {"tendon.law": values})
        with pytest.raises(ff.InputError, match=r"tendon\.pushes_when_slack: need true to simulate a law that has a"):
            compile_model(provided)
        assert not compile_model(with_values(provided, {"tendon.pushes_when_slack": True})).lets_go.any()


def test_a_slack_tendon_exerts_nothing_however_fast_its_ends_move():
    wing = compile_model(with_values(ff.load_design("binder2025"), {"tendon.damping": 10.0}))
    data = mujoco.MjData(wing.engine)
    for speed in (-50, 50):
        data.qpos[RING], data.qvel[RING] = -np.radians(120) * wing.folds.senses[RING], speed
        mujoco.mj_forward(wing.engine, data)
        assert np.all(data.ten_length[wing.tendons] < wing.elastic.rest_length)
        assert np.all(data.qfrc_actuator == 0)
