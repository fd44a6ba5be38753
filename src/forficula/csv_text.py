"""Tables as comma-separated text that a spreadsheet only shows."""

from __future__ import annotations

import csv
import io
import re
from collections.abc import Iterable, Sequence

# Cells that a spreadsheet would run as a formula begin so; an apostrophe before them makes them text (OWASP, CSV
# Injection). A number that happens to be text does no harm.
_FORMULA = re.compile(r"[=+\-@\t\r]")
_NUMBER = re.compile(r"[+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?", re.ASCII)


def csv_text(rows: Iterable[Sequence[object]]) -> str:
    """Write rows of cells; a text that a spreadsheet would run as a formula gets an apostrophe before it."""
    return "".join(f"{_line(row)}\n" for row in rows)


def _line(row: Sequence[object]) -> str:
    text, end = io.StringIO(), "\r\n"
    # a cell is quoted for the signs of the line's end that are in it: with both of them every break is
    csv.writer(text, lineterminator=end).writerow([_cell(cell) for cell in row])
    return text.getvalue().removesuffix(end)


def _cell(cell: object) -> object:
    if isinstance(cell, str) and _FORMULA.match(cell) and not _NUMBER.fullmatch(cell):
        return f"'{cell}"
    return cell
