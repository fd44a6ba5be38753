"""Pictures of a structure at several moments of a run."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.cm import ScalarMappable
from matplotlib.colors import Normalize
from matplotlib.figure import Figure
from matplotlib.layout_engine import ConstrainedLayoutEngine
from matplotlib.patches import Patch

from forficula.analysis import Outcome
from forficula.arrays import Array, Flags
from forficula.design import stage_drives
from forficula.dynamics import Record, StageEnd
from forficula.quantities import reading_unit, round_below, show_value
from forficula.show.run.state_names import lettered_states
from forficula.show.structure.labels import shown_angles
from forficula.show.structure.painted_shape import (
    PaintedShape,
    paint_shape,
    shape_handles,
    show_painted,
)
from forficula.show.structure.shape import shape_of
from forficula.show.structure.surface import DrawnSurface, at_time, face_strains, surface_at
from forficula.show.structure.surroundings import draw_gravity, draw_table, surroundings_text, table_handles
from forficula.show.structure.viewpoint import Viewpoint, readable_view
from forficula.show.style import (
    ORANGE,
    PAGE_WIDTH,
    STRAIN_COLOURS,
    describe,
    draw_bar,
    figure_style,
    fit_legend,
    is_narrow,
)
from forficula.structure import Structure

# inch, heights: of a row of the legend below, of an entry of one beside pictures, and of a line of a title
_LEGEND_ROW, _ENTRY, _LINE = 0.2, 0.166, 0.16
_MARGIN = 0.08  # inch, above titles and below pictures
_BAR_HEIGHT = 0.3  # inch, height of a scale bar with its number
_BETWEEN = 0.1  # distance of pictures beside one another, as a share of their width
_TORN = 10.0  # spans, size from which a structure counts as torn
_MOST_LINES = 200  # largest number of creases and edges: more would hide the surface
_MOST_PICTURES = 40
_COLUMNS = (4, 5, 3), (2, 3)  # numbers of pictures in a row of a page and of a column, the usual one first
_ENLARGED = 1.4  # least magnification for which a state is also drawn enlarged
_PLACES = ("point_position", "membrane_position")
_STILL = np.radians(1.0)  # hinges that turn less in a stage do not count for its progress
_LEAST_READ = 0.1  # a unit in which a time is smaller is replaced by a smaller unit
_SAME = 0.02  # spans; moments between which no point moves further look the same


@dataclass(frozen=True, kw_only=True)
class _Moment:
    """Contents of one picture.

    Attributes:
        name: name of the state, of the start or of the end of the run; empty for others.
        time: time in the run, s.
        stage: last stage that began before this time.
        state: whether the moment is a state.
    """

    name: str
    time: float
    stage: StageEnd
    state: bool


@dataclass(frozen=True, kw_only=True, eq=False)
class _Panel:
    """A picture and its title; at the scale of the others if its magnification is 1."""

    painted: PaintedShape
    surface: DrawnSurface
    title: str
    magnification: float = 1.0

    @property
    def size(self) -> Array:
        """Width and height, m in the picture at the common scale, (2,)."""
        return np.asarray(self.magnification * np.ptp(self.painted.corners, axis=0))


def draw_folding(record: Record, outcome: Outcome, width: float = PAGE_WIDTH, *, strain: bool = False) -> Figure:
    """Draw a structure in its states and at equal progress between them, at one scale and from one viewpoint.

    A state that is much smaller than the whole is drawn again, enlarged. Moments at which the structure has not moved
    since the picture before are left out, except for states. The last picture is the end of the run.

    Args:
        record: the simulated motion.
        outcome: the outcome of the run.
        width: width of the figure, inch.
        strain: whether a membrane is coloured by its largest strains instead of its regions.
    """
    all_moments, structure = _moments(record, outcome), record.structure
    # of hundreds of stages only some are drawn: a picture takes a third of a second in every format
    chosen = np.linspace(0, len(all_moments) - 1, min(_MOST_PICTURES, len(all_moments)))
    moments = [all_moments[place] for place in chosen.round().astype(int).tolist()]
    shape, texts = shape_of(structure), _titles(moments)
    surfaces = [surface_at(record, shape, moment.time) for moment in moments]
    view = readable_view(surfaces)
    if len(shape.lines) > _MOST_LINES and not structure.facets:
        surfaces = [replace(surface, lines=surface.lines[:0], folds=surface.folds[:0]) for surface in surfaces]
    strains = [face_strains(shape, surface) for surface in surfaces] if strain else []
    norm = Normalize(0, max((float(strain.max(initial=0)) for strain in strains), default=0.0) or 1e-6)
    colours = [STRAIN_COLOURS(norm(strain))[:, :3] for strain in strains] or [None] * len(surfaces)
    drawn = [paint_shape(surface, view, ORANGE, colour) for surface, colour in zip(surfaces, colours, strict=True)]
    panels = [
        _Panel(painted=painted, surface=surface, title=texts[moment])
        for painted, surface, moment in zip(drawn, surfaces, moments, strict=True)
    ]
    largest = np.max([panel.size for panel in panels], axis=0)
    enlarged = _enlarged(moments, panels, largest)
    if enlarged is not None:
        place, times = enlarged
        title = f"{moments[place].name}\nenlarged {times:.2g} times"
        panels.insert(
            place + 1, _Panel(painted=drawn[place], surface=surfaces[place], title=title, magnification=times)
        )
    handles = [
        handle for handle in shape_handles(shape, structure, ORANGE, 2.0) if not (strain and isinstance(handle, Patch))
    ]
    handles += table_handles(structure)
    with figure_style():
        figure, grid = _draw_panels(panels, handles, width, structure, view)
        if strain:
            scaled = ScalarMappable(Normalize(0, 100 * float(norm.vmax or 0)), STRAIN_COLOURS)
            bar = figure.colorbar(scaled, ax=grid, fraction=0.04, pad=0.02, aspect=30)
            bar.set_label("Green strain (%)")
            bar.outline.set_visible(False)
        strain_text = f" Largest strain of the membrane: {100 * float(norm.vmax or 0):.3g} %." if strain else ""
        titles = "; ".join(texts[moment].replace("\n", ", ") for moment in moments)
        count = f"{len(moments)}" if len(moments) == len(all_moments) else f"{len(moments)} of {len(all_moments)}"
        what = f"The {structure.appearance.whole} {record.design.name} in 3-D at {count} moments of a run"
        room = surroundings_text(structure)
        return describe(figure, f"{what}, each with the time since its stage began. {titles}.{strain_text}{room}")


def _draw_panels(
    panels: Sequence[_Panel], handles: Sequence[Artist], width: float, structure: Structure, view: Viewpoint
) -> tuple[Figure, list[Axes]]:
    """Draw pictures in rows that are as high as their contents, with the legend in an empty place if there is one."""
    columns = _columns(len(panels), width)
    rows = [panels[start : start + columns] for start in range(0, len(panels), columns)]
    across = (1 + _BETWEEN) * max(float(panel.size[0]) for panel in panels)
    scale = width / columns / across
    # the scale bar is below a picture that leaves room for it, or room is added
    room, spans = _BAR_HEIGHT / scale, [_row_span(row) for row in rows]
    roomy = (
        (row, place)
        for row, contents in enumerate(rows)
        for place, panel in enumerate(contents)
        if panel.magnification == 1 and panel.painted.corners[0, 1] > spans[row][0] + room
    )
    barred = next(roomy, None)
    if barred is None:
        spans[0][0] -= room
    titles = [max(panel.title.count("\n") + 1 for panel in row) for row in rows]
    heights = [scale * float(high - low) + _LINE * lines for (low, high), lines in zip(spans, titles, strict=True)]
    beside = len(rows) * columns - len(panels) > 0 and heights[-1] > _ENTRY * len(handles)
    wide = 2 if is_narrow(width) else len(handles)
    below = 0.0 if beside else _LEGEND_ROW * -(-len(handles) // wide) + 0.1
    layout = ConstrainedLayoutEngine(w_pad=0.0, h_pad=_MARGIN, wspace=0.0, hspace=0.0)
    figure = Figure(figsize=(width, sum(heights) + below + (2 * _MARGIN + 0.02) * len(rows)), layout=layout)
    grid = figure.subplots(len(rows), columns, squeeze=False, height_ratios=heights)
    for axes in grid.flat:
        axes.set_axis_off()
    for row, contents, (low, high) in zip(grid, rows, spans, strict=True):
        for axes, panel in zip(row, contents, strict=False):
            middle = float(panel.painted.corners[:, 0].mean())
            window = np.array([[middle - across / 2, low], [middle + across / 2, high]])
            if panel.magnification != 1:
                centre, size = panel.painted.corners.mean(axis=0), np.array([across, high - low])
                window = centre + size / panel.magnification * np.array([[-0.5], [0.5]])
            show_painted(axes, panel.painted, window, width / columns)
            draw_table(axes, structure, panel.surface, view)
            axes.set_title(panel.title, pad=2)
    row, place = barred or (0, 0)
    _scale_bar(grid[row, place], across)
    left, foot = grid[row, place].get_xlim()[0], grid[row, place].get_ylim()[0]
    draw_gravity(grid[row, place], structure, view, (left + 0.6 * across, foot + room / 2), 0.4 * room)
    if beside:
        fit_legend(grid[-1, -1], handles, 1, room=width / columns, loc="center").set_in_layout(False)
    else:
        fit_legend(figure, handles, wide, loc="outside lower center")
    return figure, list(grid.flat)


def _columns(count: int, width: float) -> int:
    """Return the number of pictures in a row with which the fewest places stay empty, one of them for the legend."""

    def empty(columns: int) -> int:
        return max(-count % columns - 1, 0)

    return min(_COLUMNS[is_narrow(width)], key=empty)


def _row_span(row: Sequence[_Panel]) -> list[float]:
    """Return the lowest and the highest position of the pictures in a row, m."""
    common = [panel for panel in row if panel.magnification == 1]
    low = min((float(panel.painted.corners[0, 1]) for panel in common), default=0.0)
    high = max((float(panel.painted.corners[1, 1]) for panel in common), default=0.0)
    # an enlarged picture may be higher than the others
    return [low, max(high, low + max(float(panel.size[1]) for panel in row))]


def _titles(moments: Sequence[_Moment]) -> dict[_Moment, str]:
    """Return the titles of the pictures: a state's name, and the stage with the time since its start."""
    texts = {}
    for moment in moments:
        beside = [other.time - other.stage.start for other in moments if other.stage is moment.stage]
        since = f"{moment.stage.stage.name} + {time_texts(beside)[moment.time - moment.stage.start]}"
        lines = [moment.name] * bool(moment.name) + [since] * (moment.time > 0)
        texts[moment] = "\n".join(lines)
    return texts


