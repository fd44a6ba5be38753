"""Conclusions of a search in sentences."""

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
from forficula.names import counted, listed
from forficula.quantities import show_quantity
from forficula.structure import structure_of

# distance from a bound, as a fraction of the range, within which a value counts as at the bound
_NEAR = 1e-3


def summary_sentences(result: Optimum) -> list[str]:
    """Return the conclusions, the effort, and, if no design meets the goal, what would have to be relaxed."""
    sentences = [_answer(result)]
    if result.best:
        sentences += [_verified(result.best)]
        edge = bounded_text(result.goal, result.best[0].candidate) if len(result.goal.objectives) == 1 else None
        sentences += [] if edge is None else [edge]
        sentences += _without_friction(result.goal, result.best[0].candidate)
    sentences += _discarded(result)
    if not result.best:
        sentences += _missing(result)
    filled = filling_text(result.goal)
    return [*sentences, _effort(result), *([] if filled is None else [filled])]


def _without_friction(goal: Goal, best: Candidate) -> list[str]:
    """Return which quantities of statics ignore which friction of the best design."""
    structure = structure_of(goal.base if isinstance(best.screened.design, str) else best.screened.design)
    names = [quantity.name for quantity in goal.quantities if quantity.source in ("hinges", "fold", "slow")]
    ignored = {
        "the dry friction of hinges": any(hinge.friction for hinge in structure.hinges),
        "friction on the table": structure.table is not None and structure.table.friction > 0,
        "the friction of contact": structure.contact is not None and structure.contact.friction > 0,
    }
    frictions = [name for name, exists in ignored.items() if exists]
    if not names or not frictions:
        return []
    return [f"statics computes {listed(names)} without {listed(frictions)}, which holds states more firmly"]


def value_texts(goal: Goal, candidate: Candidate) -> list[str]:
    """Return texts with the quantities of a goal for a candidate."""
    texts = []
    for quantity in goal.quantities:
        value = candidate.value(quantity)
        shown = "unknown" if value is None else show_quantity(value, quantity.unit)
        texts.append(f"{quantity.name} {shown}")
    return texts


def _answer(result: Optimum) -> str:
    goal, count = result.goal, result.effort.tried
    objectives = " and ".join(f"the {objective.kind} {objective.quantity.name}" for objective in goal.objectives)
    if not result.best:
        what = "passes verification" if result.discarded else "meets every limit"
        return f"none of {counted(count, 'design')} {what}"
    if len(goal.objectives) > 1:
        return f"{counted(len(result.best), 'design')} on the Pareto front of {objectives}, of {count} that were tried"
    best = result.best[0].candidate
    values = ", ".join(f"{key} = {value}" for key, value in best.values.items())
    return f"{objectives} of {counted(count, 'design')}: {', '.join(value_texts(goal, best))}, with {values}"


def _verified(best: tuple[Verification, ...]) -> str:
    sentences = []
    residuals = [verification.residual for verification in best if verification.residual is not None]
    if residuals:
        sentences.append(
            f"at a quarter of the timestep {'it meets' if len(best) == 1 else 'they meet'} the goal, too,"
            f" and the energy residual is at most {max(residuals):.2g}"
        )
    fresh = [verification.fresh for verification in best if verification.fresh is not None]
    if fresh:
        worst = min(fresh, key=lambda neighbours: neighbours.share)
        sentences.append(f"of {worst.tried} new random variants within the tolerances, {_share(worst)} work")
    return "; ".join(sentences) or "only statics was computed, nothing was simulated"


def _share(neighbours: Neighbours) -> str:
    low, high = neighbours.interval
    return f"{100 * neighbours.share:.3g} % ({100 * low:.3g} to {100 * high:.3g} %)"


def _discarded(result: Optimum) -> list[str]:
    if not result.discarded:
        return []
    coarse = sum(verification.finer is not None and not verification.finer.meets for verification in result.discarded)
    sentences = []
    if coarse:
        sentences.append(f"{counted(coarse, 'better design')} failed at a quarter of the timestep")
    if len(result.discarded) > coarse:
        count = counted(len(result.discarded) - coarse, "better design")
        sentences.append(f"{count} had too few new variants within the tolerances that work")
    return ["; ".join(sentences)]


def _missing(result: Optimum) -> list[str]:
    """Return which limits are missed, by how much, and which would have to be relaxed."""
    goal, wanted = result.goal, wanted_share(result.goal)
    limits: list[Limit | None] = [*own_limits(goal)]
    sentences: list[str] = []
    meeting = [candidate for candidate in result.candidates if candidate.screened.meets]
    named = [*limits, None] if goal.simulate else limits
    sentences += _not_built(result)
    if all(isinstance(candidate.screened.design, str) for candidate in result.candidates):
        return sentences
    if not meeting:
        sentences += [_relaxed(result, relaxation, named[relaxation.limit]) for relaxation in result.relaxations]
        sentences += _outcomes(result)
    elif wanted is not None and not result.discarded:
        evaluated = [candidate.neighbours for candidate in meeting if candidate.neighbours is not None]
        complete = [neighbours for neighbours in evaluated if neighbours.tried == neighbours.wanted] or evaluated
        best = max((neighbours.share for neighbours in complete), default=0.0)
        sentences += [
            f"{counted(len(meeting), 'design')} {'meets' if len(meeting) == 1 else 'meet'} all other limits, but at"
            f" most {100 * best:.3g} % of the variants within the tolerances work, and"
            f" {show_quantity(wanted.bound, wanted.quantity.unit)} are required:"
            " widen the limits, tighten the tolerances, or require less"
        ]
    nearest = nearest_trial([trial_of(goal, candidate) for candidate in result.candidates])
    if nearest is not None:
        candidate = next(candidate for candidate in result.candidates if candidate.point == nearest.point)
        values = ", ".join(f"{key} = {value}" for key, value in candidate.values.items())
        sentences.append(f"closest design: {', '.join(value_texts(goal, candidate))}, with {values}")
    return sentences


