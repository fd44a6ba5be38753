"""Figures of an optimisation: all designs over parameters and quantities, and the Pareto front."""

from __future__ import annotations

import textwrap
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.collections import LineCollection
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Patch, Rectangle

from forficula.arrays import Array, Flags
from forficula.goals.optimise.optimum import Optimum
from forficula.quantities import Unit, parse_quantity
from forficula.show.study.factor_text import key_text
from forficula.show.style import BLACK, BLUE, PAGE_WIDTH, VERMILION, describe, figure_style, fit_legend, is_narrow

_GREY = "0.75"
# height of a figure, inch; half the width of a shaded part of an axis, as a share of the figure
_HEIGHT, _SHADED = 3.0, 0.01
# letters per inch in the name of an axis, and least letters per line
_LETTERS, _LEAST_LETTERS = 13, 8
_BEYOND: dict[str, Any] = {"fc": "0.88", "ec": "none"}
# room around the designs that meet the goal and the limits, as a share of their range
_ROOM = 0.5
_SIGNS = {"<=": "≤", ">=": "≥"}


def draw_candidates(optimum: Optimum, width: float = PAGE_WIDTH) -> Figure:
    """Draw every candidate as a line over the parameters, the quantities of the goal and the least margin.

    Args:
        optimum: the result of the optimisation.
        width: width of the figure, inch.
    """
    axes_of = _axes_of(optimum)
    feasible, best = (optimum.table[name].values.astype(bool) for name in ("feasible", "best"))
    places = np.arange(len(axes_of), dtype=float)
    shares = np.stack([axis.shares(axis.values) for axis in axes_of], axis=1)
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
        for place, axis in zip(places.tolist(), axes_of, strict=True):
            axes.plot([place, place], [0, 1], color=BLACK, lw=0.6)
            for end, at, side in ((axis.low, -0.02, "top"), (axis.high, 1.02, "bottom")):
                axes.text(place, at, axis.text(end), ha="center", va=side, fontsize=6)
            for kind, bound in axis.limits:
                _draw_limit(axes, place, axis, kind, bound)
        axes.set_xlim(-0.5, len(axes_of) - 0.5)
        axes.set_ylim(-0.1, 1.1)
        axes.set_yticks([])
        for spine in axes.spines.values():
            spine.set_visible(False)
        room = max(_LEAST_LETTERS, int(_LETTERS * width / len(axes_of)))
        axes.set_xticks(places, [axis.label(room) for axis in axes_of])
        axes.tick_params(axis="x", length=0, labelsize=6 if is_narrow(width) else 7)
        handles: list[Artist] = [
            Line2D([], [], color=VERMILION, lw=1.6, label=f"best{_verified(optimum)}"),
            Line2D([], [], color=BLUE, lw=0.7, label="meets the goal"),
            Line2D([], [], color=_GREY, lw=0.7, label="other designs"),
        ]
        if any(axis.limits for axis in axes_of):
            handles.append(Patch(label="beyond a limit", **_BEYOND))
        fit_legend(figure, handles, 4, loc="outside upper center")
        return describe(
            figure,
            f"All {len(feasible)} designs tried for {optimum.goal.name}, one line each, over its parameters and"
            f" quantities; {int(feasible.sum())} are known to meet the goal.{_limits_text(axes_of)}",
        )


def _draw_limit(axes: Axes, place: float, axis: _Axis, kind: str, bound: float) -> None:
    """Shade the part of an axis beyond a limit."""
    edge = float(axis.shares(np.array([bound]))[0])
    low, high = (edge, 1.0) if kind == "<=" else (0.0, edge)
    half = _SHADED * (axes.get_xlim()[1] - axes.get_xlim()[0])
    axes.add_patch(Rectangle((place - half, low), 2 * half, high - low, zorder=0.5, **_BEYOND))
    axes.plot([place - half, place + half], [edge, edge], color=BLACK, lw=1.2, zorder=4)


def _limits_text(axes_of: Sequence[_Axis]) -> str:
    limits = [f"{axis.name} {_SIGNS[kind]} {axis.text(bound)}" for axis in axes_of for kind, bound in axis.limits]
    return f" Limits: {'; '.join(limits)}." if limits else ""


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
        inside = _focus(axes, optimum, one, other, feasible | best)
        beyond = int((~inside & ~feasible & np.isfinite(one) & np.isfinite(other)).sum())
        words = f"other designs ({beyond} beyond the axes)" if beyond else "other designs"
        axes.plot(one[~feasible & inside], other[~feasible & inside], "x", color="0.55", ms=3, mew=0.7, label=words)
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
        limits = _draw_limits(axes, optimum)
        axes.set_xlabel(first)
        axes.set_ylabel(second)
        fit_legend(figure, [*axes.get_legend_handles_labels()[0], *limits], 4, loc="outside upper center")
        return describe(
            figure,
            f"{first} against {second} of all designs tried for {optimum.goal.name}; {int(best.sum())} of them"
            " form the front, where improving one quantity worsens the other.",
        )


def _objective_limits(optimum: Optimum) -> list[tuple[int, str, float]]:
    """Return the limits of the first two objectives: the objective's index, the kind, and the bound in its unit."""
    return [
        (number, limit.kind, float(_shown(limit.bound, limit.quantity.unit)))
        for number, objective in enumerate(optimum.goal.objectives[:2])
        for limit in (*optimum.goal.limits, *optimum.goal.torque_limits)
        if limit.quantity.name == objective.quantity.name
    ]


