"""Keys of a design, dotted as in "tendon.stiffness": which there are, and what they hold."""

from __future__ import annotations

import difflib
from collections.abc import Iterable, Iterator, Sequence
from functools import lru_cache
from types import UnionType
from typing import Annotated, Any, TypeVar, Union, get_args, get_origin

from pydantic.fields import FieldInfo

from forficula.design.design import Design
from forficula.design.fan import FanDesign
from forficula.design.file_fields import by_key
from forficula.design.law import LawSection
from forficula.design.part import Part, Quantity, field_quantity
from forficula.design.tables import check_once, entry_index, numbered
from forficula.errors import InputError
from forficula.names import unknown_key
from forficula.quantities import as_written

_PartOf = TypeVar("_PartOf", bound=Part)

# what people write for another word
_MEANT = {"file": "path"}
# sections of a law file that a design has as single keys
_OF_LAW_FILES = {
    "modulus": ("linear_modulus", "quadratic_modulus", "cubic_modulus"),
    "viscosity": ("linear_viscosity", "quadratic_viscosity", "cubic_viscosity"),
    "drift": ("stiffness_drift", "residual_strain_drift"),
}


def key_quantity(key: str, model: type[Design] = FanDesign, given: object = None) -> Quantity | None:
    """How a value of a design is read, or None where it has no unit; a law counts as one value, its name.

    Args:
        key: dotted; a number picks an entry of a list, as in "protocol.stages.1.hold", or the name of an entry, whether
            or not a design has it. "tendon.stiffness" is of all tendons, "tendon.1.stiffness" of that on vein 1.
        model: class of the design.
        given: the value that it was given, for errors, where there is one.

    Raises:
        InputError: there is no such key, or it holds several values.
    """
    try:
        return _quantity_of(key, model)
    except InputError:
        return _found_quantity(key, model, given)


@lru_cache(maxsize=1024)  # what is off, optimised or identified asks for the same keys for each of its designs
def _quantity_of(key: str, model: type[Design]) -> Quantity | None:
    return _found_quantity(key, model, None)


def _found_quantity(key: str, model: type[Design], given: object) -> Quantity | None:
    if key == "based_on":
        raise InputError("based_on: is no value of a design; name the design to start from instead")
    parts = key.split(".")
    place: Any = model
    quantity = None
    for depth, part in enumerate(parts):
        forms = list(_forms(place))
        section = next((form for form in forms if _is_part(form)), None)
        entries = next((form for form in forms if get_origin(form) is tuple), None)
        if entries is not None and (part.isdecimal() or _may_be_called(part, get_args(entries)[0], section)):
            place = get_args(entries)[0]
        elif section is not None:
            field = section.model_fields.get(part)
            if field is None:
                raise InputError(unknown_key(key, given, hint(parts, model)))
            place, quantity = field.annotation, field_quantity(field)
        elif entries is not None:
            of = ".".join(parts[:depth])
            raise InputError(f"{key}: need the number of an entry of {of}, from 0 on, got {as_written(part)}")
        else:
            raise InputError(unknown_key(key, given, f"did you mean {'.'.join(parts[:depth])}?"))
    if any(get_origin(form) is tuple for form in _forms(place)):
        quantity = None
    if LawSection in _forms(place):
        return None
    inside = list(parts_of(place))
    if inside:
        first = key if any(_is_part(form) for form in _forms(place)) else f"{key}.0"
        values = ", ".join(f"{first}.{name}" for name in inside[0].model_fields)
        raise InputError(f"{key}: holds several values; name one of them: {values}")
    return quantity


def names_law(key: str) -> bool:
    """Whether a key is that of a tendon's law."""
    match key.split("."):
        case ["tendon", "law"]:
            return True
        case ["tendon", _, "law"]:
            return True
        case _:
            return False


