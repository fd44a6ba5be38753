"""The files of a run: its design, its record and the summary of its outcome."""

from __future__ import annotations

import json
import re
from pathlib import Path

from forficula.analysis.outcome import Outcome
from forficula.analysis.summary import summary
from forficula.design import design_text
from forficula.dynamics import Record, load_record, save_record, versions
from forficula.errors import InputError
from forficula.files import clear_leftovers, write_text
from forficula.serial import json_text
from forficula.toml_text import with_remarks

# remark on a time constant of contact
_DERIVED = 'derived by the run; "auto" derives it again'
_DESIGN, _RECORD, _SUMMARY = "design.toml", "record.nc", "summary.json"


def write_run_files(
    record: Record, outcome: Outcome, folder: Path, *, kept: Record | None = None, key: str | None = None
) -> None:
    """Write design, record and summary of a run, one after another.

    To write all files or none, pass a folder of `replacing_all`.

    Args:
        record: of the run.
        outcome: of the run.
        folder: existing folder.
        kept: thinned record to write instead of the full one; the summary is always of all rows.
        key: of the run among those of a study, to be written into the summary.

    Raises:
        InputError: a file cannot be written.
    """
    write_text(folder / _DESIGN, _design_file(record))
    save_record(record if kept is None else kept, folder / _RECORD)
    write_text(folder / _SUMMARY, json_text(summary(record, outcome, versions(record.design.protocol.device), key)))


def _design_file(record: Record) -> str:
    """Return the design file of a run; a time constant of contact that the run derived is marked."""
    text = design_text(record.design)
    if not record.contact_runs:
        return text
    sections = re.findall(r"^\[((?:.+\.)?contact)\]$", text, re.MULTILINE)
    return with_remarks(text, {f"{section}.time_constant": _DERIVED for section in sections})


def read_run(folder: Path) -> Record:
    """Read the record of a run from its folder.

    Raises:
        InputError: there is no such folder, it holds no run, or the record cannot be read.
    """
    if not folder.is_dir():
        what = "a file" if folder.exists() else "no such folder"
        raise InputError(f"{folder}: need the folder of a run, as forficula run writes it, got {what}")
    clear_leftovers(folder)  # a killed run may have moved the record to a temporary name
    path = folder / _RECORD
    if not path.is_file():
        raise InputError(f"{folder}: holds no run: {_RECORD} is missing; write it with forficula run --out {folder}")
    return load_record(path)


def holds_run(folder: Path, key: str) -> bool:
    """Return whether a folder contains the run with this key, written by the present versions."""
    try:
        written = json.loads((folder / _SUMMARY).read_text("utf-8"))
        # the versions of the device's packages, if there are any, follow
        same = written["key"] == key and versions().items() <= written["versions"].items()
        return same and (folder / _RECORD).is_file()
    except (OSError, ValueError, LookupError, TypeError):
        return False


def remove_run(folder: Path) -> None:
    """Remove the files of a run, if there is one; other files in the folder stay."""
    if (folder / _SUMMARY).is_file():
        for name in (_DESIGN, _RECORD, _SUMMARY):  # summary last: it marks a folder as one of a run
            (folder / name).unlink(missing_ok=True)
