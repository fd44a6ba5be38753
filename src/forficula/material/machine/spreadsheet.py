"""Workbooks (.xlsx, .xls, .ods) with tensile tests, read by python-calamine (MIT, an optional extra)."""

from __future__ import annotations

import io
from dataclasses import replace
from typing import Any

from forficula.errors import InputError, error_prefix
from forficula.material.machine.machine_names import Test, is_role, split_unit
from forficula.material.machine.machine_text import recordings_of
from forficula.material.machine.recording import Recording
from forficula.optional_module import optional_module

_MOST_CELLS = 20_000_000
SPREADSHEETS = (".xlsx", ".xlsm", ".xls", ".ods")


def parse_spreadsheet(content: bytes, name: str, test: Test = "tensile") -> tuple[Recording, ...]:
    """Find the tables of tensile tests in the sheets of a workbook.

    Sheets without a row that names two measured quantities, such as sheets of results, are left out.

    Args:
        content: of the file.
        name: of the specimen; several get a number each.
        test: kind of the test.

    Returns:
        The columns in the units of the file, one entry for each specimen.

    Raises:
        InputError: python-calamine is not installed, the file is not a workbook, or no sheet has a tensile test.
    """
    result: list[Recording] = []
    titles = []
    for title, rows in _sheets(content):
        titles.append(title)
        lines = [number for number, row in enumerate(rows, start=1) if any(row)]
        cells = [row for row in rows if any(row)]
        if any(sum(is_role(split_unit(cell)[0], test) for cell in row) > 1 for row in cells):
            with error_prefix(f'sheet "{title}": '):
                result += recordings_of(cells, lines, name, test)
    if not result:
        raise InputError(f"need a sheet with columns of time, travel and force, got {', '.join(titles) or 'no sheet'}")
    if len(result) == 1:
        return tuple(result)
    return tuple(replace(recording, name=f"{name} {number}") for number, recording in enumerate(result, start=1))


def _sheets(content: bytes) -> list[tuple[str, list[list[str]]]]:
    """Return the title and the cells of every sheet."""
    calamine = optional_module(
        "python_calamine", "reading a workbook needs python-calamine", "forficula[xlsx]", "or save the sheet as .csv"
    )
    try:
        workbook = calamine.CalamineWorkbook.from_filelike(io.BytesIO(content))
        return [
            (title, [[_text(cell) for cell in row] for row in _cells(workbook.get_sheet_by_name(title))])
            for title in workbook.sheet_names
        ]
    except (calamine.CalamineError, OSError, ValueError) as error:
        raise InputError(f"need a workbook (.xlsx, .xls or .ods): {error}") from None


def _cells(sheet: Any) -> list[list[object]]:
    """Return the rows of a sheet, the empty ones at its top included, which count in the numbers of rows."""
    if (size := sheet.total_height * sheet.total_width) > _MOST_CELLS:
        raise InputError(f'sheet "{sheet.name}": need at most {_MOST_CELLS} cells, got {size}')
    rows: list[list[object]] = sheet.to_python(skip_empty_area=False)
    return rows


def _text(cell: object) -> str:
    """Return a cell as an exported text would have it; a number keeps all digits and a decimal point."""
    return repr(cell) if isinstance(cell, float) else str(cell).strip()
