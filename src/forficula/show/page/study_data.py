"""A study's table as data for its page: factors, columns, quantities to map, and why values are missing."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from forficula.analysis import FOLDED, OPENED, Verdict
from forficula.quantities import reading_unit
from forficula.show.study.factor_text import display_values, number_text, plain_name, value_with_unit
from forficula.show.study.map_page import (
    DIVERGED,
    NOT_BUILT,
    NOT_FOLDED,
    NOT_OPENED,
    NOT_RUN,
    NOT_STAYED,
    NOT_STAYED_OPEN,
    NOT_TRIED,
    STILL_FOLDING,
    STILL_OPENING,
    STUCK,
    UNTRUSTED,
)
from forficula.show.study.maps import missing_reasons
from forficula.study import Study
from forficula.study.choices import CHOICE

if TYPE_CHECKING:
    from xarray import DataArray, Dataset

# what a map shows: group, whose maps share a scale where that is said, and title; in the order of the page's choice
_TORQUES = {"least_fold_torque": "least fold torque", "least_unfold_torque": "least unfold torque"}
_WORKS = {"fold_work": "work of folding", "unfold_work": "work of unfolding"}
_ENERGIES = {
    "flat_energy": "tendons' energy when flat",
    "folded_energy": "tendons' energy when folded",
    "opened_energy": "tendons' energy when opened",
}
_TIMES = {"fold_time": "fold time", "unfold_time": "opening time"}
_GROUPS = (("torque", _TORQUES), ("time", _TIMES), ("work", _WORKS), ("energy", _ENERGIES))
# a sign for each reason, so that no one needs to tell colours apart
_SIGNS = {
    OPENED: "●",
    FOLDED: "◆",
    NOT_STAYED_OPEN: "↻",
    STILL_OPENING: "◁",
    NOT_OPENED: "■",
    NOT_FOLDED: "×",
    STUCK: "✱",
    STILL_FOLDING: "▷",
    NOT_STAYED: "↺",
    DIVERGED: "✚",
    UNTRUSTED: "≠",
    NOT_BUILT: "⊘",
    NOT_TRIED: "–",
    NOT_RUN: "·",
}
_WITH_TORQUE, _OTHER = "⊗", "?"
_DIGITS = 7


def study_data(study: Study, table: Dataset) -> dict[str, Any]:
    """What a page needs to know of a study, as data for JSON.

    Args:
        study: what was asked.
        table: what came out.

    Returns:
        Every list with an entry a point has the study's order, in which the last factor runs fastest; numbers are in
        the unit that stands beside them, None where there is none.

        - `points`: how many; `sampled`: whether they were drawn.
        - `factors`: `key`, `name`, `unit`, and `values`: of the grid, or a point each where they were drawn. Where
          factors are varied one at a time, their choices are the first of these.
        - `axes`: numbers of the factors in the order in which maps take them for axes; `cuts`: number of each one's
          value at which maps of the others lie.
        - `words`: what became of points, those that came furthest first: `word`, `sign`, and `count` of the points with
          it as their outcome.
        - `verdicts`: a number of `words` a point; `statuses`: the full texts; `built`: whether there is a wing.
        - `quantities`: for maps and for the table's columns: `name`, `title`, `group`, `unit`, `values`, and `reasons`:
          a number of `words` a point, None where there is a value. The first is the verdict and has no values.
    """
    words = _Words(sorted({str(word) for word in table["outcome"].values.ravel()}, key=_rank))
    verdicts = words.numbers(table["outcome"])
    quantities = [
        {"name": "status", "title": "outcome", "group": "outcome", "unit": "", "values": None, "reasons": verdicts},
        *(_quantity(table, name, title, group, words) for group, name, title in _drawn(table)),
        *_times_by_torque(table, words),
    ]
    drawn = [factor.dimension for factor in study.factors]
    names = drawn if study.sampled else [str(name) for name in table["status"].dims]
    return {
        "name": study.name,
        "design": study.base.name,
        "points": len(study.points),
        "sampled": study.sampled,
        "search": study.search is not None,
        "factors": [_factor(table[name]) for name in names],
        "axes": sorted(range(len(names)), key=lambda index: names[index] == CHOICE),
        "cuts": [0 if name == CHOICE else table[name].size // 2 for name in names],
        "built": [str(verdict) != Verdict.NOT_BUILT for verdict in table["verdict"].values.ravel()],
        "statuses": [str(status) for status in table["status"].values.ravel()],
        "verdicts": verdicts,
        "quantities": quantities,
        "words": words.data(verdicts),
    }


class _Words:
    """What became of points, each word once, with a number."""

    def __init__(self, first: Sequence[str]) -> None:
        self._numbers = {word: number for number, word in enumerate(first)}

    def number(self, word: str) -> int:
        return self._numbers.setdefault(word, len(self._numbers))

    def numbers(self, words: DataArray) -> list[int]:
        return [self.number(str(word)) for word in words.values.ravel()]

    def data(self, verdicts: Sequence[int]) -> list[dict[str, Any]]:
        counts = Counter(verdicts)
        return [{"word": word, "sign": _sign(word), "count": counts[number]} for word, number in self._numbers.items()]


def _rank(word: str) -> tuple[int, str]:
    """Those that came furthest first."""
    return [*_SIGNS, word].index(word), word


def _sign(word: str) -> str:
    return _SIGNS.get(word) or (_WITH_TORQUE if " with " in word else _OTHER)


def _drawn(table: Dataset) -> Iterator[tuple[str, str, str]]:
    """Group, name and title of the numbers that a table has."""
    for group, names in _GROUPS:
        for name, title in names.items():
            if name in table:
                yield group, name, title


def _factor(factor: DataArray) -> dict[str, Any]:
    values, unit = display_values(factor)
    return {
        "key": str(factor.attrs.get("key", factor.name)),
        "name": plain_name(factor),
        "unit": unit,
        "values": [_rounded(value) for value in values.tolist()],
        "texts": [number_text(value) for value in values.tolist()],
    }


def _quantity(table: Dataset, name: str, title: str, group: str, words: _Words) -> dict[str, Any]:
    numbers = table[name].values.ravel()
    unit, scale = _unit(table[name], numbers)
    values = [_rounded(scale * value) for value in numbers.tolist()]
    return {
        "name": name,
        "title": title,
        "group": group,
        "unit": unit,
        "values": values,
        "reasons": _reasons(values, missing_reasons(table, name).values.ravel(), words),
    }


def _reasons(values: Sequence[float | None], reasons: NDArray[np.object_], words: _Words) -> list[int | None]:
    """Why there is no value, where there is none."""
    pairs = zip(values, reasons.tolist(), strict=True)
    return [words.number(str(reason)) if value is None else None for value, reason in pairs]


def _times_by_torque(table: Dataset, words: _Words) -> Iterator[dict[str, Any]]:
    """A map a fold torque that was tried, all in one unit."""
    if "fold_time_by_torque" not in table:
        return
    times, torques = table["fold_time_by_torque"], table["fold_torque"]
    unit, scale = _unit(times, times.values)
    for index in range(torques.size):
        values = [_rounded(scale * value) for value in times.isel(fold_torque=index).values.ravel().tolist()]
        became = table["fold_outcome_by_torque"].isel(fold_torque=index).values.ravel()
        yield {
            "name": f"fold_time_by_torque:{index}",
            "title": f"fold time with {value_with_unit(torques, index)}",
            "group": "time by torque",
            "unit": unit,
            "values": values,
            "reasons": _reasons(values, became, words),
        }


def _unit(variable: DataArray, values: Any) -> tuple[str, float]:
    """The unit in which values read well, and its factor from SI."""
    largest = np.nanmax(np.abs(values), initial=0.0, where=np.isfinite(values))
    return reading_unit(str(variable.attrs["units"]), float(largest))


def _rounded(value: Any) -> Any:
    """A number with the digits that anyone reads; None for none."""
    if not isinstance(value, float):
        return value
    return float(f"{value:.{_DIGITS}g}") if math.isfinite(value) else None
