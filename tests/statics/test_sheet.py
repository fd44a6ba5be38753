"""Energy of membrane and guards, compared with differences, with the simulator, and under rigid motions."""

import math
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from forficula.design import load_design, with_values
from forficula.statics.tree.pose import places_of, pose, tree_of
from forficula.statics.tree.sheet import sheet_energy
from forficula.statics.tree.sheet import sheet_of as laid_out
from forficula.structure import hinges_of, structure_of
from tests.statics.trees import tree

REFERENCE = load_design("binder2025")
DENSE = with_values(
    REFERENCE,
    {
        "pattern.units": 2,
        "pattern.sector_angle": math.radians(15),
        "membrane.proximal_rows": [0.3, 0.6],
        "membrane.distal_rows": [0.5],
    },
)
BUILT = structure_of(REFERENCE)
SWEEPS, TURNS, FOLDS = (list(hinges_of(BUILT, role)) for role in ("sweep", "turn", "ring"))


def sheet_of(structure):
    return laid_out(structure, tree_of(structure))


SHEETS = [sheet_of(structure_of(design)) for design in (REFERENCE, DENSE)]
TREES = [sheet_of(tree(seed, limit=limit)) for seed, limit in ((1, 10.0), (2, 10.0), (5, 1.0), (8, 1.0))]


def size_of(sheet):
    return sheet.laid.tree.size


@settings(deadline=None, max_examples=40)
@given(st.sampled_from([*SHEETS, *TREES]), st.integers(0, 1000), st.floats(0.01, 1))
def test_slope_and_curvature_are_derivatives_of_the_energy(sheet, seed, spread):
    small = 1e-4
    angles = np.random.default_rng(seed).uniform(-spread, spread, (1, size_of(sheet)))
    _, slope, curvature = sheet_energy(sheet, angles)
    slopes, curvatures, pulls = zip(*(differences(sheet, angles, step) for step in (small, small / 2)), strict=True)
    stiff = np.abs(curvature).max()
    # Richardson extrapolation: errors of 1e-16 of the stiffness, from fourth derivatives; rounding of the energy
    # divided by 1e-4; curvature jumps where a guard starts to pull, which no step may cross
    if not any(pulls):
        assert slope[0] == pytest.approx((4 * slopes[1] - slopes[0]) / 3, abs=1e-9 * stiff)
        assert curvature[0] == pytest.approx((4 * curvatures[1] - curvatures[0]) / 3, abs=1e-9 * stiff)
    assert curvature[0] == pytest.approx(curvature[0].T, abs=1e-14 * stiff)


def differences(sheet, angles, step):
    """Return central differences of energy and slope, and whether a guard starts to pull between them."""
    steps = step * np.eye(angles.size)
    ahead, behind = sheet_energy(sheet, angles + steps), sheet_energy(sheet, angles - steps)
    begins = guards_begin(sheet, np.concatenate([angles + steps, angles - steps]))
    return (ahead[0] - behind[0]) / (2 * step), (ahead[1] - behind[1]) / (2 * step), begins


def guards_begin(sheet, angles):
    pulls = [apart > lengths for apart, lengths in zip(apart_at(sheet, angles), sheet.lengths, strict=True)]
    return any((pull != pull[0]).any() for pull in pulls)


def apart_at(sheet, angles):
    """Return the distances of the ends of all limits, m, (case, limit), by group."""
    places = places_of(sheet.laid.carried, pose(sheet.laid.tree, angles))
    ends = [places[:, :, group.points] for group in sheet.laid.groups[len(sheet.patches) :]]
    return [np.linalg.norm(end[:, :, 1::2] - end[:, :, ::2], axis=0) for end in ends]


@pytest.mark.parametrize("sheet", SHEETS)
def test_the_flat_wing_stores_nothing_and_nothing_moves_it(sheet):
    energy, slope, curvature = sheet_energy(sheet, np.zeros((1, size_of(sheet))))
    # rounding of a strain of 1e-16
    assert energy[0] == pytest.approx(0, abs=1e-25)
    assert slope[0] == pytest.approx(0, abs=1e-12)
    assert np.linalg.eigvalsh(curvature[0]).min() > -1e-12 * curvature.max()


