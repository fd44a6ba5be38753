"""A convergence study as rows and as text."""

from __future__ import annotations

import math
from typing import Any

from rich.console import Console, Group, RenderableType
from rich.table import Table
from rich.text import Text

from forficula.structure import structure_of
from forficula.study.convergence.convergence import Convergence
from forficula.study.convergence.observed_order import OrderFit
from forficula.study.convergence.refinement import MESH, TIMESTEP, YOUNGS_MODULUS, value_text


def convergence_rows(convergence: Convergence) -> list[dict[str, Any]]:
    """Return a row for every value as plain data with units in its keys; None for missing times."""
    key = {TIMESTEP: "timestep_s", YOUNGS_MODULUS: "youngs_modulus_Pa", MESH: "mesh_refinement"}[convergence.key]
    return [
        {
            key: float(value),
            "membrane_rows": rows,
            "status": status,
            **{f"{name}_time_s": _number(times[run]) for name, times in convergence.transition_times.items()},
        }
        for run, (value, rows, status) in enumerate(
            zip(convergence.values, convergence.rows, convergence.statuses, strict=True)
        )
    ]


def print_convergence(convergence: Convergence) -> None:
    """Print the table and the verdict."""
    Console(width=110, highlight=False).print(convergence_table(convergence))


def convergence_table(convergence: Convergence) -> RenderableType:
    """Return every run, the limits if there are any, and the verdict."""
    table = Table(box=None, padding=(0, 2, 0, 0))
    for heading in (
        {TIMESTEP: "timestep", YOUNGS_MODULUS: "Young's modulus", MESH: "rows"}[convergence.key],
        *time_labels(convergence).values(),
    ):
        table.add_column(heading, justify="right")
    table.add_column("status")
    for run, (value, rows, status) in enumerate(
        zip(convergence.values, convergence.rows, convergence.statuses, strict=True)
    ):
        name = str(rows) if convergence.key == MESH else value_text(convergence.key, float(value))
        suffix = " (value of the design)" if value == convergence.design_value else ""
        times = (f"{1e3 * time:.5g} ms" if math.isfinite(time) else "" for time in _times_of(convergence, run))
        table.add_row(name, *times, status + suffix)
    limits = [
        Text(f"limit of the {label}: {1e3 * fit.limit:.5g} ms, {order_text(fit)}")
        for name, label in time_labels(convergence).items()
        if (fit := convergence.orders[name]) is not None
    ]
    verdict = Text(f"{convergence.design.name}: {convergence.verdict}", style="bold")
    return Group(table, *limits, Text(), verdict)


def time_labels(convergence: Convergence) -> dict[str, str]:
    """Return the name of each transition's time."""
    return {transition.name: transition.wording.time for transition in structure_of(convergence.design).transitions}


def _times_of(convergence: Convergence, run: int) -> list[float]:
    return [float(times[run]) for times in convergence.transition_times.values()]


def order_text(fit: OrderFit) -> str:
    """Return the order of a fit, and whether it was observed or assumed."""
    return f"order {fit.order:.2f}, fitted" if fit.observed else f"order {fit.order:g}, assumed"


def _number(time: float) -> float | None:
    return float(time) if math.isfinite(time) else None
