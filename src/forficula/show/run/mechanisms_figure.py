"""Energies of a run by mechanism, as areas on top of each other whose sum is the work put in."""

from __future__ import annotations

import math
from dataclasses import dataclass
from itertools import pairwise
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.colors import to_hex, to_rgb
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Patch

from forficula.analysis.energy_by_mechanism import EnergyShares, energy_shares
from forficula.analysis.order_of_events import group_motions
from forficula.arrays import Array, Flags, Indices
from forficula.design import stage_drives
from forficula.dynamics import Record, StageEnd
from forficula.names import listed
from forficula.quantities import reading_unit, show_value
from forficula.show.structure.drive_labels import acting
from forficula.show.style import (
    BLACK,
    BLUE,
    GREEN,
    ORANGE,
    PAGE_WIDTH,
    PURPLE,
    SKY,
    VERMILION,
    YELLOW,
    describe,
    figure_style,
    fit_legend,
    is_narrow,
    letter_panels,
)
from forficula.structure import Mechanism, Structure, mechanisms_of

# colour of a mechanism by the kind of its elements, unless another mechanism has it already
_PREFERRED = (("tendons", BLUE), ("membranes", ORANGE), ("hinges", SKY), ("springs", GREEN), ("couplings", PURPLE))
_PALETTE = (BLUE, ORANGE, SKY, GREEN, PURPLE, YELLOW)
_PALER = 0.55  # share of white in the colours of further mechanisms
LOSSES = "losses"  # name of the topmost area
_MOTION, _LOST, _WEIGHT = VERMILION, "#D0D0D0", "#8C8C8C"
_MARKERS = ("o", "s", "D", "^", "p", "h")  # of groups of hinges
_MOST_PANELS, _MOST_ACROSS = 6, 3
_STILL = 0.01  # share of the largest kinetic energy below which a structure counts as still
_AFTER = 0.1  # time shown after the motion, as a share of its duration
_HEIGHT = 2.3  # inch, of a row of panels
_LEGEND = 1.55  # inch, width of the legend beside the panels
_ABOVE = 1.035  # height of the markers, in heights of the axes


@dataclass(frozen=True, kw_only=True)
class Band:
    """Area of a stack.

    Attributes:
        name: name in the legend.
        colour: its colour.
        energy: J, (time,).
    """

    name: str
    colour: str
    energy: Array


@dataclass(frozen=True, kw_only=True)
class EnergySpan:
    """Part of a run that one panel shows.

    Attributes:
        start: s.
        end: s.
        stage: driven stage with which it begins; None for the whole run.
    """

    start: float
    end: float
    stage: StageEnd | None = None


def draw_mechanisms(record: Record, width: float = PAGE_WIDTH) -> Figure:
    """Draw the energy of every mechanism, of the motion and the losses as areas on top of each other.

    The upper edge of the areas is the energy at the start of a panel plus the work of the motors since then, which is
    drawn as a line. A panel shows a driven stage and the motion after it; the width is in inches.
    """
    shares, spans = energy_shares(record), energy_spans(record)
    with figure_style():
        figure, panels, legend = _panels(len(spans), width)
        shown = [_rows(record, shares, span) for span in spans]
        most = max(float(shares.supplied[rows].max() - shares.lost[rows][0]) for rows in shown)
        unit, factor = reading_unit("J", most)
        groups: dict[str, str] = {}
        for axes, span, rows in zip(panels, spans, shown, strict=True):
            _draw_stack(axes, record, shares, rows, span, factor)
            _mark_events(axes, record, span, groups)
            axes.set_title(span.stage.stage.name if span.stage else "whole run", pad=11, fontsize=7)
        for axes in panels if is_narrow(width) else panels[::_MOST_ACROSS]:
            axes.set_ylabel(f"energy ({unit})")
        letter_panels(panels)
        _add_legend(figure, legend, _handles(record, shares, spans, groups), width)
        return describe(figure, _text(record, shares, spans))


