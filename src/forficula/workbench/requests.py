"""Requests of the page of a workbench: a design, with values in place of those of its file."""

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

# endings of files of designs and of files that designs name
_ENDINGS = (".toml", ".fold", ".svg", ".dxf")
_MOST_FILES = 20
_NAME = re.compile(r"[^/\\:\x00-\x1f]{1,100}")
_LONGEST = 255  # bytes of a file name, on every usual file system
_MOST_POINTS = 8  # of a place on a panel
_LONGEST_KEY = 300  # letters; the longest key of a named design has 39
_OUTSIDE = (
    "the workbench reads only files that are dropped on its page, files in the folder of its design, and files that"
    " this design named when the workbench was opened"
)


class UploadedFile(BaseModel):
    """A file that was dropped on the page.

    Attributes:
        name: name of the file, without a folder.
        text: content of the file.
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


class PageRequest(BaseModel):
    """A request of a page."""

    model_config = ConfigDict(frozen=True, extra="forbid")


class DesignRequest(PageRequest):
    """A design that a page requests.

    Attributes:
        design: name of a named design; "" for the design with which the workbench was opened, or for that of the files.
        files: a design file and the files that it names, or a FOLD file or a drawing; the design comes first.
        unit: length of the unit of a FOLD file or drawing that states none, as text; "" if not given.
        settings: values by dotted key, as the text of `--set`.
    """

    design: str = ""
    files: Annotated[tuple[UploadedFile, ...], Field(max_length=_MOST_FILES)] = ()
    unit: str = ""
    settings: dict[str, str] = {}

    @field_validator("settings")
    @classmethod
    def _has_short_keys(cls, settings: dict[str, str]) -> dict[str, str]:
        for key in settings:
            if len(key) > _LONGEST_KEY:
                raise ValueError(f"need keys of at most {_LONGEST_KEY} letters, got {as_written(key)}")
        return settings


class FoldRequest(DesignRequest):
    """A design whose fold path a page requests.

    Attributes:
        share: position of the slider; the path is computed first around the shape that the path of the design before a
            change has there. None for another design.
    """

    share: Annotated[float | None, Field(ge=0, le=1)] = None


class DragRequest(FoldRequest):
    """A design, and a point of its structure that a page drags.

    Attributes:
        weights: numbers of the drawn points whose weighted mean is dragged, and their weights.
        target: position to which the point is dragged, m.
        begins: whether the drag begins at the shape of the slider; otherwise it continues from its last shape.
    """

    weights: Annotated[dict[Annotated[int, Field(ge=0)], float], Field(min_length=1, max_length=_MOST_POINTS)]
    target: tuple[float, float, float]
    begins: bool = False


@dataclass(frozen=True, kw_only=True)
class Opened:
    """The design with which a workbench was opened.

    Attributes:
        design: a named design, or the path of a file.
        unit: length of the unit of a FOLD file or drawing that states none, m.
        settings: values by dotted key, as text, with which its page begins.
        named: absolute paths of the files that the design and these settings name, in any folder.
    """

    design: str
    unit: float | None = None
    settings: Mapping[str, str] = field(default_factory=dict)
    named: frozenset[Path] = frozenset()

    @property
    def folder(self) -> Path:
        """Folder in which its page may name files: that of the design file, or the working folder."""
        return Path() if self.design in named_designs() else Path(self.design).parent


def opened_with(design: str, settings: Mapping[str, str], unit: float | None) -> Opened:
    """Open a design for a workbench, and record the files that it names, because its owner chose them.

    Raises:
        InputError: the design cannot be read.
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
    """Allow the files that a page may name, and refuse every other path without accessing it.

    Args:
        opened: design with which the workbench was opened.
        sent: folder of the files that the page has sent.
    """
    folders = [opened.folder] if sent is None else [opened.folder, sent]
    with reading_only(_within(folders, opened.named), _OUTSIDE):
        yield


def _within(folders: list[Path], named: frozenset[Path]) -> Callable[[Path], bool]:
    allowed = [(_absolute(folder), folder.resolve()) for folder in folders]

    def allows(path: Path) -> bool:
        written = _absolute(path)
        if written in named:
            return True
        for absolute, resolved in allowed:
            # compare the path as written first, because resolving it accesses files
            if not (written.is_relative_to(absolute) or written.is_relative_to(resolved)):
                continue
            try:
                if path.resolve().is_relative_to(resolved):
                    return True
            except (OSError, RuntimeError, ValueError):  # circular links, or not a path
                continue
        return False

    return allows


def _absolute(path: Path) -> Path:
    return Path(os.path.normpath(path.absolute()))


def _read(settings: Mapping[str, str]) -> dict[str, object]:
    return dict(read_settings([f"{key}={text}" for key, text in settings.items()], "key"))


def requested_design(request: DesignRequest, opened: Opened) -> Design:
    """Read the design that a page requests, with its values.

    Raises:
        InputError: the design does not exist, a file is not a design, or a value is not allowed.
    """
    settings = _read(request.settings)
    if request.files:
        return _sent_design(request, opened, settings)
    # a page must not name a file as its design
    if request.design and request.design not in named_designs():
        raise InputError(f"design: need {one_of(named_designs(), request.design)}")
    with reading_for_page(opened):
        if request.design:
            return load_design(request.design, settings)
        return load_design(opened.design, settings, unit=opened.unit)


def design_source(request: DesignRequest, opened: Opened) -> str:
    """Return the argument with which a command reads the design of a request, without its values."""
    if not request.files:
        return request.design or opened.design
    name = request.files[0].name
    # otherwise the name would be read as an option
    return f"./{name}" if name.startswith("-") else name


def _sent_design(request: DesignRequest, opened: Opened, settings: Mapping[str, object]) -> Design:
    """Read a design from sent files, which are in a temporary folder while they are read."""
    unit = parse_quantity(request.unit, LENGTH) if request.unit else None
    with TemporaryDirectory(prefix="forficula-") as name:
        folder = Path(name)
        for sent in request.files:
            if Path(sent.name).suffix.lower() not in _ENDINGS:
                raise InputError(f"need a file that ends with {', '.join(_ENDINGS)}, got {as_written(sent.name)}")
            try:
                (folder / sent.name).write_text(sent.text, "utf-8", newline="")
            except OSError as error:  # a file name that this system does not allow
                raise InputError(f"{as_written(sent.name)}: cannot be stored: {error.strerror}") from None
        try:
            with reading_for_page(opened, folder):
                return load_design(folder / request.files[0].name, settings, unit=unit)
        except InputError as error:
            # without the temporary folder, which means nothing to the reader
            message = str(error).replace(f"{folder.resolve()}/", "").replace(f"{folder}/", "")
            raise InputError(message.replace(f"{folder}\\", "")) from None
