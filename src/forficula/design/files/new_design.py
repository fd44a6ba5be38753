"""A commented design file to start from."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

import tomli_w
from pydantic.fields import FieldInfo

from forficula.design.design import Design
from forficula.design.fans.fan import FanDesign
from forficula.design.files.design_file import load_design
from forficula.design.files.keys import entry_of, section_fields
from forficula.design.files.kinds import KINDS, OTHER_REFERENCE
from forficula.design.files.sized_design import sized_design, with_short_numbers
from forficula.design.law import LawSection
from forficula.design.section import Section, field_quantity
from forficula.errors import InputError
from forficula.files import check_new, write_text
from forficula.names import near_name
from forficula.quantities import as_written


def write_new_design(path: str | os.PathLike[str], kind: str = "earwig-fan", *, size: float | None = None) -> None:
    """Write a commented design file to start from, with the values of the reference and the meaning of every key.

    Args:
        path: path of the file.
        kind: kind of pattern, one of `KINDS`; "fold-file" takes the pattern of a file sheet.fold.
        size: largest dimension of the flat pattern to which the design is scaled, m; by default it is not scaled.

    Raises:
        InputError: no such kind, or the file exists already, or cannot be written.
    """
    path = Path(path)
    if kind not in KINDS:
        raise InputError(f"kind: need one of {', '.join(KINDS)}, got {as_written(kind)}{near_name(kind, KINDS)}")
    reference = KINDS[kind].reference or OTHER_REFERENCE
    check_new(path, ".toml")
    design = None if size is None else sized_design(kind, size)
    lines = [
        "# A forficula design. Only based_on is required; keys that are left out have the values of that design.",
        f'based_on = "{reference}"',
    ]
    own_pattern = KINDS[kind].reference is None and design is None
    if own_pattern:
        lines += _own_pattern(kind, reference)
    without = "pattern" if own_pattern else ""
    if design is not None:
        if KINDS[kind].reference is None:
            lines += _emptied(reference)
        text = "\n".join([*lines, *_commented(design, without, active=True)]) + "\n"
        write_text(path, with_short_numbers(text))
        return
    write_text(path, "\n".join([*lines, *_commented(load_design(reference), without)]) + "\n")


def _own_pattern(kind: str, reference: str) -> Iterator[str]:
    """Yield lines for a design with another pattern than its base: the pattern, and empty lists for entries on it."""
    yield from _emptied(reference)
    section = _section_of(kind)
    yield f"\n[pattern]  # {section.about}"
    for key, value in {"kind": kind, **KINDS[kind].example}.items():
        yield f"{tomli_w.dumps({key: value}).strip():<40}  # {section.model_fields[key].description}"


def _emptied(reference: str) -> Iterator[str]:
    for key in ("tendon", "support", "measure"):
        yield f"{f'{key} = []':<40}  # without those of {reference}; remove this line to give some under [[{key}]]"


def _section_of(kind: str) -> type[Section]:
    """Return the class of the pattern's section for a kind of pattern."""
    annotation: Any = KINDS[kind].model_fields["pattern"].annotation
    section: type[Section] = annotation
    return section


def _commented(design: Design, without: str, *, active: bool = False) -> Iterator[str]:
    """The sections of a design but for one, every key with its meaning; what is done to it comes last.

    Lists of tables are commented out, unless they are to be active.
    """
    for section in sorted(type(design).model_fields, key=lambda name: name == "protocol"):
        if section == without:
            continue
        part = getattr(design, section)
        if isinstance(part, tuple):
            yield from _commented_tables(section, part, type(design).model_fields[section], active=active)
        if not isinstance(part, Section):
            continue
        values = part.as_tables()
        yield f"\n[{section}]  # {part.about}"
        for key, entry in type(part).model_fields.items():
            if section_fields(entry_of(entry.annotation)):
                # a table with its own header must follow all keys of the section
                continue
            if key not in values:
                yield f"{'# ' + _example(key, entry):<40}  # {entry.description}"
                continue
            law = getattr(part, key)
            value = law.name if isinstance(law, LawSection) else values[key]
            yield f"{_line(key, value):<40}  # {entry.description}"
        if section == "tendon" and isinstance(design, FanDesign):
            yield "# [[tendon]] with vein = 0 and the values that differ is the tendon of one vein; other veins without"
            yield "# such a table then have no tendon."
        for key, entry in type(part).model_fields.items():
            if key == "stages":
                yield from _commented_stages(values["stages"], entry.description, active=active)
            elif section_fields(entry_of(entry.annotation)):
                yield from _commented_tables(f"{section}.{key}", getattr(part, key), entry, active=active)


def _example(key: str, entry: FieldInfo) -> str:
    """Return an example line for a value that is absent."""
    reader = field_quantity(entry)
    return _line(key, (entry.examples or [reader.unit.example if reader else ""])[0])


def _line(key: str, value: object) -> str:
    """Return a key and its value on one line; a table is written inline."""
    if isinstance(value, Mapping):
        return f"{key} = {{ {', '.join(_line(inner, part) for inner, part in value.items())} }}"
    text = re.sub(r"\[\n\s+", "[", tomli_w.dumps({key: value}).strip())
    return re.sub(r",\n\s+", ", ", re.sub(r",\n\s*\]", "]", text))


def _commented_tables(
    header: str, entries: Sequence[Section], field: FieldInfo, *, active: bool = False
) -> Iterator[str]:
    """The entries of a list of tables, commented out, every key with its meaning; an example where there are none."""
    yield f"\n# {field.description}; giving any replaces all of them."
    for values in [part.as_tables() for part in entries] or [{}]:
        start = "" if active and entries else "# "
        yield f"{start}[[{header}]]"
        for key, entry in section_fields(entry_of(field.annotation)).items():
            if entries and key not in values:
                continue
            line = _line(key, values[key]) if key in values else _example(key, entry)
            yield f"{start + line:<40}  # {entry.description}"


def _commented_stages(stages: list[dict[str, Any]], description: str | None, *, active: bool = False) -> Iterator[str]:
    """The stages, commented out: a list of tables replaces the whole list."""
    yield f"\n# {description}; giving any stage replaces all of them."
    for stage in stages:
        start = "" if active else "# "
        yield f"{start}[[protocol.stages]]"
        yield from (f"{start}{line}" for line in tomli_w.dumps(stage).strip().splitlines())
