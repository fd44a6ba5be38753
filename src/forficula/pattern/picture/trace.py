"""Traces: crease patterns that were found in pictures, with their scale and their doubts."""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path
from typing import Annotated

from forficula.pattern.crease_pattern import CreasePattern
from forficula.pattern.files.fold_writer import write_fold
from forficula.pattern.picture.picture_file import Picture
from forficula.pattern.picture.straighten import Straightening
from forficula.quantities import show_value
from forficula.results import Result
from forficula.serial import Metres, Radians, Written


@dataclass(frozen=True, kw_only=True)
class TracedVertex:
    """Vertex of a traced pattern.

    Attributes:
        vertex: number of the vertex.
        x: position in the pattern, m.
        y: position in the pattern, m.
        picture_x: position in the picture, pixels from the middle of the first one.
        picture_y: position in the picture, pixels, downwards.
        standard_error: standard error of the position, from the lines that meet, m.
        creases: number of creases, if the vertex is interior; None on the rim.
        kawasaki: alternating sum of the sectors, rad; None on the rim and for an odd number of creases.
        maekawa: |mountains - valleys| - 2; None on the rim and where a crease is unassigned.
        doubt: why the vertex is doubtful; empty without a doubt.
    """

    vertex: int
    x: Metres
    y: Metres
    picture_x: float
    picture_y: float
    standard_error: Metres
    creases: int | None
    kawasaki: Radians | None
    maekawa: int | None
    doubt: str


@dataclass(frozen=True, kw_only=True)
class TracedEdge:
    """Edge of a traced pattern.

    Attributes:
        edge: number of the edge.
        vertices: numbers of its two vertices.
        letter: letter as in FOLD files; "U" where the kind is doubtful.
        colour: name of the colour; empty where it is doubtful.
        dashes: pattern of its dashes.
        agreement: share of the edge whose colour agrees, 0 to 1.
        doubt: why the edge is doubtful; empty without a doubt.
    """

    edge: int
    vertices: tuple[int, int]
    letter: str
    colour: str
    dashes: str
    agreement: float
    doubt: str


@dataclass(frozen=True, kw_only=True)
class PicturePoint:
    """Point of a picture.

    Attributes:
        x: pixels.
        y: pixels, downwards.
        what: what is there.
    """

    x: float
    y: float
    what: str


@dataclass(frozen=True, kw_only=True, eq=False)
class Trace(Result):
    """Pattern that was traced in a picture.

    Attributes:
        name: name of the picture.
        pattern: the pattern, with its lower left corner at the origin.
        picture: the picture.
        homography: matrix that maps pixels to the pattern's coordinates in m, shape (3, 3).
        width: width of the pattern, m.
        height: height of the pattern, m.
        pixel_size: length on the sheet of a pixel in the middle of the pattern, m.
        corner_source: "sheet" where the corners of the sheet were found, "given", or "none" where the picture is not
            rectified.
        corners: corners of the sheet in the picture; empty without corners.
        corner_residual: root mean square distance of the found edge of the sheet from its lines, pixels; None without.
        line_width: typical width of a line, pixels.
        line_residual: root mean square distance of the centre lines from their straight lines, pixels.
        vertices: vertices.
        edges: edges.
        free_ends: ends of lines that lead nowhere; these lines are left out.
        left_over: other ink that belongs to no edge.
        doubts: about the whole pattern, as sentences.
        straightening: correction to symmetry and flat-foldability; None without.
    """

    name: Annotated[str, Written.ALWAYS]
    pattern: Annotated[CreasePattern, Written.NEVER]
    picture: Annotated[Picture, Written.NEVER]
    homography: tuple[tuple[float, ...], ...]
    width: Metres
    height: Metres
    pixel_size: Metres
    corner_source: str
    corners: tuple[PicturePoint, ...]
    corner_residual: float | None
    line_width: float
    line_residual: float
    vertices: tuple[TracedVertex, ...]
    edges: tuple[TracedEdge, ...]
    free_ends: tuple[PicturePoint, ...]
    left_over: tuple[PicturePoint, ...]
    doubts: tuple[str, ...] = field(default=())
    straightening: Straightening | None = None

    def __repr__(self) -> str:
        """Return the picture, and the numbers of vertices, edges and doubtful edges."""
        doubtful = sum(bool(edge.doubt) for edge in self.edges)
        return (
            f"<Trace of {self.name or 'a picture'}: {len(self.vertices)} vertices, {len(self.edges)} edges,"
            f" {doubtful} doubtful>"
        )

    @property
    def is_doubtful(self) -> bool:
        """Whether anything is doubtful: an edge, a vertex, or the whole."""
        parts = [vertex.doubt for vertex in self.vertices] + [edge.doubt for edge in self.edges]
        return any([*self.doubts, *parts])


def write_trace(trace: Trace, path: Path) -> None:
    """Write the pattern of a trace to a FOLD file, with the scale of the picture and the doubts.

    Args:
        trace: the trace.
        path: path of the file; an existing file is replaced.

    Raises:
        InputError: the file cannot be written.
    """
    name = trace.name or "a picture"
    write_fold(
        trace.pattern,
        path,
        extra={
            "vertices_standardError": [vertex.standard_error for vertex in trace.vertices],
            "edges_doubt": [edge.doubt or None for edge in trace.edges],
        },
        description=f"Traced in {name}; one pixel in the middle of the pattern is {show_value(trace.pixel_size, 'm')}.",
        metadata={
            "picture": {
                "name": trace.name,
                "metres_per_pixel": trace.pixel_size,
                "homography_from_pixels_to_m": [list(row) for row in trace.homography],
                "corners": [[corner.x, corner.y] for corner in trace.corners],
            }
        },
    )
