"""Build the question of a tolerance analysis from a design, settings, and tolerances in files or tables."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

from forficula.design import Design, numbered_key
from forficula.errors import InputError, error_prefix
from forficula.goals.deviation import Deviation, default_deviations
from forficula.goals.goal_file import GOAL, deviations_within, read_limits, with_torques
from forficula.goals.outcome_quantity import PROBABILITY
from forficula.goals.tolerance.question import Question
from forficula.quantities import as_written
from forficula.study.files.named_file import base_design, load_named, settings_of, settled_by


def question_of(
    design: Design | None,
    tolerances: Mapping[str, object] | None = None,
    limits: Mapping[str, object] | None = None,
    goal: str | Path | None = None,
    settings: Mapping[str, object] | None = None,
) -> Question:
    """Build the question: with what probability does a design work within manufacturing tolerances?

    Args:
        design: the nominal design; None for the design of the goal.
        tolerances: tolerances by key, as in a goal file.
        limits: limits by quantity, as in a goal file.
        goal: a named goal, or the path of a file with a table `[tolerances]` and optional tables `[limits]` and
            `[settings]`. Its tolerances and limits are the defaults of the arguments. Its settings replace values of
            the design, except keys that the goal varies. If no tolerances are given at all, every positive number
            with a unit that is not in the protocol varies uniformly by 10 %.
        settings: values by key that take precedence over those of the goal. A given design already contains them.

    Raises:
        InputError: no such file, an unknown key, a value that is not allowed, or no design.
    """
    for name, table in (("tolerances", tolerances), ("limits", limits)):
        if table is not None and not isinstance(table, Mapping):
            raise InputError(f"{name}: need them by key, got {as_written(table)}")
    if goal is None:
        if design is None:
            raise InputError("need a design, or a goal that has one")
        return _question(design, tolerances, limits or {}, Path())
    file, folder = load_named(goal, GOAL, lambda file, folder: (file, folder))
    of_file = f"{goal}: "
    if design is None:
        with error_prefix(of_file):
            design = base_design(file.design, file.settings, folder)
        design = design.with_values(settings or {})
    else:
        # settings of the goal apply, except to keys that were set otherwise and keys that the goal varies
        kept_keys = {numbered_key(design, key) for key in (*(settings or {}), *file.vary)}
        values = settings_of(file.settings, folder)
        replaced = {key: value for key, value in values.items() if numbered_key(design, key) not in kept_keys}
        with error_prefix(of_file):
            design = settled_by(design, replaced) if replaced else design
    with error_prefix(of_file):
        return _question(design, tolerances or file.tolerances or None, limits or file.limits, folder)


def _question(
    design: Design, tolerances: Mapping[str, object] | None, limits: Mapping[str, object], folder: Path
) -> Question:
    all_limits = read_limits(limits, design)
    torques = tuple(limit for limit in all_limits if limit.quantity.source == "search")
    for limit in torques:
        if limit.kind == ">=":
            raise InputError(f"limits.{limit.quantity.name}: need an upper limit, which is the torque of every run")
    design = with_torques(design, torques)
    required = [limit for limit in all_limits if limit.quantity.name == PROBABILITY]
    deviations: tuple[Deviation, ...] = (
        default_deviations(design) if tolerances is None else deviations_within(tolerances, design, folder)
    )
    if not deviations:
        raise InputError(f'tolerances: need at least one, such as all = "5 %"; {design.name} has none')
    return Question(
        design=design,
        deviations=deviations,
        limits=tuple(limit for limit in all_limits if limit not in torques and limit not in required),
        wanted=tuple(required),
        assumed=tolerances is None,
    )
