"""Reading of straight lines from an SVG drawing, with the kinds of edges that colours, groups or data mean."""

from __future__ import annotations

import itertools
import math
import re
import xml.etree.ElementTree as ElementTree
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from forficula.arrays import Array
from forficula.errors import InputError, error_prefix
from forficula.files import read_bytes
from forficula.names import one_line
from forficula.pattern.drawings.drawing import Drawing, DrawnLine, check_has_lines, letter_of_colour
from forficula.pattern.drawings.svg_style import (
    PIXEL,
    Rules,
    Style,
    colour_of,
    length_of,
    number_of,
    rules_of,
    style_of,
)
from forficula.pattern.drawings.svg_transform import NUMBER, check_rules, matrix_of, numbers_of
from forficula.pattern.files.edge_names import letter_of_name
from forficula.quantities import as_written

_ALIGNED = re.compile(r"none|x(?:Min|Mid|Max)Y(?:Min|Mid|Max)")
_SHAPES = {"line", "polyline", "polygon", "rect", "path", "circle", "ellipse", "use", "svg"}
_PATH_NUMBERS = {"m": 2, "l": 2, "h": 1, "v": 1, "z": 0}
_LABEL = "{http://www.inkscape.org/namespaces/inkscape}label"

Line = tuple[tuple[float, float], tuple[float, float]]


@dataclass(frozen=True, kw_only=True, eq=False)
class _Place:
    """Style, transform and kind of edge that a shape inherits from the groups around it."""

    style: Style
    to_page: Array  # matrix, shape (3, 3)
    letter: str | None


def read_svg(file: Path) -> Drawing:
    """Read the straight lines of an SVG drawing.

    The kind of a line follows, in this order, from its data-assignment, as written by Rabbit Ear; from the name of a
    group around it, such as a layer "mountain"; or from the colour of its stroke. The fold angle of mountains and
    valleys follows from data-foldAngle, in degrees, or else from the opacity, 1 at 180 deg, as in Origami Simulator.

    Raises:
        InputError: the file cannot be read, is not an SVG drawing, or has curves or copies among its creases.
    """
    try:
        root = ElementTree.fromstring(read_bytes(file))
    except InputError:
        raise
    except (ElementTree.ParseError, LookupError, ValueError) as error:
        raise InputError(f"need XML, as SVG files are: {error}") from error
    if _tag(root) != "svg":
        raise InputError(f"need an SVG drawing, got XML of <{_tag(root)}>")
    try:
        return _drawing(root)
    except RecursionError:
        raise InputError("need groups nested less deeply; ungroup them in a drawing program") from None


def _drawing(root: ElementTree.Element) -> Drawing:
    """Convert the root element of an SVG file to a drawing."""
    rules, seen, left_out = rules_of(root), Counter[str](), Counter[str]()
    check_rules(rules)
    unit, assumed, stretch = _scale(root)
    lines: list[DrawnLine] = []
    page = _Place(style={}, to_page=np.eye(3), letter=None)
    for shape, place in _shapes(root, page, rules, np.diag([1.0, stretch, 1.0])):
        seen[_tag(shape)] += 1
        identifier = f" (id {as_written(shape.get('id'))})" if shape.get("id") else ""
        name = f"{_tag(shape)} {seen[_tag(shape)]}{identifier}"
        with error_prefix(f"{name}: "):
            lines += _drawn_lines(shape, place, rules, left_out, name)
    remarks = check_has_lines(lines, left_out)
    title = next((child.text or "" for child in root if _tag(child) == "title"), "")
    return Drawing(lines=tuple(lines), unit=unit, assumed_unit=assumed, title=one_line(title), remarks=remarks)


def _tag(element: ElementTree.Element) -> str:
    return element.tag.rpartition("}")[2] if isinstance(element.tag, str) else ""


