"""Energies of states, and what tendons with branches take, from what the engine recorded."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

from forficula.dynamics.membrane import membrane_energy
from forficula.dynamics.model import WingModel

Array = NDArray[np.float64]

# of the quadrature over a step, exact to 1e-9 up to steps of 20 relaxation times
_NODES = 16


def letting_go_work(
    wing: WingModel, travel: Array, forces: Mapping[str, Array], activations: Array
) -> tuple[Array, Array]:
    """Work of the dampers of tendons that let go, and of what keeps them from pushing, (step,), in the model's units.

    Args:
        wing: the model.
        travel: of the joints in each step, (step, dof), in the model's units.
        forces: ten_length, ten_velocity and ten_J before each step.
        activations: forces of Maxwell branches before the first step and after each, (step + 1, activation).
    """
    law = wing.tendon_law
    longer = np.stack(
        [
            np.sum(forces["ten_J"][:, entries] * travel[:, dofs], axis=1)
            for entries, dofs in (wing.levers(tendon) for tendon in wing.tendons)
        ],
        axis=1,
    )
    spring = law.elastic.force(forces["ten_length"][:, wing.tendons])
    damper = (law.damping or (0.0,))[0] * forces["ten_velocity"][:, wing.tendons]
    # the engine takes the branches' forces after the step; they are > 0 where they push
    push = activations[1:, wing.branches].sum(axis=2) - spring - damper
    return -np.sum(damper * longer, axis=1), -np.sum(np.maximum(push, 0.0) * longer, axis=1)


def branch_losses(wing: WingModel, activations: Array) -> Array:
    """What Maxwell branches turn into heat in each step, (step, vein, branch), in the model's units.

    The integral of F^2 / (k tau), with the force between two steps as the engine has it at a constant velocity:
    F0 a + F1 b with b = (1 - exp(-s / tau)) / (1 - exp(-h / tau)) and a = exp(-s / tau) - exp(-h / tau) b.
    """
    force = activations[:, wing.branches]
    before, after = force[:-1], force[1:]
    timestep = float(wing.in_units.protocol.timestep)
    time = np.array([branch.time for branch in wing.tendon_law.branches])
    stiffness = np.array([branch.stiffness for branch in wing.tendon_law.branches])
    # three integrals of positive numbers by quadrature: their closed forms lose all digits where h is far below tau
    nodes, weights = np.polynomial.legendre.leggauss(_NODES)
    share, width = (nodes[:, None] + 1) / 2, timestep / time
    late = np.expm1(-share * width) / np.expm1(-width)
    early = np.exp(-share * width) - np.exp(-width) * late
    squares = [weights @ product * timestep / 2 for product in (early * early, 2 * early * late, late * late)]
    total = squares[0] * before**2 + squares[1] * before * after + squares[2] * after**2
    return np.asarray(total / (stiffness * time))


def _by_vein(wing: WingModel, joints: Array) -> Array:
    """Sweep, lift, turn and fold by vein, (state, vein, 4), of joints (state, dof)."""
    # a hinge that a fixed base lacks has index -1 and reads the 0 at the end
    return np.concatenate([joints, np.zeros((len(joints), 1))], axis=1)[:, wing.joints]


def state_series(wing: WingModel, positions: Array, derived: Mapping[str, Array]) -> dict[str, Array]:
    """What the record says of states, SI.

    Args:
        wing: the model.
        positions: (state, dof), in the model's units.
        derived: of the same states, by MuJoCo's names, in the model's units: energy, ten_length, flexvert_xpos, xpos,
            xipos, site_xpos; or ten_length alone.

    Returns:
        Arrays (state, ...) for the names of `record.VARIABLES` that are neither power nor work; of ten_length alone
        only those that need nothing else.
    """
    units, law = wing.units, wing.tendon_law
    sweep, lift, turn, fold = np.moveaxis(_by_vein(wing, positions), -1, 0)
    length = derived["ten_length"][:, wing.tendons]
    # 0 where the resting length stays
    crept = derived["plastic"][:, wing.creep] - law.rest_length if wing.creep.size else np.zeros_like(length)
    series = {
        "sweep_angle": sweep,
        "lift_angle": lift,
        "turn_angle": wing.senses * turn,
        "distal_angle": wing.senses * fold,
        "tendon_length": units.length * length,
        "tendon_energy": units.energy * law.elastic.energy(length - crept),
    }
    if wing.creep.size:
        series["tendon_rest_length"] = units.length * (law.rest_length + crept)
        # ideal plasticity: the yield force times the creep since the first state
        series["yield_work"] = -units.energy * (law.yield_force or 0.0) * np.sum(crept - crept[0], axis=1)
    if wing.branches.size:
        stiffness = np.array([branch.stiffness for branch in law.branches])
        force = derived["act"][:, wing.branches]
        series["branch_energy"] = units.energy * np.sum(force**2 / (2 * stiffness), axis=-1)
    if "xpos" not in derived:
        return series
    places = derived["xpos"][:, wing.bodies]
    tips = derived["site_xpos"][:, wing.tips]
    return series | {
        **state_energies(wing, derived),
        "vein_position": units.length * np.concatenate([places, tips[:, :, None]], axis=2),
        "membrane_position": units.length * derived["flexvert_xpos"],
    }


def state_energies(wing: WingModel, derived: Mapping[str, Array]) -> dict[str, Array]:
    """Energies of states but for the tendons', J, (state,).

    Args:
        wing: the model.
        derived: of the states, by MuJoCo's names, in the model's units: energy, flexvert_xpos, xipos.
    """
    units, height = wing.units, np.sum(wing.engine.body_mass * derived["xipos"][..., 2], axis=-1)
    with np.errstate(over="ignore", invalid="ignore"):  # of a wing that blows up
        return {
            "membrane_energy": units.energy * membrane_energy(derived["flexvert_xpos"], wing.membrane, wing.in_units),
            "kinetic_energy": units.energy * derived["energy"][:, 1],
            "gravitational_energy": units.energy * wing.in_units.protocol.gravity * height,
        }
