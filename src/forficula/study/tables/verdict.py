"""Whether a timestep is fine, and how far times move with the membrane: in a sentence."""

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
    here: int,
    runs: Sequence[TimedRun],
    alike: Flags,
    labels: Sequence[str],
    times: Sequence[Array],
    fits: Sequence[OrderFit | None],
    tolerance: float,
) -> tuple[bool | None, str]:
    """Whether the design's own timestep is fine, and a sentence that says why.

    Fine means: it does not blow up, no shorter one ends otherwise, and no time differs by more than the tolerance from
    the limit h -> 0. Where the order cannot be told, that difference is known between two bounds: at most it is the
    largest of the distance from the limit with order 1, of the distances from the times at shorter timesteps, and of
    the scatter; at least, the smaller of the first and the distance from the time at the shortest timestep.
    """
    names = [value_text(TIMESTEP, float(step)) for step in steps]
    own, status = names[here], runs[here].status
    if runs[here].outcome.diverged:
        sound = [name for name, run in zip(names, runs, strict=True) if not run.outcome.diverged]
        remedy = f"at {sound[0]} it does not" if sound else "and so it does at all the others"
        return False, f"{own} is too long: it {status}; {remedy}."
    otherwise = [f'"{run.status}" at {name}' for name, run, same in zip(names, runs, alike, strict=True) if not same]
    changes = f'the outcome changes with the timestep: "{status}" at {own}, {", ".join(otherwise)}' if otherwise else ""
    if not alike[here:].all():
        return False, f"{own} is too long, or the design stands at a boundary: {changes}."
    after = f"; {changes}" if changes else ""
    known = [(name, each, fit) for name, each, fit in zip(labels, times, fits, strict=True) if fit is not None]
    if not known:
        return None, f'{own} cannot be judged: there are no two times to compare where "{status}"{after}.'
    errors = [_error(each, here, alike, fit) for _, each, fit in known]
    differs = " and ".join(
        f"the {name} differs by {_range(error)}" for (name, *_), error in zip(known, errors, strict=True)
    )
    untold = " and ".join(f"the {name} ({fit.reason})" for name, _, fit in known if not fit.observed)
    assumed = f"; no order can be told from {untold}, so {FORMAL_ORDER:g} is assumed" if untold else ""
    least, most = (max(ends) for ends in zip(*errors, strict=True))
    allowed = f"{differs} from the limit h -> 0 ({100 * tolerance:g} % allowed)"
    if most <= tolerance:
        return True, f"{own} is fine: {allowed}{assumed}{after}."
    if least <= tolerance:
        return None, f"{own} is on the edge: {allowed}; shorter timesteps may tell{assumed}{after}."
    remedy = _remedy(float(steps[here]), [error for _, error in errors], [fit for *_, fit in known], tolerance)
    return False, f"{own} is too long: {allowed}{remedy}{assumed}{after}."


def _error(times: Array, here: int, alike: Flags, fit: OrderFit) -> tuple[float, float]:
    """By how much of the limit the time at the design's own timestep is off, at least and at most."""
    distances = [abs(times[here] - fit.limit)]
    least = distances[0]
    if not fit.observed:
        finer = alike & (np.arange(len(times)) > here) & np.isfinite(times)
        distances += [*np.abs(times[finer] - times[here]), fit.scatter]
        least = min(least, abs(times[finer][-1] - times[here]) if finer.any() else 0.0)
    scale = abs(fit.limit)
    return (float(least / scale), float(max(distances) / scale)) if scale else (0.0, math.inf)


def _range(error: tuple[float, float]) -> str:
    least, most = (f"{100 * end:.3g}" for end in error)
    return f"{most} %" if least == most else f"{least} to {most} %"


def _remedy(own: float, errors: Sequence[float], fits: Sequence[OrderFit], tolerance: float) -> str:
    """The timestep at which the laws meet the tolerance."""
    if not all(fit.observed for fit in fits):
        return ""
    needed = min(own * (tolerance / error) ** (1 / fit.order) for error, fit in zip(errors, fits, strict=True))
    digit = 10.0 ** math.floor(math.log10(needed))
    return f"; {value_text(TIMESTEP, math.floor(needed / digit) * digit)} would do"


def judge_moves(
    names: Sequence[str],
    here: int,
    runs: Sequence[TimedRun],
    alike: Flags,
    labels: Sequence[str],
    times: Sequence[Array],
) -> str:
    """How far the times move with the membrane's stiffness or mesh, in a sentence."""
    parts = []
    for name, each in zip(labels, times, strict=True):
        known = np.flatnonzero(alike & np.isfinite(each)).tolist()
        if len(known) >= 2:
            moves = ", ".join(f"{100 * (each[i] / each[here] - 1):+.2g} % at {names[i]}" for i in known if i != here)
            parts.append(f"the {name} moves from {1e3 * each[here]:.3g} ms at {names[here]} by {moves}")
    if not parts:
        parts.append("there are no two times to compare")
    status = runs[here].status
    others = [f'"{run.status}" at {name}' for name, run, same in zip(names, runs, alike, strict=True) if not same]
    if others:
        parts.append(f'the outcome changes: "{status}" at {names[here]}, {", ".join(others)}')
    sentence = "; ".join(parts)
    return f"{sentence[0].upper()}{sentence[1:]}."
