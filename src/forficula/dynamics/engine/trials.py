"""Trials: runs that differ only in the strength of one drive. The result of one trial can make others needless."""

from __future__ import annotations

from collections.abc import Hashable, Sequence
from dataclasses import dataclass

from forficula.design import Design, key_value, put, stage_drives
from forficula.structure import Structure, Transition, drive_of


@dataclass(frozen=True, kw_only=True)
class DriveTrial:
    """A run whose drive has one of several strengths.

    Attributes:
        others: everything in which the runs of one chain agree.
        strength: size of the drive's strength, SI.
        last: whether the drive makes the last transition of the structure.
    """

    others: Hashable
    strength: float
    last: bool


def tried_transition(design: Design, structure: Structure) -> Transition | None:
    """Return the last transition whose drive acts in some stage of a protocol; None if there is none."""
    acting = {name for stage in design.protocol.stages for name in stage_drives(stage)}
    return next((item for item in reversed(structure.transitions) if item.drive in acting), None)


def design_trial(design: Design, structure: Structure) -> DriveTrial | None:
    """Return the trial of a design: that of the drive of its `tried_transition`."""
    transition = tried_transition(design, structure)
    if transition is None:
        return None
    drive = drive_of(structure, transition.drive)
    return DriveTrial(
        others=put(design, drive.key, 0.0).hash,
        strength=abs(float(str(key_value(design, drive.key)))),
        last=transition is structure.transitions[-1],
    )


def trial_chains(trials: Sequence[DriveTrial | None]) -> list[list[int]]:
    """Return chains of trials by number: those of one chain run one after another, in the given order.

    Trials of the last transition form a chain in any order. Those of an earlier transition form a chain only if their
    strengths fall, because all of them are needed as long as they succeed.
    """
    chains: dict[Hashable, list[int]] = {}
    for number, trial in enumerate(trials):
        if trial is not None:
            chains.setdefault(trial.others, []).append(number)
    return [chain for chain in chains.values() if len(chain) > 1 and _runs_in_turn([trials[row] for row in chain])]


def _runs_in_turn(trials: Sequence[DriveTrial | None]) -> bool:
    known = [trial for trial in trials if trial is not None]
    strengths = [trial.strength for trial in known]
    return known[0].last or strengths == sorted(strengths, reverse=True)


def needless_trials(
    trials: Sequence[DriveTrial | None], chain: Sequence[int], done: int, *, reached: bool | None
) -> list[int]:
    """Return the trials of a chain that the result of one of them makes needless.

    A trial of the last transition that reached its state makes larger strengths needless. A trial that stayed short of
    its goal makes smaller strengths needless, because a smaller drive is taken to stay short of the goal, too.

    Args:
        trials: all trials.
        chain: numbers of the trials of the chain.
        done: number of the trial whose result is known.
        reached: whether it reached its state; None if it neither reached its state nor stayed short of its goal.
    """
    known = trials[done]
    if known is None or reached is None:
        return []

    def needless(trial: DriveTrial | None) -> bool:
        if trial is None:
            return False
        return known.last and trial.strength > known.strength if reached else trial.strength < known.strength

    return [number for number in chain if needless(trials[number])]
