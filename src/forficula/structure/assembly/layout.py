"""Layout of an assembly: bodies, points and hinges of its parts, and the bodies of hinges between them."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from typing import TypeVar

import numpy as np

from forficula.arrays import Array
from forficula.design.assembly.assembly import AssemblyDesign
from forficula.design.assembly.joints import GROUND_BODY, HingeJoint, PlacingJoint
from forficula.errors import InputError
from forficula.names import one_of
from forficula.pattern.rotation import RigidMotion
from forficula.structure.assembly.joined_part import JoinedPart
from forficula.structure.assembly.placement import part_motion
from forficula.structure.parts import GROUND, Body, Hinge, Point, PointMass
from forficula.structure.sheets.facets import BEND
from forficula.structure.structure import Structure
from forficula.structure.tree import built_points, frames_of

_Named = TypeVar("_Named", Body, Point, Hinge)


class Layout:
    """Bodies, points and hinges of an assembly while they are laid out."""

    def __init__(self, design: AssemblyDesign) -> None:
        self.design = design
        self.parts: dict[str, JoinedPart] = {}
        self.bodies: list[Body] = []
        self.points: list[Point] = []
        self.masses: list[PointMass] = []
        self.joints: list[Hinge] = []
        self.creases: list[Hinge] = []

    @property
    def hinges(self) -> tuple[Hinge, ...]:
        """Return the hinges of the assembly: joints come before creases."""
        return (*self.joints, *self.creases)

    def numbered_parts(self) -> list[JoinedPart]:
        """Return the parts in the order of the design, with the numbers of their hinges, after all are laid out."""
        numbers = {hinge.name: number for number, hinge in enumerate(self.hinges)}
        parts = [self.parts[name] for name in self.design.parts]
        return [
            replace(part, hinges=tuple(numbers[part.full_name(hinge.name)] for hinge in part.structure.hinges))
            for part in parts
        ]


def add_part(layout: Layout, name: str, structure: Structure) -> None:
    """Add bodies, points and hinges of a part, after those of the part that carries it."""
    joint = layout.design.placing.get(name)
    part = _placed(layout, name, structure, joint)
    layout.parts[name] = part
    turns = part.motion.rotation
    for body in structure.bodies:
        if body.parent != GROUND:
            moved = replace(body, parent=part.body(body.parent))
        elif body.slides:
            _check_free(layout, part, body)
            moved = replace(body, position=part.motion.of(body.position), frame=_turned(body, turns))
        else:
            moved = replace(
                body,
                parent=part.base,
                position=part.place(GROUND, body.position),
                frame=_carried_frame(part, body),
            )
        layout.bodies.append(replace(moved, name=part.full_name(body.name)))
    layout.points += [
        replace(
            point,
            name=part.full_name(point.name),
            body=part.body(point.body),
            place=part.place(point.body, point.place),
        )
        for point in structure.points
    ]
    single = len(layout.design.parts) == 1
    for hinge in structure.hinges:
        named = replace(
            hinge,
            name=part.full_name(hinge.name),
            role=hinge.role if hinge.role == BEND else part.full_name(hinge.role),
            label=part.full_name(hinge.label or hinge.name),
            edge=hinge.edge if single else -1,
        )
        if hinge.flaps is None:
            layout.joints.append(replace(named, body=part.body(hinge.body)))
        else:
            one, two, three, four, five, six = part.point_numbers(hinge.flaps)
            layout.creases.append(replace(named, flaps=(one, two, three, four, five, six)))


def _carried_frame(part: JoinedPart, body: Body) -> Array:
    """Return the frame of a body that the part fixes to the ground, in the axes of the part's base."""
    turn = part.carried.rotation
    return body.frame if np.array_equal(turn, np.eye(3)) else np.asarray(turn @ body.frame)


def _turned(body: Body, turn: Array) -> Array:
    """Return the frame of a free body; a node that only slides keeps its axes."""
    return body.frame if not body.turns or np.array_equal(turn, np.eye(3)) else np.asarray(turn @ body.frame)


def _check_free(layout: Layout, part: JoinedPart, body: Body) -> None:
    """Refuse free bodies whose freedom depends on the axes of the ground, where these turn or move."""
    if len(body.slides) < 3 and (part.base != GROUND or not np.array_equal(np.abs(part.motion.rotation), np.eye(3))):
        raise InputError(
            f"part.{part.name}.support: a vertex may be held along single axes only in a part that is not turned and"
            f" whose base does not move, got {body.name}"
        )
    number = part.base
    while number != GROUND:
        for hinge in layout.joints:
            if hinge.body == number and hinge.start != hinge.built:
                raise InputError(
                    f"part.{part.name}: parts with free bodies need bases that start as built, and {hinge.name} starts"
                    f" at {math.degrees(hinge.start - hinge.built):.4g} deg from there"
                )
        number = layout.bodies[number].parent


def _placed(layout: Layout, name: str, structure: Structure, joint: PlacingJoint | None) -> JoinedPart:
    """Return a part where its joint places it, after adding the body of a hinge."""
    base = GROUND if joint is None else _body_number(layout, joint)
    points = np.zeros((0, 3)) if joint is None else _joint_points(structure, name, joint)
    motion = part_motion(joint, points, np.zeros((0, 3)) if joint is None else _onto(layout, joint, points))
    origin, frame = _frame_of(layout, base)
    carried = motion if base == GROUND else _within(motion, origin, frame)
    if isinstance(joint, HingeJoint):
        start = motion.of(points[0])
        axis = motion.rotation @ (points[1] - points[0])
        axis = frame.T @ axis / np.linalg.norm(axis)
        number = len(layout.bodies)
        layout.bodies.append(
            Body(
                name=f"{joint.name} base",
                role="base",
                parent=base,
                position=frame.T @ (start - origin),
                frame=np.eye(3),
            )
        )
        layout.joints.append(_hinge(joint, number, axis))
        base, carried = number, _within(motion, start, frame)
        layout.masses += _base_masses(joint, structure, number, carried)
    return JoinedPart(
        name=name,
        structure=structure,
        first_body=len(layout.bodies),
        first_point=len(layout.points),
        base=base,
        motion=motion,
        carried=carried,
    )


