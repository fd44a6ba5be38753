"""What the page of a workbench asks: a design, and values in place of its own."""

from __future__ import annotations

import os
import re
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Annotated

from pydantic import BaseModel, ConfigDict, Field, field_validator

from forficula.allowed_files import reading_only
from forficula.design import Design, load_design, named_designs
from forficula.design.section import LENGTH
from forficula.errors import InputError
from forficula.names import one_of
from forficula.options import read_settings
from forficula.quantities import as_written, parse_quantity

# of files that a design is read from, with what it names
_ENDINGS = (".toml", ".fold", ".svg", ".dxf")
_MOST_FILES = 20
_NAME = re.compile(r"[^/\\:\x00-\x1f]{1,100}")
_LONGEST = 255  # bytes of a file name, on every usual file system
_LONGEST_KEY = 300  # letters; the longest key of a named design has 39
_OUTSIDE = (
    "the workbench reads only what is dropped on its page, what lies in the folder of its design, and what that design"
    " named when the workbench was opened"
)


class SentFile(BaseModel):
    """A file that was dropped on the page.

    Attributes:
        name: without a folder.
        text: what it holds.
    """

    model_config = ConfigDict(frozen=True, extra="forbid")

    name: str
    text: str

    @field_validator("name")
    @classmethod
    def _is_a_name(cls, name: str) -> str:
        if _NAME.fullmatch(name) is None:
            raise ValueError(f"need a file name of at most 100 letters, none of them / \\ or :, got {as_written(name)}")
        if len(name.encode("utf-8", "replace")) > _LONGEST:
            raise ValueError(f"need a file name of at most {_LONGEST} bytes in UTF-8, got {as_written(name)}")
        return name


class Asked(BaseModel):
    """A design as the page has it.

    Attributes:
        design: a named one; "" for the one that the workbench was opened with, or for that of the files.
        files: a design file with those that it names, or a FOLD file or a drawing; the design comes first.
        unit: length of the unit of a FOLD file or a drawing that names none, with its unit; "" if not given.
        settings: text by dotted key, as `--set` takes it.
    """

    model_config = ConfigDict(frozen=True, extra="forbid")

    design: str = ""
    files: Annotated[tuple[SentFile, ...], Field(max_length=_MOST_FILES)] = ()
    unit: str = ""
    settings: dict[str, str] = {}

    @field_validator("settings")
    @classmethod
    def _has_short_keys(cls, settings: dict[str, str]) -> dict[str, str]:
        for key in settings:
            if len(key) > _LONGEST_KEY:
                raise ValueError(f"need keys of at most {_LONGEST_KEY} letters, got {as_written(key)}")
        return settings


@dataclass(frozen=True, kw_only=True)
class Opened:
    """What a workbench was opened with.

    Attributes:
        design: a named design, or the path of a file.
        unit: length of the unit of a FOLD file or a drawing that names none, m.
        settings: text by dotted key, with which its page begins.
        named: absolute paths of the files that the design and these settings name, wherever they lie.
    """

    design: str
    unit: float | None = None
    settings: Mapping[str, str] = field(default_factory=dict)
    named: frozenset[Path] = frozenset()

    @property
    def folder(self) -> Path:
        """The folder in which its page may name files: that of the design's file, or the working folder."""
        return Path() if self.design in named_designs() else Path(self.design).parent


def opened_with(design: str, settings: Mapping[str, str], unit: float | None) -> Opened:
    """Open a design for a workbench, and note which files it names: its owner chose them, wherever they lie.

    Raises:
        InputError: it cannot be read.
    """
    named: set[Path] = set()

    def note(path: Path) -> bool:
        named.add(_absolute(path))
        return True

    with reading_only(note, ""):
        load_design(design, _read(settings), unit=unit)
    return Opened(design=design, unit=unit, settings=settings, named=frozenset(named))


@contextmanager
def reading_for_page(opened: Opened, sent: Path | None = None) -> Iterator[None]:
    """Read what a page may name, and refuse every other path without looking at it.

    Args:
        opened: what the workbench was opened with.
        sent: the folder of the files that the page has sent.
    """
    folders = [opened.folder] if sent is None else [opened.folder, sent]
    with reading_only(_within(folders, opened.named), _OUTSIDE):
        yield


def _within(folders: list[Path], named: frozenset[Path]) -> Callable[[Path], bool]:
    places = [(_absolute(folder), folder.resolve()) for folder in folders]

    def allows(path: Path) -> bool:
        written = _absolute(path)
        if written in named:
            return True
        for absolute, resolved in places:
            # as it is written first: to resolve a path looks at files
            if not (written.is_relative_to(absolute) or written.is_relative_to(resolved)):
                continue
            try:
                if path.resolve().is_relative_to(resolved):
                    return True
            except (OSError, RuntimeError, ValueError):  # links in a circle, or no path at all
                continue
        return False

    return allows


def _absolute(path: Path) -> Path:
    return Path(os.path.normpath(path.absolute()))


def _read(settings: Mapping[str, str]) -> dict[str, object]:
    return dict(read_settings([f"{key}={text}" for key, text in settings.items()], "key"))


def asked_design(asked: Asked, opened: Opened) -> Design:
    """Read the design that a page asks for, with its values.

    Raises:
        InputError: no such design, a file that is none, or a value that is not allowed.
    """
    settings = _read(asked.settings)
    if asked.files:
        return _sent_design(asked, opened, settings)
    # a page names no file as its design
    if asked.design and asked.design not in named_designs():
        raise InputError(f"design: need {one_of(named_designs(), asked.design)}")
    with reading_for_page(opened):
        if asked.design:
            return load_design(asked.design, settings)
        return load_design(opened.design, settings, unit=opened.unit)


def design_source(asked: Asked, opened: Opened) -> str:
    """What a command names to have the design that a page asks for, before its values."""
    if not asked.files:
        return asked.design or opened.design
    name = asked.files[0].name
    # else it would be read as an option
    return f"./{name}" if name.startswith("-") else name


def _sent_design(asked: Asked, opened: Opened, settings: Mapping[str, object]) -> Design:
    """A design of files, which lie in a folder of their own as long as it takes to read them."""
    unit = parse_quantity(asked.unit, LENGTH) if asked.unit else None
    with TemporaryDirectory(prefix="forficula-") as name:
        folder = Path(name)
        for sent in asked.files:
            if Path(sent.name).suffix.lower() not in _ENDINGS:
                raise InputError(f"need a file that ends with {', '.join(_ENDINGS)}, got {as_written(sent.name)}")
            try:
                (folder / sent.name).write_text(sent.text, "utf-8", newline="")
            except OSError as error:  # a name that this system does not take
                raise InputError(f"{as_written(sent.name)}: cannot be kept: {error.strerror}") from None
        try:
            with reading_for_page(opened, folder):
                return load_design(folder / asked.files[0].name, settings, unit=unit)
        except InputError as error:
            # that folder is none of its reader's business
            told = str(error).replace(f"{folder.resolve()}/", "").replace(f"{folder}/", "")
            raise InputError(told.replace(f"{folder}\\", "")) from None
