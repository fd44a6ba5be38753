"""Tendons across the distal hinges, and guard tendons between neighbouring tips."""

from __future__ import annotations

import mujoco
import numpy as np

from forficula.design import Design, tendon_law
from forficula.dynamics.veins import Vein, stop_reference

# MuJoCo lets a limit harden over 0.001 of its length unit, which would be another share of every wing; the other
# numbers are its defaults.
_SOFT_SHARE = 0.001


def add_tendon(spec: mujoco.MjSpec, index: int, design: Design) -> None:
    """Add the tendon of a vein: its spring pulls beyond its resting length and never pushes.

    Its damper, like every tendon damper of MuJoCo, works at any length, slack or taut. Where it would stretch further
    than it yields, its resting length grows at the end of the step.
    """
    law = tendon_law(design)
    tendon = spec.add_tendon(
        name=f"tendon{index}",
        stiffness=law.stiffness,
        damping=law.damping or (0.0, 0.0, 0.0),
        springlength=[0, law.rest_length],
        springyield=law.yield_extension or 0.0,
    )
    tendon.wrap_site(f"proximal_attachment{index}")
    tendon.wrap_site(f"distal_attachment{index}")


def add_branches(spec: mujoco.MjSpec, index: int, design: Design) -> None:
    """Add the Maxwell branches of a vein's tendon, which act at any length, slack or taut, and start relaxed.

    Each is a DC motor without input (MuJoCo manual, actuator/dcmotor): its current, the branch's force where it pushes,
    obeys L di/dt = -R i - K dl/dt. With K = 1, R = 1 / (stiffness time) and L / R = time that is Maxwell's branch; the
    engine steps it exactly at the velocity before the step, and takes the force after it.
    """
    for number, branch in enumerate(tendon_law(design).branches):
        motor = spec.add_actuator(
            name=f"branch{index}_{number}", target=f"tendon{index}", trntype=mujoco.mjtTrn.mjTRN_TENDON
        )
        motor.set_to_dcmotor(
            motorconst=[1, 0],
            resistance=1 / (branch.stiffness * branch.time),
            inductance=[0, branch.time],
            ctrlspec=mujoco.mjtCtrlInput.mjINPUT_NONE.value,
        )


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
