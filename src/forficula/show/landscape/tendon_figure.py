"""Energy and moment of one tendon over its distal angle, as in Binder et al. 2025, Figure 5."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import Patch
from numpy.typing import NDArray

from forficula.analysis.simulated_snap import INNER_VEIN
from forficula.dynamics import Record
from forficula.quantities import reading_unit, show_value
from forficula.show.landscape.landscape_marks import mark_barrier, mark_state, show_angle, state_handles, write_note
from forficula.show.style import (
    BLUE,
    GREEN,
    ORANGE,
    PAGE_WIDTH,
    PURPLE,
    SKY,
    VERMILION,
    describe,
    figure_style,
    in_column,
    is_narrow,
)
from forficula.statics import EnergyLandscape, HingeLandscape

Array = NDArray[np.float64]

_COLOURS = (BLUE, SKY, GREEN, PURPLE)
_STOP = "0.87"
_ALIKE = 1e-6  # relative difference of energies up to which two hinges are drawn as one
_APART = 12.0  # between two points of the simulation, deg
_INSET = (0.62, 0.58, 0.34, 0.40)
_WIDE_BOWL = 50.0  # of a moment, beside or within which there is room for words, deg


def draw_tendon(
    landscape: EnergyLandscape, record: Record | None = None, width: float = PAGE_WIDTH, vein: int = INNER_VEIN
) -> Figure:
    """Draw energy and moment of one tendon over its distal angle.

    Args:
        landscape: of a design.
        record: a run of it, whose tendon is drawn on top; it must not have diverged.
        width: of the figure, inch.
        vein: number of the one, from 0, whose tendon it is.
    """
    wing = landscape.tendons[vein]
    energy_unit, energy_factor = reading_unit("J", float(landscape.hinge.energy.max()))
    torque_unit, torque_factor = reading_unit("N m", float(np.abs(landscape.hinge.moment).max()))
    with figure_style():
        figure = Figure(figsize=(width, 5.0), layout="constrained")
        top, bottom = figure.subplots(2, 1, sharex=True, height_ratios=[1.3, 1])
        for hinge, name, style in _curves(landscape):
            angle = np.degrees(hinge.angle)
            top.plot(angle, energy_factor * hinge.energy, label=name, **style)
            bottom.plot(angle, torque_factor * hinge.moment, **style)
        for state in wing.states:
            band = _between(wing, state.angle, state.far_angle)
            ends = np.degrees(wing.angle[band]), energy_factor * wing.energy[band]
            mark_state(top, state.kind, math.degrees(state.angle), energy_factor * state.energy, *ends)
        if record is not None:
            _plot_simulation(top, record, vein, energy_factor)
        _mark_moments(bottom, wing, torque_unit, torque_factor)
        _close_up(top, landscape, vein)
        _shade_stops(wing, top, bottom)
        top.set_ylabel(f"tendon energy ({energy_unit})")
        bottom.set_ylabel(f"moment about the hinge,\npositive opens ({torque_unit})")
        meaning = "overbend > 0, straight 0, folding < 0"
        bottom.set_xlabel(f"distal angle (deg){':' if not is_narrow(width) else chr(10)} {meaning}")
        handles, _ = top.get_legend_handles_labels()
        simulated = [handle for handle in handles if handle.get_label().startswith("simulated")]
        curves = [handle for handle in handles if handle not in simulated]
        stops = Patch(color=_STOP, label="beyond the stops")
        handles = [*curves, stops, *simulated, *state_handles({state.kind for state in wing.states})]
        figure.legend(handles=handles, loc="outside upper center", ncols=1 if is_narrow(width) else 3)
        return describe(figure, _tell(landscape, vein))


def _curves(landscape: EnergyLandscape) -> Iterator[tuple[HingeLandscape, str, dict[str, Any]]]:
    """Hinges to draw, their names and line styles: the ideal one, and of the wing's those that differ."""
    yield landscape.hinge, "ideal hinge, bars square to its axis", {"color": ORANGE, "ls": "--", "lw": 1.4, "zorder": 3}
    groups: list[list[int]] = []
    for vein, hinge in enumerate(landscape.tendons):
        largest = float(hinge.energy.max())
        for group in groups:
            other = landscape.tendons[group[0]].energy
            if other.shape == hinge.energy.shape and np.allclose(other, hinge.energy, rtol=0, atol=_ALIKE * largest):
                group.append(vein)
                break
        else:
            groups.append([vein])
    for number, group in enumerate(groups):
        names = "all veins alike" if len(groups) == 1 else f"vein {', '.join(str(vein) for vein in group)}"
        style = {"color": _COLOURS[number % len(_COLOURS)], "ls": "-", "zorder": 2}
        yield landscape.tendons[group[0]], f"hinge of the wing, its ring crease ({names})", style


def _between(hinge: HingeLandscape, start: float, end: float) -> NDArray[np.bool_]:
    low, high = sorted((start, end))
    return np.asarray((hinge.angle >= low - 1e-12) & (hinge.angle <= high + 1e-12))


def _plot_simulation(axes: Axes, record: Record, vein: int, factor: float) -> None:
    """Points of a vein's simulated tendon, evenly spaced over its angle, folding and opening apart."""
    opening = min((end.start for end in record.stages if end.stage.drive == "unfold"), default=math.inf)
    angle = np.degrees(record.series["distal_angle"][:, vein])
    energy = factor * record.series["tendon_energy"][:, vein]
    for part, marker, colour, name, shift in (
        (record.time <= opening, "v", VERMILION, "simulated, folding", 0.0),
        (record.time > opening, "^", PURPLE, "simulated, opening", 0.5),
    ):
        rows = _spread(angle[part], shift)
        if len(rows):
            axes.plot(
                angle[part][rows],
                energy[part][rows],
                marker,
                color="white",
                mec=colour,
                mew=1.0,
                ms=4.5,
                ls="none",
                label=name,
                zorder=5,
            )


