"""A study that varies its factors one at a time: the results of all choices."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Patch
from matplotlib.transforms import blended_transform_factory

from forficula.quantities import reading_unit
from forficula.reproduction import named_reproduction
from forficula.show.study.factor_text import display_values, factor_label, number_text, value_text
from forficula.show.study.maps import energy_noun, missing_reasons
from forficula.show.study.outcome_looks import look_of, map_style
from forficula.show.style import BLACK, BLUE, PAGE_WIDTH, SKY, VERMILION, describe, fit_legend, is_narrow, letter_panels
from forficula.study.assumptions.choice_groups import choice_groups, count_all, count_first, count_unknown
from forficula.study.assumptions.choices import CHOICE
from forficula.study.tables.outcome_kinds import studied_verbs, table_transitions, whole_of

if TYPE_CHECKING:
    from xarray import Dataset

# inch, height of a row
_ROW = 0.155
# in rows: height of a bar, gap between factors
_BAR, _GAP = 0.72, 0.35
_INK = "0.35"
# keeps the line of the paper away from text
_BEHIND_TEXT: dict[str, Any] = {"fc": "white", "ec": "none", "pad": 0.6}
_NAME: dict[str, Any] = {"va": "center", "fontweight": "bold", "fontsize": 7, "bbox": _BEHIND_TEXT}
_DID_ALL: dict[str, Any] = {"ls": "", "marker": "D", "ms": 3, "color": "white", "mec": BLACK, "mew": 0.8}
# for single structures
_MOST_PANELS = 3
_SMALL = 1e-3
_BESIDE = 0.12  # space beside the dots, as a share of their range


@dataclass(frozen=True, kw_only=True)
class _Row:
    """Line of the figure: the name of a factor, or one of its choices.

    Attributes:
        height: height of its centre, in rows, downwards from 0.
        text: name or value.
        place: index of the choice; None for a name.
    """

    height: float
    text: str
    place: int | None


def draw_choices(table: Dataset, *, width: float = PAGE_WIDTH) -> Figure:
    """Draw the number of grid points that complete the first transition, for every choice; or a structure's results.

    Args:
        table: table of a study that varies its factors one at a time.
        width: width of the figure, inch.
    """
    rows = list(_rows(table))
    with map_style():
        figure = Figure(figsize=(width, _ROW * (rows[-1].height + 1) + 0.85), layout="constrained")
        if table["status"].dims == (CHOICE,):
            known = _numbers(table)
            names = [name for name in known if name in table and bool(np.isfinite(table[name]).any())]
            first = next(name for name in known if name in table)
            shown = (names or [first])[: 1 if is_narrow(width) else _MOST_PANELS]
            grid = figure.subplots(1, len(shown), sharey=True, squeeze=False)[0]
            for axes, name in zip(grid, shown, strict=True):
                _draw_numbers(axes, table, name, rows)
        else:
            grid = [figure.subplots()]
            _draw_counts(grid[0], table, rows)
        letter_panels(grid)
        _name_rows(grid, rows)
        return describe(figure, _text(table, rows))


def _numbers(table: Dataset) -> dict[str, str]:
    """Return the drawable results of a single structure, with labels: least values, the first time, works."""
    transitions, start = table_transitions(table), table.attrs.get("start_state")
    if not transitions:
        if start:
            return {f"{start}_energy": f"{energy_noun(table)} when {start}"}
        return {"residual": "largest residual of the energy balance (share)"}
    return {
        **{transition.least: transition.least.replace("_", " ") for transition in transitions if transition.least},
        **{f"{transition.name}_time": transition.wording.time for transition in transitions[:1]},
        **{f"{transition.name}_work": f"work of {transition.wording.noun}" for transition in transitions},
    }


def _rows(table: Dataset) -> Iterator[_Row]:
    height = 0.0
    for group in choice_groups(table):
        factor = table[group.factor]
        texts = _value_texts([display_values(factor)[0][place].item() for place in group.places])
        yield _Row(height=height, text=factor_label(factor), place=None)
        for place, text in zip(group.places, texts, strict=True):
            height += 1
            yield _Row(height=height, text=text, place=place)
        height += 1 + _GAP


def _value_texts(values: Sequence[object]) -> list[str]:
    """Return values without their unit, all as powers of ten if one is small."""
    texts = ["none" if value != value else number_text(value) for value in values]
    if not any(isinstance(value, float) and 0 < abs(value) < _SMALL for value in values):
        return texts
    numbers = [f"{value:.3e}".split("e") if isinstance(value, float) and value else None for value in values]
    return [
        text if parts is None else f"{float(parts[0]):g}e{int(parts[1])}"
        for text, parts in zip(texts, numbers, strict=True)
    ]


def _draw_counts(axes: Axes, table: Dataset, rows: Sequence[_Row]) -> None:
    """Draw a bar for each choice: points that complete the first transition, then undecided points."""
    first, every, unknown = count_first(table), count_all(table), count_unknown(table)
    count = table["status"].size // table.sizes[CHOICE]
    for row in rows:
        if row.place is None:
            continue
        least = end = int(first[row.place])
        axes.barh(row.height, end, _BAR, color=_colour(row.place))
        for word, numbers in unknown.items():
            if number := int(numbers[row.place]):
                look = look_of(table, word)
                axes.barh(row.height, number, _BAR, left=end, fc=look.face, hatch=look.hatch, ec=_INK, lw=0.4)
                end += number
        text = str(least) if end == least else f"{least} to {end}"
        axes.text(end + 0.01 * count, row.height, text, va="center", fontsize=7, bbox=_BEHIND_TEXT, zorder=3)
        if every is not None:
            axes.plot(every[row.place], row.height, zorder=3, **_DID_ALL)
    handles: list[Artist] = [
        Patch(color=BLUE, label=f"{table.attrs['design']}"),
        Patch(color=SKY, label="with one value changed"),
        *(
            Patch(fc=look_of(table, word).face, hatch=look_of(table, word).hatch, ec=_INK, lw=0.4, label=word)
            for word in unknown
        ),
    ]
    if every is not None:
        handles.append(Line2D([], [], label=f"{studied_verbs(table)[-1]} again", **_DID_ALL))
    paper = named_reproduction(table.attrs.get("reproduces"))
    if paper is not None and (folds := paper.fold_count) is not None:
        line = axes.axvline(folds, color=VERMILION, ls="--", lw=1, zorder=2, label=f"paper: {folds}")
        handles.append(line)
    # space for the numbers beside full bars
    axes.set(
        xlim=(0, (1.12 if unknown else 1.06) * count),
        xlabel=f"{whole_of(table)}s that {studied_verbs(table)[0]}, of {count}",
    )
    axes.set_xticks(np.unique(np.linspace(0, count, 7).round()))
    figure = axes.get_figure(root=True)
    if isinstance(figure, Figure):
        fit_legend(figure, handles, 5, loc="outside lower center")


def _draw_numbers(axes: Axes, table: Dataset, name: str, rows: Sequence[_Row]) -> None:
    """Draw a dot for each choice, or the reason why there is none."""
    values = table[name].values.astype(float)
    unit, factor = reading_unit(table[name].attrs["units"], float(np.nanmax(np.abs(values), initial=0.0)))
    reasons = missing_reasons(table, name).values
    axes.axvline(factor * values[0], color=BLUE, lw=0.6, zorder=0)
    foot = blended_transform_factory(axes.transAxes, axes.transData)
    for row in rows:
        if row.place is None:
            continue
        if np.isfinite(values[row.place]):
            axes.plot(factor * values[row.place], row.height, "o", ms=4, color=_colour(row.place), mec=BLUE, mew=0.6)
        else:
            axes.text(0.02, row.height, str(reasons[row.place]), transform=foot, va="center", fontsize=6, color=_INK)
    if np.isfinite(values).any():
        low, high = factor * float(np.nanmin(values)), factor * float(np.nanmax(values))
        room = _BESIDE * ((high - low) or abs(high) or 1.0)
        axes.set_xlim(low - room, high + room)
    axes.set_xlabel(f"{_numbers(table)[name]} ({unit})" if unit else _numbers(table)[name])


def _name_rows(grid: Sequence[Axes], rows: Sequence[_Row]) -> None:
    """Label the rows with values, those of the base design bold, and factors with names above their values."""
    named = [row for row in rows if row.place is not None]
    first = grid[0]  # the others share its rows
    first.set_ylim(rows[-1].height + 0.7, -0.6)
    first.set_yticks([row.height for row in named], [row.text for row in named])
    for label, row in zip(first.get_yticklabels(), named, strict=True):
        label.set_fontweight("bold" if row.place == 0 else "normal")
    for axes in grid:
        axes.tick_params(axis="y", length=0)
    beside = blended_transform_factory(first.transAxes, first.transData)
    for row in rows:
        if row.place is None:
            first.text(0.012, row.height, row.text, transform=beside, zorder=3, **_NAME)


def _colour(place: int) -> str:
    return SKY if place else BLUE


def _text(table: Dataset, rows: Sequence[_Row]) -> str:
    """Describe the figure."""
    singles = table["status"].dims == (CHOICE,)
    first, count = count_first(table), table["status"].size // table.sizes[CHOICE]
    whole = whole_of(table)
    what = f"Results of a {whole}" if singles else f"Number of {count} {whole}s that {studied_verbs(table)[0]},"
    results, name = [], ""
    for row in rows:
        if row.place is None:
            name = row.text
        else:
            result = table["status"].values[row.place] if singles else first[row.place]
            results.append(f"{name} {row.text}: {result}")
    return f"{what} with values of {table.attrs['design']} varied one at a time. {'; '.join(results)}."


def choice_rows(table: Dataset) -> tuple[list[str], list[list[str]]]:
    """Count the grid points that complete the first transition, and all transitions, for every choice.

    Args:
        table: table of a study.

    Returns:
        Headings, and one row for each choice; no rows if there is no grid.
    """
    if CHOICE not in table.dims or table["status"].ndim == 1:
        return [], []
    first, every, unknown = count_first(table), count_all(table), count_unknown(table)
    rows = []
    for group in choice_groups(table):
        for place in group.places:
            suffix = "" if place else f", as in {table.attrs['design']}"
            counts = [str(item[place]) for item in (first, every) if item is not None]
            if unsure := sum(int(numbers[place]) for numbers in unknown.values()):
                counts[0] += f" to {first[place] + unsure}"
            rows.append([value_text(table[group.factor], place) + suffix, *counts])
    count = table["status"].size // table.sizes[CHOICE]
    verbs = studied_verbs(table)
    return ["choice", f"{verbs[0]}, of {count}", *([f"{verbs[-1]} again"] if every is not None else [])], rows
