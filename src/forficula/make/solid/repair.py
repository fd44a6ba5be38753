"""Changes that may avoid collisions in a recorded motion, such as thinner bars, each of them tried."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from forficula.arrays import Indices
from forficula.design import key_value
from forficula.design.section import SMALL_LENGTH
from forficula.dynamics import Record
from forficula.errors import InputError
from forficula.make.flat.clearance import Collision, recorded_collisions, state_rows
from forficula.make.flat.pieces import pieces_of
from forficula.make.make_parts import make_parts
from forficula.make.part import PartSet
from forficula.quantities import show_quantity

# m, largest distance of pegs from the hinge when they are moved nearer to it
_NEAR = 30e-3


@dataclass(frozen=True, kw_only=True)
class Repair:
    """Parts with other sizes in the same motion.

    Attributes:
        name: name of the change.
        values: values of the design, by key, as text.
        touches: remaining collisions; None if the parts cannot be made.
        states: named states in which parts touch.
        why: reason why the parts cannot be made, else empty.
    """

    name: str
    values: Mapping[str, str]
    touches: tuple[Collision, ...] | None
    states: tuple[str, ...] = ()
    why: str = ""

    @property
    def first(self) -> Collision | None:
        """First collision; None if there is none, or if the parts cannot be made."""
        return self.touches[0] if self.touches else None


def possible_repairs(parts: PartSet, record: Record) -> tuple[Repair, ...]:
    """Try changes that may avoid collisions in a recorded motion, one after another, and then all together.

    The changes are bars half as thick, hinges half as wide and as thick, pegs nearer to the hinges and half as thick,
    and rods at the hub half as thick. The motion is not repeated: effects of other masses, pegs and stiffnesses are
    ignored.

    Args:
        parts: parts of bars, with joints.
        record: record of a run of their design.
    """
    tried: list[tuple[str, dict[str, str]]] = [
        ("bars half as thick", {"vein.diameter": _share(parts, "vein.diameter")}),
        ("slim hinges", _slim_hinges(parts)),
        ("pegs near the hinges", _near_pegs(parts)),
    ]
    if parts.roots:
        tried.append(("slim roots", {"make.root_diameter": _share(parts, "make.root_diameter")}))
    tried.append(("all changes together", {key: value for _, values in tried for key, value in values.items()}))
    results = []
    for name, values in tried:
        try:
            other = make_parts(parts.design.with_values(values), "section")
        except InputError as error:
            results.append(Repair(name=name, values=values, touches=None, why=str(error)))
        else:
            results.append(_tried(other, record, name, values))
    return tuple(results)


def _tried(parts: PartSet, record: Record, name: str, values: Mapping[str, str]) -> Repair:
    """Return the collisions of changed parts in a recorded motion, and in its named states."""
    pieces = pieces_of(parts)

    def collisions_in(rows: Indices | None) -> tuple[Collision, ...]:
        return recorded_collisions(parts, record, rows, deepest=0, pieces=pieces)

    states = tuple(state for state, row in state_rows(record).items() if collisions_in(np.array([row])))
    return Repair(name=name, values=values, touches=collisions_in(None), states=states)


def _share(parts: PartSet, key: str, least: float = 0.0, share: float = 0.5) -> str:
    """Return a reduced length of a design, but not below a minimum unless it is already smaller."""
    value = float(key_value(parts.design, key))
    return show_quantity(max(min(value, least), share * value), SMALL_LENGTH)


def _slim_hinges(parts: PartSet) -> dict[str, str]:
    make = parts.joints[0].make
    # three knuckles of two printed lines each, and the gaps between them
    least_width = 2 * (2 * make.nozzle + make.clearance)
    return {
        "make.hinge_width": _share(parts, "make.hinge_width", least_width),
        "make.pin_diameter": _share(parts, "make.pin_diameter"),
        "make.hinge_wall": _share(parts, "make.hinge_wall", 2 * make.nozzle),
    }


def _near_pegs(parts: PartSet) -> dict[str, str]:
    """Return values with pegs near the hinges."""
    values = {"make.peg_diameter": _share(parts, "make.peg_diameter")}
    for tendon in dict.fromkeys(parts.structure.tendons[place.tendon].key for place in parts.straps):
        for side in ("proximal", "distal"):
            attachment = key_value(parts.design, f"{tendon}.{side}_attachment")
            values[f"{tendon}.{side}_attachment"] = show_quantity(min(float(attachment), _NEAR), SMALL_LENGTH)
    return values
