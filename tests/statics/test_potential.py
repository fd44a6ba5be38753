"""The total potential: its derivatives, its parts, the work of torques, and states of rest."""

import math
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from forficula.design import load_design, with_values
from forficula.errors import InputError
from forficula.statics import tendon_hinges
from forficula.statics.tree.ensemble import ensemble, ensemble_of, start_angles, torque_scale
from forficula.statics.tree.pose import tree_of
from forficula.statics.tree.potential import potential, rest
from forficula.statics.tree.sheet import sheet_energy
from forficula.structure import GROUND, Bar, Body, Hinge, Motor, Structure, hinges_of, mass_of, structure_of
from tests.statics.test_pose import turned_one_by_one
from tests.statics.trees import tree

REFERENCE = load_design("binder2025")
TENDONS = [(1000.0, 0.09), (3000.0, 0.05), (6000.0, 0.0)]
DESIGNS = [with_values(REFERENCE, {"tendon.stiffness": k, "tendon.rest_length": rest}) for k, rest in TENDONS]
WINGS = ensemble_of(DESIGNS)
SWEEPS, TURNS, FOLDS = (list(hinges_of(WINGS.structure, role)) for role in ("sweep", "turn", "ring"))
# on proximal axes and on distal hinges, in their own senses
FOLDING = np.array([0.1, 0.0])


@settings(deadline=None, max_examples=20)
@given(st.integers(0, 1000))
def test_the_potential_is_the_energy_of_sheet_and_tendons_minus_the_work_of_torques(seed):
    angles = np.random.default_rng(seed).uniform(-0.5, 0.5, (3, 12))
    torques = np.array([[0.1, 0.0], [0.2, 0.1], [0.3, -0.4]])
    energy = potential(WINGS, angles, torques)[0]
    tendons = [
        sum(float(hinge.energy(angle)) for hinge, angle in zip(tendon_hinges(structure_of(design)), folds, strict=True))
        for design, folds in zip(DESIGNS, angles[:, FOLDS], strict=True)
    ]
    work = torques[:, 0] * angles[:, TURNS].sum(axis=1) + torques[:, 1] * angles[:, FOLDS].sum(axis=1)
    assert energy == pytest.approx(sheet_energy(WINGS.sheet, angles)[0] + tendons - work, rel=1e-12)


def check_derivatives(structures, angles, torques):
    """Compare slope and curvature of the first case with central differences."""
    small, count = 1e-5, angles.shape[1]
    _, slope, curvature = potential(structures, angles, torques)
    many, steps = structures.repeated(count), small * np.eye(count)
    ahead, behind = potential(many, angles + steps, torques), potential(many, angles - steps, torques)
    stiff = np.abs(curvature).max()
    # central differences
    assert slope[0] == pytest.approx((ahead[0] - behind[0]) / (2 * small), abs=1e-8 * stiff)
    assert curvature[0] == pytest.approx((ahead[1] - behind[1]) / (2 * small), abs=1e-7 * stiff)


@settings(deadline=None, max_examples=20)
@given(st.integers(0, 1000), st.floats(-0.5, 0.5), st.floats(-0.5, 0.5))
def test_slope_and_curvature_are_its_derivatives(seed, proximal, distal):
    # tips close enough for slack guards, and taut tendons
    angles = np.random.default_rng(seed).uniform(-0.05, 0.05, (1, 12))
    angles[:, TURNS] += 0.5
    check_derivatives(ensemble_of(DESIGNS[:1]), angles, np.array([proximal, distal]))


@settings(deadline=None, max_examples=40)
@given(st.integers(0, 10_000), st.booleans(), st.integers(2, 8))
def test_slope_and_curvature_of_any_tree_are_its_derivatives(seed, membranes, bodies):
    """Trees with tendons across one or several hinges, springs, weights, and a motor on some hinges."""
    built = tree(seed, bodies, gravity=9.81, membranes=membranes, limit=100.0)
    count = len(built.hinges)
    some = tuple(range(0, count, 2))
    structures = ensemble([replace(built, motors=(Motor(name="m", hinges=some), Motor(name="n", hinges=(0,))))])
    angles = np.random.default_rng(seed).uniform(-1, 1, (1, count))
    check_derivatives(structures, angles, np.array([0.3, -0.1]))


