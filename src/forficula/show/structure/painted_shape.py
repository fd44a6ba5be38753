"""A structure as shaded triangles, and as a picture of them in axes."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from matplotlib.axes import Axes
from matplotlib.colors import to_rgb, to_rgba, to_rgba_array
from matplotlib.lines import Line2D
from matplotlib.patches import Patch
from numpy.typing import ArrayLike

from forficula.arrays import Array, Flags, Indices
from forficula.show.structure.raster import SAMPLES, Picture, rasterise
from forficula.show.structure.shape import Shape
from forficula.show.structure.surface import DrawnSurface
from forficula.show.structure.viewpoint import Viewpoint
from forficula.show.style import BLUE, PICTURE_RESOLUTION, VERMILION
from forficula.structure import Structure

# colours of the regions of sheets and plates, in their order
TINTS = ("#E2CF9F", "#C5BCD9", "#B7CFA2", "#D6AEB9", "#9CC4DD", "#CFCFCF")
# colours of bars of the same regions if these are groups of bodies: the same hues, darker
BAR_TINTS = ("#735826", "#54458A", "#35693A", "#8C4467", "#0B5A8A", "#525252")
BAR = "#3A3A3A"
_BACK = "#AEBFCB"  # back of a facet, the side away from which valleys fold
_UNDERSIDE = 0.84  # brightness of the back of a facet in a group of bodies
_CREASE, _CASING = "#6E6E6E", "#FFFFFF"
# direction to the light: right, up and towards the eye, as on the pages (web/src/stage.js)
_LIGHT = np.array([-0.45, 0.75, 1.0])
_SHADE, _LUMINOSITY = 0.6, 0.45  # brightness of a face along the light, and what is added across it
# half widths, in radii of the thickest bar
_TENDON, _CASED, _THIN, _FOLDED, _HELD = 0.62, 0.95, 0.14, 0.3, 1.0
# in that radius: distance by which lines are painted closer to the eye than their face, or their bar's axis
_ON_FACE, _ON_BAR = 0.5, 1.5
# in that radius: depth behind a face up to which a whole tendon, or a part of one, counts as lying on the face
_WHOLE_BEHIND, _PART_BEHIND = 1.5, 0.15
_PIECES = 64  # pieces of a tendon that are each visible or hidden
_CELLS = 12  # cells along a side of a twisted face, whose shade varies
_TWIST = 1e-6  # volume between a face's corners, in cubes of the span, above which the face counts as twisted
_SIDES = 12  # sides of a tube
_DULL, _LUSTRE = 0.55, 0.95  # brightness of a tube seen from the side, and what is added seen from above
_FLAT = "#B8B8B8"  # colour of unfolded creases


@dataclass(frozen=True, kw_only=True)
class PaintedShape:
    """Triangles to paint, which may hide or intersect one another.

    Attributes:
        triangles: m in the picture, and towards the eye, (triangle, corner, 3); of equally close ones the last is
            visible.
            one is visible.
        colours: red, green, blue, 0 to 1, (triangle, 3).
    """

    triangles: Array
    colours: Array

    @property
    def corners(self) -> Array:
        """Lower left and upper right corner of the painted area, m in the picture, (2, 2)."""
        places = self.triangles[..., :2].reshape(-1, 2)
        return np.array([places.min(axis=0), places.max(axis=0)])

    def picture(self, low: Array, pixel: float, size: tuple[int, int], samples: int = SAMPLES) -> Picture:
        """Rasterise the triangles.

        Args:
            low: lower left corner of the picture, m, (2,).
            pixel: side of a pixel, m.
            size: pixels across and upwards.
            samples: samples per pixel, across and upwards.

        Returns:
            Red, green, blue and opacity, 0 to 255, the highest row first, (height, width, 4).
        """
        placed = (self.triangles - [*low, 0.0]) / [pixel, -pixel, pixel] + [0.0, size[1], 0.0]
        return rasterise(placed, self.colours, size, samples)


def paint_shape(
    surface: DrawnSurface,
    view: Viewpoint,
    tendon_colours: str | Sequence[str] | ArrayLike,
    face_colours: Array | None = None,
) -> PaintedShape:
    """Cover a surface with triangles and shade them.

    Args:
        surface: surface in 3-D.
        view: viewpoint.
        tendon_colours: one colour, or one for each tendon.
        face_colours: red, green, blue of faces, 0 to 1, (face, 3), drawn without shading; the colours of their regions
            by
                default.
    """
    radius = surface.thickness / 2
    plain = np.isnan(surface.folds)
    tendons, numbers = _in_front(surface.tendons, surface.faces, view, radius)
    shades = np.broadcast_to(to_rgba_array(tendon_colours), (len(surface.tendons), 4))[numbers]
    folds = fold_colours(surface.folds[~plain])
    parts = [
        _faces(surface, view, face_colours),
        ribbons(surface.lines[plain], view, _CREASE, _THIN * radius, _ON_FACE * radius),
        ribbons(surface.lines[~plain], view, folds, _FOLDED * radius, _ON_FACE * radius),
        _tubes(surface.bars, surface.radii, view, _bar_colours(surface)),
        # the casing is wider than the tendon on top of it
        ribbons(tendons, view, _CASING, _CASED * radius, _ON_BAR * radius),
        ribbons(tendons, view, shades, _TENDON * radius, (_ON_BAR + _ON_FACE) * radius),
        _squares(surface.held, view, _HELD * radius, _ON_BAR * radius),
    ]
    quads, colours = (np.concatenate(item) for item in zip(*parts, strict=True))
    placed = np.concatenate([view.project(quads), (quads @ view.towards)[..., np.newaxis]], axis=-1)
    return PaintedShape(
        triangles=placed[:, [[0, 1, 2], [0, 2, 3]]].reshape(-1, 3, 3), colours=np.repeat(colours, 2, axis=0)
    )


def show_painted(axes: Axes, painted: PaintedShape, window: Array, width: float) -> None:
    """Show a painted shape in axes without lines, with one scale for both directions.

    Args:
        axes: axes to draw into.
        painted: shape to show.
        window: lower left and upper right corner of the visible area, m, (2, 2).
        width: width of the window in the figure, inch.
    """
    low, high = np.clip(painted.corners, *window)
    pixel = float(window[1, 0] - window[0, 0]) / (width * PICTURE_RESOLUTION)
    across, upwards = np.maximum(np.ceil((high - low) / pixel), 1).astype(int).tolist()
    left, bottom = low.tolist()
    drawn = painted.picture(low, pixel, (across, upwards))
    axes.imshow(drawn, extent=(left, left + across * pixel, bottom, bottom + upwards * pixel))
    axes.set(xlim=window[:, 0], ylim=window[:, 1], aspect="equal")
    axes.set_axis_off()


def fold_colours(angles: Array) -> Array:
    """Return colours of creases by fold angle, valleys positive, rad: stronger with larger angles, (crease, 4)."""
    full = np.where(angles[:, np.newaxis] > 0, to_rgba(BLUE), to_rgba(VERMILION))
    share = np.sqrt(np.minimum(np.abs(angles) / np.pi, 1))[:, np.newaxis]
    return np.asarray(share * full + (1 - share) * to_rgba(_FLAT))


def tint(region: int) -> str:
    """Return the colour of a region."""
    return TINTS[region % len(TINTS)]


def bar_tint(region: int) -> str:
    """Return the colour of the bars of a region that is a group of bodies."""
    return BAR_TINTS[region % len(BAR_TINTS)]


def _bar_colours(surface: DrawnSurface) -> Array:
    """Return red, green and blue of each bar, 0 to 1, (bar, 3)."""
    regions = [-1] * len(surface.bars) if surface.bar_regions is None else surface.bar_regions.tolist()
    return np.array([to_rgb(BAR if region < 0 else bar_tint(region)) for region in regions]).reshape(-1, 3)


def shape_handles(shape: Shape, structure: Structure, tendon_colour: ArrayLike, width: float) -> list[Patch | Line2D]:
    """Return the entries of a legend, with lines of a width in points."""
    handles: list[Patch | Line2D] = [
        Patch(facecolor=tint(region), label=name) for region, name in enumerate(shape.regions)
    ]
    if structure.facets and not shape.grouped:
        handles.append(Patch(facecolor=_BACK, label="back of a facet"))
    if any(line.hinge is not None for line in shape.lines):
        for colour, name in ((VERMILION, "mountain"), (BLUE, "valley"), (_FLAT, "pale: nearly flat")):
            handles.append(Line2D([], [], color=colour, lw=0.75 * width, label=name))
    if any(bar.region is None for bar in shape.bars):
        handles.append(Line2D([], [], color=BAR, lw=width, label=structure.appearance.bar))
    if shape.tendons:
        handles.append(Line2D([], [], color=tendon_colour, lw=width, label="tendon"))  # type: ignore[arg-type]
    if len(shape.held):
        handles.append(Line2D([], [], color=BAR, marker="s", ls="none", ms=1.5 * width, label="support"))
    return handles


def _faces(surface: DrawnSurface, view: Viewpoint, textures: Array | None) -> tuple[Array, Array]:
    """Return corners and colours of the cells of sheets and plates."""
    if not len(surface.faces):
        return np.zeros((0, 4, 3)), np.zeros((0, 3))
    if textures is not None:
        return surface.faces, textures
    tints = np.array([to_rgb(tint(region)) for region in surface.regions.tolist()])
    first, second, third, fourth = surface.faces.swapaxes(0, 1)
    out_of_plane = np.abs(np.sum(np.cross(second - first, third - first) * (fourth - first), axis=1))
    twisted = out_of_plane > _TWIST * surface.span**3
    cells = np.concatenate([surface.faces[~twisted], _cells(surface.faces[twisted])])
    colours = np.concatenate([tints[~twisted], np.repeat(tints[twisted], _CELLS**2, axis=0)])
    if surface.two_sided:
        behind = _normals(cells) @ view.towards < 0
        colours[behind] = to_rgb(_BACK) if surface.bar_regions is None else _UNDERSIDE * colours[behind]
    return cells, colours * _facing(cells, view)[:, np.newaxis]


def _cells(quads: Array) -> Array:
    """Return cells of ruled surfaces between four corners, `_CELLS` along a side, (cell, 4, axis)."""
    shares = np.linspace(0, 1, _CELLS + 1)
    u, v = shares[:, np.newaxis, np.newaxis], shares[:, np.newaxis]
    first, second, third, fourth = quads[:, :, np.newaxis, np.newaxis].swapaxes(0, 1)
    grid = (1 - v) * ((1 - u) * first + u * second) + v * ((1 - u) * fourth + u * third)
    cells = [grid[:, :-1, :-1], grid[:, 1:, :-1], grid[:, 1:, 1:], grid[:, :-1, 1:]]
    return np.stack(cells, axis=3).reshape(-1, 4, 3)


def _normals(quads: Array) -> Array:
    """Return vectors along the normals of cells, twice as long as their areas, m^2, (quad, axis)."""
    return np.cross(quads[:, 2] - quads[:, 0], quads[:, 3] - quads[:, 1])


def _facing(quads: Array, view: Viewpoint) -> Array:
    """Return the Lambert shading of cells, the same for both sides, (quad,)."""
    light = _LIGHT @ np.stack([view.right, view.up, view.towards])
    return np.asarray(_SHADE + _LUMINOSITY * np.abs(_unit(_normals(quads)) @ _unit(light)))


def _unit(vectors: Array) -> Array:
    return np.asarray(vectors / np.maximum(np.linalg.norm(vectors, axis=-1, keepdims=True), 1e-300))


def _in_front(lines: Array, faces: Array, view: Viewpoint, radius: float) -> tuple[Array, Indices]:
    """Return the parts of lines that no face hides, m, (part, end, axis), and the line of each, (part,).

    Lines are painted closer to the eye than they are. Without this test an end behind a face would be visible.

    Args:
        lines: m, (line, end, axis).
        faces: m, (face, corner, axis).
        view: viewpoint.
        radius: reference for lengths, m.
    """
    shares = np.linspace(0, 1, _PIECES + 1)
    corners = faces[:, [[0, 1, 2], [0, 2, 3]]].reshape(-1, 3, 3)
    flat, away = view.project(corners), corners @ view.towards
    parts, numbers = list[Array](), list[int]()
    for number, (start, end) in enumerate(lines):
        points = start + shares[:, np.newaxis] * (end - start)
        middles = (points[1:] + points[:-1]) / 2
        places, depths = view.project(middles), middles @ view.towards
        near = ((flat.max(axis=1) >= places.min(axis=0)) & (flat.min(axis=1) <= places.max(axis=0))).all(axis=1)
        hidden = _hidden(places, depths + _WHOLE_BEHIND * radius, flat[near], away[near])
        if hidden.any():
            hidden = _hidden(places, depths + _PART_BEHIND * radius, flat[near], away[near])
        edges = np.flatnonzero(np.diff(np.concatenate([[True], hidden, [True]])))
        parts += [points[[first, last]] for first, last in edges.reshape(-1, 2)]
        numbers += [number] * (len(edges) // 2)
    return np.array(parts).reshape(-1, 2, 3), np.array(numbers, dtype=np.int64)


def _hidden(places: Array, depths: Array, flat: Array, away: Array) -> Flags:
    """Return whether points are behind triangles.

    Args:
        places: points in the picture, m, (point, 2).
        depths: towards the eye, m, (point,).
        flat: corners of the triangles in the picture, m, (triangle, 3, 2).
        away: the corners towards the eye, m, (triangle, 3).
    """
    first, second = flat[:, 1] - flat[:, 0], flat[:, 2] - flat[:, 0]
    area = first[:, 0] * second[:, 1] - first[:, 1] * second[:, 0]
    beside = places[:, np.newaxis] - flat[:, 0]
    with np.errstate(divide="ignore", invalid="ignore"):
        u = (beside[..., 0] * second[:, 1] - beside[..., 1] * second[:, 0]) / area
        v = (first[:, 0] * beside[..., 1] - first[:, 1] * beside[..., 0]) / area
        above = away[:, 0] + u * (away[:, 1] - away[:, 0]) + v * (away[:, 2] - away[:, 0])
        return np.asarray(((u >= 0) & (v >= 0) & (u + v <= 1) & (above > depths[:, np.newaxis])).any(axis=1))


def _squares(places: Array, view: Viewpoint, half: float, above: float) -> tuple[Array, Array]:
    """Return corners and colours of squares that face the eye, from their centres, m, (square, axis)."""
    corners = [right * view.right + up * view.up for right, up in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
    quads = (places + above * view.towards)[:, np.newaxis] + half * np.array(corners)
    return quads, np.tile(to_rgb(BAR), (len(places), 1))


def _tubes(bars: Array, radii: Array, view: Viewpoint, colours: Array) -> tuple[Array, Array]:
    """Return corners and colours of round bars with flat ends.

    Args:
        bars: m, (bar, end, axis).
        radii: m, (bar,).
        view: viewpoint.
        colours: red, green, blue, 0 to 1, (bar, 3).
    """
    along = _unit(bars[:, 1] - bars[:, 0])
    # any direction that is not along the bar
    across = _unit(np.cross(along, np.eye(3)[np.argmin(np.abs(along), axis=1)]))
    turns = np.linspace(0, 2 * np.pi, _SIDES + 1)[:, np.newaxis, np.newaxis]
    spokes = np.cos(turns) * across + np.sin(turns) * np.cross(along, across)  # (side, bar, axis)
    first, second = (bars[:, end] + radii[:, np.newaxis] * spokes for end in (0, 1))
    sides = np.stack([first[:-1], first[1:], second[1:], second[:-1]], axis=2)
    ends = [
        np.stack([np.broadcast_to(bars[:, end], rim[1:].shape), rim[:-1], rim[1:], rim[1:]], axis=2)
        for end, rim in ((0, first), (1, second))
    ]
    quads = np.concatenate([sides, *ends]).reshape(-1, 4, 3)
    outwards = np.concatenate(
        [_unit(spokes[:-1] + spokes[1:]), *np.broadcast_to([-along, along], (_SIDES, 2, *along.shape)).swapaxes(0, 1)]
    )
    bright = outwards.reshape(-1, 3) @ view.towards
    visible = bright > 0
    shades = np.tile(colours, (len(quads) // max(len(colours), 1), 1))
    # a bright colour would exceed white where the bar shines
    return quads[visible], np.minimum((_DULL + _LUSTRE * bright[visible, np.newaxis] ** 4) * shades[visible], 1.0)


def ribbons(
    lines: Array, view: Viewpoint, colours: str | Sequence[str] | ArrayLike, half: float, above: float
) -> tuple[Array, Array]:
    """Return corners and colours of lines, as bands that face the eye.

    Args:
        lines: m, (line, end, axis).
        view: viewpoint.
        colours: one colour, or one for each line.
        half: half the width of a band, m.
        above: distance by which bands are painted closer to the eye than their lines, m.
    """
    across = half * _unit(np.cross(view.towards, lines[:, 1] - lines[:, 0]))
    start, end = (lines[:, place] + above * view.towards for place in (0, 1))
    quads = np.stack([start - across, end - across, end + across, start + across], axis=1)
    return quads, np.broadcast_to(to_rgba_array(colours)[:, :3], (len(lines), 3))
