"""Figures of an optimisation: all designs over parameters and quantities, and the Pareto front."""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib.collections import LineCollection
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from forficula.arrays import Array, Flags
from forficula.goals.optimise.optimum import Optimum
from forficula.quantities import Unit, parse_quantity
from forficula.show.study.factor_text import key_text
from forficula.show.style import BLACK, BLUE, PAGE_WIDTH, VERMILION, describe, figure_style, fit_legend, is_narrow

_GREY = "0.75"
# height of a figure, inch
_HEIGHT = 3.0


def draw_candidates(optimum: Optimum, width: float = PAGE_WIDTH) -> Figure:
    """Draw every candidate as a line over the parameters, the quantities of the goal and the least margin.

    Args:
        optimum: the result of the optimisation.
        width: width of the figure, inch.
    """
    axes_of = _axes_of(optimum)
    feasible, best = (optimum.table[name].values.astype(bool) for name in ("feasible", "best"))
    places = np.arange(len(axes_of), dtype=float)
    shares = np.stack([_shares(values) for _, _, values in axes_of], axis=1)
    with figure_style():
        figure = Figure(figsize=(width, _HEIGHT), layout="constrained")
        axes = figure.subplots()
        looks: tuple[tuple[Flags, dict[str, Any]], ...] = (
            (~feasible & ~best, {"color": _GREY, "lw": 0.4, "alpha": 0.5}),
            (feasible & ~best, {"color": BLUE, "lw": 0.7, "alpha": 0.7}),
            (best, {"color": VERMILION, "lw": 1.6}),
        )
        for chosen, look in looks:
            for part in _lines(places, shares[chosen]):
                axes.add_collection(LineCollection(part, **look))
        for place, (_, unit, values) in zip(places, axes_of, strict=True):
            axes.plot([place, place], [0, 1], color=BLACK, lw=0.6)
            known = values[np.isfinite(values)]
            ends = (known.min(), known.max()) if len(known) else (np.nan, np.nan)
            for end, at, side in ((ends[0], -0.02, "top"), (ends[1], 1.02, "bottom")):
                axes.text(place, at, f"{end:.3g} {unit}".strip(), ha="center", va=side, fontsize=6)
        axes.set_xlim(-0.4, len(axes_of) - 0.6)
        axes.set_ylim(-0.12, 1.12)
        axes.set_yticks([])
        for spine in axes.spines.values():
            spine.set_visible(False)
        names = [name for name, _, _ in axes_of]
        axes.set_xticks(places, names, rotation=30 if len(names) > 4 or is_narrow(width) else 0, ha="right")
        axes.tick_params(axis="x", length=0)
        handles = [
            Line2D([], [], color=VERMILION, lw=1.6, label=f"best{_verified(optimum)}"),
            Line2D([], [], color=BLUE, lw=0.7, label="meets the goal"),
            Line2D([], [], color=_GREY, lw=0.7, label="other designs"),
        ]
        fit_legend(figure, handles, 3, loc="outside upper center")
        return describe(
            figure,
            f"All {len(feasible)} designs tried for {optimum.goal.name}, one line each, over its parameters and"
            f" quantities; {int(feasible.sum())} are known to meet the goal.",
        )


def draw_front(optimum: Optimum, width: float = PAGE_WIDTH) -> Figure:
    """Draw the first two objectives of every candidate against each other, with the front.

    Args:
        optimum: a result with at least two objectives.
        width: width of the figure, inch.
    """
    objectives = [objective.quantity for objective in optimum.goal.objectives[:2]]
    (first, one), (second, other) = (
        (_label(quantity.name, quantity.unit), _shown(optimum.table[quantity.dimension].values, quantity.unit))
        for quantity in objectives
    )
    feasible, best = (optimum.table[name].values.astype(bool) for name in ("feasible", "best"))
    with figure_style():
        figure = Figure(figsize=(width, _HEIGHT), layout="constrained")
        axes = figure.subplots()
        axes.plot(one[~feasible], other[~feasible], "x", color=_GREY, ms=3, mew=0.7, label="other designs")
        axes.plot(one[feasible & ~best], other[feasible & ~best], "o", color=BLUE, ms=3, label="meets the goal")
        order = np.argsort(one[best], kind="stable")
        axes.plot(
            one[best][order],
            other[best][order],
            "-o",
            color=VERMILION,
            ms=4.5,
            lw=0.8,
            label=f"front{_verified(optimum)}",
        )
        axes.set_xlabel(first)
        axes.set_ylabel(second)
        fit_legend(figure, axes.get_legend_handles_labels()[0], 3, loc="outside upper center")
        return describe(
            figure,
            f"{first} against {second} of all designs tried for {optimum.goal.name}; {int(best.sum())} of them"
            " form the front, where improving one quantity worsens the other.",
        )


def _verified(optimum: Optimum) -> str:
    """Return a note if the best designs were verified; statics alone verifies nothing."""
    return ", verified" if any(item.finer is not None or item.fresh is not None for item in optimum.best) else ""


def _axes_of(optimum: Optimum) -> list[tuple[str, str, Array]]:
    """Return the names, units and values, in display units, of the axes."""
    rows: list[tuple[str, str, Array]] = []
    for parameter in optimum.goal.parameters:
        values, unit = optimum.table[parameter.factor.dimension].values, parameter.factor.unit
        if values.dtype.kind in "OU":  # choices that are words, by index
            indices = [float([str(choice) for choice in parameter.choices].index(str(value))) for value in values]
            rows.append((key_text(parameter.key), "", np.array(indices)))
        else:
            rows.append((key_text(parameter.key), unit.display if unit else "", _shown(values, unit)))
    names = {name for name, _, _ in rows}
    for quantity in optimum.goal.quantities:
        if quantity.dimension in optimum.table and key_text(quantity.name) not in names:
            values = _shown(optimum.table[quantity.dimension].values, quantity.unit)
            rows.append((key_text(quantity.name), quantity.unit.display, values))
    rows.append(("least margin", "%", 100 * np.asarray(optimum.table["margin"].values, dtype=np.float64)))
    return rows


def _shown(values: Any, unit: Unit | None) -> Array:
    """Return values in their display unit."""
    factor = 1.0 if unit is None else parse_quantity(f"1 {unit.display}", unit)
    return np.asarray(values, dtype=np.float64) / factor


def _label(name: str, unit: Unit) -> str:
    return f"{key_text(name)} ({unit.display})"


def _shares(values: Array) -> Array:
    """Scale values from 0, the least, to 1, the largest; 0.5 if all are equal."""
    known = values[np.isfinite(values)]
    if not len(known) or np.ptp(known) == 0:
        return np.where(np.isfinite(values), 0.5, np.nan)
    return np.asarray((values - known.min()) / np.ptp(known))


def _lines(places: Array, shares: Array) -> list[list[Array]]:
    """Return lines over the positions, interrupted at unknown values."""
    parts = [[np.column_stack([places[known], row[known]]) for row in shares if (known := np.isfinite(row)).sum() > 1]]
    return [part for part in parts if part]