def _spread(angle: Array, shift: float) -> NDArray[np.int64]:
    """Rows at which an angle (deg) first enters each of the steps that it comes through."""
    if not len(angle):
        return np.zeros(0, dtype=np.int64)
    _, first = np.unique(np.floor(angle / _APART + shift), return_index=True)
    return np.sort(first)


def _mark_moments(axes: Axes, hinge: HingeLandscape, unit: str, factor: float) -> None:
    """Holding torque, peak torque against opening, and where the tendon goes slack."""
    axes.axhline(0, color="0.6", lw=0.5, zorder=0)
    peak, slack, limit = hinge.peak_opening, hinge.slack_angle, hinge.hinge.fold_limit
    if peak is None:
        axes.set(ylim=(-1, 1), yticks=[0])
        return
    largest, at = factor * peak.torque, math.degrees(peak.angle)
    axes.set_ylim(-1.12 * largest, max(0.42 * largest, 1.3 * factor * (hinge.holding_torque or 0)))
    axes.plot(at, -largest, "o", color=BLUE, ms=4)
    end = -math.degrees(limit if slack is None else -slack)
    words = f"peak against opening:\n{largest:.4g} {unit}\nat {show_angle(peak.angle)}"
    column = in_column(axes)
    if -end > _WIDE_BOWL * (2 if column else 1):
        axes.text(at, -0.55 * largest, words, ha="center", va="center", fontsize=7)
    else:
        axes.text(end - 3, -0.7 * largest, words, ha="left", va="center", fontsize=7)
    beside: dict[str, Any] = {"textcoords": "offset points", "ha": "left", "va": "center", "fontsize": 7}
    if hinge.holding_torque is not None:
        place = (math.degrees(hinge.hinge.overbend), factor * hinge.holding_torque)
        axes.plot(*place, "o", color=BLUE, ms=4)
        words = f"presses onto its stop: {factor * hinge.holding_torque:.4g} {unit}"
        # in a column above the words on the slack range, which begins near
        axes.annotate(words, place, xytext=(10, 12) if column else (16, 7), **beside)
    if slack is not None and -slack < limit - math.radians(0.1):
        axes.plot(math.degrees(slack), 0, "o", color=BLUE, ms=4)
        axes.annotate(f"slack beyond {show_angle(slack)}", (math.degrees(slack), 0), xytext=(4, 9), **beside)


def _close_up(axes: Axes, landscape: EnergyLandscape, vein: int) -> None:
    """The few degrees about straight, by energy above the overbend stop; a sentence where there is no barrier."""
    wing = landscape.tendons[vein]
    left, low, width, height = _INSET
    if wing.barrier is None:
        write_note(axes, (left + width / 2, low + height / 2), wing.remarks[0])
        return
    overbend = wing.hinge.overbend
    near = axes.inset_axes(_INSET)
    unit, factor = reading_unit("J", wing.barrier)
    for hinge, _, style in _curves(landscape):
        angle = np.linspace(overbend, -1.5 * overbend, 121)
        near.plot(np.degrees(angle), factor * (hinge.hinge.energy(angle) - hinge.hinge.energy(overbend)), **style)
    top = factor * max(wing.barrier, landscape.hinge.barrier or 0.0)
    near.set_ylim(-0.75 * top, 1.25 * top)
    near.set_xlim(1.12 * math.degrees(overbend), -1.5 * math.degrees(overbend))
    mark_barrier(near, 0.0, factor * wing.barrier, f"barrier {factor * wing.barrier:.4g} {unit}")
    near.set_ylabel(f"above the stop ({unit})", fontsize=7, labelpad=2)
    near.set_xlabel("distal angle (deg)", fontsize=7, labelpad=1)
    near.tick_params(labelsize=6)


def _shade_stops(hinge: HingeLandscape, *rows: Axes) -> None:
    """Grey beyond the stops."""
    stop, limit = math.degrees(hinge.hinge.overbend), -math.degrees(hinge.hinge.fold_limit)
    margin = 0.03 * (stop - limit)
    for axes in rows:
        axes.axvspan(stop, stop + margin, color=_STOP, lw=0, zorder=-1)
        axes.axvspan(limit, limit - margin, color=_STOP, lw=0, zorder=-1)
        axes.axvline(0, color="0.6", lw=0.5, ls=":", zorder=0)
        axes.set_xlim(stop + margin, limit - margin)
        axes.set_xticks([tick for tick in range(0, -181, -30) if tick >= limit])
    rows[0].set_ylim(bottom=0)
    if not hinge.hinge.pulls:
        rows[0].set(ylim=(0, 1), yticks=[0])


def _tell(landscape: EnergyLandscape, vein: int) -> str:
    """One tendon in words."""
    hinge = landscape.tendons[vein]
    told = [f"up to {show_value(float(hinge.energy.max()), 'J')} are stored"]
    if hinge.barrier is not None:
        told.append(f"the barrier from the overbend stop to straight is {show_value(hinge.barrier, 'J')}")
    if hinge.holding_torque is not None:
        told.append(f"the holding torque onto that stop {show_value(hinge.holding_torque, 'N m')}")
    states = ", ".join(show_angle(state.angle) for state in hinge.states) or "none"
    name = landscape.design.name
    return (
        f"Energy and moment of one tendon of {name} over its distal angle. In the wing {', '.join(told)};"
        f" stable states: {states}."
    )
