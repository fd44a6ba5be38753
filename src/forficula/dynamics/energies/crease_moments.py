"""Moments of the creases of structures of one topology, side by side: springs, damping and motors."""

from __future__ import annotations

import dataclasses
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from forficula.arrays import Array, Indices
from forficula.dynamics.engine.model import Model
from forficula.material import CreaseLaw
from forficula.material.law.crease_memory import acting_moment, next_memory, yielding_slope


@dataclass(frozen=True, kw_only=True)
class Past:
    """Creases of structures when their numbers in the engine were computed last.

    Attributes:
        angles: in own senses and without jumps, rad, (structure, crease).
        memory: see `CreaseLaw`, (slot, structure, crease).
        elapsed: time since then, in the models' units, (structure, 1).
        block: time over which the next numbers will be constant, in the models' units, (structure, 1).
    """

    angles: Array
    memory: Array
    elapsed: Array
    block: Array

    def some(self, columns: slice) -> Past:
        """Select creases."""
        return dataclasses.replace(self, angles=self.angles[:, columns], memory=self.memory[..., columns])


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

    def at(self, angles: Array, turning: Array, efforts: Array, past: Past) -> tuple[Array, Array, Array]:
        """Compute moments in own senses and their derivatives by the angle, (structure, crease), and the new memory.

        Args:
            angles: in own senses, rad, (structure, crease).
            turning: speeds of the angles between the flaps, valleys positive, (structure, crease).
            efforts: settings of the motors, (structure, motor).
            past: of the creases.
        """
        rests, torques, braking = (
            np.einsum("rm,rmc->rc", item, gains)
            for item, gains in ((efforts, self.rests), (efforts, self.torques), (np.abs(efforts), self.braking))
        )
        memory = next_memory(self.law, angles, rests, past.memory, angles - past.angles, past.elapsed)
        moment, slope = acting_moment(self.law, angles, rests, memory, past.block)
        if self.law.yields or self.law.rubs:
            # while a crease yields, its moment grows with the slope of the hardening; while it slides, it is constant
            slope = slope - yielding_slope(self.law, past.memory, memory)
        return moment + (self.damping + braking) * self.senses * turning - torques, slope, memory


def crease_moments(models: Sequence[Model], *, joints: bool) -> CreaseMoments:
    """Collect the laws and motors of creases of structures of one topology.

    Args:
        models: with creases that are followed.
        joints: whether to collect the creases that are joints, instead of those between flaps.
    """
    creases = [model.creases for model in models if model.creases is not None]
    which = np.flatnonzero((creases[0].joints >= 0) == joints)
    unit = [np.eye(len(model.structure.motors)) for model in models]
    settings = [model.settings(unit_creases) for model, unit_creases in zip(models, unit, strict=True)]
    laws = [part.law.some(which) for part in creases]
    names = [field.name for field in dataclasses.fields(CreaseLaw)]
    return CreaseMoments(
        senses=np.array([crease.senses[which] for crease in creases], dtype=np.float64),
        law=CreaseLaw(**{name: np.array([getattr(law, name) for law in laws]) for name in names}),
        damping=np.array([part.damping[which] for part in creases]),
        rests=np.array([rests[..., which] for rests, _ in settings]),
        torques=np.array([torques[..., which] for _, torques in settings]),
        braking=np.array(
            [model.braking(unit_creases)[..., which] for model, unit_creases in zip(models, unit, strict=True)]
        ),
    )
