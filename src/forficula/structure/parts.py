"""Components of a structure: bodies with points, bars and plates on them, hinges, springs and tendons.

All are frozen data in SI and radians, or in other coherent units in which a design is written.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field

import numpy as np

from forficula.arrays import Array
from forficula.material.law.crease_law import CreaseDamage
from forficula.material.law.material_law import MaterialLaw
from forficula.material.law.maxwell_element import MaxwellElement
from forficula.material.law.tendon_law import TendonLaw

GROUND = -1


@dataclass(frozen=True, kw_only=True, eq=False)
class Body:
    """A rigid body.

    Attributes:
        name: name of the body.
        role: role, shared with other bodies of the same kind.
        parent: number of the parent body, which comes earlier, or GROUND. Without hinges the body is fixed to it.
        position: origin in the axes of the parent, m, (3,).
        frame: rotation from the axes of the body to those of the parent, (3, 3).
        slides: axes of the ground, 0 to 2, along which the origin is free to move; only for a body without hinges whose
            parent is the ground.
        turns: whether the body is also free to turn; only for a body that slides along all three axes.
        mass: mass at the origin, in addition to that of bars and plates, kg.
    """

    name: str
    role: str
    parent: int
    position: Array
    frame: Array
    slides: tuple[int, ...] = ()
    turns: bool = False
    mass: float = 0.0

    @property
    def label(self) -> str:
        """Return the role and the number of the body, such as "facet 3"."""
        return f"{self.role} {self.name.removeprefix(self.role)}"


@dataclass(frozen=True, kw_only=True, eq=False)
class Point:
    """A named point on a body.

    Attributes:
        name: name of the point.
        role: role, shared with other points of the same kind.
        body: number of the body that carries the point, or GROUND.
        place: position in the axes of the body, from its origin, m, (3,).
    """

    name: str
    role: str
    body: int
    place: Array


@dataclass(frozen=True, kw_only=True, eq=False)
class Bar:
    """A solid cylinder from the origin of a body.

    Attributes:
        body: number of the body.
        end: outer end in the axes of the body, m, (3,).
        diameter: m.
        density: kg/m^3.
        points: numbers of the points between which the bar is drawn.
        overlaps: length from the origin, m, in which the bar may overlap others in the built shape; contact is ignored
            there.
    """

    body: int
    end: Array
    diameter: float
    density: float
    points: tuple[int, int]
    overlaps: float = 0.0


@dataclass(frozen=True, kw_only=True, eq=False)
class Plate:
    """A flat polygon of uniform thickness, or convex solids.

    Attributes:
        body: number of the body.
        points: numbers of the corners of the mid-plane, points of that body, in order.
        thickness: m.
        density: kg/m^3.
        touching_distance: distance between the mid-planes of touching plates, m; that of the structure's contact if
            None.
        solids: numbers of the corners of convex solids that touch but do not overlap, points of that body; empty for a
            prism over the mid-plane.
        core: numbers of the corners of a polygon in the mid-plane, points of that body, in order. Everything within
            half the thickness of the polygon lies inside the solids, apart from notches. Empty without solids.
    """

    body: int
    points: tuple[int, ...]
    thickness: float
    density: float
    touching_distance: float | None = None
    solids: tuple[tuple[int, ...], ...] = ()
    core: tuple[int, ...] = ()


@dataclass(frozen=True, kw_only=True, eq=False)
class PointMass:
    """A point mass that a body carries in addition to its bars and plates.

    Attributes:
        body: number of the body that carries the mass.
        place: position in the axes of the body, from its origin, m, (3,).
        mass: kg.
        role: component to which the mass belongs, such as "membrane".
    """

    body: int
    place: Array
    mass: float
    role: str


@dataclass(frozen=True, kw_only=True, eq=False)
class Facet:
    """A polygon between points of any bodies: a panel of a sheet that may bend.

    Attributes:
        name: name of the facet.
        points: numbers of the corners, in order.
        thickness: m.
        inside: numbers of points inside the polygon at which the facet also bends.
        touching_distance: distance between the mid-planes of touching facets, m; that of the structure's contact if
            None.
    """

    name: str
    points: tuple[int, ...]
    thickness: float
    inside: tuple[int, ...] = ()
    touching_distance: float | None = None


@dataclass(frozen=True, kw_only=True, eq=False)
class Hinge:
    """A hinge: a joint about which a body turns relative to its parent, or a crease between two flaps.

    The axis of a joint passes through the origin of its body. A body may have several joints; each joint turns the
    axes of the next. A crease has no body: its angle is that between two triangles, 0 if they lie in one plane, and
    positive if both rise to the side from which the left one is seen counterclockwise. All angles are in the hinge's
    own sense.

    Attributes:
        name: name of the hinge.
        role: role, shared with other hinges of the same kind, in goals, groups and tables.
        body: number of the body that turns; GROUND for a crease.
        axis: unit vector in the axes of the body, (3,); zeros for a crease.
        flaps: points of a crease: tail, head and corner of the triangle on the left, then tail, head and corner of the
            triangle on the right, seen from tail to head; None for a joint.
        sense: +1 or -1, the factor between a right-handed turn about the axis, or the angle between the flaps, and the
            angle in the hinge's own sense.
        lower: angle of the lower stop, rad; -inf without a stop.
        upper: angle of the upper stop, rad; inf without a stop.
        stiffness: stiffness of the spring, N m/rad.
        rest_angle: rest angle of the spring, rad.
        lock_below: angle, rad, below which the spring stiffens until it locks at -180 deg, as panels that touch do;
            -inf for a spring that does not lock.
        lock_above: angle, rad, above which the spring stiffens until it locks at 180 deg; inf for a spring that does
            not lock.
        stop_stiffness: stiffness of the stops of a crease, N m/rad; None if `crease_law` chooses it.
        yield_angle: angle from rest at which the spring begins to yield, rad; inf for one that never yields.
        hardening: slope of the moment while the spring yields, N m/rad.
        quadratic: quadratic term of the spring's moment over the angle from rest, N m/rad^2.
        cubic: cubic term, N m/rad^3.
        branches: Maxwell branches parallel to the spring.
        damage: loss of the moment with wear; None without.
        damping: N m s/rad.
        friction: torque of the dry friction of a joint, N m.
        armature: added inertia, kg m^2.
        built: angle of a joint in the built shape, rad.
        start: initial angle, rad; for a crease, the angle in the built shape.
        assignment: letter of a hinge that is an edge of a pattern, such as "M"; empty for others.
        edge: number of the edge of the pattern to which the hinge belongs; -1 for others.
        label: name in tables and figures; `name` if empty.
    """

    name: str
    role: str
    body: int = GROUND
    axis: Array = field(default_factory=lambda: np.zeros(3))
    flaps: tuple[int, int, int, int, int, int] | None = None
    sense: int = 1
    lower: float = -math.inf
    upper: float = math.inf
    stiffness: float = 0.0
    rest_angle: float = 0.0
    lock_below: float = -math.inf
    lock_above: float = math.inf
    stop_stiffness: float | None = None
    yield_angle: float = math.inf
    hardening: float = 0.0
    quadratic: float = 0.0
    cubic: float = 0.0
    branches: tuple[MaxwellElement, ...] = ()
    damage: CreaseDamage | None = None
    damping: float = 0.0
    friction: float = 0.0
    armature: float = 0.0
    built: float = 0.0
    start: float = 0.0
    assignment: str = ""
    edge: int = -1
    label: str = ""

    @property
    def remembers(self) -> bool:
        """Whether the moment of the spring depends on the past by more than a permanent fold."""
        return bool(self.branches) or self.damage is not None


@dataclass(frozen=True, kw_only=True, eq=False)
class Coupling:
    """A spring or a rigid connection between two joints; its twist is the second angle minus `ratio` times the first.

    Angles are relative to the built shape, in which the twist is 0, and in the hinges' own senses.

    Attributes:
        name: name of the coupling.
        hinges: numbers of the two joints.
        stiffness: stiffness of the spring, N m/rad; inf for a rigid coupling, whose twist is always 0.
        ratio: angle of the second joint divided by that of the first, without a twist.
    """

    name: str
    hinges: tuple[int, int]
    stiffness: float
    ratio: float = 1.0

    @property
    def rigid(self) -> bool:
        """Whether the twist is always 0."""
        return math.isinf(self.stiffness)


@dataclass(frozen=True, kw_only=True, eq=False)
class Closure:
    """A crease that closes a loop: its hinge turns a copy of a body, and the copy is constrained to move with the body.

    The body and all of its copies share its mass equally.

    Attributes:
        name: name of the closure.
        bodies: numbers of the body and of its copy.
        position: origin of the copy in the axes of the body, m, (3,).
        frame: rotation from the axes of the copy to those of the body, (3, 3).
        points: pairs of points at both ends of the crease, on the parent of the copy and on the body; the distance of a
            pair is the gap of the closure.
    """

    name: str
    bodies: tuple[int, int]
    position: Array
    frame: Array
    points: tuple[tuple[int, int], ...]


@dataclass(frozen=True, kw_only=True, eq=False)
class Spring:
    """An elastic bar between two points, which pulls and pushes.

    Attributes:
        name: name of the spring.
        role: role, shared with other springs of the same kind.
        points: numbers of the end points.
        stiffness: N/m.
        rest_length: m.
        damping: N s/m.
        area: cross-section, by which the force is divided to obtain the stress, m^2; 0 without one.
    """

    name: str
    role: str
    points: tuple[int, int]
    stiffness: float
    rest_length: float
    damping: float = 0.0
    area: float = 0.0


@dataclass(frozen=True, kw_only=True)
class Crossing:
    """Geometry of a tendon across a single hinge, on whose angle alone its length depends.

    The ends turn about the hinge's axis on two circles with radii A and B, which are an offset c apart along the axis:
    length^2 = A^2 + B^2 + c^2 + 2 A B cos(angle + delta), with the hinge's angle in its own sense.

    Attributes:
        hinge: number of the hinge.
        proximal_arm: A, distance from the axis to the end on the side of the hinge's parent, m.
        distal_arm: B, distance from the axis to the end on the side that turns, m.
        axial_offset: c, m; 0 if both ends lie in one plane normal to the axis.
        offset_angle: delta, rad; the tendon is longest at the hinge angle -delta. 0 if axis and ends lie in one plane
            as built.
        inertia: inertia of everything that turns about the axis, as built, with the hinge's armature, kg m^2.
    """

    hinge: int
    proximal_arm: float
    distal_arm: float
    axial_offset: float = 0.0
    offset_angle: float = 0.0
    inertia: float


@dataclass(frozen=True, kw_only=True, eq=False)
class Tendon:
    """A pull-only spring between two points.

    Attributes:
        name: name of the tendon.
        role: role, shared with other tendons of the same kind.
        points: numbers of the end points.
        law: force as a function of length, rate and history, in the structure's units.
        longest: largest possible length, m.
        crossing: geometry across the only hinge on which the length depends; None if it depends on several.
        ideal: the same with both bars normal to the hinge's axis, as in closed forms; None without bars.
        gauge_length: resting length before any permanent set, m; strain is extension divided by this length.
        material: law of the material, in the structure's units; None for a spring without a material.
        key: key of the section of the design, such as "tendon", or "tendon.1" if tendons differ.
        label: name in tables and figures; `name` if empty.
    """

    name: str
    role: str
    points: tuple[int, int]
    law: TendonLaw
    longest: float
    crossing: Crossing | None = None
    ideal: Crossing | None = None
    gauge_length: float = 0.0
    material: MaterialLaw | None = None
    key: str = ""
    label: str = ""


@dataclass(frozen=True, kw_only=True, eq=False)
class LengthLimit:
    """An upper limit of the distance between two points: a guard tendon.

    Attributes:
        name: name of the limit.
        points: numbers of the two points.
        built_length: distance in the built shape, m.
        most: largest distance, m.
    """

    name: str
    points: tuple[int, int]
    built_length: float
    most: float


@dataclass(frozen=True, kw_only=True)
class Mechanism:
    """A named group of elements that store energy, such as the tendons of a wing; numbers are those of the structure.

    Attributes:
        name: name of the mechanism.
        hinges: numbers of the joints and creases whose springs belong to the mechanism.
        springs: numbers of the springs between points.
        tendons: numbers of the tendons.
        membranes: numbers of the membranes.
        couplings: numbers of the elastic couplings between joints.
    """

    name: str
    hinges: tuple[int, ...] = ()
    springs: tuple[int, ...] = ()
    tendons: tuple[int, ...] = ()
    membranes: tuple[int, ...] = ()
    couplings: tuple[int, ...] = ()
