"""Energy, fold time and torque margin of a structure over load cycles."""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable, Sequence
from typing import Any

from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Patch
from matplotlib.ticker import LogLocator, NullFormatter, StrMethodFormatter

from forficula.quantities import reading_unit
from forficula.show.style import (
    BLUE,
    GREEN,
    ORANGE,
    PAGE_WIDTH,
    PURPLE,
    VERMILION,
    describe,
    figure_style,
    fit_legend,
    in_column,
    is_narrow,
)
from forficula.structure import structure_of
from forficula.study.cycling import CycleRun, Cycling

_STYLES = ((BLUE, "-", "o"), (VERMILION, "--", "s"), (GREEN, ":", "^"), (PURPLE, "-.", "v"), (ORANGE, "-", "D"))
_MARKERS = ("o", "D", "s", "v")
_EXTRAPOLATED = "0.9"
_FAILED: dict[str, Any] = {"ls": "none", "marker": "x", "color": VERMILION, "ms": 4.5, "mew": 1.2}


def draw_cycling(cycling: Cycling, width: float = PAGE_WIDTH) -> Figure:
    """Draw the tendons' energy, the fold time and the margin over the number of cycles.

    Cycles beyond the tests of the material are shaded, and a line marks the first failure.

    Args:
        cycling: the analysis.
        width: width of the figure, inch.
    """
    with figure_style():
        narrow = is_narrow(width)
        figure = Figure(figsize=(width, 6.0 if narrow else 2.9), layout="constrained")
        energies, times, margins = figure.subplots(3, 1) if narrow else figure.subplots(1, 3, sharex=True)
        _draw_energies(energies, cycling)
        _draw_times(times, cycling)
        _draw_margins(margins, cycling)
        for axes in (energies, times, margins):
            _draw_counts(axes, cycling)
        fit_legend(figure, _handles(cycling), 6, loc="outside lower center")
        return describe(figure, _text(cycling))


def _states(cycling: Cycling) -> dict[str, tuple[str, str, str]]:
    """Return the states, each with colour, line and marker."""
    names = [state.name for state in structure_of(cycling.design).states]
    return dict(zip(names, itertools.cycle(_STYLES)))


def _reached(run: CycleRun, state: str) -> bool:
    """Return whether a run reached a state, not only the end of its stage; True for states without transition."""
    return bool(run.row.get(state, True))


def _values(runs: Sequence[CycleRun], value: Callable[[CycleRun], float | None]) -> list[float]:
    return [math.nan if (number := value(run)) is None else float(number) for run in runs]


def _energy(state: str) -> Callable[[CycleRun], float | None]:
    return lambda run: run.row.get(f"{state}_energy_J") if _reached(run, state) else None


def _margin(name: str) -> Callable[[CycleRun], float | None]:
    return lambda run: run.margins.get(name)


def _draw_energies(axes: Axes, cycling: Cycling) -> None:
    cycles = [run.cycle for run in cycling.runs]
    by_state = {state: _values(cycling.runs, _energy(state)) for state in _states(cycling)}
    largest = max((value for values in by_state.values() for value in values if math.isfinite(value)), default=0.0)
    unit, factor = reading_unit("J", largest or 1.0)
    for state, (colour, style, marker) in _states(cycling).items():
        # the first and the last state coincide if the structure opens again: the marker of the first is hollow
        first = (colour, style, marker) == _STYLES[0]
        face = "white" if first else colour
        scaled = [factor * item for item in by_state[state]]
        size = 5.5 if first else 3.2
        axes.plot(cycles, scaled, style, color=colour, marker=marker, mfc=face, markersize=size, linewidth=1.0)
    axes.set_ylabel(f"energy of the tendons ({unit})")
    axes.set_ylim(-0.05 * factor * (largest or 1.0), 1.1 * factor * (largest or 1.0))


def _draw_times(axes: Axes, cycling: Cycling) -> None:
    values = _values(cycling.runs, lambda run: run.row.get(f"{cycling.transitions[0].name}_time_s"))
    finite = [value for value in values if math.isfinite(value)]
    unit, factor = reading_unit("s", max(finite, default=1.0))
    _plot(axes, cycling, [factor * value for value in values])
    axes.set_ylabel(f"{cycling.transitions[0].wording.time} ({unit})")
    if finite:
        axes.set_ylim(0, 1.2 * factor * max(finite))


