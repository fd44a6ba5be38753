"""Assumptions of a design as JSON, and those that are known of a design without a run."""

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
# of the folder beside that of a run in which the command leaves its results
FOLDER_ENDING = "-assumptions"


def save_assumptions(found: Assumptions, path: Path) -> None:
    """Write assumptions as JSON.

    Raises:
        InputError: the file cannot be written.
    """
    write_text(path, json_text(found))


def load_assumptions(path: Path) -> Assumptions:
    """Read what `save_assumptions` wrote.

    Raises:
        InputError: it cannot be read, or is none.
    """
    try:
        return _assumptions(path.read_text("utf-8"))
    except (OSError, LookupError, ValueError, TypeError, AttributeError, RecursionError) as error:
        why = " ".join(str(error).split())
        raise InputError(f"{path}: not a table of assumptions of forficula: {why}") from None


def known_assumptions(design: Design, folder: Path) -> tuple[Assumptions, str] | None:
    """Return what is known of the assumptions of a design, and where from; None where nothing is.

    Known is what `forficula assumptions` left in the folder of a run or beside it, and what comes with the package. It
    counts for a design with the same values only.

    Args:
        design: that was run.
        folder: of the run.
    """
    places = (folder, folder.with_name(f"{folder.name}{FOLDER_ENDING}"))
    for place in places:
        if (place / ASSUMPTIONS_FILE).is_file():
            try:
                found = load_assumptions(place / ASSUMPTIONS_FILE)
            except InputError:  # another file of that name
                continue
            if found.design.hash == design.hash:
                return found, str(place)
    for measured in measured_assumptions():
        if measured.design.hash == design.hash:
            return measured, f"measured with forficula {measured.versions['forficula']}"
    return None


def measured_assumptions() -> Iterator[Assumptions]:
    """Yield the assumptions of named designs that come with the package."""
    for entry in sorted(resources.files("forficula.study").joinpath("measured").iterdir(), key=lambda each: each.name):
        if entry.name.endswith(".json"):
            yield _assumptions(entry.read_text("utf-8"))


def known_text(found: Assumptions, source: str) -> str:
    """Return which assumptions decide a result, in a sentence, as a run prints it."""
    tried = counted(len(found.runs), "changed assumption")
    if not found.deciding:
        return f"Assumptions: none of {tried} changes the verdict ({source})."
    changes = ", ".join(f"{run.label} ({run.word})" for run in found.deciding)
    return f"Assumptions that decide the verdict, {len(found.deciding)} of {tried}: {changes} ({source})."


def _assumptions(text: str) -> Assumptions:
    content = json.loads(text)
    return Assumptions(
        design=design_from_text(content["design_file"]),
        transitions=tuple(TransitionName(**each) for each in content["transitions"]),
        own=_run(content["own"]),
        runs=tuple(_run(each) for each in content["runs"]),
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