def time_texts(times: list[float]) -> dict[float, str]:
    """Return times (s) in one unit, with three significant digits or as many as distinguish them."""
    least = min((time for time in times if time > 0), default=0.0)
    unit, factor = min((reading_unit("s", time) for time in (least, max(times))), key=lambda item: item[1])
    if factor * least < _LEAST_READ:
        unit, factor = reading_unit("s", least)
    for digits in range(3, 18):
        texts = {time: f"{factor * time:.{digits}g} {unit}" for time in times}
        if len(set(texts.values())) == len(texts):
            break
    return texts


def _enlarged(moments: Sequence[_Moment], panels: Sequence[_Panel], largest: Array) -> tuple[int, float] | None:
    """Return the smallest state and the magnification that fills a panel; None if the magnification is small."""
    times = {
        place: float((largest / panel.size).min())
        for place, (moment, panel) in enumerate(zip(moments, panels, strict=True))
        if moment.state
    }
    place = max(times, key=times.__getitem__, default=0)
    return (place, np.floor(10 * times[place]) / 10) if times.get(place, 0.0) >= _ENLARGED else None


def _scale_bar(axes: Axes, across: float) -> None:
    """Draw a scale bar of about a third of the picture at its lower edge."""
    start = (axes.get_xlim()[0] + 0.04 * across, axes.get_ylim()[0])
    bar = round_below(across / 3)
    draw_bar(axes, start, bar, show_value(bar, "m"))


