"""Reading of straight lines from a DXF drawing, with the kinds of edges that their layers or colours mean."""

from __future__ import annotations

import codecs
import colorsys
import io
import itertools
import logging
import math
import re
from collections import Counter
from pathlib import Path
from typing import TYPE_CHECKING

from forficula.errors import InputError, error_prefix
from forficula.files import read_bytes
from forficula.names import one_line
from forficula.pattern.drawings.drawing import Drawing, DrawnLine, check_has_lines, letter_of_colour
from forficula.pattern.files.edge_names import letter_of_name
from forficula.quantities import as_written

if TYPE_CHECKING:
    from ezdxf.document import Drawing as Document
    from ezdxf.entities.dxfgfx import DXFGraphic
    from ezdxf.entities.layer import Layer

Point = tuple[float, float]
Colour = tuple[float, float, float]

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
_INSERT_UNITS = re.compile(rb"^\$INSUNITS\n70\n(.*)$", re.MULTILINE)
_HANDLES = re.compile(rb"^5\n([0-9A-F]+)$", re.MULTILINE)
_OLD_RELEASE = re.compile(rb"^(\$ACADVER\n1\n)AC10(06|09)$", re.MULTILINE)
# the type of the entity and the group codes that all entities have, before the first code of polylines only
_LWPOLYLINE = re.compile(rb"^(0\nLWPOLYLINE\n)((?:(?!0\n).*\n.*\n)*?)(?=(?:10|38|39|43|70|90|210)\n)", re.MULTILINE)
_LINES = {"LINE", "LWPOLYLINE", "POLYLINE"}
_CURVES = {"ARC", "CIRCLE", "ELLIPSE", "SPLINE", "HELIX"}
_BLOCK = "INSERT"
_BY_LAYER, _BY_BLOCK = 256, 0
_HEADER = b"0\nSECTION\n2\nHEADER\n"
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
_BINARY = b"AutoCAD Binary DXF"
_BEGINNING = re.compile(rb"(999\n.*\n)*0\nSECTION\n")
_LONGEST_REASON = 160

logging.getLogger("ezdxf").addHandler(logging.NullHandler())  # otherwise its warnings go to the terminal


def read_dxf(file: Path) -> Drawing:
    """Read the straight lines of a DXF drawing: LINE, LWPOLYLINE and POLYLINE of the model, seen from +z.

    The name of the layer, such as "mountain" or "V", defines the kind of a line, or else its colour: red (1) mountain,
    blue (5) valley, black or white (7) border, green (3) cut, yellow (2) and greys flat, magenta (6) unassigned.

    Raises:
        InputError: the file cannot be read, is not a DXF drawing, or has curves or blocks among its creases.
    """
    content = read_bytes(file)
    binary = content.startswith(_BINARY)
    if not binary:
        content = b"\n".join([line.strip() for line in content.removeprefix(codecs.BOM_UTF8).splitlines()]) + b"\n"
    unit = 0 if binary else _insert_units(content)
    document, repairs = _document(content)
    layers = {layer.dxf.name.lower(): layer for layer in document.layers}
    left_out, seen, lines = Counter[str](), Counter[str](), list[DrawnLine]()
    handles = set(_HANDLES.findall(content))
    for entity in document.modelspace():
        kind, handle = entity.dxftype(), str(entity.dxf.handle)
        if kind not in (*_LINES, *_CURVES, _BLOCK):
            continue
        seen[kind] += 1
        # ezdxf gives a handle to entities that have none in the file
        name = f"{kind} {seen[kind]}" + (f" (handle {handle})" if handle.encode() in handles else "")
        with error_prefix(f"{name}: "):
            lines += _drawn_lines(entity, layers.get(entity.dxf.layer.lower()), left_out, name)
    if binary and b"$INSUNITS" in content:
        unit = document.header.get("$INSUNITS", 0)
    remarks = (*repairs, *check_has_lines(lines, left_out))
    return Drawing(lines=tuple(lines), unit=_METRES.get(unit), assumed_unit=None, title="", remarks=remarks)


def _insert_units(content: bytes) -> int:
    """Return the number of the unit in the header of a text, 0 where the header has no unit.

    ezdxf reads 5.7 as 5, and returns metres where the file has no header.
    """
    if (unit := _INSERT_UNITS.search(content)) is None:
        return 0
    if not re.fullmatch(rb"\+?[0-9]{1,9}(\.0*)?", unit[1]):
        line, value = content.count(b"\n", 0, unit.start(1)) + 1, unit[1].decode(errors="replace")
        raise InputError(f"line {line}: $INSUNITS: need a whole number from 0 on, got {as_written(value)}")
    return int(float(unit[1]))


def _document(content: bytes) -> tuple[Document, list[str]]:
    """Read a DXF document, and list the repairs without which ezdxf could not read it."""
    from ezdxf import recover
    from ezdxf.document import Drawing as Document
    from ezdxf.lldxf.tagger import binary_tags_loader

    binary = content.startswith(_BINARY)
    if not (binary or _BEGINNING.match(content)):
        raise InputError("need a DXF drawing, got a file that does not begin with a section")
    try:
        if binary:
            return Document.load(binary_tags_loader(content)), []
        return Document.read(io.StringIO(_text(_with_markers(content)))), []
    except Exception as error:  # a damaged file may break any part of the library
        if binary:
            raise InputError(f"need a DXF drawing, got a damaged binary one: {_reason(error)}") from None
    try:
        # the original content, so that errors name its lines; without an end mark, the last section would be lost
        document, audit = recover.read(io.BytesIO(content + b"0\nEOF\n"))
    except Exception as error:
        raise InputError(f"need a DXF drawing, got a damaged one: {_reason(error)}") from None
    if audit.errors:
        raise InputError(f"need a DXF drawing, got a damaged one: {_reason(audit.errors[0].message)}")
    repairs = Counter(_reason(fix.message) for fix in audit.fixes)
    return document, [f"damaged file repaired: {message}" for message in repairs]


