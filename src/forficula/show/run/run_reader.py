"""Runs read back from the folders that they left."""

from __future__ import annotations

from pathlib import Path

from forficula.dynamics import Record, load_record
from forficula.errors import InputError
from forficula.files import clear_leftovers


def read_run(folder: Path) -> Record:
    """Read the record of a run from its folder.

    Raises:
        InputError: there is no such folder, it holds no run, or the record cannot be read.
    """
    if not folder.is_dir():
        what = "a file" if folder.exists() else "no such folder"
        raise InputError(f"{folder}: need the folder of a run, as forficula run writes it, got {what}")
    clear_leftovers(folder)  # a run that was killed may have set the record aside
    path = folder / "record.nc"
    if not path.is_file():
        raise InputError(f"{folder}: holds no run: record.nc is missing; write it with forficula run --out {folder}")
    return load_record(path)
