"""What is checked of the parts of a design before they are made."""

from __future__ import annotations

from forficula.dynamics import Record, as_record
from forficula.errors import InputError
from forficula.make.check import Check
from forficula.make.mesh_checks import mesh_checks
from forficula.make.part import PartSet


def check_parts(parts: PartSet, record: object = None) -> tuple[Check, ...]:
    """Check the parts of a design: of its sheet, what `cut_sheet` checks; of solids, that printers can take them.

    Args:
        parts: to check.
        record: of a run of the design, or its folder, to see who touches whom in it.

    Returns:
        One that fails says what to do about it; one that could not be made says why.

    Raises:
        InputError: the record is none, or of a design with other values.

    >>> parts = ff.make_parts("letter-fold", part="sheet")
    >>> all(check.ok for check in ff.check_parts(parts))
    True
    """
    if record is not None:
        _check_record(parts, as_record(record))
    sheet: tuple[Check, ...] = () if parts.sheet is None else parts.sheet.checks
    return (*sheet, *(check for part in parts.parts for check in mesh_checks(part)))


def _check_record(parts: PartSet, record: Record) -> None:
    """Refuse a run of another design; how parts are made is not of the run."""
    if record.design.hash != parts.design.hash:
        raise InputError(
            f"record: need a run of {parts.design.name} with the same values, got one of {record.design.name} with"
            " others; give both the same --set"
        )
