"""What parts are called together, and in which colours they are drawn."""

from __future__ import annotations

from dataclasses import dataclass

from forficula.make.part import Part, PartSet
from forficula.structure import GROUND

# by kind; bars of several roles take turns
_BARS = ("#7DB3D8", "#E3BE7E", "#B7A6D6", "#A9C98F")
_KINDS = {"pin": "#B9C0C7", "strap": "#3E9C86", "hub": "#C99AA9", "root": "#C77B52"}
_OTHERS = "#CFCFCF"
# of the faces by which two halves of a joint come to rest on one another
STOP_COLOUR = "#D55E00"


@dataclass(frozen=True, kw_only=True)
class PartLook:
    """Parts that are drawn alike.

    Attributes:
        name: what they are called together, such as "distal bar".
        kind: of all of them.
        colour: as #RRGGBB.
    """

    name: str
    kind: str
    colour: str


def part_looks(parts: PartSet) -> tuple[tuple[PartLook, ...], tuple[int, ...]]:
    """How parts look: all looks in the order of the parts, and the number of each part's own.

    >>> from forficula.make.make_parts import make_parts
    >>> looks, own = part_looks(make_parts("binder2025", "joint"))
    >>> [look.name for look in looks], own
    (['proximal bar', 'distal bar', 'pin', 'strap'], (0, 1, 2, 3))
    """
    looks: dict[str, PartLook] = {}
    own = []
    for part in parts.parts:
        name = _name(parts, part)
        if name not in looks:
            bars = sum(look.kind == "bar" for look in looks.values())
            colour = _BARS[bars % len(_BARS)] if part.kind == "bar" else _KINDS.get(part.kind, _OTHERS)
            looks[name] = PartLook(name=name, kind=part.kind, colour=colour)
        own.append(list(looks).index(name))
    return tuple(looks.values()), tuple(own)


def _name(parts: PartSet, part: Part) -> str:
    """What a part is called with those like it: bars by the role of their bodies, where these have several."""
    if part.kind != "bar" or part.body is None or part.body == GROUND:
        return part.kind
    bodies = [each.body for each in parts.parts if each.kind == "bar" and each.body not in (None, GROUND)]
    roles = {parts.structure.bodies[body].role for body in bodies if body is not None}
    role = parts.structure.bodies[part.body].role
    return f"{role} {part.kind}" if role and len(roles) > 1 else part.kind
