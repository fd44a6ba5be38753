"""A crease pattern laid flat for drawings, and the positions of points of the built sheet on it."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from forficula.arrays import Array
from forficula.errors import InputError
from forficula.make.flat.unfolding import Unfolding, laid_place, unfolded
from forficula.pattern import CreasePattern
from forficula.pattern.crease_pattern import is_unfolded


@dataclass(frozen=True, kw_only=True, eq=False)
class FlatNet:
    """A crease pattern in the plane.

    Attributes:
        built: pattern as built.
        laid: the same, laid flat; None for a pattern that is flat as built, or that cannot be laid flat.
    """

    built: CreasePattern
    laid: Unfolding | None

    @cached_property
    def pattern(self) -> CreasePattern:
        """The pattern to draw; an unfolded one begins at the origin."""
        if self.laid is None:
            return self.built
        laid = self.laid.pattern
        return replace(laid, vertices_coords=laid.vertices_coords - np.append(self._corner, 0.0))

    @property
    def view(self) -> str:
        """How the sheet is shown, such as "unfolded"; empty for one that is flat as built."""
        if self.laid is not None:
            return "unfolded"
        return "" if is_unfolded(self.built) else "seen from above"

    @property
    def seams(self) -> frozenset[int]:
        """Indices of the drawn edges at which the sheet had to be opened."""
        if self.laid is None:
            return frozenset()
        return frozenset(np.flatnonzero(np.isin(self.laid.edges, self.laid.seams)).tolist())

    def places(self, points: Array) -> Array:
        """Return the drawn positions of points of the built sheet, m, (point, 3) -> (point, 2)."""
        return np.array([self._place(point) for point in points]).reshape(-1, 2)

    def _place(self, point: Array) -> Array:
        if self.laid is None:
            return point[:2]
        on_face = laid_place(self.built, self.laid, point)
        if on_face is not None:
            return np.asarray(on_face[1] - self._corner)
        # a point beside the sheet is shown beside the nearest face
        face = int(np.argmin(np.linalg.norm(self._centres - point, axis=1)))
        return np.asarray(self.laid.turns[face] @ point + self.laid.shifts[face])[:2] - self._corner

    @cached_property
    def _corner(self) -> Array:
        """Lower left corner of the laid pattern, m, (2,)."""
        assert self.laid is not None
        return np.asarray(self.laid.pattern.vertices_coords[:, :2].min(axis=0))

    @cached_property
    def _centres(self) -> Array:
        return np.array([self.built.vertices_coords[list(face)].mean(axis=0) for face in self.built.faces_vertices])


def flat_net(pattern: CreasePattern) -> FlatNet:
    """Return a pattern laid flat; a folded one with facets that are not flat stays as it is, seen from above."""
    if is_unfolded(pattern):
        return FlatNet(built=pattern, laid=None)
    try:
        return FlatNet(built=pattern, laid=unfolded(pattern))
    except InputError:
        return FlatNet(built=pattern, laid=None)
