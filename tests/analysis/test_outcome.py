import json
import math
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import forficula as ff
from forficula.analysis import measure, summary
from forficula.design import with_values
from forficula.dynamics import Record, StageEnd
from forficula.dynamics.record import VARIABLES
from forficula.structure import hinges_of, structure_of

REFERENCE = ff.load_design("binder2025")
STRUCTURE = structure_of(REFERENCE)
SIZES = {"hinge": 12, "tendon": 3, "motor": 2, "point": 15, "axis": 3, "node": 12}
RINGS = list(hinges_of(STRUCTURE, "ring"))
MOTORS = [motor.name for motor in STRUCTURE.motors]
# s: settle, fold, release folded, unfold, release opened; the window of a state is 0.1 s
ENDS = (0.3, 0.4, 0.7, 0.9, 1.2)
DEG = math.radians(1)
ROUNDING = 1e-12  # of sums of some hundred numbers of similar size


def planted(
    times=(0.0, 1.2), angles=(0.0, 0.0), *, ends=ENDS, goals=None, diverged_at=None, design=REFERENCE, **series
):
    """Return a record with one angle, deg, of all ring hinges and other series, piecewise linear between times, s.

    Series are (times, values) with values of one number or one of every hinge or tendon; `proximal_work` and
    `distal_work` are those of the motors. Goals are reached at the end of a stage where nothing else is said, rest as
    long before as its stage holds it.
    """
    time = np.round(np.arange(0, round(1e3 * ends[-1]) + 1) * 1e-3, 9)  # one row per millisecond

    def line(at, values):
        return np.array([np.interp(time, at, part) for part in np.array(values, dtype=float).T.reshape(-1, len(at))]).T

    arrays = {
        name: np.zeros((len(time), *(SIZES[dimension] for dimension in dimensions)))
        for name, (dimensions, _, _) in VARIABLES.items()
    }
    # with its nodes as built the membrane is unstrained
    arrays["membrane_position"][:] = np.concatenate([membrane.built for membrane in structure_of(design).membranes])
    arrays["hinge_angle"][:, RINGS] = line(times, DEG * np.array(angles, dtype=float))
    for name, (at, values) in series.items():
        motor = name.removesuffix("_work")
        if motor in MOTORS:
            arrays["motor_work"][:, MOTORS.index(motor)] = line(at, values)[:, 0]
        else:
            arrays[name].T[:] = line(at, values).T
    starts = (0.0, *ends[:-1])
    reached = [
        max(start, end - stage.hold) if stage.until == "rest" else end
        for stage, start, end in zip(design.protocol.stages, starts, ends, strict=False)
    ]
    stages = tuple(
        StageEnd(stage=stage, start=start, end=end, goal_time=goal, at_rest=True)
        for stage, start, end, goal in zip(design.protocol.stages, starts, ends, goals or reached, strict=False)
    )
    return Record(
        design=design,
        structure=structure_of(design),
        time=time,
        series=arrays,
        stages=stages,
        diverged_at=diverged_at,
    )


# flat at 3 deg, folded to -170 deg, opened again
FOLDS_AND_OPENS = {"times": (0.3, 0.4, 0.7, 0.8), "angles": (3, -170, -170, 3)}


def test_a_wing_that_folds_and_opens_is_reported_as_such():
    outcome = measure(planted(**FOLDS_AND_OPENS))
    assert (outcome.status, outcome.advice) == ("folded and opened", "")
    assert outcome.holds["folded"]
    assert outcome.holds["opened"]


def test_states_are_taken_at_the_end_of_the_rest_that_follows():
    outcome = measure(planted(**FOLDS_AND_OPENS))
    assert {name: state.time for name, state in outcome.states.items()} == {"flat": 0.3, "folded": 0.7, "opened": 1.2}
    for state, angle in zip(outcome.states.values(), (3, -170, 3), strict=True):
        assert state.readings["distal_angle"].mean / DEG == pytest.approx(np.full(3, angle), rel=ROUNDING)
        assert not state.swings


