"""How far a run or a study is: a bar on a terminal, plain lines elsewhere."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from time import monotonic
from typing import Any

from rich.console import Console
from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeRemainingColumn


@contextmanager
def run_progress() -> Iterator[Callable[[str, float, float], None]]:
    """Show how far a run is: a bar on a terminal, a line a stage elsewhere."""
    console = Console(stderr=True, highlight=False)
    if not console.is_terminal:
        stages = [""]

        def line(stage: str, time: float, longest: float) -> None:
            if stage != stages[-1]:
                stages.append(stage)
                console.print(f"{stage}: {time:.3g} s of at most {longest:.3g} s simulated")

        yield line
        return
    with Progress(console=console, transient=True) as bar:
        task = bar.add_task("start")
        yield lambda stage, time, longest: bar.update(task, description=stage, completed=time, total=longest)


@contextmanager
def study_progress() -> Iterator[Callable[[int, int, dict[str, Any]], None]]:
    """Show runs done, time left and what became of them: a bar on a terminal, a line every 10 s elsewhere."""
    console = Console(stderr=True, highlight=False)
    counts: Counter[str] = Counter()

    def count(row: dict[str, Any]) -> str:
        status = str(row["status"])
        folded = "folded" if row.get("folded") else "diverged" if status.startswith("diverged") else "stuck"
        counts["cannot be built" if status.startswith("cannot") else folded] += 1
        return ", ".join(f"{number} {name}" for name, number in sorted(counts.items()))

    if not console.is_terminal:
        last = [monotonic()]

        def line(done: int, needed: int, row: dict[str, Any]) -> None:
            words = count(row)
            if monotonic() - last[-1] > 10:
                last[-1] = monotonic()
                console.print(f"{done} of {needed} runs: {words}")

        yield line
        return
    columns = (BarColumn(), MofNCompleteColumn(), TimeRemainingColumn(), TextColumn("{task.description}"))
    with Progress(*columns, console=console) as bar:
        task = bar.add_task("")
        yield lambda done, needed, row: bar.update(task, description=count(row), completed=done, total=needed)
