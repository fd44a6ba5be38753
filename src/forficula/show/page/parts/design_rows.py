"""A design as rows for people, and what differs from another design."""

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
_MOST_IN_TITLE = 2  # values that a title names [chosen]


@dataclass(frozen=True, kw_only=True)
class DesignRow:
    """One value of a design.

    Attributes:
        section: the part that it stands in, such as "tendon".
        key: in that part; a number picks an entry of a list.
        meaning: in words.
        value: with its unit; `ABSENT` where there is none.
        base: what the other design has there.
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
    """The named design to compare one with: the one of its name, the reference, or the first of its kind.

    A design does not keep what it was based on, so a file of another name counts as one that came from the reference,
    as one that `forficula new` wrote does.

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
    """Every value of a design, in its order, beside that of another; then what only the other one has."""
    own, other = _flat(design), _flat(base)
    meanings = dict(key_meanings(design)) | dict(key_meanings(base))
    # as in a design file: what is built, then what is done to it
    sections = dict.fromkeys([*type(design).model_fields, *type(base).model_fields])
    order = sorted(sections, key=lambda section: section == "protocol")
    keys = sorted(_keys([own, other]), key=lambda key: order.index(key.partition(".")[0]))
    return [
        DesignRow(
            section=key.partition(".")[0],
            key=key.partition(".")[2],
            meaning=meanings.get(key, ""),
            value=_at(own, key),
            base=_at(other, key),
        )
        for key in keys
    ]


def design_title(design: Design) -> str:
    """A design's name and what sets it apart from the named design of that name, for a heading or a window's title.

    Returns:
        Such as "binder2025, tendon.stiffness 20 N/cm"; where more differs, how many values do and the design's hash. Of
        a design that no named one has the name of, the name.
    """
    base = base_design(design)
    if base is None or base.name != design.name:
        return design.name
    rows = [row for row in design_rows(design, base) if row.differs]
    if len(rows) > _MOST_IN_TITLE:
        return f"{design.name} with {len(rows)} other values ({design.hash})"
    return ", ".join([design.name, *(_apart(row) for row in rows)])


def differing_rows(designs: Sequence[Design]) -> list[tuple[str, list[str]]]:
    """The keys in which designs differ, dotted, each with every design's value."""
    flat = [_flat(design) for design in designs]
    rows = [(key, [_at(values, key) for values in flat]) for key in _keys(flat)]
    return [(key, values) for key, values in rows if len(set(values)) > 1]


def section_title(section: str, design: Design) -> str:
    """What a part of a design is, in words."""
    part = _section(section, design)
    return (part.about if part is not None else "") or section


def section_heading(section: str, designs: Sequence[Design]) -> str:
    """What is written over a part, as the first of some designs that has it says; empty where it does not say."""
    parts = (_section(section, design) for design in designs)
    return next((part.heading for part in parts if part is not None), "")


def _apart(row: DesignRow) -> str:
    key = f"{row.section}.{row.key}"
    return f"{key} left out" if row.value == ABSENT else f"{key} {row.value}"


def _section(section: str, design: Design) -> Section | None:
    """A part of a design; of a list of them the first that there is."""
    part = getattr(design, section, None)
    entries = part if isinstance(part, tuple) else (part,)
    return next((entry for entry in entries if isinstance(entry, Section)), None)


def _keys(designs: Sequence[dict[str, str]]) -> list[str]:
    """The keys of designs; of those of one table for all only where no design has a list of tables."""
    keys = list(dict.fromkeys(key for values in designs for key in values))
    listed = {_of_all(key) for key in keys} - {None}
    return [key for key in keys if key not in listed]


def _at(values: dict[str, str], key: str) -> str:
    """The value at a key, or that of the table that stands for all entries of a list."""
    return values.get(key, values.get(_of_all(key) or key, ABSENT))


def _of_all(key: str) -> str | None:
    """The key of all entries of a list, such as "tendon.stiffness" of "tendon.1.stiffness"; None of others."""
    section, _, rest = key.partition(".")
    number, _, inside = rest.partition(".")
    return f"{section}.{inside}" if number.isdecimal() and inside else None


def _flat(design: Design) -> dict[str, str]:
    """Values as text by dotted key, without name and source; their last digits, where rounding shows, are left out."""
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
    for name, each in value.items():
        yield from _leaves(each, f"{key}.{name}")


def _is_list_of_tables(value: Any) -> bool:
    return isinstance(value, list) and bool(value) and isinstance(value[0], dict)


def key_meanings(part: Section, prefix: str = "") -> Iterator[tuple[str, str]]:
    """What the keys of a part mean, and of the parts in it."""
    for name, field in type(part).model_fields.items():
        value = getattr(part, name)
        yield f"{prefix}{name}", field.description or ""
        inside = value if isinstance(value, tuple) else ()
        for number, entry in enumerate(inside):
            if isinstance(entry, Section):
                yield from key_meanings(entry, f"{prefix}{name}.{number}.")
        if isinstance(value, Section):
            yield from key_meanings(value, f"{prefix}{name}.")
