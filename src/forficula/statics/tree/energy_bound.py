"""Lower bounds of the energy barrier around a region of hinge angles, which a structure cannot leave with less energy.

Derivation: docs/model/reliability.md, section When a repetition ends early.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from forficula.arrays import Array, Flags
from forficula.statics.tree.hinge import hinges_in_own_senses
from forficula.structure import Hinge, StageGoal, Structure

# [chosen] share of the barrier that the energy must not exceed, because a run conserves energy only approximately
_SHARE = 0.9
# [chosen] angle by which stops may yield, rad
_YIELDING = math.radians(10.0)
# width of the intervals in which energies are bounded, rad
_WIDTH = math.radians(0.1)


@dataclass(frozen=True, kw_only=True)
class _HingeEnergy:
    """Energy of the elements that depend on the angle of one hinge alone, on a grid of angles.

    Attributes:
        angles: rad, rising, (angle,).
        energy: J, at these angles, (angle,).
        floor: lower bound between neighbouring angles, J, (angle - 1,).
    """

    angles: Array
    energy: Array
    floor: Array

    def least(self, lower: float, upper: float) -> float:
        """Return a lower bound of the energy between two angles, J."""
        first = int(np.clip(np.searchsorted(self.angles, lower, "right") - 1, 0, len(self.floor) - 1))
        last = int(np.clip(np.searchsorted(self.angles, upper), first + 1, len(self.floor)))
        return float(self.floor[first:last].min())

    def at(self, angle: float) -> float:
        """Return a lower bound of the energy at an angle, J."""
        return self.least(angle, angle)

    def highest(self, start: float, end: float) -> float:
        """Return the angle between two others at which the energy is largest, rad."""
        inside = (self.angles >= min(start, end)) & (self.angles <= max(start, end))
        return float(self.angles[inside][np.argmax(self.energy[inside])]) if inside.any() else end


@dataclass(frozen=True, kw_only=True)
class EnergyBound:
    """Energy of a structure under constant torques, bounded from below by the sum of the energies of its hinges.

    Attributes:
        structure: the structure, see `has_bound`.
        torques: torque on each hinge in its own sense, N m, (hinge,).
    """

    structure: Structure
    torques: Array

    @cached_property
    def _stops(self) -> Array:
        """Return the angles of the lower and upper stops, rad, (end, hinge)."""
        return np.array([[getattr(hinge, end) for hinge in self.structure.hinges] for end in ("lower", "upper")])

    @cached_property
    def _hinges(self) -> dict[int, _HingeEnergy]:
        """Return the energies of hinges with tendons, springs or torques, by number."""
        return {
            number: hinge for number in range(len(self.structure.hinges)) if (hinge := self._hinge(number)) is not None
        }

    def _hinge(self, number: int) -> _HingeEnergy | None:
        hinge, torque = self.structure.hinges[number], float(self.torques[number])
        crossed = [tendon for tendon in self.structure.tendons if tendon.crossing is not None]
        tendons = [
            turned
            for tendon, turned in zip(crossed, hinges_in_own_senses(self.structure), strict=True)
            if tendon.crossing is not None and tendon.crossing.hinge == number and tendon.law.yield_extension is None
        ]
        if not (tendons or hinge.stiffness or torque):
            return None
        low, high = _range(hinge)
        # the energy of a tendon rises or falls between the angles at which the tendon is longest or shortest
        turns = [half * math.pi - turned.offset_angle for turned in tendons for half in range(-3, 4)]
        angles = np.linspace(low, high, math.ceil((high - low) / _WIDTH) + 1)
        angles = np.union1d(angles, [angle for angle in (*turns, hinge.rest_angle) if low < angle < high])
        parts: list[Array] = [-torque * angles, hinge.stiffness / 2 * (angles - hinge.rest_angle) ** 2]
        parts += [turned.energy(angles) for turned in tendons]
        floor: Array = np.sum([np.minimum(part[:-1], part[1:]) for part in parts], axis=0)
        return _HingeEnergy(angles=angles, energy=np.sum(parts, axis=0), floor=floor)

    def holds_in(self, lower: Array, upper: Array, angles: Array, energy: float) -> bool:
        """Return whether a structure cannot leave a region because its energy is too small.

        Args:
            lower: least angles in the region, rad, (hinge,); -inf for hinges that are not bounded.
            upper: largest angles, as `lower`.
            angles: present angles, rad, (hinge,).
            energy: present energy of motion and of all elements, J, without the potential of the torques.

        Returns:
            Whether this is certain; False as long as a hinge is beyond its stop.
        """
        # a hinge beyond its stop may receive energy from the stop
        beyond = (angles < self._stops[0] - _WIDTH) | (angles > self._stops[1] + _WIDTH)
        if beyond.any() or not np.all((angles > lower) & (angles < upper)):
            return False
        parts = {
            number: hinge.least(float(lower[number]), float(upper[number])) for number, hinge in self._hinges.items()
        }
        floor = sum(parts.values())
        rims = [
            floor - parts[number] + hinge.at(edge) if (hinge := self._hinges.get(number)) is not None else floor
            for number in np.flatnonzero(np.isfinite(lower) | np.isfinite(upper)).tolist()
            for edge in _edges(self.structure.hinges[number], float(lower[number]), float(upper[number]))
        ]
        if not rims:
            return False
        return bool(energy - self.torques @ angles - floor < _SHARE * (min(rims) - floor))

    def keeps(self, goal: StageGoal, angles: Array, energy: float) -> bool:
        """Return whether a structure at a goal cannot leave the goal; see `holds_in`."""
        return self.holds_in(*_bounds(goal, len(angles)), angles, energy)

    def misses(self, goal: StageGoal, angles: Array, energy: float) -> bool:
        """Return whether a structure short of a goal cannot reach the goal; see `holds_in`.

        Each hinge short of the goal must pass the angle on its way at which its own energy is largest.
        """
        least, most = _bounds(goal, len(angles))
        lower, upper = np.full(len(angles), -np.inf), np.full(len(angles), np.inf)
        for number in np.flatnonzero((angles < least) | (angles > most)).tolist():
            end = float(least[number] if angles[number] < least[number] else most[number])
            hinge = self._hinges.get(number)
            edge = end if hinge is None else hinge.highest(float(angles[number]), end)
            (upper if end > angles[number] else lower)[number] = edge
        return self.holds_in(lower, upper, angles, energy)


def has_bound(structure: Structure, torques: Array) -> bool:
    """Return whether energies of hinges bound the energy of a structure from below, and its energy only decreases.

    Weight, flow, contact and closures of loops can add energy, and the barrier of an element that yields or wears
    decreases. Dry friction only takes energy. The energy of springs with other moments is not computed here.
    Hinges with torques need stops, because the potential of a torque is otherwise not bounded.
    """
    loaded = zip(structure.hinges, torques.tolist(), strict=True)
    return not (
        np.any(structure.gravity)
        or structure.medium is not None
        or structure.has_contacts
        or structure.closures
        or structure.holds
        or any(
            hinge.flaps is not None
            or hinge.remembers
            or math.isfinite(hinge.yield_angle)
            or hinge.quadratic
            or hinge.cubic
            for hinge in structure.hinges
        )
        or any(not math.isfinite(hinge.upper - hinge.lower) for hinge, torque in loaded if torque)
    )


def torques_of(structure: Structure, strengths: Array) -> Array | None:
    """Return the torque of motors with these settings on each hinge, N m, (hinge,); None for other loads."""
    torques = np.zeros(len(structure.hinges))
    for motor, strength in zip(structure.motors, strengths.tolist(), strict=True):
        if not strength:
            continue
        if motor.kind != "torque" or math.isfinite(motor.no_load_speed):
            return None
        for hinge, gain in zip(motor.hinges, motor.gains or (1.0,) * len(motor.hinges), strict=True):
            torques[hinge] += gain * strength
    return torques


def bounds_hinges_only(goal: StageGoal, hinges: int) -> bool:
    """Return whether a goal consists of bounds on the angles of hinges alone."""
    others: Flags = np.isfinite(goal.least[hinges:]) | np.isfinite(goal.most[hinges:])
    return goal.kind == "bounds" and not others.any()


def _bounds(goal: StageGoal, hinges: int) -> tuple[Array, Array]:
    return np.asarray(goal.least[:hinges]), np.asarray(goal.most[:hinges])


def _edges(hinge: Hinge, lower: float, upper: float) -> list[float]:
    """Return the angles of a hinge at the edge of a region that it can reach."""
    low, high = _range(hinge)
    return [edge for edge in (lower, upper) if low < edge < high]


def _range(hinge: Hinge) -> tuple[float, float]:
    """Return the angles that a hinge can reach, rad; without stops, two turns."""
    return max(hinge.lower - _YIELDING, -2 * math.pi), min(hinge.upper + _YIELDING, 2 * math.pi)
