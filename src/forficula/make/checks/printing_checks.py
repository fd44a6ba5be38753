"""Checks of printed parts: walls, overhangs, pieces, and the cross-section of straps."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from forficula.design import MakeSection
from forficula.make.checks.check import Check, count_check, least_check
from forficula.make.part import Part, PartSet
from forficula.make.solid.mesh import mesh_of, solid_of
from forficula.make.solid.solids import Cut, Joined, Rod, Shared, Solid
from forficula.pattern.geometry import triangle_normals

# minimum number of nozzle lines in a wall
_LINES = 2
# cos of the steepest overhang that filament needs no support for, 45 deg from the vertical
_SLOPE = np.sqrt(0.5)
# [chosen] allowed overhanging area / area on the bed
_LARGEST_OVERHANG = 0.05
# m, largest diameter of a round hole that filament bridges
_BRIDGED = 5e-3
# mm: surfaces this near to the bed count as on it
_ON_BED = 1e-3


def printing_checks(parts: PartSet) -> Iterator[Check]:
    """Check the printed parts of a set."""
    for joint in parts.joints:
        make = joint.make
        least = _LINES * make.nozzle
        walls = {"make.hinge_wall": make.hinge_wall, "knuckles (make.hinge_width)": 2 * joint.side_widths[0]}
        if joint.strap is not None:
            walls |= {"make.strap_thickness": joint.strap.thickness, "strap width": joint.strap.width}
            walls |= {"make.peg_diameter": make.peg_diameter}
        thin, wall = min(walls.items(), key=lambda item: item[1])
        text = f"{thin} is the thinnest wall; it needs two lines of make.nozzle"
        yield least_check("thinnest wall", joint.name, measured=wall, least=least, text=text)
        if joint.strap is not None:
            strap = joint.strap
            yield Check(
                name="strap bends on its flat side",
                part=joint.name,
                ok=strap.width > strap.thickness,
                value=strap.width,
                limit=strap.thickness,
                unit="m",
                text="a strap must be wider than thick; otherwise it buckles sideways into the joint"
                + ("" if strap.width > strap.thickness else ": choose a thinner one (make.strap_thickness)"),
            )
    for part in parts.parts:
        pieces = len(part.shape.decompose())
        missed = f"it falls into {pieces} pieces: make it longer or wider"
        yield count_check("in one piece", part.name, measured=pieces, wanted=1, held="it is one piece", missed=missed)
    if parts.parts and (parts.design.make or MakeSection()).process == "filament":
        yield from (_overhang(part) for part in parts.parts if part.printed)


def _overhang(part: Part) -> Check:
    """Check the area of a part with steep overhangs / the area that lies on the bed.

    Round holes of 5 mm and less are bridged.
    """
    mesh = mesh_of(solid_of(_without_small_holes(part.solid)))
    corners = (mesh.points @ part.bed.T)[mesh.triangles]
    normals = triangle_normals(corners) / 2
    areas = np.linalg.norm(normals, axis=1)
    down = -normals[:, 2] / np.where(areas > 0, areas, 1.0)
    on_bed = corners[:, :, 2].max(axis=1) < corners[:, :, 2].min() + _ON_BED
    bed_area = float(np.sum(areas[on_bed]))
    overhang_area = float(np.sum(areas[~on_bed & (down > _SLOPE)]))
    share = overhang_area / bed_area if bed_area else np.inf
    return Check(
        name="overhang",
        part=part.name,
        ok=bool(share <= _LARGEST_OVERHANG),
        value=float(share),
        limit=_LARGEST_OVERHANG,
        unit="",
        text=f"{bed_area:.0f} mm^2 are on the bed, and {overhang_area:.0f} mm^2 overhang by more than 45 deg"
        + ("" if share <= _LARGEST_OVERHANG else ': print it with supports, or by make.process = "powder"'),
    )


def _without_small_holes(solid: Solid) -> Solid:
    """Return a solid with its small round holes filled."""
    match solid:
        case Cut():
            kept = tuple(child for child in solid.taken if not (isinstance(child, Rod) and child.diameter <= _BRIDGED))
            return Cut(solid=_without_small_holes(solid.solid), taken=kept)
        case Joined():
            return Joined(solids=tuple(_without_small_holes(child) for child in solid.solids))
        case Shared():
            return Shared(solids=tuple(_without_small_holes(child) for child in solid.solids))
        case _:
            return solid
