"""Use an installed forficula as its users do; `release/check.py` runs this in environments that hold nothing else.

It needs no repository: it works in the current folder, which should be empty, and fails at the first thing that fails.
"""

import json
import subprocess
import sys
from pathlib import Path

STUDY = """
design = "letter-fold"
ask = "run"

[factors]
"drive.close.value" = ["0.5 N cm", "1 N cm"]
"""


def forficula(*arguments: str) -> str:
    command = [str(Path(sys.executable).parent / "forficula"), *arguments]
    finished = subprocess.run(command, capture_output=True, text=True, check=False)
    if finished.returncode:
        sys.exit(f"forficula {' '.join(arguments)}: status {finished.returncode}\n{finished.stdout}{finished.stderr}")
    return finished.stdout


def needed(*paths: str) -> None:
    for path in paths:
        if not Path(path).is_file() or not Path(path).stat().st_size:
            sys.exit(f"{path}: missing or empty")


def commands() -> None:
    forficula("--help")
    forficula("run", "letter-fold", "--out", "run")
    needed("run/report.html", "run/energy.png", "run/summary.json")
    forficula("landscape", "letter-fold", "--out", "landscape")
    needed("landscape/report.html")
    Path("torques.toml").write_text(STUDY, encoding="utf-8")
    forficula("study", "torques.toml", "--out", "study")
    needed("study/report.html")
    forficula("make", "binder2025-joint", "--out", "parts")
    needed("parts/parts.html", "parts/parts.3mf", "parts/sheet.dxf")
    forficula("pattern", "miura-sheet", "--out", "sheet.fold")
    needed("sheet.fold")
    assert json.loads(forficula("designs", "--json"))


def calls() -> None:
    import forficula as ff

    design = ff.load_design("letter-fold")
    outcome = ff.measure(ff.run(design))
    assert outcome.verdict.value not in ("untrusted", "diverged"), outcome
    assert ff.landscape(design).design.name == "letter-fold"


if __name__ == "__main__":
    commands()
    calls()
