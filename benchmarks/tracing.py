"""Tracing of photographs with known content: errors of vertices, edges and letters, and whether doubt is reported.

Every family of patterns is drawn by Pillow, photographed with perspective, uneven light, blur, noise and JPEG, and
traced. Then pictures with random distortions, up to unreadable ones, are traced and counted.
"""

from __future__ import annotations

import argparse
import json
import math
import os
import platform
import sys
import time
from collections import Counter
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

sys.path.insert(0, str(Path(__file__).parents[1]))

from forficula.design import design_pattern, load_design
from forficula.dynamics import versions
from forficula.errors import InputError
from forficula.make.flat.unfolding import unfolded
from forficula.pattern import (
    CreasePattern,
    miura_pattern,
    pleat_pattern,
    strip_pattern,
    vertex_pattern,
    waterbomb_base,
    waterbomb_pattern,
    yoshimura_pattern,
)
from forficula.pattern.picture.picture_file import picture_of_array
from forficula.pattern.picture.trace import Trace
from forficula.pattern.picture.trace_picture import trace_picture
from tests.pattern.picture.drawn_pictures import (
    INKS,
    Distortion,
    Photograph,
    compared,
    drawn_page,
    photographed,
)

_LARGE = (3456, 2304)  # pixels, 8 megapixels
_SMALL = (1200, 1000)
_FANS = ("fan", "graded fan")


def patterns() -> dict[str, CreasePattern]:
    """Return a flat pattern of every family."""
    degrees = math.radians
    return {
        "miura 5 x 5": miura_pattern(5, 5, 0.03, 0.025, degrees(60)),
        "miura 9 x 8": miura_pattern(9, 8, 0.03, 0.025, degrees(70)),
        "waterbomb base": waterbomb_base(0.1),
        "waterbomb 3 x 3": waterbomb_pattern(3, 3, 0.04),
        "yoshimura 4 x 4": yoshimura_pattern(4, 4, 0.03, 0.02),
        "kresling net": _net(design_pattern(load_design("kresling-cell"))),
        "pleats": pleat_pattern([0.03, 0.02, 0.04, 0.02], 0.1, "MVM"),
        "vertex of 4": vertex_pattern([degrees(angle) for angle in (60, 100, 120, 80)], 0.06, "MMMV"),
        "vertex of 6": vertex_pattern([degrees(60)] * 6, [0.06, 0.05, 0.06, 0.05, 0.06, 0.05], "MVMVMV"),
        "strip": strip_pattern(0.12, 0.1, degrees(20), degrees(20), 0.04, valley=True),
        "fan": design_pattern(load_design("binder2025")),
        "graded fan": design_pattern(load_design("graded-fan")),
    }


def _net(pattern: CreasePattern) -> CreasePattern:
    """Return a pattern laid flat, with a border where it was opened."""
    laid = unfolded(pattern).pattern
    return replace(laid, edges_assignment=tuple("B" if letter == "C" else letter for letter in laid.edges_assignment))


def traced(photograph: Photograph) -> Trace:
    """Trace a photograph with the page's width and height and its corners."""
    return trace_picture(picture_of_array(photograph.pixels), photograph.page, photograph.corners)


def family(name: str, pattern: CreasePattern, size: tuple[int, int], *, dashed: bool) -> dict[str, Any]:
    """Trace one photograph of a pattern with moderate distortions."""
    distortion = Distortion(size=size, blur=1.0 if size == _SMALL else 2.0)
    page = drawn_page(pattern, round(1.1 * max(size)), dashed=dashed)
    photograph = photographed(*page, distortion, seed=1)
    picture = picture_of_array(photograph.pixels)
    start = time.process_time()
    row: dict[str, Any] = {"pattern": name, "dashed": dashed}
    try:
        trace = trace_picture(picture, photograph.page, None)
    except InputError as error:
        return {**row, "fault": str(error)}
    row["cpu_s"] = time.process_time() - start
    return {**row, **_numbers(pattern, photograph, trace)}


def _numbers(pattern: CreasePattern, photograph: Photograph, trace: Trace) -> dict[str, Any]:
    result = compared(pattern, photograph, trace)
    return {
        "vertices": result.vertices,
        "error_percent": 100 * result.error,
        "edges": result.edges,
        "right": result.right,
        "wrong": result.wrong,
        "unassigned": result.unassigned,
        "extra": result.extra,
        "complete": result.complete,
        "doubt": trace.is_doubtful,
        "silent": result.silent,
    }


