"""The command that makes parts of a design."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, Literal

from cyclopts import Parameter

from forficula.errors import InputError
from forficula.options import (
    DesignName,
    DrawingUnit,
    OpenReport,
    OutIfGiven,
    Settings,
    check_folder,
    end_with_page,
    note_replaced,
    read_design,
    read_option,
)
from forficula.serial import plain
from forficula.terminal import set_result

if TYPE_CHECKING:
    from forficula.design import Design
    from forficula.make.checks.check import Check
    from forficula.make.part import PartSet
    from forficula.study.made_comparison import MadeComparison


def make(
    design: DesignName,
    /,
    *,
    part: Annotated[
        Literal["all", "sheet", "joint", "section"],
        Parameter(help="Parts to make: sheet; joint (the first joint); section (all joints with their bars); or all."),
    ] = "all",
    settings: Settings = None,
    unit: DrawingUnit = None,
    out: Annotated[OutIfGiven, Parameter(help="Output folder; default: out/<name of the design>-parts.")] = None,
    record: Annotated[
        Path | None,
        Parameter(help="Folder of a run of this design; the parts are checked for collisions in its motion."),
    ] = None,
    step: Annotated[
        bool, Parameter(help='Also write solids as STEP; needs pip install "forficula[step]".', negative=())
    ] = False,
    simulate: Annotated[
        bool,
        Parameter(
            help="Run the design, then with the values of the made parts, and report which values alter the result.",
            negative=(),
        ),
    ] = False,
    strict: Annotated[
        bool, Parameter(help="End with status 2 where a check fails; with --no-strict it ends with 0.")
    ] = True,
    open_report: OpenReport = False,
) -> int:
    """Make parts of a design to print, cut and buy, and check them: STL, 3MF, STEP, DXF, SVG and a bill.

    Of an assembly, every part gets a folder of its own.
    """
    from forficula.design import AssemblyDesign
    from forficula.make.files.step import check_step

    chosen = read_design(design, settings, unit)
    folder = out or Path("out") / f"{chosen.name}-parts"
    if step:
        read_option("--step", check_step)
    if not isinstance(chosen, AssemblyDesign):
        status, result = _make(chosen, folder, part=part, record=record, step=step, simulate=simulate, strict=strict)
        set_result(result)
        end_with_page(folder, show=open_report)
        return status
    if record is not None:
        raise InputError("--record: is for a design that is not an assembly; the parts are checked one by one")
    results, worst = dict[str, Any](), 0
    for name, of_part in chosen.designs.items():
        print(f"\nPart {name}")
        status, results[name] = _make(
            of_part, folder / name, part=part, record=None, step=step, simulate=simulate, strict=strict
        )
        worst = max(worst, status)
        end_with_page(folder / name, show=open_report)
    set_result(results)
    return worst


def _make(
    design: Design,
    folder: Path,
    *,
    part: Literal["all", "sheet", "joint", "section"],
    record: Path | None,
    step: bool,
    simulate: bool,
    strict: bool,
) -> tuple[int, dict[str, Any]]:
    """Make the parts of a design that is not an assembly; return the status of the command and its result."""
    from forficula.make.checks.check_parts import check_parts, run_of
    from forficula.make.make_parts import make_parts
    from forficula.show.folder.parts_folder import write_parts
    from forficula.show.progress import steps_progress
    from forficula.study.made_comparison import MadeComparison, comparison_or_why

    check_folder(folder, "bill of parts")
    with steps_progress() as progress:
        progress("building the parts")
        parts = make_parts(design, part=part)
        run = None if record is None else read_option("--record", lambda: run_of(parts, record))
        progress("checking the parts")
        checks = check_parts(parts, run)
        compared = comparison_or_why(parts, simulate, progress) if parts.joints else None
        note_replaced(folder, "bill of parts")
        made = compared if isinstance(compared, MadeComparison) else None
        write_parts(parts, checks, folder, record=run, step=step, compared=made, progress=progress)
    result = _print(parts, checks, compared)
    return (2 if strict and any(check.ok is False for check in checks) else 0), result


def _print(parts: PartSet, checks: tuple[Check, ...], compared: MadeComparison | str | None) -> dict[str, Any]:
    """Print parts, their checks and the design as made, and return them as the result of the command."""
    from forficula.show.folder.parts_folder import parts_json
    from forficula.show.make.made_table import print_made
    from forficula.show.make.parts_table import print_parts

    print_parts(parts, checks)
    print_made(compared)
    return parts_json(parts, checks) | {"as_made": None if isinstance(compared, str) else plain(compared)}
