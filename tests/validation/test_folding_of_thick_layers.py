"""Thick layers with contact fold flat about two ring folds, but not about one."""

import math

import numpy as np
import pytest

import forficula as ff
from forficula.analysis.crossing_panels import panel_crossing
from forficula.dynamics import energy_balance

STAGES = [
    {"name": "settle", "drive": "none", "until": "time", "hold": 0.0, "time_limit": 0.05},
    {"name": "fold", "drive": "fold", "until": "time", "hold": 0.0, "time_limit": 1.2},
]


def folded(**values):
    """Run of 1.2 s under the fold torque."""
    provided = {key.replace("__", "."): value for key, value in values.items()}
    return ff.run(
        ff.load_design("binder2025-thick").with_values({"protocol.stages": STAGES, **provided}), confirm=False
    )


def angles(record):
    """Final angles of the veins, rad, (vein,)."""
    return record.measured("distal_angle")[-1]


# with the 0.4 ms of the design, a pair of panels passes through each other for a moment, by 7 mm
STIFF = {"contact__time_constant": "0.2 ms", "protocol__timestep": "0.025 ms"}


@pytest.fixture(scope="module")
def two_folds():
    return folded(**STIFF)


def test_thick_layers_with_two_ring_folds_close_without_crossing(holds, two_folds):
    folded_to = math.degrees(angles(two_folds).max())
    holds("angle of the least folded vein, two ring folds", folded_to, below=-165, unit="deg")
    holds("depth of crossing panels", 1e3 * panel_crossing(two_folds).depth, below=0.5, unit="mm")
    assert energy_balance(two_folds).residual < two_folds.design.protocol.residual_limit


def test_with_one_ring_fold_folding_stops_when_bars_touch(holds, two_folds):
    one = folded(pattern__ring_folds=1)
    holds("angle of the least folded vein, one ring fold", math.degrees(angles(one).max()), above=-160, unit="deg")
    assert angles(one).max() - angles(two_folds).max() > math.radians(8)


def test_each_of_two_ring_folds_folds_about_half_of_the_angle(agree, two_folds):
    rings = np.degrees(two_folds.angles("ring")[-1]).reshape(-1, 2)
    agree("angles of the ring folds", rings, -90, unit="deg", by="half of the total angle", abs=12)
