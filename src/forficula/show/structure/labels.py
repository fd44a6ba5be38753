"""What hinges, tendons and the lines of plots are called."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from forficula.arrays import Array
from forficula.quantities import show_value
from forficula.structure import Hinge, Measure, Structure, Tendon, measure_of

MOST_TOLD = 16  # hinges of a measure, each with a row of a table and a line of a plot of its own


@dataclass(frozen=True, kw_only=True)
class Parts:
    """Names of parts, short where they have a word in common.

    Attributes:
        heading: that word, such as "vein"; empty where there is none.
        names: each without it.
    """

    heading: str
    names: tuple[str, ...]


def label_of(part: Hinge | Tendon) -> str:
    """What tables and figures call a hinge or a tendon."""
    return part.label or part.name


def measure_labels(structure: Structure, measure: Measure) -> list[str]:
    """What the readings of a measure are called: its hinges, or itself where it is a distance."""
    if measure.points is not None:
        return [measure.label or measure.name]
    labels = [label_of(structure.hinges[part[0]]) for part in measure.parts]
    # what tells the hinges of one reading from each other stands behind a comma
    return labels if measure.together == 1 else [label.partition(",")[0] for label in labels]


def role_groups(structure: Structure, measure: Measure) -> dict[str, list[int]]:
    """Places of a measure's readings by the role of their hinges, where they are too many to tell each; else none."""
    groups: dict[str, list[int]] = {}
    if len(measure.parts) > MOST_TOLD:
        for place, part in enumerate(measure.parts):
            groups.setdefault(structure.hinges[part[0]].role, []).append(place)
    return groups


def reading_labels(structure: Structure, measure: Measure) -> list[str]:
    """What the readings of a measure are called that tables and pages tell: each, or of many what `condensed` makes."""
    groups = role_groups(structure, measure)
    if not groups:
        return measure_labels(structure, measure)
    medians = [f"median {role}" for role in groups] if len(groups) > 1 else ["median"]
    return ["smallest", *medians, "largest"]


def condensed(structure: Structure, measure: Measure, values: Array) -> Array:
    """The readings of a measure, (..., place), as tables and pages tell them, (..., reading).

    Of many angles the smallest, the median of each role, and the largest. A median is one of them, the lower one of two
    in the middle.
    """
    groups = role_groups(structure, measure)
    if not groups:
        return values
    return np.stack(
        [values.min(axis=-1), *(median(values[..., places]) for places in groups.values()), values.max(axis=-1)],
        axis=-1,
    )


def median(values: Array) -> Array:
    """The value in the middle, along the last axis; of two the lower one."""
    return np.asarray(np.sort(values, axis=-1)[..., (values.shape[-1] - 1) // 2])


def title_of(measure: Measure) -> str:
    """What a measure is called."""
    return measure.label or measure.name


def parts_of(labels: Sequence[str]) -> Parts:
    """Take out the word that all labels begin with, where each has one and a number behind it."""
    split = [label.rpartition(" ") for label in labels]
    words = {word for word, _, number in split if number.isdigit()}
    if len(words) == 1 and all(number.isdigit() for _, _, number in split):
        return Parts(heading=words.pop(), names=tuple(number for _, _, number in split))
    return Parts(heading="", names=tuple(labels))


def counted(labels: Sequence[str], kind: str) -> str:
    """How many there are, as "3 veins", by their common word, or by what they are."""
    word = parts_of(labels).heading or kind
    return f"{len(labels)} {word}{'s' * (len(labels) != 1)}"


def aligned(columns: Sequence[Sequence[str]]) -> tuple[list[str], list[list[int]]]:
    """Rows for entries of several columns by what they are called, those of one name in one row.

    Returns:
        What the rows are called, in the order in which they are first named, one as often as a column has it; and the
        row of every entry, (column, entry).
    """
    most: Counter[str] = Counter()
    for names in columns:
        most |= Counter(names)
    order = dict.fromkeys(name for names in columns for name in names)
    rows = [name for name in order for _ in range(most[name])]
    places: list[list[int]] = []
    for names in columns:
        seen: Counter[str] = Counter()
        places.append([])
        for name in names:
            places[-1].append(rows.index(name) + seen[name])
            seen[name] += 1
    return rows, places


def shown_angles(structure: Structure) -> tuple[Measure, ...]:
    """The angles that figures show: those that are measured; where none is, those that are driven; else all."""
    measured = tuple(measure for measure in structure.measures if measure.kind == "angle" and measure.hinges)
    return measured or driven_angles(structure, measured) or _by_role(structure, range(len(structure.hinges)))


def driven_angles(structure: Structure, but: Sequence[Measure]) -> tuple[Measure, ...]:
    """The angles of the hinges that motors act on, by role, but for those that some measures have."""
    had = {hinge for measure in but for hinge in measure.hinges}
    return _by_role(structure, [hinge for motor in structure.motors for hinge in motor.hinges if hinge not in had])


def shown_distances(structure: Structure) -> tuple[Measure, ...]:
    """The distances that figures show: all."""
    return tuple(measure for measure in structure.measures if measure.kind == "distance")


def _by_role(structure: Structure, hinges: Sequence[int]) -> tuple[Measure, ...]:
    roles = dict.fromkeys(structure.hinges[hinge].role for hinge in hinges)
    return tuple(measure for role in roles if (measure := measure_of(structure, role)) is not None)


def stress_text(stress: float, withstood: float | None) -> str:
    """A stress, Pa, and what share it is of what its material withstands, where that is told."""
    told = show_value(stress, "Pa", 3)
    return f"{told}, {100 * abs(stress) / withstood:.3g} % of its strength" if withstood else told
