"""Keys of design files and other files: meaning, allowed values and defaults."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any, Literal, get_args, get_origin

from annotated_types import Ge, Gt, Le, Lt
from pydantic.fields import FieldInfo

from forficula.design.fans.fan import FanDesign
from forficula.design.file_fields import by_key, left_out
from forficula.design.files.keys import fields_of, hint, holds_sections, names_crease_law
from forficula.design.section import Quantity, Section, field_quantity, is_list
from forficula.errors import InputError
from forficula.material.law.crease_law_file import FORMS, named_crease_laws
from forficula.names import listed, unknown_key
from forficula.quantities import show_quantity


@dataclass(frozen=True, kw_only=True)
class KeyFact:
    """A key of a design or of another file.

    Attributes:
        key: dotted key; 0 is the number of an entry of a list of tables, and KEY represents the keys of a design.
        meaning: meaning of the value.
        allowed: type, unit and bounds of the value.
        default: value if the key is left out; "needed" if a design that is not based on another must give it; "" if the
            value is absent then.
    """

    key: str
    meaning: str
    allowed: str
    default: str


def key_facts(within: str = "", model: type[Section] = FanDesign) -> list[KeyFact]:
    """List the keys of a class of designs or of another file, or those of one section, in the order of the file.

    Args:
        within: a section or a key, as in "tendon", "protocol.stages.2" or "tendon.stiffness"; all keys if empty.
        model: class of the design or of the file.

    Raises:
        InputError: there is no such section or key; the message names the nearest one.
    """
    wanted = _unnumbered(within) if within else []
    facts = [
        crease_law_fact(key, field) if names_crease_law(key) else field_fact(key, field)
        for key, field in fields_of(model)
        if names_crease_law(key) or not holds_sections(field)
    ]
    matches = [fact for fact in facts if _unnumbered(fact.key)[: len(wanted)] == wanted]
    if not matches:
        raise InputError(unknown_key(within, None, hint(within.split("."), model)))
    return matches


def _unnumbered(key: str) -> list[str]:
    """Split a key into its parts, without the numbers of entries of lists, which all have the same keys."""
    return [part for part in key.split(".") if not part.isdecimal()]


def field_fact(key: str, field: FieldInfo) -> KeyFact:
    """Return the meaning, allowed values and default of a field."""
    default = "needed" if field.is_required() else _written(field.get_default(), field_quantity(field))
    return KeyFact(
        key=key,
        meaning=field.description or "",
        allowed=_allowed(field),
        default=left_out(field) or default,
    )


def crease_law_fact(key: str, field: FieldInfo) -> KeyFact:
    """Return the meaning of the law of creases, which is one value, a form or a name, or has keys of its own."""
    words = listed((f'"{word}"' for word in (*FORMS, *named_crease_laws())), "or")
    allowed = f"{words}, or the path of a law file"
    return KeyFact(key=key, meaning=field.description or "", allowed=allowed, default=_written(field.default, None))


def _allowed(field: FieldInfo) -> str:
    """Describe the allowed values of a field by its annotation and its bounds."""
    if (table := by_key(field)) is not None:
        return table.allowed
    if words := [rule for rule in field.metadata if isinstance(rule, str)]:
        return words[0]
    reader = field_quantity(field)
    allowed = _quantity(reader) if reader else _plain(field)
    return f"list of: {allowed}" if is_list(field) or _is_list_or_absent(field) else allowed


def _is_list_or_absent(field: FieldInfo) -> bool:
    """Return whether the only values of a field are lists and None."""
    forms = get_args(field.annotation) if field.default is None else ()
    return type(None) in forms and all(get_origin(form) is tuple for form in forms if form is not type(None))


def _written(value: Any, reader: Quantity | None) -> str:
    match value:
        case None | () | [] | {} | "":
            return ""
        case bool():
            return str(value).lower()
        case tuple():
            return f"[{', '.join(_written(entry, reader) for entry in value)}]"
        case float() if reader is not None:
            return show_quantity(value, reader.unit)
        case _:
            return str(value)


def _quantity(reader: Quantity) -> str:
    rules = ((">", reader.above), (">=", reader.at_least), ("<", reader.below), ("<=", reader.at_most))
    bounds = [
        f"{rule} {show_quantity(bound, reader.unit) if bound else 0}" for rule, bound in rules if math.isfinite(bound)
    ]
    return listed([", ".join([reader.unit.display, *bounds]), *(f'"{word}"' for word in reader.words)], "or")


def _plain(field: FieldInfo) -> str:
    """Describe the allowed values of a field without a unit: type and bounds."""
    forms = [form for form in field_forms(field) if form is not type(None)]
    words = [f'"{word}"' for form in forms if get_origin(form) is Literal for word in get_args(form)]
    kinds = {bool: "true or false", int: "whole number", float: "number", str: "text"}
    names = [name for kind, name in kinds.items() if kind in forms]
    signs = {Gt: (">", "gt"), Ge: (">=", "ge"), Lt: ("<", "lt"), Le: ("<=", "le")}
    bounds = [
        f"{sign} {getattr(rule, name):.12g}"
        for rule in field.metadata
        for kind, (sign, name) in signs.items()
        if isinstance(rule, kind)
    ]
    return ", ".join([listed([*names, *words], "or"), *bounds])


def field_forms(field: FieldInfo) -> Iterator[Any]:
    """Yield the types that a field allows; for lists, the types of their entries."""
    yield from _forms(field.annotation)


def _forms(annotation: Any) -> Iterator[Any]:
    """Yield the types that an annotation allows; for lists, the types of their entries."""
    origin = get_origin(annotation)
    if origin is None or origin is Literal:
        yield annotation
        return
    for argument in get_args(annotation):
        if argument is not Ellipsis:
            yield from _forms(argument)
