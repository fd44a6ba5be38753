"""Do what README.md and docs/tutorial.md say, word for word, as someone does who reads them for the first time.

The repository is cloned into a temporary folder for each page, and what the page prints is run there in order, in one
shell with an empty environment: commands of indented blocks and of cells, Python, files. The first that ends otherwise
than the page says ends the walk. Needs the network, for pip; takes as long as the tests and the named study together.
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
# a fenced block with its options or with printed text, an indented one, or a picture or file that a cell wrote
_BLOCK = re.compile(
    r"^```(?P<kind>\{\w+\}|python|text)[^\n]*\n.*?^```$|(?:^(?: {4}[^\n]*)?\n)*^ {4}[^\n]*$",
    re.M | re.S,
)
_WRITTEN = re.compile(r"^```\{(?:picture|show|live)\} *(\S+)")
_END = "END_OF_WHAT_THE_PAGE_PRINTS"


@dataclass(frozen=True, kw_only=True)
class Step:
    """What a page prints, at a line of it: shell commands that end with a status, 0 if not told."""

    line: int
    shell: str
    status: int = 0


def steps_of(page: str) -> list[Step]:
    """What a reader does, in order; of an indented block each line is a command."""
    found, python = [], ""
    for block in _BLOCK.finditer(page):
        line = page.count("\n", 0, block.start()) + 1
        text = block[0]
        if block["kind"] is None:
            lines = text.replace("\\\n", " ").splitlines()
            found += [Step(line=line + at, shell=each.strip()) for at, each in enumerate(lines) if each.strip()]
        elif block["kind"] == "text":
            continue
        elif block["kind"] == "python":
            found.append(Step(line=line, shell=_python(text.partition("\n")[2].removesuffix("```"))))
        elif written := _WRITTEN.match(text):
            found.append(Step(line=line, shell=f"test -s {shlex.quote(written[1])}"))
        else:
            for cell in cells_of(text):
                python += cell.text if cell.kind == "python" else ""
                found += _steps_of_cell(cell, line, python)
    return found


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
    """One script of bash for all steps, which says what it does and stops at the first that ends otherwise."""
    lines = []
    for step in steps:
        first = step.shell.splitlines()[0]
        lines += [
            f"printf '%s\\n' {shlex.quote(f'{page}:{step.line}: {first}')}",
            step.shell,
            f"found=$?; if [ $found -ne {step.status} ]; then",
            f"  echo '{page}:{step.line}: ended with '$found', not {step.status}' >&2; exit 1; fi",
        ]
    return "\n".join([*lines, ""])


def walk(page: str, without: Sequence[str] = ()) -> bool:
    """Clone, and do what a page says, but for commands that are left out; whether all of it could be done."""
    with tempfile.TemporaryDirectory(prefix="walk-") as place:
        clone = Path(place) / "forficula"
        subprocess.run(["git", "clone", "--quiet", str(ROOT), str(clone)], check=True)
        text = (clone / page).read_text("utf-8")
        begun = time.monotonic()
        # a search path and a home are all that a shell starts with
        empty = {"PATH": os.environ.get("PATH", os.defpath), "HOME": place, "LANG": "C.UTF-8"}
        script = Path(place) / "walk.sh"
        steps = [step for step in steps_of(text) if step.shell.partition("#")[0].strip() not in without]
        script.write_text(script_of(page, steps), "utf-8")
        done = subprocess.run(["bash", "--noprofile", "--norc", script], cwd=clone, env=empty, check=False)
        took = time.monotonic() - begun
    print(f"{page}: {'done' if done.returncode == 0 else 'not done'}, {took:.0f} s", flush=True)
    return done.returncode == 0


def main() -> None:
    """Walk along all pages, or those that are named."""
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("pages", nargs="*", default=PAGES)
    parser.add_argument("--without", action="append", default=[], help="a command as printed that is left out")
    parser.add_argument("--show", action="store_true", help="print the commands and run nothing")
    given = parser.parse_args()
    if given.show:
        for page in given.pages:
            print(script_of(page, steps_of((ROOT / page).read_text("utf-8"))))
        return
    sys.exit(0 if all(walk(page, given.without) for page in given.pages) else 1)


if __name__ == "__main__":
    main()
