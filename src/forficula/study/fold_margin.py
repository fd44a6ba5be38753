"""The least torque that folds a wing, for many wings side by side."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from forficula.design import Design
from forficula.study.evaluate import evaluate, row_key
from forficula.study.journal import Row
from forficula.study.search import fold_design

# The least torque is looked for from the protocol's by this to the protocol's times this.
RANGE = 64.0
# Every round takes the part that holds it, of so many; 64^(1/8^3) = 1.008.
_PARTS, _ROUNDS = 8, 3
MOST_RUNS = _PARTS * _ROUNDS


@dataclass(frozen=True, kw_only=True)
class _Interval:
    """Torques, N m, between which the least one lies; `folds` where the upper one is known to fold."""

    low: float
    high: float
    folds: bool

    def torques(self) -> list[float]:
        """Those to try, rising."""
        between = np.geomspace(self.low, self.high, _PARTS + 1)[1:].tolist()
        return [*between[:-1], *([] if self.folds else [self.high])]

    def narrowed(self, folded: Sequence[bool]) -> _Interval | None:
        """The part with the first of the torques that folded; None where none does."""
        torques = self.torques()
        if True in folded:
            first = list(folded).index(True)
            return _Interval(low=[self.low, *torques][first], high=torques[first], folds=True)
        return _Interval(low=torques[-1], high=self.high, folds=True) if self.folds else None


def evaluated(designs: Sequence[Design], count: Callable[[Row], None]) -> dict[str, Row]:
    """Rows of designs by their keys, each counted as it comes."""
    rows: dict[str, Row] = {}
    for row in evaluate(designs):
        rows[str(row["key"])] = row
        count(row)
    return rows


def least_fold_torques(
    designs: Mapping[str, Design], rows: Mapping[str, Row], count: Callable[[Row], None]
) -> dict[str, float]:
    """Find the least torques that fold, from 1/64 of the protocol's up to 64 times it, to 1 %.

    Where folding is not monotone in the torque, it is the least of those that bound a jump and were tried first.

    Args:
        designs: by key of their row.
        rows: what became of them with the protocol's own torque, by key.
        count: called with every row.

    Returns:
        N m by key; one that no torque folds, and one that diverged or could not be built, is left out.
    """
    intervals = {key: _start(design, rows[key]) for key, design in designs.items()}
    for _ in range(_ROUNDS):
        wanted = {
            key: [fold_design(designs[key], torque) for torque in interval.torques()]
            for key, interval in intervals.items()
            if interval is not None
        }
        found = evaluated([design for several in wanted.values() for design in several], count)
        for key, several in wanted.items():
            interval = intervals[key]
            folded = [bool(found[row_key(design)].get("folded")) for design in several]
            intervals[key] = None if interval is None else interval.narrowed(folded)
    return {key: interval.high for key, interval in intervals.items() if interval is not None}


def _start(design: Design, row: Row) -> _Interval | None:
    own, status = design.protocol.fold_torque, str(row["status"])
    if own == 0 or status.startswith(("cannot", "diverged")):
        return None
    # one that opens again when it is released was folded all the same
    if row.get("folded") or status == "did not stay folded":
        return _Interval(low=own / RANGE, high=own, folds=True)
    return _Interval(low=own, high=own * RANGE, folds=False)
