"""Kept runs as data for a page that plays them back."""

from __future__ import annotations

import json
from collections.abc import Iterable
from typing import Any

import numpy as np

from forficula.analysis import Verdict
from forficula.show.page.parts.outcome_tables import outcome_tables
from forficula.show.page.parts.run_sentences import outcome_sentence, readable
from forficula.show.page.playback import BUDGET, make_clip
from forficula.show.page.run_page import playback_data
from forficula.structure import drive_of, drive_unit
from forficula.study.running.kept_runs import KeptRun

# bytes of all runs on a page; the script takes 0.7 MB more
_RUNS = 7_950_000
# a clip with fewer bytes does not show the motion
_LEAST_BUDGET = 18_500


def runs_data(kept: Iterable[KeptRun], count: int, beside: int = 0) -> list[dict[str, Any]]:
    """Return kept runs as data for JSON, ordered by point and, within a point, by the protocol's transitions.

    Args:
        kept: runs that the page can play back.
        count: number of these runs; they share a budget of bytes, so that a page with 60 points stays below 10 MB.
        beside: bytes of this budget that other parts of the page take.
    """
    return sorted((_run(run, (_RUNS - beside) // max(count, 1)) for run in kept), key=_order)


def _order(run: dict[str, Any]) -> tuple[int, int, str]:
    """Return the sort key: the point and, within it, the transition in the protocol's order."""
    return run["point"], -1 if run["transition"] is None else run["transition"], run["part"]


def _run(run: KeptRun, size: int) -> dict[str, Any]:
    """Return a run as data for JSON of about a number of bytes, but with enough frames to show the motion."""
    # base64 takes four letters for three bytes
    spare = 3 * (size - len(json.dumps(_run_data(run, 0)))) // 4
    return _run_data(run, int(np.clip(spare, _LEAST_BUDGET, BUDGET)))


def _run_data(run: KeptRun, budget: int) -> dict[str, Any]:
    """Return the title, the numbers and the playback of a run, within a budget of bytes."""
    outcome, structure = run.outcome, run.record.structure
    units = {
        transition.name: drive_unit(structure, drive_of(structure, transition.drive))
        for transition in structure.transitions
    }
    driven = [
        f"{transition.wording.doing} with {readable(result.strength, units[transition.name])}"
        for transition in structure.transitions
        if (result := outcome.transitions[transition.name]) is not None
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
