"""Design files: TOML in and out, with errors that name the key."""

from __future__ import annotations

import difflib
import os
import re
import tomllib
from collections.abc import Iterable, Iterator, Mapping, Sequence
from importlib import resources
from pathlib import Path
from typing import Any

import tomli_w
from pydantic import ValidationError
from pydantic.fields import FieldInfo

from forficula.design.design import Design
from forficula.design.keys import entry_index, hint, known_keys, siblings
from forficula.design.kinds import KINDS, REFERENCES, design_class, kind_of, reference_of
from forficula.design.law_tables import law_taken_off, names_law, with_following, with_law_read, without_following
from forficula.design.part import Part, as_tables, entry_part, field_quantity
from forficula.design.sheet_tables import with_sheet_read
from forficula.design.tables import RejectedError, WholeTable, merged, overlaid
from forficula.errors import InputError
from forficula.files import read_toml, write_text
from forficula.quantities import as_written

REFERENCE = "binder2025"

# a file's name and the tables that stand in it
_File = tuple[str, dict[str, Any]]


def load_design(name_or_path: str | Path, settings: Mapping[str, object] | None = None) -> Design:
    """Read a named design or a design file, with some values replaced.

    Args:
        name_or_path: one of `named_designs`, or the path of a TOML file.
        settings: values by dotted key or in nested tables, as in {"tendon.stiffness": "20 N/cm"} or
            {"tendon": {"stiffness": "20 N/cm"}}; text with units, as in a file.

    Returns:
        The design, checked.

    Raises:
        InputError: no such design or file, not TOML, an unknown key, or a value that is not allowed.
    """
    files = _read_files(str(name_or_path))
    tables: dict[str, Any] = {}
    for where, given in files:
        tables, own = law_taken_off(tables, _of_kind(where, tables, given))
        tables = merged(without_following(tables, own), own)
    tables = _with_settings(tables, settings or {})
    try:
        return _validate(tables)
    except RejectedError as error:
        where = _origin(error.place, files, _dotted(settings or {}))
        raise InputError(f"{where}: {error}" if where else str(error)) from None


def with_values(design: Design, values: Mapping[str, object]) -> Design:
    """Replace some values by dotted key; floats with a unit are SI, and "tendon.law" may be a `MaterialLaw`.

    Raises:
        InputError: an unknown key, or a value that is not allowed.
    """
    tables = _with_settings(design.model_dump(mode="json", exclude_none=True), values, si=True)
    try:
        return _validate(tables, si=True)
    except RejectedError as error:
        raise InputError(f"{design.name}: {error}") from None


def named_designs() -> dict[str, str]:
    """The names of the designs that come with the package, each with its source."""
    return {name: load_design(name).source for name in _named()}


def save_design(design: Design, path: str | os.PathLike[str]) -> None:
    """Write every value of a design; reading the file gives the same bits."""
    write_text(Path(path), design_text(design))


def design_text(design: Design) -> str:
    """Every value of a design as TOML."""
    tables = as_tables(design)
    return tomli_w.dumps({name: tables[name] for name in _sections(design) if name in tables})


def design_from_text(text: str) -> Design:
    """Read what `design_text` wrote.

    Raises:
        InputError: a key or value that is not allowed.
        TOMLDecodeError: it is not TOML.
    """
    return _validate(tomllib.loads(text))


def write_new_design(path: str | os.PathLike[str], kind: str = "earwig-fan") -> None:
    """Write a commented design file to start from: the reference, every key with what it means.

    Args:
        path: of the file.
        kind: of its pattern, such as "earwig-fan" or "pleats".

    Raises:
        InputError: no such kind, or the file exists already, or cannot be written.
    """
    path = Path(path)
    if kind not in REFERENCES:
        hint = f"; {_nearest(kind, list(REFERENCES))}" if _nearest(kind, list(REFERENCES)) else ""
        raise InputError(f"kind: need one of {', '.join(REFERENCES)}, got {as_written(kind)}{hint}")
    reference = REFERENCES[kind]
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
        f'based_on = "{reference}"',
    ]
    write_text(path, "\n".join([*lines, *_commented(load_design(reference))]) + "\n")


