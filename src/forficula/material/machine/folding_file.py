"""Reading of folding tests from the files of testing machines."""

from __future__ import annotations

import os
from collections.abc import Sequence
from pathlib import Path

import numpy as np

from forficula.arrays import Array
from forficula.errors import InputError
from forficula.files import shown_path
from forficula.material.folding.folding_test import FoldingTest
from forficula.material.machine.machine_file import in_si, recordings_in
from forficula.material.machine.machine_names import is_angle, is_moment
from forficula.material.machine.machine_units import (
    ANGLE,
    FORCE,
    LENGTH,
    MOMENT,
    MOMENT_BY_WIDTH,
    TIME,
    ColumnKind,
)
from forficula.material.machine.recording import RecordedColumn, Recording, message_at_line
from forficula.material.machine.specimen import strip_size
from forficula.material.tensile.tensile_test import UNITS, falling
from forficula.quantities import as_written


def read_folding_tests(
    paths: Sequence[str | os.PathLike[str]],
    *,
    width: float | None = None,
    thickness: float | None = None,
    lever: float | None = None,
) -> tuple[FoldingTest, ...]:
    """Read the folding tests of several strips in the order of the files. A file may contain several tests.

    A file has columns of fold angle and moment. Instead of the angle it may have the travel d of a machine that pushes
    one panel at the constant distance a from the crease, the lever arm, normal to the other panel, which is clamped:
    the angle is arctan(d / a). Instead of the moment it may have the force F: with a travel the moment is
    F (a^2 + d^2) / a, so that the work of force and moment is equal; with an angle it is F a, with a force normal to
    the panel. A column of time is needed only to determine viscosity. Formats are those of `read_tensile_test`.

    Args:
        paths: paths of the files.
        width: length of the crease, m; needed if a file does not give the width of the strip.
        thickness: thickness of the strip, m, if a file does not give it.
        lever: lever arm, m; needed with a travel or a force if a file does not give it.

    Raises:
        InputError: there is no file, a file cannot be read, it has no column of angle or moment, a column has a wrong
            unit, or the width or the lever arm is missing. The message names the file and, if there is one, the line.
    """
    if not paths:
        raise InputError("need at least one file of a folding test, got none")
    tests: list[FoldingTest] = []
    for path in map(Path, paths):
        try:
            recordings = recordings_in(path, "folding")
            tests += [_folding_test(recording, width, thickness, lever) for recording in recordings]
        except InputError as error:
            raise InputError(f"{shown_path(path)}: {error}") from error
    return tuple(tests)


def has_angles(path: str | os.PathLike[str]) -> bool:
    """Return whether a file has a column of angles or moments, and is therefore a folding test."""
    try:
        recordings = recordings_in(Path(path), "folding")
    except InputError:
        return False
    columns = [column for recording in recordings for column in (recording.travel, recording.force)]
    return any(
        is_angle(column.name)
        or is_moment(column.name)
        or any(kind.factor(column.unit) is not None for kind in (ANGLE, MOMENT, MOMENT_BY_WIDTH))
        for column in columns
    )


def _folding_test(
    recording: Recording, width: float | None, thickness: float | None, lever: float | None
) -> FoldingTest:
    """Convert a recording to SI and check it, with errors that name lines of the file."""
    line, properties = recording.names_line, recording.properties
    time = None
    if recording.time.name:
        time, _ = in_si(recording.time, line, TIME)
        if (row := falling(time)) is not None:
            before, after = recording.time.values[row - 1 : row + 1]
            message = f"{recording.time.name}: need times that never decrease, got {after:g} after {before:g}"
            raise InputError(message_at_line(int(recording.lines[row]), message))
    travel, turns = in_si(recording.travel, line, ANGLE, None if is_angle(recording.travel.name) else LENGTH)
    force, kind = _moment(recording.force, line)
    arm = strip_size("lever", properties, lever)
    if arm is None and (kind is FORCE or not turns):
        lacking = [recording.travel.name] * (not turns) + [recording.force.name] * (kind is FORCE)
        raise InputError(
            f"lever: is not in the file; give the lever arm, such as {UNITS['lever'].example}, from which angle and"
            f" moment follow, because the file has {' and '.join(lacking)} instead"
        )
    across = strip_size("width", properties, width)
    if across is None:
        raise InputError(f"width: is not in the file; give the width of the strip, such as {UNITS['width'].example}")
    angle, moment = travel, force
    if kind is FORCE:
        assert arm is not None
        moment = force * arm if turns else force * (arm**2 + travel**2) / arm
    elif kind is MOMENT_BY_WIDTH:
        moment = force * across
    if not turns:
        assert arm is not None
        angle = np.arctan(travel / arm)
    return FoldingTest(
        name=recording.name,
        time=time,
        angle=angle,
        moment=moment,
        width=across,
        thickness=strip_size("thickness", properties, thickness),
    )


def _moment(column: RecordedColumn, line: int) -> tuple[Array, ColumnKind]:
    """Convert a column, shape (row,), to SI as a moment, a moment per width or a force; return its kind."""
    kinds = (MOMENT, MOMENT_BY_WIDTH) if is_moment(column.name) else (MOMENT, MOMENT_BY_WIDTH, FORCE)
    for kind in kinds:
        if (factor := kind.factor(column.unit)) is not None:
            return column.values * factor, kind
    what = f"{as_written(column.unit)} is not its unit" if column.unit else "the unit is missing"
    other = ", or a unit of force" if FORCE in kinds else f", or per width one of {', '.join(MOMENT_BY_WIDTH.factors)}"
    raise InputError(message_at_line(line, f"{column.name}: {what}; {MOMENT.rule()}{other}"))
