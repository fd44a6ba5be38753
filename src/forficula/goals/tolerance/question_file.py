"""Questions from designs, settings, and tolerances in files or tables."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

from forficula.design import Design
from forficula.errors import InputError
from forficula.goals.deviation import Deviation, default_deviations
from forficula.goals.goal_file import deviations_within, flat_table, read_limits, with_torques
from forficula.goals.outcome_quantity import PROBABILITY
from forficula.goals.tolerance.question import Question
from forficula.quantities import as_written
from forficula.study.named_file import read_named
from forficula.toml_text import parse_toml

_GOALS = "forficula.goals"


def question_of(
    design: Design,
    tolerances: Mapping[str, object] | str | Path | None = None,
    limits: Mapping[str, object] | None = None,
) -> Question:
    """Ask how likely it is that a design works as it is built.

    Args:
        design: as it is meant.
        tolerances: by key, as in a goal file; a named goal or the path of a goal file, or of a file with a table
            `[tolerances]` and perhaps `[limits]`; if None, 10 %, uniform, on every positive number with a unit that is
            not the protocol's.
        limits: by quantity, as in a goal file, beside those of the file.

    Raises:
        InputError: no such file, an unknown key, or a value that is not allowed.
    """
    if isinstance(tolerances, str | Path):
        text, where, folder = read_named(tolerances, _GOALS, "goal", "goals")
        try:
            tables = parse_toml(text, "tolerances")
            given = {name: _table(tables, name) for name in ("tolerances", "limits")}
            return _question(design, given["tolerances"] or None, given["limits"] | dict(limits or {}), folder)
        except InputError as error:
            raise InputError(f"{where}: {error}") from None
    if not isinstance(tolerances, Mapping | None):
        raise InputError(f'tolerances: need them by key, such as all = "5 %", or a file, got {as_written(tolerances)}')
    return _question(design, tolerances, limits or {}, Path())


def _table(tables: Mapping[str, Any], name: str) -> dict[str, Any]:
    """One table of a file by dotted key; what else a goal file has is not looked at."""
    if not isinstance(tables.get(name, {}), dict):
        raise InputError(f"{name}: need a table, got {as_written(tables[name])}")
    return flat_table(tables, name, keep=("distribution", "size", "intervals_of"))


def _question(
    design: Design, tolerances: Mapping[str, object] | None, limits: Mapping[str, object], folder: Path
) -> Question:
    every = read_limits(limits, design)
    torques = tuple(each for each in every if each.quantity.source == "search")
    for limit in torques:
        if limit.kind == ">=":
            raise InputError(f"limits.{limit.quantity.name}: need an upper limit, which is the torque of every run")
    design = with_torques(design, torques)
    wanted = [each for each in every if each.quantity.name == PROBABILITY]
    deviations: tuple[Deviation, ...] = (
        default_deviations(design) if tolerances is None else deviations_within(tolerances, design, folder)
    )
    if not deviations:
        raise InputError(f'tolerances: need at least one, such as all = "5 %"; {design.name} has none')
    return Question(
        design=design,
        deviations=deviations,
        limits=tuple(each for each in every if each not in torques and each not in wanted),
        wanted=tuple(wanted),
        assumed=tolerances is None,
    )
