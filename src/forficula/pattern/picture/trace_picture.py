"""Tracing: from a picture of a drawn crease pattern to a pattern with its scale."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from typing import Literal

import numpy as np

from forficula.arrays import Array, Flags, Indices
from forficula.errors import InputError
from forficula.pattern.crease_pattern import CreasePattern
from forficula.pattern.facts.flat_folding import VertexCheck, vertex_checks
from forficula.pattern.picture.drawn_segments import drawn_segments
from forficula.pattern.picture.homography import (
    check_corners,
    homography,
    mapped_points,
    metres_per_pixel,
    side_ratio,
)
from forficula.pattern.picture.ink import Ink, full_places, ink_of
from forficula.pattern.picture.ink_letters import MERGED, InkOfEdge, ink_along_edge, letters_of_ink
from forficula.pattern.picture.junctions import Junctions, junctions, snapped_points
from forficula.pattern.picture.picture_file import Picture
from forficula.pattern.picture.ridge_points import RidgePoints, ridge_points
from forficula.pattern.picture.sheet_corners import SheetCorners, find_corners
from forficula.pattern.picture.straighten import straightened
from forficula.pattern.picture.trace import PicturePoint, Trace, TracedEdge, TracedVertex
from forficula.pattern.picture.traced_pattern import (
    EnclosedFaces,
    enclosed_faces,
    pattern_of_edges,
    without_straight_vertices,
)
from forficula.pattern.picture.unexplained_ink import free_ends_of, left_over_ink, unexplained_sentences
from forficula.quantities import show_value

CornerSource = Literal["sheet", "given", "none"]

_PIXELS = 3e6  # [chosen] number of pixels above which a picture is reduced, where its lines are wide enough
_LEAST_WIDTH = 2.5  # [chosen] pixels, width of a line in a reduced picture
_SNAP = 0.015  # [chosen] of the sheet's diagonal, by which corners move to those that are found
_RIM = 0.006  # [chosen] of the sheet's diagonal beside its edge that is not searched for lines
_AROUND = 0.04  # [chosen] of the diagonal around given corners that is searched for lines
_MERGING = math.radians(12)  # [chosen] angle below which lines at a vertex merge
_LEAST_ANGLE = 1e-3  # rad
_UNCERTAIN = 0.002  # [chosen] standard error of a vertex, as a share of the pattern's size, that is doubtful
_NO_SHEET = (
    "No edge of a sheet was found, so perspective is not corrected. Give the corners of the sheet if the picture was"
    " not taken exactly from above."
)
_SIDES_DIFFER = 0.01  # [chosen] relative difference of the given sides' ratio from the drawn one


def trace_picture(
    picture: Picture, size: tuple[float, float | None], corners: Array | None = None, *, rectify: bool = True
) -> Trace:
    """Trace a drawn crease pattern.

    Args:
        picture: photograph, scan or drawing.
        size: width and height of the sheet whose corners are found or given, m, or its longer side and None. Without
            corners: of the pattern.
        corners: corners of the sheet, pixels, clockwise from the upper left one, shape (4, 2); corners that are closer
            than 1.5 % to a found corner or junction move there. None to find them.
        rectify: whether to find corners; False for a scan.

    Raises:
        InputError: a size or corners that are not allowed, or no lines that enclose faces.
    """
    _check_size(size)
    height, width = picture.pixels.shape[:2]
    if corners is not None:
        check_corners(corners, width, height)
    sheet = find_corners(picture.pixels.mean(axis=2)) if rectify or corners is not None else None
    inside = _searched(width, height, sheet, corners)
    reduced, ink = _reduced_ink(picture.pixels, inside)
    ridges = ridge_points(ink)
    segments, left = drawn_segments(ridges, ink)
    network = junctions(segments, ink.line_width)
    if not len(network.edges):
        raise InputError("need lines that meet, got none")
    places = full_places(network.places, reduced)
    doubts: list[str] = []
    frame = _frame(size, corners, sheet, places, (width, height), doubts)
    if frame is None and rectify:
        doubts.append(_NO_SHEET)
    upwards = np.array([[1.0, 0, 0], [0, -1.0, height - 1.0], [0, 0, 1]])
    matrix = upwards if frame is None else homography(*frame)
    points = mapped_points(matrix, places)
    enclosed = enclosed_faces(points, network.edges)
    if frame is None:
        matrix = _scale_of_pattern(size, points[np.unique(network.edges[enclosed.edges])], doubts) @ matrix
        points = mapped_points(matrix, places)
    source: CornerSource = "none" if frame is None else "given" if corners is not None else "sheet"
    return _trace_of(
        picture=picture,
        reduced=reduced,
        ink=ink,
        ridges=ridges,
        left=left,
        network=network,
        enclosed=enclosed,
        matrix=matrix,
        points=points,
        source=source,
        corners=None if frame is None else frame[0],
        sheet=sheet,
        doubts=doubts,
    )


def snapping_points(picture: Picture) -> Array:
    """Find the points of a picture to which clicks may move: junctions of drawn lines, and corners of the sheet.

    Args:
        picture: photograph, scan or drawing.

    Returns:
        Pixels, shape (N, 2).

    Raises:
        InputError: no ink is found.
    """
    height, width = picture.pixels.shape[:2]
    sheet = find_corners(picture.pixels.mean(axis=2))
    try:
        reduced, ink = _reduced_ink(picture.pixels, _searched(width, height, sheet, None))
    except InputError:
        # the bright part without lines may be the inside of a drawn frame
        sheet = None
        reduced, ink = _reduced_ink(picture.pixels, _searched(width, height, None, None))
    segments, _ = drawn_segments(ridge_points(ink), ink)
    places = full_places(junctions(segments, ink.line_width).places, reduced)
    return places if sheet is None else np.concatenate([places, sheet.corners])


def _check_size(size: tuple[float, float | None]) -> None:
    for length in size:
        if length is not None and not (math.isfinite(length) and 1e-6 <= length <= 1e3):
            raise InputError(f"size: need a length from 1 um to 1 km, got {length:g} m")


def _searched(width: int, height: int, sheet: SheetCorners | None, corners: Array | None) -> Flags:
    """Return the pixels in which lines are searched: the sheet without its rim."""
    inside = np.zeros((height, width), dtype=bool)
    if sheet is not None:
        polygon, share = sheet.corners, -_RIM
    elif corners is not None:
        polygon, share = corners, _AROUND
    else:
        inside[2:-2, 2:-2] = True
        return inside
    diagonal = float(np.linalg.norm(polygon[2] - polygon[0]))
    middle = polygon.mean(axis=0)
    away = polygon - middle
    moved = middle + away * (1 + 2 * share * diagonal / np.linalg.norm(away, axis=1, keepdims=True) / math.sqrt(2))
    low = np.clip(np.floor(moved.min(axis=0)).astype(int), 0, [width, height])
    high = np.clip(np.ceil(moved.max(axis=0)).astype(int) + 1, 0, [width, height])
    y, x = np.mgrid[low[1] : high[1], low[0] : high[0]]
    within = np.ones(x.shape, dtype=bool)
    for (left, top), (right, bottom) in zip(moved, np.roll(moved, -1, axis=0), strict=True):
        within &= (right - left) * (y - top) >= (bottom - top) * (x - left)  # clockwise, because y is downwards
    inside[low[1] : high[1], low[0] : high[0]] = within
    return inside


def _reduced_ink(pixels: Array, inside: Flags) -> tuple[int, Ink]:
    """Return the ink in as few pixels as its lines allow, and the number of pixels that became one along each axis."""
    reduced = max(1, round(math.sqrt(inside.sum() / _PIXELS)))
    while True:
        ink = ink_of(*_reduced(pixels, inside, reduced))
        if reduced == 1 or ink.line_width >= _LEAST_WIDTH:
            return reduced, ink
        reduced //= 2


def _reduced(pixels: Array, inside: Flags, step: int) -> tuple[Array, Flags]:
    if step == 1:
        return pixels, inside
    height, width = (size // step for size in inside.shape)
    cut = pixels[: height * step, : width * step].reshape(height, step, width, step, 3)
    mask = inside[: height * step, : width * step].reshape(height, step, width, step)
    return cut.mean(axis=(1, 3)), np.asarray(mask.all(axis=(1, 3)))


def _frame(
    size: tuple[float, float | None],
    corners: Array | None,
    sheet: SheetCorners | None,
    places: Array,
    extent: tuple[int, int],
    doubts: list[str],
) -> tuple[Array, Array] | None:
    """Return the corners of the sheet in the picture and in m; None where the picture is not rectified."""
    if corners is not None:
        reach = _SNAP * float(np.linalg.norm(corners[2] - corners[0]))
        known = places if sheet is None else np.concatenate([sheet.corners, places])
        used, _ = snapped_points(corners, known, reach)
    elif sheet is not None:
        used = sheet.corners
    else:
        return None
    ratio, by_perspective = side_ratio(used, (np.array(extent) - 1) / 2)
    if size[1] is None:
        how = "the perspective" if by_perspective else "the lengths of its sides in the picture"
        longer, shorter = size[0], size[0] * min(ratio, 1 / ratio)
        width, height = (longer, shorter) if ratio >= 1 else (shorter, longer)
        doubts.append(
            f"The shorter side of the sheet, {show_value(shorter, 'm')}, was estimated from {how}. Give width and"
            ' height, such as "29.7 x 21 cm".'
        )
    else:
        width, height = size[0], size[1]
        if by_perspective and abs(math.log(width / height / ratio)) > 0.15:
            doubts.append(
                f"Width / height of the sheet is {width / height:.3g} as given, but about {ratio:.3g} in the picture."
                " Check the order of the numbers and of the corners."
            )
    return used, np.array([[0, height], [width, height], [width, 0], [0, 0]])


def _scale_of_pattern(size: tuple[float, float | None], points: Array, doubts: list[str]) -> Array:
    """Return the matrix that scales a pattern to its size."""
    extent = np.ptp(points, axis=0)
    if size[1] is None:
        factor = size[0] / float(extent.max())
    else:
        ratios = np.array([size[0], size[1]]) / extent
        factor = float(np.sqrt(ratios.prod()))
        if abs(math.log(ratios[0] / ratios[1])) > _SIDES_DIFFER:
            doubts.append(
                f"Width / height of the pattern is {size[0] / size[1]:.4g} as given, but {extent[0] / extent[1]:.4g} in"
                " the picture. The picture may show the sheet at an angle: give its corners."
            )
    return np.diag([factor, factor, 1.0])


def _trace_of(
    *,
    picture: Picture,
    reduced: int,
    ink: Ink,
    ridges: RidgePoints,
    left: Indices,
    network: Junctions,
    enclosed: EnclosedFaces,
    matrix: Array,
    points: Array,
    source: CornerSource,
    corners: Array | None,
    sheet: SheetCorners | None,
    doubts: list[str],
) -> Trace:
    """Collect the trace of a network of lines."""
    enclosed, edges = without_straight_vertices(enclosed, network.edges, network.segments)
    merged, narrow = _merging(network.places, edges, ink.line_width)
    inks = [
        ink_along_edge(ink, network.places[one], network.places[other], share)
        for (one, other), share in zip(edges.tolist(), merged.tolist(), strict=True)
    ]
    letters, reasons = letters_of_ink(inks, enclosed.counts)
    title = f"traced from {picture.name}" if picture.name else "traced pattern"
    pattern, used = pattern_of_edges(points, edges, letters, enclosed.faces, title)
    lower_left = points[used].min(axis=0)
    matrix = np.array([[1, 0, -lower_left[0]], [0, 1, -lower_left[1]], [0, 0, 1]]) @ matrix
    matrix = matrix / matrix[2, 2]
    places = full_places(network.places[used], reduced)
    scale = metres_per_pixel(matrix, places)
    errors = network.errors[used] * reduced * scale
    vertices = _vertices(pattern, places, errors, narrow[used])
    free_ends = free_ends_of(network, enclosed, reduced)
    left_over = left_over_ink(ridges, left, network.places, edges, ink, reduced)
    width, height = np.ptp(pattern.vertices_coords[:, :2], axis=0).tolist()
    return Trace(
        name=picture.name,
        pattern=pattern,
        picture=picture,
        homography=tuple(tuple(row) for row in matrix.tolist()),
        width=width,
        height=height,
        pixel_size=float(metres_per_pixel(matrix, places.mean(axis=0)[np.newaxis])[0]),
        corner_source=source,
        corners=()
        if corners is None
        else tuple(PicturePoint(x=x, y=y, what="corner of the sheet") for x, y in corners.tolist()),
        corner_residual=sheet.residual if sheet is not None and source == "sheet" else None,
        line_width=ink.line_width * reduced,
        line_residual=float(np.sqrt(np.mean([line.residual**2 for line in network.lines]))) * reduced,
        vertices=vertices,
        edges=_traced_edges(pattern, inks, letters, reasons, np.asarray(narrow[edges].any(axis=1))),
        free_ends=free_ends,
        left_over=left_over,
        doubts=(*doubts, *unexplained_sentences(free_ends, left_over)),
    )


def _merging(places: Array, edges: Indices, line_width: float) -> tuple[Array, Flags]:
    """Return the share of every edge in which it merges with others, and the vertices at which lines merge."""
    merged = np.zeros(len(edges))
    narrow = np.zeros(len(places), dtype=bool)
    lengths = np.linalg.norm(places[edges[:, 1]] - places[edges[:, 0]], axis=1)
    for vertex in np.unique(edges).tolist():
        at = np.flatnonzero((edges == vertex).any(axis=1))
        away = places[edges[at].sum(axis=1) - vertex] - places[vertex]
        angles = np.arctan2(away[:, 1], away[:, 0])
        order = np.argsort(angles)
        between = np.diff(angles[order], append=angles[order[0]] + 2 * np.pi)
        least = np.minimum(between, np.roll(between, 1))[np.argsort(order)]
        along = line_width / (2 * np.sin(np.clip(least, _LEAST_ANGLE, np.pi) / 2))
        merged[at] += along / lengths[at]
        narrow[vertex] = bool((least < _MERGING).any())
    narrow[edges[merged > MERGED]] = True
    return merged, narrow


def _vertices(pattern: CreasePattern, places: Array, errors: Array, narrow: Flags) -> tuple[TracedVertex, ...]:
    """Collect the vertices."""
    checks: dict[int, VertexCheck] = {check.vertex: check for check in vertex_checks(pattern)}
    size = float(np.ptp(pattern.vertices_coords, axis=0).max())
    vertices = []
    for number, (place, error) in enumerate(zip(places.tolist(), errors.tolist(), strict=True)):
        x, y, _ = pattern.vertices_coords[number].tolist()
        check = checks.get(number)
        doubt = ""
        if narrow[number]:
            doubt = "lines merge, because they meet at a small angle or close to other vertices"
        elif error > _UNCERTAIN * size:
            doubt = f"the position is uncertain, by {show_value(error, 'm')}"
        vertices.append(
            TracedVertex(
                vertex=number,
                x=x,
                y=y,
                picture_x=place[0],
                picture_y=place[1],
                standard_error=error,
                creases=None if check is None else check.creases,
                kawasaki=None if check is None or math.isinf(check.kawasaki) else check.kawasaki,
                maekawa=None if check is None else check.maekawa,
                doubt=doubt,
            )
        )
    return tuple(vertices)


def _traced_edges(
    pattern: CreasePattern, inks: Sequence[InkOfEdge], letters: Sequence[str], reasons: Sequence[str], merging: Flags
) -> tuple[TracedEdge, ...]:
    """Collect the edges."""
    return tuple(
        TracedEdge(
            edge=number,
            vertices=(ends[0], ends[1]),
            letter=letter,
            colour=ink.ground,
            dashes=ink.dashes,
            agreement=ink.share,
            doubt=reason or ("it ends where lines merge" if merges else ""),
        )
        for number, (ends, ink, letter, reason, merges) in enumerate(
            zip(pattern.edges_vertices.tolist(), inks, letters, reasons, merging.tolist(), strict=True)
        )
    )


def straightened_trace(trace: Trace, tolerance: float) -> Trace:
    """Return a trace with the least movement of vertices to exact symmetry and flat-foldability.

    Args:
        trace: trace of a picture.
        tolerance: largest movement of a vertex, m.

    Raises:
        InputError: as for `straightened`.
    """
    pattern, straightening = straightened(trace.pattern, tolerance)
    errors = np.array([vertex.standard_error for vertex in trace.vertices])
    places = np.array([(vertex.picture_x, vertex.picture_y) for vertex in trace.vertices])
    vertices = _vertices(pattern, places, errors, np.zeros(len(errors), dtype=bool))
    width, height = np.ptp(pattern.vertices_coords[:, :2], axis=0).tolist()
    return replace(
        trace,
        pattern=pattern,
        width=width,
        height=height,
        straightening=straightening,
        vertices=tuple(replace(new, doubt=old.doubt) for new, old in zip(vertices, trace.vertices, strict=True)),
    )
