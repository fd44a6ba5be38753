"""Energy of tendons whose length depends on several hinges, with gradient and Hessian by the hinges' angles."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property, partial
from typing import Any

import numpy as np

from forficula.arrays import Array, Indices
from forficula.errors import InputError
from forficula.material import ElasticLaw
from forficula.statics.tree.elements import Elements, Expansion, LinePiece, elements, stretched
from forficula.statics.tree.pose import Pose, Tree
from forficula.structure import Structure

_SHORTEST = 1e-12  # share of its longest length; a shorter tendon has no direction


@dataclass(frozen=True, kw_only=True)
class Lines:
    """Tendons between any points of a structure, in cases that differ only in the tendons' laws.

    Attributes:
        laid: a piece for each tendon.
        law: of the tendons; its numbers are (case, tendon), or (1, tendon) if all cases have the same tendons.
        shortest: length below which a tendon has no direction, m, (tendon,).
    """

    laid: Elements
    law: ElasticLaw
    shortest: Array

    @cached_property
    def laws(self) -> tuple[ElasticLaw, ...]:
        """Return the laws of the tendons of every group."""
        return tuple(_selected_law(self.law, (slice(None), group.pieces)) for group in self.laid.groups)

    def only(self, cases: Indices) -> Lines:
        """Select cases by index; repeats are allowed."""
        return replace(self, law=_selected_law(self.law, cases))


def lines_of(structures: Sequence[Structure], tree: Tree) -> Lines | None:
    """Lay out the tendons across several hinges of structures that differ only in their tendons' laws.

    Returns:
        None if every tendon lies across one hinge, or its length never changes.

    Raises:
        InputError: such a tendon has other attachments in another structure.
    """
    first = structures[0]
    numbers = [
        number
        for number, tendon in enumerate(first.tendons)
        if tendon.crossing is None and _changes(tree, [first.points[point].body for point in tendon.points])
    ]
    if not numbers:
        return None
    bodies: list[int] = []
    places: list[Array] = []
    for number in numbers:
        ends = [first.points[point] for point in first.tendons[number].points]
        for other in structures[1:]:
            other_places = [other.points[point].place for point in other.tendons[number].points]
            if not all(np.array_equal(end.place, place) for end, place in zip(ends, other_places, strict=True)):
                raise InputError(
                    f"{other.name}: {other.tendons[number].name} lies across several hinges and its attachments differ"
                    " from those in the other structures; compute the landscape of this structure alone"
                )
        bodies += [end.body for end in ends]
        places += [end.place for end in ends]
    pieces = [LinePiece(points=(2 * line, 2 * line + 1), sides=np.array([[-1.0, 1.0]])) for line in range(len(numbers))]
    laws = [[structure.tendons[number].law.elastic for number in numbers] for structure in structures]
    parts: Any = {
        name: np.array([[getattr(law, name) for law in row] for row in laws])
        for name in ("rest_length", "linear", "quadratic", "cubic")
    }
    return Lines(
        laid=elements(tree, bodies, np.array(places), pieces),
        law=ElasticLaw(**parts),
        shortest=_SHORTEST * np.array([first.tendons[number].longest for number in numbers]),
    )


def _changes(tree: Tree, bodies: Sequence[int]) -> bool:
    return set(tree.chain(bodies[0])) != set(tree.chain(bodies[1]))


def line_energy(lines: Lines, angles: Array, at: Pose | None = None) -> Expansion:
    """Compute the energy of the tendons.

    The Hessian by the vector from end to end, for a pull F at a length L along a unit vector n, is
    F' n n^T + F / L (1 - n n^T).

    Args:
        lines: the tendons.
        angles: of all hinges, in their own senses, rad, (case, hinge).
        at: pose of the tree at these angles; computed by default.

    Returns:
        Energy, J, (case,); gradient, N m, (case, hinge), and Hessian, N m/rad, (case, hinge, hinge), by the angles.
    """
    laws = [
        partial(_pulled, law, lines.shortest[group.pieces])
        for law, group in zip(lines.laws, lines.laid.groups, strict=True)
    ]
    return stretched(lines.laid, angles, laws, at)


def _pulled(law: ElasticLaw, shortest: Array, sides: Array) -> Expansion | None:
    """Compute the energy of tendons from the vectors between their ends, (case, tendon, 1, 3).

    It is None if all tendons are slack.
    """
    apart = sides[:, :, 0]
    length = np.linalg.norm(apart, axis=2)
    if np.all(length < law.rest_length):
        return None
    known = np.maximum(length, shortest)
    stored, force, slope = law.expansion(length)
    along = apart / known[..., None]
    outer = along[..., :, None] * along[..., None, :]
    by_length = (force / known)[..., None, None]
    stiffness = slope[..., None, None] * outer + by_length * (np.eye(3) - outer)
    return stored.sum(axis=1), (force[..., None] * along)[:, :, None], stiffness[:, :, None]


def _selected_law(law: ElasticLaw, which: Any) -> ElasticLaw:
    parts: Any = {name: getattr(law, name)[which] for name in ("rest_length", "linear", "quadratic", "cubic")}
    return ElasticLaw(**parts)


def largest_pull(lines: Lines, structure: Structure) -> float:
    """Return an upper bound of the torque that the strongest of these tendons exerts about a hinge, N m."""
    longest = lines.shortest / _SHORTEST
    return float((lines.law.force(longest) * structure.span).max())
