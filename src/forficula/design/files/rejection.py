"""Error messages for designs and other files: one line with the key, the rule, the value and the file."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence
from typing import Any, TypeVar

from pydantic import ValidationError

from forficula.design.design import Design
from forficula.design.fans.fan import FanDesign
from forficula.design.files.key_table import key_facts
from forficula.design.files.keys import (
    field_at,
    hint,
    holds_texts,
    is_key,
    known_keys,
    needed_keys,
    section_kinds,
    siblings,
    without_forms,
    words_at,
)
from forficula.design.files.tables import RejectedError, written_key
from forficula.design.section import Section
from forficula.names import listed, near_name, unknown_key
from forficula.quantities import as_written

_SectionOf = TypeVar("_SectionOf", bound=Section)
# name of a file and its tables
File = tuple[str, dict[str, Any]]


def read_section(model: type[_SectionOf], tables: Mapping[str, object]) -> _SectionOf:
    """Read the tables of a file, or one of its sections.

    Args:
        model: class of the file or the section.
        tables: values by key.

    Raises:
        RejectedError: an unknown key, or a value that is not allowed.
    """
    try:
        return model.model_validate(tables)
    except ValidationError as error:
        raise rejected(error, model) from None


def rejected(error: ValidationError, model: type[Section]) -> RejectedError:
    """Convert an error of pydantic for a design or another file to one line: key, rule, value."""
    # Other errors may be consequences of the first, so one is reported; a misspelt key comes before a missing one.
    errors: list[Any] = list(error.errors(include_url=False))
    worst = next((entry for entry in errors if entry["type"] == "extra_forbidden"), errors[0])
    kind, value, bounds = worst["type"], worst["input"], worst.get("ctx", {})
    # tags that pydantic inserts for the kind of a section
    tags = [part for part in map(str, worst["loc"]) if re.fullmatch(r"<[a-z -]+>", part)]
    parts, which = [str(part) for part in worst["loc"] if part not in tags], "".join(tags).strip("<>")
    place = without_forms(parts, model)
    if kind.startswith("union_tag_"):
        # the key `kind` of a section with several kinds is missing or wrong
        kinds, place = section_kinds(place, model), [*place, "kind"]
        if not isinstance(value, dict):
            kind, place = "model_type", place[:-1]
        elif "kind" in value:
            kind, value, bounds = "literal_error", value["kind"], {"expected": listed(map(as_written, kinds), "or")}
        else:
            kind = "missing"
    key = written_key(place)
    if kind == "value_error":
        return _of_a_check(place, str(bounds["error"]), model, which)
    if kind == "extra_forbidden":
        if place[-1] in siblings(place, model):
            keys = ", ".join(section_kinds(place[:-1], model).get(which, {}))
            return RejectedError(place, f'{key}: is not for kind = "{which}"' + (f", which has {keys}" if keys else ""))
        return RejectedError(place, unknown_key(key, value, hint(place, model)))
    if kind == "missing" and place[-1].isdecimal() and isinstance(value, list | tuple):
        return RejectedError(place[:-1], f"{written_key(place[:-1])}: need more entries, got {as_written(value)}")
    if kind == "missing":
        return RejectedError(place[:-1], f"{key}: is missing; {_remedy(place, model, which)}")
    rule = _rule(place, kind, value, bounds, model)
    near = near_name(value, rule.split('"')[1::2]) if kind == "literal_error" and isinstance(value, str) else ""
    if kind.startswith("model_") and is_key(f"protocol.{key}", model):
        near = f"; did you mean protocol.{key}?"
    return RejectedError(place, f"{key}: need {rule}, got {as_written(value)}{near}")


def origin(place: Sequence[str], files: Sequence[File], settings: Iterable[str]) -> str:
    """Return the name of the file that contains a value; "" if a setting gave the value.

    Args:
        place: parts of the key of the value; empty for the design as a whole, whose file is the last one.
        files: files from which a design is read; later ones override earlier ones.
        settings: dotted keys of the settings.
    """
    if not place:
        return files[-1][0]
    keys = [".".join(place)]
    if place[0] == "tendon" and len(place) > 1 and place[1].isdecimal():
        # the key of all tendons
        keys.append(".".join(["tendon", *place[2:]]))
    for setting in settings:
        if any(f"{key}.".startswith(f"{setting}.") or f"{setting}.".startswith(f"{key}.") for key in keys):
            return ""
    return next((name for name, tables in reversed(files) if _contains(tables, place)), files[-1][0])


def _contains(tables: object, place: Sequence[str]) -> bool:
    for part in place:
        if isinstance(tables, list) and part.isdecimal():
            # by their number of a vein, or by their position
            entries = [(entry.get("vein", at), entry) for at, entry in enumerate(tables) if isinstance(entry, dict)]
            tables = next((entry for vein, entry in entries if vein == int(part)), None)
        elif isinstance(tables, dict) and part in tables:
            tables = tables[part]
        elif not (isinstance(tables, dict) and part.isdecimal()):
            return False
    return True


def _of_a_check(place: list[str], message: str, model: type[Section], which: str) -> RejectedError:
    """Convert the message of a check of a value, of a section or of the whole design."""
    name = message.partition(":")[0]
    if name in siblings([*place, ""], model) and place:
        place, missing = [*place, name], message.endswith(": is missing")
        remedy = f"; {_remedy(place, model, which)}" if missing else ""
        return RejectedError(place[:-1] if missing else place, f"{written_key(place[:-1])}.{message}{remedy}")
    if is_key(name, model):  # a check of several values has no single place
        return RejectedError([], message)
    if place and is_key(f"{written_key(place)}.{name}", model):  # the same of a part of an assembly
        return RejectedError(place, _of_a_part(written_key(place), message, model))
    if place and not message.startswith((f"{written_key(place)}.", f"{written_key(place)} ")):
        message = f"{written_key(place)}: {message}"
    return RejectedError(place, message)


def _of_a_part(part: str, message: str, model: type[Section]) -> str:
    """Return the message of a check of a part, with the name of the part before every key in the message."""

    def named(match: re.Match[str]) -> str:
        return f"{part}.{match[0]}" if is_key(f"{part}.{match[0]}", model) else match[0]

    return re.sub(r"(?<![\w.])[a-z_]+(?:\.\w+)+", named, message)


def _remedy(place: list[str], model: type[Section], which: str) -> str:
    """Return the advice for a missing key; `which` is the kind of its section."""
    if not issubclass(model, Design):
        (fact,) = key_facts(".".join(place), model)
        return f"give it ({fact.allowed})"
    reference = model.reference
    to_inherit = f'give it, or begin the file with based_on = "{reference}"' if reference else "give it"
    if place[-2:-1] == ["law"]:
        return 'give it, or name a material as in tendon.law = "tpu-82a"'
    if model is FanDesign and place[0] == "tendon" and "law" not in place:
        return to_inherit
    section = model.model_fields.get(place[0])
    if len(place) > 1 and section is not None and not section.is_required() and section.default is None:
        # the reference design has no such section
        return f"give it, or leave out [{place[0]}]"
    if any(part.isdecimal() for part in place):
        needed = needed_keys(place, model, which)
        if needed != place[-1:] and needed:
            return f"needed here: {', '.join(needed)}"
        examples = getattr(field_at(place, model), "examples", None) or []
        return "give it" + "".join(f", such as {place[-1]} = {as_written(example)}" for example in examples[:1])
    within = {} if section is None else getattr(section.annotation, "model_fields", {})
    if len(place) > 2 and place[1] in within and within[place[1]].default is None:
        # a section within a section that the reference design does not have
        return f"give it, or leave out {place[0]}.{place[1]}"
    return to_inherit


def _rule(place: list[str], kind: str, value: object, bounds: Mapping[str, Any], model: type[Section]) -> str:
    """Describe the allowed values, by pydantic's name of the error."""
    header = ".".join(part for part in place if not part.isdecimal())
    first = ".".join("0" if part.isdecimal() else part for part in place)
    entries = f"{first}." if place[-1].isdecimal() else f"{first}.0."
    is_tables = any(key.startswith(entries) for key in known_keys(model))
    bare = " without quotes" if isinstance(value, str) else ""
    rules = {
        "greater_than": "> {gt:.12g}",
        "greater_than_equal": ">= {ge:.12g}",
        "less_than": "< {lt:.12g}",
        "less_than_equal": "<= {le:.12g}",
        "literal_error": "{expected}",
        "too_short": "at least {min_length} entry",
        "too_long": "at most {max_length} entries",
        "string_too_short": "some text",
        "int": f"a whole number{bare}",
        "float": f"a number{bare}",
        "finite_number": "a finite number",
        "string": "text in quotes",
        "bool": f"true or false{bare}",
        "dict": "a table",
        "tuple": f"a list of tables, each under [[{header}]]" if is_tables else _list_rule(place, model),
        "model": _table_rule(header, words_at(place, model), is_list=is_tables),
    }
    if not issubclass(model, Design) and kind.startswith(("greater", "less", "int", "string_type")):
        # for files other than designs, the table of keys describes all allowed values
        for fact in key_facts(".".join("0" if part.isdecimal() else part for part in place), model):
            if fact.allowed.startswith("whole number"):
                return f"a {fact.allowed.replace(', >=', ' >=').replace(', <=', ' and <=')}{bare}"
            if kind == "string_type" and fact.allowed != "text":
                return f"text in quotes: {fact.allowed}"
    rule = rules.get(kind) or next((text for name, text in rules.items() if kind.startswith(f"{name}_")), kind)
    return rule.format(**bounds).replace("'", '"')


def _list_rule(place: list[str], model: type[Section]) -> str:
    return (
        'a list of texts such as ["one", "two"]'
        if holds_texts(place, model)
        else "a list of numbers such as [0.3, 0.6]"
    )


def _table_rule(header: str, words: Sequence[str], *, is_list: bool) -> str:
    if header in ("crease.law", "crease.group.law"):
        return f"the form of a spring, the name of a law, the path of a law file, or a table under [{header}]"
    if header == "tendon.law":
        return "the name of a material, the path of a law file, or a table under [tendon.law]"
    return listed([f"a table under {f'[[{header}]]' if is_list else f'[{header}]'}", *map(as_written, words)], "or")
