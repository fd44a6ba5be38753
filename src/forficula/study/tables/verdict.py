"""Conclusions of convergence studies: is the timestep short enough; how do times change with the membrane?"""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from forficula.arrays import Array, Flags
from forficula.study.convergence.observed_order import FORMAL_ORDER, OrderFit
from forficula.study.convergence.refinement import TIMESTEP, value_text
from forficula.study.running.timed_run import TimedRun


def judge_timestep(
    steps: Array,
    own_index: int,
    runs: Sequence[TimedRun],
    alike: Flags,
    labels: Sequence[str],
    times: Sequence[Array],
    fits: Sequence[OrderFit | None],
    tolerance: float,
) -> tuple[bool | None, str]:
    """Decide whether the design's own timestep is short enough, and return a sentence with the reason.

    It is if its run does not diverge, no shorter one ends differently, and no time deviates from the limit h -> 0 by
    more than the tolerance. If the order cannot be observed, only bounds of this deviation are known. The upper bound
    is the largest of the distance from the limit with order 1, the distances from the times at shorter timesteps, and
    the scatter. The lower bound is the smaller of the first of these and the distance from the time at the shortest
    timestep.
    """
    names = [value_text(TIMESTEP, float(step)) for step in steps]
    present, status = names[own_index], runs[own_index].status
    if runs[own_index].outcome.diverged:
        sound = [name for name, run in zip(names, runs, strict=True) if not run.outcome.diverged]
        remedy = f"the run at {sound[0]} does not diverge" if sound else "all other runs diverge, too"
        return False, f"{present} is too long: the run {status}; {remedy}."
    otherwise = [f'"{run.status}" at {name}' for name, run, same in zip(names, runs, alike, strict=True) if not same]
    changes = (
        f'the outcome changes with the timestep: "{status}" at {present}, {", ".join(otherwise)}' if otherwise else ""
    )
    if not alike[own_index:].all():
        return False, f"{present} is too long, or the design lies on a boundary between outcomes: {changes}."
    after = f"; {changes}" if changes else ""
    known = [
        (name, transition_times, fit)
        for name, transition_times, fit in zip(labels, times, fits, strict=True)
        if fit is not None
    ]
    if not known:
        return None, f'{present} cannot be judged: there are no two times to compare among runs with "{status}"{after}.'
    errors = [_error(transition_times, own_index, alike, fit) for _, transition_times, fit in known]
    differs = " and ".join(
        f"the {name} differs by {_range(error)}" for (name, *_), error in zip(known, errors, strict=True)
    )
    unobserved = " and ".join(f"the {name} ({fit.reason})" for name, _, fit in known if not fit.observed)
    assumed = f"; no order is observed for {unobserved}, so order {FORMAL_ORDER:g} is assumed" if unobserved else ""
    least, most = (max(ends) for ends in zip(*errors, strict=True))
    allowed = f"{differs} from the limit h -> 0 ({100 * tolerance:g} % allowed)"
    if most <= tolerance:
        return True, f"{present} is short enough: {allowed}{assumed}{after}."
    if least <= tolerance:
        return None, f"{present} is borderline: {allowed}; shorter timesteps may decide{assumed}{after}."
    remedy = _remedy(float(steps[own_index]), [error for _, error in errors], [fit for *_, fit in known], tolerance)
    return False, f"{present} is too long: {allowed}{remedy}{assumed}{after}."


def _error(times: Array, own_index: int, alike: Flags, fit: OrderFit) -> tuple[float, float]:
    """Return bounds of the relative deviation of the time at the design's own timestep from the limit."""
    distances = [abs(times[own_index] - fit.limit)]
    least = distances[0]
    if not fit.observed:
        finer = alike & (np.arange(len(times)) > own_index) & np.isfinite(times)
        distances += [*np.abs(times[finer] - times[own_index]), fit.scatter]
        least = min(least, abs(times[finer][-1] - times[own_index]) if finer.any() else 0.0)
    scale = abs(fit.limit)
    return (float(least / scale), float(max(distances) / scale)) if scale else (0.0, math.inf)


def _range(error: tuple[float, float]) -> str:
    least, most = (f"{100 * end:.3g}" for end in error)
    return f"{most} %" if least == most else f"{least} to {most} %"


def _remedy(present: float, errors: Sequence[float], fits: Sequence[OrderFit], tolerance: float) -> str:
    """Return a text with the timestep at which the laws meet the tolerance."""
    if not all(fit.observed for fit in fits):
        return ""
    needed = min(present * (tolerance / error) ** (1 / fit.order) for error, fit in zip(errors, fits, strict=True))
    digit = 10.0 ** math.floor(math.log10(needed))
    return f"; {value_text(TIMESTEP, math.floor(needed / digit) * digit)} would be short enough"


def judge_moves(
    names: Sequence[str],
    own_index: int,
    runs: Sequence[TimedRun],
    alike: Flags,
    labels: Sequence[str],
    times: Sequence[Array],
) -> str:
    """Return a sentence on the change of times with the membrane's stiffness or mesh."""
    parts = []
    for name, values in zip(labels, times, strict=True):
        known = np.flatnonzero(alike & np.isfinite(values)).tolist()
        if len(known) >= 2:
            changes = ", ".join(
                f"{100 * (values[i] / values[own_index] - 1):+.2g} % at {names[i]}" for i in known if i != own_index
            )
            own_value = f"{1e3 * values[own_index]:.3g} ms at {names[own_index]}"
            parts.append(f"the {name} is {own_value} and changes by {changes}")
    if not parts:
        parts.append("there are no two times to compare")
    status = runs[own_index].status
    others = [f'"{run.status}" at {name}' for name, run, same in zip(names, runs, alike, strict=True) if not same]
    if others:
        parts.append(f'the outcome changes: "{status}" at {names[own_index]}, {", ".join(others)}')
    sentence = "; ".join(parts)
    return f"{sentence[0].upper()}{sentence[1:]}."
