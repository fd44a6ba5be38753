"""What statics, dynamics and drawings share of a design: bodies, hinges, tendons, membranes, drives, measures.

Frozen data in SI and radians, or in any other coherent units that a design was written in. They know no engine, and
nothing here asks in which way a structure was built.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from forficula.material.law.material_law import MaterialLaw
from forficula.material.law.tendon_law import TendonLaw
from forficula.structure.appearance import Appearance

Array = NDArray[np.float64]
Indices = NDArray[np.int64]

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
    """

    name: str
    role: str
    parent: int
    position: Array
    frame: Array


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
        overlaps: whether it overlaps others of which this is said, too, in the built shape: they never touch.
    """

    body: int
    end: Array
    diameter: float
    density: float
    points: tuple[int, int]
    overlaps: bool = False


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
class Hinge:
    """A hinge by which a body turns against its parent, through the body's origin.

    Several hinges of one body follow each other: the first one turns the axes of the next. Angles are 0 in the built
    shape, and count in the hinge's own sense.

    Attributes:
        name: of its own.
        role: what it is called with others of its kind, in goals, groups and tables.
        body: number of the body that it turns.
        axis: unit vector in the axes of the body, (3,).
        sense: +1 or -1: an angle in the hinge's own sense is a right-handed turn about the axis times that.
        lower: where a stop ends its range, rad; -inf where none does.
        upper: alike; inf where none does.
        stiffness: of its spring, N m/rad.
        rest_angle: where its spring rests, rad.
        damping: N m s/rad.
        armature: inertia added to it, kg m^2.
        start: its angle at the start, rad.
        label: what tables and figures call it; its name if empty.
    """

    name: str
    role: str
    body: int
    axis: Array
    sense: int = 1
    lower: float = -math.inf
    upper: float = math.inf
    stiffness: float = 0.0
    rest_angle: float = 0.0
    damping: float = 0.0
    armature: float = 0.0
    start: float = 0.0
    label: str = ""


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
    """

    name: str
    bodies: Indices
    places: Array
    built: Array
    triangles: Indices
    law: MembraneLaw
    margin: float
    roots: Array | None = None


@dataclass(frozen=True, kw_only=True)
class Motor:
    """A torque on some hinges, the same on each, in their own senses.

    Attributes:
        name: of its own, as works and powers are called by.
        hinges: numbers of the hinges.
    """

    name: str
    hinges: tuple[int, ...]


@dataclass(frozen=True, kw_only=True)
class Drive:
    """Torques that a protocol switches on by name.

    Attributes:
        name: as stages call it.
        shares: by which `torque` is on the hinges of every motor of the structure, in their order.
        rise: time over which they rise evenly from 0, s; 0: at once.
        key: of the design's value that makes it stronger, such as "protocol.fold_torque".
        torque: that value, N m.
        tries: what a search for the least value tries where it is not told, as text.
        large: alike, what it takes to see whether the next transition works, as text.
        where: what it acts on, as sentences say it, such as "on every proximal joint".
        part: what each of its torques is on, as tables say it, such as "distal hinge"; empty where `where` is enough.
    """

    name: str
    shares: tuple[float, ...]
    rise: float
    key: str
    torque: float
    tries: str = ""
    large: str = ""
    where: str = ""
    part: str = ""

    @property
    def torques(self) -> tuple[float, ...]:
        """Of every motor of the structure, in their order, N m."""
        return tuple(share * self.torque for share in self.shares)


@dataclass(frozen=True, kw_only=True)
class Measure:
    """Angles or a distance that are watched by name.

    Attributes:
        name: of its own.
        kind: "angle" or "distance".
        hinges: numbers of the hinges of an angle.
        signs: by which the angles of these hinges, in their own senses, are multiplied.
        points: numbers of the two points of a distance.
        label: what tables and figures call it.
    """

    name: str
    kind: Literal["angle", "distance"]
    hinges: tuple[int, ...] = ()
    signs: tuple[int, ...] = ()
    points: tuple[int, int] | None = None
    label: str = ""


@dataclass(frozen=True, kw_only=True, eq=False)
class Goal:
    """What ends a stage: bounds on what is watched, rest, or neither, the time.

    Attributes:
        name: as stages call it.
        kind: "time", "rest" or "bounds".
        least: of every hinge's angle in its own sense, rad, and then of every distance that is measured, m,
            (coordinate,); -inf where there is none.
        most: alike; inf where there is none.
    """

    name: str
    kind: Literal["time", "rest", "bounds"]
    least: Array
    most: Array


@dataclass(frozen=True, kw_only=True, eq=False)
class RestState:
    """Where a protocol says that the structure rests.

    Attributes:
        name: such as "folded".
        bounds: within which it deserves the name.
        missed: what to call it otherwise, such as "not folded".
        unknown: what to call it where nothing is to be trusted, such as "after folding".
    """

    name: str
    bounds: Goal
    missed: str
    unknown: str


