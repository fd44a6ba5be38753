"""Cells of a page: commands and Python that the build runs, with what they print, draw and write.

    ```{command}
    forficula run letter-fold --out out/letter
    ```

runs in a folder of the page's own, and what it prints stands below it. A cell of `{python}` shares its names with those
before it, and a figure that it ends with is drawn; `{file} sheet.fold` is written there. What cells wrote is shown by
`{picture} out/letter/energy.png`, `{live} out/letter/report.html` and `{show} out/letter/design.toml`.

A command that ends with another status than `:status:`, or Python that raises, stops the build.
Cells run again where they, those before them on the page, or forficula's sources have changed.
"""

from __future__ import annotations

import contextlib
import hashlib
import io
import json
import os
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
import textwrap
from collections.abc import Iterator, Sequence
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

DOCS = Path(__file__).parents[1]
WORK = DOCS / "_build" / "work"
_CELL = re.compile(
    r"^```\{(?P<kind>command|python|file)\}[ ]*(?P<name>[^\n]*)\n(?P<options>(?::[a-z]+:[^\n]*\n)*)(?P<text>.*?)^```$",
    re.M | re.S,
)
_OPTION = re.compile(r"^:([a-z]+):[ ]*(.*)$", re.M)
# what tells that something goes on, and how long it took
_WAITING = re.compile(r"simulated$|^took |runs/s|^keeping |^\d+ of \d+ ")
_WIDE = 94
# in the folder of a page some of whose cells were too costly to run
NOT_RUN = "not-run"


@dataclass(frozen=True, kw_only=True)
class Cell:
    """What a page has run.

    Attributes:
        kind: "command", "python" or "file".
        name: of a file.
        text: as it is shown.
        options: status, that a command ends with; shared, for one that several pages have and that is run once; costly,
            for one that is run where FORFICULA_DOCS is "all" only.
    """

    kind: str
    name: str
    text: str
    options: dict[str, str]

    @property
    def commands(self) -> list[list[str]]:
        """Arguments of every command of it, without comments."""
        lines = self.text.replace("\\\n", " ").splitlines()
        return [words for words in (shlex.split(line, comments=True) for line in lines) if words]


@dataclass(frozen=True, kw_only=True)
class Shown:
    """What came of a cell: what it printed, and the picture that it ended with, by its path in the page's folder."""

    text: str = ""
    picture: str = ""


def cells_of(page: str) -> list[Cell]:
    """The cells of a page's source, in order."""
    return [
        Cell(
            kind=found["kind"], name=found["name"], text=found["text"], options=dict(_OPTION.findall(found["options"]))
        )
        for found in _CELL.finditer(page)
    ]


def folder_of(page: str) -> Path:
    """Where the cells of a page run, by its name."""
    return WORK / page.replace("/", "-")


def sources_digest() -> str:
    """Of everything in the package, and of what runs cells: where it changes, so may any result."""
    digest = hashlib.sha256(Path(__file__).read_bytes())
    for path in sorted((DOCS.parent / "src").rglob("*")):
        if path.suffix in {".py", ".pyi", ".toml", ".js", ".css"}:
            digest.update(path.read_bytes())
    return digest.hexdigest()


def run_page(page: str, cells: Sequence[Cell], sources: str) -> list[Shown]:
    """What comes of a page's cells; what an earlier build found is kept where nothing has changed."""
    folder = folder_of(page)
    costly = any("costly" in cell.options for cell in cells)
    every = json.dumps([sources, costly and _all_wanted(), [asdict(cell) for cell in cells]])
    key = hashlib.sha256(every.encode()).hexdigest()
    kept = folder.with_suffix(".json")
    if kept.exists() and (found := json.loads(kept.read_text("utf-8")))["key"] == key:
        return [Shown(**each) for each in found["shown"]]
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    # in a process of its own: it has a working folder and names of its own
    orders = json.dumps([sources, [asdict(cell) for cell in cells]])
    done = subprocess.run(
        [sys.executable, __file__], input=orders, cwd=folder, capture_output=True, encoding="utf-8", check=False
    )
    if done.returncode:
        raise RuntimeError(f"{page}: {done.stderr.strip()}")
    kept.write_text(json.dumps({"key": key, "shown": json.loads(done.stdout)}), "utf-8")
    return [Shown(**each) for each in json.loads(done.stdout)]


