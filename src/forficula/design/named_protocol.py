"""A protocol by names, the same for every kind of design: drives, goals, states and the transitions between them."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Literal


@dataclass(frozen=True, kw_only=True)
class Action:
    """What a drive does to hinges or at places.

    Attributes:
        motor: name of the motor that does this and nothing else.
        kind: "torque" on hinges, "rest-angle" of creases, "force" at places or "displacement" of places.
        share: times which the strength of the drive acts on each hinge, in the hinge's own sense.
        hinges: names or roles of hinges.
        edges: numbers of the edges of the pattern that are creases.
        places: on a sheet, as text.
        to_targets: whether rest angles go on to the targets of their creases, all at once.
        direction: of a force or a displacement, of any length.
        no_load_speed: of a torque, speed of a hinge at which nothing is left of it, rad/s.
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
    """What a protocol switches on by name: torques, forces, ways or turns of rest angles.

    Attributes:
        name: as stages call it.
        actions: what it does, in proportion to its strength.
        shares: times which `strength` every motor of a structure is set to, in their order; () before it is built.
        rise: time over which they rise evenly from 0, s; 0: at once.
        key: of the design's value that makes it stronger, such as "protocol.fold_torque".
        strength: that value, in SI; of creases that go on to their targets, the way of the furthest.
        tries: what a search for the least value tries where it is not told, as text.
        where: what it acts on, as sentences say it, such as "on every proximal joint".
        part: what each of its torques is on, as tables say it, such as "distal hinge"; empty where `where` is enough.
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
        """What every motor of the structure is set to, in their order, in its SI unit."""
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
        verb: what it is to do, such as "fold" in "did not fold".
        doing: what goes on, such as "folding" in "still folding".
        stays: what is to last, such as "folded" in "did not stay folded".
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
    """What is done to a structure, and the names of where it rests.

    Attributes:
        drives: by name.
        goals: bounds as text, by the names that stages give them; "target" for the bounds around `targets`.
        states: by name.
        stage_states: names of the states that the stages end in, "" where one ends in none, (stage,).
        transitions: in the order in which the stages take them.
        targets: fold angles that creases are to reach, rad, valley positive, by the numbers of their edges.
        arrival: within which every crease must be of its target, rad.
    """

    drives: tuple[Drive, ...]
    goals: Mapping[str, str]
    states: tuple[RestState, ...]
    stage_states: tuple[str, ...]
    transitions: tuple[Transition, ...]
    targets: Mapping[int, float] = field(default_factory=dict)
    arrival: float = 0.0
