"""Reading of crease patterns from drawings: lines become edges, and the areas that they enclose become faces."""

from __future__ import annotations

import math
import os
from collections import Counter
from collections.abc import Mapping, Sequence
from pathlib import Path

import numpy as np

from forficula.arrays import Array, Indices
from forficula.errors import InputError
from forficula.files import shown_path
from forficula.names import listed
from forficula.pattern.crease_pattern import ASSIGNMENTS, CreasePattern, face_sides
from forficula.pattern.drawings.drawing import Drawing, DrawnLine
from forficula.pattern.drawings.dxf_reader import read_dxf
from forficula.pattern.drawings.flat_faces import faces_between, parts_of
from forficula.pattern.drawings.line_network import LineNetwork, line_network, place_text
from forficula.pattern.drawings.svg_reader import read_svg
from forficula.pattern.files.fold_frame import CHOSEN_UNIT, chosen_unit, target_angles
from forficula.quantities import show_value

_TOLERANCE = 1e-4  # share of the drawing's size: drawing programs round to 1e-5, and 1e-3 is visible
_SMALLEST, _LARGEST = 1e-12, 1e6  # m


def read_drawing(
    path: str | os.PathLike[str],
    unit: float | None = None,
    tolerance: float | None = None,
    *,
    choose_unit: bool = False,
) -> tuple[CreasePattern, list[str]]:
    """Read a crease pattern from an SVG or DXF drawing.

    Colours, or the names of layers and groups, define the kinds of lines (see `read_svg` and `read_dxf`). Ends that
    nearly meet are joined, lines are split where they cross or touch, and duplicate lines are merged. An area that
    lines enclose is a face, except for holes, which only border and cuts enclose. An edge of a single face is a border,
    and a border between two faces is a cut. Flat lines that end inside a face are left out.

    Args:
        path: path of the file, .svg or .dxf.
        unit: unit of length, m, if the file does not give it; pixels of an SVG are 1/96 inch by default.
        tolerance: largest gap between ends and lines that are joined, m; by default 1e-4 of the drawing's larger side.
        choose_unit: as for `read_pattern`.

    Returns:
        The pattern in metres, flat in z = 0 with its lower left corner at the origin and y up; and remarks on what was
        joined, split, found and left out.

    Raises:
        InputError: the file cannot be read, has no unit of length, or has curves, or its lines do not form a pattern;
            the message names the file and the line.
    """
    file = Path(path)
    try:
        with np.errstate(over="ignore", invalid="ignore"):  # the resulting size is checked later
            drawing = read_dxf(file) if file.suffix.lower() == ".dxf" else read_svg(file)
            metres, remarks = _metres(drawing, unit, choose_unit=choose_unit)
            pattern, more = _pattern_of(drawing, metres, tolerance)
    except InputError as error:
        raise InputError(f"{shown_path(file)}: {error}") from error
    return pattern, [*drawing.remarks, *remarks, *more]


def _metres(drawing: Drawing, unit: float | None, *, choose_unit: bool) -> tuple[float, list[str]]:
    """Return the unit of length of the drawing, m, and remarks."""
    if unit is not None:
        if not (math.isfinite(unit) and unit > 0):
            raise InputError(f"unit: need a length > 0, got {unit:g} m")
        if drawing.unit is not None and not math.isclose(unit, drawing.unit, rel_tol=1e-6):
            raise InputError(
                f"unit: need none beside that of the file, {show_value(drawing.unit, 'm')}, got"
                f" {show_value(unit, 'm')}; leave it out"
            )
        return drawing.unit or unit, []
    if drawing.unit is not None:
        return drawing.unit, []
    if drawing.assumed_unit is not None:
        return drawing.assumed_unit, ["the file gives its size in pixels: taken as 1/96 inch, as no unit is given"]
    if choose_unit:
        ends = np.array([(line.start, line.end) for line in drawing.lines])
        return chosen_unit(float(np.ptp(ends, axis=(0, 1)).max())), [CHOSEN_UNIT]
    raise InputError(
        "unit: need the length of the drawing's unit, got none in the file; give it: in a design"
        ' pattern.unit = "1 mm", on the command line --unit "1 mm"'
    )


