"""The structure of an assembly: the structures of its parts, one after another, and the joints between them."""

from __future__ import annotations

import dataclasses
from collections.abc import Callable, Sequence
from dataclasses import replace

import numpy as np

from forficula.design.assembly.assembly import AssemblyDesign
from forficula.design.design import Design
from forficula.errors import InputError
from forficula.structure.appearance import Appearance
from forficula.structure.assembly.components import with_components
from forficula.structure.assembly.groups import with_groups
from forficula.structure.assembly.joined_part import JoinedPart
from forficula.structure.assembly.joints import with_inertia, with_joints
from forficula.structure.assembly.layout import Layout, add_part
from forficula.structure.assembly.protocol import with_assembly_protocol
from forficula.structure.mass import mass_of
from forficula.structure.parts import Contact, Stops
from forficula.structure.structure import Structure
<<<<<<< HEAD
from forficula.structure.tree import built_points
=======
from forficula.structure.tree import ancestry, built_points, moving_body

_Named = TypeVar("_Named", Body, Point, Hinge)


@dataclass(frozen=True, kw_only=True)
class _Part:
    """A part where it is in the assembly.

    Attributes:
        name: name of the part.
        structure: structure of the part alone.
        bodies: number in the assembly of its first body.
        points: number in the assembly of its first point.
        base: number in the assembly of the body that carries what the part fixes to the ground, or GROUND.
        motion: from the axes of the part to those of the assembly, as built.
        carried: from the axes of the part to those of `base`.
    """

    name: str
    structure: Structure
    bodies: int
    points: int
    base: int
    motion: RigidMotion
    carried: RigidMotion

    def body(self, number: int) -> int:
        """Return the number in the assembly of a body of the part, or of its ground."""
        return self.base if number == GROUND else self.bodies + number

    def place(self, body: int, place: Array) -> Array:
        """Return a position in the axes of the body, or of the ground, of the part in those of `self.body(body)`."""
        return self.carried.of(place) if body == GROUND and self._moves else place

    def places(self, bodies: Indices, places: Array) -> Array:
        """Return positions, m, (..., 3), as `place` does."""
        grounded = (bodies == GROUND)[..., None]
        return np.where(grounded, self.carried.of(places), places) if grounded.any() and self._moves else places

    def numbers(self, bodies: Indices) -> Indices:
        """Return numbers of bodies as `body` does."""
        return np.where(bodies == GROUND, self.base, bodies + self.bodies)

    def point_numbers(self, points: Sequence[int]) -> tuple[int, ...]:
        """Return the numbers in the assembly of points of the part."""
        return tuple(self.points + point for point in points)

    @property
    def _moves(self) -> bool:
        motion = self.carried
        return self.base != GROUND or bool(motion.shift.any()) or not np.array_equal(motion.rotation, np.eye(3))

    def called(self, name: str) -> str:
        """Return a name with that of the part before it."""
        return f"{self.name}.{name}"


class _Joined:
    """The lists of an assembly's structure while it is built."""

    def __init__(self, design: AssemblyDesign) -> None:
        self.design = design
        self.parts: dict[str, _Part] = {}
        self.bodies: list[Body] = []
        self.points: list[Point] = []
        self.masses: list[PointMass] = []
        self.joints: list[Hinge] = []
        self.creases: list[Hinge] = []
>>>>>>> rev-hostile


def assembly_structure(design: AssemblyDesign, build: Callable[[Design], Structure]) -> Structure:
    """Build the structure of an assembly, in the units of its design.

    Bodies, points and elastic elements of the parts follow each other, with the name of the part before their names and
    before the roles of hinges. Joints come first among the hinges, then creases.

    Args:
        design: design of the assembly.
        build: function that builds the structure of a part.

    Raises:
        InputError: a joint that names something that the parts do not have, or parts that cannot be joined so.
    """
    design = design.settled()
    layout = Layout(design)
    for name in design.order:
        add_part(layout, name, build(design.designs[name]))
    parts = layout.numbered_parts()
    alone = parts[0].structure if len(parts) == 1 else None
    structure = Structure(
        name=design.name,
        bodies=tuple(layout.bodies),
        points=tuple(layout.points),
        hinges=layout.hinges,
        contact=_common_contact(design, parts),
        stops=Stops(time_constant=design.stops.time_constant, damping_ratio=design.stops.damping_ratio),
        gravity=design.protocol.gravity,
        span=parts[0].structure.span,
        mass=max(part.structure.mass for part in parts),
        strength=min((part.structure.strength for part in parts if part.structure.strength), default=None),
        imperfection=next((part.structure.imperfection for part in parts if part.structure.imperfection), None),
        rigid_fold=None if alone is None else alone.rigid_fold,
        remarks=tuple(f"{part.name}: {remark}" for part in parts for remark in part.structure.remarks),
        appearance=Appearance(whole="assembly"),
    )
    structure = with_components(structure, layout.masses, parts)
    if alone is not None:
        structure = replace(structure, remarks=alone.remarks, appearance=alone.appearance)
    else:
        structure = replace(structure, span=float(np.ptp(built_points(structure), axis=0).max()))
    _check_kinds(structure)
    structure = with_joints(structure, design)
    if alone is None:
        structure = with_groups(structure, parts)
    structure = with_inertia(structure, parts)
    _check_masses(structure)
    return with_assembly_protocol(structure, design, parts)


