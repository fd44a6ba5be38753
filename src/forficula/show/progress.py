"""Progress of runs and studies: a bar on a terminal, plain lines elsewhere."""

from __future__ import annotations

import sys
from collections import Counter
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from threading import Timer
from time import monotonic
from typing import Any

from rich.console import Console
from rich.markup import escape
from rich.progress import BarColumn, Progress, TextColumn
from rich.table import Column

from forficula.terminal import is_quiet

_PATIENCE = 3  # s
_LONG = 1  # s


def _console() -> Console:
    return Console(stderr=True, highlight=False, quiet=is_quiet())


@contextmanager
def run_progress(first: str = "building the structure") -> Iterator[Callable[[str, float, float], None]]:
    """Show the progress of a run and the step before it: a bar on a terminal, a line for each stage elsewhere."""
    console = _console()
    if not console.is_terminal:
        stages, start = [""], monotonic()
        with waiting(first) as stop_waiting:

            def line(stage: str, time: float, longest: float) -> None:
                stop_waiting()
                # the verdict of a short run comes first
                if stage != stages[-1] and monotonic() - start > _PATIENCE:
                    stages.append(stage)
                    console.print(f"{stage}: {time:.3g} s of at most {longest:.3g} s simulated", markup=False)

            yield line
        return
    with Progress(console=console, transient=True) as bar:
        task = bar.add_task(first)
        yield lambda stage, time, longest: bar.update(task, description=escape(stage), completed=time, total=longest)


@contextmanager
def survey_progress(
    first: str, what: str
) -> Iterator[tuple[Callable[[str, float, float], None], Callable[[str], None]]]:
    """Show the progress of a run, and then of a survey: a line for each step, or text in place of the bar.

    Args:
        first: step before the run.
        what: name of the survey.
    """
    console = _console()
    with run_progress(first) as line:
        if console.is_terminal:
            yield line, lambda step: line(f"{what}: {step}", 0.0, 0.0)
        else:
            start = monotonic()

            def surveyed(step: str) -> None:
                # the first line of a short survey comes first
                if monotonic() - start > _PATIENCE:
                    console.print(f"{what}: {step}", markup=False)

            yield line, surveyed


@contextmanager
def waiting(what: str) -> Iterator[Callable[[], None]]:
    """Print what is being done if it takes longer than a few seconds; the returned function stops the timer."""
    quiet = is_quiet()  # read here, because the timer's thread has its own context
    timer = Timer(_PATIENCE, lambda: None if quiet else print(f"{what} ...", file=sys.stderr, flush=True))
    timer.daemon = True
    timer.start()
    try:
        yield timer.cancel
    finally:
        timer.cancel()


@contextmanager
def steps_progress() -> Iterator[Callable[[str], None]]:
    """Show steps: a changing line on a terminal; elsewhere a line for each step that takes longer than a second."""
    console = _console()
    if console.is_terminal:
        with console.status("") as status:
            yield lambda step: status.update(escape(step))
        return
    timer = Timer(_LONG, lambda: None)

    def begin(step: str) -> None:
        nonlocal timer
        timer.cancel()
        timer = Timer(_LONG, lambda: console.print(f"{step} ...", markup=False, soft_wrap=True))
        timer.daemon = True
        timer.start()

    try:
        yield begin
    finally:
        timer.cancel()


@contextmanager
def study_progress() -> Iterator[Callable[[int, int, dict[str, Any]], None]]:
    """Show the number of runs, their rate, the time left and their outcomes: a bar on a terminal, lines elsewhere.

    A line is printed every 10 s. The rate is the mean since the start. The time left is that of the runs known to be
    needed: a search may add runs, or make others unnecessary, which then count as done.
    """
    console = _console()
    ends: Counter[str] = Counter()
    start = monotonic()

    def words(done: int, needed: int, row: dict[str, Any]) -> str:
        ends[_end(row)] += 1
        rate = ends.total() / max(monotonic() - start, 1e-3)
        outcomes = ", ".join(f"{number} {name}" for name, number in sorted(ends.items()))
        return f"{done} of {needed} runs, {rate:.3g} runs/s, {_duration((needed - done) / rate)} left: {outcomes}"

    if not console.is_terminal:
        last = [start]

        def line(done: int, needed: int, row: dict[str, Any]) -> None:
            now = words(done, needed, row)
            if monotonic() - last[-1] > 10:
                last[-1] = monotonic()
                console.print(now, soft_wrap=True)

        yield line
        return
    text = TextColumn("{task.description}", table_column=Column(no_wrap=False))
    with Progress(BarColumn(bar_width=20), text, console=console) as bar:
        task = bar.add_task("")
        yield lambda done, needed, row: bar.update(
            task, description=words(done, needed, row), completed=done, total=needed
        )


@contextmanager
def film_progress() -> Iterator[Callable[[int, int], None]]:
    """Show how many pictures of a film are drawn: a bar on a terminal, a line every 10 s elsewhere."""
    console = _console()
    if not console.is_terminal:
        last = [monotonic()]

        def line(done: int, all_of_them: int) -> None:
            if monotonic() - last[-1] > 10:
                last[-1] = monotonic()
                console.print(f"{done} of {all_of_them} pictures")

        yield line
        return
    with Progress(console=console, transient=True) as bar:
        task = bar.add_task("film")
        yield lambda done, all_of_them: bar.update(task, completed=done, total=all_of_them)


def building_progress() -> Callable[[int, int], None]:
    """Print how many points are checked: a line every 5 s, also on a terminal, where a bar may be below."""
    return _lines("points checked", 5)


def map_progress(whole: str = "structure") -> Callable[[int, int], None]:
    """Print how many structures of a static map are done, with their noun: a line every 5 s."""
    return _lines(f"{whole}s of the map", 5)


def _lines(what: str, seconds: float) -> Callable[[int, int], None]:
    console, last = _console(), [monotonic()]

    def line(done: int, all_of_them: int) -> None:
        if monotonic() - last[-1] > seconds:
            last[-1] = monotonic()
            console.print(f"{done} of {all_of_them} {what}", soft_wrap=True)

    return line


def _end(row: dict[str, Any]) -> str:
    """Return the outcome of a run in a word or two."""
    return str(row.get("outcome", row["verdict"]))


def _duration(seconds: float) -> str:
    if seconds < 120:
        return f"{seconds:.0f} s"
    return f"{seconds / 60:.0f} min" if seconds < 7200 else f"{seconds / 3600:.0f} h"
