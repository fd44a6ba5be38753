"""A sheet as it is cut, scored and marked: what the files of it are written from."""

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
    """A way of the cutter.

    Attributes:
        layer: that tells how it is made.
        kind: what it is of: the border, a window, a hole of the pattern, a relief hole, a cut of the pattern, a slit of
            a crease, a crease that is scored, or the edge of the model's membrane within the sheet.
        points: m, (point, 2); of a closed one the first is not repeated.
        closed: whether it goes back to its first point.
        edge: number of the pattern's edge that it is of, as built; -1 of others.
    """

    layer: Layer
    kind: Kind
    points: Array
    closed: bool
    edge: int = -1


@dataclass(frozen=True, kw_only=True, eq=False)
class CutHole:
    """A round hole, as the cutter goes around it.

    Attributes:
        kind: "relief" where creases meet, "window" of a peg.
        place: m, (2,).
        diameter: of the cutter's way, m.
        nominal: diameter of the hole that it leaves, m.
    """

    kind: Kind
    place: Array
    diameter: float
    nominal: float


@dataclass(frozen=True, kw_only=True, eq=False)
class CutLabel:
    """A word on the sheet, to be engraved or left out.

    Attributes:
        text: of it.
        place: of its middle, m, (2,).
        height: of its letters, m.
    """

    text: str
    place: Array
    height: float


@dataclass(frozen=True, kw_only=True, eq=False)
class CutSheet:
    """A crease pattern as it is cut from a sheet, seen from +z, in the coordinates of the pattern laid flat.

    Attributes:
        name: of the design.
        title: what the pattern is.
        style: of its creases.
        kerf: that its lines make up for, m.
        pattern: laid flat, m.
        outlines: of what is to stay, in its nominal size, holes clockwise, round holes left out, m, (corner, 2) each.
        creases: by number of the pattern's edge as built, with all lines of one that is cut in several pieces.
        lines: of the cutter.
        holes: that are round.
        labels: on it.
        notes: sentences for who makes it.
        checks: of it.
        faults: outlines of what fails them: windows that meet others, pieces that come off, m, (corner, 2) each.
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
        """The least and the largest x and y of all that is cut, m, (2, 2)."""
        points = np.concatenate([line.points for line in self.lines])
        return np.array([points.min(axis=0), points.max(axis=0)])

    @property
    def size(self) -> Array:
        """Of the finished sheet along x and y, m, (2,)."""
        points = np.concatenate(self.outlines)
        return np.asarray(np.ptp(points, axis=0))


def layer_texts(sheet: CutSheet) -> dict[Layer, str]:
    """What is done with the lines of each layer that a sheet has, a sentence each."""
    scored = sheet.style == "score"
    face, back = (", from the face", ", from the back if you can turn the sheet over") if scored else ("", "")
    marks = "numbers of seams, where two edges of one number are joined" if sheet.labels else "where the membrane ends"
    does = {
        "score": "score half through",
        "perforation": "cut through, as dashes",
        "lattice": "cut through, as staggered slits",
    }[sheet.style]
    texts: dict[Layer, str] = {
        "cut": "cut through: border, holes, windows and cuts of the pattern",
        "score": "score half through, from the face: creases that fold either way, or too short for dashes",
        "mountain": f"mountain creases, which rise towards you: {does}{face}",
        "valley": f"valley creases, which fall away from you: {does}{back}",
        "mark": f"engrave or leave out: {marks}",
    }
    used = {line.layer for line in sheet.lines} | ({"mark"} if sheet.labels else set())
    return {layer: texts[layer] for layer in LAYERS if layer in used}