def _common_contact(design: AssemblyDesign, parts: Sequence[JoinedPart]) -> Contact | None:
    """Return the contact of all parts; None if bodies pass through each other.

    Raises:
        InputError: contact of a part is not modelled, or parts differ in their contact.
    """
    if not design.protocol.contact:
        return None
    for part in parts:
        if part.structure.contact is None:
            raise InputError(
                f"{design.name}: protocol.contact: need false, because contact of the part {part.name} is not modelled,"
                " got true"
            )
        if part.structure.contact != parts[0].structure.contact:
            raise InputError(
                f"{design.name}: protocol.contact: need one thickness and one friction of contact in all parts, got"
                f" those of {part.name} that differ from those of {parts[0].name}"
            )
    return parts[0].structure.contact


def _check_kinds(structure: Structure) -> None:
    """Refuse parts that cannot be simulated together."""
    laws = {dataclasses.astuple(membrane.law) for membrane in structure.membranes}
    if len(laws) > 1:
        raise InputError(
            f"{structure.name}: need membranes of one thickness and one material in all parts, got {len(laws)} that"
            " differ"
        )
    for crease in structure.hinges:
        bodies = {structure.points[point].body for point in (crease.flaps or ())}
        if structure.plates and len(bodies) > 2:
            raise InputError(
                f"{structure.name}: need facets that are rigid in all parts, or that bend in all of them, got both:"
                f" {crease.name} is a crease of facets that bend"
            )


<<<<<<< HEAD
=======
def _joined_part(part: _Part, numbers: Mapping[str, int]) -> JoinedPart:
    return JoinedPart(
        name=part.name,
        structure=part.structure,
        hinges=tuple(numbers[part.called(hinge.name)] for hinge in part.structure.hinges),
        first_point=part.points,
        turn=part.motion.rotation,
    )


def _add_part(joined: _Joined, name: str, structure: Structure) -> None:
    """Add bodies, points and hinges of a part, after those of the part that carries it."""
    joint = joined.design.placing.get(name)
    part = _placed(joined, name, structure, joint)
    joined.parts[name] = part
    turns = part.motion.rotation
    for body in structure.bodies:
        if body.parent != GROUND:
            moved = replace(body, parent=part.body(body.parent))
        elif body.slides:
            _check_free(joined, part, body)
            moved = replace(body, position=part.motion.of(body.position), frame=_turned(body, turns))
        else:
            moved = replace(
                body,
                parent=part.base,
                position=part.place(GROUND, body.position),
                frame=_carried_frame(part, body),
            )
        joined.bodies.append(replace(moved, name=part.called(body.name)))
    joined.points += [
        replace(
            point,
            name=part.called(point.name),
            body=part.body(point.body),
            place=part.place(point.body, point.place),
        )
        for point in structure.points
    ]
    single = len(joined.design.parts) == 1
    for hinge in structure.hinges:
        named = replace(
            hinge,
            name=part.called(hinge.name),
            role=hinge.role if hinge.role == BEND else part.called(hinge.role),
            label=part.called(hinge.label or hinge.name),
            edge=hinge.edge if single else -1,
        )
        if hinge.flaps is None:
            joined.joints.append(replace(named, body=part.body(hinge.body)))
        else:
            one, two, three, four, five, six = part.point_numbers(hinge.flaps)
            joined.creases.append(replace(named, flaps=(one, two, three, four, five, six)))


