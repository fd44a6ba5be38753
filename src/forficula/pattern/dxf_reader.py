"""The straight lines of a DXF drawing (text form), with the kinds of creases that their layers or colours mean."""

from __future__ import annotations

import colorsys
import itertools
import math
import re
from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

from forficula.errors import InputError
from forficula.files import read_bytes
from forficula.pattern.drawing import Drawing, DrawnLine, check_some, letter_of_colour
from forficula.pattern.edge_names import letter_of_name
from forficula.quantities import as_written

Pair = tuple[int, str]
Entity = list[Pair]
Point = tuple[float, float]

# m by $INSUNITS (Autodesk, DXF reference, header variables); 0 is "no unit"
_METRES = {
    1: 0.0254,
    2: 0.3048,
    4: 1e-3,
    5: 1e-2,
    6: 1.0,
    8: 2.54e-8,
    9: 2.54e-5,
    10: 0.9144,
    12: 1e-9,
    13: 1e-6,
    14: 0.1,
}
_CURVES = {"ARC", "CIRCLE", "ELLIPSE", "SPLINE", "HELIX"}
_COPIES = {"INSERT"}
_BY_LAYER, _BY_BLOCK = 256, 0
_COLOURS = {
    1: (1.0, 0.0, 0.0),
    2: (1.0, 1.0, 0.0),
    3: (0.0, 1.0, 0.0),
    4: (0.0, 1.0, 1.0),
    5: (0.0, 0.0, 1.0),
    6: (1.0, 0.0, 1.0),
    7: (0.0, 0.0, 0.0),  # black on white paper
    8: (0.5, 0.5, 0.5),
    9: (0.75, 0.75, 0.75),
}


@dataclass(frozen=True, kw_only=True)
class _Layer:
    """A layer: its colour, and whether it is shown."""

    colour: tuple[float, float, float]
    shown: bool


def read_dxf(file: Path) -> Drawing:
    """Read the straight lines of a DXF drawing: LINE, LWPOLYLINE and POLYLINE of the model, seen from +z.

    The name of its layer says what a line is, such as "mountain" or "V", or else its colour: red (1) mountain, blue
    (5) valley, black or white (7) border, green (3) cut, yellow (2) and greys flat, magenta (6) unassigned.

    Raises:
        InputError: the file cannot be read, is no DXF text, or has curves or blocks among its creases.
    """
    pairs = _pairs(file)
    sections = _sections(pairs)
    if "ENTITIES" not in sections:
        raise InputError("need a DXF drawing as text, got no section ENTITIES")
    layers = _layers(sections.get("TABLES", []))
    left_out, seen, lines = Counter[str](), Counter[str](), list[DrawnLine]()
    for entity in _with_vertices(_entities(sections["ENTITIES"])):
        kind = entity[0][0][1]
        seen[kind] += 1
        handle = next((f" (handle {value})" for code, value in entity[0] if code == 5), "")
        try:
            lines += _drawn_lines(entity, layers, left_out, f"{kind} {seen[kind]}{handle}")
        except InputError as error:
            raise InputError(f"{kind} {seen[kind]}{handle}: {error}") from None
    remarks = check_some(lines, left_out)
    unit = _METRES.get(_insert_units(pairs, sections.get("HEADER", [])))
    return Drawing(lines=tuple(lines), unit=unit, assumed_unit=None, title="", remarks=remarks)


def _pairs(file: Path) -> list[Pair]:
    """The group codes and values of a file."""
    content = read_bytes(file)
    if content.startswith(b"AutoCAD Binary DXF"):
        raise InputError("need DXF as text, got binary DXF; save it as ASCII DXF")
    rows = content.decode("utf-8-sig", errors="replace").splitlines()
    pairs: list[Pair] = []
    for row in range(0, len(rows) - 1, 2):
        try:
            pairs.append((int(rows[row]), rows[row + 1].strip()))
        except ValueError:
            raise InputError(
                f"need DXF text, pairs of lines with a number first, got {as_written(rows[row])} in line {row + 1}"
            ) from None
    return pairs


def _sections(pairs: Sequence[Pair]) -> dict[str, list[Pair]]:
    """What lies between SECTION and ENDSEC, by name."""
    sections: dict[str, list[Pair]] = {}
    inside: list[Pair] | None = None
    for place, pair in enumerate(pairs):
        if pair == (0, "SECTION") and place + 1 < len(pairs):
            inside = sections.setdefault(pairs[place + 1][1], [])
        elif pair == (0, "ENDSEC"):
            inside = None
        elif inside is not None:
            inside.append(pair)
    return sections


def _entities(pairs: Sequence[Pair]) -> list[Entity]:
    """What begins with a code 0, each with its pairs."""
    entities: list[Entity] = []
    for pair in pairs:
        if pair[0] == 0:
            entities.append([pair])
        elif entities:
            entities[-1].append(pair)
    return entities


def _with_vertices(entities: Sequence[Entity]) -> Iterator[list[Entity]]:
    """Every entity, a POLYLINE with its vertices behind it."""
    waiting: list[Entity] = []
    for entity in entities:
        kind = entity[0][1]
        if waiting and kind == "VERTEX":
            waiting.append(entity)
            continue
        if waiting:
            yield waiting
            waiting = []
        if kind == "POLYLINE":
            waiting = [entity]
        elif kind != "SEQEND":
            yield [entity]
    if waiting:
        yield waiting


