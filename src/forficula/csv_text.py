"""Tables as comma-separated text without formulas that a spreadsheet would run."""

from __future__ import annotations

import csv
import io
import re
from collections.abc import Iterable, Mapping, Sequence

# beginnings of cells that a spreadsheet would run as a formula; an apostrophe before them makes them text (OWASP, CSV
# Injection). Numbers are harmless.
_FORMULA = re.compile(r"[=+\-@\t\r]")
_NUMBER = re.compile(r"[+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?", re.ASCII)


def csv_text(rows: Iterable[Sequence[object]]) -> str:
    """Return rows of cells as text; an apostrophe precedes a text that a spreadsheet would run as a formula."""
    return "".join(f"{_line(row)}\n" for row in rows)


def csv_table(rows: Sequence[Mapping[str, object]]) -> str:
    """Return one row or more with the same keys as text, below a line with the keys; the cell of None is empty."""
    return csv_text([list(rows[0]), *(list(row.values()) for row in rows)])


def _line(row: Sequence[object]) -> str:
    text, end = io.StringIO(), "\r\n"
    # the csv module quotes a cell with a character of the line end: with "\r\n" it quotes every cell with a line break
    csv.writer(text, lineterminator=end).writerow([_cell(cell) for cell in row])
    return text.getvalue().removesuffix(end)


def _cell(cell: object) -> object:
    if isinstance(cell, str) and _FORMULA.match(cell) and not _NUMBER.fullmatch(cell):
        return f"'{cell}"
    return cell
