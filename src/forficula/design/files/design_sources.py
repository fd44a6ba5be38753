"""Files of a design: named designs, files that are based on others, and parts of assemblies."""

from __future__ import annotations

import difflib
import re
import tomllib
from collections.abc import Sequence
from copy import deepcopy
from functools import cache
from importlib import resources
from pathlib import Path
from typing import Any

from forficula.allowed_files import may_read
from forficula.design.assembly.assembly import check_part_name
from forficula.design.files.file_design import file_tables
from forficula.design.files.file_words import check_file_kind
from forficula.design.files.layers import laid_over
from forficula.design.files.rejection import File
from forficula.design.files.tables import (
    RejectedError,
    merged,
)
from forficula.design.files.tendon_tables import value_from_folder
from forficula.design.sheets.sheet_tables import with_sheet_read
from forficula.errors import InputError
from forficula.files import read_toml
from forficula.names import listed
from forficula.pattern import PATTERN_FILES
from forficula.quantities import as_written

_MOST_FILES = 50  # in a chain of files that are based on each other
_LISTED = 4  # named designs in the message for an unknown one
# a character without a letter of its own, which no file in UTF-8 contains
SURROGATE = re.compile("[\ud800-\udfff]")


@cache
def design_names() -> tuple[str, ...]:
    """Return the names of the designs that come with the package."""
    folder = resources.files("forficula.design") / "references"
    return tuple(sorted(entry.name.removesuffix(".toml") for entry in folder.iterdir() if entry.name.endswith(".toml")))


@cache
def _named_tables(name: str) -> dict[str, Any]:
    """Return the tables of the file of a named design; they must not be changed."""
    return tomllib.loads((resources.files("forficula.design") / "references" / f"{name}.toml").read_text("utf-8"))


def read_files(name_or_path: str, within: Sequence[Path] = ()) -> list[File]:
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
            if name in design_names():
                tables = deepcopy(_named_tables(name))
                base = tables.pop("based_on", None)
                tables = with_parts(tables, None, within)
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
        known = [*design_names(), *files]
        some = ", ".join(design_names()[:_LISTED])
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
        tables = with_parts(tables, path, [*above, path])
        tables = {key: value_from_folder(key, value, path.parent) for key, value in tables.items()}
        return with_sheet_read(tables, folder=path.parent)
    except InputError as error:
        raise InputError(f"{path}: {error}") from None


def with_parts(tables: dict[str, Any], path: Path | None, within: Sequence[Path] = ()) -> dict[str, Any]:
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
    try:
        inside = with_sheet_read(with_parts(part, path, within), folder=folder)
        if base is None:
            # the file may change a part of the assembly that it is based on, whose kind is not known here
            return inside
        complete: dict[str, Any] = {}
        for _, tables in _base_files(base, folder, within):
            complete = laid_over(complete, tables, merged, si=False)
        return laid_over(complete, inside, merged, si=False)
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
    return read_files(str(folder / base) if suffix == ".toml" else base, within)


def _name_of(path: Path) -> str:
    """Return the name of a design without a key `name`: the name of its file."""
    if SURROGATE.search(path.stem):
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


def _nearest(word: str, words: list[str]) -> str | None:
    near = difflib.get_close_matches(word, words, n=1)
    return f'did you mean "{near[0]}"?' if near else None
