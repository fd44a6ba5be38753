"""Target angles of creases, and whether a run reaches them."""

import math

import pytest

import forficula as ff
from forficula.analysis import run_warnings
from forficula.analysis.run_warnings import missed_targets
from forficula.pattern import vertex_pattern
from tests.sheets import sheet_design


def folded(sectors):
    """Return the run of a vertex of four creases whose rest angles grow until it is folded flat."""
    pattern = vertex_pattern([math.radians(sector) for sector in sectors], 0.02, "MVMM")
    values = {
        "facet.youngs_modulus": 2e7,
        "facet.bend_stiffness": 0.05,
        "crease.stiffness": 0.01,
        "crease.damping": 1e-4,
        "drive": [{"name": "fold", "kind": "rest-angle", "of": "creases", "to": "target", "rise": 0.05}],
        "protocol.timestep": 5e-5,
        "protocol.stages": [{"name": "fold", "drive": "fold", "until": "target", "hold": 0.0, "time_limit": 0.3}],
    }
    return ff.run(sheet_design(pattern, values), confirm=False)


def test_every_crease_of_a_vertex_that_folds_flat_arrives():
    assert missed_targets(folded((70, 80, 110, 100))) == []


def test_a_vertex_with_a_missing_angle_names_the_creases_that_missed_their_targets():
    record = folded((60, 120, 90, 90))
    missed = missed_targets(record)
    assert missed
    assert abs(missed[0].angle - missed[0].target) == max(abs(item.angle - item.target) for item in missed)
    (output,) = [text for text in run_warnings(record) if "did not reach their targets within" in text]
    assert output.startswith(
        f"{len(missed)} of 4 creases did not reach their targets within 5 deg: {missed[0].label} at "
    )
    assert missed[0].target == pytest.approx(math.pi)
