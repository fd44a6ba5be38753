"""Commands that run many designs, or one design with changed numerics or assumptions."""

from __future__ import annotations

from contextlib import nullcontext
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

from cyclopts import Parameter

from forficula.commands.cost import RunEstimate, runs_estimated
from forficula.errors import InputError
from forficula.names import counted, listed
from forficula.options import (
    WHOLE_NUMBER,
    Dask,
    DesignName,
    Device,
    DrawingUnit,
    NoEngine,
    OkIf,
    OpenReport,
    OutIfGiven,
    Settings,
    Tolerate,
    check_apart,
    check_folder,
    check_verdicts,
    end_with_page,
    exit_status,
    finish_folder,
    note_replaced,
    on_device,
    read_design,
    read_option,
    read_shard,
)
from forficula.terminal import ended_by_signal, note, set_result

if TYPE_CHECKING:
    from xarray import Dataset

    from forficula.study import Study

_ALL = "1/1"  # the shard of all points


def study(
    study: Annotated[str, Parameter(help="A named study, or the path of a study file (.toml).")],
    /,
    *,
    out: Annotated[OutIfGiven, Parameter(help="Output folder; default: out/<name of the study>.")] = None,
    dry_run: Annotated[bool, Parameter(help="Only estimate the number of runs and their time.")] = False,
    shard: Annotated[
        str, Parameter(help="Run one part of the points, such as 2/8 for part 2 of 8; then use --collect.")
    ] = _ALL,
    collect: Annotated[bool, Parameter(help="Build the table from the rows of all shards.")] = False,
    status: Annotated[
        bool, Parameter(help="Report which shards are complete, run, or must run again; exit status 0 if complete.")
    ] = False,
    slurm: Annotated[
        int | None, WHOLE_NUMBER, Parameter(help="Write a SLURM job array of this number of shards, and run nothing.")
    ] = None,
    dask: Dask = None,
    device: Device = None,
    keep: Annotated[
        int | None,
        WHOLE_NUMBER,
        Parameter(help="Maximum number of runs stored for playback in report.html; default: 100, 0 for none."),
    ] = None,
    no_engine: NoEngine = False,
    parquet: Annotated[bool, Parameter(help="Write the table as table.parquet, too; needs pyarrow.")] = False,
    open_report: OpenReport = False,
) -> int | None:
    """Run a study, or resume one: a table of all runs, maps, and a page in which each point opens its run."""
    from forficula.reproduction import check_reproduction
    from forficula.show.progress import building_progress
    from forficula.study import collect as collect_study
    from forficula.study import json_rows, load_study

    split = {"--shard": shard != _ALL, "--dask": dask is not None}
    drawn = {"--keep": keep is not None, "--no-engine": no_engine, "--parquet": parquet, "--open": open_report}
    others = {"--slurm": slurm is not None, "--collect": collect, "--dry-run": dry_run}
    check_apart("--status", status, others | split | drawn)
    other_work = {"--collect": collect, "--dry-run": dry_run, "--device": device is not None}
    check_apart("--slurm", slurm is not None, other_work | split | drawn)
    check_apart("--collect", collect, {"--dry-run": dry_run} | split)
    check_apart("--dry-run", dry_run, {"--dask": dask is not None} | drawn)
    chosen = load_study(study)
    chosen = replace(chosen, base=on_device(chosen.base, device))
    folder = out or Path("out") / chosen.name
    check_folder(folder, "study")
    check_reproduction(chosen)
    if keep is not None:
        from forficula.study.running.kept_runs import check_most

        most = keep
        read_option("--keep", lambda: check_most(most))
    if status:
        return _print_status(chosen, study, folder)
    if parquet:
        from forficula.study.tables.table_files import check_parquet

        read_option("--parquet", check_parquet)
    if chosen.boundaries is not None and (slurm is not None or shard != _ALL):
        from forficula.study.running.run_study import REFINE_ALONE

        raise InputError(f"{'--shard' if slurm is None else '--slurm'}: {REFINE_ALONE}")
    if slurm is not None:
        _write_job(study, folder, slurm)
        return None
    if dry_run:
        _print_estimate(chosen, folder, shard)
        return None
    table = collect_study(chosen, folder, building_progress()) if collect else _run(chosen, folder, shard, dask)
    if table is None:
        print(f"shard {shard} is done; when all are: forficula study {study} --out {folder} --collect")
        return None

    from forficula.show import print_study, write_study
    from forficula.study.tables.study_table import study_of_table

    chosen = study_of_table(table)  # with the points that refinement placed
    print_study(chosen, table)
    if (folder / "table.nc").is_file():
        note(f"{folder}: replaces the table, the maps and the page; the rows are kept")
    write_study(chosen, table, folder, parquet=parquet)
    set_result(json_rows(chosen, table))
    _report(chosen, table, keep, folder, engine=not no_engine)
    end_with_page(folder, show=open_report)
    return None


