"""A protocol by names, the same for every kind of design: drives, goals, states and the transitions between them."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Literal


@dataclass(frozen=True, kw_only=True)
class Action:
    """Effect of a drive on hinges or points, in proportion to the strength of the drive.

    Attributes:
        motor: name of the motor that has exactly this effect.
        kind: "torque" on hinges, "rest-angle" of creases, "force" at places or "displacement" of places.
        share: factor of the strength on each hinge, in the hinge's own sense.
        hinges: names or roles of the hinges of a torque.
        edges: edge numbers of the creases of a torque or a rest angle.
        places: places on the sheet, as text, of a force or a displacement.
        to_targets: whether the rest angle of every crease changes to the target of the crease.
        direction: direction of a force or a displacement, of any length.
        no_load_speed: speed of a hinge at which a torque has fallen to 0, rad/s.
    """

    motor: str
    kind: Literal["torque", "rest-angle", "force", "displacement"] = "torque"
    share: float = 1.0
    hinges: tuple[str, ...] = ()
    edges: tuple[int, ...] = ()
    places: tuple[str, ...] = ()
    to_targets: bool = False
    direction: tuple[float, float, float] | None = None
    no_load_speed: float = math.inf


@dataclass(frozen=True, kw_only=True)
class Drive:
    """Torques, forces, displacements or changes of rest angles that stages switch on together by one name.

    Attributes:
        name: name in the stages.
        actions: effects of the drive.
        shares: factors of `strength` for every motor of a structure, in their order; empty before it is built.
        rise: time over which the drive grows evenly from 0, s; 0: at once.
        key: key of the design that sets the strength, such as "protocol.fold_torque".
        strength: value of that key in SI; with `to_targets` the largest change of a rest angle.
        tries: values that a search for the least strength tries by default, as text.
        where: phrase for what the drive acts on, such as "on every proximal joint".
        part: phrase of tables for what each torque is on, such as "distal hinge"; empty where `where` is enough.
    """

    name: str
    actions: tuple[Action, ...] = ()
    shares: tuple[float, ...] = ()
    rise: float
    key: str
    strength: float
    tries: str = ""
    where: str = ""
    part: str = ""

    @property
    def strengths(self) -> tuple[float, ...]:
        """Setting of every motor of the structure, in their order, in the motor's SI unit."""
        return tuple(share * self.strength for share in self.shares)


@dataclass(frozen=True, kw_only=True)
class RestState:
    """Where a protocol says that the structure rests.

    Attributes:
        name: such as "folded".
        goal: within which it deserves the name: a goal by name, or as text.
        missed: what to call it otherwise, such as "not folded".
        unknown: what to call it where nothing is to be trusted, such as "after folding".
    """

    name: str
    goal: str
    missed: str
    unknown: str


@dataclass(frozen=True, kw_only=True)
class Wording:
    """How sentences speak of a transition.

    Attributes:
        done: what it came to, such as "folded".
        verb: such as "fold" in "did not fold".
        doing: what goes on, such as "folding" in "still folding".
        stays: state that must last, such as "folded" in "did not stay folded".
        time: what its time is called, such as "fold time".
        noun: what it is called itself, such as "folding" in "work of folding".
        did: what it came to in a story of several, such as "opened again"; what it came to if empty.
    """

    done: str
    verb: str
    doing: str
    stays: str
    time: str
    noun: str
    did: str = ""

    @property
    def does(self) -> str:
        """What it does, such as "folds"."""
        first, *rest = self.verb.split(maxsplit=1)
        return " ".join([f"{first}s", *rest])


@dataclass(frozen=True, kw_only=True)
class Transition:
    """A way to a named state: a drive, the goal that it is to reach, and what must be left of it when released.

    Attributes:
        name: of its own, such as "fold".
        drive: name of the drive.
        stage: number of the protocol's stage that drives it; None where the protocol has none.
        goal: name of the goal, or its text.
        state: name of the state that it leads to.
        released: the goal, by name or as text, that the state must keep where the stage was to reach the other one;
            where it was not, the state must keep its own.
        measure: name of the measure that tells how far it got.
        kind: of that measure.
        furthest: which of the measure's readings is furthest from the goal.
        begun: reading beyond which it has begun for good; None where sentences do not tell how far it got.
        wording: for sentences.
    """

    name: str
    drive: str
    stage: int | None
    goal: str
    state: str
    released: str
    measure: str
    furthest: Literal["largest", "smallest"]
    begun: float | None
    wording: Wording
    kind: Literal["angle", "distance"] = "angle"


@dataclass(frozen=True, kw_only=True)
class NamedProtocol:
    """Protocol of a design as data without a structure.

    Attributes:
        drives: all drives.
        goals: bounds as text by the names that stages use; "target" stands for bounds around `targets`.
        states: all named states.
        stage_states: name of the state at the end of every stage, "" where the end has no name, (stage,).
        transitions: transitions in the order of their stages.
        targets: fold angles that creases are to reach, rad, positive for a valley, by edge number.
        arrival: largest deviation of a crease from its target, rad, with which the goal "target" is reached.
    """

    drives: tuple[Drive, ...]
    goals: Mapping[str, str]
    states: tuple[RestState, ...]
    stage_states: tuple[str, ...]
    transitions: tuple[Transition, ...]
    targets: Mapping[int, float] = field(default_factory=dict)
    arrival: float = 0.0
