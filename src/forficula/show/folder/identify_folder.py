"""Files of an identification, in addition to the rows of its runs."""

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
from forficula.show.folder.notebook_cell import first_figure, numbers, printed
from forficula.show.folder.presentation import Presentation, read_dataset
from forficula.show.goals.identify_figures import identify_drawings
from forficula.show.goals.identify_text import (
    agrees_sentences,
    first_sentence,
    identification_text,
    together_sentences,
)
from forficula.show.page.identify_page import write_identify_page
from forficula.show.page.parts.rich_html import printed_result
from forficula.show.style import save_figures

if TYPE_CHECKING:
    from xarray import Dataset

IDENTIFIED, IDENTIFIED_FILE = "identified.nc", "identified.json"
_SUMMARY = "summary.txt"


def write_identification(result: Dataset, folder: Path) -> None:
    """Write the table, a summary as JSON and as text, the figures and the page of an identification; all, or none.

    Args:
        result: table of the identification.
        folder: folder of the identification; files of an earlier result are replaced.

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
        write_identify_page(result, printed_result(identification_text(result)), unfinished / "report.html", csv=csv)


def samples_csv(result: Dataset) -> str:
    """Return a line for every sample: its values in SI, its distance to each fact, and the number of facts met."""
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
        missed = ["" if np.isnan(distance) else float(distance) for distance in distances[sample]]
        kind = "placed" if result["directed"].values[sample] else "drawn"
        rows.append([kind, *values, *missed, int(met[sample].sum()), str(result["status"].values[sample])])
    return csv_text([["sample", *headings, *of_facts, "facts met", "status"], *rows])


@dataclass(frozen=True, kw_only=True)
class FactSummary:
    """Fact and the drawn samples that meet it. Distances are in the fact's units."""

    name: str
    asked: str
    units: str
    told: int
    met: int
    share: Sequence[float]
    nearest: float | None


@dataclass(frozen=True, kw_only=True)
class PairSummary:
    """Two facts and the samples that meet both. Counts are of drawn samples that decide both facts."""

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
    """Prediction, by a fitted model, of the facts between the samples that ran."""

    emulated: bool
    share: float
    apart: float
    possible: bool


@dataclass(frozen=True, kw_only=True)
class UnknownSummary:
    """Unknown: ranges of all drawn samples and of those that agree, and the chance that the facts do not narrow it."""

    key: str
    units: str
    believed: Sequence[float | str]
    agrees: Sequence[float | str]
    chance: float


@dataclass(frozen=True, kw_only=True)
class IdentificationSummary:
    """Identification as in `identified.json`."""

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
    """Return the contents of `identified.json`."""
    attributes = result.attrs
    return IdentificationSummary(
        name=str(attributes["name"]),
        design=str(attributes["design"]),
        drawn=attributes["drawn"],
        placed=attributes["placed"],
        could_not_run=attributes["could_not_run"],
        runs=attributes["runs"],
        most_met=attributes["most_met"],
        facts=[_fact(result.isel(fact=number)) for number in range(result.sizes["fact"])],
        pairs=[
            _pair(result.isel(fact=one, other_fact=other), int(result["met_alone"].values[other, one]))
            for one, other in itertools.combinations(range(result.sizes["fact"]), 2)
        ],
        between=BetweenSummary(
            emulated=bool(attributes["emulated"]),
            share=float(attributes["between_share"]),
            apart=float(attributes["between_apart"]),
            possible=bool(attributes["between_possible"]),
        ),
        sentences=together_sentences(result),
        agrees_sentences=agrees_sentences(result),
        unknowns=[
            UnknownSummary(
                key=marginal.key,
                units=str(result[marginal.name].attrs.get("units", "")),
                believed=[_number(end) for end in marginal.believed],
                agrees=[_number(end) for end in marginal.agrees],
                chance=marginal.chance,
            )
            for marginal in marginals(result)
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
    """Return a number as a float, anything else as text."""
    return float(value) if isinstance(value, float | int) else str(value)


def _cell(result: Dataset) -> Iterator[str]:
    # an excerpt of the table has no sentences
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
