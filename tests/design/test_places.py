import numpy as np
import pytest

from forficula.design import load_design
from forficula.design.places import mesh_rows, tendon_ends
from forficula.pattern import hub_points, ring_vertices, tips

REFERENCE = load_design("binder2025")
FAN = REFERENCE.fan
VEINS = hub_points(FAN), ring_vertices(FAN), tips(FAN)


def test_the_ends_of_a_tendon_lie_on_the_bars_as_far_from_the_ring_fold_as_the_design_says():
    hub, ring, tip = VEINS
    before, beyond = tendon_ends(hub, ring, tip, REFERENCE)
    for end, far, distance in (
        (before, hub, REFERENCE.tendon.proximal_attachment),
        (beyond, tip, REFERENCE.tendon.distal_attachment),
    ):
        assert np.linalg.norm(end - ring, axis=-1) == pytest.approx(distance, rel=1e-12)  # a few roundings
        on_bar = np.linalg.norm(end - ring, axis=-1) + np.linalg.norm(end - far, axis=-1)
        assert on_bar == pytest.approx(np.linalg.norm(far - ring, axis=-1), rel=1e-12)


def test_the_rows_of_the_mesh_run_from_hub_to_tip_with_the_ring_fold_between():
    hub, ring, tip = (points[1] for points in VEINS)
    rows = mesh_rows(hub, ring, tip, REFERENCE)
    membrane = REFERENCE.membrane
    count = len(membrane.proximal_rows)
    assert rows.shape == (count + len(membrane.distal_rows) + 2, 3)
    assert rows[count] == pytest.approx(ring, abs=1e-15)  # m, one rounding
    assert rows[-1] == pytest.approx(tip, abs=1e-15)
    shares = np.linalg.norm(rows - hub, axis=1)[:count] / FAN.proximal_length
    assert shares == pytest.approx(membrane.proximal_rows, rel=1e-12)
