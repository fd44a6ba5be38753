"""The keys of one design as it stands, each with what it means, what it may be, and its value as text."""

from __future__ import annotations

import json
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from typing import Any, Literal, get_args, get_origin

from pydantic.fields import FieldInfo

from forficula.design.design import Design
from forficula.design.files.key_table import KeyFact, field_fact, field_forms
from forficula.design.files.keys import entry_of, holds_parts, names_law, section_fields
from forficula.design.section import Quantity, Section, field_quantity
from forficula.material.law.law_file import named_laws
from forficula.names import listed
from forficula.quantities import Unit, show_quantity

_LAST = ("medium", "make", "protocol")
_DIGITS = 9  # of a quantity, significant


@dataclass(frozen=True, kw_only=True)
class HeldKey:
    """A key that a design has, or could have.

    Attributes:
        fact: the key, dotted, with the numbers of entries that there are; its meaning, what it may be, its default.
        value: as text that `load_design` takes for it; "" where the design has none.
        words: that it may be.
        only_words: whether it may be nothing else.
        chosen: why a rule chooses its value; "" where none does.
    """

    fact: KeyFact
    value: str
    words: tuple[str, ...] = ()
    only_words: bool = False
    chosen: str = ""


def held_keys(design: Design) -> list[HeldKey]:
    """All keys of a design, section by section: of its kind of pattern, and of the entries that its lists have.

    A list of tables that is empty is one key; of a section that the design lacks there are the keys that it could have.
    """
    reasons = {f"{choice.section}.{choice.key}": choice for choice in design.chosen}
    found = []
    for key in _held(type(design), design, ""):
        choice = reasons.get(key.fact.key)
        reader = _reader(design, key.fact.key)
        if choice is None or key.value or reader is None:
            found.append(key)
            continue
        value = show_quantity(choice.value, reader.unit, _DIGITS)
        found.append(HeldKey(fact=key.fact, value=value, words=key.words, chosen=choice.reason))
    # what is built, what may be left out of it, then what is done to it; first what all of that is called
    return sorted(found, key=lambda key: _place(key.fact.key.partition(".")[0]) if "." in key.fact.key else -1)


def _place(section: str) -> int:
    return _LAST.index(section) + 1 if section in _LAST else 0


def _held(annotation: Any, part: Section | None, prefix: str) -> Iterator[HeldKey]:
    """The keys of a part that an annotation allows; of one that is absent those of its kind."""
    for name, field in section_fields(annotation).items():
        if part is not None and name not in type(part).model_fields:
            continue
        key, value = f"{prefix}{name}", getattr(part, name) if part is not None else None
        entry = entry_of(field.annotation)
        if not holds_parts(field):
            yield _leaf(key, field, value)
            continue
        if names_law(key):
            yield _law(key, field, value)
        if isinstance(value, Section):
            yield from _held(field.annotation, value, f"{key}.")
        elif isinstance(value, tuple) and not value:
            yield _empty(key, field, section_fields(entry))
        elif isinstance(value, tuple):
            for number, each in enumerate(value):
                if isinstance(each, Section):
                    yield from _held(entry, each, f"{key}.{number}.")
        elif not names_law(key) and entry is None:
            yield from _held(field.annotation, None, f"{key}.")


def _leaf(key: str, field: FieldInfo, value: Any) -> HeldKey:
    reader, forms = field_quantity(field), [form for form in field_forms(field) if form is not type(None)]
    words = dict.fromkeys([*(reader.words if reader else ()), *_words(forms)])
    only = reader is None and bool(words) and all(form is bool or get_origin(form) is Literal for form in forms)
    return HeldKey(fact=field_fact(key, field), value=_text(value, reader), words=tuple(words), only_words=only)


def _law(key: str, field: FieldInfo, value: Any) -> HeldKey:
    """The law of a material as one value, its name."""
    fact = KeyFact(key=key, meaning=field.description or "", allowed="name of a material, or of a law file", default="")
    return HeldKey(fact=fact, value=value.name if value is not None else "", words=tuple(named_laws()))


def _empty(key: str, field: FieldInfo, entry: Iterable[str]) -> HeldKey:
    """A list of tables that has none, as one value; its entries have these keys."""
    allowed = f"list of tables, {{...}}, with {listed(entry)}"
    return HeldKey(fact=KeyFact(key=key, meaning=field.description or "", allowed=allowed, default=""), value="")


def _words(forms: list[Any]) -> Iterator[str]:
    for form in forms:
        if form is bool:
            yield from ("true", "false")
        elif get_origin(form) is Literal:
            yield from (str(word) for word in get_args(form))


def _text(value: Any, reader: Quantity | None) -> str:
    """A value as text that is read as it again, but for digits where rounding shows."""
    if value is None:
        return ""
    if isinstance(value, tuple):
        # a list of JSON is one of TOML
        return json.dumps(_plain(value, reader.unit if reader else None), ensure_ascii=False)
    if isinstance(value, bool):
        return str(value).lower()
    return show_quantity(value, reader.unit, _DIGITS) if reader and isinstance(value, float) else str(value)


def _plain(value: Any, unit: Unit | None) -> Any:
    if isinstance(value, tuple):
        return [_plain(each, unit) for each in value]
    return show_quantity(value, unit, _DIGITS) if unit is not None and isinstance(value, float) else value


def _reader(design: Design, key: str) -> Quantity | None:
    """How a value that a rule chooses is read, which is of a section of the design."""
    section, _, name = key.partition(".")
    part = getattr(design, section, None)
    field = type(part).model_fields.get(name) if isinstance(part, Section) else None
    return None if field is None else field_quantity(field)
