"""How far an optimisation is, and the best that it has found so far."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from time import monotonic

from rich.console import Console

from forficula.goals.optimise.candidate import trial_of
from forficula.goals.optimise.optimise import SoFar
from forficula.goals.optimise.telling import value_texts
from forficula.terminal import is_quiet

# s, between lines where nothing better was found
_EVERY = 10


@contextmanager
def optimise_progress() -> Iterator[Callable[[SoFar], None]]:
    """Say every ten seconds how many designs are tried, and the best so far as soon as there is a better one."""
    console = Console(stderr=True, highlight=False, quiet=is_quiet())
    last, best = [monotonic()], [""]

    def tell(so_far: SoFar) -> None:
        now = ""
        if so_far.best is not None:
            meets = trial_of(so_far.goal, so_far.best).feasible
            now = f"{'best' if meets else 'nearest'} so far: {', '.join(value_texts(so_far.goal, so_far.best))}"
        if now == best[0] and monotonic() - last[0] < _EVERY:
            return
        last[0], best[0] = monotonic(), now
        done = f"{so_far.tried} of {so_far.goal.runs} designs, {so_far.rows} rows worked out"
        console.print(f"{done}; {now}" if now else done, soft_wrap=True, markup=False)

    yield tell
