"""Dotted keys of a design, such as "tendon.stiffness": the list of keys, and the values at them."""

from __future__ import annotations

import difflib
from collections.abc import Iterable, Iterator, Mapping, Sequence
from copy import copy
from functools import lru_cache
from types import UnionType
from typing import Annotated, Any, Literal, TypeVar, Union, get_args, get_origin

from pydantic.fields import FieldInfo

from forficula.design.assembly.assembly import AssemblyDesign
from forficula.design.design import Design
from forficula.design.fans.fan import FanDesign
from forficula.design.file_fields import by_key
from forficula.design.files.kinds import KINDS
from forficula.design.files.tables import check_once, entry_index, numbered
from forficula.design.law import LawSection
from forficula.design.section import Quantity, Section, field_quantity
from forficula.design.sheets.crease_law_section import CreaseLawSection
from forficula.errors import InputError
from forficula.names import listed, unknown_key
from forficula.quantities import as_written

_SectionOf = TypeVar("_SectionOf", bound=Section)

# values of a part that those of the assembly replace
_OF_ASSEMBLY = (
    "medium",
    "stops",
    "table",
    "protocol.gravity",
    "protocol.gravity_direction",
    "protocol.contact",
    "protocol.timestep",
    "protocol.sample_interval",
)
# largest number of keys of other sections in a hint for an unknown key, and of keys of the same section after them
_MOST_MEANT = 4
# words that users write by mistake, with the key that they mean
_MEANT = {"file": "path"}
# sections of a law file that are single keys in a design
_OF_LAW_FILES = {
    "modulus": ("linear_modulus", "quadratic_modulus", "cubic_modulus"),
    "viscosity": ("linear_viscosity", "quadratic_viscosity", "cubic_viscosity"),
    "drift": ("stiffness_drift", "residual_strain_drift"),
}


def key_quantity(key: str, model: type[Design] = FanDesign, text: object = None) -> Quantity | None:
    """Return the reader of a value of a design, or None if it has no unit; a law counts as one value, its name.

    Args:
        key: dotted key. A number or a name selects an entry of a list, as in "protocol.stages.1.hold"; the entry need
            not exist. "tendon.stiffness" means all tendons, "tendon.1.stiffness" the one on vein 1.
        model: class of the design.
        text: value from the user, if any, for error messages.

    Raises:
        InputError: there is no such key, or it holds several values.
    """
    try:
        return _quantity_of(key, model)
    except InputError:
        return _find_quantity(key, model, text)


@lru_cache(maxsize=1024)  # studies, optimisation and identification use the same keys for each of their designs
def _quantity_of(key: str, model: type[Design]) -> Quantity | None:
    return _find_quantity(key, model, None)


def _find_quantity(key: str, model: type[Design], text: object) -> Quantity | None:
    if key == "based_on":
        raise InputError("based_on: is not a value of a design; name the design to start from instead")
    parts = key.split(".")
    place: Any = model
    quantity = None
    for depth, part in enumerate(parts):
        fields, entry = section_fields(place), entry_of(place)
        if entry is not None and (part.isdecimal() or _may_be_called(part, entry, fields)):
            place = entry
        elif fields:
            if part not in fields:
                raise InputError(unknown_key(key, text, hint(parts, model)))
            place, quantity = fields[part].annotation, field_quantity(fields[part])
        elif entry is not None:
            of = ".".join(parts[:depth])
            raise InputError(f"{key}: need the number of an entry of {of}, from 0 on, got {as_written(part)}")
        else:
            raise InputError(unknown_key(key, text, f"did you mean {'.'.join(parts[:depth])}?"))
    if {LawSection, CreaseLawSection}.intersection(form for form in _forms(place) if isinstance(form, type)):
        return None
    section, entry = section_fields(place), entry_of(place)
    if inside := section or section_fields(entry):
        first = key if section else f"{key}.0"
        values = ", ".join(f"{first}.{name}" for name in inside)
        raise InputError(f"{key}: holds several values; name one of them: {values}")
    return None if entry is not None else quantity


def names_law(key: str) -> bool:
    """Return whether a key is the law of a tendon."""
    # the name of a part of an assembly may come first
    match key.split(".")[-3:]:
        case [*_, "tendon", "law"] | ["tendon", _, "law"]:
            return True
        case _:
            return False


