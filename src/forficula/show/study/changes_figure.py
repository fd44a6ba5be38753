"""A study of named changes: margins of every change as bars, and of pairs of changes as a matrix."""

from __future__ import annotations

import itertools
import math
import textwrap
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.colors import to_rgb
from matplotlib.figure import Figure
from matplotlib.legend_handler import HandlerPatch
from matplotlib.lines import Line2D
from matplotlib.patches import Patch, Rectangle

from forficula.quantities import reading_unit
from forficula.show.study.outcome_looks import OutcomeLook, known_words, look_of, map_style
from forficula.show.style import BLACK, PAGE_WIDTH, Drawing, describe, fit_legend, is_narrow
from forficula.study.tables.outcome_kinds import studied_transitions
from forficula.study.tables.redundancy import (
    MARGIN,
    ChangedRun,
    margin_number,
    redundancy,
    redundancy_sentences,
)

if TYPE_CHECKING:
    from xarray import Dataset

# inch: height of a bar's row, of a second line of its name, size of a cell, space around
_ROW, _LINE, _CELL, _AROUND = 0.2, 0.1, 0.42, 0.75
# inch, of a list of names: width of a letter, height of a line
_LETTER_WIDTH, _LIST_LINE = 0.054, 0.125
_BAR = 0.7
_INK = "0.35"
_EMPTY = "0.97"
_NAME_LETTERS, _NARROW_LETTERS = 44, 22  # letters per line of a name
_DARK = 0.45  # lightness below which text on a face is white


@dataclass(frozen=True, kw_only=True)
class _Axis:
    """Axis of the bars.

    Attributes:
        label: label with the unit.
        values: values in the unit of the label, for every point; nan if missing.
        signed: whether values are margins, between -1 and 1.
    """

    label: str
    values: Sequence[float]
    signed: bool

    @property
    def reversed(self) -> bool:
        """Whether the axis runs from 0 to negative values, because a search found no others."""
        return (
            not self.signed and any(value < 0 for value in self.values) and not any(value > 0 for value in self.values)
        )


def change_drawings(table: Dataset) -> dict[str, Drawing]:
    """Return the drawings of a study of named changes by the stems of their files."""
    alone: dict[str, Drawing] = {"changes": lambda width: draw_changes(table, width=width)}
    in_pairs: dict[str, Drawing] = {"pairs": lambda width: draw_pairs(table, width=width)}
    return alone | (in_pairs if redundancy(table).pairs else {})


def draw_changes(table: Dataset, *, width: float = PAGE_WIDTH) -> Figure:
    """Draw the margin of the unchanged design and of every change alone as bars, the largest first.

    Colour and mark show the outcome. For a study that searches least values, bars are the first of these values.

    Args:
        table: table of a study of named changes.
        width: width of the figure, inch.
    """
    report, axis = redundancy(table), _axis(table)
    known = np.array([axis.values[run.place] for run in (report.unchanged, *report.alone)])
    order = np.argsort(-known if axis.signed else np.abs(known), kind="stable")
    runs = [(report.unchanged, *report.alone)[index] for index in order]
    names = [_wrapped(_name(run, table), width) for run in runs]
    with map_style():
        lines = sum(name.count("\n") for name in names)
        figure = Figure(figsize=(width, _ROW * len(runs) + _LINE * lines + _AROUND + 0.25), layout="constrained")
        axes = figure.subplots()
        for row, run in enumerate(runs):
            _draw_bar(axes, table, run, row, axis)
        axes.axvline(0, color=BLACK, lw=0.6)
        axes.set_ylim(len(runs) - 0.4, -0.6)
        axes.set_yticks(range(len(runs)), names)
        axes.tick_params(axis="y", length=0)
        axes.spines["left"].set_visible(False)
        for label, run in zip(axes.get_yticklabels(), runs, strict=True):
            label.set_fontweight("normal" if run.names else "bold")
        axes.set_xlabel(axis.label)
        if axis.signed:
            beyond = 1.4 if is_narrow(width) else 1.2  # space for numbers beside full bars
            axes.set_xlim(-beyond, beyond)
            axes.set_xticks(np.linspace(-1, 1, 5))
        else:
            least, largest = (1.15 * float(pick(known, initial=0.0)) for pick in (np.nanmin, np.nanmax))
            axes.set_xlim(*((0, least) if axis.reversed else (least, largest or 1.0)))
        _draw_legend(figure, _handles(table, runs, hatched=True))
        return describe(figure, f"Margins of {table.attrs['design']} with changes. {_text(table)}")


