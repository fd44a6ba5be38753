"""Looks of outcomes without a value in maps: faces, hatches and markers."""

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
from forficula.study.tables.outcome_kinds import OutcomeKind, outcome_kinds

if TYPE_CHECKING:
    from xarray import Dataset

INK = "0.35"
OTHER = "no value"
NO_POINTS = "no points"


@dataclass(frozen=True, kw_only=True)
class OutcomeLook:
    """Look of an outcome: face and hatch of a cell, and the marker on maps without cells."""

    face: str
    hatch: str
    marker: str


_LOOKS: dict[OutcomeKind, OutcomeLook] = {
    OutcomeKind.DID_ALL: OutcomeLook(face=BLUE, hatch="", marker="o"),
    OutcomeKind.DID_FIRST: OutcomeLook(face=SKY, hatch="", marker="D"),
    OutcomeKind.STUCK_LATER: OutcomeLook(face="#F3DDA6", hatch="....", marker="s"),
    OutcomeKind.STUCK: OutcomeLook(face="1.0", hatch="/////", marker="x"),
    OutcomeKind.UNDER_WAY: OutcomeLook(face="0.93", hatch="xxxx", marker="*"),
    OutcomeKind.LOST: OutcomeLook(face="1.0", hatch="|||||", marker="1"),
    OutcomeKind.MOVING: OutcomeLook(face="0.93", hatch=r"\\\\\\", marker=">"),
    OutcomeKind.MOVING_LATER: OutcomeLook(face="#F3DDA6", hatch=r"\\\\\\", marker="<"),
    OutcomeKind.LOST_LATER: OutcomeLook(face="#F3DDA6", hatch="|||||", marker="2"),
    OutcomeKind.UNDECIDED: OutcomeLook(face="#F7E9F1", hatch="//\\\\//", marker="D"),
    OutcomeKind.DIVERGED: OutcomeLook(face="0.75", hatch="++++", marker="P"),
    OutcomeKind.UNTRUSTED: OutcomeLook(face="0.75", hatch="OO", marker="d"),
    OutcomeKind.NOT_BUILT: OutcomeLook(face="0.6", hatch="", marker="X"),
    OutcomeKind.NOT_TRIED: OutcomeLook(face="0.86", hatch="", marker="_"),
}
_OTHER_LOOKS = {
    BOTH: OutcomeLook(face=BLUE, hatch="", marker="o"),
    BOTH_LESS: OutcomeLook(face=SKY, hatch="", marker="p"),
    BOTH_MORE: OutcomeLook(face=SKY, hatch="/////", marker="H"),
    ONLY_SIMULATED: OutcomeLook(face=ORANGE, hatch="", marker="^"),
    ONLY_STATIC: OutcomeLook(face=PURPLE, hatch="", marker="v"),
    NEITHER: OutcomeLook(face="0.93", hatch="", marker="x"),
    NOT_SIMULATED: OutcomeLook(face="1.0", hatch="", marker="."),
    NO_POINTS: OutcomeLook(face="1.0", hatch="", marker="."),
    OTHER: OutcomeLook(face="0.97", hatch="---", marker="+"),
}

# failed in the first transition with the reference value, which the word names
_BEFORE_NEXT = OutcomeLook(face="0.93", hatch="oo", marker="h")


@contextmanager
def map_style() -> Iterator[None]:
    """Apply the style of all figures, with fine hatches."""
    with figure_style(), rc_context({"hatch.linewidth": 0.5}):
        yield


def known_words(table: Dataset) -> list[str]:
    """Return the outcomes that structures of a table can have, in the order of a legend."""
    return [*outcome_kinds(table), *_OTHER_LOOKS]


def look_of(table: Dataset, word: str) -> OutcomeLook:
    """Return the look of an outcome."""
    kind = outcome_kinds(table).get(word)
    if kind is not None:
        return _LOOKS[kind]
    return _OTHER_LOOKS.get(word) or (_BEFORE_NEXT if " with " in word else _OTHER_LOOKS[OTHER])


def ink_of(look: OutcomeLook) -> str:
    """Return a marker's colour: the face if it is visible on white."""
    return look.face if look.face in (BLUE, SKY) else INK
