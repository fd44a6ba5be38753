"""Files of parts to make."""

from __future__ import annotations

import json
import textwrap
from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from importlib import metadata
from math import nan
from pathlib import Path, PurePosixPath
from typing import Any, get_args

from matplotlib.figure import Figure

from forficula.design import load_design, save_design
from forficula.dynamics import Record
from forficula.errors import InputError
from forficula.files import replacing_all, write_bytes, write_text
from forficula.make.as_made import AS_MADE
from forficula.make.checks.check import Check
from forficula.make.checks.check_parts import check_parts
from forficula.make.files.bill import bill_csv, bill_json, bill_of
from forficula.make.files.print_orientation import file_names
from forficula.make.files.printing import print_files
from forficula.make.files.step import check_step, write_step
from forficula.make.flat.sheet_dxf import write_sheet_dxf
from forficula.make.flat.sheet_svg import write_sheet_svg
from forficula.make.make_parts import PartName, make_parts
from forficula.make.part import PartSet
from forficula.serial import json_text, plain
from forficula.show.folder.notebook_cell import framed
from forficula.show.folder.presentation import Presentation
from forficula.show.make.made_figure import draw_made
from forficula.show.make.parts_figure import draw_parts
from forficula.show.page.parts_page import parts_page, write_parts_page
from forficula.show.structure.cut_sheet_figure import draw_cut_sheet
from forficula.show.style import VERMILION, Drawing, figure_files, figure_style, save_figures
from forficula.study.made_comparison import MadeComparison, comparison_or_why

BILL_FILE = "bill.json"
AS_MADE_FILE = "as-made.json"
_CHECKS_FILE = "checks.json"
# text above figures: letters per inch, line height in inches, and number of kinds of checks that are named
_LETTERS, _LINE, _NAMED = 14, 0.16, 4
# folders whose files a bill may list; these are removed when other parts are made in the folder
_FOLDERS = ("stl", "step")
_FIGURES = [file for name in ("parts", "sheet", "made") for file in figure_files(name)]
_WHOLE = ("parts.3mf", "sheet.dxf", "sheet.svg", AS_MADE, AS_MADE_FILE, *_FIGURES)


def write_parts(
    parts: PartSet,
    checks: Sequence[Check],
    folder: Path,
    *,
    record: Record | None = None,
    step: bool = False,
    compared: MadeComparison | None = None,
    progress: Callable[[str], None] = lambda _: None,
) -> None:
    """Write the design, bill, checks, page, and the files for printers and cutters; all of them, or none.

    Args:
        parts: parts to make.
        checks: checks of these parts.
        folder: folder, created if missing; files of earlier parts are replaced, or removed if these parts lack them.
        record: a run of the design, which the page plays back.
        step: whether solids are also written as STEP.
        compared: comparison of the design with the parts as made, to be written as well.
        progress: receives a line of text on each file.

    Raises:
        InputError: the folder cannot be written, the record has another design, or STEP is requested without
                Open Cascade.
    """
    if step:
        check_step()
    with replacing_all(folder, remove=_earlier(folder)) as unfinished:
        for name, content in print_files(parts, progress).items():
            write_bytes(unfinished / name, content)
        if step:
            _write_step(parts, unfinished, progress)
        if parts.sheet is not None:
            write_sheet_dxf(parts.sheet, unfinished / "sheet.dxf")
            write_sheet_svg(parts.sheet, unfinished / "sheet.svg")
        save_design(parts.design, unfinished / "design.toml")
        progress("drawing")
        save_figures(parts_drawings(parts, checks, compared), unfinished)
        if compared is not None:
            save_design(compared.made, unfinished / AS_MADE)
            write_text(unfinished / AS_MADE_FILE, json_text(compared))
        _write_lists(parts, checks, unfinished)
        progress("writing parts.html")
        files = [name for name in _files(unfinished) if not name.startswith("figures/")]
        write_parts_page(parts, checks, unfinished / "parts.html", record, files=files)


def parts_drawings(
    parts: PartSet, checks: Sequence[Check] = (), compared: MadeComparison | None = None
) -> dict[str, Drawing]:
    """Return the drawings of parts by kind: exploded view, sheet, and a hinge as designed and as made.

    Args:
        parts: parts to make.
        checks: checks of these parts; figures report in red how many fail.
        compared: comparison of the design with the parts as made; computed if not given.
    """
    sheet, drawings = parts.sheet, dict[str, Drawing]()
    if sheet is not None:
        drawings["sheet"] = lambda width: _marked(draw_cut_sheet(sheet, width), sheet.checks)
    if not parts.parts:
        return drawings
    drawings["parts"] = lambda width: _marked(draw_parts(parts, width), checks)
    if not parts.joints:
        return drawings
    made = compared or comparison_or_why(parts)
    if isinstance(made, MadeComparison) and made.hinges:
        drawings["made"] = lambda width: _marked(draw_made(made, width), checks)
    return drawings


