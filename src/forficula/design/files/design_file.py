"""Reading and writing of design files in TOML, with errors that name the key."""

from __future__ import annotations

import difflib
import os
import re
import tomllib
from collections.abc import Callable, Mapping, Sequence
from copy import deepcopy
from functools import cache
from importlib import resources
from pathlib import Path
from typing import Any

import tomli_w
from pydantic import ValidationError

from forficula.allowed_files import may_read
from forficula.design.assembly.assembly import AssemblyDesign, check_part_name, part_names
from forficula.design.design import Design
from forficula.design.fans.fan import FanDesign
from forficula.design.fans.fan_sections import MOST_UNITS
from forficula.design.fans.joint import JointDesign
from forficula.design.fans.joint_sections import JointTendon
from forficula.design.files.file_design import file_tables
from forficula.design.files.file_words import check_file_kind
from forficula.design.files.kept_sections import with_kept_sections
from forficula.design.files.keys import key_value, replacing_key, section_fields
from forficula.design.files.kinds import KINDS, design_class, kind_of
from forficula.design.files.provenance import derived_source
from forficula.design.files.rejection import File, origin, rejected
from forficula.design.files.tables import (
    REMOVED,
    RejectedError,
    check_once,
    dotted_keys,
    merged,
    nested,
    numbered,
    with_settings_over,
)
from forficula.design.files.tendon_tables import entries_over, is_by_vein, tendon_over, tendons_over, value_from_folder
from forficula.design.sheets.sheet_tables import with_sheet_read
from forficula.errors import InputError
from forficula.files import as_path, read_toml, write_text
from forficula.names import listed
from forficula.pattern import PATTERN_FILES
from forficula.quantities import as_written
from forficula.toml_text import check_levels, with_remarks

_MOST_FILES = 50  # in a chain of files that are based on each other
_LISTED = 4  # named designs in the message for an unknown one
_TIMESTEP = "protocol.timestep"
_SURROGATE = re.compile("[\ud800-\udfff]")

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
    if isinstance(name_or_path, str) and not settings and unit is None and name_or_path in _named():
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
        files = _read_files(str(name_or_path))
    tables: dict[str, Any] = {}
    try:
        for _, file_values in files:
            before, tables = tables, _over(tables, file_values, merged, si=False)
            tables = _with_source(before, tables, file_values)
        before, tables = tables, _with_settings(tables, settings or {}, si=False)
        design = _validate(tables, si=False)
        if settings and "source" not in settings:
            named = str(name_or_path) in _named()
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
    return {name: load_design(name).source for name in _named()}


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
    return _validate(_over({}, _with_parts(tomllib.loads(text), None), merged, si=False), si=False)


@cache
def _named() -> tuple[str, ...]:
    folder = resources.files("forficula.design") / "references"
    return tuple(sorted(entry.name.removesuffix(".toml") for entry in folder.iterdir() if entry.name.endswith(".toml")))


@cache
def _named_tables(name: str) -> dict[str, Any]:
    """Return the tables of the file of a named design; they must not be changed."""
    return tomllib.loads((resources.files("forficula.design") / "references" / f"{name}.toml").read_text("utf-8"))


def _read_files(name_or_path: str, within: Sequence[Path] = ()) -> list[File]:
    """Read the files of a design and of those that it is based on, the base first.

    Args:
        name_or_path: name or path of the design.
        within: files with parts that are based on this design, directly or through other files.
    """
    files: list[File] = []
    above: list[Path] = []
    base: str | None = name_or_path
    while base is not None:
        name = base
        try:
            if name in _named():
                tables = deepcopy(_named_tables(name))
                base = tables.pop("based_on", None)
                tables = _with_parts(tables, None, within)
            else:
                tables = _file_tables(name, [*within, *above])
                base = _base_of(tables, Path(name))
                above.append(Path(name))
        except InputError as error:
            # of a long chain, name the first and the last file
            chain = above if len(above) < 4 else [above[0], "...", above[-1]]
            raise InputError("".join([*(f"{path}: based_on: " for path in chain), str(error)])) from None
        files.insert(0, (name, tables))
    return files


