"""A trace of a picture as text."""

from __future__ import annotations

import math
from collections import Counter

import numpy as np
from rich.console import Console, Group, RenderableType
from rich.table import Table
from rich.text import Text

from forficula.names import listed
from forficula.pattern import ASSIGNMENTS, Trace
from forficula.quantities import show_value

_MOST_ROWS = 12
_SOURCES = {
    "sheet": "edge of the sheet, found",
    "given": "given",
    "none": "none: perspective is not corrected",
}


def print_trace(trace: Trace) -> None:
    """Print a trace."""
    Console(width=110, highlight=False).print(trace_table(trace))


def trace_table(trace: Trace) -> RenderableType:
    """Return the size and the accuracy of a trace, and its doubts."""
    parts: list[RenderableType] = [Text(_heading(trace), style="bold"), Text(), _facts(trace)]
    doubts = Counter((edge.letter, edge.doubt) for edge in trace.edges if edge.doubt)
    if doubts:
        table = _columns("edges that are doubtful", "letter", "reason", "numbers")
        for (letter, doubt), count in doubts.most_common(_MOST_ROWS):
            numbers = [edge.edge for edge in trace.edges if (edge.letter, edge.doubt) == (letter, doubt)]
            table.add_row(str(count), letter, doubt, _numbers(numbers))
        parts += [Text(), table]
    vertices = [vertex for vertex in trace.vertices if vertex.doubt]
    if vertices:
        table = _columns("vertex that is doubtful", "position", "reason")
        for vertex in vertices[:_MOST_ROWS]:
            table.add_row(str(vertex.vertex), _position(vertex.x, vertex.y), vertex.doubt)
        parts += [Text(), table]
    worst = sorted(
        (vertex for vertex in trace.vertices if vertex.kawasaki is not None),
        key=lambda vertex: -abs(vertex.kawasaki or 0.0),
    )
    if worst:
        table = _columns("largest deviations, at vertex", "Kawasaki", "Maekawa", "standard error")
        for vertex in worst[: _MOST_ROWS // 2]:
            maekawa = "unknown" if vertex.maekawa is None else "holds" if vertex.maekawa == 0 else "fails"
            residual = f"{math.degrees(abs(vertex.kawasaki or 0.0)):.2g} deg"
            table.add_row(str(vertex.vertex), residual, maekawa, show_value(vertex.standard_error, "m", 2))
        parts += [Text(), table]
    return Group(*parts, Text(), *map(Text, _sentences(trace)))


def _heading(trace: Trace) -> str:
    doubtful = sum(bool(edge.doubt) for edge in trace.edges)
    doubt = f"{doubtful} edge{'s' * (doubtful != 1)} doubtful" if doubtful else "no edge doubtful"
    extent = f"{show_value(trace.width, 'm')} by {show_value(trace.height, 'm')}"
    name = trace.name or "picture"
    return f"{name}: {len(trace.vertices)} vertices, {len(trace.edges)} edges, {extent}; {doubt}"


def _facts(trace: Trace) -> Table:
    table = _columns("", "")
    table.show_header = False
    letters = [edge.letter for edge in trace.edges]
    counts = (f"{letters.count(letter)} {name}" for letter, name in ASSIGNMENTS.items() if letter in letters)
    table.add_row("edges", ", ".join(counts))
    table.add_row("corners", _SOURCES[trace.corner_source])
    if trace.corner_residual is not None:
        table.add_row("residual of the sheet's edge", f"{trace.corner_residual:.2g} pixels")
    table.add_row("scale", f"{show_value(trace.pixel_size, 'm')} per pixel")
    table.add_row("width of a line", f"{trace.line_width:.2g} pixels")
    table.add_row("residual of the lines", f"{trace.line_residual:.2g} pixels")
    errors = [vertex.standard_error for vertex in trace.vertices]
    median, most = show_value(float(np.median(errors)), "m", 2), show_value(max(errors), "m", 2)
    table.add_row("standard error of a vertex", f"median {median}, largest {most}")
    return table


def _sentences(trace: Trace) -> list[str]:
    sentences = list(trace.doubts)
    done = trace.straightening
    if done is not None:
        exact = [*done.symmetries, f"Kawasaki's condition at {done.flat_vertices} vertices"]
        sentences.append(
            f"Straightened: vertices moved by up to {show_value(done.largest, 'm', 3)} (root mean square"
            f" {show_value(done.mean, 'm', 3)}, allowed {show_value(done.tolerance, 'm')}). Now exact: {listed(exact)},"
            f" and {done.straight_lines} pairs of edges in line."
        )
    return sentences


def _columns(*headings: str) -> Table:
    table = Table(box=None, padding=(0, 2, 0, 0))
    for heading in headings:
        table.add_column(heading)
    return table


def _numbers(numbers: list[int]) -> str:
    shown = ", ".join(map(str, numbers[:8]))
    return f"{shown} and {len(numbers) - 8} more" if len(numbers) > 8 else shown


def _position(x: float, y: float) -> str:
    return f"{show_value(x, 'm', 3)}, {show_value(y, 'm', 3)}"
