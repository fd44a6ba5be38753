"""Motors, measures and goals of a structure by name, and its rigid fold."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Literal

from forficula.arrays import Array


@dataclass(frozen=True, kw_only=True, eq=False)
class Motor:
    """A torque on hinges, a force at points, a displacement of points or a change of rest angles, set by drives.

    Attributes:
        name: name of the motor, also of its work and power.
        kind: "torque" on each hinge in its own sense, N m; "rest-angle": change of the rest angle of each crease in its
            own sense, rad; "force" at each point, N; "displacement" of each point, m, from its position when the drive
            begins.
        hinges: numbers of the hinges.
        gains: factor of the setting for each hinge; empty if all are 1.
        points: numbers of the points.
        direction: direction of a force or a displacement, unit vector in the axes of the ground, (3,); None for hinges.
        stiffness: stiffness of the servo that displaces a point, N/m.
        damping: damping of the servo of each point, N s/m.
        no_load_speed: speed of a hinge at which a torque has fallen linearly to 0, rad/s; inf for a constant torque.
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
    """Angles, or a distance, that are recorded under one name.

    Attributes:
        name: name of the measure.
        kind: "angle" or "distance".
        hinges: numbers of the hinges of an angle.
        signs: factors, 1 or -1, of the angles of these hinges in their own senses.
        together: number of consecutive hinges whose angles are added to one reading.
        points: numbers of the two points of a distance.
        label: name in tables and figures.
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
        """Numbers of the hinges in each reading of an angle."""
        return tuple(self.hinges[first : first + self.together] for first in range(0, len(self.hinges), self.together))


@dataclass(frozen=True, kw_only=True, eq=False)
class StageGoal:
    """The goal that ends a stage: bounds on coordinates, rest, or a time.

    Attributes:
        name: name of the goal in stages.
        kind: "time", "rest" or "bounds".
        least: lower bounds on the angle of every hinge in its own sense, rad, then on every measured distance, m, and
            on every reading that is a sum of angles, rad, (coordinate,); -inf without a bound. See `goal_coordinates`.
        most: upper bounds on the same coordinates; inf without a bound.
    """

    name: str
    kind: Literal["time", "rest", "bounds"]
    least: Array
    most: Array


@dataclass(frozen=True, kw_only=True)
class RigidFold:
    """The fold of a structure with rigid panels, which has one degree of freedom, the pleat angle.

    Hinges in `turns` turn by half the pleat angle. Those in `folds` fold to the negative of the ring angle, with
    tan(ring / 2) = ratio tan(pleat / 2). The other hinges minimise the stretching of the membrane between the panels.

    Attributes:
        turns: numbers of the hinges that turn with the pleats.
        folds: numbers of the hinges that fold with the ring.
        ratio: ratio of the tangents; 0 if the ring is straight until the pleats are closed.
        first: pleat angle, rad, negative, at which the folds reach their upper stops; None if they never do.
        last: pleat angle at which a stop ends the fold, rad.
        base_length: length of the bars up to the folds, m.
        tip_length: length of the bars beyond the folds, m.
        tips: numbers of the points at the outer ends of these bars, one for each hinge of `folds`.
        start: name of the state before the fold.
        end: name of the state at the end of the fold.
        remarks: sentences on limits of the rigid fold.
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
