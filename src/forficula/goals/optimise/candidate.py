"""Designs that a search tried: outcomes, outcomes of their neighbours, and verification."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Annotated

import numpy as np

from forficula.arrays import Array
from forficula.design import Design
from forficula.errors import InputError
from forficula.goals.assessor import Assessor, value_of
from forficula.goals.deviation import off_values
from forficula.goals.goal import Goal
from forficula.goals.latin_points import latin_points
from forficula.goals.limit import Limit
from forficula.goals.optimise.screening import Screened, screened
from forficula.goals.optimise.trials import Axis, Point, Trial
from forficula.goals.outcome_quantity import PROBABILITY, OutcomeQuantity
from forficula.goals.share_interval import share_interval
from forficula.serial import Written

# Neighbours that are asked first; each time after that twice as many are known.
_FIRST = 8
FINER = 4
# Fresh neighbours, for each that the search asked.
_FRESH = 4
# What tells the draws of the fresh ones from those of the search.
_OTHER_SEED = 1_000_003


@dataclass(frozen=True, kw_only=True)
class Neighbours:
    """What became of designs within the tolerances of one.

    Attributes:
        works: how many do all that the goal asks.
        tried: how many were asked.
        wanted: how many there are to ask; more than were, where it was plain that too few would work.
        runs: how many of them had to be simulated.
        looks: out of how many designs this one was chosen for what its neighbours do.
    """

    works: int
    tried: int
    wanted: Annotated[int, Written.NEVER]
    runs: Annotated[int, Written.NEVER]
    looks: Annotated[int, Written.NEVER] = 1

    @property
    def share(self) -> Annotated[float, Written.ALWAYS]:
        """Of those that were asked, the ones that work."""
        return self.works / self.tried

    @property
    def interval(self) -> tuple[float, float]:
        """Of the share, at 95 %."""
        return share_interval(self.works, self.tried, self.looks)

    @property
    def ends(self) -> Annotated[Mapping[str, float], Written.BESIDE]:
        """The ends of the interval by name."""
        return dict(zip(("low", "high"), self.interval, strict=True))


def neighbour_offsets(goal: Goal, count: int, seed: int) -> Array:
    """By how many widths neighbours are off, the same of every design, (count, deviation)."""
    shares = latin_points(len(goal.deviations), 2 ** math.ceil(math.log2(max(count, 1))), seed)[:count]
    columns = [deviation.offsets(column) for deviation, column in zip(goal.deviations, shares.T, strict=True)]
    return np.array(columns).T


def neighbours_of(
    goal: Goal, assess: Assessor, designs: Sequence[Design], offsets: Array, least: float | None
) -> list[Neighbours]:
    """Ask neighbours of designs, ever more of them, until it is plain that a wanted share cannot be reached.

    Args:
        goal: what is asked of each.
        assess: that answers.
        designs: whose neighbours are asked.
        offsets: by how many widths each neighbour is off, (neighbour, deviation).
        least: share that is to work; None to ask all of them.
    """
    count = len(offsets)
    allowed = count if least is None else count - math.ceil(least * count - 1e-9)
    works, runs, tried = [0] * len(designs), [0] * len(designs), [0] * len(designs)
    going, asked = list(range(len(designs))), 0
    while going and asked < count:
        upto = min(count, max(_FIRST, 2 * asked))
        owners = [number for number in going for _ in range(asked, upto)]
        off = [_off(goal, designs[number], offsets[row]) for number in going for row in range(asked, upto)]
        for number, found in zip(owners, screened(goal, assess, off, runs_first=True), strict=True):
            works[number] += found.meets
            runs[number] += goal.simulate and not found.ruled_out
            tried[number] += 1
        going = [number for number in going if tried[number] - works[number] <= allowed]
        asked = upto
    return [
        Neighbours(works=works[number], tried=tried[number], wanted=count, runs=runs[number])
        for number in range(len(designs))
    ]


def _off(goal: Goal, design: Design, offsets: Array) -> Design | str:
    """A design that is off, or why it cannot be built so."""
    try:
        return design.with_values(off_values(design, goal.deviations, [float(each) for each in offsets]))
    except InputError as error:
        return str(error)


@dataclass(frozen=True, kw_only=True)
class Candidate:
    """A design that was tried.

    Attributes:
        point: where it lies in the unit cube of the parameters.
        values: of the parameters by key, as a design file has them.
        found: what it came to.
        neighbours: what became of those within the tolerances; None where it was not worth asking.
    """

    point: Point
    values: Mapping[str, object]
    found: Screened
    neighbours: Neighbours | None = None

    def value(self, quantity: OutcomeQuantity) -> float | None:
        """A quantity, SI; None where there is none or it was not asked."""
        if quantity.name == PROBABILITY:
            return None if self.neighbours is None else self.neighbours.share
        return value_of(self.found.row, quantity, self.found.design)


def axes_of(goal: Goal) -> tuple[Axis, ...]:
    """The axes of a goal's parameters, in their order."""
    return tuple(Axis(levels=len(each.choices), ordered=each.ordered) for each in goal.parameters)


