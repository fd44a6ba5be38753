"""Run the commands of README.md and docs/tutorial.md word for word, as a first-time reader does.

For each page the repository is cloned into a temporary folder. The steps of the page run there in order, in one shell
with an empty environment: commands of indented blocks and of cells, Python, files. The walk stops at the first step
with another exit status than the page states. It needs the network, for pip, and takes as long as the tests and the
named study together.
"""

from __future__ import annotations

import argparse
import os
import re
import shlex
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent / "extensions"))
from cells import Cell, cells_of

ROOT = Path(__file__).parents[1]
PAGES = ("README.md", "docs/tutorial.md")
# a fenced block with its options or with printed text, an indented block, or a picture or file that a cell wrote
_BLOCK = re.compile(
    r"^```(?P<kind>\{\w+\}|python|text)[^\n]*\n.*?^```$|(?:^(?: {4}[^\n]*)?\n)*^ {4}[^\n]*$",
    re.M | re.S,
)
_WRITTEN = re.compile(r"^```\{(?:picture|show|live)\} *(\S+)")
_END = "END_OF_WHAT_THE_PAGE_PRINTS"


@dataclass(frozen=True, kw_only=True)
class Step:
    """Step of a page: its line, its shell commands and their exit status."""

    line: int
    shell: str
    status: int = 0


def steps_of(page: str) -> list[Step]:
    """Return the steps of a page in order; each line of an indented block is a command."""
    steps, python = [], ""
    for block in _BLOCK.finditer(page):
        line = page.count("\n", 0, block.start()) + 1
        text = block[0]
        if block["kind"] is None:
            lines = text.replace("\\\n", " ").splitlines()
            steps += [Step(line=line + at, shell=text.strip()) for at, text in enumerate(lines) if text.strip()]
        elif block["kind"] == "text":
            continue
        elif block["kind"] == "python":
            steps.append(Step(line=line, shell=_python(text.partition("\n")[2].removesuffix("```"))))
        elif written := _WRITTEN.match(text):
            steps.append(Step(line=line, shell=f"test -s {shlex.quote(written[1])}"))
        else:
            for cell in cells_of(text):
                python += cell.text if cell.kind == "python" else ""
                steps += _steps_of_cell(cell, line, python)
    return steps


def _lines(text: str) -> Iterator[str]:
    for line in text.replace("\\\n", " ").splitlines():
        if command := line.strip():
            yield command


def _steps_of_cell(cell: Cell, line: int, python: str) -> Iterator[Step]:
    if cell.kind == "file":
        yield Step(line=line, shell=f"cat > {shlex.quote(cell.name)} <<'{_END}'\n{cell.text}{_END}")
    elif cell.kind == "python":
        yield Step(line=line, shell=_python(python))
    else:
        for command in _lines(cell.text):
            yield Step(line=line, shell=command, status=int(cell.options.get("status", "0")))


def _python(text: str) -> str:
    return f"python - <<'{_END}'\n{text}{_END}"


def script_of(page: str, steps: list[Step]) -> str:
    """Return a bash script of all steps, which prints each step and stops at the first with another exit status."""
    lines = []
    for step in steps:
        first = step.shell.splitlines()[0]
        lines += [
            f"printf '%s\\n' {shlex.quote(f'{page}:{step.line}: {first}')}",
            step.shell,
            f"status=$?; if [ $status -ne {step.status} ]; then",
            f"  echo '{page}:{step.line}: ended with '$status', not {step.status}' >&2; exit 1; fi",
        ]
    return "\n".join([*lines, ""])


def walk(page: str, without: Sequence[str] = ()) -> bool:
    """Clone the repository and run the steps of a page, except for some commands; return whether all succeeded."""
    with tempfile.TemporaryDirectory(prefix="walk-") as folder:
        clone = Path(folder) / "forficula"
        subprocess.run(["git", "clone", "--quiet", str(ROOT), str(clone)], check=True)
        text = (clone / page).read_text("utf-8")
        begun = time.monotonic()
        # the shell starts with a search path and a home only
        empty = {"PATH": os.environ.get("PATH", os.defpath), "HOME": folder, "LANG": "C.UTF-8"}
        script = Path(folder) / "walk.sh"
        steps = [step for step in steps_of(text) if step.shell.partition("#")[0].strip() not in without]
        script.write_text(script_of(page, steps), "utf-8")
        done = subprocess.run(["bash", "--noprofile", "--norc", script], cwd=clone, env=empty, check=False)
        took = time.monotonic() - begun
    print(f"{page}: {'done' if done.returncode == 0 else 'not done'}, {took:.0f} s", flush=True)
    return done.returncode == 0


def main() -> None:
    """Run the steps of all pages, or of those that are named."""
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("pages", nargs="*", default=PAGES)
    parser.add_argument("--without", action="append", default=[], help="command to skip, as the page prints it")
    parser.add_argument("--show", action="store_true", help="print the commands and run nothing")
    options = parser.parse_args()
    if options.show:
        for page in options.pages:
            print(script_of(page, steps_of((ROOT / page).read_text("utf-8"))))
        return
    sys.exit(0 if all(walk(page, options.without) for page in options.pages) else 1)


if __name__ == "__main__":
    main()
