"""Commands for inverse questions: optimise a design, assess its tolerances, identify unknown values."""

from __future__ import annotations

from contextlib import AbstractContextManager, nullcontext
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

from cyclopts import Parameter

from forficula.commands.cost import LONG
from forficula.errors import InputError
from forficula.names import counted, listed
from forficula.options import (
    WHOLE_NUMBER,
    Dask,
    DrawingUnit,
    OpenReport,
    OutIfGiven,
    Settings,
    check_apart,
    check_folder,
    finish_folder,
    note_replaced,
    options_named,
    read_design,
    read_option,
    read_settings,
    read_shard,
)
from forficula.terminal import note, set_result

if TYPE_CHECKING:
    from xarray import Dataset

    from forficula.goals import Goal
    from forficula.goals.identify import Observations
    from forficula.goals.optimise import Optimum
    from forficula.goals.optimise.optimise import SoFar
    from forficula.goals.tolerance import Question, Tolerance
    from forficula.goals.tolerance.plan import Plan
    from forficula.study.running.run_study import Evaluate


_Shard = Annotated[
    str,
    Parameter(help="Share the runs with other processes: 2/8 is process 2 of 8. Each process writes the whole result."),
]
_ALL = "1/1"  # the shard of all runs
_ROWS_KEPT = "; the rows are kept"


def _folder(out: Path | None, name: str, kind: str) -> Path:
    """Return the output folder, and refuse one with results of another kind.

    Args:
        out: folder of --out.
        name: name of the folder within `out/` without --out.
        kind: kind of the results.
    """
    folder = out or Path("out") / name
    check_folder(folder, kind)
    return folder


def _cluster(scheduler: str | None) -> AbstractContextManager[Evaluate | None]:
    """Return the Dask cluster that runs designs; None for this machine."""
    from forficula.study import dask_cluster

    return nullcontext() if scheduler is None else dask_cluster(scheduler)


def optimise(
    goal: Annotated[str, Parameter(help="A named goal, or the path of a goal file (.toml).")],
    /,
    *,
    out: Annotated[OutIfGiven, Parameter(help="Output folder; default: out/<name of the goal>.")] = None,
    keep: Annotated[
        int, WHOLE_NUMBER, Parameter(help="Maximum number of runs stored for playback in report.html; 0 for none.")
    ] = 24,
    dry_run: Annotated[bool, Parameter(help="Only estimate the number of designs and their time.")] = False,
    shard: _Shard = _ALL,
    dask: Dask = None,
    open_report: OpenReport = False,
) -> int:
    """Search for the design that meets a goal best, or resume a search."""
    from forficula.goals import load_goal
    from forficula.goals.optimise.optimise import estimate_optimise
    from forficula.goals.optimise.summary import filling_text
    from forficula.study.running.kept_runs import check_most

    check_apart("--dry-run", dry_run, {"--shard": shard != _ALL, "--dask": dask is not None})
    chosen = load_goal(goal)
    folder = _folder(out, chosen.name, "optimisation")
    read_option("--keep", lambda: check_most(keep))
    share = read_shard(shard)
    if filled := filling_text(chosen):
        note(f"{chosen.name}: {filled}")
    if dry_run:
        designs, seconds = estimate_optimise(chosen)
        near = chosen.neighbours if chosen.deviations else 0
        set_result({"goal": chosen.name, "most_designs": designs, "neighbours": near, "time_s": seconds})
        neighbours = f", and up to {near} perturbed builds of the best designs" if near else ""
        print(f"{chosen.name}: at most {counted(designs, 'design')}, about {seconds:.0f} s{neighbours}")
        return 0
    note_replaced(folder, "optimisation", _ROWS_KEPT)
    optimum = _optimised(chosen, folder, share, dask)

    from forficula.goals.optimise.optimum import candidates_to_keep
    from forficula.show import study_progress
    from forficula.show.folder.optimum_folder import write_optimum, write_optimum_report
    from forficula.show.goals.optimum_text import print_optimum
    from forficula.study.running.kept_runs import kept_runs

    print_optimum(optimum)
    write_optimum(optimum, folder)
    runs = candidates_to_keep(optimum, keep)
    with study_progress() as progress:
        write_optimum_report(optimum, kept_runs(runs, folder, progress=progress), len(runs), folder)
    finish_folder(folder, "optimisation", show=open_report)
    return 0 if optimum.best else 2


