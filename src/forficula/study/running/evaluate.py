"""Runs to rows: many designs through their protocols, each as a row of plain numbers."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

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
from forficula.analysis.confirmation import HALF_STEP
from forficula.analysis.margin import NOT_TRIED, margin_column, transition_margins
from forficula.analysis.outcome import held_against
from forficula.analysis.package import smallest_package
from forficula.design import Design
from forficula.dynamics import Record
from forficula.errors import InputError
from forficula.study.running.journal import SCHEMA, Row
from forficula.study.running.runs import check_of, half_step, run_each

# [chosen] of a margin, in [-1, 1]. Calibrated on 200 builds of the reference wing within 10 %
# (benchmarks/confirmation.py): the rule finds 14 of the 14 verdicts that change between 0.2 and 0.1 ms, with 156
# repetitions.
_SMALL = 0.05


def row_key(design: Design, *, whole: bool = False) -> str:
    """What names a row: every value of the design and its protocol, and whether all of its run was looked at."""
    return f"{SCHEMA}-{design.hash}{'-whole' if whole else ''}"


def evaluate(
    designs: Sequence[Design], threads: int = 0, *, until_last: bool = False, whole: bool = False
) -> Iterator[Row]:
    """Run designs and hand on their rows as they finish; the rows do not depend on order, company or threads.

    A design that cannot be built is a row, too, whose status says why. A run whose verdict may depend on the timestep,
    see `needs_confirmation`, is run again at half the timestep: `confirmed` says whether the verdict was the same, None
    where that was not tried. Where verdicts differ, the verdict is "undecided", and margins are the lesser ones.

    Args:
        designs: what to run.
        threads: 0 for one a core.
        until_last: as of `run_each`.
        whole: whether to keep all rows of the records, for what the ends of stages do not tell: see `whole_row`.
    """
    keys = [row_key(design, whole=whole) for design in designs]
    doubtful: list[tuple[Row, Outcome, Design]] = []
    for number, result in run_each(designs, threads, sparse=not whole, until_last=until_last):
        if isinstance(result, InputError):
            yield {"key": keys[number], **ending_row(Ending(verdict=Verdict.NOT_BUILT, why=str(result)))}
            continue
        outcome = measure(result)
        more = whole_row(result, outcome) if whole else {}
        margins = transition_margins(result, outcome)
        row = {"key": keys[number], **_row(result, outcome, margins), **more}
        if needs_confirmation(result, outcome, margins):
            doubtful.append((row, outcome, result.design))
        else:
            yield row
    halves = [half_step(design) for _, _, design in doubtful]
    for number, result in run_each(halves, threads, sparse=True):
        row, outcome, design = doubtful[number]
        yield row if isinstance(result, InputError) else _confirmed(row, outcome, design, result)


def _row(record: Record, outcome: Outcome, margins: Mapping[str, float]) -> Row:
    """What a row has of every run."""
    agree = None if outcome.confirmation is None else outcome.confirmation.agree
    return {
        **outcome_row(outcome),
        **{margin_column(name): each for name, each in margins.items()},
        "confirmed": agree,
        "timestep_s": float(record.design.protocol.timestep),
    }


def _confirmed(row: Row, outcome: Outcome, design: Design, half: Record) -> Row:
    """A row that was held against a run of the same design at half the timestep."""
    other = measure(half)
    found = held_against(outcome, [check_of(HALF_STEP, float(half.design.protocol.timestep), other)], design)
    if found.confirmation is None or found.confirmation.agree:
        return row | {"confirmed": None if found.confirmation is None else True}
    margins = {margin_column(name): each for name, each in transition_margins(half, other).items()}
    least = {name: min(each, float(row[name])) for name, each in margins.items()}
    return row | outcome_row(found) | least | {"confirmed": False}


def outcome_row(outcome: Outcome) -> Row:
    """An outcome as plain numbers with units in their names; None where there is none, or none is to be trusted.

    Of every state that a transition leads to whether it holds, of every transition time and work, and of every state
    the energy of all tendons, all distances that are watched and what the measure reads furthest from the goal.
    """
    # of an undecided run all is known but what its second run contradicts
    tells = outcome.verdict.tells or outcome.verdict is Verdict.UNDECIDED
    known = {name: tells and held is not None for name, held in outcome.holds.items()}
    leads = {each.name: each.state for each in outcome.structure.transitions}
    row: Row = {**ending_row(outcome.ending), **outcome.holds}
    for name, transition in outcome.transitions.items():
        row |= _transition(name, transition if known[leads[name]] else None)
    for name, state in outcome.states.items():
        row |= _state(name, state if known.get(name, tells) else None)
    return row


def whole_row(record: Record, outcome: Outcome) -> Row:
    """What only all rows of a record tell: the least package of a named state, and the largest forces of displacements.

    None where there is none, or none is to be trusted.
    """
    smallest = smallest_package(record) if outcome.verdict.tells else None
    row: Row = {
        "package_area": None if smallest is None else smallest[2].area_ratio,
        "package_height_m": None if smallest is None else smallest[2].height,
    }
    for name, made in outcome.transitions.items():
        force = None if made is None or not outcome.verdict.tells else made.largest_force
        row[f"{name}_force_N"] = None if force is None else abs(force)
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
    if len(state.tendon_energy):
        energy[f"{name}_stored_energy_J"] = whole_energy(state)
    for kind in SPRUNG:
        if (stored := getattr(state, f"{kind}_energy")) is not None:
            energy[f"{name}_{kind}_energy_J"] = float(np.sum(stored))
    distances = {
        f"{name}_{measure}_m": float(np.max(reading.mean))
        for measure, reading in state.readings.items()
        if reading.kind == "distance"
    }
    return energy | distances | _reading(f"{name}_", state.furthest, state.furthest_kind)


def stored_energy(state: State) -> float | None:
    """Energy of all tendons, J; of a structure without any, what springs and membranes store.

    None of one without tendons that has membranes, whose energy sparse records do not have.
    """
    return float(np.sum(state.tendon_energy)) if len(state.tendon_energy) else whole_energy(state)


def whole_energy(state: State) -> float | None:
    """Energy of tendons, of the springs of hinges, bars and couplings, and of membranes, J.

    None of one that has membranes, whose energy sparse records do not have.
    """
    parts = (state.tendon_energy, *(getattr(state, f"{kind}_energy") for kind in SPRUNG), state.membrane_energy)
    stored = sum(float(np.sum(each)) for each in parts if each is not None)
    return stored if np.isfinite(stored) else None


def _reading(prefix: str, value: float | None, kind: str) -> Row:
    """An angle in deg or a distance in m."""
    if kind == "distance":
        return {f"{prefix}distance_m": value}
    return {f"{prefix}angle_deg": None if value is None else float(np.degrees(value))}


def needs_confirmation(record: Record, outcome: Outcome, margins: Mapping[str, float]) -> bool:
    """Return whether the verdict of a run may depend on the timestep.

    Verdicts change where a structure slams into its stops and is then released: whether the rest of the motion carries
    it back over the barrier depends on small differences. They may also change where a transition was made or missed by
    a small margin.

    Args:
        record: of the run. A record with checks is confirmed already.
        outcome: of the run.
        margins: of the run, by transition.
    """
    if not outcome.verdict.tells or record.checks:
        return False
    released = any(
        each.stage is not None
        and each.stage + 1 < len(record.stages)
        and record.stages[each.stage].goal_time is not None
        for each in record.structure.transitions
    )
    return released or any(margin > NOT_TRIED and abs(margin) < _SMALL for margin in margins.values())
