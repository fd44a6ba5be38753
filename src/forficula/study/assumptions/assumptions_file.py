"""Assumptions of a design as JSON, and results that are known without a run."""

from __future__ import annotations

import json
from collections.abc import Iterator
from importlib import resources
from pathlib import Path
from typing import Any

from forficula.analysis import Verdict
from forficula.design import Design, design_from_text
from forficula.errors import InputError
from forficula.files import write_text
from forficula.names import counted
from forficula.serial import json_text
from forficula.study.assumptions.assumptions import AssumptionRun, Assumptions, Effect, TransitionName

ASSUMPTIONS_FILE = "assumptions.json"
# ending of the folder beside that of a run, into which the command writes its results
FOLDER_ENDING = "-assumptions"


def save_assumptions(assumptions: Assumptions, path: Path) -> None:
    """Write assumptions as JSON.

    Raises:
        InputError: the file cannot be written.
    """
    write_text(path, json_text(assumptions))


def load_assumptions(path: Path) -> Assumptions:
    """Read a file that `save_assumptions` wrote.

    Raises:
        InputError: the file cannot be read, or contains no assumptions.
    """
    try:
        return _assumptions(path.read_text("utf-8"))
    except (OSError, LookupError, ValueError, TypeError, AttributeError, RecursionError) as error:
        why = " ".join(str(error).split())
        raise InputError(f"{path}: not a table of assumptions of forficula: {why}") from None


def known_assumptions(design: Design, folder: Path) -> tuple[Assumptions, str] | None:
    """Return the known assumptions of a design and their source; None if nothing is known.

    Sources are the results of `forficula assumptions` in the folder of a run or beside it, and files of the package.
    Only results of a design with the same values are used.

    Args:
        design: the design of the run.
        folder: folder of the run.
    """
    folders = (folder, folder.with_name(f"{folder.name}{FOLDER_ENDING}"))
    for candidate in folders:
        if (candidate / ASSUMPTIONS_FILE).is_file():
            try:
                assumptions = load_assumptions(candidate / ASSUMPTIONS_FILE)
            except InputError:  # another file with this name
                continue
            if assumptions.design.hash == design.hash:
                return assumptions, str(candidate)
    for measured in measured_assumptions():
        if measured.design.hash == design.hash:
            return measured, f"measured with forficula {measured.versions['forficula']}"
    return None


def measured_assumptions() -> Iterator[Assumptions]:
    """Yield the assumptions of named designs that come with the package."""
    for entry in sorted(resources.files("forficula.study").joinpath("measured").iterdir(), key=lambda file: file.name):
        if entry.name.endswith(".json"):
            yield _assumptions(entry.read_text("utf-8"))


def known_text(assumptions: Assumptions, source: str) -> str:
    """Return a sentence that states which assumptions decide a result, as a run prints it."""
    tried = counted(len(assumptions.runs), "changed assumption")
    if not assumptions.deciding:
        return f"Assumptions: none of {tried} changes the verdict ({source})."
    changes = ", ".join(f"{run.label} ({run.word})" for run in assumptions.deciding)
    return f"Assumptions that decide the verdict, {len(assumptions.deciding)} of {tried}: {changes} ({source})."


def _assumptions(text: str) -> Assumptions:
    content = json.loads(text)
    return Assumptions(
        design=design_from_text(content["design_file"]),
        transitions=tuple(TransitionName(**entry) for entry in content["transitions"]),
        own=_run(content["own"]),
        runs=tuple(_run(entry) for entry in content["runs"]),
        left_out=dict(content["left_out"]),
        uncertainty={name.rpartition("_")[0]: float(half) for name, half in content["uncertainty"].items()},
        versions=dict(content["versions"]),
    )


def _run(content: dict[str, Any]) -> AssumptionRun:
    words = {key: str(content[key]) for key in ("name", "label", "meaning", "goal", "word", "status")}
    return AssumptionRun(
        **words,
        timestep=float(content["timestep_s"]),
        verdict=Verdict(content["verdict"]),
        times=dict(content["time_s"]),
        works=dict(content["work_J"]),
        effect=Effect(content["effect"]),
    )