def key_value(design: Design, key: str) -> Any:
    """What a design has at a key that `key_quantity` knows, in SI; None where that is absent.

    A key of all tendons has what they have in common, and None where they differ.

    Raises:
        InputError: a list of the design has no such entry, or the design lacks a section that needs values.
    """
    section, _, rest = key.partition(".")
    if section == "tendon" and rest and isinstance(design, FanDesign):
        vein, _, inside = rest.partition(".")
        if vein.isdecimal():
            tendon = design.tendons[entry_index([section], vein, design.tendons, inside.split(".") if inside else [])]
            return tendon if tendon is not None and not inside else _value(design, tendon, key, f"tendon.{vein}")
        found = [_value(design, tendon, key, "tendon") for tendon in design.tendons if tendon is not None]
        if not found:
            raise InputError(f"{key}: {design.name} has no tendon")
        return found[0] if all(each == found[0] for each in found) else None
    return _value(design, design, key, "")


def numbered_key(design: Design, key: str) -> str:
    """A key with the numbers of entries in place of their names: the same for all that lead to one value."""
    return numbered(key, design.as_tables())


def check_keys_once(keys: Iterable[str], design: Design) -> None:
    """Refuse two keys that lead to the same value of a design, as of an entry by its number and by its name.

    Raises:
        InputError: which two.
    """
    check_once(keys, design.as_tables())


def _value(design: Design, value: Any, key: str, within: str) -> Any:
    """What a part of a design has at a key, of which `within` leads to the part."""
    parts = key.removeprefix(f"{within}.").split(".")
    left_out = None
    for depth, part in enumerate(parts, start=1):
        value = left_out if value is None else value
        if value is None:
            raise InputError(f"{key}: {design.name} has no {within}")
        left_out = _left_out(value, part)
        if isinstance(value, tuple):
            value = value[entry_index(within.split("."), part, value, parts[depth:])]
        else:
            value = getattr(value, part)
        within = f"{within}.{part}" if within else part
    return value


def _left_out(part: object, name: str) -> Part | None:
    """What counts where a part lacks the section of this name; None where the section has values that are needed."""
    field = type(part).model_fields.get(name) if isinstance(part, Part) else None
    forms = [] if field is None else [form for form in _forms(field.annotation) if _is_part(form)]
    free = [form for form in forms if not any(each.is_required() for each in form.model_fields.values())]
    return free[0]() if free else None


def put(part: _PartOf, key: str, value: object) -> _PartOf:
    """Put a value, SI, at a key that the part has, without another look at what was checked when it was read."""
    name, _, rest = key.partition(".")
    inner = getattr(part, name)
    if not rest:
        return part.model_copy(update={name: value})
    number, _, last = rest.partition(".")
    if isinstance(part, FanDesign) and name == "tendon" and number.isdecimal():
        # one for all becomes one for each
        inner = part.tendons
    if isinstance(inner, tuple):
        every = isinstance(part, FanDesign) and name == "tendon" and not number.isdecimal()
        picked = range(len(inner)) if every else [entry_index([name], number, inner, last.split(".") if last else [])]
        inside = rest if every else last
        entries = [
            entry if place not in picked or entry is None else put(entry, inside, value) if inside else value
            for place, entry in enumerate(inner)
        ]
        return part.model_copy(update={name: tuple(entries)})
    return part.model_copy(update={name: put(inner, rest, value)})


def is_key(text: str, model: type[Part] = FanDesign) -> bool:
    """Whether a text is a key of a design, of one value or of several."""
    *section, last = text.split(".")
    return last in siblings([*section, last], model) or (last.isdecimal() and is_key(".".join(section), model))


def fields_of(model: type[Part] = FanDesign, prefix: str = "") -> Iterator[tuple[str, FieldInfo]]:
    """All keys of a design or of another file.

    Entries of a list of tables stand as number 0, tendons as the one for all, and KEY for the keys of a design in a
    table by these.
    """
    for name, field in model.model_fields.items():
        if (table := by_key(field)) is not None:
            yield f"{prefix}{name}.{table.placeholder}", field
            if table.entry is not None:
                yield from fields_of(table.entry, f"{prefix}{name}.{table.placeholder}.")
            continue
        yield f"{prefix}{name}", field
        forms = list(_forms(field.annotation))
        number = "" if any(_is_part(form) for form in forms) else ".0"
        for part in dict.fromkeys(parts_of(field.annotation)):
            yield from fields_of(part, f"{prefix}{name}{number}.")


