"""Points that were drawn or proposed, as data for a page: their values, numbers and outcomes."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

from forficula.quantities import Unit, parse_quantity
from forficula.show.page.data.study_data import factor_data, rounded
from forficula.show.page.parts.outcome_words import OTHER_LOOK, OutcomeSigns, OutcomeWords
from forficula.show.page.parts.run_sentences import unbuilt_text

if TYPE_CHECKING:
    from xarray import DataArray, Dataset


# bound of a margin: it is met from 0 on
MET = ((">=", 0.0),)


@dataclass(frozen=True, kw_only=True)
class PointQuantity:
    """Quantity that every point may have.

    Attributes:
        variable: name in the table.
        title: name on the page.
        aim: "least" or "largest" for an objective.
        bounds: limits, ">=" or "<=" with a value in SI.
    """

    variable: str
    title: str
    aim: str = ""
    bounds: tuple[tuple[str, float], ...] = ()


@dataclass(frozen=True, kw_only=True)
class ShownSamples:
    """Points and the words of their page.

    Attributes:
        name: name of the goal or design.
        noun: noun for one point.
        file: file that lists all points.
        keeps: sentence on which runs are kept.
        table: table over one dimension.
        factors: names of the coordinates that vary.
        numbers: other quantities of the points.
        words: outcome of each point in a few words, (point,).
        signs: signs of these words, the best outcome first.
        statuses: full outcome texts, (point,).
        built: whether each point could run, (point,).
        nominal: values of the nominal design, SI, by factor.
    """

    name: str
    noun: str
    file: str
    keeps: str
    table: Dataset
    factors: tuple[str, ...]
    numbers: tuple[PointQuantity, ...]
    words: Sequence[str]
    signs: OutcomeSigns
    statuses: Sequence[str]
    built: Sequence[bool]
    nominal: dict[str, float] = field(default_factory=dict)


def samples_data(samples: ShownSamples) -> dict[str, Any]:
    """Return points as data for JSON.

    Returns:
        As `study_data` returns for a study with drawn points. A factor may have `own`, the value of the nominal design;
        a quantity has `aim` and `limits`, each with `kind` and `bound`, in its unit.
    """
    words = OutcomeWords(sorted(set(samples.words), key=samples.signs.rank), samples.signs)
    verdicts = [words.number(word) for word in samples.words]
    outcome = {"name": "status", "title": "outcome", "group": "outcome", "unit": "", "values": None}
    quantities = [
        outcome | {"energy": False, "reasons": verdicts, "transition": None},
        *(_number_data(samples.table[number.variable], number, verdicts) for number in samples.numbers),
    ]
    return {
        "name": samples.name,
        "noun": samples.noun,
        "file": samples.file,
        "keeps": samples.keeps,
        "unbuilt": unbuilt_text(samples.noun),
        "points": len(verdicts),
        "sampled": True,
        "search": False,
        "factors": [_factor(samples, name) for name in samples.factors],
        "axes": list(range(len(samples.factors))),
        "cuts": [0] * len(samples.factors),
        "built": list(samples.built),
        "statuses": list(samples.statuses),
        "verdicts": verdicts,
        "quantities": quantities,
        "words": words.data(verdicts),
        "other": OTHER_LOOK,
    }


def _factor(samples: ShownSamples, name: str) -> dict[str, Any]:
    coordinate = samples.table[name]
    nominal = samples.nominal.get(name)
    return factor_data(coordinate) | {"own": None if nominal is None else rounded(nominal * scale_of(coordinate))}


def _number_data(variable: DataArray, number: PointQuantity, verdicts: Sequence[int]) -> dict[str, Any]:
    scale = scale_of(variable)
    values = [rounded(float(scale * value)) for value in variable.values.astype(float)]
    return {
        "name": number.variable,
        "title": number.title,
        "group": "number",
        "unit": str(variable.attrs.get("display") or variable.attrs.get("units", "")),
        "energy": variable.attrs.get("units") == "J",
        "values": values,
        "reasons": [word if value is None else None for value, word in zip(values, verdicts, strict=True)],
        "transition": None,
        "aim": number.aim,
        "limits": [{"kind": kind, "bound": rounded(scale * bound)} for kind, bound in number.bounds],
    }


def scale_of(variable: DataArray) -> float:
    """Return the factor from SI to a variable's display unit; shares are shown in per cent."""
    display, si = str(variable.attrs.get("display", "")), str(variable.attrs.get("units", ""))
    if display == "%" and not si:
        return 100.0
    if variable.dtype.kind not in "iuf" or not display or not si or display == si:
        return 1.0
    return 1.0 / parse_quantity(f"1 {display}", Unit(display=display, si=si, example=f"1 {display}"))
