"""Which of the many ways out of its flat state a sheet took, and what decided it."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from forficula.design import stage_drives
from forficula.dynamics import Record
from forficula.pattern.crease_pattern import is_unfolded
from forficula.structure import Structure, drive_of
from forficula.structure.sheets.facets import BEND

# rad; less is flat: as built, and in the end
_FLAT_AS_BUILT, _FLAT = 1e-9, math.radians(1.0)
_ROUNDING = "rounding alone"


@dataclass(frozen=True, kw_only=True)
class Branch:
    """The way that a sheet took out of its flat state.

    Attributes:
        as_assigned: how many creases are folded the way that they are assigned in the end.
        against: how many the other way.
        flat: how many less than 1 deg.
        decided_by: what made it leave the flat state this way.
    """

    as_assigned: int
    against: int
    flat: int
    decided_by: tuple[str, ...]


def branch_taken(record: Record) -> Branch | None:
    """Which way a sheet took; None of one that is not built flat, or whose creases are joints.

    What is drawn flat counts as flat, however it is built beside that. Angles of creases count positive the way that
    they are assigned; one that is not assigned counts as a valley.
    """
    structure = record.structure
    creases = [number for number, hinge in enumerate(structure.hinges) if hinge.flaps and hinge.role != BEND]
    drawn = structure.appearance.pattern
    if not creases or drawn is None or not is_unfolded(drawn):
        return None
    ends = record.series["hinge_angle"][-1, creases]
    return Branch(
        as_assigned=int(np.sum(ends > _FLAT)),
        against=int(np.sum(ends < -_FLAT)),
        flat=int(np.sum(np.abs(ends) <= _FLAT)),
        decided_by=(*_by_build(structure, creases), *_by_drives(record)) or (_ROUNDING,),
    )


def branch_text(branch: Branch) -> str:
    """The way that was taken, as a sentence without an end."""
    every = branch.as_assigned + branch.against + branch.flat
    other = [f"{count} {how}" for count, how in ((branch.against, "the other way"), (branch.flat, "flat")) if count]
    told = ", ".join([f"{branch.as_assigned} of {every} creases folded as assigned", *other])
    by = " and ".join(branch.decided_by)
    hint = ": give imperfection.size and seed to choose" if branch.decided_by == (_ROUNDING,) else ""
    return f"out of the flat state {told}; decided by {by}{hint}"


def _by_build(structure: Structure, creases: list[int]) -> list[str]:
    rests = [structure.hinges[number] for number in creases]
    slight = _FLAT_AS_BUILT + 2 * max(abs(hinge.start) for hinge in rests)
    bent = any(hinge.stiffness and abs(hinge.rest_angle) > slight for hinge in rests)
    told = ["the rest angles of the creases"] if bent else []
    beside = structure.imperfection
    if beside is not None:
        told.append(f"an imperfection of {1e3 * beside.size:.3g} mm, seed {beside.seed}")
    return told


def _by_drives(record: Record) -> list[str]:
    used = dict.fromkeys(name for end in record.stages for name in stage_drives(end.stage))
    kinds = {"rest-angle": "rest angles", "torque": "torques", "force": "forces"}
    told = []
    for name in used:
        drive = drive_of(record.structure, name)
        motors = [motor for motor, share in zip(record.structure.motors, drive.shares, strict=True) if share]
        kind = kinds.get(motors[0].kind, "motion") if motors else "drive"
        told.append(f'the {kind} of drive "{name}"')
    return told