def _carried_frame(part: _Part, body: Body) -> Array:
    """Return the frame of a body that the part fixes to the ground, in the axes of the part's base."""
    turn = part.carried.rotation
    return body.frame if np.array_equal(turn, np.eye(3)) else np.asarray(turn @ body.frame)


def _turned(body: Body, turn: Array) -> Array:
    """Return the frame of a free body; a node that only slides keeps its axes."""
    return body.frame if not body.turns or np.array_equal(turn, np.eye(3)) else np.asarray(turn @ body.frame)


def _check_free(joined: _Joined, part: _Part, body: Body) -> None:
    """Refuse free bodies whose freedom depends on the axes of the ground, where these turn or move."""
    if len(body.slides) < 3 and (part.base != GROUND or not np.array_equal(np.abs(part.motion.rotation), np.eye(3))):
        raise InputError(
            f"part.{part.name}.support: a vertex may be held along single axes only in a part that is not turned and"
            f" whose base does not move, got {body.name}"
        )
    number = part.base
    while number != GROUND:
        for hinge in joined.joints:
            if hinge.body == number and hinge.start != hinge.built:
                raise InputError(
                    f"part.{part.name}: parts with free bodies need bases that start as built, and {hinge.name} starts"
                    f" at {math.degrees(hinge.start - hinge.built):.4g} deg from there"
                )
        number = joined.bodies[number].parent


def _placed(joined: _Joined, name: str, structure: Structure, joint: PlacingJoint | None) -> _Part:
    """Return a part where its joint places it, after adding the body of a hinge."""
    base = GROUND if joint is None else _body_number(joined, joint)
    points = np.zeros((0, 3)) if joint is None else _joint_points(structure, name, joint)
    motion = part_motion(joint, points, np.zeros((0, 3)) if joint is None else _onto(joined, joint, points))
    origin, frame = _frame_of(joined, base)
    carried = motion if base == GROUND else _within(motion, origin, frame)
    if isinstance(joint, HingeJoint):
        start = motion.of(points[0])
        axis = motion.rotation @ (points[1] - points[0])
        axis = frame.T @ axis / np.linalg.norm(axis)
        number = len(joined.bodies)
        joined.bodies.append(
            Body(
                name=f"{joint.name} base",
                role="base",
                parent=base,
                position=frame.T @ (start - origin),
                frame=np.eye(3),
            )
        )
        joined.joints.append(_hinge(joint, number, axis))
        base, carried = number, _within(motion, start, frame)
        fixed = [
            *(body.position for body in structure.bodies if body.parent == GROUND and not body.slides),
            *(point.place for point in structure.points if point.body == GROUND),
        ]
        if joint.mass and not fixed:
            raise InputError(f"joint.{joint.name}.mass: need 0 g, because the part fixes no point to this hinge")
        if joint.mass:
            share = joint.mass / len(fixed)
            places = (carried.of(place) for place in fixed)
            joined.masses += [PointMass(body=number, place=place, mass=share, role="base") for place in places]
    return _Part(
        name=name,
        structure=structure,
        bodies=len(joined.bodies),
        points=len(joined.points),
        base=base,
        motion=motion,
        carried=carried,
    )


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


def _frame_of(joined: _Joined, body: int) -> tuple[Array, Array]:
    """Return the origin and the frame of a body as built; those of the ground for GROUND."""
    if body == GROUND:
        return np.zeros(3), np.eye(3)
    origin, frame = _frame_of(joined, joined.bodies[body].parent)
    return origin + frame @ joined.bodies[body].position, frame @ joined.bodies[body].frame


def _body_number(joined: _Joined, joint: PlacingJoint) -> int:
    """Return the number of the body that carries a part."""
    if joint.to == GROUND_BODY:
        return GROUND
    return _number(f"joint.{joint.name}.to", joined.bodies, joint.to)


def _joint_points(structure: Structure, name: str, joint: PlacingJoint) -> Array:
    """Return the positions of a joint's points in the axes of the part, m, (point, 3)."""
    key = f"joint.{joint.name}.points"
    built = built_points(structure)
    names = [text.removeprefix(f"{name}.") for text in joint.points]
    return np.array([built[_number(key, structure.points, text)] for text in names]).reshape(-1, 3)


def _onto(joined: _Joined, joint: PlacingJoint, points: Array) -> Array:
    """Return the positions on which a joint's points come to lie, m, (point, 3)."""
    if joint.onto:
        part = joint.to.partition(".")[0]
        texts = [text if "." in text or joint.to == GROUND_BODY else f"{part}.{text}" for text in joint.onto]
        numbers = [_number(f"joint.{joint.name}.onto", joined.points, text) for text in texts]
        return np.array([_built_point(joined, number) for number in numbers])
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


