"""Maps of a study: torques, works, energies, times and verdicts over any two of its factors."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import matplotlib
import numpy as np
from matplotlib import rc_context
from matplotlib.axes import Axes
from matplotlib.colors import ListedColormap, Normalize
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Patch
from numpy.typing import NDArray

from forficula.errors import InputError
from forficula.quantities import Unit, parse_quantity
from forficula.show.style import BLUE, PAGE_WIDTH, SKY, figure_style

if TYPE_CHECKING:
    from xarray import DataArray, Dataset

Array = NDArray[np.float64]
Texts = NDArray[np.str_]

# lightness rises with the value, so that grey print and every kind of colour vision keep the order
_COLOURS = matplotlib.colormaps["cividis"]
# beyond this many values a factor's cells are too small for numbers, and its ticks are thinned out
_MOST_NUMBERS = 12
_MOST_PANELS = 9
_INK = "0.35"
_HATCHES = {"hatch.linewidth": 0.5}

_NOT_FOLDED = "did not fold"
_STUCK = "stuck on the way"
_NOT_STAYED = "did not stay folded"
_NOT_TRIED = "not tried: did not fold"
_NOT_RUN = "not run"
_OTHER = "no value"
# what a wing is called that folded, and may have been asked to open
_GOES_ON = ("folded", "folded and opened", "did not open")


@dataclass(frozen=True, kw_only=True)
class _Look:
    """How what happened is drawn: the cell's face and hatch, and the marker where there are no cells."""

    face: str
    hatch: str
    marker: str


_LOOKS = {
    "folded and opened": _Look(face=BLUE, hatch="", marker="o"),
    "folded": _Look(face=SKY, hatch="", marker="D"),
    "did not open": _Look(face="#F3DDA6", hatch="....", marker="s"),
    _NOT_FOLDED: _Look(face="1.0", hatch="/////", marker="x"),
    _STUCK: _Look(face="0.93", hatch="xxxx", marker="*"),
    _NOT_STAYED: _Look(face="1.0", hatch="|||||", marker="1"),
    "diverged": _Look(face="0.75", hatch="++++", marker="P"),
    _NOT_TRIED: _Look(face="0.86", hatch="", marker="_"),
    _NOT_RUN: _Look(face="1.0", hatch="", marker="."),
    _OTHER: _Look(face="0.97", hatch="---", marker="+"),
}

# failed when folded for the unfolding, with a torque that its word names
_BEFORE_OPENING = _Look(face="0.93", hatch="oo", marker="X")

# for a variable's kind of quantity: units in which it reads well, and their factors from SI
_READABLE = {
    "N m": (("N cm", 1e2), ("N mm", 1e3), ("µN m", 1e6), ("nN m", 1e9)),
    "J": (("J", 1.0), ("mJ", 1e3), ("µJ", 1e6), ("nJ", 1e9)),
    "s": (("s", 1.0), ("ms", 1e3), ("µs", 1e6)),
}


@dataclass(frozen=True, kw_only=True)
class _Panel:
    """What one pair of axes shows.

    Attributes:
        title: what it is.
        values: in SI, nan where there is none.
        reasons: why there is none, of the same shape; read only there.
        unit: SI; empty where there are verdicts only.
    """

    title: str
    values: DataArray
    reasons: DataArray
    unit: str


@dataclass(frozen=True, kw_only=True)
class _View:
    """Where things are drawn: over which factors, and what of the table.

    Attributes:
        table: the slice that is drawn.
        x: factor across.
        y: factor upwards, or None where a quantity is.
        note: which slice it is, or nothing.
        sampled: whether the rows are samples rather than a grid.
    """

    table: Dataset
    x: str
    y: str | None
    note: str
    sampled: bool


