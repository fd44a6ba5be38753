"""What became of one point of a search."""

from __future__ import annotations

import math
from dataclasses import dataclass

from forficula.goals.optimise.axis import Point


@dataclass(frozen=True, kw_only=True)
class Trial:
    """A point and what is known of it.

    Attributes:
        point: shares from 0 to 1, one an axis.
        objectives: to be made small, in any units; nan where one is not known.
        margins: by how much each limit holds (> 0) or fails (< 0); nan of those that were not looked at, because a
            cheaper one failed before.
        surplus: by how much the probability of working is more than wanted, or, where < 0, less; nan where none is
            wanted or the point was not worth asking.
    """

    point: Point
    objectives: tuple[float, ...]
    margins: tuple[float, ...] = ()
    surplus: float = math.nan

    @property
    def unknown(self) -> int:
        """How many limits and objectives were not looked at."""
        return sum(map(math.isnan, (*self.margins, *self.objectives)))

    @property
    def violation(self) -> float:
        """By how much limits that were looked at fail, in all."""
        return sum(-margin for margin in self.margins if margin < 0)

    @property
    def shortfall(self) -> float:
        """What is missing of the wanted probability; 0 where none was asked."""
        return -self.surplus if self.surplus < 0 else 0.0

    @property
    def feasible(self) -> bool:
        """Whether every limit holds and no probability is missing."""
        return not self.unknown and self.violation == 0 and self.shortfall == 0
