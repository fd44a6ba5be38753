"""The earwig fan folds flat and rigidly along its whole path.

Flat-foldability of a vertex: Kawasaki 1989. Rigid folding: the product of rotations around every vertex is the identity
(Belcastro and Hull 2002). Drift of the stack: two neighbouring veins are tangents of the hub circle and intersect at
r / cos(theta / 2) from its centre. Folding both completely turns the next panels by 2 theta about the intersection,
opposite to the 2 theta by which the flat fan turns them about the centre. The result is a shift of
2 sin(theta) r / cos(theta / 2) = 4 r sin(theta / 2).
"""

import math

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st

from forficula.pattern import (
    EarwigFan,
    creases_inside,
    degree4_fold_angles,
    earwig_pattern,
    fan_fold_angles,
    folded_coordinates,
    kawasaki_residuals,
    sectors_between,
)
from tests.pattern.closing import closure_residual


@st.composite
def fans(draw):
    units = draw(st.integers(1, 5))
    length = draw(st.floats(1e-3, 1))
    angle = math.radians(draw(st.floats(2, min(60, 175 / units))))
    return EarwigFan(
        proximal_length=length,
        distal_length=length * draw(st.floats(0.2, 2)),
        hub_radius=length * draw(st.one_of(st.just(0.0), st.floats(1e-3, 1.5))),
        sector_angle=angle,
        units=units,
        tangent=draw(st.sampled_from(["left", "right"])),
    )


PLEATS = st.one_of(st.sampled_from([0.0, math.pi]), st.floats(0, math.pi))


@settings(max_examples=100)
@given(fans())
def test_every_ring_vertex_satisfies_kawasakis_condition(holds, fan):
    # four times the rounding of coordinates, 1e-16 of the ring radius, over the shortest ring crease, 0.035 of it
    residual = np.degrees(np.abs(kawasaki_residuals(earwig_pattern(fan)))).max()
    holds("residual of Kawasaki's condition", residual, below=1e-12, unit="deg", by="Kawasaki 1989")


@given(fans(), st.sampled_from(["earwig", "miura"]))
def test_both_folding_modes_close_along_the_whole_path(holds, fan, mode):
    alpha = math.pi / 2 - fan.sector_angle / 2 + fan.epsilon
    beta = math.pi / 2 - fan.sector_angle / 2 - fan.epsilon
    left = []
    for pleat in np.linspace(0, math.pi, 37):
        folds = degree4_fold_angles(alpha, beta, pleat, mode)
        left.append(closure_residual([alpha, math.pi - beta, math.pi - alpha, beta], folds))
    holds("rotation left around a vertex", left, below=1e-12, by="Belcastro and Hull 2002")


@given(fans(), PLEATS)
def test_every_vertex_of_the_drawn_fan_closes(holds, fan, pleat):
    pattern, folds = earwig_pattern(fan), fan_fold_angles(fan, pleat)
    left = [
        closure_residual(sectors_between(pattern, vertex, around), folds[around])
        for vertex, around in creases_inside(pattern)
    ]
    holds("rotation left around a vertex", left, below=1e-12, by="Belcastro and Hull 2002")


@given(fans(), PLEATS)
def test_the_fan_folds_rigidly(agree, fan, pleat):
    pattern = earwig_pattern(fan)
    folded = folded_coordinates(pattern, fan_fold_angles(fan, pleat))
    ours, theirs = [], []
    for face in pattern.faces_vertices:
        flat_face, folded_face = pattern.vertices_coords[list(face)], folded[list(face)]
        for offset in (1, 2):
            before = np.linalg.norm(flat_face - np.roll(flat_face, offset, axis=0), axis=1)
            after = np.linalg.norm(folded_face - np.roll(folded_face, offset, axis=0), axis=1)
            ours.append(after / fan.ring_radius)
            theirs.append(before / fan.ring_radius)
    ours, theirs = np.concatenate(ours), np.concatenate(theirs)
    agree("lengths divided by the ring's radius", ours, theirs, by="the flat fan", abs=1e-12)


@given(fans())
def test_folded_flat_all_panels_are_in_one_plane(holds, fan):
    folded = folded_coordinates(earwig_pattern(fan), fan_fold_angles(fan, math.pi))
    height = np.abs(folded[:, 2]).max() / (fan.ring_radius + fan.distal_length)
    holds("height divided by the radius of the fan", height, below=1e-12)


@given(fans())
def test_every_two_panels_shift_the_folded_stack_by_four_r_sin_half_theta(agree, fan):
    pattern = earwig_pattern(fan)
    folded = folded_coordinates(pattern, fan_fold_angles(fan, math.pi))
    count = fan.vein_count
    hub, ring, tip = folded[: -2 * count], folded[-2 * count : -count], folded[-count:]
    drift = 4 * fan.hub_radius * math.sin(fan.sector_angle / 2)
    shifts = np.concatenate([points[2:] - points[:-2] for points in (hub, ring, tip)])
    size = fan.ring_radius + fan.distal_length
    sizes = np.linalg.norm(shifts, axis=1) / size
    agree("drift divided by the radius of the fan", sizes, drift / size, by="4 r sin(θ/2)", abs=1e-11)
    agree("spread of drifts", np.ptp(shifts, axis=0) / size, 0, by="one shift", abs=1e-11)


@given(fans(), st.floats(0.1, 3.0))
def test_distal_veins_fold_equally_and_the_ring_creases_alternate(agree, fan, pleat):
    pattern, folds = earwig_pattern(fan), fan_fold_angles(fan, pleat)
    roles = np.array(pattern.edges_role)
    np.testing.assert_array_equal(folds[roles == "distal"], folds[roles == "proximal"])
    ring = folds[roles == "ring"]
    np.testing.assert_array_equal(ring[1:], -ring[:-1])
    expected = math.sin(fan.epsilon) / math.cos(fan.sector_angle / 2) * math.tan(pleat / 2)
    # if the hub is a point the ring does not fold, up to the default tolerance of `pytest.approx`
    agree("tan(ring / 2)", np.tan(np.abs(ring) / 2), expected, by="m tan(pleat / 2)", rel=1e-12, abs=1e-12)


def test_with_a_small_hub_the_ring_folds_at_the_end_of_pleating(agree):
    fan = EarwigFan(proximal_length=0.12, distal_length=0.1, hub_radius=0.003, sector_angle=math.radians(20), units=1)
    ring = [abs(np.degrees(fan_fold_angles(fan, math.radians(pleat))[6])) for pleat in (90, 150, 175, 180)]
    # 2 atan(m tan(pleat / 2)) with m = sin(epsilon) / cos(10 deg) = 0.02538
    known = [2.907, 10.821, 60.334, 180]
    agree("angle of the ring at pleats of 90 to 180 deg", ring, known, unit="deg", by="2 arctan(m tan(ρ/2))", abs=1e-3)
