"""Designs and row keys of a study's points, computed when they are needed."""

from __future__ import annotations

import hashlib
import json
import math
import re
from collections import OrderedDict
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from forficula.design import Design
from forficula.errors import InputError
from forficula.study.points import GridPoints, SampledPoints
from forficula.study.running.evaluate import key_of_hash, row_key
from forficula.study.running.law_timestep import may_change_timestep, with_timestep_for_law
from forficula.study.study import Study
from forficula.study.study_designs import point_design

# Number of designs in memory, about 6 kB each: a study with fewer points builds each design once. [chosen]
_MOST_DESIGNS = 4096
# Number of designs from which the pattern of all designs is derived. [chosen]
_TRIED = 6
_MARK = re.compile(r'"<factor ([0-9]+)>"')


class StudyPlan(Mapping[int, "Design | str"]):
    """The design at every point of a study by index, or the reason why there is none.

    A design is built when it is needed, which takes about 0.3 ms. In a study of many points, the key of a row follows
    from the values of the point in about 10 us, without the design, if the study runs the protocol and varies numbers.
    """

    def __init__(self, study: Study) -> None:
        """Plan a study.

        Args:
            study: the study.
        """
        self.study = study
        self._designs: OrderedDict[int, Design | str] = OrderedDict()
        self._pattern = _pattern(self) if _has_keys_without_designs(study) else None

    def __len__(self) -> int:
        """Return the number of points."""
        return len(self.study.points)

    def __iter__(self) -> Iterator[int]:
        """Yield the indices of the points."""
        return iter(range(len(self)))

    def __getitem__(self, number: int) -> Design | str:
        """Return the design at a point, or why there is none."""
        if number not in self._designs:
            self._designs[number] = _design(self.study, number)
            if len(self._designs) > _MOST_DESIGNS:
                self._designs.popitem(last=False)
        return self._designs[number]

    def keys_without_designs(self, numbers: range) -> list[str | None]:
        """Return the key of the row of each point; None if only the design determines the key.

        If there is no row with such a key, the point may also have no valid design.
        """
        if self._pattern is None or not isinstance(self.study.points, GridPoints | SampledPoints):
            return [None] * len(numbers)
        return [self._pattern.key(values) for values in self.study.points.si_values(numbers).tolist()]


def _design(study: Study, number: int) -> Design | str:
    """Return the design at a point, or why there is none."""
    try:
        return with_timestep_for_law(point_design(study.base, study.points[number], study.search))
    except InputError as error:
        return str(error)


def _has_keys_without_designs(study: Study) -> bool:
    """Return whether the values of a study's points may be the only differences of its designs."""
    return (
        len(study.points) > _MOST_DESIGNS  # fewer designs are built once and kept
        and study.search is None
        and isinstance(study.points, GridPoints | SampledPoints)
        and not may_change_timestep(study.base)
    )


@dataclass(frozen=True, kw_only=True)
class _Pattern:
    """Text from which the hash of a design is computed, with gaps for the values of the factors.

    Attributes:
        texts: texts between the gaps.
        factors: index of the factor whose value fills each gap.
    """

    texts: tuple[str, ...]
    factors: tuple[int, ...]

    def key(self, values: list[float]) -> str | None:
        """Return the key of the row of a point with these values of the factors, SI; None if one of them is nan."""
        if any(math.isnan(value) for value in values):
            return None
        parts = [self.texts[0]]
        for factor, text in zip(self.factors, self.texts[1:], strict=True):
            parts += (repr(values[factor]), text)
        return key_of_hash(hashlib.sha256("".join(parts).encode()).hexdigest()[:16])


def _pattern(plan: StudyPlan) -> _Pattern | None:
    """Return the pattern of the designs of a plan; None if they differ in more than the values of the factors.

    The pattern is derived from a few designs in which every factor varies, and compared with the hash of another one.
    """
    points, count = plan.study.points, len(plan)
    assert isinstance(points, GridPoints | SampledPoints)
    numbers = sorted({count * part // (_TRIED - 1) - (part > 0) for part in range(_TRIED)} - {-1})
    values: dict[int, list[float]] = {
        number: points.si_values(range(number, number + 1))[0].tolist() for number in numbers
    }
    rows = {
        number: row
        for number, row in values.items()
        if not any(map(math.isnan, row)) and isinstance(plan[number], Design)
    }
    if not rows or any(
        len({row[index] for row in rows.values()}) == 1 and len(set(factor.values)) != 1
        for index, factor in enumerate(points.factors)
    ):
        return None
    designs = [design for number in rows if isinstance(design := plan[number], Design)]
    marked = _marked([design.hash_values() for design in designs], [*zip(*rows.values(), strict=True)])
    if marked is None:
        return None
    texts = _MARK.split(json.dumps(marked, sort_keys=True))
    pattern = _Pattern(texts=tuple(texts[::2]), factors=tuple(map(int, texts[1::2])))
    agree = all(row_key(design) == pattern.key(row) for design, row in zip(designs, rows.values(), strict=True))
    return pattern if agree else None


def _marked(values: Sequence[Any], factors: Sequence[tuple[float, ...]]) -> Any:
    """Replace what differs between the values of designs by marks of the factors; None if that is impossible.

    Args:
        values: values of each design.
        factors: for each factor, its value in each design, SI.
    """
    first = values[0]
    if isinstance(first, dict) and all(isinstance(value, dict) and value.keys() == first.keys() for value in values):
        entries = {key: _marked([value[key] for value in values], factors) for key in first}
        return None if any(entry is None for entry in entries.values()) else entries
    if isinstance(first, list) and all(isinstance(value, list) and len(value) == len(first) for value in values):
        items = [_marked(entries, factors) for entries in zip(*values, strict=True)]
        return None if any(item is None for item in items) else items
    if all(type(value) is type(first) and value == first for value in values):
        return first
    same = [index for index, factor in enumerate(factors) if factor == tuple(values)]
    # two factors with the same values in all of these designs would be ambiguous
    return f"<factor {same[0]}>" if len(same) == 1 and isinstance(first, float) else None
