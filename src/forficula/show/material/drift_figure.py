"""Changes of a material from cycle to cycle."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.ticker import MaxNLocator

from forficula.arrays import Array
from forficula.material.characterisation import DRIFTING, Characterisation, common_cycles, cycle_table
from forficula.material.law.drift import Drift
from forficula.show.material.material_units import energy_unit, stress_unit
from forficula.show.style import (
    BLUE,
    PAGE_WIDTH,
    VERMILION,
    describe,
    figure_style,
    fit_legend,
    is_narrow,
    letter_panels,
)


def draw_drift(material: Characterisation, width: float = PAGE_WIDTH) -> Figure:
    """Draw peak stress, loss and residual strain over the cycles, and the fitted drift; width in inch."""
    with figure_style():
        narrow, count = is_narrow(width), len(DRIFTING)
        figure = Figure(figsize=(width, 5.6 if narrow else 2.6), layout="constrained")
        grid = figure.subplots(count, 1) if narrow else figure.subplots(1, count, sharex=True)
        for axes, key in zip(grid, DRIFTING, strict=True):
            _draw_value(axes, material, key)
            axes.set_xlabel("cycle N")
            axes.xaxis.set_major_locator(MaxNLocator(integer=True, min_n_ticks=1))
        letter_panels(list(grid))
        left_out = any(specimen.left_out for specimen in material.specimens)
        fitted = any(drift is not None for drift in material.drifts.values())
        _legend(figure, many=len(material.specimens) > 1, left_out=left_out, fitted=fitted)
        return describe(figure, _text(material))


def _draw_value(axes: Axes, material: Characterisation, key: str) -> None:
    value, _ = DRIFTING[key]
    kept = [specimen.cycles for specimen in material.specimens]
    numbers, table = common_cycles(kept), cycle_table(kept, value)
    first = np.array([[value(cycle) for cycle in specimen.left_out] for specimen in material.specimens])
    every = np.concatenate([table.ravel(), first.ravel()])
    finite = every[np.isfinite(every)]
    label, factor = _reading(key, float(finite.max(initial=0.0)))
    for row in table / factor:
        axes.plot(numbers, row, "-", marker=".", color=BLUE, lw=0.6, ms=3.5, alpha=0.55, mew=0)
    if first.size:
        number = material.specimens[0].left_out[0].number
        axes.plot([number] * len(first), first[:, 0] / factor, "o", color="white", mec=BLUE, ms=3.5, mew=0.7)
    drift = material.drifts[key]
    title = "drift unknown"
    if drift is not None:
        title = _words(drift)
        _draw_drift(axes, drift, numbers, table, factor)
    axes.set_title(title, loc="left", fontsize=7)
    axes.set_ylabel(label)
    if not len(finite):
        axes.set_xlim(0.5, numbers[-1] + 0.5)
        axes.set_yticks([])
        words = "not determined:\ntoo few samples\nat low stress"
        axes.text(0.5, 0.5, words, transform=axes.transAxes, ha="center", va="center", color="0.35")
        return
    low, high = float(finite.min()), float(finite.max())
    room = max(high - low, 0.1 * abs(high), 1e-12)
    axes.set_ylim((low - 0.25 * room) / factor, (high + 0.25 * room) / factor)


def _reading(key: str, largest: float) -> tuple[str, float]:
    """Return the label of an axis and the size of its unit in SI."""
    if key == "peak_stress":
        unit, factor = stress_unit(largest)
        return f"peak stress ({unit})", factor
    if key == "loss":
        unit, factor = energy_unit(largest)
        return f"loss per cycle ({unit})", factor
    return "residual strain (%)", 0.01


def _draw_drift(axes: Axes, drift: Drift, numbers: Sequence[int], table: Array, factor: float) -> None:
    """Draw the fitted curve over the measured cycles with its 95 % interval, at the level of the median specimen."""
    changes = np.array([drift.change(number) for number in numbers]).T
    if drift.relative:
        start = np.exp(np.median(np.mean(np.log(table / changes[0]), axis=1)))
        curves = start * changes
    else:
        curves = np.median(np.mean(table - changes[0], axis=1)) + changes
    middle, low, high = curves / factor
    axes.fill_between(numbers, low, high, color=VERMILION, alpha=0.2, lw=0)
    axes.plot(numbers, middle, "--", color=VERMILION, lw=1.4)


def _words(drift: Drift) -> str:
    if drift.kind == "none":
        return "no drift in the data"
    middle, low, high = drift.change(drift.seen[1])
    change, half = (100 * (middle - 1) if drift.relative else 100 * middle), 100 * (high - low) / 2
    unit = "%" if drift.relative else "percentage points"
    course = "ln N" if drift.kind == "logarithm" else "to a plateau"
    return f"{change:+.3g} ± {half:.1g} {unit}, {course}".replace("-", "−")


def _legend(figure: Figure, *, many: bool, left_out: bool, fitted: bool) -> None:
    handles = [
        Line2D([], [], color=BLUE, marker=".", lw=0.6, ms=5, mew=0, label="each specimen" if many else "specimen")
    ]
    if left_out:
        handles.append(
            Line2D([], [], ls="none", marker="o", color="white", mec=BLUE, ms=3.5, label="left out of the fit")
        )
    if fitted:
        handles.append(Line2D([], [], ls="--", color=VERMILION, label="fitted drift and its 95 % interval"))
    fit_legend(figure, handles, 3, loc="outside lower center")


def _text(material: Characterisation) -> str:
    """Describe the drift of every value."""
    drifts = [
        f"{key.replace('_', ' ')}: {'drift unknown' if drift is None else _words(drift)}"
        for key, drift in material.drifts.items()
    ]
    return f"Peak stress, loss and residual strain of {material.name} over the cycles. {'; '.join(drifts)}."
