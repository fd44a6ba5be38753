"""A structure with some of its hinges folded: which of these states stay, and what they store."""

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
from forficula.statics.tree.hinge import folding_sense, ideal_hinges, tendon_hinge, tendon_hinges
from forficula.statics.tree.lines import largest_pull
from forficula.statics.tree.potential import Ensemble, potential, rest, sheet_torque, slight_energy
from forficula.statics.tree.sheet import sheet_energy
from forficula.structure import Structure, hinges_between

# of so many hinges every combination is tried; of more only those folded one after another, from one side
_EVERY_COMBINATION = 5
# how far past straight a hinge starts: from there its tendon pulls it as far as neighbours and length limits let it
_START = math.radians(30)
_WAYS = 45  # places on the way of one hinge, straight among them
_FINE = 721  # angles among which the top of one hinge is looked for
_ROUNDING = 1e-6  # of the stiffest part


@dataclass(frozen=True, kw_only=True)
class PartialFold:
    """A structure let go with some hinges folded and the others in the overbend.

    Of the folding hinges, see `folding_hinges`, the first has the number 0.

    Attributes:
        folded: hinges that start folded.
        stable: whether every hinge stays on the side of straight on which it starts, and no small push drives it on.
        stays_folded: hinges that are folded in the end.
        angles: of each folding hinge in the end, in its own sense, rad, (folding hinge,).
        tendon_energy: of all tendons, springs and weights in the end, J.
        sheet_energy: of membranes and length limits in the end, J.
        independent_energy: of as many hinges that nothing couples, those folded at their limits and the others at their
            overbend stops, J; ideal ones where there are such; None where springs hold them elsewhere, where there is
            no tendon, or where one lies across several hinges or one that does not fold.
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
        """Of everything, J."""
        return self.tendon_energy + self.sheet_energy


def folding_hinges(structure: Structure) -> tuple[int, ...]:
    """Numbers of the hinges that fold: those of the rigid fold, or, where there is none, those under tendons."""
    if structure.rigid_fold is not None:
        return structure.rigid_fold.folds
    bodies = ([structure.points[point].body for point in tendon.points] for tendon in structure.tendons)
    return tuple(dict.fromkeys(hinge for ends in bodies for hinge in hinges_between(structure, *ends)))


def fold_levels(structure: Structure) -> Array | None:
    """Energies of independent hinges, none of them folded to all of them, J, (folding hinge + 1,).

    Sums of the energies at the overbend stop and at the fold limit (Binder et al. 2025, section 3.1), folded from the
    first on; of ideal hinges where there are such. A hinge without a tendon counts as one that stores nothing.

    Returns:
        None where there are no tendons, or where the energies of single hinges do not add up to the structure's: see
        `PartialFold.independent_energy`.
    """
    independent = _independent(structure, folding_hinges(structure))
    if independent is None:
        return None
    count, (flat, folded) = len(independent), zip(*independent, strict=True)
    if len(set(independent)) == 1:
        return np.array([(count - each) * flat[0] + each * folded[0] for each in range(count + 1)])
    return np.array([sum(folded[:each]) + sum(flat[each:]) for each in range(count + 1)], dtype=np.float64)


def single_hinge_barriers(structures: Ensemble, flat: Array) -> Array:
    """Energy to climb until one hinge folds, the others left alone, J, (folding hinge,).

    The hinge is led from where it rests in the flat state to where it folds on by itself, and everything else goes to
    where the energy is least; 0 where it is downhill all along, nan where it never folds by itself, or rests folded.

    Args:
        structures: of which the first case is taken.
        flat: angles at rest without torques, rad, (1, hinge).
    """
    folding = folding_hinges(structures.structure)
    count = len(folding)
    if not count:
        return np.zeros(0)
    many = structures.repeated(count * _WAYS)
    start = np.tile(flat, (count * _WAYS, 1))
    held = np.zeros(start.shape, dtype=bool)
    places = _places(structures, folding, flat[0])
    for number, hinge in enumerate(folding):
        rows = slice(number * _WAYS, (number + 1) * _WAYS)
        way = np.linspace(flat[0, hinge], places.folded[number], _WAYS - 1)
        start[rows, hinge] = np.append(way, places.top[number])
        held[rows, hinge] = True
    energy = rest(many, start, held=held).energy.reshape(count, _WAYS)
    level = potential(structures.repeated(1), flat)[0][0]
    rises = places.shared & (energy[:, :-1].argmax(axis=1) == _WAYS - 2)
    folds = ~rises & (~places.shared | (places.senses * (flat[0, list(folding)] - places.top) >= 0))
    return np.where(folds, np.maximum(0.0, energy.max(axis=1) - level), np.nan)


@dataclass(frozen=True, kw_only=True)
class _Places:
    """Of the folding hinges, rad, (folding hinge,).

    Attributes:
        senses: +1 where negative angles fold them, else -1.
        shared: whether springs, several tendons or tendons across several hinges act on them, and not one tendon alone.
        top: between folded and not, where their tendons are longest, within the stops; straight where they have none.
            Of shared ones, where the energy is largest between two places at rest, if there are two.
        folded: a little beyond, from where they fold by themselves; of shared ones, where the energy is least on that
            side, or their limit.
        opened: their stops on the other side, or as far from the top where there is none; of shared ones, where the
            energy is least on that side, or their limit.
    """

    senses: Array
    shared: Flags
    top: Array
    folded: Array
    opened: Array


def _places(structures: Ensemble, folding: Sequence[int], flat: Array) -> _Places:
    """Where folding hinges go from side to side.

    Args:
        structures: of which the first case is taken.
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
    shared = ~alone[list(folding)]
    for number in np.flatnonzero(shared).tolist():
        between, folded[number], opened[number] = _sides(structures, folding[number], senses[number], flat)
        top[number] = top[number] if between is None else between
    return _Places(senses=senses, shared=shared, top=top, folded=folded, opened=opened)


