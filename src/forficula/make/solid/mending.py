"""What would keep parts from touching in a recorded motion: the same with thinner bars and the like, each tried."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from forficula.arrays import Indices
from forficula.design import key_value
from forficula.design.section import SMALL_LENGTH
from forficula.dynamics import Record
from forficula.errors import InputError
from forficula.make.flat.pieces import pieces_of
from forficula.make.flat.touching import Touch, state_rows, touches
from forficula.make.make_parts import make_parts
from forficula.make.part import PartSet
from forficula.quantities import show_quantity

# from the hinge, of pegs that are moved nearer to it, m
_NEAR = 30e-3


@dataclass(frozen=True, kw_only=True)
class Mending:
    """Parts with other sizes in the same motion.

    Attributes:
        name: of what is tried.
        values: of the design, by key, as text.
        touches: who touches whom then; None of what cannot be made.
        states: named states in which anything touches.
        why: it cannot be made; mostly empty.
    """

    name: str
    values: Mapping[str, str]
    touches: tuple[Touch, ...] | None
    states: tuple[str, ...] = ()
    why: str = ""

    @property
    def first(self) -> Touch | None:
        """The first one; None where nothing touches, or where it cannot be made."""
        return self.touches[0] if self.touches else None


def mendings(parts: PartSet, record: Record) -> tuple[Mending, ...]:
    """Try what may keep parts from touching in a recorded motion, one after another, and then all of it together.

    Bars half as thick, hinges half as wide and as thick, pegs nearer to the hinges and half as thick, rods at the hub
    half as thick. The motion stays: what other masses, pegs and stiffnesses would do to it is not in it.

    Args:
        parts: of bars, with joints.
        record: of a run of their design.
    """
    tried: list[tuple[str, dict[str, str]]] = [
        ("bars half as thick", {"vein.diameter": _share(parts, "vein.diameter")}),
        ("slim hinges", _slim_hinges(parts)),
        ("pegs near the hinges", _near_pegs(parts)),
    ]
    if parts.roots:
        tried.append(("slim roots", {"make.root_diameter": _share(parts, "make.root_diameter")}))
    tried.append(("all of that", {key: value for _, values in tried for key, value in values.items()}))
    found = []
    for name, values in tried:
        try:
            other = make_parts(parts.design.with_values(values), "section")
        except InputError as error:
            found.append(Mending(name=name, values=values, touches=None, why=str(error)))
        else:
            found.append(_tried(other, record, name, values))
    return tuple(found)


def _tried(parts: PartSet, record: Record, name: str, values: Mapping[str, str]) -> Mending:
    """Parts in a recorded motion, and in the states that it comes to."""
    pieces = pieces_of(parts)

    def met(rows: Indices | None) -> tuple[Touch, ...]:
        return touches(parts, record, rows, deepest=0, pieces=pieces)

    states = tuple(state for state, row in state_rows(record).items() if met(np.array([row])))
    return Mending(name=name, values=values, touches=met(None), states=states)


def _share(parts: PartSet, key: str, least: float = 0.0, share: float = 0.5) -> str:
    """A length of a design made smaller, down to a least one that it is not already below."""
    value = float(key_value(parts.design, key))
    return show_quantity(max(min(value, least), share * value), SMALL_LENGTH)


def _slim_hinges(parts: PartSet) -> dict[str, str]:
    make = parts.joints[0].make
    # three knuckles of two printed lines and the gaps between them
    least = 2 * (2 * make.nozzle + make.clearance)
    return {
        "make.hinge_width": _share(parts, "make.hinge_width", least),
        "make.pin_diameter": _share(parts, "make.pin_diameter"),
        "make.hinge_wall": _share(parts, "make.hinge_wall", 2 * make.nozzle),
    }


def _near_pegs(parts: PartSet) -> dict[str, str]:
    """Pegs no further from the hinges than is near."""
    found = {"make.peg_diameter": _share(parts, "make.peg_diameter")}
    for tendon in dict.fromkeys(parts.structure.tendons[place.tendon].key for place in parts.straps):
        for side in ("proximal", "distal"):
            now = key_value(parts.design, f"{tendon}.{side}_attachment")
            found[f"{tendon}.{side}_attachment"] = show_quantity(min(float(now), _NEAR), SMALL_LENGTH)
    return found
