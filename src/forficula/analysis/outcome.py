"""What a run means: states, energies, work, times, verdict and the energy balance."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from forficula.analysis.verdict import LEFT_STRAIGHT, Ending, Verdict, ending_advice, ending_text
from forficula.dynamics import EnergyBalance, Record, StageEnd, energy_balance

Array = NDArray[np.float64]

_STIR = np.radians(0.1)
_TOO_SHORT = "at its goal for too short a time when its stage was over"


@dataclass(frozen=True, kw_only=True)
class State:
    """One of the three states: the mean over the last part of a stage, and how far the wing still swings.

    Attributes:
        time: end of the stage, s.
        distal_angle: by vein, folding negative in its own sense, rad, (vein,).
        distal_angle_low: lowest over the window, rad, (vein,).
        distal_angle_high: highest over the window, rad, (vein,).
        tendon_length: by vein, m, (vein,).
        tendon_energy: by vein, J, (vein,).
        membrane_energy: J; nan in a sparse record.
    """

    time: float
    distal_angle: Array
    distal_angle_low: Array
    distal_angle_high: Array
    tendon_length: Array
    tendon_energy: Array
    membrane_energy: float

    @property
    def is_flat(self) -> bool:
        """Whether no hinge has left straight for folding."""
        return bool(np.all(self.distal_angle >= -LEFT_STRAIGHT))

    @property
    def swings(self) -> bool:
        """Whether a hinge still moves by more than 0.1 deg."""
        return bool(np.any(self.distal_angle_high - self.distal_angle_low > _STIR))


@dataclass(frozen=True, kw_only=True)
class Transition:
    """Folding or unfolding.

    Attributes:
        torque: on each driven axis, N m.
        succeeded: whether the goal was reached and held after the release.
        time: from the start of the stage until the goal was reached, s; None where it failed.
        work: of the torques over the stage, J: the integral of torque over angle.
    """

    torque: float
    succeeded: bool
    time: float | None
    work: float


@dataclass(frozen=True, kw_only=True)
class Outcome:
    """What a run means.

    Attributes:
        ending: what it came to.
        status: that in a few words.
        advice: what to try, in a sentence; empty where there is nothing to mend.
        folded: whether every distal hinge folded, and stayed beyond half the folded angle when released; None where
            the run diverged or is not to be trusted.
        opened: whether every distal hinge opened, and stayed so when released; None likewise.
        flat: the state after the first stage, or None where the wing diverged before.
        folded_state: None where the protocol did not get there.
        opened_state: None where the protocol did not get there.
        fold: None where the protocol has no such stage or did not get there.
        unfold: None where the protocol has no such stage or did not get there.
        energy_balance: over the whole run.
    """

    ending: Ending
    status: str
    advice: str
    folded: bool | None
    opened: bool | None
    flat: State | None
    folded_state: State | None
    opened_state: State | None
    fold: Transition | None
    unfold: Transition | None
    energy_balance: EnergyBalance

    @property
    def flat_name(self) -> str:
        """What to call the state after the first stage, in which a hinge may have left straight."""
        return "flat" if self.flat is None or self.flat.is_flat else "not flat"

    @property
    def folded_name(self) -> str:
        """What to call the state after folding."""
        return _name(self.folded, "folded", "folding")

    @property
    def opened_name(self) -> str:
        """What to call the state after unfolding."""
        return _name(self.opened, "opened", "unfolding")

    @property
    def verdict(self) -> Verdict:
        """What the run came to, in a word."""
        return self.ending.verdict


def measure(record: Record) -> Outcome:
    """Find what a run means.

    The flat state is taken at the end of the first stage; the folded and the opened one at the end of the stage that
    follows folding and unfolding. Each is the mean over the protocol's window; where no release follows, it is the
    moment at which the goal was reached.
    """
    folding, after_folding = _driven(record, "fold")
    unfolding, after_unfolding = _driven(record, "unfold")
    folded_state = _state(record, after_folding)
    opened_state = _state(record, after_unfolding)
    protocol, balance = record.design.protocol, energy_balance(record)
    # A slack tendon lets its hinge rest anywhere on the folded side; one that is back beyond half way has opened again.
    folded: bool | None = False
    if folding and folded_state:
        # a stage that was not to end with the wing folded does not say whether it was, but what it left does
        beyond = protocol.folded_angle / (2 if folding.stage.until == "folded" else 1)
        folded = _is_reached(folding, "folded") and bool(np.all(folded_state.distal_angle <= -beyond))
    opened: bool | None = False
    if unfolding and opened_state:
        opened = _is_reached(unfolding, "opened") and bool(np.all(opened_state.distal_angle >= protocol.opened_angle))
    missed = _missed(record, folding, unfolding, folded=folded, opened=opened)
    if record.diverged_at is not None:
        verdict = Verdict.DIVERGED
    elif record.doubt or not balance.residual <= protocol.residual_limit:
        verdict = Verdict.UNTRUSTED
    else:
        verdict = _verdict(missed)
    if not verdict.tells:
        folded = opened = None
    if not verdict.tells:
        missed = folding
    missed = missed or unfolding or folding
    state = opened_state if missed is unfolding else folded_state
    ending = Ending(
        verdict=verdict,
        goal="none" if missed is None else _goal(missed),
        angle=float(np.max(state.distal_angle)) if verdict.tells and state else None,
        time=record.diverged_at,
        residual=balance.residual if record.diverged_at is None else None,
        why=record.doubt or (_TOO_SHORT if verdict is Verdict.MOVING and missed and missed.at_goal else ""),
    )
    return Outcome(
        ending=ending,
        status=ending_text(ending),
        advice=ending_advice(ending, record.design),
        folded=folded,
        opened=opened,
        flat=_state(record, record.stages[0] if _sound(record, 0) else None),
        folded_state=folded_state,
        opened_state=opened_state,
        fold=_transition(record, folding, protocol.fold_torque, bool(folded)),
        unfold=_transition(record, unfolding, protocol.unfold_torque, bool(opened)),
        energy_balance=balance,
    )


def _is_reached(end: StageEnd, goal: str) -> bool:
    """Whether a stage reached its goal, or has another one."""
    return end.goal_time is not None or end.stage.until != goal


def _missed(
    record: Record, folding: StageEnd | None, unfolding: StageEnd | None, *, folded: bool | None, opened: bool | None
) -> StageEnd | None:
    """The stage whose goal was missed, or lost when released; None where there is none."""
    if folding and not folded:
        return folding
    if unfolding and not opened:
        return unfolding
    last = record.stages[-1]
    return last if last.goal_time is None and last.stage.until in ("folded", "opened") else None


def _goal(end: StageEnd) -> str:
    """Which goal a stage has: that of its drive, or that which ends it."""
    return end.stage.drive if end.stage.drive != "none" else {"folded": "fold", "opened": "unfold"}[end.stage.until]


def _verdict(missed: StageEnd | None) -> Verdict:
    """What a run that is to be trusted came to, by the stage whose goal it missed."""
    if missed is None:
        return Verdict.REACHED
    if missed.goal_time is not None:
        return Verdict.NOT_HELD
    return Verdict.STUCK if missed.at_rest and not missed.at_goal else Verdict.MOVING


def _name(reached: bool | None, state: str, move: str) -> str:
    return f"after {move}" if reached is None else state if reached else f"not {state}"


def _sound(record: Record, stage: int) -> bool:
    """Whether a stage took place without diverging."""
    return len(record.stages) > stage and (record.diverged_at is None or stage < len(record.stages) - 1)


def _driven(record: Record, drive: str) -> tuple[StageEnd | None, StageEnd | None]:
    """The stage with a drive, and the release that followed it, or itself where none did."""
    for index, end in enumerate(record.stages):
        if end.stage.drive == drive:
            after = record.stages[index + 1 : index + 2]
            released = bool(after) and after[0].stage.drive == "none" and _sound(record, index + 1)
            last = index + released
            return end, record.stages[last] if _sound(record, last) else None
    return None, None


def _state(record: Record, end: StageEnd | None) -> State | None:
    if end is None:
        return None
    snapped = end.stage.drive != "none" and end.goal_time is not None
    # a stage that ends in the middle of the snap is no rest to average over
    start = end.end if snapped else max(end.start, end.end - record.design.protocol.window)
    # half a step either way, for times are multiples of the timestep up to rounding
    half = float(record.design.protocol.timestep) / 2
    window = (record.time >= start - half) & (record.time <= end.end + half)
    series = {name: record.series[name][window] for name in ("distal_angle", "tendon_length", "tendon_energy")}
    angle = series["distal_angle"]
    return State(
        time=end.end,
        distal_angle=angle.mean(axis=0),
        distal_angle_low=angle.min(axis=0),
        distal_angle_high=angle.max(axis=0),
        tendon_length=series["tendon_length"].mean(axis=0),
        tendon_energy=series["tendon_energy"].mean(axis=0),
        membrane_energy=float(record.series["membrane_energy"][window].mean()),
    )


def _transition(record: Record, end: StageEnd | None, torque: float, succeeded: bool) -> Transition | None:
    if end is None:
        return None
    work = _since(record, "proximal_work", end) + _since(record, "distal_work", end)
    time = end.goal_time - end.start if succeeded and end.goal_time is not None else None
    return Transition(torque=torque, succeeded=succeeded, time=time, work=work)


def _since(record: Record, name: str, end: StageEnd) -> float:
    """Change of a series over a stage."""
    before, after = (int(np.argmin(np.abs(record.time - moment))) for moment in (end.start, end.end))
    return float(record.series[name][after] - record.series[name][before])