def _draw_margins(axes: Axes, cycling: Cycling) -> None:
    """Draw the margins of all transitions on one axis, each from the state before."""
    finite = [1.0]
    for transition, marker in zip(cycling.transitions, itertools.cycle(_MARKERS)):
        values = _values(cycling.runs, _margin(transition.name))
        finite += [value for value in values if math.isfinite(value)]
        _plot(axes, cycling, values, marker, transition.wording.doing)
    axes.axhline(1, color="black", linewidth=0.8, linestyle="--", zorder=1)
    axes.set_yscale("log")
    axes.set_ylim(min(finite) / 1.6, max(finite) * 2.5)
    axes.yaxis.set_major_locator(LogLocator(subs=(1.0, 2.0, 5.0)))
    axes.yaxis.set_major_formatter(StrMethodFormatter("{x:g}"))
    axes.yaxis.set_minor_formatter(NullFormatter())
    axes.set_ylabel(f"margin: torque{chr(10) if in_column(axes) else ' '}/ least slow torque")
    axes.text(0.03, 1.04, "least slow torque", transform=axes.get_yaxis_transform(), va="bottom", fontsize=6.5)
    if len(finite) > 1:
        axes.legend(loc="best")


def _plot(axes: Axes, cycling: Cycling, values: Sequence[float], marker: str = "o", label: str = "") -> None:
    cycles = [run.cycle for run in cycling.runs]
    axes.plot(cycles, values, "-", color="black", marker=marker, markersize=3.2, linewidth=1.0, label=label)


def _draw_counts(axes: Axes, cycling: Cycling) -> None:
    """Draw the axis of cycles, shade cycles that the tests did not cover, and mark failures."""
    last = cycling.runs[-1].cycle
    low, high = 0.85, max(last, 2) * 1.18
    axes.set_xscale("log")
    axes.set_xlim(low, high)
    axes.set_xlabel("cycle N")
    axes.xaxis.set_major_locator(LogLocator(subs=(1.0, 2.0, 5.0) if last < 1000 else (1.0,)))
    axes.xaxis.set_major_formatter(StrMethodFormatter("{x:.0f}"))
    axes.xaxis.set_minor_formatter(NullFormatter())
    seen = cycling.seen
    for start, end in ((low, seen[0]), (seen[1], high)) if seen is not None else ():
        if start < end and (start > low or end > 1):
            axes.axvspan(start, min(end, high), color=_EXTRAPOLATED, lw=0, zorder=0)
    if cycling.first_failure is not None:
        axes.axvline(cycling.first_failure, color=VERMILION, linewidth=1.0, linestyle="-.", zorder=1)
    failed = [run.cycle for run in cycling.runs if not cycling.works(run)]
    axes.plot(failed, [0.96] * len(failed), transform=axes.get_xaxis_transform(), **_FAILED)


def _handles(cycling: Cycling) -> list[Line2D | Patch]:
    handles: list[Line2D | Patch] = []
    for state, (colour, style, marker) in _states(cycling).items():
        if any(math.isfinite(value) for value in _values(cycling.runs, _energy(state))):
            face, size = ("white", 5.5) if (colour, style, marker) == _STYLES[0] else (colour, 3.2)
            line = Line2D([], [], color=colour, ls=style, marker=marker, mfc=face, ms=size, lw=1.0, label=state)
            handles.append(line)
    if cycling.seen is not None and not all(run.measured for run in cycling.runs):
        handles.append(Patch(color=_EXTRAPOLATED, lw=0, label="not covered by tests"))
    words = " and ".join(transition.wording.verb for transition in cycling.transitions)
    if cycling.first_failure is not None:
        label = f"first failure, cycle {cycling.first_failure}"
        handles.append(Line2D([], [], color=VERMILION, ls="-.", lw=1.0, label=label))
    if not all(cycling.works(run) for run in cycling.runs):
        handles.append(Line2D([], [], label=f"did not {words}", **_FAILED))
    return handles


def _text(cycling: Cycling) -> str:
    """Describe the analysis."""
    last = cycling.runs[-1].cycle
    time, name = cycling.transitions[0].wording.time, cycling.design.name
    what = f"Energy, {time} and torque margins of {name} over the cycles from 1 to {last}"
    return f"{what}. {cycling.verdict}"
