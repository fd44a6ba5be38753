"""Designs that a search tried: their results, variants within their tolerances (neighbours), and verification."""

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
from forficula.goals.binomial_interval import binomial_interval
from forficula.goals.deviation import deviating_values
from forficula.goals.goal import Goal
from forficula.goals.latin_points import latin_points
from forficula.goals.limit import Limit
from forficula.goals.optimise.screening import Screened, screened
from forficula.goals.optimise.trials import Axis, Point, Trial
from forficula.goals.outcome_quantity import PROBABILITY, OutcomeQuantity
from forficula.serial import Written

# Number of neighbours that are run first; it then doubles each time.
_FIRST = 8
FINER = 4
# Number of new neighbours for verification, per neighbour in the search.
_FRESH = 4
# Offset between the seeds of the neighbours for verification and of those in the search.
_OTHER_SEED = 1_000_003


@dataclass(frozen=True, kw_only=True)
class Neighbours:
    """Results of neighbours: variants of one design within its tolerances.

    Attributes:
        works: number of neighbours that meet the whole goal.
        tried: number of neighbours that were evaluated.
        wanted: number of neighbours to evaluate; larger than `tried` if the evaluation was stopped because too few
            work.
        runs: number of neighbours that had to be simulated.
        looks: number of designs from which this one was selected by the results of its neighbours.
    """

    works: int
    tried: int
    wanted: Annotated[int, Written.NEVER]
    runs: Annotated[int, Written.NEVER]
    looks: Annotated[int, Written.NEVER] = 1

    @property
    def share(self) -> Annotated[float, Written.ALWAYS]:
        """Fraction of the evaluated neighbours that work."""
        return self.works / self.tried

    @property
    def interval(self) -> tuple[float, float]:
        """95 % interval of the fraction."""
        return binomial_interval(self.works, self.tried, self.looks)

    @property
    def ends(self) -> Annotated[Mapping[str, float], Written.BESIDE]:
        """The ends of the interval by name."""
        return dict(zip(("low", "high"), self.interval, strict=True))


def neighbour_offsets(goal: Goal, count: int, seed: int) -> Array:
    """Return the deviations of neighbours in widths, the same for every design, (count, deviation)."""
    points = latin_points(len(goal.deviations), 2 ** math.ceil(math.log2(max(count, 1))), seed)[:count]
    columns = [deviation.offsets(column) for deviation, column in zip(goal.deviations, points.T, strict=True)]
    return np.array(columns).T


def neighbours_of(
    goal: Goal, assess: Assessor, designs: Sequence[Design], offsets: Array, least: float | None
) -> list[Neighbours]:
    """Evaluate ever more neighbours of designs, until a required fraction clearly cannot be reached.

    Args:
        goal: requirements for each neighbour.
        assess: computes rows of designs.
        designs: designs to evaluate.
        offsets: deviation of each neighbour in widths, (neighbour, deviation).
        least: required fraction; None to evaluate all neighbours.
    """
    count = len(offsets)
    allowed = count if least is None else count - math.ceil(least * count - 1e-9)
    works, runs, tried = [0] * len(designs), [0] * len(designs), [0] * len(designs)
    open_designs, done = list(range(len(designs))), 0
    while open_designs and done < count:
        end = min(count, max(_FIRST, 2 * done))
        owners = [number for number in open_designs for _ in range(done, end)]
        variants = [
            _variant(goal, designs[number], offsets[row]) for number in open_designs for row in range(done, end)
        ]
        for number, result in zip(owners, screened(goal, assess, variants, runs_first=True), strict=True):
            works[number] += result.meets
            runs[number] += goal.simulate and not result.ruled_out
            tried[number] += 1
        open_designs = [number for number in open_designs if tried[number] - works[number] <= allowed]
        done = end
    return [
        Neighbours(works=works[number], tried=tried[number], wanted=count, runs=runs[number])
        for number in range(len(designs))
    ]


def _variant(goal: Goal, design: Design, offsets: Array) -> Design | str:
    """Return a deviating design, or why it cannot be built."""
    try:
        return design.with_values(deviating_values(design, goal.deviations, [float(offset) for offset in offsets]))
    except InputError as error:
        return str(error)


@dataclass(frozen=True, kw_only=True)
class Candidate:
    """A design that was tried.

    Attributes:
        point: position in the unit cube of the parameters.
        values: values of the parameters by key, as in a design file.
        screened: result.
        neighbours: results of its neighbours; None if they were not evaluated.
    """

    point: Point
    values: Mapping[str, object]
    screened: Screened
    neighbours: Neighbours | None = None

    def value(self, quantity: OutcomeQuantity) -> float | None:
        """Return a quantity, SI; None if it does not exist or was not computed."""
        if quantity.name == PROBABILITY:
            return None if self.neighbours is None else self.neighbours.share
        return value_of(self.screened.row, quantity, self.screened.design)


