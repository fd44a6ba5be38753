"""Values that are tried one after another under a condition, to find the least that reaches a state."""

from __future__ import annotations

from dataclasses import dataclass, field

from forficula.study.journal import Row


@dataclass(kw_only=True)
class Ladder:
    """Which values of a condition were tried, and from which on the state holds.

    Attributes:
        holds: number of the least value that is known to hold; how many there are where none is.
        fails: number of the largest one below it that does not, or is taken for such; -1 where none is.
        untold: numbers of those that do not tell, and of which nothing else tells.
        rows: of what was tried, by number.
    """

    holds: int
    fails: int = -1
    untold: list[int] = field(default_factory=list)
    rows: dict[int, Row] = field(default_factory=dict)

    def next(self, count: int, *, monotone: bool) -> int:
        """Number of the value to try next: the largest first, which other facts ask for, too; then the middle one.

        Args:
            count: of all values.
            monotone: whether what holds with one value is taken to hold with all larger ones; if not, the next one.
        """
        if not monotone:
            return self.fails + 1
        return count - 1 if self.holds == count else (self.fails + self.holds) // 2

    def tell(self, number: int, row: Row, *, holds: bool | None, monotone: bool) -> None:
        """Take in what a value came to.

        Args:
            number: of the value.
            row: of its run.
            holds: whether the state does; None where the run does not tell, which is taken to fail.
            monotone: as of `next`.
        """
        self.rows[number] = row
        if holds:
            self.holds, self.fails = number, self.fails if monotone else number - 1
            return
        self.fails = number
        if holds is None:
            self.untold.append(number)
        elif monotone:
            # what is smaller fails, too
            self.untold = [each for each in self.untold if each > number]

    @property
    def least(self) -> int:
        """Number of the least value that may hold, whatever those that do not tell would have come to."""
        return min([self.holds, *self.untold])
