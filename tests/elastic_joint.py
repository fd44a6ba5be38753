"""A joint whose tendon is a linear spring between two bars in line: its energy and moment in closed form."""

import numpy as np
from scipy.optimize import minimize_scalar

from forficula.design import load_design, with_values

ARMS, STIFFNESS, REST = (0.059, 0.051), 400.0, 0.005  # m, N/m, m
FOLDED, STRENGTH = np.radians(170), 2.0  # stop, and torque of the drive that opens the joint, N m


def stage(name, drive="none", until="time", limit=2.0, **more):
    return {"name": name, "drive": drive, "until": until, "hold": 0.0, "time_limit": limit, **more}


def slow(name, drive="none", until="time", limit=90.0):
    return stage(name, drive, until, limit, motion="quasi-static")


# the joint rests on its stop when folded
FOLDING = (
    stage("settle", limit=0.2),
    stage("push", "fold", "distal_angle < -20 deg"),
    stage("snap", "none", "rest", hold=0.02),
)


def joint(*stages, **values):
    """Return the design, which folds and then goes through the stages."""
    return with_values(
        load_design("binder2025-joint"),
        {
            "pattern.proximal_sector": np.pi / 2,
            "pattern.distal_sector": np.pi / 2,
            "tendon.law": None,
            "tendon.stiffness": STIFFNESS,
            "tendon.damping": 0.0,
            "tendon.rest_length": REST,
            "tendon.proximal_offset": 0.0,
            "tendon.distal_offset": 0.0,
            "hinge.fold_limit": FOLDED,
            "hinge.damping": 2e-2,
            "protocol.fold_torque": 5.0,
            "protocol.unfold_torque": STRENGTH,
            "protocol.window": 0.05,
            "protocol.sample_interval": 2e-3,
            "protocol.stages": [*FOLDING, *stages],
            **values,
        },
    )


def energy(angle):
    """Energy of the tendon at angles from the straight joint, J."""
    return STIFFNESS / 2 * (_length(angle) - REST) ** 2


def moment(angle):
    """Torque that holds the joint at angles from the straight one, N m."""
    return STIFFNESS * (1 - REST / _length(angle)) * ARMS[0] * ARMS[1] * np.sin(angle)


def peak():
    """Angle of the largest moment, rad."""
    return float(
        minimize_scalar(lambda angle: -moment(angle), bounds=(0.1, 3), method="bounded", options={"xatol": 1e-10}).x
    )


def _length(angle):
    return np.sqrt(ARMS[0] ** 2 + ARMS[1] ** 2 + 2 * ARMS[0] * ARMS[1] * np.cos(angle))
