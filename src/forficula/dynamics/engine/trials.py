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


class TrialChains:
    """Trials in chains: those of one chain run one after another, in their order, until others are needless.

    Trials of the last transition form a chain in any order. Those of an earlier transition form a chain only if their
    strengths fall, because all of them are needed as long as they succeed.

    Attributes:
        chains: numbers of the trials of each chain, in their order.
    """

    def __init__(self, trials: Sequence[DriveTrial | None]) -> None:
        """Start with the trials of designs, see `design_trial`."""
        self._trials = trials
        similar: dict[Hashable, list[int]] = {}
        for number, trial in enumerate(trials):
            if trial is not None:
                similar.setdefault(trial.others, []).append(number)
        self.chains = [chain for chain in similar.values() if len(chain) > 1 and self._runs_in_turn(chain)]
        self._chain_of = {number: chain for chain in self.chains for number in chain}

    def needless(self, number: int, *, reached: bool | None) -> list[int]:
        """Return the trials that the result of one of their chain makes needless.

        A trial of the last transition that reached its state makes larger strengths needless. A trial that stayed short
        of its goal makes smaller strengths needless, because a smaller drive is taken to stay short of the goal, too.

        Args:
            number: number of the trial whose result is known.
            reached: whether it reached its state; None if it neither reached its state nor stayed short of its goal.
        """
        known = self._trials[number]
        if known is None or reached is None or (reached and not known.last):
            return []
        strengths = self._strengths(chain := self._chain_of.get(number, []))
        return [
            other
            for other, strength in zip(chain, strengths, strict=True)
            if (strength > known.strength if reached else strength < known.strength)
        ]

    def surplus(self, number: int, *, reached: bool | None) -> list[int]:
        """Return the trials whose results do not count if one of their chain reached its state.

        They have larger strengths. If the strengths of a chain fall, every result counts.
        """
        strengths = self._strengths(self._chain_of.get(number, []))
        counts = strengths == sorted(strengths, reverse=True) or not reached
        return [] if counts else self.needless(number, reached=True)

    def _strengths(self, chain: Sequence[int]) -> list[float]:
        return [trial.strength for number in chain if (trial := self._trials[number]) is not None]

    def _runs_in_turn(self, chain: Sequence[int]) -> bool:
        first, strengths = self._trials[chain[0]], self._strengths(chain)
        return (first is not None and first.last) or strengths == sorted(strengths, reverse=True)
