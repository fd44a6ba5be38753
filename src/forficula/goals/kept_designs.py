"""Selection of designs that were tried for a goal and whose records are kept, so that they can be played."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from itertools import islice

from forficula.design import Design
from forficula.study.running.kept_runs import RunToKeep

# default number of runs that are kept
MOST_KEPT = 24


def designs_to_keep(designs: Sequence[Design | str], wanted: Iterable[int], most: int = MOST_KEPT) -> list[RunToKeep]:
    """Return the runs of selected designs, for `kept_runs`.

    Args:
        designs: all designs in the order of their table, or why there is none.
        wanted: indices of the selected designs, most important first. One that cannot be built is omitted.
        most: largest number of runs.
    """
    return runs_to_keep(len(designs), designs.__getitem__, wanted, most)


def runs_to_keep(
    count: int, design_of: Callable[[int], Design | str], wanted: Iterable[int], most: int
) -> list[RunToKeep]:
    """Do the same as `designs_to_keep`, but build designs one after another until there are enough.

    Args:
        count: number of all designs.
        design_of: builds the design with an index, or returns why there is none.
        wanted: indices of the selected designs, most important first. One that cannot be built is omitted.
        most: largest number of runs.
    """
    width = len(str(count))
    chosen = ((index, design_of(index)) for index in dict.fromkeys(wanted))
    built = ((index, design) for index, design in chosen if isinstance(design, Design))
    return [
        RunToKeep(point=index, part="run", name=f"{index + 1:0{width}d}", design=design)
        for index, design in islice(built, max(most, 0))
    ]
