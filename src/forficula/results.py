"""Classes of results, the methods that they share, and their kinds: how each is recognised, drawn and written.

A new kind of result is one entry of `KINDS` and one module of `forficula.show.folder` with a `PRESENTATION`. Importing
this module loads none of them.
"""

from __future__ import annotations

import json
from dataclasses import dataclass
from importlib import import_module
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

from forficula.argument_checks import checked
from forficula.displayed import Displayed
from forficula.errors import InputError
from forficula.names import one_of
from forficula.optional_module import optional_module
from forficula.quantities import as_written
from forficula.serial import schema_of

# public classes of what functions return, by name; they are imported at first use
_CLASSES = {
    # runs
    "Record": "forficula.dynamics",
    "StageEnd": "forficula.dynamics",
    "NumericalCheck": "forficula.dynamics",
    "EnergyBalance": "forficula.dynamics",
    "State": "forficula.analysis",
    "Reading": "forficula.analysis",
    "TransitionOutcome": "forficula.analysis",
    "StageOutcome": "forficula.analysis",
    "Ending": "forficula.analysis",
    "Confirmation": "forficula.analysis.confirmation",
    "Advice": "forficula.analysis.advice",
    "Cycling": "forficula.study.cycling",
    "CycleRun": "forficula.study.cycling",
    # designs and structures
    "FanDesign": "forficula.design",
    "JointDesign": "forficula.design",
    "SheetDesign": "forficula.design",
    "Structure": "forficula.structure",
    "Examples": "forficula.calls",
    # energy landscapes
    "StableState": "forficula.statics",
    "NetState": "forficula.statics.net.net_state",
    "Rest": "forficula.statics",
    "Pass": "forficula.statics.landscape",
    "LeastTorque": "forficula.statics.landscape",
    "Course": "forficula.statics.net.driven.net_course",
    "CrossedHinge": "forficula.statics",
    "HingeLandscape": "forficula.statics",
    "QuasiStaticPath": "forficula.statics",
    "QuasiStaticPoint": "forficula.statics",
    "PathMark": "forficula.statics",
    # many runs
    "Assumptions": "forficula.study.assumptions.assumptions",
    "AssumptionRun": "forficula.study.assumptions.assumptions",
    "Convergence": "forficula.study.convergence.convergence",
    "StudyStatus": "forficula.study.running.study_status",
    "StudyTable": "forficula.study.tables.study_table",
    "ToleranceTable": "forficula.goals.tolerance.tolerance_table",
    "IdentificationTable": "forficula.goals.identify.result",
    "Optimum": "forficula.goals.optimise",
    "FanFit": "forficula.goals.clicks.fan_fit",
    "ObservedMotion": "forficula.goals.clicks.motion",
}
__all__ = ["Result", "json_schema", *_CLASSES]  # noqa: PLE0604


def __getattr__(name: str) -> Any:
    if name in _CLASSES:
        return getattr(import_module(_CLASSES[name]), name)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")


def __dir__() -> list[str]:
    return sorted(__all__)


if TYPE_CHECKING:
    import os

    from matplotlib.figure import Figure
    from pandas import DataFrame as DataFrame  # type: ignore[import-untyped]
    from pandas import Series as Series


class Result(Displayed):
    """Result of a computation: a notebook shows it, and its methods draw it and write it.

    The methods are the calls of `forficula.calls`, a layer above, by name.
    """

    __slots__ = ()

    def figure(self, name: str | None = None, *, width: float | Literal["column", "page"] = "column") -> Figure:
        """Draw a figure of this result.

        Args:
            name: name of the figure, as in its file in the folder that `save` writes; optional for a single one.
            width: of a journal's column or page, or a number in inches.

        Raises:
            InputError: no such figure or width.
        """
        figure: Figure = call("figure")(self, name, width=width)
        return figure

    def save(self, folder: str | os.PathLike[str]) -> None:
        """Write data, figures and page of this result to a folder, as its command does.

        Args:
            folder: created if it is missing; an earlier result of the same kind in it is replaced.

        Raises:
            InputError: the folder cannot be written or contains results of another kind.
        """
        call("save")(self, folder)

    def page(self, path: str | os.PathLike[str], *, engine: bool = True) -> None:
        """Write this result as one HTML file that opens in any browser without a network.

        Args:
            path: of the file; must end with .html.
            engine: whether the page of a run contains the simulator (3.5 MB).

        Raises:
            InputError: another ending, or the file cannot be written.
        """
        call("page")(self, path, engine=engine)


