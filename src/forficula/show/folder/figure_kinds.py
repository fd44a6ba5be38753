"""The figures that a folder of results has, drawn again from what it holds."""

from __future__ import annotations

import difflib
import json
import os
from collections.abc import Callable, Iterable
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING

from forficula.analysis import measure
from forficula.analysis.run_files import read_run
from forficula.design import load_design
from forficula.dynamics import Record
from forficula.errors import InputError
from forficula.files import clear_leftovers, write_bytes
from forficula.goals.optimise import Optimum
from forficula.make.part import PartSet
from forficula.material.characterisation import Characterisation
from forficula.reproduction import shown_tendon
from forficula.show.folder.assumptions_folder import assumptions_drawings
from forficula.show.folder.convergence_folder import CONVERGENCE_FILE, convergence_drawings
from forficula.show.folder.cycling_folder import cycling_drawings, read_cycling
from forficula.show.folder.identify_folder import IDENTIFIED
from forficula.show.folder.landscape_folder import landscape_drawings
from forficula.show.folder.material_folder import material_drawings
from forficula.show.folder.optimum_folder import OPTIMUM_FILE, optimum_drawings
from forficula.show.folder.parts_folder import BILL_FILE, parts_drawings, read_checks, read_parts
from forficula.show.folder.run_folder import run_drawings
from forficula.show.folder.static_map_folder import SIMULATED, static_map_drawings
from forficula.show.folder.study_folder import study_drawings
from forficula.show.folder.tolerance_folder import TOLERANCE_TABLE, tolerance_drawings
from forficula.show.goals.identify_figures import identify_drawings
from forficula.show.style import COLUMN_WIDTH, COPIES, ENDINGS, PAGE_WIDTH, Drawing, save_figure
from forficula.statics import EnergyLandscape
from forficula.study.assumptions import Assumptions
from forficula.study.assumptions_file import ASSUMPTIONS_FILE, load_assumptions
from forficula.study.convergence import Convergence
from forficula.study.convergence_file import load_convergence
from forficula.study.cycling import Cycling
from forficula.study.landscape_and_run import landscape_and_run
from forficula.study.outcome_kinds import check_table

if TYPE_CHECKING:
    from matplotlib.figure import Figure
    from xarray import Dataset

_MATERIAL = "material.json"
# whose figures are handed out as they were written, for the folder does not hold all that they show, and what it lacks
_COPIED = {
    _MATERIAL: "a material cannot be drawn again without its tests",
    OPTIMUM_FILE: "a search are not drawn again",
}
_AGAIN = {"table.nc": "forficula study …", "map.nc": "forficula landscape …", SIMULATED: "forficula landscape …"}


def write_figure(folder: Path, kind: str, path: Path, width: float | None = None) -> None:
    """Write one figure of a folder of results.

    Args:
        folder: that forficula wrote.
        kind: which figure; the name that its picture has in the folder.
        path: ends with .png, .svg or .pdf.
        width: inch; that of a column if not given.

    Raises:
        InputError: the folder is none of forficula's or has no such figure, another ending, or it cannot be written.
    """
    if path.suffix not in ENDINGS:
        raise InputError(f"--out: need a file that ends with .png, .svg or .pdf, got {path}")
    clear_leftovers(folder)  # a run that was killed may have set files aside
    for file, why in _COPIED.items():
        if (folder / file).is_file():
            _copy(folder, kind, path, width, why)
            return
    drawings = folder_drawings(folder)
    save_figure(drawings[_known(kind, drawings, folder)](width or COLUMN_WIDTH), path)


def drawings_of(result: object) -> dict[str, Drawing]:
    """What draws every figure of some results, by kind.

    Args:
        result: a folder that forficula wrote, or a record, a landscape, a table of a study or of an identification, a
            convergence study, assumptions, what became of cycles, a material, parts, or a search for the best design.

    Raises:
        InputError: it has no figures.
    """
    import xarray

    match result:
        case str() | os.PathLike():
            clear_leftovers(Path(result))
            return folder_drawings(Path(result))
        case Record():
            return run_drawings(result, measure(result))
        case EnergyLandscape():
            return landscape_drawings(result)
        case xarray.Dataset():
            if "factor" in result.dims and "fact" in result.dims:
                return tolerance_drawings(result)
            return identify_drawings(result) if "fact" in result.dims else study_drawings(result)
        case Convergence():
            return convergence_drawings(result)
        case Assumptions():
            return assumptions_drawings(result)
        case Cycling():
            return cycling_drawings(result)
        case Characterisation():
            return material_drawings(result)
        case PartSet():
            return parts_drawings(result)
        case Optimum():
            return optimum_drawings(result)
    raise InputError(f"need results of forficula or their folder, got a {type(result).__name__}")


