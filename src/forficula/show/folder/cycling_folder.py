"""Files of a cycling analysis: a table, JSON, a figure, and a section on the page of the run."""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import chain
from pathlib import Path
from typing import Annotated, Any

from rich.console import Console

from forficula.analysis.summary import drive_strength
from forficula.csv_text import csv_table
from forficula.design import load_design
from forficula.design.design import DesignIdentity
from forficula.dynamics import versions
from forficula.errors import InputError
from forficula.files import replacing_all, write_text
from forficula.serial import WithUnit, Written, json_text
from forficula.show.folder.notebook_cell import first_figure
from forficula.show.folder.presentation import Presentation
from forficula.show.page.parts.html import Cell, paragraph, remarks, section, table
from forficula.show.page.parts.run_sentences import readable
from forficula.show.page.results_page import figure_html, read_page, with_section
from forficula.show.run.cycling_figure import draw_cycling
from forficula.show.style import Drawing, figure_files, save_figures
from forficula.structure import Structure, structure_of
from forficula.study.cycling import CycleRun, Cycling, driven_transitions

CYCLING_FILES = ("cycles.csv", "cycles.json", *figure_files("cycles"))
_STIFFNESS = ("stiffness_by_first", "stiffness_by_first_low_95", "stiffness_by_first_high_95")
_NONE = "—"


def write_cycling(cycling: Cycling, folder: Path) -> None:
    """Write cycles.csv, cycles.json and the figure, and show them on the run's page; all of it, or nothing.

    Args:
        cycling: the analysis.
        folder: folder of the run; files of an earlier analysis are replaced.

    Raises:
        InputError: the folder cannot be written.
    """
    with replacing_all(folder) as unfinished:
        write_text(unfinished / "cycles.csv", cycling_csv(cycling))
        write_text(unfinished / "cycles.json", json_text(cycling_summary(cycling)))
        texts = save_figures(cycling_drawings(cycling), unfinished)
        if (page := read_page(folder)) is not None:
            drawn = figure_html(unfinished, "cycles", texts["cycles"])
            write_text(unfinished / "report.html", with_section(page, "cycles", cycling_section(cycling, drawn)))


def cycling_drawings(cycling: Cycling) -> dict[str, Drawing]:
    """Return the drawings of a cycling analysis by the stems of their files."""
    return {"cycles": lambda width: draw_cycling(cycling, width)}


def cycling_rows(cycling: Cycling) -> list[dict[str, Any]]:
    """Return a row for every cycle as plain data with units in its keys; None for missing numbers."""
    structure = structure_of(cycling.design)
    return [
        {
            "cycle": run.cycle,
            "measured": run.measured,
            **dict(zip(_STIFFNESS, run.stiffness, strict=True)),
            "residual_strain": run.residual_strain,
            **{name: run.row.get(name) for name in _columns(structure)},
            **{f"{transition.name}_margin": run.margins.get(transition.name) for transition in structure.transitions},
        }
        for run in cycling.runs
    ]


def _columns(structure: Structure) -> list[str]:
    """Return the columns kept from the row of a run: status, states reached, energies, times and works."""
    transitions = structure.transitions
    return [
        "status",
        *(transition.state for transition in transitions),
        *(f"{state.name}_energy_J" for state in structure.states),
        *(f"{transition.name}_{number}" for transition in transitions for number in ("time_s", "work_J")),
    ]


def cycling_csv(cycling: Cycling) -> str:
    """Return the rows as text; missing numbers are empty."""
    return csv_table(cycling_rows(cycling))


@dataclass(frozen=True, kw_only=True)
class CyclingSummary:
    """Cycling analysis as in `cycles.json`, with the strengths of the drives."""

    design: Annotated[DesignIdentity, Written.BESIDE]
    verdict: str
    remarks: Sequence[str]
    seen_cycles: tuple[int, int] | None
    first_failure: int | None
    drives: Annotated[Mapping[str, WithUnit], Written.BESIDE]
    cycles: Sequence[Mapping[str, Any]]
    versions: Mapping[str, str]


def cycling_summary(cycling: Cycling) -> CyclingSummary:
    """Return the contents of `cycles.json`."""
    structure = structure_of(cycling.design)
    return CyclingSummary(
        design=cycling.design.identity,
        verdict=cycling.verdict,
        remarks=cycling.remarks,
        seen_cycles=cycling.seen,
        first_failure=cycling.first_failure,
        drives={
            f"{drive.name}_{kind}": strength
            for drive in structure.drives
            for kind, strength in drive_strength(structure, drive).items()
        },
        cycles=cycling_rows(cycling),
        versions=versions(),
    )