def _base_masses(joint: HingeJoint, structure: Structure, body: int, carried: RigidMotion) -> list[PointMass]:
    """Return the mass of a hinge's body, divided equally between the positions that the part fixes to the ground.

    Args:
        joint: hinge that carries the part.
        structure: structure of the part.
        body: number of the hinge's body in the assembly.
        carried: motion from the axes of the part to those of this body.

    Raises:
        InputError: the part fixes nothing to the ground, so that the hinge would carry nothing.
    """
    fixed = [
        *(entry.position for entry in structure.bodies if entry.parent == GROUND and not entry.slides),
        *(point.place for point in structure.points if point.body == GROUND),
    ]
    if not fixed:
        raise InputError(
            f"joint.{joint.name}.part: need a part that a support holds, because a hinge carries what the part fixes to"
            f" the ground, got {joint.part}, whose bodies are all free"
        )
    if not joint.mass:
        return []
    if not fixed:
        raise InputError(f"joint.{joint.name}.mass: need 0 g, because the part fixes no point to this hinge")
    mass = joint.mass / len(fixed)
    return [PointMass(body=body, place=carried.of(place), mass=mass, role="base") for place in fixed]


def _hinge(joint: HingeJoint, body: int, axis: Array) -> Hinge:
    return Hinge(
        name=joint.name,
        role=joint.name,
        body=body,
        axis=axis,
        lower=-math.inf if joint.lower is None else joint.lower,
        upper=math.inf if joint.upper is None else joint.upper,
        stiffness=joint.stiffness,
        rest_angle=joint.rest_angle,
        damping=joint.damping,
        friction=joint.friction,
        armature=joint.armature,
        start=joint.start,
        label=joint.name,
    )


def _within(motion: RigidMotion, origin: Array, frame: Array) -> RigidMotion:
    """Return a motion to the axes of the ground as one to the axes of a body, given its origin and frame as built."""
    return RigidMotion(frame.T @ motion.rotation, frame.T @ (motion.shift - origin))


def _frame_of(layout: Layout, body: int) -> tuple[Array, Array]:
    """Return the origin and the frame of a body as built; those of the ground for GROUND."""
    if body == GROUND:
        return np.zeros(3), np.eye(3)
    origins, frames = frames_of(layout.bodies)
    return origins[body], frames[body]


def _body_number(layout: Layout, joint: PlacingJoint) -> int:
    """Return the number of the body that carries a part.

    Raises:
        InputError: there is no such body, or it has no orientation.
    """
    if joint.to == GROUND_BODY:
        return GROUND
    key = f"joint.{joint.name}.to"
    number = number_of(key, layout.bodies, joint.to)
    if layout.bodies[number].slides and not layout.bodies[number].turns:
        raise InputError(
            f"{key}: need a body that can turn, because it sets the orientation of the part, got {joint.to}, a vertex"
            " of facets that bend; connect such vertices by springs or tendons"
        )
    return number


def _joint_points(structure: Structure, name: str, joint: PlacingJoint) -> Array:
    """Return the positions of a joint's points in the axes of the part, m, (point, 3)."""
    key = f"joint.{joint.name}.points"
    built = built_points(structure)
    names = [text.removeprefix(f"{name}.") for text in joint.points]
    return np.array([built[number_of(key, structure.points, text)] for text in names]).reshape(-1, 3)


def _onto(layout: Layout, joint: PlacingJoint, points: Array) -> Array:
    """Return the positions on which a joint's points come to lie, m, (point, 3)."""
    if joint.onto:
        part = joint.to.partition(".")[0]
        texts = [text if "." in text or joint.to == GROUND_BODY else f"{part}.{text}" for text in joint.onto]
        numbers = [number_of(key := f"joint.{joint.name}.onto", layout.points, text) for text in texts]
        carrier = _body_number(layout, joint)
        for text, number in zip(texts, numbers, strict=True):
            if (body := layout.points[number].body) != carrier:
                place = "on the ground" if body == GROUND else f"of {layout.bodies[body].name}"
                raise InputError(
                    f"{key}: need points of {joint.to}, which carries the part, got {text}, a point {place}"
                )
        return np.array([_built_point(layout, number) for number in numbers])
    if not len(points):
        return np.zeros((0, 3))
    first = np.array(joint.position)
    if len(points) < 2:
        return first[None]
    length = float(np.linalg.norm(points[1] - points[0]))
    along = (
        points[1] - points[0] if joint.along is None else length * np.array(joint.along) / np.linalg.norm(joint.along)
    )
    return np.array([first, first + along])


def _built_point(layout: Layout, number: int) -> Array:
    point = layout.points[number]
    origin, frame = _frame_of(layout, point.body)
    return np.asarray(origin + frame @ point.place)


def number_of(key: str, entries: Sequence[_Named], text: str) -> int:
    """Return the number of an entry by its name, in which spaces are ignored.

    Raises:
        InputError: there is no such entry.
    """
    names = [entry.name for entry in entries]
    plain = [name.replace(" ", "") for name in names]
    wanted = text.replace(" ", "")
    if wanted not in plain:
        raise InputError(f"{key}: need {one_of(names, text)}")
    return plain.index(wanted)
