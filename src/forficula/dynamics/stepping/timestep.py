"""Longest timestep for the stiffest mode of a structure."""

from __future__ import annotations

import copy
import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import lru_cache
from typing import Any

import mujoco
import numpy as np
import scipy

from forficula.arrays import Array
from forficula.design import AnyDesign, Design, as_design, key_quantity, load_design, with_values
from forficula.dynamics.engine.drag import KINEMATICS, Drag, stacked_drag
from forficula.dynamics.engine.model import Model, compile_model
from forficula.dynamics.stepping.node_modes import node_timestep, short_edge
from forficula.errors import InputError
from forficula.material.law.maxwell_element import MaxwellElement
from forficula.quantities import show_quantity, show_value
from forficula.structure import Structure, crease_law, structure_of, tendon_arms

# Folding stretches the membrane and pleats the veins together: along the fold the limit was measured to fall to about
# half of the flat wing's (reference design: 2.4 ms flat, 1.2 ms at the snap; seven veins, 5 MPa: 0.40 and 0.23 ms).
_FOLDING = 0.5
# A quarter of that: eleven veins driven by 100 N cm were measured to diverge from 0.4 of it on, the reference from 0.9.
_SAFETY = 0.25
# share of the limit of nodes as built, because folding brings neighbouring creases closer together
_KEPT = 0.8
_NUDGE = 1e-6
STEPS_TO_TIME_CONSTANT = 4
# of contacts: with four the folded stack of the reference depends on the timestep, with eight it does not
STEPS_TO_CONTACT = 8
# factor by which rounding makes a quotient too small
_ROUNDING = 1 + 1e-9
_SHORTEST, _LONGEST = 1e-12, 1e3  # s
# number of values that are checked as the cause if no step is short enough, and factors for values without a reference
_SUSPECTS = 6
_FACTORS = (1e-6, 1e6, 1e-12, 1e12)


def with_timestep(design: Design) -> Design:
    """Replace a timestep "auto" by an estimate: a quarter of the limit of its modes, rounded down to one digit.

    This is a limit of stability; only runs show whether it is accurate. It resolves the stops and the contacts.
    """
    if design.protocol.timestep != "auto":
        return design
    allowed = min(_SAFETY * stable_timestep(design), resolving_timestep(structure_of(design)))
    digit = 10.0 ** np.floor(np.log10(allowed))
    # the logarithm of a power of ten may be rounded up
    rounded = np.floor(allowed / digit * _ROUNDING) * digit
    try:
        return with_values(design, {"protocol.timestep": float(f"{rounded:.0e}")})
    except InputError as error:
        because = _short_edge(structure_of(design))
        raise InputError(f"{error}; {because}" if because else str(error)) from None


def timestep_warnings(design: AnyDesign) -> list[str]:
    """Return a warning if the design's timestep is longer than its stiffest mode allows."""
    design = as_design(design)
    chosen = design.protocol.timestep
    if chosen == "auto" or chosen <= (longest := stable_timestep(design)):
        return []
    built = structure_of(design)
    start = f"a timestep of {1e3 * chosen:.3g} ms is too long: the stiffest mode allows {1e3 * longest:.3g} ms"
    if because := _short_edge(built):
        return [f"{start}; {because}"]
    parts = "softer facets and creases" if built.facets or built.plates else "a softer or thinner membrane"
    if any(np.isfinite(motor.no_load_speed) for motor in built.motors):
        parts += ", or motors that are faster or weaker (no_load_speed)"
    return [f'{start}; use protocol.timestep = "auto", or {parts}']


def _short_edge(structure: Structure) -> str:
    """Return which short edge makes the timestep short, and the remedy; empty if no edge is short."""
    edge = short_edge(structure)
    if edge is None:
        return ""
    one, other, length = edge
    ends = " and ".join(name.replace("vertex", "vertex ") for name in (one, other))
    return (
        f"the cause is the edge between {ends}, which is only {show_value(length, 'm')} long: merge both vertices, or"
        " move them apart"
    )


