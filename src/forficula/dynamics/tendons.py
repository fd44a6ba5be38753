"""Tendons across the distal hinges, and guard tendons between neighbouring tips."""

from __future__ import annotations

import mujoco
import numpy as np

from forficula.design import Design, tendon_law
from forficula.dynamics.veins import Vein, stop_reference

# MuJoCo lets a limit harden over 0.001 of its length unit, which would be another share of every wing; the other
# numbers are its defaults.
_SOFT_SHARE = 0.001
_PARTS = 1e6  # of the resting length: over one of them a linear spring of a muscle sets in
_QUADRATIC = 1e3  # resting lengths up to which a quadratic spring is one


def add_tendon(spec: mujoco.MjSpec, index: int, design: Design) -> None:
    """Add the tendon of a vein: its spring pulls beyond its resting length and never pushes.

    Its damper, like every tendon damper of MuJoCo, works at any length, slack or taut. Where it would stretch further
    than it yields, its resting length grows at the end of the step. A tendon that lets go has neither spring nor damper
    here: they are actuators, see `add_branches`, since it is the sum of these that MuJoCo can clamp.
    """
    law = tendon_law(design)
    tendon = spec.add_tendon(name=f"tendon{index}")
    if law.lets_go:
        tendon.actfrclimited = mujoco.mjtLimited.mjLIMITED_TRUE
        tendon.actfrcrange = [-1e30, 0]
    else:
        tendon.stiffness = law.stiffness
        tendon.damping = law.damping or (0.0, 0.0, 0.0)
        tendon.springlength = [0, law.rest_length]
        tendon.springyield = law.yield_extension or 0.0
    tendon.wrap_site(f"proximal_attachment{index}")
    tendon.wrap_site(f"distal_attachment{index}")


def add_branches(spec: mujoco.MjSpec, index: int, design: Design) -> None:
    """Add the Maxwell branches of a vein's tendon, which start relaxed; of one that lets go its spring and damper, too.

    Each branch is a DC motor without input (MuJoCo manual, actuator/dcmotor): its current, the branch's force where it
    pushes, obeys L di/dt = -R i - K dl/dt. With K = 1, R = 1 / (stiffness time) and L / R = time that is Maxwell's
    branch; the engine steps it exactly at the velocity before the step, and takes the force after it. Without
    inductance the motor is a damper.
    """
    law = tendon_law(design)
    for number, branch in enumerate(law.branches):
        _add_motor(spec, f"branch{index}_{number}", index, 1 / (branch.stiffness * branch.time), branch.time)
    if not law.lets_go:
        return
    linear, quadratic, _ = law.stiffness
    if linear:
        # it sets in half a part early, so that half a part late it is the spring itself
        begins = law.rest_length / (1 + 0.5 / _PARTS)
        _add_muscle(spec, f"spring{index}", index, begins, _PARTS, 1.0, linear * begins / _PARTS)
    if quadratic:
        force = 2 * quadratic * (_QUADRATIC * law.rest_length) ** 2
        _add_muscle(spec, f"stiffening{index}", index, law.rest_length, 1.0, _QUADRATIC, force)
    if law.damping and law.damping[0]:
        _add_motor(spec, f"damper{index}", index, 1 / law.damping[0], 0.0)


def _add_motor(spec: mujoco.MjSpec, name: str, index: int, resistance: float, time: float) -> None:
    motor = spec.add_actuator(name=name, target=f"tendon{index}", trntype=mujoco.mjtTrn.mjTRN_TENDON)
    motor.set_to_dcmotor(
        motorconst=[1, 0],
        resistance=resistance,
        inductance=[0, time],
        ctrlspec=mujoco.mjtCtrlInput.mjINPUT_NONE.value,
    )


def _add_muscle(
    spec: mujoco.MjSpec, name: str, index: int, begins: float, parts: float, rounded: float, force: float
) -> None:
    """Add what a muscle does when it is passive and stretched, and nothing else of it.

    None up to a length, from there on force (x / rounded)^2 / 2 in units of that length by `parts`, and beyond
    `rounded` straight on with the slope of there (MuJoCo's mju_muscleBias).
    """
    muscle = spec.add_actuator(name=name, target=f"tendon{index}", trntype=mujoco.mjtTrn.mjTRN_TENDON)
    muscle.gaintype, muscle.biastype = mujoco.mjtGain.mjGAIN_FIXED, mujoco.mjtBias.mjBIAS_MUSCLE
    muscle.gainprm = np.zeros(10)
    # range, force, scale, lmin, lmax, vmax, fpmax, fvmax; the muscle's own length is 1 where it begins
    muscle.biasprm = [1 - parts, 1, force, 1, 0, 1 + 2 * rounded, 1, 1, 1, 0]
    muscle.lengthrange = [0, begins]


def add_guard(spec: mujoco.MjSpec, index: int, veins: tuple[Vein, ...], design: Design) -> None:
    """Add the guard tendon between tips `index` and `index` + 1: a limit on their distance, nothing else."""
    flat_distance = float(np.linalg.norm(veins[index + 1].tip - veins[index].tip))
    guard = spec.add_tendon(
        name=f"guard{index}",
        limited=True,
        range=[0, design.guard.stretch * flat_distance],
        solref_limit=stop_reference(design),
        solimp_limit=[0.9, 0.95, _SOFT_SHARE * flat_distance, 0.5, 2],
    )
    guard.wrap_site(f"tip{index}")
    guard.wrap_site(f"tip{index + 1}")
