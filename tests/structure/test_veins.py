"""Tendons on veins: which veins have one, its attachments, and its length."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

from forficula.design import load_design
from forficula.structure import built_points, built_strains, structure_of

ANGLES = np.radians([-179.0, -120.0, -60.0, -10.0, -1.0, 0.0, 1.0, 3.0, 20.0])
REFERENCE = load_design("binder2025")


def built(**settings):
    return structure_of(load_design("binder2025", {key.replace("__", "."): value for key, value in settings.items()}))


def ends(structure, tendon):
    """Ends of a tendon from its hinge on, in the axes of the bars, and the hinge."""
    hinge = structure.hinges[tendon.crossing.hinge]
    before, beyond = (structure.points[point] for point in tendon.points)
    return before.place - structure.bodies[hinge.body].position, beyond.place, hinge


def rotated_length(structure, tendon, angle):
    """Length of a tendon at a hinge angle in the folding sense, by rotating its end on the distal bar, m."""
    before, beyond, hinge = ends(structure, tendon)
    turned = Rotation.from_rotvec(hinge.sense * angle * hinge.axis).apply(beyond)
    return float(np.linalg.norm(turned - before))


def closed_form(structure, tendon, angle, tall, beside):
    """The same from the distances, heights and sideways offsets of the attachments, m.

    The formula is in docs/model/theory.md, section "Tendon off the hinge axis".

    p, d: distances from the hinge; alpha, beta: angles of the bars to its axis.
    """
    (h_p, h_d), (s_p, s_d) = tall, beside
    hinge = structure.hinges[tendon.crossing.hinge]
    distal = structure.bodies[hinge.body]
    proximal_bar, distal_bar = distal.position, next(bar.end for bar in structure.bars if bar.body == hinge.body)
    alpha, beta = (math.acos(bar @ hinge.axis / np.linalg.norm(bar)) for bar in (proximal_bar, distal_bar))
    p, d = REFERENCE.tendon.proximal_attachment, REFERENCE.tendon.distal_attachment
    a = p * math.sin(alpha) + s_p * math.cos(alpha)
    b = d * math.sin(beta) - s_d * math.cos(beta)
    c = p * math.cos(alpha) + d * math.cos(beta) - s_p * math.sin(alpha) + s_d * math.sin(beta)
    delta = math.atan(h_p / a) + math.atan(h_d / b)
    reach = math.hypot(a, h_p) * math.hypot(b, h_d)
    square = a**2 + h_p**2 + b**2 + h_d**2 + c**2 + 2 * reach * math.cos(angle + delta)
    return math.sqrt(square)


millimetres = st.floats(-8, 8)


@given(
    st.tuples(millimetres, millimetres),
    st.tuples(millimetres, millimetres),
    st.sampled_from(["left", "right"]),
    st.sampled_from(["5 deg", "20 deg", "35 deg"]),
)
def test_a_tendon_off_its_bars_has_the_length_of_the_closed_form(tall, beside, tangent, sector):
    names = ("proximal_offset", "distal_offset", "proximal_aside", "distal_aside")
    values = {f"tendon__{name}": f"{value} mm" for name, value in zip(names, (*tall, *beside), strict=True)}
    narrow = {"vein__diameter": "1 mm", "membrane__margin": "2 mm", "guard__stretch": 2.0}
    structure = built(pattern__tangent=tangent, pattern__sector_angle=sector, **narrow, **values)
    tall, beside = (tuple(1e-3 * item for item in pair) for pair in (tall, beside))
    for tendon in structure.tendons:
        for angle in ANGLES:
            length = rotated_length(structure, tendon, angle)
            # m; a folded tendon is a small difference of large squares
            assert length == pytest.approx(closed_form(structure, tendon, angle, tall, beside), abs=1e-9)
            assert length <= tendon.longest * (1 + 1e-12)


def test_a_tendon_on_the_overbend_side_is_longest_before_its_hinge_is_straight():
    # both anchors at h: the barrier lies at -2.1 deg with 1 mm, at 3 deg with -1.44 mm (docs/model/theory.md,
    # section "Tendon off the hinge axis", for a hinge square to its bars; an oblique one bends 2 % more)
    angles = np.radians(np.linspace(-10, 10, 4001))
    for height, degrees in ((1.0, -2.1), (2.0, -4.2), (-1.44, 3.0)):
        structure = built(tendon__proximal_offset=f"{height} mm", tendon__distal_offset=f"{height} mm")
        for tendon in structure.tendons:
            lengths = [rotated_length(structure, tendon, angle) for angle in angles]
            assert np.degrees(angles[np.argmax(lengths)]) == pytest.approx(degrees, rel=0.03)


def test_mountain_and_valley_joints_are_mirror_images():
    structure = built(
        pattern__units=2, tendon__proximal_offset="3 mm", tendon__distal_offset="2 mm", tendon__distal_aside="1 mm"
    )
    mirror = np.array([1.0, 1.0, -1.0])
    joints = [ends(structure, tendon) for tendon in structure.tendons]
    first = joints[0]
    assert abs(first[0][2]) == pytest.approx(3e-3)
    for before, beyond, hinge in joints[1:]:
        image = mirror if hinge.sense != first[2].sense else 1.0
        # m; one rounding of a rotation by a multiple of the sector angle
        assert before == pytest.approx(image * first[0], abs=1e-15)
        assert beyond == pytest.approx(image * first[1], abs=1e-15)


def test_offsets_beside_a_bar_point_towards_the_next_vein():
    structure, plain = built(tendon__proximal_aside="2 mm", tendon__distal_aside="2 mm"), built()
    moved = built_points(structure) - built_points(plain)
    tips = built_points(plain)[[number for number, point in enumerate(plain.points) if point.role == "tip"]]
    for vein, tendon in enumerate(structure.tendons[:-1]):
        towards = tips[vein + 1] - tips[vein]
        for point in tendon.points:
            assert np.linalg.norm(moved[point]) == pytest.approx(2e-3, rel=1e-9)
            assert moved[point] @ towards > 0
            assert moved[point][2] == 0


def test_a_vein_without_a_tendon_has_neither_tendon_nor_attachments(tmp_path):
    (tmp_path / "wing.toml").write_text(
        'based_on = "binder2025"\n'
        '[[tendon]]\nvein = 2\nstiffness = "20 N/cm"\n[[tendon]]\nvein = 0\nrest_length = "8 cm"\n'
    )
    structure, whole = structure_of(load_design(tmp_path / "wing.toml")), built()
    assert [tendon.name for tendon in structure.tendons] == ["tendon0", "tendon2"]
    assert [tendon.law.stiffness[0] for tendon in structure.tendons] == [1000.0, 2000.0]
    assert [tendon.law.rest_length for tendon in structure.tendons] == [0.08, 0.09]
    names = {point.name for point in whole.points} - {point.name for point in structure.points}
    assert names == {"proximal_attachment1", "distal_attachment1"}
    for limit in structure.limits:
        assert [structure.points[point].role for point in limit.points] == ["tip", "tip"]
    for bar, same in zip(structure.bars, whole.bars, strict=True):
        assert [structure.points[point].name for point in bar.points] == [
            whole.points[point].name for point in same.points
        ]


def test_a_tendon_of_a_material_has_its_law_and_reference_length():
    law = {"tendon__law": "tpu-82a", "tendon__area": "12.5 mm^2", "tendon__law__residual_strain": "10 %"}
    for tendon in built(**law).tendons:
        assert tendon.gauge_length == 0.09
        assert tendon.law.rest_length == pytest.approx(0.099, rel=1e-12)
        assert tendon.material.name == "tpu-82a"
    strains = built_strains(built(tendon__2__rest_length="5 cm", tendon__1__rest_length="0 cm"))
    # the flat tendon is 10.9 cm long
    assert strains == pytest.approx([0.2, math.inf, 1.2], abs=0.02)