def resolving_timestep(structure: Structure) -> float:
    """Return the longest timestep, s, that resolves the stops, guard tendons and contacts of a structure.

    With fewer than two steps per time constant the engine uses a longer time constant (its refsafe flag), and with two
    steps, bouncy stops supply energy. With `STEPS_TO_TIME_CONSTANT` the rebound of a drop deviates from the closed form
    by at most 0.04 of the impact's speed: measured. It is infinite for a structure without such parts.
    """
    stopped = any(np.isfinite([hinge.lower, hinge.upper]).any() for hinge in structure.hinges if not hinge.flaps)
    longest = [structure.stops.time_constant / STEPS_TO_TIME_CONSTANT] * bool(stopped or structure.limits)
    if structure.table is not None:
        longest.append(structure.table.stops.time_constant / STEPS_TO_CONTACT)
    return min([*longest, contact_timestep(structure)])


def contact_timestep(structure: Structure) -> float:
    """Return the longest timestep, s, that resolves the contacts of a structure; infinite without contact.

    The contacts of facets and plates are explicit: several pairs on a body with the angular frequency 1 / (T zeta) each
    would be unstable with a damping ratio zeta much below 1 (0.05: unstable with T / 25, stable with T / 50, measured).
    """
    if structure.contact is None:
        return np.inf
    stops = structure.contact.stops
    explicit = bool(structure.facets or structure.plates)
    return stops.time_constant * (min(1.0, 2 * stops.damping_ratio) if explicit else 1.0) / STEPS_TO_CONTACT


@lru_cache(maxsize=64)  # checks, warnings and pages of a run call this three times or more
def stable_timestep(design: Design) -> float:
    """Estimate the longest timestep, s, at which no mode diverges while the structure folds.

    The structure is linearised as built, at rest. One step of semi-implicit Euler with implicit joint damping is then a
    linear map of positions, velocities and forces of Maxwell branches. Above a limit, one of its eigenvalues passes -1:
    the mode changes its sign at every step and grows (for one undamped mode of angular frequency w this is the textbook
    limit h = 2 / w). Growth without a change of sign is the snap itself, not an error. Half of that limit is returned,
    because a structure stiffens as it folds; the share was measured on wings.

    Because tendons may have no lever as built, the limit with tendons at their largest lever and with the largest
    stiffness of their law is a second bound. A structure that is driven harder than necessary can need a shorter step:
    see `with_timestep`. For nodes, whose bars are equally stiff in any shape, most of the limit as built is returned:
    see `node_timestep`.
    """
    structure = structure_of(design)
    if any(body.slides for body in structure.bodies) or any(hinge.flaps for hinge in structure.hinges):
        return _KEPT * node_timestep(structure)
    try:
        return _jointed_timestep(design)
    except _NoTimestepError as error:
        raise InputError(f"{error}{_cause(design)}") from None


class _NoTimestepError(InputError):
    """No timestep is short enough for a structure."""


def _jointed_timestep(design: Design) -> float:
    """Return the longest timestep of bodies on joints, s."""
    # the linearisation does not depend on the timestep of the compiled model
    any_step = {"protocol": design.protocol.model_copy(update={"timestep": _LONGEST})}
    model = compile_model(design.model_copy(update=any_step))
    built = _as_built(model)
    try:
        return min(_FOLDING * _limit(model, built), _limit(model, _at_largest_lever(model, built)))
    except np.linalg.LinAlgError:
        raise InputError(f"{design.name}: a value is too large or too small to compute with") from None


