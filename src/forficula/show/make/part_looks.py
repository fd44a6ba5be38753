"""Colours of parts, and the names of parts with one colour."""

from __future__ import annotations

from dataclasses import dataclass

from forficula.make.part import Part, PartSet
from forficula.structure import GROUND

# by kind; bars of several roles take these colours in turn
_BARS = ("#7DB3D8", "#E3BE7E", "#B7A6D6", "#A9C98F")
_KINDS = {"pin": "#B9C0C7", "strap": "#3E9C86", "hub": "#C99AA9", "root": "#C77B52", "panel": "#E3CF9E"}
_OTHERS = "#CFCFCF"
# colour of the faces with which two halves of a joint stop each other
STOP_COLOUR = "#D55E00"


@dataclass(frozen=True, kw_only=True)
class PartLook:
    """Parts with one colour.

    Attributes:
        name: common name, such as "distal bar".
        kind: kind of all of them.
        colour: colour as #RRGGBB.
    """

    name: str
    kind: str
    colour: str


def part_looks(parts: PartSet) -> tuple[tuple[PartLook, ...], tuple[int, ...]]:
    """Return all looks in the order of the parts, and the index of each part's look.

    >>> from forficula.make.make_parts import make_parts
    >>> looks, own = part_looks(make_parts("binder2025", "joint"))
    >>> [look.name for look in looks], own
    (['proximal bar', 'distal bar', 'pin', 'strap'], (0, 1, 2, 3))
    """
    looks: dict[str, PartLook] = {}
    numbers = []
    for part in parts.parts:
        name = _name(parts, part)
        if name not in looks:
            bars = sum(look.kind == "bar" for look in looks.values())
            colour = _BARS[bars % len(_BARS)] if part.kind == "bar" else _KINDS.get(part.kind, _OTHERS)
            looks[name] = PartLook(name=name, kind=part.kind, colour=colour)
        numbers.append(list(looks).index(name))
    return tuple(looks.values()), tuple(numbers)


def _name(parts: PartSet, part: Part) -> str:
    """Return the name shared by parts with one look: bars by the role of their bodies, if there are several roles."""
    if part.kind != "bar" or part.body is None or part.body == GROUND:
        return part.kind
    bodies = [part.body for part in parts.parts if part.kind == "bar" and part.body not in (None, GROUND)]
    roles = {parts.structure.bodies[body].role for body in bodies if body is not None}
    role = parts.structure.bodies[part.body].role
    return f"{role} {part.kind}" if role and len(roles) > 1 else part.kind
