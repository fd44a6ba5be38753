"""Checks as plain data."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

from forficula.make.check import Check


def checks_json(checks: Sequence[Check]) -> list[dict[str, Any]]:
    """Checks as plain data, what was not found None; numbers have their unit behind their key, angles are in deg.

    >>> checks_json([Check(name="gap", part="fold0", ok=True, value=0.0005, limit=0.0004, unit="m", text="wide")])
    [{'name': 'gap', 'part': 'fold0', 'ok': True, 'value_m': 0.0005, 'limit_m': 0.0004, 'text': 'wide'}]
    """
    return [_plain(check) for check in checks]


def _plain(check: Check) -> dict[str, Any]:
    unit, factor = ("deg", math.degrees(1.0)) if check.unit == "rad" else (check.unit, 1.0)
    suffix = unit.replace("/", "_per_").replace("^", "").replace(" ", "_")
    keys = [f"{key}_{suffix}" if suffix else key for key in ("value", "limit")]
    numbers = [factor * each if math.isfinite(each) else None for each in (check.value, check.limit)]
    return {
        "name": check.name,
        "part": check.part,
        "ok": check.ok,
        **dict(zip(keys, numbers, strict=True)),
        "text": check.text,
    }
