import numpy as np
import pytest
from forficula.show.page.wing_mesh import DISTAL, PROXIMAL, moving_points, wing_mesh
from forficula.show.structure.wing_surface import wing_surface

from forficula.design import load_design
from forficula.pattern import earwig_pattern


@pytest.fixture(params=["three veins", "eleven veins"])
def wing(request, short_run, large_record):
    record = short_run if request.param == "three veins" else large_record
    return record, wing_mesh(record.design), moving_points(record)


def vertex_positions(mesh, points):
    """Where the page draws the vertices, (..., vertex, 3), with the points at (..., point, 3)."""
    first, second = points[..., mesh.between[:, 0], :], points[..., mesh.between[:, 1], :]
    return first + mesh.share[:, np.newaxis] * (second - first)


def test_the_sheet_is_the_surface_of_the_record_at_any_time(wing):
    record, mesh, points = wing
    for row in (0, len(record.time) // 3, len(record.time) - 1):
        corners = vertex_positions(mesh, points[row])[mesh.triangles]
        surface = wing_surface(record, float(record.time[row]))
        # two triangles of three corners in place of each quadrilateral of four
        assert len(corners) == 2 * len(surface.quads)
        assert np.allclose(corners.reshape(len(surface.quads), 6, 3)[:, [0, 1, 2, 5]], surface.quads, atol=1e-12)
        assert np.array_equal(mesh.regions[::2] == DISTAL, surface.distal)


def test_veins_and_tendons_are_where_the_record_has_them(wing):
    record, mesh, points = wing
    positions = vertex_positions(mesh, points)
    ends = {kind: [tube.ends for tube in mesh.tubes if tube.kind == kind] for kind in ("vein", "tendon")}
    veins = record.series["vein_position"]
    drawn = positions[:, np.array(ends["vein"])].reshape(*veins.shape[:2], 2, 2, 3)
    assert np.allclose(drawn[:, :, 0, 0], veins[:, :, 0], atol=1e-12)
    assert np.allclose(drawn[:, :, 0, 1], veins[:, :, 1], atol=1e-12)
    assert np.allclose(drawn[:, :, 1, 1], veins[:, :, 2], atol=1e-12)
    tendons = positions[:, np.array(ends["tendon"])]
    lengths = np.linalg.norm(tendons[:, :, 1] - tendons[:, :, 0], axis=-1)
    # lengths to the rounding of the model's units
    assert np.allclose(lengths, record.series["tendon_length"], atol=1e-9)


def test_creases_have_the_letters_of_the_pattern(wing):
    record, mesh, _ = wing
    pattern = earwig_pattern(record.design.fan)
    for kind, role in (("vein", "proximal"), ("ring", "ring"), ("tendon", "distal")):
        letters = {tube.vein: tube.crease for tube in mesh.tubes if tube.kind == kind}
        assert list(letters.values()) == [
            letter for letter, known in zip(pattern.edges_assignment, pattern.edges_role, strict=True) if known == role
        ]


def test_the_dashes_of_a_crease_lie_on_the_ring_fold_and_mountains_differ_from_valleys(wing):
    record, mesh, points = wing
    positions = vertex_positions(mesh, points[0])
    ring = record.series["vein_position"][0, :, 1]
    lengths = {"M": set(), "V": set()}
    for tube in (tube for tube in mesh.tubes if tube.kind == "ring"):
        first, second = positions[list(tube.ends)]
        along = ring[tube.vein + 1] - ring[tube.vein]
        along /= np.linalg.norm(along)
        for place in (first, second):
            away = place - ring[tube.vein]
            # the start is not quite flat: the edge of the margin stands a little off the line
            assert np.linalg.norm(away - (away @ along) * along) < 2e-3
        lengths[tube.crease].add(round(float(np.linalg.norm(second - first)), 4))
    assert len(lengths["M"]) > 1
    assert lengths["M"] != lengths["V"]


def test_triangles_of_the_flat_wing_are_counterclockwise_from_above(reference):
    mesh = wing_mesh(reference)
    from forficula.study.runs import run

    stage = {"name": "settle", "drive": "none", "until": "time", "hold": "0 s", "time_limit": "1 ms"}
    record = run(load_design("binder2025", {"protocol.stages": [stage]}))
    corners = vertex_positions(mesh, moving_points(record)[0])[mesh.triangles]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    assert (normals[:, 2] > 0).all()
    assert set(mesh.regions) == {PROXIMAL, DISTAL}


def test_more_rows_of_the_membrane_make_more_triangles_and_no_other_veins(reference):
    finer = load_design("binder2025", {"membrane.proximal_rows": [0.3, 0.6], "membrane.distal_rows": [0.5]})
    coarse, fine = wing_mesh(reference), wing_mesh(finer)
    # each of two panels, margin and rest, has two quadrilaterals more
    assert len(fine.triangles) == len(coarse.triangles) + 2 * 2 * 2 * 2
    assert [tube for tube in fine.tubes if tube.kind == "vein"] != []
    assert len(fine.joints) == len(coarse.joints)


def test_hair_thin_veins_leave_creases_that_can_be_seen():
    thin = wing_mesh(load_design("binder2025", {"vein.diameter": "0.01 mm"}))
    assert min(tube.radius for tube in thin.tubes if tube.kind == "vein") == pytest.approx(5e-6)
    assert min(tube.radius for tube in thin.tubes if tube.kind == "ring") > 1e-4
    assert len(thin.tubes) < 200
