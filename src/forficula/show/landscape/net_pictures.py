"""Small pictures of a net in several shapes, at one scale and from one viewpoint."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import LineCollection
from matplotlib.lines import Line2D
from matplotlib.patches import Patch
from scipy.spatial.transform import Rotation

from forficula.arrays import Array
from forficula.show.structure.painted_shape import (
    PaintedShape,
    paint_shape,
    shape_handles,
    show_painted,
)
from forficula.show.structure.shape import Shape, shape_of
from forficula.show.structure.surface import DrawnSurface, surface_of
from forficula.show.structure.surroundings import draw_gravity, draw_table, table_handles
from forficula.show.structure.viewpoint import Viewpoint, readable_view
from forficula.show.style import ORANGE
from forficula.statics import EnergyLandscape
from forficula.statics.landscape import net_states
from forficula.statics.net.energy import built_shape
from forficula.statics.net.net import NetShape
from forficula.statics.net.net_of import place_points, point_positions
from forficula.structure import Structure

_ARROW = 0.06  # half of the length of the arrow of gravity, as a share of a picture's width
_DOTTED: dict[str, Any] = {"color": "0.35", "lw": 0.6, "ls": ":"}


@dataclass(frozen=True, kw_only=True, eq=False)
class Pictures:
    """Painted shapes, and the size of a window that contains any of them.

    Attributes:
        painted: shapes, in order.
        surfaces: the same shapes in 3-D.
        outlines: ends of the dotted lines of each picture, m, (line, end, 2).
        middles: middle of each picture, m, (picture, 2).
        size: width and height of the largest picture, m, (2,).
        handles: entries of the legend.
        structure: the structure.
        view: viewpoint of the pictures.
    """

    painted: tuple[PaintedShape, ...]
    surfaces: tuple[DrawnSurface, ...]
    outlines: tuple[Array, ...]
    middles: Array
    size: Array
    handles: tuple[Patch | Line2D, ...]
    structure: Structure
    view: Viewpoint

    @property
    def slope(self) -> float:
        """Height divided by width."""
        return float(self.size[1] / self.size[0])


def net_pictures(landscape: EnergyLandscape, shapes: Sequence[NetShape], outlined: Sequence[NetShape] = ()) -> Pictures:
    """Paint a structure in several shapes of its net, from the viewpoint that shows its stable states best.

    Args:
        landscape: landscape of a net.
        shapes: shapes to paint.
        outlined: for every shape, another one whose creases and edges are dotted in the same picture; none by default.
    """
    structure, shape = landscape.structure, shape_of(landscape.structure)
    states = [_surface(landscape, shape, state.rest.shape) for state in net_states(landscape)]
    view = readable_view(states, free=_is_free(landscape))
    surfaces = [_surface(landscape, shape, item) for item in shapes]
    painted = [paint_shape(surface, view, ORANGE) for surface in surfaces]
    outlines = [view.project(_surface(landscape, shape, item).lines) for item in outlined]
    corners = np.array([item.corners for item in painted])
    for number, lines in enumerate(outlines):
        corners[number, 0] = np.minimum(corners[number, 0], lines.min(axis=(0, 1)))
        corners[number, 1] = np.maximum(corners[number, 1], lines.max(axis=(0, 1)))
    return Pictures(
        painted=tuple(painted),
        surfaces=tuple(surfaces),
        outlines=tuple(outlines),
        middles=corners.mean(axis=1),
        size=np.ptp(corners, axis=1).max(axis=0),
        handles=(*shape_handles(shape, structure, ORANGE, 2.0), *table_handles(structure)),
        structure=structure,
        view=view,
    )


def show_pictures(pictures: Pictures, all_axes: Iterable[Axes], width: float) -> None:
    """Draw pictures into axes of a given width, inch, without lines; remaining axes stay empty.

    Every picture is in the middle of its axes, so that titles are above it; all have the same scale.
    """
    for axes in (all_axes := list(all_axes)):
        axes.set_axis_off()
    shown = zip(all_axes, pictures.painted, pictures.surfaces, pictures.middles, strict=False)
    for axes, painted, surface, middle in shown:
        show_painted(axes, painted, np.array([middle - pictures.size / 2, middle + pictures.size / 2]), width)
        draw_table(axes, pictures.structure, surface, pictures.view)
    # in the upper right corner of the first picture
    half = _ARROW * float(pictures.size[0])
    corner = pictures.middles[0] + pictures.size / 2
    draw_gravity(all_axes[0], pictures.structure, pictures.view, (corner[0] - 2 * half, corner[1] - half), half)
    for axes, lines in zip(all_axes, pictures.outlines, strict=False):
        axes.add_collection(LineCollection(list(lines), colors=_DOTTED["color"], lw=_DOTTED["lw"], ls=_DOTTED["ls"]))


def outline_handle(words: str) -> Line2D:
    """Return the legend's entry of the dotted lines."""
    return Line2D([], [], label=words, **_DOTTED)


def _surface(landscape: EnergyLandscape, shape: Shape, net_shape: NetShape) -> DrawnSurface:
    assert landscape.net is not None
    structure = landscape.structure
    net = landscape.net.net
    points = point_positions(net, net_shape)[: len(structure.points)]
    if _is_free(landscape):
        points = _aligned(points, point_positions(net, built_shape(net))[: len(points)])
    return surface_of(shape, points[place_points(structure)], net_shape.angles, two_sided=bool(structure.facets))


def _is_free(landscape: EnergyLandscape) -> bool:
    """Return whether nothing holds a net."""
    assert landscape.net is not None
    return bool(landscape.net.net.free.all())


def _aligned(points: Array, built: Array) -> Array:
    """Move points as a rigid body to the built ones (Kabsch 1976); without supports positions are arbitrary."""
    centre, to = points.mean(axis=0), built.mean(axis=0)
    turn, _ = Rotation.align_vectors(built - to, points - centre)
    return np.asarray(turn.apply(points - centre) + to)
