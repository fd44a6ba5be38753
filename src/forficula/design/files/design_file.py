"""Reading and writing of design files in TOML, with errors that name the key."""

from __future__ import annotations

import os
import tomllib
from collections.abc import Mapping
from functools import cache
from pathlib import Path
from typing import Any

import tomli_w
from pydantic import ValidationError

from forficula.design.assembly.assembly import AssemblyDesign, part_names
from forficula.design.design import Design
from forficula.design.fans.fan import FanDesign
from forficula.design.files.design_sources import SURROGATE, design_names, read_files, with_parts
from forficula.design.files.file_design import file_tables
from forficula.design.files.kept_sections import with_kept_sections
from forficula.design.files.keys import key_value, replacing_key
from forficula.design.files.kinds import design_class
from forficula.design.files.layers import laid_over
from forficula.design.files.provenance import derived_source
from forficula.design.files.rejection import origin, rejected
from forficula.design.files.tables import (
    RejectedError,
    check_once,
    dotted_keys,
    merged,
    nested,
    numbered,
    with_settings_over,
)
from forficula.design.files.tendon_tables import is_by_vein
from forficula.design.sheets.sheet_tables import with_sheet_read
from forficula.errors import InputError
from forficula.files import as_path, write_text
from forficula.pattern import PATTERN_FILES
from forficula.quantities import as_written
from forficula.toml_text import check_levels, with_remarks

_TIMESTEP = "protocol.timestep"

# a design, its name, or the path of its file
AnyDesign = Design | str | os.PathLike[str]


def load_design(
    name_or_path: str | Path, settings: Mapping[str, object] | None = None, *, unit: float | None = None
) -> Design:
    """Read a named design, a design file, a FOLD file or a drawing, with some values replaced.

    Args:
        name_or_path: one of `named_designs`, the path of a TOML file, or the path of a file that `read_pattern` reads;
            for the latter, rules choose the values that the file does not contain.
        settings: values by dotted key or in nested tables, as in {"tendon.stiffness": "20 N/cm"} or
            {"tendon": {"stiffness": "20 N/cm"}}; text with units, as in a file.
        unit: length of the unit of a FOLD file or a drawing that states none, m; if not given, its largest dimension is
            taken as 20 cm, with a warning.

    Returns:
        The checked design.

    Raises:
        InputError: no such design or file, not TOML, an unknown key, a value that is not allowed, or a unit for a file
            that names its units.
    """
    if isinstance(name_or_path, str) and not settings and unit is None and name_or_path in design_names():
        return _named_design(name_or_path)
    return _load(name_or_path, settings, unit)


@cache  # the files of the package do not change, and a design is frozen
def _named_design(name: str) -> Design:
    return _load(name, None, None)


def _load(name_or_path: str | Path, settings: Mapping[str, object] | None, unit: float | None) -> Design:
    path = as_path(name_or_path, "a named design, or the path of a file")
    if path.suffix.lower() in PATTERN_FILES:
        files = [(str(name_or_path), file_tables(path, unit))]
    elif unit is not None:
        raise InputError(f"unit: a design already has units, got {unit:g} m")
    else:
        files = read_files(str(name_or_path))
    tables: dict[str, Any] = {}
    try:
        for _, file_values in files:
            before, tables = tables, laid_over(tables, file_values, merged, si=False)
            tables = _with_source(before, tables, file_values)
        before, tables = tables, _with_settings(tables, settings or {}, si=False)
        design = _validate(tables, si=False)
        if settings and "source" not in settings:
            named = str(name_or_path) in design_names()
            base = _named_design(str(name_or_path)) if named else _validate_or_none(before)
            if base is not None:
                _check_of_parts(settings, base, design)
                design = design.model_copy(update={"source": derived_source(base, design)})
        return _marked(design, is_set=_sets_timestep(settings or {}))
    except RejectedError as error:
        # name entries as the settings do, not by number
        keys_set, message = {numbered(key, tables): key for key in dotted_keys(settings or {})}, str(error)
        for number, name in keys_set.items():
            message = message.replace(f"{number.rpartition('.')[0]}.", f"{name.rpartition('.')[0]}.")
        file = origin(error.place, files, keys_set)
        raise InputError(f"{file}: {message}" if file else message) from None


