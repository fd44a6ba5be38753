"""Whether a design's timestep, membrane and mesh are fine enough: the same run at several values of one of them."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from forficula.analysis import measure
from forficula.design import Design, with_values
from forficula.design.design import MODULUS, SHORT_TIME
from forficula.dynamics import Record, StageEnd, WingModel, compile_wing, with_timestep
from forficula.dynamics.simulate import simulate_each
from forficula.errors import InputError
from forficula.quantities import as_written, parse_quantity, show_quantity
from forficula.study.observed_order import FORMAL_ORDER, OrderFit, fit_order

Array = NDArray[np.float64]
Progress = Callable[[str, float, float], None]

TIMESTEP = "protocol.timestep"
YOUNGS_MODULUS = "membrane.youngs_modulus"
MESH = "membrane.rows"
_UNITS = {TIMESTEP: SHORT_TIME, YOUNGS_MODULUS: MODULUS}
_FINEST_MESH = 50
_NAMES = ("fold time", "opening time")

_SAME = 1e-9
# Rows that a run keeps at most while its stages last: with more, a very short timestep would fill the memory.
_MOST_ROWS = 100_000

# a comma separates only before a space: "0,5" may be meant as a decimal
_NUMBER_THEN_UNIT = re.compile(
    r"([+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)\s*([^\W\d_][^\s,]*)?(?:\s*,(?=\s)|\s|$)\s*"
)


@dataclass(frozen=True, kw_only=True)
class Convergence:
    """One design at several values of one setting, from coarse to fine, soft to stiff.

    Attributes:
        design: what ran.
        key: `TIMESTEP`, `YOUNGS_MODULUS` or `MESH`.
        values: timesteps in s, moduli in Pa, or how many times finer the mesh is, (run,).
        own: the design's own among them.
        rows: of the membrane's mesh, by run.
        statuses: what each run came to, in a few words.
        fold_times: from the start of folding until the slowest hinge crosses the folded angle, s, nan where it did not
            fold, (run,).
        unfold_times: likewise until the last hinge has opened for good, s, (run,).
        times: of the rows of each run, s, (row,).
        angles: of the third distal hinge, folding negative, rad, (row,).
        fold_starts: when folding began, s, nan where it did not, (run,).
        unfold_starts: when unfolding began, s, nan where it did not, (run,).
        fold_order: how the fold time goes with the timestep; None for another key, or without two times to compare.
        unfold_order: likewise of the opening time.
        tolerance: largest allowed difference from the limit, as a share of it.
        fine: whether the design's own timestep is; None where that cannot be told, or for another key.
        verdict: in a sentence.
    """

    design: Design
    key: str
    values: Array
    own: float
    rows: tuple[int, ...]
    statuses: tuple[str, ...]
    fold_times: Array
    unfold_times: Array
    times: tuple[Array, ...]
    angles: tuple[Array, ...]
    fold_starts: Array
    unfold_starts: Array
    fold_order: OrderFit | None
    unfold_order: OrderFit | None
    tolerance: float
    fine: bool | None
    verdict: str


class _Kind(NamedTuple):
    """What must not change with a timestep."""

    folded: bool
    opened: bool
    diverged: bool


@dataclass(frozen=True, kw_only=True)
class _Run:
    """What is kept of a run."""

    status: str
    outcome: _Kind
    fold_time: float
    unfold_time: float
    fold_start: float
    unfold_start: float
    times: Array
    angle: Array


def converge(
    design: Design, key: str, values: Sequence[float], *, tolerance: float = 0.02, progress: Progress | None = None
) -> Convergence:
    """Run a design at several timesteps, membrane moduli or meshes and say what that changes.

    The design's own value is run, too, whether it is among the values or not.

    Args:
        design: what to run.
        key: `TIMESTEP`, `YOUNGS_MODULUS`, or `MESH`.
        values: two at least, in any order: s, Pa, or whole numbers by which the spacing of the mesh's rows is divided.
        tolerance: by how much of its limit a time may be off at a timestep that is fine.
        progress: as `forficula.dynamics.run` takes it.

    Raises:
        InputError: another key, fewer than two values, one of them twice, or one that the design cannot have.
    """
    if key not in (TIMESTEP, YOUNGS_MODULUS, MESH):
        raise InputError(f"key: need {TIMESTEP}, {YOUNGS_MODULUS} or {MESH}, got {as_written(key)}")
    _check_values(key, values)
    own = _own_value(design, key)
    # a timestep goes from coarse to fine, the others from soft or coarse on
    ordered = sorted([own, *(value for value in values if not _same(value, own))], reverse=key == TIMESTEP)
    wings = [compile_wing(_with_dense_record(with_timestep(_with_value(design, key, value)))) for value in ordered]
    return replace(compare_wings(wings, key, ordered, own, tolerance=tolerance, progress=progress), design=design)


def compare_wings(
    wings: Sequence[WingModel],
    key: str,
    values: Sequence[float],
    own: float,
    *,
    tolerance: float = 0.02,
    progress: Progress | None = None,
) -> Convergence:
    """Do as `converge` does with compiled wings, one for each value, in the order of the values."""
    runs, rows = _run_all(wings, progress), tuple(_row_count(wing.design) for wing in wings)
    here = list(values).index(own)
    fold_times, unfold_times, fold_starts, unfold_starts = (
        np.array([getattr(run, name) for run in runs])
        for name in ("fold_time", "unfold_time", "fold_start", "unfold_start")
    )
    steps, alike = np.array(values, dtype=float), np.array([run.outcome == runs[here].outcome for run in runs])
    fits: list[OrderFit | None] = [None, None]
    fine: bool | None = None
    if key == TIMESTEP:
        fits = [_fit_where_known(steps, times, alike) for times in (fold_times, unfold_times)]
        fine, verdict = _judge_timestep(steps, here, runs, alike, (fold_times, unfold_times), fits, tolerance)
    else:
        names = [f"{rows[i]} rows" if key == MESH else value_text(key, value) for i, value in enumerate(values)]
        verdict = _judge_moves(names, here, runs, alike, (fold_times, unfold_times))
    return Convergence(
        design=wings[here].design,
        key=key,
        values=steps,
        own=own,
        rows=rows,
        statuses=tuple(run.status for run in runs),
        fold_times=fold_times,
        unfold_times=unfold_times,
        times=tuple(run.times for run in runs),
        angles=tuple(run.angle for run in runs),
        fold_starts=fold_starts,
        unfold_starts=unfold_starts,
        fold_order=fits[0],
        unfold_order=fits[1],
        tolerance=tolerance,
        fine=fine,
        verdict=verdict,
    )


def read_values(key: str, text: str) -> list[float]:
    """Read values such as "0.5 0.4 ms", or "0.5 ms, 0.4 ms": a number without a unit has that of the next one.

    Args:
        key: `TIMESTEP`, `YOUNGS_MODULUS`, or `MESH`, whose values are whole numbers without a unit.
        text: what the user wrote.

    Returns:
        The values in their order: s, Pa, or numbers.

    Raises:
        InputError: something that is no such list; the caller knows the option.
    """
    unit = _UNITS.get(key)
    right = f'such as "{_example(key)}"'
    items: list[tuple[str, str]] = []
    place, stripped = 0, text.strip()
    while place < len(stripped):
        match = _NUMBER_THEN_UNIT.match(stripped, place)
        if match is None:
            raise InputError(f"need numbers with spaces between {right}, got {as_written(text)}")
        items.append((match[1], match[2] or ""))
        place = match.end()
    following, values = "", []
    for number, written in reversed(items):
        following = written or following
        try:
            values.append(parse_quantity(f"{number} {following}", unit) if unit else _whole(number, following))
        except InputError as error:
            raise InputError(f"{error} in {as_written(text)}") from None
    values.reverse()
    _check_values(key, values)
    return values


def value_text(key: str, value: float) -> str:
    """A value as people write it, such as "0.2 ms"."""
    unit = _UNITS.get(key)
    return show_quantity(value, unit) if unit else f"{value:g}"


def _example(key: str) -> str:
    return {TIMESTEP: "0.4 0.2 0.1 ms", YOUNGS_MODULUS: "0.5 1 2 MPa", MESH: "1 2 3"}[key]


def _whole(number: str, unit: str) -> float:
    if unit or not number.isdigit():
        raise InputError(f"need whole numbers, got {as_written(f'{number} {unit}'.strip())}")
    return float(number)


def _check_values(key: str, values: Sequence[float]) -> None:
    right = f'such as "{_example(key)}"'
    if len(values) < 2:
        raise InputError(f"need two values at least {right}, got {len(values)}")
    for value in values:
        shown = value_text(key, value)
        if not 0 < value < math.inf:
            raise InputError(f"need values > 0 {right}, got {shown}")
        if (times := sum(_same(value, other) for other in values)) > 1:
            raise InputError(f"need values that differ, got {shown} {times} times")
        if key == MESH and not (value == int(value) and value <= _FINEST_MESH):
            raise InputError(f"need whole numbers from 1 to {_FINEST_MESH}, got {shown}")


def _same(one: float, other: float) -> bool:
    """Whether two values are one, written in different units."""
    return math.isclose(one, other, rel_tol=_SAME)


def _own_value(design: Design, key: str) -> float:
    match key:
        case "protocol.timestep":
            return float(with_timestep(design).protocol.timestep)
        case "membrane.youngs_modulus":
            return design.membrane.youngs_modulus
        case _:
            return 1.0


def _with_value(design: Design, key: str, value: float) -> Design:
    if key != MESH:
        return with_values(design, {key: value})
    times = int(value)
    proximal = _divided((*design.membrane.proximal_rows, 1.0), times)
    distal = _divided((0.0, *design.membrane.distal_rows, 1.0), times)[1:]
    return with_values(design, {"membrane.proximal_rows": proximal, "membrane.distal_rows": distal})


def _divided(shares: Sequence[float], times: int) -> list[float]:
    """Shares with each gap divided evenly, without the last share, which the mesh has anyway."""
    return [float(share) for low, high in pairwise(shares) for share in np.linspace(low, high, times, endpoint=False)]


def _row_count(design: Design) -> int:
    """Rows of the mesh, that at the ring fold and that at the tip among them."""
    return len(design.membrane.proximal_rows) + len(design.membrane.distal_rows) + 2


def _with_dense_record(design: Design) -> Design:
    """Keep every step, or as many as fit, so that a crossing can be found between two of them."""
    timestep = float(design.protocol.timestep)
    steps = sum(stage.time_limit for stage in design.protocol.stages) / timestep
    return with_values(design, {"protocol.sample_interval": timestep * max(1, math.ceil(steps / _MOST_ROWS))})


def _run_all(wings: Sequence[WingModel], progress: Progress | None) -> list[_Run]:
    """Run all wings, those of one topology side by side, and keep of each record only what is needed."""
    topologies: dict[int, list[int]] = {}
    for index, wing in enumerate(wings):
        topologies.setdefault(len(wing.membrane.nodes), []).append(index)
    runs: dict[int, _Run] = {}
    for members in topologies.values():
        for row, record in simulate_each([wings[index] for index in members], progress=progress):
            runs[members[row]] = _kept(record)
    return [runs[index] for index in range(len(wings))]


def _kept(record: Record) -> _Run:
    outcome, protocol = measure(record), record.design.protocol
    angle = record.series["distal_angle"]
    # both fall through 0 when the goal is reached
    to_fold, to_open = angle.max(axis=1) + protocol.folded_angle, protocol.opened_angle - angle.min(axis=1)
    starts = {end.stage.drive: end for end in record.stages}
    return _Run(
        status=outcome.status,
        outcome=_Kind(outcome.folded, outcome.opened, record.diverged_at is not None),
        fold_time=_crossing(record, starts.get("fold"), to_fold) if outcome.folded else math.nan,
        unfold_time=_crossing(record, starts.get("unfold"), to_open) if outcome.opened else math.nan,
        fold_start=starts["fold"].start if "fold" in starts else math.nan,
        unfold_start=starts["unfold"].start if "unfold" in starts else math.nan,
        times=record.time,
        angle=angle[:, min(2, angle.shape[1] - 1)].copy(),
    )


def _crossing(record: Record, end: StageEnd | None, distance: Array) -> float:
    """Time from the start of a stage until its goal was reached, s, between the two steps about it.

    The goal's own time is a multiple of the step: that alone would make an error of order 1, whatever the integrator's.
    Semi-implicit Euler's velocity is constant over a step, so that its angles do go straight in between.

    Args:
        record: with every step, or nearly so.
        end: the stage.
        distance: from the goal, (row,), <= 0 where reached.
    """
    if end is None or end.goal_time is None:
        return math.nan
    timestep = float(record.design.protocol.timestep)
    # half a step, for times are multiples of it up to rounding
    after = int(np.searchsorted(record.time, end.goal_time - timestep / 2))
    left, right = distance[after - 1], distance[after]
    share = left / (left - right) if left > 0 >= right else float(right > 0)
    moment = record.time[after - 1] + share * (record.time[after] - record.time[after - 1])
    return float(np.clip(moment, end.goal_time - timestep, end.goal_time)) - end.start


def _fit_where_known(steps: Array, times: Array, alike: NDArray[np.bool_]) -> OrderFit | None:
    """A fit over the runs that ended as the design's own does and have a time; None without two of them."""
    known = alike & np.isfinite(times)
    return fit_order(steps[known], times[known]) if known.sum() >= 2 else None


def _judge_timestep(
    steps: Array,
    here: int,
    runs: Sequence[_Run],
    alike: NDArray[np.bool_],
    times: tuple[Array, Array],
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
        return False, f"{own} is too long: the wing {status}; {remedy}."
    otherwise = [f'"{run.status}" at {name}' for name, run, same in zip(names, runs, alike, strict=True) if not same]
    changes = f'the outcome changes with the timestep: "{status}" at {own}, {", ".join(otherwise)}' if otherwise else ""
    if not alike[here:].all():
        return False, f"{own} is too long, or the design stands at a boundary: {changes}."
    after = f"; {changes}" if changes else ""
    known = [(name, each, fit) for name, each, fit in zip(_NAMES, times, fits, strict=True) if fit is not None]
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


def _error(times: Array, here: int, alike: NDArray[np.bool_], fit: OrderFit) -> tuple[float, float]:
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


def _judge_moves(
    names: Sequence[str], here: int, runs: Sequence[_Run], alike: NDArray[np.bool_], times: tuple[Array, Array]
) -> str:
    """How far the times move with the membrane's stiffness or mesh, in a sentence."""
    parts = []
    for name, each in zip(_NAMES, times, strict=True):
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
