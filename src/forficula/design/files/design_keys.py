"""The keys of a given design with their meanings, allowed values, and current values as text."""

from __future__ import annotations

import json
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from typing import Any, Literal, get_args, get_origin

from pydantic.fields import FieldInfo

from forficula.design.design import Design
from forficula.design.files.key_table import KeyFact, crease_law_fact, field_fact, field_forms
from forficula.design.files.keys import entry_of, holds_sections, names_crease_law, names_law, section_fields
from forficula.design.section import Quantity, Section, field_quantity
from forficula.design.sheets.crease_law_section import CreaseLawSection
from forficula.material.law.crease_law_file import FORMS, named_crease_laws
from forficula.material.law.law_file import named_laws
from forficula.names import listed
from forficula.quantities import Unit, show_quantity

_LAST = ("medium", "make", "protocol")
_DIGITS = 9  # significant digits of a quantity


@dataclass(frozen=True, kw_only=True)
class DesignKey:
    """A key that a design has, or could have.

    Attributes:
        fact: dotted key, with the numbers of existing entries of lists; its meaning, allowed values and default.
        value: value as text that `load_design` accepts; "" if the design has none.
        words: words that are allowed values.
        only_words: whether only these words are allowed.
        chosen: reason why a rule chose the value; "" if the design gives it.
    """

    fact: KeyFact
    value: str
    words: tuple[str, ...] = ()
    only_words: bool = False
    chosen: str = ""


def design_keys(design: Design) -> list[DesignKey]:
    """List all keys of a design, section by section, for its kind of pattern and the entries of its lists.

    An empty list of tables is one key. A section that the design lacks is listed with all keys of its class.
    """
    reasons = {f"{choice.section}.{choice.key}": choice for choice in design.chosen}
    keys = []
    for key in _held(type(design), design, ""):
        choice = reasons.get(key.fact.key)
        reader = _reader(design, key.fact.key)
        if choice is None or key.value or reader is None:
            keys.append(key)
            continue
        value = show_quantity(choice.value, reader.unit, _DIGITS)
        keys.append(DesignKey(fact=key.fact, value=value, words=key.words, chosen=choice.reason))
    # keys outside sections first, then the structure, then optional sections and the protocol
    return sorted(keys, key=lambda key: _rank(key.fact.key.partition(".")[0]) if "." in key.fact.key else -1)


def _rank(section: str) -> int:
    return _LAST.index(section) + 1 if section in _LAST else 0


def _held(annotation: Any, section: Section | None, prefix: str) -> Iterator[DesignKey]:
    """Yield the keys of a section that an annotation allows; for an absent section, those of its class."""
    for name, field in section_fields(annotation).items():
        if section is not None and name not in type(section).model_fields:
            continue
        key, value = f"{prefix}{name}", getattr(section, name) if section is not None else None
        entry = entry_of(field.annotation)
        if not holds_sections(field):
            yield _leaf(key, field, value)
            continue
        if names_law(key):
            yield _law(key, field, value)
        elif names_crease_law(key):
            yield _crease_law(key, field, value)
        if isinstance(value, Section):
            yield from _held(field.annotation, value, f"{key}.")
        elif (isinstance(value, tuple) and not value) or (section is not None and value is None and entry is not None):
            yield _empty(key, field, section_fields(entry))
        elif isinstance(value, tuple):
            for number, item in enumerate(value):
                if isinstance(item, Section):
                    yield from _held(entry, item, f"{key}.{number}.")
        elif not (names_law(key) or names_crease_law(key)) and entry is None:
            yield from _held(field.annotation, None, f"{key}.")


def _leaf(key: str, field: FieldInfo, value: Any) -> DesignKey:
    reader, forms = field_quantity(field), [form for form in field_forms(field) if form is not type(None)]
    words = dict.fromkeys([*(reader.words if reader else ()), *_words(forms)])
    only = reader is None and bool(words) and all(form is bool or get_origin(form) is Literal for form in forms)
    return DesignKey(fact=field_fact(key, field), value=_text(value, reader), words=tuple(words), only_words=only)


def _law(key: str, field: FieldInfo, value: Any) -> DesignKey:
    """Return the key of a material law as a single value, its name."""
    fact = KeyFact(key=key, meaning=field.description or "", allowed="name of a material, or of a law file", default="")
    return DesignKey(fact=fact, value=value.name if value is not None else "", words=tuple(named_laws()))


def _crease_law(key: str, field: FieldInfo, value: Any) -> DesignKey:
    """Return the key of a law of creases as a single value: the form of a spring, or the name of a law."""
    words = (*FORMS, *named_crease_laws())
    shown = value.name if isinstance(value, CreaseLawSection) else value or ""
    return DesignKey(fact=crease_law_fact(key, field), value=shown, words=words)


def _empty(key: str, field: FieldInfo, entry: Iterable[str]) -> DesignKey:
    """Return the key of an empty list of tables as a single value; `entry` has the keys of the tables."""
    allowed = f"list of tables, {{...}}, with {listed(entry)}"
    return DesignKey(fact=KeyFact(key=key, meaning=field.description or "", allowed=allowed, default=""), value="")


def _words(forms: list[Any]) -> Iterator[str]:
    for form in forms:
        if form is bool:
            yield from ("true", "false")
        elif get_origin(form) is Literal:
            yield from (str(word) for word in get_args(form))


def _text(value: Any, reader: Quantity | None) -> str:
    """Return a value as text from which it can be read again, except for rounding of the last digits."""
    if value is None:
        return ""
    if isinstance(value, tuple):
        # a JSON list is also a TOML list
        return json.dumps(_plain(value, reader.unit if reader else None), ensure_ascii=False)
    if isinstance(value, bool):
        return str(value).lower()
    return show_quantity(value, reader.unit, _DIGITS) if reader and isinstance(value, float) else str(value)


def _plain(value: Any, unit: Unit | None) -> Any:
    if isinstance(value, tuple):
        return [_plain(entry, unit) for entry in value]
    return show_quantity(value, unit, _DIGITS) if unit is not None and isinstance(value, float) else value


def _reader(design: Design, key: str) -> Quantity | None:
    """Return the reader of a value in a section of the design, for values that a rule chooses."""
    header, _, name = key.partition(".")
    section = getattr(design, header, None)
    field = type(section).model_fields.get(name) if isinstance(section, Section) else None
    return None if field is None else field_quantity(field)
