"""What a structure is made of: bodies and the points, bars and plates on them, hinges, springs, tendons, membranes.

Frozen data in SI and radians, or in any other coherent units that a design was written in.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np

from forficula.arrays import Array, Indices
from forficula.material.law.material_law import MaterialLaw
from forficula.material.law.tendon_law import TendonLaw

GROUND = -1


@dataclass(frozen=True, kw_only=True, eq=False)
class Body:
    """Something rigid that moves as one.

    Attributes:
        name: of its own.
        role: what it is called with others of its kind.
        parent: number of the body that it hangs on, an earlier one, or GROUND. Without hinges it is fixed there.
        position: of its origin in the axes of its parent, m, (3,).
        frame: rotation from its axes to those of its parent, (3, 3).
        slides: axes of the ground, 0 to 2, along which its origin is free to go; only of a body that hangs on the
            ground and has no hinges.
        turns: whether it is free to turn, too; only of one that slides along all three.
        mass: at its origin, beside that of its bars and plates, kg.
    """

    name: str
    role: str
    parent: int
    position: Array
    frame: Array
    slides: tuple[int, ...] = ()
    turns: bool = False
    mass: float = 0.0


@dataclass(frozen=True, kw_only=True, eq=False)
class Point:
    """A named place on a body.

    Attributes:
        name: of its own.
        role: what it is called with others of its kind.
        body: number of the body that carries it, or GROUND.
        place: in the axes of the body, from its origin, m, (3,).
    """

    name: str
    role: str
    body: int
    place: Array


@dataclass(frozen=True, kw_only=True, eq=False)
class Bar:
    """A solid cylinder from the origin of a body.

    Attributes:
        body: number of the body that it is.
        end: in the axes of the body, m, (3,).
        diameter: m.
        density: kg/m^3.
        points: numbers of the points that it is drawn between.
        overlaps: how far from the origin on it may overlap others in the built shape, m: there it touches nothing.
    """

    body: int
    end: Array
    diameter: float
    density: float
    points: tuple[int, int]
    overlaps: float = 0.0


@dataclass(frozen=True, kw_only=True, eq=False)
class Plate:
    """A flat polygon of even thickness.

    Attributes:
        body: number of the body that it is.
        points: numbers of its corners, points of that body, one after another.
        thickness: m.
        density: kg/m^3.
    """

    body: int
    points: tuple[int, ...]
    thickness: float
    density: float


@dataclass(frozen=True, kw_only=True, eq=False)
class PointMass:
    """Mass that a body carries beside that of its bars and plates, small enough to be at one place.

    Attributes:
        body: number of the body that carries it.
        place: in the axes of the body, from its origin, m, (3,).
        mass: kg.
        role: what it is the mass of, such as "membrane".
    """

    body: int
    place: Array
    mass: float
    role: str


@dataclass(frozen=True, kw_only=True, eq=False)
class Facet:
    """A polygon between points of any bodies: a panel of a sheet that may bend.

    Attributes:
        name: of its own.
        points: numbers of its corners, one after another.
        thickness: m.
        inside: numbers of points on it where it bends, too.
    """

    name: str
    points: tuple[int, ...]
    thickness: float
    inside: tuple[int, ...] = ()


@dataclass(frozen=True, kw_only=True, eq=False)
class Hinge:
    """Where a structure folds: a joint by which a body turns against its parent, or a crease between two flaps.

    A joint goes through its body's origin; several of one body follow each other: the first one turns the axes of the
    next. A crease has no body of its own: its angle is that between two
    triangles, 0 where they lie in one plane, positive where both rise to the side from which the left one is seen
    counterclockwise. Angles count in the hinge's own sense.

    Attributes:
        name: of its own.
        role: what it is called with others of its kind, in goals, groups and tables.
        body: number of the body that it turns; GROUND of a crease.
        axis: unit vector in the axes of the body, (3,); zeros of a crease.
        flaps: of a crease, numbers of points: tail, head and corner of the triangle on its left, and tail, head and
            corner of that on its right, seen along it from tail to head; None of a joint.
        sense: +1 or -1: an angle in the hinge's own sense is a right-handed turn about the axis, or the angle between
            the flaps, times that.
        lower: where a stop ends its range, rad; -inf where none does.
        upper: alike; inf where none does.
        stiffness: of its spring, N m/rad.
        rest_angle: where its spring rests, rad.
        lock_below: below which its spring stiffens until it locks at -180 deg, as of panels that touch, rad; -inf for
            a spring that does not.
        lock_above: alike towards 180 deg; inf for a spring that does not.
        stop_stiffness: of a crease's stops, N m/rad; None where it is chosen, see `crease_law`.
        damping: N m s/rad.
        friction: of a joint, torque of its dry friction, N m.
        armature: inertia added to it, kg m^2.
        built: of a joint, its angle in the built shape, rad.
        start: its angle at the start, rad; of a crease, that of the built shape.
        assignment: of one that is an edge of a pattern, its letter, such as "M"; empty of others.
        edge: number of the edge of the pattern that it is, or is part of; -1 of others.
        label: what tables and figures call it; its name if empty.
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
    damping: float = 0.0
    friction: float = 0.0
    armature: float = 0.0
    built: float = 0.0
    start: float = 0.0
    assignment: str = ""
    edge: int = -1
    label: str = ""


