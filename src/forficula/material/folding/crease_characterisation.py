"""Characterisation of creases by folding tests: the law of a crease, with its uncertainty and what is not known."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from importlib import metadata
from typing import Annotated

import numpy as np

from forficula.material.folding.crease_fit import CreaseFit, fit_crease_law, turning_speeds, turns_back
from forficula.material.folding.folding_test import FoldingTest
from forficula.material.law.crease_law_file import CREASE_DAMPING, CREASE_MOMENT, CREASE_STIFFNESS, CreaseLawFile
from forficula.material.law.law_summary import LawValue
from forficula.material.law.material_law import LawFact
from forficula.material.tensile.tensile_test import UNITS
from forficula.names import counted
from forficula.quantities import Unit, show_quantity
from forficula.results import Result
from forficula.serial import Key, Written

_DIGITS = 6  # of a value in a law file
_POOR_FIT = 0.05  # share of the largest moment
_FEWEST_SPECIMENS = 3  # least number of strips whose scatter is used
_SAME_SIZE = 0.01  # largest relative difference between sizes that count as equal
_ANGLE = Unit(display="deg", si="rad", example="15 deg")
_SPEED = Unit(display="deg/s", si="rad/s", example="1 deg/s")
_UNITS = {
    "stiffness": CREASE_STIFFNESS,
    "rest_angle": _ANGLE,
    "yield_moment": CREASE_MOMENT,
    "hardening": CREASE_STIFFNESS,
    "damping": CREASE_DAMPING,
}


@dataclass(frozen=True, kw_only=True, eq=False)
class CreaseCharacterisation(Result):
    """Results of the folding tests of a crease.

    Attributes:
        name: name of the law.
        tests: tests in the given order.
        fit: fit of the law.
        law: chosen law, with its source and the size of the strips.
        remarks: remarks for the user, as sentences.
    """

    name: Annotated[str, Key("law_of_creases")]
    tests: tuple[FoldingTest, ...]
    fit: CreaseFit
    law: Annotated[CreaseLawFile, Written.NEVER]
    remarks: tuple[str, ...] = field(default=())

    def __repr__(self) -> str:
        """Return the law, the number of strips, and the form of the law."""
        return f"<CreaseCharacterisation of {self.name}: {counted(len(self.tests), 'strip')}, {self.fit.law}>"

    @property
    def versions(self) -> Annotated[dict[str, str], Written.ALWAYS]:
        """Versions of the packages that compute a law."""
        return {name: metadata.version(name) for name in ("forficula", "numpy", "scipy")}


def characterise_crease(
    tests: Sequence[FoldingTest], *, name: str = "crease", source: str = ""
) -> CreaseCharacterisation:
    """Fit the law of a crease to folding tests.

    Args:
        tests: folding tests of strips with one crease each.
        name: name of the law.
        source: source of the tests, for the law.

    Raises:
        InputError: no test, or tests that determine no law; the message says why.
    """
    fit = fit_crease_law(tests)
    law = CreaseLawFile(
        name=name,
        source=source,
        thickness=_common("thickness", [test.thickness for test in tests]),
        width=_common("width", [test.width for test in tests]),
        values={value.key: shown_value(value.key, value.value, _DIGITS) for value in fit.values},
        chosen={},
        intervals={value.key: _shown_interval(value) for value in fit.values if value.interval is not None},
        facts=tuple(_facts(tests)),
    )
    return CreaseCharacterisation(name=name, tests=tuple(tests), fit=fit, law=law, remarks=tuple(_remarks(tests, fit)))


def shown_value(key: str, value: float, digits: int = 4) -> str:
    """Return a value of a law of creases as text with its unit."""
    return show_quantity(value, _UNITS[key], digits)


def _shown_interval(value: LawValue) -> tuple[str, str]:
    low, high = value.interval or (value.value, value.value)
    return shown_value(value.key, low, _DIGITS), shown_value(value.key, high, _DIGITS)


def _common(key: str, sizes: Sequence[float | None]) -> str:
    """Return a size that all strips have, as text; empty if they differ or it is not known."""
    known = [size for size in sizes if size is not None]
    if len(known) < len(sizes) or max(known) > (1 + _SAME_SIZE) * min(known):
        return ""
    return show_quantity(float(np.median(known)), UNITS[key], _DIGITS)


def _facts(tests: Sequence[FoldingTest]) -> Iterator[LawFact]:
    """Yield facts about the tests, for readers of the law."""
    source = "the same tests"
    angles = np.concatenate([test.angle for test in tests])
    low, high = (shown_value("rest_angle", float(end)) for end in (angles.min(), angles.max()))
    yield LawFact(what="angles of the tests", value=f"{low} to {high}", source=source)
    moment = max(float(np.abs(test.moment_by_width).max()) for test in tests)
    yield LawFact(what="largest moment", value=shown_value("yield_moment", moment), source=source)
    if speeds := turning_speeds(tests):
        slow, fast = (show_quantity(speed, _SPEED) for speed in (min(speeds), max(speeds)))
        yield LawFact(what="turning speeds", value=slow if slow == fast else f"{slow} to {fast}", source=source)
    yield LawFact(what="number of strips", value=str(len(tests)), source=source)


def _remarks(tests: Sequence[FoldingTest], fit: CreaseFit) -> Iterator[str]:
    keys = [value.key for value in fit.values]
    refused = {candidate.refused for candidate in fit.candidates if candidate.refused}
    if len(tests) < _FEWEST_SPECIMENS:
        yield f"{counted(len(tests), 'strip')}: intervals hardly show the scatter of strips; test three or more"
    if fit.relative_misfit > _POOR_FIT:
        yield f"the law deviates from the data by {fit.relative_misfit:.0%} of the largest moment; see fit.png"
    if "yield_moment" not in keys:
        without = [reason for reason in refused if reason.startswith("yield_moment:")]
        moment = max(float(np.abs(test.moment_by_width).max()) for test in tests)
        if any(turns_back(test) for test in tests):
            yield f"the crease folds elastically up to {shown_value('yield_moment', moment)}: no yield moment is known"
        else:
            yield from without
    if "damping" not in keys:
        yield from (reason for reason in refused if reason.startswith("damping: cannot"))
        if "yield_moment" in keys and any(reason.startswith("damping: cannot") for reason in refused):
            yield "a viscous loss, if there is one, counts as yielding"
    elif speeds := turning_speeds(tests):
        fastest = show_quantity(max(speeds), _SPEED)
        yield f"the damping was measured up to {fastest}; in faster motions it is extrapolated"
    sizes = [test.thickness for test in tests]
    if any(size is None for size in sizes):
        yield "the thickness is not known, so a design cannot compare it with that of its sheet; give --thickness"
