"""The files that parts to make leave."""

from __future__ import annotations

import json
from collections.abc import Callable, Sequence
from importlib import metadata
from pathlib import Path, PurePosixPath
from typing import Any

from forficula.design import save_design
from forficula.files import replacing_all, write_bytes, write_text
from forficula.make.check import Check
from forficula.make.files.bill import bill_csv, bill_json, bill_of
from forficula.make.files.checks import checks_json
from forficula.make.files.lying import file_names, lying_mesh
from forficula.make.files.step import check_step, write_step
from forficula.make.files.stl import stl_bytes
from forficula.make.files.three_mf import Item, three_mf_bytes
from forficula.make.part import PartSet
from forficula.make.sheet_dxf import write_sheet_dxf
from forficula.make.sheet_svg import write_sheet_svg

BILL_FILE = "bill.json"
# in which a bill may list files of parts, which go when other parts are made there
_FOLDERS = ("stl", "step")
_WHOLE = ("parts.3mf", "sheet.dxf", "sheet.svg")


def write_parts(
    parts: PartSet,
    checks: Sequence[Check],
    folder: Path,
    *,
    step: bool = False,
    progress: Callable[[str], None] = lambda _: None,
) -> None:
    """Write design, bill, checks, and the files that printers and cutters take; all of them, or none.

    Args:
        parts: to make.
        checks: of them.
        folder: made where it is missing; what earlier parts left there is replaced, or removed where these have none.
        step: whether solids are written as STEP, too.
        progress: is told what is written.

    Raises:
        InputError: the folder cannot be written, or STEP is wanted and Open Cascade not there.
    """
    if step:
        check_step()
    with replacing_all(folder, remove=_earlier(folder)) as unfinished:
        _write_solids(parts, unfinished, step, progress)
        if parts.sheet is not None:
            write_sheet_dxf(parts.sheet, unfinished / "sheet.dxf")
            write_sheet_svg(parts.sheet, unfinished / "sheet.svg")
        save_design(parts.design, unfinished / "design.toml")
        _write_lists(parts, checks, unfinished)


def parts_json(parts: PartSet, checks: Sequence[Check]) -> dict[str, Any]:
    """Parts and what is checked of them as plain data: masses, sizes, totals by material, checks."""
    bill = bill_json(bill_of(parts))
    return {"design": parts.design.name, "design_hash": parts.design.hash, **bill, "checks": checks_json(checks)}


def _write_solids(parts: PartSet, folder: Path, step: bool, progress: Callable[[str], None]) -> None:
    """Write all printed parts as STL and in one 3MF file, and all solids as STEP where that is wanted."""
    names, items = file_names([part.name for part in parts.parts]), []
    for part, name in zip(parts.parts, names, strict=True):
        if part.printed:
            progress(f"writing {name}.stl")
            mesh = lying_mesh(part)
            items.append(Item(name=part.name, material=part.stock.name, mesh=mesh, count=part.count))
            write_bytes(folder / "stl" / f"{name}.stl", stl_bytes(mesh, part.name))
    if items:
        progress("writing parts.3mf")
        write_bytes(folder / "parts.3mf", three_mf_bytes(items, parts.design.name))
    for part, name in zip(parts.parts, names, strict=True) if step else ():
        progress(f"writing {name}.step")
        (folder / "step").mkdir(exist_ok=True)
        write_step(part, folder / "step" / f"{name}.step")


def _write_lists(parts: PartSet, checks: Sequence[Check], folder: Path) -> None:
    """Write the bill, which lists the files that are there, and the checks."""
    plain = parts_json(parts, checks)
    # what does not exist is null; not every reader of JSON knows NaN
    told = json.dumps(plain.pop("checks"), indent=2, ensure_ascii=False, allow_nan=False)
    write_text(folder / "checks.json", told + "\n")
    write_text(folder / "bill.csv", bill_csv(bill_of(parts)))
    plain["files"] = sorted(file.relative_to(folder).as_posix() for file in folder.rglob("*.*") if file.is_file())
    plain["versions"] = {name: metadata.version(name) for name in ("forficula", "manifold3d")}
    write_text(folder / BILL_FILE, json.dumps(plain, indent=2, ensure_ascii=False, allow_nan=False) + "\n")


def _earlier(folder: Path) -> list[str]:
    """Files of earlier parts in a folder, by their bill: what else lies there is not ours."""
    try:
        listed = json.loads((folder / BILL_FILE).read_text("utf-8"))["files"]
        names = [name for name in listed if isinstance(name, str)]
    except (OSError, ValueError, LookupError, TypeError):
        return []
    places = [(name, PurePosixPath(name).parts) for name in names]
    return [name for name, at in places if name in _WHOLE or (len(at) == 2 and at[0] in _FOLDERS and at[1] != "..")]
