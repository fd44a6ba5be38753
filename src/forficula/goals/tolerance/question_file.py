"""Questions from designs, settings, and tolerances in files or tables."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any, TypeVar

from forficula.design import Design, numbered_key
from forficula.design.key_table import names_within
from forficula.errors import InputError
from forficula.goals.deviation import Deviation, default_deviations
from forficula.goals.goal_file import deviations_within, flat_table, read_limits, with_torques
from forficula.goals.goal_keys import GOAL_KEYS
from forficula.goals.outcome_quantity import PROBABILITY
from forficula.goals.tolerance.question import Question
from forficula.quantities import as_written
from forficula.study.file_keys import check_keys
from forficula.study.named_file import base_design, read_named, settings_of, settled_by
from forficula.toml_text import parse_toml

T = TypeVar("T")
_GOALS = "forficula.goals"


def question_of(
    design: Design | None,
    tolerances: Mapping[str, object] | None = None,
    limits: Mapping[str, object] | None = None,
    goal: str | Path | None = None,
    settings: Mapping[str, object] | None = None,
) -> Question:
    """Ask how likely it is that a design works as it is built.

    Args:
        design: as it is meant; None for that of the goal.
        tolerances: by key, as in a goal file.
        limits: by quantity, as in a goal file.
        goal: a named goal, or the path of a file with tables `[tolerances]`, and perhaps `[limits]` and `[settings]`.
            Its tolerances and limits count where none are given here; its settings replace values of the design, but
            for what the goal varies. Without tolerances anywhere, 10 %, uniform, on every positive number with a unit
            that is not the protocol's.
        settings: values by key that stand above those of the goal; a design that is given has them already.

    Raises:
        InputError: no such file, an unknown key, a value that is not allowed, or no design.
    """
    for name, given in (("tolerances", tolerances), ("limits", limits)):
        if given is not None and not isinstance(given, Mapping):
            raise InputError(f"{name}: need them by key, got {as_written(given)}")
    if goal is None:
        if design is None:
            raise InputError("need a design, or a goal that has one")
        return _question(design, tolerances, limits or {}, Path())
    text, where, folder = read_named(goal, _GOALS, "goal", "goals")
    tables = _of_file(where, lambda: _tables(text))
    if design is None:
        asked = _of_file(where, lambda: base_design(tables, folder)).with_values(settings or {})
    else:
        asked = _of_file(where, lambda: _settled(design, tables, folder, settings or {}))
    tolerances, limits = tolerances or _flat(tables, "tolerances") or None, limits or _flat(tables, "limits")
    return _of_file(where, lambda: _question(asked, tolerances, limits, folder))


def _of_file(where: str, read: Callable[[], T]) -> T:
    """What is read of a file; an error begins with it."""
    try:
        return read()
    except InputError as error:
        raise InputError(f"{where}: {error}") from None


def _tables(text: str) -> dict[str, Any]:
    """The tables of a goal file that are looked at, checked to be such; what else it has is not."""
    tables = parse_toml(text, "a goal")
    check_keys(tables, names_within("", GOAL_KEYS), "")
    for name in ("tolerances", "limits", "vary"):
        if not isinstance(tables.get(name, {}), dict):
            raise InputError(f"{name}: need a table, got {as_written(tables[name])}")
        _flat(tables, name)
    return tables


def _flat(tables: Mapping[str, Any], name: str) -> dict[str, Any]:
    """One table of a goal file by dotted key."""
    return flat_table(tables, name, keep=("distribution", "size", "intervals_of", "low", "high", "step"))


def _settled(design: Design, tables: Mapping[str, Any], folder: Path, settings: Mapping[str, object]) -> Design:
    """A design with the settings of a goal, but for keys that were given otherwise, and what the goal varies."""
    own = {numbered_key(design, key) for key in (*settings, *_flat(tables, "vary"))}
    replaced = {
        key: value for key, value in settings_of(tables, folder).items() if numbered_key(design, key) not in own
    }
    return settled_by(design, replaced) if replaced else design


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
