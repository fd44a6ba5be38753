"""A traced pattern over its photograph, and its deviations from flat-foldability."""

from __future__ import annotations

import math

import numpy as np
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.collections import LineCollection
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from forficula.arrays import Array
from forficula.pattern import ASSIGNMENTS, Trace
from forficula.quantities import reading_unit, show_value
from forficula.show.structure.crease_lines import add_sheet_legend, draw_creases, sheet_axes
from forficula.show.structure.flat_net import flat_net
from forficula.show.style import (
    BLACK,
    BLUE,
    GREEN,
    ORANGE,
    PAGE_WIDTH,
    PURPLE,
    QUANTITY_COLOURS,
    VERMILION,
    describe,
    figure_style,
    in_column,
)

# colours of edges, as in other drawings of patterns; solid, because the photograph shows the dashes
_COLOURS = {"M": VERMILION, "V": BLUE, "B": BLACK, "C": GREEN, "F": "0.45", "U": PURPLE}
_MOST_PIXELS = 800  # along the longer side of a drawn photograph
_FADED = 0.45  # opacity of the photograph under the lines
_AROUND = 0.06  # of the pattern's size, shown around it
_WIDEST = 5.2  # inch
_TALLEST = 1.3  # largest height by width
_LEAST_RESIDUAL = 1e-3  # deg, least end of the scale of Kawasaki's residuals
_BAR = 0.55  # inch, height of the scale


def draw_trace(trace: Trace, width: float = PAGE_WIDTH) -> Figure:
    """Draw the found lines and vertices over the photograph, and mark doubtful ones.

    Args:
        trace: trace of a picture.
        width: largest width of the figure, inch.
    """
    places = np.array([(vertex.picture_x, vertex.picture_y) for vertex in trace.vertices])
    marks = np.array([(point.x, point.y) for point in (*trace.corners, *trace.free_ends, *trace.left_over)])
    left, top, right, bottom = _window(trace, np.concatenate([places, marks.reshape(-1, 2)]))
    with figure_style():
        wide = min(width, _WIDEST)
        tall = min(_TALLEST, (bottom - top) / (right - left))
        figure = Figure(figsize=(wide, (wide - 0.6) * tall + 0.5), layout="constrained")
        axes = figure.subplots()
        step = max(1, math.ceil(max(right - left, bottom - top) / _MOST_PIXELS))
        shown = trace.picture.pixels[top:bottom:step, left:right:step]
        faded = (255 * (1 - _FADED * (1 - shown))).round().astype(np.uint8)
        axes.imshow(faded, extent=(left - 0.5, right - 0.5, bottom - 0.5, top - 0.5), interpolation="antialiased")
        handles = _draw_edges(trace, axes, places)
        axes.plot(*places.T, "o", ms=3.0, mfc="white", mec=BLACK, mew=0.6, zorder=4)
        handles.append(Line2D([], [], marker="o", ls="none", ms=3, mfc="white", mec=BLACK, mew=0.6, label="vertex"))
        for points, marker, label in (
            (trace.corners, "+", "corner of the sheet"),
            (trace.free_ends, "x", "line that leads nowhere"),
            (trace.left_over, "s", "other ink"),
        ):
            if points:
                look = {"marker": marker, "ls": "none", "ms": 7, "mfc": "none", "mec": ORANGE, "mew": 1.4}
                axes.plot([point.x for point in points], [point.y for point in points], zorder=5, **look)  # type: ignore[arg-type]
                handles.append(Line2D([], [], label=label, **look))  # type: ignore[arg-type]
        axes.set(
            xlabel="x (pixels)", ylabel="y (pixels)", xlim=(left - 0.5, right - 0.5), ylim=(bottom - 0.5, top - 0.5)
        )
        if in_column(axes):
            axes.locator_params(nbins=5)
        add_sheet_legend(figure, handles, 4)
        return describe(figure, _trace_text(trace))


def _window(trace: Trace, points: Array) -> tuple[int, int, int, int]:
    """Return the part of the picture to show, in pixels: left, top, right and bottom."""
    height, width = trace.picture.pixels.shape[:2]
    around = _AROUND * float(np.ptp(points, axis=0).max())
    left, top = np.floor(np.maximum(points.min(axis=0) - around, 0)).astype(int).tolist()
    right, bottom = np.ceil(np.minimum(points.max(axis=0) + around, [width, height])).astype(int).tolist()
    return left, top, right, bottom