def _built_point(joined: _Joined, number: int) -> Array:
    point = joined.points[number]
    origin, frame = _frame_of(joined, point.body)
    return np.asarray(origin + frame @ point.place)


def _number(key: str, entries: Sequence[_Named], text: str) -> int:
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


def _bar(part: _Part, bar: Bar) -> Bar:
    one, other = part.point_numbers(bar.points)
    return replace(bar, body=part.body(bar.body), points=(one, other))


def _plate(part: _Part, plate: Plate) -> Plate:
    return replace(plate, body=part.body(plate.body), points=part.point_numbers(plate.points))


def _mass(part: _Part, mass: PointMass) -> PointMass:
    return replace(mass, body=part.body(mass.body), place=part.place(mass.body, mass.place))


def _facet(part: _Part, facet: Facet) -> Facet:
    return replace(
        facet,
        name=part.called(facet.name),
        points=part.point_numbers(facet.points),
        inside=part.point_numbers(facet.inside),
    )


def _closure(part: _Part, closure: Closure) -> Closure:
    one, other = (part.body(body) for body in closure.bodies)
    pairs = tuple((part.points + first, part.points + second) for first, second in closure.points)
    return replace(closure, name=part.called(closure.name), bodies=(one, other), points=pairs)


def _limit(part: _Part, limit: LengthLimit) -> LengthLimit:
    one, other = part.point_numbers(limit.points)
    return replace(limit, name=part.called(limit.name), points=(one, other))


def _membrane(part: _Part, membrane: Membrane) -> Membrane:
    surface = membrane.surface
    return replace(
        membrane,
        name=part.called(membrane.name),
        bodies=part.numbers(membrane.bodies),
        places=part.places(membrane.bodies, membrane.places),
        built=membrane.built if _stays(part) else part.motion.of(membrane.built),
        surface=None if surface is None else _surface(part, surface),
    )


def _stays(part: _Part) -> bool:
    return not part.motion.shift.any() and np.array_equal(part.motion.rotation, np.eye(3))


def _surface(part: _Part, surface: Surface) -> Surface:
    return replace(
        surface,
        bodies=part.numbers(surface.bodies),
        places=part.places(surface.bodies, surface.places),
        names=tuple(part.called(name) for name in surface.names),
    )


def _coupling(part: _Part, coupling: Coupling, numbers: Mapping[str, int]) -> Coupling:
    one, other = (numbers[part.called(part.structure.hinges[hinge].name)] for hinge in coupling.hinges)
    return replace(coupling, name=part.called(coupling.name), hinges=(one, other))


def _spring(part: _Part, spring: Spring) -> Spring:
    one, other = part.point_numbers(spring.points)
    return replace(spring, name=part.called(spring.name), points=(one, other))


def _tendon(part: _Part, tendon: Tendon, numbers: Mapping[str, int]) -> Tendon:
    one, other = part.point_numbers(tendon.points)

    def hinge(number: int) -> int:
        return numbers[part.called(part.structure.hinges[number].name)]

    return replace(
        tendon,
        name=part.called(tendon.name),
        points=(one, other),
        key=f"{part.name}.{tendon.key}" if tendon.key else "",
        label=part.called(tendon.label or tendon.name),
        crossing=None if tendon.crossing is None else replace(tendon.crossing, hinge=hinge(tendon.crossing.hinge)),
        ideal=None if tendon.ideal is None else replace(tendon.ideal, hinge=hinge(tendon.ideal.hinge)),
    )


def _medium(parts: Sequence[_Part]) -> Medium | None:
    """Return the medium around all parts; None without one."""
    media = [(part, part.structure.medium) for part in parts if part.structure.medium is not None]
    if not media:
        return None
    kept = [(part, medium) for part, medium in media if medium is not None]
    return replace(
        kept[0][1],
        carriers=np.concatenate([part.numbers(medium.carriers) for part, medium in kept]),
        places=np.concatenate([part.places(medium.carriers, medium.places) for part, medium in kept]),
        widths=np.concatenate([medium.widths for _, medium in kept]),
        masses=tuple(_mass(part, mass) for part, medium in kept for mass in medium.masses),
    )


