"""Tensile tests out of the files of testing machines."""

from __future__ import annotations

import os
from collections.abc import Sequence
from pathlib import Path

from forficula.arrays import Array
from forficula.errors import InputError
from forficula.files import read_bytes, shown_path
from forficula.material.machine.machine_text import parse_recordings
from forficula.material.machine.machine_units import FORCE, LENGTH, STRAIN, STRESS, TIME, ColumnKind
from forficula.material.machine.recording import RecordedColumn, Recording, at_line
from forficula.material.machine.specimen import specimen_area, specimen_length
from forficula.material.machine.spreadsheet import SPREADSHEETS, parse_spreadsheet
from forficula.material.machine.zs2_file import parse_zs2
from forficula.material.tensile.tensile_test import TensileTest, falling
from forficula.quantities import as_written

_LARGEST = 2**29  # bytes of a file: a hundred hours of ten columns


def read_tensile_test(
    path: str | os.PathLike[str], *, length: float | None = None, area: float | None = None
) -> TensileTest:
    """Read one tensile test from what a testing machine exported.

    ZwickRoell testXpert .TXT, .TRA and .CSV, Instron Bluehill .csv and plain tables, in English or German (some
    French); encoding, delimiter, decimal sign and units are found in the file. Where it holds no travel, its strain
    times the length is taken; where it holds no force, its stress times the area; a position of the crosshead counts
    from the first row. Specimens may be below each other or side by side, and in several sheets of a workbook. A .zs2
    needs the extra `zs2`, an .xlsx, .xls or .ods the extra `xlsx`.

    Args:
        path: the file.
        length: of the specimen, m; needed where the file does not give it.
        area: of its cross-section, m2; needed where the file gives neither it nor the edges or diameter.

    Returns:
        The test in SI.

    Raises:
        InputError: the file cannot be read, is cut off, of an unknown format, has no column of time, travel or force, a
            unit that is missing, unknown or mixed, a cell that is no number, or time that falls; or its length or area
            is missing or in conflict with the one given. The message names the file and, where there is one, the line.
    """
    tests = read_tensile_tests([path], length=length, area=area)
    if len(tests) != 1:
        names = ", ".join(test.name for test in tests)
        raise InputError(f"{shown_path(Path(path))}: need one specimen, got {len(tests)}: {names}")
    return tests[0]


def read_tensile_tests(
    paths: Sequence[str | os.PathLike[str]], *, length: float | None = None, area: float | None = None
) -> tuple[TensileTest, ...]:
    """Read the tensile tests of several specimens, in the order of the files, each of which may hold several.

    Args:
        paths: the files.
        length: of every specimen, m; as `read_tensile_test` takes it.
        area: of every specimen's cross-section, m2.

    Raises:
        InputError: there is no file, or what `read_tensile_test` says of any of them.
    """
    if not paths:
        raise InputError("need at least one file of a tensile test, got none")
    tests: list[TensileTest] = []
    for path in map(Path, paths):
        try:
            tests += [_tensile_test(recording, length, area) for recording in _recordings(path)]
        except InputError as error:
            raise InputError(f"{shown_path(path)}: {error}") from error
    return tuple(tests)


def _recordings(path: Path) -> tuple[Recording, ...]:
    """What a file holds, one entry a specimen."""
    content = read_bytes(path, _LARGEST)
    if path.suffix.lower() == ".zs2":
        return parse_zs2(content, path.stem)
    if path.suffix.lower() in SPREADSHEETS:
        return parse_spreadsheet(content, path.stem)
    return parse_recordings(content, path.stem)


def _tensile_test(recording: Recording, length: float | None, area: float | None) -> TensileTest:
    """Columns in SI, checked where the lines are still known."""
    line = recording.names_line
    time, _ = _in_si(recording.time, line, TIME)
    if (falls := falling(time)) is not None:
        before, after = recording.time.values[falls - 1 : falls + 1]
        message = f"{recording.time.name}: need times that never fall, got {after:g} after {before:g}"
        raise InputError(at_line(int(recording.lines[falls]), message))
    if len(time) < 2:
        raise InputError(at_line(line, "need at least two rows of numbers, got one: is it cut off?"))
    travel, is_travel = _in_si(recording.travel, line, LENGTH, STRAIN)
    force, is_force = _in_si(recording.force, line, FORCE, STRESS)
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


def _in_si(column: RecordedColumn, line: int, kind: ColumnKind, other: ColumnKind | None = None) -> tuple[Array, bool]:
    """A column's values, shape (row,), as one kind or else the other, and whether it is the first."""
    if (factor := kind.factor(column.unit)) is not None:
        return column.values * factor, True
    if other is not None and (factor := other.factor(column.unit)) is not None:
        return column.values * factor, False
    what = f"{as_written(column.unit)} is not its unit" if column.unit else "the unit is missing"
    raise InputError(at_line(line, f"{column.name}: {what}; {kind.rule()}"))
