"""Page of an identification: values of the unknowns that agree with the observations, and incompatible facts."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
import scipy

from forficula.files import write_text
from forficula.goals.identify.exclusion import Together
from forficula.quantities import show_value
from forficula.show.page.data.samples_data import PointQuantity, ShownSamples, samples_data
from forficula.show.page.parts.bars import BarRow, bar, bar_table, percent_text
from forficula.show.page.parts.html import escaped, paragraph, section
from forficula.show.page.parts.outcome_words import OutcomeSigns
from forficula.show.page.parts.rich_html import PrintedResult
from forficula.show.page.samples_page import about_rows, samples_page
from forficula.show.study.factor_text import plain_name, value_with_unit
from forficula.study.running.kept_runs import KeptRun

if TYPE_CHECKING:
    from xarray import Dataset

_AGREES, _APART, _PLACED, _NOT_RUN = "agrees", "does not agree", "placed, not drawn", "could not run"
_SIGNS = {_AGREES: "●", _APART: "○", _PLACED: "△", _NOT_RUN: "⊘"}
# largest number of unknowns for which plots of all pairs fit into one picture
_MOST_PAIRED = 4
# CSS class for each word of the result, the worst first
_TOGETHER: dict[str, str] = {
    Together.EXCLUDED: "excluded",
    Together.UNTRIED: "rare",
    Together.NEARLY: "rare",
    Together.OPEN: "rare",
    Together.RARE: "rare",
    Together.NEVER: "never",
}


def write_identify_page(
    results: Dataset, printed: PrintedResult, path: Path, kept: Iterable[KeptRun] = (), count: int = 0, csv: str = ""
) -> None:
    """Write an identification as one HTML file that needs no network.

    Args are those of `identify_page`.

    Raises:
        InputError: it cannot be written.
    """
    write_text(path, identify_page(results, printed, kept, count, csv))


def identify_page(
    results: Dataset, printed: PrintedResult, kept: Iterable[KeptRun] = (), count: int = 0, csv: str = ""
) -> str:
    """Return an identification as one page.

    Args:
        results: samples of the unknowns, over "sample" and "fact", from `forficula.goals.identify`.
        printed: the sentence, the tables and the remarks of the terminal.
        kept: runs that the page can play back; `point` is the index of the sample.
        count: number of these runs.
        csv: contents of `samples.csv`.
    """
    data = _data(results)
    ranked = unknowns_by_distance(results)
    keys = {name: item["key"] for name, item in zip(_unknowns(results), data["factors"], strict=True)}
    named = [keys[name] for name in ranked]
    views = {
        "lines": [*named[:8], "facts_met"],
        "plane": {"title": "Two unknowns", "x": named[0], "y": named[1] if len(named) > 1 else "facts_met"},
        "order": ["pairs", "plane", "lines"],
        "best_word": "most facts",
        "pairs": named[:_MOST_PAIRED],
        "marginals": named,
        "front": [],
        "best": _best(results),
    }
    return samples_page(
        name=str(results.attrs["name"]),
        kind="identify",
        printed=printed,
        before=(
            section("Agreement with each fact", _facts_table(results), name="facts"),
            section("Facts met by the same samples", _together_table(results), name="together"),
        ),
        data=data,
        views=views,
        headings=("All samples", "Observations and settings"),
        about=_about(results),
        kept=kept,
        count=count,
        csv=csv,
    )


def _unknowns(results: Dataset) -> list[str]:
    """Return the names of the coordinates that are unknowns."""
    named = results.attrs["unknowns"]
    return [named] if isinstance(named, str) else [str(item) for item in named]


def unknowns_by_distance(results: Dataset) -> list[str]:
    """Return the unknowns, beginning with those about which the facts say most.

    Ranked by the largest distance between the distribution of the samples that agree and that of all drawn samples
    (Kolmogorov and Smirnov).
    """
    agrees, drawn = _flag(results, "agrees"), ~_flag(results, "directed")
    names = _unknowns(results)
    if not agrees.any():
        return names
    far = {}
    for name in names:
        values = results.get(f"{name}_share", results[name]).values
        if values.dtype.kind not in "iuf":
            values = np.unique(values.astype(str), return_inverse=True)[1]
        far[name] = float(scipy.stats.ks_2samp(values[agrees & drawn], values[drawn]).statistic)
    return sorted(names, key=lambda name: -far[name])


def _flag(results: Dataset, name: str) -> Any:
    """Return a flag of every sample; False for all if the result does not have the flag."""
    return results[name].values.astype(bool) if name in results else np.zeros(results.sizes["sample"], dtype=bool)


def _ran(results: Dataset) -> Any:
    return np.isfinite(results["distance"].values).all(axis=1)


def _best(results: Dataset) -> int | None:
    """Return the index of the sample that meets most facts; among equals the one that misses the others least."""
    if not _ran(results).any():
        return None
    met = results["met"].values.sum(axis=1)
    scaled = _scaled(results)
    missing = np.where(_ran(results), np.nan_to_num(scaled / (1 + scaled)).sum(axis=1), np.inf)
    return int(np.lexsort((missing, -met))[0])


def _scaled(results: Dataset) -> Any:
    return results.get("scaled_distance", results["distance"]).values.astype(float)


def _data(results: Dataset) -> dict[str, Any]:
    facts = [str(name) for name in results["fact"].values]
    scaled = _scaled(results)
    met = results["met"].values.astype(bool)
    table = results.assign(facts_met=("sample", met.sum(axis=1).astype(float), {}))
    for number in range(len(facts)):
        table[f"fact_{number}"] = ("sample", scaled[:, number])
    agrees, placed, ran = _flag(results, "agrees"), _flag(results, "directed"), _ran(results)
    words = [
        _NOT_RUN if not runs else _PLACED if later else _AGREES if does else _APART
        for runs, later, does in zip(ran, placed, agrees, strict=True)
    ]
    statuses = [
        f"{word}; meets {int(count)} of {len(facts)} facts" if runs else str(results["status"].values[number])
        for number, (word, count, runs) in enumerate(zip(words, met.sum(axis=1), ran, strict=True))
    ]
    return samples_data(
        ShownSamples(
            name=str(results.attrs["name"]),
            noun="sample",
            file="samples.csv",
            keeps="The runs of samples are used to compare with the facts and are not kept.",
            table=table,
            factors=tuple(_unknowns(results)),
            numbers=(
                PointQuantity(variable="facts_met", title="facts met"),
                *(
                    PointQuantity(variable=f"fact_{number}", title=f"misses: {name}")
                    for number, name in enumerate(facts)
                ),
            ),
            words=words,
            signs=OutcomeSigns(signs=_SIGNS),
            statuses=statuses,
            built=[bool(runs) for runs in ran],
        )
    )


def _facts_table(results: Dataset) -> str:
    """Return a table with the share of drawn samples that meets each fact, and the distances of the others."""
    drawn = ~_flag(results, "directed") & _ran(results)
    met, distance = results["met"].values.astype(bool), results["distance"].values.astype(float)
    rows = []
    for number, name in enumerate(results["fact"].values):
        share = float(met[drawn, number].mean()) if drawn.any() else 0.0
        ends = (share, share)
        if "met_share_low" in results:
            # shares of the samples that decide whether the fact is met
            share = float(results["met_share"].values[number])
            ends = (float(results["met_share_low"].values[number]), float(results["met_share_high"].values[number]))
        far = distance[drawn, number]
        unit = _text(results, "fact_units", number)
        middle, nearest = (_distance(function(far), unit) if len(far) else "—" for function in (np.median, np.min))
        rows.append(
            BarRow(
                name=f"{number + 1}. {name}",
                lanes=((bar(share, "first", interval=ends),),),
                cells=(
                    f"{percent_text(share)} % ({percent_text(ends[0])} to {percent_text(ends[1])})",
                    nearest,
                    middle,
                ),
                note="; ".join(
                    filter(None, (_text(results, "fact_asked", number), _text(results, "fact_source", number)))
                ),
            )
        )
    caption = (
        "Share of the drawn samples that meet each fact, with its 95 % interval, and the distance to the fact of the"
        " nearest and of the median sample"
    )
    return bar_table(caption, ("fact", "met by", "share", "nearest", "median"), rows, (0.0, 1.0))


def _distance(value: float, unit: str) -> str:
    return "met" if value == 0 else show_value(float(value), unit) if unit else f"{value:.3g}"


def _text(results: Dataset, name: str, number: int) -> str:
    return str(results[name].values[number]) if name in results else ""


def _together_table(results: Dataset) -> str:
    """Return a table with the number of samples that meet each pair of facts; incompatible pairs are marked."""
    facts = [str(name) for name in results["fact"].values]
    if len(facts) < 2:
        return ""
    met = results["met"].values.astype(int)
    counts = met.T @ met
    head = "".join(
        f'<th scope="col"><abbr title="{escaped(name)}">{number + 1}</abbr></th>' for number, name in enumerate(facts)
    )
    body = "".join(
        f'<tr><th scope="row">{number + 1}. {escaped(name)}</th>'
        + "".join(_together_cell(results, counts, number, other) for other in range(len(facts)))
        + "</tr>"
        for number, name in enumerate(facts)
    )
    caption = f"Number of the {len(met)} samples that meet both facts; on the diagonal, one fact"
    note = paragraph(_together_words(results, facts), "note")
    return (
        f'<div class="table" tabindex="0" role="group" aria-label="{escaped(caption)}"><table class="numbers together">'
        f"<caption>{escaped(caption)}</caption><thead><tr><td></td>{head}</tr></thead><tbody>{body}</tbody></table></div>"
        f"{note}"
    )


def _together_cell(results: Dataset, counts: Any, one: int, other: int) -> str:
    count = int(counts[one, other])
    word = str(results["together"].values[one, other]) if "together" in results else ""
    look = "own" if one == other else _TOGETHER.get(word, "met" if count else "never")
    sign = {"excluded": "✕ ", "rare": "? "}.get(look, "")
    share = 100 * count / max(int(counts.max()), 1)
    return f'<td class="{look}" style="--share:{share:.0f}%">{sign}{count}</td>'


def _together_words(results: Dataset, facts: list[str]) -> str:
    """Return sentences about incompatible pairs of facts, and about pairs that no sample happens to meet."""
    if "together" not in results:
        return ""
    words = results["together"].values
    pairs = [(one, other) for one in range(len(facts)) for other in range(one + 1, len(facts))]
    excluded = [f"{one + 1} and {other + 1}" for one, other in pairs if str(words[one, other]) == Together.EXCLUDED]
    text = (
        f"✕ some samples meet each of the two facts, but none, drawn or placed, meets both: {', '.join(excluded)}."
        if excluded
        else ""
    )
    open_ = any(_TOGETHER.get(str(words[one, other])) == "rare" for one, other in pairs)
    more = " ? no sample meets both, but some values might." if open_ else ""
    return f"{text}{more}".strip()


def _about(results: Dataset) -> list[str]:
    attributes = results.attrs
    rows = [["design", str(attributes["design"])]]
    for name in _unknowns(results):
        coordinate = results[name]
        kind = str(coordinate.attrs.get("prior", ""))
        rows.append([f"unknown: {plain_name(coordinate)}", _span(coordinate, kind)])
    rows += [[f"{key}", str(attributes[key])] for key in ("drawn", "placed", "runs", "seed") if key in attributes]
    return about_rows(
        rows,
        str(attributes["design_hash"]),
        str(attributes.get("source", "")),
        f"forficula identify {attributes['name']}",
    )


def _span(coordinate: Any, kind: str) -> str:
    values = coordinate.values
    if values.dtype.kind not in "iuf":
        return ", ".join(dict.fromkeys(str(value) for value in values))
    ends = (value_with_unit(coordinate, int(place)) for place in (np.argmin(values), np.argmax(values)))
    return f"{' to '.join(ends)}{f', {kind}' if kind else ''}"
