"""Partial folds: states with only some hinges folded, their stability and their energies."""

from __future__ import annotations

import itertools
import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Annotated

import numpy as np

from forficula.arrays import Array, Flags
from forficula.quantities import Unit
from forficula.serial import Joules, Key
from forficula.statics.tree.ensemble import Ensemble, sheet_torque, slight_energy
from forficula.statics.tree.hinge import folding_sense, ideal_hinges, tendon_hinge, tendon_hinges
from forficula.statics.tree.lines import largest_pull
from forficula.statics.tree.potential import potential, rest
from forficula.statics.tree.sheet import sheet_energy
from forficula.structure import Structure, hinges_between

# largest number of hinges for which every combination is tried; more hinges are folded only one after another
_EVERY_COMBINATION = 5
# angle past straight at which a hinge starts, so that its tendon pulls it on as far as neighbours and limits allow
_START = math.radians(30)
_POSITIONS = 45  # positions on the path of one hinge, including straight
_FINE = 721  # number of angles in the search for the maximum of one hinge
_ROUNDING = 1e-6  # of the stiffness of the stiffest part


@dataclass(frozen=True, kw_only=True)
class PartialFold:
    """State of a structure after release with some hinges folded and the others in the overbend.

    The folding hinges of `folding_hinges` are numbered from 0.

    Attributes:
        folded: hinges that start folded.
        stable: whether every hinge stays on the side of straight on which it starts, and no small push drives it away.
        stays_folded: hinges that end folded.
        angles: final angle of each folding hinge, in its own sense, rad, (folding hinge,).
        tendon_energy: final energy of all tendons, springs and weights, J.
        sheet_energy: final energy of membranes and length limits, J.
        independent_energy: energy of the same number of uncoupled hinges, folded ones at their limits and the others at
            their overbend stops, J, of ideal hinges if there are any; None if springs hold hinges elsewhere, if there
            are no tendons, or if a tendon lies across several hinges or across one that does not fold.
    """

    folded: tuple[int, ...]
    stable: bool
    stays_folded: tuple[int, ...]
    angles: Annotated[Array, Key("distal_angle"), Unit("rad")]
    tendon_energy: Joules
    sheet_energy: Annotated[Joules, Key("membrane_energy")]
    independent_energy: Joules | None = None

    @property
    def energy(self) -> Joules:
        """Return the total energy, J."""
        return self.tendon_energy + self.sheet_energy


def folding_hinges(structure: Structure) -> tuple[int, ...]:
    """Return the numbers of the folding hinges: those of the rigid fold or, without one, those under tendons."""
    if structure.rigid_fold is not None:
        return structure.rigid_fold.folds
    bodies = ([structure.points[point].body for point in tendon.points] for tendon in structure.tendons)
    return tuple(dict.fromkeys(hinge for ends in bodies for hinge in hinges_between(structure, *ends)))


def fold_levels(structure: Structure) -> Array | None:
    """Compute the energies with none to all of the independent hinges folded, J, (folding hinge + 1,).

    They are sums of the energies at the overbend stop and at the fold limit (Binder et al. 2025, section 3.1), folded
    from the first hinge on, of ideal hinges if there are any. A hinge without a tendon stores nothing.

    Returns:
        None if there are no tendons, or if the energies of single hinges do not add up to that of the structure: see
        `PartialFold.independent_energy`.
    """
    independent = _independent(structure, folding_hinges(structure))
    if independent is None:
        return None
    count, (flat, folded) = len(independent), zip(*independent, strict=True)
    if len(set(independent)) == 1:
        return np.array([(count - number) * flat[0] + number * folded[0] for number in range(count + 1)])
    return np.array([sum(folded[:number]) + sum(flat[number:]) for number in range(count + 1)], dtype=np.float64)


