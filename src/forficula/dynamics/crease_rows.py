"""Rows of a bending flex that follow the creases of many structures: any law, torque, damping and moving rest angle.

MuJoCo's bending of a flex is by edge and exact: a moment k sin(angle - r), without a jump anywhere. A row can be
changed between steps, so that it has at any angle the moment and the slope that the crease has there.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from forficula.dynamics.model import Model
from forficula.material import CreaseLaw
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
        senses: +1 or -1, (structure, crease).
        law: of the springs, arrays (structure, crease).
        damping: (structure, crease).
        rests: by how much what a motor is set to moves each rest angle, (structure, motor, crease).
        torques: by how much it turns each crease, (structure, motor, crease).
        braking: by how much its size damps each crease, (structure, motor, crease).
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
    braking: Array

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
        every = len(which) == len(self.built)
        law = self.law if every else self.law.some(which)
        senses = self.senses[which]
        edge, away = self._sides(self.built[which], positions)
        edge_moves, moves = self._sides(None, velocities)
        # of the left and the right flap, whose normals are up in a flat sheet
        normals = cross(edge[:, None], away) * _UP
        square, area = dot(edge, edge), dot(normals, normals)
        length, share = np.sqrt(square), dot(away, edge[:, None]) / square
        volume = dot(away[:, 1], normals[:, 0])
        angles = without_jump(senses * np.arctan2(length * volume, dot(normals[:, 0], normals[:, 1])), near)
        turning = length * (dot(normals, moves - share * edge_moves[:, None]) / area).sum(axis=0)
        rests, torques = (np.einsum("rm,rmc->rc", efforts, each[which]) for each in (self.rests, self.torques))
        moment, slope = law.moment_and_slope(angles, rests)
        damping = self.damping[which] + np.einsum("rm,rmc->rc", np.abs(efforts), self.braking[which])
        moment = moment + damping * senses * turning - torques
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
        across, own = share * square, dot(away, away)
        densities = np.zeros((4, 4, *angles.shape))
        densities[2:, 1] = (along * own - off * across) / area
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
        **stacked_creases(models),
    )


def stacked_creases(models: Sequence[Model]) -> dict[str, Any]:
    """Senses, law, damping and what motors do, of creases of structures of one topology, as `CreaseRows` has them."""
    creases = [model.creases for model in models if model.creases is not None]
    unit = [np.eye(len(model.structure.motors)) for model in models]
    settings = [model.settings(each) for model, each in zip(models, unit, strict=True)]
    laws = [each.law for each in creases]
    return {
        "senses": np.array([each.senses for each in creases], dtype=np.float64),
        "law": CreaseLaw(
            **{
                each.name: np.array([np.asarray(getattr(law, each.name)) for law in laws])
                for each in dataclasses.fields(CreaseLaw)
            }
        ),
        "damping": np.array([each.damping for each in creases]),
        "rests": np.array([rests for rests, _ in settings]),
        "torques": np.array([torques for _, torques in settings]),
        "braking": np.array([model.braking(each) for model, each in zip(models, unit, strict=True)]),
    }


def without_jump(angles: Array, near: Array) -> Array:
    """Angles with as many whole turns as bring them closest to others, rad."""
    return np.asarray(angles + 2 * np.pi * np.round((near - angles) / (2 * np.pi)))