def _file_tables(name: str, above: Sequence[Path]) -> dict[str, Any]:
    """Read the tables of a file; `above` are the files that are based on it, or whose parts are."""
    path = Path(name)
    if path.suffix.lower() != ".toml":
        readable = (".toml", *PATTERN_FILES)
        files = sorted(str(file) for file in Path().glob("*.*") if file.suffix.lower() in readable and may_read(file))
        known = [*_named(), *files]
        some = ", ".join(_named()[:_LISTED])
        hint = _nearest(name, known) or f"forficula designs lists the named designs: {some}, ..."
        endings = listed((".toml", *PATTERN_FILES), "or")
        raise InputError(f"{as_written(name)} is neither a named design nor a {endings} file; {hint}")
    if len(above) == _MOST_FILES:
        raise InputError(f"need at most {_MOST_FILES} files that are based on each other, got more")
    tables = read_toml(path, "a design")
    if path.resolve() in [other.resolve() for other in above]:
        raise InputError(f"{path}: is based on itself, directly or through other files")
    try:
        check_file_kind(tables, "design")
        if "name" not in tables:
            tables["name"] = _name_of(path)
        tables = _with_parts(tables, path, [*above, path])
        tables = {key: value_from_folder(key, value, path.parent) for key, value in tables.items()}
        return with_sheet_read(tables, folder=path.parent)
    except InputError as error:
        raise InputError(f"{path}: {error}") from None


def _with_parts(tables: dict[str, Any], path: Path | None, within: Sequence[Path] = ()) -> dict[str, Any]:
    """Return tables of an assembly with each part directly under its name, complete with the design it is based on.

    Args:
        tables: tables of a file, with the parts under `part`; those of other designs stay as they are.
        path: path of the file; None for a named design.
        within: the file, and the files that are based on it or whose parts are.

    Raises:
        InputError: a part that is not a table, whose name is not allowed, or whose base cannot be read.
    """
    if "part" not in tables:
        return tables
    parts = tables["part"]
    if not isinstance(parts, dict) or not parts:
        raise InputError(f"part: need tables such as [part.fan], got {as_written(parts)}")
    if "parts" in tables:
        raise InputError("parts: cannot be set, because the tables [part.NAME] name the parts")
    others = {key: value for key, value in tables.items() if key != "part"}
    complete = {name: _part_tables(name, part, path, within) for name, part in parts.items()}
    return others | {"parts": list(parts)} | complete


def _part_tables(name: str, part: object, path: Path | None, within: Sequence[Path]) -> dict[str, Any]:
    """Return the tables of a part, laid over those of the design that it is based on."""
    if not isinstance(part, dict):
        raise InputError(f"part.{name}: need a table under [part.{check_part_name(name)}], got {as_written(part)}")
    check_part_name(name)
    folder = Path() if path is None else path.parent
    part = {key: value_from_folder(key, value, folder) for key, value in part.items()}
    base = part.pop("based_on", None)
    complete: dict[str, Any] = {}
    try:
        for _, tables in [] if base is None else _base_files(base, folder, within):
            complete = _over(complete, tables, merged, si=False)
        inside = with_sheet_read(_with_parts(part, path, within), folder=folder)
        return _over(complete, inside, merged, si=False)
    except RejectedError as error:
        raise RejectedError([name, *error.place], f"part.{name}.{error}") from None
    except InputError as error:
        raise InputError(f"part.{name}: {error}") from None


def _base_files(base: object, folder: Path, within: Sequence[Path]) -> list[File]:
    """Read the files of the design that a part is based on: a name, or a path relative to the file's folder."""
    if not isinstance(base, str):
        raise InputError(f'based_on: need the name of a design such as "binder2025", got {as_written(base)}')
    suffix = Path(base).suffix.lower()
    if suffix in PATTERN_FILES:
        return [(base, file_tables(folder / base, None))]
    return _read_files(str(folder / base) if suffix == ".toml" else base, within)


def _name_of(path: Path) -> str:
    """Return the name of a design without a key `name`: the name of its file."""
    if _SURROGATE.search(path.stem):
        raise InputError(f"name: is missing, and the file's name is no text in UTF-8, got {as_written(path.stem)}")
    return path.stem


def _base_of(tables: dict[str, Any], path: Path) -> str | None:
    """Remove `based_on` from the tables of a file and return it: a name, or a path relative to the file's folder."""
    base = tables.pop("based_on", None)
    if base is None:
        return None
    if not isinstance(base, str):
        raise InputError(f'{path}: based_on: need the name of a design such as "binder2025", got {as_written(base)}')
    return str(path.parent / base) if base.lower().endswith(".toml") else base


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
    return _over(tables, nested(with_sheet_read(settings)), with_settings_over, si=si)


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
        if common is not None and key_value(before, inside) != key_value(after, inside):
            raise InputError(f"{key}: has no effect in a part; set {common} of the assembly")