def draw_pairs(table: Dataset, *, width: float = PAGE_WIDTH) -> Figure:
    """Draw the margins of all pairs of changes as a triangular matrix; the diagonal has every change alone.

    Args:
        table: table of a study of named changes in pairs.
        width: width of the figure, inch.
    """
    report, axis = redundancy(table), _axis(table)
    places = {run.names[0]: index for index, run in enumerate(report.alone)}
    count = len(places)
    names = [_wrapped(f"{index + 1}  {name}", width) for index, name in enumerate(places)]
    cell = min(_CELL, (width - 0.3) / count)
    rows = max(count, _rows_of(names, count, cell))
    with map_style():
        figure = Figure(figsize=(width, cell * rows + _AROUND), layout="constrained")
        axes = figure.subplots()
        runs = [*report.alone, *report.pairs]
        for run in runs:
            first, second = places[run.names[0]], places[run.names[-1]]
            _draw_cell(axes, table, run, first, second, axis, small=cell < 0.8 * _CELL)
        for pair in report.omitted:
            first, second = sorted(places[name] for name in pair.names)
            axes.add_patch(Rectangle((first - 0.5, second - 0.5), 1, 1, fc=_EMPTY, ec="white", lw=1))
            axes.plot([first], [second], ls="", marker="_", ms=4, color=_INK)
        axes.set(xlim=(-0.5, count - 0.5), ylim=(count - 0.5, count - rows - 0.5), aspect="equal")
        axes.set_yticks(range(count), [str(index + 1) for index in range(count)])
        listed: dict[str, Any] = {"ha": "right", "va": "top", "ma": "left", "fontsize": 6.5, "linespacing": 1.35}
        axes.text(1, 1, "\n".join(names), transform=axes.transAxes, **listed)
        axes.set_xticks(range(count), [str(index + 1) for index in range(count)])
        axes.tick_params(length=0)
        for spine in axes.spines.values():
            spine.set_visible(False)
        handles = _handles(table, runs, hatched=False)
        if report.omitted:
            handles.append(_MarkedPatch("_", _INK, fc=_EMPTY, ec=_INK, lw=0.4, label="not combined"))
        _draw_legend(figure, handles)
        what = axis.label[:1].upper() + axis.label[1:]
        return describe(figure, f"{what} of {table.attrs['design']} with pairs of changes. {_text(table)}")


def _rows_of(names: Sequence[str], count: int, cell: float) -> int:
    """Return the number of rows with which the names above a triangular matrix do not meet its cells."""
    lines = [line for name in names for line in name.splitlines()]

    def meets(rows: int) -> bool:
        """Return whether a line is longer than the cells right of the diagonal that are free at its foot."""
        covered = [math.ceil((number + 1) * _LIST_LINE / cell) - (rows - count) for number in range(len(lines))]
        return any(
            row > 0 and len(line) * _LETTER_WIDTH > cell * (count - row)
            for line, row in zip(lines, covered, strict=True)
        )

    return next(rows for rows in itertools.count(count) if not meets(rows))


def _axis(table: Dataset) -> _Axis:
    """Return what bars and cells show: the margin, or the first least value of a search."""
    if MARGIN in table:
        label = "margin (negative: failed)"
        return _Axis(label=label, values=table[MARGIN].values.tolist(), signed=True)
    name = next(transition.least for transition in studied_transitions(table) if transition.least)
    values = table[name].values.astype(float)
    unit, factor = reading_unit(table[name].attrs["units"], float(np.nanmax(np.abs(values), initial=0.0)))
    return _Axis(label=f"{name.replace('_', ' ')} ({unit})", values=(factor * values).tolist(), signed=False)


