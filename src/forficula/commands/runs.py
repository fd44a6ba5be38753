"""Commands about runs: simulate a design, draw, film and compare what was recorded."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Literal

from cyclopts import Parameter

from forficula.commands.cost import CountEstimate, RunEstimate, runs_estimated
from forficula.errors import InputError, error_prefix
from forficula.options import (
    WHOLE_NUMBER,
    DesignName,
    Device,
    DrawingUnit,
    NoEngine,
    OkIf,
    OpenReport,
    Out,
    OutIfGiven,
    Settings,
    Tolerate,
    check_folder,
    check_verdicts,
    exit_status,
    finish_folder,
    note_replaced,
    on_device,
    read_design,
    read_option,
    read_quantity,
    read_size,
)
from forficula.terminal import result_first, warn

if TYPE_CHECKING:
    from forficula.analysis import Outcome, Verdict
    from forficula.design import Design
    from forficula.dynamics import Record


def run(
    design: DesignName,
    /,
    *,
    settings: Settings = None,
    unit: DrawingUnit = None,
    out: Annotated[OutIfGiven, Parameter(help="Output folder; default: out/<name of the design>.")] = None,
    open_report: OpenReport = False,
    cycles: Annotated[
        int | None,
        WHOLE_NUMBER,
        Parameter(
            help="Also run the design with its tendons as changed by 1, 2, 3 and more load cycles, up to this number,"
            " such as 100."
        ),
    ] = None,
    no_confirm: Annotated[
        bool,
        Parameter(
            negative=(),
            help="Skip the second runs, at half the timestep and from a slightly different start, that confirm the"
            " verdict and give numbers their uncertainty.",
        ),
    ] = False,
    device: Device = None,
    no_engine: NoEngine = False,
    figures: Annotated[
        str | None,
        Parameter(
            help="Also write the figures in these formats, as wide as a journal's column: svg, pdf, or svg,pdf. PNG is"
            " always written."
        ),
    ] = None,
    tolerate: Tolerate = False,
    ok_if: OkIf = None,
) -> int:
    """Simulate a design through its protocol: verdict, energies, work, times and figures."""
    with result_first() as release:
        from forficula.study.running.law_timestep import with_timestep_for_law

        chosen = with_timestep_for_law(on_device(read_design(design, settings, unit), device))
        folder = out or Path("out") / chosen.name
        check_verdicts(ok_if)
        copies = _copies(figures)
        check_folder(folder, "run")
        if cycles is not None:
            from forficula.study.cycling import check_cycles

            last = cycles
            read_option("--cycles", lambda: check_cycles(chosen, last))

        from forficula.analysis import measure, run_warnings
        from forficula.show.run.outcome_table import print_verdict

        note_replaced(folder, "run")
        record = _simulated(chosen, confirm=not no_confirm)
        outcome = measure(record)
        for warning in run_warnings(record):
            warn(warning)
        # before anything is drawn
        print_verdict(chosen.name, outcome)
        release()

    from forficula.show import write_run

    _print_details(record, outcome, folder)
    write_run(record, outcome, folder, engine=not no_engine, copies=copies)
    verdicts = [outcome.verdict, *_cycle(chosen, cycles, folder)]
    finish_folder(folder, "run", show=open_report)
    return exit_status(verdicts, tolerate=tolerate, ok_if=ok_if)


def _simulated(design: Design, *, confirm: bool) -> Record:
    """Simulate a design; warn of its structure and its timestep, and estimate the time."""
    from forficula.dynamics import timestep_warnings
    from forficula.show import run_progress
    from forficula.show.progress import waiting
    from forficula.structure import structure_of, structure_warnings
    from forficula.study.running.numerical_settings import finds_settings
    from forficula.study.running.runs import run as run_design

    with waiting("computing the timestep limit"):
        structure = structure_of(design)
        warnings = structure_warnings(design, structure) + timestep_warnings(design)
    for warning in warnings:
        warn(warning)
    with run_progress(f"building the {structure.appearance.whole}") as progress:
        estimate = RunEstimate(progress, searches=finds_settings(design), stages=design.protocol.stages)
        return run_design(design, estimate, confirm=confirm)


def _print_details(record: Record, outcome: Outcome, folder: Path) -> None:
    """Print the tables of a run below its verdict, and the assumptions that decide its result, where known."""
    from forficula.show import print_events, print_outcome, print_storage, print_strength
    from forficula.study.assumptions.assumptions_file import known_assumptions, known_text

    print_outcome(record.design.name, outcome, verdict=False)
    print_events(record)
    print_storage(record, outcome)
    print_strength(record)
    known = known_assumptions(record.design, folder)
    if known is not None:
        print(f"\n{known_text(*known)}", flush=True)


def _copies(figures: str | None) -> list[str]:
    """Return the file endings of the formats of --figures, without PNG.

    Raises:
        InputError: a format is unknown.
    """
    known = ("png", "svg", "pdf")
    named = [] if figures is None else [word.strip().lower() for word in figures.split(",")]
    for word in named:
        if word not in known:
            raise InputError(f'--figures: need one or more of {", ".join(known)}, with commas, got "{figures}"')
    return [f".{word}" for word in dict.fromkeys(named) if word != "png"]


def _cycle(design: Design, cycles: int | None, folder: Path) -> list[Verdict]:
    """Run a design with tendons after load cycles, write and print the results; returns the verdicts.

    Returns no verdicts without --cycles, and where the tendons do not change.
    """
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
        cycling = run_cycles(design, cycles, runs_estimated(progress))
    write_cycling(cycling, folder)
    print_cycling(cycling)
    return [Verdict(run.row["verdict"]) for run in cycling.runs]


def compare(
    *runs: Annotated[
        Path, Parameter(help="Two or more folders of forficula run, or FOLD files with frames of the same pattern.")
    ],
    out: Annotated[Out, Parameter(help="Page to write (.html).")],
) -> None:
    """Show runs side by side, played at the same time, in a page for any browser."""
    from forficula.show.page import compare_runs

    compare_runs(runs, out)
    print(f"written to {out}")


def figure(
    results: Annotated[Path, Parameter(help="Folder of results: of a run, study, landscape, material, ...")],
    /,
    *,
    kind: Annotated[str, Parameter(help="Name of the figure, such as energy: its file without ending.")],
    out: Annotated[Out, Parameter(help="File to write (.pdf, .svg or .png).")],
    width: Annotated[
        Literal["column", "page"] | None,
        Parameter(help="Width of a journal's column (3.5 in, the default) or of its page (7.1 in)."),
    ] = None,
) -> None:
    """Draw one figure of results again, as PDF, SVG or PNG, at the width of a journal's column."""
    from forficula.show.folder.presentation import write_figure
    from forficula.show.style import COLUMN_WIDTH, PAGE_WIDTH

    write_figure(results, kind, out, None if width is None else {"column": COLUMN_WIDTH, "page": PAGE_WIDTH}[width])
    print(f"written to {out}")


