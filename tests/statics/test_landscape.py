"""Stable states, barriers, and the remarks of a landscape without them."""

from __future__ import annotations

import json
import math

import numpy as np
import pytest

import forficula as ff
from forficula.errors import InputError
from forficula.statics import landscape_summary
from forficula.statics.tree.partial_folds import fold_levels
from forficula.structure import structure_of

SLACK_WITHOUT_HUB = {"pattern.hub_radius": "0 cm", "tendon.rest_length": "12 cm"}


@pytest.fixture(scope="module")
def landscape(surveyed):
    return surveyed("reference")


@pytest.fixture(scope="module")
def landscape_with(landscape_of):
    """Return the landscape of the reference with some settings."""
    return lambda settings: landscape_of(ff.load_design("binder2025", settings))


def test_the_reference_is_bistable_pressed_flat_and_slack_when_folded(landscape):
    flat, folded = landscape.states
    assert (flat.name, flat.kind, folded.name, folded.kind) == ("flat", "stop", "folded", "neutral")
    assert flat.ring_angle == pytest.approx(-math.radians(3))
    assert flat.energy == pytest.approx(3 * float(landscape.tendons[0].hinge.energy(math.radians(3))), rel=1e-5)
    assert folded.energy < 1e-4 * flat.energy


def test_all_hinges_together_climb_three_times_what_one_climbs(landscape):
    """The membrane stores nothing when cambered or straight, so the wing's barrier is that of its tendons."""
    one = landscape.tendons[0].barrier
    assert landscape.barrier("flat", "folded") == pytest.approx(3 * one, rel=1e-3)
    assert landscape.hinge_barriers == pytest.approx(np.full(3, one), rel=5e-3)


def test_back_it_climbs_what_it_has_lost(landscape):
    flat, folded = landscape.states
    present, back = landscape.barrier("flat", "folded"), landscape.barrier("folded", "flat")
    assert back - present == pytest.approx(flat.energy - folded.energy)


def test_the_flat_state_presses_as_much_as_folding_takes(landscape):
    """The path is steepest at its start, so the holding torque of the flat state is the torque to overcome."""
    flat = landscape.states[0]
    assert landscape.fold_path.fold_torque == pytest.approx(flat.holding_torque)
    assert landscape.least_torques["fold"] == pytest.approx(flat.holding_torque, rel=0.02)


def test_rigid_panels_open_with_the_torque_whose_work_on_every_joint_is_that_of_the_tendons(landscape):
    """The protocol turns the proximal joints back and opens the distal ones, both with this torque."""
    path, roles = landscape.fold_path, [hinge.role for hinge in landscape.structure.hinges]
    turned = path.angles[:, [role == "turn" for role in roles]].sum(axis=1)
    opened = path.angles[:, [role == "ring" for role in roles]].sum(axis=1)
    rate = np.gradient(turned - opened, path.pleat_angle)
    assert path.unfold_rate[2:-2] == pytest.approx(rate[2:-2], rel=0.01)
    needed = np.max(path.moment[path.fold_slope > 0] / rate[path.fold_slope > 0])
    assert path.unfold_torque == pytest.approx(needed, rel=0.01)
    assert path.unfold_torque < landscape.tendons[0].peak_opening.torque


def test_levels_of_independent_tendons_are_those_of_the_paper():
    """About 18, 12, 6 and 0 J for 10 N/cm and no resting length (Binder et al. 2025, section 3.1)."""
    levels = fold_levels(structure_of(ff.load_design("binder2025", {"tendon.rest_length": "0 cm"})))
    at_stop = 0.5 * 1000 * (0.11 * math.cos(math.radians(1.5))) ** 2
    assert levels == pytest.approx([3 * at_stop, 2 * at_stop, at_stop, 0], abs=1e-12)


@pytest.mark.parametrize(
    ("settings", "sentences"),
    [
        (SLACK_WITHOUT_HUB, ["rigid panels never reach the overbend", "the tendon is slack at every angle"]),
        (
            {"tendon.rest_length": "10.95 cm", "hinge.overbend": "0 deg", "protocol.initial_overbend": "0 deg"},
            ["about the wing's own hinge axes the tendon is slack at every angle", "straight is no stable state"],
        ),
        ({"hinge.turn_limit": "60 deg"}, ["hinge.turn_limit stops the veins at 60 deg"]),
        ({"tendon.stiffness": "60 N/cm"}, ["no slowly growing torque up to 50 N cm folds it"]),
    ],
)
def test_missing_results_have_a_remark_and_no_nan(landscape_with, settings, sentences):
    result = landscape_with(settings)
    for sentence in sentences:
        assert any(sentence in remark for remark in result.remarks), sentence
    json.dumps(landscape_summary(result), allow_nan=False)


def test_a_wing_whose_veins_stop_early_is_never_called_folded(landscape_with):
    names = [state.name for state in landscape_with({"hinge.turn_limit": "60 deg"}).states]
    assert names == ["flat", "partly folded"]


def test_an_unknown_state_is_rejected_with_the_nearest_name(landscape):
    with pytest.raises(InputError, match=r'need a stable state of the wing \(flat, folded\), got "foldd".*"folded"'):
        landscape.barrier("flat", "foldd")


def test_a_path_without_a_barrier_says_why(landscape_with):
    landscape = landscape_with(SLACK_WITHOUT_HUB)
    with pytest.raises(InputError, match="hub_radius is 0"):
        landscape.barrier("flat", "folded")


def test_the_summary_has_units_in_its_keys(landscape):
    result = landscape_summary(landscape)
    assert result["hinge"]["angle_deg"][0] == pytest.approx(3)
    assert result["hinge"]["angle_deg"][-1] == pytest.approx(-180)
    assert result["hinge"]["slack_angle_deg"] == pytest.approx(-2 * math.degrees(math.acos(9 / 11)))
    assert result["wing"]["barrier_J"] == pytest.approx(landscape.barrier("flat", "folded"))
    assert len(result["tendons"]) == 3
    assert len(result["wing"]["pleat_angle_deg"]) == len(result["wing"]["energy_J"])


def test_a_hinge_without_a_fold_path_has_stable_states_and_the_closed_form_of_its_barrier(landscape_of):
    """The hinge is the only coordinate, so its top is the saddle between its two states."""
    landscape = landscape_of(ff.load_design("binder2025-joint"))
    flat, folded = landscape.states
    assert (flat.name, folded.name) == ("flat", "folded")
    assert landscape.to_dataframe()["energy_J"].tolist() == [flat.energy, folded.energy]
    hinge = landscape.tendons[0]
    assert landscape.barrier("flat", "folded") == pytest.approx(hinge.barrier, rel=1e-6)
    assert landscape.barrier("flat", "folded") == pytest.approx(landscape.easiest_barrier, rel=1e-6)
    top = float(hinge.hinge.energy(hinge.hinge.top))
    assert landscape.barrier("folded", "flat") == pytest.approx(top - folded.energy, rel=1e-9)
