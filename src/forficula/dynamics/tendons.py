"""Tendons across the distal hinges, and guard tendons between neighbouring tips."""

from __future__ import annotations

import mujoco
import numpy as np
from numpy.typing import NDArray

from forficula.design import Design
from forficula.dynamics.veins import Vein, stop_reference

# MuJoCo lets a limit harden over 0.001 of its length unit, which would be another share of every wing; the other
# numbers are its defaults.
_SOFT_SHARE = 0.001


def add_tendon(spec: mujoco.MjSpec, index: int, design: Design) -> None:
    """Add the tendon of a vein: its spring pulls beyond its resting length and never pushes.

    Its damper, like every tendon damper of MuJoCo, works at any length, slack or taut.
    """
    law = design.tendon
    tendon = spec.add_tendon(
        name=f"tendon{index}",
        stiffness=[law.stiffness, 0, 0],
        damping=[law.damping, 0, 0],
        springlength=[0, law.rest_length],
    )
    tendon.wrap_site(f"proximal_attachment{index}")
    tendon.wrap_site(f"distal_attachment{index}")


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


def tendon_energy(length: NDArray[np.float64], stiffness: float, rest_length: float) -> NDArray[np.float64]:
    """Energy of a tendon, k / 2 max(length - rest_length, 0)^2 (Binder et al. 2025), in the shape of `length`."""
    return np.asarray(0.5 * stiffness * np.maximum(length - rest_length, 0.0) ** 2)