def test_a_state_is_the_mean_over_the_window_with_the_envelope_of_every_vein():
    # linear in the window from 0.6 to 0.7 s: the mean is the middle, the envelope the ends
    times = (0.0, 0.3, 0.4, 0.6, 0.7)
    angles = [[0, 0, 0], [0, 0, 0], [-160, -160, -160], [-160, -170, -150], [-170, -160, -150]]
    lengths = [[0.1, 0.1, 0.1]] * 3 + [[0.02, 0.03, 0.04], [0.04, 0.05, 0.04]]
    energies = [[1.0, 1.0, 1.0]] * 3 + [[0.1, 0.2, 0.3], [0.3, 0.2, 0.1]]
    state = measure(
        planted(
            times,
            angles,
            ends=ENDS[:3],
            tendon_length=(times, lengths),
            tendon_energy=(times, energies),
            membrane_energy=((0.0, 0.6, 0.7), (9.0, 1.0, 2.0)),
        )
    ).states["folded"]
    assert state.readings["distal_angle"].mean / DEG == pytest.approx([-165, -165, -150], rel=ROUNDING)
    assert state.readings["distal_angle"].low / DEG == pytest.approx([-170, -170, -150], rel=ROUNDING)
    assert state.readings["distal_angle"].high / DEG == pytest.approx([-160, -160, -150], rel=ROUNDING)
    assert state.tendon_length == pytest.approx([0.03, 0.04, 0.04], rel=ROUNDING)
    assert state.tendon_energy == pytest.approx([0.2, 0.2, 0.2], rel=ROUNDING)
    assert state.membrane_energy == pytest.approx(1.5, rel=ROUNDING)
    assert state.swings


@pytest.mark.parametrize(("swing", "swings"), [(0.09, False), (0.11, True)])
def test_a_state_swings_where_a_hinge_moves_by_more_than_a_tenth_of_a_degree(swing, swings):
    assert measure(planted((0.0, 0.25, 0.3), (0, 0, swing), ends=ENDS[:1])).states["flat"].swings is swings


def test_a_stage_shorter_than_the_window_is_averaged_whole():
    # flat until 0.3 s; the release of 20 ms is linear from -150 to -170 deg
    outcome = measure(planted((0.3, 0.4, 0.42), (0, -150, -170), ends=(0.3, 0.4, 0.42)))
    assert outcome.states["folded"].readings["distal_angle"].mean / DEG == pytest.approx(np.full(3, -160), rel=ROUNDING)


def test_a_window_longer_than_the_rest_does_not_average_the_motion():
    # the release goes from -150 to -170 deg in 0.1 s, and rests for 0.1 s
    wide = with_values(REFERENCE, {"protocol.window": "0.3 s"})
    goals = (None, 0.4, 0.5)
    moved = planted((0.3, 0.4, 0.5), (0, -150, -170), ends=(0.3, 0.4, 0.6), goals=goals, design=wide)
    state = measure(moved).states["folded"]
    assert state.readings["distal_angle"].mean / DEG == pytest.approx(np.full(3, -170), rel=ROUNDING)
    assert not state.swings


def test_the_window_is_a_setting():
    wide = with_values(REFERENCE, {"protocol.window": 0.2})
    outcome = measure(planted((0.0, 0.1, 0.3), (0, 0, 2), ends=ENDS[:1], design=wide))
    assert outcome.states["flat"].readings["distal_angle"].mean / DEG == pytest.approx(np.full(3, 1), rel=ROUNDING)


def test_without_a_release_the_folded_state_is_the_moment_in_which_the_goal_was_reached():
    outcome = measure(planted((0.3, 0.4), (0, -160), ends=ENDS[:2]))
    assert outcome.states["folded"].time == 0.4
    assert outcome.states["folded"].readings["distal_angle"].mean / DEG == pytest.approx(np.full(3, -160), rel=ROUNDING)


@settings(deadline=None)
@given(st.floats(-2, 2), st.floats(-2, 2), st.floats(-2, 2))
def test_work_of_a_stage_is_what_all_torques_did_in_it(folding, unfolding_proximal, unfolding_distal):
    outcome = measure(
        planted(
            **FOLDS_AND_OPENS,
            proximal_work=((0.3, 0.4, 0.7, 0.9), (0, folding, folding, folding + unfolding_proximal)),
            distal_work=((0.7, 0.9), (0, unfolding_distal)),
        )
    )
    assert outcome.transitions["fold"].work == pytest.approx(folding, abs=ROUNDING)
    assert outcome.transitions["unfold"].work == pytest.approx(unfolding_proximal + unfolding_distal, abs=4 * ROUNDING)
    assert outcome.energy_balance.work == pytest.approx(
        folding + unfolding_proximal + unfolding_distal, abs=4 * ROUNDING
    )


