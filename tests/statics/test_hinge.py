"""Statics of one tendon across one hinge against geometry in space, differentiation, and closed forms."""

import math

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from forficula.design import load_design, scale_design, with_values
from forficula.errors import InputError
from forficula.material import ElasticLaw
from forficula.pattern import earwig_pattern, folded_coordinates, hub_points, ring_vertices, tips
from forficula.statics import TendonHinge, ideal_hinges, slack_angle, tendon_hinges
from forficula.statics.tree.hinge import released_energy
from forficula.structure import structure_of
from tests.statics.hinge_numbers import holding_torque, peak_opening_torque, top_barrier

REFERENCE = load_design("binder2025")
ANGLES = st.floats(-math.pi, math.radians(30))


def equal_arms(rest_length=0.0, arm=0.055, **changes):
    """The ideal hinge of the paper's tendons, 10 N/cm."""
    law = ElasticLaw(rest_length=rest_length, linear=1000.0)
    fixed = {"overbend": math.radians(3), "fold_limit": math.pi, "inertia": 2e-5}
    return TendonHinge(law=law, proximal_arm=arm, distal_arm=arm, **{**fixed, **changes})


@st.composite
def hinges(draw):
    """Arms of any ratio up to four, at any slant, and laws that stiffen and soften; taut by a hundredth at least."""
    proximal = draw(st.floats(0.01, 0.1))
    distal = proximal * draw(st.floats(0.25, 4))
    # within 1/20 of each other the ends nearly meet, and a difference quotient no longer sees the passage
    offset = draw(st.sampled_from([-1, 1])) * draw(st.floats(0.05, 1)) * proximal
    longest = math.hypot(proximal + distal, offset)
    linear, cubic = draw(st.floats(100, 6000)), draw(st.floats(0, 1)) / longest**2
    quadratic = draw(st.floats(-1.9 * math.sqrt(cubic), 1 / longest))
    return TendonHinge(
        law=ElasticLaw(
            rest_length=draw(st.floats(0, 0.99)) * longest,
            linear=linear,
            quadratic=linear * quadratic,
            cubic=linear * cubic,
        ),
        proximal_arm=proximal,
        distal_arm=distal,
        axial_offset=offset,
        overbend=draw(st.floats(0.01, 0.2)),
        fold_limit=draw(st.floats(1, math.pi)),
        inertia=draw(st.floats(1e-7, 1e-3)),
    )


def stiffness_scale(hinge):
    """Of the second derivative, N m."""
    law, longest = hinge.law, float(hinge.length(0))
    slope = law.linear + 2 * abs(law.quadratic) * longest + 3 * law.cubic * longest**2
    return slope * hinge.proximal_arm * hinge.distal_arm


@given(hinges(), ANGLES)
def test_the_moment_is_the_falling_slope_of_the_energy(hinge, angle):
    step = 1e-5
    slope = (hinge.energy(angle + step) - hinge.energy(angle - step)) / (2 * step)
    # step^2 times a third derivative of up to 20^2, and rounding by the step
    assert hinge.moment(angle) == pytest.approx(-slope, abs=1e-6 * stiffness_scale(hinge))


@given(hinges(), ANGLES)
def test_the_stiffness_is_the_falling_slope_of_the_moment(hinge, angle):
    step = 1e-5
    slack = hinge.slack_distance
    assume(slack is None or abs(abs(angle) - slack) > 2 * step)
    slope = (hinge.moment(angle + step) - hinge.moment(angle - step)) / (2 * step)
    # as above
    assert hinge.stiffness(angle) == pytest.approx(-slope, abs=1e-6 * stiffness_scale(hinge))


def test_where_the_ends_meet_the_hinge_is_a_pendulum_at_rest():
    """With no resting length U = k a^2 (1 + cos(angle)) for equal arms."""
    hinge = equal_arms()
    angles = np.linspace(-math.pi, 0.05, 50)
    full = 1000 * 0.055**2
    # rounding
    assert hinge.energy(angles) == pytest.approx(full * (1 + np.cos(angles)), abs=1e-14)
    assert hinge.moment(angles) == pytest.approx(full * np.sin(angles), abs=1e-14)
    assert hinge.stiffness(angles) == pytest.approx(-full * np.cos(angles), abs=1e-14)
    assert (hinge.length(math.pi), hinge.moment(-math.pi)) == (0, 0)