def read_cycling(folder: Path) -> Cycling:
    """Read the files that `write_cycling` wrote into the folder of a run.

    Raises:
        InputError: a file cannot be read, or belongs to another design than the run.
    """
    path = folder / "cycles.json"
    design = load_design(str(folder / "design.toml"))
    try:
        content = json.loads(path.read_text("utf-8"))
        structure = structure_of(design)
        runs = tuple(_cycle_run(row, structure) for row in content["cycles"])
        same = content["design_hash"] == design.hash
        seen = None if content["seen_cycles"] is None else tuple(content["seen_cycles"])
        verdict, remarks = content["verdict"], tuple(content["remarks"])
    except (OSError, LookupError, ValueError, TypeError) as error:
        raise InputError(f"{path}: not cycles of forficula: {' '.join(str(error).split())}") from None
    if not same:
        raise InputError(f"{path}: of another design than {folder / 'design.toml'}")
    return Cycling(
        design=design,
        runs=runs,
        seen=seen,
        transitions=driven_transitions(structure),
        verdict=verdict,
        remarks=remarks,
    )


def _cycle_run(row: dict[str, Any], structure: Structure) -> CycleRun:
    return CycleRun(
        cycle=row["cycle"],
        measured=row["measured"],
        stiffness=tuple(row[name] for name in _STIFFNESS),
        residual_strain=row["residual_strain"],
        row={name: row[name] for name in _columns(structure)},
        margins={transition.name: row[f"{transition.name}_margin"] for transition in structure.transitions},
    )


def print_cycling(cycling: Cycling) -> None:
    """Print the verdict of a cycling analysis and its remarks."""
    console = Console(width=110, highlight=False)
    console.print(f"\nCycles: {cycling.verdict}", markup=False)
    runs = cycling.runs
    for transition in cycling.transitions:
        name = transition.name
        first, last = (run.margins[name] for run in (runs[0], runs[-1]))
        if first is not None and last is not None:
            text = f"{first:.3g} at cycle 1, {last:.3g} at cycle {runs[-1].cycle}"
            console.print(f"  ratio of the {name} torque to the least slow torque: {text}")
    for remark in cycling.remarks:
        console.print(f"  {remark}", markup=False, soft_wrap=True)


def _cell(cycling: Cycling) -> Iterator[str]:
    yield from map(paragraph, (f"Cycles: {cycling.verdict}", *cycling.remarks))
    yield first_figure(cycling_drawings(cycling))


PRESENTATION = Presentation(
    drawings=cycling_drawings,
    cell=_cell,
    read=lambda folder: cycling_drawings(read_cycling(folder)),
    write=write_cycling,
)


def cycling_section(cycling: Cycling, drawn: str) -> str:
    """Return the section of the page: the verdict, the figure as HTML, a row for every cycle, and remarks."""
    driven = [(transition, transition.wording.doing) for transition in cycling.transitions]
    headings = ["cycle", "stiffness relative to cycle 1", "residual strain"]
    headings += [f"{doing}: {what}" for _, doing in driven for what in ("time", "work", "margin")]
    return section(
        "Over cycles",
        paragraph(f"{cycling.verdict[:1].upper()}{cycling.verdict[1:]}.".replace(" -", " −")),
        drawn,
        table("Simulated cycles", [*headings, "status"], [_row(cycling, run) for run in cycling.runs]),
        remarks(cycling.remarks),
        name="cycles",
    )


def _row(cycling: Cycling, run: CycleRun) -> list[str | Cell]:
    """Return the row of a cycle; extrapolated and failed cycles are marked."""
    value, *bounds = run.stiffness
    low, high = (f"{bound:.3g}" for bound in bounds)
    numbers = chain.from_iterable(
        (
            _number(run.row.get(f"{transition.name}_time_s"), "s"),
            _number(run.row.get(f"{transition.name}_work_J"), "J"),
            _number(run.margins.get(transition.name), ""),
        )
        for transition in cycling.transitions
    )
    return [
        Cell(text=str(run.cycle), note="" if run.measured else "extrapolated"),
        f"{value:.3g} ({low} to {high})",
        f"{100 * run.residual_strain:.3g} %".replace("-", "−"),
        *numbers,
        Cell(text=str(run.row["status"]).replace(" -", " −"), marked=not cycling.works(run)),
    ]


def _number(value: float | None, unit: str) -> str:
    if value is None:
        return _NONE
    return readable(value, unit) if unit else f"{value:.3g}"
