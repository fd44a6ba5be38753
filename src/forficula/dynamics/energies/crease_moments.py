"""Moments of the creases of structures of one topology, side by side: springs, damping and motors."""

from __future__ import annotations

import dataclasses
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from forficula.arrays import Array, Indices
from forficula.dynamics.engine.model import Model
from forficula.material import CreaseLaw


@dataclass(frozen=True, kw_only=True)
class CreaseMoments:
    """Laws and motors of creases, each in its model's units.

    Attributes:
        senses: +1 or -1, (structure, crease).
        law: of the springs, arrays (structure, crease).
        damping: (structure, crease).
        rests: change of each rest angle per setting of a motor, (structure, motor, crease).
        torques: torque on each crease per setting of a motor, (structure, motor, crease).
        braking: damping of each crease per magnitude of a motor's setting, (structure, motor, crease).
    """

    senses: Array
    law: CreaseLaw
    damping: Array
    rests: Array
    torques: Array
    braking: Array

    def some(self, which: Indices) -> CreaseMoments:
        """Select structures by index, in ascending order."""
        if len(which) == len(self.senses):
            return self
        rows = {
            field.name: getattr(self, field.name)[which] for field in dataclasses.fields(self) if field.name != "law"
        }
        return CreaseMoments(law=self.law.some(which), **rows)

    def at(self, angles: Array, turning: Array, efforts: Array, sets: Array) -> tuple[Array, Array, Array]:
        """Compute moments in own senses, their derivatives by the angle, and the new sets, (structure, crease).

        Args:
            angles: in own senses, rad, (structure, crease).
            turning: speeds of the angles between the flaps, valleys positive, (structure, crease).
            efforts: settings of the motors, (structure, motor).
            sets: permanent folds before, rad, (structure, crease).
        """
        rests, torques, braking = (
            np.einsum("rm,rmc->rc", item, gains)
            for item, gains in ((efforts, self.rests), (efforts, self.torques), (np.abs(efforts), self.braking))
        )
        if self.law.yields:
            before, sets = sets, self.law.next_set(angles, rests, sets)
            rests = rests + self.law.rest_shift(sets)
        moment, slope = self.law.moment_and_slope(angles, rests)
        if self.law.yields:
            # while a crease yields, its moment grows with the slope of the hardening
            slope = slope - np.where(sets != before, np.asarray(self.law.stiffness) - self.law.hardening, 0.0)
        return moment + (self.damping + braking) * self.senses * turning - torques, slope, sets


def crease_moments(models: Sequence[Model]) -> CreaseMoments:
    """Collect the laws and motors of creases of structures of one topology, which must have creases."""
    creases = [model.creases for model in models if model.creases is not None]
    unit = [np.eye(len(model.structure.motors)) for model in models]
    settings = [model.settings(unit_creases) for model, unit_creases in zip(models, unit, strict=True)]
    names = [field.name for field in dataclasses.fields(CreaseLaw)]
    return CreaseMoments(
        senses=np.array([crease.senses for crease in creases], dtype=np.float64),
        law=CreaseLaw(**{name: np.array([np.asarray(getattr(part.law, name)) for part in creases]) for name in names}),
        damping=np.array([part.damping for part in creases]),
        rests=np.array([rests for rests, _ in settings]),
        torques=np.array([torques for _, torques in settings]),
        braking=np.array([model.braking(unit_creases) for model, unit_creases in zip(models, unit, strict=True)]),
    )