def wanted_share(goal: Goal) -> Limit | None:
    """The least share of neighbours that is to work, if there is one."""
    wanted = [each for each in goal.limits if each.quantity.name == PROBABILITY and each.kind == ">="]
    return max(wanted, key=lambda each: each.bound, default=None)


def asks_probability(goal: Goal) -> bool:
    """Whether the probability of working is itself to be as large as can be."""
    return any(each.quantity.name == PROBABILITY for each in goal.objectives)


def costs(goal: Goal, candidate: Candidate) -> tuple[float, ...]:
    """What is to be small, an objective each; nan where one is not known."""
    found = []
    for each in goal.objectives:
        value = candidate.value(each.quantity)
        # what was not worth asking is not known to be worse than nothing
        unknown = 0.0 if each.quantity.name == PROBABILITY and candidate.found.meets else math.nan
        found.append(each.cost(unknown if value is None else value))
    return tuple(found)


def trial_of(goal: Goal, candidate: Candidate) -> Trial:
    """A candidate as the search sees it."""
    found, wanted, neighbours = candidate.found, wanted_share(goal), candidate.neighbours
    surplus = math.nan
    if wanted is not None and neighbours is not None:
        surplus = neighbours.share - wanted.bound
        if neighbours.tried < neighbours.wanted:
            # of those that were given up the first ones may have done well
            surplus = min(surplus, -1 / neighbours.wanted)
    margins = (*found.margins, found.works) if goal.simulate else found.margins
    return Trial(point=candidate.point, objectives=costs(goal, candidate), margins=margins, surplus=surplus)


@dataclass(frozen=True, kw_only=True)
class Verification:
    """How a candidate does where the search did not look.

    Attributes:
        candidate: that was verified.
        timestep: of its run, s; None where nothing is run.
        finer: what it comes to at a quarter of that; None where nothing is run.
        fresh: what became of neighbours that the search did not ask; None without tolerances.
        holds: whether all limits are met again, that on the probability among them.
    """

    candidate: Candidate
    timestep: float | None
    finer: Screened | None
    fresh: Neighbours | None
    holds: bool

    @property
    def residual(self) -> float | None:
        """The largest share of the energy that is missing at the finer timestep."""
        return None if self.finer is None else self.finer.row.get("residual")


def verified(goal: Goal, assess: Assessor, candidates: Sequence[Candidate], before: int = 0) -> list[Verification]:
    """Verify candidates that meet a goal.

    Args:
        goal: what is asked.
        assess: that answers.
        candidates: that were built.
        before: how many others were verified before and did not hold: each time the fresh neighbours are drawn anew.
    """
    designs = [each.found.design for each in candidates if isinstance(each.found.design, Design)]
    steps = [_timestep(each) for each in candidates]
    finer: list[Screened | None] = [None] * len(candidates)
    if goal.simulate:
        finer = [*screened(goal, assess, [_finer(d, step) for d, step in zip(designs, steps, strict=True)])]
    fresh: list[Neighbours | None] = [None] * len(candidates)
    if goal.deviations:
        offsets = neighbour_offsets(goal, _FRESH * goal.neighbours, goal.seed + _OTHER_SEED + before)
        fresh = [*neighbours_of(goal, assess, designs, offsets, None)]
    wanted = wanted_share(goal)
    return [
        Verification(
            candidate=candidate,
            timestep=step,
            finer=fine,
            # the first that does well enough is taken
            fresh=None if other is None else replace(other, looks=before + 1),
            holds=(fine is None or fine.meets) and (wanted is None or other is None or wanted.margin(other.share) >= 0),
        )
        for candidate, step, fine, other in zip(candidates, steps, finer, fresh, strict=True)
    ]


def _timestep(candidate: Candidate) -> float | None:
    step = candidate.found.row.get("timestep_s")
    return None if step is None else float(step)


def _finer(design: Design, timestep: float | None) -> Design | str:
    """The design at a quarter of a timestep, s."""
    try:
        return design if timestep is None else design.with_values({"protocol.timestep": timestep / FINER})
    except InputError as error:
        return str(error)
