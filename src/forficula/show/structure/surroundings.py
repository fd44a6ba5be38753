"""The room around a structure in a picture: the direction of gravity and the table."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.patches import Circle, Patch, Polygon

from forficula.arrays import Array
from forficula.quantities import show_value
from forficula.show.structure.surface import DrawnSurface
from forficula.show.structure.viewpoint import Viewpoint
from forficula.structure import Structure

# length of the arrow in the picture, as a share of its true length, below which gravity points into or out of it
_ALONG_VIEW = 0.3
_TABLE, _EDGE = "0.93", "0.75"
_MARGIN = 0.15  # of a table around a structure, as a share of the structure's extent on it


def draw_gravity(axes: Axes, structure: Structure, view: Viewpoint, middle: tuple[float, float], half: float) -> None:
    """Draw an arrow along gravity with the letter g, or a circle if gravity points into or out of the picture.

    Args:
        axes: axes in metres of the picture.
        structure: a structure with gravity; other structures get no arrow.
        view: viewpoint of the picture.
        middle: middle of the arrow, m in the picture.
        half: half of the length of an arrow in the plane of the picture, m.
    """
    if not structure.gravity:
        return
    down = np.sign(structure.gravity) * np.array(structure.down)
    along = half * view.project(down)
    style = {"color": "black", "lw": 0.9, "clip_on": False}
    if np.linalg.norm(along) < _ALONG_VIEW * half:
        axes.add_patch(Circle(middle, 0.5 * half, fill=False, **style))
        if down @ view.towards > 0:
            axes.plot(*middle, marker=".", ms=3, color="black", clip_on=False)
        else:
            axes.plot(*middle, marker="x", ms=4, mew=0.9, color="black", clip_on=False)
    else:
        start, end = ((middle[0] + side * float(along[0]), middle[1] + side * float(along[1])) for side in (-1.0, 1.0))
        arrow = {"arrowstyle": "-|>,head_width=0.15,head_length=0.3", "lw": 0.9, "color": "black"}
        axes.annotate(
            "", end, start, arrowprops={**arrow, "shrinkA": 0, "shrinkB": 0}, annotation_clip=False
        ).set_in_layout(False)
    beside = (middle[0] + half, middle[1])
    letter = axes.annotate("g", beside, (3, 0), textcoords="offset points", va="center", annotation_clip=False)
    letter.set(style="italic", in_layout=False)


def surroundings_text(structure: Structure) -> str:
    """Return sentences on gravity and table for readers who cannot see a picture; empty without both."""
    x, y, z = (round(part, 3) + 0.0 for part in structure.down)
    texts = [f" Gravity of {show_value(structure.gravity, 'm/s^2')} acts along ({x:g}, {y:g}, {z:g})."] * bool(
        structure.gravity
    )
    if structure.table is not None:
        texts.append(f" A table is at the height {show_value(structure.table.height, 'm')}.")
    return "".join(texts)


def draw_table(axes: Axes, structure: Structure, surface: DrawnSurface, view: Viewpoint) -> None:
    """Draw the table under a structure as a grey rectangle, cut off at the edges of the picture.

    From above, the rectangle is behind the structure; from below only its edge is drawn.

    Args:
        axes: axes in metres of the picture.
        structure: a structure with a table; without one nothing is drawn.
        surface: shape of the structure in the picture.
        view: viewpoint of the picture.
    """
    if structure.table is None:
        return
    up = -np.array(structure.down)
    corners = _under(surface, up, structure.table.height)
    above = float(up @ view.towards) > 0
    colour, order = (_TABLE, -1) if above else ("none", 3)
    table = Polygon(view.project(corners), facecolor=colour, edgecolor=_EDGE, lw=0.6, zorder=order)
    axes.add_patch(table).set_in_layout(False)


def table_handles(structure: Structure) -> list[Patch]:
    """Return the entry of a legend for the table; empty without a table."""
    return [] if structure.table is None else [Patch(facecolor=_TABLE, edgecolor=_EDGE, lw=0.6, label="table")]


def _under(surface: DrawnSurface, up: Array, height: float) -> Array:
    """Return the corners of a rectangle under a shape on a plane normal to a unit vector, m, (4, 3)."""
    across = np.eye(3)[int(np.argmin(np.abs(up)))]
    across = across - (across @ up) * up
    across /= np.linalg.norm(across)
    axes = np.array([across, np.cross(up, across)])
    on_plane = np.concatenate([surface.faces.reshape(-1, 3), surface.bars.reshape(-1, 3)]) @ axes.T
    low, high = on_plane.min(axis=0), on_plane.max(axis=0)
    margin = _MARGIN * float((high - low).max())
    (left, near), (right, far) = low - margin, high + margin
    rectangle = np.array([[left, near], [right, near], [right, far], [left, far]])
    return np.asarray(height * up + rectangle @ axes)
