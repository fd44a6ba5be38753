"""Values of a design as rows for people, compared with another design."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import partial
from typing import Any

from forficula.design import Design
from forficula.design.files.design_file import load_design, named_designs
from forficula.design.section import Section
from forficula.quantities import as_written, show_quantity

ABSENT = "—"
DIGITS = 9  # of a quantity, significant
_MOST_IN_TITLE = 2  # largest number of values in a title [chosen]


@dataclass(frozen=True, kw_only=True)
class DesignRow:
    """Value of a design, beside that of another design.

    Attributes:
        section: section of the design that contains the value, such as "tendon".
        key: dotted key within the section; a number selects an entry of a list.
        meaning: description of the key.
        value: value with its unit; `ABSENT` if the design has none.
        base: value of the other design.
    """

    section: str
    key: str
    meaning: str
    value: str
    base: str

    @property
    def differs(self) -> bool:
        """Whether the two designs have different values."""
        return self.value != self.base


def base_design(design: Design) -> Design | None:
    """Return the named design to compare a design with: that of its name, its reference, or the first of its kind.

    A design does not record which design it started from, so a file with a name that is not known is compared with the
    reference, from which `forficula new` writes files.

    Returns:
        None where no named design is of its kind.
    """
    named = named_designs()
    for name in (design.name, design.reference, *named):
        if name in named:
            base = load_design(name)
            if type(base) is type(design):
                return base
    return None


def design_rows(design: Design, base: Design) -> list[DesignRow]:
    """Return every value of a design, in its order, beside that of another; then values that only the other one has."""
    values, other = _flat(design), _flat(base)
    meanings = dict(key_meanings(design)) | dict(key_meanings(base))
    # the order of a design file: first the structure, then the protocol
    sections = dict.fromkeys([*type(design).model_fields, *type(base).model_fields])
    order = sorted(sections, key=lambda section: section == "protocol")
    keys = sorted(_keys([values, other]), key=lambda key: order.index(key.partition(".")[0]))
    return [
        DesignRow(
            section=key.partition(".")[0],
            key=key.partition(".")[2],
            meaning=meanings.get(key, ""),
            value=_value_at(values, key),
            base=_value_at(other, key),
        )
        for key in keys
    ]


def design_title(design: Design) -> str:
    """Return a design's name and its differences from the named design of that name, for a heading or a window title.

    Returns:
        Text such as "binder2025, tendon.stiffness 20 N/cm". Above two differences, their number and the design's hash.
        Only the name if no named design has that name.
    """
    base = base_design(design)
    if base is None or base.name != design.name:
        return design.name
    rows = [row for row in design_rows(design, base) if row.differs]
    if len(rows) > _MOST_IN_TITLE:
        return f"{design.name} with {len(rows)} other values ({design.hash})"
    return ", ".join([design.name, *(_difference_text(row) for row in rows)])


def differing_rows(designs: Sequence[Design]) -> list[tuple[str, list[str]]]:
    """Return the dotted keys in which designs differ, each with the values of all designs."""
    flat = [_flat(design) for design in designs]
    rows = [(key, [_value_at(values, key) for values in flat]) for key in _keys(flat)]
    return [(key, values) for key, values in rows if len(set(values)) > 1]


def section_title(section: str, design: Design) -> str:
    """Return the description of a section of a design."""
    part = _section(section, design)
    return (part.about if part is not None else "") or section


def section_heading(section: str, designs: Sequence[Design]) -> str:
    """Return the heading of a section from the first design that has one; empty if none has."""
    parts = (_section(section, design) for design in designs)
    return next((part.heading for part in parts if part is not None), "")


def _difference_text(row: DesignRow) -> str:
    key = f"{row.section}.{row.key}"
    return f"{key} left out" if row.value == ABSENT else f"{key} {row.value}"


def _section(section: str, design: Design) -> Section | None:
    """Return a section of a design; the first entry if the section is a list."""
    part = getattr(design, section, None)
    entries = part if isinstance(part, tuple) else (part,)
    return next((entry for entry in entries if isinstance(entry, Section)), None)


def _keys(designs: Sequence[dict[str, str]]) -> list[str]:
    """Return the keys of all designs. A key of one table for all entries is left out if a design lists the entries."""
    keys = list(dict.fromkeys(key for values in designs for key in values))
    listed = {_key_of_all_entries(key) for key in keys} - {None}
    return [key for key in keys if key not in listed]


def _value_at(values: dict[str, str], key: str) -> str:
    """Return the value at a key, or that of the table that applies to all entries of a list."""
    return values.get(key, values.get(_key_of_all_entries(key) or key, ABSENT))


def _key_of_all_entries(key: str) -> str | None:
    """Return the key of all entries of a list, such as "tendon.stiffness" for "tendon.1.stiffness"; None otherwise."""
    section, _, rest = key.partition(".")
    number, _, inside = rest.partition(".")
    return f"{section}.{inside}" if number.isdecimal() and inside else None


def _flat(design: Design) -> dict[str, str]:
    """Return values as text by dotted key, without name and source, rounded so that rounding errors do not show."""
    tables = design.as_tables(partial(show_quantity, digits=DIGITS))
    sections = {key: value for key, value in tables.items() if isinstance(value, dict) or _is_list_of_tables(value)}
    leaves: dict[str, str] = {}
    for key, value in sections.items():
        leaves |= _leaves(value, key)
    return leaves


def _leaves(value: Any, key: str) -> Iterator[tuple[str, str]]:
    if _is_list_of_tables(value):
        value = dict(enumerate(value))
    if not isinstance(value, dict):
        yield key, value if isinstance(value, str) else as_written(value)
        return
    for name, entry in value.items():
        yield from _leaves(entry, f"{key}.{name}")


def _is_list_of_tables(value: Any) -> bool:
    return isinstance(value, list) and bool(value) and isinstance(value[0], dict)


def key_meanings(part: Section, prefix: str = "") -> Iterator[tuple[str, str]]:
    """Yield the keys of a section and of the sections in it, with their descriptions."""
    for name, field in type(part).model_fields.items():
        value = getattr(part, name)
        yield f"{prefix}{name}", field.description or ""
        inside = value if isinstance(value, tuple) else ()
        for number, entry in enumerate(inside):
            if isinstance(entry, Section):
                yield from key_meanings(entry, f"{prefix}{name}.{number}.")
        if isinstance(value, Section):
            yield from key_meanings(value, f"{prefix}{name}.")
