"""The command line: one sub-command, one library call."""

from __future__ import annotations

import os
import sys
from collections.abc import Sequence
from contextlib import nullcontext
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Literal

from cyclopts import App, CycloptsError, Parameter

from forficula.errors import InputError
from forficula.options import read_option, read_quantity, read_size, read_stiffnesses

if TYPE_CHECKING:
    from xarray import Dataset

    from forficula.design import Design
    from forficula.study import Study

# What each command needs is imported in it: help and errors come at once, without MuJoCo and matplotlib.

app = App(
    name="forficula",
    help="Predict and design bistable folding structures.",
    version_flags=["--version"],
    help_format="plaintext",
    suppress_keyboard_interrupt=False,
)
Settings = Annotated[
    list[str] | None,
    Parameter(
        name="--set", help='Replace a value, as in --set tendon.stiffness="20 N/cm"; may be repeated.', negative=()
    ),
]
DesignName = Annotated[str, Parameter(help="A named design, or the path of a design file (.toml).")]


@app.command
def run(
    design: DesignName,
    /,
    *,
    settings: Settings = None,
    out: Annotated[
        Path | None, Parameter(help="Folder for the results; out/<name of the design> if not given.")
    ] = None,
    cycles: Annotated[
        int | None, Parameter(help="Fold and open again with the tendons as they are up to this cycle, as in 100.")
    ] = None,
) -> None:
    """Fold and open a wing: energies, work, times, a verdict, and pictures."""
    from forficula.design import design_warnings, load_design

    chosen = load_design(design, _read_settings(settings))
    folder = out or Path("out") / chosen.name
    _check_folder(folder)
    if cycles is not None:
        from forficula.study.cycling import check_cycles

        last = cycles
        read_option("--cycles", lambda: check_cycles(chosen, last))

    from forficula.analysis import measure
    from forficula.dynamics import run as run_design
    from forficula.dynamics import timestep_warnings
    from forficula.show import print_outcome, run_progress, write_run

    for warning in design_warnings(chosen) + timestep_warnings(chosen):
        print(f"warning: {warning}", file=sys.stderr)
    with run_progress() as progress:
        record = run_design(chosen, progress)
    outcome = measure(record)
    write_run(record, outcome, folder)
    print_outcome(chosen.name, outcome)
    _cycle(chosen, cycles, folder)
    print(f"\nwritten to {folder}")


@app.command
def pattern(
    design: DesignName,
    /,
    *,
    out: Annotated[Path, Parameter(help="A .fold or .svg file.")],
    settings: Settings = None,
) -> None:
    """Write a design's crease pattern as FOLD or SVG, by the ending of the file."""
    from forficula.design import load_design
    from forficula.pattern import earwig_pattern, folded_frames, write_fold, write_svg

    fan = load_design(design, _read_settings(settings)).fan
    match out.suffix:
        case ".fold":
            write_fold(earwig_pattern(fan), out, frames=folded_frames(fan))
        case ".svg":
            write_svg(earwig_pattern(fan), out)
        case _:
            raise InputError(f"--out: need a file that ends with .fold or .svg, got {out}")
    print(f"written to {out}")


@app.command
def landscape(
    design: DesignName,
    /,
    *,
    settings: Settings = None,
    out: Annotated[
        Path | None, Parameter(help="Folder for the results; out/<name of the design>-landscape if not given.")
    ] = None,
    simulation: Annotated[
        bool, Parameter(help="Run the design, too, and show it beside what statics predicts.")
    ] = True,
    over: Annotated[
        list[str] | None,
        Parameter(
            help='Map what folds and opens slowly over a key, as in --over tendon.rest_length="0..9 cm step 1"; may be'
            " repeated.",
            negative=(),
        ),
    ] = None,
    simulated: Annotated[
        Path | None, Parameter(help="Folder of a study of this design over the same keys, to compare the map with.")
    ] = None,
) -> None:
    """Survey a design's energy without simulating: stable states, barriers, holding torques, stiffness, snap."""
    from forficula.design import load_design

    chosen = load_design(design, _read_settings(settings))
    folder = out or Path("out") / f"{chosen.name}-landscape"
    _check_folder(folder)
    if simulated is not None and not over:
        raise InputError("--simulated: needs --over with the keys of the study")
    if not over:
        _survey(chosen, folder, simulation)
    else:
        from forficula.show.static_map_folder import print_static_map, read_simulated, write_static_map
        from forficula.study.static_map import map_study, static_map

        study = map_study(chosen, _read_settings(over, "--over", 'tendon.rest_length="0..9 cm step 1"'))
        beside = None if simulated is None else read_simulated(simulated, chosen)
        _survey(chosen, folder, simulation)
        table = static_map(study)
        write_static_map(study, table, folder, beside)
        print_static_map(table, beside)
    print(f"\nwritten to {folder}")


