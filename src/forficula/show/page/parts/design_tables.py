"""Tables of a page with the values of a design; values that differ from the compared named design are marked."""

from __future__ import annotations

from itertools import groupby

from forficula.design import Design
from forficula.show.page.parts.design_rows import (
    ABSENT,
    DIGITS,
    DesignRow,
    base_design,
    design_rows,
    section_heading,
    section_title,
)
from forficula.show.page.parts.html import Cell, paragraph, table

_STAGES = "stages"


def design_tables(design: Design) -> list[str]:
    """Return the HTML of a sentence about the differences and of one table for each section."""
    base = base_design(design)
    rows = design_rows(design, base or design)
    listed: dict[str, list[DesignRow]] = {}
    for row in rows:
        if (name := _list_of(row)) is not None:
            listed.setdefault(name, []).append(row)
    tables = []
    for name, group in groupby((row for row in rows if _list_of(row) is None), key=lambda row: row.section):
        title = section_title(name, design)
        heading = section_heading(name, (design, base or design)) or name.capitalize()
        caption = f"{heading}: {title[:1].lower()}{title[1:]}"
        cells = [[Cell(text=row.meaning or row.key, note=f"{name}.{row.key}"), _value(row, base)] for row in group]
        tables.append(table(caption, ("", ""), cells, numbers=False))
    return [
        paragraph(_differences(design, base, [row for row in rows if row.differs])) if base else "",
        paragraph(f"Source: {design.source}" if design.source else "", "note"),
        f'<div class="columns">{"".join(tables)}</div>',
        *(_list(name, group, design, base) for name, group in listed.items()),
    ]


def _list_of(row: DesignRow) -> str | None:
    """Return the key of the list that a row belongs to: the stages or a listed section; None for other rows."""
    first, _, rest = row.key.partition(".")
    if first.isdigit():
        return row.section
    return f"{row.section}.{first}" if first == _STAGES and rest else None


def _differences(design: Design, base: Design, changed: list[DesignRow]) -> str:
    if not changed:
        digits = "" if design.hash == base.hash else f", to {DIGITS} digits"
        return f"Every value is that of the named design {base.name}{digits}."
    values = "value differs" if len(changed) == 1 else "values differ"
    keys = ", ".join(f"{row.section}.{row.key}" for row in changed)
    reason = (
        ""
        if design.name == base.name
        else f" A design does not record what it was made from, so it is compared with the reference, {base.name}."
    )
    return f"{len(changed)} {values} from the named design {base.name}, marked below: {keys}.{reason}"


def _value(row: DesignRow, base: Design | None) -> Cell:
    marked = base is not None and row.differs
    return Cell(text=row.value, note=f"{base.name}: {row.base}" if base and marked else "", marked=marked)


def _list(name: str, rows: list[DesignRow], design: Design, base: Design | None) -> str:
    """Return a table with one row for each entry of a list."""
    entries: dict[str, dict[str, DesignRow]] = {}
    inner_key = name.partition(".")[2]
    for row in rows:
        number, key = row.key.removeprefix(f"{inner_key}.").split(".", 1)
        entries.setdefault(number, {})[key] = row
    keys = list(dict.fromkeys(key for entry in entries.values() for key in entry))
    # entries without names are numbered
    named = "name" in keys
    cells = [
        [
            *([] if named else [Cell(text=number)]),
            *(_value(entry[key], base) if key in entry else Cell(text=ABSENT) for key in keys),
        ]
        for number, entry in sorted(entries.items(), key=lambda item: int(item[0]))
    ]
    headings = [*([] if named else [""]), *(key.replace("_", " ") for key in keys)]
    if inner_key:
        return table(f"{inner_key.capitalize()} of the protocol ({name})", headings, cells, numbers=False)
    meaning = type(design).model_fields[name].description or section_title(name, design)
    heading = section_heading(name, (design, base or design)) or f"{name.capitalize()}s"
    return table(f"{heading}: {meaning}", headings, cells, numbers=False)
