"""The timestep that the stiffest mode of a structure allows."""

from __future__ import annotations

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
from forficula.dynamics.stepping.node_modes import node_timestep
from forficula.errors import InputError
from forficula.material.law.tendon_law import TendonBranch
from forficula.quantities import show_quantity
from forficula.structure import Structure, structure_of, tendon_arms

# Folding stretches the membrane and pleats the veins together: along the fold the limit was measured to fall to about
# half of the flat wing's (reference design: 2.4 ms flat, 1.2 ms at the snap; seven veins, 5 MPa: 0.40 and 0.23 ms).
_FOLDING = 0.5
# A quarter of that: eleven veins driven by 100 N cm were measured to blow up from 0.4 of it on, the reference from 0.9.
_SAFETY = 0.25
# of nodes: neighbours that fold bring some creases closer
_KEPT = 0.8
_NUDGE = 1e-6
STEPS_TO_TIME_CONSTANT = 4
# of contacts: with four the folded stack of the reference depends on the timestep, with eight it does not
STEPS_TO_CONTACT = 8
_SHORTEST, _LONGEST = 1e-12, 1e3  # s
# values that are looked at as the cause where no step is short enough, and by how much those without a usual one differ
_SUSPECTS = 6
_FACTORS = (1e-6, 1e6, 1e-12, 1e12)


def with_timestep(design: Design) -> Design:
    """Give a design whose timestep is "auto" an estimate: a quarter of what its modes allow, rounded down to one digit.

    That is a limit of stability; whether it is accurate, only runs tell. It resolves the stops and the contacts.
    """
    if design.protocol.timestep != "auto":
        return design
    allowed = min(_SAFETY * stable_timestep(design), resolving_timestep(structure_of(design)))
    digit = 10.0 ** np.floor(np.log10(allowed))
    return with_values(design, {"protocol.timestep": float(f"{np.floor(allowed / digit) * digit:.0e}")})


def timestep_warnings(design: AnyDesign) -> list[str]:
    """A sentence where the design's timestep is longer than its stiffest mode allows."""
    design = as_design(design)
    chosen = design.protocol.timestep
    if chosen == "auto" or chosen <= (longest := stable_timestep(design)):
        return []
    built = structure_of(design)
    parts = "softer facets and creases" if built.facets or built.plates else "a softer or thinner membrane"
    if any(np.isfinite(motor.no_load_speed) for motor in built.motors):
        parts += ", or motors that are faster or weaker (no_load_speed)"
    return [
        f"a timestep of {1e3 * chosen:.3g} ms is too long: the stiffest mode allows"
        f' {1e3 * longest:.3g} ms; take protocol.timestep = "auto", or {parts}'
    ]


def resolving_timestep(structure: Structure) -> float:
    """Return the longest timestep, s, that resolves the stops, guard tendons and contacts of a structure.

    With fewer than two steps to a time constant the engine takes a longer one (its refsafe flag), and with two, bouncy
    stops give energy. With `STEPS_TO_TIME_CONSTANT` the rebound of a drop deviates from the closed form by 0.04 of the
    impact's speed at most: measured. Infinite of a structure without any.
    """
    stopped = any(np.isfinite([hinge.lower, hinge.upper]).any() for hinge in structure.hinges if not hinge.flaps)
    longest = [structure.stops.time_constant / STEPS_TO_TIME_CONSTANT] * bool(stopped or structure.limits)
    if structure.contact is not None:
        longest.append(structure.contact.stops.time_constant / STEPS_TO_CONTACT)
    return min(longest, default=np.inf)


