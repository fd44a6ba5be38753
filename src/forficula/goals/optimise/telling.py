"""What a search came to, in sentences."""

from __future__ import annotations

import math
from collections import Counter

from forficula.design import Design
from forficula.goals.goal import Goal, own_limits
from forficula.goals.limit import Limit
from forficula.goals.optimise.candidate import Candidate, Neighbours, Verification, axes_of, trial_of, wanted_share
from forficula.goals.optimise.optimum import Optimum
from forficula.goals.optimise.parabola_search import filling_count
from forficula.goals.optimise.trials import Relaxation, nearest_trial
from forficula.goals.parameter import Parameter
from forficula.names import counted
from forficula.quantities import show_quantity

# of the way from bound to bound: no further from one it lies there
_NEAR = 1e-3


def told(found: Optimum) -> list[str]:
    """Say what was found, what it cost, and where nothing meets the goal, what would have to give."""
    said = [_answer(found)]
    if found.best:
        said += [_verified(found.best)]
        edge = bounded_text(found.goal, found.best[0].candidate) if len(found.goal.objectives) == 1 else None
        said += [] if edge is None else [edge]
    said += _discarded(found)
    if not found.best:
        said += _missing(found)
    filled = filling_text(found.goal)
    return [*said, _effort(found), *([] if filled is None else [filled])]


def value_texts(goal: Goal, candidate: Candidate) -> list[str]:
    """The quantities of a goal of a candidate, as sentences have them."""
    texts = []
    for quantity in goal.quantities:
        value = candidate.value(quantity)
        shown = "unknown" if value is None else show_quantity(value, quantity.unit)
        texts.append(f"{quantity.name} {shown}")
    return texts


def _answer(found: Optimum) -> str:
    goal, count = found.goal, found.effort.tried
    asked = " and ".join(f"the {each.kind} {each.quantity.name}" for each in goal.objectives)
    if not found.best:
        what = "holds when it is verified" if found.discarded else "meets every limit"
        return f"none of {counted(count, 'design')} {what}"
    if len(goal.objectives) > 1:
        return f"{counted(len(found.best), 'design')} of the front of {asked}, of {count} that were tried"
    best = found.best[0].candidate
    values = ", ".join(f"{key} = {value}" for key, value in best.values.items())
    return f"{asked} of {counted(count, 'design')}: {', '.join(value_texts(goal, best))}, with {values}"


def _verified(best: tuple[Verification, ...]) -> str:
    said = []
    residuals = [each.residual for each in best if each.residual is not None]
    if residuals:
        said.append(
            f"at a quarter of the timestep {'it meets' if len(best) == 1 else 'they meet'} the goal, too,"
            f" with at most {max(residuals):.2g} of the energy missing"
        )
    fresh = [each.fresh for each in best if each.fresh is not None]
    if fresh:
        worst = min(fresh, key=lambda each: each.share)
        said.append(f"of {worst.tried} fresh neighbours within the tolerances {_share(worst)} work")
    return "; ".join(said) or "statics alone was asked, and nothing was run"


def _share(of: Neighbours) -> str:
    low, high = of.interval
    return f"{100 * of.share:.3g} % ({100 * low:.3g} to {100 * high:.3g} %)"


def _discarded(found: Optimum) -> list[str]:
    if not found.discarded:
        return []
    coarse = sum(each.finer is not None and not each.finer.meets for each in found.discarded)
    said = []
    if coarse:
        said.append(f"{coarse} that looked better did not do it at a quarter of the timestep")
    if len(found.discarded) > coarse:
        said.append(f"{len(found.discarded) - coarse} that looked better had too few fresh neighbours that work")
    return ["; ".join(said)]


def _missing(found: Optimum) -> list[str]:
    """Which limits fail, by how much, and which would have to give."""
    goal, wanted = found.goal, wanted_share(found.goal)
    limits: list[Limit | None] = [*own_limits(goal)]
    said: list[str] = []
    meeting = [each for each in found.candidates if each.found.meets]
    named = [*limits, None] if goal.simulate else limits
    said += _not_built(found)
    if all(isinstance(each.found.design, str) for each in found.candidates):
        return said
    if not meeting:
        said += [_relaxed(found, each, named[each.limit]) for each in found.relaxations]
        said += _outcomes(found)
    elif wanted is not None and not found.discarded:
        asked = [each.neighbours for each in meeting if each.neighbours is not None]
        whole = [each for each in asked if each.tried == each.wanted] or asked
        best = max((each.share for each in whole), default=0.0)
        said += [
            f"{counted(len(meeting), 'design')} {'meets' if len(meeting) == 1 else 'meet'} all limits alone, but of the"
            f" neighbours at best {100 * best:.3g} % work, where"
            f" {show_quantity(wanted.bound, wanted.quantity.unit)} are wanted:"
            " widen the limits, tighten the tolerances, or want less"
        ]
    nearest = nearest_trial([trial_of(goal, each) for each in found.candidates])
    if nearest is not None:
        candidate = next(each for each in found.candidates if each.point == nearest.point)
        values = ", ".join(f"{key} = {value}" for key, value in candidate.values.items())
        said.append(f"nearest to it: {', '.join(value_texts(goal, candidate))}, with {values}")
    return said


