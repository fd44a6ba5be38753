"""Commands that turn it round: from what a structure must do to the design, and to what that is worth."""

from __future__ import annotations

from contextlib import AbstractContextManager, nullcontext
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

from cyclopts import Parameter

from forficula.errors import InputError
from forficula.names import counted, listed
from forficula.options import (
    WHOLE_NUMBER,
    Dask,
    OutIfGiven,
    Settings,
    check_apart,
    check_folder,
    read_option,
    read_settings,
    read_shard,
    tell_replaced,
    tell_written,
)
from forficula.terminal import came_to, remark

if TYPE_CHECKING:
    from xarray import Dataset

    from forficula.goals import Goal
    from forficula.goals.identify import Observations
    from forficula.goals.optimise import Optimum
    from forficula.goals.tolerance import Question, Tolerance
    from forficula.goals.tolerance.plan import Plan
    from forficula.study.running.run_study import Evaluate


_Shard = Annotated[str, Parameter(help="Share the runs with other processes, as in 2/8; each of them has the result.")]
_ALL = "1/1"  # every run is of this shard
_ROWS_STAY = "; the rows stay"


def _folder(out: Path | None, name: str, own: str) -> Path:
    """The folder of a command's answer, which another kind of answer must not have.

    Args:
        out: as it was given.
        name: of the folder within `out`, if none was given.
        own: kind of its own results.
    """
    folder = out or Path("out") / name
    check_folder(folder, own)
    return folder


def _cluster(scheduler: str | None) -> AbstractContextManager[Evaluate | None]:
    """What makes rows of runs: a Dask cluster, or this machine where none is given."""
    from forficula.study import dask_cluster

    return nullcontext() if scheduler is None else dask_cluster(scheduler)


def optimise(
    goal: Annotated[str, Parameter(help="A named goal, or the path of a goal file (.toml).")],
    /,
    *,
    out: Annotated[OutIfGiven, Parameter(help="Folder of the search; out/<name of the goal> if not given.")] = None,
    keep: Annotated[
        int, WHOLE_NUMBER, Parameter(help="Keep so many runs at most, to be played in its page; 0 for none.")
    ] = 24,
    dry_run: Annotated[bool, Parameter(help="Only say how many designs are tried and how long they take.")] = False,
    shard: _Shard = _ALL,
    dask: Dask = None,
) -> int:
    """Look for the design that does best what a goal asks, or go on with it where it stopped."""
    from forficula.goals import load_goal
    from forficula.goals.optimise.optimise import estimate_optimise
    from forficula.goals.optimise.telling import filling_text
    from forficula.study.running.kept_runs import check_most

    check_apart("--dry-run", dry_run, {"--shard": shard != _ALL, "--dask": dask is not None})
    asked = load_goal(goal)
    folder = _folder(out, asked.name, "optimisation")
    read_option("--keep", lambda: check_most(keep))
    share = read_shard(shard)
    if filled := filling_text(asked):
        remark(f"{asked.name}: {filled}")
    if dry_run:
        designs, seconds = estimate_optimise(asked)
        near = asked.neighbours if asked.deviations else 0
        came_to({"goal": asked.name, "most_designs": designs, "neighbours": near, "time_s": seconds})
        neighbours = f", and up to {near} neighbours of the best" if near else ""
        print(f"{asked.name}: at most {counted(designs, 'design')}, about {seconds:.0f} s{neighbours}")
        return 0
    tell_replaced(folder, "optimisation", _ROWS_STAY)
    found = _optimised(asked, folder, share, dask)

    from forficula.goals.optimise.optimum import candidates_to_keep
    from forficula.show import study_progress
    from forficula.show.folder.optimum_folder import write_optimum, write_optimum_report
    from forficula.show.goals.optimum_text import print_optimum
    from forficula.study.running.kept_runs import kept_runs

    write_optimum(found, folder)
    runs = candidates_to_keep(found, keep)
    with study_progress() as progress:
        write_optimum_report(found, kept_runs(runs, folder, progress=progress), len(runs), folder)
    print_optimum(found)
    tell_written(folder, "optimisation")
    return 0 if found.best else 2


