"""Files of a tolerance analysis, in addition to its journal."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import numpy as np

from forficula.csv_text import csv_text
from forficula.design import key_value, save_design
from forficula.design.design import DesignIdentity
from forficula.dynamics import versions
from forficula.files import replacing_all, write_bytes, write_text
from forficula.goals.deviation import deviation_widths
from forficula.goals.tolerance import Tolerance
from forficula.goals.tolerance.advice import advice, tighten_first
from forficula.goals.tolerance.indices import Values
from forficula.goals.tolerance.narrowing import Narrowed
from forficula.goals.tolerance.nearest_failure import Answer, Reach
from forficula.goals.tolerance.plan import Plan
from forficula.goals.tolerance.probability import Probability
from forficula.goals.tolerance.question import MARGIN
from forficula.goals.tolerance.tolerance_table import tolerance_of_table, tolerance_table
from forficula.serial import Written, json_text, unit_suffix
from forficula.show.folder.notebook_cell import first_figure, heading, numbers
from forficula.show.folder.presentation import Presentation, read_dataset
from forficula.show.goals.tolerance_figures import draw_cloud, draw_indices, draw_reaches
from forficula.show.goals.tolerance_text import tolerance_text
from forficula.show.page.parts.html import paragraph
from forficula.show.page.parts.rich_html import printed_result
from forficula.show.page.tolerance_page import VerdictGrid, write_tolerance_page
from forficula.show.style import Drawing, save_figures
from forficula.study.running.kept_runs import KeptRun

if TYPE_CHECKING:
    from xarray import Dataset

TOLERANCE_FILE, TOLERANCE_TABLE = "tolerance.json", "tolerance.nc"


def write_tolerance(tolerance: Tolerance, folder: Path) -> Dataset:
    """Write design.toml, tolerance.json, tolerance.nc, table.csv and the figures; all of them, or none.

    Args:
        tolerance: the result.
        folder: folder with the journal; files of an earlier result are replaced.

    Returns:
        Table that was written.

    Raises:
        InputError: the folder cannot be written.
    """
    table = tolerance_table(tolerance)
    with replacing_all(folder) as unfinished:
        _write_files(tolerance, table, unfinished)
    return table


def _write_files(tolerance: Tolerance, table: Dataset, folder: Path) -> None:
    save_design(tolerance.question.design, folder / "design.toml")
    write_text(folder / TOLERANCE_FILE, json_text(tolerance_summary(tolerance)))
    write_text(folder / "table.csv", _samples_csv(table))
    write_bytes(folder / TOLERANCE_TABLE, table.to_netcdf(engine="h5netcdf"))
    save_figures(tolerance_drawings(table), folder)


def write_tolerance_report(tolerance: Tolerance, kept: Iterable[KeptRun], count: int, folder: Path) -> None:
    """Write the page of a tolerance analysis, `report.html`.

    Args:
        tolerance: the result.
        kept: runs to play back, read one after another.
        count: number of these runs.
        folder: folder of the results.

    Raises:
        InputError: it cannot be written.
    """
    question, table = tolerance.question, tolerance_table(tolerance)
    write_tolerance_page(
        question.design,
        question.deviations,
        table,
        printed_result(tolerance_text(tolerance)),
        folder / "report.html",
        kept,
        count,
        _samples_csv(table),
        _verdict_cells(tolerance),
    )


def _verdict_cells(tolerance: Tolerance) -> VerdictGrid | None:
    """Return the map of verdicts over values, not over widths of tolerances; None without a map."""
    if tolerance.map is None:
        return None
    question, factors = tolerance.question, (tolerance.map.first, tolerance.map.second)
    nominal = [float(key_value(question.design, question.keys[factor])) for factor in factors]
    widths = deviation_widths(question.design, [question.deviations[factor] for factor in factors])
    across, upwards = (
        value + steps * width for value, steps, width in zip(nominal, tolerance.map.steps, widths, strict=True)
    )
    works = (tolerance.map.samples.answers == Answer.WORKS).reshape(len(across), len(upwards))
    first, second = (question.keys[factor] for factor in factors)
    return VerdictGrid(
        first=first, second=second, across=across.tolist(), upwards=upwards.tolist(), works=works.tolist()
    )


def tolerance_drawings(table: Dataset) -> dict[str, Drawing]:
    """Return the drawings of a tolerance analysis by the stems of their files; those without data are left out."""
    drawings: dict[str, Drawing] = {}
    if np.isfinite(table["first_index"].values[0]).any():
        drawings["indices"] = lambda width: draw_indices(table, width)
    if "map_outcome" in table:
        drawings["cloud"] = lambda width: draw_cloud(table, width)
    if np.isfinite(table["works_down"].values).any():
        drawings["reaches"] = lambda width: draw_reaches(table, width)
    return drawings


@dataclass(frozen=True, kw_only=True)
class ToleranceSummary:
    """Tolerance analysis as in `tolerance.json`. Deviations of a value are in units of its tolerance."""

    design: Annotated[DesignIdentity, Written.BESIDE]
    nominal: str
    works: Probability
    probabilities: Mapping[str, Probability]
    outcomes: Mapping[str, int]
    tighten_first: str | None
    says: Sequence[str]
    tolerances: Mapping[str, str]
    tolerances_given: bool
    limits: Sequence[str]
    meets_limits_on_probability: bool
    indices: Mapping[str, Mapping[str, Mapping[str, Mapping[str, float] | None]]]
    gains_of_half: Mapping[str, Narrowed]
    alone_in_tolerances: Mapping[str, Mapping[str, Reach]]
    nearest_failure_in_tolerances: Mapping[str, float] | None
    runs: int
    plan: Plan
    seed: int
    versions: Mapping[str, str]


def tolerance_summary(tolerance: Tolerance) -> ToleranceSummary:
    """Return the contents of `tolerance.json`."""
    question, indices = tolerance.question, tolerance.indices
    tightest = tighten_first(tolerance)
    return ToleranceSummary(
        design=question.design.identity,
        nominal=str(tolerance.nominal.outcomes[0]),
        works=tolerance.probability,
        probabilities=tolerance.probabilities,
        outcomes=tolerance.outcomes,
        tighten_first=None if tightest is None else question.keys[tightest],
        says=advice(tolerance),
        tolerances={key: question.width_text(factor) for factor, key in enumerate(question.keys)},
        tolerances_given=not question.assumed,
        limits=[str(limit) for limit in (*question.limits, *question.wanted)],
        meets_limits_on_probability=tolerance.meets,
        indices={
            result: {
                group: {
                    "first": _three(indices.first, indices.first_low, indices.first_high, row, column),
                    "total": _three(indices.total, indices.total_low, indices.total_high, row, column),
                }
                for column, group in enumerate(indices.groups)
            }
            for row, result in enumerate(indices.results)
        },
        gains_of_half=dict(zip(question.keys, tolerance.narrowed, strict=True)),
        alone_in_tolerances={
            key: {"down": down, "up": up} for key, (down, up) in zip(question.keys, tolerance.reaches, strict=False)
        },
        nearest_failure_in_tolerances=None
        if tolerance.nearest is None
        else dict(zip(question.keys, tolerance.nearest.offsets.tolist(), strict=True)),
        runs=tolerance.runs,
        plan=tolerance.plan,
        seed=tolerance.seed,
        versions=versions(),
    )


def _three(value: Values, low: Values, high: Values, row: int, column: int) -> dict[str, float] | None:
    if not np.isfinite(value[row, column]):
        return None
    return {name: float(item[row, column]) for name, item in (("index", value), ("low", low), ("high", high))}


def _samples_csv(table: Dataset) -> str:
    """Return a line for every sample: its values in SI, its outcome and its margins; headings have units."""
    factors = [name for name in table.coords if table[name].dims == ("sample",)]
    headings = [f"{name}{unit_suffix(table[name].attrs['units'])}" for name in factors]
    results = [f"{name} margin" if name != MARGIN else MARGIN for name in table["result"].values.tolist()]
    columns = [*(table[name].values for name in factors), table["answer"].values, table["outcome"].values]
    columns += list(table["margin"].values)
    rows = [
        [value if isinstance(value, str) else f"{value:.9g}" for value in row] for row in zip(*columns, strict=True)
    ]
    return csv_text([[*headings, "answer", "outcome", *results], *rows])


def _cell(table: Dataset) -> Iterator[str]:
    first, *others = str(table.attrs["says"]).splitlines()
    yield heading(f"{table.attrs['design']}: {first}")
    yield from map(paragraph, others)
    yield first_figure(tolerance_drawings(table))
    yield numbers(table)


def _write(table: Dataset, folder: Path) -> None:
    """Write a tolerance analysis without kept runs: its page plays none."""
    tolerance = tolerance_of_table(table)
    write_tolerance(tolerance, folder)
    write_tolerance_report(tolerance, (), 0, folder)


PRESENTATION = Presentation(
    drawings=tolerance_drawings,
    cell=_cell,
    read=lambda folder: tolerance_drawings(read_dataset(folder / TOLERANCE_TABLE)),
    write=_write,
)
