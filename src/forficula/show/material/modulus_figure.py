"""Moduli by class of strain as box plots (Binder et al. 2025, Figure 9)."""

from __future__ import annotations

import math
import textwrap
from typing import Any, Literal

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import Patch
from matplotlib.ticker import FuncFormatter

from forficula.material.characterisation import AREA, LENGTH, Characterisation
from forficula.material.tensile.modulus import ModulusClass
from forficula.quantities import show_quantity
from forficula.show.style import (
    BLACK,
    BLUE,
    PAGE_WIDTH,
    VERMILION,
    describe,
    figure_style,
    fit_legend,
    in_column,
    is_narrow,
    letter_panels,
)

Kind = Literal["secant_modulus", "local_modulus"]

_LOOKS = {"loading": ("#BBDDF2", BLUE, ""), "unloading": ("#FBE3D3", VERMILION, "/////")}
_BAND = "#DDF1EA"
_BAND_INK = "#00604A"
_NAMES: dict[Kind, str] = {
    "secant_modulus": "secant modulus,\nstress / strain (MPa)",
    "local_modulus": "local modulus,\nd stress / d strain (MPa)",
}
_MPA = 1e6
# ratio of moduli up to which the scale is linear, and its least span, as a share of the largest modulus
_DECADE, _LEAST_SPAN = 10.0, 0.1
_COLUMN_LINE = 54  # letters per line in a column
_GAP = 0.2  # distance of the two boxes from the centre of their class, in classes


def draw_moduli(material: Characterisation, width: float = PAGE_WIDTH) -> Figure:
    """Draw secant and local moduli by class of strain, loading beside unloading, with the moduli required for folding.

    Args:
        material: material with its moduli.
        width: width of the figure, inch.
    """
    with figure_style():
        figure = Figure(figsize=(width, 5.2), layout="constrained")
        panels = figure.subplots(2, 1, sharex=True, sharey=True)
        kinds: tuple[Kind, Kind] = ("secant_modulus", "local_modulus")
        for axes, kind in zip(panels, kinds, strict=True):
            _draw_band(axes, material)
            for branch in _LOOKS:
                _draw_boxes(axes, material, branch, kind)
            axes.set_ylabel(_NAMES[kind])
            axes.axhline(0, color="0.6", lw=0.5, zorder=1)
        _scale(panels[0], material)
        for axes in panels:
            _note_band(axes, material)
        letter_panels(list(panels))
        _classes(panels[1], material)
        panels[0].tick_params(axis="x", length=0)
        panels[1].set_xlabel("engineering strain, in classes (%)")
        _legend(figure, material)
        return describe(figure, _text(material))


def _place(low: float, high: float) -> float:
    """Return the position of a class; classes are one apart, whatever their width."""
    return (low + high) / 2 / (high - low)


def _draw_band(axes: Axes, material: Characterisation) -> None:
    low, high = (modulus / _MPA for modulus in material.simulated_moduli)
    axes.axhspan(low, high, color=_BAND, zorder=0, lw=0)


def _draw_boxes(axes: Axes, material: Characterisation, branch: str, kind: Kind) -> None:
    """Draw one box for each class: quartiles and median over specimens and cycles, whiskers to the extremes."""
    face, edge, hatch = _LOOKS[branch]
    side = -_GAP if branch == "loading" else _GAP
    boxes, places = [], []
    for entry in (item for item in material.pooled if item.way == branch):
        values = _single_values(material, entry, kind)
        quartiles = getattr(entry, kind)
        boxes.append(
            {
                "q1": quartiles.lower / _MPA,
                "med": quartiles.median / _MPA,
                "q3": quartiles.upper / _MPA,
                "whislo": float(values.min()) / _MPA,
                "whishi": float(values.max()) / _MPA,
            }
        )
        places.append(_place(entry.from_strain, entry.to_strain) + side)
    thin: dict[str, Any] = {"color": edge, "lw": 0.8}
    axes.bxp(
        boxes,
        positions=places,
        widths=0.32,
        showfliers=False,
        patch_artist=True,
        manage_ticks=False,
        boxprops={"facecolor": face, "edgecolor": edge, "lw": 0.8, "hatch": hatch},
        medianprops={"color": BLACK, "lw": 1.1},
        whiskerprops=thin,
        capprops=thin,
    )


def _single_values(material: Characterisation, entry: ModulusClass, kind: Kind) -> Any:
    """Return the single values of an entry, Pa, shape (value,)."""
    same = [item for item in material.single if (item.way, item.from_strain) == (entry.way, entry.from_strain)]
    return np.array([getattr(item, kind).median for item in same])


