"""A net under slowly growing drives: load against displacement, and shapes along the path."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import groupby, pairwise, takewhile
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure, SubFigure
from matplotlib.gridspec import GridSpec
from matplotlib.lines import Line2D

from forficula.quantities import reading_unit
from forficula.show.landscape.landscape_marks import shown_value, slow_path_text
from forficula.show.landscape.net_pictures import net_pictures, show_pictures
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
    letter_panels,
)
from forficula.statics import EnergyLandscape
from forficula.statics.landscape import net_courses
from forficula.statics.net.driven.driven_net import prescribes_displacement
from forficula.statics.net.driven.net_course import Course, drive_displacement, reaction
from forficula.statics.net.net import NetShape
from forficula.statics.net.path_increment import PathPoint
from forficula.structure import drive_unit, driven_motor

_MOST = 6  # largest number of pictures of a path
_ABREAST = 4  # largest number of pictures in one row
_FEW = 2  # drives with higher plots
_PLOT, _LOW_PLOT, _PICTURE = 2.2, 1.7, 1.3  # heights of a plot, and largest height of a picture, inch
_WORDS = 0.2  # height of a picture's title, inch
_LEGEND = 0.45
_SAME = 0.1  # points closer than this share of a plot's size share a label
# equilibria off the path are drawn up to this multiple of the largest strength on the path: a crease at a stop
# withstands far more
_BEYOND = 2.0

_BEHIND_NUMBERS: dict[str, Any] = {"fc": "white", "ec": "none", "pad": 0.4, "alpha": 0.7}
_STABLE: dict[str, Any] = {"color": BLACK, "lw": 0.9, "ls": "-"}
_UNSTABLE: dict[str, Any] = {"color": "0.5", "lw": 0.9, "ls": "--"}
# factor, shape and words of a picture
_Moment = tuple[float, NetShape, str]


def draw_slow_paths(landscape: EnergyLandscape, width: float = PAGE_WIDTH) -> Figure:
    """Draw the equilibria under every drive as it grows slowly, and shapes along the path.

    Args:
        landscape: landscape of a net with a drive.
        width: width of the figure, inch.
    """
    courses = net_courses(landscape)
    moments = [_moments(course) for course in courses]
    columns = 1 if is_narrow(width) else min(2, len(courses))
    rows = -(-len(courses) // columns)
    pictures = [net_pictures(landscape, [shape for _, shape, _ in moment]) for moment in moments]
    count = max(len(moment) for moment in moments)
    # several drives must fit on a page
    plot, abreast = (_PLOT, _ABREAST) if len(courses) <= _FEW else (_LOW_PLOT, _ABREAST + 1)
    most = count if count <= abreast else -(-count // 2)
    layers = max(-(-len(moment) // most) for moment in moments)
    # the same for all drives, so that their plots have the same size
    picture = min(max(item.slope for item in pictures) * width / columns / most, _PICTURE) + _WORDS
    spare = rows * columns - len(courses)
    height = rows * (plot + layers * picture) + _LEGEND * (not spare) * (1 + is_narrow(width))
    with figure_style():
        figure = Figure(figsize=(width, height), layout="constrained")
        panels = np.ravel(figure.subfigures(rows, columns, squeeze=False))
        plots = []
        for panel, course, moment, shown in zip(panels, courses, moments, pictures, strict=False):
            grid = panel.add_gridspec(1 + layers, most, height_ratios=[plot, *[picture] * layers])
            plots.append(_draw_course(panel, grid, landscape, course, moment))
            small = [panel.add_subplot(grid[1 + number // most, number % most]) for number in range(len(moment))]
            show_pictures(shown, small, width / columns / most)
            for number, (axes, (_, _, words)) in enumerate(zip(small, moment, strict=True), start=1):
                axes.set_title(f"{number}  {words}", pad=2, fontsize=7)
        letter_panels(plots)
        if spare:  # in the place of a plot
            fit_legend(panels[-1], _handles(courses), 1, loc="center")
        else:
            fit_legend(figure, _handles(courses), 3, loc="outside lower center")
        return describe(figure, _text(landscape, courses))


def _draw_course(
    panel: SubFigure, grid: GridSpec, landscape: EnergyLandscape, course: Course, moments: Sequence[_Moment]
) -> Axes:
    """Draw the plot of one drive above the pictures, with the numbers of the points that these show."""
    plot = _Plot(landscape, course)
    axes = panel.add_subplot(grid[0, :])
    axes.axhline(0, color="0.8", lw=0.5, zorder=0)
    if course.through is not None:
        plot.lines(axes, plot.through)
    for path in course.slow.paths:
        axes.plot(*plot.place(path.points), color=BLUE, lw=1.8, zorder=3)
    for snap in course.slow.snaps:
        colour = GREEN if snap.kind == "branch" else VERMILION
        ends = [plot.at(snap.factor, shape) for shape in (snap.before, snap.after.shape)]
        arrow = {"arrowstyle": "->", "color": colour, "lw": 1.2, "shrinkA": 0, "shrinkB": 0}
        axes.annotate("", ends[1], ends[0], arrowprops=arrow, zorder=4)
        axes.plot(*ends[0], "o", color="white", mec=colour, ms=4, zorder=5)
    for touch in course.touches:
        axes.plot(*plot.at(touch.point.factor, touch.point.shape), "D", color="white", mec=BLUE, ms=4, zorder=5)
    last = moments[-2] if len(moments) > 1 else moments[-1]
    ends = [plot.at(last[0], last[1]), plot.at(0.0, course.rest.shape)]
    axes.plot(*zip(*ends, strict=True), ":", color="0.4", lw=1.0, zorder=2)
    for place, numbers in _numbered([plot.at(factor, shape) for factor, shape, _ in moments]):
        axes.plot(*place, ".", color=BLACK, ms=3, zorder=6)
        # the start on the left of the path, which leads to the right and upwards
        across, up, side = (-4, 4, "right") if numbers == "1" else (4, 4 if numbers[0] != "1" else -10, "left")
        look: dict[str, Any] = {"ha": side, "fontsize": 8, "zorder": 6, "bbox": _BEHIND_NUMBERS}
        axes.annotate(numbers, place, xytext=(across, up), textcoords="offset points", **look)
    axes.set_xlabel(f"{plot.along} ({plot.unit_along})")
    axes.set_ylabel(f"{plot.drive} ({plot.unit})")
    axes.set_title(course.name, loc="left")
    axes.margins(x=0.08, y=0.16)
    return axes


class _Plot:
    """Axes of a drive's plot: displacement, and the drive's strength (of a prescribed displacement, the reaction)."""

    def __init__(self, landscape: EnergyLandscape, course: Course) -> None:
        assert landscape.net is not None
        self._structure, self._net, self._drive = landscape.structure, landscape.net.net, course.drive
        self.through = _near_path(course)
        points = [*course.slow.points, *self.through]
        self._size = abs(course.drive.strength)
        motor = driven_motor(self._structure, course.drive)
        si = "rad" if motor.direction is None else "m"
        self._zero = self._gone(course.start.shape)
        far = max(
            abs(self._gone(shape) - self._zero) for shape in (*(point.shape for point in points), course.rest.shape)
        )
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
        steps = [(one.index == 0 and other.index == 0, one, other) for one, other in pairwise(points)]
        for holds, group in groupby(steps, key=lambda step: step[0]):
            run = list(group)
            axes.plot(*self.place([run[0][1], *(other for _, _, other in run)]), **(_STABLE if holds else _UNSTABLE))


def _near_path(course: Course) -> Sequence[PathPoint]:
    """Return the equilibria through the snaps of a course, up to strengths far beyond those of its slow path."""
    points = () if course.through is None else course.through.points
    limit = _BEYOND * max(abs(point.factor) for point in course.slow.points)
    return list(takewhile(lambda point: abs(point.factor) <= limit, points))


def _numbered(places: Sequence[tuple[float, float]]) -> list[tuple[tuple[float, float], str]]:
    """Return points with the numbers of their pictures; points that coincide share one label."""
    size = np.ptp(np.array(places), axis=0) + 1e-12
    labels: list[tuple[tuple[float, float], str]] = []
    for count, place in enumerate(places, start=1):
        near = [np.abs((np.array(item) - place) / size).max() < _SAME for item, _ in labels]
        if any(near):
            number = near.index(True)
            labels[number] = (labels[number][0], f"{labels[number][1]}, {count}")
        else:
            labels.append((place, str(count)))
    return labels


def _moments(course: Course) -> list[_Moment]:
    """Return factor, shape and words of each picture: the start, both ends of snaps, the end, and the shape at rest."""
    moments: list[_Moment] = [(0.0, course.start.shape, "start")]
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
    if any(course.touches for course in courses):
        handles.append(Line2D([], [], color=BLUE, marker="D", mfc="white", ms=4, lw=0, label="parts begin to touch"))
    steps = [step for course in courses for step in pairwise(_near_path(course))]
    stable = {one.index == 0 and other.index == 0 for one, other in steps}
    if True in stable:
        handles.append(Line2D([], [], label="stable equilibria off the path", **_STABLE))
    if False in stable:
        handles.append(Line2D([], [], label="unstable equilibria", **_UNSTABLE))
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
