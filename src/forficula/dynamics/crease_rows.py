"""Rows of a bending flex that follow the creases of many structures: any law, torque, damping and moving rest angle.

MuJoCo's bending of a flex is by edge and exact: a moment k sin(angle - r), without a jump anywhere. A row can be
changed between steps, so that it has at any angle the moment and the slope that the crease has there.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from forficula.dynamics.model import Model
from forficula.material import CreaseLaw
from forficula.structure.flaps import cross, dot

Array = NDArray[np.float64]
Indices = NDArray[np.int64]

# numbers of a row: of a quadratic form of its four nodes, and one of their determinant
_FORM, _ROW = 16, 17


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
        senses: +1 or -1, (structure, crease).
        law: of the springs, arrays (structure, crease).
        damping: (structure, crease).
        rests: by how much what a motor is set to moves each rest angle, (structure, motor, crease).
        torques: by how much it turns each crease, (structure, motor, crease).
    """

    built: Array
    slides: Indices
    flaps: Indices
    rows: Indices
    form: Indices
    parity: Array
    senses: Array
    law: CreaseLaw
    damping: Array
    rests: Array
    torques: Array

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
        tail, head, left, right = self._corners(self.built[which], positions)
        edge, one, other = head - tail, left - tail, right - tail
        first, second = cross(edge, one), cross(other, edge)
        square, area, other_area = dot(edge, edge), dot(first, first), dot(second, second)
        length, volume = np.sqrt(square), dot(other, first)
        share, other_share = dot(one, edge) / square, dot(other, edge) / square
        senses = self.senses[which]
        angles = without_jump(senses * np.arctan2(length * volume, dot(first, second)), near)

        tail, head, left, right = self._corners(np.zeros_like(self.built[which]), velocities)
        turning = dot(first, left - tail - share * (head - tail)) / area
        turning += dot(second, right - tail - other_share * (head - tail)) / other_area
        rests, torques = (np.einsum("rm,rmc->rc", efforts, each[which]) for each in (self.rests, self.torques))
        law = self.law.some(which)
        moment = law.moment(angles, rests) + self.damping[which] * senses * length * turning - torques
        slope = law.slope(angles)
        # of the angle between the flaps, whose sense the row has
        rest = senses * (angles - np.arctan2(moment, slope))
        size, moment = np.hypot(moment, slope), senses * moment
        cosine, sine = size * np.cos(rest), size * np.sin(rest)

        # with the cotangent weights c of the nodes over |edge|, |c x|^2 = 2 (1 - cos angle) (Wardetzky et al. 2007)
        high, other_high = length / np.sqrt(area), length / np.sqrt(other_area)
        weights = np.stack(
            [
                (1 - share) * high + (1 - other_share) * other_high,
                share * high + other_share * other_high,
                -high,
                -other_high,
            ]
        )
        last = -sine * high * other_high / length
        # such a row pulls within the flaps, too, as soon as they are not in one plane: force densities along their
        # sides take that back, so that the force is that of the moment
        pull = cosine * (weights[1] * edge + weights[2] * one + weights[3] * other)
        densities = np.zeros((4, 4, *angles.shape))
        for corner, away, wrong, normal in (
            (2, one, weights[2] * pull + last * second - moment * length / area * first, area),
            (3, other, weights[3] * pull + last * first - moment * length / other_area * second, other_area),
        ):
            along, across, own = dot(wrong, edge), dot(edge, away), dot(away, away)
            off = dot(wrong, away)
            densities[corner, 1] = (along * own - off * across) / normal
            densities[corner, 0] = (along * across - off * square) / normal - densities[corner, 1]
        at_tail = weights[0] * dot(pull, edge) - last * volume
        at_tail -= square * (densities[2, 0] * share + densities[3, 0] * other_share)
        densities[1, 0] = at_tail / square
        densities += np.swapaxes(densities, 0, 1)
        form = cosine * weights[:, None] * weights[None] - densities
        form[range(4), range(4)] += densities.sum(axis=0)
        rows = np.empty((*angles.shape, _ROW))
        every = np.moveaxis(form.reshape(_FORM, *angles.shape), 0, -1)
        rows[..., :_FORM] = np.take_along_axis(every, np.broadcast_to(self.form, every.shape), axis=-1)
        rows[..., _FORM] = self.parity * last
        return angles, rows

    def _corners(self, built: Array, shifts: Array) -> Array:
        """Tails, heads, left and right corners, (4, 3, structure, crease)."""
        held = np.concatenate([shifts, np.zeros((len(shifts), 1))], axis=1)
        nodes = built + held[:, self.slides]
        return np.ascontiguousarray(np.transpose(nodes[:, self.flaps], (2, 3, 0, 1)))


def crease_rows(models: Sequence[Model]) -> CreaseRows | None:
    """Lay the creases of structures of one topology side by side; None where they have none."""
    creases = [model.creases for model in models if model.creases is not None]
    if not creases:
        return None
    order, flaps = creases[0].order, models[0].folds.flaps
    unit = [np.eye(len(model.structure.motors)) for model in models]
    settings = [model.settings(each) for model, each in zip(models, unit, strict=True)]
    laws = [each.law for each in creases]
    return CreaseRows(
        built=np.array([model.folds.built for model in models]),
        slides=models[0].folds.slides,
        flaps=flaps[:, [0, 1, 2, 5]],
        rows=creases[0].rows,
        form=(4 * order[:, :, None] + order[:, None, :]).reshape(-1, _FORM),
        parity=np.where(order[:, 0] == order[:, 2] - 2, 1.0, -1.0),
        senses=np.array([each.senses for each in creases], dtype=np.float64),
        law=CreaseLaw(
            **{
                each.name: np.array([np.asarray(getattr(law, each.name)) for law in laws])
                for each in dataclasses.fields(CreaseLaw)
            }
        ),
        damping=np.array([each.damping for each in creases]),
        rests=np.array([rests for rests, _ in settings]),
        torques=np.array([torques for _, torques in settings]),
    )


def without_jump(angles: Array, near: Array) -> Array:
    """Angles with as many whole turns as bring them closest to others, rad."""
    return np.asarray(angles + 2 * np.pi * np.round((near - angles) / (2 * np.pi)))
