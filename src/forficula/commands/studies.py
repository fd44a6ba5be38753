"""Commands that make many runs."""

from __future__ import annotations

from contextlib import nullcontext
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

from cyclopts import Parameter

from forficula.errors import InputError
from forficula.names import counted, listed
from forficula.options import (
    WHOLE_NUMBER,
    Dask,
    DesignName,
    NoEngine,
    OkIf,
    OutIfGiven,
    Settings,
    Tolerate,
    check_apart,
    check_folder,
    check_verdicts,
    exit_status,
    read_option,
    read_settings,
    read_shard,
    tell_replaced,
    tell_written,
)
from forficula.terminal import came_to, remark

if TYPE_CHECKING:
    from xarray import Dataset

    from forficula.study import Study

_ALL = "1/1"  # every point is of this shard


def study(
    study: Annotated[str, Parameter(help="A named study, or the path of a study file (.toml).")],
    /,
    *,
    out: Annotated[OutIfGiven, Parameter(help="Folder of the study; out/<its name> if not given.")] = None,
    dry_run: Annotated[bool, Parameter(help="Only say how many runs there are and how long they take.")] = False,
    shard: Annotated[str, Parameter(help="Run a part of the points, as in 2/8; then collect.")] = _ALL,
    collect: Annotated[bool, Parameter(help="Build the table from the rows of all shards.")] = False,
    slurm: Annotated[
        int | None, WHOLE_NUMBER, Parameter(help="Write a SLURM job array of so many shards instead.")
    ] = None,
    dask: Dask = None,
    keep: Annotated[
        int | None,
        WHOLE_NUMBER,
        Parameter(help="Keep runs of so many points at most, to be played in its page; 100 if not given, 0 for none."),
    ] = None,
    no_engine: NoEngine = False,
) -> None:
    """Run a study, or go on with it where it stopped: a table, maps, and a page on which they open their runs."""
    from forficula.reproduction import check_reproduction
    from forficula.show.progress import building_progress
    from forficula.study import collect as collect_study
    from forficula.study import load_study, table_json

    split, drawn = {"--shard": shard != _ALL, "--dask": dask is not None}, {"--keep": keep is not None}
    drawn["--no-engine"] = no_engine
    check_apart("--slurm", slurm is not None, {"--collect": collect, "--dry-run": dry_run} | split | drawn)
    check_apart("--collect", collect, {"--dry-run": dry_run} | split)
    check_apart("--dry-run", dry_run, split | drawn)
    chosen = load_study(study)
    folder = out or Path("out") / chosen.name
    check_folder(folder, "study")
    check_reproduction(chosen)
    if keep is not None:
        from forficula.study.running.kept_runs import check_most

        most = keep
        read_option("--keep", lambda: check_most(most))
    if slurm is not None:
        _write_job(study, folder, slurm)
        return
    if dry_run:
        _print_estimate(chosen, folder)
        return
    table = collect_study(chosen, folder, building_progress()) if collect else _run(chosen, folder, shard, dask)
    if table is None:
        print(f"shard {shard} is done; when all are: forficula study {study} --out {folder} --collect")
        return

    from forficula.show import print_study, write_study

    if (folder / "table.nc").is_file():
        remark(f"{folder}: replaces the table, the maps and the page there; the rows stay")
    write_study(chosen, table, folder)
    came_to(table_json(chosen, table))
    _report(chosen, table, keep, folder, engine=not no_engine)
    print_study(chosen, table)
    print(f"\nwritten to {folder}")


def _write_job(study: str, folder: Path, shards: int) -> None:
    """Write a study's SLURM job array, and say how to submit it."""
    from forficula.files import write_text
    from forficula.study import slurm_script

    job = folder / "study.slurm"
    write_text(job, slurm_script(study, str(folder), shards))
    print(f"written to {job}; submit it with: sbatch {job}")


def _print_estimate(study: Study, folder: Path) -> None:
    """Print how many runs a study takes, and how long the rest of them."""
    from forficula.show.progress import building_progress
    from forficula.study import estimate

    most, left, seconds = estimate(study, folder, building_progress())
    came_to({"name": study.name, "points": len(study.points), "most_runs": most, "runs_left": left, "time_s": seconds})
    print(f"{study.name}: {len(study.points)} points, at most {most} runs; {left} to do, about {seconds:.0f} s")


def _run(study: Study, folder: Path, shard: str, dask: str | None) -> Dataset | None:
    """Run a study or a shard of it, here or on a Dask cluster; None where others of its shards are not done."""
    from forficula.show import study_progress
    from forficula.show.progress import building_progress
    from forficula.study import dask_cluster, run_study

    with nullcontext() if dask is None else dask_cluster(dask) as cluster, study_progress() as progress:
        return run_study(
            study,
            folder,
            shard=read_shard(shard),
            cluster=cluster,
            progress=progress,
            building=building_progress(),
        )


def _report(study: Study, table: Dataset, keep: int | None, folder: Path, *, engine: bool) -> None:
    """Write a study's page, and keep the runs that it plays."""
    from forficula.show import study_progress
    from forficula.show.folder.study_folder import write_study_report
    from forficula.study.running.kept_runs import MOST_POINTS, kept_runs, runs_to_keep

    runs = runs_to_keep(study, table, MOST_POINTS if keep is None else keep)
    if runs:
        what = "1 run" if len(runs) == 1 else f"{len(runs)} runs"
        remark(f"keeping {what} whole, to be played in report.html (--keep 0 does without)")
    with study_progress() as progress:
        kept = kept_runs(runs, folder, progress=progress)
        write_study_report(study, table, kept, len(runs), folder, engine=engine)