def _optimised(goal: Goal, folder: Path, shard: tuple[int, int], dask: str | None) -> Optimum:
    """Search on this machine or on a Dask cluster."""
    from forficula.commands.cost import CountEstimate
    from forficula.goals.optimise import optimise_goal
    from forficula.show.goals.goal_progress import optimise_progress

    estimate = CountEstimate("designs", most=True)
    with _cluster(dask) as cluster, optimise_progress() as progress:

        def update(so_far: SoFar) -> None:
            estimate.update(so_far.tried, so_far.goal.runs)
            progress(so_far)

        return optimise_goal(goal, folder, shard=shard, cluster=cluster, progress=update)


def tolerance(
    design: Annotated[
        str | None,
        Parameter(
            help="A named design, or the path of a design file (.toml), a FOLD file or a drawing (.svg, .dxf); default:"
            " the design of --goal."
        ),
    ] = None,
    /,
    *,
    settings: Settings = None,
    unit: DrawingUnit = None,
    tolerances: Annotated[
        list[str] | None,
        Parameter(
            name="--tolerance",
            help='Tolerance of a value, such as tendon.stiffness="5 %" or all="2 %"; may be repeated.',
            negative=(),
        ),
    ] = None,
    goal: Annotated[
        str | None, Parameter(help="A named goal, or the path of a goal file, with tolerances and limits.")
    ] = None,
    out: Annotated[OutIfGiven, Parameter(help="Output folder; default: out/<name of the design>-tolerance.")] = None,
    minutes: Annotated[float, Parameter(help="Time limit in minutes; more time gives narrower intervals.")] = 5.0,
    runs: Annotated[
        int | None,
        WHOLE_NUMBER,
        Parameter(help="Maximum number of runs, which replaces the time limit; the smallest sample needs 17."),
    ] = None,
    seed: Annotated[int, WHOLE_NUMBER, Parameter(help="Seed of the random sample within the tolerances.")] = 0,
    keep: Annotated[
        int, WHOLE_NUMBER, Parameter(help="Maximum number of runs stored for playback in report.html; 0 for none.")
    ] = 12,
    dry_run: Annotated[bool, Parameter(help="Only print the planned runs and estimate their time.")] = False,
    shard: _Shard = _ALL,
    dask: Dask = None,
    open_report: OpenReport = False,
) -> int:
    """Estimate the probability that a design works within its manufacturing tolerances, and which matter most."""
    from forficula.goals.tolerance import estimate_tolerance
    from forficula.goals.tolerance.assess_tolerance import check_numbers
    from forficula.goals.tolerance.plan import PLANS
    from forficula.study.running.kept_runs import check_most

    check_apart("--dry-run", dry_run, {"--shard": shard != _ALL, "--dask": dask is not None})
    widths = read_settings(tolerances, "--tolerance", 'tendon.stiffness="5 %"')
    with options_named(minutes="--minutes", seed="--seed", runs="--runs"):
        check_numbers(minutes, seed, runs)
    question = _question(design, settings, unit, widths or None, goal)
    folder = _folder(out, f"{question.design.name}-tolerance", "tolerance")
    read_option("--keep", lambda: check_most(keep))
    share = read_shard(shard)
    if runs is not None and (fewest := PLANS[-1].most_runs(len(question.deviations))) > runs:
        note(f"--runs: the smallest sample needs {fewest} runs, which are more than {runs}")
    if dry_run:
        _print_plan(question, *estimate_tolerance(question, folder, minutes, seed, runs))
        return 0
    note_replaced(folder, "tolerance", _ROWS_KEPT)
    if runs is None and 60 * minutes > LONG:
        note(f"estimate: up to {minutes:.3g} min (--minutes)")
    result = _assessed(question, folder, minutes, runs, seed, share, dask)
    _write_tolerance(result, folder, keep, show=open_report)
    return 0 if result.nominal_works and result.meets else 2


def _assessed(
    question: Question,
    folder: Path,
    minutes: float,
    runs: int | None,
    seed: int,
    shard: tuple[int, int],
    dask: str | None,
) -> Tolerance:
    """Assess the tolerances of a design on this machine or on a Dask cluster."""
    from forficula.commands.cost import runs_estimated
    from forficula.goals.tolerance import assess_tolerance
    from forficula.show import study_progress

    with _cluster(dask) as cluster, study_progress() as progress:
        return assess_tolerance(
            question,
            folder,
            minutes=minutes,
            runs=runs,
            seed=seed,
            shard=shard,
            cluster=cluster,
            progress=progress if runs is None else runs_estimated(progress, most=True),
        )