def energy_spans(record: Record) -> list[EnergySpan]:
    """Return the parts of a run to show: each driven stage with the motion after it, or else the whole run."""
    driven = [end for end in record.stages if stage_drives(end.stage)]
    if not 0 < len(driven) <= _MOST_PANELS:
        return [EnergySpan(start=float(record.time[0]), end=float(record.time[-1]))]
    spans = []
    for stage, following in pairwise([*driven, None]):
        assert stage is not None
        limit = float(record.time[-1]) if following is None else following.start
        rows = (record.time >= stage.start) & (record.time <= limit)
        kinetic = np.nan_to_num(record.series["kinetic_energy"][rows], posinf=0.0)
        moving = np.flatnonzero(kinetic >= _STILL * kinetic.max())
        last = max(float(record.time[rows][moving[-1]]), stage.goal_time or stage.start)
        # the first row after the motion, so that the areas fill the panel
        end = record.time[rows][record.time[rows] >= min(last + _AFTER * (last - stage.start), limit)][0]
        spans.append(EnergySpan(start=stage.start, end=float(end) if end > stage.start else limit, stage=stage))
    return spans


def energy_bands(record: Record, shares: EnergyShares, rows: Flags | Indices) -> list[Band]:
    """Return the areas of a stack in some rows, the lowest first; losses count from the first of these rows."""
    mechanisms = mechanisms_of(record.structure)
    bands = [
        Band(name=mechanism.name, colour=colour, energy=shares.stored[mechanism.name][rows])
        for mechanism, colour in zip(mechanisms, mechanism_colours(mechanisms), strict=True)
    ]
    if shares.weight is not None:
        bands.append(Band(name="weight", colour=_WEIGHT, energy=shares.weight[rows]))
    lost = shares.lost[rows]
    bands.append(Band(name="motion", colour=_MOTION, energy=shares.kinetic[rows]))
    bands.append(Band(name=LOSSES, colour=_LOST, energy=lost - lost[0]))
    return bands


def mechanism_colours(mechanisms: tuple[Mechanism, ...]) -> list[str]:
    """Return a colour for every mechanism: that of the kind of its elements, or the next one that is free."""
    shares = (np.array(to_rgb(colour)) for colour in _PALETTE)
    pale = [to_hex(tuple(((1 - _PALER) * share + _PALER).tolist())) for share in shares]
    palette = [*_PALETTE, *pale]
    colours: list[str] = []
    for mechanism in mechanisms:
        wanted = [colour for kind, colour in _PREFERRED if getattr(mechanism, kind)]
        free = [colour for colour in (*wanted[:1], *palette) if colour not in colours]
        colours.append(free[0] if free else palette[len(colours) % len(palette)])
    return colours


def supply_text(structure: Structure) -> str:
    """Return the name of the energy to which all areas add up."""
    work = f" plus work of the {acting(structure)}" if structure.motors else ""
    return f"energy at the start{work}"


def _rows(record: Record, shares: EnergyShares, span: EnergySpan) -> Flags:
    """Return the rows of a span in which all energies are known, (time,)."""
    sound = np.isfinite(shares.supplied) & np.isfinite(shares.held) & np.isfinite(shares.lost)
    if record.diverged_at is not None:
        sound &= record.time < record.diverged_at
    rows = (record.time >= span.start) & (record.time <= span.end) & np.logical_and.accumulate(sound)
    if not rows.any():
        rows[0] = True
    return np.asarray(rows)


