"""Cells of a page: commands and Python that the build runs.

    ```{command}
    forficula run letter-fold --out out/letter
    ```

runs in the folder of the page. The page shows its output below it. A `{python}` cell shares its names with the cells
before it, and shows the figure of its last expression. `{file} sheet.fold` writes a file into the folder. The
directives `{picture} out/letter/energy.png`, `{live} out/letter/report.html` and `{show} out/letter/design.toml` show
files that cells wrote.

A command with an exit status other than `:status:`, or Python that raises, stops the build. The cells of a page run
again if any of them or the sources of forficula have changed.
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
# lines about progress and elapsed time
_WAITING = re.compile(r"simulated$|^took |runs/s|^keeping |^\d+ of \d+ ")
_WIDE = 94
# name of a file in the folder of a page with cells that were too costly to run
NOT_RUN = "not-run"


@dataclass(frozen=True, kw_only=True)
class Cell:
    """Cell of a page.

    Attributes:
        kind: "command", "python" or "file".
        name: name of the file; empty for other kinds.
        text: source that the page shows.
        options: options by name. status: expected exit status of a command. shared: several pages contain the command,
            which runs once. costly: the cell runs only if FORFICULA_DOCS is "all".
    """

    kind: str
    name: str
    text: str
    options: dict[str, str]

    @property
    def commands(self) -> list[list[str]]:
        """Words of each command in the cell, without comments."""
        lines = self.text.replace("\\\n", " ").splitlines()
        return [words for words in (shlex.split(line, comments=True) for line in lines) if words]


@dataclass(frozen=True, kw_only=True)
class Shown:
    """Result of a cell: its output, and the path of its picture in the folder of the page."""

    text: str = ""
    picture: str = ""


def cells_of(page: str) -> list[Cell]:
    """Return the cells in the source of a page, in order."""
    return [
        Cell(
            kind=match["kind"], name=match["name"], text=match["text"], options=dict(_OPTION.findall(match["options"]))
        )
        for match in _CELL.finditer(page)
    ]


def folder_of(page: str) -> Path:
    """Return the folder in which the cells of a page run."""
    return WORK / page.replace("/", "-")


def sources_digest() -> str:
    """Return a hash of the package and of this folder. If it changes, any result of a cell may change."""
    digest = hashlib.sha256()
    for path in sorted([*(DOCS.parent / "src").rglob("*"), *Path(__file__).parent.glob("*.py")]):
        if path.suffix in {".py", ".pyi", ".toml", ".js", ".css"}:
            digest.update(path.read_bytes())
    return digest.hexdigest()


def run_page(page: str, cells: Sequence[Cell], sources: str) -> list[Shown]:
    """Return the results of the cells of a page, from an earlier build if nothing has changed."""
    folder = folder_of(page)
    costly = any("costly" in cell.options for cell in cells)
    inputs = json.dumps([sources, costly and _all_wanted(), [asdict(cell) for cell in cells]])
    key = hashlib.sha256(inputs.encode()).hexdigest()
    kept = folder.with_suffix(".json")
    if kept.exists() and (earlier := json.loads(kept.read_text("utf-8")))["key"] == key:
        return [Shown(**shown) for shown in earlier["shown"]]
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    # a separate process has its own working folder and names
    orders = json.dumps([sources, [asdict(cell) for cell in cells]])
    done = subprocess.run(
        [sys.executable, __file__], input=orders, cwd=folder, capture_output=True, encoding="utf-8", check=False
    )
    if done.returncode:
        raise RuntimeError(f"{page}: {done.stderr.strip()}")
    kept.write_text(json.dumps({"key": key, "shown": json.loads(done.stdout)}), "utf-8")
    return [Shown(**shown) for shown in json.loads(done.stdout)]


def _run_cells(cells: Sequence[Cell], sources: str) -> Iterator[Shown]:
    """Run cells in the working folder and yield their results."""
    names: dict[str, Any] = {"__name__": "__main__"}
    for number, cell in enumerate(cells):
        if "costly" in cell.options and not _all_wanted():
            Path(NOT_RUN).touch()
            yield Shown(text="This build did not run this command. make docs-all runs it.")
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
    """Return the result of a command that several pages contain: run it once and copy its files."""
    folder = WORK / "shared" / hashlib.sha256(f"{sources} {cell.text}".encode()).hexdigest()[:16]
    if not folder.exists():
        folder.parent.mkdir(exist_ok=True)
        # several processes read pages: the folder appears only when it is complete
        with tempfile.TemporaryDirectory(dir=folder.parent) as temporary:
            new = Path(temporary) / "new"
            (new / "files").mkdir(parents=True)
            with contextlib.chdir(new / "files"):
                text = _command(cell)
            (new / "printed.txt").write_text(text, "utf-8")
            with contextlib.suppress(OSError):
                new.rename(folder)
    shutil.copytree(folder / "files", Path.cwd(), dirs_exist_ok=True)
    return Shown(text=(folder / "printed.txt").read_text("utf-8"))


def _command(cell: Cell) -> str:
    expected = int(cell.options.get("status", "0"))
    environment = {**os.environ, "COLUMNS": str(_WIDE), "OPENBLAS_NUM_THREADS": "1", "NO_COLOR": "1", "PYTHONUTF8": "1"}
    printed = []
    for program, *arguments in cell.commands:
        if program != "forficula":
            raise RuntimeError(f"{program}: cells run only forficula")
        done = subprocess.run(
            [sys.executable, "-m", "forficula", *arguments],
            capture_output=True,
            encoding="utf-8",
            env=environment,
            check=False,
        )
        messages = [
            textwrap.fill(line, _WIDE, subsequent_indent="    ")
            for line in done.stderr.splitlines()
            if not _WAITING.search(line)
        ]
        if done.returncode != expected:
            raise RuntimeError(f"{shlex.join(arguments)}: ended with {done.returncode}: {done.stderr}")
        printed += [*messages, done.stdout.rstrip()]
    return "\n".join(line.rstrip() for text in printed for line in text.splitlines()).strip("\n")


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
    sources, cells = json.load(sys.stdin)
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
    # standard output contains only the results, not what libraries print
    results = sys.stdout
    sys.stdout = sys.stderr
    shown = [asdict(result) for result in _run_cells([Cell(**cell) for cell in cells], sources)]
    json.dump(shown, results)


if __name__ == "__main__":
    _main()
