"""Page of a tolerance analysis: the probability of working, the deviations that matter most, the nearest failures."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from forficula.analysis import Verdict, verdict_word
from forficula.design import Design, key_value
from forficula.files import write_text
from forficula.goals.deviation import Deviation
from forficula.show.page.data.samples_data import MET, PointQuantity, ShownSamples, samples_data, scale_of
from forficula.show.page.parts.bars import BarRow, bar, bar_table, percent_text
from forficula.show.page.parts.deviation_text import deviation_text, plain_key
from forficula.show.page.parts.html import section
from forficula.show.page.parts.outcome_words import signs_of
from forficula.show.page.parts.rich_html import PrintedResult
from forficula.show.page.samples_page import about_rows, samples_page
from forficula.study.running.kept_runs import KeptRun

if TYPE_CHECKING:
    from xarray import Dataset


@dataclass(frozen=True, kw_only=True)
class VerdictGrid:
    """Verdicts of designs in which only two values deviate: a map under the scatter plot of the samples.

    Attributes:
        first: key on the horizontal axis.
        second: key on the vertical axis.
        across: values of `first`, rising, SI.
        upwards: values of `second`, rising, SI.
        works: whether the design works, (across, upwards).
    """

    first: str
    second: str
    across: Sequence[float]
    upwards: Sequence[float]
    works: Sequence[Sequence[bool]]


_WORKS, _MISSES = "works", "misses a limit"
# largest number of rows of bars
_MOST_BARS = 10
# largest number of axes of the parallel coordinates
_MOST_AXES = 8


def write_tolerance_page(
    design: Design,
    deviations: Sequence[Deviation],
    results: Dataset,
    printed: PrintedResult,
    path: Path,
    kept: Iterable[KeptRun] = (),
    count: int = 0,
    csv: str = "",
    cells: VerdictGrid | None = None,
) -> None:
    """Write a tolerance analysis as one HTML file that works offline.

    Args are those of `tolerance_page`.

    Raises:
        InputError: it cannot be written.
    """
    write_text(path, tolerance_page(design, deviations, results, printed, kept, count, csv, cells))


def tolerance_page(
    design: Design,
    deviations: Sequence[Deviation],
    results: Dataset,
    printed: PrintedResult,
    kept: Iterable[KeptRun] = (),
    count: int = 0,
    csv: str = "",
    cells: VerdictGrid | None = None,
) -> str:
    """Return a tolerance analysis as one page.

    Args:
        design: the nominal design.
        deviations: tolerances of its values.
        results: from `tolerance_table`: facts with their probabilities, factors, groups of factors, and samples.
        printed: the sentence with the probability, the tables and the remarks of the terminal.
        kept: runs that the page can play back; `point` is the index of the sample.
        count: number of these runs.
        csv: contents of `table.csv`.
        cells: a map over two of the values, under the scatter plot.
    """
    data = _data(design, deviations, results)
    return samples_page(
        name=design.name,
        kind="tolerance",
        printed=printed,
        before=(
            section("Probability of working", _facts_table(results), name="likely"),
            section("Deviations that matter most", _indices_table(results), name="sensitivity"),
        ),
        after=(section("Distance to the nearest failure", _reach_table(design, deviations, results), name="reach"),),
        data=data,
        views=_views(results, data, cells),
        headings=("All samples", "Tolerances and settings"),
        about=_about(design, deviations, results),
        kept=kept,
        count=count,
        csv=csv,
    )


def _views(results: Dataset, data: dict[str, Any], cells: VerdictGrid | None) -> dict[str, Any]:
    """Return the plots of the points that the script draws: a scatter plot, and parallel coordinates."""
    names = [item["key"] for item in data["factors"]]
    ranked = [key for key in ranked_keys(results) if key in names]
    ranked += [key for key in names if key not in ranked]
    return {
        "lines": [*ranked[:_MOST_AXES], "margin"],
        "plane": _plane(results, ranked, cells),
        "order": ["plane", "lines"],
        "front": [],
        "best": None,
        "best_word": "",
    }


def _plane(results: Dataset, ranked: Sequence[str], cells: VerdictGrid | None) -> dict[str, Any]:
    """Return the two axes of the scatter plot: those of the map, or the deviations that matter most."""
    if cells is None:
        return {"title": "Samples", "x": ranked[0], "y": ranked[1] if len(ranked) > 1 else "margin"}
    across, upwards = (
        [float(value) * scale_of(results[key.replace(".", "_")]) for value in values]
        for key, values in ((cells.first, cells.across), (cells.second, cells.upwards))
    )
    drawn = {"across": across, "upwards": upwards, "works": [[bool(item) for item in row] for row in cells.works]}
    return {"title": "Samples over the map of verdicts", "x": cells.first, "y": cells.second, "cells": drawn}


def ranked_keys(results: Dataset) -> list[str]:
    """Return the keys with sensitivity indices of their own, from the largest index down."""
    keys = [str(key) for key in results["factor"].values]
    groups = [str(group) for group in results["group"].values]
    return [groups[index] for index in _order(results) if groups[index] in keys]


def _order(results: Dataset) -> list[int]:
    """Return the indices of the groups by falling sensitivity of the margin; the group of remaining factors is last."""
    first, total = (results[f"{name}_index"].values[0].astype(float) for name in ("first", "total"))
    weight = np.nan_to_num(np.where(np.isnan(total), first, total))
    keys = {str(key) for key in results["factor"].values}
    groups = [str(group) for group in results["group"].values]
    return sorted(range(len(groups)), key=lambda index: (groups[index] not in keys, -weight[index]))


def _data(design: Design, deviations: Sequence[Deviation], results: Dataset) -> dict[str, Any]:
    names = {deviation.key: deviation.key.replace(".", "_") for deviation in deviations}
    answers, outcomes = results["answer"].values, results["outcome"].values
    words = [_WORKS if str(answer) == _WORKS else str(word) for answer, word in zip(answers, outcomes, strict=True)]
    margins = [str(name) for name in results["result"].values]
    table = results[list(names.values())]
    for number, _ in enumerate(margins):
        table[f"margin_{number}" if number else "margin"] = (
            "sample",
            results["margin"].values[number],
            {"units": "", "display": "%"},
        )
    return samples_data(
        ShownSamples(
            name=design.name,
            noun="sample",
            file="table.csv",
            keeps="Runs of some samples are kept.",
            table=table,
            factors=tuple(names.values()),
            numbers=(
                PointQuantity(variable="margin", title="margin", bounds=MET),
                *(
                    PointQuantity(variable=f"margin_{number}", title=f"margin: {name}", bounds=MET)
                    for number, name in enumerate(margins)
                    if number
                ),
            ),
            words=words,
            signs=signs_of(results, {_WORKS: "●", _MISSES: "◐"}),
            statuses=[
                word if word == str(outcome) else f"{word}: {outcome}"
                for word, outcome in zip(words, outcomes, strict=True)
            ],
            built=[word != verdict_word(Verdict.NOT_BUILT, None) for word in words],
            nominal={name: float(key_value(design, key)) for key, name in names.items()},
        )
    )


def _facts_table(results: Dataset) -> str:
    """Return a table of probabilities with intervals: that the design works, and that it meets each requirement."""
    rows = []
    for number, name in enumerate(results["fact"].values):
        share, low, high = (float(results[f"probability{end}"].values[number]) for end in ("", "_low", "_high"))
        decided = int(results["works"].values[number]) + int(results["fails"].values[number])
        text = "—" if math.isnan(share) else f"{percent_text(share)} %"
        cells = (
            f"{text} ({percent_text(low)} to {percent_text(high)})",
            f"{int(results['works'].values[number])} of {decided}",
        )
        rows.append(BarRow(name=str(name), lanes=((bar(share, "first", interval=(low, high)),),), cells=cells))
    caption = "Probability of each requirement, with its 95 % interval"
    return bar_table(caption, ("", "probability", "", "samples"), rows, (0.0, 1.0)) if rows else ""


def _indices_table(results: Dataset) -> str:
    """Return a table of sensitivity indices: shares of the margin's variance, alone and, if known, in interactions."""
    groups, order = [str(group) for group in results["group"].values], _order(results)
    known = ["first"] if np.isnan(results["total_index"].values[0]).all() else ["first", "total"]
    rows = []
    for index in order[:_MOST_BARS]:
        shares = [
            tuple(float(results[f"{name}_index{end}"].values[0, index]) for end in ("", "_low", "_high"))
            for name in known
        ]
        lanes = tuple(
            (bar(share, kind, interval=(low, high)),)
            for (share, low, high), kind in zip(shares, ("first", "second"), strict=False)
        )
        cells = tuple(_share_text(*share) for share in shares)
        rows.append(BarRow(name=plain_key(groups[index]), lanes=lanes, cells=cells))
    if not rows:
        return ""
    what = "of each deviation alone"
    if len(known) > 1:
        what += " (upper bar) and including interactions (lower bar)"
    left = len(order) - len(rows)
    rest = f"; {left} more have smaller shares" if left else ""
    caption = f"Shares of the variance of the margin {what}, with 95 % intervals{rest}"
    return bar_table(caption, ("", "share", "alone", "with interactions")[: 2 + len(known)], rows, (0.0, 1.0))


