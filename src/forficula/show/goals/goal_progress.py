"""Progress lines of searches and identifications."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from time import monotonic
from typing import Any

from rich.console import Console

from forficula.goals.identify.identify import Sample
from forficula.goals.optimise.candidate import trial_of
from forficula.goals.optimise.optimise import SoFar
from forficula.goals.optimise.summary import value_texts
from forficula.terminal import is_quiet

# s, time between lines
_EVERY = 10


@contextmanager
def identify_progress() -> Iterator[
    tuple[Callable[[int, int, Sequence[Sample]], None], Callable[[int, int, dict[str, Any]], None]]
]:
    """Print after every batch the number of samples done and the facts that the best one meets; runs in between."""
    console = Console(stderr=True, highlight=False, quiet=is_quiet())
    start, last = monotonic(), [monotonic()]

    def samples(done: int, total: int, results: Sequence[Sample]) -> None:
        most = max((sum(finding.met for finding in sample.findings) for sample in results), default=0)
        facts = max((len(sample.findings) for sample in results), default=0)
        left = (monotonic() - start) / done * (total - done)
        console.print(
            f"{done} of {total} samples, about {left:.0f} s left; the best meets {most} of {facts} facts",
            soft_wrap=True,
        )
        last[0] = monotonic()

    def runs(done: int, needed: int, _row: dict[str, Any]) -> None:
        if monotonic() - last[0] > _EVERY:
            last[0] = monotonic()
            console.print(f"{done} of {needed} runs known to be needed", soft_wrap=True)

    yield samples, runs


@contextmanager
def optimise_progress() -> Iterator[Callable[[SoFar], None]]:
    """Print every ten seconds the numbers of designs tried and rows computed, and the best design's values."""
    console = Console(stderr=True, highlight=False, quiet=is_quiet())
    last = [monotonic()]

    def line(so_far: SoFar) -> None:
        if monotonic() - last[0] > _EVERY:
            last[0] = monotonic()
            console.print(progress_text(so_far), markup=False, soft_wrap=True)

    yield line


def progress_text(so_far: SoFar) -> str:
    """Return the progress of an optimisation in one line."""
    text = f"{so_far.tried} of {so_far.goal.runs} designs tried, {so_far.rows} rows computed"
    if so_far.best is None:
        return text
    values = ", ".join(value_texts(so_far.goal, so_far.best))
    if trial_of(so_far.goal, so_far.best).feasible:
        return f"{text}; the best: {values}"
    return f"{text}; no design meets the goal yet, the nearest: {values}"
