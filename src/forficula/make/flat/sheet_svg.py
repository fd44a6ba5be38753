"""A cut sheet as an SVG drawing in true size."""

from __future__ import annotations

import os
import xml.etree.ElementTree as ElementTree
from pathlib import Path

import numpy as np

from forficula.arrays import Array
from forficula.files import write_text
from forficula.make.flat.cut_lines import LAYERS, CutLine, CutSheet, Layer, layer_texts
from forficula.make.flat.regions import MILLIMETRES
from forficula.make.flat.sheet_notes import legend_lines
from forficula.pattern.drawings.svg_file import COLOURS, DASHES, STROKE, printable

# assignments whose colours and dashes the layers use
_LIKE: dict[Layer, str] = {"cut": "B", "score": "U", "mountain": "M", "valley": "V", "mark": "F"}
_MARGIN = 3.0  # mm


def write_sheet_svg(sheet: CutSheet, path: str | os.PathLike[str]) -> None:
    """Write a cut sheet as SVG.

    True size, millimetres, y axis up, seen from +z. Layers are groups: those of "CUT", "SCORE", "MOUNTAIN", "VALLEY"
    and "MARK" that the sheet has, in the colours and dashes of `forficula.pattern.write_svg`. Lines that are cut
    through are solid. The size, the kerf and the instructions for each layer are in the description of the file, where
    no program reads them as lines. The same sheet gives the same bytes.

    Args:
        sheet: sheet from `cut_sheet`.
        path: path of the file; an existing file is replaced.

    Raises:
        InputError: the file cannot be written.
    """
    write_text(Path(path), f'<?xml version="1.0" encoding="utf-8"?>\n{sheet_svg(sheet)}\n')


def sheet_svg(sheet: CutSheet) -> str:
    """Return the element of the drawing that `write_sheet_svg` writes, without the beginning of a file."""
    low, high = MILLIMETRES * sheet.corners
    width, height = high - low + 2 * _MARGIN
    drawing = ElementTree.Element(
        "svg",
        {
            "xmlns": "http://www.w3.org/2000/svg",
            "xmlns:inkscape": "http://www.inkscape.org/namespaces/inkscape",
            "width": f"{width:.6f}mm",
            "height": f"{height:.6f}mm",
            "viewBox": f"0 0 {width:.6f} {height:.6f}",
        },
    )
    ElementTree.SubElement(drawing, "title").text = printable(sheet.title or sheet.name)
    ElementTree.SubElement(drawing, "desc").text = printable(". ".join(legend_lines(sheet)) + ".")

    def page(points: Array) -> Array:
        placed = MILLIMETRES * np.atleast_2d(points)
        return np.column_stack([placed[:, 0] - low[0] + _MARGIN, high[1] + _MARGIN - placed[:, 1]]) + 0.0

    texts = layer_texts(sheet)
    for layer in (layer for layer in LAYERS if layer in texts):
        letter, name = _LIKE[layer], layer.upper()
        look = {"fill": "none", "stroke": COLOURS[letter], "stroke-width": f"{STROKE:g}"}
        names = {"id": name, "inkscape:label": name, "inkscape:groupmode": "layer"}
        group = ElementTree.SubElement(drawing, "g", names | look)
        ElementTree.SubElement(group, "title").text = texts[layer]
        for line in (line for line in sheet.lines if line.layer == layer):
            dashes = {"stroke-dasharray": DASHES[letter]} if line.kind == "crease" and letter in DASHES else {}
            _draw(group, line, page(line.points), dashes)
        for hole in sheet.holes if layer == "cut" else ():
            x, y = page(hole.place)[0]
            radius = f"{MILLIMETRES * hole.diameter / 2:.6f}"
            ElementTree.SubElement(group, "circle", {"cx": f"{x:.6f}", "cy": f"{y:.6f}", "r": radius})
        for label in sheet.labels if layer == "mark" else ():
            _write(group, label.text, page(label.place)[0], MILLIMETRES * label.height, COLOURS[letter])
    ElementTree.indent(drawing)
    return ElementTree.tostring(drawing, encoding="unicode")


def _draw(group: ElementTree.Element, line: CutLine, points: Array, look: dict[str, str]) -> None:
    """Draw a line of the cutter on the page."""
    if line.closed:
        path = " ".join(f"{x:.6f},{y:.6f}" for x, y in points)
        ElementTree.SubElement(group, "polygon", {"points": path} | look)
        return
    (x, y), (x_end, y_end) = points
    ends = {"x1": f"{x:.6f}", "y1": f"{y:.6f}", "x2": f"{x_end:.6f}", "y2": f"{y_end:.6f}"}
    ElementTree.SubElement(group, "line", ends | look)


def _write(group: ElementTree.Element, text: str, place: Array, height: float, colour: str) -> None:
    """Write a text on the page, filled, so that programs that read only lines ignore it."""
    look = {"fill": colour, "stroke": "none", "font-size": f"{height:.6f}", "font-family": "sans-serif"}
    middle = {"text-anchor": "middle", "dominant-baseline": "central"}
    where = {"x": f"{place[0]:.6f}", "y": f"{place[1]:.6f}"}
    ElementTree.SubElement(group, "text", where | middle | look).text = text
