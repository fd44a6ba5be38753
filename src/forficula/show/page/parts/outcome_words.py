"""Outcomes of points in words, each with a sign, so that nobody needs to distinguish colours."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from forficula.study.tables.map_comparison import NOT_SIMULATED
from forficula.study.tables.outcome_kinds import OutcomeKind, outcome_kinds

if TYPE_CHECKING:
    from xarray import DataArray, Dataset

# sign of a point that completed every transition
_GOOD = "●"
_SIGNS = {
    OutcomeKind.DID_ALL: _GOOD,
    OutcomeKind.DID_FIRST: "◆",
    OutcomeKind.LOST_LATER: "↻",
    OutcomeKind.MOVING_LATER: "◁",
    OutcomeKind.STUCK_LATER: "■",
    OutcomeKind.STUCK: "×",
    OutcomeKind.UNDER_WAY: "✱",
    OutcomeKind.MOVING: "▷",
    OutcomeKind.LOST: "↺",
    OutcomeKind.UNDECIDED: "≷",
    OutcomeKind.DIVERGED: "✚",
    OutcomeKind.UNTRUSTED: "≠",
    OutcomeKind.NOT_BUILT: "⊘",
    OutcomeKind.NOT_TRIED: "–",
}
_WITH_TORQUE, _OTHER = "⊗", "?"
# the class of each sign in the style of pages
_PATTERNS = {
    _GOOD: "opened",
    "◆": "folded",
    "↻": "reclosed",
    "◁": "opening",
    "■": "closed",
    "×": "unfolded",
    "✱": "stuck",
    "▷": "moving",
    "↺": "returned",
    "≷": "undecided",
    "✚": "diverged",
    "≠": "untrusted",
    "⊘": "unbuilt",
    "–": "untried",
    "·": "unrun",
    _WITH_TORQUE: "before",
    "◐": "missed",
    "◒": "missed",
    "○": "apart",
    "△": "placed",
}


def look_data(sign: str) -> dict[str, Any]:
    """Return a sign as data for JSON, with its CSS class and whether it stands for completing every transition."""
    return {"sign": sign, "pattern": _PATTERNS.get(sign, "other"), "good": sign == _GOOD}


OTHER_LOOK = look_data(_OTHER)  # of a word that no point of the page has


class OutcomeWords:
    """Numbered outcome words of the points of a page."""

    def __init__(self, first: Sequence[str], signs: OutcomeSigns) -> None:
        self._numbers = {word: number for number, word in enumerate(first)}
        self._signs = signs

    def number(self, word: str) -> int:
        """Return the number of a word; a new word gets a new number."""
        return self._numbers.setdefault(word, len(self._numbers))

    def numbers(self, words: DataArray) -> list[int]:
        """Return the number of each point's word."""
        return [self.number(str(word)) for word in words.values.ravel()]

    def data(self, verdicts: Sequence[int]) -> list[dict[str, Any]]:
        """Return all words as data for JSON, each with its sign and the number of points with this outcome."""
        counts = Counter(verdicts)
        return [
            {"word": word, "count": counts[number]} | look_data(self._signs.sign(word))
            for word, number in self._numbers.items()
        ]


@dataclass(frozen=True, kw_only=True)
class OutcomeSigns:
    """Signs of words, from the most to the least successful outcome."""

    signs: Mapping[str, str]

    def rank(self, word: str) -> tuple[int, str]:
        """Return the sort key of a word."""
        return [*self.signs, word].index(word), word

    def sign(self, word: str) -> str:
        """Return the sign of a word; that of other words if it has none."""
        return self.signs.get(word) or (_WITH_TORQUE if " with " in word else _OTHER)


def signs_of(table: Dataset, additional: Mapping[str, str] | None = None) -> OutcomeSigns:
    """Return the signs of the words that a table may contain.

    Args:
        table: results, with or without the attribute that names the transitions.
        additional: additional words with their signs, placed before the others.
    """
    kinds = outcome_kinds(table)
    by_kind = {word: sign for kind, sign in _SIGNS.items() for word, its in kinds.items() if its is kind}
    others = {word: sign for word, sign in {**by_kind, NOT_SIMULATED: "·"}.items() if word not in (additional or {})}
    return OutcomeSigns(signs={**(additional or {}), **others})