def _check_texts(settings: Mapping[str, object]) -> None:
    """Refuse values that are nested too deeply, and texts that cannot be written to a file."""
    check_levels(settings)
    within: list[tuple[str, object]] = [("", settings)]
    while within:
        key, value = within.pop()
        match value:
            case str() if _SURROGATE.search(value):
                raise InputError(f"{key}: need text in UTF-8, got {as_written(value)}, which holds a lone surrogate")
            case Mapping():
                for part, inside in value.items():
                    if isinstance(part, str) and _SURROGATE.search(part):
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


def _over(
    tables: dict[str, Any], upper: dict[str, Any], lay: Callable[[object, object], Any], *, si: bool
) -> dict[str, Any]:
    """Lay tables over others; tendons have separate rules, and the pattern of a fan gives their number."""
    if names := tuple(dict.fromkeys([*part_names(tables), *part_names(upper)])):
        return _assembly_over(tables, upper, lay, names, si=si)
    tables = _without_other_pattern(tables, kind_of(upper))
    both: dict[str, Any] = lay(tables, {key: value for key, value in upper.items() if key != "tendon"})
    if REMOVED in both.values():
        both = _without_removed(both)
    if "tendon" not in upper:
        return both
    model = design_class(both)
    if issubclass(model, JointDesign):
        tendon = upper["tendon"]
        if isinstance(tendon, dict):
            tendon = tendon_over(tables.get("tendon"), tendon, "", si=si, model=JointTendon)
        return {**both, "tendon": tendon}
    if not issubclass(model, FanDesign):
        return {**both, "tendon": entries_over(tables.get("tendon"), upper["tendon"], si=si)}
    pattern = both.get("pattern")
    units = pattern.get("units") if isinstance(pattern, dict) else None
    veins = 2 * units + 1 if isinstance(units, int) and 0 < units <= MOST_UNITS else 0
    return {**both, "tendon": tendons_over(tables.get("tendon"), upper["tendon"], veins=veins, si=si)}


def _assembly_over(
    tables: dict[str, Any],
    upper: dict[str, Any],
    lay: Callable[[object, object], Any],
    names: Sequence[str],
    *,
    si: bool,
) -> dict[str, Any]:
    """Lay tables of an assembly over others, part by part, by the rules of each part's kind."""
    parts: dict[str, Any] = {}
    for name in names:
        below, above = tables.get(name, {}), upper.get(name)
        if above is None:
            continue
        if not isinstance(below, dict) or not isinstance(above, dict):
            raise RejectedError([name], f"{name}: need a table under [part.{name}], got {as_written(above)}")
        try:
            parts[name] = _over(below, above, lay, si=si)
        except RejectedError as error:
            raise RejectedError([name, *error.place], f"{name}.{error}") from None
        except InputError as error:
            raise InputError(f"{name}.{error}") from None
    others = {key: value for key, value in upper.items() if key not in (*names, "parts")}
    below = {key: value for key, value in tables.items() if key not in parts}
    return {**lay(below, others), **parts, "parts": list(names)}


def _without_removed(tables: dict[str, Any]) -> dict[str, Any]:
    """Return tables without the sections that "none" removes: those that a design need not have."""
    fields = design_class(tables).model_fields
    removed = {
        key
        for key, value in tables.items()
        if value == REMOVED and key in fields and fields[key].default is None and section_fields(fields[key].annotation)
    }
    return {key: value for key, value in tables.items() if key not in removed}


def _without_other_pattern(tables: dict[str, Any], kind: str | None) -> dict[str, Any]:
    """Remove the pattern from tables if a pattern of another kind is to be laid over them.

    Raises:
        RejectedError: designs of the new kind have other sections.
    """
    below = kind_of(tables)
    if kind == below or kind is None or below is None or not {kind, below} <= KINDS.keys():
        return tables
    model = KINDS[kind]
    if model.model_fields.keys() != KINDS[below].model_fields.keys():
        reference = model.reference
        instead = f'; begin with based_on = "{reference}"' if reference else ""
        raise RejectedError(
            ["pattern", "kind"],
            f"pattern.kind: designs of kind {kind} have other sections than those of kind {below}{instead}",
        )
    return {key: value for key, value in tables.items() if key != "pattern"}


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


def _nearest(word: str, words: list[str]) -> str | None:
    near = difflib.get_close_matches(word, words, n=1)
    return f'did you mean "{near[0]}"?' if near else None
