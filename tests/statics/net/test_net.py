"""The parts of a net fit together, or an error names the field, the rule and the value."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.sparse import csr_array, eye_array

from forficula.errors import InputError
from forficula.statics.net.net import Springs
from tests.statics.net.nets import truss

NET = truss([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1], [1, 2]], stiffness=1.0)


@pytest.mark.parametrize(
    ("changed", "rule"),
    [
        ({"free": np.ones((2, 3), dtype=bool)}, r"net.free: need an array of shape \(3, 3\), got \(2, 3\)"),
        ({"nodes": np.full((3, 3), np.nan)}, "net.nodes: need finite coordinates"),
        ({"nodes": np.ones((3, 3))}, "net.nodes: need some that are apart"),
        ({"points": csr_array(2.0 * eye_array(3))}, "net.points: need weights that add up to 1, got 2"),
        ({"masses": np.ones(4)}, "net.masses"),
        (
            {"springs": Springs(points=np.array([[0, 3]]), stiffness=np.ones(1), rest_length=np.ones(1))},
            "net: need points between 0 and 2, got 0 to 3",
        ),
        (
            {"springs": Springs(points=np.array([[0, 1]]), stiffness=-np.ones(1), rest_length=np.ones(1))},
            "net.springs.stiffness: need finite numbers >= 0, got -1",
        ),
    ],
)
def test_what_does_not_fit_is_refused(changed, rule):
    with pytest.raises(InputError, match=rule):
        replace(NET, **changed)


def test_masses_may_be_lumped_or_a_matrix():
    matrix = csr_array(np.array([[2.0, 1.0, 0.0], [1.0, 2.0, 0.0], [0.0, 0.0, 1.0]]))
    np.testing.assert_array_equal(NET.mass_matrix.toarray(), np.eye(3))
    np.testing.assert_array_equal(replace(NET, masses=matrix).mass_matrix.toarray(), matrix.toarray())
