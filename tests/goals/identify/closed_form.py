"""Rows of runs from closed forms of one tendon across one hinge, for tests that need many of them."""

import math

from forficula.study.running.evaluate import row_key

# values of the paper; and inertia of the hinge, kg m^2
TENDONS = {"tendon.stiffness": "10..60 N/cm step 10", "tendon.rest_length": "0..9 cm step 1"}
INERTIA = 4e-4


def holding_torque(design):
    """Least torque that leaves the stop, N m: k (L - l0) a b sin(phi) / L at the overbend, by virtual work."""
    tendon = design.tendon
    a, b, angle = tendon.proximal_attachment, tendon.distal_attachment, design.hinge.overbend
    length = math.sqrt(a * a + b * b + 2 * a * b * math.cos(angle))
    return tendon.stiffness * max(length - tendon.rest_length, 0.0) * a * b * math.sin(angle) / length


def row_of(design):
    """Row of a run if the wing were this hinge: it folds if the torque suffices, and sooner if it is stiff."""
    tendon = design.tendon
    folds = design.protocol.fold_torque >= holding_torque(design)
    # time scale sqrt(I / (k a b)), and an additional delay by the damping
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
    """A fact on the number of the paper's 60 tendons that fold with 50 N cm."""
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
    """A fact on the fold time of the reference."""
    return {
        "name": name,
        "quantity": "fold_time",
        "until": "fold",
        "settings": {"protocol.fold_torque": "50 N cm"},
        "over": {"tendon.rest_length": "9 cm"},
        "absent": "1 s",
        **more,
    }
