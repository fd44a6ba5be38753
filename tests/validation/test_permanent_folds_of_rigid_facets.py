"""Permanent folds of rigid facets in statics against closed forms, and against slow runs of the engine."""

import numpy as np
import pytest

import forficula as ff
from forficula.design import design_from_text
from forficula.statics import quasi_static_path
from tests.dynamics.test_yielding_creases import HARDENING, STIFFNESS, VERTEX, YIELD, strip


@pytest.fixture(scope="module")
def path():
    return quasi_static_path(strip("plates"))


def test_a_strip_of_rigid_facets_folds_along_two_slopes(path, agree):
    moment, beyond = path.strength, np.maximum(path.strength - YIELD, 0.0) / HARDENING
    closed = np.minimum(moment, YIELD) / STIFFNESS + beyond
    agree(
        "fold angle", path.angles[:, 0], closed, by="closed form", unit="rad", abs=1e-6, over=("moment (N m)", moment)
    )
    agree("permanent fold", path.sets[:, 0], beyond, by="closed form", unit="rad", abs=1e-6)


def test_creases_that_close_a_loop_fold_permanently_as_far_as_in_a_slow_run(agree):
    design = design_from_text(VERTEX)
    slow, run = quasi_static_path(design), ff.run(design).record
    for what, ours, name in (("fold angle", slow.angles, "hinge_angle"), ("permanent fold", slow.sets, "hinge_set")):
        agree(what, ours[-1], run.series[name][-1], by="slow run", unit="rad", rel=5e-3)
