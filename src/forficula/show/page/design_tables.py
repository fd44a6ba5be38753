"""A design in tables of a page, what differs from the named design it is compared with marked."""

from __future__ import annotations

from itertools import groupby

from forficula.design import Design
from forficula.show.page.design_rows import ABSENT, DIGITS, DesignRow, base_design, design_rows, section_title
from forficula.show.page.html import Cell, paragraph, table

_NAMES = {"vein": "Veins", "guard": "Guard tendons", "hinge": "Hinges", "tendon": "Tendons"}
_STAGES = "stages."


def design_tables(design: Design) -> list[str]:
    """What differs, in a sentence, then one table a part, as HTML."""
    base = base_design(design)
    rows = design_rows(design, base)
    stages = [row for row in rows if row.key.startswith(_STAGES)]
    tables = []
    for name, group in groupby((row for row in rows if row not in stages), key=lambda row: row.section):
        title = section_title(name, design)
        caption = f"{_NAMES.get(name, name.capitalize())}: {title[:1].lower()}{title[1:]}"
        cells = [[Cell(text=row.meaning or row.key, note=f"{name}.{row.key}"), _value(row, base)] for row in group]
        tables.append(table(caption, ("", ""), cells, numbers=False))
    return [
        paragraph(_differences(design, base, [row for row in rows if row.differs])),
        paragraph(f"Source: {design.source}" if design.source else "", "note"),
        f'<div class="columns">{"".join(tables)}</div>',
        _stages(stages, base),
    ]


def _differences(design: Design, base: Design, changed: list[DesignRow]) -> str:
    if not changed:
        digits = "" if design.hash == base.hash else f", to {DIGITS} digits"
        return f"Every value is that of the named design {base.name}{digits}."
    values = "value differs" if len(changed) == 1 else "values differ"
    keys = ", ".join(f"{row.section}.{row.key}" for row in changed)
    why = "" if design.name == base.name else f" A design does not say what it came from: {base.name} is the reference."
    return f"{len(changed)} {values} from the named design {base.name}, marked below: {keys}.{why}"


def _value(row: DesignRow, base: Design) -> Cell:
    return Cell(text=row.value, note=f"{base.name}: {row.base}" if row.differs else "", marked=row.differs)


def _stages(rows: list[DesignRow], base: Design) -> str:
    """The stages of the protocol, one a row."""
    stages: dict[str, dict[str, DesignRow]] = {}
    for row in rows:
        _, number, key = row.key.split(".", 2)
        stages.setdefault(number, {})[key] = row
    keys = list(dict.fromkeys(key for stage in stages.values() for key in stage))
    cells = [
        [_value(stage[key], base) if key in stage else Cell(text=ABSENT) for key in keys]
        for _, stage in sorted(stages.items(), key=lambda item: int(item[0]))
    ]
    headings = [key.replace("_", " ") for key in keys]
    return table("Stages of the protocol (protocol.stages)", headings, cells, numbers=False)
