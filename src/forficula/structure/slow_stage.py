"""Quasi-static stage of a run: the request of dynamics to statics, and the equilibria that statics returns."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Literal

from forficula.arrays import Array
from forficula.structure.motors_and_measures import StageGoal
from forficula.structure.structure import Structure


@dataclass(frozen=True, kw_only=True, eq=False)
class RestShape:
    """Shape of a structure at rest.

    Attributes:
        angles: of all hinges in their own senses, rad, (hinge,).
        points: positions of the points, m, (point, 3).
        origins: of the bodies, m, (body, 3).
        frames: rotations from the bodies' axes to the ground's, (body, 3, 3).
        memory: of all hinges in their own senses, see `crease_memory`, SI, (slot, hinge); None if no hinge remembers
            anything.
    """

    angles: Array
    points: Array
    origins: Array
    frames: Array
    memory: Array | None = None


@dataclass(frozen=True, kw_only=True, eq=False)
class GrowingLoad:
    """Settings of the motors in a quasi-static stage: they change evenly with the share of the stage.

    Attributes:
        before: settings at the share 0, SI, (motor,).
        after: settings at the share 1, SI, (motor,).
        begin: share at which the path begins.
        goal: ends the path; a goal without bounds ends it at the share 1.
        built_on: positions of the points at the share 0, m, (point, 3), from which a motor displaces points.
        rest_speed: speed below which a hinge counts as at rest, rad/s.
        duration: time in which the share grows from 0 to 1, s.
    """

    before: Array
    after: Array
    begin: float
    goal: StageGoal
    built_on: Array
    rest_speed: float
    duration: float

    def settings(self, share: float) -> Array:
        """Return the settings of the motors at a share of the stage, SI, (motor,)."""
        return (1 - share) * self.before + share * self.after


@dataclass(frozen=True, kw_only=True, eq=False)
class RestPath:
    """Equilibria of a structure under a growing load.

    Attributes:
        share: of the stage, rising, (row,).
        shapes: at these shares.
        work: of the motors since the start, J, (row, motor).
        lost: energy that dampers dissipate while the structure creeps from the start to the first row, J.
        creases: energies that creases have dissipated since the start, J, (row,): by permanent folds ("yield"), by the
            dampers of Maxwell branches ("branch") and by wear ("damage"), without those that no crease can dissipate.
        forces: of motors that displace points, N; 0 for other motors, (row, motor).
        ended: "goal"; "full" at the share 1; "lost" if no stable equilibrium is near the last one at a larger share;
            "away" if no stable equilibrium is near the start, so that there are no rows.
    """

    share: Array
    shapes: tuple[RestShape, ...]
    work: Array
    lost: float
    creases: Mapping[str, Array]
    forces: Array
    ended: Literal["goal", "full", "lost", "away"]


# returns the equilibria of a structure from a shape on
RestSolver = Callable[[Structure, RestShape, GrowingLoad], RestPath]
