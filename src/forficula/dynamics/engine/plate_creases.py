"""Creases between plates that turn, in the engine: couples between directions of both plates.

A row of a bending flex is a quadratic form of four nodes. If two nodes define a direction d of the left plate, and two
others a direction d' of the right plate, a row is the energy -k d . d', which is a couple without a force for any pose
of the plates. The rows of `PRODUCTS`, weighted with the derivatives of the angle by these products, represent any
moment exactly, even if the crease is askew, and any slope of the moment.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from forficula.arrays import Array, Indices
from forficula.dynamics.energies.crease_moments import CreaseMoments, Past, crease_moments
from forficula.dynamics.engine.crease_rows import without_jump
from forficula.dynamics.engine.model import Model
from forficula.dynamics.engine.placement import stacked
from forficula.dynamics.engine.plate_angles import PRODUCTS
from forficula.dynamics.stepping.folds import Folds


@dataclass(frozen=True, kw_only=True)
class PlateRows:
    """Creases between plates of structures of one topology, side by side.

    Attributes:
        folds: of all structures: constants have a leading dimension, (structure, ...).
        rows: in the engine's flex_bending, crease after crease, (row,).
        forms: rows of the energy -d . d', (structure, row, 17).
        moments: of the creases.
    """

    folds: Folds
    rows: Indices
    forms: Array
    moments: CreaseMoments

    def some(self, which: Indices) -> PlateRows:
        """Select structures by index, in ascending order."""
        folds = self.folds
        assert folds.placement is not None
        return PlateRows(
            folds=replace(folds, placement=folds.placement.some(which), places=folds.places[which]),
            rows=self.rows,
            forms=self.forms[which],
            moments=self.moments.some(which),
        )

    def follow(self, positions: Array, velocities: Array, efforts: Array, past: Past) -> tuple[Array, Array, Array]:
        """Compute the angles of creases, and rows with their moments and slopes; see `CreaseRows.follow`."""
        moments, senses = self.moments, self.moments.senses
        apart, turned = self.folds.turns(positions, velocities)
        angles = without_jump(senses * apart.angles, past.angles)
        moment, slope, memory = moments.at(angles, turned, efforts, past)
        factors = -senses * moment * apart.slopes
        # add an energy without force at the present angle that has the slope of the moment
        upright, side = apart.values[:2]
        factors[:3] += slope / np.hypot(upright, side) * apart.values[:3]
        values = np.moveaxis(factors, 0, -1).reshape(len(positions), -1)
        return angles, memory, values[..., None] * self.forms


def plate_rows(models: Sequence[Model]) -> PlateRows:
    """Collect the creases between plates of structures of one topology side by side."""
    every = [model.folds for model in models]
    placements = [folds.placement for folds in every if folds.placement is not None]
    folds = replace(every[0], placement=stacked(placements), places=np.array([folds.places for folds in every]))
    creases = models[0].creases
    assert creases is not None
    return PlateRows(
        folds=folds,
        rows=creases.rows,
        forms=np.array([_forms(model, creases.order) for model in models]),
        moments=crease_moments(models, joints=False),
    )


def _forms(model: Model, order: Indices) -> Array:
    """Return rows of the energy -d . d' of directions as long as their creases, (row, 17)."""
    folds = model.folds
    ends = folds.places[folds.flaps[:, :2]]
    square = np.repeat(np.sum((ends[:, 1] - ends[:, 0]) ** 2, axis=1), len(PRODUCTS))
    # signs of the nodes in the engine's order: start and end of the direction on the left, and on the right
    left = (order == 1).astype(float) - (order == 0)
    right = (order == 3).astype(float) - (order == 2)
    both = left[:, :, None] * right[:, None, :]
    forms = -(both + np.swapaxes(both, 1, 2)) / square[:, None, None]
    return np.concatenate([forms.reshape(len(order), -1), np.zeros((len(order), 1))], axis=1)
