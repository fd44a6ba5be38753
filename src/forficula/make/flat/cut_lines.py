"""A sheet as it is cut, scored and marked, from which its files are written."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import numpy as np

from forficula.arrays import Array
from forficula.make.checks.check import Check
from forficula.make.flat.crease_cuts import CreaseLine
from forficula.pattern import CreasePattern

Layer = Literal["cut", "score", "mountain", "valley", "mark"]
# in the order in which files list them
LAYERS: tuple[Layer, ...] = ("cut", "score", "mountain", "valley", "mark")
Kind = Literal["border", "window", "hole", "relief", "cut", "slit", "crease", "edge"]


@dataclass(frozen=True, kw_only=True, eq=False)
class CutLine:
    """A path of the cutter.

    Attributes:
        layer: layer, which determines how it is made.
        kind: the border, a window, a hole of the pattern, a relief hole, a cut of the pattern, a slit of a crease, a
            scored crease, or the edge of the model's membrane within the sheet.
        points: m, (point, 2); in a closed line the first is not repeated.
        closed: whether it returns to its first point.
        edge: index of the pattern's edge as built; -1 for others.
    """

    layer: Layer
    kind: Kind
    points: Array
    closed: bool
    edge: int = -1


@dataclass(frozen=True, kw_only=True, eq=False)
class CutHole:
    """A round hole with the path of the cutter.

    Attributes:
        kind: "relief" where creases meet, "window" for a peg.
        place: m, (2,).
        diameter: diameter of the cutter's path, m.
        nominal: diameter of the finished hole, m.
    """

    kind: Kind
    place: Array
    diameter: float
    nominal: float


@dataclass(frozen=True, kw_only=True, eq=False)
class CutLabel:
    """A text on the sheet, to be engraved or omitted.

    Attributes:
        text: the text.
        place: position of its centre, m, (2,).
        height: height of its letters, m.
    """

    text: str
    place: Array
    height: float


@dataclass(frozen=True, kw_only=True, eq=False)
class CutSheet:
    """A crease pattern as it is cut from a sheet, seen from +z, in the coordinates of the flat pattern.

    Attributes:
        name: name of the design.
        title: title of the pattern.
        style: style of its creases.
        kerf: kerf for which its lines compensate, m.
        pattern: flat, m.
        outlines: corners of the finished sheet, nominal, holes clockwise, without round holes, m, (corner, 2) each.
        creases: lines by index of the pattern's edge as built; a crease that is cut in several pieces has all of them.
        lines: lines of the cutter.
        holes: round holes.
        labels: texts on the sheet.
        notes: sentences for the maker.
        checks: checks of the sheet.
        faults: outlines of what fails the checks: overlapping windows, pieces that come off, m, (corner, 2) each.
    """

    name: str
    title: str
    style: str
    kerf: float
    pattern: CreasePattern
    outlines: tuple[Array, ...]
    creases: tuple[CreaseLine, ...]
    lines: tuple[CutLine, ...]
    holes: tuple[CutHole, ...]
    labels: tuple[CutLabel, ...]
    notes: tuple[str, ...]
    checks: tuple[Check, ...] = ()
    faults: tuple[Array, ...] = ()

    @property
    def corners(self) -> Array:
        """Smallest and largest x and y of all cuts, m, (2, 2)."""
        points = np.concatenate([line.points for line in self.lines])
        return np.array([points.min(axis=0), points.max(axis=0)])

    @property
    def size(self) -> Array:
        """Size of the finished sheet along x and y, m, (2,)."""
        points = np.concatenate(self.outlines)
        return np.asarray(np.ptp(points, axis=0))


def layer_texts(sheet: CutSheet) -> dict[Layer, str]:
    """Return a sentence for each layer of a sheet that says what to do with its lines."""
    scored = sheet.style == "score"
    face, back = (", from the face", ", from the back if you can turn the sheet over") if scored else ("", "")
    marks = "numbers of seams: join the two edges with the same number" if sheet.labels else "where the membrane ends"
    action = {
        "score": "score half through",
        "perforation": "cut through, as dashes",
        "lattice": "cut through, as staggered slits",
    }[sheet.style]
    texts: dict[Layer, str] = {
        "cut": "cut through: border, holes, windows and cuts of the pattern",
        "score": "score half through, from the face: creases that fold in both directions or are too short for dashes",
        "mountain": f"mountain creases, which rise towards you: {action}{face}",
        "valley": f"valley creases, which fall away from you: {action}{back}",
        "mark": f"engrave or omit: {marks}",
    }
    used = {line.layer for line in sheet.lines} | ({"mark"} if sheet.labels else set())
    return {layer: texts[layer] for layer in LAYERS if layer in used}