def study_figures(table: Dataset) -> dict[str, Figure]:
    """Draw every figure that a study's table has the numbers for.

    Args:
        table: of the search for the least torques or of plain runs, over a grid of factors or over samples.

    Returns:
        Figures by the stem of their file.
    """
    figures = {"status": draw_status_map(table)}
    if "least_fold_torque" in table:
        figures["torques"] = draw_torque_maps(table)
    if _known(table, "fold_work", "unfold_work"):
        figures["works"] = draw_work_maps(table)
    if _known(table, "flat_energy", "folded_energy", "opened_energy"):
        figures["energies"] = draw_energy_maps(table)
    if "fold_time_by_torque" in table and not _is_sampled(table):
        figures["fold_times"] = draw_fold_times(table)
    return figures


def draw_torque_maps(table: Dataset, x: str | None = None, y: str | None = None) -> Figure:
    """Draw the least torques that fold and unfold, and why there is none where there is none.

    Args:
        table: of a search for the least torques.
        x: factor across, such as "tendon.rest_length"; by default the second.
        y: factor upwards; by default the first.

    Raises:
        InputError: the table has no such factor.
    """
    names = {"least_fold_torque": "least fold torque", "least_unfold_torque": "least unfold torque"}
    return _draw(table, x, y, names)


def draw_work_maps(table: Dataset, x: str | None = None, y: str | None = None) -> Figure:
    """Draw the work that folding and unfolding take, at the least torques where these were searched for.

    Args and errors are those of `draw_torque_maps`.
    """
    return _draw(table, x, y, {"fold_work": "work of folding", "unfold_work": "work of unfolding"})


def draw_energy_maps(table: Dataset, x: str | None = None, y: str | None = None) -> Figure:
    """Draw the tendons' energy in the three states on one scale (Binder et al. 2025, Figure 8).

    Args and errors are those of `draw_torque_maps`.
    """
    names = {"flat_energy": "energy when flat", "folded_energy": "energy when folded"}
    return _draw(table, x, y, names | {"opened_energy": "energy when opened"}, one_scale=True)


def draw_status_map(table: Dataset, x: str | None = None, y: str | None = None) -> Figure:
    """Draw what became of every wing.

    Args and errors are those of `draw_torque_maps`.
    """
    with figure_style(), rc_context(_HATCHES):
        view = _view(table, x, y)
        verdicts = _words(view.table["status"])
        nothing = verdicts.copy(data=np.full(verdicts.shape, np.nan))
        return _page(view, [_Panel(title="outcome", values=nothing, reasons=verdicts, unit="")])


def draw_fold_times(table: Dataset, panels: str | None = None, y: str | None = None) -> Figure:
    """Draw the time that folding takes over the fold torque and a factor, for values of another (the paper's Figure 7).

    Args:
        table: of a search for the least torques over a grid.
        panels: factor with one panel a value; by default the first of several. Of many values, some are drawn.
        y: factor upwards; by default the second, or the only one.

    Raises:
        InputError: the table has no such factor, or has samples.
    """
    if _is_sampled(table):
        raise InputError("fold times over the torque need a grid of factors, got samples")
    factors = _factors(table)
    y = _name(factors, y) if y else _default([name for name in factors if name != panels], 1 if panels is None else 0)
    panels = _name(factors, panels) if panels else next((name for name in factors if name != y), None)
    with figure_style(), rc_context(_HATCHES):
        view = _slice(table, [name for name in (panels, y) if name], x="fold_torque", y=y)
        times = view.table["fold_time_by_torque"]
        reasons = times.copy(data=np.full(times.shape, _NOT_FOLDED))
        if panels is None:
            return _page(view, [_Panel(title="fold time", values=times, reasons=reasons, unit="s")])
        count = table.sizes[panels]
        chosen = np.unique(np.linspace(0, count - 1, min(count, _MOST_PANELS)).round().astype(int))
        drawn = [
            _Panel(
                title=_value_text(table[panels], int(index)),
                values=times.isel({panels: index}),
                reasons=reasons.isel({panels: index}),
                unit="s",
            )
            for index in chosen
        ]
        few = f"{len(chosen)} of {count} values of {_plain(table[panels])}" if len(chosen) < count else ""
        return _page(view, drawn, one_scale=True, quantity="fold time", note=few)


