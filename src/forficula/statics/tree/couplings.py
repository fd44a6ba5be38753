"""Couplings between joints in statics: energy of elastic couplings, and coordinates that rigid couplings leave free."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from forficula.arrays import Array, Indices
from forficula.errors import InputError
from forficula.statics.tree.elements import Expansion
from forficula.structure import Coupling, Structure, coupling_rows, joint_count

_ROUNDING = 1e-9  # relative tolerance of a coupling's ratio


@dataclass(frozen=True, kw_only=True)
class Twists:
    """Elastic couplings.

    Attributes:
        rows: twist of each coupling per angle of each hinge, (coupling, hinge).
        built: angles at which no coupling is twisted, rad, (hinge,).
        stiffness: N m/rad, (coupling,).
    """

    rows: Array
    built: Array
    stiffness: Array


@dataclass(frozen=True, kw_only=True)
class Ties:
    """Groups of joints that rigid couplings tie together; the coordinate of a group is the angle of its first joint.

    Attributes:
        coordinate: number of the coordinate that each hinge follows, (hinge,).
        ratio: turn of each hinge per turn of its coordinate, (hinge,).
        shift: angle of each hinge at a coordinate of 0, rad, (hinge,).
    """

    coordinate: Indices
    ratio: Array
    shift: Array

    @property
    def spread(self) -> Array:
        """Return the turn of each hinge per turn of each coordinate, (hinge, coordinate)."""
        return np.asarray(np.eye(int(self.coordinate.max()) + 1)[self.coordinate] * self.ratio[:, None])

    def angles(self, coordinates: Array) -> Array:
        """Return the angles of the hinges, rad, (case, hinge), for coordinates, (case, coordinate)."""
        return np.asarray(coordinates[:, self.coordinate] * self.ratio + self.shift)

    def bounds(self, lower: Array, upper: Array) -> tuple[Array, Array]:
        """Return least and largest coordinates with all hinges within their bounds, (case, coordinate).

        If the bounds of two tied hinges contradict each other, the coordinate is fixed at their mean.
        """
        ends = [(bound - self.shift) / self.ratio for bound in (lower, upper)]
        low, high = np.minimum(*ends), np.maximum(*ends)
        count = int(self.coordinate.max()) + 1
        least, most = np.full((len(lower), count), -np.inf), np.full((len(lower), count), np.inf)
        for hinge, coordinate in enumerate(self.coordinate.tolist()):
            least[:, coordinate] = np.maximum(least[:, coordinate], low[:, hinge])
            most[:, coordinate] = np.minimum(most[:, coordinate], high[:, hinge])
        apart = least > most
        least[apart] = most[apart] = (least[apart] + most[apart]) / 2
        return least, most

    def start(self, angles: Array) -> Array:
        """Return the coordinates nearest to some angles: the mean over the hinges of each, (case, coordinate)."""
        sums = ((angles - self.shift) / self.ratio) @ (self.spread != 0)
        return np.asarray(sums / np.bincount(self.coordinate))


def twists_of(structure: Structure) -> Twists | None:
    """Return the elastic couplings of a structure; None if there are none."""
    elastic = [number for number, coupling in enumerate(structure.couplings) if not coupling.rigid]
    if not elastic:
        return None
    joints = _coupled_joints(structure)
    return Twists(
        rows=coupling_rows(structure)[elastic, :joints],
        built=np.array([joint.built for joint in structure.hinges[:joints]]),
        stiffness=np.array([structure.couplings[number].stiffness for number in elastic]),
    )


def _coupled_joints(structure: Structure) -> int:
    """Return the number of joints.

    Raises:
        InputError: a coupling acts on a crease between flaps.
    """
    joints = joint_count(structure)
    for coupling in structure.couplings:
        for number in coupling.hinges:
            if number >= joints:
                name = structure.hinges[number].name
                raise InputError(f"{coupling.name}: need couplings between joints, got the crease {name}, which opens")
    return joints


def twist_energy(twists: Twists, angles: Array) -> Expansion:
    """Compute the energy of elastic couplings, J, (case,), its gradient and Hessian by angles, rad, (case, hinge)."""
    turned = (angles - twists.built) @ twists.rows.T
    moments = twists.stiffness * turned
    curvature = twists.rows.T @ (twists.stiffness[:, None] * twists.rows)
    return np.sum(moments * turned, axis=1) / 2, moments @ twists.rows, np.tile(curvature, (len(angles), 1, 1))


def ties_of(structure: Structure) -> Ties | None:
    """Return the groups of joints that rigid couplings tie together; None if there are none.

    Raises:
        InputError: couplings tie two joints to each other with contradictory ratios.
    """
    rigid = [coupling for coupling in structure.couplings if coupling.rigid]
    if not rigid:
        return None
    built = np.array([joint.built for joint in structure.hinges[: _coupled_joints(structure)]])
    leader, ratio = np.arange(len(built)), np.ones(len(built))
    for coupling in rigid:
        first, second = coupling.hinges
        if leader[first] == leader[second]:
            _check_loop(structure, coupling, float(ratio[second] / ratio[first]))
            continue
        joined, target = leader == leader[second], leader[first]
        ratio[joined] *= coupling.ratio * ratio[first] / ratio[second]
        leader[joined] = target
    leaders, coordinate = np.unique(leader, return_inverse=True)
    led = leaders[coordinate]
    return Ties(coordinate=coordinate.astype(np.int64), ratio=ratio, shift=built - ratio * built[led])


def _check_loop(structure: Structure, coupling: Coupling, ratio: float) -> None:
    if abs(ratio - coupling.ratio) > _ROUNDING * abs(ratio):
        names = " and ".join(structure.hinges[number].name for number in coupling.hinges)
        raise InputError(
            f"{structure.name}: need couplings that let joints turn, got {names} tied with the ratios"
            f" {ratio:g} and {coupling.ratio:g}"
        )