def _scale(root: ElementTree.Element) -> tuple[float | None, float | None, float]:
    """Compute the unit of length of a drawing (SVG 2, section 8.2), without its position on the page.

    Returns:
        Unit of length along x, m, if the file gives one; the assumed unit, m, if the file uses pixels; and the ratio of
        the units along y and x.
    """
    if not root.get("viewBox", "").strip():
        return None, PIXEL, 1.0
    box = numbers_of("viewBox", root.get("viewBox", ""))
    if len(box) != 4 or min(box[2:]) <= 0:
        raise InputError(f"viewBox: need four numbers, the last two > 0, got {as_written(root.get('viewBox'))}")
    sides = [(length_of(root.get(key)), in_box) for key, in_box in zip(("width", "height"), box[2:], strict=True)]
    known = [(*side, in_box) for side, in_box in sides if side is not None and side[0] > 0 and in_box > 0]
    if not known:
        return None, None, 1.0
    scales = [number * (PIXEL if metres is None else metres) / in_box for number, metres, in_box in known]
    fit = root.get("preserveAspectRatio", "xMidYMid").split()
    fit = fit[1:] if fit[:1] == ["defer"] else fit
    if not fit or not _ALIGNED.fullmatch(fit[0]) or fit[1:] not in ([], ["meet"], ["slice"]):
        raise InputError(
            "preserveAspectRatio: need none, or an alignment such as xMidYMid with meet or slice,"
            f" got {as_written(root.get('preserveAspectRatio'))}"
        )
    # one scale for both directions, to fit or to cover the page; or a separate scale for each direction
    stretched = fit[0] == "none" and len(scales) == 2
    scale = scales[0] if stretched else max(scales) if fit[1:] == ["slice"] and fit[0] != "none" else min(scales)
    says_length = all(metres is not None for _, metres, _ in known)
    return scale if says_length else None, scale, scales[1] / scales[0] if stretched else 1.0


def _shapes(
    group: ElementTree.Element, above: _Place, rules: Rules, stretch: Array | None = None
) -> Iterator[tuple[ElementTree.Element, _Place]]:
    """Yield the shapes of a group and of groups inside it, with the properties that they inherit.

    The root element is also a group; `stretch` is applied before its transform.
    """
    style = style_of(group, above.style, rules)
    if style.get("display") == "none":
        return
    with error_prefix(f"{_tag(group)} {as_written(group.get('id', ''))}: "):
        to_page = above.to_page @ matrix_of(group, style)
        to_page = to_page if stretch is None else to_page @ stretch
    # an id with a single letter may come from a program that shortens files, so it has no meaning
    names = [group.get(_LABEL, ""), group.get("id", "").rjust(2, "_")] if _tag(group) == "g" else []
    letters = (letter_of_name(name) for name in names)
    place = _Place(style=style, to_page=to_page, letter=next(filter(None, letters), above.letter))
    for child in group:
        if _tag(child) in ("g", "a", "switch"):
            yield from _shapes(child, place, rules)
        elif _tag(child) in _SHAPES:
            yield child, place


def _drawn_lines(
    shape: ElementTree.Element, place: _Place, rules: Rules, left_out: Counter[str], name: str
) -> list[DrawnLine]:
    """Return the lines of a shape that belong to the sheet; count shapes without a meaning in `left_out`."""
    style = style_of(shape, place.style, rules)
    stroke = style.get("stroke", "none")
    colour = colour_of(stroke)
    if style.get("display") == "none" or style.get("visibility") in ("hidden", "collapse"):
        return []
    if _tag(shape) in ("use", "svg"):
        what = "a copy" if _tag(shape) == "use" else "a drawing in the drawing"
        raise InputError(f"need lines themselves, got {what}; unlink or ungroup it in a drawing program")
    if stroke == "none":
        return []
    letter = letter_of_name(shape.get("data-assignment", "")) or place.letter
    letter = letter or (letter_of_colour(*colour[:3]) if colour else None)
    if letter is None:
        left_out[stroke] += 1
        return []
    opacity = number_of(style["opacity"]) * number_of(style.get("stroke-opacity")) * (colour[3] if colour else 1.0)
    fold_angle = _fold_angle(shape, letter, opacity)
    lines = np.array(list(_lines_of(shape)), dtype=np.float64).reshape(-1, 2)
    matrix = place.to_page @ matrix_of(shape, style)
    points = (lines @ matrix[:2, :2].T + matrix[:2, 2]) * (1.0, -1.0)
    if not np.isfinite(points).all():
        raise InputError(f"transform: need coordinates that are finite numbers, got {as_written(points[0].tolist())}")
    ends = [(x, y) for x, y in points.tolist()]
    return [DrawnLine(start, end, letter, fold_angle, name) for start, end in zip(ends[::2], ends[1::2], strict=True)]