def _named() -> list[str]:
    folder = resources.files("forficula.design") / "references"
    return sorted(entry.name.removesuffix(".toml") for entry in folder.iterdir() if entry.name.endswith(".toml"))


def _read_files(name_or_path: str, above: tuple[Path, ...] = ()) -> list[_File]:
    """A design and what it is based on, the last one first."""
    if name_or_path in _named():
        text = (resources.files("forficula.design") / "references" / f"{name_or_path}.toml").read_text("utf-8")
        return [(name_or_path, tomllib.loads(text))]
    path = Path(name_or_path)
    if path.suffix.lower() != ".toml":
        known = [*_named(), *sorted(str(file) for file in Path().glob("*.toml"))]
        hint = _nearest(name_or_path, known) or f"the named designs are {', '.join(_named())}"
        raise InputError(f"{as_written(name_or_path)} is neither a named design nor a .toml file; {hint}")
    tables = read_toml(path, "a design")
    if path.resolve() in above:
        raise InputError(f"{path}: goes round in a circle")
    tables.setdefault("name", path.stem)
    try:
        tables = {key: with_law_read(key, value, folder=path.parent) for key, value in tables.items()}
        tables = with_sheet_read(tables, folder=path.parent)
    except InputError as error:
        raise InputError(f"{path}: {error}") from None
    base = tables.pop("based_on", None)
    if base is None:
        return [(name_or_path, tables)]
    if not isinstance(base, str):
        raise InputError(f'{path}: based_on: need the name of a design such as "{REFERENCE}", got {as_written(base)}')
    if base.lower().endswith(".toml"):
        base = str(path.parent / base)
    try:
        return [*_read_files(base, (*above, path.resolve())), (name_or_path, tables)]
    except InputError as error:
        raise InputError(f"{path}: based_on: {error}") from None


def _with_settings(tables: dict[str, Any], settings: Mapping[str, object], *, si: bool = False) -> dict[str, Any]:
    """Put values into tables by their dotted keys, a law that is named before values of it."""
    read = {key: with_law_read(key, value, si=si) for key, value in with_sheet_read(settings).items()}
    tables, read = law_taken_off(_with_kind(tables, read.get("pattern.kind")), read, si=si)
    nested: dict[str, Any] = {}
    for key, value in read.items():
        _nest(nested, key, value)
    tables = without_following(tables, nested)
    for key, value in sorted(read.items(), key=lambda each: not names_law(each[1])):
        _set(tables, key, value)
    return tables


def _of_kind(where: str, tables: Mapping[str, Any], given: dict[str, Any]) -> dict[str, Any]:
    """What a file gives, its pattern whole where that is of another kind than the one that it is laid over."""
    kind, below = kind_of(given), kind_of(tables)
    if kind is None or below is None or kind == below:
        return given
    model = design_class(given)
    if not _alike(model, KINDS[below]):
        own = reference_of(model)
        instead = f'leave it out, or begin with based_on = "{own}"' if own else "leave it out"
        raise InputError(f"{where}: based_on: is a design of kind {below}, which has other sections; {instead}")
    return given | {"pattern": WholeTable(given["pattern"])}


def _with_kind(tables: dict[str, Any], kind: object) -> dict[str, Any]:
    """Tables to set the kind of the pattern in: without a pattern of another kind."""
    below = kind_of(tables)
    if kind == below or not isinstance(kind, str) or kind not in KINDS or below not in KINDS:
        return tables
    if not _alike(KINDS[kind], KINDS[str(below)]):
        raise InputError(f"pattern.kind: designs of kind {kind} have other sections than those of kind {below}")
    return tables | {"pattern": {}}


def _alike(one: type[Design], other: type[Design]) -> bool:
    """Whether two kinds of designs have the same sections."""
    return one.model_fields.keys() == other.model_fields.keys()


def _nest(tables: dict[str, Any], key: str, value: object) -> None:
    """Put a value into tables of its own, as far as its key goes."""
    *sections, last = key.split(".")
    for section in sections:
        inner = tables.setdefault(section, {})
        if not isinstance(inner, dict):
            return
        tables = inner
    tables[last] = value