def test_times_count_from_the_start_of_the_stage_until_the_goal_was_reached():
    outcome = measure(planted(**FOLDS_AND_OPENS, goals=(None, 0.35, 0.6, 0.8, 1.1)))
    assert outcome.transitions["fold"].time == pytest.approx(0.05, rel=ROUNDING)
    assert outcome.transitions["unfold"].time == pytest.approx(0.1, rel=ROUNDING)


def test_torques_are_those_of_the_design():
    outcome = measure(planted(**FOLDS_AND_OPENS))
    assert (outcome.transitions["fold"].strength, outcome.transitions["unfold"].strength) == (0.5, 1.0)


def test_a_wing_whose_hinges_stay_straight_did_not_fold():
    # all but one hinge fold; one stays within 5 deg of straight
    outcome = measure(planted((0.3, 0.4), ([0, 0, 0], [-170, -170, -4.9]), ends=ENDS[:2], goals=(None, None)))
    assert outcome.status == "did not fold"
    assert not outcome.holds["folded"]
    assert not outcome.transitions["fold"].succeeded
    assert outcome.transitions["fold"].time is None
    assert (outcome.transitions["unfold"], outcome.states["opened"]) == (None, None)


@settings(deadline=None)
@given(st.floats(5.1, 149))
def test_a_wing_that_stops_on_the_way_is_stuck_where_its_least_folded_hinge_is(angle):
    times, at_rest = (0.2, 0.3, 0.4), [-170, -angle, -170]
    record = planted(times, ([0, 0, 0], at_rest, at_rest), ends=(0.1, 0.4), goals=(None, None))
    outcome = measure(record)
    reached = outcome.status.split()[2]
    assert float(reached) == pytest.approx(-angle, abs=0.0501)  # deg; shown with one digit
    assert outcome.status == f"stuck at {reached} deg"
    assert not outcome.holds["folded"]


def test_a_wing_that_folds_under_torque_only_did_not_stay_folded():
    outcome = measure(planted((0.3, 0.4, 0.5), (0, -170, 3), ends=ENDS[:3]))
    assert outcome.status == "did not stay folded"
    assert outcome.advice.startswith("Hold it longer before the release: protocol.stages.fold.hold = 1 s")
    assert not outcome.holds["folded"]
    assert outcome.transitions["fold"].time is None


def test_a_wing_that_never_opens_did_not_open():
    outcome = measure(planted((0.3, 0.4), (0, -170), ends=ENDS[:4], goals=(None, 0.4, 0.7, None)))
    assert outcome.status == "did not open"
    assert outcome.holds["folded"]
    assert outcome.transitions["fold"].time == pytest.approx(0.1, rel=ROUNDING)
    assert not outcome.holds["opened"]
    assert outcome.transitions["unfold"].time is None


def test_a_wing_that_opens_only_under_torque_gets_the_advice_to_hold_longer():
    outcome = measure(planted((0.3, 0.4, 0.7, 0.8, 0.9, 1.0), (0, -170, -170, 3, 3, -170)))
    assert outcome.status == "did not stay open"
    assert "hold" in outcome.advice
    assert not outcome.holds["opened"]
    assert outcome.transitions["unfold"].time is None


@pytest.mark.parametrize(("angle", "opened"), [(0.0, True), (-0.001, False), (3.0, True)])
def test_opened_is_at_straight_or_past_it(angle, opened):
    times = (0.3, 0.4, 0.7, 0.8)
    record = planted(times, ([3] * 3, [-170] * 3, [-170] * 3, [3, angle, 3]))
    assert measure(record).holds["opened"] is opened


