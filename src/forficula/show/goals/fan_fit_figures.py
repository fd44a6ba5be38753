"""A fan that was fitted to clicked points: over its picture, and its deviations by vein."""

from __future__ import annotations

import math

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import LineCollection
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from forficula.arrays import Array
from forficula.goals.clicks.fan_fit import FanFit, fitted_lines
from forficula.pattern.picture.homography import mapped_points
from forficula.quantities import reading_unit, round_below, show_value
from forficula.show.structure.crease_lines import add_sheet_legend
from forficula.show.style import (
    BLACK,
    BLUE,
    GREEN,
    ORANGE,
    PAGE_WIDTH,
    SKY,
    VERMILION,
    describe,
    draw_bar,
    figure_style,
    in_column,
)

_MARKERS = {"base": ("^", "clicked base"), "ring": ("o", "clicked ring fold"), "tip": ("s", "clicked tip")}
_MOST_PIXELS = 800  # along the longer side of a drawn picture
_FADED = 0.45  # opacity of the picture under the lines
_AROUND = 0.07  # of the fan's size, shown around it
_WIDEST = 5.2  # inch
_TALLEST = 1.3  # largest height by width
_SHOWN_RESIDUAL = 0.05  # largest drawn deviation by the fan's size
_BAR = 0.25  # largest length of the scale bar by the width


def draw_fan_fit(fit: FanFit, width: float = PAGE_WIDTH) -> Figure:
    """Draw clicked points, the fitted fan, and the deviations as magnified arrows, over the picture if there is one.

    Args:
        fit: fitted fan.
        width: largest width of the figure, inch.
    """
    to_picture = np.linalg.inv(np.array(fit.homography))
    clicked = mapped_points(to_picture, np.array([(point.x, point.y) for point in fit.points]))
    fitted = mapped_points(to_picture, np.array([(point.fitted_x, point.fitted_y) for point in fit.points]))
    lines = {name: [mapped_points(to_picture, line) for line in group] for name, group in fitted_lines(fit).items()}
    everything = np.concatenate([clicked, fitted, *lines["veins"]])
    size = float(np.ptp(everything, axis=0).max())
    margin = _AROUND * size
    (left, top), (right, bottom) = everything.min(axis=0) - margin, everything.max(axis=0) + margin
    longest = float(np.linalg.norm(clicked - fitted, axis=1).max())
    factor = max(1.0, round_below(_SHOWN_RESIDUAL * size / longest)) if longest > 0 else 1.0
    with figure_style():
        wide = min(width, _WIDEST)
        tall = min(_TALLEST, (bottom - top) / (right - left))
        figure = Figure(figsize=(wide, (wide - 0.6) * tall + 0.6), layout="constrained")
        axes = figure.subplots()
        _draw_picture(fit, axes, left, top, right, bottom)
        styles = {"veins": (BLUE, 1.2, "fitted veins"), "ring": (VERMILION, 1.2, "fitted ring fold")}
        styles["hub"] = (GREEN, 1.0, "fitted hub circle")
        handles = []
        for name, (colour, line_width, label) in styles.items():
            axes.add_collection(LineCollection(lines[name], colors=[colour], linewidths=line_width, zorder=3))
            handles.append(Line2D([], [], color=colour, lw=line_width, label=label))
        roles = [point.role for point in fit.points]
        for role, (marker, label) in {**_MARKERS, "hub": ("*", "clicked hub")}.items():
            chosen = [number for number, other in enumerate(roles) if other == role]
            if chosen:
                look = {"marker": marker, "ls": "none", "ms": 4.0, "mfc": "white", "mec": BLACK, "mew": 0.7}
                axes.plot(*clicked[chosen].T, zorder=4, **look)  # type: ignore[arg-type]
                handles.append(Line2D([], [], label=label, **look))  # type: ignore[arg-type]
        pairs = zip(clicked, fitted, strict=True)
        arrows = [np.array([model, model + factor * (point - model)]) for point, model in pairs]
        axes.add_collection(LineCollection(arrows, colors=[ORANGE], linewidths=1.6, zorder=5))
        handles.append(
            Line2D([], [], color=ORANGE, lw=1.6, label="deviation" if factor == 1 else f"{factor:g} x deviation")
        )
        for number, vein in enumerate(lines["veins"]):
            along = (vein[2] - vein[1]) / np.linalg.norm(vein[2] - vein[1])
            tips = [
                float((place - vein[2]) @ along)
                for place, point in zip(clicked, fit.points, strict=True)
                if point.vein == number and point.role == "tip"
            ]
            beyond = vein[2] + (max(0.0, *tips, 0.0) + 0.035 * size) * along
            axes.text(float(beyond[0]), float(beyond[1]), str(number), ha="center", va="center", color=BLUE, fontsize=7)
        axes.set(xlabel="x (pixels)", ylabel="y (pixels)", xlim=(left, right), ylim=(bottom, top), aspect="equal")
        if in_column(axes):
            axes.locator_params(nbins=5)
        _draw_scale(fit, axes, to_picture, (left, right, bottom, top))
        add_sheet_legend(figure, handles, 4)
        return describe(figure, _fit_text(fit))


