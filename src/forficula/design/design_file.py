"""Design files: TOML in and out, with errors that name the key."""

from __future__ import annotations

import difflib
import tomllib
from collections.abc import Iterator, Mapping
from importlib import resources
from pathlib import Path
from typing import Any

import tomli_w
from pydantic import BaseModel, ValidationError

from forficula.design.design import Design, Part, Quantity, field_quantity
from forficula.errors import InputError
from forficula.files import write_text
from forficula.quantities import format_quantity

REFERENCE = "binder2025"


def load_design(name_or_path: str | Path, settings: Mapping[str, object] | None = None) -> Design:
    """Read a named design or a design file, with some values replaced.

    Args:
        name_or_path: one of `named_designs`, or the path of a TOML file.
        settings: values by dotted key, as in {"tendon.stiffness": "20 N/cm"}; text with units, as in a file.

    Returns:
        The design, checked.

    Raises:
        InputError: no such design or file, not TOML, an unknown key, or a value that is not allowed.
    """
    tables, where = _read_tables(str(name_or_path))
    for key, value in (settings or {}).items():
        _set(tables, key, value)
    return _validate(tables, where)


def with_values(design: Design, values: Mapping[str, object]) -> Design:
    """Replace some values by dotted key; floats with a unit are SI.

    Raises:
        InputError: an unknown key, or a value that is not allowed.
    """
    tables = design.model_dump()
    for key, value in values.items():
        _set(tables, key, value)
    return _validate(tables, design.name, si=True)


def named_designs() -> dict[str, str]:
    """The names of the designs that come with the package, each with its source."""
    return {name: load_design(name).source for name in _named()}


def save_design(design: Design, path: Path) -> None:
    """Write every value of a design; reading the file gives the same bits."""
    write_text(path, design_text(design))


def design_text(design: Design) -> str:
    """Every value of a design as TOML."""
    return tomli_w.dumps(_as_text(design))


def design_from_text(text: str) -> Design:
    """Read what `design_text` wrote.

    Raises:
        InputError: a key or value that is not allowed.
    """
    return _validate(tomllib.loads(text), "design")


def write_new_design(path: Path) -> None:
    """Write a commented design file to start from: the reference, every key with what it means.

    Raises:
        InputError: the file exists already, or cannot be written.
    """
    if path.exists():
        raise InputError(f"{path}: exists already; choose another name or remove it")
    if path.suffix != ".toml":
        raise InputError(f"{path}: need a name that ends with .toml")
    lines = [
        "# A forficula design. Every key is optional but based_on; what is left out comes from there.",
        f'based_on = "{REFERENCE}"',
    ]
    write_text(path, "\n".join([*lines, *_commented(load_design(REFERENCE))]) + "\n")


def _named() -> list[str]:
    folder = resources.files("forficula.design") / "references"
    return sorted(entry.name.removesuffix(".toml") for entry in folder.iterdir() if entry.name.endswith(".toml"))


def _read_tables(name_or_path: str, seen: tuple[str, ...] = ()) -> tuple[dict[str, Any], str]:
    """The nested tables of a design with what it is based on filled in, and how errors call it."""
    if name_or_path in seen:
        raise InputError(f"based_on: {' -> '.join((*seen, name_or_path))} goes round in a circle")
    if name_or_path in _named():
        text = (resources.files("forficula.design") / "references" / f"{name_or_path}.toml").read_text("utf-8")
        tables, where, folder = tomllib.loads(text), name_or_path, Path()
    elif name_or_path.endswith(".toml"):
        tables, where, folder = _read_toml(Path(name_or_path)), name_or_path, Path(name_or_path).parent
        tables.setdefault("name", Path(name_or_path).stem)
    else:
        hint = _nearest(name_or_path, _named()) or f"the named designs are {', '.join(_named())}"
        raise InputError(f'"{name_or_path}" is neither a named design nor a .toml file; {hint}')
    base = tables.pop("based_on", None)
    if base is None:
        return tables, where
    if not isinstance(base, str):
        raise InputError(f'{where}: based_on: need the name of a design such as "{REFERENCE}", got {base!r}')
    base = (
        base if base in _named() or Path(base).is_absolute() else str(folder / base) if base.endswith(".toml") else base
    )
    return _merged(_read_tables(base, (*seen, name_or_path))[0], tables), where


def _read_toml(path: Path) -> dict[str, Any]:
    try:
        return tomllib.loads(path.read_text("utf-8"))
    except FileNotFoundError:
        raise InputError(f"{path}: no such file") from None
    except (OSError, UnicodeDecodeError) as error:
        raise InputError(f"{path}: cannot be read: {error}") from None
    except tomllib.TOMLDecodeError as error:
        raise InputError(f"{path}: not TOML: {error}") from None


def _merged(base: dict[str, Any], over: dict[str, Any]) -> dict[str, Any]:
    both = dict(base)
    for key, value in over.items():
        inner = both.get(key)
        both[key] = _merged(inner, value) if isinstance(inner, dict) and isinstance(value, dict) else value
    return both


def _set(tables: dict[str, Any], key: str, value: object) -> None:
    *sections, last = key.split(".")
    place = tables
    for section in sections:
        place = place.setdefault(section, {})
        if not isinstance(place, dict):
            raise InputError(f"{key}: unknown key; {_hint(key)}")
    place[last] = value


