"""What stands in a machine's file, before anyone asks what it means."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray


@dataclass(frozen=True, kw_only=True, eq=False)
class RecordedColumn:
    """One measured quantity as the file has it.

    Attributes:
        name: as written, its unit taken off.
        unit: as written, brackets taken off; empty where the file gives none.
        values: in that unit, shape (row,).
    """

    name: str
    unit: str
    values: NDArray[np.float64]


@dataclass(frozen=True, kw_only=True)
class Property:
    """One line above the table that holds a number, such as `"L0" 60.0 "mm"`.

    Attributes:
        label: as written, its unit taken off.
        value: in that unit.
        rounding: half of the last digit that is written, in that unit.
        unit: as written, brackets taken off; empty where the file gives none.
        line: where it stands, from 1; 0 in a file without lines.
    """

    label: str
    value: float
    rounding: float
    unit: str
    line: int


@dataclass(frozen=True, kw_only=True, eq=False)
class Recording:
    """The columns of one specimen that a tensile test needs, and the properties in the same file.

    Attributes:
        name: of the specimen.
        time: of the test.
        travel: of the machine, or a strain.
        force: on the specimen, or a stress.
        properties: in the order of the file.
        names_line: where the names stand, from 1; 0 in a file without lines.
        lines: of every row, shape (row,); all 0 in a file without lines.
    """

    name: str
    time: RecordedColumn
    travel: RecordedColumn
    force: RecordedColumn
    properties: tuple[Property, ...]
    names_line: int
    lines: NDArray[np.int64]


def travel_among(columns: Mapping[str, RecordedColumn]) -> RecordedColumn:
    """The column of travel, or that of position, from where the test began."""
    if "travel" in columns:
        return columns["travel"]
    position = columns["position"]
    return RecordedColumn(name=position.name, unit=position.unit, values=position.values - position.values[0])


def at_line(line: int, message: str) -> str:
    """A message that begins with its line, where there is one."""
    return f"line {line}: {message}" if line else message
