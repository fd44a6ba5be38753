"""The timestep that a wing's stiffest mode allows."""

from __future__ import annotations

import mujoco
import numpy as np
from numpy.typing import NDArray
from scipy.optimize import brentq

from forficula.design import Design, with_values
from forficula.dynamics.model import WingModel, compile_wing
from forficula.errors import InputError

Array = NDArray[np.float64]

# Folding stretches the membrane and pleats the veins together: along the fold the limit was measured to fall to about
# half of the flat wing's (reference design: 2.4 ms flat, 1.2 ms at the snap; seven veins, 5 MPa: 0.40 and 0.23 ms).
_FOLDING = 0.5
# A quarter of that: eleven veins driven by 100 N cm were measured to blow up from 0.4 of it on, the reference from 0.9.
_SAFETY = 0.25
_NUDGE = 1e-6
_SHORTEST, _LONGEST = 1e-12, 1e3  # s


def with_timestep(design: Design) -> Design:
    """Give a design whose timestep is "auto" a quarter of what its modes allow, rounded down to one digit."""
    if design.protocol.timestep != "auto":
        return design
    allowed = _SAFETY * stable_timestep(design)
    digit = 10.0 ** np.floor(np.log10(allowed))
    return with_values(design, {"protocol.timestep": float(f"{np.floor(allowed / digit) * digit:.0e}")})


def timestep_warnings(design: Design) -> list[str]:
    """A sentence where the design's timestep is longer than its stiffest mode allows."""
    chosen = design.protocol.timestep
    if chosen == "auto" or chosen <= (longest := stable_timestep(design)):
        return []
    return [
        f"a timestep of {1e3 * chosen:.3g} ms is too long: the wing's stiffest mode allows"
        f' {1e3 * longest:.3g} ms; take protocol.timestep = "auto", or a softer or thinner membrane'
    ]


def stable_timestep(design: Design) -> float:
    """Estimate the longest timestep, s, at which no mode of the wing blows up while it folds.

    The flat wing is linearised at rest, and one step of semi-implicit Euler with implicit joint damping is a linear map
    of positions and velocities. Above a limit an eigenvalue of it passes -1: the mode flips its sign at every step and
    grows (for one undamped mode of angular frequency w this is the textbook limit h = 2 / w). Growth without a flip is
    the snap itself, not an error. Half of that limit is taken, because the folding wing is stiffer than the flat one;
    the share was measured. A wing that is driven harder than it needs to be can ask for less: see `with_timestep`.
    """
    # the linearised wing does not depend on the step it is compiled with
    wing = compile_wing(with_values(design, {"protocol.timestep": _LONGEST}))
    wing_at_rest = _linearised(wing)
    shortest, longest = np.log10(_SHORTEST), np.log10(_LONGEST)

    def sign(power: float) -> float:
        return -1.0 if _flips(*wing_at_rest, timestep=10.0**power / wing.units.time) else 1.0

    try:
        if sign(longest) > 0:
            return _LONGEST
        if sign(shortest) < 0:
            raise InputError(f"{design.name}: no timestep is short enough: a part is too stiff or too light")
        exponent = brentq(sign, shortest, longest, xtol=1e-4)
    except np.linalg.LinAlgError:
        raise InputError(f"{design.name}: a value is too large or too small to compute with") from None
    return _FOLDING * float(10.0**exponent)


def _linearised(wing: WingModel) -> tuple[Array, Array, Array, Array]:
    """Inertia, stiffness, all damping and its implicit part, (dof, dof), of the flat wing in its units."""
    engine = wing.engine
    data = mujoco.MjData(engine)
    mujoco.mj_forward(engine, data)
    inertia = np.zeros((engine.nv, engine.nv))
    mujoco.mj_fullM(engine, data, inertia)
    return (
        inertia,
        -_slope(engine, data, data.qpos),
        -_slope(engine, data, data.qvel),
        np.diag(np.array(engine.dof_damping).reshape(engine.nv, -1)[:, 0]),
    )


def _slope(engine: mujoco.MjModel, data: mujoco.MjData, state: Array) -> Array:
    """Passive force by state, central differences, (dof, dof)."""
    columns = []
    for index in range(engine.nv):
        forces = []
        for step in (_NUDGE, -_NUDGE):
            state[index] += step
            mujoco.mj_forward(engine, data)
            forces.append(data.qfrc_passive.copy())
            state[index] -= step
        columns.append((forces[0] - forces[1]) / (2 * _NUDGE))
    return np.column_stack(columns)


def _flips(inertia: Array, stiffness: Array, damping: Array, implicit: Array, timestep: float) -> bool:
    """Whether a mode flips its sign and grows from one step to the next."""
    step = np.linalg.inv(inertia + timestep * implicit) * timestep
    to_velocity = np.hstack([-step @ stiffness, np.eye(len(inertia)) - step @ damping])
    to_position = np.hstack([np.eye(len(inertia)), np.zeros_like(inertia)]) + timestep * to_velocity
    modes = np.linalg.eigvals(np.vstack([to_position, to_velocity]))
    return bool(np.any((np.abs(modes) > 1 + 1e-9) & (modes.real < 0)))