@dataclass(frozen=True, kw_only=True)
class Wording:
    """How sentences speak of a transition.

    Attributes:
        done: what it came to, such as "folded".
        verb: what it is to do, such as "fold" in "did not fold".
        doing: what goes on, such as "folding" in "still folding".
        stays: what is to last, such as "folded" in "did not stay folded".
        time: what its time is called, such as "fold time".
        noun: what it is called itself, such as "folding" in "work of folding".
        did: what it came to in a story of several, such as "opened again"; what it came to if empty.
        if_stuck: advice where it never began, in a sentence.
        if_under_way: advice where it stuck on the way.
        if_lost: advice where it was lost when released.
    """

    done: str
    verb: str
    doing: str
    stays: str
    time: str
    noun: str
    did: str = ""
    if_stuck: str = ""
    if_under_way: str = ""
    if_lost: str = ""

    @property
    def does(self) -> str:
        """What it does, such as "folds"."""
        first, *rest = self.verb.split(maxsplit=1)
        return " ".join([f"{first}s", *rest])


@dataclass(frozen=True, kw_only=True, eq=False)
class Transition:
    """A way to a named state: a drive, the goal that it is to reach, and what must be left of it when released.

    Attributes:
        name: of its own, such as "fold".
        drive: name of the drive.
        stage: number of the protocol's stage that drives it; None where the protocol has none.
        goal: name of the goal.
        state: name of the state that it leads to.
        released: the bounds that the state must keep where the stage was to reach the goal; where it was not, the
            state must keep its own.
        measure: name of the measure that tells how far it got.
        kind: of that measure.
        slow_drive: what statics lets grow in the drive's place, where that moves more than it must; None for the drive.
        furthest: which of the measure's readings is furthest from the goal.
        begun: reading beyond which it has begun for good; None where sentences do not tell how far it got.
        wording: for sentences.
    """

    name: str
    drive: str
    stage: int | None
    goal: str
    state: str
    released: Goal
    measure: str
    furthest: Literal["largest", "smallest"]
    begun: float | None
    wording: Wording
    kind: Literal["angle", "distance"] = "angle"
    slow_drive: Drive | None = None


@dataclass(frozen=True, kw_only=True)
class RigidFold:
    """The one way in which the panels fold if they are rigid, along the angle of their pleats.

    Hinges in `turns` turn by half the pleat angle. Those in `folds` fold to the negative of the ring angle,
    tan(ring / 2) = ratio tan(pleat / 2). All others go where the sheets between the panels are stretched least.

    Attributes:
        turns: numbers of hinges.
        folds: numbers of hinges.
        ratio: of the tangents; 0 where the ring stays straight until the pleats are closed.
        first: pleat angle at which the folds are at their upper stops, rad, negative; None where they never are.
        last: pleat angle at which a stop ends the fold, rad.
        base_length: length of the bars up to the folds, m.
        tip_length: length of the bars beyond them, m.
        tips: numbers of the points at the ends of these, one for each of `folds`.
        start: name of the state before it folds.
        end: name of the state at its end.
        remarks: sentences on what keeps the panels from it.
    """

    turns: tuple[int, ...]
    folds: tuple[int, ...]
    ratio: float
    first: float | None
    last: float
    base_length: float
    tip_length: float
    tips: tuple[int, ...]
    start: str
    end: str
    remarks: tuple[str, ...] = ()


@dataclass(frozen=True, kw_only=True, eq=False)
class Structure:
    """What is built: a tree of bodies on hinges, what spans it, what acts on it and what is watched.

    Attributes:
        name: of the design.
        bodies: parents before their children.
        points: on bodies.
        bars: of bodies.
        plates: of bodies.
        hinges: in the order of their bodies, and of one body in the order in which they turn it.
        tendons: pull-only springs.
        limits: unstressed length limits.
        membranes: elastic sheets, each of neighbouring bodies.
        motors: that drives set.
        drives: by name.
        measures: by name.
        goals: by name.
        states: by name.
        stage_states: names of the states that the stages of the protocol end in, "" where one ends in none, (stage,).
        transitions: in the order in which a protocol takes them.
        fold_path: how its panels fold if they are rigid; None where there is no such way, or several.
        span: a length of the size of the whole, m.
        mass: of the size of its bodies' mass, kg.
        contact: whether bars that touch push each other apart.
        gravity: acceleration along -z, m/s^2.
        appearance: what drawings and sentences need beside all that.
    """

    name: str
    bodies: tuple[Body, ...]
    points: tuple[Point, ...]
    bars: tuple[Bar, ...] = ()
    plates: tuple[Plate, ...] = ()
    hinges: tuple[Hinge, ...]
    tendons: tuple[Tendon, ...] = ()
    limits: tuple[LengthLimit, ...] = ()
    membranes: tuple[Membrane, ...] = ()
    motors: tuple[Motor, ...] = ()
    drives: tuple[Drive, ...] = ()
    measures: tuple[Measure, ...] = ()
    goals: tuple[Goal, ...] = ()
    states: tuple[RestState, ...] = ()
    stage_states: tuple[str, ...] = ()
    transitions: tuple[Transition, ...] = ()
    fold_path: RigidFold | None = None
    span: float
    mass: float
    contact: bool = False
    gravity: float = 0.0
    appearance: Appearance = field(default_factory=Appearance)

    @property
    def supports(self) -> tuple[int, ...]:
        """Numbers of the bodies that are held: those on the ground without a hinge."""
        hinged = {hinge.body for hinge in self.hinges}
        return tuple(
            number for number, body in enumerate(self.bodies) if body.parent == GROUND and number not in hinged
        )
