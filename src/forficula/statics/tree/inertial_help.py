"""Where inertia may decide: snaps on a slow path that release more energy than what is left to climb to the goal."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from forficula.serial import Joules, NewtonMetres
from forficula.statics.tree.potential import Ensemble, potential
from forficula.statics.tree.quasi_static import QuasiStaticPath
from forficula.structure import Drive

# A snap at a torque that differs less from the least one makes no difference to it.
_SAME = 0.03


@dataclass(frozen=True, kw_only=True)
class InertialHelp:
    """A snap after which inertia may take a structure to its goal, with less torque than a slow motion needs.

    Attributes:
        torque: size at which the structure snaps, N m.
        released: energy that the snap releases, J.
        barrier: energy from where the snap ends to the highest point of the slow path to the goal, both at this torque,
            J; another path can be lower.
    """

    torque: NewtonMetres
    released: Joules
    barrier: Joules


def inertial_help(structures: Ensemble, path: QuasiStaticPath, drive: Drive) -> InertialHelp | None:
    """Find the first snap of a path to a goal that releases more energy than the rest of the path has to climb.

    At the constant torque of the snap the energy less the torque's work is conserved but for damping. So a structure
    without damping can get over every rise up to what the snap released. Whether it does depends on damping and on the
    direction of its motion, which a simulation computes. Without such a snap, inertia can still find a lower path.

    Args:
        structures: of which the first case is taken.
        path: to the goal.
        drive: of the torque.

    Returns:
        None where no snap at a torque at least 3 % below the last one releases enough.
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
