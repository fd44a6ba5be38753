"""Batches of runs: shared stages run once and only requested records are kept, without changing a bit."""

import importlib
import threading
from dataclasses import replace
from unittest import mock

import mujoco
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from mujoco.batch import Batch, SimulationError

import forficula as ff
from forficula.design import with_values
from forficula.dynamics import compile_model, simulate, simulate_each
from tests.dynamics.protocols import on_protocol

STAGES = {
    "protocol.timestep": 4e-4,
    "stops.time_constant": 2e-3,
    "protocol.window": 0.01,
    "protocol.stages.0.time_limit": 0.02,
    "protocol.stages.1.time_limit": 0.1,
    "protocol.stages.2.time_limit": 0.1,
    "protocol.stages.2.hold": 0.01,
    "protocol.stages.3.time_limit": 0.1,
    "protocol.stages.3.hold": 0.01,
    "protocol.stages.4.time_limit": 0.1,
    "protocol.stages.4.hold": 0.01,
}
SHORT = with_values(ff.load_design("binder2025"), STAGES | {"tendon.rest_length": 0.05})
WING = compile_model(SHORT)
# energies that a sparse record has only at the start and the end
AT_ENDS = ("membrane_energy", "kinetic_energy", "gravitational_energy")
MODULE = importlib.import_module("forficula.dynamics.stepping.simulate")


def sharing(fold, unfold, stages=5):
    """Return a wing with the others' engine model, its own torques and a number of its stages."""
    protocol = SHORT.protocol.model_copy(
        update={"fold_torque": fold, "unfold_torque": unfold, "stages": SHORT.protocol.stages[:stages]}
    )
    design = SHORT.model_copy(update={"protocol": protocol})
    return on_protocol(WING, design)


def assert_same_bits(record, other):
    assert record.stages == other.stages
    assert record.diverged_at == other.diverged_at
    assert record.time.tobytes() == other.time.tobytes()
    assert set(record.series) == set(other.series)
    for name, values in record.series.items():
        assert values.tobytes() == other.series[name].tobytes(), name


TORQUES = st.sampled_from([0.0, 0.1, 0.2, 0.5, 5.0])


@settings(max_examples=15, deadline=None)
@given(
    st.lists(st.tuples(TORQUES, TORQUES, st.integers(1, 5)), min_size=2, max_size=7),
    st.integers(1, 2),
    st.booleans(),
    st.sampled_from([0, 2, 16]),
)
def test_wings_that_share_their_first_stages_give_the_same_bits_as_alone(courses, threads, sparse, few):
    # a course with which others start, twice and in any order: a run may share the stages of one that shares others'
    wings = [sharing(*course) for course in courses]
    with mock.patch.object(MODULE, "_FEW", few):
        records = simulate(wings, threads, sparse)
    for wing, record in zip(wings, records, strict=True):
        alone = replace(wing, engine=compile_model(wing.design).engine)
        assert_same_bits(record, simulate([alone], sparse=sparse)[0])


@pytest.mark.parametrize("few", [0, 16])
def test_every_record_is_yielded_once(few):
    wings = [sharing(torque, 1.0, stages) for torque in (0.0, 0.5) for stages in (2, 3, 5, 5)]
    with mock.patch.object(MODULE, "_FEW", few):
        assert sorted(row for row, _ in simulate_each(wings)) == list(range(8))
    assert list(simulate_each([])) == []


@pytest.mark.parametrize("few", [0, 16])
@pytest.mark.parametrize("opens", [None, 0, 1])
def test_rising_unfold_torques_are_tried_until_one_reaches_its_goal(few, opens):
    # without a fold torque none folds, and runs that share its stages end there, too
    torques = [0.1, 0.5, 1.0]
    wings = [sharing(fold, torque) for fold in (0.0, 0.5) for torque in torques]
    last = None if opens is None else torques[opens]

    def reached(record):
        return record.design.protocol.unfold_torque == last

    with mock.patch.object(MODULE, "_FEW", few):
        records = dict(simulate_each(wings, reached=reached))
    assert len(records) == (6 if last is None else 2 * (opens + 1))
    for row, record in records.items():
        assert_same_bits(record, simulate([wings[row]])[0])


@pytest.mark.parametrize(
    ("order", "least", "tried"),
    [([2, 1, 0], 0.1, [2, 1, 0]), ([1, 2, 0], 0.9, [1, 2]), ([2, 0, 1], 9.0, [2]), ([1, 0, 2], 0.5, [1, 0])],
)
def test_torques_that_a_result_makes_needless_do_not_run(order, least, tried):
    torques = [0.1, 0.5, 1.0]
    wings = [sharing(0.5, torques[number]) for number in order]
    records = simulate_each(wings, reached=lambda record: record.design.protocol.unfold_torque >= least)
    # a larger torque than one that reaches its goal, or a smaller one than one that stays short of it
    assert [torques.index(record.design.protocol.unfold_torque) for _, record in records] == tried


def test_wings_that_share_stages_have_the_same_numbers_up_to_the_first_difference():
    one, other = simulate([sharing(0.5, 0.2), sharing(0.5, 1.0)])
    assert one.stages[:3] == other.stages[:3]
    parting = one.stages[2].end
    angles = [item.angles("ring")[item.time <= parting + 1e-9] for item in (one, other)]
    assert np.array_equal(*angles)
    assert not np.array_equal(one.angles("ring")[-1], other.angles("ring")[-1])


