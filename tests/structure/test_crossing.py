"""Position of tendons across hinges, compared with rotated vectors in space."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

from forficula.design import load_design, with_values
from forficula.structure import (
    GROUND,
    Bar,
    Body,
    Hinge,
    Point,
    Structure,
    bar_crossing,
    built_points,
    structure_of,
    tendon_crossing,
)

REFERENCE = load_design("binder2025")
FLAT = st.floats(-0.02, 0.02)
BARS = st.fixed_dictionaries(
    {
        "attachments": st.tuples(st.floats(0.03, 0.1), st.floats(0.03, 0.1)),
        "offsets": st.tuples(FLAT, FLAT),
        "asides": st.tuples(st.floats(-0.005, 0.005), st.floats(-0.005, 0.005)),
    }
)


def level(angle):
    """A level unit vector."""
    return np.array([math.cos(angle), math.sin(angle), 0.0])


def law_of_cosines(crossing, angle):
    a, b = crossing.proximal_arm, crossing.distal_arm
    square = a**2 + b**2 + crossing.axial_offset**2 + 2 * a * b * math.cos(angle + crossing.offset_angle)
    return math.sqrt(max(square, 0.0))


@given(BARS, st.floats(-math.pi, math.pi), st.floats(0.6, 2.5), st.floats(-0.4, 0.4), st.floats(-math.pi, math.pi))
def test_the_length_between_bars_is_that_of_turned_vectors(chosen, heading, slant, bend, angle):
    """Ends off the bars' axes: along them, out of the plane to the side of the overbend, and beside them."""
    axis, proximal, distal = level(heading + slant), level(heading), level(heading + bend)
    upwards = np.array([0.0, 0.0, 1.0])
    overbend = math.copysign(1.0, np.cross(axis, distal)[2]) * upwards
    (p, d), (above, further), (beside, beyond) = (chosen[name] for name in ("attachments", "offsets", "asides"))
    before = -p * proximal + above * overbend + beside * np.cross(upwards, proximal)
    after = d * distal + further * overbend + beyond * np.cross(upwards, distal)
    turned = Rotation.from_rotvec(angle * axis).apply(after)
    crossing = bar_crossing(hinge=0, axis=axis, bars=(proximal, distal), inertia=1.0, **chosen)
    # rounding; where the ends meet, by a square root
    assert law_of_cosines(crossing, angle) == pytest.approx(float(np.linalg.norm(turned - before)), abs=1e-8)
    other_way = bar_crossing(hinge=0, axis=-axis, bars=(proximal, distal), inertia=1.0, **chosen)
    assert law_of_cosines(other_way, angle) == pytest.approx(law_of_cosines(crossing, angle), abs=1e-12)


def skew_hinge(seed):
    """A body on another, about a skew axis, and a tendon between them in either order."""
    random = np.random.default_rng(seed)
    frames, axis = Rotation.random(2, rng=seed).as_matrix(), random.normal(size=3)
    places = random.uniform(-0.1, 0.1, (4, 3))
    order = (0, 1) if seed % 2 else (1, 0)
    return Structure(
        name="skew",
        bodies=(
            Body(name="base", role="base", parent=GROUND, position=places[0], frame=frames[0]),
            Body(name="arm", role="arm", parent=0, position=places[1], frame=frames[1]),
        ),
        points=(Point(name="p", role="p", body=0, place=places[2]), Point(name="d", role="d", body=1, place=places[3])),
        bars=(Bar(body=1, end=np.array([0.1, 0.0, 0.0]), diameter=0.01, density=1000.0, points=order),),
        hinges=(
            Hinge(
                name="h", role="h", body=1, axis=axis / np.linalg.norm(axis), sense=(-1) ** (seed // 2), armature=1e-6
            ),
        ),
        span=0.1,
        mass=0.1,
    ), order


@given(st.integers(0, 10_000), st.floats(-math.pi, math.pi))
def test_the_crossing_of_any_two_points_is_that_of_turned_vectors(seed, angle):
    built, order = skew_hinge(seed)
    crossing, hinge = tendon_crossing(built, order), built.hinges[0]
    assert crossing is not None
    base, arm = built.bodies
    turned = Rotation.from_rotvec(hinge.sense * angle * hinge.axis).apply(built.points[1].place)
    apart = base.position + base.frame @ (arm.position + arm.frame @ turned) - built_points(built)[0]
    assert crossing.hinge == 0
    assert law_of_cosines(crossing, angle) == pytest.approx(float(np.linalg.norm(apart)), abs=1e-8)


def test_the_crossings_of_a_fan_are_those_of_its_points():
    values = {"proximal_offset": 0.003, "distal_offset": -0.002, "proximal_aside": 0.004, "distal_aside": -0.003}
    for tangent in ("left", "right"):
        built = structure_of(
            with_values(
                REFERENCE, {"pattern.tangent": tangent, **{f"tendon.{key}": value for key, value in values.items()}}
            )
        )
        for tendon in built.tendons:
            result, crossing = tendon_crossing(built, tendon.points), tendon.crossing
            assert (result.hinge, result.offset_angle) == (
                crossing.hinge,
                pytest.approx(crossing.offset_angle, abs=1e-12),
            )
            assert result.proximal_arm == pytest.approx(crossing.proximal_arm)
            assert result.distal_arm == pytest.approx(crossing.distal_arm)
            # along the axis, either way
            assert abs(result.axial_offset) == pytest.approx(abs(crossing.axial_offset))
            assert result.inertia == pytest.approx(crossing.inertia)


def test_a_tendon_across_two_hinges_or_on_the_axis_has_no_crossing():
    built = structure_of(REFERENCE)
    names = [point.name for point in built.points]
    across = (names.index("distal_attachment0"), names.index("distal_attachment1"))
    on_axis = (names.index("proximal_attachment0"), names.index("ring0"))
    same = (names.index("distal_attachment0"), names.index("tip0"))
    assert [tendon_crossing(built, pair) for pair in (across, on_axis, same)] == [None, None, None]
