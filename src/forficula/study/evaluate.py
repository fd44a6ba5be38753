"""Runs to rows: many designs through their protocols, each as a row of plain numbers."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from forficula.analysis import Ending, Outcome, State, Transition, Verdict, ending_text, measure
from forficula.design import Design
from forficula.errors import InputError
from forficula.study.journal import SCHEMA, Row
from forficula.study.runs import run_each


def row_key(design: Design) -> str:
    """What names a row: every value of the design and its protocol."""
    return f"{SCHEMA}-{design.hash}"


def evaluate(designs: Sequence[Design], threads: int = 0, *, until_opened: bool = False) -> Iterator[Row]:
    """Run designs and hand on their rows as they finish; the rows do not depend on order, company or threads.

    A design that cannot be built is a row, too, whose status says why.

    Args:
        designs: what to run.
        threads: 0 for one a core.
        until_opened: as of `run_each`.
    """
    keys = [row_key(design) for design in designs]
    for number, result in run_each(designs, threads, sparse=True, until_opened=until_opened):
        if isinstance(result, InputError):
            yield {"key": keys[number], **ending_row(Ending(verdict=Verdict.NOT_BUILT, why=str(result)))}
        else:
            timestep = float(result.design.protocol.timestep)
            yield {"key": keys[number], **outcome_row(measure(result)), "timestep_s": timestep}


def outcome_row(outcome: Outcome) -> Row:
    """An outcome as plain numbers with units in their names; None where there is none, or none is to be trusted."""
    tells = outcome.verdict.tells
    states = {"flat": outcome.flat, "folded": outcome.folded_state, "opened": outcome.opened_state}
    row = {
        **ending_row(outcome.ending),
        "folded": outcome.folded,
        "opened": outcome.opened,
        **_transition("fold", outcome.fold if tells else None),
        **_transition("unfold", outcome.unfold if tells else None),
    }
    for name, state in states.items():
        row |= _state(name, state if tells else None)
    return row


def ending_row(ending: Ending) -> Row:
    """What a run came to as plain data."""
    residual = ending.residual
    return {
        "status": ending_text(ending),
        "verdict": ending.verdict.value,
        "goal": ending.goal,
        "angle_deg": None if ending.angle is None else float(np.degrees(ending.angle)),
        # JSON has no number for what is not finite
        "residual": None if residual is None or not np.isfinite(residual) else residual,
    }


def row_ending(row: Row) -> Ending:
    """What `ending_row` wrote, but for what only its status says."""
    angle = row.get("angle_deg")
    return Ending(
        verdict=Verdict(row["verdict"]),
        goal=row.get("goal", "none"),
        angle=None if angle is None else float(np.radians(angle)),
        residual=row.get("residual"),
    )


def _transition(name: str, transition: Transition | None) -> Row:
    if transition is None:
        return {f"{name}_time_s": None, f"{name}_work_J": None}
    return {f"{name}_time_s": transition.time, f"{name}_work_J": transition.work}


def _state(name: str, state: State | None) -> Row:
    """Energy of all tendons, and the angle of the hinge that is furthest from folded."""
    if state is None:
        return {f"{name}_energy_J": None, f"{name}_angle_deg": None}
    angle = float(np.degrees(np.max(state.distal_angle)))
    return {f"{name}_energy_J": float(np.sum(state.tendon_energy)), f"{name}_angle_deg": angle}