def test_all_along_the_reference_the_membrane_has_the_energy_of_the_record(reference_run):
    sheet = sheet_of(structure_of(with_values(reference_run.design, {"guard.stretch": 10.0})))
    energy = sheet_energy(sheet, reference_run.data["hinge_angle"].values)[0]
    record = reference_run.data["membrane_energy"].values
    assert record.max() > 1e-3
    # rounding
    assert energy == pytest.approx(record, rel=1e-9, abs=1e-12)


@given(st.floats(-math.pi, math.pi))
def test_rigid_rotation_does_not_change_the_energy(angle):
    """Without a hub all veins start at one point, so the same sweep of all is a rigid motion."""
    sheet = sheet_of(structure_of(with_values(REFERENCE, {"pattern.hub_radius": 0.0})))
    angles = np.random.default_rng(1).uniform(-0.3, 0.3, (1, 12))
    turned = angles.copy()
    turned[:, SWEEPS] += angle
    energy, slope, curvature = sheet_energy(sheet, angles)
    other = sheet_energy(sheet, turned)
    # rounding
    assert other[0] == pytest.approx(energy, rel=1e-11)
    assert other[1] == pytest.approx(slope, abs=1e-11 * np.abs(slope).max())
    assert other[2] == pytest.approx(curvature, abs=1e-11 * np.abs(curvature).max())
    assert slope[0, SWEEPS].sum() == pytest.approx(0, abs=1e-11 * np.abs(slope).max())


@given(st.integers(0, 1000), st.floats(-math.pi, math.pi))
def test_a_hinge_that_carries_all_nodes_moves_no_energy(seed, angle):
    """Sheets in any plane on a chain of bodies: a hinge below them all turns them rigidly."""
    built = tree(seed)
    root = next(number for number, hinge in enumerate(built.hinges) if hinge.body == 0)
    carried = [index for index in range(len(built.bodies)) if root in tree_of(built).chain(index)]
    random = np.random.default_rng(seed)
    membranes = tuple(
        replace(membrane, bodies=random.choice(carried, len(membrane.bodies))) for membrane in built.membranes
    )
    sheet = sheet_of(replace(built, membranes=membranes, limits=()))
    angles = random.uniform(-0.5, 0.5, (1, size_of(sheet)))
    turned = angles.copy()
    turned[0, root] += angle
    (energy, slope, _), other = sheet_energy(sheet, angles), sheet_energy(sheet, turned)
    # rounding
    assert other[0] == pytest.approx(energy, rel=1e-11)
    least = 1e-11 * (np.abs(slope).max() + energy[0])
    assert other[1] == pytest.approx(slope, abs=least)
    assert slope[0, root] == pytest.approx(0, abs=least)


def test_a_guard_pulls_beyond_its_length_only():
    """Sweeping an outer vein spreads two tips: a spring, stretched by their distance less the guard's length."""
    soft = with_values(REFERENCE, {"membrane.youngs_modulus": 1e6})
    slack, taut = (sheet_of(structure_of(with_values(soft, {"guard.stretch": stretch}))) for stretch in (10.0, 1.02))
    angles = np.zeros((2, 12))
    angles[:, SWEEPS[2]] = [0.001, 0.1]
    beyond = (apart_at(taut, angles)[0] - taut.lengths[0])[:, 1]
    assert beyond[0] < 0 < beyond[1]
    more = sheet_energy(taut, angles)[0] - sheet_energy(slack, angles)[0]
    spring = 100 * 1e6 * REFERENCE.membrane.thickness
    assert more == pytest.approx([0, spring / 2 * beyond[1] ** 2])


@settings(deadline=None)
@given(st.floats(0.3, 3))
def test_energy_is_proportional_to_the_modulus_and_the_thickness(factor):
    angles = np.zeros((1, 12))
    angles[:, TURNS], angles[:, FOLDS] = 0.7, -1.2
    energy = sheet_energy(SHEETS[0], angles)[0]
    for key in ("youngs_modulus", "thickness"):
        stiffer = {f"membrane.{key}": factor * getattr(REFERENCE.membrane, key)}
        result = sheet_energy(sheet_of(structure_of(with_values(REFERENCE, stiffer))), angles)[0]
        assert result == pytest.approx(factor * energy)
