"""Result of a search for the best design, and the selection of designs whose records are kept."""

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
    """Numbers of designs and runs that a search needed and avoided.

    Attributes:
        tried: designs that were tried.
        runs: designs that were simulated, without neighbours and finer timesteps.
        ruled_out: designs that were ruled out before any run, by method: closed forms, statics or the builder.
        neighbour_runs: neighbours that were simulated.
        spared_neighbours: neighbours that were not evaluated, because too few could work any more, or because their
            design was worse than a known good one.
        verification_runs: runs at the finer timestep and of new neighbours.
        simulated: whether the goal needs simulation.
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
        """Number of runs that were avoided."""
        return sum(self.ruled_out.values()) if self.simulated else 0


@dataclass(frozen=True, kw_only=True)
class Optimum(Result):
    """The best designs for a goal.

    Attributes:
        goal: the goal.
        candidates: all designs that were tried, in their order.
        best: the best of them, verified: one, or a front sorted by its first objective; empty if no design meets the
            goal.
        discarded: better ones that failed verification.
        effort: numbers of designs and runs.
        relaxations: if no design meets the goal, how far each limit would have to be relaxed, by limit; the last one is
            for the success of the protocol, if it is simulated.
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
            verification.candidate.screened.design
            for verification in self.best
            if isinstance(verification.candidate.screened.design, Design)
        )

    @property
    def feasible(self) -> bool:
        """Whether any design meets the goal."""
        return bool(self.best)

    def to_dataframe(self) -> DataFrame:
        """Return all candidates as a pandas table, one row each, SI."""
        return self.table.to_dataframe()

    def __repr__(self) -> str:
        """Return the numbers of best and of tried designs."""
        return f"<Optimum {self.goal.name}: {len(self.best)} of {self.effort.tried} designs are best>"


Numbers = NDArray[np.int64]


def candidates_to_keep(optimum: Optimum, most: int = MOST_KEPT) -> list[RunToKeep]:
    """Return the runs of the best designs, of the front, and of others that meet or miss the goal, evenly spread.

    Args:
        optimum: the result.
        most: largest number of runs. Without simulation, none is returned.
    """
    if not optimum.goal.simulate:
        return []
    table = optimum.table
    best, front, feasible = (table[name].values.astype(bool) for name in ("best", "front", "feasible"))
    first = [*np.flatnonzero(best), *np.flatnonzero(front & ~best)][:most]
    left = most - len(first)
    ran = table["outcome"].values != "not run"
    others = [_spread(np.flatnonzero(ran & ~best & ~front & kind), left) for kind in (feasible, ~feasible)]
    by_turns = [int(numbers[index]) for index in range(left) for numbers in others[::-1] if index < len(numbers)]
    designs = [candidate.screened.design for candidate in optimum.candidates]
    return designs_to_keep(designs, [*map(int, first), *by_turns], most)


def _spread(numbers: Numbers, most: int) -> Numbers:
    """Return at most this many of some numbers, evenly spread."""
    if len(numbers) <= most:
        return numbers
    indices = np.linspace(0, len(numbers) - 1, max(most, 0)).round().astype(np.int64)
    return np.asarray(numbers[indices], dtype=np.int64)
