"""Commands that write a file to start from: `forficula new design`, `study`, `goal`, `observations` and `tests`."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Annotated

from cyclopts import App, Parameter

from forficula.errors import InputError
from forficula.names import listed, one_of
from forficula.options import check_apart

USUAL_KIND = "earwig-fan"
_File = Annotated[Path, Parameter(help="Where to write it; must end with .toml and not exist.")]
Kind = Annotated[
    str,
    Parameter(
        help="Kind of crease pattern, such as earwig-fan, joint, miura-ori or fold-file; an unknown name lists all."
    ),
]
_Switch = Annotated[bool, Parameter(show=False, negative=())]

new = App(name="new", help="Write a commented file to start from: a design, study, goal or observations, or tests.")


@new.command(name="design")
def write_design(file: _File, /, *, kind: Kind = USUAL_KIND) -> None:
    """Write a design file with a comment on every key."""
    from forficula.design import write_new_design

    write_new_design(file, kind)
    print(f"written to {file}; run it with: forficula run {file}")


@new.command(name="study")
def write_study(file: _File, /, *, kind: Kind = USUAL_KIND) -> None:
    """Write a study file: many runs of a design."""
    from forficula.study.files.study_file import STUDY
    from forficula.study.new_file import write_new_file

    write_new_file(file, STUDY, kind)
    print(f"written to {file}; run it with: forficula study {file}")


@new.command(name="goal")
def write_goal(file: _File, /, *, kind: Kind = USUAL_KIND) -> None:
    """Write a goal file: what a structure must do, what may vary, and its tolerances."""
    from forficula.goals.goal_file import GOAL
    from forficula.study.new_file import write_new_file

    write_new_file(file, GOAL, kind)
    print(f"written to {file}; find the design with: forficula optimise {file}")


@new.command(name="observations")
def write_observations(file: _File, /, *, kind: Kind = USUAL_KIND) -> None:
    """Write an observations file: unknown values of a design, and what was observed."""
    from forficula.goals.identify.observations_file import OBSERVATIONS
    from forficula.study.new_file import write_new_file

    write_new_file(file, OBSERVATIONS, kind)
    print(f"written to {file}; find what is unknown with: forficula identify {file}")


@new.command(name="tests")
def write_tests(
    file: Annotated[Path, Parameter(help="Where to write them; must end with .csv and not exist.")],
    /,
) -> None:
    """Write three tensile tests to try `forficula material` with; the values are made up."""
    from forficula.material.sample_tests import write_sample_tests

    files = " ".join(str(written) for written in write_sample_tests(file))
    print(f'written, not measured; read with: forficula material {files} --length "60 mm" --area "5 mm^2"')


_COMMANDS = {"design": write_design, "study": write_study, "goal": write_goal, "observations": write_observations}


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
) -> None:
    """Write a design file; with one of the switches of earlier versions, another file."""
    kinds = [*_COMMANDS, "tests"]
    if file is None:
        raise InputError(f"new: need {listed(kinds, 'or')}, and FILE, as in: forficula new design mine.toml")
    if more and str(file) in kinds:
        raise InputError(f"new: need options after {file}, as in: forficula new {file} {more[0]} --kind joint")
    if more:
        raise InputError(f"new: need {one_of(kinds, str(file))}")
    switches = {"study": study, "goal": goal, "observations": observations, "tests": tests}
    given = [name for name, wanted in switches.items() if wanted]
    if len(given) > 1:
        raise InputError(f"new: need one of {listed(kinds, 'or')}, got {listed([f'--{name}' for name in given])}")
    check_apart("--tests", tests, {"--kind": kind != USUAL_KIND})
    if tests:
        write_tests(file)
    else:
        _COMMANDS[given[0] if given else "design"](file, kind=kind)
    for name in given:
        option = f" --kind {kind}" if kind != USUAL_KIND else ""
        print(f"warning: --{name} will be removed; use: forficula new {name} {file}{option}", file=sys.stderr)
