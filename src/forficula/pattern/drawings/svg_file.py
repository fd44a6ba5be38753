"""Crease patterns as SVG drawings in true size, for cutters, plotters and origami programs."""

from __future__ import annotations

import math
import os
import xml.etree.ElementTree as ElementTree
from pathlib import Path

import numpy as np

from forficula.arrays import Array
from forficula.files import write_text
from forficula.pattern.crease_pattern import ASSIGNMENTS, CreasePattern, check_flat
from forficula.quantities import round_below

# colours that origami programs read; the dashes (lengths in mm) distinguish the lines in grey
COLOURS = {"B": "#000000", "M": "#ff0000", "V": "#0000ff", "F": "#808080", "U": "#ff00ff", "C": "#00ff00"}
DASHES = {"M": "4 1 0.5 1", "V": "2 1", "F": "0.5 1", "U": "6 2", "C": "1 0.5"}
_LINES = {
    "B": "black, solid",
    "M": "red, dash-dotted",
    "V": "blue, dashed",
    "F": "grey, dotted",
    "U": "magenta, long-dashed",
    "C": "green, short-dashed",
}
STROKE = 0.35  # mm
_MARGIN = 3.0  # mm
_LEAST_BAR = 1e-6  # mm
_DOT, _ATTACHMENT, _BAR_HEIGHT = 1.2, "#e69f00", 6.0  # mm, radius of a dot; colour; mm, height of scale bar and label
_MILLIMETRES = 1e3


def write_svg(pattern: CreasePattern, path: str | os.PathLike[str], attachments: Array | None = None) -> None:
    """Draw a flat pattern in true size, millimetres, y axis up.

    Mountains are red and dash-dotted, valleys blue and dashed, borders black and solid, cuts green, flat edges grey,
    unassigned edges magenta. The magnitude of a fold angle is the opacity of its line, 1 at 180 deg. The legend is in
    the description of the file instead of the drawing, where programs would read it as creases. Dots mark the ends of
    tendons, and a scale bar is below the drawing; both are filled without lines, so that programs do not read them as
    creases.

    Args:
        pattern: a flat sheet.
        path: path of the file; an existing file is replaced.
        attachments: ends of tendons, m, (end, 3).

    Raises:
        InputError: the sheet is not flat, or the file cannot be written.
    """
    check_flat(pattern)
    points = pattern.vertices_coords[:, :2] * _MILLIMETRES
    left, top = points[:, 0].min() - _MARGIN, points[:, 1].max() + _MARGIN
    page = np.column_stack([points[:, 0] - left, top - points[:, 1]])
    bar = round_below(max(float(np.ptp(points[:, 0])) / 3, _LEAST_BAR))
    width, height = page.max(axis=0) + _MARGIN
    width, foot, height = max(width, bar + 2 * _MARGIN), height, height + _BAR_HEIGHT
    drawing = ElementTree.Element(
        "svg",
        {
            "xmlns": "http://www.w3.org/2000/svg",
            "width": f"{width:.6f}mm",
            "height": f"{height:.6f}mm",
            "viewBox": f"0 0 {width:.6f} {height:.6f}",
        },
    )
    ElementTree.SubElement(drawing, "title").text = printable(pattern.title)
    ElementTree.SubElement(drawing, "desc").text = _legend(pattern)
    for edge, (tail, head) in enumerate(pattern.edges_vertices.tolist()):
        letter, fold_angle = pattern.edges_assignment[edge], float(pattern.edges_fold_angle[edge])
        line = {
            "x1": f"{page[tail, 0]:.6f}",
            "y1": f"{page[tail, 1]:.6f}",
            "x2": f"{page[head, 0]:.6f}",
            "y2": f"{page[head, 1]:.6f}",
            "stroke": COLOURS[letter],
            "stroke-width": f"{STROKE:g}",
        }
        if letter in DASHES:
            line["stroke-dasharray"] = DASHES[letter]
        if letter in "MV" and math.isfinite(fold_angle):
            line["stroke-opacity"] = f"{min(abs(fold_angle) / math.pi, 1.0):.6g}"
        ElementTree.SubElement(drawing, "line", line)
    for place in () if attachments is None else attachments[:, :2] * _MILLIMETRES:
        x, y = place[0] - left, top - place[1]
        dot = {"cx": f"{x:.6f}", "cy": f"{y:.6f}", "r": f"{_DOT:g}", "fill": _ATTACHMENT, "stroke": "none"}
        ElementTree.SubElement(ElementTree.SubElement(drawing, "circle", dot), "title").text = "end of a tendon"
    filled = {"fill": "#000000", "stroke": "none"}
    thick = {"width": f"{bar:g}", "height": f"{2 * STROKE:g}"}
    ElementTree.SubElement(drawing, "rect", {"x": f"{_MARGIN:g}", "y": f"{foot:.6f}", **thick, **filled})
    below = {"x": f"{_MARGIN:g}", "y": f"{foot + _BAR_HEIGHT - 1.5:.6f}", "font-size": "3", "font-family": "sans-serif"}
    ElementTree.SubElement(drawing, "text", {**below, **filled}).text = f"{bar:g} mm"
    ElementTree.indent(drawing)
    text = ElementTree.tostring(drawing, encoding="unicode")
    write_text(Path(path), f'<?xml version="1.0" encoding="utf-8"?>\n{text}\n')


def printable(text: str) -> str:
    """Remove characters that are not printable, which XML does not allow."""
    return "".join(character for character in text if character.isprintable())


def _legend(pattern: CreasePattern) -> str:
    """Return the legend of the lines."""
    used = [letter for letter in ASSIGNMENTS if letter in pattern.edges_assignment]
    lines = "; ".join(f"{ASSIGNMENTS[letter]}: {_LINES[letter]}" for letter in used)
    return f"Millimetres, seen from +z. {lines}. Opacity of a mountain or valley: fold angle / 180 deg."