def _fold_angle(shape: ElementTree.Element, letter: str, opacity: float) -> float:
    """Return the fold angle of a line, rad."""
    if letter not in "MV":
        return math.nan
    sense = -1.0 if letter == "M" else 1.0
    data = next((text for key, text in shape.attrib.items() if key.lower() == "data-foldangle"), None)
    if data is None:
        return sense * math.pi * opacity
    if re.fullmatch(NUMBER, data.strip()) is None or not 0 <= sense * float(data) <= 180:
        raise InputError(f"data-foldAngle: need {sense:g} times 0 to 180 deg, got {as_written(data)}")
    return math.radians(float(data))


def _lines_of(shape: ElementTree.Element) -> Iterator[Line]:
    """Yield the straight lines of a shape, before its transform."""
    match _tag(shape):
        case "line":
            x, y, other_x, other_y = (_coordinate(shape, key) for key in ("x1", "y1", "x2", "y2"))
            yield (x, y), (other_x, other_y)
        case "rect":
            x, y, width, height = (_coordinate(shape, key) for key in ("x", "y", "width", "height"))
            if shape.get("rx", "0") not in ("0", "0px") or shape.get("ry", "0") not in ("0", "0px"):
                raise InputError("need straight lines, got a rectangle with round corners (rx, ry)")
            corners = [(x, y), (x + width, y), (x + width, y + height), (x, y + height)]
            yield from zip(corners, [*corners[1:], corners[0]], strict=True)
        case "polyline" | "polygon":
            numbers = numbers_of("points", shape.get("points", ""))
            if len(numbers) % 2:
                raise InputError(f"points: need two numbers for every point, got {len(numbers)} numbers")
            points = list(zip(numbers[::2], numbers[1::2], strict=True))
            yield from itertools.pairwise(points)
            if _tag(shape) == "polygon" and len(points) > 2:
                yield points[-1], points[0]
        case "path":
            yield from _lines_of_path(shape.get("d", ""))
        case _:
            raise InputError("need straight lines, got a curve; draw it as short straight lines")


def _coordinate(shape: ElementTree.Element, key: str) -> float:
    """Return a coordinate in the drawing's unit."""
    if key not in shape.attrib:
        return 0.0
    length = length_of(shape.get(key))
    if length is None:
        raise InputError(f"{key}: need a number, got {as_written(shape.get(key))}")
    return length[0] * (1.0 if length[1] is None else length[1] / PIXEL)


def _lines_of_path(data: str) -> Iterator[Line]:
    """Yield the straight lines of a path (SVG 2, section 9.3)."""
    point = first = (0.0, 0.0)
    if data.strip() and data.strip()[0] not in "Mm":
        raise InputError(f"d: need a path that begins with M, got {as_written(data)}")
    for command, text in re.findall(r"([A-DF-Za-df-z])([^A-DF-Za-df-z]*)", data):
        kind = command.lower()
        if kind not in _PATH_NUMBERS:
            raise InputError(
                f'd: need straight lines (M, L, H, V, Z), got a curve ("{command}"); draw it as short straight lines'
            )
        numbers, count = numbers_of("d", text), _PATH_NUMBERS[kind]
        if (len(numbers) % count if count else len(numbers)) or (count and not numbers):
            raise InputError(f'd: need {count} numbers a point after "{command}", got {len(numbers)}')
        if kind == "z":
            yield point, first
            point = first
        for index in range(0, len(numbers), count or 1):
            x, y = point if command.islower() else (0.0, 0.0)
            values = numbers[index : index + count]
            following = {
                "h": (x + values[0], point[1]),
                "v": (point[0], y + values[0]),
            }.get(kind) or (x + values[0], y + values[1])
            if kind == "m" and index == 0:
                first = following
            else:
                yield point, following
            point = following
