"""The mechanical model of a design, which statics, dynamics and drawings share.

It does not depend on an engine, nor on the kind of design from which a structure was built.
"""

from __future__ import annotations

from dataclasses import dataclass, field

from forficula.design import Imperfection
from forficula.design.named_protocol import Drive, RestState, Transition
from forficula.structure.appearance import Appearance, BodyGroup
from forficula.structure.membranes import Membrane
from forficula.structure.motors_and_measures import Measure, Motor, RigidFold, StageGoal
from forficula.structure.parts import (
    Bar,
    Body,
    Closure,
    Coupling,
    Facet,
    Hinge,
    LengthLimit,
    Mechanism,
    Plate,
    Point,
    PointMass,
    Spring,
    Tendon,
)
from forficula.structure.surroundings import Contact, Hold, Medium, Stops, Table


@dataclass(frozen=True, kw_only=True, eq=False)
class Structure:
    """A structure: a tree of bodies with hinges, elastic elements between them, drives and measures.

    Attributes:
        name: name of the design.
        bodies: bodies, parents before their children.
        points: points on bodies.
        bars: bars of bodies.
        plates: plates of bodies.
        masses: point masses that bodies carry in addition to bars and plates.
        facets: polygons between points of any bodies.
        hinges: joints in the order of their bodies, several of one body in the order in which they turn it; then
            creases.
        couplings: couplings between joints.
        closures: creases that close loops of bodies.
        holds: supports of points of plates.
        springs: elastic bars.
        tendons: pull-only springs.
        limits: unstressed length limits.
        membranes: elastic sheets between neighbouring bodies.
        motors: motors, which drives set.
        drives: drives that stages switch on.
        measures: angles and distances that are recorded.
        goals: named goals.
        states: named states.
        stage_states: name of the state in which each stage of the protocol ends, "" for none, (stage,).
        transitions: transitions in the order of the protocol.
        rigid_fold: fold of the structure with rigid panels; None if it has no such fold, or several.
        remarks: sentences on results that do not exist for this structure, with the reason.
        medium: medium around the structure; None for a vacuum.
        span: characteristic length of the whole structure, m.
        mass: characteristic mass of the bodies, kg.
        strength: stress that the material of the facets withstands, Pa; None if it is not known.
        imperfection: random deviation from the drawing with which it is built; None without one.
        stops: compliance of the stops of joints and of length limits.
        contact: contact between bodies; None if bodies pass through each other.
        table: plane that no part passes through; None without a table.
        gravity: acceleration along `down`, m/s^2.
        down: unit vector along gravity.
        mechanisms: groups of elements that store energy, each element in one group; if empty, elements are grouped by
            kind. See `mechanisms_of`.
        groups: groups of bodies that drawings distinguish by colour; with fewer than two, colours depend on roles.
        appearance: words, sizes and pattern for drawings and sentences.
    """

    name: str
    bodies: tuple[Body, ...]
    points: tuple[Point, ...]
    bars: tuple[Bar, ...] = ()
    plates: tuple[Plate, ...] = ()
    masses: tuple[PointMass, ...] = ()
    facets: tuple[Facet, ...] = ()
    hinges: tuple[Hinge, ...]
    couplings: tuple[Coupling, ...] = ()
    closures: tuple[Closure, ...] = ()
    holds: tuple[Hold, ...] = ()
    springs: tuple[Spring, ...] = ()
    tendons: tuple[Tendon, ...] = ()
    limits: tuple[LengthLimit, ...] = ()
    membranes: tuple[Membrane, ...] = ()
    motors: tuple[Motor, ...] = ()
    drives: tuple[Drive, ...] = ()
    measures: tuple[Measure, ...] = ()
    goals: tuple[StageGoal, ...] = ()
    states: tuple[RestState, ...] = ()
    stage_states: tuple[str, ...] = ()
    transitions: tuple[Transition, ...] = ()
    rigid_fold: RigidFold | None = None
    remarks: tuple[str, ...] = ()
    medium: Medium | None = None
    span: float
    mass: float
    strength: float | None = None
    imperfection: Imperfection | None = None
    stops: Stops = field(default_factory=lambda: Stops(time_constant=2e-3))
    contact: Contact | None = None
    table: Table | None = None
    gravity: float = 0.0
    down: tuple[float, float, float] = (0.0, 0.0, -1.0)
    mechanisms: tuple[Mechanism, ...] = ()
    groups: tuple[BodyGroup, ...] = ()
    appearance: Appearance = field(default_factory=Appearance)

    @property
    def has_contacts(self) -> bool:
        """Whether bodies touch each other or a table."""
        return self.contact is not None or self.table is not None

    def __repr__(self) -> str:
        """Name and number of parts."""
        counts = {"bodies": self.bodies, "hinges": self.hinges, "tendons": self.tendons, "membranes": self.membranes}
        parts = ", ".join(f"{len(every)} {name}" for name, every in counts.items() if every)
        return f"<Structure {self.name}: {parts}>"