def names_crease_law(key: str) -> bool:
    """Return whether a key is the law of creases, of all or of a group."""
    match key.split(".")[-4:]:
        case [*_, "crease", "law"] | ["crease", "group", _, "law"]:
            return True
        case _:
            return False


def key_value(design: Design, key: str) -> Any:
    """Return the value of a design at a key that `key_quantity` accepts, in SI; None if it is absent.

    For a key of all tendons, return their common value, or None if they differ.

    Raises:
        InputError: a list of the design has no such entry, or the design lacks a section with required values.
    """
    section, _, rest = key.partition(".")
    if rest and isinstance(part := getattr(design, section, None), Design):
        try:
            return key_value(part, rest)
        except InputError as error:
            raise InputError(f"{section}.{error}") from None
    if section == "tendon" and rest and isinstance(design, FanDesign):
        vein, _, inside = rest.partition(".")
        if vein.isdecimal():
            tendon = design.tendons[entry_index([section], vein, design.tendons, inside.split(".") if inside else [])]
            return tendon if tendon is not None and not inside else _value(design, tendon, key, f"tendon.{vein}")
        values = [_value(design, tendon, key, "tendon") for tendon in design.tendons if tendon is not None]
        if not values:
            raise InputError(f"{key}: {design.name} has no tendon")
        return values[0] if all(value == values[0] for value in values) else None
    return _value(design, design, key, "")


def numbered_key(design: Design, key: str) -> str:
    """Return a key with the numbers of entries in place of their names, so that equal keys mean the same value."""
    return numbered(key, design.as_tables())


def check_keys_once(keys: Iterable[str], design: Design) -> None:
    """Refuse two keys for the same value of a design, such as an entry by its number and by its name.

    Raises:
        InputError: a value with two keys, or a value of a part that has no effect.
    """
    keys = list(keys)
    check_once(keys, design.as_tables())
    for key in keys:
        if (common := replacing_key(design, key)) is not None:
            raise InputError(f"{key}: has no effect in a part; use {common} of the assembly")


def replacing_key(design: Design, key: str) -> str | None:
    """Return the key of the assembly's value that replaces a value of a part; None for a key that has an effect."""
    whole, rest = design, key
    while isinstance(whole, AssemblyDesign) and (name := rest.partition(".")[0]) in whole.parts:
        whole, rest = getattr(whole, name), rest.partition(".")[2]
    replaced = whole is not design and f"{rest}.".startswith(tuple(f"{common}." for common in _OF_ASSEMBLY))
    return rest if replaced else None


def _value(design: Design, value: Any, key: str, within: str) -> Any:
    """Return the value of a section at a key; `within` is the beginning of the key, which leads to the section."""
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
            # a key that only another kind of section has, such as the angle of a torque drive, is absent
            value = getattr(value, part, None)
        within = f"{within}.{part}" if within else part
    return value


def _left_out(section: object, name: str) -> Section | None:
    """Return the default of a section that is absent; None if that section has required values."""
    field = type(section).model_fields.get(name) if isinstance(section, Section) else None
    forms = [] if field is None else [form for form in _forms(field.annotation) if _is_section(form)]
    optional = [form for form in forms if not any(entry.is_required() for entry in form.model_fields.values())]
    return optional[0]() if optional else None


def put(section: _SectionOf, key: str, value: object) -> _SectionOf:
    """Return a section with a value, SI, at an existing key, without checking the other values again."""
    name, _, rest = key.partition(".")
    inner = getattr(section, name)
    if not rest:
        return section.model_copy(update={name: value})
    number, _, last = rest.partition(".")
    if isinstance(section, FanDesign) and name == "tendon" and number.isdecimal():
        # one tendon for all veins becomes one for each
        inner = section.tendons
    if isinstance(inner, tuple):
        every = isinstance(section, FanDesign) and name == "tendon" and not number.isdecimal()
        picked = range(len(inner)) if every else [entry_index([name], number, inner, last.split(".") if last else [])]
        inside = rest if every else last
        entries = [
            entry if place not in picked or entry is None else put(entry, inside, value) if inside else value
            for place, entry in enumerate(inner)
        ]
        return section.model_copy(update={name: tuple(entries)})
    return section.model_copy(update={name: put(inner, rest, value)})