@given(st.integers(0, 10_000))
def test_the_energy_of_a_tree_is_that_of_its_tendons_springs_and_weights(seed):
    """Tendons by the distance of their ends, weights by the height of their centres, by successive rotations."""
    built = tree(seed, gravity=9.81, membranes=False, limit=100.0)
    angles = np.random.default_rng(seed).uniform(-2, 2, len(built.hinges))
    points = turned_one_by_one(built, angles)
    expected = 0.0
    for tendon in built.tendons:
        one, other = tendon.points
        expected += float(tendon.law.elastic.energy(np.linalg.norm(points[other] - points[one])))
    expected += sum(
        hinge.stiffness / 2 * (angle - hinge.rest_angle) ** 2 for hinge, angle in zip(built.hinges, angles, strict=True)
    )
    fixed = {number for number in range(len(built.bodies)) if not tree_of(built).chain(number)}
    for number in range(len(built.bodies)):
        mass, centre, _ = mass_of(built, number)
        if mass and number not in fixed:
            marked = replace(built.points[0], body=number, place=centre)
            at = turned_one_by_one(replace(built, points=(marked,)), angles)[0]
            expected += mass * 9.81 * at[2]
    # a tendon between two fixed points has constant energy and is omitted
    still = [
        float(tendon.law.elastic.energy(np.linalg.norm(points[tendon.points[1]] - points[tendon.points[0]])))
        for tendon in built.tendons
        if _chains(built, tendon.points[0]) == _chains(built, tendon.points[1])
    ]
    energy = potential(ensemble([built]), angles[None])[0][0]
    assert energy == pytest.approx(expected - sum(still), rel=1e-9, abs=1e-12)


def _chains(built, point):
    return tree_of(built).chain(built.points[point].body)


def test_a_pendulum_hangs_down_and_stands_up():
    """A bar of mass m and length l on a level hinge: energy m g l / 2 sin(angle), rest at -90 deg."""
    bar = Bar(body=0, end=np.array([0.2, 0.0, 0.0]), diameter=0.01, density=1000.0, points=(0, 0))
    built = Structure(
        name="pendulum",
        bodies=(Body(name="bar", role="bar", parent=GROUND, position=np.zeros(3), frame=np.eye(3)),),
        points=(),
        bars=(bar,),
        hinges=(Hinge(name="h", role="h", body=0, axis=np.array([0.0, -1.0, 0.0])),),
        span=0.2,
        mass=0.1,
        gravity=9.81,
    )
    structures = ensemble([built])
    mass = 1000 * math.pi * 0.005**2 * 0.2
    angles = np.linspace(-3, 3, 13)[:, None]
    energy, slope, curvature = potential(structures.repeated(13), angles)
    most = mass * 9.81 * 0.1
    assert energy == pytest.approx(most * np.sin(angles[:, 0]))
    assert slope == pytest.approx(most * np.cos(angles))
    assert curvature[:, 0] == pytest.approx(-most * np.sin(angles))
    result = rest(structures, np.array([[0.3]]))
    assert result.rests.all()
    assert result.position[0, 0] == pytest.approx(-math.pi / 2, abs=1e-5)


def test_gravity_bends_a_wing():
    flat = rest(WINGS, start_angles(WINGS))
    heavy = with_values(DESIGNS[0], {"protocol.gravity": 9.81})
    hanging = ensemble_of([heavy])
    bent = rest(hanging, start_angles(hanging))
    assert bent.rests.all()
    lifts = list(hinges_of(WINGS.structure, "lift"))
    assert np.abs(bent.position[0, lifts]).max() > np.abs(flat.position[0, lifts]).max()
    with pytest.raises(InputError, match=r"another protocol\.gravity"):
        ensemble_of([DESIGNS[0], heavy])


