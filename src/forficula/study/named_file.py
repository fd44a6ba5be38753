"""Files that a command takes by name or path, and the design that they start from."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from importlib import resources
from pathlib import Path
from typing import Any, TypeVar

from forficula.design import Design, load_design, value_from_folder
from forficula.errors import InputError
from forficula.files import as_path, read_text
from forficula.names import near_name
from forficula.quantities import as_written
from forficula.study.file_keys import dotted_values
from forficula.toml_text import parse_toml

Built = TypeVar("Built")


def named_files(package: str, within: str = "references") -> list[str]:
    """The names of the files that come with a part of the package, without their endings."""
    folder = resources.files(package) / within
    return sorted(entry.name.removesuffix(".toml") for entry in folder.iterdir() if entry.name.endswith(".toml"))


def read_named(name_or_path: object, package: str, what: str, several: str) -> tuple[str, str, Path]:
    """Text of a named file or a path, how errors call it, and the folder that paths in it start from.

    Args:
        name_or_path: as a user gives it.
        package: whose folder `references` has the named ones.
        what: such a file is, such as "study".
        several: of these, such as "studies".

    Raises:
        InputError: no such name or file, or it cannot be read.
    """
    given, names = str(as_path(name_or_path, f"a named {what}, or the path of a file")), named_files(package)
    if given in names:
        file = resources.files(package) / "references" / f"{given}.toml"
        return file.read_text("utf-8"), given, Path()
    if not given.endswith(".toml"):
        raise InputError(
            f"{as_written(given)} is neither a named {what} nor a .toml file; the named {several} are"
            f" {', '.join(names)}{near_name(given, names)}"
        )
    path = Path(given)
    return read_text(path), given, path.parent


def load_named(
    name_or_path: object, package: str, what: str, several: str, build: Callable[[dict[str, Any], Path], Built]
) -> Built:
    """What the tables of a named file or a path describe; its name is the file's where it has none.

    Args:
        name_or_path: as a user gives it.
        package: whose folder `references` has the named ones.
        what: such a file is, such as "study".
        several: of these, such as "studies".
        build: makes it of tables, and of the folder that paths in them start from.

    Raises:
        InputError: no such name or file, not TOML, or what `build` refuses, with the file before it.
    """
    text, where, folder = read_named(name_or_path, package, what, several)
    try:
        tables = parse_toml(text, _a(what))
        _check_kind(tables, what)
        tables.setdefault("name", Path(where).stem)
        return build(tables, folder)
    except InputError as error:
        raise InputError(f"{where}: {error}") from None


# of each kind of file a table that no other kind has, and the command that takes it
_TELLING = {
    "study": ("factors", "study"),
    "goal": ("objectives", "optimise"),
    "observations file": ("fact", "identify"),
}


def _check_kind(tables: Mapping[str, Any], what: str) -> None:
    """Refuse a file of another kind, for which there is another command."""
    for kind, (table, command) in _TELLING.items():
        if kind != what and table in tables and _TELLING[what][0] not in tables:
            raise InputError(f"need {_a(what)}, got {_a(kind)}, for it has {table}; give it to forficula {command}")


def _a(what: str) -> str:
    return f"{'an' if what[0] in 'aeiou' else 'a'} {what}"


def base_design(tables: Mapping[str, Any], folder: Path) -> Design:
    """The design that a file names under `design`, with the values under `settings`.

    Args:
        tables: of the file; `design` may be a design itself.
        folder: that paths in it start from.

    Raises:
        InputError: there is none, or a value that is not allowed.
    """
    name = tables.get("design")
    if name is None:
        raise InputError('design: is missing; give the name or path of a design, such as "binder2025"')
    if not isinstance(name, str | Design):
        raise InputError(f'design: need the name or path of a design, such as "binder2025", got {as_written(name)}')
    settings = settings_of(tables, folder)
    if isinstance(name, Design):
        return settled_by(name, settings)
    called = str(folder / name) if name.endswith(".toml") else name
    try:
        return load_design(called, settings)
    except InputError as error:
        # what is wrong with the design itself is told as such
        load_design(called)
        raise InputError(_of_settings(str(error), settings)) from None


def settings_of(tables: Mapping[str, Any], folder: Path) -> dict[str, object]:
    """The values that a file has under `settings`, by dotted key.

    Args:
        tables: of the file.
        folder: that paths in it start from.

    Raises:
        InputError: one is given twice, or is a path that leads nowhere.
    """
    if not isinstance(given := tables.get("settings", {}), dict):
        raise InputError(f"settings: need a table, got {as_written(given)}")
    values = dotted_values(given, "settings")
    try:
        return {key: value_from_folder(key, value, folder) for key, value in values.items()}
    except InputError as error:
        raise InputError(_of_settings(str(error), values)) from None


def settled_by(design: Design, settings: Mapping[str, object]) -> Design:
    """A design with the values under `settings` of a file.

    Raises:
        InputError: one of them is not allowed, or no key of it.
    """
    try:
        return design.with_values(settings)
    except InputError as error:
        raise InputError(_of_settings(str(error).removeprefix(f"{design.name}: "), settings)) from None


def _of_settings(error: str, settings: Mapping[str, object]) -> str:
    """An error with the table that it is about, and its key there."""
    return f"settings.{error}" if error.startswith(tuple(f"{key}:" for key in settings)) else f"settings: {error}"
