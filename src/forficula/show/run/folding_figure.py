"""A structure in space at a few moments of a run."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.collections import PolyCollection
from matplotlib.figure import Figure
from numpy.typing import NDArray

from forficula.analysis import Outcome
from forficula.design import stage_drives
from forficula.dynamics import Record, StageEnd
from forficula.quantities import reading_unit
from forficula.show.run.state_names import lettered_states
from forficula.show.structure.painted_shape import paint_shape, shape_handles, structure_view
from forficula.show.structure.shape import shape_of
from forficula.show.structure.surface import at_time, surface_at
from forficula.show.style import ORANGE, PAGE_WIDTH, describe, figure_style, is_narrow
from forficula.structure import Structure, hinge_groups

Array = NDArray[np.float64]

_LEGEND_HEIGHT = 0.9  # inch
_BAR_HEIGHT = 0.3  # inch, of a scale bar with its number
_TORN = 10.0  # spans
_MOST_LINES = 200  # of creases and edges: more would hide what they lie on
# to the size of the whole: the more, the larger the file; facets hide more of one another than sheets between bars do
_CELLS, _FACET_CELLS = 16, 20


def draw_folding(record: Record, outcome: Outcome, width: float = PAGE_WIDTH) -> Figure:
    """Draw a structure in its states and on its ways between them, all at one scale and from one side.

    Args:
        record: what happened.
        outcome: what it means.
        width: of the figure, inch.
    """
    moments, structure = _moments(record, outcome), record.structure
    shape, view = shape_of(structure), structure_view(structure)
    with figure_style():
        columns = 2 if is_narrow(width) else 4
        times = time_texts([time for _, time in moments])
        surfaces = [surface_at(record, shape, time) for _, time in moments]
        if len(shape.lines) > _MOST_LINES and not structure.facets:
            surfaces = [replace(each, lines=each.lines[:0], folds=each.folds[:0]) for each in surfaces]
        cells = _FACET_CELLS if structure.facets else _CELLS
        drawn = [paint_shape(surface, view, ORANGE, cells=cells) for surface in surfaces]
        corners = np.concatenate([painted.polygons.reshape(-1, 2) for painted in drawn])
        low, high = corners.min(axis=0), corners.max(axis=0)
        scale = width / columns / (high - low)[0]
        height = scale * (high - low)[1]
        flat = height < _LEGEND_HEIGHT / 2
        if flat:  # the scale bar comes beneath the first one, and the legend beneath all
            low[1] -= _BAR_HEIGHT / scale
            height += _BAR_HEIGHT
        else:
            height = max(height, _LEGEND_HEIGHT)
        rows = -(-(len(moments) + (not flat)) // columns)  # one place for the legend
        figure = Figure(figsize=(width, rows * (height + 0.25) + 0.25 * flat), layout="constrained")
        for axes, (name, time), painted in zip(
            np.ravel(figure.subplots(rows, columns, squeeze=False)), moments, drawn, strict=False
        ):
            # edges of the same colour, or else seams show between the polygons
            axes.add_collection(
                PolyCollection(list(painted.polygons), facecolors=painted.colours, edgecolors="face", linewidths=0.3)
            )
            axes.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]), aspect="equal")
            axes.set_title(f"{name}, {times[time]}", pad=2)
        for axes in figure.axes:
            axes.set_axis_off()
        handles = shape_handles(shape, structure, ORANGE, 2.0)
        if flat:
            _scale_bar(figure.axes[0], high - low, low)
            figure.legend(handles=handles, loc="outside lower center", ncols=len(handles))
        else:
            _legend(figure.axes[len(moments)], handles, high - low, low)
        told = "; ".join(f"{name} at {times[time]}" for name, time in moments)
        what = f"The {structure.appearance.whole} {record.design.name} in space at {len(moments)} moments of a run"
        return describe(figure, f"{what}. {told}.")


def time_texts(times: list[float]) -> dict[float, str]:
    """Times (s) in one unit, with four significant digits or as many as tell them apart."""
    unit, factor = reading_unit("s", max(times))
    for digits in range(4, 18):
        texts = {time: f"{factor * time:#.{digits}g} {unit}" for time in times}
        if len(set(texts.values())) == len(texts):
            break
    return texts


def _legend(axes: Axes, handles: Sequence[Artist], size: Array, low: Array) -> None:
    """What the colours mean, and a scale bar."""
    axes.set(xlim=(low[0], low[0] + size[0]), ylim=(low[1], low[1] + size[1]), aspect="equal")
    _scale_bar(axes, size, low)
    axes.legend(handles=handles, loc="upper left", borderaxespad=0)


def _scale_bar(axes: Axes, size: Array, low: Array) -> None:
    """A scale bar of about a third of the picture."""
    bar = 10.0 ** np.floor(np.log10(size[0] / 2))
    bar *= next(steps for steps in (5, 2, 1) if steps * bar <= size[0] / 2)
    left, height = low[0] + 0.15 * size[0], low[1] + 0.05 * size[1]
    axes.plot([left, left + bar], [height, height], color="black", lw=1.5)
    unit, factor = reading_unit("m", bar)
    axes.text(left + bar / 2, height + 0.04 * size[1], f"{factor * bar:.4g} {unit}", ha="center", va="bottom")


def _moments(record: Record, outcome: Outcome) -> list[tuple[str, float]]:
    """Names and times: the states, and between them moments at equal progress of every driven stage.

    Where none is driven, of every stage, from the start.
    """
    moments = [(name, state.time) for name, state in lettered_states(record.structure, outcome)]
    driven = [end for end in record.stages if stage_drives(end.stage)]
    if not driven:
        moments.append(("start", 0.0))
    for end in driven or record.stages:
        moments += [(end.stage.name, time) for time in _halfway(record, end)]
    moments.sort(key=lambda moment: moment[1])
    # of two names for one moment the first
    apart = [(name, time) for place, (name, time) in enumerate(moments) if place == 0 or time > moments[place - 1][1]]
    return [(name, time) for name, time in apart if not _is_torn(record, time)] or [("start", 0.0)]


def _is_torn(record: Record, time: float) -> bool:
    """Whether a structure lies so far about that nothing of it can be seen, as after it blew up."""
    places = record.series.get("point_position")
    if places is None or not places.size:
        return False
    with np.errstate(over="ignore", invalid="ignore"):
        extent = np.ptp(at_time(record, "point_position", time), axis=0).max()
    return not extent <= _TORN * record.structure.span


def _halfway(record: Record, end: StageEnd) -> list[float]:
    """Times in a stage at which it has gone a third and two thirds of its way."""
    rows = (record.time >= end.start) & (record.time <= end.end)
    time, progress = record.time[rows], _progress(record)[rows]
    done = np.maximum.accumulate(np.abs(progress - progress[0]))
    return [float(time[int(np.searchsorted(done, share * done[-1]))]) for share in (1 / 3, 2 / 3)]


def _progress(record: Record) -> Array:
    """How far the hinges of every motor are on their way to their further stops, on average, summed, (time,)."""
    structure, angles = record.structure, record.series["hinge_angle"]
    groups = [motor.hinges for motor in structure.motors if motor.hinges]
    groups = groups or [hinges for kind, hinges in hinge_groups(structure).items() if kind != "facet bends"]
    return sum(
        ((angles[:, list(group)] / _ways(structure, angles, group)).mean(axis=1) for group in groups),
        np.zeros(len(record.time)),
    )


def _ways(structure: Structure, angles: Array, group: tuple[int, ...]) -> Array:
    """The angles of hinges at their further stops, rad, (hinge,); where there is none, the furthest that they come."""
    ways = []
    for number in group:
        hinge = structure.hinges[number]
        stops = [stop for stop in (hinge.lower, hinge.upper) if np.isfinite(stop)]
        seen = angles[:, number][np.isfinite(angles[:, number])]
        way = max(stops, key=abs, default=0.0) or (float(seen[np.argmax(np.abs(seen))]) if len(seen) else 0.0)
        ways.append(way or 1.0)
    return np.array(ways)