def is_key(text: str, model: type[Section] = FanDesign) -> bool:
    """Return whether a text is a key of a design, of a value or of a section."""
    *section, last = text.split(".")
    return last in siblings([*section, last], model) or (last.isdecimal() and is_key(".".join(section), model))


def fields_of(annotation: Any = FanDesign, prefix: str = "") -> Iterator[tuple[str, FieldInfo]]:
    """Yield all keys, with their fields, of a design, of another file, or of sections that an annotation allows.

    An entry of a list of tables has the number 0, tendons appear as one for all veins, and KEY represents the keys of a
    design in a table by design keys.
    """
    for name, field in section_fields(annotation).items():
        if (table := by_key(field)) is not None:
            yield f"{prefix}{name}.{table.placeholder}", field
            if table.entry is not None:
                yield from fields_of(table.entry, f"{prefix}{name}.{table.placeholder}.")
            continue
        yield f"{prefix}{name}", field
        if section_fields(field.annotation):
            yield from fields_of(field.annotation, f"{prefix}{name}.")
        else:
            yield from fields_of(entry_of(field.annotation), f"{prefix}{name}.0.")


def holds_sections(field: FieldInfo) -> bool:
    """Return whether a field holds a section or a list of sections, which have further keys."""
    return bool(section_fields(field.annotation) or section_fields(entry_of(field.annotation)))


def known_keys(model: type[Section] = FanDesign) -> Iterator[str]:
    """Yield the keys of `fields_of`."""
    return (key for key, _ in fields_of(model))


def siblings(place: Sequence[str], model: type[Section] = FanDesign) -> list[str]:
    """Return the keys that are allowed beside a key, given by its parts; the protocol comes last."""
    names = sorted(_fields_at(place[:-1], model), key=lambda name: name == "protocol")
    return [*(["based_on"] if len(place) < 2 and issubclass(model, Design) else []), *names]


def needed_keys(place: Sequence[str], model: type[Section] = FanDesign, kind: str = "") -> list[str]:
    """Return the required keys of the section that contains a key; of a section with several kinds, those of `kind`."""
    fields = section_kinds(place[:-1], model).get(kind) or _fields_at(place[:-1], model)
    return [name for name, field in fields.items() if field.is_required()]


def section_kinds(place: Sequence[str], model: type[Section]) -> dict[str, dict[str, FieldInfo]]:
    """Return the fields of a section with several kinds, by the value of its key `kind`; none for other sections."""
    kinds = [form.model_fields for form in _forms(_annotation_at(place, model)) if _is_section(form)]
    return {get_args(fields["kind"].annotation)[0]: fields for fields in kinds} if len(kinds) > 1 else {}


def hint(place: Sequence[str], model: type[Section] = FanDesign) -> str:
    """Return a hint for an unknown key: the nearest key of its section or of another, or all keys of its section."""
    if place[0] == "part" and is_key(".".join(place[1:]), model):
        return f"did you mean {'.'.join(place[1:])}?"
    *section, wrong = place
    for depth, part in enumerate(section):
        if part == "law" and (names := _OF_LAW_FILES.get("".join(place[depth + 1 : depth + 2]))):
            meant = [name for name in names if name.startswith("".join(place[depth + 2 : depth + 3]))] or names
            law = ".".join(section[: depth + 1])
            return f"did you mean {' or '.join(f'{law}.{name}' for name in meant)}?"
    allowed = siblings(place, model)
    word = _MEANT.get(wrong.lower(), "")
    # names of sections are short: "design" is not near "vein"
    cutoff = 0.6 if section else 0.65
    if near := [word] if word in allowed else difflib.get_close_matches(wrong.lower(), allowed, n=1, cutoff=cutoff):
        return f"did you mean {'.'.join([*section, *near])}?"
    elsewhere: dict[str, list[str]] = {}
    for key in known_keys(model):
        elsewhere.setdefault(key.rpartition(".")[2], []).append(key)
    near = difflib.get_close_matches(wrong.lower(), elsewhere, n=1, cutoff=0.75)
    listing = f"allowed here: {', '.join(allowed)}"
    kind = next((name for name in KINDS if KINDS[name] is model), "")
    if kind and not section and (having := [name for name in KINDS if wrong in KINDS[name].model_fields]):
        return f"designs of kind {kind} have no such key, only those of kind {listed(having)}"
    if near and not (section and allowed and len(elsewhere[near[0]]) > _MOST_MEANT):
        few = f" {listing}" * bool(section and 0 < len(allowed) <= _MOST_MEANT)
        return f"did you mean {' or '.join(elsewhere[near[0]])}?{few}"
    # where the section itself is unknown, give a hint for the section
    return listing if allowed or not section else hint(section, model)


