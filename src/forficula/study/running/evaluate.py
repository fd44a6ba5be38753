"""Run many designs through their protocols, and convert each outcome to a row of plain numbers."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

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
from forficula.analysis.margin import NOT_TRIED, SMALL_MARGIN, margin_column, transition_margins
from forficula.analysis.outcome import compared_outcome
from forficula.analysis.package import smallest_package
from forficula.design import Design
from forficula.dynamics import Record
from forficula.errors import InputError
from forficula.study.running.certain_ending import CertainEnding, certain_ending
from forficula.study.running.journal import SCHEMA, Row
from forficula.study.running.runs import reached_goal, run_each, trial_chains
from forficula.study.running.second_runs import check_of, half_step, in_double_precision


def row_key(design: Design, *, whole: bool = False) -> str:
    """Return the key of a row: it identifies all values of the design, and whether the whole record was evaluated."""
    return f"{key_of_hash(design.hash)}{'-whole' if whole else ''}"


def key_of_hash(design_hash: str) -> str:
    """Return the key of the row of a design with this hash."""
    return f"{SCHEMA}-{design_hash}"


def evaluate(
    designs: Sequence[Design], threads: int = 0, *, until_last: bool = False, whole: bool = False
) -> Iterator[Row]:
    """Run designs and yield their rows as they finish. Rows do not depend on order, other designs or threads.

    A design that cannot be built also has a row; its status says why. A run whose verdict may depend on the timestep
    (see `needs_confirmation`) is repeated at half the timestep; a run on a device that reached or missed a transition
    by a small margin is repeated in double precision, too. `confirmed` is whether the verdicts agree; None if the run
    was not repeated. If they differ, the verdict is "undecided", and each margin is the smaller one.
    The repetition ends as soon as it is certain that the verdicts agree, see `certain_ending`.

    If designs are tried one after another, a run that would have to be repeated has no row if a smaller strength of the
    drive also reached the state: it does not decide the least strength.

    Args:
        designs: designs to run.
        threads: number of threads; 0 for one per core.
        until_last: see `run_each`; designs that the result of another one makes needless have no rows.
        whole: whether to keep whole records, which the columns of `whole_row` need.
    """
    keys = [row_key(design, whole=whole) for design in designs]
    doubtful: dict[int, _Doubtful] = {}
    chains, surplus = None, set[int]()
    for number, result in run_each(designs, threads, sparse=not whole, until_last=until_last):
        if isinstance(result, InputError):
            yield {"key": keys[number], **ending_row(Ending(verdict=Verdict.NOT_BUILT, why=str(result)))}
            continue
        outcome = measure(result)
        more = whole_row(result, outcome) if whole else {}
        margins = transition_margins(result, outcome)
        if until_last:
            chains = chains or trial_chains(designs, result.structure)
            surplus.update(chains.surplus(number, reached=reached_goal(result)))
        row = {"key": keys[number], **_row(result, outcome, margins), **more}
        if needs_confirmation(result, outcome, margins):
            close = result.design.protocol.device is not None and _is_close(margins)
            doubtful[number] = _Doubtful(
                row=row,
                outcome=outcome,
                design=in_double_precision(result.design) if close else result.design,
                ending=certain_ending(result, outcome),
            )
        else:
            yield row
    repeated = [item for number, item in doubtful.items() if number not in surplus]
    certain = {number: item.ending for number, item in enumerate(repeated) if item.ending is not None}
    halves = [half_step(item.design) for item in repeated]
    for number, result in run_each(halves, threads, sparse=True, certain=certain):
        item = repeated[number]
        yield item.row if isinstance(result, InputError) else _confirmed(item.row, item.outcome, item.design, result)


@dataclass(frozen=True, kw_only=True)
class _Doubtful:
    """A run whose verdict may depend on the timestep.

    Attributes:
        row: row of the run.
        outcome: outcome of the run.
        design: design that is repeated at half its timestep.
        ending: when the repetition is certain to have the same outcome; None if this is not known before its end.
    """

    row: Row
    outcome: Outcome
    design: Design
    ending: CertainEnding | None


def _row(record: Record, outcome: Outcome, margins: Mapping[str, float]) -> Row:
    """Return the columns that every run has."""
    agree = None if outcome.confirmation is None else outcome.confirmation.agree
    return {
        **outcome_row(outcome),
        **{margin_column(name): margin for name, margin in margins.items()},
        # whether the run never met the goal of the transition that it tries
        "short_of_goal": reached_goal(record) is False,
        "confirmed": agree,
        "timestep_s": float(record.design.protocol.timestep),
    }


def _confirmed(row: Row, outcome: Outcome, design: Design, half: Record) -> Row:
    """Return a row after the comparison with a run of the same design at half the timestep."""
    other = measure(half)
    compared = compared_outcome(outcome, [check_of(HALF_STEP, float(half.design.protocol.timestep), other)], design)
    if compared.confirmation is None or compared.confirmation.agree:
        return row | {"confirmed": None if compared.confirmation is None else True}
    margins = {margin_column(name): margin for name, margin in transition_margins(half, other).items()}
    least = {name: min(margin, float(row[name])) for name, margin in margins.items()}
    return row | outcome_row(compared) | least | {"confirmed": False}


def outcome_row(outcome: Outcome) -> Row:
    """Return an outcome as plain numbers with units in their names; None if missing or unreliable.

    The row has, for every state that a transition leads to, whether the state holds; for every transition, its time and
    work; for every state, the energy of all tendons, all recorded distances, and the reading that is furthest from the
    goal.
    """
    # for an undecided run everything is known except what its second run contradicts
    reliable = outcome.verdict.conclusive or outcome.verdict is Verdict.UNDECIDED
    known = {name: reliable and held is not None for name, held in outcome.holds.items()}
    leads = {transition.name: transition.state for transition in outcome.structure.transitions}
    row: Row = {**ending_row(outcome.ending), **outcome.holds}
    for name, transition in outcome.transitions.items():
        row |= _transition(name, transition if known[leads[name]] else None)
    for name, state in outcome.states.items():
        row |= _state(name, state if known.get(name, reliable) else None)
    return row


def whole_row(record: Record, outcome: Outcome) -> Row:
    """Return columns that need the whole record: smallest package of a named state, largest forces of displacements.

    Values are None if missing or unreliable.
    """
    smallest = smallest_package(record) if outcome.verdict.conclusive else None
    row: Row = {
        "package_area": None if smallest is None else smallest[2].area_ratio,
        "package_height_m": None if smallest is None else smallest[2].height,
    }
    for name, transition in outcome.transitions.items():
        force = None if transition is None or not outcome.verdict.conclusive else transition.largest_force
        row[f"{name}_force_N"] = None if force is None else abs(force)
    return row


def ending_row(ending: Ending) -> Row:
    """Return the ending of a run as plain data."""
    residual, transition = ending.residual, ending.transition
    return {
        "status": ending_text(ending),
        "verdict": ending.verdict.value,
        "outcome": ending_word(ending),
        "goal": ending.goal,
        **_reading("", ending.reading, "angle" if transition is None else transition.kind),
        # JSON has no infinity or nan
        "residual": None if residual is None or not np.isfinite(residual) else residual,
    }


def _transition(name: str, transition: TransitionOutcome | None) -> Row:
    if transition is None:
        return {f"{name}_time_s": None, f"{name}_work_J": None}
    return {f"{name}_time_s": transition.time, f"{name}_work_J": transition.work}


def _state(name: str, state: State | None) -> Row:
    """Return stored energies, distances, and the first measure's reading that is furthest from the goal."""
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
    """Return the energy of all tendons, J; without tendons, the energy of springs and membranes.

    None for a structure without tendons but with membranes, because sparse records lack the energy of membranes.
    """
    return float(np.sum(state.tendon_energy)) if len(state.tendon_energy) else whole_energy(state)


