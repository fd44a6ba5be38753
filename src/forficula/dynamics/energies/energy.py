"""Energies of states, and losses of tendons with Maxwell branches, from fields recorded by the engine."""

from __future__ import annotations

import copy
from collections.abc import Mapping
from functools import reduce

import mujoco
import numpy as np

from forficula.arrays import Array, Indices
from forficula.dynamics.engine.couplings import coupling_energies
from forficula.dynamics.engine.membrane import stretch_energy
from forficula.dynamics.engine.model import Model
from forficula.dynamics.engine.warnings import quiet
from forficula.dynamics.stepping.steps import MEMORY, MOVING
from forficula.material.law.crease_memory import remaining_share, stored_energy
from forficula.material.law.relaxation import square_integrals

# fields of the engine that `clamping_work` needs
CLAMPING_FIELDS = ("ten_length", "ten_velocity", "ten_J")


def clamping_work(
    model: Model, travel: Array, forces: Mapping[str, Array], late: Mapping[str, Array], activations: Array
) -> tuple[Array, Array]:
    """Compute the work of the dampers of tendons that must not push, and of their clamping, (step,), in model units.

    When a tendon without branches would push, its damper dissipates exactly the energy that its spring releases.

    Args:
        model: the model.
        travel: of the joints in each step, (step, dof), in the model's units.
        forces: ten_length, ten_velocity and ten_J before each step.
        late: the same fields after each step, for steps of Runge and Kutta; empty for other steps.
        activations: forces of Maxwell branches before the first step and after each step, (step + 1, activation).
    """
    which = np.flatnonzero(model.lets_go)
    if late:
        ends = [
            _letting_go(model, which, *arguments) for arguments in ((forces, activations[:-1]), (late, activations[1:]))
        ]
        powers = [
            [part * fields["ten_velocity"][:, model.tendons[which]] for part in end]
            for end, fields in zip(ends, (forces, late), strict=True)
        ]
        damper, spared = ((one + other) * model.timestep / 2 for one, other in zip(*powers, strict=True))
        return -np.sum(damper, axis=1), -np.sum(spared, axis=1)
    levers = [model.levers(tendon) for tendon in model.tendons[which]]
    entries = np.concatenate([np.arange(span.start, span.stop) for span, _ in levers])
    first = np.cumsum([0, *(len(dofs) for _, dofs in levers[:-1])])
    turned = forces["ten_J"][:, entries] * travel[:, np.concatenate([dofs for _, dofs in levers])]
    longer = np.add.reduceat(turned, first, axis=1)
    # the engine uses the branches' forces after the step
    damper, spared = _letting_go(model, which, forces, activations[1:])
    return -np.sum(damper * longer, axis=1), -np.sum(spared * longer, axis=1)


def _letting_go(model: Model, which: Indices, forces: Mapping[str, Array], activations: Array) -> tuple[Array, Array]:
    """Return the pull of dampers of some tendons, and the excess of tendons' pulls over their parts, (step, tendon)."""
    length = forces["ten_length"][:, model.tendons]
    laws = [model.in_units.tendons[tendon].law for tendon in which]
    spring = model.elastic.force(length)[:, which]
    viscous = np.array([(law.damping or (0.0,))[0] for law in laws])
    damper = viscous * forces["ten_velocity"][:, model.tendons[which]]
    taut = length[:, which] > np.asarray(model.elastic.rest_length)[which]
    if not model.branches.size:
        pull = np.where(taut, np.maximum(spring + damper, 0.0), 0.0)
        return pull - spring, np.zeros_like(pull)
    # positive values push
    push = branch_forces(model, activations)[:, which].sum(axis=2)
    pull = np.where(taut, np.maximum(spring + damper - push, 0.0), 0.0)
    alone = np.array([not law.branches for law in laws])
    damper = np.where(alone, pull - spring, np.where(taut, damper, 0.0))
    return damper, pull - spring - damper + push


def branch_losses(model: Model, activations: Array) -> Array:
    """Compute the energy that Maxwell branches dissipate in each step, (step, tendon, branch), in the model's units.

    It is the integral of F^2 / (k tau). Between two steps the engine assumes a constant velocity; see
    `square_integrals`.
    """
    force = branch_forces(model, activations)
    before, after = force[:-1], force[1:]
    time, stiffness = branch_numbers(model)
    # most tendons have the same branches
    different, which = np.unique(time, axis=0, return_inverse=True)
    integrals = np.array([square_integrals(times, model.timestep) for times in different])
    squares = np.moveaxis(integrals[which.ravel()], 1, 0)
    total = squares[0] * before**2 + squares[1] * before * after + squares[2] * after**2
    return np.asarray(total / (stiffness * time))