def as_design(design: AnyDesign) -> Design:
    """Return a design as it is, or read it by its name or path.

    Raises:
        InputError: an argument of another type, or a design that cannot be read.
    """
    if isinstance(design, Design):
        return design
    if isinstance(design, str | os.PathLike):
        return load_design(os.fspath(design))
    raise InputError(f"need a design, its name or the path of its file, got a {type(design).__name__}")


def with_values(design: Design, values: Mapping[str, object]) -> Design:
    """Replace some values by dotted key; floats with a unit are SI, and "tendon.law" may be a `MaterialLaw`.

    Raises:
        InputError: an unknown key, or a value that is not allowed.
    """
    try:
        changed = _validate_changed(design, _with_settings(design.si_tables(), values, si=True))
    except RejectedError as error:
        raise InputError(f"{design.name}: {error}") from None
    _check_of_parts(values, design, changed)
    if "source" not in values:
        changed = changed.model_copy(update={"source": derived_source(design, changed)})
    return _marked(changed, is_set=is_timestep_set(design) or _sets_timestep(values))


def is_timestep_set(design: Design) -> bool:
    """Return whether the settings of `load_design`, or `with_values`, have set the timestep."""
    return bool(design.once(_TIMESTEP, lambda: False))


def _marked(design: Design, *, is_set: bool) -> Design:
    design.once(_TIMESTEP, lambda: is_set)
    return design


def _sets_timestep(settings: Mapping[str, object]) -> bool:
    return _TIMESTEP in dotted_keys(settings)


def named_designs() -> dict[str, str]:
    """Return the names of the designs that come with the package, with their sources."""
    return {name: load_design(name).source for name in design_names()}


def save_design(design: Design, path: str | os.PathLike[str]) -> None:
    """Write all values of a design to a file, from which exactly the same values are read."""
    write_text(Path(path), design_text(design))


def design_text(design: Design) -> str:
    """Return all values of a design as TOML; values that a rule chooses are marked, with the reason."""
    text = tomli_w.dumps(_file_form(design, design.settled().as_tables()))
    reasons = {
        f"{_file_section(design, choice.section)}.{choice.key}": f"[chosen] {choice.reason}" for choice in design.chosen
    }
    return with_remarks(text, reasons) if reasons else text


def _file_section(design: Design, section: str) -> str:
    """Return the name of a section as a file has it: parts of an assembly are under `part`."""
    if not isinstance(design, AssemblyDesign):
        return section
    name, _, inside = section.partition(".")
    return f"part.{name}.{_file_section(getattr(design, name), inside)}"


def _file_form(design: Design, tables: dict[str, Any]) -> dict[str, Any]:
    """Return the tables of a design as a file has them: parts of an assembly under `part`, and the protocol last."""
    if isinstance(design, AssemblyDesign):
        parts = {name: _file_form(getattr(design, name), tables[name]) for name in design.parts}
        tables = {key: value for key, value in tables.items() if key not in (*parts, "parts")} | {"part": parts}
    elif isinstance(design, FanDesign) and is_by_vein(tables["tendon"]):
        by_number = [{"vein": int(vein)} | entry for vein, entry in tables["tendon"].items()]
        tables = tables | {"tendon": by_number}
    return {name: tables[name] for name in sorted(tables, key=lambda name: name == "protocol")}


def design_from_text(text: str) -> Design:
    """Read a design from the text that `design_text` returns.

    Raises:
        InputError: a key or value that is not allowed.
        TOMLDecodeError: the text is not TOML.
    """
    return _validate(laid_over({}, with_parts(tomllib.loads(text), None), merged, si=False), si=False)


