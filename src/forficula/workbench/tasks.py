"""Tasks of a workbench, as a worker process runs them."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from forficula.analysis import measure
from forficula.reproduction import shown_tendon
from forficula.show.folder.landscape_folder import write_landscape
from forficula.show.folder.run_folder import write_run
from forficula.statics import energy_landscape
from forficula.study.running.law_timestep import with_timestep_for_law
from forficula.study.running.runs import run
from forficula.workbench.fold_responses import FoldResponses
from forficula.workbench.requests import DesignRequest, DragRequest, FoldRequest, Opened, PageRequest, requested_design
from forficula.workbench.responses import design_response, model_response, pattern_response
from forficula.workbench.trace_requests import (
    DrawnPatternRequest,
    PictureRequest,
    ScaleRequest,
    StraightenRequest,
    TraceRequest,
)
from forficula.workbench.trace_responses import (
    drawn_pattern_response,
    junctions_response,
    scale_response,
    straightened_response,
    trace_response,
)
from forficula.workbench.worker import Report, Task


def task_result(
    task: Task, request: PageRequest, opened: Opened, folder: Path, folds: FoldResponses, report: Report
) -> Any:
    """Return the result of a task; None if the result is in the folder, or was reported in parts.

    Args:
        task: the task.
        request: the request of the page.
        opened: design with which the workbench was opened.
        folder: folder for results that are files.
        folds: fold paths that this process has computed.
        report: receives descriptions of the progress, or parts of the result.

    Raises:
        InputError: the design or the picture cannot be read or built, or the task refuses it.
    """
    match request:
        case StraightenRequest():
            return straightened_response(request, opened)
        case DrawnPatternRequest():
            return drawn_pattern_response(request, opened)
        case ScaleRequest():
            return scale_response(request)
        case TraceRequest():
            return trace_response(request)
        case PictureRequest():
            return junctions_response(request)
    assert isinstance(request, DesignRequest)
    match task:
        case "design":
            return design_response(request, opened)
        case "model":
            return model_response(request, opened)
        case "pattern":
            return pattern_response(request, opened)
        case "landscape":
            _write_landscape(request, opened, folder, report)
        case "run":
            _write_run(request, opened, folder, report)
        case "fold":
            assert isinstance(request, FoldRequest)
            folds.follow(request, opened, report)
        case "drag":
            assert isinstance(request, DragRequest)
            return folds.drag(request)
    return None


def _write_landscape(request: DesignRequest, opened: Opened, folder: Path, report: Report) -> None:
    """Compute the energy landscape of a design, as `forficula landscape --no-simulation` does, and write its results.

    Raises:
        InputError: the design cannot be read or built.
    """
    design = requested_design(request, opened)
    report("building the structure")
    landscape = energy_landscape(design, progress=lambda step: report(f"surveying: {step}"))
    report("drawing")
    write_landscape(landscape, folder, None, shown_tendon(design))


def _write_run(request: DesignRequest, opened: Opened, folder: Path, report: Report) -> None:
    """Simulate a design through its protocol, as `forficula run` does, and write its results.

    Raises:
        InputError: the design cannot be read or built.
    """
    design = with_timestep_for_law(requested_design(request, opened))
    report("building the structure")
    record = run(
        design,
        lambda stage, time, longest: report(f"{stage}: {time:.3g} s of at most {longest:.3g} s simulated"),
        confirm=True,
    )
    report("drawing")
    write_run(record, measure(record), folder, engine=False)
