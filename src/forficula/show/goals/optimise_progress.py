"""How far a search for the best design is, and the best so far."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from time import monotonic

from rich.console import Console

from forficula.goals.optimise.candidate import trial_of
from forficula.goals.optimise.optimise import SoFar
from forficula.goals.optimise.telling import value_texts
from forficula.terminal import is_quiet

# s, between lines
_EVERY = 10


@contextmanager
def optimise_progress() -> Iterator[Callable[[SoFar], None]]:
    """Say every ten seconds how many designs were tried, how many rows that took, and what the best comes to."""
    console = Console(stderr=True, highlight=False, quiet=is_quiet())
    last = [monotonic()]

    def line(so_far: SoFar) -> None:
        if monotonic() - last[0] > _EVERY:
            last[0] = monotonic()
            console.print(progress_text(so_far), markup=False, soft_wrap=True)

    yield line


def progress_text(so_far: SoFar) -> str:
    """How far it is, in a line."""
    text = f"{so_far.tried} of {so_far.goal.runs} designs tried, {so_far.rows} rows worked out"
    if so_far.best is None:
        return text
    values = ", ".join(value_texts(so_far.goal, so_far.best))
    if trial_of(so_far.goal, so_far.best).feasible:
        return f"{text}; the best: {values}"
    return f"{text}; nothing meets the goal yet, the nearest: {values}"
