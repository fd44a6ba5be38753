"""Names of hinges, tendons and the lines of plots."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from forficula.arrays import Array
from forficula.quantities import show_value
from forficula.structure import Hinge, Measure, Structure, Tendon, measure_of

MOST_TOLD = 16  # largest number of hinges of a measure with separate rows and lines


@dataclass(frozen=True, kw_only=True)
class Parts:
    """Names of parts, shortened if they begin with the same word.

    Attributes:
        heading: common word, such as "vein"; empty if there is none.
        names: names without this word.
    """

    heading: str
    names: tuple[str, ...]


def label_of(part: Hinge | Tendon) -> str:
    """Return the name of a hinge or tendon in tables and figures."""
    return part.label or part.name


def measure_labels(structure: Structure, measure: Measure) -> list[str]:
    """Return the names of a measure's readings: its hinges, or the measure itself for a distance."""
    if measure.points is not None:
        return [measure.label or measure.name]
    labels = [label_of(structure.hinges[part[0]]) for part in measure.parts]
    # the part of a label after the comma distinguishes hinges of one reading
    return labels if measure.together == 1 else [label.partition(",")[0] for label in labels]


def role_groups(structure: Structure, measure: Measure) -> dict[str, list[int]]:
    """Return the indices of a measure's readings by role of their hinges; empty if every reading has its own row."""
    return by_role(structure, measure) if len(measure.parts) > MOST_TOLD else {}


def by_role(structure: Structure, measure: Measure) -> dict[str, list[int]]:
    """Return the indices of a measure's readings by role of their hinges."""
    groups: dict[str, list[int]] = {}
    for place, part in enumerate(measure.parts):
        groups.setdefault(structure.hinges[part[0]].role, []).append(place)
    return groups


def reading_labels(structure: Structure, measure: Measure) -> list[str]:
    """Return the names of the readings in tables and pages: every reading, or for many those of `condensed`."""
    groups = role_groups(structure, measure)
    if not groups:
        return measure_labels(structure, measure)
    medians = [f"median {role}" for role in groups] if len(groups) > 1 else ["median"]
    return ["smallest", *medians, "largest"]


def condensed(structure: Structure, measure: Measure, values: Array) -> Array:
    """Return the readings of a measure, (..., hinge), as in tables and pages, (..., reading).

    Of many angles the smallest, the median of each role, and the largest. A median is the lower one of two
    middle values.
    """
    groups = role_groups(structure, measure)
    if not groups:
        return values
    return np.stack(
        [values.min(axis=-1), *(median(values[..., places]) for places in groups.values()), values.max(axis=-1)],
        axis=-1,
    )


def median(values: Array) -> Array:
    """Return the median along the last axis; of two middle values the lower one."""
    return np.asarray(np.sort(values, axis=-1)[..., (values.shape[-1] - 1) // 2])


def title_of(measure: Measure) -> str:
    """Return the title of a measure."""
    return measure.label or measure.name


def parts_of(labels: Sequence[str]) -> Parts:
    """Separate the word with which all labels begin, if every label is a word and a number."""
    split = [label.rpartition(" ") for label in labels]
    words = {word for word, _, number in split if number.isdigit()}
    if len(words) == 1 and all(number.isdigit() for _, _, number in split):
        return Parts(heading=words.pop(), names=tuple(number for _, _, number in split))
    return Parts(heading="", names=tuple(labels))


def by_number(labels: Sequence[str]) -> list[int]:
    """Return the indices of labels in the order of their numbers, if every label is one word and a number.

    >>> by_number(["crease 0", "crease 13", "crease 2"]), by_number(["ring", "beside 3"])
    ([0, 2, 1], [0, 1])
    """
    parts = parts_of(labels)
    return sorted(range(len(labels)), key=lambda place: int(parts.names[place]) if parts.heading else place)


def counted(labels: Sequence[str], kind: str) -> str:
    """Return the number of labels with their common word, such as "3 veins", or with a kind."""
    word = parts_of(labels).heading or kind
    return f"{len(labels)} {word}{'s' * (len(labels) != 1)}"


def aligned(columns: Sequence[Sequence[str]]) -> tuple[list[str], list[list[int]]]:
    """Merge the names of several columns into rows; equal names share a row.

    Returns:
        Names of the rows, in the order of their first use, each as often as a column repeats it; and the
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
    """Return the angles that figures show: those measured; without any, those driven; without any, all."""
    measured = tuple(measure for measure in structure.measures if measure.kind == "angle" and measure.hinges)
    return measured or driven_angles(structure, measured) or _by_role(structure, range(len(structure.hinges)))


def driven_angles(structure: Structure, but: Sequence[Measure]) -> tuple[Measure, ...]:
    """Return the angles of driven hinges, by role, without hinges of some measures."""
    had = {hinge for measure in but for hinge in measure.hinges}
    return _by_role(structure, [hinge for motor in structure.motors for hinge in motor.hinges if hinge not in had])


def shown_distances(structure: Structure) -> tuple[Measure, ...]:
    """Return the distances that figures show: all."""
    return tuple(measure for measure in structure.measures if measure.kind == "distance")


def _by_role(structure: Structure, hinges: Sequence[int]) -> tuple[Measure, ...]:
    roles = dict.fromkeys(structure.hinges[hinge].role for hinge in hinges)
    return tuple(measure for role in roles if (measure := measure_of(structure, role)) is not None)


def stress_text(stress: float, withstood: float | None) -> str:
    """Return a stress, Pa, with its share of the material's strength, if known."""
    text = show_value(stress, "Pa", 3)
    return f"{text}, {100 * abs(stress) / withstood:.3g} % of its strength" if withstood else text
