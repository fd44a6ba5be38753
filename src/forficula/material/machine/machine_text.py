"""Parsing of text files of testing machines, whose format is detected from the text itself.

ZwickRoell testXpert (.TXT, .TRA, .CSV), Instron Bluehill (.csv) and plain tables have a common structure: lines with
label, value and unit; a row of names; possibly a row of units; then numbers. They differ in encoding, delimiter,
decimal sign and language.
"""

from __future__ import annotations

import codecs
import csv
import io
import re
from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from forficula.arrays import Array
from forficula.errors import InputError
from forficula.material.machine.machine_names import Test, columns_by_specimen, is_role, split_unit
from forficula.material.machine.machine_units import is_unit
from forficula.material.machine.recording import Property, RecordedColumn, Recording, message_at_line, travel_among
from forficula.names import listed
from forficula.quantities import as_written

_DELIMITERS = ("\t", ";", ",")
_EITHER_SIGN = re.compile(r"[+-]?(?:\d+[.,]?\d*|[.,]\d+)(?:[eE][+-]?\d+)?")
_VALUE_AND_UNIT = re.compile(rf"({_EITHER_SIGN.pattern})\s*(.*)")
_SAMPLE = 100  # number of lines from which the delimiter is detected
_LONGEST_HEADER = 2000  # lines
_LONGEST_LINE = 100_000  # characters; the csv module rejects much longer cells
# a number such as 1,234, whose comma may be a decimal sign or separate thousands
_EITHER_COMMA = re.compile(r"[+-]?[1-9]\d{0,2},\d{3}")
_TABLE = "a table of time, extension and force, or for a folding test of angle and moment"
_KNOWN = (
    "known are ZwickRoell testXpert .TXT, .TRA and .CSV, Instron Bluehill .csv, tables with units in their names, each "
    "with tab, semicolon or comma between its columns, .zs2 and .xlsx"
)


def parse_recordings(content: bytes, name: str, test: Test = "tensile") -> tuple[Recording, ...]:
    """Find the tables of tensile tests in an exported text: one for each specimen, all below the same names.

    Numbers are converted by Python's `float`, column by column: 100 000 rows in about a third of a second.

    Args:
        content: content of the file.
        name: name of the specimen; a number is added if there are several.
        test: kind of the test.

    Returns:
        The columns in the file's units, one entry for each specimen.

    Raises:
        InputError: there is no such table, or it is cut off; the message begins with the line.
    """
    text = _decoded(content)
    if not text.strip():
        raise InputError(f"need {_TABLE}, got an empty file")
    long = next((number for number, line in enumerate(text.splitlines(), 1) if len(line) > _LONGEST_LINE), None)
    if long is not None:
        raise InputError(message_at_line(long, f"need at most {_LONGEST_LINE} characters on a line, got more"))
    return recordings_of(*_rows(text, _delimiter(text)), name, test)


def recordings_of(rows: list[list[str]], lines: list[int], name: str, test: Test = "tensile") -> tuple[Recording, ...]:
    """Find the tables of tensile tests among rows of cells: below each other, or side by side.

    Args:
        rows: cells of every row that is not empty.
        lines: number of every row in the file.
        name: of the specimen; several get a number each.
        test: kind of the test.

    Raises:
        InputError: as `parse_recordings` raises it.
    """
    header = _names_row(rows, test)
    starts = [number for number, row in enumerate(rows) if row == rows[header] and number >= header]
    tables: list[tuple[Recording, ...]] = []
    above = 0
    for number, start in enumerate(starts, start=1):
        end = starts[number] if number < len(starts) else len(rows)
        while end < len(rows) and end > start + 1 and not _is_numeric(rows[end - 1]):
            end -= 1  # rows above the next names
        shared = [] if start == header else tables[0][0].properties
        tables.append(_recordings(name, rows[above:end], lines[above:end], start - above, shared, test))
        if number > 1 and tables[-1][0].time.values[0] >= tables[-2][0].time.values[-1]:
            raise InputError(
                message_at_line(lines[start], "the names are repeated, but time continues: join the tables")
            )
        above = end
    recordings = [recording for table in tables for recording in table]
    if len(recordings) == 1:
        return tuple(recordings)
    return tuple(replace(recording, name=f"{name} {number}") for number, recording in enumerate(recordings, start=1))