def _run_here(cells: Sequence[Cell], sources: str) -> Iterator[Shown]:
    """Run cells in the working folder."""
    names: dict[str, Any] = {"__name__": "__main__"}
    for number, cell in enumerate(cells):
        if "costly" in cell.options and not _all_wanted():
            Path(NOT_RUN).touch()
            yield Shown(text="This build did not run it: make docs-all does.")
        elif cell.kind == "file":
            Path(cell.name).write_text(cell.text, "utf-8")
            yield Shown()
        elif cell.kind == "python":
            yield _python(cell.text, names, f"cell-{number}.svg")
        elif "shared" in cell.options:
            yield _shared(cell, sources)
        else:
            yield Shown(text=_command(cell))


def _all_wanted() -> bool:
    return os.environ.get("FORFICULA_DOCS") == "all"


def _shared(cell: Cell, sources: str) -> Shown:
    """What a command that needs nothing but its words leaves: run once, and copied here."""
    there = WORK / "shared" / hashlib.sha256(f"{sources} {cell.text}".encode()).hexdigest()[:16]
    if not there.exists():
        there.parent.mkdir(exist_ok=True)
        # whole or not there: pages are read side by side
        with tempfile.TemporaryDirectory(dir=there.parent) as made:
            (Path(made) / "new" / "files").mkdir(parents=True)
            with contextlib.chdir(Path(made) / "new" / "files"):
                text = _command(cell)
            (Path(made) / "new" / "printed.txt").write_text(text, "utf-8")
            with contextlib.suppress(OSError):
                (Path(made) / "new").rename(there)
    shutil.copytree(there / "files", Path.cwd(), dirs_exist_ok=True)
    return Shown(text=(there / "printed.txt").read_text("utf-8"))


def _command(cell: Cell) -> str:
    expected = int(cell.options.get("status", "0"))
    environment = {**os.environ, "COLUMNS": str(_WIDE), "OPENBLAS_NUM_THREADS": "1", "NO_COLOR": "1", "PYTHONUTF8": "1"}
    printed = []
    for program, *arguments in cell.commands:
        if program != "forficula":
            raise RuntimeError(f"{program}: only forficula is run")
        done = subprocess.run(
            [sys.executable, "-m", "forficula", *arguments],
            capture_output=True,
            encoding="utf-8",
            env=environment,
            check=False,
        )
        told = [
            textwrap.fill(line, _WIDE, subsequent_indent="    ")
            for line in done.stderr.splitlines()
            if not _WAITING.search(line)
        ]
        if done.returncode != expected:
            raise RuntimeError(f"{shlex.join(arguments)}: ended with {done.returncode}: {done.stderr}")
        printed += [*told, done.stdout.rstrip()]
    return "\n".join(line.rstrip() for each in printed for line in each.splitlines()).strip("\n")


def _python(text: str, names: dict[str, Any], picture: str) -> Shown:
    printed = io.StringIO()
    with contextlib.redirect_stdout(printed):
        value = evaluate(text, names)
    if hasattr(value, "savefig"):
        value.savefig(picture)
        return Shown(text=printed.getvalue().rstrip(), picture=picture)
    if value is not None:
        printed.write(repr(value))
    return Shown(text=printed.getvalue().rstrip())


def evaluate(text: str, names: dict[str, Any]) -> Any:
    """Run Python and return the value of the expression that it ends with; None if it ends with a statement."""
    import ast

    tree = ast.parse(text)
    last = tree.body.pop() if tree.body and isinstance(tree.body[-1], ast.Expr) else None
    exec(compile(tree, "<cell>", "exec"), names)
    return None if last is None else eval(compile(ast.Expression(last.value), "<cell>", "eval"), names)


def _main() -> None:
    sources, given = json.load(sys.stdin)
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
    # what libraries print is none of the results
    results = sys.stdout
    sys.stdout = sys.stderr
    shown = [asdict(each) for each in _run_here([Cell(**cell) for cell in given], sources)]
    json.dump(shown, results)


if __name__ == "__main__":
    _main()
