"""How maps draw what came of a structure where there is no value: faces, hatches and markers."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from typing import TYPE_CHECKING

from matplotlib import rc_context

from forficula.show.style import BLUE, ORANGE, PURPLE, SKY, figure_style
from forficula.study.tables.map_comparison import (
    BOTH,
    BOTH_LESS,
    BOTH_MORE,
    NEITHER,
    NOT_SIMULATED,
    ONLY_SIMULATED,
    ONLY_STATIC,
)
from forficula.study.tables.outcome_kinds import Kind, outcome_kinds

if TYPE_CHECKING:
    from xarray import Dataset

INK = "0.35"
OTHER = "no value"


@dataclass(frozen=True, kw_only=True)
class Look:
    """How what happened is drawn: the cell's face and hatch, and the marker where there are no cells."""

    face: str
    hatch: str
    marker: str


_LOOKS: dict[Kind, Look] = {
    Kind.DID_ALL: Look(face=BLUE, hatch="", marker="o"),
    Kind.DID_FIRST: Look(face=SKY, hatch="", marker="D"),
    Kind.STUCK_LATER: Look(face="#F3DDA6", hatch="....", marker="s"),
    Kind.STUCK: Look(face="1.0", hatch="/////", marker="x"),
    Kind.UNDER_WAY: Look(face="0.93", hatch="xxxx", marker="*"),
    Kind.LOST: Look(face="1.0", hatch="|||||", marker="1"),
    Kind.MOVING: Look(face="0.93", hatch=r"\\\\\\", marker=">"),
    Kind.MOVING_LATER: Look(face="#F3DDA6", hatch=r"\\\\\\", marker="<"),
    Kind.LOST_LATER: Look(face="#F3DDA6", hatch="|||||", marker="2"),
    Kind.UNDECIDED: Look(face="#F7E9F1", hatch="//\\\\//", marker="D"),
    Kind.DIVERGED: Look(face="0.75", hatch="++++", marker="P"),
    Kind.UNTRUSTED: Look(face="0.75", hatch="OO", marker="d"),
    Kind.NOT_BUILT: Look(face="0.6", hatch="", marker="X"),
    Kind.NOT_TRIED: Look(face="0.86", hatch="", marker="_"),
}
_OTHER_LOOKS = {
    BOTH: Look(face=BLUE, hatch="", marker="o"),
    BOTH_LESS: Look(face=SKY, hatch="", marker="p"),
    BOTH_MORE: Look(face=SKY, hatch="/////", marker="H"),
    ONLY_SIMULATED: Look(face=ORANGE, hatch="", marker="^"),
    ONLY_STATIC: Look(face=PURPLE, hatch="", marker="v"),
    NEITHER: Look(face="0.93", hatch="", marker="x"),
    NOT_SIMULATED: Look(face="1.0", hatch="", marker="."),
    OTHER: Look(face="0.97", hatch="---", marker="+"),
}

# failed in the first transition before the next, with a value that its word names
_BEFORE_NEXT = Look(face="0.93", hatch="oo", marker="h")


@contextmanager
def map_style() -> Iterator[None]:
    """Draw as all figures are drawn, with fine hatches."""
    with figure_style(), rc_context({"hatch.linewidth": 0.5}):
        yield


def known_words(table: Dataset) -> list[str]:
    """What structures of a table can come to, in the order of a legend."""
    return [*outcome_kinds(table), *_OTHER_LOOKS]


def look_of(table: Dataset, word: str) -> Look:
    """How a structure of a table is drawn that came to this."""
    kind = outcome_kinds(table).get(word)
    if kind is not None:
        return _LOOKS[kind]
    return _OTHER_LOOKS.get(word) or (_BEFORE_NEXT if " with " in word else _OTHER_LOOKS[OTHER])


def ink_of(look: Look) -> str:
    """A marker's colour: the face where that shows on white."""
    return look.face if look.face in (BLUE, SKY) else INK
