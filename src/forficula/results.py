"""Kinds of results: the file by which a folder is recognised, and the module that presents results of the kind.

A new kind of result is one entry here and one module of `forficula.show.folder` with a `PRESENTATION`. Importing this
module loads none of them.
"""

from __future__ import annotations

import json
from dataclasses import dataclass
from importlib import import_module
from pathlib import Path
from typing import Any

from forficula.errors import InputError
from forficula.names import one_of
from forficula.quantities import as_written
from forficula.serial import schema_of


@dataclass(frozen=True, kw_only=True)
class ResultKind:
    """A kind of results.

    Attributes:
        name: in messages, such as "convergence study".
        module: of `forficula.show.folder`, whose `PRESENTATION` draws and writes it.
        classes: names of the classes of its results.
        data: file in its folder from which its figures are drawn again.
        json: name of its JSON and of the schema of that; the file in the folder, where there is one, ends with ".json".
        shape: the data class that `forficula.serial` writes as this JSON, as "module:class".
        marker: file in its folder that only this kind has; empty where it is an addition to the folder of another kind.
        named_by: key of the marker, a JSON file, whose value names the result.
        verdict: key of the marker that has the verdict; empty where it has none.
        has_rows: whether a journal of rows may be in its folder before it is done.
        covers: kinds whose files are part of its folder, too.
    """

    name: str
    module: str
    classes: tuple[str, ...]
    data: str
    json: str = ""
    shape: str = ""
    marker: str = ""
    named_by: str = "design"
    verdict: str = ""
    has_rows: bool = False
    covers: tuple[str, ...] = ()


KINDS: tuple[ResultKind, ...] = (
    ResultKind(
        name="run",
        module="run_folder",
        classes=("Record",),
        data="record.nc",
        json="summary",
        shape="forficula.analysis.summary:Summary",
        marker="summary.json",
        verdict="status",
    ),
    ResultKind(
        name="cycles",
        module="cycling_folder",
        classes=("Cycling",),
        data="cycles.json",
        json="cycles",
        shape="forficula.show.folder.cycling_folder:CyclingSummary",
    ),
    ResultKind(
        name="landscape",
        module="landscape_folder",
        classes=("EnergyLandscape",),
        data="landscape.json",
        json="landscape",
        shape="forficula.statics.landscape_summary:LandscapeSummary",
        marker="landscape.json",
    ),
    ResultKind(name="static map", module="static_map_folder", classes=(), data="map.nc"),
    ResultKind(
        name="convergence study",
        module="convergence_folder",
        classes=("Convergence",),
        data="convergence.nc",
        json="convergence",
        shape="forficula.show.folder.convergence_folder:ConvergenceSummary",
        marker="convergence.json",
        verdict="verdict",
    ),
    ResultKind(
        name="table of assumptions",
        module="assumptions_folder",
        classes=("Assumptions",),
        data="assumptions.json",
        json="assumptions",
        shape="forficula.study.assumptions.assumptions:Assumptions",
        marker="assumptions.json",
        verdict="verdict",
    ),
    ResultKind(
        name="material",
        module="material_folder",
        classes=("Characterisation",),
        data="material.json",
        json="material",
        shape="forficula.material.characterisation:Characterisation",
        marker="material.json",
        named_by="material",
    ),
    ResultKind(name="bill of parts", module="parts_folder", classes=("PartSet",), data="bill.json", marker="bill.json"),
    ResultKind(
        name="optimisation",
        module="optimum_folder",
        classes=("Optimum",),
        data="optimum.json",
        json="optimum",
        shape="forficula.show.folder.optimum_folder:OptimumSummary",
        marker="optimum.json",
        named_by="goal",
        has_rows=True,
        covers=("study",),
    ),
    ResultKind(
        name="tolerance",
        module="tolerance_folder",
        classes=("ToleranceTable",),
        data="tolerance.nc",
        json="tolerance",
        shape="forficula.show.folder.tolerance_folder:ToleranceSummary",
        marker="tolerance.json",
        has_rows=True,
    ),
    ResultKind(
        name="identification",
        module="identify_folder",
        classes=("IdentificationTable",),
        data="identified.nc",
        json="identified",
        shape="forficula.show.folder.identify_folder:IdentificationSummary",
        marker="identified.json",
        named_by="name",
        has_rows=True,
    ),
    ResultKind(
        name="study",
        module="study_folder",
        classes=("StudyTable",),
        data="table.nc",
        json="row",
        shape="forficula.study.tables.table:TableRow",
        marker="table.nc",
        has_rows=True,
    ),
)
# rows of a study or a search that is not done; the command that continues it checks whose they are
_ROWS = "journal*.jsonl"


