"""What a run says in numbers, by name: whether a state holds, times, works, energies, readings."""

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
    """A number of a run's row.

    Attributes:
        name: such as "fold_time"; of a state that holds or does not, the state's.
        column: of the row.
        unit: None of a state.
        factor: from the column's number to SI.
    """

    name: str
    column: str
    unit: Unit | None
    factor: float = 1.0

    def of(self, row: Row) -> float | None:
        """The number in SI, of a state 1 where it holds and else 0; None where the row has none."""
        value = row.get(self.column)
        return None if value is None else self.factor * float(value)


Combination = tuple[tuple[float, RowQuantity], ...]


def row_quantities(design: Design) -> dict[str, RowQuantity]:
    """What runs of a design say, by name: states, what goals know of a run, and readings of what is furthest away."""
    structure = structure_of(design)
    states = [transition.state for transition in structure.transitions]
    found = [RowQuantity(name=state, column=state, unit=None) for state in states]
    # what is missing of the energy is of the computation, and nothing that anybody sees
    found += [
        RowQuantity(name=each.name, column=each.column, unit=each.unit)
        for each in quantities_of(design).values()
        if each.source == "run" and each.unit.si
    ]
    start = first_state(structure, structure.stage_states)
    for state in (*([start] if start else []), *states):
        name = state.replace(" ", "_")
        found.append(
            RowQuantity(name=f"{name}_angle", column=f"{state}_angle_deg", unit=ANGLE, factor=math.radians(1.0))
        )
        found.append(RowQuantity(name=f"{name}_distance", column=f"{state}_distance_m", unit=LENGTH))
    return {each.name: each for each in found}


def read_combination(text: object, known: Mapping[str, RowQuantity]) -> Combination:
    """Read a quantity or a sum of some, such as "opened_energy - 0.5 folded_energy".

    Args:
        text: as a file has it.
        known: quantities by name.

    Raises:
        InputError: none of these, or a sum of what has several units; the caller knows the key.
    """
    if not isinstance(text, str) or not text.strip():
        raise InputError(f"need {one_of(known, text)}")
    parts, place = [], 0
    while place < len(text):
        match = _TERM.match(text, place)
        if match is None:
            raise InputError(
                f'need a quantity or a sum such as "opened_energy - folded_energy", got {as_written(text)}'
            )
        sign, number, name = match.groups()
        if name not in known:
            raise InputError(f"need {one_of(known, name)}")
        parts.append(((-1.0 if sign == "-" else 1.0) * float(number or 1.0), known[name]))
        place = match.end()
    units = {part.unit.si if part.unit else "yes or no" for _, part in parts}
    if len(units) > 1:
        raise InputError(f"need a sum of what has one unit, got {' and '.join(sorted(units))} in {as_written(text)}")
    return tuple(parts)


def combined(parts: Combination, row: Row) -> float | None:
    """The sum in SI; None where the row lacks one of its numbers."""
    values = [part.of(row) for _, part in parts]
    if any(value is None for value in values):
        return None
    return sum(share * value for (share, _), value in zip(parts, values, strict=True) if value is not None)


def is_state(parts: Sequence[tuple[float, RowQuantity]]) -> bool:
    """Whether it is one state that holds or does not."""
    return len(parts) == 1 and parts[0][1].unit is None
