from dataclasses import replace

import numpy as np
import pytest

from forficula.analysis.strength import strain_peaks
from forficula.design.places import mesh_rows
from forficula.show.structure.shape import shape_of
from forficula.show.structure.surface import at_time, face_strains, surface_at


@pytest.fixture(scope="module")
def shape(reference_run):
    return shape_of(reference_run.structure)


ROLES = ("hub", "ring", "tip")


def points_of(record, role):
    """Return the indices of the points of a role, by vein."""
    return [number for number, point in enumerate(record.structure.points) if point.role == role]


def test_between_two_samples_a_series_is_interpolated_and_outside_it_stays(reference_run):
    time, points = reference_run.time, reference_run.series["point_position"]
    middle = (time[400] + time[401]) / 2
    assert at_time(reference_run, "point_position", middle) == pytest.approx((points[400] + points[401]) / 2, abs=1e-15)
    assert np.array_equal(at_time(reference_run, "point_position", time[400]), points[400])
    assert np.array_equal(at_time(reference_run, "point_position", -1.0), points[0])
    assert np.array_equal(at_time(reference_run, "point_position", 1e6), points[-1])


@pytest.mark.parametrize("row", [0, 310, 900, -1])
def test_the_surface_is_where_the_record_has_the_structure(reference_run, shape, row):
    surface = surface_at(reference_run, shape, float(reference_run.time[row]))
    veins = reference_run.series["point_position"][row][
        np.transpose([points_of(reference_run, role) for role in ROLES])
    ]
    assert surface.bars[::2] == pytest.approx(veins[:, :2], abs=1e-12)
    assert surface.bars[1::2] == pytest.approx(veins[:, 1:], abs=1e-12)
    nodes = reference_run.series["membrane_position"][row]
    corners = surface.faces.reshape(-1, 3)
    for node in nodes:
        assert np.linalg.norm(corners - node, axis=1).min() < 1e-12
    # and, besides the nodes, on the veins: the strip between a vein and its margin belongs to the wing
    along = np.concatenate([mesh_rows(vein, reference_run.design) for vein in veins[:-1]])
    known = np.concatenate([nodes, along])
    assert max(np.linalg.norm(known - corner, axis=1).min() for corner in corners) < 1e-12


def test_proximal_and_distal_faces_meet_at_the_ring_fold(reference_run, shape):
    surface = surface_at(reference_run, shape, 0.3)
    assert shape.regions == ("proximal panel", "distal panel")
    ring, distal = surface.bars[0, 1], surface.regions == 1
    nearest = [np.linalg.norm(surface.faces[part] - ring, axis=2).min() for part in (distal, ~distal)]
    assert nearest == pytest.approx([0, 0], abs=1e-12)
    assert distal.sum() == (~distal).sum() == len(surface.faces) / 2


def test_a_tendon_is_as_long_as_the_record_has_it(reference_run, shape):
    for row in (0, 330, -1):
        surface = surface_at(reference_run, shape, float(reference_run.time[row]))
        lengths = np.linalg.norm(surface.tendons[:, 1] - surface.tendons[:, 0], axis=1)
        # the record's lengths are those of the engine's tendon, between sites at the same positions
        assert lengths == pytest.approx(reference_run.series["tendon_length"][row], rel=1e-6)


def test_strains_of_faces_are_greens_of_a_sheet_that_is_pulled_sheared_and_turned(reference_run, shape):
    built = surface_at(reference_run, shape, 0.0)
    corners = np.array([(*face, face[-1])[:4] for face in shape.faces])
    turn = np.linalg.qr(np.random.default_rng(0).normal(size=(3, 3)))[0]
    pulled = turn @ np.diag([1.2, 0.9, 1.0]) @ [[1.0, 0.3, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]
    flat = np.diag([1.2, 0.9]) @ [[1.0, 0.3], [0.0, 1.0]]
    largest = np.linalg.svd(flat, compute_uv=False)[0]
    moved = replace(built, faces=shape.built[corners] @ pulled.T)
    assert face_strains(shape, moved) == pytest.approx((largest**2 - 1) / 2, rel=1e-9)
    still = replace(built, faces=shape.built[corners])
    assert face_strains(shape, still) == pytest.approx(0, abs=1e-7)


def test_the_largest_strain_of_faces_is_that_of_the_membrane(reference_run, shape):
    peak = max(
        (peak for peak in strain_peaks(reference_run) if peak.kind == "membranes"), key=lambda item: abs(item.strain)
    )
    strains = face_strains(shape, surface_at(reference_run, shape, peak.time))
    assert strains.max() == pytest.approx(peak.strain, rel=0.01)
