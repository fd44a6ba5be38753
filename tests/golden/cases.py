"""Commands whose JSON is kept in this folder, each in a small case.

`python -m tests.golden.cases` compares the JSON of today with the kept files. Names of cases restrict it to them,
`--write` keeps the JSON of today, and `--exact` compares every bit of the numbers, which depend on the processor and on
the versions of the libraries.
"""

from __future__ import annotations

import argparse
import contextlib
import io
import json
import math
import os
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from forficula.cli import main
from forficula.design import load_design, save_design
from tests.letters import QUICK

KEPT = Path(__file__).parent

Settings = dict[str, object]

_JOINT: Settings = {"protocol.timestep": "0.2 ms"}

_STUDY = """
design = "letter.toml"
[factors]
"tendon.left.stiffness" = ["0.4 N/cm", "0.6 N/cm"]
"""

_GOAL = """
name = "goal"
design = "letter.toml"
[vary]
"tendon.left.stiffness" = { low = "0.4 N/cm", high = "0.6 N/cm" }
[objectives]
mass = "least"
[search]
runs = 4
batch = 4
neighbours = 8
"""

_OBSERVED = """
design = "letter.toml"
[unknown]
"tendon.left.stiffness" = ["0.4 N/cm", "0.6 N/cm"]
[sampling]
samples = 2
directed = 0
[[fact]]
name = "closes"
quantity = "closed"
until = "close"
"""

_CYCLED = """
based_on = "binder2025"
[tendon]
area = "18.75 mm^2"
[tendon.law]
name = "rubber"
linear_modulus = "4.8 MPa"
[tendon.law.stiffness_drift]
kind = "logarithm"
rate = -0.05
interval = [-0.06, -0.04]
seen = [1, 2]
[protocol]
stages = [
  {name = "settle", drive = "none", until = "time", hold = "0 s", time_limit = "50 ms"},
  {name = "fold", drive = "fold", until = "folded", hold = "0 s", time_limit = "0.2 s"},
]
"""

_FILES = {"cycled.toml": _CYCLED, "study.toml": _STUDY, "goal.toml": _GOAL, "observed.toml": _OBSERVED}

_SPECIMENS = [f"specimen-made-up-{number}.csv" for number in (1, 2, 3)]

# arguments of the commands
CASES: dict[str, tuple[str, ...]] = {
    "designs": ("designs",),
    "studies": ("studies",),
    "materials": ("materials",),
    "keys": ("keys",),
    "keys-of-a-part": ("keys", "guard"),
    "schema-summary": ("schema", "summary"),
    "schema-landscape": ("schema", "landscape"),
    "schema-row": ("schema", "row"),
    "schema-assumptions": ("schema", "assumptions"),
    "size": ("size", "binder2025", "--material", "tpu-82a", "--stiffness", "10 N/cm"),
    "run-of-a-joint": ("run", "joint.toml", "--no-engine", "--tolerate"),
    "run-of-a-sheet": ("run", "letter.toml", "--no-engine", "--tolerate"),
    "cycles": ("run", "cycled.toml", "--no-confirm", "--no-engine", "--tolerate", "--cycles", "2"),
    "landscape-of-a-joint": ("landscape", "binder2025-joint", "--no-simulation"),
    "landscape-of-a-sheet": ("landscape", "letter-fold", "--no-simulation"),
    "landscape-of-a-net": ("landscape", "four-plate-snap", "--no-simulation"),
    "landscape-with-a-run": ("landscape", "joint.toml", "--tolerate"),
    "convergence": ("converge", "letter.toml", "--timesteps", "1 0.5 ms", "--tolerate"),
    "assumptions": ("assumptions", "letter.toml", "--only", "slow rise", "--tolerate"),
    "study": ("study", "study.toml", "--keep", "0"),
    "static-map": ("landscape", "binder2025-joint", "--over", 'tendon.rest_length="4..5 cm step 1"'),
    "material": (
        "material",
        *(f"specimen-made-up-{n}.csv" for n in (1, 2, 3)),
        "--length",
        "60 mm",
        "--area",
        "5 mm^2",
    ),
    "parts-of-a-sheet": ("make", "letter-fold"),
    "parts-of-a-joint": ("make", "binder2025-joint"),
    "bill-of-a-joint": ("make", "binder2025-joint", "--part", "joint"),
    "optimum": ("optimise", "goal.toml", "--keep", "0"),
    "tolerance": ("tolerance", "letter.toml", "--tolerance", "facet.thickness=1 %", "--runs", "20", "--keep", "0"),
    "identification": ("identify", "observed.toml"),
}

