"""Measured moment of a crease, moment of the fitted law, and residuals."""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from forficula.arrays import Array
from forficula.material.folding.crease_characterisation import CreaseCharacterisation, shown_value
from forficula.names import counted
from forficula.quantities import reading_unit
from forficula.show.material.law_figure import time_unit
from forficula.show.style import (
    BLACK,
    ORANGE,
    PAGE_WIDTH,
    SKY,
    VERMILION,
    describe,
    figure_style,
    fit_legend,
    is_narrow,
    letter_panels,
)


def draw_crease(crease: CreaseCharacterisation, width: float = PAGE_WIDTH) -> Figure:
    """Draw data and law over the fold angle and over time, and the residual below both; width in inch.

    Tests without a time are drawn over the number of the row.
    """
    fit, tests = crease.fit, crease.tests
    unit, factor = reading_unit("N", max(float(np.abs(test.moment_by_width).max()) for test in tests))
    label = f"{unit} m/m"
    longest = max((float(test.time[-1] - test.time[0]) for test in tests if test.time is not None), default=0.0)
    time_name, second = time_unit(longest)
    timed = all(test.time is not None for test in tests)
    with figure_style():
        figure = Figure(figsize=(width, 4.3), layout="constrained")
        panels = figure.subplots(2, 2, sharex="col", sharey="row", height_ratios=[2.2, 1])
        for test, fitted in zip(tests, fit.fitted, strict=True):
            moment, law = factor * test.moment_by_width, factor * fitted
            rows = np.arange(len(moment), dtype=np.float64)
            along = rows if test.time is None or not timed else (test.time - test.time[0]) / second
            for column, across in enumerate((np.rad2deg(test.angle), along)):
                _draw_test(panels[:, column], across, moment, law)
        for axes in panels.ravel():
            axes.axhline(0, color="0.6", lw=0.5, zorder=0)
        for axes in panels[1]:
            for side in (-1, 1):
                axes.axhline(side * factor * fit.misfit, color=BLACK, lw=0.7, ls=":")
        panels[0, 0].set_ylabel(f"moment per length ({label})")
        panels[1, 0].set_ylabel(f"law − data\n({label})")
        panels[1, 0].set_xlabel("fold angle (deg)")
        panels[1, 1].set_xlabel(f"time ({time_name})" if timed else "row")
        rest = next(value.value for value in fit.values if value.key == "rest_angle")
        panels[0, 0].plot(np.rad2deg(rest), 0.0, ls="none", marker="o", ms=4.5, color="white", mec=ORANGE, zorder=5)
        letter_panels(panels.ravel().tolist())
        end = ":\n" if is_narrow(width) else ": "
        residual = f"residual {100 * fit.relative_misfit:.2g} % of the largest moment"
        figure.suptitle(f"{fit.law}{end}{residual}", fontsize=8)
        data = f"data of {len(tests)} strips" if len(tests) > 1 else "data"
        handles = [
            Line2D([], [], color=SKY, lw=2.0, alpha=0.6, label=data),
            Line2D([], [], color=VERMILION, label="law"),
            Line2D([], [], ls="none", marker="o", ms=4.5, color="white", mec=ORANGE, label="rest angle"),
            Line2D([], [], color=BLACK, lw=0.7, ls=":", label=f"root mean square, {factor * fit.misfit:.2g} {label}"),
        ]
        fit_legend(figure, handles, 4, loc="outside lower center", fontsize=6 if is_narrow(width) else 7)
        return describe(figure, _text(crease))


def _draw_test(panels: Any, across: Array, moment: Array, law: Array) -> None:
    """Draw one test in the upper one of two panels, and its residual in the lower one."""
    upper: Axes = panels[0]
    upper.plot(across, moment, color=SKY, lw=2.0, alpha=0.6)
    upper.plot(across, law, color=VERMILION, lw=1.0)
    panels[1].plot(across, law - moment, color=SKY, ls="none", marker=".", ms=2.0, mew=0, alpha=0.8)


def _text(crease: CreaseCharacterisation) -> str:
    """Describe the fit."""
    values = ", ".join(
        f"{value.key.replace('_', ' ')} {shown_value(value.key, value.value)}" for value in crease.fit.values
    )
    strips = counted(len(crease.tests), "strip")
    return f"Measured moment of {strips} over fold angle and time, and moment of the fitted law: {values}."
