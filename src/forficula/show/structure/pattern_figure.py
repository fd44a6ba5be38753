"""The crease pattern with its tendons, laid flat; without a pattern, the built structure seen from above."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from forficula.arrays import Array
from forficula.quantities import reading_unit, show_value
from forficula.show.structure.crease_lines import add_sheet_legend, draw_creases, sheet_axes
from forficula.show.structure.flat_net import FlatNet, flat_net
from forficula.show.structure.labels import counted, label_of, measure_labels, parts_of, shown_angles
from forficula.show.structure.painted_shape import BAR
from forficula.show.structure.viewpoint import page_view
from forficula.show.style import BLACK, ORANGE, PAGE_WIDTH, describe, figure_style, number_handle
from forficula.structure import Hinge, Structure, built_hinges, built_points, held_corners

# [chosen] of the span: distance at which labels on lines overlap, and shift of the second one along its line
_NEAR, _SHIFT = 0.06, 0.07
_MOST_NUMBERED, _NUMBERED = 20, 9  # largest number of hinges with numbers on their lines; number of these if more
_TALL = 0.5  # height above which a sheet is drawn from the side, as a share of the lesser of length and width
_ON_AXIS = 1e-6  # distance in spans below which a point lies on an axis


def draw_pattern(structure: Structure, width: float = PAGE_WIDTH) -> Figure:
    """Draw the crease pattern of a structure, its circles and its tendons; `width` is the largest width, inch.

    A pattern that is built folded is drawn unfolded. A tendon is then a line between the points to which it is tied.
    """
    drawing = _drawing(structure)
    unit, factor = reading_unit("m", float(np.abs(drawing.extent).max(initial=structure.span)))
    with figure_style():
        figure, axes = sheet_axes(factor * drawing.extent, factor * structure.span, unit, width)
        axes.set(xlabel=f"{drawing.across} ({unit}){drawing.note}", ylabel=f"{drawing.upwards} ({unit})")
        points = factor * drawing.places(built_points(structure))
        if drawing.net is None:
            handles = _draw_built(axes, structure, points)
        else:
            handles = draw_creases(axes, drawing.net, factor)
        angle = np.linspace(0, 2 * np.pi, 200)
        for radius in (factor * circle for circle in structure.appearance.circles.values()):
            axes.plot(radius * np.cos(angle), radius * np.sin(angle), ":", color="0.5", lw=0.8)
        for tendon in structure.tendons:
            axes.plot(*points[list(tendon.points)].T, "o-", color=ORANGE, ms=3.5, lw=3, alpha=0.6)
        if held := list(held_corners(structure)):
            axes.plot(*points[held].T, "s", color=BAR, ms=3.5, zorder=3)
            handles.append(Line2D([], [], color=BAR, marker="s", ls="none", ms=3.5, label="support"))
        if structure.tendons:
            handles.append(Line2D([], [], color=ORANGE, marker="o", ms=3.5, lw=3, alpha=0.6, label="tendon"))
        handles += [Line2D([], [], color="0.5", ls=":", label=name) for name in structure.appearance.circles]
        handles += _number(axes, structure, drawing, factor)
        add_sheet_legend(figure, handles, 5)
        return describe(figure, _text(structure))


@dataclass(frozen=True, kw_only=True, eq=False)
class _Drawing:
    """Flat drawing of a pattern: its net, lines and marks.

    Attributes:
        net: pattern; None without a pattern.
        turn: rotation of points of the structure for a drawing without a pattern, (3, 3).
        extent: points that the drawing contains, m, (point, 2).
        across: name of the horizontal axis.
        upwards: name of the vertical axis.
        note: addition to the horizontal axis.
    """

    net: FlatNet | None
    turn: Array
    extent: Array
    across: str
    upwards: str
    note: str

    def places(self, points: Array) -> Array:
        """Return the drawn positions of points of the structure, m, (point, 3) -> (point, 2)."""
        return (points @ self.turn)[:, :2] if self.net is None else self.net.places(points)


def _drawing(structure: Structure) -> _Drawing:
    """Return the flat pattern; without one, the structure from above, or obliquely if it is tall."""
    pattern, points = structure.appearance.pattern, built_points(structure)
    if pattern is not None:
        net = flat_net(pattern)
        extent = net.pattern.vertices_coords[:, :2]
        note = f", {net.view}" if net.view else ""
        return _Drawing(net=net, turn=np.eye(3), extent=extent, across="x", upwards="y", note=note)
    extent = np.ptp(points, axis=0)
    if extent[2] <= _TALL * extent[:2].min():
        return _Drawing(net=None, turn=np.eye(3), extent=points[:, :2], across="x", upwards="y", note="")
    view, note = page_view(), ", seen obliquely from above"
    turn = np.stack([view.right, view.up, view.towards], axis=1)
    return _Drawing(net=None, turn=turn, extent=(points @ turn)[:, :2], across="across", upwards="upwards", note=note)


def _draw_built(axes: Axes, structure: Structure, points: Array) -> list[Artist]:
    """Draw plates and bars between points, (point, 2); return the legend's entries."""
    handles = list[Artist]()
    for plate in structure.plates:
        axes.plot(*points[[*plate.points, plate.points[0]]].T, "-", color=BLACK, lw=1.1)
    if structure.plates:
        handles.append(Line2D([], [], color=BLACK, lw=1.1, label="edge of a plate"))
    for bar in structure.bars:
        axes.plot(*points[list(bar.points)].T, "-", color=BAR, lw=2.2)
    if structure.bars:
        handles.append(Line2D([], [], color=BAR, lw=2.2, label=structure.appearance.bar))
    return handles