@dataclass(frozen=True, kw_only=True, eq=False)
class Coupling:
    """What ties two joints to each other: how far the second turns beside a multiple of the first is its twist.

    Angles count from those of the built shape, where nothing twists it, in the hinges' own senses.

    Attributes:
        name: of its own.
        hinges: numbers of the two joints.
        stiffness: of its spring, N m/rad; inf where it is rigid and lets nothing twist it.
        ratio: by how much the second turns where the first turns by 1 and nothing is twisted.
    """

    name: str
    hinges: tuple[int, int]
    stiffness: float
    ratio: float = 1.0

    @property
    def rigid(self) -> bool:
        """Whether its joints turn as one."""
        return math.isinf(self.stiffness)


@dataclass(frozen=True, kw_only=True, eq=False)
class Closure:
    """A crease that closes a loop: its hinge turns a copy of a body, which lies on that body and moves with it.

    The body and all of its copies share its mass evenly.

    Attributes:
        name: of its own.
        bodies: number of the body, and of its copy.
        position: of the copy's origin in the axes of the body, m, (3,).
        frame: rotation from the copy's axes to those of the body, (3, 3).
        points: pairs of points at both ends of the crease, on the side of the copy's parent and on the body; the
            distance of a pair is the gap of the closure.
    """

    name: str
    bodies: tuple[int, int]
    position: Array
    frame: Array
    points: tuple[tuple[int, int], ...]


@dataclass(frozen=True, kw_only=True, eq=False)
class Spring:
    """An elastic bar between two points: it pulls and it pushes.

    Attributes:
        name: of its own.
        role: what it is called with others of its kind.
        points: numbers of its ends.
        stiffness: N/m.
        rest_length: m.
        damping: N s/m.
        area: of its cross-section, by which its force is a stress, m^2; 0 where it has none.
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
    """How a tendon lies across a hinge, where its length depends on that hinge alone.

    Its ends turn about the hinge's axis on two circles with radii A and B, an offset c apart along the axis:
    length^2 = A^2 + B^2 + c^2 + 2 A B cos(angle + delta), with the hinge's angle in its own sense.

    Attributes:
        hinge: number of the hinge.
        proximal_arm: A, distance of the end on the side of the hinge's parent from the axis, m.
        distal_arm: B, the same of the end on the side that turns, m.
        axial_offset: c, m; 0 where the ends lie in one plane square to the axis.
        offset_angle: delta, rad; the tendon is longest where the hinge's angle is -delta. 0 where axis and ends lie in
            one plane as built.
        inertia: of what turns about the axis as built, with the hinge's armature, kg m^2.
    """

    hinge: int
    proximal_arm: float
    distal_arm: float
    axial_offset: float = 0.0
    offset_angle: float = 0.0
    inertia: float


@dataclass(frozen=True, kw_only=True, eq=False)
class Tendon:
    """A spring between two points that pulls and never pushes.

    Attributes:
        name: of its own.
        role: what it is called with others of its kind.
        points: numbers of its ends.
        law: force against length, rate and past, in the structure's units.
        longest: the length beyond which it is never stretched, m.
        crossing: how it lies across the only hinge that its length depends on; None where it depends on several.
        ideal: the same with both bars square to the hinge's axis, as closed forms have it; None where there are no
            bars to be so.
        gauge_length: by which its extension is a strain, m: the resting length that it had before any set.
        material: whose law it has, in the structure's units; None where it is a spring of no material.
        key: of the design's section that it comes from, such as "tendon", or "tendon.1" where others differ.
        label: what tables and figures call it; its name if empty.
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
    """What keeps two points from moving further apart, and does nothing else: a guard tendon.

    Attributes:
        name: of its own.
        points: numbers of the two.
        built_length: their distance in the built shape, m.
        most: their largest distance, m.
    """

    name: str
    points: tuple[int, int]
    built_length: float
    most: float


@dataclass(frozen=True, kw_only=True, eq=False)
class MembraneLaw:
    """Of an elastic sheet that resists stretch only.

    Attributes:
        youngs_modulus: Pa.
        poisson_ratio: of the sheet.
        thickness: m.
        damping: relaxation time of its Kelvin-Voigt damping, s.
    """

    youngs_modulus: float
    poisson_ratio: float
    thickness: float
    damping: float


