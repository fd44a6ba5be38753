"""Result of a search for the best design, and which designs deserve a record."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Annotated

import numpy as np
from numpy.typing import NDArray

from forficula.design import Design
from forficula.goals.goal import Goal
from forficula.goals.kept_designs import MOST_KEPT, designs_to_keep
from forficula.goals.optimise.candidate import Candidate, Verification
from forficula.goals.optimise.trials import Relaxation
from forficula.results import Result
from forficula.serial import Key, Written
from forficula.study.running.kept_runs import RunToKeep

if TYPE_CHECKING:
    import xarray

    from forficula.results import DataFrame


@dataclass(frozen=True, kw_only=True)
class Effort:
    """What a search cost, and what it did without.

    Attributes:
        tried: designs that were tried.
        runs: designs that were simulated, neighbours and finer timesteps left out.
        ruled_out: designs that closed forms, statics or the builder ruled out before any run, by which of them.
        neighbour_runs: neighbours that were simulated.
        spared_neighbours: neighbours that were not asked, because too few could work any more, or because what they
            are neighbours of was worse than what was known to be good.
        verification_runs: at the finer timestep, and of fresh neighbours.
        simulated: whether designs were to be run at all.
    """

    tried: int
    runs: int
    ruled_out: dict[str, int]
    neighbour_runs: int
    spared_neighbours: Annotated[int, Key("neighbours_spared")]
    verification_runs: int
    simulated: Annotated[bool, Written.NEVER]

    @property
    def spared_runs(self) -> Annotated[int, Key("runs_spared")]:
        """Runs that were never made, where there would have been any."""
        return sum(self.ruled_out.values()) if self.simulated else 0


@dataclass(frozen=True, kw_only=True)
class Optimum(Result):
    """The best designs by a goal.

    Attributes:
        goal: what was asked.
        candidates: all that were tried, in their order.
        best: the best of them, with how they do where the search did not look: one, or a front by its first
            objective; none where nothing meets the goal.
        discarded: better ones that did not hold when they were verified.
        effort: what it cost.
        relaxations: where nothing meets the goal, by limit, what would have to give; the last one is that the structure
            works, if it is simulated.
        table: all candidates.
    """

    goal: Goal
    candidates: tuple[Candidate, ...]
    best: tuple[Verification, ...]
    discarded: tuple[Verification, ...]
    effort: Effort
    relaxations: tuple[Relaxation, ...]
    table: xarray.Dataset

    @property
    def designs(self) -> tuple[Design, ...]:
        """The best designs."""
        return tuple(
            each.candidate.found.design for each in self.best if isinstance(each.candidate.found.design, Design)
        )

    @property
    def feasible(self) -> bool:
        """Whether anything meets the goal."""
        return bool(self.best)

    def to_dataframe(self) -> DataFrame:
        """Return all candidates as a pandas table, one row each, SI."""
        return self.table.to_dataframe()

    def __repr__(self) -> str:
        """What was asked and how many designs answer it."""
        return f"<Optimum {self.goal.name}: {len(self.best)} of {self.effort.tried} designs are best>"


Numbers = NDArray[np.int64]


def candidates_to_keep(optimum: Optimum, most: int = MOST_KEPT) -> list[RunToKeep]:
    """The best, the front, and of the others those that meet the goal and those that do not by turns, spread evenly.

    Args:
        optimum: what was found.
        most: runs at most; none where nothing is run.
    """
    if not optimum.goal.simulate:
        return []
    table = optimum.table
    best, front, feasible = (table[name].values.astype(bool) for name in ("best", "front", "feasible"))
    first = [*np.flatnonzero(best), *np.flatnonzero(front & ~best)][:most]
    left = most - len(first)
    ran = table["outcome"].values != "not run"
    others = [_spread(np.flatnonzero(ran & ~best & ~front & kind), left) for kind in (feasible, ~feasible)]
    by_turns = [int(numbers[place]) for place in range(left) for numbers in others[::-1] if place < len(numbers)]
    designs = [each.found.design for each in optimum.candidates]
    return designs_to_keep(designs, [*map(int, first), *by_turns], most)


def _spread(numbers: Numbers, most: int) -> Numbers:
    """So many of some numbers, evenly."""
    if len(numbers) <= most:
        return numbers
    places = np.linspace(0, len(numbers) - 1, max(most, 0)).round().astype(np.int64)
    return np.asarray(numbers[places], dtype=np.int64)