@app.command
def converge(
    design: DesignName,
    /,
    *,
    timesteps: Annotated[str | None, Parameter(help='Timesteps, as in "0.5 0.4 0.3 0.2 0.1 ms".')] = None,
    moduli: Annotated[str | None, Parameter(help='Moduli of the membrane, as in "0.5 1 2 4 MPa".')] = None,
    meshes: Annotated[str | None, Parameter(help='How many times finer its rows are, as in "1 2 3".')] = None,
    settings: Settings = None,
    out: Annotated[
        Path | None, Parameter(help="Folder for the results; out/<name of the design>-converge if not given.")
    ] = None,
) -> None:
    """Run a design at several timesteps, membrane moduli or meshes: do its times depend on them?"""
    from forficula.design import load_design

    chosen = load_design(design, _read_settings(settings))
    folder = out or Path("out") / f"{chosen.name}-converge"
    _check_folder(folder)

    from forficula.show import study_progress
    from forficula.show.convergence_figure import print_convergence, write_convergence
    from forficula.study.convergence import converge as converge_design
    from forficula.study.refinement import MESH, TIMESTEP, YOUNGS_MODULUS, read_values

    options = {"--timesteps": (TIMESTEP, timesteps), "--moduli": (YOUNGS_MODULUS, moduli), "--meshes": (MESH, meshes)}
    given = [(option, key, text) for option, (key, text) in options.items() if text is not None]
    if len(given) != 1:
        named = ", ".join(option for option, _, _ in given) or "none"
        raise InputError(f"converge: need one of {', '.join(options)}, got {named}")
    ((option, key, text),) = given
    values = read_option(option, lambda: read_values(key, text))
    with study_progress() as progress:
        convergence = converge_design(chosen, key, values, progress=progress)
    print_convergence(convergence)
    write_convergence(convergence, folder)
    print(f"\nwritten to {folder}")


@app.command
def compare(
    *runs: Annotated[Path, Parameter(help="Folders that forficula run wrote, two or more.")],
    out: Annotated[Path, Parameter(help="A .html file.")],
) -> None:
    """Show runs side by side on one clock, as a page that opens in any browser."""
    from forficula.show.page import compare_runs

    compare_runs(runs, out)
    print(f"written to {out}")


