"""Commands about one run: make it, look at it, compare it."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Literal

from cyclopts import Parameter

from forficula.errors import InputError, error_prefix
from forficula.options import (
    WHOLE_NUMBER,
    DesignName,
    DrawingUnit,
    NoEngine,
    OkIf,
    Out,
    OutIfGiven,
    Settings,
    Tolerate,
    check_folder,
    check_verdicts,
    exit_status,
    read_option,
    read_settings,
    read_size,
    read_unit,
    tell_replaced,
    tell_written,
)

if TYPE_CHECKING:
    from forficula.analysis import Verdict
    from forficula.design import Design


def run(
    design: DesignName,
    /,
    *,
    settings: Settings = None,
    unit: DrawingUnit = None,
    out: Annotated[OutIfGiven, Parameter(help="Folder for the results; out/<name of the design> if not given.")] = None,
    cycles: Annotated[
        int | None,
        WHOLE_NUMBER,
        Parameter(help="Fold and open again with the tendons as they are up to this cycle, as in 100."),
    ] = None,
    no_confirm: Annotated[
        bool,
        Parameter(
            negative=(),
            help="Leave out the second runs, at half the timestep and from a slightly different start, that confirm the"
            " verdict and give numbers their uncertainty.",
        ),
    ] = False,
    no_engine: NoEngine = False,
    figures: Annotated[
        str | None,
        Parameter(
            help="Also write the figures in other formats, as wide as a journal's column: svg, pdf, or svg,pdf. PNG is"
            " always written."
        ),
    ] = None,
    tolerate: Tolerate = False,
    ok_if: OkIf = None,
) -> int:
    """Take a design through its protocol: energies, work, times, a verdict, and pictures."""
    from forficula.design import load_design
    from forficula.pattern import PATTERN_FILES, read_pattern

    length = read_unit(unit)
    if Path(design).suffix.lower() in PATTERN_FILES:
        for remark in read_pattern(design, length)[1]:
            print(f"{design}: {remark}", file=sys.stderr)
    chosen = load_design(design, read_settings(settings), unit=length)
    folder = out or Path("out") / chosen.name
    check_verdicts(ok_if)
    copies = _copies(figures)
    check_folder(folder, "run")
    if cycles is not None:
        from forficula.study.cycling import check_cycles

        last = cycles
        read_option("--cycles", lambda: check_cycles(chosen, last))

    from forficula.analysis import measure, run_warnings
    from forficula.dynamics import timestep_warnings
    from forficula.show import print_outcome, print_storage, print_strength, run_progress, write_run
    from forficula.show.progress import waiting
    from forficula.structure import structure_of, structure_warnings
    from forficula.study.running.runs import run as run_design

    tell_replaced(folder, "run")
    with waiting("working out the timestep that it allows"):
        structure = structure_of(chosen)
        warnings = structure_warnings(chosen, structure) + timestep_warnings(chosen)
    for warning in warnings:
        print(f"warning: {warning}", file=sys.stderr)
    with run_progress(f"building the {structure.appearance.whole}") as progress:
        record = run_design(chosen, progress, confirm=not no_confirm)
    for warning in run_warnings(record):
        print(f"warning: {warning}", file=sys.stderr)
    outcome = measure(record)
    write_run(record, outcome, folder, engine=not no_engine, copies=copies)
    print_outcome(chosen.name, outcome)
    print_storage(record, outcome)
    print_strength(record)
    _print_assumptions(chosen, folder)
    verdicts = [outcome.verdict, *_cycle(chosen, cycles, folder)]
    tell_written(folder, "run")
    return exit_status(verdicts, tolerate=tolerate, ok_if=ok_if)


def _copies(figures: str | None) -> list[str]:
    """Return the endings of the formats that --figures names; PNG needs no name.

    Raises:
        InputError: one is unknown.
    """
    known = ("png", "svg", "pdf")
    named = [] if figures is None else [each.strip().lower() for each in figures.split(",")]
    for each in named:
        if each not in known:
            raise InputError(f'--figures: need one or more of {", ".join(known)}, with commas, got "{figures}"')
    return [f".{each}" for each in dict.fromkeys(named) if each != "png"]


def _print_assumptions(design: Design, folder: Path) -> None:
    """Print which modelling assumptions decide the result of a design, where that is known."""
    from forficula.study.assumptions.assumptions_file import known_assumptions, known_text

    known = known_assumptions(design, folder)
    if known is not None:
        print(f"\n{known_text(*known)}")


def _cycle(design: Design, cycles: int | None, folder: Path) -> list[Verdict]:
    """Write and print what becomes of a run's structure over cycles, where that is wanted and the tendons change."""
    from forficula.show.folder.cycling_folder import print_cycling, write_cycling

    if cycles is None:
        return []

    from forficula.analysis import Verdict
    from forficula.show import study_progress
    from forficula.study.cycling import run_cycles, why_unchanged

    if reason := why_unchanged(design):
        print(f"\nCycles: {reason}")
        return []
    with study_progress() as progress:
        cycling = run_cycles(design, cycles, progress)
    write_cycling(cycling, folder)
    print_cycling(cycling)
    return [Verdict(run.row["verdict"]) for run in cycling.runs]


