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

# letters of assignments whose colours and dashes the layers have
_LIKE: dict[Layer, str] = {"cut": "B", "score": "U", "mountain": "M", "valley": "V", "mark": "F"}
_MARGIN = 3.0  # mm


def write_sheet_svg(sheet: CutSheet, path: str | os.PathLike[str]) -> None:
    """Write a cut sheet as SVG.

    In true size, millimetres, y axis up, seen from +z. Layers are groups, "CUT", "SCORE", "MOUNTAIN", "VALLEY", "MARK",
    of these those that the sheet has, in the colours and dashes of `forficula.pattern.write_svg`; lines that are cut
    through are solid. The size, the kerf and what is done with each layer stand in the description of the file, where
    no program takes them for lines. The same sheet gives the same bytes.

    Args:
        sheet: as `cut_sheet` gives it.
        path: the file, replaced where it exists.

    Raises:
        InputError: the file cannot be written.
    """
    write_text(Path(path), f'<?xml version="1.0" encoding="utf-8"?>\n{sheet_svg(sheet)}\n')


def sheet_svg(sheet: CutSheet) -> str:
    """The element of the drawing that `write_sheet_svg` writes, without what a file begins with."""
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
    for layer in (each for each in LAYERS if each in texts):
        letter, name = _LIKE[layer], layer.upper()
        look = {"fill": "none", "stroke": COLOURS[letter], "stroke-width": f"{STROKE:g}"}
        names = {"id": name, "inkscape:label": name, "inkscape:groupmode": "layer"}
        group = ElementTree.SubElement(drawing, "g", names | look)
        ElementTree.SubElement(group, "title").text = texts[layer]
        for line in (each for each in sheet.lines if each.layer == layer):
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
    """A line of the cutter, on the page."""
    if line.closed:
        ways = " ".join(f"{x:.6f},{y:.6f}" for x, y in points)
        ElementTree.SubElement(group, "polygon", {"points": ways} | look)
        return
    (x, y), (there, above) = points
    ends = {"x1": f"{x:.6f}", "y1": f"{y:.6f}", "x2": f"{there:.6f}", "y2": f"{above:.6f}"}
    ElementTree.SubElement(group, "line", ends | look)


def _write(group: ElementTree.Element, text: str, place: Array, height: float, colour: str) -> None:
    """A word on the page, filled: a program that takes only lines passes it over."""
    look = {"fill": colour, "stroke": "none", "font-size": f"{height:.6f}", "font-family": "sans-serif"}
    middle = {"text-anchor": "middle", "dominant-baseline": "central"}
    where = {"x": f"{place[0]:.6f}", "y": f"{place[1]:.6f}"}
    ElementTree.SubElement(group, "text", where | middle | look).text = text