def _draw(table: Dataset, x: str | None, y: str | None, names: dict[str, str], *, one_scale: bool = False) -> Figure:
    """A page with a panel a variable."""
    with figure_style(), rc_context(_HATCHES):
        view = _view(table, x, y)
        panels = [
            _Panel(title=title, values=view.table[name], reasons=_reasons(view.table, name), unit=_unit(table, name))
            for name, title in names.items()
        ]
        return _page(view, panels, one_scale=one_scale, quantity="tendons' energy" if one_scale else "")


# ---- the table: its factors, what is drawn of it, and why a value is missing


def _is_sampled(table: Dataset) -> bool:
    return table["status"].dims == ("sample",)


def _factors(table: Dataset) -> list[str]:
    """Names of the factors, in the study's order."""
    if not _is_sampled(table):
        return [str(name) for name in table["status"].dims]
    return [str(name) for name, values in table.coords.items() if values.dims == ("sample",) and name != "sample"]


def _name(factors: Sequence[str], wanted: str) -> str:
    """A factor's name in the table, from that or from its key."""
    name = wanted.replace(".", "_")
    if name not in factors:
        raise InputError(f"{wanted}: need a factor of the study, one of {', '.join(factors)}")
    return name


def _default(factors: Sequence[str], place: int) -> str:
    return factors[min(place, len(factors) - 1)]


def _view(table: Dataset, x: str | None, y: str | None) -> _View:
    """What to draw over two factors, or over the only one."""
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


