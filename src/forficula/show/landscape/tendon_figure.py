"""Energy and moment of one tendon over the angle of its hinge, as in Binder et al. 2025, Figure 5."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import Patch
from matplotlib.ticker import MaxNLocator
from numpy.typing import ArrayLike

from forficula.analysis.simulated_snap import folding_rows, inner_hinge
from forficula.arrays import Array, Flags, Indices
from forficula.dynamics import Record
from forficula.errors import InputError
from forficula.quantities import reading_unit, show_value
from forficula.show.landscape.close_up import add_legend, hinge_panels, write_sentence
from forficula.show.landscape.landscape_marks import (
    hinge_measure,
    mark_barrier,
    mark_state,
    show_angle,
    state_handles,
)
from forficula.show.structure.labels import label_of, parts_of, title_of
from forficula.show.style import (
    BLACK,
    BLUE,
    GREEN,
    LINE_STYLES,
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
from forficula.statics import CrossedHinge, EnergyLandscape, HingeLandscape

_COLOURS = (BLUE, SKY, GREEN, PURPLE)
_STOP = "0.87"
_ALIKE = 1e-6  # relative difference of energies up to which two hinges share a line
_APART = 12.0  # deg, distance between two points of the simulation
_WIDE_BOWL = 75.0  # deg, width of a moment's bowl with space for words
_CROSSING = 0.15  # share of the largest moment above which another hinge's curve crosses these words
WIDEST = math.radians(60)  # largest angle from the overbend stop to the barrier that is shown enlarged
_SPRING: dict[str, Any] = {"color": ORANGE, "ls": "--", "lw": 1.2, "zorder": 2}
_BOTH: dict[str, Any] = {"color": BLACK, "ls": "-", "lw": 1.6, "zorder": 3}


def draw_tendon(
    landscape: EnergyLandscape, record: Record | None = None, width: float = PAGE_WIDTH, tendon: int | None = None
) -> Figure:
    """Draw energy and moment of one tendon over the angle of its hinge.

    If the hinge has a spring, the spring and the sum of both are drawn as well.

    Args:
        landscape: landscape of a design with a tendon across a single hinge.
        record: a run of the design that did not diverge, whose tendon is drawn on top.
        width: width of the figure, inch.
        tendon: index of the tendon; an inner one by default.

    Raises:
        InputError: no tendon lies across a single hinge.
    """
    shown = inner_hinge(landscape, tendon)
    if shown is None:
        raise InputError(f"{landscape.design.name}: no tendon lies across one hinge")
    actual, curves = shown.actual, list(tendon_curves(landscape, shown))
    energy_unit, energy_factor = reading_unit("J", max(float(energy.max()) for _, energy, _, _, _ in curves))
    torque_unit, torque_factor = reading_unit("N m", max(float(np.abs(moment).max()) for *_, moment, _, _ in curves))
    with figure_style():
        figure, top, bottom, near = hinge_panels(width, enlarged=_is_enlarged(landscape, shown))
        for hinge, energy, moment, name, style in curves:
            top.plot(_place(hinge, hinge.angle), energy_factor * energy, label=name, **style)
            bottom.plot(_place(hinge, hinge.angle), torque_factor * moment, **style)
        stored = actual.stored_energy(actual.angle)
        for state in actual.states:
            band = _between(actual, state.angle, state.far_angle)
            ends = _place(actual, actual.angle[band]), energy_factor * stored[band]
            mark_state(top, state.kind, float(_place(actual, state.angle)), energy_factor * state.energy, *ends)
        if record is not None:
            _plot_simulation(top, record, shown, energy_factor)
        others = [hinge for hinge, *_ in curves if hinge is not actual]
        _mark_moments(bottom, actual, others, torque_unit, torque_factor)
        _close_up(near, landscape, shown)
        _shade_stops(actual, top, bottom)
        title = title_of(hinge_measure(landscape.structure, shown.hinge))
        top.set_ylabel(f"{'tendon' if actual.spring is None else 'stored'} energy ({energy_unit})")
        bottom.set_ylabel(f"moment about the hinge,\npositive opens ({torque_unit})")
        overbend = landscape.structure.appearance.overbend
        meaning = f"{overbend} > 0, straight 0, folding < 0"
        if actual.sense < 0:
            meaning = f"folding > 0, straight 0, {overbend} < 0"
        bottom.set_xlabel(f"{title} (deg){':' if not is_narrow(width) else chr(10)} {meaning}")
        handles, _ = top.get_legend_handles_labels()
        simulated = [handle for handle in handles if str(handle.get_label()).startswith("simulated")]
        lines = [handle for handle in handles if handle not in simulated]
        stops = Patch(color=_STOP, label="beyond the stops")
        handles = [*lines, stops, *simulated, *state_handles({state.kind for state in actual.states})]
        add_legend(figure, handles)
        return describe(figure, _text(landscape, shown, title))


def _place(hinge: HingeLandscape, angle: ArrayLike) -> Array:
    """Convert an angle at which folding is negative (rad) to the hinge's own sense, deg."""
    return np.asarray(hinge.sense * np.degrees(angle))


