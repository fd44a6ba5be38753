"""What does contact cost, and does it keep parts apart? Wings, sheets that close, and named designs that touch.

python benchmarks/contact.py [--units N ...] [--strips N ...] [--sheets NAME ...] [--named [NAME ...]] [--json FILE]

The wings have 1, 2, 3 and 5 units. Without --named, the named designs are not run.
"""

from __future__ import annotations

import argparse
import json
import time
from pathlib import Path
from typing import Any

import numpy as np

from forficula.analysis import measure
from forficula.analysis.contact_overlap import contact_overlap
from forficula.analysis.crossing_panels import panel_crossing
from forficula.analysis.package import packages
from forficula.design import Design, design_from_text, load_design
from forficula.dynamics import Record, compile_model, simulate
from forficula.structure.fans import veins
from forficula.study.running.runs import run

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


# Sheets that a torque on every crease closes: pattern, kind of facet, and values that differ from those in `_CLOSING`.
_SHEETS: dict[str, tuple[str, str, dict[str, str]]] = {
    "two panels": (
        'kind = "pleats"\npanels = 2\npanel_lengths = ["5 cm"]\nwidth = "4 cm"\nassignment = "V"',
        "rigid",
        {"torque": "0.2 N cm"},
    ),
    "zigzag of 4 panels": (
        'kind = "pleats"\npanels = 4\npanel_lengths = ["5 cm"]\nwidth = "4 cm"\nassignment = "VM"',
        "rigid",
        {"torque": "0.1 N cm"},
    ),
    "zigzag of 3 membranes": (
        'kind = "pleats"\npanels = 3\npanel_lengths = ["5 cm"]\nwidth = "4 cm"\nassignment = "VM"',
        "membrane",
        {"torque": "0.1 N cm", "timestep": "0.02 ms"},
    ),
    "vertex of 4 rigid facets": (
        'kind = "vertex"\nsectors = ["60 deg", "90 deg", "120 deg", "90 deg"]\nlengths = ["5 cm"]\n'
        'assignment = "MVVV"\nfold = "30 deg"',
        "rigid",
        {"torque": "0.1 N cm", "time_constant": "0.1 ms", "timestep": "0.0125 ms"},
    ),
    "Miura sheet of 9 rigid facets": (
        'kind = "miura-ori"\ncolumns = 3\nrows = 3\nlong_side = "2 cm"\nshort_side = "2 cm"\n'
        'acute_angle = "60 deg"\nfold = "60 deg"',
        "rigid",
        {"torque": "0.2 N cm"},
    ),
}
_CLOSING = """
name = "closing"
source = "a benchmark"
[pattern]
{pattern}
[facet]
kind = "{kind}"
thickness = "0.5 mm"
density = "1.27 g/cm^3"
{bending}
[crease]
stiffness = "1e-3 N m/rad/m"
damping = "2e-3 N m s/rad/m"
[[support]]
of = "facet 0"
[contact]
time_constant = "{time_constant}"
[[drive]]
name = "close"
kind = "torque"
of = "creases"
value = "{torque}"
rise = "0.1 s"
[protocol]
timestep = "{timestep}"
sample_interval = "0.5 ms"
contact = {contact}
[[protocol.stages]]
name = "close"
drive = "close"
until = "time"
time_limit = "{duration}"
"""


def closing(name: str, *, contact: bool) -> Design:
    """A sheet that a torque on every crease closes."""
    pattern, kind, different = _SHEETS[name]
    bending = "" if kind == "rigid" else 'youngs_modulus = "20 MPa"'
    values = {
        "torque": "0.05 N cm",
        "timestep": "0.025 ms",
        "time_constant": "0.2 ms",
        "duration": "0.4 s",
        **different,
    }
    return design_from_text(
        _CLOSING.format(pattern=pattern, kind=kind, bending=bending, contact=str(contact).lower(), **values)
    )


def sheet_row(name: str) -> dict[str, Any]:
    """One sheet with and without contact: cost, overlap and balance."""
    (free, without), (record, with_contact) = (timed(closing(name, contact=contact)) for contact in (False, True))
    overlap = contact_overlap(record)
    folds = record.series["hinge_angle"]
    return {
        "sheet": name,
        "without_us": without,
        "with_us": with_contact,
        "ratio": with_contact / without,
        "fold_without_deg": float(np.degrees(np.abs(free.series["hinge_angle"]).max())),
        "fold_with_deg": float(np.degrees(np.abs(folds[-1]).max())),
        "overlap_of_rows": None if overlap is None else overlap.share,
        "overlap_of_steps": None if overlap is None else overlap.share_in_steps,
        "residual": measure(record).energy_balance.residual,
        "doubt": record.doubt,
    }


