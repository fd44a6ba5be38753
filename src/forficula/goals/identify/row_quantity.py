"""Quantities in rows of runs, by name: whether a state holds, times, works, energies, readings."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from forficula.design import Design
from forficula.design.section import ANGLE, LENGTH
from forficula.errors import InputError
from forficula.goals.outcome_quantity import quantities_of
from forficula.names import one_of
from forficula.quantities import Unit, as_written
from forficula.structure import first_state, structure_of
from forficula.study.running.journal import Row

_TERM = re.compile(r"\s*([+-]?)\s*(\d+\.?\d*(?:[eE][+-]?\d+)?|\.\d+)?\s*\*?\s*([A-Za-z][\w ]*?)\s*(?=[+-]|$)")


@dataclass(frozen=True, kw_only=True)
class RowQuantity:
    """A number in a run's row.

    Attributes:
        name: name, such as "fold_time"; for a state, its name.
        column: column of the row.
        unit: None for a state.
        factor: factor from the column's number to SI.
    """

    name: str
    column: str
    unit: Unit | None
    factor: float = 1.0

    def of(self, row: Row) -> float | None:
        """Return the number in SI, or 1 or 0 for a state; None if the row lacks it."""
        value = row.get(self.column)
        return None if value is None else self.factor * float(value)


Combination = tuple[tuple[float, RowQuantity], ...]


def row_quantities(design: Design) -> dict[str, RowQuantity]:
    """Return the quantities in rows of a design's runs, by name: states, quantities of goals, and readings."""
    structure = structure_of(design)
    states = [transition.state for transition in structure.transitions]
    quantities = [RowQuantity(name=state, column=state, unit=None) for state in states]
    # the energy residual is excluded, because it is a property of the computation that nobody observes
    quantities += [
        RowQuantity(name=quantity.name, column=quantity.column, unit=quantity.unit)
        for quantity in quantities_of(design).values()
        if quantity.source == "run" and quantity.unit.si
    ]
    start = first_state(structure, structure.stage_states)
    for state in (*([start] if start else []), *states):
        name = state.replace(" ", "_")
        quantities.append(
            RowQuantity(name=f"{name}_angle", column=f"{state}_angle_deg", unit=ANGLE, factor=math.radians(1.0))
        )
        quantities.append(RowQuantity(name=f"{name}_distance", column=f"{state}_distance_m", unit=LENGTH))
    return {quantity.name: quantity for quantity in quantities}


def read_combination(text: object, known: Mapping[str, RowQuantity]) -> Combination:
    """Read a quantity or a sum of quantities, such as "opened_energy - 0.5 folded_energy".

    Args:
        text: the quantity or sum, as in a file.
        known: quantities by name.

    Raises:
        InputError: an unknown quantity, or a sum of different units. The caller adds the key.
    """
    if not isinstance(text, str) or not text.strip():
        raise InputError(f"need {one_of(known, text)}")
    parts, position = [], 0
    while position < len(text):
        match = _TERM.match(text, position)
        if match is None:
            raise InputError(
                f'need a quantity or a sum such as "opened_energy - folded_energy", got {as_written(text)}'
            )
        sign, number, name = match.groups()
        if name not in known:
            raise InputError(f"need {one_of(known, name)}")
        parts.append(((-1.0 if sign == "-" else 1.0) * float(number or 1.0), known[name]))
        position = match.end()
    units = {part.unit.si if part.unit else "yes or no" for _, part in parts}
    if len(units) > 1:
        raise InputError(
            f"need a sum of quantities with one unit, got {' and '.join(sorted(units))} in {as_written(text)}"
        )
    return tuple(parts)


def combined(parts: Combination, row: Row) -> float | None:
    """Return the sum in SI; None if the row lacks one of its numbers."""
    values = [part.of(row) for _, part in parts]
    if any(value is None for value in values):
        return None
    return sum(share * value for (share, _), value in zip(parts, values, strict=True) if value is not None)


def is_state(parts: Sequence[tuple[float, RowQuantity]]) -> bool:
    """Return whether a combination is a single state."""
    return len(parts) == 1 and parts[0][1].unit is None
