"""Figures of a convergence study: an angle over time, and times over the varied value."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator

from forficula.arrays import Array
from forficula.names import ordinal
from forficula.show.run.time_axes import stacked_axes
from forficula.show.study.convergence_table import order_text, time_labels
from forficula.show.style import (
    BLUE,
    LINE_STYLES,
    PAGE_WIDTH,
    QUANTITY_COLOURS,
    VERMILION,
    describe,
    figure_style,
    fit_legend,
    is_narrow,
    letter_panels,
)
from forficula.structure import Measure, Structure, measure_stops, structure_of
from forficula.study.convergence.convergence import Convergence
from forficula.study.convergence.observed_order import OrderFit
from forficula.study.convergence.refinement import MESH, TIMESTEP, YOUNGS_MODULUS, value_text

_AXIS = {
    TIMESTEP: ("timestep (ms)", 1e3),
    YOUNGS_MODULUS: ("Young's modulus (MPa)", 1e-6),
    MESH: ("rows of the mesh", 1),
}
# time shown before and after the start of a transition, as a multiple of its longest time
_BEFORE, _AFTER = 0.15, 1.6


def draw_convergence_angles(convergence: Convergence, width: float = PAGE_WIDTH) -> Figure:
    """Draw an angle over time for every value: the whole run, and its transitions enlarged.

    As in Binder et al. 2025, Figure 6C. A transition begins when the state before it is at rest, which takes longer in
    some runs than in others, so enlarged parts count time from the start of their stage.

    Args:
        convergence: the study.
        width: width of the figure, inch.
    """
    structure = structure_of(convergence.design)
    spans = [
        (transition.wording.noun, convergence.starts[transition.name], convergence.transition_times[transition.name])
        for transition in structure.transitions
        if np.isfinite(convergence.transition_times[transition.name]).any()
    ]
    measure = structure.measures[0]
    which = f"{ordinal(convergence.hinge)} {measure.label}"
    low, high = _range(structure, measure, convergence)
    with figure_style():
        narrow = is_narrow(width)
        figure = Figure(figsize=(width, 4.2 if narrow else 2.7), layout="constrained")
        if narrow:
            whole, *close = stacked_axes(figure, 1, len(spans))[0]
        else:
            ratios = [1.5] + [1.0] * len(spans)
            whole, *close = figure.subplots(1, len(ratios), sharey=True, squeeze=False, width_ratios=ratios)[0]
        _plot_angles(whole, convergence, np.zeros(len(convergence.values)), 1.0)
        whole.set_xlim(0, max(float(times[-1]) for times in convergence.times))
        whole.set_xlabel("time (s)")
        whole.set_title("whole run")
        whole.set_ylabel(f"{which} (deg)")
        whole.set_ylim(low, high)
        whole.yaxis.set_major_locator(MaxNLocator(6, steps=[1, 1.5, 3, 4.5, 9, 10]))
        for axes, (name, starts, times) in zip(close, spans, strict=True):
            _plot_angles(axes, convergence, starts, 1e3)
            axes.set_xlim(*(1e3 * np.nanmax(times) * np.array([-_BEFORE, _AFTER])))
            axes.set_xlabel("since its start (ms)" if narrow else "time since its start (ms)")
            axes.set_title(name)
        letter_panels([whole, *close])
        lines = whole.get_legend_handles_labels()[0]
        label_of_values = _AXIS[convergence.key][0].partition(" (")[0]
        if narrow:
            fit_legend(figure, lines, 3, loc="outside upper center", title=label_of_values, title_fontsize=7)
        else:
            figure.legend(handles=lines, loc="outside right upper", title=label_of_values, title_fontsize=7)
        runs = f"in {len(convergence.values)} runs of {convergence.design.name}"
        return describe(figure, f"{which.capitalize()} over time {runs}. {_text(convergence)}")


def draw_convergence_times(convergence: Convergence, width: float = PAGE_WIDTH) -> Figure:
    """Draw the times of transitions over the values, with the fit towards h -> 0 if there is one; width in inch."""
    with figure_style():
        narrow = is_narrow(width)
        figure = Figure(figsize=(width, 4.2 if narrow else 2.5), layout="constrained")
        label, factor = _AXIS[convergence.key]
        labels = time_labels(convergence)
        places = factor * _positions(convergence)
        shape = (len(labels), 1) if narrow else (1, len(labels))
        panels = figure.subplots(*shape, squeeze=False).ravel().tolist()
        for axes, name, times, fit in zip(
            panels,
            labels.values(),
            convergence.transition_times.values(),
            convergence.orders.values(),
            strict=True,
        ):
            style = "o" if fit is not None else "o-"
            axes.plot(places, 1e3 * times, style, color=BLUE, ms=5, lw=0.8, label="simulated", zorder=3)
            known = np.isfinite(times)
            at_design = (convergence.values == convergence.design_value) & known
            look: dict[str, Any] = {"mfc": "none", "mec": "black", "ms": 10, "ls": "none"}
            axes.plot(places[at_design], 1e3 * times[at_design], "o", label="design value", **look)
            if fit is not None:
                _plot_law(axes, fit, convergence, factor)
            if not known.any():
                axes.text(0.5, 0.5, "none", ha="center", va="center", transform=axes.transAxes)
            elif not known.all():
                foot = axes.get_xaxis_transform()
                at = np.full(int((~known).sum()), 0.04)
                axes.plot(places[~known], at, "x", color="0.35", transform=foot, label="no reliable time")
            axes.set_xlabel(label)
            axes.set_ylabel(f"{name} (ms)")
            if convergence.key == YOUNGS_MODULUS:
                axes.set_xscale("log")
                axes.set_xticks(places, [f"{place:.3g}" for place in places])
                axes.minorticks_off()
            elif convergence.key == MESH:
                axes.set_xticks(places)
        letter_panels(panels)
        # the order of a law may differ from panel to panel
        handles = {handle.get_label(): handle for axes in panels for handle in axes.get_legend_handles_labels()[0]}
        fit_legend(figure, list(handles.values()), 3 if narrow else 5, loc="outside lower center")
        names = " and ".join(text.removesuffix(" time") for text in labels.values())
        what = f"{names} times of {convergence.design.name} over the {label.partition(' (')[0]}"
        return describe(figure, f"{what[:1].upper()}{what[1:]}. {_text(convergence)}")


def _text(convergence: Convergence) -> str:
    """Describe the times and the verdict."""
    rows = [
        f"{_name(convergence, index)}: "
        + ", ".join(
            f"{label.removesuffix(' time')} {_time(float(convergence.transition_times[name][index]))}"
            for name, label in time_labels(convergence).items()
        )
        for index in range(len(convergence.values))
    ]
    return f"{'; '.join(rows)}. {convergence.verdict}"


def _range(structure: Structure, measure: Measure, convergence: Convergence) -> tuple[float, float]:
    """Return the range of the shown hinge, deg: that of its angles, within 20 deg of its stops."""
    angles = [np.degrees(angle[np.isfinite(angle)]) for angle in convergence.angles]
    low = min(float(angle.min(initial=0.0)) for angle in angles)
    high = max(float(angle.max(initial=0.0)) for angle in angles)
    room = 0.1 * ((high - low) or 1.0)
    first, last = (math.degrees(stop) for stop in measure_stops(structure, measure)[convergence.hinge])
    # the angles of a run that diverges are meaningless; without stops the bounds are infinite
    return max(low - room, first - 20), min(high + room, last + 20)


def _time(time: float) -> str:
    return f"{1e3 * time:.4g} ms" if math.isfinite(time) else "none"


def _name(convergence: Convergence, index: int) -> str:
    """Return the value of a run as text."""
    if convergence.key == MESH:
        return f"{convergence.rows[index]} rows"
    return value_text(convergence.key, float(convergence.values[index]))


def _positions(convergence: Convergence) -> Array:
    """Return the position of each run on the axis, in SI."""
    return np.array(convergence.rows, dtype=float) if convergence.key == MESH else convergence.values


def _plot_angles(axes: Axes, convergence: Convergence, starts: Array, scale: float) -> None:
    """Draw a line for every value, the first wide and light, the last thin and dark, so that none is hidden."""
    count = len(convergence.values)
    shades = QUANTITY_COLOURS(np.linspace(0.9, 0, count))
    for index in range(count):
        axes.plot(
            scale * (convergence.times[index] - starts[index]),
            np.degrees(convergence.angles[index]),
            LINE_STYLES[index % len(LINE_STYLES)],
            color=shades[index],
            lw=np.linspace(2.6, 0.9, count)[index],
            label=_name(convergence, index),
        )
    axes.axhline(0, color="0.6", lw=0.5, zorder=0)


def _plot_law(axes: Axes, fit: OrderFit, convergence: Convergence, factor: float) -> None:
    """Draw the fitted law from its limit on, and the tolerance about the limit."""
    steps = np.linspace(0, 1.05 * float(convergence.values.max()), 100)
    axes.plot(factor * steps, 1e3 * fit.time(steps), "--", color=VERMILION, label=order_text(fit))
    limit, tolerance = 1e3 * fit.limit, convergence.tolerance
    axes.axhspan(
        limit * (1 - tolerance),
        limit * (1 + tolerance),
        facecolor="0.92",
        edgecolor="0.6",
        lw=0.5,
        zorder=-1,
        label=f"within {100 * tolerance:g} % of the limit",
    )
    axes.set_xlim(left=0)