@app.command
def study(
    study: Annotated[str, Parameter(help="A named study, or the path of a study file (.toml).")],
    /,
    *,
    out: Annotated[Path | None, Parameter(help="Folder of the study; out/<its name> if not given.")] = None,
    dry_run: Annotated[bool, Parameter(help="Only say how many runs there are and how long they take.")] = False,
    shard: Annotated[str, Parameter(help="Run a part of the points, as in 2/8; then collect.")] = "1/1",
    collect: Annotated[bool, Parameter(help="Build the table from the rows of all shards.")] = False,
    slurm: Annotated[int | None, Parameter(help="Write a SLURM job array of so many shards instead.")] = None,
    dask: Annotated[
        str | None, Parameter(help="Run on the Dask cluster with this scheduler, as in tcp://scheduler:8786.")
    ] = None,
    keep: Annotated[
        int | None,
        Parameter(help="Keep runs of so many points at most, to be played in its page; 100 if not given, 0 for none."),
    ] = None,
) -> None:
    """Run a study, or go on with it where it stopped: a table, maps, and a page on which they open their runs."""
    from forficula.study import collect as collect_study
    from forficula.study import estimate, load_study, run_study, slurm_script

    chosen = load_study(study)
    folder = out or Path("out") / chosen.name
    _check_folder(folder)
    if keep is not None:
        from forficula.study.kept_runs import check_most

        most = keep
        read_option("--keep", lambda: check_most(most))
    if slurm is not None:
        from forficula.files import write_text

        write_text(folder / "study.slurm", slurm_script(study, str(folder), slurm))
        print(f"written to {folder / 'study.slurm'}; submit it with: sbatch {folder / 'study.slurm'}")
        return
    if dry_run:
        most, left, seconds = estimate(chosen, folder)
        print(f"{chosen.name}: {len(chosen.points)} points, at most {most} runs; {left} to do, about {seconds:.0f} s")
        return
    if collect:
        table = collect_study(chosen, folder)
    else:
        from forficula.show import study_progress
        from forficula.study import dask_cluster

        with nullcontext() if dask is None else dask_cluster(dask) as cluster, study_progress() as progress:
            part = run_study(chosen, folder, shard=_read_shard(shard), cluster=cluster, progress=progress)
        if part is None:
            print(f"shard {shard} is done; when all are: forficula study {study} --out {folder} --collect")
            return
        table = part

    from forficula.show import print_study, write_study

    write_study(chosen, table, folder)
    _report(chosen, table, keep, folder)
    print_study(chosen, table)
    print(f"\nwritten to {folder}")


@app.command
def material(
    *files: Annotated[str, Parameter(help="Exports of a testing machine, one or more specimens each.")],
    length: Annotated[
        str | None, Parameter(help='Length of every specimen, as in "60 mm", where the files do not give it.')
    ] = None,
    area: Annotated[str | None, Parameter(help='Area of its cross-section, as in "5 mm^2", likewise.')] = None,
    law: Annotated[
        str | None,
        Parameter(
            help="Fit this law only: linear, polynomial, kelvin-voigt, zener, prony or softening; by default all are"
            " fitted, and an information criterion chooses."
        ),
    ] = None,
    keep_first: Annotated[
        bool, Parameter(help="Let the first cycle of every specimen count, too.", negative=())
    ] = False,
    band: Annotated[
        str, Parameter(help="A turn back by less of the largest travel is noise, not the end of a cycle.")
    ] = "5 %",
    out: Annotated[Path, Parameter(help="Folder for the results; the material is named after it.")] = Path(
        "out/material"
    ),
) -> None:
    """Turn tensile tests into a material: cycles, moduli, drift, and a law that a tendon can have."""
    from forficula.material.characterisation import AREA, BAND_SHARE, LENGTH, characterise
    from forficula.material.law_family import family_forms
    from forficula.material.specimen_files import read_specimens

    _check_folder(out)
    forms = None if law is None else read_option("--law", lambda: family_forms(law))
    read = read_specimens(
        files,
        length=None if length is None else read_quantity("--length", length, LENGTH),
        area=None if area is None else read_quantity("--area", area, AREA),
    )
    share = read_quantity("--band", band, BAND_SHARE)
    found = characterise(
        read.tests, name=out.resolve().name, source=read.source, drop_first=not keep_first, band=share, forms=forms
    )

    from forficula.show.material_folder import write_material
    from forficula.show.material_table import print_material

    write_material(found, out)
    print_material(found)
    print(f"\nwritten to {out}")