def _not_built(result: Optimum) -> list[str]:
    """Return how many designs cannot be built, and the most frequent reason."""
    why = [candidate.screened.design for candidate in result.candidates if isinstance(candidate.screened.design, str)]
    if not why:
        return []
    (reason, _), *_ = Counter(why).most_common()
    return [f"{len(why)} of {counted(len(result.candidates), 'design')} cannot be built: {reason}"]


def _outcomes(result: Optimum) -> list[str]:
    """Return the most frequent outcome of the runs that failed."""
    run = [candidate.screened for candidate in result.candidates if isinstance(candidate.screened.design, Design)]
    failed = Counter(
        str(screened.row["outcome"]) for screened in run if screened.works <= 0 and "outcome" in screened.row
    )
    if not failed:
        return []
    (outcome, number), *_ = failed.most_common()
    return [f"of {counted(failed.total(), 'run')} that failed, {number} ended with: {outcome}"]


def _relaxed(result: Optimum, relaxation: Relaxation, limit: Limit | None) -> str:
    name = "success of the protocol" if limit is None else str(limit)
    if math.isnan(relaxation.best):
        return f"{name}: was never computed, because every design misses an earlier limit"
    if relaxation.trial is None:
        best = (
            "some designs meet it"
            if relaxation.best >= 0
            else f"all designs miss it by {_missed(relaxation.best)} or more"
        )
        return f"{name}: {best}, and no design meets all other limits"
    candidate = next(candidate for candidate in result.candidates if candidate.point == relaxation.trial.point)
    value = None if limit is None else candidate.value(limit.quantity)
    reached = "" if limit is None or value is None else f" ({show_quantity(value, limit.quantity.unit)})"
    missed = _missed(relaxation.alone)
    return (
        f"{name}: of the designs that meet all other limits, the best misses it by {missed}{reached};"
        " this requirement would have to be relaxed"
    )


def _effort(result: Optimum) -> str:
    effort = result.effort
    sentences = [f"{counted(effort.tried, 'design')} tried"]
    if effort.simulated:
        sentences.append(f"{effort.runs} of them run")
        if effort.spared_runs:
            by = ", ".join(f"{count} by {source}" for source, count in effort.ruled_out.items())
            sentences.append(f"{effort.spared_runs} ruled out before any run ({by})")
    if effort.neighbour_runs or effort.spared_neighbours:
        sentences.append(f"{counted(effort.neighbour_runs, 'variant')} run, {effort.spared_neighbours} skipped")
    if effort.verification_runs:
        sentences.append(f"{counted(effort.verification_runs, 'run')} for verification")
    return ", ".join(sentences)


def _missed(margin: float) -> str:
    """Return by how much a limit is missed; margins end at one whole bound."""
    return "100 % or more" if margin <= -1 else f"{100 * -margin:.3g} %"


def bounded_text(goal: Goal, best: Candidate) -> str | None:
    """Return a sentence if a design lies at bounds of its parameters; None if it lies between all of them."""
    ends = [
        f"{parameter.key} at its {end}"
        for parameter, share in zip(goal.parameters, best.point, strict=True)
        if (end := _end(parameter, share))
    ]
    if not ends:
        return None
    return f"the best design lies at bounds of its parameters ({' and '.join(ends)}): better designs may lie beyond"


def _end(parameter: Parameter, share: float) -> str:
    """Return the end of its range at which a parameter lies; empty if at none, or if its values have no order."""
    if not parameter.ordered:
        return ""
    near = max(_NEAR, 1 / len(parameter.choices)) if parameter.choices else _NEAR
    return "lowest" if share < near else "highest" if share > 1 - near else ""


def only_fills(goal: Goal) -> int | None:
    """Return the number of space-filling designs if a goal tries no more than these and more exist; else None."""
    axes = axes_of(goal)
    count = filling_count(axes, goal.batch)
    places = math.prod(axis.levels for axis in axes) or math.inf
    return count if goal.runs <= count and goal.runs < places else None


def filling_text(goal: Goal) -> str | None:
    """Return a sentence if a goal's designs only fill the space; else None."""
    count = only_fills(goal)
    if count is None:
        return None
    designs = "the only design fills" if goal.runs == 1 else f"all {goal.runs} designs only fill"
    return f"{designs} the space evenly: the search begins to use results after {count} designs (search.runs)"