def axes_of(goal: Goal) -> tuple[Axis, ...]:
    """Return the axes of a goal's parameters, in their order."""
    return tuple(Axis(levels=len(parameter.choices), ordered=parameter.ordered) for parameter in goal.parameters)


def wanted_share(goal: Goal) -> Limit | None:
    """Return the required fraction of working neighbours as a limit, if there is one."""
    limits = [limit for limit in goal.limits if limit.quantity.name == PROBABILITY and limit.kind == ">="]
    return max(limits, key=lambda limit: limit.bound, default=None)


def asks_probability(goal: Goal) -> bool:
    """Return whether the probability of working is an objective."""
    return any(objective.quantity.name == PROBABILITY for objective in goal.objectives)


def costs(goal: Goal, candidate: Candidate) -> tuple[float, ...]:
    """Return the numbers to minimise, one per objective; nan if unknown."""
    values = []
    for objective in goal.objectives:
        value = candidate.value(objective.quantity)
        # the probability of a design whose neighbours were not evaluated counts as 0
        unknown = 0.0 if objective.quantity.name == PROBABILITY and candidate.screened.meets else math.nan
        values.append(objective.cost(unknown if value is None else value))
    return tuple(values)


def trial_of(goal: Goal, candidate: Candidate) -> Trial:
    """Return a candidate as a trial of the search."""
    result, required, neighbours = candidate.screened, wanted_share(goal), candidate.neighbours
    surplus = math.nan
    if required is not None and neighbours is not None:
        surplus = neighbours.share - required.bound
        if neighbours.tried < neighbours.wanted:
            # if the evaluation was stopped early, the first neighbours may have been better than average
            surplus = min(surplus, -1 / neighbours.wanted)
    margins = (*result.margins, result.works) if goal.simulate else result.margins
    return Trial(point=candidate.point, objectives=costs(goal, candidate), margins=margins, surplus=surplus)


@dataclass(frozen=True, kw_only=True)
class Verification:
    """Check of a candidate with conditions that the search did not use.

    Attributes:
        candidate: the candidate.
        timestep: timestep of its run, s; None without simulation.
        finer: result at a quarter of this timestep; None without simulation.
        fresh: results of new neighbours; None without tolerances.
        holds: whether all limits are met again, including that on the probability.
    """

    candidate: Candidate
    timestep: float | None
    finer: Screened | None
    fresh: Neighbours | None
    holds: bool

    @property
    def residual(self) -> float | None:
        """Largest fraction of the energy that the balance misses at the finer timestep."""
        return None if self.finer is None else self.finer.row.get("residual")


def verified(goal: Goal, assess: Assessor, candidates: Sequence[Candidate], before: int = 0) -> list[Verification]:
    """Verify candidates that meet a goal.

    Args:
        goal: the goal.
        assess: computes rows of designs.
        candidates: candidates that could be built.
        before: number of other candidates that failed verification before; new neighbours are drawn each time.
    """
    designs = [candidate.screened.design for candidate in candidates if isinstance(candidate.screened.design, Design)]
    steps = [_timestep(candidate) for candidate in candidates]
    finer: list[Screened | None] = [None] * len(candidates)
    if goal.simulate:
        finer = [*screened(goal, assess, [_finer(design, step) for design, step in zip(designs, steps, strict=True)])]
    fresh: list[Neighbours | None] = [None] * len(candidates)
    if goal.deviations:
        offsets = neighbour_offsets(goal, _FRESH * goal.neighbours, goal.seed + _OTHER_SEED + before)
        fresh = [*neighbours_of(goal, assess, designs, offsets, None)]
    required = wanted_share(goal)
    return [
        Verification(
            candidate=candidate,
            timestep=step,
            finer=result,
            # the number of selected designs widens the interval, because the first one that passes is taken
            fresh=None if neighbours is None else replace(neighbours, looks=before + 1),
            holds=(result is None or result.meets)
            and (required is None or neighbours is None or required.margin(neighbours.share) >= 0),
        )
        for candidate, step, result, neighbours in zip(candidates, steps, finer, fresh, strict=True)
    ]


def _timestep(candidate: Candidate) -> float | None:
    step = candidate.screened.row.get("timestep_s")
    return None if step is None else float(step)


def _finer(design: Design, timestep: float | None) -> Design | str:
    """Return the design at a quarter of a timestep, s."""
    try:
        return design if timestep is None else design.with_values({"protocol.timestep": timestep / FINER})
    except InputError as error:
        return str(error)
