"""A sheet to cut: material, cut lines and size."""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Circle, Patch, PathPatch, Polygon
from matplotlib.path import Path

from forficula.make.flat.cut_lines import CutSheet, Layer, layer_texts
from forficula.quantities import round_below
from forficula.show.style import (
    BLACK,
    BLUE,
    PAGE_WIDTH,
    PURPLE,
    VERMILION,
    describe,
    figure_style,
    fit_legend,
    number_handle,
)

_MILLIMETRES = 1e3
_STYLES: dict[Layer, tuple[str, str]] = {
    "cut": (BLACK, "-"),
    "score": (PURPLE, ":"),
    "mountain": (VERMILION, "-."),
    "valley": (BLUE, "--"),
    "mark": ("0.4", "-"),
}
_PAPER = "#efe9dc"
_FAULT = "////"
_TALLEST = 1.2  # largest height of the sheet, as a multiple of the figure's width
_ROOM = 1.15  # inch above and below the sheet
_BESIDE = 0.6  # inch left of it
_THIN, _MANY = 0.5, 300  # width of lines in points if there are more slits than this
_CUT, _LINE = 0.9, 1.1  # points
_APART = 0.045  # distance of dimensions from the sheet, as a share of its size


def draw_cut_sheet(sheet: CutSheet, width: float = PAGE_WIDTH) -> Figure:
    """Draw a cut sheet with its layers, its size and a scale bar; `width` is the largest width, inch."""
    size = _MILLIMETRES * sheet.size
    scale = min((width - _BESIDE) / size[0], _TALLEST * width / size[1])
    with figure_style():
        figure = Figure(figsize=(width, scale * size[1] + _ROOM), layout="constrained")
        axes = figure.subplots()
        axes.set_aspect("equal")
        axes.set_axis_off()
        _fill(axes, sheet)
        _draw_lines(axes, sheet)
        _draw_sizes(axes, sheet)
        axes.autoscale_view()
        _draw_faults(axes, sheet)
        figure.suptitle(f"{sheet.name}: sheet to cut", fontsize=8)
        fit_legend(figure, _handles(sheet), 5, loc="outside lower center")
        return describe(figure, _text(sheet))


def _fill(axes: Axes, sheet: CutSheet) -> None:
    """Draw the material that remains, in its nominal size."""
    loops = [_MILLIMETRES * np.vstack([outline, outline[:1]]) for outline in sheet.outlines]
    codes = [[Path.MOVETO, *[Path.LINETO] * (len(loop) - 2), Path.CLOSEPOLY] for loop in loops]
    whole = Path(np.concatenate(loops), np.concatenate(codes))
    axes.add_patch(PathPatch(whole, fc=_PAPER, ec="none"))
    for hole in sheet.holes:
        axes.add_patch(Circle(tuple(_MILLIMETRES * hole.place), _MILLIMETRES * hole.nominal / 2, fc="white", ec="none"))


def _draw_lines(axes: Axes, sheet: CutSheet) -> None:
    """Draw the cutter's paths in the colours of their layers; slits are solid, because they are cut."""
    thin = sum(line.kind == "slit" for line in sheet.lines) > _MANY
    for line in sheet.lines:
        colour, style = _STYLES[line.layer]
        points = _MILLIMETRES * (np.vstack([line.points, line.points[:1]]) if line.closed else line.points)
        dashes = style if line.kind == "crease" else "-"
        width = _CUT if line.layer == "cut" else _THIN if thin else _LINE
        axes.plot(*points.T, dashes, color=colour, lw=width, solid_capstyle="butt")
    for hole in sheet.holes:
        radius = _MILLIMETRES * hole.diameter / 2
        axes.add_patch(Circle(tuple(_MILLIMETRES * hole.place), radius, fc="none", ec=BLACK, lw=_CUT))
    for label in sheet.labels:
        place = _MILLIMETRES * label.place
        axes.text(place[0], place[1], label.text, color=_STYLES["mark"][0], fontsize=6, ha="center", va="center")


def _draw_faults(axes: Axes, sheet: CutSheet) -> None:
    """Draw the causes of failed checks, hatched above everything else."""
    for outline in sheet.faults:
        axes.add_patch(Polygon(_MILLIMETRES * outline, fc="none", ec=VERMILION, hatch=_FAULT, lw=1.2, zorder=5))


def _draw_sizes(axes: Axes, sheet: CutSheet) -> None:
    """Arrows along the sheet's width and height, and a scale bar below them."""
    points = _MILLIMETRES * np.concatenate(sheet.outlines)
    (left, low), (right, high) = points.min(axis=0), points.max(axis=0)
    apart = _APART * max(right - left, high - low)
    arrow = {"arrowstyle": "<|-|>", "lw": 0.6, "color": "0.3", "shrinkA": 0, "shrinkB": 0, "mutation_scale": 7}
    below, beside = low - apart, left - apart
    for start, end in (((left, below), (right, below)), ((beside, low), (beside, high))):
        axes.annotate("", start, end, arrowprops=arrow)
        axes.plot(*np.array([start, end]).T, color="none")
    text: dict[str, Any] = {"fontsize": 7, "color": "0.2", "bbox": {"fc": "white", "ec": "none", "pad": 1.0}}
    axes.text((left + right) / 2, below, f"{right - left:.1f} mm", ha="center", va="center", **text)
    axes.text(beside, (low + high) / 2, f"{high - low:.1f} mm", ha="center", va="center", rotation=90, **text)
    bar = round_below((right - left) / 4)
    foot = below - 1.5 * apart
    axes.plot([left, left + bar], [foot, foot], color=BLACK, lw=2, solid_capstyle="butt")
    axes.text(left + bar + apart / 2, foot, f"{bar:g} mm", fontsize=7, va="center")


def _handles(sheet: CutSheet) -> list[Line2D | Patch]:
    """Return the legend's entries."""
    names: dict[Layer, str] = {
        "cut": "cut through",
        "mountain": "mountain",
        "valley": "valley",
        "mark": "join edges with the same number",
    }
    method = {"score": "scored", "perforation": "cut as dashes", "lattice": "cut as slits"}[sheet.style]
    handles: list[Line2D | Patch] = [Patch(fc=_PAPER, label="sheet")]
    for layer in layer_texts(sheet):
        colour, style = _STYLES[layer]
        if layer == "mark" and sheet.labels:
            handles.append(number_handle(1, names[layer], colour))
            continue
        folds = layer in ("mountain", "valley")
        if layer == "mark":
            handles.append(Line2D([], [], color=colour, lw=_LINE, label="end of the membrane"))
            continue
        label = "scored" if layer == "score" else names[layer] + (f", {method}" if folds else "")
        dashes = style if sheet.style == "score" or layer == "score" else "-"
        handles.append(Line2D([], [], color=colour, ls=dashes, lw=_LINE, label=label))
    if sheet.faults:
        handles.append(Patch(fc="none", ec=VERMILION, hatch=_FAULT, label="fails a check"))
    return handles


def _text(sheet: CutSheet) -> str:
    wide, high = _MILLIMETRES * sheet.size
    kerf = f"its lines compensate a kerf of {_MILLIMETRES * sheet.kerf:g} mm" if sheet.kerf else "without a kerf"
    failed = "".join(f" {check.text[:1].upper()}{check.text[1:]}." for check in sheet.checks if check.ok is False)
    return (
        f"Sheet to cut of {sheet.name}. {wide:.1f} mm wide and {high:.1f} mm high, {kerf}, creases as"
        f" {sheet.style}.{failed}"
    )