def compare(
    *runs: Annotated[Path, Parameter(help="Folders that forficula run wrote, two or more.")],
    out: Annotated[Out, Parameter(help="A .html file.")],
) -> None:
    """Show runs side by side on one clock, as a page that opens in any browser."""
    from forficula.show.page import compare_runs

    compare_runs(runs, out)
    print(f"written to {out}")


def figure(
    results: Annotated[Path, Parameter(help="A folder that forficula wrote: of a run, a study, a landscape, ...")],
    /,
    *,
    kind: Annotated[str, Parameter(help="Which figure, by the name of its picture there, such as energy or folding.")],
    out: Annotated[Out, Parameter(help="A .pdf, .svg or .png file.")],
    width: Annotated[
        Literal["column", "page"] | None,
        Parameter(help="As wide as a journal's column, 3.5 in, which it is if not given, or as its page, 7.1 in."),
    ] = None,
) -> None:
    """Draw one figure of some results again, for a paper."""
    from forficula.show.folder.presentation import write_figure
    from forficula.show.style import COLUMN_WIDTH, PAGE_WIDTH

    write_figure(results, kind, out, None if width is None else {"column": COLUMN_WIDTH, "page": PAGE_WIDTH}[width])
    print(f"written to {out}")


def film(
    run: Annotated[Path, Parameter(help="The folder of a run.")],
    /,
    *,
    out: Annotated[Out, Parameter(help="An .mp4 or .gif file.")],
    size: Annotated[
        str | None, Parameter(help="Pixels across and upwards; 1280x720, or 800x450 for .gif, if not given.")
    ] = None,
    fps: Annotated[
        int | None, WHOLE_NUMBER, Parameter(help="Pictures a second; 30, or 15 for .gif, if not given.")
    ] = None,
    slower: Annotated[
        float | None, Parameter(help="How many times; each move takes about 3.5 s of the film if not given.")
    ] = None,
    strain: Annotated[bool, Parameter(negative=(), help="Colour the membrane by its strains.")] = False,
) -> None:
    """Film a run: the structure, tendons coloured by their energy, held in every state and slowed between them."""
    from forficula.analysis.run_files import read_run
    from forficula.show.film.film import LARGEST, SMALLEST, check_choices, check_film, write_film
    from forficula.show.progress import film_progress

    read_option("--out", lambda: check_film(out))
    pixels = None if size is None else read_size("--size", size, SMALLEST, LARGEST)
    with error_prefix("--"):
        check_choices(pixels, fps, slower)
    record = read_run(run)
    with film_progress() as progress:
        write_film(record, out, size=pixels, rate=fps, slowed=slower, strain=strain, progress=progress)
    print(f"written to {out}")