@app.command
def size(
    design: DesignName,
    /,
    *,
    material: Annotated[str, Parameter(help="A named material, or the path of a law file (.toml).")],
    stiffness: Annotated[str, Parameter(help='Of the tendon, as in "10 N/cm" or "10..60 N/cm step 10".')],
    length: Annotated[
        str | None, Parameter(help="Of the unstretched tendon; that of the material's specimens if not given.")
    ] = None,
    modulus: Annotated[
        str | None, Parameter(help='Modulus of a material that is known as a range only, as in "1 MPa".')
    ] = None,
    settings: Settings = None,
    out: Annotated[Path | None, Parameter(help="A .csv file for the table.")] = None,
) -> None:
    """Tell how thick a tendon of a material must be to have a stiffness."""
    from forficula.analysis.sizing import size_tendons
    from forficula.design import load_design
    from forficula.files import write_text
    from forficula.material.characterisation import LENGTH
    from forficula.material.law_file import load_law
    from forficula.material.law_keys import law_unit
    from forficula.material.material_law import chosen, known_moduli
    from forficula.show.size_table import print_sizes, sizes_csv

    if out is not None and out.suffix != ".csv":
        raise InputError(f"--out: need a file that ends with .csv, got {out}")
    law = load_law(material)
    if modulus is not None:
        value = read_quantity("--modulus", modulus, law_unit("modulus.linear"))
        law = read_option("--modulus", lambda: chosen(law, value))
    elif not law.no_tendon:
        read_option("--modulus", lambda: known_moduli(law))
    own = None if length is None else read_quantity("--length", length, LENGTH)
    sizes = size_tendons(
        load_design(design, _read_settings(settings)), law, read_stiffnesses("--stiffness", stiffness), length=own
    )
    print_sizes(law, sizes)
    if out is not None:
        write_text(out, sizes_csv(sizes))
        print(f"\nwritten to {out}")


@app.command
def figure(
    results: Annotated[Path, Parameter(help="A folder that forficula wrote: of a run, a study, a landscape, ...")],
    /,
    *,
    kind: Annotated[str, Parameter(help="Which figure, by the name of its picture there, such as energy or folding.")],
    out: Annotated[Path, Parameter(help="A .pdf, .svg or .png file.")],
    width: Annotated[
        Literal["column", "page"] | None,
        Parameter(help="As wide as a journal's column, 3.5 in, which it is if not given, or as its page, 7.1 in."),
    ] = None,
) -> None:
    """Draw one figure of some results again, for a paper."""
    from forficula.show.figure_kinds import write_figure
    from forficula.show.style import COLUMN_WIDTH, PAGE_WIDTH

    write_figure(results, kind, out, None if width is None else {"column": COLUMN_WIDTH, "page": PAGE_WIDTH}[width])
    print(f"written to {out}")


@app.command
def film(
    run: Annotated[Path, Parameter(help="The folder of a run.")],
    /,
    *,
    out: Annotated[Path, Parameter(help="An .mp4 or .gif file.")],
    size: Annotated[
        str | None, Parameter(help="Pixels across and upwards; 1280x720, or 800x450 for .gif, if not given.")
    ] = None,
    fps: Annotated[int | None, Parameter(help="Pictures a second; 30, or 15 for .gif, if not given.")] = None,
    slower: Annotated[
        float | None, Parameter(help="How many times; each move takes about 3.5 s of the film if not given.")
    ] = None,
) -> None:
    """Film a run: the wing, its tendons coloured by their energy, held in every state and slowed down between them."""
    from forficula.show.film import LARGEST, SMALLEST, check_film, write_film
    from forficula.show.progress import film_progress
    from forficula.show.run_reader import read_run

    read_option("--out", lambda: check_film(out))
    pixels = None if size is None else read_size("--size", size, SMALLEST, LARGEST)
    if fps is not None and not 1 <= fps <= 60:
        raise InputError(f"--fps: need 1 to 60, got {fps}")
    if slower is not None and not 0.01 <= slower <= 10_000:
        raise InputError(f"--slower: need 0.01 to 10000, got {slower:g}")
    record = read_run(run)
    with film_progress() as progress:
        write_film(record, out, size=pixels, rate=fps, slowed=slower, progress=progress)
    print(f"written to {out}")


@app.command
def materials() -> None:
    """List the named materials, each with its source."""
    from forficula.material.law_file import named_laws

    for name, source in named_laws().items():
        print(f"{name}\n    {source}")


@app.command
def new(file: Annotated[Path, Parameter(help="Where to write it; must end with .toml and not exist.")], /) -> None:
    """Write a commented design file to start from."""
    from forficula.design import write_new_design

    write_new_design(file)
    print(f"written to {file}; run it with: forficula run {file}")


@app.command
def designs() -> None:
    """List the named designs, each with its source."""
    from forficula.design import named_designs

    for name, source in named_designs().items():
        print(f"{name}\n    {source}")