def turned(vector, axis, angle):
    """Rodrigues 1840."""
    cosine, sine = math.cos(angle), math.sin(angle)
    return vector * cosine + np.cross(axis, vector) * sine + axis * (axis @ vector) * (1 - cosine)


def unit(vector):
    return vector / np.linalg.norm(vector)


FANS = st.fixed_dictionaries(
    {
        "pattern.hub_radius": st.floats(0, 0.04),
        "pattern.sector_angle": st.floats(0.26, 0.5),
        "pattern.units": st.integers(1, 3),
        "pattern.tangent": st.sampled_from(["left", "right"]),
        "tendon.proximal_attachment": st.floats(0.02, 0.12),
        "tendon.distal_attachment": st.floats(0.02, 0.1),
    }
)


@settings(deadline=None)
@given(FANS, ANGLES)
def test_the_length_is_that_of_a_distal_vein_turned_about_its_ring_crease(values, angle):
    design = with_values(REFERENCE, values)
    ring = ring_vertices(design.fan, continued=True)
    hinges = tendon_hinges(structure_of(design))
    assert len(hinges) == design.fan.vein_count
    for vein, hinge in enumerate(hinges):
        vertex = ring[vein]
        before = design.tendon.proximal_attachment * unit(hub_points(design.fan)[vein] - vertex)
        beyond = design.tendon.distal_attachment * unit(tips(design.fan)[vein] - vertex)
        length = np.linalg.norm(turned(beyond, unit(ring[vein + 1] - vertex), angle) - before)
        # rounding; where the ends meet, by a square root
        assert hinge.length(angle) == pytest.approx(length, abs=1e-9)


@pytest.mark.parametrize("fold", [-3.0, -1.5, 0.7])
def test_the_length_is_that_of_the_pattern_folded_along_its_ring(fold):
    """With all veins on one ray each (no hub) the first panel folds along its ring crease alone."""
    design = with_values(REFERENCE, {"pattern.hub_radius": 0.0})
    pattern = earwig_pattern(design.fan)
    panel = [0, 1, 2, 4, 5]  # centre, ring vertices and tips of the first panel
    half = type(pattern)(
        vertices_coords=pattern.vertices_coords[panel],
        edges_vertices=np.array([[1, 2], [0, 1], [0, 2], [1, 3], [2, 4], [3, 4]]),
        edges_assignment=("V",) + ("B",) * 5,
        edges_fold_angle=np.full(6, np.nan),
        faces_vertices=((0, 1, 2), (1, 3, 4, 2)),
    )
    centre, vertex, _, tip, _ = folded_coordinates(half, [fold] + [math.nan] * 5)
    tendon = design.tendon
    ends = (
        vertex + tendon.proximal_attachment * unit(centre - vertex),
        vertex + tendon.distal_attachment * unit(tip - vertex),
    )
    # rounding
    assert tendon_hinges(structure_of(design))[0].length(fold) == pytest.approx(
        np.linalg.norm(ends[0] - ends[1]), abs=1e-14
    )


def test_the_bar_turns_with_the_inertia_of_its_volume():
    """The integral over the cylinder of density times distance squared from the axis, by Gauss's rule, in space."""
    design = with_values(REFERENCE, {"vein.diameter": 0.03, "hinge.armature": 0.0})
    length, radius, density = design.pattern.distal_length, design.vein.diameter / 2, design.vein.density
    nodes, weights = np.polynomial.legendre.leggauss(4)
    around = np.arange(8) * math.pi / 4
    along, out, turn = np.meshgrid((nodes + 1) / 2 * length, (nodes + 1) / 2 * radius, around, indexing="ij")
    volume = np.einsum("i,j,k->ijk", weights * length / 2, weights * radius / 2, np.full(8, math.pi / 4)) * out
    vertex, after = ring_vertices(design.fan)[:2]
    bar = unit(tips(design.fan)[0] - vertex)
    beside = np.cross([0, 0, 1], bar)
    points = along[..., None] * bar + out[..., None] * (
        np.cos(turn)[..., None] * beside + np.sin(turn)[..., None] * np.array([0, 0, 1])
    )
    for hinge, axis in (
        (tendon_hinges(structure_of(design))[0], unit(after - vertex)),
        (ideal_hinges(structure_of(design))[0], beside),
    ):
        inertia = density * np.sum(volume * np.sum(np.cross(points, axis) ** 2, axis=-1))
        # the rule is exact
        assert hinge.inertia == pytest.approx(inertia, rel=1e-13)