def _slice(table: Dataset, kept: Sequence[str], *, x: str, y: str | None) -> _View:
    """The middle of every factor that is not kept, and a note that says so."""
    if _is_sampled(table):
        return _View(table=table, x=x, y=y, note="", sampled=True)
    middle = {name: table.sizes[name] // 2 for name in _factors(table) if name not in kept}
    note = ", ".join(_value_text(table[name], index) for name, index in middle.items() if table.sizes[name] > 1)
    return _View(table=table.isel(middle), x=x, y=y, note=f"at {note}" if note else "", sampled=False)


def _known(table: Dataset, *names: str) -> bool:
    return all(name in table for name in names) and any(bool(np.isfinite(table[name]).any()) for name in names)


def _unit(table: Dataset, name: str) -> str:
    return str(table[name].attrs.get("units", ""))


def _words(statuses: DataArray) -> DataArray:
    """Statuses without their numbers: "stuck at -134.6 deg" is one of many that are stuck."""
    return statuses.copy(data=np.vectorize(_word, otypes=[object])(statuses.values))


def _word(status: str) -> str:
    if status in ("", "nan", "None"):
        return _NOT_RUN
    return next(
        (word for start, word in (("stuck", _STUCK), ("diverged", "diverged")) if status.startswith(start)), status
    )


def _reasons(table: Dataset, name: str) -> DataArray:
    """Why a variable has no value, wherever it has none."""
    status = table["status"]
    if name == "flat_energy":
        return _words(status)
    folding = table["fold_status"] if "fold_status" in table else status
    if name in ("least_fold_torque", "fold_time", "fold_work", "folded_energy"):
        return folding.copy(data=np.vectorize(_why_not_folded, otypes=[object])(folding.values))
    reference = table["reference_fold_status"] if "reference_fold_status" in table else status.copy(data=status.values)
    torque = reference.attrs.get("torque")
    where = f" with {100 * torque:.4g} N cm" if torque is not None and "reference_fold_status" in table else ""
    why = np.vectorize(lambda *words: _why_not_opened(*words, where), otypes=[object])
    return status.copy(data=why(status.values, folding.values, reference.values))


def _why_not_folded(folding: str) -> str:
    word = _word(folding)
    return _OTHER if word in _GOES_ON else word


def _why_not_opened(status: str, folding: str, reference: str, where: str) -> str:
    """Why it did not open, where `reference` is how it folded before that, and `where` with which torque."""
    if _word(folding) in (_NOT_FOLDED, _STUCK, _NOT_STAYED):
        return _NOT_TRIED
    if where and _word(reference) not in (*_GOES_ON, _NOT_RUN):
        return f"{_word(reference)}{where}"
    word = _word(status)
    return _OTHER if word in ("folded", "folded and opened") else word


# ---- factors in words and numbers


def _plain(factor: DataArray) -> str:
    """A factor's name for people: its key without the protocol's, whose names stand alone."""
    return str(factor.attrs.get("key", factor.name)).removeprefix("protocol.").replace(".", " ").replace("_", " ")


def _display(factor: DataArray) -> tuple[NDArray[Any], str]:
    """A factor's values in the unit for people, and that unit; words stay words."""
    values, si, display = factor.values, factor.attrs.get("units", ""), factor.attrs.get("display", "")
    if values.dtype.kind not in "iuf" or not si or not display or si == display:
        return values, str(display or si)
    unit = Unit(display=display, si=si, example=f"1 {display}")
    return values / parse_quantity(f"1 {display}", unit), display


def _number_text(value: object) -> str:
    return f"{value:.4g}" if isinstance(value, float | int) and not isinstance(value, bool) else str(value)


def _value_text(factor: DataArray, index: int) -> str:
    values, unit = _display(factor)
    return f"{_plain(factor)} {_number_text(values[index].item())} {unit}".rstrip()


def _label(factor: DataArray) -> str:
    unit = _display(factor)[1]
    return f"{_plain(factor)} ({unit})" if unit else _plain(factor)


# ---- a page of panels


@dataclass(frozen=True, kw_only=True)
class _Scale:
    """How a quantity is written and coloured: the unit that reads well, its factor from SI, and the colours' ends."""

    unit: str
    factor: float
    norm: Normalize
    empty: bool


def _page(
    view: _View, panels: Sequence[_Panel], *, one_scale: bool = False, quantity: str = "", note: str = ""
) -> Figure:
    """All panels with their colour bars, a legend of what happened where there is no value, and the slice's name."""
    columns = {1: 1, 2: 2, 4: 2}.get(len(panels), 3)
    rows = math.ceil(len(panels) / columns)
    cells = not view.sampled and (view.y is not None or not panels[0].unit)
    across, upwards = view.table[view.x].size, view.table[view.y].size if view.y else 1
    width = PAGE_WIDTH if columns > 1 else 0.6 * PAGE_WIDTH
    height = float(np.clip((0.27 if rows == 1 else 0.21) * upwards, 0.5, 3.2)) if cells else 1.7
    figure = Figure(figsize=(width, rows * (height + 0.5) + 0.75), layout="constrained")
    grid = figure.subplots(rows, columns, squeeze=False).ravel()
    scales = [_scale(panels)] * len(panels) if one_scale else [_scale([panel]) for panel in panels]
    small = columns * across > 24
    for index, (axes, panel, scale) in enumerate(zip(grid, panels, scales, strict=False)):
        axes.set_title(panel.title)
        if cells:
            _draw_cells(axes, view, panel, scale, numbers=max(across, upwards) <= _MOST_NUMBERS, small=small)
        else:
            _draw_points(axes, view, panel, scale)
        if index + columns >= len(panels):
            axes.set_xlabel(_label(view.table[view.x]))
        if view.y and index % columns == 0:
            axes.set_ylabel(_label(view.table[view.y]))
        elif view.y:
            axes.tick_params(labelleft=False)
        if (cells or view.y) and not one_scale and not scale.empty:
            _colour_bar(figure, [axes], scale.unit, scale)
    for axes in grid[len(panels) :]:
        axes.remove()
    if (cells or view.y) and one_scale and not scales[0].empty:
        _colour_bar(figure, list(grid[: len(panels)]), f"{quantity} ({scales[0].unit})", scales[0])
    if text := ", ".join(part for part in (view.note, note) if part):
        figure.suptitle(text, fontsize=8)
    _legend(figure, view, panels, cells=cells)
    return figure


def _scale(panels: Sequence[_Panel]) -> _Scale:
    """One scale for all values of some panels."""
    values = np.concatenate([panel.values.values.astype(float).ravel() for panel in panels])
    finite = values[np.isfinite(values)]
    empty, units = not len(finite), _READABLE.get(panels[0].unit, ((panels[0].unit, 1.0),))
    low, high = (0.0, 0.0) if empty else (float(finite.min()), float(finite.max()))
    largest = max(abs(low), abs(high))
    unit, factor = next((pair for pair in units if largest * pair[1] >= 0.999), units[-1] if largest else units[0])
    if low == high:
        low, high = low - 0.1 * largest - (not largest), high + 0.1 * largest + (not largest)
    return _Scale(unit=unit, factor=factor, norm=Normalize(low * factor, high * factor), empty=empty)


def _colour_bar(figure: Figure, axes: list[Axes], label: str, scale: _Scale) -> None:
    mappable = matplotlib.cm.ScalarMappable(scale.norm, _COLOURS)
    bar = figure.colorbar(mappable, ax=axes, label=label, pad=0.015, aspect=25, fraction=0.06)
    bar.outline.set_visible(False)  # type: ignore[operator]


def _missing(panel: _Panel) -> dict[str, NDArray[np.bool_]]:
    """Where there is no value, by reason, in the panel's own order of dimensions."""
    absent = ~np.isfinite(panel.values.values.astype(float))
    words = panel.reasons.transpose(*panel.values.dims).values.astype(str)
    order = [*_LOOKS, *sorted(set(words[absent].tolist()) - set(_LOOKS))]
    return {word: where for word in order if (where := absent & (words == word)).any()}


def _look(word: str) -> _Look:
    return _LOOKS.get(word) or (_BEFORE_OPENING if " with " in word else _LOOKS[_OTHER])


def _legend(figure: Figure, view: _View, panels: Sequence[_Panel], *, cells: bool) -> None:
    """Every reason that a panel shows, once."""
    words = list(dict.fromkeys(word for panel in panels for word in _missing(panel)))
    handles: list[Patch | Line2D] = []
    for word in words:
        look = _look(word)
        if cells:
            handles.append(Patch(facecolor=look.face, hatch=look.hatch, edgecolor=_INK, lw=0.4, label=word))
        else:
            handles.append(Line2D([], [], ls="", marker=look.marker, color=_ink(look), ms=5, label=word))
    if handles:
        columns = min(len(handles), 4 if figure.get_figwidth() >= PAGE_WIDTH else 2)
        figure.legend(handles=handles, loc="outside lower center", ncols=columns, handleheight=1.4, handlelength=2.2)


def _ink(look: _Look) -> str:
    """A marker's colour: the face where that shows on white."""
    return look.face if look.face in (BLUE, SKY) else _INK


def _draw_cells(axes: Axes, view: _View, panel: _Panel, scale: _Scale, *, numbers: bool, small: bool) -> None:
    """A cell for each pair of values, evenly spaced whatever the values are."""
    order = [name for name in (view.y, view.x) if name]
    panel = _Panel(
        title=panel.title,
        values=panel.values.transpose(*order),
        reasons=panel.reasons.transpose(*order),
        unit=panel.unit,
    )
    values = np.atleast_2d(panel.values.values.astype(float) * scale.factor)
    edges = [np.arange(count + 1) - 0.5 for count in reversed(values.shape)]
    if np.isfinite(values).any():
        shown = np.ma.masked_invalid(values)
        axes.pcolormesh(*edges, shown, cmap=_COLOURS, norm=scale.norm, edgecolors="white", linewidth=0.4)
    for word, where in _missing(panel).items():
        look = _look(word)
        axes.pcolor(
            *edges,
            np.ma.masked_array(np.zeros(values.shape), ~np.atleast_2d(where)),
            cmap=ListedColormap([look.face]),
            hatch=look.hatch,
            edgecolor=_INK if look.hatch else "white",
            linewidth=0.25,
        )
    if numbers:
        _write_numbers(axes, values, scale, size=5 if small else 6)
    axes.set(xlim=edges[0][[0, -1]], ylim=edges[1][[0, -1]])
    axes.tick_params(length=0)
    for name, axis in ((view.x, axes.xaxis), (view.y, axes.yaxis)):
        shown_values = _display(view.table[name])[0] if name else np.array([])
        step = math.ceil(len(shown_values) / _MOST_NUMBERS) or 1
        places = range(0, len(shown_values), step)
        axis.set_ticks(list(places), [_number_text(shown_values[place].item()) for place in places])


def _write_numbers(axes: Axes, values: Array, scale: _Scale, *, size: float) -> None:
    """Every value in its cell, with the digits that the largest one allows, in the ink that shows on its colour."""
    largest = float(np.nanmax(np.abs(values), initial=0.0))
    decimals = 3 - math.floor(math.log10(largest)) if largest else 0
    for (row, column), value in np.ndenumerate(values):
        if np.isfinite(value):
            red, green, blue, _ = _COLOURS(scale.norm(value))
            light = 0.299 * red + 0.587 * green + 0.114 * blue > 0.5
            text = f"{round(value, decimals) + 0.0:.3g}"
            axes.text(column, row, text, ha="center", va="center", fontsize=size, color="black" if light else "white")


def _draw_points(axes: Axes, view: _View, panel: _Panel, scale: _Scale) -> None:
    """Samples over two factors, coloured by value; over one, the value upwards and the failures along the bottom."""
    values = panel.values.values.astype(float) * scale.factor
    across = _positions(axes, view, "x")
    missing = _missing(panel)
    if view.y:
        upwards = _positions(axes, view, "y")
        found = np.isfinite(values)
        if found.any():
            axes.scatter(
                across[found], upwards[found], c=values[found], cmap=_COLOURS, norm=scale.norm, s=16, ec=_INK, lw=0.3
            )
        foot = axes.transData
    else:
        upwards = np.full(len(values), 0.05 if panel.unit else 0.5)
        foot = axes.get_xaxis_transform()
        if panel.unit:
            axes.plot(across, values, "o" if view.sampled else "o-", color=BLUE, ms=3.5)
            axes.set_ylabel(f"{panel.title} ({scale.unit})")
            # room for the failures under the least value
            low, high = (0.0, 1.0) if scale.empty else (min(0.0, float(np.nanmin(values))), float(np.nanmax(values)))
            axes.set_ylim(low - 0.12 * ((high - low) or 1), high + 0.08 * ((high - low) or 1))
        else:
            axes.set_yticks([])
    for word, where in missing.items():
        look = _look(word)
        axes.plot(
            across[where], upwards[where], ls="", marker=look.marker, color=_ink(look), ms=4, mew=0.8, transform=foot
        )


def _positions(axes: Axes, view: _View, which: str) -> Array:
    """Where a factor's values lie on an axis: at their size, or words one after another."""
    values, _ = _display(view.table[view.x if which == "x" else str(view.y)])
    if values.dtype.kind in "iuf":
        return values.astype(float)
    words, places = np.unique(values.astype(str), return_inverse=True)
    axis = axes.xaxis if which == "x" else axes.yaxis
    axis.set_ticks(list(range(len(words))), list(words))
    return places.astype(float)
