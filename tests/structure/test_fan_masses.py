"""Mass of membranes, tendons and hinges on the veins that carry them: plates by closed forms, momentum and energy."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from forficula import measure, run
from forficula.design import load_design, with_values
from forficula.dynamics import compile_model
from forficula.errors import InputError
from forficula.structure import mass_of, structure_of
from forficula.structure.fans.fan_masses import triangle_masses
from forficula.structure.tree import built_frames, built_points

REFERENCE = load_design("binder2025")
SHEET = {"membrane.density": 1200.0}
TENDON = {"tendon.density": 1100.0, "tendon.area": 5e-6}
corner = st.tuples(*[st.floats(-1, 1)] * 3)
three = st.tuples(corner, corner, corner).map(np.array)
# a unit triangle's consistent mass matrix
CONSISTENT = (np.ones((3, 3)) + np.eye(3)) / 12


def area(corners):
    return np.linalg.norm(np.cross(corners[1] - corners[0], corners[2] - corners[0])) / 2


@given(three)
def test_a_triangle_on_one_body_has_the_moments_of_a_plate(corners):
    masses = list(triangle_masses(corners, [4, 4, 4]))
    places, weights = np.array([place for _, place, _ in masses]), np.array([mass for *_, mass in masses])
    assert {body for body, *_ in masses} == {4}
    assert weights.sum() == pytest.approx(area(corners), abs=1e-12)
    assert weights @ places == pytest.approx(area(corners) * corners.mean(axis=0), abs=1e-12)
    second = np.einsum("m,mi,mj->ij", weights, places, places)
    assert second == pytest.approx(area(corners) * corners.T @ CONSISTENT @ corners, abs=1e-12)


@given(three, three, three, st.sampled_from([(0, 0, 1), (0, 1, 0), (1, 0, 0), (0, 1, 2)]))
def test_a_triangle_between_bodies_has_its_momentum_and_no_less_than_its_energy(corners, speeds, turns, carriers):
    """Bodies move independently: velocities of the corners differ by body."""

    def velocity(body, place):
        return speeds[body] + np.cross(turns[body], place)

    moving = np.array([velocity(body, place) for body, place in zip(carriers, corners, strict=True)])
    masses = [(mass, velocity(body, place)) for body, place, mass in triangle_masses(corners, carriers)]
    whole = area(corners)
    assert sum(mass * speed for mass, speed in masses) == pytest.approx(whole * moving.mean(axis=0), abs=1e-12)
    energy = sum(mass * speed @ speed for mass, speed in masses) / 2
    consistent = whole * np.trace(moving.T @ CONSISTENT @ moving) / 2
    apart = [
        np.sum((moving[one] - moving[other]) ** 2)
        for one in range(3)
        for other in range(one)
        if carriers[one] != carriers[other]
    ]
    assert energy == pytest.approx(consistent + whole * sum(apart) / 24, abs=1e-12)


@pytest.mark.parametrize("units", [1, 2])
def test_the_mass_of_the_membrane_is_that_of_its_panels(units):
    values = SHEET | {"pattern.units": units, "pattern.sector_angle": 0.3}
    structure = structure_of(with_values(REFERENCE, values))
    quads = 0.0
    for near, far in zip(range(2 * units), range(1, 2 * units + 1), strict=True):
        places = {point.name: place for point, place in zip(structure.points, built_points(structure), strict=True)}
        (hub, ring, tip), (other_hub, other_ring, other_tip) = (
            [places[f"{name}{vein}"] for name in ("hub", "ring", "tip")] for vein in (near, far)
        )
        share = REFERENCE.membrane.proximal_rows[0]
        begins = hub + share * (ring - hub), other_hub + share * (other_ring - other_hub)
        for quad in ((begins[0], ring, other_ring, begins[1]), (ring, tip, other_tip, other_ring)):
            quads += area(np.array([quad[0], quad[1], quad[2]])) + area(np.array([quad[0], quad[2], quad[3]]))
    total = sum(mass.mass for mass in structure.masses)
    assert total == pytest.approx(1200 * REFERENCE.membrane.thickness * quads, rel=1e-12)
    # it lies in the plane of the sheet
    origins, frames = built_frames(structure)
    heights = [(origins[mass.body] + frames[mass.body] @ mass.place)[2] for mass in structure.masses]
    assert np.abs(heights).max() < 1e-12


def test_tendon_and_hinge_masses_are_divided_between_both_sides():
    structure = structure_of(with_values(REFERENCE, TENDON | {"vein.added_mass": 2e-3}))
    by_role = {role: [mass for mass in structure.masses if mass.role == role] for role in ("tendon", "hinge")}
    length = REFERENCE.tendon.rest_length
    assert [item.mass for item in by_role["tendon"]] == pytest.approx([1100 * 5e-6 * length / 2] * 6)
    assert [item.mass for item in by_role["hinge"]] == [1e-3] * 6
    assert [item.body for item in by_role["hinge"]] == [0, 1, 2, 3, 4, 5]
    ends = [structure.points[point] for tendon in structure.tendons for point in tendon.points]
    assert [item.body for item in by_role["tendon"]] == [end.body for end in ends]
    for item, end in zip(by_role["tendon"], ends, strict=True):
        np.testing.assert_array_equal(item.place, end.place)


def test_the_engine_has_the_masses_of_the_structure():
    model = compile_model(with_values(REFERENCE, SHEET | TENDON | {"vein.added_mass": 1e-3}))
    for number, body in enumerate(model.in_units.bodies):
        mass, centre, inertia = mass_of(model.in_units, number)
        compiled = model.engine.body(body.name)
        assert compiled.mass[0] == pytest.approx(mass, rel=1e-12)
        assert compiled.ipos == pytest.approx(centre, rel=1e-12, abs=1e-15)
        assert np.sort(compiled.inertia) == pytest.approx(np.linalg.eigvalsh(inertia), rel=1e-9)


def test_what_turns_about_a_distal_hinge_carries_its_masses():
    """The closed forms of the snap of a hinge contain the masses, too."""
    light, heavy = (
        structure_of(with_values(REFERENCE, values)).tendons[0].crossing.inertia for values in ({}, SHEET | TENDON)
    )
    structure = structure_of(with_values(REFERENCE, SHEET | TENDON))
    axis = next(hinge.axis for hinge in structure.hinges if hinge.name == "fold0")
    carried = [mass for mass in structure.masses if mass.body == 1]
    assert heavy - light == pytest.approx(sum(m.mass * np.sum(np.cross(axis, m.place) ** 2) for m in carried))


def test_a_design_without_masses_is_unchanged():
    zeros = dict.fromkeys(("membrane.density", "tendon.density", "vein.added_mass"), 0.0)
    assert with_values(REFERENCE, zeros).hash == REFERENCE.hash
    assert structure_of(REFERENCE).masses == ()
    assert with_values(REFERENCE, SHEET).hash != REFERENCE.hash


@pytest.mark.parametrize(
    ("values", "message"),
    [
        ({"tendon.density": 1100.0}, r"tendon\.area: is missing; tendon\.density needs the volume"),
        ({"tendon.area": 5e-6}, r"tendon\.area: needs tendon\.law"),
        ({"membrane.density": -1.0}, r"membrane\.density: need >= 0, got -0\.001 g/cm\^3"),
        ({"vein.added_mass": "2 cm"}, r"vein\.added_mass: .cm. is not a unit of the right kind"),
    ],
)
def test_masses_that_cannot_be_are_refused(values, message):
    with pytest.raises(InputError, match=message):
        with_values(REFERENCE, values)


def test_the_wing_with_the_masses_of_its_parts_in_air_folds_in_72_ms():
    built = load_design("binder2025-built", {"protocol.timestep": "0.04 ms"})
    stages = [stage.model_dump() for stage in built.protocol.stages[:2]]
    record = run(with_values(built, {"protocol.stages": stages}))
    fold = record.stages[1]
    # 71.96, 71.88 and 71.85 ms at 0.04, 0.02 and 0.01 ms
    assert fold.goal_time - fold.start == pytest.approx(0.0719, abs=3e-4)


def test_without_armature_a_step_of_the_reference_is_too_long_and_the_advice_is_a_shorter_one():
    built = load_design("binder2025-built", {"protocol.timestep": "0.2 ms"})
    stages = [stage.model_dump() for stage in built.protocol.stages[:2]]
    outcome = measure(run(with_values(built, {"protocol.stages": stages})))
    assert not outcome.verdict.conclusive
    assert outcome.advised.values == {"protocol.timestep": "auto"}