def _draw_edges(trace: Trace, axes: Axes, places: Array) -> list[Artist]:
    """Draw the edges, the doubtful ones on a broad band; return the legend's entries."""
    handles = list[Artist]()
    doubtful = [places[list(edge.vertices)] for edge in trace.edges if edge.doubt]
    if doubtful:
        axes.add_collection(LineCollection(doubtful, colors=[ORANGE], linewidths=6, alpha=0.45, zorder=2))
    for letter, name in ASSIGNMENTS.items():
        lines = [places[list(edge.vertices)] for edge in trace.edges if edge.letter == letter]
        if lines:
            axes.add_collection(LineCollection(lines, colors=[_COLOURS[letter]], linewidths=1.3, zorder=3))
            handles.append(Line2D([], [], color=_COLOURS[letter], lw=1.3, label=f"{name} ({len(lines)})"))
    if doubtful:
        handles.append(Line2D([], [], color=ORANGE, lw=6, alpha=0.45, label=f"doubtful ({len(doubtful)})"))
    return handles


def _trace_text(trace: Trace) -> str:
    letters = [edge.letter for edge in trace.edges]
    counts = ", ".join(f"{letters.count(letter)} {name}" for letter, name in ASSIGNMENTS.items() if letter in letters)
    doubtful = sum(bool(edge.doubt) for edge in trace.edges)
    doubt = f"{doubtful} edges are doubtful." if doubtful else "No edge is doubtful."
    return (
        f"Pattern traced in {trace.name or 'a picture'}, over the picture. {len(trace.vertices)} vertices; edges:"
        f" {counts}. {doubt}"
    )


def draw_deviations(trace: Trace, width: float = PAGE_WIDTH) -> Figure:
    """Draw the traced pattern with the deviation from Kawasaki's condition at every interior vertex.

    Args:
        trace: trace of a picture.
        width: largest width of the figure, inch.
    """
    size = max(trace.width, trace.height)
    unit, factor = reading_unit("m", size)
    points = factor * trace.pattern.vertices_coords[:, :2]
    residuals = {
        vertex.vertex: abs(math.degrees(vertex.kawasaki)) for vertex in trace.vertices if vertex.kawasaki is not None
    }
    with figure_style():
        figure, axes = sheet_axes(points, factor * size, unit, width)
        handles = draw_creases(axes, flat_net(trace.pattern), factor)
        if residuals:
            dots = axes.scatter(
                points[list(residuals), 0],
                points[list(residuals), 1],
                c=list(residuals.values()),
                cmap=QUANTITY_COLOURS,
                vmin=0.0,
                vmax=max(*residuals.values(), _LEAST_RESIDUAL),
                s=34,
                ec=BLACK,
                lw=0.5,
                zorder=3,
            )
            label = "deviation from Kawasaki's condition (deg)"
            figure.colorbar(dots, ax=axes, label=label, orientation="horizontal", aspect=30, pad=0.02)
            figure.set_figheight(figure.get_figheight() + _BAR)
        odd = [item.vertex for item in trace.vertices if item.creases is not None and item.creases % 2]
        failing = [item.vertex for item in trace.vertices if item.maekawa]
        for chosen, marker, label in ((odd, "D", "odd number of creases"), (failing, "s", "Maekawa fails")):
            if chosen:
                look = {"marker": marker, "ls": "none", "ms": 9, "mfc": "none", "mec": VERMILION, "mew": 1.2}
                axes.plot(*points[chosen].T, zorder=4, **look)  # type: ignore[arg-type]
                handles.append(Line2D([], [], label=label, **look))  # type: ignore[arg-type]
        add_sheet_legend(figure, handles, 4)
        return describe(figure, _deviation_text(trace, residuals))


def _deviation_text(trace: Trace, residuals: dict[int, float]) -> str:
    extent = f"{show_value(trace.width, 'm')} by {show_value(trace.height, 'm')}"
    if not residuals:
        return f"Traced pattern, {extent}. It has no interior vertex with an even number of creases."
    worst = max(residuals, key=lambda vertex: residuals[vertex])
    return (
        f"Deviations from Kawasaki's condition at {len(residuals)} interior vertices of the traced pattern, {extent}."
        f" The largest is {residuals[worst]:.2g} deg, at vertex {worst}."
    )
