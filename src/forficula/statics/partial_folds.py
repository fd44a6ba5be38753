"""A wing with some of its hinges folded: which of these states stay, and what they store."""

from __future__ import annotations

import itertools
import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from forficula.design import Design
from forficula.statics.hinge import ideal_hinge
from forficula.statics.potential import FOLD, rest, section, straight_start
from forficula.statics.sheet import sheet_energy

Array = NDArray[np.float64]

# of so many veins every combination is tried; of more only those folded one after another, from one side
_EVERY_COMBINATION = 5
# how far past straight a hinge starts: from there its tendon pulls it as far as neighbours and guards let it
_START = math.radians(30)
_WAYS = 45  # places on the way of one hinge, straight among them
_ROUNDING = 1e-6  # of the stiffest part


@dataclass(frozen=True, kw_only=True)
class PartialFold:
    """A wing let go with some hinges folded and the others in the overbend.

    Attributes:
        folded: veins whose hinges start folded.
        stable: whether every hinge stays on the side of straight on which it starts, and no small push drives it on.
        stays_folded: veins whose hinges are folded in the end.
        distal_angle: of each vein in the end, rad, (vein,).
        tendon_energy: of all tendons in the end, J.
        sheet_energy: of membrane and guards in the end, J.
    """

    folded: tuple[int, ...]
    stable: bool
    stays_folded: tuple[int, ...]
    distal_angle: Array
    tendon_energy: float
    sheet_energy: float

    @property
    def energy(self) -> float:
        """Of tendons, membrane and guards, J."""
        return self.tendon_energy + self.sheet_energy


def fold_levels(design: Design) -> Array:
    """Energies of independent ideal hinges, none of them folded to all of them, J, (vein + 1,).

    Sums of the energies at the overbend stop and at the fold limit (Binder et al. 2025, section 3.1).
    """
    hinge, veins = ideal_hinge(design), design.fan.vein_count
    flat, folded = float(hinge.energy(hinge.overbend)), float(hinge.energy(-hinge.fold_limit))
    return np.array([(veins - count) * flat + count * folded for count in range(veins + 1)])


def single_hinge_barriers(design: Design) -> Array:
    """Energy to climb until one hinge folds, the others left alone, J, (vein,).

    The hinge is led from where it rests in the flat wing to past straight, and everything else goes to where the
    energy is least; 0 where it is downhill all along.
    """
    one = section([design])
    flat = rest(one, straight_start(one))
    veins = one.veins
    wings = one.only(np.zeros(veins * _WAYS, dtype=np.int64))
    start = np.tile(flat.position, (veins * _WAYS, 1))
    held = np.zeros(start.shape, dtype=bool)
    for vein in range(veins):
        rows, joint = slice(vein * _WAYS, (vein + 1) * _WAYS), 4 * vein + FOLD
        here = flat.position[0, joint]
        past = -min(_START, design.hinge.fold_limit)
        start[rows, joint] = np.append(np.linspace(here, past, _WAYS - 1), 0.0)
        held[rows, joint] = True
    energy = rest(wings, start, held=held).energy.reshape(veins, _WAYS)
    return np.asarray(np.maximum(0.0, energy.max(axis=1) - flat.energy[0]))


def partial_folds(design: Design) -> tuple[PartialFold, ...]:
    """Let the wing go from every combination of folded hinges, fewest first.

    First the joints at the base and the turns go to where the membrane is stretched least, with the hinges held, then
    everything is free. Of more than five veins only the combinations of neighbours from the first vein on are tried.
    """
    combinations = _combinations(design.fan.vein_count)
    wings = section([design]).only(np.zeros(len(combinations), dtype=np.int64))
    start = np.zeros((len(combinations), len(wings.lower)))
    for row, folded in enumerate(combinations):
        for vein in range(wings.veins):
            start[row, 4 * vein + FOLD] = -min(_START, design.hinge.fold_limit) if vein in folded else wings.upper[FOLD]
    aimed = rest(wings, start, fixed=(FOLD,)).position
    found = rest(wings, aimed)
    sheet, _, _ = sheet_energy(wings.sheet, found.position.reshape(len(start), wings.veins, 4))
    states = []
    for row, folded in enumerate(combinations):
        angle = found.position[row, FOLD::4]
        stays = tuple(int(vein) for vein in np.flatnonzero(angle < 0))
        states.append(
            PartialFold(
                folded=folded,
                stable=bool(found.rests[row] and found.stiffness[row] > -_soft(design)) and stays == folded,
                stays_folded=stays,
                distal_angle=angle,
                tendon_energy=float(found.energy[row] - sheet[row]),
                sheet_energy=float(sheet[row]),
            )
        )
    return tuple(states)


def _soft(design: Design) -> float:
    """Stiffness that counts as none, N m/rad: where nothing holds a wing, rounding makes it a little negative."""
    membrane = design.membrane
    sheet = membrane.youngs_modulus * membrane.thickness * membrane.margin**2
    return _ROUNDING * max(sheet, abs(float(ideal_hinge(design).stiffness(0.0))))


def _combinations(veins: int) -> list[tuple[int, ...]]:
    if veins > _EVERY_COMBINATION:
        return [tuple(range(count)) for count in range(veins + 1)]
    return [folded for count in range(veins + 1) for folded in itertools.combinations(range(veins), count)]
