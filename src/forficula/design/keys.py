"""Keys of a design, dotted as in "tendon.stiffness": which there are, and what they hold."""

from __future__ import annotations

import difflib
from collections.abc import Iterator, Sequence
from types import UnionType
from typing import Any, TypeVar, get_args, get_origin

from pydantic import BaseModel

from forficula.design.design import Design
from forficula.design.fan import FanDesign
from forficula.design.part import Part, Quantity, field_quantity
from forficula.errors import InputError
from forficula.quantities import as_written

_PartOf = TypeVar("_PartOf", bound=Part)

# sections of a law file that a design has as single keys
_OF_LAW_FILES = {
    "modulus": ("linear_modulus", "quadratic_modulus", "cubic_modulus"),
    "viscosity": ("linear_viscosity", "quadratic_viscosity", "cubic_viscosity"),
    "drift": ("stiffness_drift", "residual_strain_drift"),
}


def key_quantity(key: str, model: type[Design] = FanDesign) -> Quantity | None:
    """How a value of a design is read, or None where it has no unit; a law counts as one value, its name.

    Args:
        key: dotted; a number picks an entry of a list, as in "protocol.stages.1.hold", or the name of an
            entry, whether or not a design has it.
        model: class of the design.

    Raises:
        InputError: there is no such key, or it holds several values.
    """
    if key == "based_on":
        raise InputError("based_on: is no value of a design; name the design to start from instead")
    if key == "tendon.law" and issubclass(model, FanDesign):
        return None
    parts = key.split(".")
    place: Any = model
    quantity = None
    for depth, part in enumerate(parts):
        if _is_part(place):
            field = place.model_fields.get(part)
            if field is None:
                raise InputError(f"{key}: unknown key; {hint(parts, model)}")
            place, quantity = _without_none(field.annotation), field_quantity(field)
        elif get_origin(place) is not tuple:
            raise InputError(f"{key}: unknown key; did you mean {'.'.join(parts[:depth])}?")
        elif not part.isdecimal() and not _may_be_called(part, get_args(place)[0]):
            of = ".".join(parts[:depth])
            raise InputError(f"{key}: need the number of an entry of {of}, from 0 on, got {as_written(part)}")
        else:
            place = get_args(place)[0]
    if get_origin(place) is tuple:
        quantity = None
    inside = list(_parts(place))
    if inside:
        first = f"{key}.0" if get_origin(place) is tuple else key
        values = ", ".join(f"{first}.{name}" for name in inside[0].model_fields)
        raise InputError(f"{key}: holds several values; name one of them: {values}")
    return quantity


def key_value(design: Design, key: str) -> Any:
    """What a design has at a key that `key_quantity` knows, in SI; None where that is absent.

    Raises:
        InputError: a list of the design has no such entry, or the design lacks the section.
    """
    value: Any = design
    within = ""
    for part in key.split("."):
        if value is None:
            raise InputError(f"{key}: {design.name} has no {within}")
        value = value[entry_index(key, part, value)] if isinstance(value, tuple) else getattr(value, part)
        within = f"{within}.{part}" if within else part
    return value


def put(part: _PartOf, key: str, value: object) -> _PartOf:
    """Put a value, SI, at a key that the part has, without another look at what was checked when it was read."""
    name, _, rest = key.partition(".")
    inner = getattr(part, name)
    if not rest:
        return part.model_copy(update={name: value})
    if isinstance(inner, tuple):
        entry, _, rest = rest.partition(".")
        number = entry_index(key, entry, inner)
        changed = put(inner[number], rest, value) if rest else value
        return part.model_copy(update={name: (*inner[:number], changed, *inner[number + 1 :])})
    return part.model_copy(update={name: put(inner, rest, value)})


def entry_index(key: str, text: str, entries: Sequence[Any]) -> int:
    """Find an entry of a list by its number or its name.

    Args:
        key: that it is a part of.
        text: the number, or the name where the entries have names.
        entries: of the list: of a design, or of the tables of a file.

    Raises:
        InputError: there is none, and which there are.
    """
    if text in (allowed := [str(index) for index in range(len(entries))]):
        return int(text)
    names = [entry.get("name") if isinstance(entry, dict) else getattr(entry, "name", None) for entry in entries]
    if names.count(text) == 1:
        return names.index(text)
    shown = ", ".join(f"{index} ({name})" if name else index for index, name in zip(allowed, names, strict=True))
    rule = f"need one of the numbers {shown} in it" if shown else "has no entries"
    raise InputError(f"{key}: {rule}, got {as_written(text)}")


def known_keys(model: type[BaseModel] = FanDesign, prefix: str = "") -> Iterator[str]:
    """All keys of a design; entries of a list of tables stand as number 0."""
    for name, field in model.model_fields.items():
        yield f"{prefix}{name}"
        number = ".0" if get_origin(field.annotation) is tuple else ""
        for part in _parts(field.annotation):
            yield from known_keys(part, f"{prefix}{name}{number}.")


def siblings(place: Sequence[str], model: type[Design] = FanDesign) -> list[str]:
    """The keys that are allowed in the section of a place."""
    section = "".join("0." if part.isdecimal() else f"{part}." for part in place[:-1])
    inside = [key.removeprefix(section) for key in known_keys(model) if key.startswith(section)]
    return [*([] if section else ["based_on"]), *(key for key in inside if "." not in key)]


def hint(place: Sequence[str], model: type[Design] = FanDesign) -> str:
    """The nearest valid key of the same section, or of another, or all of the section."""
    if list(place[:2]) == ["tendon", "law"] and (names := _OF_LAW_FILES.get("".join(place[2:3]))):
        meant = [name for name in names if name.startswith("".join(place[3:4]))] or names
        return f"did you mean {' or '.join(f'tendon.law.{name}' for name in meant)}?"
    *section, wrong = place
    here = siblings(place, model)
    if near := difflib.get_close_matches(wrong.lower(), here, n=1):
        return f"did you mean {'.'.join([*section, *near])}?"
    elsewhere: dict[str, list[str]] = {}
    for key in known_keys(model):
        elsewhere.setdefault(key.rpartition(".")[2], []).append(key)
    if near := difflib.get_close_matches(wrong.lower(), elsewhere, n=1, cutoff=0.75):
        return f"did you mean {' or '.join(elsewhere[near[0]])}?"
    # where the section itself is unknown, it is what is wrong
    return f"allowed here: {', '.join(here)}" if here or not section else hint(section, model)


def _without_none(annotation: Any) -> Any:
    """What a field holds where it is not absent."""
    given = [each for each in get_args(annotation) if each is not type(None)]
    return given[0] if len(given) == 1 and get_origin(annotation) is UnionType else annotation


def _may_be_called(text: str, entry: Any) -> bool:
    """Whether text may be the name of an entry of a list, and is no key of it whose entry was left out."""
    return _is_part(entry) and "name" in entry.model_fields and text not in entry.model_fields


def _is_part(annotation: Any) -> bool:
    return isinstance(annotation, type) and issubclass(annotation, Part)


def _parts(annotation: Any) -> Iterator[type[Part]]:
    """The parts of a design that a field holds: itself, or each of its list."""
    for candidate in (annotation, *get_args(annotation)):
        if _is_part(candidate):
            yield candidate