def _recordings(
    name: str, rows: list[list[str]], lines: list[int], header: int, shared: Sequence[Property], test: Test
) -> tuple[Recording, ...]:
    """Parse one table, of one specimen or of several side by side.

    Properties are those above the table and those that it shares with the first table of the file.
    """
    names, units, first = _names_and_units(rows, lines, header)
    blocks = _columns_of_roles(names, lines[header], test)
    body, body_lines = rows[first:], lines[first:]
    if len(blocks) > 1:  # shorter specimens may leave out the cells at the end
        body = [[*row, *[""] * (len(names) - len(row))] for row in body]
    _check_widths(body, body_lines, names, lines[header])
    return tuple(
        _recording(name, columns, names, units, rows[:header], body, lines, header, body_lines, shared)
        for columns in blocks
    )


def _recording(
    name: str,
    columns: dict[str, int],
    names: Sequence[str],
    units: Sequence[str],
    above: list[list[str]],
    body: list[list[str]],
    lines: list[int],
    header: int,
    body_lines: list[int],
    shared: Sequence[Property],
) -> Recording:
    """The columns of one specimen; rows below its last number belong to longer specimens beside it."""
    cells = {role: [row[column] for row in body] for role, column in columns.items()}
    count = len(body)
    while count > 1 and not any(column[count - 1].strip() for role, column in cells.items() if role != "time"):
        count -= 1
    cells = {role: column[:count] for role, column in cells.items()}
    decimal = _decimal_sign(cells, body_lines)
    recorded = {
        role: RecordedColumn(name=names[column], unit=units[column], values=_numbers(cells[role], decimal, body_lines))
        for role, column in columns.items()
    }
    if "time" not in recorded:
        recorded["time"] = RecordedColumn(name="", unit="", values=np.arange(count, dtype=np.float64))
    return Recording(
        name=name,
        time=recorded["time"],
        travel=travel_among(recorded),
        force=recorded["force"],
        properties=(*_properties(above, lines, decimal), *shared),
        names_line=lines[header],
        lines=np.array(body_lines[:count], dtype=np.int64),
    )


def _decoded(content: bytes) -> str:
    """Decode text by its byte order mark, as UTF-16 if it has zero bytes, as UTF-8, or else as Windows-1252."""
    if content.startswith((codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE)):
        encoding = "utf-16"
    elif b"\0" in content[:200]:
        encoding = "utf-16-be" if content[:200:2].count(0) > content[1:200:2].count(0) else "utf-16-le"
    else:
        encoding = "utf-8-sig"
    try:
        return content.decode(encoding)
    except UnicodeDecodeError:
        if encoding != "utf-8-sig":
            # a truncated file may end within a character
            return content.decode(encoding, errors="replace")
        return content.decode("cp1252", errors="replace")


