"""The files that an identification leaves beside the rows of its runs."""

from __future__ import annotations

import itertools
import json
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from forficula.csv_text import csv_text
from forficula.files import replacing_all, write_bytes, write_text
from forficula.goals.identify.marginal import marginals, unknowns_of
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
from forficula.show.page.rich_html import laid_out
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
        told = json.dumps(identification_json(result), indent=2, ensure_ascii=False, allow_nan=False)
        write_text(unfinished / IDENTIFIED_FILE, told + "\n")
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


def identification_json(result: Dataset) -> dict[str, Any]:
    """What came out as plain data: the facts, how often each and each pair is met, and what agrees."""
    told = result.attrs
    return {
        **{name: str(told[name]) for name in ("name", "design")},
        # whole numbers of a file are those of numpy
        **{name: int(told[name]) for name in ("drawn", "placed", "could_not_run", "runs", "most_met")},
        "facts": [_fact_json(result.isel(fact=number)) for number in range(result.sizes["fact"])],
        "pairs": [
            _pair_json(result.isel(fact=one, other_fact=other), float(result["met_alone"].values[other, one]))
            for one, other in itertools.combinations(range(result.sizes["fact"]), 2)
        ],
        "between": {
            "emulated": bool(told["emulated"]),
            "share": _finite(told["between_share"]),
            "apart": _finite(told["between_apart"]),
            "possible": bool(told["between_possible"]),
        },
        "sentences": together_sentences(result),
        "agrees_sentences": agrees_sentences(result),
        "unknowns": [
            {
                "key": each.key,
                "units": str(result[each.name].attrs.get("units", "")),
                "believed": [_plain(end) for end in each.believed],
                "agrees": [_plain(end) for end in each.agrees],
                "chance": each.chance,
            }
            for each in marginals(result)
        ],
    }


def _fact_json(fact: Dataset) -> dict[str, Any]:
    distances = fact["distance"].values
    known = distances[np.isfinite(distances)]
    return {
        "name": str(fact["fact"].values),
        "asked": str(fact["fact_asked"].values),
        "units": str(fact["fact_units"].values),
        "told": int(fact["told"]),
        "met": int((fact["met"].values & ~fact["directed"].values).sum()),
        "share": [float(fact[f"met_share{end}"]) for end in ("", "_low", "_high")],
        "nearest": float(known.min()) if len(known) else None,
    }


def _pair_json(pair: Dataset, other_alone: float) -> dict[str, Any]:
    """Two facts and how far they are met together; counts are of drawn samples that tell of both."""
    near = float(pair["together_near"])
    return {
        "facts": [str(pair["fact"].values), str(pair["other_fact"].values)],
        "told": int(pair["told_together"]),
        "met": int(pair["met_together"]),
        "met_alone": [int(pair["met_alone"]), int(other_alone)],
        "met_if_independent": float(pair["together_if_independent"]),
        "largest_share": float(pair["together_share_high"]),
        "placed_to": int(pair["tried_together"]),
        "met_by_placed": int(pair["met_together_placed"]),
        "nearest_in_scales": near if np.isfinite(near) else None,
        "verdict": str(pair["together"].values),
    }


def _finite(value: float) -> float | None:
    return float(value) if np.isfinite(value) else None


def _plain(value: object) -> object:
    """A number, or a word, as JSON has it."""
    return float(value) if isinstance(value, float | int) else value


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
