"""Statements of the documentation on tendons above the hinge axis: few fold, and the sum of both heights counts.

To first order in height / arm, the energy maximum of a hinge is at -(h_p / a + h_d / b) from straight (law of cosines
for both anchors, turned by their angles above the bars).
"""

import math

import pytest

import forficula as ff
from forficula.design import with_values
from forficula.statics import hinge_landscape, ideal_hinges
from forficula.structure import structure_of
from forficula.study import load_study

ONE_END = {"tendon.proximal_offset": "6.2 mm", "tendon.distal_offset": "0 mm"}
BOTH_ENDS = {"tendon.proximal_offset": "3.1 mm", "tendon.distal_offset": "3.1 mm"}


def hinge(reference, offsets):
    return ideal_hinges(structure_of(with_values(reference, offsets)))[0]


def test_raising_one_end_by_twice_the_height_equals_raising_both_ends_to_first_order(agree, reference):
    one, both = hinge(reference, ONE_END), hinge(reference, BOTH_ENDS)
    # of second order: (6.2 mm / 55 mm)^2 = 0.013
    top, known = math.degrees(one.top), math.degrees(-2 * 3.1 / 55)
    agree("angle of the energy maximum, one end at 6.2 mm", top, known, unit="deg", by="-(h / a)", rel=0.013)
    ends = "both ends at 3.1 mm"
    agree("angle of the energy maximum, one end at 6.2 mm", top, math.degrees(both.top), unit="deg", by=ends, rel=0.013)
    first, second, flush = map(hinge_landscape, (one, both, hinge(reference, {})))
    agree("barrier, one end at 6.2 mm", 1e3 * first.barrier, 1e3 * second.barrier, unit="mJ", by=ends, rel=0.02)
    torques = (100 * item.holding_torque for item in (first, second))
    agree("holding torque, one end at 6.2 mm", *torques, unit="N cm", by=ends, rel=0.02)
    barriers = 1e3 * second.barrier, 1e4 * flush.barrier
    agree("barrier, both ends at 3.1 mm", *barriers, unit="mJ", by="ten times", rel=0.02)


@pytest.mark.parametrize("offsets", [ONE_END, BOTH_ENDS])
@pytest.mark.parametrize(("rest_length", "folds"), [("8 cm", True), ("7 cm", False)])
def test_with_tendons_on_bars_of_5_mm_folding_ends_between_7_and_8_cm(offsets, rest_length, folds):
    """For 10 N/cm and 50 N cm, with the settings of the study; at 0 mm all ten lengths fold."""
    study = load_study("binder2025-offsets")
    design = with_values(study.base, {**offsets, "tendon.rest_length": rest_length})
    protocol = design.protocol.model_copy(update={"stages": design.protocol.stages[:3]})
    outcome = ff.measure(ff.run(design.model_copy(update={"protocol": protocol}), confirm=False))
    assert outcome.holds["folded"] is folds