def _print_status(study: Study, name: str, folder: Path) -> int:
    """Print the status of a study, and return the exit status: 2 unless the study is complete."""
    from forficula.serial import plain
    from forficula.show.study.status_table import print_status
    from forficula.study.running.study_status import study_status

    status = study_status(study, folder)
    print_status(status, name, folder)
    set_result(plain(status))
    return 0 if status.complete else 2


def _write_job(study: str, folder: Path, shards: int) -> None:
    """Write the SLURM job array of a study, and print how to submit it."""
    from forficula.files import write_text
    from forficula.study import slurm_script

    job = folder / "study.slurm"
    write_text(job, slurm_script(study, str(folder), shards))
    print(f"written to {job}; submit it with: sbatch {job}")


def _print_estimate(study: Study, folder: Path, shard: str) -> None:
    """Print the number of runs of a study or a shard of it, and the time of those that remain."""
    from forficula.show.progress import building_progress
    from forficula.study import estimate

    number, count = read_shard(shard)
    most, left, seconds = estimate(study, folder, building_progress(), shard=(number, count))
    points = len(range(number - 1, len(study.points), count))
    set_result({"name": study.name, "points": points, "most_runs": most, "runs_left": left, "time_s": seconds})
    name = study.name if count == 1 else f"shard {shard} of {study.name}"
    print(f"{name}: {counted(points, 'point')}, at most {counted(most, 'run')}; {left} to do, about {seconds:.0f} s")
    if study.boundaries is not None:
        count = study.boundaries.full_grid
        print(f"These are the points of the initial grid. Refinement adds some of the {count} points of the full grid.")


def _run(study: Study, folder: Path, shard: str, dask: str | None) -> Dataset | None:
    """Run a study or a shard of it, on this machine or a Dask cluster; None where other shards are missing."""
    from forficula.show import study_progress
    from forficula.show.progress import building_progress
    from forficula.study import dask_cluster, run_study

    with (
        ended_by_signal(),
        nullcontext() if dask is None else dask_cluster(dask) as cluster,
        study_progress() as progress,
    ):
        return run_study(
            study,
            folder,
            shard=read_shard(shard),
            cluster=cluster,
            progress=runs_estimated(progress, most=study.search is not None),
            building=building_progress(),
        )


def _report(study: Study, table: Dataset, keep: int | None, folder: Path, *, engine: bool) -> None:
    """Write the page of a study, and store the runs that it plays."""
    from forficula.show import study_progress
    from forficula.show.folder.study_folder import write_study_report
    from forficula.study.running.kept_runs import MOST_POINTS, kept_runs, runs_to_keep

    runs = runs_to_keep(study, table, MOST_POINTS if keep is None else keep)
    if runs:
        what = "1 run" if len(runs) == 1 else f"{len(runs)} runs"
        note(f"storing {what} for playback in report.html (--keep 0 stores none)")
    with study_progress() as progress:
        kept = kept_runs(runs, folder, progress=progress)
        write_study_report(study, table, kept, len(runs), folder, engine=engine)


def studies() -> None:
    """List the named studies, goals and observations with their sources and contents."""
    from forficula.goals import load_goal, named_goals
    from forficula.goals.identify import load_observations, named_observations
    from forficula.study import load_study
    from forficula.study.files.study_file import named_studies

    listing: list[dict[str, object]] = []
    for name in named_studies():
        study = load_study(name)
        factors = [factor.key for factor in study.factors]
        changes = [change.name for change in study.plan.changes]
        over = listed([*factors, *(f"grid of {axis.key}" for axis in study.grid)])
        if changes:
            over = f"{counted(len(changes), 'change')}{' and pairs of them' * (len(study.points) > 1 + len(changes))}"
        print(f"{name}\n    {study.source}\n    {len(study.points)} points of {study.base.name} over {over}")
        facts = {"name": name, "kind": "study", "source": study.source, "design": study.base.name}
        grid = [axis.key for axis in study.grid]
        listing.append(facts | {"points": len(study.points), "factors": factors, "grid": grid})
        if changes:
            listing[-1]["changes"] = changes
    for name in named_goals():
        goal = load_goal(name)
        objectives = listed(f"{objective.kind} {objective.quantity.name}" for objective in goal.objectives)
        keys = [parameter.key for parameter in goal.parameters]
        print(f"{name}\n    {goal.source}\n    a goal: {objectives} of {goal.base.name} over {listed(keys)}")
        facts = {"name": name, "kind": "goal", "source": goal.source, "design": goal.base.name}
        listing.append(
            facts | {"objectives": [objective.quantity.name for objective in goal.objectives], "factors": keys}
        )
    for name in named_observations():
        observations = load_observations(name)
        observed, keys = [fact.name for fact in observations.facts], [prior.key for prior in observations.priors]
        what = f"{counted(len(observed), 'fact')} on {counted(len(keys), 'unknown value')}"
        print(f"{name}\n    {observations.source}\n    {what} of {observations.base.name}")
        facts = {"name": name, "kind": "observations", "source": observations.source, "design": observations.base.name}
        listing.append(facts | {"facts": observed, "factors": keys})
    set_result(listing)


