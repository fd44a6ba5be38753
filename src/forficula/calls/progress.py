"""Progress of computations: one report for all calls, shown in notebooks and terminals."""

from __future__ import annotations

import sys
import warnings
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from html import escape
from inspect import Parameter, signature
from time import monotonic
from typing import TypeAlias

_INTERVAL = 0.2  # s, between two updates of a notebook's cell


@dataclass(frozen=True, kw_only=True)
class Progress:
    """Progress of a computation, as every call reports it.

    Attributes:
        task: name of the running task, such as "stage fold" or "runs".
        done: amount that is done, in `unit`.
        total: largest amount that may be needed, in `unit`; None if it is not known.
        unit: "s" of simulated time, "runs", "samples" or "designs".
        latest: latest result: the row of a run, the samples so far, or the state of a search; None if there is none.
    """

    task: str
    done: float = 0.0
    total: float | None = None
    unit: str = ""
    latest: object = None

    def __str__(self) -> str:
        """Progress in one line, such as "fold: 0.3 of at most 1 s"."""
        if self.total is None:
            return f"{self.task}: {self.done:.4g} {self.unit}" if self.unit else self.task
        return f"{self.task}: {self.done:.4g} of at most {self.total:.4g} {self.unit}".rstrip()


ProgressOption: TypeAlias = Callable[[Progress], None] | bool | None


@contextmanager
def reporting(progress: ProgressOption, report: Callable[..., Progress]) -> Iterator[Callable[..., None] | None]:
    """Yield the function to which a computation reports its progress; None if nobody wants to know it.

    Args:
        progress: function that is called with every report; True shows the progress, False does not, None shows it in
            notebooks and on terminals only.
        report: makes a report of the arguments with which the computation calls the function.
    """
    if callable(progress):
        if _takes_several(progress):
            warnings.warn(
                "progress: functions get one argument, an ff.Progress; several arguments are deprecated",
                DeprecationWarning,
                stacklevel=4,
            )
            yield progress
        else:
            yield lambda *arguments: progress(report(*arguments))
    elif progress or (progress is None and (_in_notebook() or sys.stderr.isatty())):
        with _notebook_line() if _in_notebook() else _terminal_bar() as show:
            yield lambda *arguments: show(report(*arguments))
    else:
        yield None


def simulated(stage: str, time: float, longest: float) -> Progress:
    """Report the stage of a run, the simulated time and its limit, s."""
    return Progress(task=stage, done=time, total=longest or None, unit="s")


def runs_done(done: int, needed: int, row: object) -> Progress:
    """Report the number of runs that are done and needed, and the row of the last."""
    return Progress(task="runs", done=done, total=needed, unit="runs", latest=row)


def _takes_several(function: Callable[..., object]) -> bool:
    """Return whether a function needs more than one positional argument, as progress functions of 0.1 did."""
    try:
        parameters = signature(function).parameters.values()
    except (TypeError, ValueError):
        return False
    positional = (Parameter.POSITIONAL_ONLY, Parameter.POSITIONAL_OR_KEYWORD)
    return sum(parameter.kind in positional and parameter.default is Parameter.empty for parameter in parameters) > 1


def _in_notebook() -> bool:
    """Return whether the code runs in a kernel, which shows HTML; a terminal of IPython does not."""
    shell = getattr(sys.modules.get("IPython"), "get_ipython", lambda: None)()
    return getattr(shell, "kernel", None) is not None


@contextmanager
def _terminal_bar() -> Iterator[Callable[[Progress], None]]:
    """Show progress as a bar on stderr, which disappears at the end."""
    from rich.console import Console
    from rich.markup import escape as escape_markup
    from rich.progress import BarColumn, TextColumn
    from rich.progress import Progress as Bar

    columns = (BarColumn(bar_width=20), TextColumn("{task.description}"))
    with Bar(*columns, console=Console(stderr=True), transient=True) as bar:
        task = bar.add_task("", total=None)

        def show(report: Progress) -> None:
            bar.update(task, description=escape_markup(str(report)), completed=report.done, total=report.total)

        yield show


@contextmanager
def _notebook_line() -> Iterator[Callable[[Progress], None]]:
    """Show progress as a bar in the cell of a notebook, which disappears at the end."""
    from IPython.display import HTML, display  # type: ignore[import-not-found]

    handle, last = display(HTML(""), display_id=True), [0.0]

    def show(report: Progress) -> None:
        if monotonic() - last[-1] > _INTERVAL:
            last[-1] = monotonic()
            value = "" if not report.total else f' value="{report.done / report.total:.3f}"'
            handle.update(HTML(f"<progress{value}></progress> {escape(str(report))}"))

    try:
        yield show
    finally:
        handle.update(HTML(""))
