"""The wing along its rigid fold: energies of its hinges, its moment, its states, and designs without such a fold."""

import math

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st
from scipy.integrate import cumulative_trapezoid

from forficula.design import load_design, with_values
from forficula.pattern import earwig_pattern, fan_fold_angles
from forficula.statics import tendon_hinges
from forficula.statics.tree import fold_path as module
from forficula.statics.tree.ensemble import ensemble_of
from forficula.structure import structure_of
from tests.statics.hinge_numbers import holding_torque

REFERENCE = load_design("binder2025")


def fold_path(design, points=181):
    return module.fold_path(ensemble_of([design]), points)


def design(hub=0.015, sector=20.0, rest=0.09, stiffness=1000.0):
    return with_values(
        REFERENCE,
        {
            "pattern.hub_radius": hub,
            "pattern.sector_angle": math.radians(sector),
            "tendon.rest_length": rest,
            "tendon.stiffness": stiffness,
        },
    )


designs = st.builds(design, st.floats(0.005, 0.03), st.floats(12, 30), st.floats(0, 0.1), st.floats(100, 6000))


@settings(deadline=None, max_examples=8)
@given(designs)
def test_the_energy_is_that_of_the_hinges_and_what_little_the_membrane_stretches(wing):
    path, hinges = fold_path(wing, 21), tendon_hinges(structure_of(wing))
    assert (path.pleat_angle[0], path.pleat_angle[-1]) == (structure_of(wing).rigid_fold.first, math.pi)
    by_hinge = sum(hinge.energy(-path.ring_angle) for hinge in hinges)
    assert path.tendon_energy == pytest.approx(by_hinge, rel=1e-9, abs=1e-12)
    assert (path.sheet_energy >= -1e-15).all()
    # cambered: every hinge at its overbend; then flat: straight; at the end: folded
    # (docs/model/theory.md, section Fan pattern)
    for place, angle in ((0, wing.hinge.overbend), (np.flatnonzero(path.pleat_angle == 0)[0], 0.0), (-1, -math.pi)):
        expected = sum(hinge.energy(angle) for hinge in hinges)
        assert path.energy[place] - path.sheet_energy[place] == pytest.approx(expected, rel=1e-9, abs=1e-12)
    assert path.sheet_energy[path.pleat_angle == 0] == pytest.approx(0, abs=1e-15)


@settings(deadline=None, max_examples=6)
@given(designs)
def test_the_ring_folds_as_the_pattern_does(wing):
    path = fold_path(wing, 21)
    ring = [role == "ring" for role in earwig_pattern(wing.fan).edges_role]
    for pleat, angle in zip(path.pleat_angle, path.ring_angle, strict=True):
        expected = math.copysign(abs(fan_fold_angles(wing.fan, min(abs(pleat), math.pi))[ring][0]), pleat)
        assert angle == pytest.approx(expected, abs=1e-12)


@pytest.mark.parametrize(
    "wing", [design(), design(hub=0.03, rest=0.03), design(sector=15.0, stiffness=6000.0, rest=0.0)]
)
def test_the_moment_is_what_the_energy_loses_by_the_pleat_angle(wing):
    path = fold_path(wing, 721)
    # trapezoidal rule with steps of 5e-3, in which the ring moves up to eight times as far
    lost = cumulative_trapezoid(path.moment, path.pleat_angle, initial=0)
    assert path.energy[0] - path.energy == pytest.approx(lost, abs=1e-3 * path.energy.max())
    moved = cumulative_trapezoid(path.fold_slope, path.pleat_angle, initial=0)
    assert path.ring_angle - path.ring_angle[0] == pytest.approx(moved, abs=1e-3)


@settings(deadline=None, max_examples=6)
@given(st.floats(0.012, 0.03), st.floats(12, 30), st.floats(0.05, 0.1), st.floats(1000, 6000))
@example(0.015, 20.0, 0.09, 1000.0)
def test_a_cambered_wing_is_pressed_on_its_overbend_and_climbs_to_flat(hub, sector, rest, stiffness):
    """Panels hardly stretch, so the torques are the tendons', by the kinematics of ring and pleats."""
    wing = design(hub, sector, rest, stiffness)
    path, hinge = fold_path(wing, 181), tendon_hinges(structure_of(wing))[0]
    first, second = path.states[:2]
    assert (first.kind, second.kind) == ("stop", "maximum")
    assert second.coordinate == pytest.approx(0, abs=1e-6)
    veins = wing.fan.vein_count
    expected = veins * holding_torque(hinge) * path.fold_slope[0]
    assert first.press == pytest.approx(expected, rel=0.01)
    assert path.fold_torque >= first.press * 2 / veins * (1 - 1e-9)
    # the torque opens the distal joints and turns the proximal ones back by half the pleat angle
    climbs = -hinge.moment(-path.ring_angle) * path.fold_slope / (path.fold_slope + 0.5)
    assert path.unfold_torque == pytest.approx(climbs[path.pleat_angle > 0].max(), rel=0.01)


@pytest.mark.parametrize(
    ("changes", "sentence"),
    [
        (
            {"pattern.hub_radius": 0.0},
            "pattern.hub_radius is 0, so the ring fold stays straight until the pleats are closed: rigid panels never"
            " reach the overbend, and their energy is constant; a hub radius > 0 couples ring fold and pleats",
        ),
        (
            {},
            "rigid panels reach the overbend of 3 deg only with veins turned back by 11.75 deg, and hinge.turn_back"
            " stops them at 5 deg: in the compliant wing the membrane stretches instead",
        ),
        ({"hinge.overbend": 0.0, "protocol.initial_overbend": 0.0}, None),
        ({"tendon.rest_length": 0.2}, None),
        ({"tendon.stiffness": 0.0}, None),
        ({"hinge.fold_limit": 2.0, "protocol.folded_angle": 1.5}, None),
    ],
)
def test_missing_values_of_a_path_have_a_remark_and_no_value_is_nan(changes, sentence):
    path = fold_path(with_values(REFERENCE, changes), 31)
    if sentence:
        assert path.remarks == (sentence,)
    for name in ("pleat_angle", "ring_angle", "tendon_energy", "sheet_energy", "moment", "fold_slope"):
        assert np.isfinite(getattr(path, name)).all()
    for state in path.states:
        assert all(map(math.isfinite, (state.coordinate, state.far_coordinate, state.energy, state.press)))
    assert math.isfinite(path.fold_torque)
    assert path.unfold_torque is None or math.isfinite(path.unfold_torque)


@pytest.mark.parametrize(
    "changes", [{"pattern.hub_radius": 0.0}, {"tendon.rest_length": 0.2}, {"tendon.stiffness": 0.0}]
)
def test_a_path_without_force_is_one_neutral_range(changes):
    path = fold_path(with_values(REFERENCE, changes), 31)
    (neutral,) = path.states
    assert neutral.kind == "neutral"
    assert (neutral.coordinate, neutral.far_coordinate) == (path.pleat_angle[0], path.pleat_angle[-1])
    assert path.fold_torque == pytest.approx(0, abs=1e-6)


def test_without_overbend_flat_is_no_stable_state():
    path = fold_path(with_values(REFERENCE, {"hinge.overbend": 0.0, "protocol.initial_overbend": 0.0}))
    assert path.pleat_angle[0] == 0
    assert [state.kind for state in path.states] == ["maximum", "neutral"]
