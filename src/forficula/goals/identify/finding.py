"""How far a sample is from a fact."""

from __future__ import annotations

from dataclasses import dataclass

from forficula.goals.identify.fact import Fact
from forficula.goals.identify.observe import Observed, observe
from forficula.goals.identify.sample_runs import Rows, SampleRuns, Wanted

# of a bound: what differs by less differs by rounding
_ROUNDING = 1e-9


@dataclass(frozen=True, kw_only=True)
class Finding:
    """What a sample says of a fact.

    Attributes:
        value: of what is observed, SI.
        distance: by how much the fact is missed, SI, at least 0; the larger one where runs that do not tell may go
            either way.
        met: whether that is within the fact's tolerance.
        untold: how many runs do not tell.
    """

    value: float
    distance: float
    met: bool
    untold: int


def find(fact: Fact, runs: SampleRuns, rows: Rows) -> Finding | Wanted:
    """Say how far a sample is from a fact, or which of its designs must run before that is known."""
    observed = [observe(term, fact.places, runs, rows) for term in fact.terms]
    wanted = {key: run for each in observed if isinstance(each, dict) for key, run in each.items()}
    if wanted:
        return wanted
    seen = [each for each in observed if isinstance(each, Observed)]
    distance = max(_distances(fact, seen))
    return Finding(
        value=seen[0].value,
        distance=distance,
        met=distance <= fact.tolerance + _ROUNDING * max(1.0, abs(seen[0].value)),
        untold=sum(each.untold for each in seen),
    )


def _distances(fact: Fact, seen: list[Observed]) -> list[float]:
    """The distance for every way in which the runs that do not tell may go."""
    first, *others = seen
    bounds = [others[0].value, others[0].other] if others else [float(fact.bound)]  # type: ignore[arg-type]
    return [_distance(fact, value, bound) for value in (first.value, first.other) for bound in bounds]


def _distance(fact: Fact, value: float, bound: float) -> float:
    match fact.order:
        case "at least":
            return max(0.0, bound - value)
        case "at most":
            return max(0.0, value - bound)
        case _:
            return abs(value - bound)