def _number(axes: Axes, structure: Structure, drawing: _Drawing, factor: float) -> list[Artist]:
    """Number the angles that figures show, at the end of the last hinge's bar or on the hinge's line.

    Returns:
        The entry of the legend for the numbers.
    """
    labels = {
        part[-1]: label
        for measure in shown_angles(structure)
        for part, label in zip(measure.parts, measure_labels(structure, measure), strict=True)
    }
    hinges, words = list(labels), parts_of(list(labels.values()))
    points, (origins, directions) = built_points(structure), built_hinges(structure)
    shown = range(len(hinges))
    if len(hinges) > _MOST_NUMBERED and structure.facets:
        return []
    if len(hinges) > _MOST_NUMBERED:
        shown = np.linspace(0, len(hinges) - 1, _NUMBERED).round().astype(int).tolist()
    numbered = False
    taken = list[Array]()
    for hinge, name in ((hinges[place], words.names[place]) for place in shown):
        flaps = structure.hinges[hinge].flaps
        bar = next((bar for bar in structure.bars if bar.body == structure.hinges[hinge].body), None)
        if flaps is None and bar is not None:
            # a single hinge needs no label
            if len(hinges) == 1:
                continue
            _label_beyond(axes, factor * drawing.places(points[[bar.points[1]]])[0], name)
        else:
            middle = (
                points[list(flaps[:2])].mean(axis=0)
                if flaps is not None
                else _middle(structure, structure.hinges[hinge], points, origins[hinge], directions[hinge])
            )
            # labels of parallel hinges beside each other are shifted along them
            for place in (middle, *(middle + side * _SHIFT * structure.span * directions[hinge] for side in (1, -1))):
                drawn = drawing.places(place[np.newaxis])[0]
                if all(np.linalg.norm(drawn - other) > _NEAR * structure.span for other in taken):
                    break
            taken.append(drawn)
            _label(axes, factor * drawn, name)
        numbered = True
    if not (numbered and words.heading):
        return []
    return [number_handle(0, f"{words.heading} number")]


def _label_beyond(axes: Axes, place: Array, name: str) -> None:
    """Write a name beyond a point, seen from the origin."""
    outwards = place / max(float(np.linalg.norm(place)), 1e-300)
    axes.annotate(
        name,
        (place[0], place[1]),
        (8 * outwards[0], 8 * outwards[1]),
        textcoords="offset points",
        ha="center",
        va="center",
    )


def _label(axes: Axes, place: Array, name: str) -> None:
    """Write a name on a line."""
    box = {"boxstyle": "round,pad=0.15", "fc": "white", "ec": "none"}
    axes.text(place[0], place[1], name, ha="center", va="center", bbox=box)


def _middle(structure: Structure, hinge: Hinge, points: Array, origin: Array, direction: Array) -> Array:
    """Return the middle of the side by which a plate is attached to its hinge, m, (3,)."""
    for closure in structure.closures:
        if closure.bodies[1] == hinge.body:
            return np.asarray(points[[pair[1] for pair in closure.points]].mean(axis=0))
    for plate in structure.plates:
        if plate.body == hinge.body:
            corners = points[list(plate.points)]
            along = (corners - origin) @ direction
            beside = np.linalg.norm(corners - origin - along[:, np.newaxis] * direction, axis=1)
            on_axis = along[beside < _ON_AXIS * structure.span]
            if plate.solids:
                # the axis may be above or below the mid-plane
                on_axis = along[np.argsort(beside)[:2]]
            if len(on_axis):
                return np.asarray(origin + (on_axis.min() + on_axis.max()) / 2 * direction)
    return origin


def _text(structure: Structure) -> str:
    """Describe the pattern."""
    pattern = structure.appearance.pattern
    hinges = {hinge for measure in shown_angles(structure) for hinge in measure.hinges}
    count = counted([label_of(structure.hinges[hinge]) for hinge in sorted(hinges)], "hinge")
    if pattern is None:
        return f"{structure.name} as built, seen from above: {count}, {show_value(structure.span, 'm')} in size."
    letters = pattern.edges_assignment
    creases = f"{letters.count('M')} mountain and {letters.count('V')} valley creases"
    lengths = ", ".join(f"{name} {show_value(length, 'm')}" for name, length in structure.appearance.sizes.items())
    sizes = f" {lengths[:1].upper()}{lengths[1:]}." if lengths else ""
    return f"Crease pattern of {structure.name}: {count}, {creases}.{sizes}"
