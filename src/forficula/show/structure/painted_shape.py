"""A structure as flat polygons from back to front: what a picture without a depth buffer needs."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from matplotlib.colors import to_rgb, to_rgba, to_rgba_array
from matplotlib.lines import Line2D
from matplotlib.patches import Patch
from numpy.typing import ArrayLike, NDArray

from forficula.show.structure.shape import Shape
from forficula.show.structure.surface import Surface
from forficula.show.style import BLUE, VERMILION
from forficula.structure import Structure, outer_ends

Array = NDArray[np.float64]

# of the regions of sheets and plates, in their order
TINTS = ("#E3D2AC", "#93BBDA", "#B7CFA2", "#D6AEB9", "#BDB6DC", "#CFCFCF")
BAR = "#3A3A3A"
_BACK = "#AEBFCB"  # of a facet, the side from which valleys fold away
_CREASE, _CASING = "#6E6E6E", "#FFFFFF"
_LIGHT = np.array([0.35, -0.25, 0.9])
# the eye's height, and how far from the middle of what lies flat it looks
_ELEVATION, _ASIDE = np.radians(47.0), np.radians(80.0)
# strips of a tube: from where to where beside its axis, in radii, and how light they are
_STRIPS = ((-1.0, -0.35, 0.75), (-0.35, 0.35, 1.5), (0.35, 1.0, 0.6))
# half widths in radii of the thickest bar
_TENDON, _CASED, _THIN, _FOLDED, _HELD = 0.62, 0.95, 0.14, 0.3, 1.0
_MOST_PIECES = 200  # along a side: what blew up is far longer than the whole
_CENTRED = 1e-3  # by the size of the whole: what is no further from the origin lies no way from it
_FLAT = "#B8B8B8"  # of what is not folded


@dataclass(frozen=True, kw_only=True)
class View:
    """From where a structure is looked at, in parallel projection.

    Attributes:
        right: across the picture, a unit vector, (axis,).
        up: upwards on it, likewise.
        towards: to the eye, likewise.
    """

    right: Array
    up: Array
    towards: Array

    def project(self, points: Array) -> Array:
        """Place points on the picture, m, (..., 3) -> (..., 2)."""
        return np.stack([points @ self.right, points @ self.up], axis=-1)


@dataclass(frozen=True, kw_only=True)
class PaintedShape:
    """What to paint, the farthest first.

    Attributes:
        polygons: m on the picture, (polygon, 4, 2).
        colours: red, green, blue, opacity, (polygon, 4).
    """

    polygons: Array
    colours: Array


def structure_view(structure: Structure) -> View:
    """Look at a structure from above and from beside the way that it lies from the origin, built."""
    ends = outer_ends(structure)
    x, y, _ = ends.mean(axis=0) if len(ends) else np.zeros(3)
    if math.hypot(x, y) < _CENTRED * structure.span:
        x, y = 0.0, 0.0
    azimuth = math.atan2(y, x) + _ASIDE
    right = np.array([-math.sin(azimuth), math.cos(azimuth), 0.0])
    level = np.array([math.cos(azimuth), math.sin(azimuth), 0.0])
    towards = math.cos(_ELEVATION) * level + np.array([0.0, 0.0, math.sin(_ELEVATION)])
    return View(right=right, up=np.cross(towards, right), towards=towards)


def paint_shape(
    surface: Surface, view: View, tendon_colours: str | Sequence[str] | ArrayLike, *, cells: int = 40
) -> PaintedShape:
    """Cut a surface into small polygons, shade them and sort them by their distance.

    Args:
        surface: in space.
        view: from where it is seen.
        tendon_colours: one, or one a tendon.
        cells: to the size of the whole; the more, the better is seen what hides what.
    """
    radius, cell = surface.thickness / 2, surface.span / cells
    # what lies on a face is in front of the cells beside it, whose middles may be nearer to the eye
    above = radius + cell / 2
    plain = np.isnan(surface.folds)
    parts = [
        _faces(surface, view, cell),
        _ribbons(surface.lines[plain], view, cell, _CREASE, _THIN * radius, cell / 2),
        _ribbons(surface.lines[~plain], view, cell, fold_colours(surface.folds[~plain]), _FOLDED * radius, cell / 2),
        _squares(surface.held, view, _HELD * radius, above),
    ]
    for low, high, lustre in _STRIPS:
        shade = to_rgba_array(BAR) * [lustre, lustre, lustre, 1]
        # the bright strip last, so that the ends of the others do not lie on it
        nearer = above + cell / 2 if lustre > 1 else above
        for thick in np.unique(surface.radii):
            bars = surface.bars[surface.radii == thick]
            parts.append(_ribbons(bars, view, cell, shade, (low * thick, high * thick), nearer))
    # the casing shows on both sides of what lies on it
    for half, colours, nearer in ((_CASED, _CASING, 2 * radius), (_TENDON, tendon_colours, 2 * radius + cell / 2)):
        parts.append(_ribbons(surface.tendons, view, cell, colours, half * radius, above + nearer))
    depths, polygons, shades = (np.concatenate(each) for each in zip(*parts, strict=True))
    order = np.argsort(depths, kind="stable")
    return PaintedShape(polygons=polygons[order], colours=np.clip(shades[order], 0, 1))


def fold_colours(angles: Array) -> Array:
    """Colours of creases by how far they are folded, valleys positive, rad: the further, the less pale, (crease, 4)."""
    full = np.where(angles[:, np.newaxis] > 0, to_rgba(BLUE), to_rgba(VERMILION))
    share = np.sqrt(np.minimum(np.abs(angles) / np.pi, 1))[:, np.newaxis]
    return np.asarray(share * full + (1 - share) * to_rgba(_FLAT))


def tint(region: int) -> str:
    """The colour of a region."""
    return TINTS[region % len(TINTS)]


def shape_handles(shape: Shape, structure: Structure, tendon_colour: ArrayLike, width: float) -> list[Patch | Line2D]:
    """What the colours mean, for a legend whose lines are so many points wide."""
    handles: list[Patch | Line2D] = [
        Patch(facecolor=tint(region), label=name) for region, name in enumerate(shape.regions)
    ]
    if structure.facets:
        handles.append(Patch(facecolor=_BACK, label="back of a facet"))
    if any(line.hinge is not None for line in shape.lines):
        for colour, name in ((VERMILION, "mountain"), (BLUE, "valley"), (_FLAT, "pale: nearly flat")):
            handles.append(Line2D([], [], color=colour, lw=0.75 * width, label=name))
    if shape.bars:
        handles.append(Line2D([], [], color=BAR, lw=width, label=structure.appearance.bar))
    if shape.tendons:
        handles.append(Line2D([], [], color=tendon_colour, lw=width, label="tendon"))  # type: ignore[arg-type]
    if len(shape.held):
        handles.append(Line2D([], [], color=BAR, marker="s", ls="none", ms=1.5 * width, label="held vertex"))
    return handles


def _faces(surface: Surface, view: View, cell: float) -> tuple[Array, Array, Array]:
    """Depths, polygons and colours of the cells of sheets and plates."""
    if not len(surface.faces):
        return np.zeros(0), np.zeros((0, 4, 2)), np.zeros((0, 4))
    cells, tints = [], []
    for face, region in zip(surface.faces, surface.regions.tolist(), strict=True):
        small = _cut(face, cell)
        cells.append(small)
        tints.append(np.tile(to_rgb(tint(region)), (len(small), 1)))
    every, colours = np.concatenate(cells), np.concatenate(tints)
    if surface.two_sided:
        colours[_normals(every) @ view.towards < 0] = to_rgb(_BACK)
    shades = np.column_stack([colours * _facing(every)[:, np.newaxis], np.ones(len(every))])
    return every.mean(axis=1) @ view.towards, view.project(every), shades


def _cut(quad: Array, cell: float) -> Array:
    """Cells of a surface between four corners, straight from side to side, (cell, 4, axis)."""
    first, second, third, fourth = quad
    u = np.linspace(0, 1, _pieces(max(_length(second - first), _length(third - fourth)), cell) + 1)
    v = np.linspace(0, 1, _pieces(max(_length(fourth - first), _length(third - second)), cell) + 1)
    u, v = u[:, np.newaxis, np.newaxis], v[:, np.newaxis]
    grid = (1 - v) * ((1 - u) * first + u * second) + v * ((1 - u) * fourth + u * third)
    return np.stack([grid[:-1, :-1], grid[1:, :-1], grid[1:, 1:], grid[:-1, 1:]], axis=2).reshape(-1, 4, 3)


def _length(vector: Array) -> float:
    return float(np.linalg.norm(vector))


def _pieces(length: float, cell: float) -> int:
    return max(1, math.ceil(min(length / cell, _MOST_PIECES)))


def _normals(quads: Array) -> Array:
    """Twice the area of cells, along their normals, m^2, (quad, axis)."""
    return np.cross(quads[:, 2] - quads[:, 0], quads[:, 3] - quads[:, 1])


def _facing(quads: Array) -> Array:
    """Lambert shading of both sides alike, (quad,)."""
    normals = _normals(quads)
    lengths = np.maximum(np.linalg.norm(normals, axis=1), 1e-300)
    return np.asarray(0.55 + 0.45 * np.abs(normals @ _LIGHT) / lengths / np.linalg.norm(_LIGHT))


def _squares(places: Array, view: View, half: float, above: float) -> tuple[Array, Array, Array]:
    """Depths, polygons and colours of squares that face the eye, by their middles, m, (square, axis)."""
    corners = half * np.array([[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]])
    shades = np.broadcast_to(to_rgba(BAR), (len(places), 4))
    return places @ view.towards + above, view.project(places)[:, np.newaxis] + corners, shades


def _ribbons(
    lines: Array,
    view: View,
    cell: float,
    colours: str | Sequence[str] | ArrayLike,
    width: float | tuple[float, float],
    above: float,
) -> tuple[Array, Array, Array]:
    """Depths, polygons and colours of lines, as bands that face the eye.

    Args:
        lines: m, (line, end, axis).
        view: from where they are seen.
        cell: length of a polygon, m.
        colours: one, or one a line.
        width: half of the band's, or from where to where it lies beside the line, m.
        above: how much nearer than the line it is painted, m.
    """
    if not len(lines):
        return np.zeros(0), np.zeros((0, 4, 2)), np.zeros((0, 4))
    pieces = _pieces(max(_length(end - start) for start, end in lines), cell)
    shares = np.linspace(0, 1, pieces + 1)[:, np.newaxis]
    points = lines[:, :1] + shares * (lines[:, 1:] - lines[:, :1])
    flat = view.project(points)
    across = (flat[:, -1] - flat[:, 0])[:, ::-1] * [-1, 1]
    across /= np.maximum(np.linalg.norm(across, axis=1, keepdims=True), 1e-300)
    low, high = width if isinstance(width, tuple) else (-width, width)
    left, right = (flat + side * across[:, np.newaxis] for side in (low, high))
    bands = np.stack([left[:, :-1], left[:, 1:], right[:, 1:], right[:, :-1]], axis=2)
    depths = ((points[:, :-1] + points[:, 1:]) / 2) @ view.towards + above
    shades = np.repeat(np.broadcast_to(to_rgba_array(colours), (len(lines), 4)), pieces, axis=0)
    return depths.ravel(), bands.reshape(-1, 4, 2), shades