@dataclass(frozen=True, kw_only=True, eq=False)
class Surface:
    """All that there is of an elastic sheet, as triangles whose corners bodies carry, glued strips and all.

    Attributes:
        bodies: number of the body that carries each node, (node,).
        places: nodes in the axes of their bodies, m, (node, 3).
        triangles: three nodes each, (triangle, 3).
        panels: number, in `names`, of the panel that each triangle is of, (triangle,).
        names: of the panels: the parts of it that folds part.
    """

    bodies: Indices
    places: Array
    triangles: Indices
    panels: Indices
    names: tuple[str, ...]

    @property
    def carried(self) -> list[tuple[int, tuple[float, ...]]]:
        """The body of each node and its place on it, alike for nodes that surfaces have in common."""
        return list(zip(self.bodies.tolist(), map(tuple, self.places.tolist()), strict=True))


@dataclass(frozen=True, kw_only=True)
class Stops:
    """Compliance of stops, length limits or contacts, which no timestep changes.

    With the inertia I that meets it, a stop is a spring and a damper of the angular frequency 1 / (T zeta) and the
    damping ratio zeta: its moment is -I (r / (T zeta)^2 + 2 r' / T) at a depth r, and never pulls.

    Attributes:
        time_constant: T, s.
        damping_ratio: zeta, in (0, 1].
    """

    time_constant: float
    damping_ratio: float = 1.0


@dataclass(frozen=True, kw_only=True)
class Contact:
    """How bars and sheets that touch push each other apart.

    Attributes:
        thickness: by which sheets keep apart, from middle to middle, m; bars do so by their diameters.
        friction: Coulomb's coefficient of all of them.
        stops: compliance of a contact.
    """

    thickness: float
    friction: float = 0.0
    stops: Stops


@dataclass(frozen=True, kw_only=True, eq=False)
class Membrane:
    """An elastic sheet whose nodes are carried by bodies.

    Attributes:
        name: of its own.
        bodies: number of the body that carries each node, (node,).
        places: nodes in the axes of their bodies, m, (node, 3).
        built: nodes in the built shape, where the sheet is unstretched, m, (node, 3).
        triangles: three nodes each, (triangle, 3).
        law: of the sheet.
        margin: width of what is glued to a bar, m; how far a body reaches into the sheet.
        roots: from where on its bar each node is held, in the axes of its body, m, (node, 3): the strip between the two
            is glued to the bar. The node itself where it lies on the bar; None where all do, or where there are none.
        surface: all of it, which may touch or cross that of others; None where that is not told.
    """

    name: str
    bodies: Indices
    places: Array
    built: Array
    triangles: Indices
    law: MembraneLaw
    margin: float
    roots: Array | None = None
    surface: Surface | None = None


@dataclass(frozen=True, kw_only=True, eq=False)
class Medium:
    """Air or water around the panels of a structure, which resists where they move square to themselves.

    Strips of width w, by area: a mass of pi rho w / 4 moves with them (Lamb 1932, Hydrodynamics, article 71: pi rho w^2
    / 4 by length), and the pressure on them is rho C_D v |v| / 2 + 32 mu v / (pi w) for a speed v along the normal: of
    a plate at high Reynolds numbers (Hoerner 1965) and of a disc of diameter w at low ones (16 mu a U broadside: Lamb
    1932, article 339). Nothing resists what moves in the plane of a panel. Panels do not shade one another, a panel's
    ends take nothing of its width, bars have none beside their panels, and no vortex lasts: quasi-steady.

    Attributes:
        density: kg/m^3.
        viscosity: Pa s.
        carriers: numbers of the bodies that carry the corners of triangles, (triangle, 3).
        places: these corners in the axes of their bodies, m, (triangle, 3, 3).
        widths: of the strips that the triangles are part of, m, (triangle,).
        masses: that move with bodies and weigh nothing. They count in every direction, and so too much where a panel
            moves in its plane: of the reference wing's kinetic energy what moves along normals in air has 1.2 %, and
            that adds 0.4 % while it folds and 0.7 % while it opens. In water it is 1.2 and 0.9 times as much again.
    """

    density: float
    viscosity: float
    carriers: Indices
    places: Array
    widths: Array
    masses: tuple[PointMass, ...]


@dataclass(frozen=True, kw_only=True, eq=False)
class Panel:
    """A triangle of a panel as built.

    Attributes:
        corners: m, (3, 3).
        carriers: numbers of the bodies that carry them.
        width: of the strip that it is part of, m.
    """

    corners: Array
    carriers: Sequence[int]
    width: float
