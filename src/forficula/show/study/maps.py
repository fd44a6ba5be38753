"""Maps of a study: torques, works, energies, times and verdicts over any two of its factors."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np
from matplotlib.figure import Figure

from forficula.analysis import FOLDED, OPENED
from forficula.errors import InputError
from forficula.show.study.factor_text import plain_name, value_text
from forficula.show.study.map_page import (
    DIVERGED,
    NOT_BUILT,
    NOT_FOLDED,
    NOT_OPENED,
    NOT_STAYED,
    NOT_STAYED_OPEN,
    NOT_TRIED,
    OTHER,
    STILL_FOLDING,
    STILL_OPENING,
    STUCK,
    UNTRUSTED,
    Panel,
    View,
    draw_page,
    map_style,
)
from forficula.show.style import PAGE_WIDTH, Drawing
from forficula.study.choices import CHOICE

if TYPE_CHECKING:
    from xarray import DataArray, Dataset

_MOST_PANELS = 9
# what a wing is called that folded, and may have been asked to open
_GOES_ON = (FOLDED, OPENED, NOT_OPENED, NOT_STAYED_OPEN, STILL_OPENING)


def map_drawings(table: Dataset) -> dict[str, Drawing]:
    """Find every map that a study's table has the numbers for.

    Args:
        table: of the search for the least torques or of plain runs, over a grid of factors, with or without choices,
            or over samples.

    Returns:
        What draws them, by the stem of their file.
    """
    drawings: dict[str, Drawing] = {"status": lambda width: draw_status_map(table, width=width)}
    if "least_fold_torque" in table:
        drawings["torques"] = lambda width: draw_torque_maps(table, width=width)
    if _known(table, "fold_work", "unfold_work"):
        drawings["works"] = lambda width: draw_work_maps(table, width=width)
    if _known(table, "flat_energy", "folded_energy", "opened_energy"):
        drawings["energy"] = lambda width: draw_energy_maps(table, width=width)
    if "fold_time_by_torque" in table and not _is_sampled(table):
        drawings["fold_times"] = lambda width: draw_fold_times(table, width=width)
    return drawings


def draw_torque_maps(
    table: Dataset, x: str | None = None, y: str | None = None, *, width: float = PAGE_WIDTH
) -> Figure:
    """Draw the least torques that fold and unfold, and why there is none where there is none.

    Args:
        table: of a search for the least torques.
        x: factor across, such as "tendon.rest_length"; by default the second.
        y: factor upwards; by default the first.
        width: of the figure at most, inch.

    Raises:
        InputError: the table has no such factor.
    """
    names = {"least_fold_torque": "least fold torque", "least_unfold_torque": "least unfold torque"}
    return _draw(table, x, y, names, "torque", width=width)


def draw_work_maps(table: Dataset, x: str | None = None, y: str | None = None, *, width: float = PAGE_WIDTH) -> Figure:
    """Draw the work that folding and unfolding take, at the least torques where these were searched for.

    Args and errors are those of `draw_torque_maps`.
    """
    return _draw(table, x, y, {"fold_work": "work of folding", "unfold_work": "work of unfolding"}, "work", width=width)


def draw_energy_maps(
    table: Dataset, x: str | None = None, y: str | None = None, *, width: float = PAGE_WIDTH
) -> Figure:
    """Draw the tendons' energy in the three states on one scale (Binder et al. 2025, Figure 8).

    Args and errors are those of `draw_torque_maps`.
    """
    names = {"flat_energy": "energy when flat", "folded_energy": "energy when folded"}
    return _draw(
        table, x, y, names | {"opened_energy": "energy when opened"}, "tendons' energy", one_scale=True, width=width
    )


def draw_status_map(table: Dataset, x: str | None = None, y: str | None = None, *, width: float = PAGE_WIDTH) -> Figure:
    """Draw what became of every wing.

    Args and errors are those of `draw_torque_maps`.
    """
    with map_style():
        view = table_view(table, x, y)
        outcomes = view.table["outcome"]
        nothing = outcomes.copy(data=np.full(outcomes.shape, np.nan))
        return draw_page(view, [Panel(title="outcome", values=nothing, reasons=outcomes, unit="")], width=width)


def draw_fold_times(
    table: Dataset, panels: str | None = None, y: str | None = None, *, width: float = PAGE_WIDTH
) -> Figure:
    """Draw the time that folding takes over the fold torque and a factor, for values of another.

    As in Binder et al. 2025, Figure 7.

    Args:
        table: of a search for the least torques over a grid.
        panels: factor with one panel a value; by default the first of several. Of many values, some are drawn.
        y: factor upwards; by default the second, or the only one.
        width: of the figure, inch.

    Raises:
        InputError: the table has no such factor, or has samples.
    """
    if _is_sampled(table):
        raise InputError("fold times over the torque need a grid of factors, got samples")
    factors = _factors(table)
    panels, y = (_name(factors, name) if name else None for name in (panels, y))
    free = [name for name in factors if name not in (panels, y)]
    if len(factors) > 1:
        panels = panels or free.pop(0)
    y = y or (free or factors).pop(0)
    if panels == y:
        raise InputError(f"panels and y: need two factors, got {y} twice")
    with map_style():
        view = _slice(table, [name for name in (panels, y) if name], x="fold_torque", y=y)
        times = view.table["fold_time_by_torque"]
        reasons = view.table["fold_outcome_by_torque"]
        if panels is None:
            only = Panel(title="fold time", values=times, reasons=reasons, unit="s")
            return draw_page(view, [only], quantity="fold time", width=width)
        count = table.sizes[panels]
        chosen = np.unique(np.linspace(0, count - 1, min(count, _MOST_PANELS)).round().astype(int))
        drawn = [
            Panel(
                title=value_text(table[panels], int(index)),
                values=times.isel({panels: index}),
                reasons=reasons.isel({panels: index}),
                unit="s",
            )
            for index in chosen
        ]
        few = f"{len(chosen)} of {count} values of {plain_name(table[panels])}" if len(chosen) < count else ""
        return draw_page(view, drawn, one_scale=True, quantity="fold time", note=few, width=width)


def _draw(
    table: Dataset,
    x: str | None,
    y: str | None,
    names: dict[str, str],
    quantity: str,
    *,
    width: float,
    one_scale: bool = False,
) -> Figure:
    """A page with a panel a variable."""
    with map_style():
        view = table_view(table, x, y)
        panels = [
            Panel(
                title=title, values=view.table[name], reasons=missing_reasons(view.table, name), unit=_unit(table, name)
            )
            for name, title in names.items()
            if name in table  # a search may leave opening out
        ]
        return draw_page(view, panels, one_scale=one_scale, quantity=quantity, width=width)


# ---- the table: its factors, what is drawn of it, and why a value is missing


def _is_sampled(table: Dataset) -> bool:
    return table["outcome"].dims == ("sample",)


def _factors(table: Dataset) -> list[str]:
    """Names of the factors, in the study's order; choices of one at a time, which stand for the rest of them, last."""
    if not _is_sampled(table):
        # maps are of the grid that is repeated at every choice
        return sorted((str(name) for name in table["outcome"].dims), key=lambda name: name == CHOICE)
    return [str(name) for name, values in table.coords.items() if values.dims == ("sample",) and name != "sample"]


