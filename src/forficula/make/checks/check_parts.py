"""Parts -> checks: whether they can be made, move through their range, and bear what pulls."""

from __future__ import annotations

import math
from collections.abc import Iterator

from forficula.dynamics import Record, as_record
from forficula.errors import InputError
from forficula.make.as_made import uncoupled
from forficula.make.checks.check import Check, count_check
from forficula.make.checks.motion_checks import built_checks, motion_checks
from forficula.make.checks.printing_checks import printing_checks
from forficula.make.checks.range_checks import range_checks
from forficula.make.checks.strength_checks import strength_checks
from forficula.make.files.lying import OrientedPart, lying_mesh, open_edges, printed_pieces
from forficula.make.hinge.joint_layout import JointLayout, bar_hinges
from forficula.make.part import PartSet
from forficula.make.solid.mesh import MILLIMETRES
from forficula.names import listed
from forficula.quantities import show_value
from forficula.structure import hinges_between

# of the clearance: what corners of circles stand out takes of it
_ROUND = 0.998


def check_parts(parts: PartSet, record: object = None) -> tuple[Check, ...]:
    """Check parts: geometry at nominal size, and formulas with the strengths of data sheets.

    What is not checked: that they print, fatigue, creep, bonding.

    Args:
        parts: to check.
        record: of a run of the design, or its folder, to see who touches whom in it.

    Returns:
        One that fails says what to do about it; one that could not be made says why.

    Raises:
        InputError: the record is none, or of a design with other values.

    >>> checks = ff.make.check_parts(ff.make.parts("binder2025-joint"))
    >>> [check.name for check in checks if check.ok is False]
    []
    """
    try:
        run = None if record is None else run_of(parts, record)
    except InputError as error:
        raise InputError(f"record: {error}") from None
    sheet: tuple[Check, ...] = () if parts.sheet is None else parts.sheet.checks
    own = (*range_checks(parts), *strength_checks(parts), *printing_checks(parts), *built_checks(parts))
    return (*own, *mesh_checks(parts), *sheet, *tendon_checks(parts), *coupling_checks(parts), *_motion(parts, run))


def run_of(parts: PartSet, record: object) -> Record:
    """A run of the design whose parts are made, from its record or its folder.

    Raises:
        InputError: it is none, or one of a design with other values; how parts are made is not of a run.
    """
    run = as_record(record)
    if run.design.hash != parts.design.hash:
        raise InputError(
            f"need a run of {parts.design.name} with the same values, got one of {run.design.name} with others"
        )
    return run


def tendon_checks(parts: PartSet) -> Iterator[Check]:
    """Whether every tendon has its straps, where all joints are made."""
    structure, straps = parts.structure, {place.tendon for place in parts.straps}
    if not structure.tendons or not parts.joints or len(parts.joints) < len(bar_hinges(structure)):
        return
    without = [_without_straps(parts, number) for number in range(len(structure.tendons)) if number not in straps]
    why = "a joint has pegs for one tendon, and nothing else carries any"
    yield count_check(
        "straps of every tendon",
        parts.design.name,
        found=len(straps),
        wanted=len(structure.tendons),
        held="every tendon has its straps",
        missed=f"no straps are made of {'; nor of '.join(without)}; {why}",
    )


def _without_straps(parts: PartSet, number: int) -> str:
    """A tendon without straps, and why it has none."""
    structure = parts.structure
    tendon = structure.tendons[number]
    crossed = hinges_between(structure, *(structure.points[point].body for point in tendon.points))
    taken = [
        f"{joint.name} has those of {structure.tendons[joint.tendon].name}"
        for joint in parts.joints
        if joint.hinge in crossed and joint.tendon is not None
    ]
    return f"{tendon.name}, for " + (listed(taken) if taken else "it crosses no hinge between two bars")


def coupling_checks(parts: PartSet) -> Iterator[Check]:
    """Whether parts tie neighbouring bars as their design does."""
    if uncoupled(parts):
        yield Check(
            name="basal coupling",
            part=parts.design.name,
            ok=False,
            value=0.0,
            limit=float(len(parts.structure.couplings)),
            unit="",
            text="the design ties the turns of neighbouring veins, and no part does: turn every vein by a drive of its"
            " own (protocol.driven_veins), or tie them by what you have; as-made.toml is without it",
        )


def _motion(parts: PartSet, run: Record | None) -> Iterator[Check]:
    """What is checked of a run, or that there is none; of a sheet alone, nothing."""
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
        text="not looked at without a run of the design: give its folder, --record",
    )


def mesh_checks(parts: PartSet) -> Iterator[Check]:
    """Check the printed pieces of a set."""
    for piece in printed_pieces(parts):
        yield _closed(piece)
    for joint in parts.joints:
        if joint.make.hinge == "print-in-place":
            yield _apart(parts, joint)


def _closed(piece: OrientedPart) -> Check:
    """Whether the surface of a piece is closed, so that slicers know what is inside."""
    gaps = open_edges(lying_mesh(*piece.parts))
    missed = f"it is open at {gaps} edges, which slicers mend as they like; report it"
    return count_check("closed surface", piece.name, found=gaps, wanted=0, held="it is closed", missed=missed)


def _apart(parts: PartSet, joint: JointLayout) -> Check:
    """Whether the halves of a joint that is printed in one stay two, flat as they are printed."""
    proximal, distal = (parts.of_body(arm.body)[0].shape for arm in (joint.proximal, joint.distal))
    clearance = joint.make.clearance
    gap = float(proximal.min_gap(distal, 2 * clearance * MILLIMETRES)) / MILLIMETRES
    told = f"flat, as it is printed, its two halves are {show_value(gap, 'm')} apart"
    mend = "there they fuse: take a larger overbend, or a pin (make.hinge)"
    return Check(
        name="apart as printed",
        part=joint.name,
        ok=gap >= clearance * _ROUND,
        value=gap,
        limit=clearance,
        unit="m",
        text=told if gap >= clearance * _ROUND else f"{told}, less than make.clearance, and {mend}",
    )