def film(
    run: Annotated[Path, Parameter(help="Folder of a run.")],
    /,
    *,
    out: Annotated[Out, Parameter(help="File to write (.mp4 or .gif).")],
    size: Annotated[
        str | None, Parameter(help="Width and height in pixels; default: 1280x720, for .gif 800x450.")
    ] = None,
    fps: Annotated[int | None, WHOLE_NUMBER, Parameter(help="Frames per second; default: 30, for .gif 15.")] = None,
    slower: Annotated[
        float | None, Parameter(help="Slow-motion factor; by default each transition takes about 3.5 s of the film.")
    ] = None,
    strain: Annotated[bool, Parameter(negative=(), help="Colour membranes by their strain.")] = False,
) -> None:
    """Film a run: the moving structure, slowed in transitions, with tendons coloured by energy."""
    from forficula.analysis.run_files import read_run
    from forficula.show.film.film import LARGEST, SMALLEST, check_choices, check_film, write_film
    from forficula.show.progress import film_progress

    read_option("--out", lambda: check_film(out))
    pixels = None if size is None else read_size("--size", size, SMALLEST, LARGEST)
    with error_prefix("--"):
        check_choices(pixels, fps, slower)
    record = read_run(run)
    estimate = CountEstimate("frames")
    with film_progress() as progress:

        def drawn(done: int, count: int) -> None:
            estimate.update(done, count)
            progress(done, count)

        write_film(record, out, size=pixels, rate=fps, slowed=slower, strain=strain, progress=drawn)
    print(f"written to {out}")


def export(
    run: Annotated[Path, Parameter(help="Folder of a run.")],
    /,
    *,
    to: Annotated[
        str | None,
        Parameter(
            help="Format: gltf (animation for Blender, slides and phones), obj or stl (one moment), vtk (series for"
            " ParaView), usd, fold or csv; by default that of the ending of --out."
        ),
    ] = None,
    at: Annotated[
        str | None,
        Parameter(
            help='Time of the only moment to write, such as "30 ms"; default: the motion, for obj and stl its end.'
        ),
    ] = None,
    out: Annotated[
        OutIfGiven,
        Parameter(
            help="File to write (.glb, .obj, .stl, .pvd, .usda, .fold or .csv); default: in the folder of the run."
        ),
    ] = None,
) -> None:
    """Write the motion of a run, or one moment of it, for Blender, ParaView, printers and other programs."""
    from forficula.analysis.run_files import read_run
    from forficula.design.section import TIME
    from forficula.show.export import check_format, default_path, export_times, format_of, write_export

    if to is not None:
        read_option("--to", lambda: check_format(to))
    if out is not None:
        chosen = read_option("--out", lambda: format_of(out, to))
    elif to is not None:
        chosen = to
    else:
        raise InputError('--to: need a format such as "gltf" where --out is missing')
    time = None if at is None else read_quantity("--at", at, TIME)
    record = read_run(run)
    path = out or default_path(run, chosen)
    with error_prefix("" if at is None else "--at: "):
        times = export_times(record, chosen, time)
    write_export(record, path, chosen, times)
    print(f"written to {path}")
