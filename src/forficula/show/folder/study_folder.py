"""Files of a study, in addition to its rows."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import TYPE_CHECKING

from forficula.files import replacing_all, write_text
from forficula.reproduction import compare
from forficula.reproduction.comparison import comparison_markdown
from forficula.serial import json_text
from forficula.show.folder.notebook_cell import first_figure, numbers
from forficula.show.folder.presentation import Presentation, read_dataset
from forficula.show.page.study_page import write_study_page
from forficula.show.study.changes_figure import change_drawings
from forficula.show.study.choices_figure import draw_choices
from forficula.show.study.maps import map_drawings
from forficula.show.style import Drawing, save_figures
from forficula.study import Study
from forficula.study.assumptions.choices import CHOICE
from forficula.study.changes import CHANGE
from forficula.study.running.kept_runs import KeptRun
from forficula.study.tables.outcome_kinds import check_table
from forficula.study.tables.table_files import write_csv, write_netcdf, write_parquet

if TYPE_CHECKING:
    from xarray import Dataset


_PARQUET = "table.parquet"


def study_drawings(table: Dataset) -> dict[str, Drawing]:
    """Return the drawings for which a study's table has the numbers.

    Returns:
        Drawings by the stems of their files.
    """
    if CHANGE in table.dims:
        return change_drawings(table)
    if CHOICE not in table.dims:
        return map_drawings(table)
    side_by_side: dict[str, Drawing] = {"choices": lambda width: draw_choices(table, width=width)}
    # without a grid there is no map
    return side_by_side | (map_drawings(table) if table["status"].ndim > 1 else {})


def write_study(study: Study, table: Dataset, folder: Path, *, parquet: bool = False) -> None:
    """Write the table, the maps and, if the study names a paper, a comparison with its claims; all of them, or none.

    Args:
        study: the study.
        table: its results.
        folder: folder of the study; files of an earlier table are replaced.
        parquet: whether to write the table as Parquet, too.

    Raises:
        InputError: a file cannot be written.
    """
    with replacing_all(folder, () if parquet else (_PARQUET,)) as unfinished:
        _write_files(study, table, unfinished, parquet=parquet)


def _write_files(study: Study, table: Dataset, folder: Path, *, parquet: bool) -> None:
    write_csv(study, table, folder / "table.csv")
    write_netcdf(table, folder / "table.nc")
    if parquet:
        write_parquet(study, table, folder / _PARQUET)
    save_figures(study_drawings(table), folder)
    compared = compare(study, table)
    if compared is not None:
        write_text(folder / "comparison.md", comparison_markdown(compared))
        write_text(folder / "comparison.json", json_text(compared.claims))


def write_study_report(
    study: Study, table: Dataset, kept: Iterable[KeptRun], count: int, folder: Path, *, engine: bool = True
) -> None:
    """Write the page of a study, `report.html`.

    Args:
        study: the study.
        table: its results.
        kept: runs to play back, read one after another.
        count: number of these runs.
        folder: folder of the study.
        engine: whether the page contains the simulator, which simulates points whose runs were not kept.

    Raises:
        InputError: it cannot be written.
    """
    write_study_page(study, table, folder / "report.html", kept, count, compare(study, table), engine=engine)


def _read(folder: Path) -> dict[str, Drawing]:
    table = read_dataset(folder / "table.nc")
    check_table(table, folder / "table.nc", "forficula study …")
    return study_drawings(table)


def _cell(table: Dataset) -> Iterator[str]:
    yield first_figure(study_drawings(table))
    yield numbers(table)


def _write(table: Dataset, folder: Path) -> None:
    """Write a table without kept runs: its page plays none."""
    from forficula.study.tables.study_table import study_of_table

    study = study_of_table(table)
    write_study(study, table, folder)
    write_study_report(study, table, (), 0, folder)


def _write_page(table: Dataset, path: Path, engine: bool) -> None:
    from forficula.study.tables.study_table import study_of_table

    study = study_of_table(table)
    write_study_page(study, table, path, (), 0, compare(study, table), engine=engine)


PRESENTATION = Presentation(drawings=study_drawings, cell=_cell, read=_read, write=_write, page=_write_page)
