"""Choices of a study that varies its factors one at a time: a value of one factor each, and how they are told."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import replace

from forficula.design import Design, LawSection, key_quantity, key_value, with_values
from forficula.errors import InputError
from forficula.quantities import as_written, format_quantity
from forficula.study.factors import Factor

# a dimension of the table, and the coordinate that names its entries
CHOICE = "choice"


def one_at_a_time(base: Design, factors: Sequence[Factor]) -> tuple[Mapping[str, object], ...]:
    """The base, then every value of every factor by itself, those left out that the base has.

    Args:
        base: that is varied.
        factors: with values.

    Returns:
        The value of one factor each, by its key; nothing for the base, which comes first.
    """
    choices: list[Mapping[str, object]] = [{}]
    there = {base.hash}
    for factor in factors:
        for value in factor.values:
            name = _design_name(base, factor.key, value)
            if name not in there:
                there.add(name)
                choices.append({factor.key: value})
    return tuple(choices)


def _design_name(base: Design, key: str, value: object) -> str:
    """What names the design with a value, or the value where there is no such design: its rows say why."""
    try:
        return with_values(base, {key: value}).hash
    except InputError:
        return choice_label(base, {key: value})


def choice_label(base: Design, choice: Mapping[str, object]) -> str:
    """A choice in words, such as "hinge.damping = 1e-3 N m s/rad"; the base's is its name."""
    words = [f"{key} = {value if isinstance(value, str) else as_written(value)}" for key, value in choice.items()]
    return ", ".join(words) or base.name


def own_value(base: Design, factor: Factor) -> object:
    """What the base has for a factor, as a design file has it; where it has nothing, "none", or not a number."""
    value, quantity = key_value(base, factor.key), key_quantity(factor.key, type(base))
    if value is None:
        return "none" if factor.unit is None else math.nan
    if isinstance(value, LawSection):
        return value.name
    if quantity is not None and isinstance(value, float):
        return format_quantity(value, quantity.unit)
    return list(value) if isinstance(value, tuple) else value


def with_own_word(base: Design, factor: Factor) -> Factor:
    """The factor with the base's value among its own where that is a word: such values have no unit in common."""
    quantity, own = key_quantity(factor.key, type(base)), own_value(base, factor)
    is_word = quantity is not None and own in quantity.words and own not in factor.values
    return replace(factor, values=(*factor.values, own)) if is_word else factor
