"""Rows of runs by closed forms of one tendon across one hinge, for tests that need many of them."""

import math

from forficula.study.running.evaluate import row_key

# of the paper; and kg m^2, of the hinge
TENDONS = {"tendon.stiffness": "10..60 N/cm step 10", "tendon.rest_length": "0..9 cm step 1"}
INERTIA = 4e-4


def holding_torque(design):
    """Least torque that leaves the stop, N m: k (L - l0) a b sin(phi) / L at the overbend, by virtual work."""
    tendon = design.tendon
    a, b, angle = tendon.proximal_attachment, tendon.distal_attachment, design.hinge.overbend
    length = math.sqrt(a * a + b * b + 2 * a * b * math.cos(angle))
    return tendon.stiffness * max(length - tendon.rest_length, 0.0) * a * b * math.sin(angle) / length


def row_of(design):
    """What a run would say were the wing that hinge: it folds where the torque is enough, sooner where it is stiff."""
    tendon = design.tendon
    folds = design.protocol.fold_torque >= holding_torque(design)
    # time scale sqrt(I / (k a b)), and as much again for the damping
    scale = math.sqrt(INERTIA / (tendon.stiffness * tendon.proximal_attachment * tendon.distal_attachment))
    time = scale * (1 + design.hinge.damping / 1e-3)
    return {
        "key": row_key(design),
        "verdict": "reached" if folds else "stuck",
        "folded": folds,
        "fold_time_s": time if folds else None,
        "fold_work_J": design.protocol.fold_torque * math.radians(80) if folds else None,
    }


def assess(runs):
    """Rows of runs, in their order."""
    return [row_of(run.design) for run in runs]


def count_fact(name, **more):
    """A fact on how many of the paper's 60 tendons fold with 50 N cm."""
    return {
        "name": name,
        "quantity": "folded",
        "statistic": "count",
        "until": "fold",
        "settings": {"protocol.fold_torque": "50 N cm"},
        "over": TENDONS,
        "rising": ["tendon.rest_length"],
        "falling": ["tendon.stiffness"],
        **more,
    }


def time_fact(name, **more):
    """A fact on how long the reference takes to fold."""
    return {
        "name": name,
        "quantity": "fold_time",
        "until": "fold",
        "settings": {"protocol.fold_torque": "50 N cm"},
        "over": {"tendon.rest_length": "9 cm"},
        "absent": "1 s",
        **more,
    }
