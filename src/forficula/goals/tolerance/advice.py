"""Conclusions of a tolerance analysis in sentences: probability, tolerance to tighten, nearest failure."""

from __future__ import annotations

import math

import numpy as np

from forficula.goals.binomial_interval import LEVEL
from forficula.goals.tolerance.probability import Probability, surely_less
from forficula.goals.tolerance.tolerance import Tolerance

# groups that explain less of the variance than this are uncritical
_LITTLE = 0.05
_MOST_NAMED = 3
# if the largest deviation that works is at least this fraction of the smallest that fails, one number is reported
_SHARP = 0.9


def advice(result: Tolerance) -> list[str]:
    """Return the conclusions in sentences, the most important first.

    Args:
        result: the result.
    """
    sentences = [
        *_nominal(result),
        _works(result),
        *_required(result),
        *_decides(result),
        *_side(result),
        *_near(result),
        *_doubtful(result),
        *_bounded(result),
    ]
    return [*sentences, *_assumed(result)]


def percent(probability: Probability) -> str:
    """Return a probability with its interval, such as "55 % (49 to 61 %)"."""
    if probability.share is None:
        return "unknown"
    return f"{_number(probability.share)} % ({_number(probability.low)} to {_number(probability.high)} %)"


def most_important(result: Tolerance) -> int | None:
    """Return the index of the most important factor; None if nothing varies or the importance is unknown.

    This is the factor with the largest significant gain among those that explain most of the margin's variance; if no
    gain is significant, the one that explains most.
    """
    order = result.order
    if not result.can_rank_factors or not order or not np.nanmax(np.abs(result.indices.first[0]), initial=0.0) > 0:
        return None
    significant = [factor for factor in order[:_MOST_NAMED] if result.narrowed[factor].gain_low > 0]
    return max(significant, key=lambda factor: result.narrowed[factor].gain) if significant else order[0]


def tighten_first(result: Tolerance) -> int | None:
    """Return the index of the factor whose tolerance to tighten first; None if it is unknown or would not help.

    If nothing fails, there is nothing to gain. If nothing works, tighter tolerances do not help.
    """
    works = result.probability
    return most_important(result) if works.works and works.fails else None


def _nominal(result: Tolerance) -> list[str]:
    if result.nominal_works:
        return []
    return [f"The nominal design does not work: {result.nominal.outcomes[0]}."]


def _works(result: Tolerance) -> str:
    works, failed = result.probability, [name for name in result.outcomes if name not in _working(result)]
    if works.share is None:
        outcomes = ", ".join(result.outcomes)
        return f"None of {works.count} designs within the tolerances has a conclusive result: {outcomes}."
    failures = "" if not failed else f" Most failures end with: {failed[0]}."
    return (
        f"The design works in {percent(works)} of cases within its tolerances, estimated from {works.count} designs."
        f"{failures}"
    )


def _required(result: Tolerance) -> list[str]:
    """Return whether the required probability is met."""
    works, sentences = result.probability, []
    for limit in result.question.wanted:
        above, below = works.low >= limit.bound, works.high <= limit.bound
        met = above if limit.kind == ">=" else below
        missed = works.high < limit.bound if limit.kind == ">=" else works.low > limit.bound
        judged = "met" if met else "not met" if missed else "undecided, because it lies within the confidence interval"
        sentences.append(f"The required {limit} is {judged}.")
    return sentences


def _working(result: Tolerance) -> set[str]:
    works = result.samples.facts[0]
    return set(result.samples.outcomes[works].tolist())


def _decides(result: Tolerance) -> list[str]:
    if not result.can_rank_factors:
        return ["There are too few designs to rank the tolerances: increase the time."]
    factor = most_important(result)
    if result.probability.share is None:
        return []
    if factor is None:
        return ["No tolerance changes the margin."]
    question, line = result.question, bool(np.isnan(result.indices.total[0]).all())
    share, low, high = _decided(result, result.kept.index(factor))
    how = "by linear regression" if line else "alone and in interaction with others"
    which = f"the tolerance of {question.keys[factor]}, {question.width_text(factor)}"
    decides = f"explains {_range(share, low, high)} of the margin's variance, {how}"
    if tighten_first(result) is None:
        what = (
            f"None of the {result.probability.works} conclusive designs fails: no tolerance needs to be tightened."
            if result.probability.works
            else "None of the designs works: change the design before its tolerances."
        )
        return [f"{what} What matters most is {which}: it {decides}.", *_unresolved(result), *_rest(result)]
    sentence = f"Tighten {which}, first. It {decides}{_gained(result, factor)}."
    by_chance = result.narrowed[factor].gain_low <= 0
    sentence = f"{sentence} Halving this tolerance alone has no significant effect." if by_chance else sentence
    return [sentence, *_unresolved(result), *_rest(result)]


def _unresolved(result: Tolerance) -> list[str]:
    """Return a warning if resamplings disagree on which tolerance explains most of the variance."""
    leads = np.nan_to_num(result.indices.leads[0, : len(result.kept)])
    order = np.argsort(-leads, kind="stable")
    if len(order) < 2 or leads[order[0]] >= LEVEL:
        return []
    first, second = (f"{result.question.keys[result.kept[index]]} in {_number(leads[index])} %" for index in order[:2])
    return [
        "There are too few runs to resolve which tolerance explains most of the variance: in resamplings of"
        f" {result.indices.rows} rows it is {first} and {second}."
    ]


