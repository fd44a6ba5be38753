"""What is done with a structure, by name: motors, measures, goals, and its own fold."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Literal

from forficula.arrays import Array


@dataclass(frozen=True, kw_only=True, eq=False)
class Motor:
    """What a drive sets: torque on hinges, force at points, how far they go, or by how much springs rest further on.

    Attributes:
        name: of its own, as works and powers are called by.
        kind: "torque": on each hinge in its own sense, N m; "rest-angle": by which the rest angle of each crease goes
            on in its own sense, rad; "force": at each point, N; "displacement": of each point, m, from where it is when
            the drive begins.
        hinges: numbers of the hinges.
        gains: of each hinge, by which what is set counts there; empty where it counts once.
        points: numbers of the points.
        direction: of a force or a displacement, unit vector in the axes of the ground, (3,); None of what acts on
            hinges.
        stiffness: of the servo that displaces a point, N/m.
        damping: of the servo of each point, N s/m.
        no_load_speed: of a torque, speed of a hinge along it at which nothing is left of it, in proportion, rad/s; inf
            where it does not mind speeds.
    """

    name: str
    kind: Literal["torque", "rest-angle", "force", "displacement"] = "torque"
    hinges: tuple[int, ...] = ()
    gains: tuple[float, ...] = ()
    points: tuple[int, ...] = ()
    direction: Array | None = None
    stiffness: float = 0.0
    damping: tuple[float, ...] = ()
    no_load_speed: float = math.inf


@dataclass(frozen=True, kw_only=True)
class Measure:
    """Angles or a distance that are watched by name.

    Attributes:
        name: of its own.
        kind: "angle" or "distance".
        hinges: numbers of the hinges of an angle.
        signs: by which the angles of these hinges, in their own senses, are multiplied.
        together: so many of them, one after another, are one reading: the sum of what they would read each.
        points: numbers of the two points of a distance.
        label: what tables and figures call it.
    """

    name: str
    kind: Literal["angle", "distance"]
    hinges: tuple[int, ...] = ()
    signs: tuple[int, ...] = ()
    together: int = 1
    points: tuple[int, int] | None = None
    label: str = ""

    @property
    def parts(self) -> tuple[tuple[int, ...], ...]:
        """Numbers of the hinges of every reading of an angle."""
        return tuple(self.hinges[first : first + self.together] for first in range(0, len(self.hinges), self.together))


@dataclass(frozen=True, kw_only=True, eq=False)
class StageGoal:
    """What ends a stage: bounds on what is watched, rest, or neither, the time.

    Attributes:
        name: as stages call it.
        kind: "time", "rest" or "bounds".
        least: of every hinge's angle in its own sense, rad, then of every distance that is measured, m, and of every
            reading that is the sum of angles, rad, (coordinate,); -inf where there is none. See `goal_coordinates`.
        most: alike; inf where there is none.
    """

    name: str
    kind: Literal["time", "rest", "bounds"]
    least: Array
    most: Array


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