def _with_joints(structure: Structure, design: AssemblyDesign) -> Structure:
    """Return a structure with the couplings, springs and tendons between the parts."""
    points = list(structure.points)

    def end(joint: SpringJoint | TendonJoint, key: str) -> int:
        text = getattr(joint, key)
        if text.strip() != GROUND_BODY:
            return _number(f"joint.{joint.name}.{key}", points, text)
        if len(joint.ground) != 3:
            raise InputError(f"joint.{joint.name}.ground: need x, y and z of the point on the ground")
        points.append(Point(name=f"{joint.name} {key}", role="ground", body=GROUND, place=np.array(joint.ground)))
        return len(points) - 1

    def ends(joint: SpringJoint | TendonJoint) -> tuple[int, int]:
        one, other = end(joint, "from"), end(joint, "to")
        if moving_body(structure, points[one].body) == moving_body(structure, points[other].body):
            names = f"{points[one].name} and {points[other].name}"
            raise InputError(f"joint.{joint.name}.to: need points that move relative to each other, got {names}")
        if joint.ground and not {points[one].role, points[other].role} & {GROUND_BODY}:
            raise InputError(f'joint.{joint.name}.ground: needs "ground" as one end, and both ends are points of parts')
        return one, other

    couplings, springs, tendons = list(structure.couplings), list(structure.springs), list(structure.tendons)
    for number, joint in enumerate(design.joint):
        if isinstance(joint, CouplingJoint):
            one, other = (_joint_number(structure, f"joint.{joint.name}.hinges", name) for name in joint.hinges)
            stiffness = math.inf if joint.stiffness == "rigid" else float(joint.stiffness)
            couplings.append(Coupling(name=joint.name, hinges=(one, other), stiffness=stiffness, ratio=joint.ratio))
        elif isinstance(joint, SpringJoint):
            springs.append(
                Spring(
                    name=joint.name,
                    role="spring",
                    points=ends(joint),
                    stiffness=joint.stiffness,
                    rest_length=joint.rest_length,
                    damping=joint.damping,
                )
            )
        elif isinstance(joint, TendonJoint):
            tendons.append(
                Tendon(
                    name=joint.name,
                    role="tendon",
                    points=ends(joint),
                    law=tendon_law(joint),
                    longest=math.inf,
                    gauge_length=joint.rest_length,
                    material=None if joint.law is None else joint.law.material,
                    key=f"joint.{number}",
                )
            )
    made = replace(structure, points=tuple(points), couplings=tuple(couplings), springs=tuple(springs))
    first = len(structure.tendons)
    if any(body.slides for body in made.bodies) or made.closures:
        return replace(made, tendons=tuple(tendons))
    crossed = [replace(tendon, crossing=tendon_crossing(made, tendon.points)) for tendon in tendons[first:]]
    return replace(made, tendons=(*tendons[:first], *crossed))


def _joint_number(structure: Structure, key: str, name: str) -> int:
    """Return the number of a joint that turns a body; a crease that opens has none."""
    number = _number(key, structure.hinges, name)
    if structure.hinges[number].flaps is not None:
        raise InputError(f"{key}: need hinges that turn a body, and {name} is a crease that opens or between nodes")
    return number


def _with_inertia(structure: Structure, parts: Sequence[_Part]) -> Structure:
    """Return a structure whose tendons have the inertia of everything that turns, other parts included."""
    carrying = {body for part in parts if part.base != GROUND for body in ancestry(structure, part.base)}

    def complete(tendon: Tendon) -> Tendon:
        crossing = tendon.crossing
        if crossing is None or structure.hinges[crossing.hinge].body not in carrying:
            return tendon
        return replace(tendon, crossing=replace(crossing, inertia=inertia_about(structure, crossing.hinge)))

    return replace(structure, tendons=tuple(map(complete, structure.tendons)))


>>>>>>> rev-reader
def _check_masses(structure: Structure) -> None:
    """Refuse the body of a hinge that carries no mass itself and no body fixed to it."""
    fixed = {body.parent for number, body in enumerate(structure.bodies) if not _turns(structure, number)}
    for number, body in enumerate(structure.bodies):
        if body.role == "base" and not mass_of(structure, number)[0] and number not in fixed:
            name = body.name.removesuffix(" base")
            raise InputError(f"joint.{name}.mass: need > 0 g, because the part fixes no body to this hinge")


def _turns(structure: Structure, body: int) -> bool:
    return bool(structure.bodies[body].slides) or any(hinge.body == body for hinge in structure.hinges)
