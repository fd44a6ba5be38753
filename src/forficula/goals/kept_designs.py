"""Designs that were tried for a goal and are worth a record, so that they can be played."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from forficula.design import Design
from forficula.study.kept_runs import RunToKeep

# runs that are kept where nothing else is said
MOST_KEPT = 24


def designs_to_keep(designs: Sequence[Design | str], wanted: Iterable[int], most: int = MOST_KEPT) -> list[RunToKeep]:
    """The runs of some of the designs that were tried, for `kept_runs`.

    Args:
        designs: all of them in the order of their table, or why there is none.
        wanted: numbers of those that are worth it, the first ones first; one that cannot be built is left out.
        most: of them.
    """
    width = len(str(len(designs)))
    chosen = [(number, designs[number]) for number in dict.fromkeys(wanted)]
    built = [(number, design) for number, design in chosen if isinstance(design, Design)]
    return [
        RunToKeep(point=number, part="run", name=f"{number + 1:0{width}d}", design=design)
        for number, design in built[: max(most, 0)]
    ]
