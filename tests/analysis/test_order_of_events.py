from dataclasses import replace

import numpy as np
import pytest

from forficula.analysis.order_of_events import event_texts, group_motions

# rows of the planted motion: 2 ms apart, in stages from 0.1 s to 0.2 s (driven) and on to 0.3 s
TIME = np.round(np.arange(0, 0.3001, 0.002), 6)
STAGES = ("settle", "fold", "release folded")


def ramp(start, end):
    """Progress from 0 to 1 between two times, s."""
    return np.clip((TIME - start) / (end - start), 0, 1)


@pytest.fixture
def planted(reference_run):
    """Function that returns a run of the reference wing whose hinges move as planted, by role: (start, end, travel)."""

    def build(**motions):
        roles = [hinge.role for hinge in reference_run.structure.hinges]
        angles = np.zeros((len(TIME), len(roles)))
        for number, role in enumerate(roles):
            start, end, travel = motions.get(role, (0.0, 1.0, 0.0))
            # neighbouring hinges move in opposite senses
            angles[:, number] = 0.05 + np.radians(travel) * (-1) ** number * ramp(start, end)
        ends = [stage for stage in reference_run.stages if stage.stage.name in STAGES]
        times = [(0.0, 0.1), (0.1, 0.2), (0.2, 0.3)]
        stages = tuple(replace(item, start=low, end=high) for item, (low, high) in zip(ends, times, strict=True))
        return replace(reference_run, time=TIME, series={"hinge_angle": angles}, stages=stages)

    return build


def test_begin_and_middle_of_a_planted_motion_are_found(planted):
    record = planted(ring=(0.12, 0.16, 170), turn=(0.11, 0.13, 90))
    turn, ring = group_motions(record, 1)
    assert (turn.group, ring.group) == ("turn", "ring")
    assert (turn.begin, turn.middle) == pytest.approx((0.111, 0.12))
    assert (ring.begin, ring.middle) == pytest.approx((0.122, 0.14))
    assert np.degrees([turn.travel, ring.travel]) == pytest.approx([90, 170])


def test_one_sentence_names_the_order(planted):
    record = planted(ring=(0.12, 0.16, 170), turn=(0.11, 0.13, 90))
    assert event_texts(record) == [
        'Stage "fold", times since its start: the turn begins to move at 11 ms and passes the middle of its travel at'
        " 20 ms, then the ring at 22 ms and 40 ms."
    ]


def test_the_order_is_that_of_the_middles_and_not_that_of_the_names(planted):
    late_turn = planted(ring=(0.11, 0.13, 170), turn=(0.12, 0.16, 90))
    assert [motion.group for motion in group_motions(late_turn, 1)] == ["ring", "turn"]


def test_groups_that_hardly_move_are_left_out(planted):
    record = planted(ring=(0.12, 0.16, 170), sweep=(0.11, 0.13, 10), turn=(0.11, 0.13, 20))
    assert [motion.group for motion in group_motions(record, 1)] == ["turn", "ring"]


@pytest.mark.parametrize("turn", [(0.0, 1.0, 0.0), (0.12, 0.16, 90), (0.1201, 0.1601, 90)])
def test_one_group_or_simultaneous_groups_have_no_sentence(planted, turn):
    assert event_texts(planted(ring=(0.12, 0.16, 170), turn=turn)) == []


def test_a_motion_that_a_pulse_triggers_ends_after_the_drive(planted):
    """A ring that has turned by a tenth when the drive ends, and completes its travel afterwards."""
    record = planted(ring=(0.19, 0.29, 170), turn=(0.11, 0.13, 90))
    _, ring = group_motions(record, 1)
    assert ring.middle == pytest.approx(0.24)
    assert np.degrees(ring.travel) == pytest.approx(170)


def test_a_motion_that_returns_when_the_drive_ends_keeps_its_travel(planted):
    record = planted(ring=(0.12, 0.16, 170))
    angles = record.series["hinge_angle"].copy()
    angles[TIME > 0.2] = angles[0]
    (ring,) = group_motions(replace(record, series={"hinge_angle": angles}), 1)
    assert ring.middle == pytest.approx(0.14)


def test_a_diverged_motion_has_no_order(planted):
    record = planted(ring=(0.12, 0.16, 170), turn=(0.11, 0.13, 90))
    record.series["hinge_angle"][-1] = np.nan
    assert event_texts(record) == []


def test_the_reference_wing_turns_its_veins_before_its_ring_folds(reference_run):
    fold, unfold = event_texts(reference_run)
    assert fold.startswith('Stage "fold"')
    assert unfold.startswith('Stage "unfold"')
    for text in (fold, unfold):
        assert text.index("the turn begins to move") < text.index("then the ring")
