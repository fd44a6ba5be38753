"""Pictures of a structure at several moments of a run."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from matplotlib.axes import Axes
from matplotlib.cm import ScalarMappable
from matplotlib.colors import Normalize
from matplotlib.figure import Figure
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
    structure_view,
)
from forficula.show.structure.shape import shape_of
from forficula.show.structure.surface import at_time, face_strains, surface_at
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

_LEGEND_ROW, _TITLE = 0.2, 0.42  # inch, heights
_BAR_HEIGHT = 0.3  # inch, height of a scale bar with its number
_TORN = 10.0  # spans, size from which a structure counts as torn
_MOST_LINES = 200  # largest number of creases and edges: more would hide the surface
_MOST_PICTURES = 40
_ENLARGED = 1.4  # least magnification for which a state is also drawn enlarged
_MARGIN = 1.06  # size of an enlarged picture, as a multiple of its contents
_STILL = np.radians(1.0)  # hinges that turn less in a stage do not count for its progress


@dataclass(frozen=True, kw_only=True)
class _Moment:
    """Contents of one picture.

    Attributes:
        name: name of the state or the stage.
        time: time in the run, s.
        stage: last stage that began before this time.
        state: whether the moment is a state.
    """

    name: str
    time: float
    stage: StageEnd
    state: bool


def draw_folding(record: Record, outcome: Outcome, width: float = PAGE_WIDTH, *, strain: bool = False) -> Figure:
    """Draw a structure in its states and at equal progress between them, at one scale and from one viewpoint.

    A state that is much smaller than the whole is also drawn enlarged.

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
    shape, view = shape_of(structure), structure_view(structure)
    texts = _titles(moments)
    with figure_style():
        columns = 2 if is_narrow(width) else 4
        surfaces = [surface_at(record, shape, moment.time) for moment in moments]
        if len(shape.lines) > _MOST_LINES and not structure.facets:
            surfaces = [replace(surface, lines=surface.lines[:0], folds=surface.folds[:0]) for surface in surfaces]
        strains = [face_strains(shape, surface) for surface in surfaces] if strain else []
        norm = Normalize(0, max((float(strain.max(initial=0)) for strain in strains), default=0.0) or 1e-6)
        colours = [STRAIN_COLOURS(norm(strain))[:, :3] for strain in strains] or [None] * len(surfaces)
        drawn = [paint_shape(surface, view, ORANGE, colour) for surface, colour in zip(surfaces, colours, strict=True)]
        corners = np.concatenate([painted.corners for painted in drawn])
        window = np.array([corners.min(axis=0), corners.max(axis=0)])
        scale = width / columns / np.ptp(window, axis=0)[0]
        # the scale bar is below a picture that leaves room for it, or room is added
        room = _BAR_HEIGHT / scale
        barred = next((place for place, item in enumerate(drawn) if item.corners[0, 1] > window[0, 1] + room), None)
        if barred is None:
            window[0, 1] -= room
        enlarged = _enlarged(moments, drawn, window)
        rows = -(-(len(moments) + (enlarged is not None)) // columns)
        handles = [
            handle
            for handle in shape_handles(shape, structure, ORANGE, 2.0)
            if not (strain and isinstance(handle, Patch))
        ]
        across = 2 if is_narrow(width) else len(handles)
        legend = _LEGEND_ROW * -(-len(handles) // across)
        height = rows * (scale * np.ptp(window, axis=0)[1] + _TITLE) + legend
        figure = Figure(figsize=(width, height), layout="constrained")
        panels = np.ravel(figure.subplots(rows, columns, squeeze=False))
        for axes, moment, painted in zip(panels, moments, drawn, strict=False):
            show_painted(axes, painted, window, width / columns)
            axes.set_title(texts[moment], pad=2)
        _scale_bar(panels[barred or 0], window)
        if enlarged is not None:
            place, times = enlarged
            close = drawn[place].corners.mean(axis=0) + np.ptp(window, axis=0) / times * np.array([[-0.5], [0.5]])
            show_painted(panels[len(moments)], drawn[place], close, width / columns)
            panels[len(moments)].set_title(f"{moments[place].name}\nenlarged {times:.2g} times", pad=2)
        for axes in panels:
            axes.set_axis_off()
        if strain:
            scaled = ScalarMappable(Normalize(0, 100 * float(norm.vmax or 0)), STRAIN_COLOURS)
            bar = figure.colorbar(scaled, ax=list(panels), fraction=0.04, pad=0.02, aspect=30)
            bar.set_label("Green strain (%)")
            bar.outline.set_visible(False)
        fit_legend(figure, handles, across, loc="outside lower center")
        seen = f" Largest strain of the membrane: {100 * float(norm.vmax or 0):.3g} %." if strain else ""
        titles = "; ".join(texts[moment].replace("\n", ", ") for moment in moments)
        count = f"{len(moments)}" if len(moments) == len(all_moments) else f"{len(moments)} of {len(all_moments)}"
        what = f"The {structure.appearance.whole} {record.design.name} in 3-D at {count} moments of a run"
        return describe(figure, f"{what}, each with the time since its stage began. {titles}.{seen}")


def _titles(moments: Sequence[_Moment]) -> dict[_Moment, str]:
    """Return the titles of the pictures: a state's name, and the stage with the time since its start."""
    texts = {}
    for moment in moments:
        beside = [other.time - other.stage.start for other in moments if other.stage is moment.stage]
        since = f"{moment.stage.stage.name} + {time_texts(beside)[moment.time - moment.stage.start]}"
        texts[moment] = f"{moment.name}\n{since}" if moment.state else since
    return texts


def time_texts(times: list[float]) -> dict[float, str]:
    """Return times (s) in one unit, with three significant digits or as many as distinguish them."""
    unit, factor = reading_unit("s", max(times))
    for digits in range(3, 18):
        texts = {time: f"{factor * time:.{digits}g} {unit}" for time in times}
        if len(set(texts.values())) == len(texts):
            break
    return texts


def _enlarged(moments: Sequence[_Moment], drawn: Sequence[PaintedShape], window: Array) -> tuple[int, float] | None:
    """Return the smallest state and the magnification that fills a window; None if the magnification is small."""
    times = {
        place: float((np.ptp(window, axis=0) / np.ptp(painted.corners, axis=0)).min()) / _MARGIN
        for place, (item, painted) in enumerate(zip(moments, drawn, strict=True))
        if item.state
    }
    place = max(times, key=times.__getitem__, default=0)
    return (place, np.floor(10 * times[place]) / 10) if times.get(place, 0.0) >= _ENLARGED else None


def _scale_bar(axes: Axes, window: Array) -> None:
    """Draw a scale bar of about a third of the picture at its lower edge."""
    size = np.ptp(window, axis=0)
    bar = round_below(size[0] / 2)
    draw_bar(axes, window[0] + (0.04, 0.02) * size, bar, show_value(bar, "m"))


def _moments(record: Record, outcome: Outcome) -> list[_Moment]:
    """Return the states, and moments at equal progress of every driven stage between them.

    If no stage is driven, the start and moments of every stage.
    """
    moments = [(name, state.time, True) for name, state in lettered_states(record.structure, outcome)]
    driven = [end for end in record.stages if stage_drives(end.stage)]
    if not driven:
        moments.append(("start", 0.0, True))
    for end in driven or record.stages:
        moments += [(end.stage.name, time, False) for time in _halfway(record, end)]
    moments.sort(key=lambda moment: moment[1])
    # of several names for one moment the first is kept
    apart = [moment for place, moment in enumerate(moments) if place == 0 or moment[1] > moments[place - 1][1]]
    seen = [item for item in apart if not _is_torn(record, item[1])] or [("start", 0.0, True)]
    half = float(record.design.protocol.timestep) / 2  # times are multiples of it up to rounding
    return [
        _Moment(
            name=name,
            time=time,
            stage=next((end for end in reversed(record.stages) if end.start < time - half), record.stages[0]),
            state=state,
        )
        for name, time, state in seen
    ]


def _is_torn(record: Record, time: float) -> bool:
    """Return whether a structure is so scattered that a picture shows nothing, as after it diverged."""
    places = record.series.get("point_position")
    if places is None or not places.size:
        return False
    with np.errstate(over="ignore", invalid="ignore"):
        extent = np.ptp(at_time(record, "point_position", time), axis=0).max()
    return not extent <= _TORN * record.structure.span


def _halfway(record: Record, end: StageEnd) -> list[float]:
    """Return the times at which the angles of a stage have completed one and two thirds of their change."""
    rows = (record.time >= end.start) & (record.time <= end.end)
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
