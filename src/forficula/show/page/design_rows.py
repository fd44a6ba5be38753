"""A design as rows for people, and what differs from another design."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import partial
from typing import Any

from forficula.design import Design
from forficula.design.design_file import REFERENCE, load_design, named_designs
from forficula.design.part import Part, as_tables
from forficula.quantities import as_written, show_quantity

ABSENT = "—"
DIGITS = 9  # of a quantity, significant


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
    for name in (design.name, REFERENCE, *named):
        if name in named:
            base = load_design(name)
            if type(base) is type(design):
                return base
    return None


def design_rows(design: Design, base: Design) -> list[DesignRow]:
    """Every value of a design, in its order, beside that of another; then what only the other one has."""
    own, other = _flat(design), _flat(base)
    meanings = dict(_meanings(design)) | dict(_meanings(base))
    keys = [*own, *(key for key in other if key not in own)]
    # as in a design file: what is built, then what is done to it
    sections = dict.fromkeys([*type(design).model_fields, *type(base).model_fields])
    order = sorted(sections, key=lambda section: section == "protocol")
    keys.sort(key=lambda key: order.index(key.partition(".")[0]))
    return [
        DesignRow(
            section=key.partition(".")[0],
            key=key.partition(".")[2],
            meaning=meanings.get(key, ""),
            value=own.get(key, ABSENT),
            base=other.get(key, ABSENT),
        )
        for key in keys
    ]


def differing_rows(designs: Sequence[Design]) -> list[tuple[str, list[str]]]:
    """The keys in which designs differ, dotted, each with every design's value."""
    flat = [_flat(design) for design in designs]
    keys = dict.fromkeys(key for values in flat for key in values)
    rows = [(key, [values.get(key, ABSENT) for values in flat]) for key in keys]
    return [(key, values) for key, values in rows if len(set(values)) > 1]


def section_title(section: str, design: Design) -> str:
    """What a part of a design is, in words; of a list of parts, what one is."""
    part = getattr(design, section, None)
    first = part[0] if isinstance(part, tuple) and part else part
    return (type(first).__doc__ or section).splitlines()[0].removesuffix(".") if isinstance(first, Part) else section


def _flat(design: Design) -> dict[str, str]:
    """Values as text by dotted key, without name and source; their last digits, where rounding shows, are left out."""
    tables = as_tables(design, partial(show_quantity, digits=DIGITS))
    sections = {key: value for key, value in tables.items() if isinstance(value, dict) or _is_list_of_tables(value)}
    return dict(_leaves(sections))


def _leaves(value: Any, key: str = "") -> Iterator[tuple[str, str]]:
    inside = value.items() if isinstance(value, dict) else enumerate(value) if _is_list_of_tables(value) else None
    if inside is None:
        yield key, value if isinstance(value, str) else as_written(value)
        return
    for name, each in inside:
        yield from _leaves(each, f"{key}.{name}" if key else str(name))


def _is_list_of_tables(value: Any) -> bool:
    return isinstance(value, list) and bool(value) and isinstance(value[0], dict)


def _meanings(part: Part, prefix: str = "") -> Iterator[tuple[str, str]]:
    """What the keys of a part mean, and of the parts in it."""
    for name, field in type(part).model_fields.items():
        value = getattr(part, name)
        yield f"{prefix}{name}", field.description or ""
        inside = value if isinstance(value, tuple) else ()
        for number, entry in enumerate(inside):
            if isinstance(entry, Part):
                yield from _meanings(entry, f"{prefix}{name}.{number}.")
        if isinstance(value, Part):
            yield from _meanings(value, f"{prefix}{name}.")