def _draw_bar(axes: Axes, table: Dataset, run: ChangedRun, row: int, axis: _Axis) -> None:
    look, value = look_of(table, run.outcome), axis.values[run.place]
    if not np.isfinite(value):
        axes.plot([0], [row], ls="", zorder=3, clip_on=False, **_mark(look))
        axes.annotate(run.outcome, (0, row), (6, 0), textcoords="offset points", va="center", fontsize=6.5, color=_INK)
        return
    axes.barh(row, value, _BAR, fc=look.face, ec=_INK, lw=0.4, hatch=look.hatch)
    axes.plot([value], [row], ls="", zorder=3, clip_on=False, **_mark(look))
    left = value < 0 and not axis.reversed
    axes.annotate(
        _number(value, axis),
        (value, row),
        (-5 if left else 5, 0),
        textcoords="offset points",
        ha="right" if left else "left",
        va="center",
        fontsize=6.5,
    )


def _draw_cell(
    axes: Axes, table: Dataset, run: ChangedRun, first: int, second: int, axis: _Axis, *, small: bool
) -> None:
    """Draw the cell of a pair, or of one change on the diagonal: its outcome as a mark above its number."""
    look, value = look_of(table, run.outcome), axis.values[run.place]
    face, alone = _face(look), first == second
    axes.add_patch(Rectangle((first - 0.5, second - 0.5), 1, 1, fc=face, ec="white", lw=1))
    if alone:
        axes.add_patch(Rectangle((first - 0.46, second - 0.46), 0.92, 0.92, fc="none", ec=BLACK, lw=0.8))
    ink = _ink(face)
    axes.plot([first], [second - 0.2], ls="", marker=look.marker, ms=2.5 if small else 4, color=ink, mfc=ink, mew=0.7)
    text = _number(value, axis) if np.isfinite(value) else "?"
    if small and axis.signed:
        text = text[:5]
    axes.text(first, second + 0.22, text, ha="center", va="center", fontsize=5 if small else 6.5, color=ink)


def _number(value: float, axis: _Axis) -> str:
    return margin_number(value) if axis.signed else f"{value:.3g}".replace("-", "−")


def _mark(look: OutcomeLook) -> dict[str, Any]:
    return {"marker": look.marker, "ms": 4, "mfc": _face(look), "mec": BLACK, "mew": 0.7}


class _MarkedPatch(Patch):
    """Entry of a legend: a face with a mark on it."""

    def __init__(self, marker: str, ink: str, **look: Any) -> None:
        super().__init__(**look)
        self.marker, self.ink = marker, ink


class _MarkedHandler(HandlerPatch):
    """Draw an entry of a legend with its mark."""

    def create_artists(self, legend: Any, orig_handle: Any, *box: Any) -> list[Artist]:
        left, foot, width, height, _, transform = box
        artists: list[Artist] = [*super().create_artists(legend, orig_handle, *box)]
        mark = Line2D([(width - left) / 2], [(height - foot) / 2], ls="", marker=orig_handle.marker, ms=3.5, mew=0.7)
        mark.set(color=orig_handle.ink, transform=transform)
        return [*artists, mark]


def _draw_legend(figure: Figure, handles: Sequence[Artist]) -> None:
    fit_legend(figure, handles, 3, loc="outside lower center", handler_map={_MarkedPatch: _MarkedHandler()})


def _handles(table: Dataset, runs: Sequence[ChangedRun], *, hatched: bool) -> list[Artist]:
    """Return the legend's entries of the outcomes that occur, in the order of all outcomes."""
    present = {run.outcome for run in runs}
    order = [word for word in known_words(table) if word in present]
    handles: list[Artist] = []
    for word in (*order, *sorted(present - set(order))):
        look = look_of(table, word)
        face, hatch = _face(look), look.hatch if hatched else ""
        handles.append(_MarkedPatch(look.marker, _ink(face), fc=face, hatch=hatch, ec=_INK, lw=0.4, label=word))
    return handles


def _face(look: OutcomeLook) -> str:
    """Return the face of an outcome; not white, which would merge with the page."""
    return look.face if to_rgb(look.face) != (1.0, 1.0, 1.0) else "0.96"


def _ink(face: str) -> str:
    """Return the colour of text on a face."""
    red, green, blue = to_rgb(face)
    return "white" if 0.3 * red + 0.59 * green + 0.11 * blue < _DARK else BLACK


def _name(run: ChangedRun, table: Dataset) -> str:
    return " + ".join(run.names) or f"{table.attrs['design']}, unchanged"


def _wrapped(name: str, width: float) -> str:
    return textwrap.fill(name, _NARROW_LETTERS if is_narrow(width) else _NAME_LETTERS)


def _text(table: Dataset) -> str:
    return " ".join(redundancy_sentences(table))