@lru_cache(maxsize=64)  # a run that is checked, warned of and shown asks three times and more
def stable_timestep(design: Design) -> float:
    """Estimate the longest timestep, s, at which no mode blows up while the structure folds.

    As built, at rest, it is linearised, and one step of semi-implicit Euler with implicit joint damping is a linear map
    of positions, velocities and the forces of Maxwell branches. Above a limit an eigenvalue of it passes -1: the mode
    flips its sign at every step and grows (for one undamped mode of angular frequency w this is the textbook limit
    h = 2 / w). Growth without a flip is the snap itself, not an error. Half of that limit is taken, because a
    structure stiffens as it folds; the share was measured on wings. Tendons may have no lever as built, so the limit
    with tendons at their largest lever, where their law is stiffest, is another bound. What is driven
    harder than it needs to be can ask for less: see `with_timestep`. Of nodes, whose bars are as stiff whatever the
    shape, nearly all of the limit as built is taken: see `node_timestep`.
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
    """The longest timestep of bodies on joints, s."""
    # what is linearised does not depend on the step it is compiled with
    any_step = {"protocol": design.protocol.model_copy(update={"timestep": _LONGEST})}
    model = compile_model(design.model_copy(update=any_step))
    built = _as_built(model)
    try:
        return min(_FOLDING * _limit(model, built), _limit(model, _at_largest_lever(model, built)))
    except np.linalg.LinAlgError:
        raise InputError(f"{design.name}: a value is too large or too small to compute with") from None


def _cause(design: Design) -> str:
    """Name the value without which there is a timestep, of those furthest from the reference of their kind."""
    name = design.reference
    usual = {} if name is None else _numbers(load_design(name).si_tables())
    own = {key: value for key, value in _numbers(design.si_tables()).items() if value != usual.get(key)}
    far = {key: abs(math.log10(value / usual[key])) if usual.get(key) else math.inf for key, value in own.items()}
    for key in sorted(far, key=lambda key: -far[key])[:_SUSPECTS]:
        # of what the reference lacks, less and more of it
        others = [usual[key]] if key in usual else [own[key] * factor for factor in _FACTORS]
        for other in others:
            try:
                _jointed_timestep(with_values(design, {key: other}))
            except InputError:
                continue
            quantity = key_quantity(key, type(design))
            shown = f"{own[key]:g}" if quantity is None else show_quantity(own[key], quantity.unit)
            return f", by {key} of {shown}"
    return ""


def _numbers(tables: Mapping[str, Any], within: str = "") -> dict[str, float]:
    """The numbers > 0 in nested tables, by dotted key, but those of the pattern and of lists, and the timestep."""
    numbers: dict[str, float] = {}
    for key, value in tables.items():
        if isinstance(value, Mapping) and not key.isdecimal():
            numbers |= _numbers(value, f"{within}{key}.")
        elif isinstance(value, float) and value > 0 and not within.startswith("pattern."):
            numbers[f"{within}{key}"] = value
    numbers.pop("protocol.timestep", None)
    return numbers


@dataclass(frozen=True, kw_only=True)
class _Linear:
    """Near a state, in the model's units: inertia, stiffness, all damping and its implicit part, (dof, dof).

    `stretch` is by how much each tendon lengthens, (tendon, dof).
    """

    inertia: Array
    stiffness: Array
    damping: Array
    implicit: Array
    stretch: Array


def _limit(model: Model, linear: _Linear) -> float:
    """The longest timestep, s, without a mode that flips and grows."""
    shortest, longest = np.log10(_SHORTEST), np.log10(_LONGEST)
    branches = [(tendon, branch) for tendon, each in enumerate(model.in_units.tendons) for branch in each.law.branches]

    def sign(power: float) -> float:
        return -1.0 if _flips(linear, branches, timestep=10.0**power / model.units.time) else 1.0

    if model.explicit:
        return _explicit_limit(linear, branches) * model.units.time
    if sign(longest) > 0:
        return _LONGEST
    if sign(shortest) < 0:
        raise _NoTimestepError(f"{model.design.name}: no timestep is short enough: a part is too stiff or too light")
    return float(10.0 ** scipy.optimize.brentq(sign, shortest, longest, xtol=1e-4))


def _explicit_limit(linear: _Linear, branches: Sequence[tuple[int, TendonBranch]]) -> float:
    """The longest step of Runge and Kutta without a mode that grows, in the model's units.

    An eigenvalue z of step times slope is to keep |1 + z + z^2/2 + z^3/6 + z^4/24| <= 1: up to 2.8 i undamped, -2.8
    overdamped (Hairer and Wanner 1996). What the closures hold counts as free, which is faster than it is.
    """
    dofs = len(linear.inertia)
    stiffness = linear.stiffness + sum(
        branch.stiffness * np.outer(linear.stretch[tendon], linear.stretch[tendon]) for tendon, branch in branches
    )
    inverse = np.linalg.inv(linear.inertia)
    slope = np.block([[np.zeros((dofs, dofs)), np.eye(dofs)], [-inverse @ stiffness, -inverse @ linear.damping]])
    modes = np.linalg.eigvals(slope)
    # what grows of itself snaps
    modes = modes[(modes.real <= 0) & (np.abs(modes) > 0)]
    steps = np.geomspace(1e-3, 3, 500)
    z = steps[:, None] * modes / np.abs(modes)
    grows = np.abs(1 + z + z**2 / 2 + z**3 / 6 + z**4 / 24) > 1 + 1e-9
    first = np.where(grows.any(axis=0), steps[grows.argmax(axis=0)], steps[-1])
    return float((first / np.abs(modes)).min(initial=_LONGEST))


def _as_built(model: Model) -> _Linear:
    engine = model.engine
    data = mujoco.MjData(engine)
    mujoco.mj_forward(engine, data)
    inertia = np.zeros((engine.nv, engine.nv))
    mujoco.mj_fullM(engine, data, inertia)
    stiffness = -_slope(engine, data, data.qpos, "qfrc_passive")
    damping = -_slope(engine, data, data.qvel, "qfrc_passive")
    stretch = _slope(engine, data, data.qpos, "ten_length")[model.tendons]
    if model.lets_go.any():
        # springs and dampers that are actuators; at rest nothing else is in their forces, at speed branches are, too
        stiffness -= _slope(engine, data, data.qpos, "qfrc_actuator")
        for tendon in np.flatnonzero(model.lets_go):
            viscous = (model.in_units.tendons[tendon].law.damping or (0.0,))[0]
            damping += viscous * stretch[tendon : tendon + 1].T @ stretch[tendon : tendon + 1]
    for control in np.flatnonzero(model.brakes >= 0):
        # what speed takes of motors' torques, where these are largest
        number, way = model.brakes[control], model.ways[control]
        largest = max((abs(drive.strengths[number]) for drive in model.in_units.drives), default=0.0)
        damping += largest / model.in_units.motors[number].no_load_speed * np.outer(way, way)
    if model.drag is not None:
        # what is set anew after so many steps is as if it were so much stronger
        damping += model.followed * _drag_damping(model, model.drag, data, inertia)
    return _Linear(
        inertia=inertia,
        stiffness=stiffness,
        damping=damping,
        implicit=np.diag(np.array(engine.dof_damping).reshape(engine.nv, -1)[:, 0]),
        stretch=stretch,
    )


def _drag_damping(model: Model, drag: Drag, data: mujoco.MjData, inertia: Array) -> Array:
    """By how much drag damps coordinates at most, (dof, dof), each as fast as tendons and torques can make it alone."""
    tendons = model.elastic.energy(model.engine.tendon_length0[model.tendons])
    torque = sum(abs(drive.strength) for drive in model.in_units.drives)
    energy = float(np.max(tendons, initial=0.0)) + torque * np.pi
    speeds = np.maximum(np.sqrt(2 * energy / np.diag(inertia)), _NUDGE)
    kinematics = {name: np.repeat(getattr(data, name)[None], len(speeds), axis=0) for name in KINEMATICS}
    forces = stacked_drag([drag]).forces(np.zeros(len(speeds), dtype=np.int64), kinematics, np.diag(speeds))
    # what goes with the square of a speed has twice that slope
    return np.asarray(-2 * forces.T / speeds)


def _at_largest_lever(model: Model, built: _Linear) -> _Linear:
    """A structure with tendons that pull at the largest levers that they can have, as stiff as their law is anywhere.

    The lever of a tendon about a hinge that it crosses is no longer than the nearer of its ends is away from it.
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
        # a cubic's slope is largest at an end of its range
        ends = law.elastic.stiffness([min(law.rest_length, longest), longest])
        torque = sum(abs(drive.strength) for drive in structure.drives)
        linear, quadratic, cubic = law.damping or (0.0, 0.0, 0.0)
        # a hinge is no faster than the energy of its tendon and the work of the torques on it allow, and about no
        # faster than where its tendon's damper holds their forces
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


def _slope(engine: mujoco.MjModel, data: mujoco.MjData, state: Array, name: str) -> Array:
    """One of MuJoCo's fields by state, central differences, (..., dof)."""
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


def _flips(linear: _Linear, branches: Sequence[tuple[int, TendonBranch]], timestep: float) -> bool:
    """Whether a mode flips its sign and grows from one step to the next; each branch comes with its tendon's number."""
    dofs = len(linear.inertia)
    step = np.linalg.inv(linear.inertia + timestep * linear.implicit) * timestep
    # each branch's force after the step, by position, velocity and the forces of all before it; it takes the velocity
    # from before, and the velocity after takes the force
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