def _validate(tables: dict[str, Any], where: str, *, si: bool = False) -> Design:
    try:
        return Design.model_validate(tables, context={"si": si})
    except ValidationError as error:
        # A wrong value hides what depends on it, so one error, the first, is the one to mend.
        raise InputError(f"{where}: {_sentence(error.errors(include_url=False)[0])}") from None


def _sentence(error: Any) -> str:
    """One pydantic error as one line: key, rule, value."""
    place = [str(part) for part in error["loc"] if part not in ("float", "literal['auto']")]
    key, got, bounds = ".".join(place), error["input"], error.get("ctx", {})
    rules = {
        "extra_forbidden": "unknown key",
        "missing": "is missing; give it, or start the file with based_on",
        "greater_than": "need > {gt}",
        "greater_than_equal": "need >= {ge}",
        "less_than": "need < {lt}",
        "less_than_equal": "need <= {le}",
        "literal_error": "need {expected}",
        "too_short": "need at least {min_length}",
        "string_too_short": "need some text",
    }
    kinds = {"int": "a whole number", "float": "a number", "finite_number": "a finite number", "string": "text"}
    kinds |= {"bool": "true or false", "tuple": "a list", "model": "a table"}
    if error["type"] == "value_error":
        message = str(bounds["error"])
        return f"{key}: {message}" if _is_quantity(place) else f"{key}.{message}" if key else message
    if error["type"] == "extra_forbidden":
        return f"{key}: unknown key; {_hint(key)}"
    if error["type"] == "missing":
        return f"{key}: {rules['missing']}"
    if error["type"] in rules:
        return f"{key}: {rules[error['type']].format(**bounds)}, got {got!r}"
    kind = next((text for name, text in kinds.items() if error["type"].startswith(name)), None)
    return f"{key}: need {kind}, got {got!r}" if kind else f"{key}: {error['msg']}, got {got!r}"


def _is_quantity(place: list[str]) -> bool:
    model: type[BaseModel] = Design
    quantity: Quantity | None = None
    for name in place:
        field = model.model_fields.get("stages" if name.isdigit() else name)
        if field is None:
            continue
        quantity = field_quantity(field)
        model = next((part for part in _parts(field.annotation)), model)
    return quantity is not None


def _parts(annotation: Any) -> Iterator[type[Part]]:
    for candidate in (annotation, *getattr(annotation, "__args__", ())):
        if isinstance(candidate, type) and issubclass(candidate, Part):
            yield candidate


def _keys(model: type[BaseModel] = Design, prefix: str = "") -> Iterator[str]:
    for name, field in model.model_fields.items():
        parts = list(_parts(field.annotation))
        yield f"{prefix}{name}"
        for part in parts:
            yield from _keys(part, f"{prefix}{name}.")


def _hint(key: str) -> str:
    """The nearest valid key, by its whole path or by its last word."""
    plain = ".".join(part for part in key.split(".") if not part.isdigit())
    keys = list(_keys())
    near = difflib.get_close_matches(plain, keys, n=1, cutoff=0.6)
    by_last = {valid.rsplit(".", 1)[-1]: valid for valid in keys}
    near = near or [
        by_last[last] for last in difflib.get_close_matches(plain.rsplit(".", 1)[-1], by_last, n=1, cutoff=0.5)
    ]
    if near:
        return f"did you mean {near[0]}?"
    section = plain.rpartition(".")[0]
    siblings = [valid for valid in keys if valid.rpartition(".")[0] == section]
    return f"allowed here: {', '.join(siblings or [valid for valid in keys if '.' not in valid])}"


def _nearest(word: str, words: list[str]) -> str | None:
    near = difflib.get_close_matches(word, words, n=1)
    return f'did you mean "{near[0]}"?' if near else None


def _as_text(part: Part) -> dict[str, Any]:
    """A part as TOML tables, quantities as exact text."""
    tables: dict[str, Any] = {}
    for name, field in type(part).model_fields.items():
        value, quantity = getattr(part, name), field_quantity(field)
        if isinstance(value, Part):
            tables[name] = _as_text(value)
        elif isinstance(value, tuple):
            tables[name] = [_as_text(item) if isinstance(item, Part) else item for item in value]
        else:
            tables[name] = format_quantity(value, quantity.unit) if quantity and isinstance(value, float) else value
    return tables


def _commented(design: Design) -> Iterator[str]:
    """The sections of a design, every key with its meaning."""
    for section, field in Design.model_fields.items():
        part = getattr(design, section)
        if not isinstance(part, Part):
            continue
        yield f"\n[{section}]  # {(type(part).__doc__ or '').splitlines()[0].removesuffix('.')}"
        for key, entry in type(part).model_fields.items():
            if key == "stages":
                yield from _commented_stages(_as_text(part)["stages"], entry.description)
                continue
            value = tomli_w.dumps({key: _as_text(part)[key]}).strip().replace("[\n    ", "[").replace(",\n]", "]")
            yield f"{value:<40}  # {entry.description}"


def _commented_stages(stages: list[dict[str, Any]], description: str | None) -> Iterator[str]:
    """The stages, commented out: a list of tables replaces the whole list."""
    yield f"\n# {description}; giving any stage replaces all of them."
    for stage in stages:
        yield "# [[protocol.stages]]"
        yield from (f"# {line}" for line in tomli_w.dumps(stage).strip().splitlines())