def _with_markers(content: bytes) -> bytes:
    """Add what ezdxf needs to read LWPOLYLINE: a release of 2000 or later, and markers of subclasses."""
    if b"LWPOLYLINE" not in content:
        return content
    content = _OLD_RELEASE.sub(rb"\g<1>AC1015", content, count=1)
    if b"$ACADVER\n" not in content:
        version = b"9\n$ACADVER\n1\nAC1015\n"
        header = content.find(_HEADER)
        if header >= 0:
            start = header + len(_HEADER)
            content = content[:start] + version + content[start:]
        else:
            content = _HEADER + version + b"0\nENDSEC\n" + content
    if b"AcDbPolyline" in content:
        return content
    return _LWPOLYLINE.sub(rb"\g<1>100\nAcDbEntity\n\g<2>100\nAcDbPolyline\n", content)


def _text(content: bytes) -> str:
    """Decode a text: as UTF-8 where possible, otherwise by the code page of the header."""
    from ezdxf.filemanagement import dxf_stream_info

    try:
        return content.decode()
    except UnicodeDecodeError:
        header = dxf_stream_info(io.StringIO(content.decode(errors="ignore")))
        return content.decode(header.encoding, errors="surrogateescape")


def _reason(error: object) -> str:
    """Return the reason that ezdxf gives, on one short line."""
    text = one_line(str(error))
    return text if len(text) <= _LONGEST_REASON else f"{text[:_LONGEST_REASON]}..."


def _index_colour(index: int) -> Colour:
    """Return a colour of AutoCAD's index: from 10 on, 24 hues by 10, each in 5 shades; greys from 250 on.

    The table of ezdxf 1.4 deviates in dark shades: a channel is 88 instead of 38 in 109, 159 to 249 and others.
    """
    if index in _COLOURS:
        return _COLOURS[index]
    if not 10 <= index <= 255:
        return _COLOURS[7]
    if index >= 250:
        grey = 0.2 + (index - 250) * 0.13
        return grey, grey, grey
    shade = (1.0, 0.65, 0.5, 0.3, 0.15)[index % 10 // 2]
    return colorsys.hsv_to_rgb((index // 10 - 1) / 24, 0.5 if index % 2 else 1.0, shade)


def _colour(drawn: DXFGraphic | Layer) -> Colour:
    """Return the colour of an entity or a layer: its true colour, or that of its index."""
    if (rgb := drawn.rgb) is not None:
        return rgb[0] / 255, rgb[1] / 255, rgb[2] / 255
    return _index_colour(abs(drawn.dxf.color))


def _drawn_lines(entity: DXFGraphic, layer: Layer | None, left_out: Counter[str], name: str) -> list[DrawnLine]:
    """Return the lines of an entity that are part of a sheet; count an entity without a meaning."""
    kind, layer_name = entity.dxftype(), entity.dxf.layer
    hidden = entity.dxf.invisible == 1 or (layer is not None and (layer.is_off() or layer.is_frozen()))
    if hidden:
        return []
    if kind == "LWPOLYLINE" and entity.doc is not None and entity.doc.dxfversion <= "AC1009":
        raise InputError(
            "need release 2000 or later ($ACADVER) for LWPOLYLINE, got release 12; save the drawing as R2000 DXF"
        )
    if kind == _BLOCK:
        raise InputError("need lines themselves, got a block; explode it in a drawing program")
    by_layer = entity.rgb is None and entity.dxf.color in (_BY_LAYER, _BY_BLOCK)
    colour = _colour(entity) if not by_layer else _COLOURS[7] if layer is None else _colour(layer)
    letter = letter_of_name(layer_name) or letter_of_colour(*colour)
    if letter is None:
        red, green, blue = (round(255 * share) for share in colour)
        left_out[f"layer {as_written(layer_name)}, colour #{red:02x}{green:02x}{blue:02x}"] += 1
        return []
    if kind in _CURVES:
        raise InputError("need straight lines, got a curve; draw it as short straight lines")
    points = _points(entity)
    if bad := [value for point in points for value in point if not math.isfinite(value)]:
        raise InputError(f"need finite numbers, got {bad[0]}")
    return [DrawnLine(start, end, letter, math.nan, name) for start, end in itertools.pairwise(points)]


def _points(entity: DXFGraphic) -> list[Point]:
    """Return the corners of a line or polyline in world coordinates; a closed one ends at its first corner."""
    from ezdxf.entities.lwpolyline import LWPolyline
    from ezdxf.entities.polyline import Polyline

    if not isinstance(entity, LWPolyline | Polyline):
        for end in ("start", "end"):
            if not entity.dxf.hasattr(end):
                raise InputError(f"need coordinates of its {end}, got none")
        return [(end.x, end.y) for end in (entity.dxf.start, entity.dxf.end)]
    normal = entity.dxf.extrusion
    if normal.x or normal.y:
        raise InputError("need a polyline in the plane of the drawing, got one out of it (codes 210 to 230)")
    if entity.has_arc:
        raise InputError("need straight lines, got an arc in a polyline (bulge, code 42)")
    if isinstance(entity, Polyline) and not all(vertex.dxf.hasattr("location") for vertex in entity.vertices):
        raise InputError("need coordinates of every corner, got one without")
    corners = entity.points_in_wcs() if isinstance(entity, Polyline) else entity.vertices_in_wcs()
    points = [(corner.x, corner.y) for corner in corners]
    return [*points, points[0]] if entity.is_closed and len(points) > 2 else points
