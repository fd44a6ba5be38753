"""The files that an identification leaves beside the rows of its runs."""

from __future__ import annotations

import itertools
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from forficula.csv_text import csv_text
from forficula.files import replacing_all, write_bytes, write_text
from forficula.goals.identify.marginal import marginals, unknowns_of
from forficula.serial import json_text
from forficula.show.folder.cell import first_figure, numbers, printed
from forficula.show.folder.presentation import Presentation, read_dataset
from forficula.show.goals.identify_figures import identify_drawings
from forficula.show.goals.identify_text import (
    agrees_sentences,
    first_sentence,
    identification_text,
    together_sentences,
)
from forficula.show.page.identify_page import write_identify_page
from forficula.show.page.parts.rich_html import laid_out
from forficula.show.style import save_figures

if TYPE_CHECKING:
    from xarray import Dataset

IDENTIFIED, IDENTIFIED_FILE = "identified.nc", "identified.json"
_SUMMARY = "summary.txt"


def write_identification(result: Dataset, folder: Path) -> None:
    """Write an identification: table, what it says as JSON and in sentences, figures and page; all of them, or none.

    Args:
        result: what came out.
        folder: of the identification; what an earlier result left there is replaced.

    Raises:
        InputError: a file cannot be written.
    """
    with replacing_all(folder) as unfinished:
        write_bytes(unfinished / IDENTIFIED, result.to_netcdf(engine="h5netcdf"))
        write_text(unfinished / IDENTIFIED_FILE, json_text(identification_summary(result)))
        csv = samples_csv(result)
        write_text(unfinished / "samples.csv", csv)
        write_text(
            unfinished / _SUMMARY,
            "\n".join([first_sentence(result), *together_sentences(result), *agrees_sentences(result)]) + "\n",
        )
        save_figures(identify_drawings(result), unfinished)
        write_identify_page(result, laid_out(identification_text(result)), unfinished / "report.html", csv=csv)


def samples_csv(result: Dataset) -> str:
    """A line for every sample: its values in SI, by how much it misses each fact, and how many it meets."""
    names = unknowns_of(result)
    units = [str(result[name].attrs.get("units", "")) for name in names]
    facts = [str(name) for name in result["fact"].values]
    of_facts = [
        f"{name} ({unit})" if unit else name for name, unit in zip(facts, result["fact_units"].values, strict=True)
    ]
    headings = [f"{name} ({unit})" if unit else name for name, unit in zip(names, units, strict=True)]
    distances, met = result["distance"].values, result["met"].values
    rows: list[list[Any]] = []
    for sample in range(result.sizes["sample"]):
        values = [result[name].values[sample] for name in names]
        missed = ["" if np.isnan(each) else float(each) for each in distances[sample]]
        kind = "placed" if result["directed"].values[sample] else "drawn"
        rows.append([kind, *values, *missed, int(met[sample].sum()), str(result["status"].values[sample])])
    return csv_text([["sample", *headings, *of_facts, "facts met", "status"], *rows])


@dataclass(frozen=True, kw_only=True)
class FactSummary:
    """A fact and the drawn samples that meet it. Distances from the fact are in its units."""

    name: str
    asked: str
    units: str
    told: int
    met: int
    share: Sequence[float]
    nearest: float | None


@dataclass(frozen=True, kw_only=True)
class PairSummary:
    """Two facts and how far they are met together. Counts are of drawn samples that have both."""

    facts: tuple[str, str]
    told: int
    met: int
    met_alone: tuple[int, int]
    met_if_independent: float
    largest_share: float
    placed_to: int
    met_by_placed: int
    nearest_in_scales: float
    verdict: str


@dataclass(frozen=True, kw_only=True)
class BetweenSummary:
    """Samples between those that ran, whose facts a model predicts."""

    emulated: bool
    share: float
    apart: float
    possible: bool


@dataclass(frozen=True, kw_only=True)
class UnknownSummary:
    """An unknown: its values in the drawn samples, those that agree, and the chance that facts do not narrow it."""

    key: str
    units: str
    believed: Sequence[float | str]
    agrees: Sequence[float | str]
    chance: float


@dataclass(frozen=True, kw_only=True)
class IdentificationSummary:
    """The result of an identification, as `identified.json` has it."""

    name: str
    design: str
    drawn: int
    placed: int
    could_not_run: int
    runs: int
    most_met: int
    facts: Sequence[FactSummary]
    pairs: Sequence[PairSummary]
    between: BetweenSummary
    sentences: Sequence[str]
    agrees_sentences: Sequence[str]
    unknowns: Sequence[UnknownSummary]


def identification_summary(result: Dataset) -> IdentificationSummary:
    """Return an identification as `identified.json` has it."""
    told = result.attrs
    return IdentificationSummary(
        name=str(told["name"]),
        design=str(told["design"]),
        drawn=told["drawn"],
        placed=told["placed"],
        could_not_run=told["could_not_run"],
        runs=told["runs"],
        most_met=told["most_met"],
        facts=[_fact(result.isel(fact=number)) for number in range(result.sizes["fact"])],
        pairs=[
            _pair(result.isel(fact=one, other_fact=other), int(result["met_alone"].values[other, one]))
            for one, other in itertools.combinations(range(result.sizes["fact"]), 2)
        ],
        between=BetweenSummary(
            emulated=bool(told["emulated"]),
            share=float(told["between_share"]),
            apart=float(told["between_apart"]),
            possible=bool(told["between_possible"]),
        ),
        sentences=together_sentences(result),
        agrees_sentences=agrees_sentences(result),
        unknowns=[
            UnknownSummary(
                key=each.key,
                units=str(result[each.name].attrs.get("units", "")),
                believed=[_number(end) for end in each.believed],
                agrees=[_number(end) for end in each.agrees],
                chance=each.chance,
            )
            for each in marginals(result)
        ],
    )


def _fact(fact: Dataset) -> FactSummary:
    distances = fact["distance"].values
    known = distances[np.isfinite(distances)]
    return FactSummary(
        name=str(fact["fact"].values),
        asked=str(fact["fact_asked"].values),
        units=str(fact["fact_units"].values),
        told=int(fact["told"]),
        met=int((fact["met"].values & ~fact["directed"].values).sum()),
        share=[float(fact[f"met_share{end}"]) for end in ("", "_low", "_high")],
        nearest=float(known.min()) if len(known) else None,
    )


def _pair(pair: Dataset, other_alone: int) -> PairSummary:
    return PairSummary(
        facts=(str(pair["fact"].values), str(pair["other_fact"].values)),
        told=int(pair["told_together"]),
        met=int(pair["met_together"]),
        met_alone=(int(pair["met_alone"]), other_alone),
        met_if_independent=float(pair["together_if_independent"]),
        largest_share=float(pair["together_share_high"]),
        placed_to=int(pair["tried_together"]),
        met_by_placed=int(pair["met_together_placed"]),
        nearest_in_scales=float(pair["together_near"]),
        verdict=str(pair["together"].values),
    )


def _number(value: object) -> float | str:
    """Return a number, or a word."""
    return float(value) if isinstance(value, float | int) else str(value)


def _cell(result: Dataset) -> Iterator[str]:
    # a part of the table has no sentences
    if result.sizes.keys() >= {"sample", "fact", "other_fact"} and "most_met" in result.attrs:
        yield from printed(identification_text(result))
        yield first_figure(identify_drawings(result))
    yield numbers(result)


PRESENTATION = Presentation(
    drawings=identify_drawings,
    cell=_cell,
    read=lambda folder: identify_drawings(read_dataset(folder / IDENTIFIED)),
    write=write_identification,
)