def _fields_at(place: Sequence[str], model: type[Section]) -> dict[str, FieldInfo]:
    """Return the fields of a section, given by the parts of its key; none if there is no such section."""
    return section_fields(_annotation_at(place, model))


def field_at(place: Sequence[str], model: type[Section]) -> FieldInfo | None:
    """Return the field of a key, given by its parts; None if there is no such key."""
    return _fields_at(place[:-1], model).get(place[-1])


def holds_texts(place: Sequence[str], model: type[Section]) -> bool:
    """Return whether a key, given by its parts, holds a list of texts."""
    return str in _forms(entry_of(_annotation_at(place, model)))


def words_at(place: Sequence[str], model: type[Section]) -> list[str]:
    """Return the words that a key, given by its parts, allows instead of a table."""
    forms = list(_forms(_annotation_at(place, model)))
    return [word for form in forms if get_origin(form) is Literal for word in get_args(form)]


def without_forms(place: Sequence[str], model: type[Section]) -> list[str]:
    """Return the parts of a place without those that pydantic inserts for a value that may be a table or a word."""
    parts: list[str] = []
    for part in place:
        forms = [form.__name__ for form in _forms(_annotation_at(parts, model)) if _is_section(form)]
        if not parts or not (part in forms or part.startswith("literal[")):
            parts.append(part)
    return parts


def _annotation_at(place: Sequence[str], model: type[Section]) -> Any:
    """Return the annotation of a key, given by its parts; None if there is no such key."""
    at: Any = model
    for part in place:
        fields, entry = section_fields(at), entry_of(at)
        if entry is not None and (part.isdecimal() or _may_be_called(part, entry, fields)):
            at = entry
        elif part in fields:
            at = fields[part].annotation
        else:
            return None
    return at


def section_fields(annotation: Any) -> dict[str, FieldInfo]:
    """Return the fields of the section that an annotation allows, merged over its kinds; none if it is no section.

    A field that only some kinds have is optional, and a field that differs between kinds allows the types of all.
    """
    kinds = [form.model_fields for form in _forms(annotation) if _is_section(form)]
    if len(kinds) < 2:
        return kinds[0] if kinds else {}
    fields: dict[str, FieldInfo] = {}
    names = dict.fromkeys(name for kind in kinds for name in kind)
    # in the order of the last position in any kind
    for name in sorted(names, key=lambda name: max(list(kind).index(name) for kind in kinds if name in kind)):
        having = [kind[name] for kind in kinds if name in kind]
        fields[name] = copy(having[0])
        annotations: Any = tuple(field.annotation for field in having)
        fields[name].annotation = Union[annotations]  # noqa: UP007
        if len(having) < len(kinds):
            fields[name].default = None
    return fields


def _forms(annotation: Any) -> Iterator[Any]:
    """Yield the types that an annotation allows, except None."""
    if get_origin(annotation) is Annotated:
        yield from _forms(get_args(annotation)[0])
    elif get_origin(annotation) in (Union, UnionType):
        for argument in get_args(annotation):
            yield from _forms(argument)
    elif annotation is not type(None):
        yield annotation


def entry_of(annotation: Any) -> Any:
    """Return the annotation of the entries of a list; None if the annotation is not a list."""
    return next((get_args(form)[0] for form in _forms(annotation) if get_origin(form) is tuple), None)


def _may_be_called(text: str, entry: Any, one_for_all: Mapping[str, FieldInfo]) -> bool:
    """Return whether text may be the name of an entry of a list, instead of a key whose entry was left out."""
    fields = section_fields(entry)
    return not one_for_all and "name" in fields and text not in fields


def _is_section(annotation: Any) -> bool:
    return isinstance(annotation, type) and issubclass(annotation, Section)
