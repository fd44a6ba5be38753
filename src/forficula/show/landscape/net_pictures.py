"""Small pictures of a net in several shapes, at one scale and from one viewpoint."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import numpy as np
from matplotlib.axes import Axes
from matplotlib.lines import Line2D
from matplotlib.patches import Patch

from forficula.arrays import Array
from forficula.show.structure.painted_shape import (
    PaintedShape,
    paint_shape,
    shape_handles,
    show_painted,
)
from forficula.show.structure.shape import shape_of
from forficula.show.structure.surface import surface_of
from forficula.show.structure.viewpoint import page_view
from forficula.show.style import ORANGE
from forficula.statics.net.net import Net, NetShape
from forficula.statics.net.net_of import point_positions
from forficula.structure import Structure


@dataclass(frozen=True, kw_only=True, eq=False)
class Pictures:
    """Painted shapes, and the window that contains them all.

    Attributes:
        painted: shapes, in order.
        lines: ends of creases and edges in each picture, m, (line, end, 2).
        window: lower left and upper right corner, m, (2, 2).
        handles: entries of the legend.
    """

    painted: tuple[PaintedShape, ...]
    lines: tuple[Array, ...]
    window: Array
    handles: tuple[Patch | Line2D, ...]

    @property
    def slope(self) -> float:
        """Height divided by width."""
        width, height = np.ptp(self.window, axis=0)
        return float(height / width)


def net_pictures(structure: Structure, net: Net, shapes: Sequence[NetShape]) -> Pictures:
    """Paint a structure in several shapes of its net."""
    shape, view = shape_of(structure), page_view()
    at = {point.body: number for number, point in enumerate(structure.points)}
    nodes = [at[body] for membrane in structure.membranes for body in membrane.bodies.tolist()]
    painted, lines = list[PaintedShape](), list[Array]()
    for item in shapes:
        points = point_positions(net, item)[: len(structure.points)]
        surface = surface_of(
            shape,
            np.concatenate((points, points[nodes])),
            item.angles,
            two_sided=bool(structure.facets),
        )
        painted.append(paint_shape(surface, view, ORANGE))
        lines.append(view.project(surface.lines))
    corners = np.concatenate([item.corners for item in painted])
    return Pictures(
        painted=tuple(painted),
        lines=tuple(lines),
        window=np.array([corners.min(axis=0), corners.max(axis=0)]),
        handles=tuple(shape_handles(shape, structure, ORANGE, 2.0)),
    )


def show_pictures(pictures: Pictures, all_axes: Iterable[Axes], width: float) -> None:
    """Draw pictures into axes of a given width, inch, without lines; remaining axes stay empty."""
    for axes in (all_axes := list(all_axes)):
        axes.set_axis_off()
    for axes, painted in zip(all_axes, pictures.painted, strict=False):
        show_painted(axes, painted, pictures.window, width)
