"""The plan of a tolerance in its folder: settled once, so that what is taken up again comes to the same."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import asdict
from pathlib import Path
from typing import Any

from forficula.files import write_text
from forficula.goals.tolerance.plan import PLANS, Plan
from forficula.goals.tolerance.question import Question
from forficula.lock import held

_FILE = "plan.json"


def kept_plan(folder: Path, question: Question, minutes: float, seed: int) -> Plan | None:
    """The plan that a folder has for a question, or None where it has none, or one for another question."""
    try:
        found = json.loads((folder / _FILE).read_text("utf-8"))
    except (OSError, ValueError):
        return None
    if not isinstance(found, dict) or found.get("asked") != _asked(question, minutes, seed):
        return None
    return next((plan for plan in PLANS if _plain(plan) == found.get("plan")), None)


def saved_plan(folder: Path, question: Question, minutes: float, seed: int, plan: Plan) -> Plan:
    """Write a plan where the folder has none for the question yet, and hand on the one that it has then.

    Of several processes that share the runs the first one settles it.

    Raises:
        InputError: the folder cannot be written.
    """
    with held(folder / f".{_FILE}.lock"):
        if (kept := kept_plan(folder, question, minutes, seed)) is not None:
            return kept
        asked = {"asked": _asked(question, minutes, seed), "plan": _plain(plan)}
        write_text(folder / _FILE, json.dumps(asked, indent=1) + "\n")
    return plan


def _asked(question: Question, minutes: float, seed: int) -> Mapping[str, Any]:
    """What was asked, as JSON has it."""
    return {
        "design_hash": question.design.hash,
        "tolerances": {each.key: [each.distribution, each.size, each.relative] for each in question.deviations},
        "limits": [str(limit) for limit in question.limits],
        "minutes": minutes,
        "seed": seed,
    }


def _plain(plan: Plan) -> Mapping[str, Any]:
    return {**asdict(plan), "steps": list(plan.steps)}
