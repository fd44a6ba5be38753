"""Wings that fold and open under slowly growing torques, and differences to a simulation."""

from __future__ import annotations

import numpy as np
import pytest
import xarray

from forficula.design import load_design, with_values
from forficula.errors import InputError
from forficula.statics import energy_landscape
from forficula.statics.tree.ensemble import ensemble_of
from forficula.statics.tree.quasi_static import slow_transition, start_state, state_beyond
from forficula.study import load_study
from forficula.study.tables.map_comparison import (
    BOTH,
    BOTH_LESS,
    BOTH_MORE,
    NEITHER,
    NOT_SIMULATED,
    ONLY_SIMULATED,
    ONLY_STATIC,
    compare_maps,
)
from forficula.study.tables.outcome_kinds import lost_text, table_transitions
from forficula.study.tables.static_map import map_study, static_map

OVER = {"tendon.stiffness": ["10 N/cm", "60 N/cm"], "tendon.rest_length": ["0 cm", "8 cm", "9 cm"]}


@pytest.fixture(scope="module")
def statics(reference):
    return static_map(map_study(reference, OVER))


def test_only_soft_and_long_tendons_fold_slowly(statics):
    folds = statics["least_fold_torque"]
    assert np.isnan(folds.sel(tendon_stiffness=6000)).all()
    assert np.isfinite(folds.sel(tendon_stiffness=1000)).values.tolist() == [False, True, True]


def test_longer_tendons_open_at_lower_torques(statics):
    opens = statics["least_unfold_torque"].sel(tendon_stiffness=1000)
    assert np.isnan(opens.values[0])
    assert opens.values[1] > opens.values[2] > 0


def test_a_point_of_a_map_equals_the_wing_alone(statics, reference):
    wings = ensemble_of([reference])
    fold, unfold = wings.structure.transitions
    flat, folded = start_state(wings).position, state_beyond(wings, fold).position
    alone = slow_transition(wings, flat, fold, np.arange(0.1, 0.51, 0.1)).torque[0]
    opened = slow_transition(wings, folded, unfold, np.arange(0.1, 1.01, 0.1)).torque[0]
    wing = statics.sel(tendon_stiffness=1000, tendon_rest_length=0.09)
    assert float(wing["least_fold_torque"]) == pytest.approx(alone)
    assert float(wing["least_unfold_torque"]) == pytest.approx(opened)


def test_energies_are_those_of_three_tendons(statics):
    wing = statics.sel(tendon_stiffness=1000, tendon_rest_length=0.09)
    assert float(wing["flat_energy"]) == pytest.approx(0.548035, rel=1e-5)
    assert float(wing["folded_energy"]) == pytest.approx(0, abs=1e-9)


def test_geometry_is_a_factor_and_invalid_points_have_rows(reference):
    table = static_map(map_study(reference, {"pattern.hub_radius": ["0.5 cm", "1.5 cm", "-1 cm"]}))
    assert table["status"].values[2].startswith("cannot be built")
    assert np.isnan(table["flat_energy"].values[2])
    assert table["flat_energy"].values[0] != table["flat_energy"].values[1]


def test_folded_angle_is_a_factor():
    """Veins that stop at 60 deg leave the last hinge at -70 deg: folded for one wing, not for the other."""
    design = load_design("binder2025", {"hinge.turn_limit": "60 deg"})
    table = static_map(map_study(design, {"protocol.folded_angle": ["150 deg", "60 deg"]}))
    assert np.isfinite(table["least_fold_torque"].values).tolist() == [False, True]


def test_a_letter_that_springs_open_does_not_stay_closed_in_the_map_as_in_its_landscape():
    """Creases of 0.12 N m/rad/m are stronger than the tendons."""
    letter = load_design("letter-fold")
    table = static_map(map_study(letter, {"crease.stiffness": ["0.02 N m/rad/m", "0.12 N m/rad/m"]}))
    assert table["outcome"].values.tolist() == ["closed and opened", "did not stay closed"]
    assert np.isfinite(table["least_close_value"].values).all()
    for name in ("least_open_value", "closed_energy"):
        assert np.isfinite(table[name].values).tolist() == [True, False]
    stiff = energy_landscape(with_values(letter, {"crease.stiffness": "0.12 N m/rad/m"}))
    assert not stiff.rests[1].within
    assert lost_text(table, table_transitions(table)[0]) == " (1 did not stay closed)"


def test_default_torques_of_a_map_agree_with_the_landscape_to_a_tenth_of_the_drive():
    letter = load_design("letter-fold")
    table = static_map(map_study(letter, {"crease.stiffness": ["0.02 N m/rad/m"]}))
    slow = energy_landscape(letter).least_torques
    for name in ("close", "open"):
        # 3 N cm, tried in tenths
        assert 0 <= float(table[f"least_{name}_value"][0]) - slow[name] < 0.003 + 0.01 * slow[name]


def test_a_key_without_effect_on_statics_is_rejected(reference):
    with pytest.raises(InputError, match=r"protocol\.fold_torque: has no effect under slowly growing torques"):
        map_study(reference, {"protocol.fold_torque": "10..20 N cm step 10"})


