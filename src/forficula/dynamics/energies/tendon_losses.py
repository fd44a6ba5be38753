"""Losses of tendons with dampers and Maxwell branches, and the work of clamping tendons that must not push."""

from __future__ import annotations

import dataclasses
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from forficula.arrays import Array, Indices
from forficula.dynamics.energies.energy import branch_forces, branch_numbers
from forficula.dynamics.engine.model import Model
from forficula.dynamics.stepping.steps import Steps
from forficula.material.law.relaxation import square_integrals
from forficula.material.law.tendon_law import ElasticLaw, stacked_laws


class TendonLosses:
    """Losses in the tendons of many structures of one topology, computed for all of them at once.

    Most time of a batch of many structures on many cores or on a device was spent in a loop over structures.
    """

    def __init__(self, models: Sequence[Model]) -> None:
        """Divide the structures into sets whose tendons are clamped and have branches at the same positions."""
        keys: dict[object, list[int]] = {}
        for number, model in enumerate(models):
            if model.branches.size or model.lets_go.any():
                key = (model.lets_go.tobytes(), model.branches.shape, model.branches.tobytes())
                keys.setdefault(key, []).append(number)
        self._sets = [AlikeTendons.of([models[number] for number in numbers]) for numbers in keys.values()]
        # set of each structure, -1 without losses, and its position in this set
        self._set, self._place = np.full(len(models), -1), np.zeros(len(models), dtype=int)
        for place, numbers in enumerate(keys.values()):
            self._set[numbers], self._place[numbers] = place, np.arange(len(numbers))

    def add(self, work: dict[str, Array], rows: Indices, steps: Steps, travel: Array) -> None:
        """Add losses to works, (row, step), in the models' units.

        Args:
            work: by name; the work of dampers is there.
            rows: numbers of the structures.
            steps: of these structures.
            travel: of the joints in each step, (row, step, dof).
        """
        for number, alike in enumerate(self._sets):
            some = np.flatnonzero(self._set[rows] == number)
            if not len(some):
                continue
            places, part = self._place[rows[some]], slice(None) if len(some) == len(rows) else some
            activations = steps.activations()[part]
            if alike.branches.size:
                lost = work.setdefault("branch_damping_work", np.zeros(travel.shape[:2]))
                lost[part] = -alike.branch_losses(places, activations).sum(axis=(2, 3))
            if len(alike.which):
                fields, late = (
                    {name: np.asarray(values[name])[part] for name in ("ten_length", "ten_velocity", "ten_J")}
                    if values
                    else {}
                    for values in (steps.derived, steps.late)
                )
                damper, spared = alike.clamping_work(places, travel[part], fields, late, activations)
                work["elastic_damping_work"][part] += damper
                if alike.branches.size:
                    work.setdefault("letting_go_work", np.zeros(travel.shape[:2]))[part] = spared