def studies() -> None:
    """List the named studies, goals and observations, each with its source and what it asks."""
    from forficula.goals import load_goal, named_goals
    from forficula.goals.identify import load_observations, named_observations
    from forficula.study import load_study
    from forficula.study.files.study_file import named_studies

    told: list[dict[str, object]] = []
    for name in named_studies():
        found = load_study(name)
        factors = [factor.key for factor in found.factors]
        over = listed([*factors, *(f"grid of {each.key}" for each in found.grid)])
        print(f"{name}\n    {found.source}\n    {len(found.points)} points of {found.base.name} over {over}")
        of = {"name": name, "kind": "study", "source": found.source, "design": found.base.name}
        told.append(of | {"points": len(found.points), "factors": factors, "grid": [each.key for each in found.grid]})
    for name in named_goals():
        goal = load_goal(name)
        asked = listed(f"{each.kind} {each.quantity.name}" for each in goal.objectives)
        keys = [each.key for each in goal.parameters]
        print(f"{name}\n    {goal.source}\n    a goal: {asked} of {goal.base.name} over {listed(keys)}")
        of = {"name": name, "kind": "goal", "source": goal.source, "design": goal.base.name}
        told.append(of | {"objectives": [each.quantity.name for each in goal.objectives], "factors": keys})
    for name in named_observations():
        seen = load_observations(name)
        facts, keys = [fact.name for fact in seen.facts], [prior.key for prior in seen.priors]
        what = f"{counted(len(facts), 'fact')} on {counted(len(keys), 'unknown value')}"
        print(f"{name}\n    {seen.source}\n    {what} of {seen.base.name}")
        of = {"name": name, "kind": "observations", "source": seen.source, "design": seen.base.name}
        told.append(of | {"facts": facts, "factors": keys})
    came_to(told)


def converge(
    design: DesignName,
    /,
    *,
    timesteps: Annotated[str | None, Parameter(help='Timesteps, as in "0.5 0.4 0.3 0.2 0.1 ms".')] = None,
    moduli: Annotated[str | None, Parameter(help='Moduli of the membrane, as in "0.5 1 2 4 MPa".')] = None,
    meshes: Annotated[str | None, Parameter(help='How many times finer its rows are, as in "1 2 3".')] = None,
    settings: Settings = None,
    out: Annotated[
        OutIfGiven, Parameter(help="Folder for the results; out/<name of the design>-converge if not given.")
    ] = None,
    tolerate: Tolerate = False,
    ok_if: OkIf = None,
) -> int:
    """Run a design at several timesteps, membrane moduli or meshes: do its times depend on them?"""
    from forficula.design import load_design

    chosen = load_design(design, read_settings(settings))
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
    given = [(option, key, text) for option, (key, text) in options.items() if text is not None]
    if len(given) != 1:
        named = ", ".join(option for option, _, _ in given) or "none"
        raise InputError(f"converge: need one of {', '.join(options)}, got {named}")
    ((option, key, text),) = given
    values = read_option(option, lambda: read_values(key, text))
    hinge = shown_hinge(chosen)
    tell_replaced(folder, "convergence study")
    with study_progress() as progress:
        convergence = converge_design(chosen, key, values, hinge=hinge, progress=progress)
    print_convergence(convergence)
    write_convergence(convergence, folder)
    tell_written(folder, "convergence study")
    return exit_status([convergence.own_verdict], tolerate=tolerate, ok_if=ok_if) or 2 * (convergence.fine is False)


def assumptions(
    design: DesignName,
    /,
    *,
    only: Annotated[
        list[str] | None,
        Parameter(help='Change this assumption, such as "slow rise", and no other; may be repeated.', negative=()),
    ] = None,
    settings: Settings = None,
    out: Annotated[
        OutIfGiven, Parameter(help="Folder for the results; out/<name of the design>-assumptions if not given.")
    ] = None,
    tolerate: Tolerate = False,
    ok_if: OkIf = None,
) -> int:
    """Run a design with one modelling assumption changed at a time: which of them decide its result?

    They are rise of drives, armature, damping, height of tendons, masses, air, gravity, contact, stops, step and start.
    """
    from forficula.design import load_design
    from forficula.study.assumptions.assumptions_file import FOLDER_ENDING
    from forficula.study.assumptions.modelling_assumptions import selected

    chosen = load_design(design, read_settings(settings))
    folder = out or Path("out") / f"{chosen.name}{FOLDER_ENDING}"
    check_verdicts(ok_if)
    check_folder(folder, "table of assumptions")
    to_change = read_option("--only", lambda: selected(only))

    from forficula.show import run_progress
    from forficula.show.folder.assumptions_folder import write_assumptions
    from forficula.show.study.assumptions_table import print_assumptions
    from forficula.study.assumptions.assumptions import run_assumptions

    tell_replaced(folder, "table of assumptions")
    with run_progress("building the changed designs") as progress:
        found = run_assumptions(chosen, assumptions=to_change, progress=progress)
    print_assumptions(found)
    write_assumptions(found, folder)
    tell_written(folder, "table of assumptions")
    return exit_status([found.own.verdict], tolerate=tolerate, ok_if=ok_if)