def _focus(axes: Axes, optimum: Optimum, one: Array, other: Array, chosen: Flags) -> Flags:
    """Set the range of axes to chosen designs (all if there are none) and limits; returns which designs are inside."""
    limits, inside = _objective_limits(optimum), np.ones(len(one), dtype=bool)
    for number, values in enumerate((one, other)):
        known = values[np.isfinite(values) & (chosen if chosen.any() else True)]
        ends = np.concatenate([known, [bound for index, _, bound in limits if index == number]])
        if not len(ends):
            continue
        room = _ROOM * (np.ptp(ends) or abs(ends[0]) or 1.0)
        finite = values[np.isfinite(values)]
        # no farther than the designs are
        low = max(ends.min() - room, min(finite.min(initial=ends.min()), ends.min()) - 0.1 * room)
        high = min(ends.max() + room, max(finite.max(initial=ends.max()), ends.max()) + 0.1 * room)
        (axes.set_ylim if number else axes.set_xlim)(low, high)
        inside &= (values >= low) & (values <= high)
    return inside


def _draw_limits(axes: Axes, optimum: Optimum) -> list[Artist]:
    """Shade the areas beyond the limits of the first two objectives, and return the legend's entry."""
    ranges, limits = (axes.get_xlim(), axes.get_ylim()), _objective_limits(optimum)
    for number, kind, bound in limits:
        low, high = ranges[number]
        span = axes.axvspan if number == 0 else axes.axhspan
        span(*((bound, max(high, bound)) if kind == "<=" else (min(low, bound), bound)), zorder=0, **_BEYOND)
    axes.set(xlim=ranges[0], ylim=ranges[1])
    return [Patch(label="beyond a limit", **_BEYOND)] if limits else []


def _verified(optimum: Optimum) -> str:
    """Return a note if the best designs were verified; statics alone verifies nothing."""
    return ", verified" if any(item.finer is not None or item.fresh is not None for item in optimum.best) else ""


@dataclass(frozen=True, kw_only=True, eq=False)
class _Axis:
    """Vertical axis of the candidates.

    Attributes:
        name: name of the parameter or quantity.
        unit: display unit.
        values: value of every candidate, in this unit.
        limits: kinds and bounds of the limits, in this unit.
    """

    name: str
    unit: str
    values: Array
    limits: tuple[tuple[str, float], ...] = ()

    @property
    def _known(self) -> Array:
        values = self.values[np.isfinite(self.values)]
        return np.concatenate([values, [bound for _, bound in self.limits]])

    @property
    def low(self) -> float:
        """Least value or limit; nan if there is none."""
        return float(self._known.min()) if len(self._known) else np.nan

    @property
    def high(self) -> float:
        """Largest value or limit; nan if there is none."""
        return float(self._known.max()) if len(self._known) else np.nan

    def shares(self, values: Array) -> Array:
        """Scale values from 0, the low end, to 1, the high one; 0.5 if both are equal."""
        if not self.high > self.low:
            return np.where(np.isfinite(values), 0.5, np.nan)
        return np.asarray((values - self.low) / (self.high - self.low))

    def label(self, letters: int) -> str:
        """Return the name in lines of a number of letters, and the limits."""
        limits = [f"{_SIGNS[kind]} {self.text(bound)}" for kind, bound in self.limits]
        return "\n".join([textwrap.fill(self.name, letters), *limits])

    def text(self, value: float) -> str:
        """Return a value with its unit."""
        return f"{value:.3g} {self.unit}".strip().replace("-", "−")


def _axes_of(optimum: Optimum) -> list[_Axis]:
    """Return the axes: the parameters, the quantities of the goal and the least margin."""
    goal, rows = optimum.goal, list[_Axis]()
    limits = (*goal.limits, *goal.torque_limits)

    def bounds(name: str, unit: Unit | None) -> tuple[tuple[str, float], ...]:
        named = [limit for limit in limits if key_text(limit.quantity.name) == name]
        return tuple((limit.kind, float(_shown(limit.bound, unit))) for limit in named)

    for parameter in goal.parameters:
        values, unit = optimum.table[parameter.factor.dimension].values, parameter.factor.unit
        name = key_text(parameter.key)
        if values.dtype.kind in "OU":  # choices that are words, by index
            indices = [float([str(choice) for choice in parameter.choices].index(str(value))) for value in values]
            rows.append(_Axis(name=name, unit="", values=np.array(indices)))
        else:
            shown = _Axis(
                name=name,
                unit=unit.display if unit else "",
                values=_shown(values, unit),
                limits=bounds(name, unit),
            )
            rows.append(shown)
    names = {axis.name for axis in rows}
    for quantity in goal.quantities:
        name = key_text(quantity.name)
        if quantity.dimension in optimum.table and name not in names:
            values = _shown(optimum.table[quantity.dimension].values, quantity.unit)
            rows.append(_Axis(name=name, unit=quantity.unit.display, values=values, limits=bounds(name, quantity.unit)))
    margin = 100 * np.asarray(optimum.table["margin"].values, dtype=np.float64)
    rows.append(_Axis(name="least margin", unit="%", values=margin))
    return rows


def _shown(values: Any, unit: Unit | None) -> Array:
    """Return values in their display unit."""
    factor = 1.0 if unit is None else parse_quantity(f"1 {unit.display}", unit)
    return np.asarray(values, dtype=np.float64) / factor


def _label(name: str, unit: Unit) -> str:
    return f"{key_text(name)} ({unit.display})"


def _lines(places: Array, shares: Array) -> list[list[Array]]:
    """Return lines over the positions, interrupted at unknown values."""
    parts = [[np.column_stack([places[known], row[known]]) for row in shares if (known := np.isfinite(row)).sum() > 1]]
    return [part for part in parts if part]
