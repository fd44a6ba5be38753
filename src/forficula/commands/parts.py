"""The command that turns a design into parts."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Literal

from cyclopts import Parameter

from forficula.options import (
    DesignName,
    DrawingUnit,
    OutIfGiven,
    Settings,
    check_folder,
    read_design,
    read_option,
    tell_replaced,
)
from forficula.serial import plain
from forficula.terminal import came_to

if TYPE_CHECKING:
    from forficula.make.checks.check import Check
    from forficula.make.part import PartSet
    from forficula.study.made_comparison import MadeComparison


def make(
    design: DesignName,
    /,
    *,
    part: Annotated[
        Literal["all", "sheet", "joint", "section"],
        Parameter(help="The sheet, the first joint, all joints with what they turn on, or all there is."),
    ] = "all",
    settings: Settings = None,
    unit: DrawingUnit = None,
    out: Annotated[
        OutIfGiven, Parameter(help="Folder for the files; out/<name of the design>-parts if not given.")
    ] = None,
    record: Annotated[
        Path | None, Parameter(help="Folder of a run of this design, to see who touches whom in it.")
    ] = None,
    step: Annotated[
        bool, Parameter(help='Write solids as STEP, too; needs pip install "forficula[step]".', negative=())
    ] = False,
    simulate: Annotated[
        bool, Parameter(help="Run the design and what the parts make of it; say what did it.", negative=())
    ] = False,
    strict: Annotated[
        bool, Parameter(help="End with status 2 where a check fails; --no-strict ends with 0 all the same.")
    ] = True,
) -> int:
    """Turn a design into parts to print, to buy and to cut, and check them: STL, 3MF, STEP, DXF, SVG, a bill."""
    from forficula.make.checks.check_parts import check_parts, run_of
    from forficula.make.files.step import check_step
    from forficula.make.make_parts import make_parts
    from forficula.show.folder.parts_folder import write_parts
    from forficula.show.progress import steps_progress
    from forficula.study.made_comparison import MadeComparison, comparison_or_why

    chosen = read_design(design, settings, unit)
    folder = out or Path("out") / f"{chosen.name}-parts"
    check_folder(folder, "bill of parts")
    if step:
        read_option("--step", check_step)
    with steps_progress() as progress:
        progress("building the parts")
        parts = make_parts(chosen, part=part)
        run = None if record is None else read_option("--record", lambda: run_of(parts, record))
        progress("checking the parts")
        checks = check_parts(parts, run)
        compared = comparison_or_why(parts, simulate, progress) if parts.joints else None
        tell_replaced(folder, "bill of parts")
        made = compared if isinstance(compared, MadeComparison) else None
        write_parts(parts, checks, folder, record=run, step=step, compared=made, progress=progress)
    _tell(parts, checks, compared)
    print(f"\nwritten to {folder}")
    return 2 if strict and any(check.ok is False for check in checks) else 0


def _tell(parts: PartSet, checks: tuple[Check, ...], compared: MadeComparison | str | None) -> None:
    """Print parts, their checks and what the design is as made, and hand all of it on as data."""
    from forficula.show.folder.parts_folder import parts_json
    from forficula.show.make.made_table import print_made
    from forficula.show.make.parts_table import print_parts

    # of parts that make no design there is a sentence instead
    came_to(parts_json(parts, checks) | {"as_made": None if isinstance(compared, str) else plain(compared)})
    print_parts(parts, checks)
    print_made(compared)
