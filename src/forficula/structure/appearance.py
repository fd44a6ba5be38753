"""What drawings and sentences need of a structure beside its parts."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from forficula.pattern import CreasePattern


@dataclass(frozen=True, kw_only=True, eq=False)
class Appearance:
    """What drawings and sentences need of a structure beside its parts.

    Attributes:
        whole: what sentences call it.
        bar: what they call a bar.
        crease: what they call a crease that no bar lies on.
        overbend: what they call a hinge's way past straight that its fold is not on.
        bodies: what the number of its bodies follows from, such as "two for every vein"; empty where nothing is to say.
        text: what it is, with its sizes, as the start of a sentence; empty where its parts are to be counted instead.
        sizes: lengths that it is known by, m, by name.
        titles: headings of plots of angles, by name of the measure or role of the hinges; else they are told by that.
        pattern: creases of the sheet that the built shape is, m; None where there are none.
        circles: radii of circles about the origin that the pattern is constructed on, m, by name.
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