def _question(
    design: str | None,
    settings: list[str] | None,
    unit: str | None,
    tolerances: dict[str, object] | None,
    goal: str | None,
) -> Question:
    """Return the question of a design, or of the design of a goal, and report values that the goal changes."""
    from forficula.design import differing_keys
    from forficula.goals.tolerance.question_file import question_of

    if design is None and goal is None:
        raise InputError("tolerance: need a design, or --goal with a file that has one")
    if design is None and unit is not None:
        raise InputError("--unit: needs a FOLD file or a drawing as the design")
    chosen = None if design is None else read_design(design, settings, unit)
    with nullcontext() if tolerances is None else options_named(tolerances="--tolerance"):
        question = question_of(chosen, tolerances, goal=goal, settings=read_settings(settings))
    if chosen is not None and (keys := differing_keys(chosen, question.design)):
        note(f"{chosen.name}: {listed(keys)} set to the value{'s' * (len(keys) != 1)} of {goal}")
    _note_assumed(question)
    return question


def _print_plan(question: Question, plan: Plan, most: int, seconds: float) -> None:
    """Print the planned runs and the estimate of their time."""
    name, count, points = question.design.name, len(question.keys), plan.points + plan.rows
    facts = {"values": list(question.keys), "points": points, "most_runs": most, "time_s": seconds}
    set_result({"design": name, **facts})
    print(
        f"{name}: {counted(count, 'value')} with a tolerance; {points} points for the"
        f" probability, at most {most} runs in total, about {seconds:.0f} s"
    )


def _write_tolerance(tolerance: Tolerance, folder: Path, keep: int, *, show: bool) -> None:
    """Write the results of a tolerance and its page, and print it."""
    from forficula.goals.tolerance.kept_samples import samples_to_keep
    from forficula.show import study_progress
    from forficula.show.folder.tolerance_folder import write_tolerance, write_tolerance_report
    from forficula.show.goals.tolerance_text import print_tolerance
    from forficula.study.running.kept_runs import kept_runs

    print_tolerance(tolerance)
    write_tolerance(tolerance, folder)
    runs = samples_to_keep(tolerance, keep)
    with study_progress() as progress:
        write_tolerance_report(tolerance, kept_runs(runs, folder, progress=progress), len(runs), folder)
    finish_folder(folder, "tolerance", show=show)


def _note_assumed(question: Question) -> None:
    """Report which tolerances are assumed where none were given."""
    if question.assumed:
        note(
            f"no tolerances given: {question.width_text(0)}, uniform, assumed for {len(question.keys)} values > 0 of"
            f" {question.design.name}"
        )


def identify(
    observations: Annotated[str, Parameter(help="Named observations, or the path of an observations file (.toml).")],
    /,
    *,
    out: Annotated[OutIfGiven, Parameter(help="Output folder; default: out/<name of the observations>.")] = None,
    dry_run: Annotated[bool, Parameter(help="Only estimate the number of runs and their time.")] = False,
    shard: _Shard = _ALL,
    dask: Dask = None,
    open_report: OpenReport = False,
) -> None:
    """Find the values of unknown parameters that agree with observations, and observations that exclude each other."""
    from forficula.goals.identify import load_observations
    from forficula.goals.identify.run_identify import estimate_identify

    check_apart("--dry-run", dry_run, {"--shard": shard != _ALL, "--dask": dask is not None})
    chosen = load_observations(observations)
    folder = _folder(out, chosen.name, "identification")
    share = read_shard(shard)
    if dry_run:
        count, runs, seconds = estimate_identify(chosen)
        set_result({"name": chosen.name, "samples": count, "runs": round(runs), "time_s": seconds})
        print(f"{chosen.name}: {counted(count, 'sample')}, about {counted(round(runs), 'run')}, about {seconds:.0f} s")
        return
    note_replaced(folder, "identification", _ROWS_KEPT)
    result = _identified(chosen, folder, share, dask)

    from forficula.show.folder.identify_folder import write_identification
    from forficula.show.goals.identify_text import print_identification

    print_identification(result)
    write_identification(result, folder)
    finish_folder(folder, "identification", show=open_report)


def _identified(observations: Observations, folder: Path, shard: tuple[int, int], dask: str | None) -> Dataset:
    """Identify unknown values on this machine or on a Dask cluster."""
    from forficula.goals.identify.run_identify import identify as identify_in
    from forficula.show.goals.goal_progress import identify_progress

    with _cluster(dask) as cluster, identify_progress() as (samples, runs):
        return identify_in(observations, folder, shard=shard, cluster=cluster, progress=samples, run_progress=runs)
