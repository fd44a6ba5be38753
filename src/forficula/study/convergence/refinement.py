"""Settings that a convergence study varies (timestep, membrane modulus, mesh) and their allowed values."""

from __future__ import annotations

import math
import re
from collections.abc import Sequence
from itertools import pairwise

import numpy as np

from forficula.design import Design, key_value, with_values
from forficula.design.section import MODULUS, SHORT_TIME
from forficula.errors import InputError
from forficula.quantities import as_written, parse_quantity, show_quantity

TIMESTEP = "protocol.timestep"
YOUNGS_MODULUS = "membrane.youngs_modulus"
MESH = "membrane.rows"
_UNITS = {TIMESTEP: SHORT_TIME, YOUNGS_MODULUS: MODULUS}
_FINEST_MESH = 50
_SAME = 1e-9
# a comma separates only before a space: "0,5" may be meant as a decimal
_NUMBER_THEN_UNIT = re.compile(
    r"([+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)\s*([^\W\d_][^\s,]*)?(?:\s*,(?=\s)|\s|$)\s*"
)


def read_values(key: str, text: str) -> list[float]:
    """Read values such as "0.5 0.4 ms" or "0.5 ms, 0.4 ms". A number without a unit has the unit of the next number.

    Args:
        key: `TIMESTEP`, `YOUNGS_MODULUS`, or `MESH`, whose values are whole numbers without a unit.
        text: text as written by the user.

    Returns:
        The values in their order: s, Pa, or numbers.

    Raises:
        InputError: the text is no such list. The caller adds the option.
    """
    unit = _UNITS.get(key)
    right = f'such as "{_example(key)}"'
    items: list[tuple[str, str]] = []
    position, stripped = 0, text.strip()
    while position < len(stripped):
        match = _NUMBER_THEN_UNIT.match(stripped, position)
        if match is None:
            raise InputError(f"need numbers with spaces between {right}, got {as_written(text)}")
        items.append((match[1], match[2] or ""))
        position = match.end()
    following, values = "", []
    for number, written in reversed(items):
        following = written or following
        try:
            values.append(parse_quantity(f"{number} {following}", unit) if unit else _whole(number, following))
        except InputError as error:
            raise InputError(f"{error} in {as_written(text)}") from None
    values.reverse()
    check_values(key, values)
    return values


def value_text(key: str, value: float) -> str:
    """Return a value as people write it, such as "0.2 ms"."""
    unit = _UNITS.get(key)
    return show_quantity(value, unit) if unit else f"{value:g}"


def _example(key: str) -> str:
    return {TIMESTEP: "0.4 0.2 0.1 ms", YOUNGS_MODULUS: "0.5 1 2 MPa", MESH: "1 2 3"}[key]


def _whole(number: str, unit: str) -> float:
    if unit or not number.isdigit():
        raise InputError(f"need whole numbers, got {as_written(f'{number} {unit}'.strip())}")
    return float(number)


def check_values(key: str, values: Sequence[float]) -> None:
    """Reject values that cannot be compared.

    Raises:
        InputError: fewer than two values, equal values, or a value that the key does not allow.
    """
    right = f'such as "{_example(key)}"'
    if len(values) < 2:
        raise InputError(f"need at least two values {right}, got {len(values)}")
    for value in values:
        shown = value_text(key, value)
        if not 0 < value < math.inf:
            raise InputError(f"need values > 0 {right}, got {shown}")
        if (times := sum(same(value, other) for other in values)) > 1:
            raise InputError(f"need values that differ, got {shown} {times} times")
        if key == MESH and not (value == int(value) and value <= _FINEST_MESH):
            raise InputError(f"need whole numbers from 1 to {_FINEST_MESH}, got {shown}")


def same(one: float, other: float) -> bool:
    """Return whether two values are equal up to the rounding of units."""
    return math.isclose(one, other, rel_tol=_SAME)


def own_value(design: Design, key: str) -> float:
    """Return the design's own value: s, Pa, or 1 for its mesh.

    Raises:
        InputError: the design has no such setting.
    """
    section = key.partition(".")[0]
    if section not in type(design).model_fields:
        raise InputError(f"{key}: {design.name} has no {section}; need {TIMESTEP} to vary, or a design with one")
    if key == MESH:
        row_count(design)
        return 1.0
    return float(key_value(design, key))


def with_value(design: Design, key: str, value: float) -> Design:
    """Return the design with another timestep (s) or modulus (Pa), or with a mesh that is finer by a whole factor."""
    if key != MESH:
        return with_values(design, {key: value})
    times = int(value)
    proximal = _divided((*key_value(design, "membrane.proximal_rows"), 1.0), times)
    distal = _divided((0.0, *key_value(design, "membrane.distal_rows"), 1.0), times)[1:]
    return with_values(design, {"membrane.proximal_rows": proximal, "membrane.distal_rows": distal})


def _divided(shares: Sequence[float], times: int) -> list[float]:
    """Divide each gap between shares evenly, and omit the last share, which the mesh always has."""
    return [float(share) for low, high in pairwise(shares) for share in np.linspace(low, high, times, endpoint=False)]


def row_count(design: Design) -> int:
    """Return the number of rows of the mesh, including those at the ring fold and at the tip."""
    rows = (key_value(design, f"membrane.{part}_rows") for part in ("proximal", "distal"))
    return sum(len(shares) for shares in rows) + 2
