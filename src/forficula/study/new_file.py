"""Commented templates of study, goal and observations files, built from the examples of all keys."""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping
from pathlib import Path
from string import Template
from textwrap import wrap
from typing import Any

import tomli_w
from pydantic.fields import FieldInfo

from forficula.design import Design, key_quantity, key_value, load_design
from forficula.design.file_fields import by_key, left_out
from forficula.design.files.keys import entry_of, section_fields
from forficula.design.files.kinds import KINDS, OTHER_REFERENCE
from forficula.design.section import Section
from forficula.errors import InputError
from forficula.files import check_new, write_text
from forficula.names import one_of
from forficula.quantities import format_quantity, show_quantity
from forficula.structure import structure_of
from forficula.study.files.named_file import FileKind

_WIDTH = 118  # of comments


def write_new_file(path: str | os.PathLike[str], file: FileKind[Any], kind: str = "earwig-fan") -> None:
    """Write a file that can be run unchanged, with a comment on every key that has an example or a default.

    Args:
        path: path of the new file.
        file: kind of file.
        kind: kind of the pattern of the design that the file refers to, one of `KINDS`.

    Raises:
        InputError: unknown kind, or the file exists already or cannot be written.
    """
    if kind not in KINDS:
        raise InputError(f"kind: need {one_of(KINDS, kind)}")
    check_new(path := Path(path), ".toml")
    design = load_design(name := KINDS[kind].reference or OTHER_REFERENCE)
    transitions, key = structure_of(design).transitions, design.varied_key
    low = value_text(design, key, 0.5)
    texts = {
        "design": name,
        "key": key,
        "low": low,
        "low_number": low.split()[0],
        "value": value_text(design, key, 1.0),
        "high": value_text(design, key, 2.0),
        "step": value_text(design, key, 0.05, few_digits=True),
        "first": transitions[0].name,
        "second": transitions[-1].name,
        "state": transitions[0].state,
        **file.texts(design),
    }
    about = (
        f"{file.model.about}, forficula keys --kind {kind} those of the design. Lines that begin with # are optional"
    )
    write_text(path, "\n".join([*_comment(about), *_lines(file.model, texts)]) + "\n")


def value_text(design: Design, key: str, share: float, *, few_digits: bool = False) -> str:
    """Return a multiple of a design's value as text for a file, with all digits or with few."""
    quantity = key_quantity(key, type(design))
    assert quantity is not None
    write = show_quantity if few_digits else format_quantity
    return write(share * float(key_value(design, key)), quantity.unit)


def _lines(model: type[Section], texts: Mapping[str, str]) -> Iterator[str]:
    """Yield the lines of a file of a class: first its own keys, then its tables."""
    for name, field in model.model_fields.items():
        examples, is_needed = _examples(name, field, texts), left_out(field) == "needed"
        comment = ["", *_comment(". ".join(filter(None, (field.description, texts.get(name)))))]
        if by_key(field) is not None and examples:
            yield from (*comment, f"[{name}]")
            yield from (_line(text, active=is_needed and text is examples[0]) for text in examples)
        elif section_fields(entry_of(field.annotation)):
            yield from comment
            yield "\n\n".join(
                _line(f"[[{name}]]\n{text}", active=is_needed and text is examples[0]) for text in examples
            )
        elif fields := section_fields(field.annotation):
            yield from (*comment, _line(f"[{name}]", active=field.default is not None))
            for key, inside in fields.items():
                lines = _examples(key, inside, texts)
                yield from (_line(f"{text}  # {inside.description}", active=False) for text in lines)
        else:
            yield from (_line(f"{text}  # {field.description}", active=is_needed) for text in examples)


def _examples(name: str, field: FieldInfo, texts: Mapping[str, str]) -> list[str]:
    """Return lines with a key: its examples, or its default if this is a word or a number."""
    if field.examples or left_out(field) or not isinstance(field.default, str | int):
        return [Template(example).substitute(texts) for example in field.examples or []]
    return [tomli_w.dumps({name: field.default}).strip()]


def _line(text: str, *, active: bool) -> str:
    """Return one or several lines of a file, commented out if not active."""
    return text if active else "\n".join(f"# {line}" for line in text.splitlines())


def _comment(text: str) -> Iterator[str]:
    """Yield a sentence as comment lines."""
    for line in wrap(f"{text[0].upper()}{text[1:]}.", _WIDTH, break_long_words=False, break_on_hyphens=False):
        yield f"# {line}"