def _pattern_of(drawing: Drawing, metres: float, tolerance: float | None) -> tuple[CreasePattern, list[str]]:
    """Convert the lines of a drawing to a pattern."""
    lines = drawing.lines
    ends = metres * np.array([(line.start, line.end) for line in lines])
    ends -= ends.min(axis=(0, 1))
    size = float(ends.max())
    if not _SMALLEST <= size <= _LARGEST:
        raise InputError(
            f"need a drawing of a size from {_SMALLEST:g} m to {_LARGEST:g} m, got {size:g} m, in units of {metres:g} m"
        )
    if tolerance is None:
        tolerance = _TOLERANCE * size
    elif not 0 < tolerance < size:
        raise InputError(f"tolerance: need > 0 m and < {size:g} m, the drawing's size, got {tolerance:g} m")
    network = line_network(lines, ends, tolerance)
    remarks = _network_remarks(network, tolerance)
    kept = _closed_edges(network, lines, remarks)
    edges = network.edges[kept]
    drawn = [lines[line] for line in network.lines[kept].tolist()]
    faces = _faces(network.points, edges, drawn, remarks)
    faces_at = Counter(frozenset(side) for face in faces for side in face_sides(face))
    counts = np.array([faces_at[frozenset(pair)] for pair in edges.tolist()])
    letters = _letters_by_faces([line.letter for line in drawn], counts, remarks)
    beside = np.flatnonzero(counts > 0)
    vertices = _in_order(edges[beside])
    number = {vertex: place for place, vertex in enumerate(vertices)}
    angles = np.array([drawn[edge].fold_angle for edge in beside.tolist()])
    letters = [letters[edge] for edge in beside.tolist()]
    points = network.points[vertices] - network.points[vertices].min(axis=0)
    pattern = CreasePattern(
        vertices_coords=np.column_stack([points, np.zeros(len(points))]),
        edges_vertices=np.array([[number[end] for end in pair] for pair in edges[beside].tolist()]),
        edges_assignment=tuple(letters),
        edges_fold_angle=target_angles(letters, angles),
        faces_vertices=tuple(tuple(number[vertex] for vertex in face) for face in faces),
        title=drawing.title,
    )
    return pattern, remarks


def _in_order(edges: Indices) -> list[int]:
    """Return the vertices of edges in order of appearance."""
    return list(dict.fromkeys(edges.ravel().tolist()))


def _network_remarks(network: LineNetwork, tolerance: float) -> list[str]:
    """Return remarks on the changes of the lines."""
    remarks = []
    near = f"the tolerance is {show_value(tolerance, 'm')}"
    if count := len(network.gaps):
        gaps = "1 gap" if count == 1 else f"{count} gaps"
        remarks.append(f"{gaps} between ends closed, the largest {show_value(network.gaps.max(), 'm')} wide; {near}")
    if network.crossings:
        places = "1 place" if network.crossings == 1 else f"{network.crossings} places"
        remarks.append(f"lines split where they cross, at {places}")
    if network.lost:
        remarks.append(f"lines left out because they are too short, {network.lost}; {near}")
    return remarks


def _closed_edges(network: LineNetwork, lines: Sequence[DrawnLine], remarks: list[str]) -> Indices:
    """Return the edges without flat ones with free ends; raise InputError for other free ends and separate parts."""
    edges, kept = network.edges, np.arange(len(network.edges))
    flat = np.array([lines[line].letter == "F" for line in network.lines.tolist()], dtype=bool)
    while True:
        degrees = np.bincount(edges[kept].ravel(), minlength=len(network.points))
        free = (degrees[edges[kept]] == 1).any(axis=1)
        if not (free & flat[kept]).any():
            break
        kept = kept[~(free & flat[kept])]
    if lost := len(edges) - len(kept):
        remarks.append(f"flat lines that end inside a face left out, {lost} pieces")
    if free.any():
        edge = int(kept[np.argmax(free)])
        end = next(vertex for vertex in edges[edge].tolist() if degrees[vertex] == 1)
        name, distance = lines[network.lines[edge]].name, _nearest_line(network, kept, edge, end)
        far = f"; the nearest other line is {show_value(distance, 'm')} away: draw it to there, or give a tolerance"
        raise InputError(
            f"{name}: need lines that continue to others, got a free end {place_text(network.points[end])}"
            f"{f'{far} above that' if math.isfinite(distance) else ', and no other line'}"
        )
    if len(kept) == 0:
        raise InputError("need lines that enclose faces, got none")
    parts = parts_of(len(network.points), edges[kept])[edges[kept][:, 0]]
    numbers, sizes = np.unique(parts, return_counts=True)
    if len(numbers) > 1:
        edge = int(kept[np.argmax(parts == numbers[np.argmin(sizes)])])
        raise InputError(
            f"{lines[network.lines[edge]].name}: need lines that are connected, got {len(numbers)} parts; that of this"
            f" line has {sizes.min()} lines and lies {place_text(network.points[edges[edge, 0]])}"
        )
    return kept


