"""Responses of a workbench about a picture: its scale, its junctions, its trace, and the pattern drawn on it."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import numpy as np

from forficula.arrays import Array
from forficula.errors import InputError
from forficula.pattern import CreasePattern, write_fold
from forficula.pattern.files.fold_file import fold_pattern
from forficula.pattern.picture.homography import (
    check_corners,
    homography,
    mapped_points,
    metres_per_pixel,
    side_ratio,
)
from forficula.pattern.picture.picture_file import picture_of_content
from forficula.pattern.picture.straighten import straightened
from forficula.pattern.picture.trace_options import read_corners, read_length, read_size
from forficula.pattern.picture.trace_picture import snapping_points, trace_picture
from forficula.quantities import show_value
from forficula.workbench.requests import Opened, reading_for_page
from forficula.workbench.trace_requests import (
    DrawnPatternRequest,
    PictureRequest,
    ScaleRequest,
    StraightenRequest,
    TraceRequest,
)

_LEAST_DISTANCE = 2.0  # [chosen] pixels between the two points of a length


def scale_response(request: ScaleRequest) -> dict[str, Any]:
    """Return the matrix that maps pixels to m, and the size of the clicked sheet or length, for JSON.

    Raises:
        InputError: a length or points that give no scale.
    """
    matrix, size, estimated = _scale(request)
    middle = np.array([request.points], dtype=np.float64).mean(axis=1)
    return {
        "matrix": matrix.tolist(),
        "size": " x ".join(show_value(length, "m") for length in size),
        "estimated": estimated,
        "pixel": show_value(float(metres_per_pixel(matrix, middle)[0]), "m"),
    }


def _scale(request: ScaleRequest) -> tuple[Array, tuple[float, ...], str]:
    """Return the matrix from pixels to m, the distance or width and height, m, and how a side was estimated."""
    points = np.array(request.points, dtype=np.float64)
    if len(points) == 2:
        length = read_length(request.size, "length")
        distance = float(np.linalg.norm(points[1] - points[0]))
        if distance < _LEAST_DISTANCE:
            raise InputError(f"need two points at least {_LEAST_DISTANCE:g} pixels apart, got {distance:.3g} pixels")
        factor = length / distance
        # the y axis of a pattern points upwards
        matrix = np.array([[factor, 0, 0], [0, -factor, factor * (request.height - 1)], [0, 0, 1]])
        return matrix, (length,), ""
    width, height = read_size(request.size)
    check_corners(points, request.width, request.height)
    estimated = ""
    if height is None:
        centre = (np.array([request.width, request.height]) - 1) / 2
        ratio, by_perspective = side_ratio(points, centre)
        width, height = (width, width / ratio) if ratio >= 1 else (width * ratio, width)
        estimated = "the perspective" if by_perspective else "the lengths of the sides in the picture"
    matrix = homography(points, np.array([[0, height], [width, height], [width, 0], [0, 0]]))
    return matrix, (width, height), estimated


def junctions_response(request: PictureRequest) -> dict[str, Any]:
    """Return the points of a picture to which clicks snap, for JSON; none, with the reason, without drawn lines.

    Raises:
        InputError: the content is no picture that `forficula trace` reads.
    """
    picture = picture_of_content(request.picture, request.name)
    height, width = picture.pixels.shape[:2]
    try:
        points, reason = snapping_points(picture).tolist(), ""
    except InputError as error:
        points, reason = [], str(error)
    return {"points": points, "reason": reason, "width": width, "height": height}


def trace_response(request: TraceRequest) -> dict[str, Any]:
    """Trace a picture as `forficula trace` does; return vertices in pixels, edges, scale and doubts, for JSON.

    Raises:
        InputError: as for `trace_picture`, or a size or corners that cannot be read.
    """
    size = read_size(request.size)
    corners, rectify = read_corners(request.corners or None)
    trace = trace_picture(picture_of_content(request.picture, request.name), size, corners, rectify=rectify)
    matrix = np.array(trace.homography)
    vertices = [[vertex.picture_x, vertex.picture_y] for vertex in trace.vertices]
    if trace.corners:
        points = [[corner.x, corner.y] for corner in trace.corners]
        upper_left, upper_right, lower_right, _ = mapped_points(matrix, np.array(points))
        lengths = [np.linalg.norm(upper_right - upper_left), np.linalg.norm(lower_right - upper_right)]
    else:
        offsets = np.linalg.norm(np.array(vertices) - vertices[0], axis=1)
        points = [vertices[0], vertices[int(offsets.argmax())]]
        one, other = mapped_points(matrix, np.array(points))
        lengths = [np.linalg.norm(other - one)]
    return {
        "vertices": vertices,
        "edges": [list(edge.vertices) for edge in trace.edges],
        "letters": [edge.letter for edge in trace.edges],
        "scale": {"points": points, "size": " x ".join(f"{float(length):.12g} m" for length in lengths)},
        "doubts": {
            "edges": {edge.edge: edge.doubt for edge in trace.edges if edge.doubt},
            "vertices": {vertex.vertex: vertex.doubt for vertex in trace.vertices if vertex.doubt},
            "points": [[point.x, point.y, point.what] for point in (*trace.free_ends, *trace.left_over)],
            "whole": list(trace.doubts),
        },
        "said": f"{show_value(trace.width, 'm')} x {show_value(trace.height, 'm')}",
    }


def drawn_pattern_response(request: DrawnPatternRequest, opened: Opened) -> dict[str, Any]:
    """Return the FOLD file of a drawn pattern, with the scale of its picture, for JSON.

    Raises:
        InputError: no scale, or the edges are no crease pattern.
    """
    pattern, remarks, matrix = _drawn_pattern(request, opened)
    return {"fold": _fold_text(pattern, matrix, request), "remarks": remarks, "size": _size_text(pattern)}


def straightened_response(request: StraightenRequest, opened: Opened) -> dict[str, Any]:
    """Return a drawn pattern after the least movement to flat-foldability, in pixels, for JSON.

    Raises:
        InputError: no scale, the edges are no crease pattern, or as for `straightened`.
    """
    tolerance = read_length(request.tolerance, "largest movement")
    pattern, remarks, matrix = _drawn_pattern(request, opened)
    pattern, straightening = straightened(pattern, tolerance)
    pixels = mapped_points(np.asarray(np.linalg.inv(matrix), dtype=np.float64), pattern.vertices_coords[:, :2])
    return {
        "vertices": pixels.tolist(),
        "edges": pattern.edges_vertices.tolist(),
        "letters": list(pattern.edges_assignment),
        "remarks": remarks,
        "largest": show_value(straightening.largest, "m"),
        "flat": straightening.flat_vertices,
        "straight": straightening.straight_lines,
        "symmetries": list(straightening.symmetries),
    }


def _drawn_pattern(request: DrawnPatternRequest, opened: Opened) -> tuple[CreasePattern, list[str], Array]:
    """Read a drawn pattern as a FOLD file without faces.

    Returns:
        The pattern with its lower left corner at the origin, remarks, and the matrix from pixels to its coordinates.
    """
    if len(request.edges) < 3:
        raise InputError(f"need edges that enclose a face, got {len(request.edges)} edges")
    matrix, _, _ = _scale(request.scale)
    pixels = np.array(request.vertices, dtype=np.float64).reshape(-1, 2)
    if max(max(edge) for edge in request.edges) >= len(pixels) or len(request.letters) != len(request.edges):
        raise InputError("need edges between vertices, and a letter for every edge")
    document = {
        "file_spec": 1.2,
        "frame_title": f"drawn on {request.name}" if request.name else "drawn on a picture",
        "frame_unit": "m",
        "vertices_coords": mapped_points(matrix, pixels).tolist(),
        "edges_vertices": request.edges,
        "edges_assignment": request.letters,
    }
    with TemporaryDirectory(prefix="forficula-") as name:
        file = Path(name) / "drawn.fold"
        file.write_text(json.dumps(document), "utf-8")
        try:
            with reading_for_page(opened, Path(name)):
                pattern, remarks = fold_pattern(file)
        except InputError as error:
            raise InputError(str(error).rpartition("drawn.fold: ")[2]) from None
    lower_left = pattern.vertices_coords.min(axis=0)
    moved = np.array([[1, 0, -lower_left[0]], [0, 1, -lower_left[1]], [0, 0, 1]]) @ matrix
    pattern = replace(pattern, vertices_coords=pattern.vertices_coords - lower_left)
    return pattern, [remark for remark in remarks if " found between " not in remark], moved / moved[2, 2]


def _fold_text(pattern: CreasePattern, matrix: Array, request: DrawnPatternRequest) -> str:
    """Return the text of a FOLD file with the scale of the picture, under the same keys as those of a trace."""
    name = request.name or "a picture"
    pixels = np.array(request.vertices, dtype=np.float64).mean(axis=0)[np.newaxis]
    corners = [list(point) for point in request.scale.points] if len(request.scale.points) == 4 else []
    pixel = float(metres_per_pixel(matrix, pixels)[0])
    with TemporaryDirectory(prefix="forficula-") as folder:
        file = Path(folder) / "drawn.fold"
        write_fold(
            pattern,
            file,
            description=f"Drawn on {name}; one pixel in the middle of the pattern is {show_value(pixel, 'm')}.",
            metadata={
                "picture": {
                    "name": request.name,
                    "metres_per_pixel": pixel,
                    "homography_from_pixels_to_m": matrix.tolist(),
                    "corners": corners,
                }
            },
        )
        return file.read_text("utf-8")


def _size_text(pattern: CreasePattern) -> str:
    width, height = np.ptp(pattern.vertices_coords[:, :2], axis=0).tolist()
    return f"{show_value(width, 'm')} x {show_value(height, 'm')}"
