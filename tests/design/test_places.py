import numpy as np
import pytest

from forficula.design import load_design
from forficula.design.places import mesh_rows
from forficula.pattern import hub_points, ring_vertices, tips

REFERENCE = load_design("binder2025")
FAN = REFERENCE.fan
VEINS = hub_points(FAN), ring_vertices(FAN), tips(FAN)


def test_the_rows_of_the_mesh_run_from_hub_to_tip_with_the_ring_fold_between():
    hub, ring, tip = (points[1] for points in VEINS)
    rows = mesh_rows((hub, ring, tip), REFERENCE)
    membrane = REFERENCE.membrane
    count = len(membrane.proximal_rows)
    assert rows.shape == (count + len(membrane.distal_rows) + 2, 3)
    assert rows[count] == pytest.approx(ring, abs=1e-15)  # m, one rounding
    assert rows[-1] == pytest.approx(tip, abs=1e-15)
    shares = np.linalg.norm(rows - hub, axis=1)[:count] / FAN.proximal_length
    assert shares == pytest.approx(membrane.proximal_rows, rel=1e-12)
