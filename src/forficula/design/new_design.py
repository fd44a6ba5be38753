"""A commented design file to start from."""

from __future__ import annotations

import os
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import tomli_w
from pydantic.fields import FieldInfo

from forficula.design.design import Design
from forficula.design.design_file import load_design
from forficula.design.part import Part, field_quantity
from forficula.design.rejection import REFERENCE
from forficula.design.tendon import TendonSection
from forficula.errors import InputError
from forficula.files import write_text


def write_new_design(path: str | os.PathLike[str]) -> None:
    """Write a commented design file to start from: the reference, every key with what it means.

    Raises:
        InputError: the file exists already, or cannot be written.
    """
    path = Path(path)
    if path.suffix != ".toml":
        raise InputError(f"{path}: need a name that ends with .toml")
    try:
        exists = path.exists()
    except OSError as error:
        raise InputError(f"{path}: cannot be written: {error.strerror}") from None
    if exists:
        raise InputError(f"{path}: exists already; choose another name or remove it")
    lines = [
        "# A forficula design. Every key is optional but based_on; what is left out comes from there.",
        f'based_on = "{REFERENCE}"',
    ]
    write_text(path, "\n".join([*lines, *_commented(load_design(REFERENCE))]) + "\n")


def _commented(design: Design) -> Iterator[str]:
    """The sections of a design, every key with its meaning; what is done to it comes last."""
    for section in sorted(type(design).model_fields, key=lambda name: name == "protocol"):
        part = getattr(design, section)
        if not isinstance(part, Part):
            continue
        values = part.as_tables()
        yield f"\n[{section}]  # {(type(part).__doc__ or '').splitlines()[0].removesuffix('.')}"
        for key, entry in type(part).model_fields.items():
            if key == "stages":
                continue
            if key not in values:
                yield f"{'# ' + _example(key, entry):<40}  # {entry.description}"
                continue
            value = tomli_w.dumps({key: values[key]}).strip().replace("[\n    ", "[").replace(",\n]", "]")
            yield f"{value:<40}  # {entry.description}"
        if isinstance(part, TendonSection):
            yield "# [[tendon]] with vein = 0 and what differs is the tendon of one vein; then a vein without has none."
        if "stages" in values:
            yield from _commented_stages(values["stages"], type(part).model_fields["stages"].description)


def _example(key: str, entry: FieldInfo) -> str:
    """A line for a value that is absent."""
    reader = field_quantity(entry)
    return tomli_w.dumps({key: reader.unit.example if reader else (entry.examples or [""])[0]}).strip()


def _commented_stages(stages: list[dict[str, Any]], description: str | None) -> Iterator[str]:
    """The stages, commented out: a list of tables replaces the whole list."""
    yield f"\n# {description}; giving any stage replaces all of them."
    for stage in stages:
        yield "# [[protocol.stages]]"
        yield from (f"# {line}" for line in tomli_w.dumps(stage).strip().splitlines())
