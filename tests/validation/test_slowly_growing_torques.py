"""Slowly growing torques fold and open a simulated fan at the torques of statics.

The simulation keeps the masses and dampers of the design, and its torque grows within 20 s. Folding is compared at the
torque at which the last distal hinge snaps, because a slack wing then creeps to its goal against the dampers. If
inertia or small differences decide the path, statics give a range. `benchmarks/slow_ramps.py` compares 30 fans.
"""

import math

import numpy as np

import forficula as ff
from forficula.design import load_design, with_values
from forficula.statics.tree.ensemble import ensemble_of
from forficula.statics.tree.inertial_help import inertial_help
from forficula.statics.tree.quasi_static import least_slow_torque, start_state, state_after
from forficula.structure import drive_of, hinges_of

RISE = 20.0  # s
KEYS = (
    "pattern.proximal_length",
    "pattern.distal_length",
    "pattern.hub_radius",
    "pattern.sector_angle",
    "membrane.youngs_modulus",
    "membrane.thickness",
    "membrane.margin",
    "membrane.margin_limit",
    "tendon.stiffness",
    "tendon.rest_length",
    "tendon.proximal_attachment",
    "tendon.distal_attachment",
    "hinge.overbend",
)
# values of these keys, SI: two random fans within 20 % of the reference, and one with two opening paths
SHORT_DISTAL = (
    *(0.1399, 0.08441, 0.01748, 0.3383, 913700.0, 9.624e-05),
    *(0.02277, 0.6996, 925.2, 0.08645, 0.05131, 0.04991, 0.04073),
)
NARROW_MARGIN = (
    *(0.1102, 0.1128, 0.01782, 0.306, 1086000.0, 9.535e-05),
    *(0.01669, 0.7508, 922.5, 0.08067, 0.05382, 0.06512, 0.03937),
)
TWO_PATHS = (
    *(0.1308696643315721, 0.1118341624271629, 0.01757979703119263, math.radians(22.538249359107212)),
    *(931168.6097797311, 1e-4, 0.02136792223553031, 0.6055798431000319, 918.1389709589612),
    *(0.07945380186090814, 0.04876639563367370, 0.04876639563367370, math.radians(2.0385214471004196)),
)


def fan(values):
    settings = dict(zip(KEYS, values, strict=True))
    return with_values(load_design("binder2025"), {**settings, "protocol.initial_overbend": math.radians(1.4)})


def stage(name, drive, until, time_limit):
    return {"name": name, "drive": drive, "until": until, "time_limit": time_limit}


def ramp(design, stages, **torques):
    """Run with torques that grow within 20 s."""
    return ff.run(
        with_values(
            design,
            {
                # with its own damping only, a fan uses steps of 0.4 ms, which these stops allow
                "protocol.timestep": 4e-4,
                "stops.time_constant": 2e-3,
                "protocol.rise": RISE,
                "protocol.least_hold": 0.0,
                "protocol.sample_interval": 0.02,
                "protocol.stages": [stage("settle", "none", "time", 0.5), *stages],
                **{f"protocol.{name}": torque for name, torque in torques.items()},
            },
        ),
        confirm=False,
    )


def snap_torque(design, largest):
    """Torque at which the last distal hinge folds while the torque grows to a largest value, N m."""
    run = ramp(design, [stage("fold", "fold", "time", RISE)], fold_torque=largest)
    angles = run.series["hinge_angle"][:, list(hinges_of(run.structure, "ring"))]
    unsnapped = np.flatnonzero((angles > -math.radians(30)).any(axis=1))
    assert unsnapped[-1] < len(angles) - 1
    return largest * (run.time[unsnapped[-1]] - run.stages[1].start) / RISE


def slow_fold(design):
    """Least slow torque, N m, and the snap after which inertia may fold the fan with less."""
    wings = ensemble_of([design])
    fold = wings.structure.transitions[0]
    slow = least_slow_torque(wings, start_state(wings).position, fold, 0.5, recorded=True)
    return float(slow.torque[0]), inertial_help(wings, slow.paths[0], drive_of(wings.structure, fold.drive))


def test_a_slowly_growing_torque_folds_a_fan_at_its_least_slow_torque(agree):
    """Snaps computed in long steps had led to another state, and to a torque that was 26 % too large."""
    least, helped = slow_fold(fan(SHORT_DISTAL))
    assert helped is None
    result = snap_torque(fan(SHORT_DISTAL), 1.3 * least)
    agree("torque at which the last hinge folds", 100 * result, 100 * least, unit="N cm", by="statics", rel=0.03)


def test_where_inertia_decides_a_fan_folds_at_the_snap_predicted_by_statics(agree):
    """The least slow torque is twice as large, and an upper bound."""
    least, helped = slow_fold(fan(NARROW_MARGIN))
    assert helped is not None
    assert least > 1.5 * helped.torque
    result = snap_torque(fan(NARROW_MARGIN), 1.3 * helped.torque)
    agree(
        "torque at which the fan folds by inertia",
        100 * result,
        100 * helped.torque,
        unit="N cm",
        by="statics",
        rel=0.03,
    )


def test_a_slowly_growing_torque_opens_a_fan_with_two_paths_within_the_range_of_statics(holds):
    """A torque of 16.9 N cm on the distal hinges alone would be enough, but no protocol drives them alone."""
    design = fan(TWO_PATHS)
    wings = ensemble_of([design])
    fold, unfold = wings.structure.transitions
    slow = least_slow_torque(wings, start_state(wings).position, fold, 0.5)
    folded = state_after(wings, fold, slow.torque, slow.position).position
    opening = least_slow_torque(wings, folded, unfold, 1.0, recorded=True)
    helped = inertial_help(wings, opening.paths[0], drive_of(wings.structure, "unfold"))
    assert helped is not None
    low, high = helped.torque, float(opening.torque[0])
    stages = [
        stage("fold", "fold", "folded", 1.5 * RISE),
        stage("release", "none", "rest", 3.0),
        stage("unfold", "unfold", "opened", RISE),
    ]
    largest = 1.2 * high
    run = ramp(design, stages, fold_torque=1.3 * slow.torque[0], unfold_torque=largest)
    end = run.stages[-1]
    assert end.goal_time is not None
    # below the range it stays folded
    holds(
        "torque at which the fan opens",
        100 * largest * (end.goal_time - end.start) / RISE,
        above=100 * 0.97 * low,
        below=100 * 1.03 * high,
        unit="N cm",
        by="range of the statics, 3 % wider",
    )