def branch_forces(model: Model, activations: Array) -> Array:
    """Return the forces of Maxwell branches, (state, tendon, branch), 0 for absent ones, from (state, activation)."""
    if model.branches.size and model.branches.min() < 0:
        activations = np.concatenate([activations, np.zeros((len(activations), 1))], axis=1)
    return np.asarray(activations[:, model.branches])


def branch_numbers(model: Model) -> tuple[Array, Array]:
    """Return relaxation times and stiffnesses of Maxwell branches, (tendon, branch), in model units; 1 if absent."""
    time, stiffness = np.ones(model.branches.shape), np.ones(model.branches.shape)
    for number, tendon in enumerate(model.in_units.tendons):
        for place, branch in enumerate(tendon.law.branches):
            time[number, place], stiffness[number, place] = branch.time, branch.stiffness
    return time, stiffness


def state_series(
    model: Model, angles: Array, derived: Mapping[str, Array], efforts: Array | None = None
) -> dict[str, Array]:
    """Compute the series of a record from states, SI.

    Args:
        model: the model.
        angles: of the hinges in their own senses, rad, (state, hinge).
        derived: fields of the same states, by MuJoCo's names, in the model's units: energy, ten_length, flexvert_xpos,
            xpos, xipos, site_xpos; or ten_length alone.
        efforts: settings of the motors, in the model's units, (state, motor); by default 0.

    Returns:
        Arrays (state, ...) for the names of `record.VARIABLES` that are neither power nor work; from ten_length alone,
        only those that need no other field.
    """
    units, built = model.units, model.in_units
    length = derived["ten_length"][:, model.tendons]
    rest = model.elastic.rest_length
    # 0 if the resting length is constant
    crept = np.zeros_like(length)
    yielding = model.creep >= 0
    if yielding.any():
        crept[:, yielding] = derived["plastic"][:, model.creep[yielding]] - np.asarray(rest)[yielding]
    series = {
        "hinge_angle": angles,
        "tendon_length": units.length * length,
        "tendon_energy": units.energy * model.elastic.energy(length - crept),
    }
    set_to = np.zeros((len(angles), len(built.motors))) if efforts is None else efforts
    series |= _hinge_series(model, angles, set_to, derived)
    if any(not coupling.rigid for coupling in built.couplings):
        series["coupling_energy"] = units.energy * coupling_energies(built, angles)
    if built.springs:
        stiffness, lengths = (
            np.array([getattr(spring, name) for spring in built.springs]) for name in ("stiffness", "rest_length")
        )
        longer = derived["ten_length"][:, model.springs] - lengths
        series["spring_force"] = units.energy / units.length * stiffness * longer
        series["spring_energy"] = units.energy * stiffness / 2 * longer**2
    if model.distances.size:
        series["distance"] = units.length * derived["ten_length"][:, model.distances]
    if yielding.any():
        series["tendon_rest_length"] = units.length * (rest + crept)
        # ideal plasticity: the yield force times the creep since the first state
        force = np.array([tendon.law.yield_force or 0.0 for tendon in built.tendons])
        further = crept - crept[0]
        of_forces = [
            -units.energy * yields * np.sum(further[:, force == yields], axis=1) for yields in np.unique(force).tolist()
        ]
        series["yield_work"] = reduce(np.add, of_forces)
    if model.branches.size:
        _, stiffness = branch_numbers(model)
        energy = branch_forces(model, derived["act"]) ** 2 / (2 * stiffness)
        series["branch_energy"] = units.energy * np.sum(energy, axis=-1)
        pull = model.elastic.force(length - crept) - branch_forces(model, derived["act"]).sum(axis=-1)
        silent = model.lets_go & ((pull < 0) | (length < rest))
        series["tendon_pull"] = units.energy / units.length * np.where(silent, 0.0, pull)
    if "xpos" not in derived:
        return series
    at_origin = model.sites < 0
    points = np.where(at_origin[:, None], derived["xpos"][:, model.carriers], _site_places(model, derived["site_xpos"]))
    return series | {
        **state_energies(model, derived),
        "point_position": units.length * points,
        "membrane_position": units.length * membrane_nodes(model, derived),
    }


