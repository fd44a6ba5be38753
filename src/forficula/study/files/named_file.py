"""Load study, goal and observations files by name or path, and the designs that they refer to."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from importlib import resources
from pathlib import Path
from typing import Generic, TypeVar

from forficula.design import Design, load_design, value_from_folder
from forficula.design.files.file_words import check_file_kind, with_article
from forficula.design.files.rejection import read_section
from forficula.design.section import Section
from forficula.errors import InputError, error_prefix
from forficula.files import as_path, read_text
from forficula.names import near_name
from forficula.pattern import PATTERN_FILES
from forficula.quantities import as_written
from forficula.toml_text import parse_toml

Model = TypeVar("Model", bound=Section)
Built = TypeVar("Built")


@dataclass(frozen=True, kw_only=True)
class FileKind(Generic[Model]):
    """A kind of file that commands accept by name or path.

    Attributes:
        word: singular, such as "study".
        several: plural, such as "studies".
        package: package whose folder `references` contains the named files.
        model: keys that such a file may have.
        texts: texts for a new file about a design, by name. Examples of keys contain them as placeholders; a text with
            the name of a table is appended to the comment of this table.
    """

    word: str
    several: str
    package: str
    model: type[Model]
    texts: Callable[[Design], Mapping[str, str]] = lambda _: {}


def named_files(kind: FileKind[Model]) -> list[str]:
    """Return the names of the files of a kind that the package contains."""
    folder = resources.files(kind.package) / "references"
    return sorted(entry.name.removesuffix(".toml") for entry in folder.iterdir() if entry.name.endswith(".toml"))


def load_named(name_or_path: object, kind: FileKind[Model], build: Callable[[Model, Path], Built]) -> Built:
    """Load a named file or a file at a path, and build its object. A file without `name` is named by its stem.

    Args:
        name_or_path: name or path as a user writes it.
        kind: kind of the file.
        build: builds the object from the content of the file and the folder that paths in the file are relative to.

    Raises:
        InputError: unknown name, missing file, invalid TOML, or rejected by `build`. The message begins with the file.
    """
    name, names = str(as_path(name_or_path, f"a named {kind.word}, or the path of a file")), named_files(kind)
    if name in names:
        text, folder = (resources.files(kind.package) / "references" / f"{name}.toml").read_text("utf-8"), Path()
    elif name.endswith(".toml"):
        text, folder = read_text(Path(name)), Path(name).parent
    else:
        raise InputError(
            f"{as_written(name)} is neither a named {kind.word} nor a .toml file; the named {kind.several} are"
            f" {', '.join(names)}{near_name(name, names)}"
        )
    with error_prefix(f"{name}: "):
        tables = parse_toml(text, with_article(kind.word))
        check_file_kind(tables, kind.word)
        return build(read_section(kind.model, {"name": Path(name).stem, **tables}), folder)


def base_design(design: str | Design | None, settings: Mapping[str, object], folder: Path) -> Design:
    """Return the design that a file refers to.

    Args:
        design: a design, its name or its path.
        settings: values by key that replace the design's own.
        folder: folder that paths are relative to.

    Raises:
        InputError: no design, or a value that is not allowed.
    """
    if design is None:
        raise InputError('design: is missing; give the name or path of a design, such as "binder2025"')
    values = settings_of(settings, folder)
    if isinstance(design, Design):
        return settled_by(design, values)
    is_path = Path(design).suffix.lower() in (".toml", *PATTERN_FILES)
    name_or_path = str(folder / design) if is_path else design
    try:
        return load_design(name_or_path, values)
    except InputError as error:
        # an error that the design has without the settings is reported as an error of the design
        with error_prefix("design: "):
            load_design(name_or_path)
        raise InputError(_of_settings(str(error), values)) from None


def settings_of(settings: Mapping[str, object], folder: Path) -> dict[str, object]:
    """Return the values under `settings` of a file, with paths resolved from a folder."""
    return {key: value_from_folder(key, value, folder) for key, value in settings.items()}


def settled_by(design: Design, settings: Mapping[str, object]) -> Design:
    """Apply the values under `settings` of a file to a design.

    Raises:
        InputError: an unknown key, or a value that is not allowed.
    """
    try:
        return design.with_values(settings)
    except InputError as error:
        raise InputError(_of_settings(str(error).removeprefix(f"{design.name}: "), settings)) from None


def _of_settings(error: str, settings: Mapping[str, object]) -> str:
    """Prefix an error with the table `settings`, and with the key if the error is about one of its keys."""
    return f"settings.{error}" if error.startswith(tuple(f"{key}:" for key in settings)) else f"settings: {error}"
