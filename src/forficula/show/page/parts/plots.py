"""Plots over time, as data that the page's script draws."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from forficula.analysis.energy_by_mechanism import energy_shares
from forficula.arrays import Array
from forficula.dynamics import Record
from forficula.names import listed
from forficula.quantities import reading_unit, show_value
from forficula.show.page.data.packing import packed
from forficula.show.page.parts.run_sentences import reading_text
from forficula.show.page.playback import Clip, Readings, mark_readings
from forficula.show.run.mechanisms_figure import LOSSES, energy_bands, supply_text
from forficula.show.structure.labels import by_number, parts_of


@dataclass(frozen=True, kw_only=True)
class Line:
    """Line of a plot.

    Attributes:
        name: text in the plot's legend.
        clip: index of the clip whose frames give the time.
        values: values in the plot's unit, (time,), or a reference to the clip's data: name of the readings and index.
        look: number of its colour and dashes; its index in the plot by default.
        area: colour of the area below the line in a plot of stacked areas, or its name in the page's style, such as
            "--grid"; "" for a line.
        since: index of the line whose value at the start of the displayed time is subtracted; None to subtract nothing.
    """

    name: str
    clip: int
    values: Array | tuple[str, int]
    look: int | None = None
    area: str = ""
    since: int | None = None


@dataclass(frozen=True, kw_only=True)
class Plot:
    """Lines over time.

    Attributes:
        title: name of the quantity.
        unit: unit of the values.
        lines: one or more.
        text: a sentence that says what the plot shows.
        stacked: whether lines with areas are thicknesses of areas on top of each other, the topmost first.
    """

    title: str
    unit: str
    lines: tuple[Line, ...]
    text: str
    stacked: bool = False


def reading_lines(readings: Readings) -> tuple[Line, ...]:
    """Return the lines of one measure in the order of their numbers."""
    return tuple(
        Line(name=readings.labels[index], clip=0, values=(readings.measure.name, index))
        for index in by_number(readings.labels)
    )


def reading_plot(clip: Clip, number: int) -> Plot:
    """Return the plot of one measure, selected by index, of a page with a single clip."""
    readings = clip.readings[number]
    in_states = [readings.factor * mark_readings(clip, readings, mark)[0] for mark in clip.marks]
    text = reading_text(readings, in_states, clip)
    return Plot(title=readings.title, unit=readings.unit, lines=reading_lines(readings), text=text)


def energy_plot(title: str, energies: Sequence[tuple[str, int, Array]], text: str) -> Plot:
    """Return a plot of energies in one unit.

    Args:
        title: the quantity.
        energies: name, number of the clip, and J, (time,), of each line.
        text: what the plot shows.
    """
    unit, factor = reading_unit("J", max(float(np.abs(values).max(initial=0.0)) for _, _, values in energies))
    lines = tuple(Line(name=name, clip=clip, values=factor * values) for name, clip, values in energies)
    return Plot(title=title, unit=unit, lines=lines, text=text)


def mechanisms_plot(record: Record, clip: Clip) -> Plot | None:
    """Return the plot of energies by mechanism as stacked areas; None if an energy is not known in every frame."""
    rows = np.searchsorted(record.time, clip.time)
    shares = energy_shares(record)
    bands = [*reversed(energy_bands(record, shares, rows))]
    supplied = shares.supplied[rows]
    if not all(np.isfinite(values).all() for values in (supplied, *(band.energy for band in bands))):
        return None
    unit, factor = reading_unit("J", float(supplied.max()))
    lost = next(number for number, band in enumerate(bands) if band.name == LOSSES)
    lines = [
        Line(
            name=band.name,
            clip=0,
            values=factor * band.energy,
            area="--grid" if number == lost else band.colour,
            since=number if number == lost else None,
        )
        for number, band in enumerate(bands)
    ]
    lines.append(Line(name="supplied", clip=0, values=factor * supplied, since=lost))
    total = sum(shares.stored.values(), np.zeros(len(record.time)))
    moments = np.searchsorted(record.time, [mark.time for mark in clip.marks])
    stored = [
        f"{show_value(energy, 'J', largest=float(max(supplied.max(), total.max())))} {mark.name}"
        for energy, mark in zip(total[moments].tolist(), clip.marks, strict=True)
    ]
    text = (
        f"Supplied is the {supply_text(record.structure)}. Work and losses count from the start of the displayed time."
        f" Motion is the kinetic energy.{f' Stored: {listed(stored)}.' if stored else ''}"
    )
    return Plot(title="energy by mechanism", unit=unit, lines=tuple(lines), text=text, stacked=True)


def plot_data(plots: Sequence[Plot]) -> list[dict[str, Any]]:
    """Return plots as data for JSON."""
    return [
        {
            "title": plot.title,
            "unit": plot.unit,
            "text": plot.text,
            # common name of lines whose names differ only in their numbers
            "word": parts_of([line.name for line in plot.lines]).heading,
            "lines": [_line_data(line) for line in plot.lines],
            **({"stacked": True} if plot.stacked else {}),
        }
        for plot in plots
    ]


def _line_data(line: Line) -> dict[str, Any]:
    values, data = line.values, {"name": line.name, "clip": line.clip}
    if line.look is not None:
        data["look"] = line.look
    if line.area:
        data["area"] = line.area
    if line.since is not None:
        data["since"] = line.since
    if isinstance(values, tuple):
        return data | {"readings": values[0], "part": values[1]}
    return data | {"values": packed(values, "f4")}
