"""Assumptions of a design as rows and as text."""

from __future__ import annotations

from typing import Any

from rich.console import Console, Group, RenderableType
from rich.table import Table
from rich.text import Text

from forficula.quantities import show_uncertain, show_value
from forficula.study.assumptions.assumptions import AssumptionRun, Assumptions, Effect

_WIDTH = 140
# largest number of transitions whose times and works fit side by side
_MOST_WORKS = 2
_STYLES = {Effect.VERDICT: "red", Effect.UNKNOWN: "yellow", Effect.NUMBERS: "", Effect.NOTHING: "dim"}


def assumption_rows(results: Assumptions) -> list[dict[str, Any]]:
    """Return a row for every run, the unchanged design first: plain data with units in the keys, None for no value."""
    return [
        {
            "assumption": run.name,
            "change": run.label,
            "effect": "" if run is results.own else run.effect.value,
            "verdict": run.verdict.value,
            "outcome": run.word,
            "status": run.status,
            "timestep_s": run.timestep,
            **{f"{transition.name}_time_s": run.times[transition.name] for transition in results.transitions},
            **{f"{transition.name}_work_J": run.works[transition.name] for transition in results.transitions},
        }
        for run in (results.own, *results.runs)
    ]


def print_assumptions(results: Assumptions) -> None:
    """Print the table, the assumptions that do not apply, and the verdict."""
    Console(width=_WIDTH, highlight=False).print(assumptions_table(results))


def assumptions_table(results: Assumptions) -> RenderableType:
    """Return every run, the assumptions that do not apply, and the assumptions that decide the result."""
    table = Table(box=None, padding=(0, 2, 0, 0))
    table.add_column("changed assumption", no_wrap=True)
    works = len(results.transitions) <= _MOST_WORKS
    for transition in results.transitions:
        table.add_column(transition.time, justify="right")
        if works:
            table.add_column(f"work of {transition.noun}", justify="right")
    table.add_column("effect")
    table.add_column("result", no_wrap=len(results.transitions) <= _MOST_WORKS)
    for run in (results.own, *results.runs):
        table.add_row(*_cells(results, run, works=works), style=_STYLES[run.effect] if run is not results.own else "")
    remark = Text(f"± is the numerical uncertainty of the unchanged design's run.{_own_step(results)}")
    left_out = [Text(f"Does not apply: {name}, because {why}.") for name, why in results.left_out.items()]
    verdict = Text(f"{results.design.name}: {results.verdict}", style="bold")
    return Group(table, Text(), remark, *left_out, Text(), verdict)


def _cells(results: Assumptions, run: AssumptionRun, *, works: bool) -> list[str]:
    cells = [run.label]
    for transition in results.transitions:
        for kind, unit, value in (("time", "s", run.times[transition.name]), ("work", "J", run.works[transition.name])):
            if kind == "work" and not works:
                continue
            sure = results.uncertainty.get(f"{transition.name}.{kind}") if run is results.own else None
            cells.append("" if value is None else show_uncertain(value, sure, unit, 3))
    return [*cells, "" if run is results.own else run.effect.value, run.word]


def _own_step(results: Assumptions) -> str:
    """Return a sentence on runs with a shorter timestep than the design's."""
    shorter = [run for run in results.runs if run.timestep < 0.999 * results.own.timestep and run.name != "timestep"]
    if not shorter:
        return ""
    steps = ", ".join(f"{run.label} {show_value(run.timestep, 's')}" for run in shorter)
    return f" Timestep {show_value(results.own.timestep, 's')}; shorter where the change requires it: {steps}."
