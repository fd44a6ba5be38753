"""Choices of a study that varies its factors one at a time: one changed value each, and their labels."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import replace

from forficula.design import CreaseLawSection, Design, LawSection, key_quantity, key_value, with_values
from forficula.errors import InputError
from forficula.quantities import as_written, format_quantity
from forficula.study.factors import Factor

# a dimension of the table, and the coordinate that names its entries
CHOICE = "choice"


def one_at_a_time(base: Design, factors: Sequence[Factor]) -> tuple[Mapping[str, object], ...]:
    """Return the base, then every value of every factor alone. Values that the base already has are omitted.

    Args:
        base: the design that is varied.
        factors: factors with values.

    Returns:
        For each choice, the value of one factor by its key. The first is empty: the base.
    """
    choices: list[Mapping[str, object]] = [{}]
    identities = {base.hash}
    for factor in factors:
        for value in factor.values:
            identity = _identity(base, factor.key, value)
            if identity not in identities:
                identities.add(identity)
                choices.append({factor.key: value})
    return tuple(choices)


def _identity(base: Design, key: str, value: object) -> str:
    """Return the hash of the design with a value, or the label of the choice if the design is not allowed."""
    try:
        return with_values(base, {key: value}).hash
    except InputError:
        return choice_label(base, {key: value})


def choice_label(base: Design, choice: Mapping[str, object]) -> str:
    """Return a choice in words, such as "hinge.damping = 1e-3 N m s/rad"; for the base its name."""
    words = [f"{key} = {value if isinstance(value, str) else as_written(value)}" for key, value in choice.items()]
    return ", ".join(words) or base.name


def own_value(base: Design, factor: Factor) -> object:
    """Return the base's value of a factor, as in a design file; if it has none, "none" or nan."""
    value, quantity = key_value(base, factor.key), key_quantity(factor.key, type(base))
    if value is None:
        return "none" if factor.unit is None else math.nan
    if isinstance(value, LawSection | CreaseLawSection):
        return value.name
    if quantity is not None and isinstance(value, float):
        return format_quantity(value, quantity.unit)
    return list(value) if isinstance(value, tuple) else value


def with_own_word(base: Design, factor: Factor) -> Factor:
    """Add the base's value to a factor if it is a word. Such values have no common unit."""
    quantity, base_value = key_quantity(factor.key, type(base)), own_value(base, factor)
    is_word = quantity is not None and base_value in quantity.words and base_value not in factor.values
    return replace(factor, values=(*factor.values, base_value)) if is_word else factor
