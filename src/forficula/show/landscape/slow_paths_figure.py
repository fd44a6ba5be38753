"""A net under slowly growing drives: load against displacement, and shapes along the path."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure, SubFigure
from matplotlib.lines import Line2D

from forficula.quantities import reading_unit
from forficula.show.landscape.landscape_marks import shown_value, slow_path_text
from forficula.show.landscape.net_pictures import Pictures, net_pictures, show_pictures
from forficula.show.style import (
    BLACK,
    BLUE,
    GREEN,
    PAGE_WIDTH,
    VERMILION,
    describe,
    figure_style,
    fit_legend,
    is_narrow,
)
from forficula.statics import EnergyLandscape
from forficula.statics.landscape import net_courses
from forficula.statics.net.driven_net import prescribes_displacement
from forficula.statics.net.load_path import PathPoint
from forficula.statics.net.net import NetShape
from forficula.statics.net.net_course import Course, drive_displacement, reaction
from forficula.structure import drive_unit, driven_motor

_MOST = 5  # largest number of pictures of a path
_PLOT = 2.3  # height of a plot, inch
_LEGEND = 0.45
_LETTERS = "abcdefgh"
_SAME = 0.04  # points closer than this share of a plot's size share a label


def draw_slow_paths(landscape: EnergyLandscape, width: float = PAGE_WIDTH) -> Figure:
    """Draw the equilibria under every drive as it grows slowly, and shapes along the path.

    Args:
        landscape: landscape of a net with a drive.
        width: width of the figure, inch.
    """
    assert landscape.net is not None
    courses = net_courses(landscape)
    moments = [_moments(course) for course in courses]
    columns = 1 if is_narrow(width) else min(2, len(courses))
    rows = -(-len(courses) // columns)
    pictures = [
        net_pictures(landscape.structure, landscape.net.net, [shape for _, shape, _ in moment]) for moment in moments
    ]
    most = max(len(moment) for moment in moments)
    height = _PLOT + min(max(picture.slope for picture in pictures) * width / columns / most, 1.3) + 0.25
    with figure_style():
        figure = Figure(figsize=(width, rows * height + _LEGEND * (1 + is_narrow(width))), layout="constrained")
        panels = np.ravel(figure.subfigures(rows, columns, squeeze=False))
        for panel, course, moment, picture in zip(panels, courses, moments, pictures, strict=False):
            _draw_course(panel, landscape, course, moment, picture, width / columns)
        fit_legend(figure, _handles(courses), 4, loc="outside lower center")
        return describe(figure, _text(landscape, courses))


def _draw_course(
    panel: SubFigure,
    landscape: EnergyLandscape,
    course: Course,
    moments: Sequence[tuple[float, NetShape, str]],
    pictures: Pictures,
    width: float,
) -> None:
    """Draw the plot of one drive, and below it pictures with the letters of their points; `width` is in inches."""
    plot = _Plot(landscape, course)
    grid = panel.add_gridspec(2, len(moments), height_ratios=[_PLOT, max(pictures.slope, 0.3)])
    axes = panel.add_subplot(grid[0, :])
    axes.axhline(0, color="0.8", lw=0.5, zorder=0)
    if course.through is not None:
        plot.lines(axes, course.through.points)
    for path in course.slow.paths:
        axes.plot(*plot.place(path.points), color=BLUE, lw=1.8, zorder=3)
    for snap in course.slow.snaps:
        colour = GREEN if snap.kind == "branch" else VERMILION
        ends = [plot.at(snap.factor, shape) for shape in (snap.before, snap.after.shape)]
        arrow = {"arrowstyle": "->", "color": colour, "lw": 1.2, "shrinkA": 0, "shrinkB": 0}
        axes.annotate("", ends[1], ends[0], arrowprops=arrow, zorder=4)
        axes.plot(*ends[0], "o", color="white", mec=colour, ms=4, zorder=5)
    last = moments[-2] if len(moments) > 1 else moments[-1]
    ends = [plot.at(last[0], last[1]), plot.at(0.0, course.rest.shape)]
    axes.plot(*zip(*ends, strict=True), ":", color="0.4", lw=1.0, zorder=2)
    for place, letters in _lettered([plot.at(factor, shape) for factor, shape, _ in moments]):
        axes.annotate(letters, place, xytext=(3, 3), textcoords="offset points", fontsize=8, zorder=6)
    axes.set_xlabel(f"{plot.along} ({plot.unit_along})")
    axes.set_ylabel(f"{plot.drive} ({plot.unit})")
    axes.set_title(course.name, loc="left")
    axes.margins(x=0.06, y=0.1)
    small = [panel.add_subplot(grid[1, number]) for number in range(len(moments))]
    show_pictures(pictures, small, width / len(moments))
    for letter, item, (_, _, words) in zip(_LETTERS, small, moments, strict=False):
        item.set_title(f"{letter}\n{words}" if words else letter, pad=1, fontsize=7)


class _Plot:
    """Axes of a drive's plot: displacement, and the drive's strength (of a prescribed displacement, the reaction)."""

    def __init__(self, landscape: EnergyLandscape, course: Course) -> None:
        assert landscape.net is not None
        self._structure, self._net, self._drive = landscape.structure, landscape.net.net, course.drive
        points = [*course.slow.points, *(() if course.through is None else course.through.points)]
        self._size = abs(course.drive.strength)
        motor = driven_motor(self._structure, course.drive)
        si = "rad" if motor.direction is None else "m"
        self._zero = self._gone(course.start.shape)
        far = max(abs(self._gone(point.shape) - self._zero) for point in points)
        self.unit_along, self._along = reading_unit(si, far)
        largest = max(abs(point.factor) for point in points) * self._size
        self.unit, self._factor = reading_unit(drive_unit(self._structure, course.drive), largest)
        self.drive = motor.kind.replace("rest-angle", "rest angle moved")
        self._displaces = prescribes_displacement(self._structure, course.drive)
        if self._displaces:
            self.unit, self._factor = reading_unit("N", max(abs(self._force(point.shape)) for point in points))
            self.drive = "force on all points"
        self.along = "angle turned" if motor.direction is None else f"displacement along the {motor.kind}"

    def _gone(self, shape: NetShape) -> float:
        return drive_displacement(self._structure, self._net, self._drive, shape)

    def _force(self, shape: NetShape) -> float:
        return reaction(self._structure, self._net, self._drive, shape)

    def at(self, factor: float, shape: NetShape) -> tuple[float, float]:
        """Return the point in the plot of a shape under a factor of the load."""
        across = self._along * (self._gone(shape) - self._zero)
        if self._displaces:
            return across, self._factor * self._force(shape)
        return across, self._factor * self._size * factor

    def place(self, points: Sequence[PathPoint]) -> tuple[list[float], list[float]]:
        """Return the points in the plot of equilibria."""
        across, upwards = zip(*(self.at(point.factor, point.shape) for point in points), strict=True)
        return list(across), list(upwards)

    def lines(self, axes: Axes, points: Sequence[PathPoint]) -> None:
        """Draw equilibria: a line where they are stable under the load, dashes where they are not."""
        for one, other in pairwise(points):
            holds = one.index == 0 and other.index == 0
            axes.plot(*self.place([one, other]), color=BLACK if holds else "0.5", lw=0.9, ls="-" if holds else "--")


def _lettered(places: Sequence[tuple[float, float]]) -> list[tuple[tuple[float, float], str]]:
    """Return points with their letters; points that coincide share one label."""
    size = np.ptp(np.array(places), axis=0) + 1e-12
    labels: list[tuple[tuple[float, float], str]] = []
    for letter, place in zip(_LETTERS, places, strict=False):
        near = [np.abs((np.array(item) - place) / size).max() < _SAME for item, _ in labels]
        if any(near):
            number = near.index(True)
            labels[number] = (labels[number][0], f"{labels[number][1]}, {letter}")
        else:
            labels.append((place, letter))
    return labels


def _moments(course: Course) -> list[tuple[float, NetShape, str]]:
    """Return factor, shape and words of each picture: the start, both ends of snaps, the end, and the shape at rest."""
    moments: list[tuple[float, NetShape, str]] = [(0.0, course.start.shape, "start")]
    for snap in course.slow.snaps:
        if snap.kind != "branch":
            moments += [(snap.factor, snap.before, "snaps"), (snap.factor, snap.after.shape, "lands")]
    last = course.slow.points[-1]
    landed = bool(course.slow.snaps) and len(course.slow.snaps) == len(course.slow.paths)
    if not landed:
        moments.append((last.factor, last.shape, "goal" if course.least is not None else "end"))
    elif course.least is not None:
        moments[-1] = (*moments[-1][:2], "at goal")
    kept = moments if len(moments) < _MOST else [moments[0], *moments[1 : _MOST - 2], moments[-1]]
    return [*kept, (0.0, course.rest.shape, "released")]


def _handles(courses: Sequence[Course]) -> list[Line2D]:
    kinds = {snap.kind == "branch" for course in courses for snap in course.slow.snaps}
    handles = [Line2D([], [], color=BLUE, lw=1.8, label="slowly growing drive")]
    if False in kinds:
        handles.append(Line2D([], [], color=VERMILION, marker="o", mfc="white", ms=4, lw=1.2, label="snap"))
    if True in kinds:
        handles.append(Line2D([], [], color=GREEN, marker="o", mfc="white", ms=4, lw=1.2, label="bifurcation"))
    if any(course.through is not None for course in courses):
        handles.append(Line2D([], [], color="0.5", lw=0.9, ls="--", label="unstable equilibria"))
    handles.append(Line2D([], [], color="0.4", lw=1.0, ls=":", label="release"))
    return handles


def _text(landscape: EnergyLandscape, courses: Sequence[Course]) -> str:
    paths = []
    for course in courses:
        unit = drive_unit(landscape.structure, course.drive)
        least = "" if course.least is None else f", at its goal with {shown_value(course.least, unit)}"
        paths.append(f"{course.name}: {slow_path_text(landscape.structure, course)}{least}")
    what = (
        f"Equilibria of the {landscape.structure.appearance.whole} {landscape.design.name} under slowly growing drives"
    )
    return f"{what}, strength against displacement, with {len(courses)} plots. {'; '.join(paths)}."
