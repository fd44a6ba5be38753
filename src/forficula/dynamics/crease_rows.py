"""Rows of a bending flex that follow the creases of many structures: any law, torque, damping and moving rest angle.

MuJoCo's bending of a flex is by edge and exact: a moment k sin(angle - r), without a jump anywhere. A row can be
changed between steps, so that it has at any angle the moment and the slope that the crease has there.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from forficula.dynamics.crease_moments import CreaseMoments, crease_moments
from forficula.dynamics.model import Model
from forficula.structure.flaps import cross, dot

Array = NDArray[np.float64]
Indices = NDArray[np.int64]

# numbers of a row: of a quadratic form of its four nodes, and one of their determinant
_FORM, _ROW = 16, 17
# the right flap runs the other way along the edge
_UP = np.array([1.0, -1.0])[None, :, None, None]


@dataclass(frozen=True, kw_only=True)
class CreaseRows:
    """Creases of structures of one topology, side by side.

    Attributes:
        built: nodes in the built shape, each in its model's units, (structure, node, 3).
        slides: place of each node's coordinates in the engine's positions, (node, 3); -1 where it is held.
        flaps: tail, head, left and right corner, by node, (crease, 4).
        rows: in the engine's flex_bending, (crease,).
        form: for each number of a row's form, which it is with tail, head, left and right in this order, (crease, 16).
        parity: of that order, +1 or -1, (crease,).
        moments: of the creases.
    """

    built: Array
    slides: Indices
    flaps: Indices
    rows: Indices
    form: Indices
    parity: Array
    moments: CreaseMoments

    def follow(
        self, which: Indices, positions: Array, velocities: Array, near: Array, efforts: Array
    ) -> tuple[Array, Array]:
        """Angles of creases, and the rows that have their moments and slopes there.

        Args:
            which: structures.
            positions: theirs, (structure, dof).
            velocities: alike.
            near: angles that theirs are near to, rad, (structure, crease).
            efforts: what their motors are set to, (structure, motor).

        Returns:
            In own senses and without jumps, rad, (structure, crease); and (structure, crease, 17).
        """
        own = self.moments.some(which)
        senses = own.senses
        edge, away = self._sides(self.built[which], positions)
        edge_moves, moves = self._sides(None, velocities)
        # of the left and the right flap, whose normals are up in a flat sheet
        normals = cross(edge[:, None], away) * _UP
        square, area = dot(edge, edge), dot(normals, normals)
        length, share = np.sqrt(square), dot(away, edge[:, None]) / square
        volume = dot(away[:, 1], normals[:, 0])
        angles = without_jump(senses * np.arctan2(length * volume, dot(normals[:, 0], normals[:, 1])), near)
        turning = length * (dot(normals, moves - share * edge_moves[:, None]) / area).sum(axis=0)
        moment, slope = own.at(angles, turning, efforts)
        # of the angle between the flaps, whose sense the row has
        rest = senses * (angles - np.arctan2(moment, slope))
        size, moment = np.hypot(moment, slope), senses * moment
        cosine, sine = size * np.cos(rest), size * np.sin(rest)

        # with the cotangent weights c of the nodes over |edge|, |c x|^2 = 2 (1 - cos angle) (Wardetzky et al. 2007)
        high = length / np.sqrt(area)
        weights = np.empty((4, *angles.shape))
        weights[1] = (share * high).sum(axis=0)
        weights[0] = high.sum(axis=0) - weights[1]
        weights[2:] = -high
        last = -sine * high[0] * high[1] / length
        # such a row pulls within the flaps, too, as soon as they are not in one plane: force densities along their
        # sides take that back, so that the force is that of the moment
        pull = cosine * (weights[1] * edge + weights[2] * away[:, 0] + weights[3] * away[:, 1])
        wrong = weights[2:] * pull[:, None] + last * normals[:, ::-1] - moment * length / area * normals
        along, off = dot(wrong, edge[:, None]), dot(wrong, away)
        across, far = share * square, dot(away, away)
        densities = np.zeros((4, 4, *angles.shape))
        densities[2:, 1] = (along * far - off * across) / area
        densities[2:, 0] = (along * across - off * square) / area - densities[2:, 1]
        at_tail = weights[0] * dot(pull, edge) - last * volume
        densities[1, 0] = at_tail / square - (densities[2:, 0] * share).sum(axis=0)
        densities += np.swapaxes(densities, 0, 1)
        form = cosine * weights[:, None] * weights[None] - densities
        form[range(4), range(4)] += densities.sum(axis=0)
        rows = np.empty((*angles.shape, _ROW))
        rows[..., :_FORM] = form.reshape(_FORM, *angles.shape)[self.form.T, :, self._columns].transpose(2, 1, 0)
        rows[..., _FORM] = self.parity * last
        return angles, rows

    @property
    def _columns(self) -> Indices:
        return np.arange(len(self.flaps))

    def _sides(self, built: Array | None, shifts: Array) -> tuple[Array, Array]:
        """From tails to heads, (3, structure, crease), and to the corners on the left and right, (3, 2, ...)."""
        held = np.concatenate([shifts, np.zeros((len(shifts), 1))], axis=1)
        nodes = held[:, self.slides] if built is None else built + held[:, self.slides]
        tail, head, left, right = np.transpose(nodes[:, self.flaps], (2, 3, 0, 1))
        return head - tail, np.stack([left - tail, right - tail], axis=1)


def crease_rows(models: Sequence[Model]) -> CreaseRows | None:
    """Lay the creases of structures of one topology side by side; None where they have none."""
    creases = [model.creases for model in models if model.creases is not None]
    if not creases:
        return None
    order, flaps = creases[0].order, models[0].folds.flaps
    return CreaseRows(
        built=np.array([model.folds.built for model in models]),
        slides=models[0].folds.slides,
        flaps=flaps[:, [0, 1, 2, 5]],
        rows=creases[0].rows,
        form=(4 * order[:, :, None] + order[:, None, :]).reshape(-1, _FORM),
        parity=np.where(order[:, 0] == order[:, 2] - 2, 1.0, -1.0),
        moments=crease_moments(models),
    )


def without_jump(angles: Array, near: Array) -> Array:
    """Angles with as many whole turns as bring them closest to others, rad."""
    return np.asarray(angles + 2 * np.pi * np.round((near - angles) / (2 * np.pi)))
