"""Plots over the time as data: what the page's script draws."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from forficula.arrays import Array
from forficula.quantities import reading_unit
from forficula.show.page.data.packing import packed
from forficula.show.page.parts.words import reading_text
from forficula.show.page.playback import Clip, mark_readings
from forficula.show.structure.labels import parts_of


@dataclass(frozen=True, kw_only=True)
class Line:
    """One line of a plot.

    Attributes:
        name: in the plot's key.
        clip: over whose frames it goes.
        values: in the plot's unit, (time,), or where they stand in the clip's own data: the readings and which of them.
    """

    name: str
    clip: int
    values: Array | tuple[str, int]


@dataclass(frozen=True, kw_only=True)
class Plot:
    """Lines over the time.

    Attributes:
        title: the quantity.
        unit: of the values.
        lines: one or more.
        text: what the plot shows, in a sentence.
    """

    title: str
    unit: str
    lines: tuple[Line, ...]
    text: str


def reading_plot(clip: Clip, number: int) -> Plot:
    """Angles or distances of the only clip of a page, by the number of its readings."""
    readings = clip.readings[number]
    lines = tuple(
        Line(name=label, clip=0, values=(readings.measure.name, place)) for place, label in enumerate(readings.labels)
    )
    in_states = [readings.factor * mark_readings(clip, readings, mark)[0] for mark in clip.marks]
    text = reading_text(readings, in_states, clip)
    return Plot(title=readings.title, unit=readings.unit, lines=lines, text=text)


def energy_plot(title: str, energies: Sequence[tuple[str, int, Array]], text: str) -> Plot:
    """Energies in one unit.

    Args:
        title: the quantity.
        energies: name, number of the clip, and J, (time,), of each line.
        text: what the plot shows.
    """
    unit, factor = reading_unit("J", max(float(np.abs(values).max(initial=0.0)) for _, _, values in energies))
    lines = tuple(Line(name=name, clip=clip, values=factor * values) for name, clip, values in energies)
    return Plot(title=title, unit=unit, lines=lines, text=text)


def plot_data(plots: Sequence[Plot]) -> list[dict[str, Any]]:
    """Plots as data for JSON."""
    return [
        {
            "title": plot.title,
            "unit": plot.unit,
            "text": plot.text,
            # of several lines that are called alike, but for their numbers
            "word": parts_of([line.name for line in plot.lines]).heading,
            "lines": [_line_data(line) for line in plot.lines],
        }
        for plot in plots
    ]


def _line_data(line: Line) -> dict[str, Any]:
    values = line.values
    if isinstance(values, tuple):
        return {"name": line.name, "clip": line.clip, "readings": values[0], "part": values[1]}
    return {"name": line.name, "clip": line.clip, "values": packed(values, "f4")}
