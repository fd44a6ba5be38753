"""Runs that were kept as data for a page, which plays them."""

from __future__ import annotations

import json
from collections.abc import Iterable
from typing import Any

import numpy as np

from forficula.analysis import Verdict
from forficula.show.page.parts.outcome_tables import outcome_tables
from forficula.show.page.parts.words import outcome_sentence, readable
from forficula.show.page.playback import BUDGET, make_clip
from forficula.show.page.run_page import playback_data
from forficula.structure import drive_of, drive_unit
from forficula.study.running.kept_runs import KeptRun

# bytes that all runs may take in the page, where the script takes 0.7 MB more
_RUNS = 7_950_000
# a clip with less than this does not show how it moves
_LEAST_BUDGET = 20_000


def runs_data(kept: Iterable[KeptRun], count: int, beside: int = 0) -> list[dict[str, Any]]:
    """Kept runs as data for JSON, by point and, within one, as the protocol takes its transitions.

    Args:
        kept: the runs that can be played.
        count: how many these are; they share the page's bytes, so that 60 points stay below 10 MB.
        beside: bytes of these that something else takes.
    """
    return sorted((_run(run, (_RUNS - beside) // max(count, 1)) for run in kept), key=_order)


def _order(run: dict[str, Any]) -> tuple[int, int, str]:
    """By point and, within one, as the protocol takes its transitions."""
    return run["point"], -1 if run["transition"] is None else run["transition"], run["part"]


def _run(run: KeptRun, size: int) -> dict[str, Any]:
    """A run as data for JSON that take so many bytes, if that is enough to see it move."""
    # three bytes are four letters in the page
    spare = 3 * (size - len(json.dumps(_run_data(run, 0)))) // 4
    return _run_data(run, int(np.clip(spare, _LEAST_BUDGET, BUDGET)))


def _run_data(run: KeptRun, budget: int) -> dict[str, Any]:
    """What a run is, its numbers, and its playback within a budget."""
    outcome, structure = run.outcome, run.record.structure
    units = {each.name: drive_unit(structure, drive_of(structure, each.drive)) for each in structure.transitions}
    driven = [
        f"{each.wording.doing} with {readable(came.strength, units[each.name])}"
        for each in structure.transitions
        if (came := outcome.transitions[each.name]) is not None
    ]
    return {
        "point": run.point,
        "part": run.part,
        "transition": run.transition,
        "title": ", ".join(driven) or outcome.status,
        "text": outcome_sentence(f"This {structure.appearance.whole}", outcome),
        "advice": outcome.advice,
        "failed": outcome.verdict is not Verdict.REACHED,
        "folder": run.folder,
        "numbers": "".join(outcome_tables(outcome)),
        "play": playback_data(make_clip(run.record, outcome, budget=budget)),
    }
