"""Snaps on a slow path that release more energy than is left to climb to the goal, so that inertia may decide."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from forficula.serial import Joules, NewtonMetres
from forficula.statics.tree.ensemble import Ensemble
from forficula.statics.tree.potential import potential
from forficula.statics.tree.quasi_static import TorquePath
from forficula.structure import Drive

# A snap within this share of the least torque does not change the least torque.
_SAME = 0.03


@dataclass(frozen=True, kw_only=True)
class InertialHelp:
    """A snap after which inertia may carry a structure to its goal, with less torque than a slow motion needs.

    Attributes:
        torque: size at which the structure snaps, N m.
        released: energy that the snap releases, J.
        barrier: energy from where the snap ends to the highest point of the slow path to the goal, both at this torque,
            J; another path can be lower.
    """

    torque: NewtonMetres
    released: Joules
    barrier: Joules


def inertial_help(structures: Ensemble, path: TorquePath, drive: Drive) -> InertialHelp | None:
    """Find the first snap of a path to a goal that releases more energy than the rest of the path has to climb.

    At the constant torque of the snap, the energy minus the torque's work is conserved except for damping. Without
    damping, a structure can therefore pass every rise up to the released energy. Whether it does depends on damping and
    on the direction of its motion, which only a simulation computes. Without such a snap, inertia can still find a
    lower path.

    Args:
        structures: only the first case is used.
        path: to the goal.
        drive: of the torque.

    Returns:
        None if no snap at a torque at least 3 % below the last one releases enough energy.
    """
    unit = np.array(drive.shares) * (-1.0 if drive.strength < 0 else 1.0)
    for begin, end in path.snaps:
        torque = float(path.torque[end])
        if torque > (1 - _SAME) * path.torque[-1]:
            return None
        on = path.position[begin:]
        energy = potential(structures.repeated(len(on)), on, torque * unit)[0]
        landing = energy[end - begin]
        released, barrier = float(energy[0] - landing), float(energy[end - begin :].max() - landing)
        if released > barrier:
            return InertialHelp(torque=torque, released=released, barrier=barrier)
    return None