def _not_built(found: Optimum) -> list[str]:
    """How many designs there are not, and the most frequent reason."""
    why = [each.found.design for each in found.candidates if isinstance(each.found.design, str)]
    if not why:
        return []
    (reason, _), *_ = Counter(why).most_common()
    return [f"{len(why)} of {counted(len(found.candidates), 'design')} cannot be built: {reason}"]


def _outcomes(found: Optimum) -> list[str]:
    """What those that were run and do not work mostly came to."""
    run = [each.found for each in found.candidates if isinstance(each.found.design, Design)]
    failed = Counter(str(each.row["outcome"]) for each in run if each.works <= 0 and "outcome" in each.row)
    if not failed:
        return []
    (outcome, number), *_ = failed.most_common()
    return [f"of {counted(failed.total(), 'run')} that did not work {number} ended with: {outcome}"]


def _relaxed(found: Optimum, relaxation: Relaxation, limit: Limit | None) -> str:
    name = "that it works" if limit is None else str(limit)
    if math.isnan(relaxation.best):
        return f"{name}: was never looked at, for something before it always failed"
    if relaxation.trial is None:
        best = "is met by some" if relaxation.best >= 0 else f"is missed by {_missed(relaxation.best)} at best"
        return f"{name}: {best}, and no design meets all the others"
    candidate = next(each for each in found.candidates if each.point == relaxation.trial.point)
    value = None if limit is None else candidate.value(limit.quantity)
    came = "" if limit is None or value is None else f", {show_quantity(value, limit.quantity.unit)}"
    missed = _missed(relaxation.alone)
    return f"{name}: where all others are met it is missed by {missed} at best{came}; it would have to give"


def _effort(found: Optimum) -> str:
    effort = found.effort
    said = [f"{counted(effort.tried, 'design')} tried"]
    if effort.simulated:
        said.append(f"{effort.runs} of them run")
        if effort.spared_runs:
            by = ", ".join(f"{count} by {source}" for source, count in effort.ruled_out.items())
            said.append(f"{effort.spared_runs} ruled out before any run ({by})")
    if effort.neighbour_runs or effort.spared_neighbours:
        said.append(f"{counted(effort.neighbour_runs, 'neighbour')} run, {effort.spared_neighbours} spared")
    if effort.verification_runs:
        said.append(f"{counted(effort.verification_runs, 'run')} to verify")
    return ", ".join(said)


def _missed(margin: float) -> str:
    """By how much a limit is missed: margins go no farther than a whole bound."""
    return "100 % or more" if margin <= -1 else f"{100 * -margin:.3g} %"


def bounded_text(goal: Goal, best: Candidate) -> str | None:
    """That a design lies at bounds of what may vary, in a sentence; None where it lies between all of them."""
    ends = [
        f"{parameter.key} at its {end}"
        for parameter, share in zip(goal.parameters, best.point, strict=True)
        if (end := _end(parameter, share))
    ]
    if not ends:
        return None
    return f"the best lies at the edge of what may vary, {' and '.join(ends)}: further on there may be better ones"


def _end(parameter: Parameter, share: float) -> str:
    """Which end of its range a share lies at; empty where at none, or where its values have no order."""
    if not parameter.ordered:
        return ""
    near = max(_NEAR, 1 / len(parameter.choices)) if parameter.choices else _NEAR
    return "lowest" if share < near else "highest" if share > 1 - near else ""


def only_fills(goal: Goal) -> int | None:
    """How many designs fill the space of a goal where it tries no more than these, and not all there are; else None."""
    axes = axes_of(goal)
    count = filling_count(axes, goal.batch)
    places = math.prod(axis.levels for axis in axes) or math.inf
    return count if goal.runs <= count and goal.runs < places else None


def filling_text(goal: Goal) -> str | None:
    """That a goal's designs only fill the space, in a sentence; None where they do more."""
    count = only_fills(goal)
    if count is None:
        return None
    designs = "its one design does" if goal.runs == 1 else f"its {goal.runs} designs do"
    return (
        f"{designs} no more than fill the space evenly: a search that learns from them begins after {count}"
        " (search.runs)"
    )