def single_hinge_barriers(structures: Ensemble, flat: Array) -> Array:
    """Compute the energy to climb until one hinge folds alone, J, (folding hinge,).

    The hinge is moved from its resting angle in the flat state to where it continues to fold by itself, while all other
    hinges minimise the energy. The result is 0 if the path leads only downhill, and nan if the hinge never folds by
    itself, or if it rests folded.

    Args:
        structures: only the first case is used.
        flat: angles at rest without torques, rad, (1, hinge).
    """
    folding = folding_hinges(structures.structure)
    count = len(folding)
    if not count:
        return np.zeros(0)
    many = structures.repeated(count * _POSITIONS)
    start = np.tile(flat, (count * _POSITIONS, 1))
    held = np.zeros(start.shape, dtype=bool)
    places = _places(structures, folding, flat[0])
    for number, hinge in enumerate(folding):
        rows = slice(number * _POSITIONS, (number + 1) * _POSITIONS)
        steps = np.linspace(flat[0, hinge], places.folded[number], _POSITIONS - 1)
        start[rows, hinge] = np.append(steps, places.top[number])
        held[rows, hinge] = True
    energy = rest(many, start, held=held).energy.reshape(count, _POSITIONS)
    level = potential(structures.repeated(1), flat)[0][0]
    rises = places.shared & (energy[:, :-1].argmax(axis=1) == _POSITIONS - 2)
    folds = ~rises & (~places.shared | (places.senses * (flat[0, list(folding)] - places.top) >= 0))
    return np.where(folds, np.maximum(0.0, energy.max(axis=1) - level), np.nan)


@dataclass(frozen=True, kw_only=True)
class _Places:
    """Characteristic angles of the folding hinges, rad, (folding hinge,).

    Attributes:
        senses: +1 if negative angles fold the hinge, else -1.
        shared: whether springs, several tendons or tendons across several hinges act on the hinge, instead of one
            tendon alone.
        top: boundary between folded and not folded: where the tendon is longest, within the stops; straight without a
            tendon. For a shared hinge, the energy maximum between its two equilibria, if there are two.
        folded: slightly beyond the top, from where the hinge folds by itself; for a shared hinge, the energy minimum on
            that side, or its limit.
        opened: stop on the other side, or the same distance from the top without a stop; for a shared hinge, the energy
            minimum on that side, or its limit.
    """

    senses: Array
    shared: Flags
    top: Array
    folded: Array
    opened: Array


def _places(structures: Ensemble, folding: Sequence[int], flat: Array) -> _Places:
    """Find the characteristic angles of folding hinges.

    Args:
        structures: only the first case is used.
        folding: numbers of the hinges.
        flat: angles at rest, rad, (hinge,).
    """
    hinges = [structures.structure.hinges[number] for number in folding]
    senses = np.array([folding_sense(hinge) for hinge in hinges], dtype=np.float64)
    tops = np.zeros(structures.size)
    tops[structures.crossed] = 0.0 - np.asarray(structures.tendons.offset_angle)[0]
    lower, upper = structures.lower[list(folding)], structures.upper[list(folding)]
    top = np.clip(tops[list(folding)], lower, upper)
    stops = np.where(senses > 0, upper, lower)
    folded = np.clip(top - senses * _START, lower, upper)
    opened = np.where(np.isfinite(stops), stops, top + senses * _START)
    alone = (structures.stiffness == 0) & (structures.crossings.sum(axis=0) <= 1) & (structures.lines is None)
    alone = alone & (not structures.coupled)
    shared = ~alone[list(folding)]
    for number in np.flatnonzero(shared).tolist():
        between, folded[number], opened[number] = _sides(structures, folding[number], senses[number], flat)
        top[number] = top[number] if between is None else between
    return _Places(senses=senses, shared=shared, top=top, folded=folded, opened=opened)


def _sides(structures: Ensemble, hinge: int, sense: float, flat: Array) -> tuple[float | None, float, float]:
    """Return the energy maximum of one hinge between two equilibria, and the folded and the open one; others are flat.

    With only one equilibrium, the maximum is None and the limits of the hinge are returned, because other hinges may
    move as well.
    """
    many, angles = structures.repeated(_FINE), np.tile(flat, (_FINE, 1))
    lower, upper = np.clip([structures.lower[hinge], structures.upper[hinge]], -math.pi, math.pi)
    turned = np.linspace(lower, upper, _FINE) if sense < 0 else np.linspace(upper, lower, _FINE)
    angles[:, hinge] = turned
    energy, least = potential(many, angles)[0], slight_energy(structures)
    tops = 1 + np.flatnonzero((energy[1:-1] > energy[:-2]) & (energy[1:-1] >= energy[2:]))
    tops = tops[[min(energy[top] - energy[:top].min(), energy[top] - energy[top:].min()) > least for top in tops]]
    if not len(tops):
        return None, float(turned[-1]), float(turned[0])
    top = int(tops[np.argmax(energy[tops])])
    before, at, after = energy[top - 1 : top + 2]
    # maximum of the parabola through the three highest points
    shift = (before - after) / (2 * (before - 2 * at + after))
    between = float(turned[top] + shift * (turned[1] - turned[0]))
    return between, float(turned[top + np.argmin(energy[top:])]), float(turned[np.argmin(energy[:top])])


