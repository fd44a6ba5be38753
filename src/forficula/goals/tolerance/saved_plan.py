"""Plan of a tolerance analysis, stored in its folder so that a continued analysis gives the same result."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import asdict
from pathlib import Path
from typing import Any

from forficula.files import write_text
from forficula.goals.tolerance.plan import PLANS, Plan
from forficula.goals.tolerance.question import Question
from forficula.lock import hold_lock

_FILE = "plan.json"


def kept_plan(folder: Path, question: Question, minutes: float, seed: int) -> Plan | None:
    """Return the plan of a folder for a question; None if it has none, or one for another question."""
    try:
        content = json.loads((folder / _FILE).read_text("utf-8"))
    except (OSError, ValueError):
        return None
    if not isinstance(content, dict) or content.get("asked") != _request(question, minutes, seed):
        return None
    return next((plan for plan in PLANS if _plain(plan) == content.get("plan")), None)


def saved_plan(folder: Path, question: Question, minutes: float, seed: int, plan: Plan) -> Plan:
    """Write a plan if the folder has none for the question yet, and return the plan of the folder.

    Among several processes that share the runs, the first one determines the plan.

    Raises:
        InputError: the folder cannot be written.
    """
    with hold_lock(folder / f".{_FILE}.lock"):
        if (kept := kept_plan(folder, question, minutes, seed)) is not None:
            return kept
        content = {"asked": _request(question, minutes, seed), "plan": _plain(plan)}
        write_text(folder / _FILE, json.dumps(content, indent=1) + "\n")
    return plan


def _request(question: Question, minutes: float, seed: int) -> Mapping[str, Any]:
    """Return the question as JSON data."""
    return {
        "design_hash": question.design.hash,
        "tolerances": {
            deviation.key: [deviation.distribution, deviation.size, deviation.relative]
            for deviation in question.deviations
        },
        "limits": [str(limit) for limit in question.limits],
        "minutes": minutes,
        "seed": seed,
    }


def _plain(plan: Plan) -> Mapping[str, Any]:
    return {**asdict(plan), "steps": list(plan.steps)}