def _moments(record: Record, outcome: Outcome) -> list[_Moment]:
    """Return the states, moments at equal progress between them, and the start and the end of the run."""
    moments = [(name, state.time, True) for name, state in lettered_states(record.structure, outcome)]
    driven = [end for end in record.stages if stage_drives(end.stage)]
    begin, last = (driven or record.stages)[0].start, float(record.time[-1])
    half = float(record.design.protocol.timestep) / 2  # times are multiples of it up to rounding
    if not any(time <= begin + half for _, time, _ in moments):
        moments.append(("start", 0.0, False))
    for end, until in pairwise([*(driven or record.stages), None]):
        assert end is not None
        moments += [("", time, False) for time in _thirds(record, end.start, last if until is None else until.start)]
    moments.append(("end of the run", last, False))
    # of several names for one moment that of a state is kept
    moments.sort(key=lambda moment: (moment[1], not moment[2], not moment[0]))
    kept = list[tuple[str, float, bool]]()
    for moment in moments:
        if not _is_torn(record, moment[1]) and (moment[2] or not kept or _moved(record, kept[-1][1], moment[1])):
            kept.append(moment)
    return [
        _Moment(
            name=name,
            time=time,
            stage=next((end for end in reversed(record.stages) if end.start < time - half), record.stages[0]),
            state=state,
        )
        for name, time, state in kept or [("start", 0.0, True)]
    ]