def test_the_armature_is_added():
    design = with_values(REFERENCE, {"hinge.armature": 1.0})
    assert ideal_hinges(structure_of(design))[0].inertia == pytest.approx(1, rel=1e-4)
    assert tendon_hinges(structure_of(design))[0].inertia == pytest.approx(1, rel=1e-4)


def test_without_hub_the_crease_is_slanted_by_half_a_sector():
    pointed = with_values(REFERENCE, {"pattern.hub_radius": 0.0, "pattern.sector_angle": 0.4})
    hinge = tendon_hinges(structure_of(pointed))[1]
    assert abs(hinge.axial_offset) == pytest.approx(0.11 * math.sin(0.2))
    assert hinge.proximal_arm == pytest.approx(0.055 * math.cos(0.2))
    assert hinge.distal_arm == pytest.approx(0.055 * math.cos(0.2))


@given(st.floats(1e-6, 1.5), st.floats(0.01, 1))
def test_the_barrier_of_a_tendon_without_resting_length_is_its_energy_times_a_squared_sine(overbend, arm):
    """theory.md, section 3: U(0) sin^2(overbend / 2)."""
    hinge = equal_arms(arm=arm, overbend=overbend)
    closed_form = float(hinge.energy(0)) * math.sin(overbend / 2) ** 2
    # rounding of the energies, of which a small overbend leaves a small difference
    assert top_barrier(hinge) == pytest.approx(closed_form, rel=1e-13, abs=1e-15 * float(hinge.energy(0)))


@given(hinges())
def test_the_barrier_is_the_work_of_the_moment_on_the_way_to_straight(hinge):
    nodes, weights = np.polynomial.legendre.leggauss(60)
    slack = hinge.slack_distance
    end = hinge.overbend if slack is None else min(slack, hinge.overbend)
    work = end / 2 * weights @ hinge.moment((nodes + 1) / 2 * end)
    # rounding of extensions of at least a hundredth
    assert top_barrier(hinge) == pytest.approx(work, rel=1e-9, abs=1e-13 * float(hinge.energy(0)))
    assert holding_torque(hinge) == hinge.moment(hinge.overbend) >= 0


@given(hinges(), st.floats(0, 1.5), st.floats(0, 1.5))
def test_the_released_energy_is_a_difference_of_energies(hinge, start, further):
    difference = hinge.energy(start) - hinge.energy(start + further)
    # rounding of the larger energy
    assert released_energy(hinge, start, further) == pytest.approx(difference, abs=1e-12 * float(hinge.energy(0)))


@given(st.floats(0, 0.9999))
def test_equal_arms_go_slack_at_twice_the_arc_cosine(share):
    hinge = equal_arms(rest_length=0.11 * share)
    # arc cosine of 0.9999: rounding by sin
    assert slack_angle(hinge) == pytest.approx(-2 * math.acos(share), abs=1e-13)


@given(hinges())
def test_at_the_slack_angle_the_tendon_has_its_resting_length(hinge):
    angle = slack_angle(hinge)
    if angle is None:
        assert hinge.moment(-hinge.fold_limit * (1 - 1e-6)) < 0
    else:
        assert hinge.length(angle) == pytest.approx(hinge.law.rest_length, rel=1e-9)
        assert hinge.energy(np.linspace(angle - 1e-6, -math.pi, 50)) == pytest.approx(0, abs=1e-15)


@given(hinges())
def test_no_angle_has_a_larger_torque_against_opening_than_the_peak(hinge):
    peak = peak_opening_torque(hinge)
    angles = np.linspace(0, -hinge.fold_limit, 4001)
    # rounding
    assert -hinge.moment(angles).min() <= peak.torque * (1 + 1e-12)
    assert peak.torque == -hinge.moment(peak.angle)
    assert -hinge.fold_limit <= peak.angle < 0


