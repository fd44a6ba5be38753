"""Files of studies, goals and observations by name or path, and the design that they start from."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from importlib import resources
from pathlib import Path
from typing import Any, Generic, TypeVar

from forficula.design import Design, load_design, value_from_folder
from forficula.design.files.rejection import read_part
from forficula.design.section import Section
from forficula.errors import InputError, error_prefix
from forficula.files import as_path, read_text
from forficula.names import near_name
from forficula.quantities import as_written
from forficula.toml_text import parse_toml

Model = TypeVar("Model", bound=Section)
Built = TypeVar("Built")


@dataclass(frozen=True, kw_only=True)
class FileKind(Generic[Model]):
    """A kind of file that commands take by name or path.

    Attributes:
        word: for one of them, such as "study".
        several: the same for several of them.
        package: whose folder `references` has the named ones.
        model: what such a file may have.
        texts: of a design that a new file is about, which its examples name; the comment of a table that has the name
            of one ends with it.
    """

    word: str
    several: str
    package: str
    model: type[Model]
    texts: Callable[[Design], Mapping[str, str]] = lambda _: {}


# of each kind of file a table that no other kind has, and the command that takes it
_TELLING = {
    "study": ("factors", "study"),
    "goal": ("objectives", "optimise"),
    "observations file": ("fact", "identify"),
}


def named_files(kind: FileKind[Model]) -> list[str]:
    """The names of the files of a kind that come with the package."""
    folder = resources.files(kind.package) / "references"
    return sorted(entry.name.removesuffix(".toml") for entry in folder.iterdir() if entry.name.endswith(".toml"))


def load_named(name_or_path: object, kind: FileKind[Model], build: Callable[[Model, Path], Built]) -> Built:
    """Load a named file or a path and build its object. Without `name` in the file, its name is the file's stem.

    Args:
        name_or_path: as a user gives it.
        kind: of the file.
        build: makes what it describes of the file and of the folder that paths in it start from.

    Raises:
        InputError: no such name or file, not TOML, or what `build` refuses, with the file before it.
    """
    given, names = str(as_path(name_or_path, f"a named {kind.word}, or the path of a file")), named_files(kind)
    if given in names:
        text, folder = (resources.files(kind.package) / "references" / f"{given}.toml").read_text("utf-8"), Path()
    elif given.endswith(".toml"):
        text, folder = read_text(Path(given)), Path(given).parent
    else:
        raise InputError(
            f"{as_written(given)} is neither a named {kind.word} nor a .toml file; the named {kind.several} are"
            f" {', '.join(names)}{near_name(given, names)}"
        )
    with error_prefix(f"{given}: "):
        tables = parse_toml(text, _a(kind.word))
        _check_kind(tables, kind.word)
        return build(read_part(kind.model, {"name": Path(given).stem, **tables}), folder)


def _check_kind(tables: Mapping[str, Any], word: str) -> None:
    """Refuse a file of another kind, for which there is another command."""
    for other, (table, command) in _TELLING.items():
        if other != word and table in tables and _TELLING[word][0] not in tables:
            raise InputError(
                f"need {_a(word)}, got {_a(other)}, because it has {table}; give it to forficula {command}"
            )


def _a(what: str) -> str:
    return f"{'an' if what[0] in 'aeiou' else 'a'} {what}"


def base_design(design: str | Design | None, settings: Mapping[str, object], folder: Path) -> Design:
    """The design that a file is about.

    Args:
        design: itself, its name or its path.
        settings: values by key that replace the design's own.
        folder: that paths start from.

    Raises:
        InputError: there is none, or a value that is not allowed.
    """
    if design is None:
        raise InputError('design: is missing; give the name or path of a design, such as "binder2025"')
    values = settings_of(settings, folder)
    if isinstance(design, Design):
        return settled_by(design, values)
    called = str(folder / design) if design.endswith(".toml") else design
    try:
        return load_design(called, values)
    except InputError as error:
        # what is wrong with the design itself is told as such
        load_design(called)
        raise InputError(_of_settings(str(error), values)) from None


def settings_of(settings: Mapping[str, object], folder: Path) -> dict[str, object]:
    """The values that a file has under `settings`, with paths that start from a folder."""
    return {key: value_from_folder(key, value, folder) for key, value in settings.items()}


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
