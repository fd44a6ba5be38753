"""The page of a tolerance: how likely a design works as it is built, what decides it, and how far off failure is."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from forficula.analysis import Verdict
from forficula.design import Design, key_quantity, key_value
from forficula.files import write_text
from forficula.goals.deviation import Deviation
from forficula.quantities import show_quantity
from forficula.show.page.bars import BarRow, bar, bar_table
from forficula.show.page.deviation_text import deviation_text, plain_key
from forficula.show.page.html import section
from forficula.show.page.outcome_words import signs_of
from forficula.show.page.rich_html import LaidOut
from forficula.show.page.samples_data import Number, Samples, samples_data
from forficula.show.page.samples_page import about_rows, samples_page
from forficula.structure import structure_of
from forficula.study.kept_runs import KeptRun
from forficula.study.outcome_kinds import transitions_text

if TYPE_CHECKING:
    from xarray import Dataset

_WORKS = "works"


def write_tolerance_page(
    design: Design,
    deviations: Sequence[Deviation],
    results: Dataset,
    indices: Dataset,
    reach: Dataset,
    found: LaidOut,
    path: Path,
    kept: Iterable[KeptRun],
    count: int,
    csv: str = "",
) -> None:
    """Write a tolerance as one HTML file that needs no network.

    Args are those of `tolerance_page`.

    Raises:
        InputError: it cannot be written.
    """
    write_text(path, tolerance_page(design, deviations, results, indices, reach, found, kept, count, csv))


def tolerance_page(
    design: Design,
    deviations: Sequence[Deviation],
    results: Dataset,
    indices: Dataset,
    reach: Dataset,
    found: LaidOut,
    kept: Iterable[KeptRun],
    count: int,
    csv: str = "",
) -> str:
    """A tolerance as one page.

    Args:
        design: as it is meant.
        deviations: how far off it may be built.
        results: what was built, over "sample".
        indices: whose deviation decides, over "factor".
        reach: how far each alone may go before it fails, over "factor" and "way", in widths of its tolerance.
        found: the sentence with the probability, the tables and the remarks, as the terminal has them.
        kept: the runs that can be played; `point` is the number of the sample.
        count: how many these are.
        csv: the text of `table.csv`.
    """
    ranked = _ranked(indices, deviations)
    data = _data(design, deviations, results)
    names = [each["key"] for each in data["factors"]]
    first = [key for key in ranked if key in names][:8]
    across, upwards = (
        (first + [key for key in names if key not in first])[:2] if len(names) > 1 else (names[0], "margin")
    )
    views = {"lines": [*first, "margin"], "plane": {"x": across, "y": upwards}, "front": [], "best": None}
    return samples_page(
        name=design.name,
        kind="tolerance",
        found=found,
        told=(
            section("What decides it", _indices_table(indices), name="sensitivity"),
            section("How far it is to a failure", _reach_table(design, deviations, reach), name="reach"),
        ),
        data=data,
        views=views,
        headings=("All that was built", "The tolerance"),
        about=_about(design, deviations),
        kept=kept,
        count=count,
        csv=csv,
    )


def _ranked(indices: Dataset, deviations: Sequence[Deviation]) -> list[str]:
    """Keys that decide most first; those without an index of their own last."""
    keys = [str(key) for key in indices["factor"].values]
    total, first = indices["total"].values.astype(float), indices["first"].values.astype(float)
    weight = np.nan_to_num(np.where(np.isnan(total), first, total))
    order = [keys[place] for place in np.argsort(-weight, kind="stable")]
    known = [each.key for each in deviations]
    return [key for key in order if key in known] + [key for key in known if key not in order]


def _data(design: Design, deviations: Sequence[Deviation], results: Dataset) -> dict[str, Any]:
    named = results.assign_attrs(transitions=transitions_text(structure_of(design), None))
    works = results["works"].values.astype(bool)
    by_key = {str(each.attrs.get("key", name)): str(name) for name, each in results.coords.items()}
    keys = [each.key for each in deviations if each.key in by_key]
    return samples_data(
        Samples(
            name=design.name,
            noun="sample",
            keeps="Some of the runs are kept, as many as --keep says.",
            table=results,
            factors=tuple(by_key[key] for key in keys),
            numbers=(Number(variable="margin", title="margin"),),
            words=[_WORKS if does else str(word) for does, word in zip(works, results["outcome"].values, strict=True)],
            signs=signs_of(named, {_WORKS: "●"}),
            statuses=[str(each) for each in results["status"].values],
            built=[str(each) != Verdict.NOT_BUILT for each in results["verdict"].values],
            own={by_key[key]: float(key_value(design, key)) for key in keys},
        )
    )


def _indices_table(indices: Dataset) -> str:
    """Shares of the variance of the margin: what each decides alone, and with others."""
    if indices.sizes["factor"] == 0:
        return ""
    values = {str(name): indices[name].values.astype(float) for name in indices.data_vars}
    weight = np.nan_to_num(np.where(np.isnan(values["total"]), values["first"], values["total"]))
    keys = [str(key) for key in indices["factor"].values]
    rows = []
    # what is left is last, however much it decides
    for place in sorted(range(len(keys)), key=lambda place: (keys[place] == "others", -weight[place])):
        shares = [
            (values[name][place], (values[f"{name}_low"][place], values[f"{name}_high"][place]))
            for name in ("first", "total")
        ]
        drawn = tuple(
            bar(share, kind, interval=ends) for (share, ends), kind in zip(shares, ("first", "second"), strict=True)
        )
        rows.append(
            BarRow(
                name=plain_key(keys[place]),
                lanes=tuple((each,) for each in drawn),
                cells=tuple(map(_share_text, shares)),
            )
        )
    caption = (
        "Shares of the scatter of the margin: what each deviation decides alone, above, and together with others,"
        " below; lines are 95 % intervals"
    )
    return bar_table(caption, ("", "share", "alone", "with others"), rows, (0.0, 1.0))


def _share_text(share: tuple[float, tuple[float, float]]) -> str:
    value, (low, high) = share
    if math.isnan(value):
        return "—"
    return f"{100 * value:.0f} % ({100 * low:.0f} to {100 * high:.0f})".replace("-", "−")


def _reach_table(design: Design, deviations: Sequence[Deviation], reach: Dataset) -> str:
    """How far each deviation alone may go, down and up, in widths of its tolerance."""
    if reach.sizes.get("factor", 0) == 0:
        return ""
    far = reach["reach"] if "reach" in reach else reach[next(iter(reach.data_vars))]
    found = {str(key): far.sel(factor=key) for key in reach["factor"].values}
    finite = far.values[np.isfinite(far.values)]
    scale = max(1.5, float(np.max(finite, initial=0.0)) * 1.05)
    rows = []
    nearest = sorted(
        (each for each in deviations if each.key in found), key=lambda each: float(np.nanmin(found[each.key].values))
    )
    for each in nearest:
        down, up = (float(found[each.key].sel(way=way).values) for way in ("down", "up"))
        drawn = tuple(
            bar(math.copysign(min(size, scale), sign), _near(size))
            for size, sign in ((down, -1), (up, 1))
            if not math.isnan(size)
        )
        rows.append(
            BarRow(
                name=plain_key(each.key),
                lanes=(drawn,),
                cells=(_widths(down), _widths(up)),
                note=deviation_text(design, each),
            )
        )
    caption = (
        "The nearest failure when one value alone is off, in widths of its tolerance: red within it, blue beyond;"
        " a full bar is none that was found"
    )
    return bar_table(caption, ("", "down and up", "down", "up"), rows, (-scale, scale))


def _near(size: float) -> str:
    return "bad" if size <= 1 else "good"


def _widths(size: float) -> str:
    if math.isnan(size):
        return "not tried"
    return "none found" if math.isinf(size) else f"{size:.2f}"


def _about(design: Design, deviations: Sequence[Deviation]) -> list[str]:
    rows = [["design", design.name], *([each.key, deviation_text(design, each)] for each in deviations)]
    return about_rows(rows, design.hash, "", f"forficula tolerance {design.name}")
