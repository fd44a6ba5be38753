"""Words, sizes and pattern of a structure, for drawings and sentences."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from forficula.pattern import CreasePattern


@dataclass(frozen=True, kw_only=True)
class BodyGroup:
    """A named group of bodies, which drawings show in one colour.

    Attributes:
        name: name of the group, in legends.
        bodies: numbers of the bodies.
    """

    name: str
    bodies: tuple[int, ...]


@dataclass(frozen=True, kw_only=True, eq=False)
class Appearance:
    """Words, sizes and pattern of a structure, for drawings and sentences.

    Attributes:
        whole: word for the structure.
        bar: word for a bar.
        crease: word for a crease without a bar on it.
        overbend: word for bending of a hinge past straight, away from folding.
        bodies: phrase on the number of bodies, such as "two for every vein"; empty without one.
        text: description with sizes, as the start of a sentence; if empty, bodies and hinges are counted instead.
        sizes: characteristic lengths, m, by name.
        titles: titles of plots of angles, by name of the measure or role of the hinges; this name without one.
        pattern: crease pattern of the sheet in the built shape, m; None without a sheet.
        circles: radii of circles about the origin from which the pattern is constructed, m, by name.
    """

    whole: str = "structure"
    bar: str = "bar"
    crease: str = "crease"
    overbend: str = "back bend"
    bodies: str = ""
    text: str = ""
    sizes: Mapping[str, float] = field(default_factory=dict)
    titles: Mapping[str, str] = field(default_factory=dict)
    pattern: CreasePattern | None = None
    circles: Mapping[str, float] = field(default_factory=dict)
