"""Commented files to start from, of studies, goals and observations: the examples of every key that has one."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from string import Template
from textwrap import wrap

from pydantic.fields import FieldInfo

from forficula.design import Design, key_quantity, key_value, load_design
from forficula.design.file_fields import by_key, word_of
from forficula.design.keys import parts_of
from forficula.design.kinds import KINDS, OTHER_REFERENCE, REFERENCES
from forficula.design.part import Part, entry_part
from forficula.errors import InputError
from forficula.files import check_new, write_text
from forficula.names import one_of
from forficula.quantities import Unit, format_quantity, show_quantity
from forficula.structure import structure_of

_WIDTH = 118  # of comments


@dataclass(frozen=True, kw_only=True)
class Start:
    """A design that a new file is about, and a key of it whose values are examples.

    Attributes:
        design: named.
        key: of a number of it.
    """

    design: Design
    key: str

    def times(self, share: float) -> str:
        """Return a multiple of the design's own value as a file has it, with all digits."""
        return format_quantity(share * self._own, self._unit)

    def about(self, share: float) -> str:
        """Return a multiple of the design's own value in a few digits."""
        return show_quantity(share * self._own, self._unit)

    @property
    def _own(self) -> float:
        return float(key_value(self.design, self.key))

    @property
    def _unit(self) -> Unit:
        quantity = key_quantity(self.key, type(self.design))
        assert quantity is not None
        return quantity.unit


def write_new_file(
    path: str | os.PathLike[str], model: type[Part], kind: str, more_texts: Callable[[Start], Mapping[str, str]]
) -> None:
    """Write a file of a class with a comment on every key that has an example; what is needed is no comment.

    Args:
        path: of the file.
        model: class of the file, whose examples name texts of the design as `$name`.
        kind: of the pattern of the design that the file is about, one of `KINDS`.
        more_texts: returns texts beside the kind, the design, the key, `low`, `value`, `high` and `step` (half, once,
            twice and a twentieth of the value of the key), and the names of the `first` and `second` transition. A text
            by the name of a table is added to its comment.

    Raises:
        InputError: no such kind, or the file exists already, or cannot be written.
    """
    if kind not in KINDS:
        raise InputError(f"kind: need {one_of(KINDS, kind)}")
    check_new(path := Path(path), ".toml")
    design = load_design(name := REFERENCES.get(kind, OTHER_REFERENCE))
    start = Start(design=design, key=design.varied_key)
    transitions = [each.name for each in structure_of(design).transitions]
    texts = {
        "kind": kind,
        "design": name,
        "key": start.key,
        "low": start.times(0.5),
        "value": start.times(1.0),
        "high": start.times(2.0),
        "step": start.about(0.05),
        "first": next(iter(transitions), "fold"),
        "second": next(iter(transitions[1:]), "unfold"),
        **more_texts(start),
    }
    about = f"{model.about}, forficula keys --kind {kind} those of the design. What is behind # may be left out"
    write_text(path, "\n".join([*_comment(about), *_lines(model, texts)]) + "\n")


def _lines(model: type[Part], texts: Mapping[str, str]) -> Iterator[str]:
    """The lines of a file of a class: keys of its own, then its tables."""
    for name, field in model.model_fields.items():
        examples, is_needed = _examples(field, texts), word_of(field, "left_out") == "needed"
        comment = ["", *_comment(". ".join(filter(None, (field.description, texts.get(name)))))]
        if by_key(field) is not None and examples:
            yield from (*comment, f"[{name}]")
            yield from (_line(text, active=is_needed and text is examples[0]) for text in examples)
        elif entry_part(field) is not None:
            yield from comment
            yield "\n\n".join(_line(f"[[{name}]]\n{text}", active=text is examples[0]) for text in examples)
        elif parts := list(parts_of(field.annotation)):
            yield from (*comment, _line(f"[{name}]", active=field.default is not None))
            for inside in parts[0].model_fields.values():
                yield from (_line(f"{text}  # {inside.description}", active=False) for text in _examples(inside, texts))
        else:
            yield from (_line(f"{text}  # {field.description}", active=is_needed) for text in examples)


def _examples(field: FieldInfo, texts: Mapping[str, str]) -> list[str]:
    return [Template(example).substitute(texts) for example in field.examples or []]


def _line(text: str, *, active: bool) -> str:
    """A line of a file, or several, behind # where it is not active."""
    return text if active else "\n".join(f"# {line}" for line in text.splitlines())


def _comment(text: str) -> Iterator[str]:
    """A sentence on comment lines."""
    for line in wrap(f"{text[0].upper()}{text[1:]}.", _WIDTH, break_long_words=False, break_on_hyphens=False):
        yield f"# {line}"