def _straight(material: Characterisation) -> float | None:
    """Return the modulus, MPa, below which a logarithmic scale is linear; None if the moduli fit on a linear scale.

    It is the decade below the largest secant modulus. Moduli near 0 are those of slack specimens.
    """
    values = [getattr(item, kind).median for item in material.single for kind in _NAMES]
    if min(values) > 0 and max(values) <= _DECADE * min(values):
        return None
    largest = max(item.secant_modulus.upper for item in material.pooled) / _MPA
    return float(10.0 ** math.floor(math.log10(largest / 2)))


def _scale(axes: Axes, material: Characterisation) -> None:
    """Set a linear scale over the moduli, or a logarithmic one over their decades that is linear about 0."""
    values = [getattr(item, kind).median / _MPA for item in material.single for kind in _NAMES]
    straight = _straight(material)
    if straight is None:
        low, high = min(values), max(values)
        room = max(high - low, _LEAST_SPAN * high) - (high - low)
        low, high = low - room / 2, high + room / 2
        axes.set_ylim(low - 0.08 * (high - low), high + 0.16 * (high - low))
        return
    low, high = min(values), max(*values, material.simulated_moduli[1] / _MPA)
    axes.set_yscale("symlog", linthresh=straight, linscale=0.8, subs=range(2, 10))
    axes.yaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}".replace("-", "−")))
    axes.set_ylim(min(1.15 * low, -0.15 * straight), 1.6 * high)


def _note_band(axes: Axes, material: Characterisation) -> None:
    """Say where the required moduli are if they are beyond the axis."""
    low, high = (modulus / _MPA for modulus in material.simulated_moduli)
    bottom, top = axes.get_ylim()
    words = (
        f"↑ required from {low:.3g} MPa" if low > top else f"↓ required up to {high:.3g} MPa" if high < bottom else ""
    )
    if words:
        above = low > top
        place, side = (0.98, "top") if above else (0.02, "bottom")
        look: dict[str, Any] = {"color": _BAND_INK, "fontsize": 7, "bbox": {"fc": "white", "ec": "none", "pad": 1}}
        axes.text(0.995, place, words, transform=axes.transAxes, ha="right", va=side, **look)


def _classes(axes: Axes, material: Characterisation) -> None:
    """Label the classes and draw lines between them."""
    classes = sorted({(item.from_strain, item.to_strain) for item in material.pooled})
    places = [_place(low, high) for low, high in classes]
    axes.set_xticks(places, [f"{100 * low:g}–{100 * high:g}" for low, high in classes])
    if in_column(axes):
        axes.tick_params(axis="x", rotation=90)
    axes.set_xlim(places[0] - 0.5, places[-1] + 0.5)
    for axis in axes.figure.axes:
        for place in places[1:]:
            axis.axvline(place - 0.5, color="0.88", lw=0.6, zorder=0.5)


def _legend(figure: Figure, material: Characterisation) -> None:
    sizes = [(specimen.test.length, specimen.test.area) for specimen in material.specimens]
    length, area = (float(np.median(values)) for values in zip(*sizes, strict=True))
    low, high = (modulus / _MPA for modulus in material.simulated_moduli)
    size = f"{show_quantity(length, LENGTH)} and {show_quantity(area, AREA).replace('^2', '²')}"
    handles = [
        Patch(facecolor=face, edgecolor=edge, hatch=hatch, lw=0.8, label=branch)
        for branch, (face, edge, hatch) in _LOOKS.items()
    ]
    band = f"{low:.3g} to {high:.3g} MPa, required for 10 to 60 N/cm at {size}"
    handles.append(Patch(facecolor=_BAND, edgecolor=_BAND_INK, lw=0.4, label=band))
    count = max(item.values for item in material.pooled)
    what = f"box: quartiles, line: median, whiskers: extremes of up to {count} values, one per specimen and cycle"
    straight = _straight(material)
    note = what if straight is None else f"{what}; linear scale below {straight:g} MPa"
    narrow = is_narrow(figure.get_figwidth())
    if narrow:
        note = textwrap.fill(note, _COLUMN_LINE)
    fit_legend(figure, handles, 3, loc="outside upper center", title=note, title_fontsize=7)


def _text(material: Characterisation) -> str:
    """Describe the secant moduli."""
    medians_by_branch = []
    for branch in _LOOKS:
        medians = [item.secant_modulus.median / _MPA for item in material.pooled if item.way == branch]
        medians_by_branch.append(f"when {branch} {min(medians):.3g} to {max(medians):.3g} MPa")
    low, high = (modulus / _MPA for modulus in material.simulated_moduli)
    return (
        f"Moduli of {material.name} by class of strain. Median secant moduli {' and '.join(medians_by_branch)};"
        f" tendons of 10 to 60 N/cm require {low:.3g} to {high:.3g} MPa."
    )
