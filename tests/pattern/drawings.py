"""Drawings in the forms that other programs write."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path
from typing import Any

from forficula.pattern import CreasePattern, read_drawing

BLACK, RED, BLUE, GREEN, YELLOW = "black", "#f00", "rgb(0, 0, 255)", "lime", "#FFFF00"


def svg(path: Path, *shapes: str, head: str = 'width="100mm" height="100mm" viewBox="0 0 100 100"') -> Path:
    """An SVG drawing, 100 mm wide and high."""
    path.write_text(f'<svg xmlns="http://www.w3.org/2000/svg" {head}>{"".join(shapes)}</svg>', encoding="utf-8")
    return path


def line(x: float, y: float, other_x: float, other_y: float, stroke: str = RED, more: str = "") -> str:
    """A line of an SVG drawing."""
    return f'<line x1="{x}" y1="{y}" x2="{other_x}" y2="{other_y}" stroke="{stroke}" {more}/>'


def rim(stroke: str = BLACK) -> str:
    """A square of 60 mm, 20 mm from the page's left upper corner."""
    return f'<rect x="20" y="20" width="60" height="60" fill="none" stroke="{stroke}"/>'


def read(path: Path, *shapes: str, **choices: Any) -> tuple[CreasePattern, list[str]]:
    """Read a drawing with a rim, and return the pattern."""
    return read_drawing(svg(path / "sheet.svg", rim(), *shapes), **choices)


def dxf(
    path: Path, *entities: Iterable[tuple[int, object]], units: int = 4, layers: dict[str, int] | None = None
) -> Path:
    """A DXF drawing; millimetres unless another unit is given."""
    pairs: list[tuple[int, object]] = [(0, "SECTION"), (2, "HEADER"), (9, "$ACADVER"), (1, "AC1009")]
    pairs += [(9, "$INSUNITS"), (70, units), (0, "ENDSEC"), (0, "SECTION"), (2, "TABLES"), (0, "TABLE"), (2, "LAYER")]
    for name, colour in (layers or {}).items():
        pairs += [(0, "LAYER"), (2, name), (70, 0), (62, colour), (6, "CONTINUOUS")]
    pairs += [(0, "ENDTAB"), (0, "ENDSEC"), (0, "SECTION"), (2, "ENTITIES")]
    for entity in entities:
        pairs += entity
    pairs += [(0, "ENDSEC"), (0, "EOF")]
    path.write_text("".join(f"{code:>3}\n{value}\n" for code, value in pairs), encoding="utf-8")
    return path


def dxf_line(x: float, y: float, other_x: float, other_y: float, *more: tuple[int, object]) -> list[tuple[int, object]]:
    """A LINE."""
    return [(0, "LINE"), (5, "1F"), (8, "0"), *more, (10, x), (20, y), (30, 0), (11, other_x), (21, other_y), (31, 0)]


def faces_like(pattern: CreasePattern, original: CreasePattern) -> set[frozenset[int]]:
    """Faces by the vertices of the original, whose edges are in the same order."""
    pairs = zip(pattern.edges_vertices.ravel().tolist(), original.edges_vertices.ravel().tolist(), strict=True)
    number = dict(pairs)
    return {frozenset(number[vertex] for vertex in face) for face in pattern.faces_vertices}
