"""What a tolerance comes to, in sentences: how likely it works, which tolerance to tighten, how near failure is."""

from __future__ import annotations

import math

import numpy as np

from forficula.goals.share_interval import LEVEL
from forficula.goals.tolerance.probability import Probability, surely_less
from forficula.goals.tolerance.tolerance import Tolerance

# groups that decide less of the variance than this may be made as roughly as they are
_LITTLE = 0.05
_MOST_NAMED = 3
# how near what works must be to what fails, as a share of it, for that to be told as one number
_SHARP = 0.9


def advice(found: Tolerance) -> list[str]:
    """Say what was found, the most important first, in sentences.

    Args:
        found: what the runs say.
    """
    told = [
        *_nominal(found),
        _works(found),
        *_wanted(found),
        *_decides(found),
        *_side(found),
        *_near(found),
        *_doubtful(found),
        *_bounded(found),
    ]
    return [*told, *_assumed(found)]


def percent(probability: Probability) -> str:
    """A probability with its interval, such as "55 % (49 to 61 %)"."""
    if probability.share is None:
        return "unknown"
    return f"{_number(probability.share)} % ({_number(probability.low)} to {_number(probability.high)} %)"


def most_telling(found: Tolerance) -> int | None:
    """Number of the factor that decides; None where nothing varies, or nothing was told.

    Of those that decide most of the margin that with the largest gain, where one of them gains beyond chance.
    """
    order = found.order
    if not found.tells_what_decides or not order or not np.nanmax(np.abs(found.indices.first[0]), initial=0.0) > 0:
        return None
    sure = [factor for factor in order[:_MOST_NAMED] if found.narrowed[factor].gain_low > 0]
    return max(sure, key=lambda factor: found.narrowed[factor].gain) if sure else order[0]


def tighten_first(found: Tolerance) -> int | None:
    """Number of the factor whose tolerance to tighten first; None where that is not known, or would not help.

    Where nothing fails there is nothing to gain, and where nothing works there is nothing to keep.
    """
    works = found.probability
    return most_telling(found) if works.works and works.fails else None


def _nominal(found: Tolerance) -> list[str]:
    if found.nominal_works:
        return []
    return [f"As designed it does not work already: {found.nominal.outcomes[0]}."]


def _works(found: Tolerance) -> str:
    works, failed = found.probability, [name for name in found.outcomes if name not in _working(found)]
    count = f"{works.count} designs within the tolerances"
    if works.share is None:
        return f"None of {count} tells whether it works: {', '.join(found.outcomes)}."
    ways = "" if not failed else f" Those that fail mostly end with: {failed[0]}."
    return f"It works in {percent(works)} of cases, by {count}.{ways}"


def _wanted(found: Tolerance) -> list[str]:
    """What was asked of the probability, and whether its interval tells."""
    works, told = found.probability, []
    for limit in found.question.wanted:
        above, below = works.low >= limit.bound, works.high <= limit.bound
        met = above if limit.kind == ">=" else below
        missed = works.high < limit.bound if limit.kind == ">=" else works.low > limit.bound
        kept = "is met" if met else "is not met" if missed else "lies within the interval: it cannot be told"
        told.append(f"Asked was {limit}, which {kept}.")
    return told


def _working(found: Tolerance) -> set[str]:
    works = found.samples.facts[0]
    return set(found.samples.outcomes[works].tolist())


def _decides(found: Tolerance) -> list[str]:
    if not found.tells_what_decides:
        return ["So few designs do not tell which tolerance decides: give it more time."]
    factor = most_telling(found)
    if found.probability.share is None:
        return []
    if factor is None:
        return ["Nothing within the tolerances changes the margin."]
    question, line = found.question, bool(np.isnan(found.indices.total[0]).all())
    share, low, high = _decided(found, found.kept.index(factor))
    how = "by a straight line over it" if line else "alone and with others"
    which = f"the tolerance of {question.keys[factor]}, {question.width_text(factor)}"
    decides = f"decides {_range(share, low, high)} of the margin's variance, {how}"
    if tighten_first(found) is None:
        what = (
            f"None of the {found.probability.works} that tell fails: no tolerance has to be tightened."
            if found.probability.works
            else "None of them works, whatever the tolerances: move the design first."
        )
        return [f"{what} What matters most is {which}: it {decides}.", *_unresolved(found), *_rest(found)]
    told = f"Tighten {which}, first. It {decides}{_gained(found, factor)}."
    by_chance = found.narrowed[factor].gain_low <= 0
    told = f"{told} Half of it alone gains no more than chance." if by_chance else told
    return [told, *_unresolved(found), *_rest(found)]


def _unresolved(found: Tolerance) -> list[str]:
    """That more runs may show another factor to decide most: where resamplings disagree on which does."""
    leads = np.nan_to_num(found.indices.leads[0, : len(found.kept)])
    order = np.argsort(-leads, kind="stable")
    if len(order) < 2 or leads[order[0]] >= LEVEL:
        return []
    first, second = (f"{found.question.keys[found.kept[place]]} in {_number(leads[place])} %" for place in order[:2])
    return [
        f"The number of runs does not resolve which tolerance decides most of the variance: of resamplings of"
        f" {found.indices.rows} rows, {first}, {second}."
    ]


