"""What is checked of parts as files have them: closed, and apart where hinges are printed in place."""

from __future__ import annotations

from collections.abc import Iterator

from forficula.make.check import Check, count_check
from forficula.make.files.lying import Piece, lying_mesh, open_edges, printed_pieces
from forficula.make.joint_layout import JointLayout
from forficula.make.mesh import MILLIMETRES
from forficula.make.part import PartSet
from forficula.quantities import show_value

# of the clearance: what corners of circles stand out takes of it
_ROUND = 0.998


def mesh_checks(parts: PartSet) -> Iterator[Check]:
    """Check the printed pieces of a set."""
    for piece in printed_pieces(parts):
        yield _closed(piece)
    for joint in parts.joints:
        if joint.make.hinge == "print-in-place":
            yield _apart(parts, joint)


def _closed(piece: Piece) -> Check:
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