def _cause(design: Design) -> str:
    """Return the key of a value that prevents any timestep, among those furthest from the reference of their kind."""
    name = design.reference
    usual = {} if name is None else _positive_numbers(load_design(name).si_tables())
    values = {key: value for key, value in _positive_numbers(design.si_tables()).items() if value != usual.get(key)}
    far = {key: abs(math.log10(value / usual[key])) if usual.get(key) else math.inf for key, value in values.items()}
    for key in sorted(far, key=lambda key: -far[key])[:_SUSPECTS]:
        # values without a reference are decreased and increased
        others = [usual[key]] if key in usual else [values[key] * factor for factor in _FACTORS]
        for other in others:
            try:
                _jointed_timestep(with_values(design, {key: other}))
            except InputError:
                continue
            quantity = key_quantity(key, type(design))
            shown = f"{values[key]:g}" if quantity is None else show_quantity(values[key], quantity.unit)
            return f", because of {key} = {shown}"
    return ""


def _positive_numbers(tables: Mapping[str, Any], within: str = "") -> dict[str, float]:
    """Return the numbers > 0 in nested tables, by dotted key, except those of patterns and lists, and the timestep."""
    numbers: dict[str, float] = {}
    for key, value in tables.items():
        if isinstance(value, Mapping) and not key.isdecimal():
            numbers |= _positive_numbers(value, f"{within}{key}.")
        elif isinstance(value, float) and value > 0 and not within.startswith("pattern."):
            numbers[f"{within}{key}"] = value
    numbers.pop("protocol.timestep", None)
    return numbers


@dataclass(frozen=True, kw_only=True)
class _Linear:
    """Linearisation about a state, in the model's units: inertia, stiffness, damping and its implicit part, (dof, dof).

    `stretch` is the derivative of each tendon's length, (tendon, dof).
    """

    inertia: Array
    stiffness: Array
    damping: Array
    implicit: Array
    stretch: Array


def _limit(model: Model, linear: _Linear) -> float:
    """Compute the longest timestep, s, without a mode that changes sign and grows."""
    shortest, longest = np.log10(_SHORTEST), np.log10(_LONGEST)
    branches = [(tendon, branch) for tendon, part in enumerate(model.in_units.tendons) for branch in part.law.branches]

    def sign(power: float) -> float:
        return -1.0 if _flips(linear, branches, timestep=10.0**power / model.units.time) else 1.0

    if model.explicit:
        return _explicit_limit(linear, branches) * model.units.time
    if sign(longest) > 0:
        return _LONGEST
    if sign(shortest) < 0:
        raise _NoTimestepError(f"{model.design.name}: no timestep is short enough: a part is too stiff or too light")
    return float(10.0 ** scipy.optimize.brentq(sign, shortest, longest, xtol=1e-4))


def _explicit_limit(linear: _Linear, branches: Sequence[tuple[int, MaxwellElement]]) -> float:
    """Compute the longest step of Runge and Kutta without a growing mode, in the model's units.

    An eigenvalue z of step times slope must satisfy |1 + z + z^2/2 + z^3/6 + z^4/24| <= 1: up to 2.8 i undamped, -2.8
    overdamped (Hairer and Wanner 1996). Closures are ignored, which overestimates frequencies.
    """
    dofs = len(linear.inertia)
    stiffness = linear.stiffness + sum(
        branch.stiffness * np.outer(linear.stretch[tendon], linear.stretch[tendon]) for tendon, branch in branches
    )
    inverse = np.linalg.inv(linear.inertia)
    slope = np.block([[np.zeros((dofs, dofs)), np.eye(dofs)], [-inverse @ stiffness, -inverse @ linear.damping]])
    modes = np.linalg.eigvals(slope)
    # modes that grow by themselves belong to a snap
    modes = modes[(modes.real <= 0) & (np.abs(modes) > 0)]
    steps = np.geomspace(1e-3, 3, 500)
    z = steps[:, None] * modes / np.abs(modes)
    grows = np.abs(1 + z + z**2 / 2 + z**3 / 6 + z**4 / 24) > 1 + 1e-9
    first = np.where(grows.any(axis=0), steps[grows.argmax(axis=0)], steps[-1])
    return float((first / np.abs(modes)).min(initial=_LONGEST))


