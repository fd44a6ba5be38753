"""A cut sheet as a DXF file of release 12, in millimetres, which all programs of cutters read."""

from __future__ import annotations

import io
import logging
import os
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike

from forficula.files import write_text
from forficula.make.flat.cut_lines import LAYERS, CutSheet, layer_texts
from forficula.make.flat.regions import MILLIMETRES
from forficula.make.flat.sheet_notes import legend_lines

if TYPE_CHECKING:
    from ezdxf._options import Options
    from ezdxf.layouts.layout import Modelspace

# AutoCAD colour index: white or black, magenta, red, blue, grey; origami programs use these colours for creases
_COLOURS = {"CUT": 7, "SCORE": 6, "MOUNTAIN": 1, "VALLEY": 5, "MARK": 8, "NOTE": 9}
_LETTERS, _BELOW = 3.0, 6.0  # mm: height of the legend's letters, and line spacing
# ezdxf omits units in files of release 12
_RELEASE, _UNIT = "  9\n$ACADVER\n  1\nAC1009\n", "  9\n$INSUNITS\n 70\n4\n  9\n$MEASUREMENT\n 70\n1\n"

logging.getLogger("ezdxf").addHandler(logging.NullHandler())  # its warnings would otherwise be printed


def write_sheet_dxf(sheet: CutSheet, path: str | os.PathLike[str]) -> None:
    """Write a cut sheet as DXF.

    Millimetres ($INSUNITS 4), y axis up, seen from +z. Layers: those of CUT, SCORE, MOUNTAIN, VALLEY and MARK that the
    sheet has, and NOTE, which is not to be made: a legend below the sheet that says what to do with each layer.
    Outlines are closed POLYLINEs, lines are LINEs, round holes are CIRCLEs. The same sheet gives the same bytes.

    Args:
        sheet: sheet from `cut_sheet`.
        path: path of the file; an existing file is replaced.

    Raises:
        InputError: the file cannot be written.
    """
    from ezdxf import _options
    from ezdxf.filemanagement import new

    with _fixed_dates(_options.options):
        document = new("R12")
        document.layers.remove("Defpoints")
        for name in (*(layer.upper() for layer in layer_texts(sheet)), "NOTE"):
            document.layers.add(name, color=_COLOURS[name])
        _draw(sheet, document.modelspace())
        stream = io.StringIO()
        document.write(stream)
    write_text(Path(path), stream.getvalue().replace(_RELEASE, _RELEASE + _UNIT, 1))


def _draw(sheet: CutSheet, space: Modelspace) -> None:
    """Draw the lines, holes and labels of a sheet, layer by layer, and its legend."""
    low, high = _millimetres(sheet.corners)
    space.reset_extents((*low, 0.0), (*high, 0.0))
    for layer in LAYERS:
        on_layer = {"layer": layer.upper()}
        for line in (line for line in sheet.lines if line.layer == layer):
            points = _millimetres(line.points)
            if line.closed:
                space.add_polyline2d(points, close=True, dxfattribs=on_layer)
            else:
                space.add_line(points[0], points[1], dxfattribs=on_layer)
        for hole in sheet.holes if layer == "cut" else ():
            space.add_circle(_millimetres(hole.place), _millimetres(hole.diameter / 2), dxfattribs=on_layer)
        for label in sheet.labels if layer == "mark" else ():
            place = _millimetres(label.place)
            middle = {**on_layer, "insert": place, "align_point": place, "halign": 1, "valign": 2}
            space.add_text(_ascii(label.text), height=_millimetres(label.height), dxfattribs=middle)
    for row, text in enumerate(legend_lines(sheet)):
        place = (low[0], low[1] - (row + 2) * _BELOW)
        space.add_text(_ascii(text), height=_LETTERS, dxfattribs={"layer": "NOTE", "insert": place})


@contextmanager
def _fixed_dates(options: Options) -> Iterator[None]:
    """Make ezdxf write fixed dates, so that the same drawing gives the same bytes."""
    before = options.write_fixed_meta_data_for_testing
    options.write_fixed_meta_data_for_testing = True
    try:
        yield
    finally:
        options.write_fixed_meta_data_for_testing = before


def _millimetres(metres: ArrayLike) -> Any:
    """Return lengths in millimetres, rounded to the nanometre and without negative zeros, as lists of numbers."""
    return (np.round(MILLIMETRES * np.asarray(metres), 6) + 0.0).tolist()


def _ascii(text: str) -> str:
    """Return a text in ASCII, as release 12 requires; other letters are replaced by their numbers."""
    return "".join(letter if " " <= letter <= "~" else f"\\U+{ord(letter):04X}" for letter in text)
