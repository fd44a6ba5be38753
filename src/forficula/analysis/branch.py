"""Which of the possible branches a sheet followed out of its flat state, and what decided between them."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from forficula.design import stage_drives
from forficula.dynamics import Record
from forficula.pattern.crease_pattern import is_unfolded
from forficula.structure import Structure, drive_of
from forficula.structure.sheets.facets import BEND

# rad; largest angle that counts as flat: as built, and at the end
_FLAT_AS_BUILT, _FLAT = 1e-9, math.radians(1.0)
_ROUNDING = "rounding alone"


@dataclass(frozen=True, kw_only=True)
class Branch:
    """The branch that a sheet followed out of its flat state.

    Attributes:
        as_assigned: number of creases that end folded in the direction of their assignment.
        against: number of creases that end folded against their assignment.
        flat: number of creases that end folded by less than 1 deg.
        decided_by: what selected this branch.
    """

    as_assigned: int
    against: int
    flat: int
    decided_by: tuple[str, ...]


def branch_taken(record: Record) -> Branch | None:
    """Return the branch that a sheet followed; None if it is not drawn flat, or if its creases are joints.

    A sheet that is drawn flat counts as flat, even if it is built slightly out of the plane. Angles of creases are
    positive in the direction of their assignment; an unassigned crease counts as a valley.
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
    """Return the branch that was followed, as a clause."""
    every = branch.as_assigned + branch.against + branch.flat
    other = [f"{count} {how}" for count, how in ((branch.against, "opposite"), (branch.flat, "flat")) if count]
    counts = ", ".join([f"{branch.as_assigned} of {every} creases folded as assigned", *other])
    by = " and ".join(branch.decided_by)
    hint = ": set imperfection.size and imperfection.seed to choose" if branch.decided_by == (_ROUNDING,) else ""
    return f"from the flat state, {counts}; decided by {by}{hint}"


def _by_build(structure: Structure, creases: list[int]) -> list[str]:
    rests = [structure.hinges[number] for number in creases]
    slight = _FLAT_AS_BUILT + 2 * max(abs(hinge.start) for hinge in rests)
    bent = any(hinge.stiffness and abs(hinge.rest_angle) > slight for hinge in rests)
    causes = ["the rest angles of the creases"] if bent else []
    imperfection = structure.imperfection
    if imperfection is not None:
        causes.append(f"an imperfection of {1e3 * imperfection.size:.3g} mm, seed {imperfection.seed}")
    return causes


def _by_drives(record: Record) -> list[str]:
    used = dict.fromkeys(name for end in record.stages for name in stage_drives(end.stage))
    kinds = {"rest-angle": "rest angles", "torque": "torques", "force": "forces"}
    causes = []
    for name in used:
        drive = drive_of(record.structure, name)
        motors = [motor for motor, share in zip(record.structure.motors, drive.shares, strict=True) if share]
        kind = kinds.get(motors[0].kind, "motion") if motors else "drive"
        causes.append(f'the {kind} of drive "{name}"')
    return causes