def _set(tables: dict[str, Any], key: str, value: object) -> None:
    """Put a value into nested tables by its dotted key; a number picks a table of a list."""
    if key == "based_on":
        raise InputError("based_on: cannot be set; name the design to start from instead")
    *sections, last = key.split(".")
    place: Any = tables
    for depth, section in enumerate(sections, start=1):
        place = place.setdefault(section, {}) if isinstance(place, dict) else place[entry_index(key, section, place)]
        if not isinstance(place, dict | list):
            raise InputError(f"{key}: unknown key; did you mean {'.'.join(sections[:depth])}?")
    at: Any = entry_index(key, last, place) if isinstance(place, list) else last
    inner = place[at] if isinstance(place, list) else place.get(at)
    place[at] = overlaid(inner, value)


def _dotted(tables: Mapping[str, object], prefix: str = "") -> Iterator[str]:
    """The dotted keys of all values in nested tables."""
    for key, value in tables.items():
        if isinstance(value, Mapping):
            yield from _dotted(value, f"{prefix}{key}.")
        else:
            yield f"{prefix}{key}"


def _validate(tables: dict[str, Any], *, si: bool = False) -> Design:
    model = design_class(tables)
    try:
        return model.model_validate(with_following(tables, si=si), context={"si": si})
    except ValidationError as error:
        # A wrong value hides what depends on it, so one error is enough; a misspelt key may be the missing one.
        errors = error.errors(include_url=False)
        worst = next((each for each in errors if each["type"] == "extra_forbidden"), errors[0])
        raise _rejected([str(part) for part in worst["loc"]], worst, model) from None


def _origin(place: Sequence[str], files: Sequence[_File], settings: Iterable[str]) -> str:
    """The file where a value stands, or the design as a whole; nothing where it was set by hand."""
    if not place:
        return files[-1][0]
    key = ".".join(place)
    for setting in settings:
        if f"{key}.".startswith(f"{setting}.") or f"{setting}.".startswith(f"{key}."):
            return ""
    return next((where for where, tables in reversed(files) if _stands_in(tables, place)), files[-1][0])


def _stands_in(tables: object, place: Sequence[str]) -> bool:
    for part in place:
        if isinstance(tables, list) and part.isdigit():
            tables = dict(enumerate(tables)).get(int(part))
        elif isinstance(tables, dict) and part in tables:
            tables = tables[part]
        else:
            return False
    return True


def _rejected(place: list[str], error: Any, model: type[Design]) -> RejectedError:
    """One pydantic error as one line: key, rule, value."""
    key = _written_key(place)
    kind, value, bounds = error["type"], error["input"], error.get("ctx", {})
    if kind == "value_error":
        message = str(bounds["error"])
        named = re.sub(r"\.\d+(?=\.)", ".0", message.partition(":")[0])
        if named in known_keys(model):  # a check of several values, no one of them to blame
            return RejectedError([], message)
        return RejectedError(place, f"{key}: {message}" if key else message)
    if kind == "extra_forbidden":
        return RejectedError(place, f"{key}: unknown key; {hint(place, model)}")
    if kind == "missing":
        in_list = any(part.isdigit() for part in place)
        reference = reference_of(model)
        to_inherit = f'give it, or begin the file with based_on = "{reference}"' if reference else "give it"
        if place[:2] == ["tendon", "law"]:
            to_inherit = 'give it, or name a material as in tendon.law = "tpu-82a"'
        remedy = f"needed here: {', '.join(siblings(place, model))}" if in_list else to_inherit
        return RejectedError(place[:-1], f"{key}: is missing; {remedy}")
    return RejectedError(place, f"{key}: need {_rule(place, kind, value, bounds, model)}, got {as_written(value)}")