def _marked(figure: Figure, checks: Sequence[Check]) -> Figure:
    """Write above a figure how many checks fail, and which."""
    failed = Counter(check.name for check in checks if check.ok is False)
    if not failed:
        return figure
    names = [f"{name} ({count})" if count > 1 else name for name, count in failed.most_common(_NAMED)]
    names += ["others"] * (len(failed) > _NAMED)
    made, fail = sum(check.ok is not None for check in checks), "fails" if failed.total() == 1 else "fail"
    text = f"{failed.total()} of {made} checks {fail}: {', '.join(names)}"
    letters = int(_LETTERS * figure.get_figwidth())
    with figure_style():
        if figure.get_layout_engine() is not None:
            title = figure.get_suptitle()
            words = textwrap.fill(f"{title}. {text}" if title else text, letters)
            figure.suptitle(words, color=VERMILION, fontsize=8)
            return figure
        # axes with fixed positions: the figure grows by the height of the text
        words, height = textwrap.fill(text, letters), figure.get_figheight()
        whole = height + _LINE * (words.count("\n") + 1.5)
        figure.set_figheight(whole)
        for axes in figure.axes:
            box = axes.get_position(original=True)
            axes.set_position((box.x0, box.y0 * height / whole, box.width, box.height * height / whole))
        figure.text(0.5, 1 - _LINE / 3 / whole, words, ha="center", va="top", color=VERMILION, fontsize=8)
    return figure


def parts_json(parts: PartSet, checks: Sequence[Check]) -> dict[str, Any]:
    """Return parts and their checks as plain data: masses, sizes, totals by material, checks."""
    return {**plain(parts.design.identity), **bill_json(bill_of(parts)), "checks": plain(checks)}


def read_parts(folder: Path) -> PartSet:
    """Make the parts of a folder again from its design: those listed in its bill.

    Raises:
        InputError: it is not a folder of parts, or its design now has other parts.
    """
    design = load_design(str(folder / "design.toml"))
    try:
        names = [str(row["part"]) for row in json.loads((folder / BILL_FILE).read_text("utf-8"))["parts"]]
    except (OSError, LookupError, ValueError, TypeError) as error:
        raise InputError(f"{folder / BILL_FILE}: not a bill of forficula: {error}") from None
    for part in get_args(PartName):
        try:
            parts = make_parts(design, part)
        except InputError:  # the design has no such part
            continue
        if [*(part.name for part in parts.parts), *([] if parts.sheet is None else ["sheet"])] == names:
            return parts
    raise InputError(f"{folder}: its bill is not of its design: make it again, forficula make …")


def read_checks(folder: Path) -> list[Check]:
    """Return the checks of the parts in a folder, without numbers; empty if they were not written."""
    try:
        rows = json.loads((folder / _CHECKS_FILE).read_text("utf-8"))
        return [
            Check(name=row["name"], part=row["part"], ok=row["ok"], value=nan, limit=nan, unit="", text=row["text"])
            for row in rows
        ]
    except (OSError, LookupError, ValueError, TypeError):
        return []


def _write_step(parts: PartSet, folder: Path, progress: Callable[[str], None]) -> None:
    """Write all solids as STEP, whether printed or not."""
    (folder / "step").mkdir()
    for part, name in zip(parts.parts, file_names([part.name for part in parts.parts]), strict=True):
        progress(f"writing {name}.step")
        write_step(part, folder / "step" / f"{name}.step")


def _write_lists(parts: PartSet, checks: Sequence[Check], folder: Path) -> None:
    """Write the checks and the bill, which lists the files of the folder."""
    bill = parts_json(parts, checks)
    write_text(folder / _CHECKS_FILE, json_text(bill.pop("checks")))
    write_text(folder / "bill.csv", bill_csv(bill_of(parts)))
    bill["files"] = sorted([*_files(folder), "parts.html"])
    bill["versions"] = {name: metadata.version(name) for name in ("forficula", "manifold3d")}
    write_text(folder / BILL_FILE, json_text(bill))


def _files(folder: Path) -> list[str]:
    return sorted(file.relative_to(folder).as_posix() for file in folder.rglob("*.*") if file.is_file())


def _earlier(folder: Path) -> list[str]:
    """Return the files of earlier parts in a folder, listed in its bill; other files are left alone."""
    try:
        listed = json.loads((folder / BILL_FILE).read_text("utf-8"))["files"]
        names = [name for name in listed if isinstance(name, str)]
    except (OSError, ValueError, LookupError, TypeError):
        return []
    places = [(name, PurePosixPath(name).parts) for name in names]
    return [name for name, at in places if name in _WHOLE or (len(at) == 2 and at[0] in _FOLDERS and at[1] != "..")]


def _cell(parts: PartSet) -> Iterator[str]:
    """Yield the page of the parts, without the checks, which take seconds."""
    yield framed(parts_page(parts, ()), f"{parts.design.name}, parts to make")


def _write(parts: PartSet, folder: Path) -> None:
    compared = comparison_or_why(parts) if parts.joints else None
    made = compared if isinstance(compared, MadeComparison) else None
    write_parts(parts, check_parts(parts), folder, compared=made)


PRESENTATION = Presentation(
    drawings=parts_drawings,
    cell=_cell,
    read=lambda folder: parts_drawings(read_parts(folder), read_checks(folder)),
    write=_write,
    page=lambda parts, path, engine: write_parts_page(parts, check_parts(parts), path),  # noqa: ARG005
)