def _moved(record: Record, before: float, after: float) -> bool:
    """Return whether a structure looks different at two times (s)."""
    changes = [at_time(record, name, after) - at_time(record, name, before) for name in _PLACES]
    return any(float(np.abs(change).max(initial=0.0)) > _SAME * record.structure.span for change in changes)


def _is_torn(record: Record, time: float) -> bool:
    """Return whether a structure is so scattered that a picture shows nothing, as after it diverged."""
    places = record.series.get("point_position")
    if places is None or not places.size:
        return False
    with np.errstate(over="ignore", invalid="ignore"):
        extent = np.ptp(at_time(record, "point_position", time), axis=0).max()
    return not extent <= _TORN * record.structure.span


def _thirds(record: Record, start: float, end: float) -> list[float]:
    """Return the times at which the angles have completed one and two thirds of their change between two times (s)."""
    rows = (record.time >= start) & (record.time <= end)
    time, done = record.time[rows], np.maximum.accumulate(_progress(record, rows))
    return [float(time[int(np.searchsorted(done, share * done[-1]))]) for share in (1 / 3, 2 / 3)]


def _progress(record: Record, rows: Flags) -> Array:
    """Return the rotation of the measured and driven hinges, each divided by its maximum, summed, (row,)."""
    structure = record.structure
    measured = [measure.hinges for measure in shown_angles(structure)]
    turned = np.abs(record.series["hinge_angle"][rows] - record.series["hinge_angle"][rows][0])
    means = [
        turned[:, list(group)].mean(axis=1)
        for group in {*measured, *(motor.hinges for motor in structure.motors)}
        if group
    ]
    moving = [mean / mean.max() for mean in means if mean.max() > _STILL]
    return np.asarray(np.sum(moving, axis=0) if moving else turned.sum(axis=1))
