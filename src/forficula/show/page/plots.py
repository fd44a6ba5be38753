"""Plots over the time as data: what the page's script draws."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from forficula.quantities import reading_unit
from forficula.show.page.playback import Clip, packed
from forficula.show.page.words import angle_text

Array = NDArray[np.float64]


@dataclass(frozen=True, kw_only=True)
class Line:
    """One line of a plot.

    Attributes:
        name: in the plot's key.
        clip: over whose frames it goes.
        values: in the plot's unit, (time,), or where they stand in the clip's own data: the series and the vein.
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


def angle_plot(clip: Clip, title: str, series: Literal["distalAngle", "turnAngle"]) -> Plot:
    """Angles of every vein of the only clip of a page, deg."""
    lines = tuple(Line(name=f"vein {vein}", clip=0, values=(series, vein)) for vein in range(clip.turn_angle.shape[1]))
    if series == "distalAngle":
        in_states = [mark.state.distal_angle for mark in clip.marks]
    else:
        # an outcome has no such means
        in_states = [clip.turn_angle[np.argmin(np.abs(clip.time - mark.time))] for mark in clip.marks]
    text = angle_text(title, [np.degrees(angles) for angles in in_states], clip)
    return Plot(title=title, unit="deg", lines=lines, text=text)


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
        {"title": plot.title, "unit": plot.unit, "text": plot.text, "lines": [_line_data(line) for line in plot.lines]}
        for plot in plots
    ]


def _line_data(line: Line) -> dict[str, Any]:
    values = line.values
    if isinstance(values, tuple):
        return {"name": line.name, "clip": line.clip, "series": values[0], "vein": values[1]}
    return {"name": line.name, "clip": line.clip, "values": packed(values, "f4")}
