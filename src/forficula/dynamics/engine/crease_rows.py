"""Rows of a bending flex for the creases of many structures: any law, torque, damping and moving rest angle.

MuJoCo computes the bending of a flex edge by edge and exactly: a moment k sin(angle - r), continuous at every angle. A
row can be changed between steps, so that at the present angle it has the moment and the slope of the crease.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from forficula.arrays import Array, Indices
from forficula.dynamics.energies.crease_moments import CreaseMoments, Past, crease_moments
from forficula.dynamics.engine.model import Model
from forficula.pattern.geometry import cross, dot

# numbers of a row: a quadratic form of its four nodes, and a factor of their determinant
_FORM, _ROW = 16, 17
_DIAGONAL = np.arange(4)


@dataclass(frozen=True, kw_only=True)
class CreaseRows:
    """Creases of structures of one topology, side by side.

    Attributes:
        built: tail, head, left and right corner in the built shape, in the models' units, (structure, 4, 3, crease).
        slides: indices of their coordinates in the engine's positions, (4, 3, crease); -1 for held ones.
        rows: in the engine's flex_bending, (crease,).
        form: for each number of a row's form, its index in the order tail, head, left, right, (16, crease).
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
        """Select structures by index, in ascending order."""
        return replace(self, built=self.built[which], moments=self.moments.some(which))

    def follow(self, positions: Array, velocities: Array, efforts: Array, past: Past) -> tuple[Array, Array, Array]:
        """Compute the angles of creases, and rows with their moments and slopes at these angles.

        Args:
            positions: of the structures, (structure, dof).
            velocities: of the structures, (structure, dof).
            efforts: settings of the motors, (structure, motor).
            past: of the creases, with angles within half a turn.

        Returns:
            Angles in own senses without jumps, rad, (structure, crease), memory, (slot, structure, crease), and rows,
            (structure, crease, 17).
        """
        moments, senses = self.moments, self.moments.senses
        (edge, away), (edge_moves, moves) = self._sides(positions, velocities)
        # normals of the left and the right flap point upwards in a flat sheet
        normals = cross(edge[:, None], away)
        # the right flap runs in the opposite direction along the edge
        np.negative(normals[:, 1], out=normals[:, 1])
        square, area = dot(edge, edge), dot(normals, normals)
        length, share = np.sqrt(square), dot(away, edge[:, None]) / square
        volume = dot(away[:, 1], normals[:, 0])
        angles = without_jump(senses * np.arctan2(length * volume, dot(normals[:, 0], normals[:, 1])), past.angles)
        turned = dot(normals, moves - share * edge_moves[:, None]) / area
        turning = length * (turned[0] + turned[1])
        moment, slope, memory = moments.at(angles, turning, efforts, past)
        # rows use the sense of the angle between the flaps
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
        # a row also pulls within the flaps if they are not in one plane; force densities along their sides compensate
        # this, so that the force is that of the moment alone
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
        return angles, memory, rows

    @property
    def _columns(self) -> Indices:
        return np.arange(len(self.rows))

    def _sides(self, positions: Array, velocities: Array) -> tuple[tuple[Array, Array], tuple[Array, Array]]:
        """Return vectors from tails to heads, (3, structure, crease), and to corners, (3, 2, ...), and their rates."""
        shifts = np.zeros((2, len(positions), max(positions.shape[1], velocities.shape[1]) + 1))
        shifts[0, :, : positions.shape[1]], shifts[1, :, : velocities.shape[1]] = positions, velocities
        nodes = np.take(shifts, self.slides, axis=2)
        nodes[0] += self.built
        sides = (nodes[:, :, 1:] - nodes[:, :, :1]).transpose(0, 3, 2, 1, 4)
        at, moves = sides[0], sides[1]
        return (at[:, 0], at[:, 1:]), (moves[:, 0], moves[:, 1:])


def crease_rows(models: Sequence[Model]) -> CreaseRows | None:
    """Collect the creases of structures of one topology side by side; None without creases."""
    creases = [model.creases for model in models if model.creases is not None]
    if not creases or not len(creases[0].rows):
        return None
    order, corners = creases[0].order, models[0].folds.flaps[:, [0, 1, 2, 5]]
    return CreaseRows(
        built=np.array([np.transpose(model.folds.built[corners], (1, 2, 0)) for model in models]),
        slides=np.ascontiguousarray(np.transpose(models[0].folds.slides[corners], (1, 2, 0))),
        rows=creases[0].rows,
        form=(4 * order[:, :, None] + order[:, None, :]).reshape(-1, _FORM).T,
        parity=np.where(order[:, 0] == order[:, 2] - 2, 1.0, -1.0),
        moments=crease_moments(models, joints=False),
    )


def without_jump(angles: Array, near: Array) -> Array:
    """Add whole turns to angles so that they are as close as possible to reference angles, rad."""
    return np.asarray(angles + 2 * np.pi * np.rint((near - angles) / (2 * np.pi)))