def _hinge_series(model: Model, angles: Array, efforts: Array, derived: Mapping[str, Array]) -> dict[str, Array]:
    """Return energies of hinges' springs, if there are any, rest angles that motors move, and permanent folds."""
    hinges, series = model.in_units.hinges, dict[str, Array]()
    springs, rests = (np.array([getattr(hinge, name) for hinge in hinges]) for name in ("stiffness", "rest_angle"))
    if (yielding := model.hinge_creep >= 0).any():
        sets = np.zeros_like(angles)
        rest = model.folds.senses[yielding] * derived["plastic"][:, model.hinge_creep[yielding]]
        sets[:, yielding] = rest - rests[yielding]
        hardening = np.where(yielding, [hinge.hardening for hinge in hinges], springs)
        energy = hardening / 2 * (angles - rests) ** 2 + (springs - hardening) / 2 * (angles - rests - sets) ** 2
        energy *= model.units.energy
        series["hinge_set"] = sets
    else:
        energy = model.units.energy * springs / 2 * (angles - rests) ** 2
    quadratic, cubic = (np.array([getattr(hinge, name) for hinge in hinges]) for name in ("quadratic", "cubic"))
    if quadratic.any() or cubic.any():
        x = angles - rests
        energy += model.units.energy * x**3 * (quadratic / 3 + x * cubic / 4)
    if model.creases is not None:
        creases, (further, _) = model.followed_hinges, model.settings(efforts)
        law, memory = model.creases.law, np.moveaxis(derived[MEMORY], 1, 0)
        energy[:, creases] = model.units.energy * stored_energy(law, angles[:, creases], further, memory)
        if law.yields:
            series.setdefault("hinge_set", np.zeros_like(angles))[:, creases] = memory[0]
        if law.wears:
            series["hinge_remaining"] = np.ones_like(angles)
            series["hinge_remaining"][:, creases] = remaining_share(law, memory)
        springs = springs + np.bincount(
            creases, (np.isfinite(law.lower) | np.isfinite(law.upper)).astype(float), len(hinges)
        )
        springs = springs + np.bincount(creases, np.sum(law.branch_stiffness, axis=-1), len(hinges))
        if any(motor.kind == "rest-angle" for motor in model.structure.motors):
            series["hinge_rest_angle"] = np.broadcast_to(rests, angles.shape).copy()
            series["hinge_rest_angle"][:, creases] += further
    if springs.any():
        series["hinge_energy"] = energy
    return series


def _site_places(model: Model, sites: Array) -> Array:
    """Return the positions of the points that are sites, (state, point, 3); arbitrary values for other points."""
    if not sites.shape[1]:
        return np.zeros((len(sites), len(model.sites), 3))
    return np.asarray(sites[:, np.maximum(model.sites, 0)])


def membrane_nodes(model: Model, derived: Mapping[str, Array]) -> Array:
    """Return the positions of the nodes of the membranes, (state, node, 3), among those of all flexes."""
    return np.asarray(derived["flexvert_xpos"][:, model.first_node : model.first_node + len(model.mesh.bodies)])


def state_energies(model: Model, derived: Mapping[str, Array]) -> dict[str, Array]:
    """Compute the energies of states except those of tendons and hinges, J, (state,).

    Args:
        model: the model.
        derived: fields of the states, by MuJoCo's names, in the model's units: energy, flexvert_xpos, xipos.
    """
    # the added mass of the medium has no weight
    weighs = model.engine.body_mass * (1 - model.engine.body_gravcomp)
    units, height = model.units, np.sum(weighs * (derived["xipos"] @ -np.array(model.in_units.down)), axis=-1)
    with np.errstate(over="ignore", invalid="ignore"):  # diverging structures
        return {
            "membrane_energy": units.energy * stretch_energy(membrane_nodes(model, derived), model.mesh),
            "kinetic_energy": units.energy * derived["energy"][:, 1],
            "gravitational_energy": units.energy * model.in_units.gravity * height,
        }


def energy_of(model: Model, moving: Array) -> float:
    """Compute the energy of springs, weight and motion, in the model's units, from a state of `Steps.after`.

    Springs whose numbers in the engine change, see `EngineCreases`, are left out.
    """
    engine = model.engine
    if model.creases is not None and (model.creases.joints >= 0).any():
        engine = copy.copy(engine)
        engine.jnt_stiffness[model.creases.joints[model.creases.joints >= 0]] = 0.0
    data = mujoco.MjData(engine)
    mujoco.mj_setState(engine, data, moving, MOVING)
    with quiet:
        mujoco.mj_forward(engine, data)
    # the engine also counts the weight of floating masses
    floats = model.engine.body_mass * model.engine.body_gravcomp
    return float(data.energy.sum() + floats @ (data.xipos @ model.engine.opt.gravity))