def _decided(found: Tolerance, place: int) -> tuple[float, float, float]:
    """The share of the margin's variance that a factor decides, with others where that is known, and its interval."""
    each = found.indices
    first, total = (each.first, each.first_low, each.first_high), (each.total, each.total_low, each.total_high)
    share, low, high = (float(values[0, place]) for values in (first if np.isnan(each.total[0]).all() else total))
    return share, low, high


def _rest(found: Tolerance) -> list[str]:
    """What the factors decide that have no indices of their own."""
    number = len(found.question.keys) - len(found.kept)
    if not number or np.isnan(found.indices.total[0]).all():
        return []
    rest = _decided(found, -1)
    may = ": these need no care" if rest[2] < _LITTLE else ""
    return [f"The {number} others together decide {_range(*rest)}{may}."]


def _gained(found: Tolerance, factor: int) -> str:
    gain = found.narrowed[factor]
    if gain.gain_low <= 0 or found.probability.share is None:
        return ""
    then = min(found.probability.share + gain.gain, 1.0)
    span = f"{_number(gain.gain_low)} to {_number(gain.gain_high)} more"
    return f"; with half of it {_number(then)} of 100 would work instead of {_number(found.probability.share)} ({span})"


def _side(found: Tolerance) -> list[str]:
    """Which value to move, and which way: where it fails more often on one side than on the other, beyond chance."""
    if not found.tells_what_decides:
        return []
    sides = []
    for factor, each in enumerate(found.narrowed):
        for way, one, other in (("larger", each.below, each.above), ("smaller", each.above, each.below)):
            if one.share is not None and other.share is not None and surely_less(one, other, 2 * len(found.narrowed)):
                sides.append((one.share - other.share, factor, way))
    if not sides:
        return []
    _, factor, way = min(sides)
    each, question = found.narrowed[factor], found.question
    where, less, more = ("below", each.below, each.above) if way == "larger" else ("above", each.above, each.below)
    return [
        f"A {way} {question.keys[factor]} than {question.value_text(factor, 0.0)} would help: where it is {where} that,"
        f" {_number(less.share or 0.0)} % work, on the other side {_number(more.share or 0.0)} %."
    ]


def _near(found: Tolerance) -> list[str]:
    """The nearest failure of one value alone, and of all together where that is nearer."""
    told, distance = [], math.inf
    alone = [
        (reach.fails, factor, sign, reach.works)
        for factor, ways in enumerate(found.reaches)
        for sign, reach in zip((-1, 1), ways, strict=True)
        if reach.fails is not None
    ]
    if alone:
        distance, factor, sign, works = min(alone)
        value = found.question.value_text(factor, sign * distance)
        width = f"{distance:.2g}" if works >= _SHARP * distance else f"between {works:.2g} and {distance:.2g}"
        told.append(
            f"The nearest failure of one value alone is {found.question.keys[factor]} at {value},"
            f" {width} tolerances {'above' if sign > 0 else 'below'} its own."
        )
    elif found.reaches:
        told.append(f"No value alone makes it fail within {found.plan.steps[-1]:g} tolerances, or its bounds.")
    if found.nearest is not None and found.nearest.largest < distance:
        told.append(f"All together fail where none is off by more than {found.nearest.largest:.2g} of its tolerance.")
    return told


def _doubtful(found: Tolerance) -> list[str]:
    unknown = found.probability.unknown
    if not unknown:
        return []
    runs = "1 run is" if unknown == 1 else f"{unknown} runs are"
    return [
        f"{runs} not to be trusted, or cannot be built: the intervals hold whatever they would have come to,"
        " and their margin counts as -1."
    ]


def _bounded(found: Tolerance) -> list[str]:
    """Of which values the tolerance goes beyond what their keys allow, and how many designs are at that bound."""
    told, question = [], found.question
    for factor, key in enumerate(question.keys):
        offsets = found.samples.offsets[:, factor]
        for end, beyond in zip(question.reach(factor), (np.less, np.greater), strict=True):
            if count := int(np.sum(beyond(offsets, end))):
                told.append(
                    f"{key} cannot go beyond {question.value_text(factor, end)}: {count} of {len(offsets)} designs have"
                    " that value instead of one farther off, as its tolerance would have it."
                )
    return told


def _assumed(found: Tolerance) -> list[str]:
    if not found.question.assumed:
        return []
    return [
        f"No tolerances were given: {found.question.width_text(0)}, uniform, on all {len(found.question.keys)} positive"
        " values with units that are not the protocol's."
    ]


def _range(share: float, low: float, high: float) -> str:
    return f"{_number(max(share, 0.0))} % ({_number(max(low, 0.0))} to {_number(min(high, 1.0))} %)"


def _number(share: float) -> str:
    """Percent, with a digit more near 0 and 100."""
    value = 100 * share
    if math.isclose(value, round(value), abs_tol=1e-9):
        return f"{value:.0f}"
    return f"{value:.0f}" if 2 <= value <= 98 else f"{value:.1f}"
