"""Questions from designs, settings, and tolerances in files or tables."""

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
    file, folder = load_named(goal, GOAL, lambda file, folder: (file, folder))
    of_file = f"{goal}: "
    if design is None:
        with error_prefix(of_file):
            design = base_design(file.design, file.settings, folder)
        design = design.with_values(settings or {})
    else:
        # settings of the goal hold but for keys that were given otherwise, and what the goal varies
        own = {numbered_key(design, key) for key in (*(settings or {}), *file.vary)}
        values = settings_of(file.settings, folder)
        replaced = {key: value for key, value in values.items() if numbered_key(design, key) not in own}
        with error_prefix(of_file):
            design = settled_by(design, replaced) if replaced else design
    with error_prefix(of_file):
        return _question(design, tolerances or file.tolerances or None, limits or file.limits, folder)


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