def folder_drawings(folder: Path) -> dict[str, Drawing]:
    """What draws every figure of a folder, by kind.

    Raises:
        InputError: the folder is none of forficula's, or holds a file that cannot be read.
    """
    if not folder.is_dir():
        what = "a file" if folder.exists() else "no such folder"
        raise InputError(f"{folder}: need a folder that forficula wrote, got {what}")
    if (folder / OPTIMUM_FILE).is_file():
        raise InputError(
            f"{folder}: holds a search, whose figures are in its folder {COPIES}; or take the search itself"
        )
    drawings: dict[str, Drawing] = {}
    for name, read in _READERS.items():
        if (folder / name).is_file():
            drawings |= read(folder)
    if not drawings:
        names = ", ".join([*_READERS, _MATERIAL])
        raise InputError(f"{folder}: need a folder that forficula wrote, with one of {names} in it")
    return drawings


def _run(folder: Path) -> dict[str, Drawing]:
    record = read_run(folder)
    return run_drawings(record, measure(record))


def _cycling(folder: Path) -> dict[str, Drawing]:
    return cycling_drawings(read_cycling(folder))


def _study(folder: Path) -> dict[str, Drawing]:
    return study_drawings(_table(folder / "table.nc"))


def _identified(folder: Path) -> dict[str, Drawing]:
    return identify_drawings(_dataset(folder / IDENTIFIED))


def _tolerance(folder: Path) -> dict[str, Drawing]:
    return tolerance_drawings(_dataset(folder / TOLERANCE_TABLE))


def _static_map(folder: Path) -> dict[str, Drawing]:
    simulated = folder / SIMULATED
    return static_map_drawings(_table(folder / "map.nc"), _table(simulated) if simulated.is_file() else None)


def _parts(folder: Path) -> dict[str, Drawing]:
    return parts_drawings(read_parts(folder), read_checks(folder))


def _convergence(folder: Path) -> dict[str, Drawing]:
    return convergence_drawings(load_convergence(folder / CONVERGENCE_FILE))


def _assumptions(folder: Path) -> dict[str, Drawing]:
    return assumptions_drawings(load_assumptions(folder / ASSUMPTIONS_FILE))


def _landscape(folder: Path) -> dict[str, Drawing]:
    """The landscape is surveyed again when a figure is drawn: that takes a second, and all of it in a file many MB."""
    design = load_design(str(folder / "design.toml"))
    try:
        written = json.loads((folder / "landscape.json").read_text("utf-8"))
        simulated, kinds = written["simulation"] is not None, list(map(str, written["figures"]))
    except (OSError, LookupError, ValueError, TypeError) as error:
        raise InputError(f"{folder / 'landscape.json'}: not a landscape of forficula: {error}") from None

    @cache
    def again(simulation: bool) -> dict[str, Drawing]:
        return landscape_drawings(*landscape_and_run(design, simulation=simulation), shown_tendon(design))

    def drawing(kind: str) -> Drawing:
        # only the tendon's figure has the run beside it
        def draw(width: float) -> Figure:
            return again(simulated and kind == "tendon")[kind](width)

        return draw

    return {kind: drawing(kind) for kind in kinds}


_READERS: dict[str, Callable[[Path], dict[str, Drawing]]] = {
    "record.nc": _run,
    "cycles.json": _cycling,
    "table.nc": _study,
    "landscape.json": _landscape,
    "map.nc": _static_map,
    BILL_FILE: _parts,
    CONVERGENCE_FILE: _convergence,
    ASSUMPTIONS_FILE: _assumptions,
    IDENTIFIED: _identified,
    TOLERANCE_TABLE: _tolerance,
}


def _table(path: Path) -> Dataset:
    table = _dataset(path)
    check_table(table, path, _AGAIN[path.name])
    return table


def _dataset(path: Path) -> Dataset:
    import xarray

    try:
        return xarray.load_dataset(path, engine="h5netcdf")
    except (OSError, ValueError) as error:
        raise InputError(f"{path}: cannot be read: {' '.join(str(error).split())}") from None


def _copy(folder: Path, kind: str, path: Path, width: float | None, why: str) -> None:
    """Hand out a figure as it was written."""
    kept = {file.stem for file in (folder / COPIES).glob("*.svg")}
    name = _known(kind, kept, folder)
    own = PAGE_WIDTH if path.suffix == ".png" else COLUMN_WIDTH
    if width is not None and width != own:
        there = "page" if path.suffix == ".png" else "column"
        raise InputError(f"--width: the figures of {why}: its {path.suffix} is as wide as a {there}")
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