def _sides(structures: Ensemble, hinge: int, sense: float, flat: Array) -> tuple[float | None, float, float]:
    """Where one hinge has most energy between two places at rest, and these, the folded one first; all others are flat.

    Where it has one such place only, there is nothing between, and its limits count: others may move, too.
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
    # the top of the parabola through the highest three
    shift = (before - after) / (2 * (before - 2 * at + after))
    between = float(turned[top] + shift * (turned[1] - turned[0]))
    return between, float(turned[top + np.argmin(energy[top:])]), float(turned[np.argmin(energy[:top])])


def partial_folds(structures: Ensemble, flat: Array) -> tuple[PartialFold, ...]:
    """Let a structure go from every combination of folded hinges, fewest first.

    First all other hinges go to where the membrane is stretched least, with the folding ones held, then everything is
    free. Of more than five hinges only the combinations of neighbours from the first one on are tried.

    Args:
        structures: of which the first case is taken.
        flat: angles at rest without torques, rad, (1, hinge).
    """
    folding = np.array(folding_hinges(structures.structure), dtype=np.int64)
    if not len(folding):
        return ()
    combinations = _combinations(len(folding))
    many = structures.repeated(len(combinations))
    start = np.zeros((len(combinations), many.size))
    places = _places(structures, folding.tolist(), flat[0])
    for row, folded in enumerate(combinations):
        start[row, folding] = np.where(np.isin(np.arange(len(folding)), folded), places.folded, places.opened)
    aimed = rest(many, start, fixed=folding.tolist()).position
    found = rest(many, aimed)
    sheet, _, _ = sheet_energy(many.sheet, found.position)
    soft, states, independent = soft_stiffness(structures), [], _independent(structures.structure, folding.tolist())
    for row, folded in enumerate(combinations):
        angles = found.position[row, folding]
        stays = tuple(int(each) for each in np.flatnonzero(places.senses * (angles - places.top) < 0))
        states.append(
            PartialFold(
                folded=folded,
                stable=bool(found.rests[row] and found.stiffness[row] > -soft) and stays == folded,
                stays_folded=stays,
                angles=angles,
                tendon_energy=float(found.energy[row] - sheet[row]),
                sheet_energy=float(sheet[row]),
                independent_energy=None
                if independent is None
                else sum(energies[int(place in folded)] for place, energies in enumerate(independent)),
            )
        )
    return tuple(states)


def _independent(structure: Structure, folding: Sequence[int]) -> list[tuple[float, float]] | None:
    """Energies of the tendons across each folding hinge at its overbend stop and at its fold limit, J.

    Those of ideal hinges, where there are such; None as `PartialFold.independent_energy`.
    """
    energies = dict.fromkeys(folding, (0.0, 0.0))
    if not structure.tendons or any(structure.hinges[hinge].stiffness for hinge in folding):
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
    """Stiffness that counts as none, N m/rad: where nothing holds a structure, rounding makes it a little negative.

    It is a share of that of the stiffest part, of a tendon's hinge where that is longest: ideal ones where there are.
    """
    hinges = ideal_hinges(structures.structure) or tendon_hinges(structures.structure)
    tops = [abs(float(hinge.stiffness(hinge.top))) for hinge in hinges]
    if structures.lines is not None:
        tops.append(largest_pull(structures.lines, structures.structure))
    springs = float(structures.stiffness.max(initial=0.0))
    return _ROUNDING * max(sheet_torque(structures.structure), springs, *tops, 0.0)


def _combinations(hinges: int) -> list[tuple[int, ...]]:
    if hinges > _EVERY_COMBINATION:
        return [tuple(range(count)) for count in range(hinges + 1)]
    return [folded for count in range(hinges + 1) for folded in itertools.combinations(range(hinges), count)]
