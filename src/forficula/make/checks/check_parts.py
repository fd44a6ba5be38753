"""Check parts: whether they can be made, move through their range, and withstand their loads."""

from __future__ import annotations

import math
from collections.abc import Iterator

from forficula.dynamics import Record, as_record
from forficula.errors import InputError
from forficula.make.as_made import uncoupled
from forficula.make.checks.check import Check, count_check
from forficula.make.checks.motion_checks import built_checks, motion_checks
from forficula.make.checks.panel_checks import panel_checks
from forficula.make.checks.printing_checks import printing_checks
from forficula.make.checks.range_checks import range_checks
from forficula.make.checks.strength_checks import strength_checks
from forficula.make.files.print_orientation import OrientedPart, open_edges, print_mesh, printed_pieces
from forficula.make.hinge.joint_layout import JointLayout, bar_hinges
from forficula.make.part import PartSet
from forficula.make.solid.mesh import MILLIMETRES
from forficula.names import listed
from forficula.quantities import show_value
from forficula.structure import hinges_between

# fraction of the clearance that remains beside the corners of polygons that approximate circles
_ROUND = 0.998


def check_parts(parts: PartSet, record: object = None) -> tuple[Check, ...]:
    """Check parts: geometry at nominal size, and strength by formulas with values of data sheets.

    Printability, fatigue, creep and bonding are not checked.

    Args:
        parts: parts to check.
        record: record of a run of the design, or its folder, to check for collisions in this motion.

    Returns:
        Checks. A failed one says what to do; one that could not be done says why.

    Raises:
        InputError: not a record, or one of a design with other values.

    >>> checks = ff.make.check_parts(ff.make.parts("binder2025-joint"))
    >>> [check.name for check in checks if check.ok is False]
    []
    """
    try:
        run = None if record is None else run_of(parts, record)
    except InputError as error:
        raise InputError(f"record: {error}") from None
    sheet: tuple[Check, ...] = () if parts.sheet is None else parts.sheet.checks
    joint_checks = (*range_checks(parts), *strength_checks(parts), *printing_checks(parts), *built_checks(parts))
    return (
        *joint_checks,
        *mesh_checks(parts),
        *sheet,
        *tendon_checks(parts),
        *coupling_checks(parts),
        *panel_checks(parts),
        *_motion(parts, run),
    )


def run_of(parts: PartSet, record: object) -> Record:
    """Return a run of the design whose parts are made, from its record or its folder.

    Raises:
        InputError: not a record, or one of a design with other values. Keys of the section make are not compared.
    """
    run = as_record(record)
    if run.design.hash != parts.design.hash:
        raise InputError(
            f"need a run of {parts.design.name} with the same values, got one of {run.design.name} with others"
        )
    return run


def tendon_checks(parts: PartSet) -> Iterator[Check]:
    """Check that every tendon has straps, if all joints are made."""
    structure, straps = parts.structure, {place.tendon for place in parts.straps}
    if not structure.tendons or not parts.joints or len(parts.joints) < len(bar_hinges(structure)):
        return
    without = [_without_straps(parts, number) for number in range(len(structure.tendons)) if number not in straps]
    why = "only joints have pegs, for one tendon each"
    yield count_check(
        "straps of every tendon",
        parts.design.name,
        measured=len(straps),
        wanted=len(structure.tendons),
        held="every tendon has its straps",
        missed=f"no straps are made for {'; nor for '.join(without)}; {why}",
    )


def _without_straps(parts: PartSet, number: int) -> str:
    """Return a text with a tendon without straps, and the reason."""
    structure = parts.structure
    tendon = structure.tendons[number]
    crossed = hinges_between(structure, *(structure.points[point].body for point in tendon.points))
    occupied = [
        f"{joint.name} has pegs for {structure.tendons[joint.tendon].name}"
        for joint in parts.joints
        if joint.hinge in crossed and joint.tendon is not None
    ]
    return f"{tendon.name}, because " + (listed(occupied) if occupied else "it crosses no hinge between two bars")


def coupling_checks(parts: PartSet) -> Iterator[Check]:
    """Check that parts couple neighbouring bars as their design does."""
    if uncoupled(parts):
        yield Check(
            name="basal coupling",
            part=parts.design.name,
            ok=False,
            value=0.0,
            limit=float(len(parts.structure.couplings)),
            unit="",
            text="the design couples the turns of neighbouring veins, but no part does: turn every vein by its own"
            " drive (protocol.driven_veins), or couple them by other means; as-made.toml has no coupling",
        )


def _motion(parts: PartSet, run: Record | None) -> Iterator[Check]:
    """Check a run, or report that there is none; nothing for a sheet alone."""
    if not parts.joints:
        return
    if run is not None:
        yield from motion_checks(parts, run)
        return
    yield Check(
        name="overlap in the recorded motion",
        part=parts.design.name,
        ok=None,
        value=math.nan,
        limit=math.nan,
        unit="m^3",
        text="not checked without a run of the design: give its folder, --record",
    )


def mesh_checks(parts: PartSet) -> Iterator[Check]:
    """Check the printed pieces of a set."""
    for piece in printed_pieces(parts):
        yield _closed(piece)
    for joint in parts.joints:
        if joint.make.hinge == "print-in-place":
            yield _apart(parts, joint)


def _closed(piece: OrientedPart) -> Check:
    """Check that the surface of a piece is closed, so that slicers know what is inside."""
    gaps = open_edges(print_mesh(*piece.parts))
    missed = f"it is open at {gaps} edges, which slicers repair in different ways; please report this"
    return count_check("closed surface", piece.name, measured=gaps, wanted=0, held="it is closed", missed=missed)


def _apart(parts: PartSet, joint: JointLayout) -> Check:
    """Check that the halves of a joint that is printed in place do not touch in the flat position."""
    proximal, distal = (parts.of_body(arm.body)[0].shape for arm in (joint.proximal, joint.distal))
    clearance = joint.make.clearance
    gap = float(proximal.min_gap(distal, 2 * clearance * MILLIMETRES)) / MILLIMETRES
    text = f"flat, as printed, its two halves are {show_value(gap, 'm')} apart"
    advice = "so they fuse: choose a larger overbend, or a pin (make.hinge)"
    return Check(
        name="apart as printed",
        part=joint.name,
        ok=gap >= clearance * _ROUND,
        value=gap,
        limit=clearance,
        unit="m",
        text=text if gap >= clearance * _ROUND else f"{text}, less than make.clearance, {advice}",
    )
