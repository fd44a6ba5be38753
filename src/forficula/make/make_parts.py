"""Build the parts of a design."""

from __future__ import annotations

from typing import Literal, get_args

import numpy as np

from forficula.arrays import Array
from forficula.design import AnyDesign, Design, MakeSection, as_design
from forficula.errors import InputError
from forficula.make.flat.sheet import cut_sheet
from forficula.make.hinge.hub import Root, hub_solid, rod_solid, roots_of, with_sleeve
from forficula.make.hinge.joint import bar_solid, pin_solid
from forficula.make.hinge.joint_layout import Arm, JointLayout, joint_layouts
from forficula.make.hinge.strap_shape import StrapPlace, bows_beside, made_strap, strap_places
from forficula.make.part import Part, PartSet
from forficula.make.solid.panels import panel_fold, panel_parts
from forficula.make.stock import stock_of
from forficula.material.law.law_file import named_laws
from forficula.names import one_of
from forficula.pattern.rotation import frame_along
from forficula.structure import GROUND, Structure, structure_of

PartName = Literal["all", "sheet", "joint", "section"]


def make_parts(design: AnyDesign, part: PartName = "all") -> PartSet:
    """Make the parts of a design: its cut sheet, and bars, pins, straps, hub and roots as solids.

    Args:
        design: design, or its name or path.
        part: "sheet"; "joint" (the first joint and the others that its tendon crosses); "section" (all joints with the
            hub on which they turn); or "all" (the sheet and, for a structure with bars, the section; for thick panels
            these instead of the sheet).

    Raises:
        InputError: unknown part, or one that the design does not have.

    >>> parts = ff.make.parts("binder2025-joint")
    >>> [part.name for part in parts.parts]
    ['proximal0', 'distal0', 'pin_fold0', 'strap0']
    """
    if part not in get_args(PartName):
        raise InputError(f"part: need {one_of(get_args(PartName), part)}")
    design = as_design(design)
    structure = structure_of(design)
    joints: tuple[JointLayout, ...] = ()
    if part in ("joint", "section") or (part == "all" and structure.bars):
        joints = joint_layouts(design, structure)
        joints = bows_beside(_first(joints) if part == "joint" else joints)
    fold = panel_fold(design, structure) if part == "all" else None
    panels = panel_parts(design, structure) if part == "all" else []
    return PartSet(
        design=design,
        structure=structure,
        joints=joints,
        roots=(roots := () if part == "joint" else roots_of(structure, joints)),
        straps=(straps := strap_places(joints)),
        parts=(
            *_bars(structure, joints, roots),
            *_pins(joints),
            *_straps(design, structure, straps),
            *_hub(roots),
            *panels,
        ),
        # thick panels are not cut from one sheet
        sheet=cut_sheet(design) if part == "sheet" or (part == "all" and not panels) else None,
        fold=fold,
    )


def _first(joints: tuple[JointLayout, ...]) -> tuple[JointLayout, ...]:
    """Return the first joint and all others that its tendon crosses, because straps end beyond the last one."""
    tendon = joints[0].tendon
    return joints[:1] if tendon is None else tuple(joint for joint in joints if joint.tendon == tendon)


def _bars(structure: Structure, joints: tuple[JointLayout, ...], roots: tuple[Root, ...]) -> list[Part]:
    """Return every bar of a joint, with its half of each of its joints, and the sleeve of its root."""
    arms: dict[int, list[tuple[JointLayout, Arm]]] = {}
    # a bar comes before the bars that it carries, so the chain of its arms goes outwards
    for joint in joints:
        arms.setdefault(joint.proximal.body, []).append((joint, joint.proximal))
        arms.setdefault(joint.distal.body, []).append((joint, joint.distal))
    rooted = {root.body: root for root in roots}
    parts = []
    for body, halves in sorted(arms.items()):
        joint, _ = halves[0]
        solid = bar_solid(halves)
        parts.append(
            Part(
                name=structure.bodies[body].name,
                kind="bar",
                stock=stock_of(joint.make.bar_material),
                solid=with_sleeve(solid, rooted[body], joint) if body in rooted else solid,
                body=body,
                bed=_face_down(joint),
            )
        )
    return parts


def _pins(joints: tuple[JointLayout, ...]) -> list[Part]:
    """Return the pins that are not printed together with their knuckles."""
    return [
        Part(
            name=f"pin_{joint.name}",
            kind="pin",
            stock=stock_of(joint.make.pin_material),
            solid=pin_solid(joint),
            body=joint.proximal.body,
            printed=False,
            bed=np.eye(3),
        )
        for joint in joints
        if joint.make.hinge == "pin"
    ]


def _straps(design: Design, structure: Structure, places: tuple[StrapPlace, ...]) -> list[Part]:
    """Return the straps of all tendons as they are made, at their resting lengths."""
    parts = []
    for place in places:
        tendon = structure.tendons[place.tendon]
        along = place.ends[0, 1] - place.ends[0, 0]
        along, up = along / np.linalg.norm(along), place.up
        material = tendon.material if (design.make or MakeSection()).strap_material is None else None
        parts.append(
            Part(
                name=tendon.name.replace("tendon", "strap"),
                kind="strap",
                stock=stock_of(
                    material if material is not None and material.name not in named_laws() else place.strap.material
                ),
                solid=made_strap(place),
                body=None,
                count=place.strap.count,
                # printed on its edge: its width is the printed height
                bed=np.vstack([along, up - along * (up @ along), np.cross(along, up)]),
            )
        )
    return parts


def _hub(roots: tuple[Root, ...]) -> list[Part]:
    """Return the hub and its rods; empty if no bar turns on a root."""
    if not roots:
        return []
    make = roots[0].make
    hub = Part(
        name="hub", kind="hub", stock=stock_of(make.bar_material), solid=hub_solid(roots), body=GROUND, bed=np.eye(3)
    )
    rods = [
        Part(
            name=f"root{number}",
            kind="root",
            stock=stock_of(make.root_material),
            solid=rod_solid(root),
            body=None,
            bed=frame_along(root.along).T,
        )
        for number, root in enumerate(roots)
    ]
    return [hub, *rods]


def _face_down(joint: JointLayout) -> Array:
    """Return the rotation that lays a bar on the flat of its overbend side, (3, 3)."""
    turned: Array = np.diag([1.0, -1.0, -1.0]) @ joint.frame.T
    return turned