def _with_settings(tables: dict[str, Any], settings: Mapping[str, object], *, si: bool) -> dict[str, Any]:
    """Put values into tables by their dotted keys; the order of the values does not matter."""
    if not (isinstance(settings, Mapping) and all(isinstance(key, str) for key in settings)):
        raise InputError(f'need values by key, such as {{"tendon.stiffness": "20 N/cm"}}, got {as_written(settings)}')
    _check_texts(settings)
    if any(key.partition(".")[0] == "based_on" for key in settings):
        raise InputError("based_on: cannot be set; name the design to start from instead")
    if part_names(tables):
        settings = _without_part(settings)
    check_once(dotted_keys(settings), tables)
    for key, value in settings.items():
        if key.partition(".")[0] == "parts" and not (isinstance(value, list | tuple) and [*value] == tables.get(key)):
            raise InputError(f"{key}: cannot be set, because the tables [part.NAME] name the parts")
    return laid_over(tables, nested(with_sheet_read(settings)), with_settings_over, si=si)


def _without_part(settings: Mapping[str, object]) -> dict[str, object]:
    """Return settings of an assembly with "part." removed from their keys, and a table `part` by its entries."""
    values: dict[str, object] = {}
    inside = settings.get("part")
    entries = [*inside.items()] if isinstance(inside, Mapping) else []
    for key, value in [*((key, value) for key, value in settings.items() if key != "part" or not entries), *entries]:
        if (name := key.removeprefix("part.")) in values:
            raise InputError(f"{name}: is given twice, also as part.{name}")
        values[name] = value
    return values


def _check_of_parts(settings: Mapping[str, object], before: Design, after: Design) -> None:
    """Refuse settings that change values of parts which have no effect, because the assembly's values apply."""
    for key in dotted_keys(settings):
        inside = key.removeprefix("part.")
        common = replacing_key(before, inside)
        if common is not None and _known_value(before, inside) != _known_value(after, inside):
            raise InputError(f"{key}: has no effect in a part; set {common} of the assembly")


def _known_value(design: Design, key: str) -> object:
    """Return the value of a design at a key; None if the design lacks the section."""
    try:
        return key_value(design, key)
    except InputError:
        return None


def _check_texts(settings: Mapping[str, object]) -> None:
    """Refuse values that are nested too deeply, and texts that cannot be written to a file."""
    check_levels(settings)
    within: list[tuple[str, object]] = [("", settings)]
    while within:
        key, value = within.pop()
        match value:
            case str() if SURROGATE.search(value):
                raise InputError(f"{key}: need text in UTF-8, got {as_written(value)}, which holds a lone surrogate")
            case Mapping():
                for part, inside in value.items():
                    if isinstance(part, str) and SURROGATE.search(part):
                        raise InputError(f"need keys in UTF-8, got {as_written(part)}, which holds a lone surrogate")
                    within.append((f"{key}.{part}" if key else str(part), inside))
            case list() | tuple():
                within += [(f"{key}.{number}", entry) for number, entry in enumerate(value)]


def _with_source(base: dict[str, Any], tables: dict[str, Any], values: Mapping[str, object]) -> dict[str, Any]:
    """Add a source that names the changed values to tables of a file that is based on another and gives no source."""
    if not base or not values or "source" in values:
        return tables
    try:
        source = derived_source(_validate(base, si=False), _validate(tables, si=False))
    except RejectedError:
        # the caller validates again and reports the error with its place
        return tables
    return tables | {"source": source}


def _validate(tables: dict[str, Any], *, si: bool) -> Design:
    model = design_class(tables)
    try:
        return model.model_validate(tables, context={"si": si})
    except ValidationError as error:
        raise rejected(error, model) from None


def _validate_changed(design: Design, tables: dict[str, Any]) -> Design:
    """Validate the changed tables of a design, SI; sections that did not change are not read again."""
    if design_class(tables) is type(design):
        try:
            return type(design).model_validate(with_kept_sections(design, tables), context={"si": True})
        except ValidationError:
            # validate the tables alone for the error message
            pass
    return _validate(tables, si=True)


def _validate_or_none(tables: dict[str, Any]) -> Design | None:
    try:
        return _validate(tables, si=False)
    except RejectedError:
        return None
