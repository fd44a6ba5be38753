"""The crease pattern with its tendons; without a pattern, the built structure seen from above."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from forficula.arrays import Array
from forficula.quantities import reading_unit, show_value
from forficula.show.structure.crease_lines import draw_creases, sheet_axes
from forficula.show.structure.labels import counted, label_of, measure_labels, parts_of, shown_angles
from forficula.show.structure.painted_shape import BAR, structure_view
from forficula.show.style import BLACK, ORANGE, PAGE_WIDTH, describe, figure_style, fit_legend
from forficula.structure import Hinge, Structure, built_hinges, built_points, held_corners

_MOST_NUMBERED, _NUMBERED = 20, 9  # largest number of hinges with numbers on their lines; number of these if more
_TALL = 0.5  # height above which a sheet is drawn from the side, as a share of the lesser of length and width
_ON_AXIS = 1e-6  # distance in spans below which a point lies on an axis


def draw_pattern(structure: Structure, width: float = PAGE_WIDTH) -> Figure:
    """Draw the crease pattern of a structure, its circles and its tendons; `width` is the largest width, inch."""
    pattern, turn = structure.appearance.pattern, _turn(structure)
    points = built_points(structure) @ turn
    places = points if pattern is None else pattern.vertices_coords @ turn
    unit, factor = reading_unit("m", float(np.abs(places).max(initial=structure.span)))
    with figure_style():
        figure, axes = sheet_axes(factor * places, factor * structure.span, unit, width)
        if not np.array_equal(turn, np.eye(3)):
            axes.set(xlabel=f"across ({unit}), seen obliquely from above", ylabel=f"upwards ({unit})")
        if pattern is None:
            handles = _draw_built(axes, structure, factor * points[:, :2])
        else:
            handles = draw_creases(axes, pattern, factor * places[:, :2])
        angle = np.linspace(0, 2 * np.pi, 200)
        for radius in (factor * circle for circle in structure.appearance.circles.values()):
            axes.plot(radius * np.cos(angle), radius * np.sin(angle), ":", color="0.5", lw=0.8)
        for tendon in structure.tendons:
            ends = factor * points[list(tendon.points)]
            axes.plot(*ends.T[:2], "o-", color=ORANGE, ms=3.5, lw=3, alpha=0.6)
        _number(axes, structure, factor, turn)
        if held := list(held_corners(structure)):
            axes.plot(*(factor * points[held, :2]).T, "s", color=BAR, ms=3.5, zorder=3)
            handles.append(Line2D([], [], color=BAR, marker="s", ls="none", ms=3.5, label="support"))
        if structure.tendons:
            handles.append(Line2D([], [], color=ORANGE, marker="o", ms=3.5, lw=3, alpha=0.6, label="tendon"))
        handles += [Line2D([], [], color="0.5", ls=":", label=name) for name in structure.appearance.circles]
        fit_legend(figure, handles, 5, loc="outside upper center")
        return describe(figure, _text(structure))


def _turn(structure: Structure) -> Array:
    """Return the rotation of points, m, (point, 3), for the drawing: oblique if the sheet is tall."""
    pattern = structure.appearance.pattern
    extent = np.ptp(built_points(structure) if pattern is None else pattern.vertices_coords, axis=0)
    if extent[2] <= _TALL * extent[:2].min():
        return np.eye(3)
    view = structure_view(structure)
    return np.stack([view.right, view.up, view.towards], axis=1)


def _draw_built(axes: Axes, structure: Structure, points: Array) -> list[Line2D]:
    """Draw plates and bars between points, (point, 2); return the legend's entries."""
    handles = []
    for plate in structure.plates:
        axes.plot(*points[[*plate.points, plate.points[0]]].T, "-", color=BLACK, lw=1.1)
    if structure.plates:
        handles.append(Line2D([], [], color=BLACK, lw=1.1, label="edge of a plate"))
    for bar in structure.bars:
        axes.plot(*points[list(bar.points)].T, "-", color=BAR, lw=2.2)
    if structure.bars:
        handles.append(Line2D([], [], color=BAR, lw=2.2, label=structure.appearance.bar))
    return handles


def _number(axes: Axes, structure: Structure, factor: float, turn: Array) -> None:
    """Label the angles that figures show: at the end of the last hinge's bar, or on the hinge's line."""
    labels = {
        part[-1]: label
        for measure in shown_angles(structure)
        for part, label in zip(measure.parts, measure_labels(structure, measure), strict=True)
    }
    hinges, names = list(labels), parts_of(list(labels.values())).names
    points, (origins, directions) = (
        built_points(structure) @ turn,
        (hinge @ turn for hinge in built_hinges(structure)),
    )
    shown = range(len(hinges))
    if len(hinges) > _MOST_NUMBERED and structure.facets:
        return
    if len(hinges) > _MOST_NUMBERED:
        shown = np.linspace(0, len(hinges) - 1, _NUMBERED).round().astype(int).tolist()
    for hinge, name in ((hinges[place], names[place]) for place in shown):
        flaps = structure.hinges[hinge].flaps
        if flaps is not None:
            _label(axes, factor * points[list(flaps[:2])].mean(axis=0), name)
            continue
        bar = next((bar for bar in structure.bars if bar.body == structure.hinges[hinge].body), None)
        if bar is not None and len(hinges) == 1:
            # a single hinge needs no label
            continue
        if bar is not None:
            place = factor * points[bar.points[1], :2]
            outwards = place / max(float(np.linalg.norm(place)), 1e-300)
            axes.annotate(
                name,
                (place[0], place[1]),
                (8 * outwards[0], 8 * outwards[1]),
                textcoords="offset points",
                ha="center",
                va="center",
            )
            continue
        place = factor * _middle(structure, structure.hinges[hinge], points, origins[hinge], directions[hinge])[:2]
        _label(axes, place, name)


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