def _share_text(value: float, low: float, high: float) -> str:
    if math.isnan(value):
        return "—"
    return f"{100 * value:.0f} % ({100 * low:.0f} to {100 * high:.0f})".replace("-", "−")


def _reach_table(design: Design, deviations: Sequence[Deviation], results: Dataset) -> str:
    """Return a table of the deviations, down and up, at which a design fails, in widths of its tolerance."""
    fails = {direction: results[f"fails_{direction}"].values.astype(float) for direction in ("down", "up")}
    works = {direction: results[f"works_{direction}"].values.astype(float) for direction in ("down", "up")}
    if not np.isfinite([*works["down"], *works["up"]]).any():
        return ""
    scale = 1.02 * float(np.nanmax([*fails["down"], *fails["up"], *works["down"], *works["up"], 1.0]))
    keys = [str(key) for key in results["factor"].values]
    by_key = {deviation.key: deviation for deviation in deviations}
    nearest = np.fmin(fails["down"], fails["up"])
    rows = []
    for number in np.argsort(np.where(np.isnan(nearest), np.inf, nearest), kind="stable").tolist():
        ends = [(fails[direction][number], works[direction][number]) for direction in ("down", "up")]
        lane = tuple(_reach_bar(*end, sign) for end, sign in zip(ends, (-1, 1), strict=True))
        note = deviation_text(design, by_key[keys[number]])
        cells = tuple(_reach_text(*end) for end in ends)
        rows.append(BarRow(name=plain_key(keys[number]), lanes=(lane,), cells=cells, note=note))
    caption = (
        "Smallest deviation of one value alone at which the design fails, in widths of its tolerance. Red: within the"
        " tolerance. Blue: beyond it. Pale: no failure up to this deviation"
    )
    return bar_table(caption, ("", "down | up", "down", "up"), rows, (-scale, scale))


def _reach_bar(fails: float, works: float, sign: int) -> Any:
    if math.isnan(fails):
        return bar(sign * works, "open")
    return bar(sign * fails, "bad" if fails <= 1 else "good")


def _reach_text(fails: float, works: float) -> str:
    if not math.isnan(fails):
        return f"{fails:.2g}"
    return "—" if math.isnan(works) else f"beyond {works:.2g}"


def _about(design: Design, deviations: Sequence[Deviation], results: Dataset) -> list[str]:
    rows = [["design", design.name], *([deviation.key, deviation_text(design, deviation)] for deviation in deviations)]
    rows += [[name, str(results.attrs[name])] for name in ("runs", "seed") if name in results.attrs]
    return about_rows(rows, design.hash, "", f"forficula tolerance {design.name}")
