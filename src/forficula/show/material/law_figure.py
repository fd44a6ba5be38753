"""Measured stress, stress of the fitted law, and residuals."""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from forficula.errors import InputError
from forficula.material.characterisation import Characterisation
from forficula.material.fit.fit import LawFit, Residual
from forficula.quantities import reading_unit
from forficula.show.material.material_units import stress_unit
from forficula.show.style import (
    BLACK,
    PAGE_WIDTH,
    SKY,
    VERMILION,
    describe,
    figure_style,
    fit_legend,
    is_narrow,
    letter_panels,
)

_MINUTE, _HOUR = 60.0, 3600.0
_SOME_ROWS = 1.5  # rows per point from which points count as means


def draw_fit(material: Characterisation, width: float = PAGE_WIDTH) -> Figure:
    """Draw data and law over strain and over time, and the residual below both.

    The offset and drift of the force's zero, which the fit determines with the law, are subtracted from the data. The
    law is drawn with the amplitude of the specimen whose strain it follows.

    Args:
        material: material with its law and data.
        width: width of the figure, inch.

    Raises:
        InputError: there is no law.
    """
    fit = material.fit
    if fit is None:
        raise InputError(f"{material.name}: there is no law to draw")
    shown = _typical(fit)
    unit, factor = stress_unit(max(float(residual.stress.max()) for residual in fit.residuals))
    longest = max(float(residual.time[-1]) for residual in fit.residuals)
    time_name, time = time_unit(longest)
    with figure_style():
        figure = Figure(figsize=(width, 4.3), layout="constrained")
        panels = figure.subplots(2, 2, sharex="col", sharey="row", height_ratios=[2.2, 1])
        middles = {
            specimen.test.name: (specimen.test.time[0] + specimen.test.time[-1]) / 2 for specimen in material.specimens
        }
        for item in fit.residuals:
            _draw_data(panels, item, factor, time, middles[item.name])
        stress = _without_zero(shown, shown.fitted, middles[shown.name]) / factor
        panels[0, 0].plot(100 * shown.strain, stress, color=VERMILION, lw=1.0)
        panels[0, 1].plot(shown.time / time, stress, color=VERMILION, lw=1.0)
        for axes in panels.ravel():
            axes.axhline(0, color="0.6", lw=0.5, zorder=0)
        for axes in panels[1]:
            for side in (-1, 1):
                axes.axhline(side * fit.misfit / factor, color=BLACK, lw=0.7, ls=":")
        panels[0, 0].set_ylabel(f"engineering stress ({unit})")
        panels[1, 0].set_ylabel(f"law − data\n({unit})")
        panels[1, 0].set_xlabel("engineering strain (%)")
        panels[1, 1].set_xlabel(f"time ({time_name})")
        letter_panels(panels.ravel().tolist())
        end = ":\n" if is_narrow(width) else ": "
        residual = f"residual {100 * fit.relative_misfit:.2g} % of the largest stress"
        figure.suptitle(f"{fit.form.name}{end}{residual}", fontsize=8)
        _legend(figure, material, fit, f"{fit.misfit / factor:.2g} {unit}", shown)
        return describe(figure, _text(material.name, fit))


def _typical(fit: LawFit) -> Residual:
    """Return the specimen with the median misfit."""
    ranked = sorted(fit.residuals, key=lambda item: float(np.mean((item.fitted - item.stress) ** 2)))
    return ranked[len(ranked) // 2]


def time_unit(longest: float) -> tuple[str, float]:
    """Return a unit for times up to the longest one, s, and its size in s."""
    if longest >= 2 * _HOUR:
        return "h", _HOUR
    if longest >= 3 * _MINUTE:
        return "min", _MINUTE
    unit, factor = reading_unit("s", longest)
    return unit, 1 / factor


def _without_zero(residual: Residual, stress: Any, middle: float) -> Any:
    """Return a stress without the offset and drift of the force's zero, Pa, shape (points,)."""
    return stress - residual.offset - residual.drift * (residual.time - middle)


def _draw_data(panels: Any, residual: Residual, factor: float, time: float, middle: float) -> None:
    """Draw one specimen over strain and over time, and its residual below both; `middle` is its mean time, s."""
    stress = _without_zero(residual, residual.stress, middle) / factor
    left = (residual.fitted - residual.stress) / factor
    look: dict[str, Any] = {"color": SKY, "lw": 2.0, "alpha": 0.6}
    for column, across in enumerate((100 * residual.strain, residual.time / time)):
        panels[0, column].plot(across, stress, **look)
        panels[1, column].plot(across, left, color=SKY, ls="none", marker=".", ms=2.0, mew=0, alpha=0.8)


def _legend(figure: Figure, material: Characterisation, fit: LawFit, misfit: str, shown: Residual) -> None:
    many = len(fit.residuals) > 1
    along = f"law × {shown.amplitude:.3g} along {shown.name}"
    data = f"data of {len(fit.residuals)} specimens" if many else "data"
    cycles = [cycle for specimen in material.specimens for cycle in specimen.cycles]
    rows = sum(len(cycle.loading.time) + len(cycle.unloading.time) for cycle in cycles) / fit.points
    means = f", means of {rows:.0f} rows" if rows >= _SOME_ROWS else ""
    handles = [
        Line2D([], [], color=SKY, lw=2.0, alpha=0.6, label=f"{data}, zero of the force corrected{means}"),
        Line2D([], [], color=VERMILION, label=along if many else "law"),
        Line2D([], [], color=BLACK, lw=0.7, ls=":", label=f"root mean square, {misfit}"),
    ]
    size = 6 if is_narrow(figure.get_figwidth()) else 7
    fit_legend(figure, handles, 3, loc="outside lower center", fontsize=size)


def _text(name: str, fit: LawFit) -> str:
    """Describe the fit."""
    residual = f"residual {100 * fit.relative_misfit:.2g} % of the largest stress"
    return f"Measured stress of {name} over strain and time, and stress of the fitted law. {fit.form.name}, {residual}."