def json_schema(name: str) -> dict[str, Any]:
    """Return the JSON schema (draft 2020-12) of the JSON that commands write to a folder and print with `--json`.

    Args:
        name: "summary" of a run, "landscape", "row" of a study, "assumptions", or that of another kind of results.

    Raises:
        InputError: another name.

    >>> sorted(ff.json_schema("row")["required"])
    ['status', 'verdict']
    """
    shapes = {kind.json: kind.shape for kind in KINDS if kind.shape}
    if name not in shapes:
        raise InputError(f"need {one_of(shapes, name)}")
    module, _, shape = shapes[name].partition(":")
    return schema_of(getattr(import_module(module), shape), name)


def json_file(kind: str) -> str:
    """Return the name of the file in a folder that has the JSON of a kind of results."""
    return f"{_named(kind).json}.json"


def kind_of_class(name: str) -> ResultKind | None:
    """Find the kind of the results of a class by the name of the class; None where there is none."""
    return next((kind for kind in KINDS if name in kind.classes), None)


def kinds_in(folder: Path) -> list[ResultKind]:
    """List the kinds of the results in a folder, by the files from which their figures are drawn."""
    return _uncovered([kind for kind in KINDS if (folder / kind.data).is_file()])


def check_own_kind(folder: Path, own: str) -> None:
    """Refuse a folder with results of another kind, whose pages, figures and tables would be replaced.

    Args:
        folder: where results will be written.
        own: name of their kind.

    Raises:
        InputError: what the folder holds.
    """
    there = _uncovered([kind for kind in KINDS if kind.marker and (folder / kind.marker).is_file()])
    if any(kind.name == own for kind in there):
        return
    if there:
        first = there[0]
        article = "an" if first.name[0] in "aeiou" else "a"
        raise InputError(
            f"need a folder of its own, got {folder}, which holds {article} {first.name} ({first.marker}), whose"
            " page and figures would be replaced; name another one"
        )
    if not _named(own).has_rows and any(folder.glob(_ROWS)):
        raise InputError(
            f"need a folder of its own, got {folder}, which holds rows of a study ({next(folder.glob(_ROWS)).name});"
            " name another one"
        )


def replaced_text(folder: Path, own: str) -> str:
    """Describe the earlier results of a kind in a folder, such as "the run of my-wing (folded)"; empty without any."""
    kind = _named(own)
    try:
        text = (folder / kind.marker).read_text("utf-8")
    except (OSError, ValueError):
        return ""
    try:
        content = json.loads(text)
        called = as_written(content[kind.named_by]).strip('"')
        how = f" ({as_written(content[kind.verdict])})" if kind.verdict else ""
    except (ValueError, LookupError, TypeError, RecursionError):
        called, how = "an unknown name", ""
    return f"the {kind.name} of {called}{how}"


def _named(name: str) -> ResultKind:
    return next(kind for kind in KINDS if kind.name == name)


def _uncovered(kinds: list[ResultKind]) -> list[ResultKind]:
    covered = {name for kind in kinds for name in kind.covers}
    return [kind for kind in kinds if kind.name not in covered]
