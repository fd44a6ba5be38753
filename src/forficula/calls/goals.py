"""Calls that turn it round: from what a structure does, or must do, to the design."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

from forficula.design import AnyDesign, as_design
from forficula.files import AnyPath, as_path

if TYPE_CHECKING:
    from xarray import Dataset

    from forficula.goals import Goal
    from forficula.goals.identify import Observations
    from forficula.goals.optimise import Optimum, SoFar


def identify(
    observations: Observations | AnyPath | Mapping[str, object],
    out: AnyPath,
    *,
    threads: int = 0,
    progress: Callable[[int, int, Sequence[Any]], None] | None = None,
) -> Dataset:
    """Say which values of what is unknown agree with what was seen, as `forficula identify` does.

    Args:
        observations: or named ones, or the path of an observations file, or its tables, as in
            `{"design": design, "unknown": {"tendon.left.stiffness": [...]}, "fact": [...]}`.
        out: folder with the rows of runs; what was stopped goes on there.
        threads: 0 for one a core.
        progress: called after every batch with the samples done, all samples, and those so far.

    Returns:
        Over samples and facts: what was found, how far it is from each fact, and which samples agree. Each unknown
        value has the ends of its range, SI, as the attributes `agrees_low` and `agrees_high`, or `agrees_choices`.

    Raises:
        InputError: no such observations, values that are not allowed, or a folder of others.

    >>> seen = {"name": "closes", "quantity": "close_time", "absent": "9 s", "at_most": "1 s"}
    >>> lost = {"tendon.left.stiffness": ["0.4 N/cm", "0.6 N/cm"]}
    >>> asked = {"design": design, "unknown": lost, "sampling": {"samples": 2, "directed": 0}, "fact": [seen]}
    >>> ff.identify(asked, out="seen")["met"].values.tolist()
    [[True], [True]]
    """
    from forficula.goals.identify import Observations, load_observations, observations_of
    from forficula.goals.identify.run_identify import identify as identify_in

    match observations:
        case Observations():
            asked = observations
        case Mapping():
            asked = observations_of(observations)
        case _:
            asked = load_observations(as_path(observations, "observations, their name or the path of their file"))
    return identify_in(asked, as_path(out, "a folder"), threads=threads, progress=progress)


def optimise(
    goal: Goal | AnyPath | Mapping[str, object],
    out: AnyPath,
    *,
    threads: int = 0,
    progress: Callable[[SoFar], None] | None = None,
) -> Optimum:
    """Look for the designs that do best what a goal asks, as `forficula optimise` does.

    Args:
        goal: or the name of one, the path of a goal file, or its tables, in which `design` may be a design.
        out: folder with the rows of runs; what was stopped goes on there.
        threads: 0 for one a core.
        progress: called after every row with how far it is and the best so far.

    Returns:
        Its `designs` are the best ones, its `table` has all that were tried.

    Raises:
        InputError: no such goal, values that are not allowed, or a folder of another design.

    >>> asked = {
    ...     "name": "holds",
    ...     "design": "binder2025-joint",
    ...     "simulate": False,
    ...     "vary": {"tendon.area": {"low": "1 mm^2", "high": "9 mm^2"}},
    ...     "limits": {"hinge_holding_torque": ">= 8 N cm"},
    ...     "objectives": {"mass": "least"},
    ...     "search": {"runs": 48, "batch": 16},
    ... }
    >>> found = ff.optimise(asked, "held")
    >>> f"{1e6 * found.designs[0].tendons[0].area:.2f} mm^2"
    '4.71 mm^2'
    """
    from forficula.goals import Goal, goal_of, load_goal
    from forficula.goals.optimise import optimise_goal

    if isinstance(goal, Mapping):
        goal = goal_of(goal)
    if not isinstance(goal, Goal):
        goal = load_goal(as_path(goal, "a named goal, or the path of a goal file"))
    return optimise_goal(goal, as_path(out, "a folder"), threads=threads, progress=progress)


def tolerance(
    design: AnyDesign,
    out: AnyPath,
    *,
    tolerances: Mapping[str, object] | None = None,
    limits: Mapping[str, object] | None = None,
    goal: AnyPath | None = None,
    minutes: float = 5.0,
    runs: int | None = None,
    seed: int = 0,
    threads: int = 0,
    progress: Callable[[int, int, dict[str, Any]], None] | None = None,
) -> Dataset:
    """Say how likely a design works as it is built, and what decides it, as `forficula tolerance` does.

    Args:
        design: or its name or path.
        out: folder with the rows of runs; what was stopped goes on there.
        tolerances: by key, as in a goal file; 10 %, uniform, on every positive value with a unit that is not the
            protocol's where there are none.
        limits: by quantity, as in a goal file, beside what the protocol asks for.
        goal: or its name or path, whose tolerances and limits count where none are given, and whose settings hold for
            the design but for what it varies.
        minutes: how long it may take; more time gives narrower intervals.
        runs: the largest number of runs, instead of a time: the result then is the same on every machine.
        seed: of the points within the tolerances.
        threads: 0 for one a core.
        progress: called after every run with the runs done, the most that there are, and the row.

    Returns:
        Probabilities, indices, how far each value may go alone, and all samples; `says` among its attributes has what
        follows, in sentences.

    Raises:
        InputError: no such design or goal, values that are not allowed, or a folder of another design.

    >>> built = ff.tolerance(design, "built", tolerances={"facet.thickness": "1 %"}, minutes=0.01)
    >>> built["outcome"].values[0]
    'closed and opened'
    """
    from forficula.goals.tolerance import assess_tolerance
    from forficula.goals.tolerance.question_file import question_of
    from forficula.goals.tolerance.tolerance_table import tolerance_table

    named = None if goal is None else as_path(goal, "a named goal, or the path of a goal file")
    question = question_of(as_design(design), tolerances, limits, named)
    folder = as_path(out, "a folder")
    found = assess_tolerance(
        question, folder, minutes=minutes, runs=runs, seed=seed, threads=threads, progress=progress
    )
    return tolerance_table(found)