def _optimised(asked: Goal, folder: Path, shard: tuple[int, int], dask: str | None) -> Optimum:
    """Search here or on a Dask cluster."""
    from forficula.goals.optimise import optimise_goal
    from forficula.show.goals.goal_progress import optimise_progress

    with _cluster(dask) as cluster, optimise_progress() as progress:
        return optimise_goal(asked, folder, shard=shard, cluster=cluster, progress=progress)


def tolerance(
    design: Annotated[
        str | None,
        Parameter(
            help="A named design, or the path of a design file (.toml), a FOLD file or a drawing (.svg, .dxf); that of"
            " --goal if not given."
        ),
    ] = None,
    /,
    *,
    settings: Settings = None,
    tolerances: Annotated[
        list[str] | None,
        Parameter(
            name="--tolerance",
            help='How far off a value may be, as in --tolerance tendon.stiffness="5 %" or all="2 %"; may be repeated.',
            negative=(),
        ),
    ] = None,
    goal: Annotated[
        str | None, Parameter(help="A named goal, or the path of a file, whose tolerances and limits count.")
    ] = None,
    out: Annotated[
        OutIfGiven, Parameter(help="Folder for the results; out/<name of the design>-tolerance if not given.")
    ] = None,
    minutes: Annotated[float, Parameter(help="How long it may take; more time gives narrower intervals.")] = 5.0,
    runs: Annotated[
        int | None, WHOLE_NUMBER, Parameter(help="The largest number of runs, instead of a time: the same everywhere.")
    ] = None,
    seed: Annotated[int, WHOLE_NUMBER, Parameter(help="Of the points within the tolerances.")] = 0,
    keep: Annotated[
        int, WHOLE_NUMBER, Parameter(help="Keep so many runs at most, to be played in its page; 0 for none.")
    ] = 12,
    dry_run: Annotated[bool, Parameter(help="Only say which runs there are and how long they take.")] = False,
    shard: _Shard = _ALL,
    dask: Dask = None,
) -> int:
    """How likely does a design work as it is built, and which tolerance decides?"""
    from forficula.goals.tolerance import estimate_tolerance
    from forficula.study.running.kept_runs import check_most

    check_apart("--dry-run", dry_run, {"--shard": shard != _ALL, "--dask": dask is not None})
    own = read_settings(tolerances, "--tolerance", 'tendon.stiffness="5 %"')
    question = _question(design, read_settings(settings), own or None, goal)
    folder = _folder(out, f"{question.design.name}-tolerance", "tolerance")
    read_option("--keep", lambda: check_most(keep))
    share = read_shard(shard)
    if dry_run:
        _tell_plan(question, *estimate_tolerance(question, folder, minutes, seed, runs))
        return 0
    tell_replaced(folder, "tolerance", _ROWS_STAY)
    found = _assessed(question, folder, minutes, runs, seed, share, dask)
    _tell_tolerance(found, folder, keep)
    return 0 if found.nominal_works and found.meets else 2


def _assessed(
    question: Question,
    folder: Path,
    minutes: float,
    runs: int | None,
    seed: int,
    shard: tuple[int, int],
    dask: str | None,
) -> Tolerance:
    """Assess a tolerance here or on a Dask cluster."""
    from forficula.goals.tolerance import assess_tolerance
    from forficula.show import study_progress

    with _cluster(dask) as cluster, study_progress() as progress:
        return assess_tolerance(
            question, folder, minutes=minutes, runs=runs, seed=seed, shard=shard, cluster=cluster, progress=progress
        )