def _rule(place: list[str], kind: str, value: object, bounds: Mapping[str, Any], model: type[Design]) -> str:
    """What is allowed, by pydantic's name of the error."""
    header = ".".join(part for part in place if not part.isdigit())
    is_tables = any(key.startswith(f"{header}.0.") for key in known_keys(model))
    bare = " without quotes" if isinstance(value, str) else ""
    rules = {
        "greater_than": "> {gt:g}",
        "greater_than_equal": ">= {ge:g}",
        "less_than": "< {lt:g}",
        "less_than_equal": "<= {le:g}",
        "literal_error": "{expected}",
        "too_short": "at least {min_length} entry",
        "too_long": "at most {max_length} entry",
        "string_too_short": "some text",
        "int": f"a whole number{bare}",
        "float": f"a number{bare}",
        "finite_number": "a finite number",
        "string": "text in quotes",
        "bool": f"true or false{bare}",
        "tuple": f"a list of tables, each under [[{header}]]" if is_tables else "a list of numbers such as [0.3, 0.6]",
        "model": _table_rule(header, is_list=is_tables),
    }
    rule = rules.get(kind) or next((text for name, text in rules.items() if kind.startswith(f"{name}_")), kind)
    return rule.format(**bounds).replace("'", '"')


def _table_rule(header: str, *, is_list: bool) -> str:
    if header == "tendon.law":
        return "the name of a material, the path of a law file, or a table under [tendon.law]"
    return f"a table under [[{header}]]" if is_list else f"a table under [{header}]"


def _written_key(place: Sequence[str]) -> str:
    """A key as a TOML file has it."""
    return ".".join(part if re.fullmatch(r"[A-Za-z0-9_-]{1,60}", part) else as_written(part) for part in place)


def _nearest(word: str, words: list[str]) -> str | None:
    near = difflib.get_close_matches(word, words, n=1)
    return f'did you mean "{near[0]}"?' if near else None


def _sections(design: Design) -> list[str]:
    """Names and sections in the order of a file: what is built, then what is done to it."""
    return sorted(type(design).model_fields, key=lambda name: name == "protocol")


def _commented(design: Design) -> Iterator[str]:
    """The sections of a design, every key with its meaning."""
    for section in _sections(design):
        part = getattr(design, section)
        if isinstance(part, tuple):
            yield from _commented_tables(section, part, type(design).model_fields[section])
        if not isinstance(part, Part):
            continue
        yield f"\n[{section}]  # {(type(part).__doc__ or '').splitlines()[0].removesuffix('.')}"
        values, lists = as_tables(part), []
        for key, entry in type(part).model_fields.items():
            if entry_part(entry) is not None:
                # a table under a header of its own ends what stands under the section's
                lists.append((key, entry))
                continue
            if key not in values:
                yield f"{'# ' + _example(key, entry):<40}  # {entry.description}"
                continue
            value = tomli_w.dumps({key: values[key]}).strip().replace("[\n    ", "[").replace(",\n]", "]")
            yield f"{value:<40}  # {entry.description}"
        for key, entry in lists:
            if key == "stages":
                yield from _commented_stages(values["stages"], entry.description)
            else:
                yield from _commented_tables(f"{section}.{key}", getattr(part, key), entry)


def _example(key: str, entry: FieldInfo) -> str:
    """A line for a value that is absent."""
    reader = field_quantity(entry)
    return tomli_w.dumps({key: reader.unit.example if reader else (entry.examples or [""])[0]}).strip()


def _commented_tables(header: str, entries: Sequence[Part], field: FieldInfo) -> Iterator[str]:
    """The entries of a list of tables, commented out, every key with its meaning; an example where there are none."""
    yield f"\n# {field.description}; giving any replaces all of them."
    model = entry_part(field)
    for values in [as_tables(part) for part in entries] or [{}]:
        yield f"# [[{header}]]"
        for key, entry in ({} if model is None else model.model_fields).items():
            if entries and key not in values:
                continue
            line = tomli_w.dumps({key: values[key]}).strip() if key in values else _example(key, entry)
            yield f"{'# ' + line:<40}  # {entry.description}"


def _commented_stages(stages: list[dict[str, Any]], description: str | None) -> Iterator[str]:
    """The stages, commented out: a list of tables replaces the whole list."""
    yield f"\n# {description}; giving any stage replaces all of them."
    for stage in stages:
        yield "# [[protocol.stages]]"
        yield from (f"# {line}" for line in tomli_w.dumps(stage).strip().splitlines())
