"""Content of a testing machine's file, before conversion to SI."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray


@dataclass(frozen=True, kw_only=True, eq=False)
class RecordedColumn:
    """A column of a file.

    Attributes:
        name: name as written, without the unit.
        unit: unit as written, without brackets; empty if the file gives none.
        values: values in that unit, shape (row,).
    """

    name: str
    unit: str
    values: NDArray[np.float64]


@dataclass(frozen=True, kw_only=True)
class Property:
    """A line above the table with a number, such as `"L0" 60.0 "mm"`.

    Attributes:
        label: label as written, without the unit.
        value: value in that unit.
        rounding: half of the last written digit, in that unit.
        unit: unit as written, without brackets; empty if the file gives none.
        line: number of the line, from 1; 0 in a file without lines.
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
        name: name of the specimen.
        time: time of the test.
        travel: travel of the machine, or a strain.
        force: force on the specimen, or a stress.
        properties: properties in the order of the file.
        names_line: number of the line with the names, from 1; 0 in a file without lines.
        lines: number of the line of every row, shape (row,); all 0 in a file without lines.
    """

    name: str
    time: RecordedColumn
    travel: RecordedColumn
    force: RecordedColumn
    properties: tuple[Property, ...]
    names_line: int
    lines: NDArray[np.int64]


def travel_among(columns: Mapping[str, RecordedColumn]) -> RecordedColumn:
    """Return the column of travel, or else that of position, relative to the first row."""
    if "travel" in columns:
        return columns["travel"]
    position = columns["position"]
    return RecordedColumn(name=position.name, unit=position.unit, values=position.values - position.values[0])


def message_at_line(line: int, message: str) -> str:
    """Return a message that begins with the number of the line, if it is not 0."""
    return f"line {line}: {message}" if line else message
