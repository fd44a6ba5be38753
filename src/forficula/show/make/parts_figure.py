"""Parts as made: at their stops and half way, and as an exploded view with names and a scale."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patheffects import Normal, Stroke

from forficula.arrays import Array
from forficula.make.part import PartSet
from forficula.pattern.geometry import triangle_normals
from forficula.quantities import round_below
from forficula.show.make.painted_parts import PlacedPart, paint_parts, placed_parts
from forficula.show.make.part_facts import mass_text, masses_text, part_masses, total_mass
from forficula.show.make.part_looks import PartLook, part_looks
from forficula.show.make.part_poses import angle_range
from forficula.show.structure.painted_shape import PaintedShape, show_painted
from forficula.show.structure.viewpoint import Viewpoint, page_view
from forficula.show.style import PAGE_WIDTH, describe, draw_bar, figure_style, is_narrow

# direction to the eye in the axes of the first joint: along the arms, along its hinge, and up
_TOWARDS = (0.3, -0.72, 0.62)
_ROOM = 1.06  # size of a picture, as a multiple of its contents
_LINE = 0.16  # inch, height of a line of words
_BESIDE = 0.3  # share of a picture's width that the scale takes
_BAR = 0.3  # length of the scale bar, as a share of a picture's width


def draw_parts(parts: PartSet, width: float = PAGE_WIDTH) -> Figure:
    """Draw the parts of a single joint at both stops and half way, of several joints as built; then an exploded view.

    Thick panels are drawn flat, half way along their fold path, and folded.

    Args:
        parts: parts with at least one joint or panel.
        width: width of the figure, inch.
    """
    low, high = angle_range(parts)
    view, (looks, _) = _view(parts), part_looks(parts)
    middle = (low + high) / 2
    stops = [("overbend stop", high), ("half way", middle), ("folding stop", low)]
    if parts.fold is not None:
        stops = [("flat", low), ("half way", middle), ("folded", high)]
    posed = stops if len(parts.joints) == 1 or parts.fold is not None else [("as built", 0.0)]
    colours = [look.colour for look in looks]
    pictures = [paint_parts(placed_parts(parts, angle), colours, view) for _, angle in posed]
    taken = placed_parts(parts, 0.0, 1.0)
    with figure_style():
        narrow = is_narrow(width)
        columns = 1 if narrow else len(posed)
        figure, panels, below = _panels(width, pictures, paint_parts(taken, colours, view), columns)
        for axes, (title, angle) in zip(panels, posed, strict=True):
            axes.set_title(f"{title}, {_degrees(angle)}" if len(posed) > 1 else title, pad=3)
        _scale(panels[0])
        below.set_title("exploded view", pad=3 + 72 * 1.6 * _LINE)
        _scale(below)
        _name(below, taken, looks, part_masses(parts), view, narrow)
        return describe(figure, _text(parts, posed))


def _view(parts: PartSet) -> Viewpoint:
    """Return the viewpoint: beside the arms of the first joint, from above."""
    if not parts.joints:
        return page_view()
    frame = parts.joints[0].frame
    towards = frame @ np.array(_TOWARDS)
    towards /= np.linalg.norm(towards)
    right = np.cross(frame[:, 2], towards)
    right /= np.linalg.norm(right)
    return Viewpoint(right=right, up=np.cross(towards, right), towards=towards)


def _panels(
    width: float, pictures: Sequence[PaintedShape], apart: PaintedShape, columns: int
) -> tuple[Figure, list[Axes], Axes]:
    """Return a figure with pictures at one scale above the exploded view, each as high as its contents."""
    column_width = width / columns
    sizes = [np.ptp(picture.corners, axis=0) * _ROOM for picture in pictures]
    scale = max(size[0] for size in sizes) / column_width  # m per inch, the same for all
    rows = [sizes[start : start + columns] for start in range(0, len(sizes), columns)]
    heights = [max(size[1] for size in row) / scale for row in rows]
    size = np.ptp(apart.corners, axis=0) * _ROOM
    last = size[1] / (size[0] / width)
    titled = [height + 1.4 * _LINE for height in heights]
    # names above and below the exploded view, and its title
    total = sum(titled) + last + 6.4 * _LINE
    figure = Figure(figsize=(width, total))
    top, axes = total, []
    for number, picture in enumerate(pictures):
        row, column = divmod(number, columns)
        bottom = top - sum(titled[: row + 1])
        box = (column / columns, bottom / total, 1 / columns, heights[row] / total)
        panel = figure.add_axes(box)
        half = np.array([column_width, heights[row]]) * scale / 2
        show_painted(panel, picture, _around(picture, half), column_width)
        axes.append(panel)
    below = figure.add_axes((0, 2.2 * _LINE / total, 1, last / total))
    show_painted(below, apart, _around(apart, size / 2), width)
    return figure, axes, below


def _around(picture: PaintedShape, half: Array) -> Array:
    """Return the window with a picture at its centre, m, (2, 2)."""
    middle = picture.corners.mean(axis=0)
    return np.array([middle - half, middle + half])


def _scale(axes: Axes) -> None:
    """Draw a bar of a stated length into the lower left corner of a picture."""
    (left, right), (bottom, _) = axes.get_xlim(), axes.get_ylim()
    length = round_below(_BAR * (right - left))
    draw_bar(axes, (left + 0.03 * (right - left), bottom), length, f"{1e3 * length:g} mm")


def _name(
    axes: Axes,
    taken: Sequence[PlacedPart],
    looks: Sequence[PartLook],
    known: Mapping[str, float | None],
    view: Viewpoint,
    narrow: bool,
) -> None:
    """Write the names of parts above and below their picture, each with a line to one of them."""
    named = []
    for number, look in enumerate(looks):
        same_look = [item for item in taken if item.look == number]
        count = sum(item.part.count for item in same_look)
        text = f"{look.name}, {count}" if count > 1 else look.name
        masses = masses_text([known[item.part.name] for item in same_look])
        text += f"\n{masses}{' each' * (count > 1)}" if masses else ""
        named.append((text, _anchor(view.project(same_look[-1].mesh.points))))
    stop = _best_stop(taken, view)
    if stop is not None:
        named.append(("face of\na stop", stop))
    # the upper half of the parts have their names above; the scale is at the lower left
    left, right = axes.get_xlim()
    named.sort(key=lambda item: (item[1][0] > left + _BESIDE * (right - left), -item[1][1]))
    above = (len(named) + 1) // 2
    for group, edge, side in ((named[:above], 1, 1), (named[above:], 0, -1)):
        _row(axes, sorted(group, key=lambda item: float(item[1][0])), edge, side, narrow)


def _best_stop(taken: Sequence[PlacedPart], view: Viewpoint) -> Array | None:
    """Return the centre of the best visible face of a stop in the picture; None if none faces the eye."""
    best, most = None, 0.0
    for item in taken:
        corners = item.mesh.points[item.mesh.triangles[: item.mesh.stops]]
        areas = triangle_normals(corners) @ view.towards
        visible = np.maximum(areas, 0.0)
        if visible.sum() > most:
            middle = np.average(corners.mean(axis=1), axis=0, weights=visible)
            best, most = view.project(middle), float(visible.sum())
    return best


def _row(axes: Axes, named: Sequence[tuple[str, Array]], edge: int, side: int, narrow: bool) -> None:
    """Write a row of names along the upper or lower edge of a picture, each near its part."""
    left, right = axes.get_xlim()
    first, last = (left + (right - left) * share for share in ((0.14, 0.88) if narrow else (0.1, 0.92)))
    if side < 0:
        first = left + (right - left) * (0.48 if narrow else _BESIDE + 0.08)
    least = (last - first) / max(len(named) - 1, 1)
    at = np.clip([float(anchor[0]) for _, anchor in named], first, last)
    # from left to right and back, for the largest distances that the width allows
    room = min(least, 0.16 * (right - left) * (2 if narrow else 1))
    for place in range(1, len(at)):
        at[place] = max(at[place], at[place - 1] + room)
    at[-1:] = np.minimum(at[-1:], last)
    for place in range(len(at) - 2, -1, -1):
        at[place] = min(at[place], at[place + 1] - room)
    halo = Stroke(linewidth=1.8, foreground="white")
    for (text, anchor), across in zip(named, at.tolist(), strict=True):
        axes.plot(*anchor, marker="o", ms=2.2, color="black", mec="white", mew=0.5)
        axes.annotate(
            text,
            tuple(anchor),
            (across, axes.get_ylim()[edge]),
            ha="center",
            va="bottom" if side > 0 else "top",
            fontsize=7,
            linespacing=1.05,
            arrowprops={"arrowstyle": "-", "lw": 0.6, "shrinkA": 0, "shrinkB": 0, "path_effects": [halo, Normal()]},
            annotation_clip=False,
        )


def _anchor(places: Array) -> Array:
    """Return the point closest to the centre of several points."""
    middle = (places.min(axis=0) + places.max(axis=0)) / 2
    return np.asarray(places[np.argmin(np.linalg.norm(places - middle, axis=1))])


def _degrees(angle: float) -> str:
    return f"{math.degrees(angle):.4g}°".replace("-", "−")


def _text(parts: PartSet, posed: Sequence[tuple[str, float]]) -> str:
    """Describe the figure."""
    looks, look_numbers = part_looks(parts)
    counts = [
        sum(part.count for part, item in zip(parts.parts, look_numbers, strict=True) if item == n)
        for n in range(len(looks))
    ]
    names = ", ".join(f"{count} × {look.name}" for look, count in zip(looks, counts, strict=True))
    mass = total_mass(parts)
    weight = f", total mass {mass_text(mass)}" if mass is not None else ""
    angles = "; ".join(f"{name}, {_degrees(angle)}" for name, angle in posed)
    return f"Parts of {parts.design.name}. {names}{weight}. The joints at: {angles}. Below, an exploded view."