@dataclass(frozen=True, kw_only=True, eq=False)
class AlikeTendons:
    """Numbers of tendons of structures that are clamped and have Maxwell branches at the same positions.

    Attributes:
        timestep: (structure,).
        which: numbers of the clamped tendons, (clamped,).
        tendons: their numbers in the engine, (clamped,).
        entries: entries of the engine's ten_J for these tendons, (entry,).
        dofs: joint of each entry, (entry,).
        first: first entry of each tendon, (clamped,).
        elastic: spring of each clamped tendon, (structure, clamped).
        viscous: linear damping of each clamped tendon, (structure, clamped).
        alone: whether a clamped tendon has no branches, (structure, clamped).
        branches: index of the forces of branches, (tendon, branch), as in `Model.branches`.
        squares: integrals over a step, see `square_integrals`, (structure, 3, tendon, branch).
        viscosity: of the dampers of branches, (structure, tendon, branch).
        model: of the first structure.
    """

    timestep: Array
    which: Indices
    tendons: Indices
    entries: Indices
    dofs: Indices
    first: Indices
    elastic: ElasticLaw
    viscous: Array
    alone: Array
    branches: Indices
    squares: Array
    viscosity: Array
    model: Model

    @classmethod
    def of(cls, models: Sequence[Model]) -> AlikeTendons:
        """Return the numbers of some structures."""
        model = models[0]
        which = np.flatnonzero(model.lets_go)
        levers = [model.levers(tendon) for tendon in model.tendons[which]]
        laws = [[item.in_units.tendons[tendon].law for tendon in which] for item in models]
        squares, viscosity = [], []
        for item in models:
            time, stiffness = branch_numbers(item)
            # most tendons have the same branches
            different, number = np.unique(time, axis=0, return_inverse=True)
            integrals = np.array([square_integrals(times, item.timestep) for times in different])
            squares.append(np.moveaxis(integrals[number.ravel()], 1, 0) if time.size else np.zeros((3, *time.shape)))
            viscosity.append(stiffness * time)
        return cls(
            timestep=np.array([item.timestep for item in models]),
            which=which,
            tendons=model.tendons[which],
            entries=np.concatenate([np.arange(0), *(np.arange(span.start, span.stop) for span, _ in levers)]),
            dofs=np.concatenate([np.arange(0), *(dofs for _, dofs in levers)]),
            first=np.cumsum([0, *(len(dofs) for _, dofs in levers[:-1])]),
            elastic=stacked_laws([law.elastic for of_model in laws for law in of_model]),
            viscous=np.array([[(law.damping or (0.0,))[0] for law in of_model] for of_model in laws]),
            alone=np.array([[not law.branches for law in of_model] for of_model in laws]),
            branches=model.branches,
            squares=np.array(squares),
            viscosity=np.array(viscosity),
            model=model,
        )

    def branch_losses(self, places: Indices, activations: Array) -> Array:
        """Compute the energy that Maxwell branches dissipate in each step, (structure, step, tendon, branch).

        It is the integral of F^2 / (k tau). Between two steps the engine assumes a constant velocity, so the force is
        F0 a + F1 b with b = (1 - exp(-s / tau)) / (1 - exp(-h / tau)) and a = exp(-s / tau) - exp(-h / tau) b.

        Args:
            places: of the structures.
            activations: forces of Maxwell branches before the first step and after each step,
                (structure, step + 1, activation).
        """
        force = self._forces(activations)
        before, after = force[:, :-1], force[:, 1:]
        squares = self.squares[places][:, :, None]
        total = squares[:, 0] * before**2 + squares[:, 1] * before * after + squares[:, 2] * after**2
        return np.asarray(total / self.viscosity[places][:, None])

    def clamping_work(
        self,
        places: Indices,
        travel: Array,
        fields: Mapping[str, Array],
        late: Mapping[str, Array],
        activations: Array,
    ) -> tuple[Array, Array]:
        """Compute the work of the dampers of clamped tendons, and of their clamping, (structure, step).

        When a tendon without branches would push, its damper dissipates exactly the energy that its spring releases.

        Args:
            places: of the structures.
            travel: of the joints in each step, (structure, step, dof).
            fields: ten_length, ten_velocity and ten_J before each step.
            late: the same fields after each step, for steps of Runge and Kutta; empty for other steps.
            activations: as for `branch_losses`.
        """
        if late:
            ends = [
                [part * values["ten_velocity"][:, :, self.tendons] for part in self._letting_go(places, values, forces)]
                for values, forces in ((fields, activations[:, :-1]), (late, activations[:, 1:]))
            ]
            half = self.timestep[places, None, None]
            damper, spared = ((one + other) * half / 2 for one, other in zip(*ends, strict=True))
            return -np.sum(damper, axis=2), -np.sum(spared, axis=2)
        turned = fields["ten_J"][:, :, self.entries] * travel[:, :, self.dofs]
        longer = np.add.reduceat(turned, self.first, axis=2)
        # the engine uses the branches' forces after the step
        damper, spared = self._letting_go(places, fields, activations[:, 1:])
        return -np.sum(damper * longer, axis=2), -np.sum(spared * longer, axis=2)

    def _letting_go(self, places: Indices, fields: Mapping[str, Array], activations: Array) -> tuple[Array, Array]:
        """Return the pull of dampers, and the excess of tendons' pulls over their parts, (structure, step, clamped)."""
        length = fields["ten_length"][:, :, self.tendons]
        law = self._elastic(places)
        spring, viscous = law.force(length), self.viscous[places, None]
        damper = viscous * fields["ten_velocity"][:, :, self.tendons]
        taut = length > law.rest_length
        if not self.branches.size:
            pull = np.where(taut, np.maximum(spring + damper, 0.0), 0.0)
            return pull - spring, np.zeros_like(pull)
        # positive values push
        push = self._forces(activations)[:, :, self.which].sum(axis=3)
        pull = np.where(taut, np.maximum(spring + damper - push, 0.0), 0.0)
        damper = np.where(self.alone[places, None], pull - spring, np.where(taut, damper, 0.0))
        return damper, pull - spring - damper + push

    def _forces(self, activations: Array) -> Array:
        """Return the forces of Maxwell branches, (structure, state, tendon, branch), 0 for absent ones."""
        count, states = activations.shape[:2]
        forces = branch_forces(self.model, activations.reshape(count * states, -1))
        return forces.reshape(count, states, *self.branches.shape)

    def _elastic(self, places: Indices) -> ElasticLaw:
        """Return the springs of clamped tendons as one law of arrays, (structure, 1, clamped)."""
        numbers: Any = {
            field.name: np.reshape(getattr(self.elastic, field.name), self.viscous.shape)[places, None]
            for field in dataclasses.fields(ElasticLaw)
        }
        return ElasticLaw(**numbers)
