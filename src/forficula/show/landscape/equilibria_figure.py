"""Equilibria of a structure: stored energy by part, angles, and the torques that lead from one state to the next."""

from __future__ import annotations

import textwrap

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Patch
from matplotlib.ticker import MaxNLocator

from forficula.arrays import Array
from forficula.quantities import reading_unit, show_value
from forficula.show.landscape.landscape_marks import (
    least_text,
    rest_name,
    sheet_parts,
    show_angles,
    torque_location,
)
from forficula.show.structure.labels import measure_labels, parts_of, shown_angles, title_of
from forficula.show.style import (
    BLACK,
    BLUE,
    GREEN,
    ORANGE,
    PAGE_WIDTH,
    PURPLE,
    SKY,
    VERMILION,
    describe,
    figure_style,
    fit_legend,
    letter_panels,
)
from forficula.statics import EnergyLandscape, Rest
from forficula.statics.landscape import LeastTorque
from forficula.structure import Measure, read_angles

_COLOURS = {
    "tendons": BLUE,
    "springs": GREEN,
    "creases": BLACK,
    "openings": VERMILION,
    "bars": VERMILION,
    "couplings": SKY,
    "closures": "0.6",
    "membranes": ORANGE,
    "weight": PURPLE,
}
_MARKS = (("o", BLUE), ("s", VERMILION), ("^", GREEN), ("D", PURPLE), ("v", SKY))
_WIDTH = 0.62  # width of a bar
_HELD = "0.75"  # colour of the angles at which dry friction holds a hinge
_NAMED = 6  # largest number of hinges that are named below their angles
_NAME, _LINE = 14, 90  # letters of a line of a transition's name, and of the label below
_LEAST_SPAN = 1.0  # deg, least span of the axis of angles: smaller differences are rounding errors


def draw_equilibria(landscape: EnergyLandscape, width: float = PAGE_WIDTH) -> Figure:
    """Draw the equilibria of a structure in the order of its protocol: stored energy above, angles below.

    The arrow from one state to the next has the least slowly growing torque or force that makes this transition.

    Args:
        landscape: landscape of a design.
        width: width of the figure, inch.
    """
    rests, structure = landscape.rests, landscape.structure
    largest = max(max(abs(rest.energy), *map(abs, rest.stored.values()), 0.0) for rest in rests)
    unit, factor = reading_unit("J", largest)
    measures = shown_angles(structure)
    with figure_style():
        figure = Figure(figsize=(width, 4.2), layout="constrained")
        top, bottom = figure.subplots(2, 1, sharex=True, height_ratios=[1.6, 1])
        for place, rest in enumerate(rests):
            _plot_bar(top, place, rest, factor)
        _mark_steps(top, landscape)
        low, high = top.get_ylim() if largest else (0.0, 1.0)
        top.set_ylim(low if low < 0 else 0.0, high if high > 0 else 1.0)
        top.set_ylabel(f"stored energy ({unit})")
        top.tick_params(axis="x", length=0)
        _plot_angles(bottom, landscape, measures)
        bottom.set_xticks(range(len(rests)), [rest_name(rest, "\n") for rest in rests])
        bottom.set_xlim(-0.6, len(rests) - 0.4)
        bottom.set_ylabel(f"{title_of(measures[0]) if len(measures) == 1 else 'angle'} (deg)")
        bottom.set_xlabel(_order(landscape, measures))
        letter_panels([top, bottom])
        fit_legend(figure, _handles(landscape, measures), 4, loc="outside upper center")
        return describe(figure, _text(landscape, measures))


def _plot_bar(axes: Axes, place: int, rest: Rest, factor: float) -> None:
    """Draw stacked energies, negative ones downwards, and their sum as a line; hatched if the state is not stable."""
    up = down = 0.0
    hatch = None if rest.stable else "/////"
    for part, energy in rest.stored.items():
        height, colour = factor * energy, _COLOURS[part]
        base = up if height >= 0 else down
        face = colour if rest.stable else "white"
        axes.bar(place, height, _WIDTH, base, color=face, edgecolor=colour, hatch=hatch, lw=0.4, alpha=0.75)
        up, down = up + max(height, 0.0), down + min(height, 0.0)
    total = factor * rest.energy
    axes.plot([place - 0.36, place + 0.36], [total, total], color=BLACK if rest.stable else "0.45", lw=1.6)
    axes.annotate(
        f"{total:.3g}", (place, up), xytext=(0, 3), textcoords="offset points", ha="center", va="bottom", fontsize=7
    )


def _mark_steps(axes: Axes, landscape: EnergyLandscape) -> None:
    """Draw an arrow for every transition to a drawn state, with its name and the least slow torque or force."""
    over = axes.get_xaxis_transform()
    courses = {course.name: course for course in landscape.courses if isinstance(course, LeastTorque)}
    # the effects of further transitions are not known
    for place, transition in enumerate(landscape.structure.transitions[: len(landscape.rests) - 1]):
        ends = (place + 0.22, 1.05), (place + 0.78, 1.05)
        axes.annotate("", ends[1], ends[0], xycoords=over, textcoords=over, arrowprops={"arrowstyle": "->", "lw": 0.8})
        least = least_text(landscape, courses[transition.name], 3)
        words = "\n".join((*textwrap.wrap(transition.name, _NAME), *textwrap.wrap(least, _NAME)))
        axes.text(place + 0.5, 1.08, words, transform=over, ha="center", va="bottom", fontsize=7)