# cases that keep a file of the results instead of the text that the command prints
WRITTEN = {"cycles": "cycles.json", "bill-of-a-joint": "bill.json"}

# values that differ from run to run or from machine to machine, and explanations in schemas
_PASSING = {"description", "versions", "seconds", "time_taken_s", "cpu_s", "elapsed_s"}


def answer(case: str, folder: Path) -> Any:
    """Return the JSON that the command of a case writes; versions and times that the command took are left out.

    Args:
        case: name of a case.
        folder: an empty folder in which the command runs.
    """
    save_design(load_design("letter-fold", QUICK), folder / "letter.toml")
    save_design(load_design("binder2025-joint", _JOINT), folder / "joint.toml")
    for name, text in _FILES.items():
        (folder / name).write_text(text, "utf-8")
    written = io.StringIO()
    with contextlib.chdir(folder), contextlib.redirect_stdout(written):
        if case == "material":
            main(("new", "specimen.csv", "--tests", "--quiet"))
        written.truncate(written.seek(0))
        # a schema is JSON in any case; commands end without a status, or with one that says what failed
        with contextlib.suppress(SystemExit):
            main((*CASES[case], *(() if case.startswith("schema") else ("--json",))))
    text = next(folder.rglob(WRITTEN[case])).read_text("utf-8") if case in WRITTEN else written.getvalue()
    return _lasting(json.loads(text))


def _lasting(value: Any) -> Any:
    if isinstance(value, dict):
        return {key: _lasting(item) for key, item in value.items() if key not in _PASSING}
    return [_lasting(item) for item in value] if isinstance(value, list) else value


def kept(case: str) -> Any:
    """Return the kept JSON of a case."""
    return json.loads((KEPT / f"{case}.json").read_text("utf-8"))


def differences(kept: Any, today: Any, place: str = "", *, relative: float, absolute: float) -> Iterator[str]:
    """Name every value that is in the kept JSON and is missing or another one today; new keys are allowed.

    Args:
        kept: the kept JSON.
        today: that of today.
        place: keys that lead to both.
        relative: tolerance of a number by its size.
        absolute: least tolerance of a number.
    """
    if isinstance(kept, dict) and isinstance(today, dict):
        for key, value in kept.items():
            if key not in today:
                yield f"{place}.{key} is missing"
            else:
                yield from differences(value, today[key], f"{place}.{key}", relative=relative, absolute=absolute)
    elif isinstance(kept, list) and isinstance(today, list) and len(kept) == len(today):
        for index, (before, after) in enumerate(zip(kept, today, strict=True)):
            yield from differences(before, after, f"{place}.{index}", relative=relative, absolute=absolute)
    elif isinstance(kept, float) and isinstance(today, float | int) and not isinstance(today, bool):
        if not math.isclose(kept, today, rel_tol=relative, abs_tol=absolute):
            yield f"{place}: {today!r} instead of {kept!r}"
    elif kept != today:
        yield f"{place}: {today!r} instead of {kept!r}"


def _command() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("cases", nargs="*", metavar="CASE")
    parser.add_argument("--write", action="store_true", help="keep the JSON of today")
    parser.add_argument("--exact", action="store_true", help="compare every bit of the numbers")
    arguments = parser.parse_args()
    relative, absolute = (0.0, 0.0) if arguments.exact else (1e-6, 1e-9)
    failed = 0
    for case in arguments.cases or CASES:
        with tempfile.TemporaryDirectory() as folder:
            today = answer(case, Path(folder))
        if arguments.write:
            text = json.dumps(today, indent=1, ensure_ascii=False)
            (KEPT / f"{case}.json").write_text(text + "\n", "utf-8")
            continue
        different = list(differences(kept(case), today, relative=relative, absolute=absolute))
        failed += bool(different)
        print(f"{case}: {'equal' if not different else f'{len(different)} differ'}", flush=True)
        for line in different[:10]:
            print("   ", line[:300])
    return int(failed > 0)


if __name__ == "__main__":
    os.environ.setdefault("MPLBACKEND", "Agg")
    sys.exit(_command())