def whole_energy(state: State) -> float | None:
    """Return the energy of tendons, of springs of hinges, bars and couplings, and of membranes, J.

    None for a structure with membranes, because sparse records lack their energy.
    """
    parts = (state.tendon_energy, *(getattr(state, f"{kind}_energy") for kind in SPRUNG), state.membrane_energy)
    stored = sum(float(np.sum(energies)) for energies in parts if energies is not None)
    return stored if np.isfinite(stored) else None


def _reading(prefix: str, value: float | None, kind: str) -> Row:
    """Return an angle in deg or a distance in m."""
    if kind == "distance":
        return {f"{prefix}distance_m": value}
    return {f"{prefix}angle_deg": None if value is None else float(np.degrees(value))}


def needs_confirmation(record: Record, outcome: Outcome, margins: Mapping[str, float]) -> bool:
    """Return whether the verdict of a run may depend on the timestep.

    Verdicts change if a structure slams into its stops and is then released, because small differences then decide
    whether the remaining motion carries it back over the barrier. They may also change if a transition was reached or
    missed by a small margin.

    Args:
        record: record of the run; a record with checks has been confirmed.
        outcome: outcome of the run.
        margins: margins of the run, by transition.
    """
    if not outcome.verdict.conclusive or record.checks:
        return False
    released = any(
        transition.stage is not None
        and transition.stage + 1 < len(record.stages)
        and record.stages[transition.stage].goal_time is not None
        for transition in record.structure.transitions
    )
    return released or _is_close(margins)


def _is_close(margins: Mapping[str, float]) -> bool:
    """Return whether a transition was reached or missed by a small margin."""
    return any(margin > NOT_TRIED and abs(margin) < SMALL_MARGIN for margin in margins.values())