def converge(
    design: DesignName,
    /,
    *,
    timesteps: Annotated[str | None, Parameter(help='Timesteps, such as "0.5 0.4 0.3 0.2 0.1 ms".')] = None,
    moduli: Annotated[str | None, Parameter(help='Young\'s moduli of the membrane, such as "0.5 1 2 4 MPa".')] = None,
    meshes: Annotated[str | None, Parameter(help='Refinements of the rows of the membrane, such as "1 2 3".')] = None,
    settings: Settings = None,
    unit: DrawingUnit = None,
    out: Annotated[OutIfGiven, Parameter(help="Output folder; default: out/<name of the design>-converge.")] = None,
    tolerate: Tolerate = False,
    ok_if: OkIf = None,
) -> int:
    """Run a design at several timesteps, membrane moduli or meshes, and report how its times converge."""
    chosen = read_design(design, settings, unit)
    folder = out or Path("out") / f"{chosen.name}-converge"
    check_verdicts(ok_if)
    check_folder(folder, "convergence study")

    from forficula.reproduction import shown_hinge
    from forficula.show import study_progress
    from forficula.show.folder.convergence_folder import write_convergence
    from forficula.show.study.convergence_table import print_convergence
    from forficula.study.convergence.convergence import converge as converge_design
    from forficula.study.convergence.refinement import MESH, TIMESTEP, YOUNGS_MODULUS, read_values

    options = {"--timesteps": (TIMESTEP, timesteps), "--moduli": (YOUNGS_MODULUS, moduli), "--meshes": (MESH, meshes)}
    used = [(option, key, text) for option, (key, text) in options.items() if text is not None]
    if len(used) != 1:
        named = ", ".join(option for option, _, _ in used) or "none"
        raise InputError(f"converge: need one of {', '.join(options)}, got {named}")
    ((option, key, text),) = used
    values = read_option(option, lambda: read_values(key, text))
    hinge = shown_hinge(chosen)
    note_replaced(folder, "convergence study")
    with study_progress() as progress:
        convergence = converge_design(chosen, key, values, hinge=hinge, progress=runs_estimated(progress))
    print_convergence(convergence)
    write_convergence(convergence, folder)
    finish_folder(folder, "convergence study")
    return exit_status([convergence.own_verdict], tolerate=tolerate, ok_if=ok_if) or 2 * (convergence.fine is False)


def assumptions(
    design: DesignName,
    /,
    *,
    only: Annotated[
        list[str] | None,
        Parameter(help='Change only this assumption, such as "slow rise"; may be repeated.', negative=()),
    ] = None,
    settings: Settings = None,
    unit: DrawingUnit = None,
    out: Annotated[OutIfGiven, Parameter(help="Output folder; default: out/<name of the design>-assumptions.")] = None,
    tolerate: Tolerate = False,
    ok_if: OkIf = None,
) -> int:
    """Run a design with one modelling assumption changed at a time, and report which of them decide its result.

    The assumptions are: rise of drives, armature, damping, height of tendons, masses, air, gravity, contact, stops,
    timestep and start.
    """
    from forficula.study.assumptions.assumptions_file import FOLDER_ENDING
    from forficula.study.assumptions.modelling_assumptions import selected

    chosen = read_design(design, settings, unit)
    folder = out or Path("out") / f"{chosen.name}{FOLDER_ENDING}"
    check_verdicts(ok_if)
    check_folder(folder, "table of assumptions")
    to_change = read_option("--only", lambda: selected(only))

    from forficula.show import run_progress
    from forficula.show.folder.assumptions_folder import write_assumptions
    from forficula.show.study.assumptions_table import print_assumptions
    from forficula.study.assumptions.assumptions import run_assumptions
    from forficula.study.running.numerical_settings import finds_settings

    note_replaced(folder, "table of assumptions")
    with run_progress("building the changed designs") as progress:
        estimate = RunEstimate(progress, searches=finds_settings(chosen), several=True, stages=chosen.protocol.stages)
        result = run_assumptions(chosen, assumptions=to_change, progress=estimate)
    print_assumptions(result)
    write_assumptions(result, folder)
    finish_folder(folder, "table of assumptions")
    return exit_status([result.own.verdict], tolerate=tolerate, ok_if=ok_if)
