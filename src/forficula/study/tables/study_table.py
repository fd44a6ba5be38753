"""Table of a study for notebooks. Only modules that build tables import this one, because xarray is slow to load."""

from __future__ import annotations

import xarray

from forficula.errors import InputError
from forficula.results import Result
from forficula.study.study import Study


class StudyTable(Result, xarray.Dataset):  # type: ignore[no-untyped-call]
    """An `xarray.Dataset` that displays its maps above its numbers.

    Attributes:
        study: study whose points are the rows. Parts of a table and tables read from a file lack it.
    """

    __slots__ = ("study",)
    study: Study


def study_of_table(table: object) -> Study:
    """Return the study whose points are the rows of a table.

    Raises:
        InputError: the table is a part of one, or was read from a file.
    """
    study = getattr(table, "study", None)
    if not isinstance(study, Study):
        raise InputError(
            "need the whole table of a study as run_study or collect returns it; parts of it and tables that were read"
            " from a file have no study; run_study returns the table of its folder without new runs"
        )
    return study
