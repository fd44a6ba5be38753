"""Runs to rows: many designs through their protocols, each as a row of plain numbers."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from forficula.analysis import (
    SPRUNG,
    Ending,
    Outcome,
    State,
    TransitionOutcome,
    Verdict,
    ending_text,
    ending_word,
    measure,
)
from forficula.design import Design
from forficula.errors import InputError
from forficula.study.journal import SCHEMA, Row
from forficula.study.runs import run_each


def row_key(design: Design) -> str:
    """What names a row: every value of the design and its protocol."""
    return f"{SCHEMA}-{design.hash}"


def evaluate(designs: Sequence[Design], threads: int = 0, *, until_last: bool = False) -> Iterator[Row]:
    """Run designs and hand on their rows as they finish; the rows do not depend on order, company or threads.

    A design that cannot be built is a row, too, whose status says why.

    Args:
        designs: what to run.
        threads: 0 for one a core.
        until_last: as of `run_each`.
    """
    keys = [row_key(design) for design in designs]
    for number, result in run_each(designs, threads, sparse=True, until_last=until_last):
        if isinstance(result, InputError):
            yield {"key": keys[number], **ending_row(Ending(verdict=Verdict.NOT_BUILT, why=str(result)))}
        else:
            timestep = float(result.design.protocol.timestep)
            yield {"key": keys[number], **outcome_row(measure(result)), "timestep_s": timestep}


def outcome_row(outcome: Outcome) -> Row:
    """An outcome as plain numbers with units in their names; None where there is none, or none is to be trusted.

    Of every state that a transition leads to whether it holds, of every transition time and work, and of every state
    the energy of all tendons and what the measure reads furthest from the goal.
    """
    tells = outcome.verdict.tells
    row: Row = {**ending_row(outcome.ending), **outcome.holds}
    for name, transition in outcome.transitions.items():
        row |= _transition(name, transition if tells else None)
    for name, state in outcome.states.items():
        row |= _state(name, state if tells else None)
    return row


def ending_row(ending: Ending) -> Row:
    """What a run came to as plain data."""
    residual, transition = ending.residual, ending.transition
    return {
        "status": ending_text(ending),
        "verdict": ending.verdict.value,
        "outcome": ending_word(ending),
        "goal": ending.goal,
        **_reading("", ending.reading, "angle" if transition is None else transition.kind),
        # JSON has no number for what is not finite
        "residual": None if residual is None or not np.isfinite(residual) else residual,
    }


def _transition(name: str, transition: TransitionOutcome | None) -> Row:
    if transition is None:
        return {f"{name}_time_s": None, f"{name}_work_J": None}
    return {f"{name}_time_s": transition.time, f"{name}_work_J": transition.work}


def _state(name: str, state: State | None) -> Row:
    """What is stored, and the first measure's reading of what is furthest from the goal."""
    if state is None:
        return {f"{name}_energy_J": None}
    energy = {f"{name}_energy_J": stored_energy(state)}
    for kind in SPRUNG:
        if (stored := getattr(state, f"{kind}_energy")) is not None:
            energy[f"{name}_{kind}_energy_J"] = float(np.sum(stored))
    return energy | _reading(f"{name}_", state.furthest, state.furthest_kind)


def stored_energy(state: State) -> float | None:
    """Energy of all tendons, J; of a structure without any, what springs and membranes store.

    None of one without tendons that has membranes, whose energy sparse records do not have.
    """
    if len(state.tendon_energy):
        return float(np.sum(state.tendon_energy))
    others = (*(getattr(state, f"{kind}_energy") for kind in SPRUNG), state.membrane_energy)
    stored = sum(float(np.sum(each)) for each in others if each is not None)
    return stored if np.isfinite(stored) else None


def _reading(prefix: str, value: float | None, kind: str) -> Row:
    """An angle in deg or a distance in m."""
    if kind == "distance":
        return {f"{prefix}distance_m": value}
    return {f"{prefix}angle_deg": None if value is None else float(np.degrees(value))}
