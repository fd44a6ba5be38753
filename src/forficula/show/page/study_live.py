"""Data of a study's structure for the engine in its page: the values of every point, and the search."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from forficula.design import TORQUE, StageSection, key_quantity, stage_drives
from forficula.dynamics import compile_model, why_not_portable
from forficula.errors import InputError
from forficula.quantities import show_quantity
from forficula.show.page.data.live_data import live_data
from forficula.show.page.live_page import live_page_data, start_clip
from forficula.study import Study
from forficula.study.search import SEARCH_TEXTS
from forficula.study.search_steps import Search, SearchStep


def study_live(study: Study, *, binned: bool = False) -> dict[str, Any]:
    """Return the data with which the engine in a study's page computes what the study would compute.

    Args:
        study: the study.
        binned: whether the page shows bins of several points.

    Returns:
        Data for JSON, as `live_data` has it, and

        - `bench`: the structure of the study's design, as on a page of `forficula open`;
        - `points`: SI values by key for each point;
        - `search`: the search for least values, or None if each point is one run.

        Only "refused", with the reason, if the engine would simulate the structures differently from the study.
    """
    design = study.base
    if binned:
        return {"refused": "a bin contains several points"}
    if any(value == "none" for point in study.points for value in point.values()):
        return {"refused": "some changes remove parts of the structure"}
    if design.protocol.timestep == "auto":
        return {"refused": "each point was given a timestep of its own"}
    try:
        points = [_in_si(study, point) for point in study.points]
        why = why_not_portable(compile_model(design))
    except InputError as error:
        return {"refused": str(error)}
    if why or any(point is None for point in points):
        return {"refused": why or "some of the varied values are not numbers with units"}
    values: dict[str, list[float]] = {}
    for point in points:
        for key, value in (point or {}).items():
            values.setdefault(key, []).append(value)
    ranges = {key: (min(numbers), max(numbers)) for key, numbers in values.items()}
    for step in study.search.steps if study.search is not None else ():
        ends = [step.sign * value for value in (*step.values, study.search.reference if study.search else 0.0)]
        ranges[step.key] = (min(ends), max(ends))
    clip = start_clip(design)
    live = live_data(design, [reading.measure for reading in clip.readings], clip.mesh.anchors.tolist(), ranges)
    if "refused" in live:
        return live
    search = None if study.search is None else _search(study.search, design.protocol.stages)
    return live | {"bench": live_page_data(clip), "points": points, "search": search}


def _in_si(study: Study, point: Any) -> dict[str, float] | None:
    """Return the values of a point, SI; None if one is not a number with a unit."""
    values = {}
    for key, value in point.items():
        quantity = key_quantity(key, type(study.base))
        read = None if quantity is None else quantity.read(value, in_si=True)
        if not isinstance(read, float):
            return None
        values[key] = read
    return values


def _search(search: Search, stages: Sequence[StageSection]) -> dict[str, Any]:
    last = len(stages) - 1
    cut = search.next_drive is not None
    driven = _first_driven(stages, search.first.drive)
    second = search.second
    return {
        "first": _step(search.first, driven if cut and driven is not None else last),
        "second": None if second is None else _step(second, last),
        "release": (_first_driven(stages, search.next_drive or "") or last + 1) - 1 if cut else None,
        "reference": search.reference,
        "texts": SEARCH_TEXTS,
        "referenceText": show_quantity(search.reference, search.first.unit),
    }


def _step(step: SearchStep, until: int) -> dict[str, Any]:
    return {
        "transition": step.transition,
        "key": step.key,
        "name": step.result_name,
        "title": step.result_name.replace("_", " "),
        "values": list(step.values),
        # only torques: a status names them
        "texts": [show_quantity(value, step.unit) for value in step.values] if step.unit is TORQUE else None,
        "sign": step.sign,
        "until": until,
    }


def _first_driven(stages: Sequence[StageSection], drive: str) -> int | None:
    """Return the index of the first stage with a drive; None if no stage has it."""
    return next((number for number, stage in enumerate(stages) if drive in stage_drives(stage)), None)
