"""Energies of stable states, and of the saddles between them."""

from __future__ import annotations

import textwrap
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from forficula.quantities import reading_unit
from forficula.show.landscape.landscape_marks import shown_value
from forficula.show.style import (
    BLACK,
    BLUE,
    PAGE_WIDTH,
    VERMILION,
    describe,
    figure_style,
    fit_legend,
    in_column,
)
from forficula.statics import EnergyLandscape

_HALF = 0.22  # half the length of a state's mark
_LETTERS, _LEAST_NAME = 13, 8  # letters per inch in the name of a state, least letters per line
_POINTS = 41  # points of a curve


def draw_barriers(landscape: EnergyLandscape, width: float = PAGE_WIDTH) -> Figure:
    """Draw the energies of stable states and the barriers between neighbouring states.

    Only the energies of states and saddles are computed; the curves between them guide the eye.

    Args:
        landscape: landscape with a stable state.
        width: width of the figure, inch.
    """
    states, passes = landscape.states, landscape.passes
    places = _places(landscape)
    energies = [state.energy for state in states]
    tops = [energies[course_pass.ends[0]] + course_pass.barriers[0] for course_pass in passes]
    unit, factor = reading_unit("J", max(map(abs, [*energies, *tops])))
    with figure_style():
        figure = Figure(figsize=(width, 2.8), layout="constrained")
        axes = figure.subplots()
        for course_pass, top in zip(passes, tops, strict=True):
            _draw_pass(axes, [(places[end], energies[end]) for end in course_pass.ends], top, unit, factor)
        for place, energy in zip(places, energies, strict=True):
            axes.plot([place - _HALF, place + _HALF], [factor * energy] * 2, color=BLUE, lw=2.5, zorder=4)
            _write(axes, (place, factor * energy), _number(energy, unit, factor), -5)
        _draw_gaps(axes, places, [course_pass.ends for course_pass in passes])
        axes.set_xlim(-0.6, max(places) + 0.6)
        axes.margins(y=0.2)
        room = max(_LEAST_NAME, int(_LETTERS * width / (max(places) + 1.2)))
        names = {places[number]: textwrap.fill(state.name, room) for number, state in enumerate(states)}
        axes.set_xticks(sorted(names), [names[place] for place in sorted(names)])
        axes.tick_params(axis="x", length=0)
        axes.set_ylabel(f"stored energy ({unit})")
        handles = [Line2D([], [], color=BLUE, lw=2.5, label="stable state")]
        if passes:
            handles.append(Line2D([], [], color="0.6", lw=0.9, label="sketch: only states and saddles are computed"))
            words = "saddle, with the barrier from either side"
            mark = {"marker": "^", "mfc": "white", "mec": VERMILION, "mew": 1.1, "ms": 5, "ls": "none"}
            handles.append(Line2D([], [], label=words, **mark))  # type: ignore[arg-type]
        fit_legend(figure, handles, 3, loc="outside upper center")
        return describe(figure, _text(landscape))


def _places(landscape: EnergyLandscape) -> list[int]:
    """Return the horizontal positions of states, such that neighbours are connected by saddles where possible."""
    beside: dict[int, list[int]] = {number: [] for number in range(len(landscape.states))}
    for course_pass in landscape.passes:
        beside[course_pass.ends[0]].append(course_pass.ends[1])
        beside[course_pass.ends[1]].append(course_pass.ends[0])
    order: list[int] = []
    for start in sorted(beside, key=lambda number: (len(beside[number]) != 1, number)):
        waiting = [start]
        while waiting:
            number = waiting.pop()
            if number not in order:
                order.append(number)
                waiting += sorted(beside[number], reverse=True)
    return [order.index(number) for number in range(len(landscape.states))]


def _draw_gaps(axes: Axes, places: list[int], joined: list[tuple[int, int]]) -> None:
    """Say in every gap between states over which no saddle leads that none was found."""
    spans = [sorted(places[end] for end in ends) for ends in joined]
    look: dict[str, Any] = {"ha": "center", "va": "center", "color": "0.35", "fontsize": 6 if in_column(axes) else 7}
    for left in range(max(places)):
        if not any(low <= left < high for low, high in spans):
            axes.text(left + 0.5, 0.5, "no saddle\nfound", transform=axes.get_xaxis_transform(), **look)


def _number(energy: float, unit: str, factor: float) -> str:
    """Return an energy in the unit of the axis."""
    return f"{factor * energy + 0.0:.3g} {unit}".replace("-", "−")


def _write(axes: Axes, place: tuple[float, float], words: str, above: float) -> None:
    """Write words above a point, or below it where `above` is negative, pt."""
    axes.annotate(
        words,
        place,
        xytext=(0, above),
        textcoords="offset points",
        ha="center",
        va="bottom" if above > 0 else "top",
        fontsize=6 if in_column(axes) else 7,
        color=BLACK,
    )


def _draw_pass(axes: Axes, ends: list[tuple[int, float]], top: float, unit: str, factor: float) -> None:
    """Draw a curve over a saddle, and the barrier from either side."""
    (left, low), (right, other) = sorted(ends)
    left_end, right_end = left + _HALF, right - _HALF
    middle = (left_end + right_end) / 2
    rise = (1 - np.cos(np.linspace(0, np.pi, _POINTS))) / 2
    for start, base in ((left_end, low), (right_end, other)):
        along = np.linspace(start, middle, _POINTS)
        axes.plot(along, factor * (base + (top - base) * rise), color="0.6", lw=0.9, zorder=2)
    axes.plot(middle, factor * top, "^", color="white", mec=VERMILION, mew=1.1, ms=5, zorder=5)
    barriers = [_number(top - base, unit, factor) for base in (low, other)]
    _write(axes, (middle, factor * top), f"{barriers[0]} →\n← {barriers[1]}", 5)


def _text(landscape: EnergyLandscape) -> str:
    names = [state.name for state in landscape.states]
    states = ", ".join(f"{state.name} {shown_value(state.energy, 'J', 3)}" for state in landscape.states)
    paths = [
        f"{names[course_pass.ends[0]]} to {names[course_pass.ends[1]]} {shown_value(course_pass.barriers[0], 'J', 3)}"
        f" and back {shown_value(course_pass.barriers[1], 'J', 3)}"
        for course_pass in landscape.passes
    ]
    barriers = f" Barriers: {'; '.join(paths)}." if paths else " No saddle between them was found."
    what = f"Energies of the stable states of the {landscape.structure.appearance.whole} {landscape.design.name}"
    return f"{what} and of saddles between them. States: {states}.{barriers}"
