"""Compare least slow torques of the statics with simulated torques that grow slowly, for random fans."""

from __future__ import annotations

import argparse
import json
import math
from collections import Counter
from pathlib import Path
from typing import Any

import numpy as np

import forficula as ff
from forficula.design import Design, key_value, load_design, with_values
from forficula.dynamics import Record
from forficula.structure import hinges_of

_SEED = 30
_SHARE = 0.2
# varied by 20 % of the reference's values, but for hinge.overbend: see `_OVERBENDS`
_KEYS = (
    "pattern.proximal_length",
    "pattern.distal_length",
    "pattern.hub_radius",
    "pattern.sector_angle",
    "membrane.youngs_modulus",
    "membrane.thickness",
    "membrane.margin",
    "membrane.margin_limit",
    "hinge.overbend",
    "tendon.stiffness",
    "tendon.rest_length",
    "tendon.proximal_attachment",
    "tendon.distal_attachment",
)
# rad, below the reference's 3 deg, with which few of the fans fold slowly
_OVERBENDS = math.radians(1.5), math.radians(3.0)
_RISE = 40.0  # s
_BEYOND = 1.3  # by which a ramp ends above the largest torque of the statics
_LET_GO = math.radians(-30)  # a hinge that passes it has snapped
_ALLOWED = 0.03


def main() -> None:
    """Compare and print a table."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--first", type=int, default=0, help="number of the first fan")
    parser.add_argument("--fans", type=int, default=30, help="how many of them")
    parser.add_argument("--json", type=Path, help="write the numbers here, too")
    arguments = parser.parse_args()
    rows = []
    print("torques in N cm\n\n| fan | | statics | range | inertia from | ramp | |\n|--:|---|--:|---|--:|--:|---|")
    for number in range(arguments.first, arguments.first + arguments.fans):
        for row in compare(random_fan(number)):
            rows.append({"fan": number, **row})
            print(table_row(rows[-1]), flush=True)
    counts = Counter(row["found"] for row in rows)
    print(f"\n{dict(counts)}")
    if arguments.json is not None:
        arguments.json.write_text(json.dumps(rows, indent=2) + "\n")


def random_fan(number: int) -> Design:
    """The reference with other values, the same for the same number."""
    reference, random = load_design("binder2025"), np.random.default_rng([_SEED, number])
    values = {key: key_value(reference, key) * random.uniform(1 - _SHARE, 1 + _SHARE) for key in _KEYS}
    values["hinge.overbend"] = random.uniform(*_OVERBENDS)
    return with_values(reference, {**values, "protocol.initial_overbend": math.radians(1.4)})


def compare(design: Design) -> list[dict[str, Any]]:
    """What statics and a ramp find for folding, and for opening where the ramp folds the fan."""
    courses = {course.name: course for course in ff.landscape(design, points=21).courses}
    spans = {name: course.span or (math.inf, math.inf) for name, course in courses.items()}
    largest = {name: _BEYOND * spans[name][1] for name in ("fold", "unfold")}
    strengths = {"fold": design.protocol.fold_torque, "unfold": design.protocol.unfold_torque}
    torques = {name: largest[name] if math.isfinite(largest[name]) else strengths[name] for name in largest}
    record = ff.run(with_values(design, ramp(torques["fold"], torques["unfold"])))
    rows = []
    for name in ("fold", "unfold"):
        if not any(end.stage.drive == name for end in record.stages):
            continue
        least, helped = courses[name].least, courses[name].inertial_help
        low, high = spans[name]
        simulated = let_go(record, name, torques[name])
        rows.append(
            {
                "transition": name,
                "statics": least,
                "range": [low, high],
                "inertia": None if helped is None else helped.torque,
                "ramp": simulated,
                "found": judged(least, low if helped is None else min(low, helped.torque), high, simulated),
            }
        )
    return rows


def ramp(fold: float, unfold: float, rise: float = _RISE) -> dict[str, Any]:
    """Settings of a protocol whose torques, N m, grow slowly."""
    return {
        "protocol.rise": rise,
        "protocol.least_hold": 0.0,
        "protocol.sample_interval": 0.02,
        "protocol.fold_torque": fold,
        "protocol.unfold_torque": unfold,
        "protocol.stages": [
            {"name": "settle", "drive": "none", "until": "time", "time_limit": 0.5},
            # a slack wing creeps to its goal against the dampers
            {"name": "fold", "drive": "fold", "until": "folded", "time_limit": 1.5 * rise},
            {"name": "release", "drive": "none", "until": "rest", "time_limit": 3.0},
            {"name": "unfold", "drive": "unfold", "until": "opened", "time_limit": 1.1 * rise},
        ],
    }


def let_go(record: Record, name: str, torque: float) -> float | None:
    """Torque at which the last distal hinge folds, or at which all are open, N m; None where a ramp misses its goal.

    A wing that folds is slack beyond some angle and creeps to its goal against the dampers, so the snap counts.
    """
    end = next(stage for stage in record.stages if stage.stage.drive == name)
    if end.goal_time is None:
        return None
    rise = record.design.protocol.rise
    if name == "unfold":
        return torque * min((end.goal_time - end.start) / rise, 1.0)
    rows = np.flatnonzero((record.time >= end.start) & (record.time <= end.end))
    angles = record.series["hinge_angle"][rows][:, list(hinges_of(record.structure, "ring"))]
    short = (angles > _LET_GO).any(axis=1)
    last = float(record.time[rows[np.flatnonzero(short)[-1]]])
    return torque * min((last - end.start) / rise, 1.0)


def judged(least: float | None, low: float, high: float, simulated: float | None) -> str:
    """How a ramp compares with the statics."""
    if least is None or simulated is None:
        return "neither" if least is None and simulated is None else "one only"
    if abs(simulated - least) <= _ALLOWED * least:
        return "within 3 %"
    return "in the range" if (1 - _ALLOWED) * low <= simulated <= (1 + _ALLOWED) * high else "apart"


def table_row(row: dict[str, Any]) -> str:
    """A row as Markdown, N cm."""
    cells = [_shown(row[name]) for name in ("statics", "inertia", "ramp")]
    low, high = row["range"]
    spread = f"{_shown(low)} to {_shown(high)}" if high > (1 + _ALLOWED) * low else ""
    return f"| {row['fan']} | {row['transition']} | {cells[0]} | {spread} | {cells[1]} | {cells[2]} | {row['found']} |"


def _shown(torque: float | None) -> str:
    return "none" if torque is None or not math.isfinite(torque) else f"{100 * torque:.3g}"


if __name__ == "__main__":
    main()
