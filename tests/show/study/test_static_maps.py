"""Maps of least slow torques, alone and compared with a simulation."""

from __future__ import annotations

import numpy as np
import pytest

from forficula.design import load_design, with_values
from forficula.errors import InputError
from forficula.show.study.static_maps import draw_static_maps
from forficula.study.tables.static_map import map_study, static_map


@pytest.fixture(scope="module")
def statics(reference):
    over = {"tendon.stiffness": ["10 N/cm", "60 N/cm"], "tendon.rest_length": ["0 cm", "9 cm"]}
    return static_map(map_study(reference, over))


def titles(figure):
    return [axes.get_title() for axes in figure.axes if axes.get_title()]


def legend(figure):
    return {text.get_text() for item in figure.legends for text in item.get_texts()}


def test_a_map_alone_has_a_panel_for_folding_and_one_for_opening(statics):
    figure = draw_static_maps(statics)
    assert titles(figure) == ["folds under a slow torque", "opens under a slow torque"]
    assert legend(figure) == {"did not fold", "did not open"}


def test_cells_that_differ_from_the_simulation_are_drawn(statics):
    simulated = statics.copy(deep=True)
    simulated["least_fold_torque"].values[:] = [[0.3, 0.1], [np.nan, 0.3]]
    figure = draw_static_maps(statics, simulated)
    assert len(titles(figure)) == 6
    assert {"in both, at the same torque", "in the simulation only: inertia", "in neither"} <= legend(figure)


def test_over_one_factor_points_are_drawn(reference):
    table = static_map(map_study(reference, {"tendon.rest_length": ["8 cm", "9 cm"]}))
    assert len(titles(draw_static_maps(table, table))) == 6


def test_a_wing_that_springs_open_when_released_does_not_resist_opening():
    """Creases of 0.12 N m/rad/m do not keep the letter closed; softer ones do, and need more torque to open."""
    letter = load_design("letter-fold", {"drive.open.value": "-1 N cm"})
    table = static_map(map_study(letter, {"crease.stiffness": ["0.02 N m/rad/m", "0.12 N m/rad/m"]}))
    assert legend(draw_static_maps(table)) == {"did not get opened", "did not stay closed"}


def test_a_map_of_a_design_that_no_drive_takes_to_a_state_is_an_error_that_names_the_missing_stage():
    stage = {"name": "wait", "drive": "none", "until": "time", "time_limit": 1.0, "hold": 0.0, "state": "closed"}
    design = with_values(load_design("letter-fold"), {"protocol.stages": [stage]})
    with pytest.raises(InputError, match="maps of slowly growing torques need a stage of the protocol") as error:
        map_study(design, {"crease.rest_angle": ["0 deg", "1 deg"]})
    assert "ask" not in str(error.value)