def _panels(count: int, width: float) -> tuple[Figure, list[Axes], Axes | None]:
    """Return axes for the spans, below each other if narrow, and the area of the legend beside them."""
    if is_narrow(width):
        figure = Figure(figsize=(width, _HEIGHT * count), layout="constrained")
        return figure, list(figure.subplots(count, 1, squeeze=False)[:, 0]), None
    across = min(count, _MOST_ACROSS)
    down = math.ceil(count / across)
    figure = Figure(figsize=(width, (_HEIGHT + 0.2) * down), layout="constrained")
    share = (width - _LEGEND) / across
    grid = figure.add_gridspec(down, across + 1, width_ratios=[*[share] * across, _LEGEND])
    panels = [figure.add_subplot(grid[number // across, number % across]) for number in range(count)]
    legend = figure.add_subplot(grid[:, across])
    legend.set_axis_off()
    return figure, panels, legend


def _draw_stack(axes: Axes, record: Record, shares: EnergyShares, rows: Flags, span: EnergySpan, factor: float) -> None:
    """Draw the areas and the line of the energy supplied."""
    unit, scale = reading_unit("s", span.end - span.start)
    time, low = scale * (record.time[rows] - span.start), np.zeros(int(rows.sum()))
    for band in energy_bands(record, shares, rows):
        high = low + factor * band.energy
        axes.fill_between(time, low, high, facecolor=band.colour, edgecolor="white", lw=0.3, label=band.name)
        low = high
    supplied = factor * (shares.supplied[rows] - shares.lost[rows][0])
    axes.plot(time, supplied, color=BLACK, lw=1.1)
    axes.set_xlim(0, max(scale * (span.end - span.start), 1e-12))
    axes.set_ylim(0, 1.06 * max(float(supplied.max()), float(low.max()), 1e-300))
    axes.set_xlabel(f"time since its start ({unit})" if span.stage else f"time ({unit})")


def _mark_events(axes: Axes, record: Record, span: EnergySpan, groups: dict[str, str]) -> None:
    """Mark the end of the drive, the goal, and the middle of the travel of each group of hinges.

    Args:
        axes: axes of the panel.
        record: the simulated motion.
        span: part of the run.
        groups: markers of the groups so far, which this function extends.
    """
    if span.stage is None:
        return
    scale, place = reading_unit("s", span.end - span.start)[1], axes.get_xaxis_transform()
    if span.stage.end < span.end:
        axes.axvline(scale * (span.stage.end - span.start), color=BLACK, ls=(0, (4, 3)), lw=0.7)
    marks = [("v", span.stage.goal_time)] if span.stage.goal_time is not None else []
    for motion in group_motions(record, record.stages.index(span.stage)):
        marker = groups.setdefault(motion.group, _MARKERS[len(groups) % len(_MARKERS)])
        marks.append((marker, motion.middle))
    for marker, moment in marks:
        if span.start <= moment <= span.end:
            at = scale * (moment - span.start)
            axes.plot([at], [_ABOVE], ls="none", transform=place, clip_on=False, **_look(marker))


def _look(marker: str) -> dict[str, Any]:
    """Return the look of a marker: groups of hinges have open ones."""
    return {"marker": marker, "mfc": BLACK if marker == "v" else "white", "mec": BLACK, "mew": 0.7, "ms": 4}


def _handles(
    record: Record, shares: EnergyShares, spans: list[EnergySpan], groups: dict[str, str]
) -> list[Patch | Line2D]:
    """Return the entries of the legend, the areas from top to bottom."""
    first = np.arange(len(record.time)) == 0
    bands = energy_bands(record, shares, first)
    handles: list[Patch | Line2D] = []
    edge = supply_text(record.structure).replace(" plus ", "\nplus ")
    handles.append(Line2D([], [], color=BLACK, lw=1.1, label=edge))
    handles += [Patch(facecolor=band.colour, label=band.name) for band in reversed(bands)]
    stages = [span.stage for span in spans if span.stage is not None]
    if any(stage.end < span.end for stage, span in zip(stages, spans, strict=False)):
        handles.append(Line2D([], [], color=BLACK, ls=(0, (4, 3)), lw=0.7, label="end of the drive"))
    if any(stage.goal_time is not None for stage in stages):
        handles.append(Line2D([], [], ls="none", label="goal reached", **_look("v")))
    groups_seen = (Line2D([], [], ls="none", label=f"half-way: {group}", **_look(groups[group])) for group in groups)
    return [*handles, *groups_seen]


def _add_legend(figure: Figure, beside: Axes | None, handles: list[Patch | Line2D], width: float) -> None:
    if beside is None:
        fit_legend(figure, handles, 2, room=width, loc="outside lower left", columnspacing=1.2)
    else:
        fit_legend(beside, handles, 1, room=_LEGEND, loc="upper left", borderaxespad=0, handlelength=1.6)


def _text(record: Record, shares: EnergyShares, spans: list[EnergySpan]) -> str:
    """Describe the stack of every span: the largest energies, the losses and the missing energy."""
    sentences = []
    for span in spans:
        rows = _rows(record, shares, span)
        *bands, lost = energy_bands(record, shares, rows)
        largest = listed(f"{band.name} {show_value(float(band.energy.max()), 'J')}" for band in bands)
        work = float(record.work[rows][-1] - record.work[rows][0])
        name = f'the stage "{span.stage.stage.name}"' if span.stage else "the whole run"
        sentences.append(
            f"Largest energies in {name}: {largest}; losses {show_value(float(lost.energy[-1]), 'J')}"
            f" of {show_value(work, 'J')} of work put in."
        )
    head = f"Energies by mechanism, as areas on top of each other, over time in a run of {record.design.name}."
    return " ".join([head, *sentences])
