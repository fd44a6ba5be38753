from itertools import pairwise

import numpy as np
import pytest

from forficula.design import load_design
from forficula.pattern import earwig_pattern
from forficula.show.page.data.shape_mesh import moving_points, shape_mesh
from forficula.show.structure.shape import shape_of
from forficula.show.structure.surface import surface_at
from forficula.structure import structure_of


@pytest.fixture(params=["three veins", "eleven veins"])
def wing(request, short_run, large_record):
    record = short_run if request.param == "three veins" else large_record
    mesh = shape_mesh(record.structure)
    return record, mesh, moving_points(record, mesh)


def vertex_positions(mesh, points):
    """Return where the page draws the vertices, (..., vertex, 3), for points at (..., point, 3)."""
    first, second = points[..., mesh.between[:, 0], :], points[..., mesh.between[:, 1], :]
    return first + mesh.share[:, np.newaxis] * (second - first)


def vein_positions(record):
    """Return hub end, ring vertex and tip of every vein, (time, vein, point, 3)."""
    roles = [
        [number for number, point in enumerate(record.structure.points) if point.role == role]
        for role in ("hub", "ring", "tip")
    ]
    return record.series["point_position"][:, np.transpose(roles)]


def test_the_sheet_is_the_surface_of_the_record_at_any_time(wing):
    record, mesh, points = wing
    for row in (0, len(record.time) // 3, len(record.time) - 1):
        corners = vertex_positions(mesh, points[row])[mesh.triangles]
        surface = surface_at(record, shape_of(record.structure), float(record.time[row]))
        # two triangles with three corners replace each quadrilateral with four
        assert len(corners) == 2 * len(surface.faces)
        assert np.allclose(corners.reshape(len(surface.faces), 6, 3)[:, [0, 1, 2, 5]], surface.faces, atol=1e-12)
        assert np.array_equal(mesh.regions[::2], surface.regions)


def test_no_more_points_move_than_the_ends_of_the_bars_and_the_edges_of_the_margins(wing):
    record, mesh, points = wing
    veins = vein_positions(record)
    panels, rows = len(veins[0]) - 1, 3
    assert points.shape[1] == len(mesh.anchors) == 3 * len(veins[0]) + panels * rows
    assert np.array_equal(points[:, : 3 * len(veins[0])], veins.reshape(len(veins), -1, 3))


def test_veins_and_tendons_are_where_the_record_has_them(wing):
    record, mesh, points = wing
    positions = vertex_positions(mesh, points)
    ends = {kind: [tube.ends for tube in mesh.tubes if tube.kind == kind] for kind in ("bar", "tendon")}
    veins = vein_positions(record)
    drawn = positions[:, np.array(ends["bar"])].reshape(*veins.shape[:2], 2, 2, 3)
    assert np.allclose(drawn[:, :, 0, 0], veins[:, :, 0], atol=1e-12)
    assert np.allclose(drawn[:, :, 0, 1], veins[:, :, 1], atol=1e-12)
    assert np.allclose(drawn[:, :, 1, 1], veins[:, :, 2], atol=1e-12)
    tendons = positions[:, np.array(ends["tendon"])]
    lengths = np.linalg.norm(tendons[:, :, 1] - tendons[:, :, 0], axis=-1)
    # lengths are exact up to rounding of the model's units
    assert np.allclose(lengths, record.series["tendon_length"], atol=1e-9)


def test_creases_have_the_letters_of_the_pattern(wing):
    record, mesh, _ = wing
    pattern = earwig_pattern(record.design.fan)
    letters = {
        role: [edge for edge, known in zip(pattern.edges_assignment, pattern.edges_role, strict=True) if known == role]
        for role in ("proximal", "distal", "ring")
    }
    bars = [tube.crease for tube in mesh.tubes if tube.kind == "bar"]
    assert bars[::2] == letters["proximal"]
    assert bars[1::2] == letters["distal"]
    lines = [line for line in shape_of(record.structure).lines if line.kind == "crease"]
    assert [line.crease for line in lines] == letters["ring"]
    assert {tube.crease for tube in mesh.tubes if tube.kind == "crease"} == set(letters["ring"])


def test_the_dashes_of_a_crease_lie_on_the_ring_fold_and_mountains_differ_from_valleys(wing):
    record, mesh, points = wing
    positions = vertex_positions(mesh, points[0])
    ring = vein_positions(record)[0, :, 1]
    lengths = {"M": set(), "V": set()}
    for tube in (tube for tube in mesh.tubes if tube.kind == "crease"):
        first, second = positions[list(tube.ends)]
        beside = []
        for start, end in pairwise(ring):
            along = (end - start) / np.linalg.norm(end - start)
            away = [place - start - ((place - start) @ along) * along for place in (first, second)]
            beside.append(np.linalg.norm(away, axis=1).max())
        # the start is not exactly flat: the edge of the margin is slightly off the line
        assert min(beside) < 2e-3
        lengths[tube.crease].add(round(float(np.linalg.norm(second - first)), 4))
    assert len(lengths["M"]) > 1
    assert lengths["M"] != lengths["V"]


def test_triangles_of_the_flat_wing_are_counterclockwise_from_above(reference):
    shape = shape_of(structure_of(reference))
    mesh = shape_mesh(structure_of(reference))
    corners = shape.built[mesh.triangles]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    assert (normals[:, 2] > 0).all()
    assert set(mesh.regions) == {0, 1}
    assert mesh.names == ("proximal panel", "distal panel")


def test_more_rows_of_the_membrane_make_more_triangles_and_no_other_veins(reference):
    finer = load_design("binder2025", {"membrane.proximal_rows": [0.3, 0.6], "membrane.distal_rows": [0.5]})
    coarse, fine = (shape_mesh(structure_of(design)) for design in (reference, finer))
    # each of two panels (margin and rest) gains two quadrilaterals
    assert len(fine.triangles) == len(coarse.triangles) + 2 * 2 * 2 * 2
    assert [tube for tube in fine.tubes if tube.kind == "bar"] != []
    assert len(fine.joints) == len(coarse.joints)


def test_hair_thin_veins_leave_creases_that_can_be_seen():
    thin = shape_mesh(structure_of(load_design("binder2025", {"vein.diameter": "0.01 mm"})))
    assert min(tube.radius for tube in thin.tubes if tube.kind == "bar") == pytest.approx(5e-6)
    assert min(tube.radius for tube in thin.tubes if tube.kind == "crease") > 1e-4
    assert len(thin.tubes) < 200
