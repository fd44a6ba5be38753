"""What a wing stores with some of its tendons folded: independent hinges beside the coupled wing."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Patch

from forficula.quantities import reading_unit, show_value
from forficula.show.landscape.landscape_marks import write_note
from forficula.show.style import BLACK, BLUE, ORANGE, PAGE_WIDTH, describe, figure_style, is_narrow
from forficula.statics import EnergyLandscape
from forficula.statics.partial_folds import PartialFold

_NARROW = 0.03  # share of all bars' width in which no words have room
_GAP = 0.8  # between groups, in bars
_WORDS = {0: "none folded", 1: "one", 2: "two", 3: "three", 4: "four", 5: "five"}


def draw_levels(landscape: EnergyLandscape, width: float = PAGE_WIDTH) -> Figure:
    """Draw the energies of independent hinges, and of the wing let go with these hinges folded.

    Under every bar stand its veins, one above the other: filled where the hinge started folded, ringed where it came
    to rest on the other side of straight.

    Args:
        landscape: of a design.
        width: of the figure, inch.
    """
    folds = landscape.partial_folds
    veins = len(landscape.tendons)
    counts = np.array([len(fold.folded) for fold in folds])
    groups = np.unique(counts)
    places = np.arange(len(folds)) + _GAP * np.searchsorted(groups, counts)
    largest = max(float(landscape.levels.max()), *(fold.energy for fold in folds))
    unit, factor = reading_unit("J", largest)
    with figure_style():
        figure = Figure(figsize=(width, 3.1 + 0.13 * veins), layout="constrained")
        top, bottom = figure.subplots(2, 1, sharex=True, height_ratios=[2.6, 0.13 * veins + 0.1])
        _plot_bars(top, folds, places, factor)
        for group in groups:
            inside = places[counts == group]
            left, right = inside.min() - 0.6, inside.max() + 0.6
            level = factor * float(landscape.levels[group])
            top.plot([left, right], [level, level], "--", color=BLACK, lw=1.2, zorder=5)
            top.text(
                (left + right) / 2,
                1.02,
                _heading(int(group), f"{level:.3g} {unit}", narrow=right - left < _NARROW * (places[-1] - places[0])),
                transform=top.get_xaxis_transform(),
                ha="center",
                va="bottom",
                fontsize=7,
            )
        top.set_ylim(0, 1.08 * factor * largest or 1)
        if not landscape.hinge.hinge.pulls:
            write_note(top, (0.3, 0.75), landscape.hinge.remarks[0])
        top.set_ylabel(f"stored energy ({unit})")
        top.tick_params(axis="x", length=0)
        _plot_veins(bottom, folds, places, veins)
        top.set_xlim(places[0] - 1, places[-1] + 1)
        figure.legend(handles=_handles(folds), loc="outside upper center", ncols=1 if is_narrow(width) else 3)
        return describe(figure, _tell(landscape))


def _heading(count: int, level: str, *, narrow: bool) -> str:
    """How many are folded and what that many independent hinges store; a number alone where there is no room."""
    return f"{count}\n" if narrow else f"{_WORDS.get(count, str(count))}\n{level}"


def _plot_bars(axes: Axes, folds: tuple[PartialFold, ...], places: np.ndarray, factor: float) -> None:
    """Tendon energy, membrane energy on top of it, and the total as a line; grey where the state does not stay."""
    for fold, place in zip(folds, places.tolist(), strict=True):
        tendons, total = factor * fold.tendon_energy, factor * fold.energy
        hatch = None if fold.stable else "/////"
        for low, high, colour in ((0.0, tendons, BLUE), (tendons, total, ORANGE)):
            face = colour if fold.stable else "white"
            axes.bar(place, high - low, 0.7, low, color=face, edgecolor=colour, hatch=hatch, lw=0.4, alpha=0.75)
        axes.plot([place - 0.4, place + 0.4], [total, total], color=BLACK if fold.stable else "0.45", lw=1.6)


def _plot_veins(axes: Axes, folds: tuple[PartialFold, ...], places: np.ndarray, veins: int) -> None:
    """A column of dots for every state, vein by vein."""
    size = 4.5 if len(folds) <= 40 else 2.0
    for vein in range(veins):
        started = np.array([vein in fold.folded for fold in folds])
        ended = np.array([vein in fold.stays_folded for fold in folds])
        height = np.full(len(folds), float(vein))
        axes.plot(places[~started], height[~started], "o", color="0.88", ms=size, mew=0)
        axes.plot(places[started], height[started], "o", color="0.15", ms=size, mew=0)
        axes.plot(places[started != ended], height[started != ended], "o", mfc="none", mec=BLACK, mew=0.8, ms=size + 3)
    axes.set_ylim(-0.7, veins - 0.3)
    axes.set_yticks(range(veins), [f"vein {vein}" for vein in range(veins)], fontsize=6)
    axes.set_xticks([])
    axes.tick_params(length=0)
    for side in ("left", "bottom"):
        axes.spines[side].set_visible(False)
    axes.set_xlabel("hinges that start folded, the others in the overbend")


def _handles(folds: tuple[PartialFold, ...]) -> list[Line2D | Patch]:
    handles: list[Line2D | Patch] = [
        Line2D([], [], color=BLACK, ls="--", lw=1.2, label="independent ideal hinges (number above)"),
        Line2D([], [], color=BLACK, lw=1.6, label="coupled wing"),
        Patch(facecolor=BLUE, alpha=0.75, label="of it tendons"),
        Patch(facecolor=ORANGE, alpha=0.75, label="of it membrane and guards"),
    ]
    if not all(fold.stable for fold in folds):
        handles += [
            Patch(facecolor="white", edgecolor="0.45", hatch="/////", label="not stable: where it ends"),
            Line2D([], [], ls="none", marker="o", mfc="none", mec=BLACK, ms=7, label="this hinge changes sides"),
        ]
    return handles


def _tell(landscape: EnergyLandscape) -> str:
    """The levels in words."""
    folds = landscape.partial_folds
    levels = ", ".join(show_value(float(level), "J", 3) for level in landscape.levels)
    return (
        f"Energy that the wing {landscape.design.name} stores with some of its hinges folded. Of {len(folds)} ways to"
        f" fold some of {len(landscape.tendons)} hinges {sum(fold.stable for fold in folds)} are stable; independent"
        f" ideal hinges store {levels} with none to all of them folded."
    )
