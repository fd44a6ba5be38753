"""The papers that are reproduced, by name."""

from __future__ import annotations

from forficula.errors import InputError
from forficula.quantities import as_written
from forficula.reproduction.binder2025 import BINDER2025
from forficula.reproduction.reproduction import Reproduction

_NAMED = {paper.name: paper for paper in (BINDER2025,)}


def named_reproduction(name: str | None) -> Reproduction | None:
    """Find the paper that a study or a design names under `reproduces`; None where it names none.

    Raises:
        InputError: there is no such paper.
    """
    if name is None:
        return None
    if name not in _NAMED:
        raise InputError(f"reproduces: need one of {', '.join(sorted(_NAMED))}, got {as_written(name)}")
    return _NAMED[name]
