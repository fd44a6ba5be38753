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
    """A named state in which the protocol expects the structure to rest.

    Attributes:
        name: name of the state, such as "folded".
        goal: goal, by name or as text, that must hold for the state to have this name.
        missed: name of the state if the goal does not hold, such as "not folded".
        unknown: name of the state if the run is unreliable, such as "after folding".
    """

    name: str
    goal: str
    missed: str
    unknown: str


@dataclass(frozen=True, kw_only=True)
class Wording:
    """Words for a transition in sentences.

    Attributes:
        done: outcome, such as "folded".
        verb: verb, such as "fold" in "did not fold".
        doing: progressive form, such as "folding" in "still folding".
        stays: adjective of the state that must last, such as "folded" in "did not stay folded".
        time: name of the duration, such as "fold time".
        noun: name of the transition, such as "folding" in "work of folding".
        did: outcome in a sentence about several transitions, such as "opened again"; `done` if empty.
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
        """The verb in the third person, such as "folds"."""
        first, *rest = self.verb.split(maxsplit=1)
        return " ".join([f"{first}s", *rest])


@dataclass(frozen=True, kw_only=True)
class Transition:
    """A transition to a named state: a drive, the goal to be reached, and the goal that must hold after release.

    Attributes:
        name: name of the transition, such as "fold".
        drive: name of the drive.
        stage: number of the protocol's stage with the drive; None where the protocol has no such stage.
        goal: name of the goal, or its text.
        state: name of the state that the transition leads to.
        released: goal, by name or as text, that the released state must keep if the stage reached `goal`; otherwise
            the state must keep its own goal.
        measure: name of the measure that shows the progress.
        kind: kind of that measure.
        ends: number of the stage that ends at the goal; None for `stage`, whose drive acts until the goal is reached. A
            drive that acts for a given time is followed by stages without drives, and the first with a goal ends there.
        furthest: which of the measure's readings is furthest from the goal.
        begun: reading beyond which the transition has begun irreversibly; None where sentences do not report progress.
        wording: words for sentences.
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
    ends: int | None = None

    @property
    def goal_stage(self) -> int | None:
        """Number of the protocol's stage that ends at the goal; None where the protocol has no such stage."""
        return self.stage if self.ends is None else self.ends


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
