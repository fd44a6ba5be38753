"""Energies of a run over time by mechanism, with its motion, its losses and the work of its motors."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from forficula.arrays import Array
from forficula.dynamics import Record
from forficula.dynamics.engine.membrane import joined_mesh, stretch_energy
from forficula.structure import Mechanism, mechanisms_of

# series of works that count as losses; the work of closures is an error of the integration
_LOSSES = (
    "hinge_damping_work",
    "elastic_damping_work",
    "stop_work",
    "friction_work",
    "branch_damping_work",
    "letting_go_work",
    "yield_work",
    "crease_yield_work",
    "crease_branch_work",
    "crease_damage_work",
    "drag_work",
)
# series of the energies of elements, by the field of a mechanism that contains their numbers
_ENERGIES = (
    ("hinges", "hinge_energy"),
    ("springs", "spring_energy"),
    ("tendons", "tendon_energy"),
    ("tendons", "branch_energy"),
    ("couplings", "coupling_energy"),
)


@dataclass(frozen=True, kw_only=True)
class EnergyShares:
    """Energies of a run over time, from which a balance is drawn: stored + weight + kinetic + lost = supplied.

    The difference of both sides is `missing`, the error of the integration.

    Attributes:
        stored: energy of each mechanism by name, J, (time,).
        weight: gravitational energy above its lowest value in the run, J, (time,); None without gravity.
        kinetic: kinetic energy of the whole structure, J, (time,).
        lost: energy dissipated since the start by damping, stops, friction, contacts and drag, with the energy of
            friction springs, J, (time,).
        supplied: energy at the start plus the work of all motors since then, J, (time,).
    """

    stored: Mapping[str, Array]
    weight: Array | None
    kinetic: Array
    lost: Array
    supplied: Array

    @property
    def held(self) -> Array:
        """Return the energy of the structure: stored, gravitational and kinetic, J, (time,)."""
        parts = (*self.stored.values(), *([] if self.weight is None else [self.weight]))
        return sum(parts, self.kinetic)

    @property
    def missing(self) -> Array:
        """Return the supplied energy that is neither in the structure nor lost, J, (time,)."""
        return np.asarray(self.supplied - self.held - self.lost)


def energy_shares(record: Record) -> EnergyShares:
    """Return the energies of a run over time by mechanism.

    Energies of mechanisms are sums of recorded energies of their elements. A record contains the energy of all
    membranes together, so the energies of single membranes are computed from the recorded positions of their nodes.
    """
    series = record.series
    stored = {mechanism.name: _mechanism_energy(record, mechanism) for mechanism in mechanisms_of(record.structure)}
    heights = series["gravitational_energy"]
    weight = np.asarray(heights - np.nanmin(heights)) if record.structure.gravity else None
    kinetic = series["kinetic_energy"]
    lost = -sum((series[name] for name in _LOSSES if name in series), np.zeros(len(record.time)))
    if "contact_work" in series:
        # real contacts only dissipate energy; energy that they supply counts as missing
        lost = lost + np.maximum(-series["contact_work"], 0.0)
    # no mechanism has this energy, which is slight
    lost = lost + series.get("friction_spring_energy", 0.0)
    first = EnergyShares(stored=stored, weight=weight, kinetic=kinetic, lost=lost, supplied=record.work).held[0]
    return EnergyShares(stored=stored, weight=weight, kinetic=kinetic, lost=lost, supplied=first + record.work)


def _mechanism_energy(record: Record, mechanism: Mechanism) -> Array:
    """Return the energy of a mechanism, J, (time,)."""
    energies = [
        record.series[name][:, list(getattr(mechanism, kind))].sum(axis=1)
        for kind, name in _ENERGIES
        if name in record.series and getattr(mechanism, kind)
    ]
    if mechanism.membranes:
        energies.append(_membrane_energy(record, mechanism))
    return sum(energies, np.zeros(len(record.time)))


def _membrane_energy(record: Record, mechanism: Mechanism) -> Array:
    """Return the stretch energy of the membranes of a mechanism, J, (time,)."""
    membranes = record.structure.membranes
    if len(mechanism.membranes) == len(membranes):
        return record.series["membrane_energy"]
    first = np.cumsum([0, *(len(membrane.bodies) for membrane in membranes)])
    nodes = record.series["membrane_position"]
    with np.errstate(over="ignore", invalid="ignore"):  # diverged runs
        energies = [
            stretch_energy(nodes[:, first[number] : first[number + 1]], joined_mesh([membranes[number]]))
            for number in mechanism.membranes
        ]
    return sum(energies, np.zeros(len(record.time)))