@pytest.mark.parametrize(
    "values",
    [
        {},
        {"tendon.rest_length": 0.09},
        {"tendon.rest_length": 0.0, "tendon.stiffness": 6000.0},
        {"protocol.fold_torque": 0.0},
        {"protocol.timestep": 8e-3},
        {"protocol.window": 0.05, "protocol.sample_interval": 3e-3},
        {"protocol.window": 0.3},
        {"pattern.units": 2},
    ],
)
def test_a_sparse_record_has_the_same_bits_for_what_it_keeps_and_for_what_is_measured(values):
    wing = compile_model(with_values(SHORT, values))
    (full,), (sparse,) = simulate([wing]), simulate([wing], sparse=True)
    assert sparse.stages == full.stages
    assert sparse.diverged_at == full.diverged_at
    assert len(sparse.time) <= len(full.time)
    # successive stages have two rows at the same time, which count in their order
    places, place = [], 0
    for moment in sparse.time:
        place += int(np.argmax(full.time[place:] == moment))
        assert full.time[place] == moment
        places.append(place)
    for name, values_kept in sparse.series.items():
        for row, kept in zip(places, values_kept, strict=True):
            same = np.flatnonzero(full.time == full.time[row])
            # costly series are computed at the start and the end only
            unknown = name in AT_ENDS and 0 < row < len(full.time) - 1 and np.isnan(kept)
            assert unknown or any(kept.tobytes() == full.series[name][item].tobytes() for item in same), name
        assert name not in AT_ENDS or np.isfinite(values_kept[[0, -1]]).all() or full.diverged_at is not None
    measured, expected = ff.measure(sparse), ff.measure(full)
    assert (measured.status, measured.holds, measured.stages) == (expected.status, expected.holds, expected.stages)
    assert measured.transitions == expected.transitions
    # every term, bit for bit
    assert repr(measured.energy_balance) == repr(expected.energy_balance)
    assert repr(measured.ending) == repr(expected.ending)
    assert list(measured.states) == list(expected.states) == ["flat", "folded", "opened"]
    for state, theirs in expected.states.items():
        ours = measured.states[state]
        assert (ours is None) == (theirs is None)
        if ours is not None:
            for name in ("coordinates", "tendon_length", "tendon_energy"):
                assert getattr(ours, name).tobytes() == getattr(theirs, name).tobytes()
            for name in ("mean", "low", "high"):
                readings = [getattr(item.readings["distal_angle"], name) for item in (ours, theirs)]
                assert readings[0].tobytes() == readings[1].tobytes()


def test_a_sparse_record_keeps_little():
    (full,), (sparse,) = simulate([WING]), simulate([WING], sparse=True)
    # each of five stages keeps at most the window, a chunk of 50 steps, and its two ends
    assert len(sparse.time) < 5 * (25 + 50 + 2) / 2 < len(full.time)
    for name in AT_ENDS:
        assert np.isfinite(full.series[name]).all()
        assert np.isfinite(sparse.series[name]).tolist() == [True, *[False] * (len(sparse.time) - 2), True]
    assert not {"point_position", "membrane_position"} & set(sparse.series)


def test_a_diverging_wing_ends_only_the_wings_that_follow_it():
    wild = compile_model(with_values(SHORT, {"protocol.timestep": 8e-3}))
    protocols = [wild.design.protocol.model_copy(update={"unfold_torque": torque}) for torque in (0.5, 1.0)]
    designs = [wild.design.model_copy(update={"protocol": protocol}) for protocol in protocols]
    wilds = [on_protocol(wild, design) for design in designs]
    records = simulate([wilds[0], WING, wilds[1]])
    assert records[0].diverged_at is not None
    assert records[2].diverged_at == records[0].diverged_at
    assert_same_bits(records[1], simulate([WING])[0])


def test_progress_reports_every_stage_and_never_exceeds_the_longest_time():
    seen = []
    # reported after every chunk (50 steps, 20 ms), except the last
    longer = with_values(SHORT, {f"protocol.stages.{stage}.hold": 0.03 for stage in range(1, 5)})
    longer = with_values(longer, {"protocol.stages.0.time_limit": 0.05})
    with mock.patch.object(MODULE, "_CHUNK", 50):
        ff.run(longer, lambda report: seen.append((report.task, report.done, report.total)), confirm=False)
    assert list(dict.fromkeys(stage for stage, _, _ in seen)) == [stage.name for stage in SHORT.protocol.stages]
    times = [time for _, time, _ in seen]
    assert times == sorted(times)
    assert all(time <= longest + 1e-9 for _, time, longest in seen)


def test_a_caller_that_stops_leaves_no_thread_and_no_silence_behind():
    threads = threading.active_count()
    wings = [compile_model(with_values(SHORT, {"tendon.rest_length": length})) for length in (0.05, 0.06, 0.07)]
    records = simulate_each(wings)
    next(records)
    with pytest.raises(KeyboardInterrupt):
        records.throw(KeyboardInterrupt)
    assert threading.active_count() == threads
    assert mujoco.get_mju_user_warning() is None


def test_what_the_engine_raises_in_the_background_is_raised():
    error = SimulationError(np.array([0]), "out of memory")
    with mock.patch.object(Batch, "rollout", side_effect=error), pytest.raises(SimulationError, match="out of memory"):
        simulate([WING])
    assert mujoco.get_mju_user_warning() is None


def test_simulations_that_take_turns_are_silent_to_the_end_and_no_longer():
    wild = compile_model(with_values(SHORT, {"protocol.timestep": 8e-3}))
    heard = []
    mujoco.set_mju_user_warning(heard.append)
    try:
        turns = [simulate_each([wild, WING]), simulate_each([WING, wild])]
        for turn in turns:
            next(turn)
        assert [sum(1 for _ in turn) for turn in turns] == [1, 1]
        assert mujoco.get_mju_user_warning() == heard.append
    finally:
        mujoco.set_mju_user_warning(None)
    assert not heard