def main(arguments: Sequence[str] | None = None) -> None:
    """Run the command line; exit with 0 where the command was carried out, and with 1 for bad input."""
    try:
        app(arguments, exit_on_error=False, print_error=False)
    except (InputError, CycloptsError) as error:
        print(f"forficula: {' '.join(str(error).split())}", file=sys.stderr)
        sys.exit(1)
    except BrokenPipeError:
        # whoever read our output has seen enough; Python would complain once more when it closes it
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        sys.exit(1)
    except KeyboardInterrupt:
        print("forficula: stopped", file=sys.stderr)
        sys.exit(130)


def _cycle(design: Design, cycles: int | None, folder: Path) -> None:
    """Write and print what becomes of a run's wing over cycles, where that is wanted and the tendons change."""
    from forficula.show.cycling_folder import print_cycling, remove_cycling, write_cycling

    remove_cycling(folder)
    if cycles is None:
        return

    from forficula.show import study_progress
    from forficula.study.cycling import run_cycles, why_unchanged

    if reason := why_unchanged(design):
        print(f"\nCycles: {reason}")
        return
    with study_progress() as progress:
        cycling = run_cycles(design, cycles, progress)
    write_cycling(cycling, folder)
    print_cycling(cycling)


def _report(study: Study, table: Dataset, keep: int | None, folder: Path) -> None:
    """Write a study's page, and keep the runs that it plays."""
    from forficula.show import study_progress
    from forficula.show.study_folder import write_study_report
    from forficula.study.kept_runs import MOST_POINTS, kept_runs, runs_to_keep

    runs = runs_to_keep(study, table, MOST_POINTS if keep is None else keep)
    if runs:
        what = "1 run" if len(runs) == 1 else f"{len(runs)} runs"
        print(f"keeping {what} whole, to be played in report.html (--keep 0 does without)", file=sys.stderr)
    with study_progress() as progress:
        write_study_report(study, table, kept_runs(runs, folder, progress=progress), len(runs), folder)


def _survey(design: Design, folder: Path, simulation: bool) -> None:
    """Write and print the landscape of one design, and a run of it where one is wanted."""
    from forficula.design import design_warnings
    from forficula.dynamics import timestep_warnings
    from forficula.show.landscape_folder import write_landscape
    from forficula.show.landscape_table import print_landscape
    from forficula.show.progress import run_progress
    from forficula.study.survey import survey

    for warning in design_warnings(design):
        print(f"warning: {warning}", file=sys.stderr)
    if simulation:
        for warning in timestep_warnings(design):
            print(f"warning: {warning}", file=sys.stderr)
    with run_progress() as progress:
        landscape, record = survey(design, simulation=simulation, progress=progress)
    write_landscape(landscape, folder, record)
    print_landscape(landscape, record)


def _read_shard(text: str) -> tuple[int, int]:
    """Turn "2/8" into (2, 8)."""
    number, slash, count = text.partition("/")
    if not (slash and number.isdecimal() and count.isdecimal() and 1 <= int(number) <= int(count)):
        raise InputError(f'--shard: need a number and a count such as 2/8, got "{text}"')
    return int(number), int(count)


def _check_folder(folder: Path) -> None:
    """Refuse a folder that cannot be made, before a run that takes a while."""
    try:
        there = next(place for place in (folder, *folder.parents, Path()) if place.exists())
    except OSError as error:
        raise InputError(f"--out: {folder}: {error.strerror}") from None
    if not there.is_dir():
        raise InputError(f"--out: need a folder, got the file {there}")


def _read_settings(
    settings: Sequence[str] | None, option: str = "--set", example: str = 'tendon.stiffness="20 N/cm"'
) -> dict[str, object]:
    """Turn key=value texts into values by dotted key: TOML where they are TOML, text with a unit otherwise."""
    import tomllib

    values: dict[str, object] = {}
    for setting in settings or ():
        key, equals, text = setting.partition("=")
        if not equals or not key.strip():
            raise InputError(f'{option}: need KEY=VALUE such as {example}, got "{setting}"')
        try:
            values[key.strip()] = tomllib.loads(f"value = {text}")["value"]
        except (ValueError, RecursionError):  # not TOML, or too long a number or too deep a list for it
            values[key.strip()] = text.strip()
    return values
