"""What does contact cost, and how coarse may the surfaces be that touch? Wings of 1, 2, 3 and 5 units side by side.

python benchmarks/contact.py [--units N ...] [--strips N ...] [--json FILE]
"""

from __future__ import annotations

import argparse
import json
import time
from pathlib import Path
from typing import Any

from forficula.analysis import measure
from forficula.analysis.crossing_panels import panel_crossing
from forficula.analysis.package import packages
from forficula.design import Design, load_design
from forficula.dynamics import Record, compile_model, simulate
from forficula.structure.fans import veins

_SECTORS = {1: "20 deg", 2: "20 deg", 3: "15 deg", 5: "12 deg"}
_TORQUES = {1: "50 N cm", 2: "100 N cm", 3: "100 N cm", 5: "100 N cm"}


def wing(units: int, *, contact: bool, **values: object) -> Design:
    """A wing that settles, folds and is let go, at 0.1 ms."""
    stages = [
        {"name": "settle", "drive": "none", "until": "time", "hold": "0 s", "time_limit": "0.05 s"},
        {"name": "fold", "drive": "fold", "until": "folded", "hold": "0.1 s", "time_limit": "0.4 s"},
        {"name": "release folded", "drive": "none", "until": "time", "hold": "0 s", "time_limit": "0.2 s"},
    ]
    chosen = {
        "pattern.units": units,
        "pattern.sector_angle": _SECTORS[units],
        "protocol.fold_torque": _TORQUES[units],
        "protocol.timestep": "0.1 ms",
        "protocol.contact": contact,
        "protocol.stages": stages,
    }
    return load_design("binder2025", {**chosen, **values})


def timed(design: Design) -> tuple[Record, float]:
    """A run, and the CPU time of a step, us."""
    model = compile_model(design)
    start = time.process_time()
    (record,) = simulate([model], threads=1)
    spent = time.process_time() - start
    return record, 1e6 * spent * float(design.protocol.timestep) / float(record.time[-1])


def row(units: int, strips: int, **values: object) -> dict[str, Any]:
    """One wing with and without contact, one after the other; the better of two rounds each."""
    veins._STRIPS = strips
    free, touching = (wing(units, contact=contact, **values) for contact in (False, True))
    rounds = [(timed(free)[1], *timed(touching)) for _ in range(2)]
    record, without, with_contact = rounds[0][1], min(times[0] for times in rounds), min(times[2] for times in rounds)
    crossing, outcome, package = panel_crossing(record), measure(record), packages(record).get("folded")
    fold = outcome.transitions["fold"]
    return {
        "units": units,
        "strips": strips,
        "without_us": without,
        "with_us": with_contact,
        "ratio": with_contact / without,
        "status": outcome.status,
        "fold_time_s": None if fold is None else fold.time,
        "height_m": None if package is None else package[1].height,
        "area_ratio": None if package is None else package[1].area_ratio,
        "crossing_m": None if crossing is None else crossing.depth,
        "residual": outcome.energy_balance.residual,
    }


def main() -> None:
    """Print a table, and write it where that is wanted."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").partition("\n")[0])
    parser.add_argument("--units", type=int, nargs="+", default=[1, 2, 3, 5], choices=sorted(_SECTORS))
    parser.add_argument("--strips", type=int, nargs="+", default=[3])
    parser.add_argument("--json", type=Path)
    arguments = parser.parse_args()
    rows = []
    for units in arguments.units:
        for strips in arguments.strips:
            rows.append(row(units, strips))
            print(
                " ".join(
                    f"{name} {value:.3g}," if isinstance(value, float) else f"{name} {value},"
                    for name, value in rows[-1].items()
                ),
                flush=True,
            )
    if arguments.json:
        arguments.json.write_text(json.dumps(rows, indent=1) + "\n", "utf-8")


if __name__ == "__main__":
    main()
