"""Lower bounds of the energy of a structure: closed forms of one hinge, and states of a run of the engine."""

from dataclasses import replace

import numpy as np
import pytest

import forficula as ff
from forficula.design import stage_drives
from forficula.statics.tree.energy_bound import EnergyBound, bounds_hinges_only, has_bound, torques_of
from forficula.structure import drive_of, goal_of, structure_of

WING = ff.load_design("binder2025")
JOINT = structure_of(ff.load_design("binder2025-joint"))
(TENDON,) = JOINT.tendons
YIELDING = np.radians(10)  # of stops
ENERGIES = ("kinetic_energy", "tendon_energy", "membrane_energy")


def largest_energy(certain):
    """The energy up to which a statement is certain, J."""
    low, high = 0.0, 1e3
    for _ in range(60):
        low, high = ((low + high) / 2, high) if certain((low + high) / 2) else (low, (low + high) / 2)
    return low


def tendon_energy(tendon, angle):
    """The energy of a tendon across one hinge, by the law of cosines, J."""
    crossing = tendon.crossing
    arms = crossing.proximal_arm, crossing.distal_arm
    squares = sum(length**2 for length in (*arms, crossing.axial_offset))
    length = np.sqrt(squares + 2 * np.prod(arms) * np.cos(angle + crossing.offset_angle))
    longer = np.maximum(length - tendon.law.rest_length, 0.0)
    return sum(factor * longer**power / power for power, factor in enumerate(tendon.law.stiffness, start=2))


@pytest.mark.parametrize("torque", [0.0, -0.05])
def test_a_straight_joint_must_pass_the_angle_of_the_highest_potential(torque):
    hinge, goal = TENDON.crossing.hinge, goal_of(JOINT, "folded")
    torques, angles = np.zeros((2, len(JOINT.hinges)))
    torques[hinge], angles[hinge] = torque, JOINT.hinges[hinge].upper
    bound = EnergyBound(structure=JOINT, torques=torques)
    largest = largest_energy(lambda energy: bound.misses(goal, angles, energy))
    turns = np.linspace(goal.most[hinge], JOINT.hinges[hinge].upper + YIELDING, 100_001)
    potential = tendon_energy(TENDON, turns) - torque * turns
    ahead = turns <= angles[hinge]
    top, edge = potential[ahead].max(), turns[ahead][np.argmax(potential[ahead])]
    floor = potential[turns >= edge].min()
    # energies are bounded in intervals of 0.1 deg
    tolerance = 0.01 * (top - floor) + abs(torque) * np.radians(0.2)
    assert largest == pytest.approx(floor + 0.9 * (top - floor) + torque * angles[hinge], abs=tolerance)


@pytest.fixture(scope="module")
def record():
    return ff.run(WING, confirm=False).record


def test_energy_and_potential_of_the_torques_do_not_rise_after_a_moment_without_hinges_beyond_stops(record):
    series, structure = record.series, record.structure
    energy = sum(values.sum(axis=-1) if values.ndim > 1 else values for values in map(series.get, ENERGIES))
    low, high = np.array([(hinge.lower, hinge.upper) for hinge in structure.hinges]).T
    rises = {}
    for end in record.stages[1:]:
        during = (record.time >= end.start - 1e-9) & (record.time <= end.end + 1e-9)
        strengths = [drive_of(structure, name).strengths for name in stage_drives(end.stage)]
        torques = torques_of(structure, np.sum([np.zeros(len(structure.motors)), *strengths], axis=0))
        angles = series["hinge_angle"][during]
        left = energy[during] - angles @ torques
        rise = np.maximum.accumulate(left[::-1])[::-1] - left
        within = ((angles >= low - np.radians(0.1)) & (angles <= high + np.radians(0.1))).all(axis=1)
        assert rise[within].max() < 1e-6
        rises[end.stage.name] = rise.max()
    # stops give back energy
    assert rises["unfold"] > 0.01


def test_no_state_of_a_run_has_less_energy_than_the_bound(record):
    series = record.series
    energy = series["tendon_energy"].sum(axis=1) + series["membrane_energy"]
    structure = structure_of(WING)
    bound = EnergyBound(structure=structure, torques=np.zeros(len(structure.hinges)))
    for angles, stored in zip(series["hinge_angle"][::5], energy[::5], strict=True):
        assert sum(hinge.at(angles[number]) for number, hinge in bound._hinges.items()) <= stored + 1e-12


def test_a_folded_wing_with_little_energy_stays_folded():
    structure = structure_of(WING.with_values({"tendon.rest_length": "5 cm"}))
    goal, bound = (
        goal_of(structure, structure.transitions[0].released),
        EnergyBound(structure=structure, torques=np.zeros(12)),
    )
    angles = np.where(np.isfinite(goal.most[:12]), np.radians(-170.0), 0.0)
    # one tendon at -75 deg, the others slack
    barrier = tendon_energy(structure.tendons[0], np.radians(-75))
    assert largest_energy(lambda energy: bound.keeps(goal, angles, energy)) == pytest.approx(0.9 * barrier, rel=5e-3)
    # a flat wing is not in the region
    assert not bound.keeps(goal, 0 * angles, 0.0)


def test_loads_without_a_bound_are_refused():
    structure = structure_of(WING)
    nothing = np.zeros(len(structure.hinges))
    assert has_bound(structure, nothing)
    assert not has_bound(replace(structure, gravity=9.81), nothing)
    free = replace(structure, hinges=tuple(replace(hinge, lower=-np.inf) for hinge in structure.hinges))
    assert has_bound(free, nothing)
    assert not has_bound(free, nothing + 0.1)
    assert torques_of(structure, np.array(drive_of(structure, "fold").strengths)) is not None
    force = replace(structure, motors=(replace(structure.motors[0], kind="force"),))
    assert torques_of(force, np.ones(1)) is None
    assert bounds_hinges_only(goal_of(structure, "folded"), len(structure.hinges))
    assert not bounds_hinges_only(goal_of(structure, "rest"), len(structure.hinges))
