"""Reading of tensile tests from the files of testing machines."""

from __future__ import annotations

import os
from collections.abc import Sequence
from pathlib import Path

from forficula.arrays import Array
from forficula.errors import InputError
from forficula.files import read_bytes, shown_path
from forficula.material.machine.machine_names import Test
from forficula.material.machine.machine_text import parse_recordings
from forficula.material.machine.machine_units import FORCE, LENGTH, STRAIN, STRESS, TIME, ColumnKind
from forficula.material.machine.recording import RecordedColumn, Recording, message_at_line
from forficula.material.machine.specimen import specimen_area, specimen_length
from forficula.material.machine.spreadsheet import SPREADSHEETS, parse_spreadsheet
from forficula.material.machine.zs2_file import parse_zs2
from forficula.material.tensile.tensile_test import TensileTest, falling
from forficula.quantities import as_written

_LARGEST = 2**29  # largest size of a file in bytes: a hundred hours of ten columns


def read_tensile_test(
    path: str | os.PathLike[str], *, length: float | None = None, area: float | None = None
) -> TensileTest:
    """Read one tensile test from a file that a testing machine exported.

    Supported are ZwickRoell testXpert .TXT, .TRA and .CSV, Instron Bluehill .csv and plain tables, in English or German
    (some French). Encoding, delimiter, decimal sign and units are detected. Without a column of travel, the strain
    times the length is used; without a column of force, the stress times the area. A position of the crosshead is
    relative to the first row. Specimens may be below each other or side by side, and in several sheets of a workbook. A
    .zs2 file needs the extra `zs2`, an .xlsx, .xls or .ods file the extra `xlsx`.

    Args:
        path: path of the file.
        length: length of the specimen, m; needed if the file does not give it.
        area: cross-section of the specimen, m2; needed if the file gives neither the area nor edges or a diameter.

    Returns:
        The test in SI.

    Raises:
        InputError: the file cannot be read, is cut off, or has an unknown format; it has no column of time, travel or
            force, a missing, unknown or mixed unit, a cell that is not a number, or time that decreases; or the length
            or area is missing or contradicts the given one. The message names the file and, if there is one, the line.
    """
    tests = read_tensile_tests([path], length=length, area=area)
    if len(tests) != 1:
        names = ", ".join(test.name for test in tests)
        raise InputError(f"{shown_path(Path(path))}: need one specimen, got {len(tests)}: {names}")
    return tests[0]


def read_tensile_tests(
    paths: Sequence[str | os.PathLike[str]], *, length: float | None = None, area: float | None = None
) -> tuple[TensileTest, ...]:
    """Read the tensile tests of several specimens in the order of the files. A file may contain several tests.

    Args:
        paths: paths of the files.
        length: length of every specimen, m, as for `read_tensile_test`.
        area: cross-section of every specimen, m2, as for `read_tensile_test`.

    Raises:
        InputError: there is no file, or one of the errors of `read_tensile_test`.
    """
    if not paths:
        raise InputError("need at least one file of a tensile test, got none")
    tests: list[TensileTest] = []
    for path in map(Path, paths):
        try:
            tests += [_tensile_test(recording, length, area) for recording in recordings_in(path)]
        except InputError as error:
            raise InputError(f"{shown_path(path)}: {error}") from error
    return tuple(tests)


def recordings_in(path: Path, test: Test = "tensile") -> tuple[Recording, ...]:
    """Read the recordings of a file, one for each specimen."""
    content = read_bytes(path, _LARGEST)
    if path.suffix.lower() == ".zs2":
        return parse_zs2(content, path.stem)
    if path.suffix.lower() in SPREADSHEETS:
        return parse_spreadsheet(content, path.stem, test)
    return parse_recordings(content, path.stem, test)


def _tensile_test(recording: Recording, length: float | None, area: float | None) -> TensileTest:
    """Convert a recording to SI and check it, with errors that name lines of the file."""
    line = recording.names_line
    time, _ = in_si(recording.time, line, TIME)
    if (row := falling(time)) is not None:
        before, after = recording.time.values[row - 1 : row + 1]
        message = f"{recording.time.name}: need times that never decrease, got {after:g} after {before:g}"
        raise InputError(message_at_line(int(recording.lines[row]), message))
    if len(time) < 2:
        raise InputError(message_at_line(line, "need at least two rows of numbers, got one: is it cut off?"))
    travel, is_travel = in_si(recording.travel, line, LENGTH, STRAIN)
    force, is_force = in_si(recording.force, line, FORCE, STRESS)
    first_length = specimen_length(recording.properties, length)
    first_area = specimen_area(recording.properties, area)
    return TensileTest(
        name=recording.name,
        time=time,
        extension=travel if is_travel else travel * first_length,
        force=force if is_force else force * first_area,
        length=first_length,
        area=first_area,
    )


def in_si(column: RecordedColumn, line: int, kind: ColumnKind, other: ColumnKind | None = None) -> tuple[Array, bool]:
    """Convert a column, shape (row,), to SI as one kind of quantity or else the other; return if it is the first."""
    if (factor := kind.factor(column.unit)) is not None:
        return column.values * factor, True
    if other is not None and (factor := other.factor(column.unit)) is not None:
        return column.values * factor, False
    what = f"{as_written(column.unit)} is not its unit" if column.unit else "the unit is missing"
    raise InputError(message_at_line(line, f"{column.name}: {what}; {kind.rule()}"))