def random_picture(number: int, size: tuple[int, int]) -> dict[str, Any]:
    """Trace a photograph with random distortions, from slight ones to unreadable ones."""
    rng = np.random.default_rng(number)
    every = patterns()
    name = str(rng.choice(list(every)))
    pattern = every[name]
    severity = float(rng.uniform(0, 1))
    scale = size[0] / _SMALL[0]
    distortion = Distortion(
        size=size,
        perspective=float(rng.uniform(0, 0.12)),
        turn=float(rng.uniform(-30, 30)),
        light=float(rng.uniform(0, 0.7)),
        cast=float(rng.uniform(0, 0.25)),
        blur=scale * (0.5 + 4.5 * severity * float(rng.uniform(0, 1))),
        noise=0.002 + 0.12 * severity * float(rng.uniform(0, 1)),
        quality=int(95 - 85 * severity * float(rng.uniform(0, 1))),
    )
    inks = {
        letter: tuple(int(value) for value in np.clip(np.array(colour) + rng.integers(-40, 41, 3), 0, 235))
        for letter, colour in INKS.items()
    }
    inks["B"] = (int(rng.integers(0, 60)),) * 3
    dashed, line = bool(rng.random() < 0.5), float(rng.uniform(0.0015, 0.005))
    page = drawn_page(pattern, round(1.1 * max(size)), line=line, dashed=dashed, inks=inks)
    photograph = photographed(*page, distortion, seed=number)
    row: dict[str, Any] = {"number": number, "pattern": name, "dashed": dashed, "line": line}
    row |= {key: getattr(distortion, key) for key in ("turn", "light", "blur", "noise", "quality")}
    try:
        trace = traced(photograph)
    except InputError as error:
        return {**row, "fault": str(error)}
    return {**row, **_numbers(pattern, photograph, trace)}


def summary(rows: list[dict[str, Any]]) -> dict[str, Any]:
    """Count the outcomes of random pictures, with and without fans, whose lines merge at the hub."""
    counts = {}
    for which, chosen in (
        ("without fans", [row for row in rows if row["pattern"] not in _FANS]),
        ("fans", [row for row in rows if row["pattern"] in _FANS]),
    ):
        read = [row for row in chosen if "fault" not in row]
        complete = [row for row in read if row["complete"]]
        counts[which] = {
            "pictures": len(chosen),
            "refused": len(chosen) - len(read),
            "complete": len(complete),
            "complete_without_doubt": sum(not row["doubt"] for row in complete),
            "incomplete_with_doubt": sum(not row["complete"] and row["doubt"] for row in read),
            "incomplete_without_doubt": sum(row["silent"] for row in read),
            "edges": sum(row["edges"][0] for row in read),
            "right": sum(row["right"] for row in read),
            "unassigned": sum(row["unassigned"] for row in read),
            "wrong": sum(row["wrong"] for row in read),
            "largest_error_percent": max((row["error_percent"] for row in complete), default=math.nan),
        }
    return counts


def main() -> None:
    """Run and report."""
    parser = argparse.ArgumentParser()
    parser.add_argument("--pictures", type=int, default=100, help="random pictures")
    parser.add_argument("--small", action="store_true", help="1.2 instead of 8 megapixels")
    parser.add_argument("--only", nargs="*", help="families to trace")
    parser.add_argument("--json", type=Path)
    arguments = parser.parse_args()
    size = _SMALL if arguments.small else _LARGE
    rows = []
    for name, pattern in patterns().items():
        if arguments.only is not None and name not in arguments.only:
            continue
        for dashed in (False, True):
            rows.append(row := family(name, pattern, size, dashed=dashed))
            print(_line(row), flush=True)
    random = []
    for number in range(arguments.pictures):
        random.append(row := random_picture(number, _SMALL))
        if row.get("wrong") or row.get("silent"):
            print(row, flush=True)
    numbers = {
        "machine": {"cores": os.cpu_count(), "python": platform.python_version(), **versions()},
        "pixels": size[0] * size[1],
        "families": rows,
        "random": random,
        "counts": summary(random),
    }
    for which, counts in numbers["counts"].items():
        print(which, counts)
    print("refused:", Counter(row["fault"] for row in random if "fault" in row).most_common(6))
    if arguments.json:
        arguments.json.write_text(json.dumps(numbers, indent=1))


def _line(row: dict[str, Any]) -> str:
    start = f"{row['pattern']}{', dashed' if row['dashed'] else ''}: "
    if "fault" in row:
        return start + row["fault"]
    return start + (
        f"vertices {row['vertices'][1]}/{row['vertices'][0]}, largest error {row['error_percent']:.3f} %, edges"
        f" {row['edges'][1]}/{row['edges'][0]}, extra {row['extra']}, letters {row['right']} right {row['wrong']} wrong"
        f" {row['unassigned']} U, {'doubt' if row['doubt'] else 'no doubt'}, {row['cpu_s']:.1f} s"
    )


if __name__ == "__main__":
    main()
