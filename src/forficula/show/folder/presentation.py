"""Drawing and writing of results of every kind: one registry for notebooks, folders, figures and calls."""

from __future__ import annotations

import difflib
import os
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from importlib import import_module
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import TYPE_CHECKING, Any

from forficula.dynamics import as_record
from forficula.errors import InputError
from forficula.files import clear_leftovers, write_bytes
from forficula.results import KINDS, ResultKind, kind_of_class, kinds_in
from forficula.show.style import COLUMN_WIDTH, COPIES, ENDINGS, PAGE_WIDTH, Drawing, save_figure

if TYPE_CHECKING:
    from xarray import Dataset

_PAGE = "report.html"
_PAGES = (_PAGE, "parts.html")


@dataclass(frozen=True, kw_only=True)
class Presentation:
    """Functions that present results of one kind.

    Attributes:
        drawings: returns the drawings of a result, by the stems of their files.
        cell: yields the HTML of a result in a notebook, part by part.
        read: returns the drawings of a folder, by the stems of their files; None if the folder lacks data that the
                figures show.
        copied: reason why figures are copied if `read` is None, for messages.
        write: writes a result to a folder as its command does; None if only the command can.
        page: writes a result as one HTML file, with or without the simulator; None if `write` writes the page.
    """

    drawings: Callable[[Any], dict[str, Drawing]]
    cell: Callable[[Any], Iterator[str]]
    read: Callable[[Path], dict[str, Drawing]] | None = None
    copied: str = ""
    write: Callable[[Any, Path], None] | None = None
    page: Callable[[Any, Path, bool], None] | None = None


def presentation(kind: ResultKind) -> Presentation:
    """Load the presentation of a kind of results."""
    loaded = import_module(f"forficula.show.folder.{kind.module}").PRESENTATION
    assert isinstance(loaded, Presentation)
    return loaded


def result_kind(result: object) -> ResultKind:
    """Find the kind of a result.

    Raises:
        InputError: it is not a result of forficula.
    """
    kind = kind_of_class(_class_name(result))
    if kind is None:
        raise InputError(f"need results of forficula or their folder, got a {type(result).__name__}")
    return kind


def drawings_of(result: object) -> dict[str, Drawing]:
    """Return the drawings of a result or of a folder of results, by the stems of their files.

    Raises:
        InputError: it is neither a result of forficula nor a folder of one.
    """
    if isinstance(result, str | os.PathLike):
        folder = Path(result)
        if folder.is_dir():  # a name that no folder can have is refused below
            clear_leftovers(folder)
        return folder_drawings(folder)
    return presentation(result_kind(result)).drawings(result)


def folder_drawings(folder: Path) -> dict[str, Drawing]:
    """Return the drawings of a folder, by the stems of their files.

    Raises:
        InputError: forficula did not write the folder, or a file in it cannot be read.
    """
    if not folder.is_dir():
        what = "a file" if folder.exists() else "no such folder"
        raise InputError(f"{folder}: need a folder that forficula wrote, got {what}")
    drawings: dict[str, Drawing] = {}
    for kind in kinds_in(folder):
        shown = presentation(kind)
        if shown.read is None:
            raise InputError(
                f"{folder}: the figures of {shown.copied}; they are in its folder {COPIES}, or pass the result itself"
            )
        drawings |= shown.read(folder)
    if not drawings:
        names = ", ".join(kind.data for kind in KINDS)
        raise InputError(f"{folder}: need a folder that forficula wrote, with one of {names} in it")
    return drawings