def test_structures_side_by_side_do_not_affect_each_other():
    together = rest(WINGS, start_angles(WINGS), FOLDING)
    for case in range(3):
        alone = rest(ensemble_of(DESIGNS[case : case + 1]), start_angles(WINGS)[case : case + 1], FOLDING)
        # the same steps except for the torque that counts as zero, which depends on the stiffest tendon
        assert alone.energy[0] == pytest.approx(together.energy[case], abs=1e-9)
        # a hinge with a slack tendon hardly resists
        assert alone.position[0] == pytest.approx(together.position[case], abs=0.01)


def test_copies_of_a_structure_have_its_energy():
    angles = np.random.default_rng(0).uniform(-0.5, 0.5, (2, 12))
    alone = [potential(WINGS.only(np.array([0])), shape[None], FOLDING) for shape in angles]
    for copied, *single in zip(potential(WINGS.repeated(2), angles, FOLDING), *alone, strict=True):
        assert copied == pytest.approx(np.concatenate(single), rel=1e-12, abs=1e-15)
    assert WINGS.repeated(2).only(np.array([1])).cases == 1


def test_tendons_across_several_hinges_are_those_of_each_case():
    springs = [tree(7, membranes=False, limit=100.0, law=law) for law in _laws()]
    assert any(tendon.crossing is None for tendon in springs[0].tendons)
    angles = np.random.default_rng(3).uniform(-1, 1, (2, len(springs[0].hinges)))
    energy = potential(ensemble(springs), angles)[0]
    alone = [potential(ensemble([spring]), angles[case : case + 1])[0][0] for case, spring in enumerate(springs)]
    assert energy == pytest.approx(alone)
    assert energy[0] != pytest.approx(energy[1])


def _laws():
    law = tree(7).tendons[0].law
    return law, replace(law, stiffness=(900.0, 0.0, 0.0))


def test_structures_that_rest_have_no_torque_left_but_on_their_stops():
    result = rest(WINGS, start_angles(WINGS), FOLDING)
    assert result.rests.all()
    free = (result.position > WINGS.lower) & (result.position < WINGS.upper)
    assert np.abs(result.slope[free]).max() < 1e-4
    on_upper = result.position == WINGS.upper
    assert (result.slope[on_upper] <= 1e-4).all()
    assert (result.slope[result.position == WINGS.lower] >= -1e-4).all()


def test_hinges_that_are_held_stay_and_none_turns_farther_than_it_may():
    start = start_angles(WINGS)
    start[:, TURNS] = 0.4
    held = rest(WINGS, start, fixed=[*TURNS, *FOLDS]).position
    assert (held[:, TURNS] == 0.4).all()
    assert (held[:, FOLDS] == start[:, FOLDS]).all()
    assert np.abs(held[:, SWEEPS]).max() > 0.01
    near = rest(WINGS, start, 3 * FOLDING, within=0.1).position
    assert np.abs(near - start).max() == pytest.approx(0.1)


def test_wings_of_another_pattern_are_refused():
    other = with_values(REFERENCE, {"name": "wide", "pattern.sector_angle": math.radians(25)})
    with pytest.raises(InputError, match="wide: need wings that differ in their tendons only, got another pattern"):
        ensemble_of([REFERENCE, other])


def test_a_hinge_comes_to_rest_where_its_tendon_is_slack_at_a_right_angle():
    """The torque that counts as zero is 0 here, so a slope of the size of rounding must be accepted."""
    joint = ensemble_of([load_design("binder2025-joint", {"tendon.rest_length": "8 cm"})])
    assert torque_scale(joint) == 0
    for torque in (0.001, 0.02):
        result = rest(joint, np.array([[-0.3]]), [torque])
        assert result.rests.all()
        # the tendon folds where its moment is positive, and balances the opening torque
        assert -joint.tendons.moment(result.position)[0, 0] == pytest.approx(torque, rel=1e-9)
