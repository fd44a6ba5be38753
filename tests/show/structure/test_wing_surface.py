import numpy as np
import pytest

from forficula.design.places import mesh_rows
from forficula.show.structure.wing_surface import at_time, wing_surface


def test_between_two_samples_a_series_is_interpolated_and_outside_it_stays(reference_run):
    time, tips = reference_run.time, reference_run.series["vein_position"]
    middle = (time[400] + time[401]) / 2
    assert at_time(reference_run, "vein_position", middle) == pytest.approx((tips[400] + tips[401]) / 2, abs=1e-15)
    assert np.array_equal(at_time(reference_run, "vein_position", time[400]), tips[400])
    assert np.array_equal(at_time(reference_run, "vein_position", -1.0), tips[0])
    assert np.array_equal(at_time(reference_run, "vein_position", 1e6), tips[-1])


@pytest.mark.parametrize("row", [0, 310, 900, -1])
def test_the_surface_is_where_the_record_has_the_wing(reference_run, row):
    surface = wing_surface(reference_run, float(reference_run.time[row]))
    veins = reference_run.series["vein_position"][row]
    assert surface.veins == pytest.approx(veins, abs=1e-12)
    nodes = reference_run.series["membrane_position"][row]
    corners = surface.quads.reshape(-1, 3)
    for node in nodes:
        assert np.linalg.norm(corners - node, axis=1).min() < 1e-12
    # and, beside the nodes, on the veins: the strip between a vein and its margin is wing, too
    along = np.concatenate([mesh_rows(*vein, reference_run.design) for vein in veins[:-1]])
    known = np.concatenate([nodes, along])
    assert max(np.linalg.norm(known - corner, axis=1).min() for corner in corners) < 1e-12


def test_proximal_and_distal_quads_meet_at_the_ring_fold(reference_run):
    surface = wing_surface(reference_run, 0.3)
    ring = surface.veins[0, 1]
    nearest = [np.linalg.norm(surface.quads[part] - ring, axis=2).min() for part in (surface.distal, ~surface.distal)]
    assert nearest == pytest.approx([0, 0], abs=1e-12)
    assert surface.distal.sum() == (~surface.distal).sum() == len(surface.quads) / 2


def test_a_tendon_is_as_long_as_the_record_has_it(reference_run):
    for row in (0, 330, -1):
        surface = wing_surface(reference_run, float(reference_run.time[row]))
        lengths = np.linalg.norm(surface.tendons[:, 1] - surface.tendons[:, 0], axis=1)
        # the record's are of the engine's tendon, between sites on the same places
        assert lengths == pytest.approx(reference_run.series["tendon_length"][row], rel=1e-6)