def test_a_wing_that_swings_about_straight_is_judged_by_the_mean():
    # oscillates by 1 deg about 0.5 deg, with a whole number of periods in the window
    swings = np.arange(1.0, 1.2001, 0.01)
    around = [0.5 + (-1) ** index for index in range(len(swings))]
    record = planted((0.3, 0.4, 0.7, 0.8, *swings), (3, -170, -170, 3, *around))
    outcome = measure(record)
    assert outcome.holds["opened"]
    assert outcome.states["opened"].swings
    assert outcome.states["opened"].readings["distal_angle"].low / DEG == pytest.approx(np.full(3, -0.5), rel=1e-9)


def protocol(*drives):
    stage = {"name": "a", "until": "time", "hold": 0.0, "time_limit": 0.1}
    return with_values(REFERENCE, {"protocol.stages": [stage | {"drive": drive} for drive in drives]})


def test_a_wing_without_drives_is_reported_as_settled():
    outcome = measure(planted(ends=(0.3,), design=protocol("none")))
    assert (outcome.status, outcome.advice) == ("settled", "")
    assert outcome.states["flat"] is not None
    assert (outcome.transitions["fold"], outcome.transitions["unfold"], outcome.states["folded"]) == (None, None, None)


def test_a_wing_that_was_only_folded_is_folded():
    outcome = measure(planted((0.3, 0.4), (0, -170), ends=ENDS[:3], design=protocol("none", "fold", "none")))
    assert (outcome.status, outcome.advice) == ("folded", "")
    assert outcome.holds["folded"]
    assert not outcome.holds["opened"]


@pytest.mark.parametrize(
    ("stages", "has_flat", "has_fold"), [(1, False, False), (2, True, True), (3, True, True), (5, True, True)]
)
def test_a_wing_that_diverged_has_the_states_before_and_neither_folded_nor_opened(stages, has_flat, has_fold):
    ends = ENDS[:stages]
    outcome = measure(planted(**FOLDS_AND_OPENS, ends=ends, diverged_at=ends[-1]))
    assert outcome.status == f"diverged at t = {ends[-1]:.4g} s"
    assert "timestep" in outcome.advice
    assert not outcome.holds["folded"]
    assert not outcome.holds["opened"]
    assert (outcome.states["flat"] is not None, outcome.transitions["fold"] is not None) == (has_flat, has_fold)
    if outcome.transitions["fold"] is not None:
        assert outcome.transitions["fold"].time is None
    assert outcome.states["opened"] is None or stages == 5


energies = st.floats(-10, 10)


@settings(deadline=None)
@given(energies, energies, energies, energies, st.tuples(energies, energies, energies), st.floats(-0.1, 0.1))
def test_the_energy_balance_detects_missing_energy(tendon, membrane, kinetic, gravitational, taken, missing):
    hinges, elastic, stops = taken
    put_in = 3 * tendon + membrane + kinetic + gravitational + sum(taken) + missing
    span = (0.0, 1.2)
    record = planted(
        **FOLDS_AND_OPENS,
        proximal_work=(span, (0, put_in / 2)),
        distal_work=(span, (0, put_in / 2)),
        tendon_energy=(span, (1, 1 + tendon)),  # of each of three tendons
        membrane_energy=(span, (2, 2 + membrane)),
        kinetic_energy=(span, (0, kinetic)),
        gravitational_energy=(span, (-1, -1 + gravitational)),
        hinge_damping_work=(span, (0, -hinges)),
        elastic_damping_work=(span, (0, -elastic)),
        stop_work=(span, (0, -stops)),
    )
    balance = measure(record).energy_balance
    assert balance.work == pytest.approx(put_in, abs=100 * ROUNDING)
    assert balance.tendon == pytest.approx(3 * tendon, abs=100 * ROUNDING)
    assert balance.missing == pytest.approx(missing, abs=100 * ROUNDING)
    exchanged = abs(put_in) + abs(3 * tendon) + abs(membrane) + abs(gravitational)
    if exchanged > 0.1:
        assert balance.residual == pytest.approx(abs(missing) / exchanged, abs=1000 * ROUNDING)


def test_without_work_the_residual_is_relative_to_the_energy_of_the_tendons():
    span = (0.0, 0.3)
    record = planted(ends=(0.3,), tendon_energy=(span, (1, 0)), hinge_damping_work=(span, (0, -2.4)))
    assert measure(record).energy_balance.residual == pytest.approx(0.6 / 3, rel=ROUNDING)
    assert measure(planted(ends=(0.3,))).energy_balance.residual == 0.0