def pandas_module() -> Any:
    """Return pandas.

    Raises:
        InputError: it is not installed.
    """
    return optional_module("pandas", "tables of this kind need pandas", "pandas")


def call(name: str) -> Any:
    """Return a function of `forficula.calls`, a layer above, that checks its arguments."""
    return checked(getattr(import_module("forficula.calls"), name), name)


# name of the JSON in a folder
_JSON_FILE = "{json}.json"


@dataclass(frozen=True, kw_only=True)
class ResultKind:
    """Kind of results.

    Attributes:
        name: name in messages, such as "convergence study".
        module: module of `forficula.show.folder` whose `PRESENTATION` draws and writes these results.
        classes: names of their classes.
        json: name of the JSON and of its schema; the file in the folder, if there is one, is this name and ".json".
        shape: data class that `forficula.serial` writes as this JSON, as "module:class".
        data: file of the folder from which figures are drawn again; by default the JSON.
        marker: file of the folder that only this kind has, by default the JSON; empty if the kind is an addition to
            folders of another kind.
        named_by: key of the marker, a JSON file, whose value names the result.
        verdict: key of the marker that has the verdict; empty if there is none.
        has_rows: whether the folder may contain a journal of rows before the result is complete.
        covers: kinds whose files are also part of the folder.
    """

    name: str
    module: str
    classes: tuple[str, ...]
    json: str = ""
    shape: str = ""
    data: str = _JSON_FILE
    marker: str = _JSON_FILE
    named_by: str = "design"
    verdict: str = ""
    has_rows: bool = False
    covers: tuple[str, ...] = ()

    def __post_init__(self) -> None:
        for name in ("data", "marker"):
            object.__setattr__(self, name, getattr(self, name).format(json=self.json))


KINDS: tuple[ResultKind, ...] = (
    ResultKind(
        name="run",
        module="run_folder",
        classes=("Run", "Record"),
        json="summary",
        shape="forficula.analysis.summary:Summary",
        data="record.nc",
        verdict="status",
    ),
    ResultKind(
        name="cycles",
        module="cycling_folder",
        classes=("Cycling",),
        json="cycles",
        shape="forficula.show.folder.cycling_folder:CyclingSummary",
        marker="",
    ),
    ResultKind(
        name="landscape",
        module="landscape_folder",
        classes=("EnergyLandscape",),
        json="landscape",
        shape="forficula.statics.landscape_summary:LandscapeSummary",
    ),
    ResultKind(name="static map", module="static_map_folder", classes=(), data="map.nc", marker=""),
    ResultKind(
        name="convergence study",
        module="convergence_folder",
        classes=("Convergence",),
        json="convergence",
        shape="forficula.show.folder.convergence_folder:ConvergenceSummary",
        data="convergence.nc",
        verdict="verdict",
    ),
    ResultKind(
        name="table of assumptions",
        module="assumptions_folder",
        classes=("Assumptions",),
        json="assumptions",
        shape="forficula.study.assumptions.assumptions:Assumptions",
        verdict="verdict",
    ),
    ResultKind(
        name="material",
        module="material_folder",
        classes=("Characterisation",),
        json="material",
        shape="forficula.material.characterisation:Characterisation",
        named_by="material",
    ),
    ResultKind(
        name="trace",
        module="trace_folder",
        classes=("Trace",),
        json="trace",
        shape="forficula.pattern.picture.trace:Trace",
        named_by="name",
    ),
    ResultKind(
        name="law of creases",
        module="crease_folder",
        classes=("CreaseCharacterisation",),
        json="crease",
        shape="forficula.material.folding.crease_characterisation:CreaseCharacterisation",
        named_by="law_of_creases",
    ),
    ResultKind(
        name="fan fit",
        module="fan_fit_folder",
        classes=("FanFit",),
        json="fan",
        shape="forficula.goals.clicks.fan_fit:FanFit",
        named_by="name",
    ),
    ResultKind(
        name="observed motion",
        module="motion_folder",
        classes=("ObservedMotion",),
        json="motion",
        shape="forficula.goals.clicks.motion:ObservedMotion",
    ),
    ResultKind(name="bill of parts", module="parts_folder", classes=("PartSet",), data="bill.json", marker="bill.json"),
    ResultKind(
        name="optimisation",
        module="optimum_folder",
        classes=("Optimum",),
        json="optimum",
        shape="forficula.show.folder.optimum_folder:OptimumSummary",
        named_by="goal",
        has_rows=True,
        covers=("study",),
    ),
    ResultKind(
        name="tolerance",
        module="tolerance_folder",
        classes=("ToleranceTable",),
        json="tolerance",
        shape="forficula.show.folder.tolerance_folder:ToleranceSummary",
        data="tolerance.nc",
        has_rows=True,
    ),
    ResultKind(
        name="identification",
        module="identify_folder",
        classes=("IdentificationTable",),
        json="identified",
        shape="forficula.show.folder.identify_folder:IdentificationSummary",
        data="identified.nc",
        named_by="name",
        has_rows=True,
    ),
    ResultKind(
        name="study",
        module="study_folder",
        classes=("StudyTable",),
        json="row",
        shape="forficula.study.tables.table_rows:TableRow",
        data="table.nc",
        marker="table.nc",
        has_rows=True,
    ),
)
# rows of an unfinished study or search; the command that continues it checks to which study they belong
_ROWS = "journal*.jsonl"


