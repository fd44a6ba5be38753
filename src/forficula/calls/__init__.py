"""The Python interface: one call for everything that a command does.

In the examples, `ff` is forficula, `design` is `ff.load_design("letter-fold")`, and `result` a run of it.
"""

from forficula.calls.designs import Examples, check_design, examples
from forficula.calls.goals import identify, optimise, tolerance
from forficula.calls.output import compare, export, figure, film, page, save
from forficula.calls.patterns import pattern_facts, trace, trace_clicks
from forficula.calls.progress import Progress
from forficula.calls.runs import landscape, load_run, quasi_static_path, run
from forficula.calls.studies import (
    assumptions,
    collect,
    converge,
    estimate,
    new_study,
    run_cycles,
    run_study,
    study_status,
    sweep,
)

__all__ = [
    "Examples",
    "Progress",
    "assumptions",
    "check_design",
    "collect",
    "compare",
    "converge",
    "estimate",
    "examples",
    "export",
    "figure",
    "film",
    "identify",
    "landscape",
    "load_run",
    "new_study",
    "optimise",
    "page",
    "pattern_facts",
    "quasi_static_path",
    "run",
    "run_cycles",
    "run_study",
    "save",
    "study_status",
    "sweep",
    "tolerance",
    "trace",
    "trace_clicks",
]