def _question(
    design: str | None, settings: dict[str, object], tolerances: dict[str, object] | None, goal: str | None
) -> Question:
    """What is asked of a design, or of that of a goal, whose settings are told where they change a design."""
    from forficula.design import differing_keys, load_design
    from forficula.goals.tolerance.question_file import question_of

    if design is None and goal is None:
        raise InputError("tolerance: need a design, or --goal with a file that has one")
    chosen = None if design is None else load_design(design, settings)
    question = question_of(chosen, tolerances, goal=goal, settings=settings)
    if chosen is not None and (keys := differing_keys(chosen, question.design)):
        remark(f"{chosen.name}: {listed(keys)} as {goal} has {'it' if len(keys) == 1 else 'them'}")
    _tell_assumed(question)
    return question


def _tell_plan(question: Question, plan: Plan, most: int, seconds: float) -> None:
    """Say which runs there are, and how long they take."""
    name, count, points = question.design.name, len(question.keys), plan.points + plan.rows
    told = {"values": list(question.keys), "points": points, "most_runs": most, "time_s": seconds}
    came_to({"design": name, **told})
    print(
        f"{name}: {counted(count, 'value')} that may be off; {points} points for the"
        f" probability, at most {most} runs in all, about {seconds:.0f} s"
    )


def _tell_tolerance(found: Tolerance, folder: Path, keep: int) -> None:
    """Write a tolerance and its page, and print it."""
    from forficula.goals.tolerance.kept_samples import samples_to_keep
    from forficula.show import study_progress
    from forficula.show.folder.tolerance_folder import write_tolerance, write_tolerance_report
    from forficula.show.goals.tolerance_text import print_tolerance
    from forficula.study.running.kept_runs import kept_runs

    write_tolerance(found, folder)
    runs = samples_to_keep(found, keep)
    with study_progress() as progress:
        write_tolerance_report(found, kept_runs(runs, folder, progress=progress), len(runs), folder)
    print_tolerance(found)
    tell_written(folder, "tolerance")


def _tell_assumed(question: Question) -> None:
    """Say on stderr which tolerances are taken where none were given."""
    if question.assumed:
        remark(
            f"no tolerances given: {question.width_text(0)}, uniform, on {len(question.keys)} positive values of"
            f" {question.design.name}"
        )


def identify(
    observations: Annotated[str, Parameter(help="Named observations, or the path of an observations file (.toml).")],
    /,
    *,
    out: Annotated[OutIfGiven, Parameter(help="Folder of the identification; out/<its name> if not given.")] = None,
    dry_run: Annotated[bool, Parameter(help="Only say how many runs there are and how long they take.")] = False,
    shard: _Shard = _ALL,
    dask: Dask = None,
) -> None:
    """Say which values of what is unknown agree with what was seen, and which facts exclude one another."""
    from forficula.goals.identify import load_observations
    from forficula.goals.identify.run_identify import estimate_identify

    check_apart("--dry-run", dry_run, {"--shard": shard != _ALL, "--dask": dask is not None})
    asked = load_observations(observations)
    folder = _folder(out, asked.name, "identification")
    share = read_shard(shard)
    if dry_run:
        count, runs, seconds = estimate_identify(asked)
        came_to({"name": asked.name, "samples": count, "runs": round(runs), "time_s": seconds})
        print(f"{asked.name}: {counted(count, 'sample')}, about {counted(round(runs), 'run')}, about {seconds:.0f} s")
        return
    tell_replaced(folder, "identification", _ROWS_STAY)
    result = _identified(asked, folder, share, dask)

    from forficula.show.folder.identify_folder import write_identification
    from forficula.show.goals.identify_text import print_identification

    write_identification(result, folder)
    print_identification(result)
    tell_written(folder, "identification")


def _identified(asked: Observations, folder: Path, shard: tuple[int, int], dask: str | None) -> Dataset:
    """Run observations here or on a Dask cluster."""
    from forficula.goals.identify.run_identify import identify as identify_in
    from forficula.show.goals.goal_progress import identify_progress

    with _cluster(dask) as cluster, identify_progress() as (samples, runs):
        return identify_in(asked, folder, shard=shard, cluster=cluster, progress=samples, run_progress=runs)