def partial_folds(structures: Ensemble, flat: Array) -> tuple[PartialFold, ...]:
    """Release a structure from every combination of folded hinges, fewest first.

    First all other hinges move to where the membrane is stretched least, with the folding hinges held; then all hinges
    are free. With more than five hinges, only combinations of the first hinges in their order are tried.

    Args:
        structures: only the first case is used.
        flat: angles at rest without torques, rad, (1, hinge).
    """
    folding = np.array(folding_hinges(structures.structure), dtype=np.int64)
    if not len(folding):
        return ()
    combinations = _combinations(len(folding))
    many = structures.repeated(len(combinations))
    start = np.zeros((len(combinations), many.size))
    places = _places(structures, folding.tolist(), flat[0])
    opened = places.opened
    if structures.coupled:
        # all joints that springs couple to the folding hinges start in their state, and so do open hinges
        start, at = np.tile(flat, (len(combinations), 1)), flat[0, folding]
        opened = np.where(places.senses * (at - places.top) >= 0, at, opened)
    for row, folded in enumerate(combinations):
        start[row, folding] = np.where(np.isin(np.arange(len(folding)), folded), places.folded, opened)
    aimed = rest(many, start, fixed=folding.tolist()).position
    result = rest(many, aimed)
    sheet, _, _ = sheet_energy(many.sheet, result.position)
    soft, states, independent = soft_stiffness(structures), [], _independent(structures.structure, folding.tolist())
    for row, folded in enumerate(combinations):
        angles = result.position[row, folding]
        stays = tuple(np.flatnonzero(places.senses * (angles - places.top) < 0).tolist())
        states.append(
            PartialFold(
                folded=folded,
                stable=bool(result.rests[row] and result.stiffness[row] > -soft) and stays == folded,
                stays_folded=stays,
                angles=angles,
                tendon_energy=float(result.energy[row] - sheet[row]),
                sheet_energy=float(sheet[row]),
                independent_energy=None
                if independent is None
                else sum(energies[int(place in folded)] for place, energies in enumerate(independent)),
            )
        )
    return tuple(states)


def _independent(structure: Structure, folding: Sequence[int]) -> list[tuple[float, float]] | None:
    """Return the energies of the tendons across each folding hinge at its overbend stop and at its fold limit, J.

    Ideal hinges are used if there are any. It is None under the conditions of `PartialFold.independent_energy`.
    """
    energies = dict.fromkeys(folding, (0.0, 0.0))
    if not structure.tendons or any(structure.hinges[hinge].stiffness for hinge in folding):
        return None
    if structure.springs or structure.closures or structure.holds or any(hinge.flaps for hinge in structure.hinges):
        return None
    for tendon in structure.tendons:
        if tendon.crossing is None or tendon.crossing.hinge not in energies:
            return None
        hinge = tendon_hinge(structure, tendon, tendon.ideal or tendon.crossing)
        opened, closed = energies[tendon.crossing.hinge]
        energies[tendon.crossing.hinge] = (
            opened + float(hinge.energy(hinge.overbend)),
            closed + float(hinge.energy(-hinge.fold_limit)),
        )
    return list(energies.values())


def soft_stiffness(structures: Ensemble) -> float:
    """Return the stiffness that counts as zero, N m/rad, because rounding makes a zero stiffness slightly negative.

    It is a share of the stiffness of the stiffest part. Tendons count with the stiffness of their hinge at its top, of
    ideal hinges if there are any.
    """
    hinges = ideal_hinges(structures.structure) or tendon_hinges(structures.structure)
    tops = [abs(float(hinge.stiffness(hinge.top))) for hinge in hinges]
    if structures.lines is not None:
        tops.append(largest_pull(structures.lines, structures.structure))
    springs = float(structures.stiffness.max(initial=0.0))
    if structures.flaps is not None:
        springs = max(springs, float(np.max(structures.flaps.law.stiffness)))
    return _ROUNDING * max(sheet_torque(structures.structure), springs, *tops, 0.0)


def _combinations(hinges: int) -> list[tuple[int, ...]]:
    if hinges > _EVERY_COMBINATION:
        return [tuple(range(count)) for count in range(hinges + 1)]
    return [folded for count in range(hinges + 1) for folded in itertools.combinations(range(hinges), count)]
