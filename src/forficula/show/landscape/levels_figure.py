"""Energies of a structure with some of its hinges folded, compared with independent hinges."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Patch

from forficula.quantities import reading_unit, show_value
from forficula.show.landscape.landscape_marks import energy_storing_parts, sheet_parts, write_note
from forficula.show.structure.labels import label_of
from forficula.show.style import BLACK, BLUE, ORANGE, PAGE_WIDTH, describe, figure_style, fit_legend
from forficula.statics import EnergyLandscape, PartialFold, folding_hinges

_NARROW = 0.03  # share of the width below which a group has no space for words
_ALIKE = 1e-9  # relative difference up to which energies count as equal
_GAP = 0.8  # gap between groups, in bars
_WORDS = {0: "none folded", 1: "one", 2: "two", 3: "three", 4: "four", 5: "five"}


def draw_levels(landscape: EnergyLandscape, width: float = PAGE_WIDTH) -> Figure:
    """Draw the energies of independent hinges, and of the structure released with these hinges folded.

    The dots below each bar are its hinges: filled if the hinge started folded, ringed if it came to rest on the other
    side of straight. Independent hinges are left out if their energies do not add up.

    Args:
        landscape: landscape of a design with hinges that fold.
        width: width of the figure, inch.
    """
    folds = landscape.partial_folds
    hinges = [label_of(landscape.structure.hinges[hinge]) for hinge in folding_hinges(landscape.structure)]
    counts = np.array([len(fold.folded) for fold in folds])
    groups = np.unique(counts)
    places = np.arange(len(folds)) + _GAP * np.searchsorted(groups, counts)
    alone = [fold.independent_energy for fold in folds]
    known = [energy for energy in alone if energy is not None]
    levels = {int(group): _level(landscape, int(group)) for group in groups}
    largest = max(*known, *(fold.energy for fold in folds))
    unit, factor = reading_unit("J", largest)
    with figure_style():
        figure = Figure(figsize=(width, 3.1 + 0.13 * len(hinges)), layout="constrained")
        top, bottom = figure.subplots(2, 1, sharex=True, height_ratios=[2.6, 0.13 * len(hinges) + 0.1])
        _plot_bars(top, folds, places, factor)
        for group, level in levels.items():
            inside = places[counts == group]
            left, right = inside.min() - 0.6, inside.max() + 0.6
            if level is not None:
                top.plot([left, right], [factor * level, factor * level], "--", color=BLACK, lw=1.2, zorder=5)
            narrow = right - left < _NARROW * (places[-1] - places[0])
            words = None if level is None or None in levels.values() else f"{factor * level:.3g} {unit}"
            top.text(
                (left + right) / 2,
                1.02,
                _heading(group, words, narrow=narrow),
                transform=top.get_xaxis_transform(),
                ha="center",
                va="bottom",
                fontsize=7,
            )
        for energy, count, place in zip(alone, counts.tolist(), places.tolist(), strict=True):
            if energy is not None and levels[count] is None:
                ends = [place - 0.5, place + 0.5]
                top.plot(ends, [factor * energy, factor * energy], "--", color=BLACK, lw=1.2, zorder=5)
        lowest = min(0.0, *(min(fold.energy, fold.tendon_energy) for fold in folds))
        top.set_ylim(1.08 * factor * lowest, 1.08 * factor * largest or 1)
        if landscape.hinge is not None and not any(hinge.hinge.pulls for hinge in landscape.tendons):
            write_note(top, (0.3, 0.75), landscape.hinge.remarks[0])
        top.set_ylabel(f"stored energy ({unit})")
        top.tick_params(axis="x", length=0)
        _plot_hinges(bottom, folds, places, hinges)
        overbend = landscape.structure.appearance.overbend
        bottom.set_xlabel(f"hinges that start folded (dark) or in the {overbend}")
        top.set_xlim(places[0] - 1, places[-1] + 1)
        fit_legend(figure, _handles(landscape), 3, loc="outside upper center")
        return describe(figure, _text(landscape))


def _level(landscape: EnergyLandscape, count: int) -> float | None:
    """Return the energy of independent hinges with a number of them folded, J; None if it depends on which ones."""
    group = [fold for fold in landscape.partial_folds if len(fold.folded) == count]
    energies = [fold.independent_energy for fold in group if fold.independent_energy is not None]
    if landscape.levels is None or not np.allclose(energies, energies[0], rtol=_ALIKE, atol=0):
        return None
    return float(landscape.levels[count])


def _heading(count: int, level: str | None, *, narrow: bool) -> str:
    """Return the number of folded hinges and the energy of as many independent ones; only the number if narrow."""
    words = str(count) if narrow else _WORDS.get(count, str(count))
    return f"{words}\n" if narrow or level is None else f"{words}\n{level}"


def _plot_bars(axes: Axes, folds: tuple[PartialFold, ...], places: np.ndarray, factor: float) -> None:
    """Draw tendon energy, membrane energy on top of it, and the total as a line; hatched if the state is not stable."""
    for fold, place in zip(folds, places.tolist(), strict=True):
        tendons, total = factor * fold.tendon_energy, factor * fold.energy
        hatch = None if fold.stable else "/////"
        for low, high, colour in ((0.0, tendons, BLUE), (tendons, total, ORANGE)):
            face = colour if fold.stable else "white"
            axes.bar(place, high - low, 0.7, low, color=face, edgecolor=colour, hatch=hatch, lw=0.4, alpha=0.75)
        axes.plot([place - 0.4, place + 0.4], [total, total], color=BLACK if fold.stable else "0.45", lw=1.6)


def _plot_hinges(axes: Axes, folds: tuple[PartialFold, ...], places: np.ndarray, names: list[str]) -> None:
    """Draw a column of dots for every state, one row for each hinge."""
    size = 4.5 if len(folds) <= 40 else 2.0
    for hinge in range(len(names)):
        started = np.array([hinge in fold.folded for fold in folds])
        ended = np.array([hinge in fold.stays_folded for fold in folds])
        height = np.full(len(folds), float(hinge))
        axes.plot(places[~started], height[~started], "o", color="0.88", ms=size, mew=0)
        axes.plot(places[started], height[started], "o", color="0.15", ms=size, mew=0)
        axes.plot(places[started != ended], height[started != ended], "o", mfc="none", mec=BLACK, mew=0.8, ms=size + 3)
    axes.set_ylim(-0.7, len(names) - 0.3)
    axes.set_yticks(range(len(names)), names, fontsize=6)
    axes.set_xticks([])
    axes.tick_params(length=0)
    for side in ("left", "bottom"):
        axes.spines[side].set_visible(False)


def _handles(landscape: EnergyLandscape) -> list[Line2D | Patch]:
    folds, whole = landscape.partial_folds, landscape.structure.appearance.whole
    stretched = sheet_parts(landscape.structure)
    compared = landscape.levels is not None
    handles: list[Line2D | Patch] = []
    if compared:
        numbered = " (number above)" * all(_level(landscape, len(fold.folded)) is not None for fold in folds)
        handles.append(Line2D([], [], color=BLACK, ls="--", lw=1.2, label=f"{_independent(landscape)}{numbered}"))
    handles.append(Line2D([], [], color=BLACK, lw=1.6, label=f"coupled {whole}" if compared else whole))
    handles.append(Patch(facecolor=BLUE, alpha=0.75, label=f"share of {energy_storing_parts(landscape.structure)}"))
    if stretched:
        handles.append(Patch(facecolor=ORANGE, alpha=0.75, label=f"share of {stretched}"))
    if not all(fold.stable for fold in folds):
        handles += [
            Patch(facecolor="white", edgecolor="0.45", hatch="/////", label="not stable: energy at the end"),
            Line2D([], [], ls="none", marker="o", mfc="none", mec=BLACK, ms=7, label="this hinge changes sides"),
        ]
    return handles


def _independent(landscape: EnergyLandscape) -> str:
    return f"independent {'ideal ' * (landscape.hinge is not None)}hinges"


def _text(landscape: EnergyLandscape) -> str:
    """Describe the levels."""
    folds, whole = landscape.partial_folds, landscape.structure.appearance.whole
    intro = (
        f"Energy of the {whole} {landscape.design.name} with some of its hinges folded. Of {len(folds)} combinations"
        f" of {len(folds[0].angles)} hinges {sum(fold.stable for fold in folds)} are stable"
    )
    if landscape.levels is None:
        ends = [show_value(end(fold.energy for fold in folds), "J", 3) for end in (min, max)]
        return f"{intro}; they store from {ends[0]} to {ends[1]}."
    levels = ", ".join(show_value(float(level), "J", 3) for level in landscape.levels)
    return f"{intro}; {_independent(landscape)} store {levels} with none to all of them folded."