def test_a_distribution_is_no_grid(reference):
    with pytest.raises(InputError, match=r"tendon.stiffness: need a list or a range"):
        map_study(
            reference,
            {"tendon.stiffness": {"distribution": "uniform", "low": "1 N/cm", "high": "2 N/cm"}},
        )


def test_an_unknown_key_is_reported(reference):
    with pytest.raises(InputError, match=r"tendon.stifness"):
        map_study(reference, {"tendon.stifness": ["1 N/cm"]})


def test_a_study_without_torques_has_no_static_map(study_file):
    study = load_study(study_file('"tendon.stiffness" = ["10 N/cm"]'))
    with pytest.raises(InputError, match="least-torques"):
        static_map(study)


def simulated(statics, folds, opens):
    """A table as from a search for the least torques."""
    shape = statics["status"].shape
    return xarray.Dataset(
        {
            "least_fold_torque": (statics["status"].dims, np.reshape(folds, shape)),
            "least_unfold_torque": (statics["status"].dims, np.reshape(opens, shape)),
            "flat_energy": statics["flat_energy"],
            "status": statics["status"],
            "outcome": statics["outcome"],
            "fold_outcome": statics["outcome"],
        },
        statics.coords,
        {"transitions": statics.attrs["transitions"]},
    )


def test_cells_that_differ_are_named(statics):
    nan = np.nan
    result = simulated(statics, [0.1, 0.2, nan, nan, nan, nan], [0.5, nan, nan, nan, nan, nan])
    folds = compare_maps(statics, result, "least_fold_torque").values.ravel().tolist()
    assert folds == [ONLY_SIMULATED, BOTH_MORE, ONLY_STATIC, NEITHER, NEITHER, NEITHER]
    alike = simulated(statics, statics["least_fold_torque"].values, [nan] * 6)
    same = compare_maps(statics, alike, "least_fold_torque")
    assert same.values.ravel().tolist() == [NEITHER, BOTH, BOTH, NEITHER, NEITHER, NEITHER]
    less = compare_maps(statics, simulated(statics, [0.01] * 6, [nan] * 6), "least_fold_torque")
    assert less.values.ravel().tolist()[:3] == [ONLY_SIMULATED, BOTH_LESS, BOTH_LESS]
    opens = compare_maps(statics, result, "least_unfold_torque").values.ravel().tolist()
    assert opens[:2] == [ONLY_SIMULATED, ONLY_STATIC]
    # opening was not tried without folding
    assert opens[2:] == [NOT_SIMULATED] * 4


def test_wings_that_were_not_simulated_are_marked(statics):
    result = simulated(statics, [0.1] * 6, [0.5] * 6).isel(tendon_rest_length=[0, 1])
    words = compare_maps(statics, result, "least_fold_torque")
    assert (words.sel(tendon_rest_length=0.09) == NOT_SIMULATED).all()


def test_a_table_with_other_factors_is_refused(statics):
    result = simulated(statics, [0.1] * 6, [0.5] * 6).isel(tendon_stiffness=0)
    with pytest.raises(InputError, match="over tendon_stiffness, tendon_rest_length"):
        compare_maps(statics, result, "least_fold_torque")


def test_values_of_a_range_match_those_of_a_study():
    """Both read their factors in the same way, so every wing of the paper's search is found."""
    study = load_study("binder2025-search")
    over = {"tendon.stiffness": "10..60 N/cm step 10", "tendon.rest_length": "0..9 cm step 1"}
    assert map_study(load_design("binder2025"), over).points == study.points


def test_a_map_of_a_million_wings_is_refused_before_it_begins():
    over = {"tendon.rest_length": "0..9 cm step 0.01", "tendon.stiffness": "10..60 N/cm step 0.05"}
    with pytest.raises(InputError) as caught:
        map_study(load_design("binder2025"), over)
    message = "tendon.rest_length, tendon.stiffness: need at most 100000 points of a static map, got 901901"
    assert str(caught.value) == message


def test_a_map_reports_progress_and_does_not_depend_on_batches(reference, statics, monkeypatch):
    study, seen = map_study(reference, OVER | {"tendon.stiffness": ["10 N/cm"]}), []
    whole = statics.sel(tendon_stiffness=[1000])
    monkeypatch.setattr("forficula.study.tables.static_map._SIDE_BY_SIDE", 2)
    parts = static_map(study, lambda *report: seen.append(report))
    assert seen == [(2, 3), (3, 3)]
    xarray.testing.assert_allclose(parts.drop_vars("status"), whole.drop_vars("status"), rtol=1e-9)
    assert (parts["status"] == whole["status"]).all()


def test_sheets_that_bend_have_no_map_of_torques():
    with pytest.raises(
        InputError, match="kresling-cell: maps of slowly growing torques need bodies on joints in a tree"
    ):
        map_study(load_design("kresling-cell"), {"crease.stiffness": ["1e-4 N m/rad/m"]})
