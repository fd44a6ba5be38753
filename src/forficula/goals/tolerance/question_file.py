"""Questions from designs, settings, and tolerances in files or tables."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

from forficula.design import Design
from forficula.errors import InputError
from forficula.goals.deviation import Deviation, default_deviations
from forficula.goals.goal_file import deviations_within, flat_table, read_limits, with_torques
from forficula.goals.goal_keys import goal_names_in
from forficula.goals.outcome_quantity import PROBABILITY
from forficula.goals.tolerance.question import Question
from forficula.quantities import as_written
from forficula.study.file_keys import check_keys
from forficula.study.named_file import read_named
from forficula.toml_text import parse_toml

_GOALS = "forficula.goals"


def question_of(
    design: Design,
    tolerances: Mapping[str, object] | None = None,
    limits: Mapping[str, object] | None = None,
    goal: str | Path | None = None,
) -> Question:
    """Ask how likely it is that a design works as it is built.

    Args:
        design: as it is meant.
        tolerances: by key, as in a goal file.
        limits: by quantity, as in a goal file.
        goal: a named goal, or the path of a file with tables `[tolerances]` and perhaps `[limits]`, which count where
            none are given here. Without tolerances anywhere, 10 %, uniform, on every positive number with a unit that
            is not the protocol's.

    Raises:
        InputError: no such file, an unknown key, or a value that is not allowed.
    """
    for name, given in (("tolerances", tolerances), ("limits", limits)):
        if given is not None and not isinstance(given, Mapping):
            raise InputError(f"{name}: need them by key, got {as_written(given)}")
    if goal is None:
        return _question(design, tolerances, limits or {}, Path())
    text, where, folder = read_named(goal, _GOALS, "goal", "goals")
    try:
        tables = parse_toml(text, "tolerances")
        check_keys(tables, goal_names_in(), "")
        of_file = {name: _table(tables, name) for name in ("tolerances", "limits")}
        return _question(design, tolerances or of_file["tolerances"] or None, limits or of_file["limits"], folder)
    except InputError as error:
        raise InputError(f"{where}: {error}") from None


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