def _plot_angles(axes: Axes, landscape: EnergyLandscape, measures: tuple[Measure, ...]) -> None:
    """Draw the angles of the hinges, side by side in the order of their measures, and where dry friction holds them."""
    rests = landscape.rests
    count = sum(len(measure.parts) for measure in measures)
    shifts = iter(np.linspace(-_WIDTH / 2, _WIDTH / 2, count + 2)[1:-1].tolist())
    axes.axhline(0, color="0.6", lw=0.5, ls=":", zorder=0)
    for number, measure in enumerate(measures):
        mark, colour = _MARKS[number % len(_MARKS)]
        bands = np.degrees([_friction_band(landscape, measure, rest) for rest in rests]).transpose(2, 0, 1)
        for angles, ends in zip(
            np.degrees([read_angles(measure, rest.angles) for rest in rests]).T, bands, strict=True
        ):
            shift = next(shifts)
            places = [place + shift for place in range(len(rests))]
            axes.vlines(places, *ends.T, color=_HELD, lw=4, zorder=1)
            axes.plot(places, angles, mark, color=colour, ms=4, ls="none", clip_on=False)
    axes.margins(y=0.15)
    low, high = axes.get_ylim()
    short = max(_LEAST_SPAN - (high - low), 0.0) / 2
    axes.set_ylim(low - short, high + short)
    axes.yaxis.set_major_locator(MaxNLocator(4, steps=[1, 1.5, 2, 3, 4.5, 5, 9, 10]))


def _friction_band(landscape: EnergyLandscape, measure: Measure, rest: Rest) -> Array:
    """Return the ends of the readings of a measure at which dry friction holds its hinges, rad, (end, reading)."""
    numbers = {hinge.name: number for number, hinge in enumerate(landscape.structure.hinges)}
    ends = np.repeat(np.asarray(rest.angles)[None], 2, axis=0)
    # a sum of several angles has no band, because a band is that of one hinge
    for band in landscape.friction_bands if measure.together == 1 else ():
        if band.state == rest.name:
            ends[:, numbers[band.hinge]] = band.lower, band.upper
    return read_angles(measure, ends)


def _order(landscape: EnergyLandscape, measures: tuple[Measure, ...]) -> str:
    """Return the order of the hinges, and where the torques act."""
    labels = [label for measure in measures for label in measure_labels(landscape.structure, measure)]
    named = parts_of(labels)
    on = dict.fromkeys(
        torque_location(landscape.structure, transition)
        for transition in landscape.structure.transitions[: len(landscape.rests) - 1]
    )
    units = {course.unit for course in landscape.courses if isinstance(course, LeastTorque)}
    torques = f"the {'drives' if 'N' in units else 'torques'} above act {', '.join(on)}" if on else ""
    if not 1 < len(labels) <= _NAMED:
        return textwrap.fill(torques, _LINE)
    order = " ".join(filter(None, ("from left to right", named.heading, ", ".join(named.names))))
    return ";\n".join(textwrap.fill(part, _LINE) for part in (order, torques) if part)


def _handles(landscape: EnergyLandscape, measures: tuple[Measure, ...]) -> list[Line2D | Patch]:
    stored = dict.fromkeys(part for rest in landscape.rests for part in rest.stored)
    names = {"membranes": sheet_parts(landscape.structure)}
    handles: list[Line2D | Patch] = [
        Patch(facecolor=_COLOURS[part], alpha=0.75, label=names.get(part, part)) for part in stored
    ]
    handles.append(Line2D([], [], color=BLACK, lw=1.6, label="sum (number)"))
    if not all(rest.stable for rest in landscape.rests):
        handles.append(Patch(facecolor="white", edgecolor="0.45", hatch="/////", label="not stable"))
    if landscape.friction_bands:
        handles.append(Line2D([], [], color=_HELD, lw=4, label="held by dry friction"))
    if len(measures) > 1:
        handles += [
            Line2D([], [], ls="none", marker=mark, color=colour, ms=4, label=title_of(measure))
            for measure, (mark, colour) in zip(measures, _MARKS, strict=False)
        ]
    return handles


def _text(landscape: EnergyLandscape, measures: tuple[Measure, ...]) -> str:
    """Describe the states and the transitions."""
    whole, name = landscape.structure.appearance.whole, landscape.design.name
    states = [
        f"{rest_name(rest)}{'' if rest.stable else ' (not stable)'} with {show_value(rest.energy, 'J', 3)}"
        f" at {', '.join(f'{title_of(measure)} {show_angles(measure, rest.angles)}' for measure in measures)}"
        for rest in landscape.rests
    ]
    steps = [
        f"{course.name} {least_text(landscape, course, 3)}"
        for course in landscape.courses
        if isinstance(course, LeastTorque)
    ]
    least = f" Least slowly growing drives: {', '.join(steps)}." if steps else ""
    return f"Energy and angles of the equilibria of the {whole} {name}. States: {'; '.join(states)}.{least}"
