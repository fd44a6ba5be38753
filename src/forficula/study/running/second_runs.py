"""Second runs of a design, which differ from the first only numerically: their designs, and their results as checks."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from forficula.analysis import Outcome, measure
from forficula.analysis.confirmation import DOUBLE_PRECISION, HALF_STEP, OTHER_START
from forficula.analysis.outcome import outcome_values
from forficula.design import Design, put
from forficula.dynamics import NumericalCheck, Record
from forficula.errors import InputError


def second_designs(design: Design) -> dict[str, Design]:
    """Return the designs of the second runs that confirm one with a given timestep, by the name of the difference."""
    return {HALF_STEP: half_step(design)} | other_designs(design)


def other_designs(design: Design) -> dict[str, Design]:
    """Return the designs of the second runs at the same timestep, by the name of the difference."""
    start = design.with_other_start()
    others = {} if start is None else {OTHER_START: start}
    return others if design.protocol.device is None else others | {DOUBLE_PRECISION: in_double_precision(design)}


def in_double_precision(design: Design) -> Design:
    """Return the design simulated by the processor."""
    return put(design, "protocol.device", None)


def half_step(design: Design) -> Design:
    """Return the design with half its timestep."""
    return with_step(design, float(design.protocol.timestep) / 2)


def with_checks(record: Record, others: Mapping[str, Record | InputError]) -> Record:
    """Return a record with the outcomes of second runs of its design, by difference. Designs not built are omitted."""
    checks = [_check(name, other) for name, other in others.items() if isinstance(other, Record)]
    return replace(record, checks=(*record.checks, *checks))


def _check(name: str, record: Record) -> NumericalCheck:
    return check_of(name, float(record.design.protocol.timestep), measure(record))


def check_of(name: str, timestep: float, outcome: Outcome) -> NumericalCheck:
    """Return the summary of a second run at a timestep, s, that a record stores."""
    return NumericalCheck(
        name=name,
        timestep=timestep,
        verdict=outcome.verdict.value,
        goal=outcome.ending.goal,
        status=outcome.status,
        holds=dict(outcome.holds),
        values=outcome_values(outcome) if outcome.verdict.conclusive else {},
    )


def with_step(design: Design, timestep: float) -> Design:
    """Return the design with a timestep, s."""
    return design.model_copy(update={"protocol": design.protocol.model_copy(update={"timestep": timestep})})
