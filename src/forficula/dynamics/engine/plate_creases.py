"""Creases between plates that turn, in the engine: couples between directions of one plate and of the other.

A row of a bending flex is a quadratic form of four nodes. With a direction d of the left plate as the difference of two
nodes of it and one of the right plate, d', alike, a row is the energy -k d . d': a couple and no force, wherever the
plates are. The rows of `PRODUCTS` have any moment with the slope that the angle has by these products, so that its
force is exactly that, even where the crease is askew, and any slope of the moment.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from forficula.arrays import Array, Indices
from forficula.dynamics.energies.crease_moments import CreaseMoments, crease_moments
from forficula.dynamics.engine.crease_rows import without_jump
from forficula.dynamics.engine.model import Model
from forficula.dynamics.engine.placement import stacked
from forficula.dynamics.engine.plate_angles import PRODUCTS
from forficula.dynamics.stepping.folds import Folds


@dataclass(frozen=True, kw_only=True)
class PlateRows:
    """Creases between plates of structures of one topology, side by side.

    Attributes:
        folds: of all of them: constants have a leading dimension, (structure, ...).
        rows: in the engine's flex_bending, those of a crease one after another, (row,).
        forms: a row of energy -d . d', (structure, row, 17).
        moments: of the creases.
    """

    folds: Folds
    rows: Indices
    forms: Array
    moments: CreaseMoments

    def some(self, which: Indices) -> PlateRows:
        """Of some of the structures, in a rising order."""
        folds = self.folds
        assert folds.placement is not None
        return PlateRows(
            folds=replace(folds, placement=folds.placement.some(which), places=folds.places[which]),
            rows=self.rows,
            forms=self.forms[which],
            moments=self.moments.some(which),
        )

    def follow(self, positions: Array, velocities: Array, near: Array, efforts: Array) -> tuple[Array, Array]:
        """Angles of creases, and the rows that have their moments and slopes there; see `CreaseRows.follow`."""
        own, senses = self.moments, self.moments.senses
        apart, turned = self.folds.turns(positions, velocities)
        angles = without_jump(senses * apart.angles, near)
        moment, slope = own.at(angles, turned, efforts)
        factors = -senses * moment * apart.slopes
        # of an energy that has the slope of the moment about the left plate's crease and no force where it is now
        upright, side = apart.values[:2]
        factors[:3] += slope / np.hypot(upright, side) * apart.values[:3]
        values = np.moveaxis(factors, 0, -1).reshape(len(positions), -1)
        return angles, values[..., None] * self.forms


def plate_rows(models: Sequence[Model]) -> PlateRows:
    """Lay the creases between plates of structures of one topology side by side."""
    each = [model.folds for model in models]
    placements = [folds.placement for folds in each if folds.placement is not None]
    folds = replace(each[0], placement=stacked(placements), places=np.array([folds.places for folds in each]))
    creases = models[0].creases
    assert creases is not None
    return PlateRows(
        folds=folds,
        rows=creases.rows,
        forms=np.array([_forms(model, creases.order) for model in models]),
        moments=crease_moments(models),
    )


def _forms(model: Model, order: Indices) -> Array:
    """A row of energy -d . d' for each, of directions as long as its crease, (row, 17)."""
    folds = model.folds
    ends = folds.places[folds.flaps[:, :2]]
    square = np.repeat(np.sum((ends[:, 1] - ends[:, 0]) ** 2, axis=1), len(PRODUCTS))
    # of the nodes in the engine's order: start and end of the direction on the left, and of that on the right
    left = (order == 1).astype(float) - (order == 0)
    right = (order == 3).astype(float) - (order == 2)
    both = left[:, :, None] * right[:, None, :]
    forms = -(both + np.swapaxes(both, 1, 2)) / square[:, None, None]
    return np.concatenate([forms.reshape(len(order), -1), np.zeros((len(order), 1))], axis=1)
