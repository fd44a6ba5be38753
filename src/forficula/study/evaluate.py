"""Runs to rows: many designs through their protocols, each as a row of plain numbers."""

from __future__ import annotations

import time
from collections.abc import Iterator, Sequence
from dataclasses import replace

import numpy as np

from forficula.analysis import Outcome, State, Transition, measure
from forficula.design import Design
from forficula.dynamics import Record, WingModel, compile_wing, design_in_model_units, simulate_each, with_timestep
from forficula.errors import InputError
from forficula.study.journal import SCHEMA, Row

# How long wings are built before the first of them run, s; twice as long each time, for many side by side are faster.
_FIRST_SECONDS = 1.0


def row_key(design: Design) -> str:
    """What names a row: every value of the design and its protocol."""
    return f"{SCHEMA}-{design.hash}"


def evaluate(designs: Sequence[Design], threads: int = 0, *, until_opened: bool = False) -> Iterator[Row]:
    """Run designs and hand on their rows as they finish; the rows do not depend on order, company or threads.

    A design that cannot be built is a row, too, whose status says why.

    Args:
        designs: what to run.
        threads: 0 for one a core.
        until_opened: whether to try designs that only their unfold torques tell apart one after another, as they come,
            until one opens; the rest of them get no rows.
    """
    by_engine: dict[str, list[Design]] = {}
    for design in designs:
        by_engine.setdefault(_engine_key(design), []).append(design)
    built: list[tuple[str, WingModel]] = []
    seconds, start = _FIRST_SECONDS, time.perf_counter()
    for alike in by_engine.values():
        wing = _compile(alike[0])
        for design in alike:
            try:
                built.append((row_key(design), _with_protocol(wing, design)))
            except InputError as error:
                yield _not_built(row_key(design), error)
        if time.perf_counter() - start > seconds:
            yield from _by_topology(built, threads, until_opened)
            seconds, start, built = 2 * seconds, time.perf_counter(), []
    yield from _by_topology(built, threads, until_opened)


def _by_topology(wings: Sequence[tuple[str, WingModel]], threads: int, until_opened: bool) -> Iterator[Row]:
    """Rows of wings, those of one topology side by side."""
    groups: dict[tuple[int, ...], list[tuple[str, WingModel]]] = {}
    for key, wing in wings:
        groups.setdefault(topology(wing), []).append((key, wing))
    for group in groups.values():
        yield from _rows(group, threads, until_opened)


def _rows(wings: Sequence[tuple[str, WingModel]], threads: int, until_opened: bool) -> Iterator[Row]:
    """Rows of wings of one topology; in halves where memory does not hold all, and a status where it holds none."""
    done: set[int] = set()
    enough = _opened if until_opened else None
    try:
        for row, record in simulate_each([wing for _, wing in wings], threads, sparse=True, enough=enough):
            done.add(row)
            yield {"key": wings[row][0], **outcome_row(measure(record))}
    except InputError as error:
        left = [wing for row, wing in enumerate(wings) if row not in done]
        if len(wings) == 1:
            yield _not_built(wings[0][0], error)
            return
        for half in (left[: len(left) // 2], left[len(left) // 2 :]):
            yield from _rows(half, threads, until_opened)


def _not_built(key: str, error: InputError) -> Row:
    return {"key": key, "status": f"cannot be built: {error}"}


def topology(wing: WingModel) -> tuple[int, ...]:
    """The sizes that wings of one batch have in common."""
    engine = wing.engine
    sizes = (engine.nq, engine.nv, engine.nu, engine.nbody, engine.ngeom, engine.ntendon, engine.nflexvert)
    return (*sizes, engine.nactuator, engine.na, engine.nplastic)


def _opened(record: Record) -> bool:
    return bool(measure(record).opened)


def outcome_row(outcome: Outcome) -> Row:
    """An outcome as plain numbers with units in their names; None where there is none."""
    return {
        "status": outcome.status,
        "folded": outcome.folded,
        "opened": outcome.opened,
        **_transition("fold", outcome.fold),
        **_transition("unfold", outcome.unfold),
        **_state("flat", outcome.flat),
        **_state("folded", outcome.folded_state),
        **_state("opened", outcome.opened_state),
    }


def _engine_key(design: Design) -> str:
    """What names an engine model: all but what is done to the wing."""
    parting = {"fold_torque": 0.0, "unfold_torque": 0.0, "stages": ()}
    return design.model_copy(update={"protocol": design.protocol.model_copy(update=parting)}).hash


def _compile(design: Design) -> WingModel | InputError:
    """A wing, or why there is none."""
    try:
        return compile_wing(with_timestep(design))
    except InputError as error:
        return error


def _with_protocol(wing: WingModel | InputError, design: Design) -> WingModel:
    """The same wing with another protocol, its engine model shared; raise InputError where there is none."""
    if isinstance(wing, InputError):
        raise wing
    timestep = wing.design.protocol.timestep
    resolved = design.model_copy(update={"protocol": design.protocol.model_copy(update={"timestep": timestep})})
    return replace(wing, design=resolved, in_units=design_in_model_units(resolved, wing.units))


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
