"""Designs that were tried for a goal and are worth a record, so that they can be played."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from itertools import islice

from forficula.design import Design
from forficula.study.running.kept_runs import RunToKeep

# runs that are kept where nothing else is said
MOST_KEPT = 24


def designs_to_keep(designs: Sequence[Design | str], wanted: Iterable[int], most: int = MOST_KEPT) -> list[RunToKeep]:
    """The runs of some of the designs that were tried, for `kept_runs`.

    Args:
        designs: all of them in the order of their table, or why there is none.
        wanted: numbers of those that are worth it, the first ones first; one that cannot be built is left out.
        most: of them.
    """
    return runs_to_keep(len(designs), designs.__getitem__, wanted, most)


def runs_to_keep(
    count: int, design_of: Callable[[int], Design | str], wanted: Iterable[int], most: int
) -> list[RunToKeep]:
    """As `designs_to_keep`, of designs that are built one after another until there are enough.

    Args:
        count: of all designs.
        design_of: builds the one with a number, or says why there is none.
        wanted: numbers of those that are worth it, the first ones first; one that cannot be built is left out.
        most: of them.
    """
    width = len(str(count))
    chosen = ((number, design_of(number)) for number in dict.fromkeys(wanted))
    built = ((number, design) for number, design in chosen if isinstance(design, Design))
    return [
        RunToKeep(point=number, part="run", name=f"{number + 1:0{width}d}", design=design)
        for number, design in islice(built, max(most, 0))
    ]