def _insert_units(pairs: Sequence[Pair], header: Sequence[Pair]) -> int:
    """The number of the drawing's unit; 0 where it has none."""
    for (code, name), (_, value) in itertools.pairwise(header):
        if name == "$INSUNITS":
            if not re.fullmatch(r"\+?[0-9]{1,9}(\.0*)?", value):
                line = 2 * pairs.index((code, name)) + 4  # two lines a pair
                raise InputError(f"line {line}: $INSUNITS: need a whole number from 0 on, got {as_written(value)}")
            return int(float(value))
    return 0


def _layers(tables: Sequence[Pair]) -> dict[str, _Layer]:
    """The layers of a drawing, by name."""
    layers: dict[str, _Layer] = {}
    for entity in _entities(tables):
        if entity[0][1] == "LAYER":
            of = dict(entity)
            number = int(_number(of.get(62, "7")))
            frozen = int(_number(of.get(70, "0"))) & 1
            colour = _true_colour(of) or _index_colour(abs(number))
            layers[of.get(2, "")] = _Layer(colour=colour, shown=number >= 0 and not frozen)
    return layers


def _true_colour(of: dict[int, str]) -> tuple[float, float, float] | None:
    """A colour that is written out, code 420."""
    if 420 not in of:
        return None
    number = int(_number(of[420]))
    return (number >> 16 & 255) / 255, (number >> 8 & 255) / 255, (number & 255) / 255


def _index_colour(index: int) -> tuple[float, float, float]:
    """A colour of AutoCAD's index: from 10 on, 24 hues by 10, each in 5 shades; greys from 250 on."""
    if index in _COLOURS:
        return _COLOURS[index]
    if not 10 <= index <= 255:
        return _COLOURS[7]
    if index >= 250:
        grey = 0.2 + (index - 250) * 0.13
        return grey, grey, grey
    shade = (1.0, 0.65, 0.5, 0.3, 0.15)[index % 10 // 2]
    return colorsys.hsv_to_rgb((index // 10 - 1) / 24, 0.5 if index % 2 else 1.0, shade)


def _drawn_lines(
    entity: Sequence[Entity], layers: dict[str, _Layer], left_out: Counter[str], name: str
) -> list[DrawnLine]:
    """The lines of an entity that are part of a sheet; count one that means nothing."""
    of, kind = dict(entity[0]), entity[0][0][1]
    layer_name = of.get(8, "0")
    layer = layers.get(layer_name, _Layer(colour=_COLOURS[7], shown=True))
    drawn = kind in ("LINE", "LWPOLYLINE", "POLYLINE", *_CURVES, *_COPIES)
    if of.get(67, "0") == "1" or of.get(60, "0") == "1" or not layer.shown or not drawn:
        return []
    if kind in _COPIES:
        raise InputError("need lines themselves, got a block; explode it in a drawing program")
    index = int(_number(of.get(62, str(_BY_LAYER))))
    own = _true_colour(of) or (_index_colour(index) if index not in (_BY_LAYER, _BY_BLOCK) else layer.colour)
    letter = letter_of_name(layer_name) or letter_of_colour(*own)
    if letter is None:
        red, green, blue = (round(255 * share) for share in own)
        left_out[f"layer {as_written(layer_name)}, colour #{red:02x}{green:02x}{blue:02x}"] += 1
        return []
    if kind in _CURVES:
        raise InputError("need straight lines, got a curve; draw it as short straight lines")
    points, closed = _points(entity)
    if any(code == 42 and _number(value) != 0 for part in entity for code, value in part):
        raise InputError("need straight lines, got an arc in a polyline (bulge, code 42)")
    ends = list(itertools.pairwise(points))
    if closed and len(points) > 2:
        ends.append((points[-1], points[0]))
    return [DrawnLine(start, end, letter, math.nan, name) for start, end in ends]


def _points(entity: Sequence[Entity]) -> tuple[list[Point], bool]:
    """The corners of a line or polyline, and whether it closes."""
    first, *vertices = entity
    of = dict(first)
    if of[0] == "LINE":
        return [(_at(of, 10), _at(of, 20)), (_at(of, 11), _at(of, 21))], False
    normal = [_number(of.get(code, default)) for code, default in ((210, "0"), (220, "0"), (230, "1"))]
    if normal[:2] != [0, 0] or normal[2] == 0:
        raise InputError("need a polyline in the plane of the drawing, got one that stands on it (codes 210 to 230)")
    sense = math.copysign(1.0, normal[2])  # seen from below, x is counted the other way
    closed = bool(int(_number(of.get(70, "0"))) & 1)
    if of[0] == "POLYLINE":
        return [(sense * _at(dict(vertex), 10), _at(dict(vertex), 20)) for vertex in vertices], closed
    across = [sense * _number(value) for code, value in first if code == 10]
    upwards = [_number(value) for code, value in first if code == 20]
    if len(across) != len(upwards):
        raise InputError(f"need x and y for every corner, got {len(across)} x (code 10) and {len(upwards)} y (code 20)")
    return list(zip(across, upwards, strict=True)), closed


def _at(of: dict[int, str], code: int) -> float:
    """A coordinate."""
    if code not in of:
        raise InputError(f"need a coordinate, code {code}, got none")
    return _number(of[code])


def _number(text: str) -> float:
    """A finite number."""
    try:
        number = float(text)
    except ValueError:
        number = math.nan
    if not math.isfinite(number):
        raise InputError(f"need a finite number, got {as_written(text)}")
    return number