def _draw_picture(fit: FanFit, axes: Axes, left: float, top: float, right: float, bottom: float) -> None:
    if fit.picture is None:
        return
    height, width = fit.picture.pixels.shape[:2]
    columns = slice(max(math.floor(left), 0), min(math.ceil(right), width))
    rows = slice(max(math.floor(top), 0), min(math.ceil(bottom), height))
    step = max(1, math.ceil(max(right - left, bottom - top) / _MOST_PIXELS))
    shown = fit.picture.pixels[rows, columns][::step, ::step]
    if not shown.size:
        return
    faded = (255 * (1 - _FADED * (1 - shown))).round().astype(np.uint8)
    extent = (columns.start - 0.5, columns.stop - 0.5, rows.stop - 0.5, rows.start - 0.5)
    axes.imshow(faded, extent=extent, interpolation="antialiased")


def _draw_scale(fit: FanFit, axes: Axes, to_picture: Array, frame: tuple[float, float, float, float]) -> None:
    """Draw a scale bar at the lower left, where it is exact for a picture without perspective."""
    left, right, bottom, top = frame
    foot = np.array([left + 0.04 * (right - left), bottom - 0.04 * (bottom - top)])
    matrix = np.array(fit.homography)
    ends = mapped_points(matrix, np.stack([foot, foot + np.array([_BAR * (right - left), 0.0])]))
    length = round_below(float(np.linalg.norm(ends[1] - ends[0])))
    along = (ends[1] - ends[0]) / np.linalg.norm(ends[1] - ends[0])
    end = mapped_points(to_picture, ends[:1] + length * along)[0]
    draw_bar(axes, foot.tolist(), float(np.linalg.norm(end - foot)), show_value(length, "m"))


def _fit_text(fit: FanFit) -> str:
    return (
        f"Fan fitted to {len(fit.points)} clicked points of {fit.name or 'a picture'}. The root mean square distance"
        f" between clicked and fitted points is {show_value(fit.rms, 'm', 3)}, {100 * fit.relative_rms:.2g} % of the"
        " length of a vein."
    )


def draw_vein_deviations(fit: FanFit, width: float = PAGE_WIDTH) -> Figure:
    """Draw the distance of every clicked point from the fitted fan, by vein.

    Args:
        fit: fitted fan.
        width: largest width of the figure, inch.
    """
    largest = max(
        distance for vein in fit.veins for distance in (vein.base, vein.ring, vein.tip) if distance is not None
    )
    unit, factor = reading_unit("m", largest)
    numbers = [vein.vein for vein in fit.veins]
    with figure_style():
        wide = min(width, _WIDEST)
        figure = Figure(figsize=(wide, 0.62 * wide), layout="constrained")
        axes = figure.subplots()
        handles = []
        for role, colour in (("base", GREEN), ("ring", VERMILION), ("tip", BLUE)):
            values = [getattr(vein, role) for vein in fit.veins]
            if any(value is not None for value in values):
                marker = _MARKERS[role][0]
                shown = [math.nan if value is None else factor * value for value in values]
                axes.plot(numbers, shown, marker, color=colour, ms=4)
                handles.append(
                    Line2D([], [], marker=marker, ls="none", color=colour, ms=4, label=_MARKERS[role][1][8:])
                )
        axes.plot(numbers, [factor * vein.rms for vein in fit.veins], color=BLACK, lw=1)
        handles.append(Line2D([], [], color=BLACK, lw=1, label="root mean square of a vein"))
        if fit.different is not None:
            others = [factor * (vein.rms_different or 0.0) for vein in fit.veins]
            axes.plot(numbers, others, color=SKY, lw=1, ls="--")
            handles.append(Line2D([], [], color=SKY, lw=1, ls="--", label="the same, veins that differ"))
        axes.set(xlabel="vein", ylabel=f"distance from the fitted fan ({unit})")
        axes.set_ylim(bottom=0)
        axes.set_xticks(numbers[:: max(1, len(numbers) // 12)])
        add_sheet_legend(figure, handles, 3)
        return describe(figure, f"Distances of clicked points from the fitted fan, by vein. {_fit_text(fit)}")
