"""Letters and words that files use for the kinds of edges, in assignments and layers."""

from __future__ import annotations

import re

_WORDS = {
    "mountain": "M",
    "ridge": "M",
    "valley": "V",
    "border": "B",
    "boundary": "B",
    "outline": "B",
    "contour": "B",
    "cut": "C",
    "slit": "C",
    "flat": "F",
    "facet": "F",
    "join": "F",
    "auxiliary": "F",
    "triangulation": "F",
    "unassigned": "U",
    "undriven": "U",
    "hinge": "U",
}
_LETTERS = {letter: "F" if letter == "J" else letter for letter in "BMVFUCJ"}


def letter_of_name(name: str) -> str | None:
    """Find the kind of edge that a name means, such as "v", "Mountain folds" or "layer_cut_2".

    A single letter is read as in the FOLD format, with "J" (join) as flat. Other names need to contain one of the words
    that origami programs use, such as mountain, valley, border, boundary, cut, flat, facet, auxiliary, unassigned or
    hinge.

    Returns:
        One of "BMVFUC"; None where the name contains no such word, or words of different kinds.
    """
    if (letter := name.strip().upper()) in _LETTERS:
        return _LETTERS[letter]
    lower = re.sub(r"[^a-z]", "", name.lower())
    meant = {letter for word, letter in _WORDS.items() if word in lower}
    return meant.pop() if len(meant) == 1 else None
