"""Files and printed lines of a static map."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from forficula.design import Design
from forficula.errors import InputError
from forficula.files import replacing_all, write_bytes, write_text
from forficula.show.folder.notebook_cell import first_figure
from forficula.show.folder.presentation import Presentation, read_dataset
from forficula.show.page.parts.html import paragraph, section
from forficula.show.page.results_page import figure_html, read_page, with_section
from forficula.show.study.static_maps import draw_static_maps
from forficula.show.style import PAGE_WIDTH, Drawing, save_figures
from forficula.structure import structure_of
from forficula.study import Study, table_csv
from forficula.study.tables.map_comparison import compare_maps
from forficula.study.tables.outcome_kinds import check_table, least_values, lost_text, table_transitions

if TYPE_CHECKING:
    from xarray import Dataset

# table of the simulated study beside the map, kept so that the figure can be drawn again
SIMULATED = "simulated.nc"


def read_simulated(folder: Path, design: Design) -> Dataset:
    """Read the table of a study of a design.

    Raises:
        InputError: there is no table, or it is of another design.
    """
    import xarray

    path = folder / "table.nc"
    try:
        table = xarray.load_dataset(path, engine="h5netcdf")
    except FileNotFoundError:
        raise InputError(f"--simulated: {path}: no such file; need the folder of a finished study") from None
    except (OSError, ValueError) as error:
        raise InputError(f"--simulated: {path}: cannot be read: {error}") from None
    check_table(table, path, "forficula study …")
    if table.attrs.get("design_hash") != design.hash:
        theirs = table.attrs.get("design", "no design")
        raise InputError(
            f"--simulated: {path}: need a study of the design {design.name} with the same values,"
            f" got one of {theirs} with others"
        )
    return table


def write_static_map(study: Study, table: Dataset, folder: Path, simulated: Dataset | None = None) -> None:
    """Write the map as a table and as a figure, and show it on the landscape's page; all of it, or nothing.

    Args:
        study: the grid.
        table: from `static_map`.
        folder: folder of the landscape; files of an earlier map are replaced.
        simulated: table of a simulated study with the same factors, drawn beside the map.

    Raises:
        InputError: a file cannot be written, or the two tables have different factors.
    """
    drawings = static_map_drawings(table, simulated)
    drawings["map"](PAGE_WIDTH)  # drawn before anything is written: the two tables may not fit
    with replacing_all(folder, remove=(SIMULATED,)) as unfinished:
        write_text(unfinished / "map.csv", table_csv(study, table))
        write_bytes(unfinished / "map.nc", table.to_netcdf(engine="h5netcdf"))
        if simulated is not None:
            write_bytes(unfinished / SIMULATED, simulated.to_netcdf(engine="h5netcdf"))
        texts = save_figures(drawings, unfinished)
        if (page := read_page(folder)) is not None:
            sentences = static_map_sentences(table, structure_of(study.base).appearance.whole, simulated)
            words = [paragraph(f"{sentence}.") for sentence in sentences]
            made = section("Map", figure_html(unfinished, "map", texts["map"]), *words, name="map")
            write_text(unfinished / "report.html", with_section(page, "map", made))


def static_map_drawings(table: Dataset, simulated: Dataset | None = None) -> dict[str, Drawing]:
    """Return the drawings of a static map by the stems of their files."""
    return {"map": lambda width: draw_static_maps(table, simulated, width)}


def print_static_map(table: Dataset, whole: str, simulated: Dataset | None = None) -> None:
    """Print how many structures complete each transition quasi-statically, and where a simulation differs."""
    print()
    for sentence in static_map_sentences(table, whole, simulated):
        first, *rest = sentence.split("; compared with the simulation: ")
        print(first, *(f"    compared with the simulation: {entry}" for entry in rest), sep="\n")


def static_map_sentences(table: Dataset, whole: str, simulated: Dataset | None = None) -> list[str]:
    """Return sentences with the number of structures that complete each transition quasi-statically.

    Args:
        table: from `static_map`.
        whole: noun for the structure.
        simulated: table of a simulated study with the same factors, to compare with.
    """
    count, sentences = table["outcome"].size, []
    for transition in table_transitions(table):
        if transition.least not in table:
            continue
        made = len(least_values(table, transition))
        sentences.append(
            f"{made} of {count} {whole}s {transition.wording.verb} under slowly growing torques"
            + lost_text(table, transition)
        )
        if simulated is not None:
            words, numbers = np.unique(
                compare_maps(table, simulated, transition.least).values.astype(str), return_counts=True
            )
            parts = [f"{number} {word}" for word, number in zip(words.tolist(), numbers.tolist(), strict=True)]
            sentences[-1] += f"; compared with the simulation: {', '.join(parts)}"
    return sentences


def _read(folder: Path) -> dict[str, Drawing]:
    tables = []
    for name in ("map.nc", SIMULATED):
        if (folder / name).is_file():
            tables.append(read_dataset(folder / name))
            check_table(tables[-1], folder / name, "forficula landscape …")
    return static_map_drawings(*tables)


def _cell(table: Dataset) -> Iterator[str]:
    yield first_figure(static_map_drawings(table))


PRESENTATION = Presentation(drawings=static_map_drawings, cell=_cell, read=_read)