def write_figure(folder: Path, kind: str, path: Path, width: float | None = None) -> None:
    """Write one figure of a folder of results.

    Args:
        folder: folder that forficula wrote.
        kind: kind of figure: the stem of its file in the folder.
        path: path that ends with .png, .svg or .pdf.
        width: width, inch; that of a column by default.

    Raises:
        InputError: forficula did not write the folder, or it has no such figure; the path has another ending, or the
            figure
            cannot be written.
    """
    if path.suffix not in ENDINGS:
        raise InputError(f"--out: need a file that ends with .png, .svg or .pdf, got {path}")
    clear_leftovers(folder)  # an interrupted run may have set files aside
    copied = next((result for kind in kinds_in(folder) if (result := presentation(kind)).read is None), None)
    if copied is not None:
        _copy(folder, kind, path, width, copied.copied)
        return
    drawings = folder_drawings(folder)
    save_figure(drawings[_known(kind, drawings, folder)](width or COLUMN_WIDTH), path)


def write_page(result: object, path: Path, *, engine: bool = True) -> None:
    """Write a result as one HTML file, or the page of a folder of results.

    Args:
        result: result of any kind, or the folder of one.
        path: path of the page.
        engine: whether the page of a run contains the simulator; the page of a folder of other results is copied
            unchanged.

    Raises:
        InputError: it is not a result of forficula or has no page, or the page cannot be written.
    """
    if isinstance(result, str | os.PathLike):
        folder = Path(result)
        written = next((folder / name for name in _PAGES if (folder / name).is_file()), None)
        if written is not None and (engine or not (folder / "record.nc").is_file()):
            write_bytes(path, written.read_bytes())
            return
        result = as_record(folder)
    kind = result_kind(result)
    shown = presentation(kind)
    if shown.page is not None:
        shown.page(result, path, engine)
        return
    if shown.write is None:
        raise InputError(f"a {kind.name} has its page in the folder that its command writes")
    with TemporaryDirectory() as folder_name:
        shown.write(result, Path(folder_name))
        if not (Path(folder_name) / _PAGE).is_file():
            raise InputError(f"{kind.name}: no page of their own; they are on the page of a run")
        write_bytes(path, (Path(folder_name) / _PAGE).read_bytes())


def read_dataset(path: Path) -> Dataset:
    """Read a table of a folder.

    Raises:
        InputError: it cannot be read.
    """
    import xarray

    try:
        return xarray.load_dataset(path, engine="h5netcdf")
    except (OSError, ValueError) as error:
        raise InputError(f"{path}: cannot be read: {' '.join(str(error).split())}") from None


def _class_name(result: object) -> str:
    """Return the name of a result's class; tables read from a file are recognised by their dimensions."""
    name = type(result).__name__
    if name != "Dataset":
        return name
    dims, attributes = getattr(result, "dims", ()), getattr(result, "attrs", {})
    if "fact" in dims and "most_met" in attributes:
        return "IdentificationTable"
    if "fact" in dims and "says" in attributes:
        return "ToleranceTable"
    return "StudyTable" if "transitions" in attributes else name


def _copy(folder: Path, kind: str, path: Path, width: float | None, why: str) -> None:
    """Copy a figure from its folder."""
    kept = {file.stem for file in (folder / COPIES).glob("*.svg")}
    name = _known(kind, kept, folder)
    usual = PAGE_WIDTH if path.suffix == ".png" else COLUMN_WIDTH
    if width is not None and width != usual:
        format_width = "page" if path.suffix == ".png" else "column"
        raise InputError(f"--width: the figures of {why}: its {path.suffix} is as wide as a {format_width}")
    source = folder / f"{name}.png" if path.suffix == ".png" else folder / COPIES / f"{name}{path.suffix}"
    try:
        content = source.read_bytes()
    except OSError as error:
        raise InputError(f"{source}: cannot be read: {error.strerror}") from None
    write_bytes(path, content)


def _known(kind: str, kinds: Iterable[str], folder: Path) -> str:
    names = sorted(kinds)
    if kind in names:
        return kind
    near = difflib.get_close_matches(kind.lower(), names, n=1)
    hint = f"; did you mean {near[0]}?" if near else ""
    raise InputError(f'--kind: need one of {", ".join(names)} for {folder}, got "{kind}"{hint}')