@given(st.floats(0, 0.999))
def test_the_peak_of_equal_arms_is_at_its_closed_form(share):
    """d/d angle of k a^2 (2 s c - 2 lambda s), s and c of half the angle: 2 c^2 - lambda c - 1 = 0."""
    cosine = (share + math.sqrt(share**2 + 8)) / 4
    sine = math.sqrt(1 - cosine**2)
    peak = peak_opening_torque(equal_arms(rest_length=0.11 * share))
    # the slope of the moment is 0 to rounding of an extension of a thousandth
    assert peak.angle == pytest.approx(-2 * math.acos(cosine), abs=1e-10)
    assert peak.torque == pytest.approx(1000 * 0.055**2 * 2 * sine * (cosine - share), rel=1e-10)


def test_the_peak_is_at_the_fold_limit_where_the_moment_grows_up_to_it():
    peak = peak_opening_torque(equal_arms(fold_limit=1.0))
    assert peak.angle == -1.0
    assert peak.torque == pytest.approx(1000 * 0.055**2 * math.sin(1.0))


@settings(deadline=None)
@given(st.floats(1e-3, 1e3))
def test_a_scaled_design_has_energy_and_torque_by_the_cube(factor):
    """theory.md, section 4: k goes with the size, U and torque with its cube, I with its fifth power."""
    scaled = scale_design(REFERENCE, factor)
    pairs = [
        (ideal_hinges(structure_of(REFERENCE))[0], ideal_hinges(structure_of(scaled))[0]),
        *zip(tendon_hinges(structure_of(REFERENCE)), tendon_hinges(structure_of(scaled)), strict=True),
    ]
    for hinge, larger in pairs:
        # rounding of extensions of a fifth, and of the position of the peak
        assert top_barrier(larger) == pytest.approx(factor**3 * top_barrier(hinge), rel=1e-11)
        assert holding_torque(larger) == pytest.approx(factor**3 * holding_torque(hinge), rel=1e-11)
        assert peak_opening_torque(larger).torque == pytest.approx(
            factor**3 * peak_opening_torque(hinge).torque, rel=1e-11
        )
        assert slack_angle(larger) == pytest.approx(slack_angle(hinge), rel=1e-11)
        assert larger.inertia == pytest.approx(factor**5 * hinge.inertia, rel=1e-11)


def test_energy_and_torque_keep_the_shape_of_the_angles():
    hinge = equal_arms(0.09)
    angles = np.zeros((2, 3))
    for values in (hinge.length(angles), hinge.energy(angles), hinge.moment(angles), hinge.stiffness(angles)):
        assert values.shape == (2, 3)


@pytest.mark.parametrize("rest_length", [0.11, 0.2])
def test_a_tendon_that_is_slack_throughout_has_nothing(rest_length):
    hinge = equal_arms(rest_length)
    assert not hinge.pulls
    for number in (top_barrier, holding_torque, peak_opening_torque, slack_angle):
        assert number(hinge) is None


@pytest.mark.parametrize(
    ("numbers", "message"),
    [
        ({"proximal_arm": 0.0}, "proximal_arm: need > 0, got 0 m"),
        ({"distal_arm": math.nan}, "distal_arm: need > 0, got nan m"),
        ({"axial_offset": math.inf}, "axial_offset: need a finite number, got inf m"),
        ({"inertia": -1.0}, r"inertia: need > 0, got -1 kg m\^2"),
        ({"offset_angle": math.nan}, "offset_angle: need >= -180 deg and <= 180 deg, got nan deg"),
        ({"overbend": -0.1}, "overbend: need >= 0 deg and <= 180 deg, got -5.72958 deg"),
        ({"fold_limit": 4.0}, "fold_limit: need >= 0 deg and <= 180 deg, got 229.183 deg"),
    ],
)
def test_a_hinge_that_is_none_is_refused(numbers, message):
    fixed = {"proximal_arm": 0.05, "distal_arm": 0.05, "overbend": 0.05, "fold_limit": 3.0, "inertia": 1e-5}
    with pytest.raises(InputError, match=message):
        TendonHinge(law=ElasticLaw(rest_length=0.0, linear=1000.0), **{**fixed, **numbers})
