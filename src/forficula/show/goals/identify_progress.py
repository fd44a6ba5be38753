"""How far an identification is, and the best that it has found so far."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from time import monotonic
from typing import Any

from rich.console import Console

from forficula.goals.identify.identify import Sample
from forficula.terminal import is_quiet

# s, between lines on runs
_EVERY = 10


@contextmanager
def identify_progress() -> Iterator[
    tuple[Callable[[int, int, Sequence[Sample]], None], Callable[[int, int, dict[str, Any]], None]]
]:
    """Say after every batch how many samples are done and how many facts the best meets, and between them the runs."""
    console = Console(stderr=True, highlight=False, quiet=is_quiet())
    start, last = monotonic(), [monotonic()]

    def samples(done: int, total: int, found: Sequence[Sample]) -> None:
        most = max((sum(each.met for each in sample.findings) for sample in found), default=0)
        facts = max((len(sample.findings) for sample in found), default=0)
        left = (monotonic() - start) / done * (total - done)
        console.print(
            f"{done} of {total} samples, about {left:.0f} s left; the best meets {most} of {facts} facts",
            soft_wrap=True,
        )
        last[0] = monotonic()

    def runs(done: int, needed: int, _row: dict[str, Any]) -> None:
        if monotonic() - last[0] > _EVERY:
            last[0] = monotonic()
            console.print(f"{done} of {needed} runs that are known to be needed so far", soft_wrap=True)

    yield samples, runs
