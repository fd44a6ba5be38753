"""Designs that a study runs: at its points, and with the values that a search tries."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from forficula.design import Design, StageSection, put, stage_drives, with_values
from forficula.structure import drive_keys
from forficula.study.search_steps import Search


def point_design(base: Design, point: Mapping[str, object], search: Search | None = None) -> Design:
    """Return the design at a point of a study.

    Args:
        base: the design that is varied.
        point: values by key.
        search: the design must also accept the values of this search.

    Raises:
        InputError: the values are not allowed together.
    """
    design = with_values(base, dict(point))
    for step in search.steps if search is not None else ():
        if step.key not in drive_keys(design):
            for value in step.values:
                with_values(design, {step.key: value})
    return design


def first_design(design: Design, search: Search, value: float) -> Design:
    """Return the design with a value (SI) of the first transition; its protocol ends before the next drive, if any."""
    stages, first = design.protocol.stages, search.first
    if search.next_drive is not None:
        stages = until_driven(stages, _first_driven(stages, first.drive))
    return _with(design, stages, {first.key: first.sign * value})


def until_driven(stages: Sequence[StageSection], last: int) -> tuple[StageSection, ...]:
    """Return the stages up to a driven one, which takes over the final state of the release after it.

    Args:
        stages: stages of a protocol.
        last: number of the driven stage.
    """
    return (*stages[:last], *(_ending_in(stage, stages[last + 1 :]) for stage in stages[last : last + 1]))


def _ending_in(stage: StageSection, following: Sequence[StageSection]) -> StageSection:
    """Return a driven stage with the state in which the release after it, which is removed, would end."""
    release = next((stage_after for stage_after in following[:1] if not stage_drives(stage_after)), None)
    if stage.state is not None or release is None or release.state is None:
        return stage
    return stage.model_copy(update={"state": release.state})


def release_design(design: Design, search: Search, value: float) -> Design:
    """Return the design with a value (SI) of the first transition, whose protocol ends before the second."""
    stages, first = design.protocol.stages, search.first
    return _with(design, stages[: _first_driven(stages, search.next_drive or "")], {first.key: first.sign * value})


def second_design(design: Design, search: Search, value: float) -> Design:
    """Return the design with the reference value of the first transition and a value (SI) of the second."""
    if search.second is None:
        return design
    first, second = search.first, search.second
    values = {first.key: first.sign * search.reference, second.key: second.sign * value}
    return _with(design, design.protocol.stages, values)


def _first_driven(stages: Sequence[StageSection], drive: str) -> int:
    """Return the number of the first stage that has a drive; the number of stages if none has it."""
    return next((number for number, stage in enumerate(stages) if drive in stage_drives(stage)), len(stages))


def _with(design: Design, stages: Sequence[StageSection], values: Mapping[str, float]) -> Design:
    """Replace stages and values. Strengths of drives were checked when they were read; other values are checked here.

    Other values may change dependent ones: a law determines the stiffness.
    """
    design = put(design, "protocol.stages", tuple(stages))
    for key, value in values.items():
        design = put(design, key, value) if key in drive_keys(design) else with_values(design, {key: value})
    return design