def _name(factors: Sequence[str], wanted: str) -> str:
    """A factor's name in the table, from that or from its key."""
    name = wanted.replace(".", "_")
    if name not in factors:
        raise InputError(f"{wanted}: need a factor of the study, one of {', '.join(factors)}")
    return name


def table_view(table: Dataset, x: str | None = None, y: str | None = None) -> View:
    """What to draw over two factors, or over the only one.

    Raises:
        InputError: the table has no such factor.
    """
    factors = _factors(table)
    if len(factors) == 1:
        return _slice(table, factors, x=_name(factors, x or factors[0]), y=None)
    across, upwards = (_name(factors, name) if name else None for name in (x, y))
    # a factor with one value is no axis as long as another one varies
    free = sorted((name for name in factors if name not in (across, upwards)), key=lambda name: table[name].size == 1)
    upwards = upwards or free.pop(0)
    across = across or free.pop(0)
    if across == upwards:
        raise InputError(f"x and y: need two factors, got {across} twice")
    return _slice(table, [upwards, across], x=across, y=upwards)


def _slice(table: Dataset, kept: Sequence[str], *, x: str, y: str | None) -> View:
    """The middle of every factor that is not kept, of choices the base, and a note that says so."""
    if _is_sampled(table):
        return View(table=table, x=x, y=y, note="", sampled=True)
    middle = {name: 0 if name == CHOICE else table.sizes[name] // 2 for name in _factors(table) if name not in kept}
    note = ", ".join(value_text(table[name], index) for name, index in middle.items() if table.sizes[name] > 1)
    return View(table=table.isel(middle), x=x, y=y, note=f"at {note}" if note else "", sampled=False)


def _known(table: Dataset, *names: str) -> bool:
    return any(name in table and bool(np.isfinite(table[name]).any()) for name in names)


def _unit(table: Dataset, name: str) -> str:
    return str(table[name].attrs.get("units", ""))


def missing_reasons(table: Dataset, name: str) -> DataArray:
    """Why a variable has no value, wherever it has none."""
    outcome = table["outcome"]
    if name in ("flat_energy", "residual"):
        return outcome
    folding = table.get("fold_outcome", outcome)
    if name in ("least_fold_torque", "fold_time", "fold_work", "folded_energy"):
        return folding.copy(data=np.vectorize(_why_not_folded, otypes=[object])(folding.values))
    searched = "reference_outcome" in table
    reference = table["reference_outcome"] if searched else outcome.copy(data=outcome.values)
    where = f" with {100 * reference.attrs['torque']:.4g} N cm" if searched else ""
    why = np.vectorize(_why_not_opened, otypes=[object])
    return outcome.copy(data=why(outcome.values, folding.values, reference.values, where))


def _why_not_folded(folding: str) -> str:
    return OTHER if folding in _GOES_ON else folding


def _why_not_opened(outcome: str, folding: str, reference: str, where: str) -> str:
    """Why it did not open, where `reference` is how it folded before that, and `where` with which torque."""
    if where and reference in _GOES_ON:
        # a wing that only the large torque folds was asked to open, too
        word = outcome if folding in _GOES_ON else NOT_OPENED
    elif where and reference:
        word = reference if reference in (DIVERGED, UNTRUSTED, NOT_BUILT) else f"{reference}{where}"
    else:
        word = NOT_TRIED if folding in (NOT_FOLDED, STUCK, STILL_FOLDING, NOT_STAYED) else outcome
    return OTHER if word in (FOLDED, OPENED) else word
