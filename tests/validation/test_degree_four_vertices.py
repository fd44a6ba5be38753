"""Nets of stiff bars fold a vertex of four creases as rigid panels do.

Flat-foldable vertices satisfy the half-angle tangent relations (Tachi 2009, J. IASS 50, 173-179; Evans, Lang, Magleby
and Howell 2015, doi 10.1098/rsos.150067). At any vertex the product of four rotations is the identity (Belcastro and
Hull 2002, doi 10.1016/S0024-3795(01)00608-5).
"""

from dataclasses import replace

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st

from forficula.material.law.crease_law import CreaseLaw
from forficula.statics.net.energy import built_shape, shape_at
from forficula.statics.net.minimum import minimum
from tests.statics.net.nets import sheet

STIFF = 1e6  # EA over the stiffness of a crease per length


def vertex(sectors):
    """Four panels around the origin; crease 0 is along x, and the angles of the creases count from it."""
    turns = np.cumsum([0.0, *sectors[:-1]])
    rim = np.stack((np.cos(turns), np.sin(turns), np.zeros(4)), axis=1)
    nodes = np.vstack((np.zeros(3), rim))
    return sheet(nodes, [(0, 1, 2), (0, 2, 3), (0, 3, 4), (0, 4, 1)], axial=STIFF)[0]


def folded(sectors, signs, target):
    """Fold angles of the creases in order, driven by the rest angle of the first; `signs` select the branch."""
    net = vertex(sectors)
    creases = [int(np.flatnonzero(net.creases.points[:, 1] == rim)[0]) for rim in (1, 2, 3, 4)]
    rest = np.zeros(4)
    rest[creases] = 0.5 * np.asarray(signs)
    start = built_shape(net)
    for rest_angles, stiffness in ((rest, np.full(4, 1.0)), (np.eye(4)[creases[0]] * target, np.full(4, 1e-6))):
        stiffness[creases[0]] = 1.0
        law = CreaseLaw(stiffness=stiffness, rest_angle=rest_angles)
        moved = replace(net, creases=replace(net.creases, law=law))
        if rest_angles is rest:  # away from the flat state, where the branches cross
            lifted = net.nodes + 0.02 * np.array([0, 0, 1.0]) * np.array([0, *signs])[:, None]
            start = shape_at(net, lifted)
        start = minimum(moved, start, longest_step=0.05).shape
    return start.angles[creases]


@settings(deadline=None, max_examples=10)
@given(st.floats(50, 80), st.floats(95, 130), st.floats(20, 150))
def test_flat_foldable_vertices_satisfy_the_half_angle_tangent_relations(agree, first, second, target):
    alpha, beta = np.deg2rad((first, second))
    angles = folded((alpha, beta, np.pi - alpha, np.pi - beta), (1, 1, 1, -1), np.deg2rad(target))
    agree("driven fold angle", np.rad2deg(angles[0]), target, unit="deg", by="its goal", abs=0.1)
    # opposite creases turn by equal angles: one pair with equal signs, the other with opposite ones
    alike = 0 if angles[0] * angles[2] > 0 else 1
    ours, theirs = np.rad2deg([(angles[alike], angles[alike + 2]), (angles[1 - alike], -angles[3 - alike])]).T
    agree("fold angles of a crease", ours, theirs, unit="deg", by="the opposite crease", abs=1e-3)
    half = np.tan(angles / 2)
    ratio = abs(half[1] / half[0])
    sums, differences = (alpha + beta) / 2, (alpha - beta) / 2
    known = np.abs([np.cos(sums) / np.cos(differences), np.sin(differences) / np.sin(sums)])
    known = np.concatenate((known, 1 / known))
    nearest = known[np.argmin(np.abs(known - ratio))]
    neighbour = np.rad2deg(2 * np.arctan(nearest * abs(half[0])))
    agree(
        "fold angles of the neighbouring crease",
        np.rad2deg(abs(angles[1])),
        neighbour,
        unit="deg",
        by="tan half angles",
        abs=1e-3,
    )


@settings(deadline=None, max_examples=10)
@given(st.floats(50, 85), st.floats(90, 110), st.floats(70, 100), st.floats(10, 80))
def test_rotations_around_any_vertex_multiply_to_the_identity(agree, first, second, third, target):
    sectors = np.deg2rad((first, second, third, 360 - first - second - third))
    angles = folded(sectors, (1, 1, 1, -1), np.deg2rad(target))
    agree("driven fold angle", np.rad2deg(angles[0]), target, unit="deg", by="its goal", abs=0.1)
    around = np.eye(3)
    for angle, sector in zip(angles, sectors, strict=True):
        # at a valley, the next panel turns about the crease against the sense of the walk
        around = around @ turn(0, angle) @ turn(2, sector)
    agree("rotation around a vertex", around, np.eye(3), by="identity", abs=np.deg2rad(2e-3))


def turn(axis, angle):
    cosine, sine = np.cos(angle), np.sin(angle)
    i, j = (axis + 1) % 3, (axis + 2) % 3
    matrix = np.eye(3)
    matrix[i, i] = matrix[j, j] = cosine
    matrix[i, j], matrix[j, i] = -sine, sine
    return matrix
