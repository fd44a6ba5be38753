"""Requests of the page of a workbench about a picture and the crease pattern that is drawn on it."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Annotated, Literal

from pydantic import Base64Bytes, Field

from forficula.workbench.requests import PageRequest
from forficula.workbench.worker import Task

_MOST_VERTICES, _MOST_EDGES = 3000, 9000  # [chosen] of a drawn pattern
_LONGEST = 300  # letters of a name or a length

Name = Annotated[str, Field(max_length=_LONGEST)]
Point = tuple[
    Annotated[float, Field(ge=-1e6, le=1e6, allow_inf_nan=False)],
    Annotated[float, Field(ge=-1e6, le=1e6, allow_inf_nan=False)],
]
Number = Annotated[int, Field(ge=0, lt=_MOST_VERTICES)]
Letter = Literal["M", "V", "F", "B", "C", "U"]


class PictureRequest(PageRequest):
    """A picture in which a page requests junctions of lines.

    Attributes:
        picture: content of a PNG or JPEG file, in base 64.
        name: name of the file.
    """

    picture: Base64Bytes
    name: Name = ""


class TraceRequest(PictureRequest):
    """A picture that a page requests to trace automatically.

    Attributes:
        size: width and height of the sheet or its longer side, as for `forficula trace`.
        corners: corners of the sheet as for `forficula trace`; "" to find them.
    """

    size: Name
    corners: Name = ""


class ScaleRequest(PageRequest):
    """Clicks on a picture that give its scale.

    Attributes:
        points: two points at a distance, or the four corners of a rectangle, clockwise from the upper left one, pixels.
        size: distance of the two points, or width and height of the rectangle or its longer side, as text.
        width: width of the picture, pixels.
        height: height of the picture, pixels.
    """

    points: Annotated[tuple[Point, ...], Field(min_length=2, max_length=4)]
    size: Name
    width: Annotated[int, Field(ge=1, le=10**6)]
    height: Annotated[int, Field(ge=1, le=10**6)]


class DrawnPatternRequest(PageRequest):
    """A crease pattern that is drawn on a picture.

    Attributes:
        scale: scale of the picture.
        name: name of the picture.
        vertices: positions of the vertices, pixels.
        edges: numbers of the two vertices of every edge.
        letters: letter of every edge, as in FOLD files.
    """

    scale: ScaleRequest
    name: Name = ""
    vertices: Annotated[tuple[Point, ...], Field(max_length=_MOST_VERTICES)]
    edges: Annotated[tuple[tuple[Number, Number], ...], Field(max_length=_MOST_EDGES)]
    letters: Annotated[tuple[Letter, ...], Field(max_length=_MOST_EDGES)]


class StraightenRequest(DrawnPatternRequest):
    """A drawn pattern whose vertices are to move least to flat-foldability.

    Attributes:
        tolerance: largest movement of a vertex, as text.
    """

    tolerance: Name


PICTURE_REQUESTS: Mapping[Task, type[PageRequest]] = {
    "picture-scale": ScaleRequest,
    "picture-pattern": DrawnPatternRequest,
    "picture-junctions": PictureRequest,
    "picture-trace": TraceRequest,
    "picture-straighten": StraightenRequest,
}
