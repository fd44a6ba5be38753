"""How far a sample is from a fact."""

from __future__ import annotations

import math
from dataclasses import dataclass

from forficula.goals.identify.fact import Fact, Term
from forficula.goals.identify.observe import Observed, observe
from forficula.goals.identify.sample_runs import Rows, SampleRuns, Wanted

# of a bound: what differs by less differs by rounding
_ROUNDING = 1e-9


@dataclass(frozen=True, kw_only=True)
class Finding:
    """What a sample says of a fact.

    Attributes:
        value: of what is observed, SI.
        miss: the value less its bound, SI, signed.
        distance: by how much the fact is missed, SI, at least 0; where runs that do not tell leave it open between two
            numbers, the larger one, and where they leave it open altogether, as if these had no number.
        met: whether it is within the fact's tolerance, whatever runs that do not tell would have come to.
        tells: whether it is met, or missed, for certain.
        untold: how many runs do not tell.
    """

    value: float
    miss: float
    distance: float
    met: bool
    tells: bool
    untold: int


def find(fact: Fact, runs: SampleRuns, rows: Rows) -> Finding | Wanted:
    """Say how far a sample is from a fact, or which of its designs must run before that is known."""
    observed = [observe(term, fact.places, runs, rows) for term in fact.terms]
    wanted = {key: run for each in observed if isinstance(each, dict) for key, run in each.items()}
    if wanted:
        return wanted
    seen = [each for each in observed if isinstance(each, Observed)]
    first, bound = seen[0], seen[1] if len(seen) > 1 else _fixed(fact)
    near, far = _distances(fact, first, bound)
    within = fact.tolerance + _ROUNDING * max(1.0, abs(first.value))
    return Finding(
        value=first.value,
        miss=first.value - bound.value,
        distance=far if math.isfinite(far) else _distance(fact, first.value, bound.value),
        met=far <= within,
        tells=far <= within or near > within,
        untold=sum(each.untold for each in seen),
    )


def _fixed(fact: Fact) -> Observed:
    """A bound that is a number, as if it were observed."""
    assert not isinstance(fact.bound, Term)
    return Observed(value=fact.bound, low=fact.bound, high=fact.bound, untold=0)


def _distances(fact: Fact, seen: Observed, bound: Observed) -> tuple[float, float]:
    """The least and the largest distance, whatever runs that do not tell would have come to."""
    far = max(_distance(fact, one, other) for one in (seen.low, seen.high) for other in (bound.low, bound.high))
    match fact.order:
        case "at least":
            near = bound.low - seen.high
        case "at most":
            near = seen.low - bound.high
        case _:
            near = max(bound.low - seen.high, seen.low - bound.high)
    return max(0.0, near), far


def _distance(fact: Fact, value: float, bound: float) -> float:
    if value == bound:
        return 0.0
    match fact.order:
        case "at least":
            return max(0.0, bound - value)
        case "at most":
            return max(0.0, value - bound)
        case _:
            return abs(value - bound)
