"""Parts to make as text: the bill, totals by material, and the checks."""

from __future__ import annotations

from collections.abc import Sequence

from rich.console import Console, Group, RenderableType
from rich.table import Table
from rich.text import Text

from forficula.make.checks.check import Check
from forficula.make.files.bill import BillRow, BillTotal, bill_of, bill_totals
from forficula.make.part import PartSet
from forficula.names import listed

_NONE = "not known"
_FAILED = "bold red"


def print_parts(parts: PartSet, checks: Sequence[Check]) -> None:
    """Print the parts of a design and their checks."""
    Console(width=110, highlight=False).print(parts_table(parts, checks))


def parts_table(parts: PartSet, checks: Sequence[Check]) -> RenderableType:
    """Return the bill, totals by material, and the checks; checks that hold are only counted."""
    rows = bill_of(parts)
    blocks: list[RenderableType] = [Text(_heading(parts, rows), style="bold"), Text(), _bill(rows)]
    totals = bill_totals(rows)
    if totals:
        blocks += [Text(), _totals(totals), *_unknown(totals)]
    return Group(*blocks, Text(), *_checks(checks))


def _heading(parts: PartSet, rows: Sequence[BillRow]) -> str:
    counts = {origin: sum(row.count for row in rows if row.comes == origin) for origin in ("printed", "bought", "cut")}
    pieces = sum(counts.values())
    origins = listed([f"{count} {origin}" for origin, count in counts.items() if count], "and")
    return f"{parts.design.name}: {pieces} {'piece' if pieces == 1 else 'pieces'}, {origins}"


def _bill(rows: Sequence[BillRow]) -> Table:
    table = _plain("part", "pieces", "material", "origin", "mm", "g each")
    for row in rows:
        size = " x ".join(f"{1e3 * side:.1f}" for side in row.size if side is not None)
        table.add_row(row.part, str(row.count), row.material or "", row.comes, size, _grams(row.mass))
    return table


def _totals(totals: Sequence[BillTotal]) -> Table:
    table = _plain("material", "pieces", "cm³", "g", "g/cm³", "density from")
    for total in totals:
        density = _NONE if total.density is None else f"{1e-3 * total.density:.4g}"
        volume = f"{1e6 * total.volume:.3g}"
        table.add_row(total.material, str(total.count), volume, _grams(total.mass), density, total.density_source)
    table.columns[-1].justify = "left"
    return table


def _unknown(totals: Sequence[BillTotal]) -> list[Text]:
    """Return a sentence on materials without a known density."""
    names = [total.material for total in totals if total.density is None]
    return [Text(f"No source gives a density of {listed(names, 'and')}: masses do not include it.")] if names else []


def _checks(checks: Sequence[Check]) -> list[RenderableType]:
    """Return the number of checks that hold, and a sentence for each one that fails or was not made."""
    failed = [check for check in checks if check.ok is False]
    missing = [check for check in checks if check.ok is None]
    held = len(checks) - len(failed) - len(missing)
    counts = f"{held} {'check holds' if held == 1 else 'checks hold'}, {len(failed)} "
    counts += f"{'fails' if len(failed) == 1 else 'fail'}" + (f", {len(missing)} not made" if missing else "")
    table = Table(box=None, padding=(0, 2, 0, 0), show_header=False)
    # the same failure of several parts is listed once
    alike: dict[tuple[bool | None, str, str], list[str]] = {}
    for check in (*failed, *missing):
        alike.setdefault((check.ok, check.name, check.text), []).append(check.part)
    for (ok, name, text), of in alike.items():
        result = Text("fails", style=_FAILED) if ok is False else Text("not made")
        table.add_row(result, "\n".join(of), f"{name}: {text}")
    return [Text(counts, style=_FAILED if failed else "bold"), *([table] if table.row_count else [])]


def _grams(mass: float | None) -> str:
    return _NONE if mass is None else f"{1e3 * mass:.3g}"


def _plain(*headings: str) -> Table:
    """Return a table without lines whose first column is text."""
    table = Table(box=None, padding=(0, 2, 0, 0))
    for number, heading in enumerate(headings):
        table.add_column(heading, justify="left" if number == 0 or heading in ("material", "origin") else "right")
    return table
