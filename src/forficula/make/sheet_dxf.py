"""A cut sheet as a DXF file of release 12, in millimetres, which every cutter's program reads."""

from __future__ import annotations

import os
from collections.abc import Sequence
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from forficula.files import write_text
from forficula.make.cut_lines import LAYERS, CutHole, CutLabel, CutLine, CutSheet, layer_texts
from forficula.make.regions import MILLIMETRES
from forficula.make.sheet_notes import legend_lines

# of AutoCAD's index: white or black, magenta, red, blue, grey; as origami programs read creases
_COLOURS = {"cut": 7, "score": 6, "mountain": 1, "valley": 5, "mark": 8}
_NOTE, _NOTE_COLOUR = "NOTE", 9
_LETTERS, _BELOW = 3.0, 6.0  # mm: height of the legend's letters, and of its lines
_CLOSED, _MILLIMETRE_UNITS, _MIDDLE = 1, 4, 1

Pair = tuple[int, object]
Array = NDArray[np.float64]


def write_sheet_dxf(sheet: CutSheet, path: str | os.PathLike[str]) -> None:
    """Write a cut sheet as DXF.

    Millimetres ($INSUNITS 4), y axis up, seen from +z. Layers: CUT, SCORE, MOUNTAIN, VALLEY, MARK, of these those that
    the sheet has, and NOTE with the legend beneath the sheet, which says what is done with each: leave it out. Outlines
    are closed POLYLINEs, lines LINEs, round holes CIRCLEs. The same sheet gives the same bytes.

    Args:
        sheet: as `cut_sheet` gives it.
        path: the file, replaced where it exists.

    Raises:
        InputError: the file cannot be written.
    """
    low, high = MILLIMETRES * sheet.corners
    used = [*(layer.upper() for layer in layer_texts(sheet)), _NOTE]
    header: list[Pair] = [(9, "$ACADVER"), (1, "AC1009"), (9, "$INSUNITS"), (70, _MILLIMETRE_UNITS)]
    header += [(9, "$MEASUREMENT"), (70, 1), (9, "$EXTMIN"), *_place(low), (9, "$EXTMAX"), *_place(high)]
    pairs = [*_section("HEADER", header), *_section("TABLES", [*_line_types(), *_layers(used)])]
    entities: list[Pair] = []
    for layer in LAYERS:
        for line in sheet.lines:
            entities += _line(line) if line.layer == layer else []
        for hole in sheet.holes if layer == "cut" else ():
            entities += _circle(hole)
        for label in sheet.labels if layer == "mark" else ():
            entities += _label(label)
    for row, text in enumerate(legend_lines(sheet)):
        entities += _text(_NOTE, text, (low[0], low[1] - (row + 2) * _BELOW), _LETTERS)
    pairs += [*_section("ENTITIES", entities), (0, "EOF")]
    write_text(Path(path), "".join(f"{code:>3}\n{_written(value)}\n" for code, value in pairs))


def _written(value: object) -> str:
    """A number to the nanometre, without a minus before nothing; a text as R12 holds it."""
    if isinstance(value, float):
        return f"{round(value, 6) + 0.0:.6f}"
    # release 12 knows no letters beyond ASCII but by their numbers
    return "".join(each if " " <= each <= "~" else f"\\U+{ord(each):04X}" for each in str(value))


def _section(name: str, pairs: Sequence[Pair]) -> list[Pair]:
    return [(0, "SECTION"), (2, name), *pairs, (0, "ENDSEC")]


def _line_types() -> list[Pair]:
    """The one that all lines have: dashes would be cut as such by some programs."""
    solid: list[Pair] = [(0, "LTYPE"), (2, "CONTINUOUS"), (70, 0), (3, "Solid line"), (72, 65), (73, 0), (40, 0.0)]
    return [(0, "TABLE"), (2, "LTYPE"), (70, 1), *solid, (0, "ENDTAB")]


def _layers(names: Sequence[str]) -> list[Pair]:
    rows: list[Pair] = [(0, "TABLE"), (2, "LAYER"), (70, len(names) + 1)]
    for name in ("0", *names):
        colour = {**{layer.upper(): its for layer, its in _COLOURS.items()}, _NOTE: _NOTE_COLOUR}.get(name, 7)
        rows += [(0, "LAYER"), (2, name), (70, 0), (62, colour), (6, "CONTINUOUS")]
    return [*rows, (0, "ENDTAB")]


def _place(place: Sequence[float] | Array, first: int = 10) -> list[Pair]:
    """x, y and z, mm."""
    return [(first, float(place[0])), (first + 10, float(place[1])), (first + 20, 0.0)]


def _line(line: CutLine) -> list[Pair]:
    layer, points = line.layer.upper(), MILLIMETRES * line.points
    if not line.closed:
        return [(0, "LINE"), (8, layer), *_place(points[0]), *_place(points[1], 11)]
    pairs: list[Pair] = [(0, "POLYLINE"), (8, layer), (66, 1), *_place((0, 0)), (70, _CLOSED)]
    for point in points:
        pairs += [(0, "VERTEX"), (8, layer), *_place(point)]
    return [*pairs, (0, "SEQEND"), (8, layer)]


def _circle(hole: CutHole) -> list[Pair]:
    return [(0, "CIRCLE"), (8, "CUT"), *_place(MILLIMETRES * hole.place), (40, float(MILLIMETRES * hole.diameter / 2))]


def _label(label: CutLabel) -> list[Pair]:
    place, height = MILLIMETRES * label.place, MILLIMETRES * label.height
    middle: list[Pair] = [(72, _MIDDLE), (73, 2), *_place(place, 11)]
    return [*_text("MARK", label.text, place, height), *middle]


def _text(layer: str, text: str, place: Sequence[float] | Array, height: float) -> list[Pair]:
    return [(0, "TEXT"), (8, layer), *_place(place), (40, float(height)), (1, text)]