def json_schema(name: str) -> dict[str, Any]:
    """Return the JSON schema (draft 2020-12) of the JSON that commands write to a folder and print with `--json`.

    Args:
        name: "summary" (of a run), "landscape", "row" (of a study), "assumptions", or the name of another kind.

    Raises:
        InputError: another name.

    >>> sorted(ff.results.json_schema("row")["required"])
    ['status', 'verdict']
    """
    shapes = {kind.json: kind.shape for kind in KINDS if kind.shape}
    if name not in shapes:
        raise InputError(f"need {one_of(shapes, name)}")
    module, _, shape = shapes[name].partition(":")
    return schema_of(getattr(import_module(module), shape), name)


def json_file(kind: str) -> str:
    """Return the name of the JSON file of a kind of results."""
    return f"{_named(kind).json}.json"


def kind_of_class(name: str) -> ResultKind | None:
    """Return the kind of results of a class, by the name of the class; None if it is no class of results."""
    return next((kind for kind in KINDS if name in kind.classes), None)


def kinds_in(folder: Path) -> list[ResultKind]:
    """List the kinds of results in a folder, recognised by the files from which figures are drawn."""
    return _uncovered([kind for kind in KINDS if (folder / kind.data).is_file()])


def check_own_kind(folder: Path, kind_name: str) -> None:
    """Refuse a folder with results of another kind, because their pages, figures and tables would be replaced.

    Args:
        folder: where results will be written.
        kind_name: name of their kind.

    Raises:
        InputError: the folder contains results of another kind.
    """
    present = _uncovered([kind for kind in KINDS if kind.marker and (folder / kind.marker).is_file()])
    if any(kind.name == kind_name for kind in present):
        return
    if present:
        first = present[0]
        article = "an" if first.name[0] in "aeiou" else "a"
        raise InputError(
            f"need a folder of its own, got {folder}, which holds {article} {first.name} ({first.marker}), whose"
            " page and figures would be replaced; name another one"
        )
    if not _named(kind_name).has_rows and any(folder.glob(_ROWS)):
        raise InputError(
            f"need a folder of its own, got {folder}, which holds rows of a study ({next(folder.glob(_ROWS)).name});"
            " name another one"
        )


def replaced_text(folder: Path, kind_name: str) -> str:
    """Describe the earlier results of a kind in a folder, such as "the run of my-wing (folded)"; empty without any."""
    kind = _named(kind_name)
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
    return [kind for kind in kinds if not any(kind.name in other.covers for other in kinds)]