def test_the_summary_has_the_keys_that_others_read():
    record = planted(**FOLDS_AND_OPENS, tendon_length=((0, 1.2), (0.1, 0.1)), goals=(None, 0.35, 0.6, 0.8, 1.1))
    plain = json.loads(json.dumps(summary(record, measure(record), {"forficula": "1"}), allow_nan=False))
    assert (plain["design"], plain["status"], plain["folded"], plain["opened"]) == (
        "binder2025",
        "folded and opened",
        True,
        True,
    )
    folded = plain["states"]["folded"]
    assert folded["time_s"] == 0.7
    assert folded["distal_angle_deg"] == pytest.approx([-170] * 3, rel=ROUNDING)
    assert folded["tendon_length_m"] == pytest.approx([0.1] * 3, rel=ROUNDING)
    assert folded["tendon_energy_J"] == [0, 0, 0]
    assert set(plain["states"]) == {"flat", "folded", "opened"}
    assert plain["fold"]["torque_N_m"] == 0.5
    assert plain["fold"]["time_s"] == pytest.approx(0.05, rel=ROUNDING)
    assert plain["unfold"]["work_J"] == 0
    assert plain["energy_balance"]["residual"] == 0
    assert (plain["design_hash"], plain["versions"]) == (REFERENCE.hash, {"forficula": "1"})


def test_the_summary_has_null_for_missing_states_and_transitions():
    record = planted((0.3, 0.4), (0, 0), ends=ENDS[:2], goals=(None, None))
    plain = summary(record, measure(record), {})
    assert plain["fold"]["time_s"] is None
    assert {name: value for name, value in plain["unfold"].items() if value} == {"torque_N_m": 1.0}
    assert plain["states"]["opened"] is None


def test_the_outcome_of_a_diverged_wing_can_be_written_as_json():
    design = with_values(REFERENCE, {"protocol.timestep": 0.01, "protocol.fold_torque": 5.0})
    record = ff.run(design, confirm=False)
    outcome = measure(record)
    assert outcome.status.startswith("diverged at t = ")
    json.dumps(summary(record, outcome, {}), allow_nan=False)


def test_a_missed_goal_is_not_a_success_whatever_the_angles():
    record = planted(**FOLDS_AND_OPENS)
    missed = replace(record, stages=tuple(replace(end, goal_time=None) for end in record.stages))
    outcome = measure(missed)
    assert not outcome.holds["folded"]
    assert not outcome.holds["opened"]


@pytest.mark.parametrize(("until", "status"), [("folded", "moving"), ("ring < -150 deg", "moving")])
def test_a_missed_goal_given_as_text_is_reported_as_one_given_by_name(until, status):
    """A weak push on a hinge reaches nothing within the stage's time: no state is held, in both notations."""
    design = with_values(REFERENCE, {"protocol.fold_torque": 0.01, "protocol.stages.1.until": until})
    outcome = measure(ff.run(design, confirm=False))
    assert outcome.verdict.value == status
    assert not outcome.holds["folded"]


def test_a_goal_given_as_text_has_the_same_outcome_as_one_given_by_name():
    named, written = (
        measure(ff.run(with_values(REFERENCE, {"protocol.stages.1.until": until}), confirm=False))
        for until in ("folded", f"ring < {-math.degrees(REFERENCE.protocol.folded_angle)!r} deg")
    )
    assert (written.verdict, written.status, written.holds) == (named.verdict, named.status, named.holds)
    assert written.transitions["fold"].time == pytest.approx(named.transitions["fold"].time, rel=1e-3)


def test_a_goal_that_is_missed_in_a_stage_without_a_state_is_named():
    letter = ff.load_design("letter-fold")
    push = {"name": "push", "drive": "close", "until": "creases > 100 deg", "hold": 0.0, "time_limit": 0.3}
    run = ff.run(with_values(letter, {"protocol.stages": [push], "drive.close.value": 1e-4}), confirm=False)
    assert run.outcome.status == 'missed the goal of stage "push"'