def tendon_curves(
    landscape: EnergyLandscape, shown: CrossedHinge
) -> Iterator[tuple[HingeLandscape, Array, Array, str, dict[str, Any]]]:
    """Yield hinges to draw, with energy, moment, name and line style: the ideal one, and every distinct real one.

    For a hinge with a spring the tendon comes first, then the spring, then both.
    """
    if shown.ideal is not None:
        ideal_style = {"color": ORANGE, "ls": "--", "lw": 1.4, "zorder": 3}
        name = "ideal hinge, bars square to its axis"
        yield shown.ideal, shown.ideal.energy, shown.ideal.moment, name, ideal_style
    structure = landscape.structure
    labels = parts_of([label_of(structure.tendons[hinge.tendon]) for hinge in landscape.hinges])
    crease = "" if shown.ideal is None else f", its {structure.hinges[shown.hinge].role} crease"
    whose = f"hinge of the {landscape.structure.appearance.whole}{crease}" if shown.actual.spring is None else "tendon"
    for number, (group, names) in enumerate(_groups(landscape.tendons, labels.names)):
        if len(names) < len(labels.names):
            which = f"{labels.heading} {', '.join(names)}".strip()
        elif len(names) > 1:
            which = f"all {labels.heading}s" if labels.heading else ", ".join(names)
        else:
            which = f"{labels.heading} {names[0]}".strip()
        line = LINE_STYLES[number // len(_COLOURS) % len(LINE_STYLES)]
        style = {"color": _COLOURS[number % len(_COLOURS)], "ls": line, "zorder": 2}
        yield group, group.energy, group.moment, f"{whose} ({which})", style
    actual = shown.actual
    if actual.spring is not None:
        yield actual, actual.spring_energy, actual.spring_moment, "spring of the hinge", _SPRING
        yield (
            actual,
            actual.stored_energy(actual.angle),
            actual.moment + actual.spring_moment,
            "tendon and spring",
            _BOTH,
        )


def _groups(hinges: tuple[HingeLandscape, ...], names: tuple[str, ...]) -> list[tuple[HingeLandscape, list[str]]]:
    """Group hinges with equal energies; each group has its first hinge and the names of all."""
    groups: list[tuple[HingeLandscape, list[str]]] = []
    for hinge, name in zip(hinges, names, strict=True):
        largest = float(hinge.energy.max())
        for first, alike in groups:
            other = first.energy
            if other.shape == hinge.energy.shape and np.allclose(other, hinge.energy, rtol=0, atol=_ALIKE * largest):
                alike.append(name)
                break
        else:
            groups.append((hinge, [name]))
    return groups


def _between(hinge: HingeLandscape, start: float, end: float) -> Flags:
    low, high = sorted((start, end))
    return np.asarray((hinge.angle >= low - 1e-12) & (hinge.angle <= high + 1e-12))


def _plot_simulation(axes: Axes, record: Record, shown: CrossedHinge, factor: float) -> None:
    """Draw points of a simulated tendon and its hinge's spring, evenly spaced over the angle, by direction."""
    folding = folding_rows(record, shown.hinge)
    angle = np.degrees(record.series["hinge_angle"][:, shown.hinge])
    energy = factor * record.series["tendon_energy"][:, shown.tendon]
    if shown.actual.spring is not None:
        energy = energy + factor * record.series["hinge_energy"][:, shown.hinge]
    for part, marker, colour, name, shift in (
        (folding, "v", VERMILION, "simulated, folding", 0.0),
        (~folding, "^", PURPLE, "simulated, opening", 0.5),
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


def _spread(angle: Array, shift: float) -> Indices:
    """Return rows at which an angle (deg) first enters each step of a regular grid."""
    if not len(angle):
        return np.zeros(0, dtype=np.int64)
    _, first = np.unique(np.floor(angle / _APART + shift), return_index=True)
    return np.sort(first)


def _mark_moments(axes: Axes, hinge: HingeLandscape, others: list[HingeLandscape], unit: str, factor: float) -> None:
    """Mark the holding torque, the peak torque against opening, and the angle beyond which the tendon is slack."""
    axes.axhline(0, color="0.6", lw=0.5, zorder=0)
    peak, slack, limit = hinge.peak_opening, hinge.slack_angle, hinge.hinge.fold_limit
    if peak is None:
        if hinge.spring is None:
            axes.set(ylim=(-1, 1), yticks=[0])
        return
    largest, at = factor * peak.torque, float(_place(hinge, peak.angle))
    low, high = -1.12 * largest, max(0.5 * largest, 1.3 * factor * (hinge.holding_torque or 0))
    if hinge.spring is not None:
        parts = factor * np.array([hinge.moment, hinge.spring_moment, hinge.moment + hinge.spring_moment])
        low, high = min(low, 1.1 * float(parts.min())), max(high, 1.1 * float(parts.max()))
    axes.set_ylim(low, high)
    axes.plot(at, -largest, "o", color=BLUE, ms=4)
    end = -math.degrees(limit if slack is None else -slack)
    words = f"peak against opening:\n{largest:.4g} {unit}\nat {show_angle(hinge.sense * peak.angle)}"
    column = in_column(axes)
    # within its bowl, unless another hinge's curve crosses there
    folding = hinge.angle[hinge.angle < 0]
    moment = hinge.hinge.moment(folding)
    free = all(float((other.hinge.moment(folding) - moment).max()) < _CROSSING * peak.torque for other in others)
    if free and -end > _WIDE_BOWL * (1 if not column else 1.4):
        axes.text(at, -0.55 * largest, words, ha="center", va="center", fontsize=7)
    else:
        axes.text(hinge.sense * (end - 3), -0.7 * largest, words, ha="left", va="center", fontsize=7)
    beside: dict[str, Any] = {"textcoords": "offset points", "ha": "left", "va": "center", "fontsize": 7}
    if hinge.holding_torque is not None:
        place = (float(_place(hinge, hinge.hinge.overbend)), factor * hinge.holding_torque)
        axes.plot(*place, "o", color=BLUE, ms=4)
        words = f"pressed onto its stop: {factor * hinge.holding_torque:.4g} {unit}"
        # above the words on the slack range, which may begin near, and above a spring's line
        above = 9 if hinge.spring is not None else 0
        axes.annotate(words, place, xytext=(10, 15 + above), **beside)
    if slack is not None and -slack < limit - math.radians(0.1):
        place = (float(_place(hinge, slack)), 0.0)
        axes.plot(*place, "o", color=BLUE, ms=4)
        words = f"slack beyond {show_angle(hinge.sense * slack)}"
        axes.annotate(words, place, xytext=(4, 9 if hinge.spring is None else -9), **beside)


def _enlarged_curves(landscape: EnergyLandscape, shown: CrossedHinge) -> list[tuple[HingeLandscape, dict[str, Any]]]:
    """Return hinges whose barriers are enlarged, with their styles."""
    if shown.actual.spring is not None:
        return [(shown.actual, _BOTH)]
    return [(hinge, style) for hinge, _, _, _, style in tendon_curves(landscape, shown)]


def _reach(landscape: EnergyLandscape, shown: CrossedHinge) -> float:
    """Return the angle from the overbend stop to the farthest barrier, rad; the hinge has a barrier."""
    tops = [hinge.barrier_angle for hinge, _ in _enlarged_curves(landscape, shown) if hinge.barrier_angle is not None]
    return shown.actual.hinge.overbend - min(tops)


def _is_enlarged(landscape: EnergyLandscape, shown: CrossedHinge) -> bool:
    """Return whether the barrier is too close to the stop to be seen along the whole fold."""
    actual = shown.actual
    return actual.barrier is not None and actual.barrier_angle is not None and _reach(landscape, shown) <= WIDEST


def _close_up(near: Axes, landscape: EnergyLandscape, shown: CrossedHinge) -> None:
    """Draw the barrier, relative to the overbend stop; a sentence if there is no barrier, or if it is wide."""
    actual = shown.actual
    if actual.barrier is None or actual.barrier_angle is None:
        if actual.remarks:
            write_sentence(near, actual.remarks[0])
        return
    unit, factor = reading_unit("J", actual.barrier)
    if not _is_enlarged(landscape, shown):
        at = show_angle(actual.sense * actual.barrier_angle)
        write_sentence(near, f"barrier {factor * actual.barrier:.4g} {unit} at {at}")
        return
    curves, overbend, reach = _enlarged_curves(landscape, shown), actual.hinge.overbend, _reach(landscape, shown)
    last = max(overbend - 2.5 * reach, -actual.hinge.fold_limit)
    for hinge, style in curves:
        angle = np.linspace(overbend, last, 121)
        above = hinge.stored_energy(angle) - hinge.stored_energy(overbend)
        near.plot(_place(hinge, angle), factor * above, **style)
    top = factor * max(hinge.barrier or 0.0 for hinge, _ in curves)
    near.set_ylim(-0.75 * top, 1.25 * top)
    near.set_xlim(float(_place(actual, overbend + 0.12 * reach)), float(_place(actual, last)))
    place = float(_place(actual, actual.barrier_angle))
    mark_barrier(near, place, factor * actual.barrier, f"barrier {factor * actual.barrier:.4g} {unit}")
    near.set_ylabel(f"energy above the stop ({unit})")
    near.set_xlabel(f"{title_of(hinge_measure(landscape.structure, shown.hinge))} (deg)")
    near.xaxis.set_major_locator(MaxNLocator(6, steps=[1, 2, 5, 10]))


def _shade_stops(hinge: HingeLandscape, *rows: Axes) -> None:
    """Shade the range beyond the stops."""
    stop, limit = math.degrees(hinge.hinge.overbend), -math.degrees(hinge.hinge.fold_limit)
    margin, sense = 0.03 * (stop - limit), hinge.sense
    for axes in rows:
        axes.axvspan(sense * stop, sense * (stop + margin), color=_STOP, lw=0, zorder=-1)
        axes.axvspan(sense * limit, sense * (limit - margin), color=_STOP, lw=0, zorder=-1)
        axes.axvline(0, color="0.6", lw=0.5, ls=":", zorder=0)
        axes.set_xlim(sense * (stop + margin), sense * (limit - margin))
        axes.set_xticks([sense * tick for tick in range(180, -181, -30) if limit <= tick <= max(stop, 0.0)])
    rows[0].set_ylim(bottom=0)
    if not hinge.hinge.pulls and hinge.spring is None:
        rows[0].set(ylim=(0, 1), yticks=[0])


def _text(landscape: EnergyLandscape, shown: CrossedHinge, title: str) -> str:
    """Describe the energy of one tendon."""
    hinge, sprung = shown.actual, shown.actual.spring is not None
    facts = [f"it stores up to {show_value(float(hinge.stored_energy(hinge.angle).max()), 'J')}"]
    if hinge.barrier is not None and hinge.barrier_angle is not None:
        at = show_angle(hinge.sense * hinge.barrier_angle) if hinge.barrier_angle else "straight"
        start = f"the {landscape.structure.appearance.overbend} stop"
        if sprung:
            start = show_angle(hinge.sense * hinge.states[0].angle)
        facts.append(f"the barrier from {start} to {at} is {show_value(hinge.barrier, 'J')}")
    if hinge.holding_torque is not None:
        facts.append(f"the holding torque onto that stop is {show_value(hinge.holding_torque, 'N m')}")
    states = ", ".join(show_angle(hinge.sense * state.angle) for state in hinge.states) or "none"
    name, whole = landscape.design.name, landscape.structure.appearance.whole
    with_spring = " and of the spring of its hinge" * sprung
    return (
        f"Energy and moment of one tendon of {name}{with_spring} over its {title}. In the {whole} {', '.join(facts)};"
        f" stable states: {states}."
    )