def _stage(drive: str, time_limit: str) -> list[dict[str, str]]:
    return [{"name": drive, "drive": drive, "until": "time", "hold": "0 s", "time_limit": time_limit}]


def _closing_torque(value: str, of: str | list[str] = "creases") -> list[dict[str, object]]:
    return [{"name": "close", "kind": "torque", "of": of, "value": value, "rise": "0.05 s"}]


# Named designs in which panels touch, and the values that differ from those of the design.
_NAMED: dict[str, dict[str, Any]] = {
    "letter-fold": {"crease.damping": "5e-3 N m s/rad/m"},
    "force-clasp": {
        "crease.fold_limit": "180 deg",
        "drive": _closing_torque("10 N cm"),
        "protocol.stages": _stage("close", "0.1 s"),
    },
    "bistable-clasp": {
        "drive": _closing_torque("0.2 N cm"),
        "protocol.stages": _stage("close", "0.1 s"),
    },
    "two-clasps": {
        "inner.crease.fold_limit": "180 deg",
        "outer.crease.fold_limit": "180 deg",
        "drive": _closing_torque("10 N cm", ["inner.crease0", "outer.crease0"]),
        "protocol.stages": _stage("close", "0.15 s"),
    },
    "earwig-midwing": {},
    "four-plate-snap": {
        "drive": _closing_torque("0.02 N cm"),
        "protocol.stages": _stage("close", "0.2 s"),
    },
    "waterbomb-base": {
        "drive": _closing_torque("0.5 N cm"),
        "protocol.stages": _stage("close", "0.3 s"),
    },
    "bistable-miura": {
        "crease.group.zigzags.fold_limit": "180 deg",
        "tendon": [],
        "drive": _closing_torque("4 N cm"),
        "protocol.stages": _stage("close", "0.1 s"),
    },
    "miura-sheet": {
        "drive.0.angle": "180 deg",
        "protocol.stages": _stage("fold", "0.5 s"),
    },
    "thick-miura": {"protocol.stages": _stage("fold", "2 s")},
}


# A named design that strong forces press flat, which takes minutes. It runs only if it is named.
_PRESSED: dict[str, dict[str, Any]] = {
    "kresling-cell": {
        "drive.0.rise": "30 ms",
        "protocol.stages": [{"name": "push", "drive": "push", "until": "time", "time_limit": "45 ms"}],
    },
}


def named_row(name: str) -> dict[str, Any]:
    """One named design in which panels touch: derived settings, cost, energy of contact, overlap and balance."""
    design, start = load_design(name, {**(_NAMED | _PRESSED)[name], "protocol.contact": True}), time.process_time()
    record = run(design)
    spent, overlap = time.process_time() - start, contact_overlap(record)
    return {
        "design": name,
        "time_constants_s": [trial.time_constant for trial in record.contact_runs],
        "timesteps_s": [trial.timestep for trial in record.contact_runs],
        "overlaps_of_steps": [trial.overlap for trial in record.contact_runs],
        "overlap_of_rows": None if overlap is None else overlap.share,
        "first_contact_s": float(record.time[np.argmax(record.series["contact_overlap"] > 0)]),
        "end_s": float(record.time[-1]),
        "dissipated_by_contact_J": float(-record.series["contact_work"][-1]),
        "residual": measure(record).energy_balance.residual,
        "cpu_s": spent,
        "verdict": measure(record).verdict.value,
        "doubt": record.doubt,
    }


def shown(values: dict[str, Any]) -> str:
    """A row as text."""
    return " ".join(
        f"{name} {value:.3g}," if isinstance(value, float) else f"{name} {value}," for name, value in values.items()
    )


def main() -> None:
    """Print a table, and write it where that is wanted."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").partition("\n")[0])
    parser.add_argument("--units", type=int, nargs="*", default=[1, 2, 3, 5], choices=sorted(_SECTORS))
    parser.add_argument("--strips", type=int, nargs="+", default=[3])
    parser.add_argument("--sheets", nargs="*", default=list(_SHEETS), choices=list(_SHEETS))
    parser.add_argument("--named", nargs="*", choices=[*_NAMED, *_PRESSED])
    parser.add_argument("--json", type=Path)
    arguments = parser.parse_args()
    rows = []
    for units in arguments.units:
        for strips in arguments.strips:
            rows.append(row(units, strips))
            print(shown(rows[-1]), flush=True)
    for name in arguments.sheets:
        rows.append(sheet_row(name))
        print(shown(rows[-1]), flush=True)
    for name in () if arguments.named is None else arguments.named or _NAMED:
        rows.append(named_row(name))
        print(shown(rows[-1]), flush=True)
    if arguments.json:
        arguments.json.write_text(json.dumps(rows, indent=1) + "\n", "utf-8")


if __name__ == "__main__":
    main()
