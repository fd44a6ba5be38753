"""Rows of a bending flex that follow the creases of many structures: any law, torque, damping and moving rest angle.

MuJoCo's bending of a flex is by edge and exact: a moment k sin(angle - r), without a jump anywhere. A row can be
changed between steps, so that it has at any angle the moment and the slope that the crease has there.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from forficula.arrays import Array, Indices
from forficula.dynamics.energies.crease_moments import CreaseMoments, crease_moments
from forficula.dynamics.engine.model import Model
from forficula.pattern.geometry import cross, dot

# numbers of a row: of a quadratic form of its four nodes, and one of their determinant
_FORM, _ROW = 16, 17
_DIAGONAL = np.arange(4)


@dataclass(frozen=True, kw_only=True)
class CreaseRows:
    """Creases of structures of one topology, side by side.

    Attributes:
        built: tail, head, left and right corner in the built shape, in the models' units, (structure, 4, 3, crease).
        slides: places of their coordinates in the engine's positions, (4, 3, crease); -1 where they are held.
        rows: in the engine's flex_bending, (crease,).
        form: for each number of a row's form, which it is with tail, head, left and right in this order, (16, crease).
        parity: of that order, +1 or -1, (crease,).
        moments: of the creases.
    """

    built: Array
    slides: Indices
    rows: Indices
    form: Indices
    parity: Array
    moments: CreaseMoments

    def some(self, which: Indices) -> CreaseRows:
        """Of some of the structures, in a rising order."""
        return replace(self, built=self.built[which], moments=self.moments.some(which))

    def follow(self, positions: Array, velocities: Array, near: Array, efforts: Array) -> tuple[Array, Array]:
        """Angles of creases, and the rows that have their moments and slopes there.

        Args:
            positions: of the structures, (structure, dof).
            velocities: alike.
            near: angles that theirs are near to, rad, (structure, crease).
            efforts: what their motors are set to, (structure, motor).

        Returns:
            In own senses and without jumps, rad, (structure, crease); and (structure, crease, 17).
        """
        own, senses = self.moments, self.moments.senses
        (edge, away), (edge_moves, moves) = self._sides(positions, velocities)
        # of the left and the right flap, whose normals are up in a flat sheet
        normals = cross(edge[:, None], away)
        # the right flap runs the other way along the edge
        np.negative(normals[:, 1], out=normals[:, 1])
        square, area = dot(edge, edge), dot(normals, normals)
        length, share = np.sqrt(square), dot(away, edge[:, None]) / square
        volume = dot(away[:, 1], normals[:, 0])
        angles = without_jump(senses * np.arctan2(length * volume, dot(normals[:, 0], normals[:, 1])), near)
        turned = dot(normals, moves - share * edge_moves[:, None]) / area
        turning = length * (turned[0] + turned[1])
        moment, slope = own.at(angles, turning, efforts)
        # of the angle between the flaps, whose sense the row has
        rest = senses * (angles - np.arctan2(moment, slope))
        size, moment = np.hypot(moment, slope), senses * moment
        cosine, sine = size * np.cos(rest), size * np.sin(rest)

        # with the cotangent weights c of the nodes over |edge|, |c x|^2 = 2 (1 - cos angle) (Wardetzky et al. 2007)
        high = length / np.sqrt(area)
        shared = share * high
        weights = np.empty((4, *angles.shape))
        np.add(shared[0], shared[1], out=weights[1])
        np.subtract(high[0] + high[1], weights[1], out=weights[0])
        np.negative(high, out=weights[2:])
        last = -sine * high[0] * high[1] / length
        # such a row pulls within the flaps, too, as soon as they are not in one plane: force densities along their
        # sides take that back, so that the force is that of the moment
        pull = cosine * (weights[1] * edge + weights[2] * away[:, 0] + weights[3] * away[:, 1])
        wrong = weights[2:] * pull[:, None] + last * normals[:, ::-1] - moment * length / area * normals
        along, off = dot(wrong, edge[:, None]), dot(wrong, away)
        across, far = share * square, dot(away, away)
        densities = np.zeros((4, 4, *angles.shape))
        densities[2:, 1] = at_head = (along * far - off * across) / area
        densities[2:, 0] = at_tail = (along * across - off * square) / area - at_head
        by_side = at_tail * share
        densities[1, 0] = (weights[0] * dot(pull, edge) - last * volume) / square - (by_side[0] + by_side[1])
        densities += np.swapaxes(densities, 0, 1)
        form = cosine * weights[:, None] * weights[None] - densities
        form[_DIAGONAL, _DIAGONAL] += densities.sum(axis=0)
        rows = np.empty((*angles.shape, _ROW))
        rows[..., :_FORM] = form.reshape(_FORM, *angles.shape)[self.form, :, self._columns].transpose(2, 1, 0)
        rows[..., _FORM] = self.parity * last
        return angles, rows

    @property
    def _columns(self) -> Indices:
        return np.arange(len(self.rows))

    def _sides(self, positions: Array, velocities: Array) -> tuple[tuple[Array, Array], tuple[Array, Array]]:
        """From tails to heads, (3, structure, crease), and to the corners, (3, 2, ...); and how these move."""
        shifts = np.zeros((2, len(positions), max(positions.shape[1], velocities.shape[1]) + 1))
        shifts[0, :, : positions.shape[1]], shifts[1, :, : velocities.shape[1]] = positions, velocities
        nodes = np.take(shifts, self.slides, axis=2)
        nodes[0] += self.built
        sides = (nodes[:, :, 1:] - nodes[:, :, :1]).transpose(0, 3, 2, 1, 4)
        at, moves = sides[0], sides[1]
        return (at[:, 0], at[:, 1:]), (moves[:, 0], moves[:, 1:])


def crease_rows(models: Sequence[Model]) -> CreaseRows | None:
    """Lay the creases of structures of one topology side by side; None where they have none."""
    creases = [model.creases for model in models if model.creases is not None]
    if not creases:
        return None
    order, corners = creases[0].order, models[0].folds.flaps[:, [0, 1, 2, 5]]
    return CreaseRows(
        built=np.array([np.transpose(model.folds.built[corners], (1, 2, 0)) for model in models]),
        slides=np.ascontiguousarray(np.transpose(models[0].folds.slides[corners], (1, 2, 0))),
        rows=creases[0].rows,
        form=(4 * order[:, :, None] + order[:, None, :]).reshape(-1, _FORM).T,
        parity=np.where(order[:, 0] == order[:, 2] - 2, 1.0, -1.0),
        moments=crease_moments(models),
    )


def without_jump(angles: Array, near: Array) -> Array:
    """Angles with as many whole turns as bring them closest to others, rad."""
    return np.asarray(angles + 2 * np.pi * np.rint((near - angles) / (2 * np.pi)))
