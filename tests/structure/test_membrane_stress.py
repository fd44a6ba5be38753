"""Strains and stresses of membranes against closed forms."""

import numpy as np
import pytest

from forficula.structure import MembraneLaw
from forficula.structure.membrane_stress import principal_strains, principal_stresses

LAW = MembraneLaw(youngs_modulus=2e6, poisson_ratio=0.3, thickness=1e-4, damping=0.0)
CORNERS = np.array([[[0.0, 0, 1], [1, 0.2, 1], [0.1, 1, 1.5]]])


def test_a_sheet_stretched_equally_in_all_directions_has_the_stress_of_the_closed_form():
    strain = principal_strains(CORNERS, 1.1 * CORNERS)
    green = (1.1**2 - 1) / 2
    assert strain == pytest.approx(green)
    # plane stress: S = E e / (1 - nu)
    assert principal_stresses(LAW, strain) == pytest.approx(2e6 * green / 0.7)


def test_a_sheet_in_uniaxial_stress_contracts_by_poisson_s_ratio():
    strain = np.array([-0.3 * 0.01, 0.01])
    assert principal_stresses(LAW, strain) == pytest.approx([0, 2e6 * 0.01], abs=1e-6)
