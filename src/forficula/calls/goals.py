"""Calls for inverse questions: from the required or observed behaviour to the design."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

from forficula.calls.journals import journal_folder, seed_of
from forficula.calls.progress import Progress, ProgressOption, reporting, runs_done
from forficula.design import AnyDesign, as_design
from forficula.files import AnyPath, as_path

if TYPE_CHECKING:
    from numpy.random import Generator

    from forficula.goals import Goal
    from forficula.goals.identify import Observations
    from forficula.goals.identify.result import IdentificationTable
    from forficula.goals.optimise import Optimum, SoFar
    from forficula.goals.tolerance.tolerance_table import ToleranceTable


def identify(
    observations: Observations | AnyPath | Mapping[str, object],
    out: AnyPath | None = None,
    *,
    threads: int = 0,
    progress: ProgressOption = None,
) -> IdentificationTable:
    """Find the values of unknown keys that agree with observations, as `forficula identify` does.

    Args:
        observations: observations, the name of named ones, the path of an observations file, or its tables, as in
            `{"design": design, "unknown": {"tendon.left.stiffness": [...]}, "fact": [...]}`.
        out: folder of the journal, in which an interrupted identification continues; a temporary one if not given.
        threads: number of threads; 0 for one per core.
        progress: as in `run`; `Progress.latest` has the samples so far.

    Returns:
        Table over samples and facts: values, their distances from each fact, and which samples agree. Each unknown
        value has the ends of its range, SI, as the attributes `agrees_low` and `agrees_high`, or `agrees_choices`.

    Raises:
        InputError: no such observations, values that are not allowed, or a folder of other observations.

    >>> fact = {"name": "closes", "quantity": "close_time", "absent": "9 s", "at_most": "1 s"}
    >>> unknown = {"tendon.left.stiffness": ["0.4 N/cm", "0.6 N/cm"]}
    >>> sampling = {"samples": 2, "directed": 0}
    >>> table = ff.identify({"design": design, "unknown": unknown, "sampling": sampling, "fact": [fact]})
    >>> table["met"].values.tolist()
    [[True], [True]]
    """
    from forficula.goals.identify import Observations, load_observations, observations_of
    from forficula.goals.identify.run_identify import identify as identify_in

    match observations:
        case Observations():
            question = observations
        case Mapping():
            question = observations_of(observations)
        case _:
            question = load_observations(as_path(observations, "observations, their name or the path of their file"))
    with journal_folder(out) as folder, reporting(progress, _samples) as tell:
        table: IdentificationTable = identify_in(question, folder, threads=threads, progress=tell)  # type: ignore[assignment]
    return table


def optimise(
    goal: Goal | AnyPath | Mapping[str, object],
    out: AnyPath | None = None,
    *,
    threads: int = 0,
    progress: ProgressOption = None,
) -> Optimum:
    """Find the designs that meet a goal best, as `forficula optimise` does.

    Args:
        goal: goal, the name of a named one, the path of a goal file, or its tables, in which `design` may be a design.
        out: folder of the journal, in which an interrupted search continues; a temporary one if not given.
        threads: number of threads; 0 for one per core.
        progress: as in `run`; `Progress.latest` has the best candidate so far.

    Returns:
        Optimum, whose `designs` are the best ones and whose `table` has all that were tried.

    Raises:
        InputError: no such goal, values that are not allowed, or a folder of another design.

    >>> goal = {
    ...     "name": "holds",
    ...     "design": "binder2025-joint",
    ...     "simulate": False,
    ...     "vary": {"tendon.area": {"low": "1 mm^2", "high": "9 mm^2"}},
    ...     "limits": {"hinge_holding_torque": ">= 8 N cm"},
    ...     "objectives": {"mass": "least"},
    ...     "search": {"runs": 48, "batch": 16},
    ... }
    >>> optimum = ff.optimise(goal)
    >>> f"{1e6 * optimum.designs[0].tendons[0].area:.2f} mm^2"
    '4.71 mm^2'
    """
    from forficula.goals import Goal, goal_of, load_goal
    from forficula.goals.optimise import optimise_goal

    if isinstance(goal, Mapping):
        goal = goal_of(goal)
    if not isinstance(goal, Goal):
        goal = load_goal(as_path(goal, "a named goal, or the path of a goal file"))
    with journal_folder(out) as folder, reporting(progress, _designs) as tell:
        return optimise_goal(goal, folder, threads=threads, progress=tell)


def tolerance(
    design: AnyDesign,
    out: AnyPath | None = None,
    *,
    tolerances: Mapping[str, object] | None = None,
    limits: Mapping[str, object] | None = None,
    goal: AnyPath | None = None,
    minutes: float = 5.0,
    runs: int | None = None,
    rng: Generator | int | None = 0,
    seed: int | None = None,
    threads: int = 0,
    progress: ProgressOption = None,
) -> ToleranceTable:
    """Compute the probability that a design works within manufacturing tolerances, as `forficula tolerance` does.

    Args:
        design: design, its name or its path.
        out: folder of the journal, in which an interrupted assessment continues; a temporary one if not given.
        tolerances: by key, as in a goal file; without any, a uniform tolerance of 10 % on every positive value with a
            unit that is not of the protocol.
        limits: requirements by quantity, as in a goal file, beyond those of the protocol.
        goal: name or path of a goal, whose tolerances and limits apply where none are given here. Its settings apply to
            the design, except to keys that the goal varies.
        minutes: longest duration; more time gives narrower intervals.
        runs: largest number of runs instead of a duration; the result is then the same on every machine.
        rng: seed of the points within the tolerances, or a generator that draws it; None for a new seed each time.
        seed: old name of `rng`.
        threads: number of threads; 0 for one per core.
        progress: as in `run`; `Progress.latest` is the row of the last run.

    Returns:
        Probabilities, sensitivity indices, the distance that each value may deviate alone, and all samples. The
        attribute `says` has the conclusions as sentences.

    Raises:
        InputError: no such design or goal, values that are not allowed, or a folder of another design.

    >>> table = ff.tolerance(design, tolerances={"facet.thickness": "1 %"}, minutes=0.01)
    >>> table["outcome"].values[0]
    'closed and opened'
    """
    from forficula.goals.tolerance import assess_tolerance
    from forficula.goals.tolerance.question_file import question_of
    from forficula.goals.tolerance.tolerance_table import tolerance_table

    named = None if goal is None else as_path(goal, "a named goal, or the path of a goal file")
    question = question_of(as_design(design), tolerances, limits, named)
    start = seed_of(rng, seed)
    with journal_folder(out) as folder, reporting(progress, runs_done) as tell:
        assessed = assess_tolerance(
            question, folder, minutes=minutes, runs=runs, seed=start, threads=threads, progress=tell
        )
    table: ToleranceTable = tolerance_table(assessed)  # type: ignore[assignment]
    return table


def _samples(done: int, total: int, samples: object) -> Progress:
    return Progress(task="samples", done=done, total=total, unit="samples", latest=samples)


def _designs(state: SoFar) -> Progress:
    return Progress(task="designs", done=state.tried, total=state.goal.runs, unit="designs", latest=state.best)
