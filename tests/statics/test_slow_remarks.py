"""Remarks of a landscape on the least slow torques."""

import numpy as np
import pytest

from forficula.design import load_design
from forficula.statics.tree.inertial_help import InertialHelp
from forficula.statics.tree.quasi_static import SlowTransition
from forficula.statics.tree_remarks import slow_remarks
from forficula.structure import structure_of

WING = structure_of(load_design("binder2025"))
FOLD, UNFOLD = WING.transitions


def said(torque, span, helped=None, transition=UNFOLD):
    position = np.zeros((1, len(WING.hinges)))
    result = SlowTransition(torque=np.array([torque]), position=position)
    return slow_remarks(WING, transition, 1.0, result, span, helped)


def test_a_torque_that_neither_inertia_nor_small_differences_change_needs_no_remark():
    assert said(0.2, (0.199, 0.201)) == ()


@pytest.mark.parametrize(("high", "words"), [(0.2037, "17.66 N cm to 20.37 N cm"), (np.inf, "17.66 N cm to more than")])
def test_a_torque_that_depends_on_small_differences_says_its_range(high, words):
    (remark,) = said(0.1766, (0.1766, high))
    assert "the least slow torque to open, 17.66 N cm, depends on small differences" in remark
    assert words in remark


def test_a_torque_that_inertia_may_lower_is_called_an_upper_bound():
    helped = InertialHelp(torque=0.018, released=8e-3, barrier=2.1e-4)
    (remark,) = said(0.038, (0.038, 0.038), helped, FOLD)
    assert "the least slow torque to fold, 3.8 N cm, is an upper bound" in remark
    assert "at 1.8 N cm the wing snaps and releases 8 mJ" in remark
    assert "climbs 0.21 mJ" in remark