def _delimiter(text: str) -> str:
    """Return the delimiter that gives the most numbers and the fewest other cells in the second half of the file."""
    lines = [line for line in text.splitlines() if line.strip()]
    half = lines[len(lines) // 2 :]
    sample = half[:: max(1, len(half) // _SAMPLE)]
    votes = {delimiter: sum(_vote(line, delimiter) for line in sample) for delimiter in _DELIMITERS}
    winner = max(_DELIMITERS, key=lambda delimiter: votes[delimiter])
    if votes[winner] <= 0:
        _refuse_names_alone(text)
        raise InputError(f"need {_TABLE}, found no rows of numbers: it is cut off, or its format is unknown; {_KNOWN}")
    return winner


def _refuse_names_alone(text: str) -> None:
    """Refuse a file whose names of columns are known, but which has no rows below them."""
    for number, line in enumerate(text.splitlines()[:_LONGEST_HEADER], start=1):
        for delimiter in _DELIMITERS:
            names = [name.strip() for name in line.split(delimiter)]
            if sum(is_role(split_unit(_unquoted(name))[0], "folding") for name in names) > 1:
                shown = listed(as_written(_unquoted(name)) for name in names if name)
                raise InputError(message_at_line(number, f"need rows of numbers below the names {shown}, got none"))


def _unquoted(cell: str) -> str:
    return cell.strip().strip('"')


def _vote(line: str, delimiter: str) -> int:
    """Return the number of numeric cells minus that of other cells; 0 for a line that is not a row of numbers."""
    cells = [cell.strip() for cell in next(csv.reader([line], delimiter=delimiter)) if cell.strip()]
    numbers = sum(_EITHER_SIGN.fullmatch(cell) is not None for cell in cells)
    return max(2 * numbers - len(cells), 0) if numbers > 1 else 0


def _rows(text: str, delimiter: str) -> tuple[list[list[str]], list[int]]:
    """Return the cells of every line that is not empty, and the numbers of these lines."""
    reader = csv.reader(io.StringIO(text, newline=""), delimiter=delimiter, strict=True)
    rows, lines = [], []
    try:
        for row in reader:
            if row and (row[0].strip() or any(cell.strip() for cell in row)):
                rows.append(row)
                lines.append(reader.line_num)
    except csv.Error as error:
        raise InputError(
            message_at_line(reader.line_num, f"need cells in closed quotes, is it cut off? ({error})")
        ) from None
    return rows, lines


def _names_row(rows: Sequence[Sequence[str]], test: Test) -> int:
    """Return the index of the first row with two known names, or else of the last row before the numbers."""
    for number, row in enumerate(rows[:_LONGEST_HEADER]):
        if sum(is_role(split_unit(cell)[0], test) for cell in row) > 1:
            return number
    numeric = (number for number, row in enumerate(rows) if _is_numeric(row))
    first = next(numeric, 0)
    units = first > 1 and all(is_unit(_unbracketed(cell)) for cell in rows[first - 1] if cell.strip())
    return max(first - 2 if units else first - 1, 0)


def _is_numeric(row: Sequence[str]) -> bool:
    cells = [cell.strip() for cell in row if cell.strip()]
    return len(cells) > 1 and all(_EITHER_SIGN.fullmatch(cell) for cell in cells)


def _is_units_row(row: Sequence[str]) -> bool:
    """Return whether no cell is a number, except for 1, the unit of a strain."""
    cells = [_unbracketed(cell) for cell in row if cell.strip()]
    return any(not _EITHER_SIGN.fullmatch(cell) for cell in cells) and all(
        cell == "1" or not _EITHER_SIGN.fullmatch(cell) for cell in cells
    )


def _unbracketed(cell: str) -> str:
    return cell.strip().strip("[]()<>").strip()


def _names_and_units(
    rows: Sequence[Sequence[str]], lines: Sequence[int], header: int
) -> tuple[list[str], list[str], int]:
    """Return names without units, units, and the index of the first row of the body."""
    split = [split_unit(cell) for cell in rows[header]]
    names, units = [name for name, _ in split], [unit for _, unit in split]
    below = header + 1
    if below < len(rows) and _is_units_row(rows[below]):
        row = [_unbracketed(cell) for cell in rows[below]]
        for column, unit in enumerate(row[: len(names)]):
            if unit and units[column] and unit != units[column]:
                written = f"{as_written(units[column])} in the name and {as_written(unit)} below it"
                raise InputError(message_at_line(lines[below], f"{names[column]}: the units are mixed: {written}"))
            units[column] = unit or units[column]
        below += 1
    return names, units, below


def _columns_of_roles(names: Sequence[str], line: int, test: Test) -> list[dict[str, int]]:
    """Return the columns that a test needs, by role, one entry for each specimen side by side."""
    try:
        return columns_by_specimen(names, test)
    except InputError as error:
        known = "" if any(is_role(name, test) for name in names) else f"; {_KNOWN}"
        raise InputError(message_at_line(line, f"{error}{known}")) from None


def _check_widths(rows: list[list[str]], lines: list[int], names: Sequence[str], names_line: int) -> None:
    """Refuse a missing body, and a body whose rows do not have as many cells as names."""
    if not rows:
        raise InputError(
            message_at_line(names_line, "need rows of numbers below the names, got none: is the file cut off?")
        )
    widths = np.fromiter(map(len, rows), dtype=np.int64, count=len(rows))
    usual, width = int(np.bincount(widths).argmax()), max(n for n, name in enumerate(names, start=1) if name)
    # a delimiter at the end of every row gives an additional empty cell
    if usual < width or any(cell.strip() for cell in rows[0][len(names) :]):
        hint = "; decimal commas need another delimiter, or quotes" if usual == 2 * width else ""
        raise InputError(message_at_line(lines[0], f"need {width} cells, one for each name, got {usual}{hint}"))
    if (widths != usual).any():
        wrong = int(np.argmax(widths != usual))
        cut = ": is the file cut off?" if wrong == len(rows) - 1 else ""
        raise InputError(
            message_at_line(lines[wrong], f"need {usual} cells, as in the other rows, got {widths[wrong]}{cut}")
        )


def _decimal_sign(cells: dict[str, list[str]], lines: Sequence[int]) -> str:
    """Return the decimal sign of the table; refuse a mixture."""
    counts = {sign: sum("".join(column).count(sign) for column in cells.values()) for sign in ",."}
    if all(counts.values()):
        odd = min(counts, key=lambda sign: counts[sign])
        row, cell = min(
            next((n, cell) for n, cell in enumerate(column) if odd in cell)
            for column in cells.values()
            if any(odd in cell for cell in column)
        )
        raise InputError(message_at_line(lines[row], f"decimal points and commas are mixed, got {as_written(cell)}"))
    if not counts[","]:
        return "."
    if all(_EITHER_COMMA.fullmatch(cell.strip()) for column in cells.values() for cell in column if "," in cell):
        row, role = min((n, role) for role, column in cells.items() for n, cell in enumerate(column) if "," in cell)
        cell = cells[role][row].strip()
        readings = f"{cell.replace(',', '.')} or {cell.replace(',', '')}"
        remedy = "export without commas between thousands, or with another number of decimals"
        raise InputError(message_at_line(lines[row], f"{role}: {as_written(cell)} may be {readings}; {remedy}"))
    return ","


def _numbers(cells: list[str], decimal: str, lines: Sequence[int]) -> Array:
    """Convert a column to numbers, shape (row,)."""
    texts = "\n".join(cells).replace(",", ".").split("\n") if decimal == "," else cells
    try:
        values = np.fromiter(map(float, texts), dtype=np.float64, count=len(texts))
    except ValueError:
        values = np.array([_number_or_nan(text) for text in texts])
    if not np.isfinite(values).all():
        row = int(np.argmin(np.isfinite(values)))
        cut = ": is the file cut off?" if row == len(cells) - 1 else ""
        raise InputError(message_at_line(lines[row], f"need a finite number, got {as_written(cells[row])}{cut}"))
    return values


def _number_or_nan(cell: str) -> float:
    try:
        return float(cell)
    except ValueError:
        return np.nan


def _properties(rows: Sequence[Sequence[str]], lines: Sequence[int], decimal: str) -> tuple[Property, ...]:
    """Return the labelled numbers above the table."""
    properties = []
    for row, line in zip(rows, lines, strict=False):
        cells = [cell.strip() for cell in row]
        if not any(cells[1:]) and (parts := re.split(r"\s*[:=]\s*", cells[0], maxsplit=1))[1:]:
            cells = parts
        match = _VALUE_AND_UNIT.fullmatch(cells[1]) if len(cells) > 1 else None
        if match is None:
            continue
        label, unit = split_unit(cells[0].lstrip("#").rpartition(" : ")[2].rstrip(":= "))
        number = match[1].replace(decimal, ".")
        if number.count(".") + number.count(",") > 1 or (decimal == "." and "," in number):
            continue
        decimals = len(number.lower().partition("e")[0].replace(",", ".").partition(".")[2])
        written = _unbracketed(cells[2]) if len(cells) > 2 else ""
        unit = _unbracketed(match[2]) or written or unit
        value = float(number.replace(",", "."))
        properties.append(Property(label=label, value=value, rounding=0.5 * 10.0**-decimals, unit=unit, line=line))
    return tuple(properties)