def _as_built(model: Model) -> _Linear:
    engine = copy.copy(model.engine)
    # no term of the linearisation is a force of a constraint, and constraints take most of the engine's time
    engine.opt.disableflags |= mujoco.mjtDisableBit.mjDSBL_CONSTRAINT.value
    data = mujoco.MjData(engine)
    mujoco.mj_forward(engine, data)
    inertia = np.zeros((engine.nv, engine.nv))
    mujoco.mj_fullM(engine, data, inertia)
    stiffness = -_derivative(engine, data, data.qpos, "qfrc_passive")
    damping = -_derivative(engine, data, data.qvel, "qfrc_passive")
    stretch = _derivative(engine, data, data.qpos, "ten_length")[model.tendons]
    if model.lets_go.any():
        # springs and dampers that are actuators; at rest their forces contain nothing else, in motion also branches
        stiffness -= _derivative(engine, data, data.qpos, "qfrc_actuator")
        for tendon in np.flatnonzero(model.lets_go):
            viscous = (model.in_units.tendons[tendon].law.damping or (0.0,))[0]
            damping += viscous * stretch[tendon : tendon + 1].T @ stretch[tendon : tendon + 1]
    stiffness = stiffness + np.diag(_steepening(model))
    for control in np.flatnonzero(model.brakes >= 0):
        # reduction of motors' torques with speed, at the largest torques
        number, way = model.brakes[control], model.jacobian[control]
        largest = max((abs(drive.strengths[number]) for drive in model.in_units.drives), default=0.0)
        damping += largest / model.in_units.motors[number].no_load_speed * np.outer(way, way)
    if model.drag is not None:
        # drag that is constant over several steps acts like a drag that is stronger by this number
        damping += model.followed * _drag_damping(model, model.drag, data, inertia)
    return _Linear(
        inertia=inertia,
        stiffness=stiffness,
        damping=damping,
        implicit=np.diag(np.array(engine.dof_damping).reshape(engine.nv, -1)[:, 0]),
        stretch=stretch,
    )


def _steepening(model: Model) -> Array:
    """Return the largest slope that nonlinear terms of joints' springs add between their stops, (dof,)."""
    more, joints = np.zeros(model.engine.nv), np.flatnonzero(model.folds.speeds >= 0)
    law = crease_law(model.in_units, joints)
    if law.bends:
        built = np.array([model.in_units.hinges[number].built for number in joints])
        linear = replace(law, quadratic=np.zeros(len(joints)), cubic=np.zeros(len(joints)))
        more[model.folds.speeds[joints]] = law.largest_slope(built) - linear.largest_slope(built)
    return more


def _drag_damping(model: Model, drag: Drag, data: mujoco.MjData, inertia: Array) -> Array:
    """Return the largest damping of coordinates by drag, (dof, dof), at speeds that tendons and torques allow."""
    tendons = model.elastic.energy(model.engine.tendon_length0[model.tendons])
    torque = sum(abs(drive.strength) for drive in model.in_units.drives)
    energy = float(np.max(tendons, initial=0.0)) + torque * np.pi
    speeds = np.maximum(np.sqrt(2 * energy / np.diag(inertia)), _NUDGE)
    kinematics = {name: np.repeat(getattr(data, name)[None], len(speeds), axis=0) for name in KINEMATICS}
    forces = stacked_drag([drag]).forces(np.zeros(len(speeds), dtype=np.int64), kinematics, np.diag(speeds))
    # the derivative of a quadratic drag is twice its ratio to the speed
    return np.asarray(-2 * forces.T / speeds)


