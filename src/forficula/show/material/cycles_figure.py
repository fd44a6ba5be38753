"""Stress over strain, cycle by cycle."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from forficula.arrays import Array
from forficula.material.characterisation import Characterisation
from forficula.material.tensile.cycles import Cycle, CycleBranch
from forficula.show.material.material_units import stress_unit
from forficula.show.style import (
    BLUE,
    PAGE_WIDTH,
    VERMILION,
    describe,
    figure_style,
    fit_legend,
    in_column,
    is_narrow,
    letter_panels,
)

WAYS = {"loading": (BLUE, "-"), "unloading": (VERMILION, "--")}
_SLACK: dict[str, Any] = {"ls": "none", "marker": "o", "color": "white", "mec": VERMILION, "ms": 4.5}
_LEAST_SLACK = 2.0  # %, slack strain below which no mark is drawn
_MOST_CYCLES = 6
_POINTS = 201


def draw_cycles(material: Characterisation, width: float = PAGE_WIDTH) -> Figure:
    """Draw stress over strain, a panel for each cycle: specimens thin, their median thick; width in inch."""
    left_out = {cycle.number for specimen in material.specimens for cycle in specimen.left_out}
    by_number: dict[int, list[Cycle]] = {}
    for specimen in material.specimens:
        for cycle in (*specimen.left_out, *specimen.cycles):
            by_number.setdefault(cycle.number, []).append(cycle)
    numbers = _shown(sorted(by_number))
    peak = max(float(cycle.loading.stress.max()) for number in numbers for cycle in by_number[number])
    unit, factor = stress_unit(peak)
    most = 2 if is_narrow(width) else 3
    # four beside and below one another, without an empty area
    columns = 2 if len(numbers) == 4 else min(len(numbers), most)
    rows = math.ceil(len(numbers) / columns)
    with figure_style():
        size = (width if columns > 1 else 2 * width / most, 2.1 * rows + 0.35)
        figure = Figure(figsize=size, layout="constrained")
        grid = figure.subplots(rows, columns, sharex=True, sharey=True, squeeze=False).ravel()
        slack = False
        for place, (axes, number) in enumerate(zip(grid, numbers, strict=False)):
            slack |= _draw_cycle(axes, by_number[number], factor)
            axes.set_title(f"cycle {number}{', left out' if number in left_out else ''}", loc="left")
            if place % columns == 0:
                axes.set_ylabel(f"engineering stress ({unit})")
            if place + columns >= len(numbers):
                axes.set_xlabel("engineering strain (%)")
                axes.tick_params(labelbottom=True)
        spare = list(grid[len(numbers) :])
        letter_panels(grid[: len(numbers)].tolist())
        _legend(figure, spare[:1], many=len(material.specimens) > 1, slack=slack)
        for axes in spare:
            axes.set_axis_off()
        return describe(figure, _text(material, numbers))


def _shown(numbers: Sequence[int]) -> list[int]:
    """Return all cycles, or as many as fit on a page, including the first two and the last."""
    if len(numbers) <= _MOST_CYCLES:
        return list(numbers)
    places = np.unique(np.geomspace(2, len(numbers), _MOST_CYCLES - 1).round().astype(int)) - 1
    return [numbers[0], *(numbers[place] for place in places)]


def _draw_cycle(axes: Axes, cycles: Sequence[Cycle], factor: float) -> bool:
    """Draw one cycle; returns whether the strain below which specimens are slack is marked."""
    for name, (colour, style) in WAYS.items():
        branches: list[CycleBranch] = [getattr(cycle, name) for cycle in cycles]
        if len(branches) > 1:
            for branch in branches:
                axes.plot(100 * branch.strain, branch.stress / factor, color=colour, lw=0.5, alpha=0.35)
        strain, stress = _median_curve(branches)
        axes.plot(100 * strain, stress / factor, color=colour, ls=style, lw=1.6)
    axes.axhline(0, color="0.6", lw=0.5, zorder=0)
    slack = [cycle.slack_strain for cycle in cycles if math.isfinite(cycle.slack_strain)]
    place = 100 * float(np.median(slack)) if slack else 0.0
    # for a specimen that is never slack this is the strain at 1 % of its peak stress
    marked = place > _LEAST_SLACK
    if marked:
        axes.plot(place, 0, **_SLACK, zorder=5, clip_on=False)
        words = f"no force below {place:.0f} %"
        if in_column(axes):  # too narrow for words beside the title
            axes.text(0.04, 0.96, words, transform=axes.transAxes, va="top", fontsize=7)
        else:
            axes.set_title(words, loc="right", fontsize=7)
    return marked


def _median_curve(branches: Sequence[CycleBranch]) -> tuple[Array, Array]:
    """Return the median over specimens at strains that all specimens reach, shape (points,)."""
    low = max(float(branch.strain.min()) for branch in branches)
    high = min(float(branch.strain.max()) for branch in branches)
    strain = np.linspace(low, high, _POINTS)
    curves = []
    for branch in branches:
        order = np.argsort(branch.strain, kind="stable")
        curves.append(np.interp(strain, branch.strain[order], branch.stress[order]))
    return strain, np.median(curves, axis=0)


def _legend(figure: Figure, spare: Sequence[Axes], *, many: bool, slack: bool) -> None:
    """Draw the legend in the area of an unused panel, or below."""
    what = ", median of the specimens" if many else ""
    handles = [
        Line2D([], [], color=colour, ls=style, lw=1.6, label=name + what) for name, (colour, style) in WAYS.items()
    ]
    if many:
        handles.append(Line2D([], [], color="0.5", lw=0.6, label="each specimen"))
    if slack:
        handles.append(Line2D([], [], label="unloading carries no force below", **_SLACK))
    if spare and not is_narrow(figure.get_figwidth()):
        spare[0].legend(handles=handles, loc="center left", borderaxespad=0)
    else:
        fit_legend(figure, handles, 2, loc="outside lower center")


def _text(material: Characterisation, numbers: Sequence[int]) -> str:
    """Describe the cycles."""
    count = len(material.specimens)
    specimens = f"{count} specimens" if count > 1 else "one specimen"
    cycles = ", ".join(str(number) for number in numbers)
    return f"Stress over strain of {specimens} of {material.name}, cycle by cycle. Cycles shown: {cycles}."
