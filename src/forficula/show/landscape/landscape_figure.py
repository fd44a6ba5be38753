"""Energy and moment of a structure along its rigid fold."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from forficula.quantities import reading_unit, show_value
from forficula.show.landscape.landscape_marks import (
    energy_storing_parts,
    mark_barrier,
    mark_state,
    rounding_torque,
    sheet_parts,
    show_angle,
    state_handles,
    torque_location,
    write_note,
)
from forficula.show.style import (
    BLACK,
    BLUE,
    ORANGE,
    PAGE_WIDTH,
    VERMILION,
    describe,
    figure_style,
    fit_legend,
    in_column,
    letter_panels,
)
from forficula.statics import EnergyLandscape, FoldPath, StableState
from forficula.statics.landscape import fold_path_of, fold_states
from forficula.statics.tree.fold_path import rigid_fold
from forficula.structure import Structure

_RING_TICKS = (0, 2, 5, 10, 20, 40, 60, 90, 120, 150, 180)  # deg
_TICK_GAP = 0.06  # least distance of two ticks, as a share of the axis
# free areas within the axes: left, low, width, height, in shares of the axes
_LOWER_LEFT, _UPPER_LEFT, _UPPER_RIGHT = (0.09, 0.20, 0.34, 0.50), (0.09, 0.50, 0.34, 0.44), (0.66, 0.50, 0.32, 0.44)
_LABELS = 0.15  # space that ticks and labels take below and beside such an area
_INWARDS = 0.1  # shift in a column, where the names of axes take a larger share
_WORDS = math.radians(22)  # length of the words at a state
_BESIDE = math.radians(15)  # distance before a state at which the curve is checked for space


def draw_fold_path(landscape: EnergyLandscape, width: float = PAGE_WIDTH) -> Figure:
    """Draw energy and moment over the pleat angle, from camber through flat to folded.

    Args:
        landscape: landscape of a design whose rigid panels have exactly one way to fold.
        width: width of the figure, inch.

    Raises:
        InputError: the panels have no way or several ways to fold.
    """
    path = fold_path_of(landscape)
    pulling, stretched = energy_storing_parts(landscape.structure), sheet_parts(landscape.structure)
    pleat, moment, sheet_energy = np.degrees(path.pleat_angle), path.moment, path.sheet_energy
    rounding = rounding_torque(landscape)
    if float(np.abs(moment).max()) <= rounding:
        moment, sheet_energy = np.zeros_like(moment), np.zeros_like(sheet_energy)
    states = fold_states(landscape)
    energy_unit, energy = reading_unit("J", float(path.energy.max()))
    sheet_unit, sheet = reading_unit("J", float(sheet_energy.max()))
    torque_unit, torque = reading_unit("N m", float(np.abs(moment).max()))
    with figure_style():
        figure = Figure(figsize=(width, 5.4), layout="constrained")
        top, middle, bottom = figure.subplots(3, 1, sharex=True, height_ratios=[2.0, 0.75, 1.15])
        top.plot(pleat, energy * path.energy, color=BLACK, lw=2.2, alpha=0.35, label="total")
        top.plot(pleat, energy * path.tendon_energy, "--", color=BLUE, label=pulling)
        middle.plot(pleat, sheet * sheet_energy, color=ORANGE, label=stretched)
        bottom.plot(pleat, torque * moment, color=BLACK, lw=1.0)
        for state in states:
            _mark(top, landscape, state, energy)
        _mark_saddles(top, path, energy)
        _close_up(top, landscape)
        _mark_climbs(bottom, landscape, torque, rounding)
        _ring_axis(top, landscape)
        for axes in (top, middle, bottom):
            axes.axvline(0, color="0.6", lw=0.5, ls=":", zorder=0)
        span = pleat[-1] - pleat[0]
        top.set_xlim(pleat[0] - 0.02 * span, pleat[-1] + 0.02 * span)
        top.set_xticks([tick for tick in range(-180, 181, 30) if pleat[0] <= tick <= pleat[-1]])
        top.set_ylim(0, 1.12 * energy * float(path.energy.max()))
        middle.set_ylim(0, 1.15 * sheet * float(sheet_energy.max()) or 1)
        bottom.axhline(0, color="0.6", lw=0.5, zorder=0)
        low, high = torque * float(moment.min()), torque * float(moment.max())
        room = (high - low) or 1.0
        bottom.set_ylim(min(low, 0) - (0.45 if in_column(bottom) else 0.3) * room, high + 0.2 * room)
        for axes, curve in ((top, path.energy), (middle, sheet_energy), (bottom, moment)):
            if not np.any(curve):
                axes.set_yticks([0])
        top.set_ylabel(f"stored energy ({energy_unit})")
        middle.set_ylabel(f"{stretched.replace(' and ', f',{chr(10)}')} ({sheet_unit})")
        bottom.set_ylabel(f"moment about the\npleats ({torque_unit})")
        letter_panels([top, middle, bottom])
        bottom.set_xlabel("pleat angle (deg): camber < 0, flat 0, folding > 0")
        handles = [handle for axes in (top, middle) for handle in axes.get_legend_handles_labels()[0]]
        handles += state_handles({state.kind for state in states})
        fit_legend(figure, handles, 4, loc="outside upper center")
        return describe(figure, _text(landscape))


def _mark_saddles(axes: Axes, path: FoldPath, factor: float) -> None:
    """Mark the energy maxima along the fold, if there are any."""
    if saddles := [state for state in path.states if not state.stable]:
        places = np.degrees([saddle.coordinate for saddle in saddles])
        heights = [factor * saddle.energy for saddle in saddles]
        style: dict[str, Any] = {"color": "white", "mec": VERMILION, "ms": 6, "ls": "none", "zorder": 6}
        axes.plot(places, heights, "^", clip_on=False, label="saddle", **style)


def _mark(axes: Axes, landscape: EnergyLandscape, state: StableState, factor: float) -> None:
    """Mark a stable state, with its name and energy."""
    path, place = fold_path_of(landscape), math.degrees(state.pleat_angle)
    band = (path.pleat_angle >= state.pleat_angle) & (path.pleat_angle <= state.far_pleat_angle)
    ends = np.degrees(path.pleat_angle[band]), factor * path.energy[band]
    mark_state(axes, state.kind, place, factor * state.energy, *ends)
    words = f"{state.name}, {show_value(state.energy, 'J', 3)}"
    last_words = words.replace(", ", ",\n") if in_column(axes) else words
    height = factor * state.energy
    offsets: dict[str, Any] = {"textcoords": "offset points", "va": "center", "fontsize": 7}
    largest = factor * float(path.energy.max())
    if state.name == rigid_fold(landscape.structure).start:
        axes.annotate(words, (place, height), xytext=(7, -12 if height > 0.2 * largest else 12), ha="left", **offsets)
        return
    before = float(np.interp(state.far_pleat_angle - _BESIDE, path.pleat_angle, factor * path.energy))
    corner = (math.degrees(state.far_pleat_angle), height)
    if before < 0.1 * largest:  # the curve is low before the state: space above the mark
        where_words_begin = float(np.interp(state.far_pleat_angle - _WORDS, path.pleat_angle, factor * path.energy))
        above = 24 if where_words_begin < 0.15 * largest else 44
        axes.annotate(last_words, corner, xytext=(0, above), ha="right", **offsets)
    else:
        axes.annotate(last_words, corner, xytext=(-10, 6), ha="right", **offsets)


def _close_up(axes: Axes, landscape: EnergyLandscape) -> None:
    """Draw an inset of the saddle after the first stable state, relative to that state; a note without a saddle."""
    path = fold_path_of(landscape)
    left, low, width, height = _free_place(landscape)
    if in_column(axes) and left == _LOWER_LEFT[0]:
        left += _INWARDS
    start = next((state for state in path.states if state.stable), None)
    saddle = next(
        (state for state in path.states if not state.stable and start and state.coordinate > start.coordinate), None
    )
    if start is None or saddle is None:
        write_note(axes, (left + width / 2, low + height / 2), _why_no_saddle(landscape))
        return
    near = axes.inset_axes((left, low, width, height))
    climb = saddle.energy - start.energy
    unit, factor = reading_unit("J", climb)
    reach = saddle.coordinate - start.coordinate
    last = min(saddle.coordinate + 1.6 * reach, float(path.pleat_angle[-1]))
    places = (path.pleat_angle >= start.coordinate) & (path.pleat_angle <= last)
    near.plot(np.degrees(path.pleat_angle[places]), factor * (path.energy[places] - start.energy), color=BLACK)
    near.set_ylim(-0.75 * factor * climb, 1.25 * factor * climb)
    near.set_xlim(math.degrees(start.coordinate - 0.12 * reach), math.degrees(last))
    words = f"barrier {factor * climb:.4g} {unit}"
    mark_barrier(near, math.degrees(saddle.coordinate), factor * climb, words)
    name = rigid_fold(landscape.structure).start if start.coordinate <= 0 else "the state"
    near.set_ylabel(f"above {name} ({unit})", fontsize=7, labelpad=2)
    near.set_xlabel("pleat angle (deg)", fontsize=7, labelpad=1)
    near.tick_params(labelsize=6)


def _free_place(landscape: EnergyLandscape) -> tuple[float, float, float, float]:
    """Return the first area that the curve leaves free, or the one that it crosses least."""
    path = fold_path_of(landscape)
    share = (path.pleat_angle - path.pleat_angle[0]) / (path.pleat_angle[-1] - path.pleat_angle[0])
    height = path.energy / (1.12 * float(path.energy.max()))
    rooms = {}
    for place in (_LOWER_LEFT, _UPPER_RIGHT, _UPPER_LEFT):
        left, low, width, tall = place
        beside = height[(share > left - _LABELS / 2) & (share < left + width)]
        above, below = low - _LABELS - float(beside.max()), float(beside.min()) - (low + tall)
        rooms[place] = min(max(above, below), 0.0)
    return max(rooms, key=lambda place: rooms[place])


def _why_no_saddle(landscape: EnergyLandscape) -> str:
    path = fold_path_of(landscape)
    if not np.any(path.ring_angle) and path.remarks:
        return path.remarks[0]
    if landscape.tendons and all(tendon.barrier is None for tendon in landscape.tendons):
        return landscape.tendons[0].remarks[0]
    return "no saddle: the energy along the fold never rises and then falls"


def _mark_climbs(axes: Axes, landscape: EnergyLandscape, factor: float, rounding: float) -> None:
    """Mark where the moment resists folding and opening most, with the torques required."""
    path = fold_path_of(landscape)
    forward, back = _directions(landscape.structure)
    driven = "" if path.driven == path.turns else "driven "
    turning = f"on every {driven}{landscape.structure.appearance.bar}"
    places = [(int(np.argmin(path.moment)), forward, path.fold_torque, turning, -9)]
    if path.unfold_torque is not None:
        moves = (path.fold_slope > 0) & (path.unfold_rate > 0)
        torque_back = np.where(moves, path.moment, 0.0) / np.where(moves, path.unfold_rate, 1.0)
        opening = next(transition for transition in landscape.structure.transitions if transition.wording.doing == back)
        where_back = torque_location(landscape.structure, opening)
        places.append((int(np.argmax(torque_back)), back, path.unfold_torque, where_back, 5))
    middle = (path.pleat_angle[0] + path.pleat_angle[-1]) / 2
    for place, name, torque, where, up in places:
        angle = path.pleat_angle[place]
        free = any(
            state.kind == "neutral" and state.coordinate <= angle <= state.far_coordinate for state in path.states
        )
        if free or torque <= rounding:
            continue
        side, across = ("left", 9) if angle < middle else ("right", -9)
        unit, reads = reading_unit("N m", torque)
        at = math.degrees(angle), factor * path.moment[place]
        axes.plot(*at, "o", color=VERMILION, ms=4)
        required = f"{reads * torque:.3g} {unit}"
        # the axis has the moment about the pleats and not that of one joint
        about = show_value(abs(path.moment[place]), "N m", 3)
        apart = "\n" if in_column(axes) else " "
        words = f"{required}{apart}{where}" if about == required else f"{about}:{apart}{required} {where}"
        style: dict[str, Any] = {"textcoords": "offset points", "ha": side, "va": "center", "fontsize": 7}
        axes.annotate(f"{name} requires {words}", at, xytext=(across, up), **style)


def _directions(structure: Structure) -> tuple[str, str]:
    """Return words for the motion along the fold and back, such as "folding" and "opening"."""
    fold, doing = rigid_fold(structure), [transition.wording.doing for transition in structure.transitions]
    states = [transition.state for transition in structure.transitions]
    place = states.index(fold.end) if fold.end in states else len(states)
    doings = doing[place : place + 2]
    return doings[0] if doings else f"getting {fold.end}", doings[1] if len(doings) > 1 else f"getting {fold.start}"


def _ring_axis(axes: Axes, landscape: EnergyLandscape) -> None:
    """Add an axis at the top with the angle of the ring creases, if the angle changes."""
    path = fold_path_of(landscape)
    if not np.any(path.ring_angle):
        return
    pleats, rings = np.degrees(path.pleat_angle), np.degrees(path.ring_angle)
    ends = [(float(pleats[0]), float(rings[0])), (float(pleats[-1]), float(rings[-1]))]
    gap = _TICK_GAP * (ends[1][0] - ends[0][0])
    for tick in _RING_TICKS:
        place = float(np.interp(tick, rings, pleats))
        if place - ends[-2][0] >= gap and ends[-1][0] - place >= gap:
            ends.insert(-1, (place, tick))
    above = axes.twiny()
    above.spines["top"].set_visible(True)
    above.set_xlim(axes.get_xlim())
    axes.callbacks.connect("xlim_changed", lambda changed: above.set_xlim(changed.get_xlim()))
    above.set_xticks([place for place, _ in ends], [f"{round(ring, 2) + 0.0:g}".replace("-", "−") for _, ring in ends])
    above.set_xlabel("fold angle of the ring creases (deg)")


def _text(landscape: EnergyLandscape) -> str:
    """Describe the energy of the structure along its fold."""
    states = [
        f"{state.name} at a pleat angle of {show_angle(state.pleat_angle)} with {show_value(state.energy, 'J', 3)}"
        for state in fold_states(landscape)
    ]
    saddles = [
        f"{show_value(state.energy, 'J', 3)} at {show_angle(state.coordinate)}"
        for state in fold_path_of(landscape).states
        if not state.stable
    ]
    return (
        f"Energy of the {landscape.structure.appearance.whole} {landscape.design.name} along its fold; below it, the"
        " energy of its membrane and the moment about the pleats."
        f" Stable states: {'; '.join(states) or 'none'}. Saddles: {'; '.join(saddles) or 'none'}."
    )
