"""Parts beside one another on the bed of a printer."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

# mm: between parts, for brims and for fingers
GAP = 5.0
# mm, of a common printer; what is longer makes it wider
BED = 220.0


def places_on_bed(sizes: Sequence[Sequence[float]], gap: float = GAP, bed: float = BED) -> NDArray[np.float64]:
    """Where the least corners of boxes go, on shelves one behind the other, the deepest first, mm, (box, 2).

    It does not look for the tightest packing, and tells of no bed how deep it is: whoever has several pieces
    moves them in a slicer anyway.

    Args:
        sizes: of the boxes along x and y, mm.
        gap: between any two, mm.
        bed: how wide shelves are, mm; as wide as the longest box where that is longer.

    >>> places_on_bed([(100, 10), (100, 20), (100, 10)]).tolist()
    [[105.0, 0.0], [0.0, 0.0], [0.0, 25.0]]
    """
    places = np.zeros((len(sizes), 2))
    wide = max([bed, *(float(size[0]) for size in sizes)])
    # of every shelf: where it begins, and up to where it is taken
    starts: list[float] = []
    taken: list[float] = []
    end = 0.0
    for number in sorted(range(len(sizes)), key=lambda each: (-sizes[each][1], -sizes[each][0], each)):
        length, width = sizes[number][:2]
        shelf = next((each for each, x in enumerate(taken) if x + length <= wide), len(taken))
        if shelf == len(taken):
            starts.append(end)
            taken.append(0.0)
            end += width + gap
        places[number] = taken[shelf], starts[shelf]
        taken[shelf] += length + gap
    return places