def _nearest_line(network: LineNetwork, kept: Indices, edge: int, end: int) -> float:
    """Compute the distance of a free end from the nearest other line, m."""
    others = network.edges[kept[kept != edge]]
    starts, along = network.points[others[:, 0]], network.points[others[:, 1]] - network.points[others[:, 0]]
    offset = network.points[end] - starts
    share = np.clip((offset * along).sum(axis=1) / (along**2).sum(axis=1), 0, 1)
    distances = np.linalg.norm(offset - share[:, np.newaxis] * along, axis=1)
    return float(distances[~(others == network.edges[edge].sum() - end).any(axis=1)].min(initial=np.inf))


def _faces(points: Array, edges: Indices, drawn: Sequence[DrawnLine], remarks: list[str]) -> list[list[int]]:
    """Return the faces between the edges, without holes."""
    lines = {frozenset(pair): line for pair, line in zip(edges.tolist(), drawn, strict=True)}
    enclosed = faces_between(points, edges)
    for face in enclosed:
        _check_surrounded(points, face, lines)
    faces = [face for face in enclosed if any(lines[frozenset(side)].letter not in "BC" for side in face_sides(face))]
    if len(enclosed) == 1:
        return enclosed
    if holes := len(enclosed) - len(faces):
        remarks.append(f"holes, which only border and cuts enclose, {holes}")
    if not faces:
        raise InputError("need faces with creases between them, got border and cuts only")
    remarks.append(f"faces found between the lines, {len(faces)}")
    return faces


def _check_surrounded(points: Array, face: Sequence[int], lines: Mapping[frozenset[int], DrawnLine]) -> None:
    """Refuse a face whose boundary is not a simple polygon."""
    if len(set(face)) == len(face):
        return
    sides = face_sides(face)
    for tail, head in sides:
        if (head, tail) in sides:
            raise InputError(
                f"{lines[frozenset((tail, head))].name}: need different faces on both sides, got the same face"
                f" around it, {place_text((points[tail] + points[head]) / 2)}; connect what it leads to by other lines"
            )
    twice = next(vertex for place, vertex in enumerate(face) if vertex in face[:place])
    raise InputError(
        f"need faces that are simple polygons, got one that touches itself {place_text(points[twice])}; connect what"
        " lies inside by other lines"
    )


def _letters_by_faces(letters: Sequence[str], counts: Indices, remarks: list[str]) -> list[str]:
    """Return the letters, with border on all edges of a single face and on no others."""
    rim = Counter(
        letter for letter, count in zip(letters, counts.tolist(), strict=True) if count == 1 and letter != "B"
    )
    if rim:
        drawn = listed(f"{count} drawn as {ASSIGNMENTS[letter]}" for letter, count in sorted(rim.items()))
        remarks.append(f"edges at the rim of the sheet taken as border, {drawn}")
    inside = sum(letter == "B" and count == 2 for letter, count in zip(letters, counts.tolist(), strict=True))
    if inside:
        remarks.append(f"border between two faces taken as a cut, {inside} edges")
    return [
        "B" if count == 1 else "C" if letter == "B" else letter
        for letter, count in zip(letters, counts.tolist(), strict=True)
    ]
