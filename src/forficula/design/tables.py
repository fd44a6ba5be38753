"""Tables of design files, laid over each other, and the error that names a place in them."""

from __future__ import annotations

import copy
from collections.abc import Sequence
from typing import Any

from forficula.errors import InputError


class WholeTable(dict[str, Any]):
    """A table that replaces another one, where others change what they name of it."""


class RejectedError(InputError):
    """A design that is not allowed, and the place that is to blame."""

    def __init__(self, place: Sequence[str], message: str) -> None:
        super().__init__(message)
        self.place = tuple(place)


def merged(base: dict[str, Any], over: dict[str, Any]) -> dict[str, Any]:
    """Lay tables over others, which stay as they are."""
    both = copy.copy(base)
    for key, value in over.items():
        both[key] = overlaid(both.get(key), value)
    return both


def overlaid(below: object, value: object) -> object:
    """What a value makes of the one that it is laid over."""
    changes = isinstance(value, dict) and not isinstance(value, WholeTable)
    return merged(below, value) if isinstance(below, dict) and isinstance(value, dict) and changes else value
