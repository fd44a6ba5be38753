"""What statics, dynamics and drawings share of a design: what is built, what acts on it and what is watched.

It knows no engine, and nothing here asks in which way a structure was built.
"""

from __future__ import annotations

from dataclasses import dataclass, field

from forficula.design import Imperfection
from forficula.design.named_protocol import Drive, RestState, Transition
from forficula.structure.appearance import Appearance
from forficula.structure.course import Measure, Motor, RigidFold, StageGoal
from forficula.structure.parts import (
    Bar,
    Body,
    Closure,
    Contact,
    Coupling,
    Facet,
    Hinge,
    LengthLimit,
    Medium,
    Membrane,
    Plate,
    Point,
    PointMass,
    Spring,
    Stops,
    Tendon,
)


@dataclass(frozen=True, kw_only=True, eq=False)
class Structure:
    """What is built: a tree of bodies on hinges, what spans it, what acts on it and what is watched.

    Attributes:
        name: of the design.
        bodies: parents before their children.
        points: on bodies.
        bars: of bodies.
        plates: of bodies.
        masses: that bodies carry beside those.
        facets: between points of any bodies.
        hinges: joints in the order of their bodies, and of one body in the order in which they turn it; then creases.
        couplings: that tie joints to each other.
        closures: creases that close loops of bodies.
        springs: elastic bars.
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
        rigid_fold: how its panels fold if they are rigid; None where there is no such way, or several.
        remarks: sentences on what there is not of it, and why.
        medium: that surrounds it; None for empty space.
        span: a length of the size of the whole, m.
        mass: of the size of its bodies' mass, kg.
        strength: stress that the material of its facets withstands, Pa; None where it is not told.
        imperfection: by which it is built beside its drawing; None where it is not.
        stops: compliance of the stops of its joints and of its length limits.
        contact: how what touches is pushed apart; None where everything passes through everything.
        gravity: acceleration along -z, m/s^2.
        appearance: what drawings and sentences need beside all that.
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
    gravity: float = 0.0
    appearance: Appearance = field(default_factory=Appearance)

    def __repr__(self) -> str:
        """Name and number of parts."""
        counts = {"bodies": self.bodies, "hinges": self.hinges, "tendons": self.tendons, "membranes": self.membranes}
        parts = ", ".join(f"{len(every)} {name}" for name, every in counts.items() if every)
        return f"<Structure {self.name}: {parts}>"
