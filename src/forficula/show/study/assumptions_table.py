"""Assumptions of a design as rows and as text that a person understands."""

from __future__ import annotations

from typing import Any

from rich.console import Console, Group, RenderableType
from rich.table import Table
from rich.text import Text

from forficula.quantities import show_uncertain, show_value
from forficula.study.assumptions.assumptions import AssumptionRun, Assumptions, Effect

_WIDTH = 140
# transitions whose times and works fit beside one another
_MOST_WORKS = 2
_STYLES = {Effect.VERDICT: "red", Effect.UNKNOWN: "yellow", Effect.NUMBERS: "", Effect.NOTHING: "dim"}


def assumption_rows(found: Assumptions) -> list[dict[str, Any]]:
    """Return a row for every run, the design itself first: plain data with units in the keys, None for no value."""
    return [
        {
            "assumption": run.name,
            "change": run.label,
            "effect": "" if run is found.own else run.effect.value,
            "verdict": run.verdict.value,
            "outcome": run.word,
            "status": run.status,
            "timestep_s": run.timestep,
            **{f"{each.name}_time_s": run.times[each.name] for each in found.transitions},
            **{f"{each.name}_work_J": run.works[each.name] for each in found.transitions},
        }
        for run in (found.own, *found.runs)
    ]


def print_assumptions(found: Assumptions) -> None:
    """Print the table, the assumptions that do not apply, and the verdict."""
    Console(width=_WIDTH, highlight=False).print(assumptions_table(found))


def assumptions_table(found: Assumptions) -> RenderableType:
    """Lay out every run, the assumptions that do not apply, and which ones decide the result."""
    table = Table(box=None, padding=(0, 2, 0, 0))
    table.add_column("assumed instead", no_wrap=True)
    works = len(found.transitions) <= _MOST_WORKS
    for each in found.transitions:
        table.add_column(each.time, justify="right")
        if works:
            table.add_column(f"work of {each.noun}", justify="right")
    table.add_column("changes")
    table.add_column("result", no_wrap=len(found.transitions) <= _MOST_WORKS)
    for run in (found.own, *found.runs):
        table.add_row(*_cells(found, run, works=works), style=_STYLES[run.effect] if run is not found.own else "")
    apart = Text(f"± is the numerical uncertainty of the design's own run.{_own_step(found)}")
    left_out = [Text(f"Does not apply: {name}, because {why}.") for name, why in found.left_out.items()]
    verdict = Text(f"{found.design.name}: {found.verdict}", style="bold")
    return Group(table, Text(), apart, *left_out, Text(), verdict)


def _cells(found: Assumptions, run: AssumptionRun, *, works: bool) -> list[str]:
    cells = [run.label]
    for each in found.transitions:
        for kind, unit, value in (("time", "s", run.times[each.name]), ("work", "J", run.works[each.name])):
            if kind == "work" and not works:
                continue
            sure = found.uncertainty.get(f"{each.name}.{kind}") if run is found.own else None
            cells.append("" if value is None else show_uncertain(value, sure, unit, 3))
    return [*cells, "" if run is found.own else run.effect.value, run.word]


def _own_step(found: Assumptions) -> str:
    """Say which runs took a shorter timestep than the design's own."""
    shorter = [run for run in found.runs if run.timestep < 0.999 * found.own.timestep and run.name != "timestep"]
    if not shorter:
        return ""
    told = ", ".join(f"{run.label} {show_value(run.timestep, 's')}" for run in shorter)
    return f" Timestep {show_value(found.own.timestep, 's')}; shorter where the change needs it: {told}."