def _decided(result: Tolerance, position: int) -> tuple[float, float, float]:
    """Return the fraction of the margin's variance that a factor explains, and its interval."""
    indices = result.indices
    first, total = (
        (indices.first, indices.first_low, indices.first_high),
        (indices.total, indices.total_low, indices.total_high),
    )
    share, low, high = (float(values[0, position]) for values in (first if np.isnan(indices.total[0]).all() else total))
    return share, low, high


def _rest(result: Tolerance) -> list[str]:
    """Return a sentence on the factors without indices of their own."""
    number = len(result.question.keys) - len(result.kept)
    if not number or np.isnan(result.indices.total[0]).all():
        return []
    rest = _decided(result, -1)
    uncritical = ": they are uncritical" if rest[2] < _LITTLE else ""
    return [f"The remaining tolerances ({number}) together explain {_range(*rest)}{uncritical}."]


def _gained(result: Tolerance, factor: int) -> str:
    gain = result.narrowed[factor]
    if gain.gain_low <= 0 or result.probability.share is None:
        return ""
    then = min(result.probability.share + gain.gain, 1.0)
    span = f"by {_number(gain.gain_low)} to {_number(gain.gain_high)} percentage points"
    before = _number(result.probability.share)
    return f"; halving it would raise the probability from {before} % to {_number(then)} % ({span})"


def _side(result: Tolerance) -> list[str]:
    """Return which value to increase or decrease: one for which failures are significantly rarer on one side."""
    if not result.can_rank_factors:
        return []
    sides = []
    for factor, narrowed in enumerate(result.narrowed):
        for direction, worse, better in (
            ("larger", narrowed.below, narrowed.above),
            ("smaller", narrowed.above, narrowed.below),
        ):
            if (
                worse.share is not None
                and better.share is not None
                and surely_less(worse, better, 2 * len(result.narrowed))
            ):
                sides.append((worse.share - better.share, factor, direction))
    if not sides:
        return []
    _, factor, direction = min(sides)
    narrowed, question = result.narrowed[factor], result.question
    less, more = (narrowed.below, narrowed.above) if direction == "larger" else (narrowed.above, narrowed.below)
    opposite = "smaller" if direction == "larger" else "larger"
    return [
        f"A {direction} {question.keys[factor]} than {question.value_text(factor, 0.0)} would help:"
        f" {_number(less.share or 0.0)} % of the designs with a {opposite} value work,"
        f" and {_number(more.share or 0.0)} % of those with a {direction} one."
    ]


def _near(result: Tolerance) -> list[str]:
    """Return the nearest failure of one value alone, and of all together if that is nearer."""
    sentences, distance = [], math.inf
    alone = [
        (reach.fails, factor, sign, reach.works)
        for factor, ways in enumerate(result.reaches)
        for sign, reach in zip((-1, 1), ways, strict=True)
        if reach.fails is not None
    ]
    if alone:
        distance, factor, sign, works = min(alone)
        value = result.question.value_text(factor, sign * distance)
        width = f"{distance:.2g}" if works >= _SHARP * distance else f"between {works:.2g} and {distance:.2g}"
        sentences.append(
            f"If only one value deviates, the nearest failure is {result.question.keys[factor]} at {value},"
            f" {width} tolerances {'above' if sign > 0 else 'below'} its nominal value."
        )
    elif result.reaches:
        sentences.append(
            f"No single value makes the design fail within {result.plan.steps[-1]:g} tolerances or its bounds."
        )
    if result.nearest is not None and result.nearest.largest < distance:
        sentences.append(
            "If all values deviate together, the design can fail with deviations of at most"
            f" {result.nearest.largest:.2g} tolerances."
        )
    return sentences


def _doubtful(result: Tolerance) -> list[str]:
    unknown = result.probability.unknown
    if not unknown:
        return []
    runs = "1 run is" if unknown == 1 else f"{unknown} runs are"
    return [
        f"{runs} unreliable or cannot be built: the intervals allow for every outcome of these runs,"
        " and their margin counts as -1."
    ]


def _bounded(result: Tolerance) -> list[str]:
    """Return which tolerances exceed the bounds of their keys, and the number of designs at the bound."""
    sentences, question = [], result.question
    for factor, key in enumerate(question.keys):
        offsets = result.samples.offsets[:, factor]
        for end, beyond in zip(question.reach(factor), (np.less, np.greater), strict=True):
            if count := int(np.sum(beyond(offsets, end))):
                sentences.append(
                    f"{key} cannot go beyond {question.value_text(factor, end)}: {count} of {len(offsets)} designs"
                    " would exceed this bound within the tolerance and have this value instead."
                )
    return sentences


def _assumed(result: Tolerance) -> list[str]:
    if not result.question.assumed:
        return []
    return [
        f"No tolerances were given: {result.question.width_text(0)}, uniform, on all {len(result.question.keys)}"
        " positive values with units that are not in the protocol."
    ]


def _range(share: float, low: float, high: float) -> str:
    return f"{_number(max(share, 0.0))} % ({_number(max(low, 0.0))} to {_number(min(high, 1.0))} %)"


def _number(share: float) -> str:
    """Return a percentage, with one more digit near 0 and 100."""
    value = 100 * share
    if math.isclose(value, round(value), abs_tol=1e-9):
        return f"{value:.0f}"
    return f"{value:.0f}" if 2 <= value <= 98 else f"{value:.1f}"
