"""What every command does, as one call: designs by name or path in, records, tables, figures and files out.

In the examples, `ff` is forficula, `design` is `ff.load_design("letter-fold")`, and `record` a run of it.
"""

from forficula.calls.goals import identify, optimise, tolerance
from forficula.calls.patterns import pattern_facts
from forficula.calls.runs import landscape, run
from forficula.calls.shown import compare, figure, film, page, save
from forficula.calls.studies import assumptions, converge, new_study

__all__ = [
    "assumptions",
    "compare",
    "converge",
    "figure",
    "film",
    "identify",
    "landscape",
    "new_study",
    "optimise",
    "page",
    "pattern_facts",
    "run",
    "save",
    "tolerance",
]
