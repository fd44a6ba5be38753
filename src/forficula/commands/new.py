"""Commands that write a file to start from: `forficula new design`, `study`, `goal`, `observations` and `tests`."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

from cyclopts import App, Group, Parameter

from forficula.errors import InputError, error_prefix
from forficula.names import listed, one_of
from forficula.options import check_apart, read_quantity
from forficula.terminal import warn

USUAL_KIND = "earwig-fan"
_File = Annotated[Path, Parameter(help="New file (.toml); existing files are not overwritten.")]
Kind = Annotated[
    str,
    Parameter(
        help="Kind of crease pattern: earwig-fan, joint, miura-ori, waterbomb, yoshimura, kresling, pleats, vertex or"
        " fold-file."
    ),
]
_Switch = Annotated[bool, Parameter(show=False, negative=())]


def _examples(*lines: str) -> str:
    return "Examples:\n" + "\n".join(f"  forficula new {line}" for line in lines)


new = App(
    name="new",
    help="Write a commented file to start from: a design, study, goal, observations or sample tests.",
    group_commands=Group("Files"),
    help_epilogue=_examples("design my-wing.toml", "study my-study.toml --kind miura-ori"),
)


_Size = Annotated[
    str | None,
    Parameter(
        help='Largest dimension of the flat pattern, such as "8 cm"; the template is scaled to this size at the same'
        " materials."
    ),
]


@new.command(
    name="design",
    help_epilogue=_examples("design my-wing.toml", 'design my-sheet.toml --kind miura-ori --size "8 cm"'),
)
def write_design(file: _File, /, *, kind: Kind = USUAL_KIND, size: _Size = None) -> None:
    """Write a design file with a comment on every key."""
    from forficula.design import write_new_design
    from forficula.design.section import LENGTH

    if size is None:
        write_new_design(file, kind)
    else:
        length = read_quantity("--size", size, LENGTH)
        with error_prefix("--"):
            write_new_design(file, kind, size=length)
    print(f"written to {file}; run it with: forficula run {file}")


@new.command(name="study", help_epilogue=_examples("study my-study.toml", "study my-study.toml --kind miura-ori"))
def write_study(file: _File, /, *, kind: Kind = USUAL_KIND) -> None:
    """Write a study file, which varies values of a design over many runs."""
    from forficula.study.files.study_file import STUDY
    from forficula.study.new_file import write_new_file

    write_new_file(file, STUDY, kind)
    print(f"written to {file}; run it with: forficula study {file}")


@new.command(name="goal", help_epilogue=_examples("goal my-goal.toml", "goal my-goal.toml --kind pleats"))
def write_goal(file: _File, /, *, kind: Kind = USUAL_KIND) -> None:
    """Write a goal file: requirements on a structure, the values that may vary, and their tolerances."""
    from forficula.goals.goal_file import GOAL
    from forficula.study.new_file import write_new_file

    write_new_file(file, GOAL, kind)
    print(f"written to {file}; find the design with: forficula optimise {file}")


@new.command(
    name="observations",
    help_epilogue=_examples("observations my-observations.toml", "observations my-joint.toml --kind joint"),
)
def write_observations(file: _File, /, *, kind: Kind = USUAL_KIND) -> None:
    """Write an observations file: unknown values of a design, and observations of it."""
    from forficula.goals.identify.observations_file import OBSERVATIONS
    from forficula.study.new_file import write_new_file

    write_new_file(file, OBSERVATIONS, kind)
    print(f"written to {file}; find the unknown values with: forficula identify {file}")


@new.command(name="tests", help_epilogue=_examples("tests my-tests.csv", "tests data/rubber.csv"))
def write_tests(
    file: Annotated[Path, Parameter(help="New files (.csv), numbered; existing files are not overwritten.")],
    /,
) -> None:
    """Write three tensile tests with made-up values, to try `forficula material`."""
    from forficula.material.sample_tests import write_sample_tests

    files = " ".join(str(written) for written in write_sample_tests(file))
    print(f'written with made-up values; fit a law with: forficula material {files} --length "60 mm" --area "5 mm^2"')


_COMMANDS = {"study": write_study, "goal": write_goal, "observations": write_observations}


@new.default
def write_by_switch(
    file: Annotated[Path | None, Parameter(show=False)] = None,
    /,
    *more: Annotated[str, Parameter(show=False)],
    kind: Annotated[str, Parameter(show=False)] = USUAL_KIND,
    study: _Switch = False,
    goal: _Switch = False,
    observations: _Switch = False,
    tests: _Switch = False,
    size: Annotated[str | None, Parameter(show=False)] = None,
) -> None:
    """Write a design file, sample tests for a name that ends with .csv, or the file of a switch of earlier versions."""
    kinds = ["design", *_COMMANDS, "tests"]
    if file is None:
        raise InputError(f"new: need {listed(kinds, 'or')}, and FILE, as in: forficula new design mine.toml")
    if more and str(file) in kinds:
        raise InputError(f"new: need options after {file}, as in: forficula new {file} {more[0]} --kind joint")
    if more:
        raise InputError(f"new: need {one_of(kinds, str(file))}")
    switches = {"study": study, "goal": goal, "observations": observations, "tests": tests}
    used = [name for name, on in switches.items() if on]
    if len(used) > 1:
        raise InputError(f"new: need one of {listed(kinds, 'or')}, got {listed([f'--{name}' for name in used])}")
    check_apart("--tests", tests, {"--kind": kind != USUAL_KIND, "--size": size is not None})
    check_apart("--size", size is not None, {f"--{name}": True for name in used})
    if tests or (not used and file.suffix.lower() == ".csv" and kind == USUAL_KIND and size is None):
        write_tests(file)
    elif used:
        _COMMANDS[used[0]](file, kind=kind)
    else:
        write_design(file, kind=kind, size=size)
    for name in used:
        option = f" --kind {kind}" if kind != USUAL_KIND else ""
        warn(f"--{name} will be removed; use: forficula new {name} {file}{option}")