def _at_largest_lever(model: Model, built: _Linear) -> _Linear:
    """Return the linearisation with tendons at their largest levers and with the largest stiffness of their laws.

    The lever of a tendon about a hinge is at most the distance of its nearer end from the hinge.
    """
    structure = model.in_units
    stretch, stiffness, damping = np.zeros_like(built.stretch), built.stiffness, built.damping
    for number, tendon in enumerate(structure.tendons):
        for hinge, arm in tendon_arms(structure, tendon):
            stretch[number, hinge] = arm
        levers = stretch[number]
        if not levers.any():
            continue
        law, driven = tendon.law, np.flatnonzero(levers)
        longest = float(model.engine.tendon_length0[model.tendons[number]])
        if law.yield_extension is not None:
            longest = min(longest, law.rest_length + law.yield_extension)
        # the slope of a cubic law is largest at an end of its range
        ends = law.elastic.stiffness([min(law.rest_length, longest), longest])
        torque = sum(abs(drive.strength) for drive in structure.drives)
        linear, quadratic, cubic = law.damping or (0.0, 0.0, 0.0)
        # the speed of a hinge is limited by the energy of its tendon and the work of torques, and about limited by the
        # speed at which the tendon's damper balances their forces
        arm = float(levers.max())
        energy = law.elastic.energy(longest) + torque * np.pi
        fastest = arm * np.sqrt(2 * energy / np.diag(built.inertia)[driven].min())
        holding = float(law.elastic.force(longest)) + torque / arm
        held = np.roots(np.array([cubic, quadratic, linear, -holding]))
        fastest = min([fastest, *(root.real for root in held if root.real > 0 and abs(root.imag) < 1e-9 * root.real)])
        viscous = linear + 2 * quadratic * fastest + 3 * cubic * fastest**2
        square = np.outer(levers, levers)
        stiffness, damping = stiffness + ends.max() * square, damping + viscous * square
    return replace(built, stiffness=stiffness, damping=damping, stretch=stretch)


def _derivative(engine: mujoco.MjModel, data: mujoco.MjData, state: Array, name: str) -> Array:
    """Compute the derivative of one of MuJoCo's fields by the state, with central differences, (..., dof)."""
    columns = []
    for index in range(engine.nv):
        values = []
        for step in (_NUDGE, -_NUDGE):
            state[index] += step
            mujoco.mj_forward(engine, data)
            values.append(getattr(data, name).copy())
            state[index] -= step
        columns.append((values[0] - values[1]) / (2 * _NUDGE))
    return np.column_stack(columns)


def _flips(linear: _Linear, branches: Sequence[tuple[int, MaxwellElement]], timestep: float) -> bool:
    """Return whether a mode changes its sign and grows from step to step; branches come with their tendons' numbers."""
    dofs = len(linear.inertia)
    step = np.linalg.inv(linear.inertia + timestep * linear.implicit) * timestep
    # each branch's force after the step as a function of position, velocity and forces before it: the force depends on
    # the velocity before the step, and the velocity after the step depends on the force
    kept = [np.exp(-timestep / branch.time) for _, branch in branches]
    stretch = linear.stretch[[tendon for tendon, _ in branches]].reshape(-1, dofs)
    gained = [-branch.stiffness * branch.time * np.expm1(-timestep / branch.time) for _, branch in branches]
    to_force = np.hstack(
        [
            np.zeros((len(kept), dofs)),
            np.array(gained).reshape(-1, 1) * stretch,
            np.diag(kept) if kept else np.zeros((0, 0)),
        ]
    )
    to_velocity = np.hstack(
        [-step @ linear.stiffness, np.eye(dofs) - step @ linear.damping, np.zeros((dofs, len(kept)))]
    )
    to_velocity -= step @ stretch.T @ to_force
    to_position = np.hstack([np.eye(dofs), np.zeros((dofs, dofs + len(kept)))]) + timestep * to_velocity
    modes = np.linalg.eigvals(np.vstack([to_position, to_velocity, to_force]))
    return bool(np.any((np.abs(modes) > 1 + 1e-9) & (modes.real < 0)))