def holds_parts(field: FieldInfo) -> bool:
    """Whether a field holds a section, or a list of them, whose keys are fields of their own."""
    return any(parts_of(field.annotation))


def known_keys(model: type[Part] = FanDesign) -> Iterator[str]:
    """The names of `fields_of`."""
    return (key for key, _ in fields_of(model))


def siblings(place: Sequence[str], model: type[Part] = FanDesign) -> list[str]:
    """The keys that are allowed in the section of a place, the protocol last."""
    section = _section(place[:-1], model)
    names = [] if section is None else sorted(section.model_fields, key=lambda name: name == "protocol")
    return [*([] if len(place) > 1 or not issubclass(model, Design) else ["based_on"]), *names]


def needed_keys(place: Sequence[str], model: type[Part] = FanDesign) -> list[str]:
    """The keys that the section of a place cannot do without."""
    section = _section(place[:-1], model)
    return [] if section is None else [name for name, field in section.model_fields.items() if field.is_required()]


def hint(place: Sequence[str], model: type[Part] = FanDesign) -> str:
    """The nearest valid key of the same section, or of another, or all of the section."""
    *section, wrong = place
    for depth, part in enumerate(section):
        if part == "law" and (names := _OF_LAW_FILES.get("".join(place[depth + 1 : depth + 2]))):
            meant = [name for name in names if name.startswith("".join(place[depth + 2 : depth + 3]))] or names
            law = ".".join(section[: depth + 1])
            return f"did you mean {' or '.join(f'{law}.{name}' for name in meant)}?"
    here = siblings(place, model)
    other = _MEANT.get(wrong.lower(), "")
    # names of sections are short: "design" is not near "vein"
    cutoff = 0.6 if section else 0.65
    if near := [other] if other in here else difflib.get_close_matches(wrong.lower(), here, n=1, cutoff=cutoff):
        return f"did you mean {'.'.join([*section, *near])}?"
    elsewhere: dict[str, list[str]] = {}
    for key in known_keys(model):
        elsewhere.setdefault(key.rpartition(".")[2], []).append(key)
    if near := difflib.get_close_matches(wrong.lower(), elsewhere, n=1, cutoff=0.75):
        return f"did you mean {' or '.join(elsewhere[near[0]])}?"
    # where the section itself is unknown, it is what is wrong
    return f"allowed here: {', '.join(here)}" if here or not section else hint(section, model)


def _section(place: Sequence[str], model: type[Part]) -> type[Part] | None:
    """The kind of section at a place, if it is one."""
    at: Any = model
    for part in place:
        forms = list(_forms(at))
        entries = next((form for form in forms if get_origin(form) is tuple), None)
        section = next((form for form in forms if _is_part(form)), None)
        if entries is not None and (part.isdecimal() or _may_be_called(part, get_args(entries)[0], section)):
            at = get_args(entries)[0]
        elif section is not None and part in section.model_fields:
            at = section.model_fields[part].annotation
        else:
            return None
    return next((form for form in _forms(at) if _is_part(form)), None)


def _forms(annotation: Any) -> Iterator[Any]:
    """What a field may hold where it is not absent."""
    if get_origin(annotation) is Annotated:
        yield from _forms(get_args(annotation)[0])
    elif get_origin(annotation) in (Union, UnionType):
        for each in get_args(annotation):
            yield from _forms(each)
    elif annotation is not type(None):
        yield annotation


def _may_be_called(text: str, entry: Any, one_for_all: Any) -> bool:
    """Whether text may be the name of an entry of a list, and is no key of it whose entry was left out."""
    return one_for_all is None and _is_part(entry) and "name" in entry.model_fields and text not in entry.model_fields


def _is_part(annotation: Any) -> bool:
    return isinstance(annotation, type) and issubclass(annotation, Part)


def parts_of(annotation: Any) -> Iterator[type[Part]]:
    """The parts of a design that a field, by its annotation, holds: itself, or each of its list."""
    for form in _forms(annotation):
        if _is_part(form):
            yield form
        elif get_origin(form) is tuple:
            for entry in get_args(form):
                yield from parts_of(entry)
