"""Springs of hinges: a pendulum about its rest angle has the period of the closed form and keeps its energy.

I phi'' = -k (phi - phi0): omega = sqrt(k / I). With a weight m g a that pulls towards phi = pi/2 the small swings about
the balance have k + m g a sin(phi) in its place.
"""

import math
from dataclasses import replace

import numpy as np
import pytest
from scipy.optimize import brentq

from forficula.dynamics import energy_balance, simulate
from forficula.structure.fans.veins import structure_of_veins
from tests.structures import compiled, straight_vein

STIFFNESS, REST = 0.05, math.radians(40)  # N m/rad; folding


def pendulum(one_hinge, *, stiffness=STIFFNESS, rest=REST, sense=1, **values):
    """Return a bar with a slack tendon on a sprung hinge; angles are > 0 when folding."""
    # the tendon's largest length
    hinge = one_hinge(0.11, **values)

    def build(design, units):
        vein = replace(straight_vein(design), sense=sense)
        structure = structure_of_veins(design, (vein,))
        (ring,) = structure.hinges
        sprung = replace(ring, stiffness=stiffness / units.energy, rest_angle=-rest)
        return replace(structure, hinges=(sprung,))

    return replace(hinge, wing=compiled(hinge.wing.design, build))


def period_of(times, away):
    """Return the period, from upward passages of the middle, interpolated between rows."""
    rows = np.flatnonzero((away[:-1] < 0) & (away[1:] >= 0))
    moments = times[rows] - away[rows] * (times[rows + 1] - times[rows]) / (away[rows + 1] - away[rows])
    return float(np.mean(np.diff(moments)))


@pytest.mark.parametrize("sense", [1, -1])
@pytest.mark.parametrize("stiffness", [0.01, 0.05, 0.5])
def test_a_pendulum_with_a_spring_has_the_period_of_the_closed_form(one_hinge, stiffness, sense):
    period = 2 * math.pi * math.sqrt(one_hinge().inertia / stiffness)
    hinge = pendulum(
        one_hinge,
        stiffness=stiffness,
        sense=sense,
        start=math.radians(20),
        timestep=period / 2000,
        duration=4.5 * period,
    )
    angles, record = hinge.run()
    # it swings as far past its rest angle as it was released before it
    assert (angles.min(), angles.max()) == pytest.approx((math.radians(20), math.radians(60)), abs=1e-3)
    # semi-implicit Euler: phase error of second order, (2 pi / 2000)^2 / 24
    assert period_of(record.time, angles - REST) == pytest.approx(period, rel=1e-6)


def test_the_recorded_energy_is_that_of_the_recorded_angle(one_hinge):
    angles, record = pendulum(one_hinge, start=math.radians(20), duration=0.05).run()
    energy = record.series["hinge_energy"]
    assert energy.shape == (len(angles), 1)
    # rounding
    assert energy[:, 0] == pytest.approx(STIFFNESS / 2 * (angles - REST) ** 2, abs=1e-15)
    assert record.data["hinge_energy"].attrs["units"] == "J"


def test_the_energy_balance_with_springs_closes_to_the_order_of_the_integrator(one_hinge):
    missing = []
    for timestep in (2e-4, 1e-4, 5e-5):
        _, record = pendulum(one_hinge, start=math.radians(20), timestep=timestep, duration=0.02).run()
        balance = energy_balance(record)
        assert balance.hinges == pytest.approx(-balance.kinetic, rel=0.02)
        assert balance.hinges < 0
        missing.append(abs(balance.missing / balance.hinges))
    assert np.polyfit(np.log([4, 2, 1]), np.log(missing), 1)[0] == pytest.approx(1, abs=0.2)
    assert missing[-1] < 5e-3


def test_a_bar_swings_about_where_its_weight_balances_its_spring(one_hinge):
    gravity = 9.81
    values = {"protocol.gravity": -gravity, "hinge.damping": 0.0}  # upward: towards folding
    plain = one_hinge(values=values)
    vein, reach = plain.wing.design.vein, plain.wing.design.pattern.distal_length
    weight = vein.density * math.pi * vein.diameter**2 / 4 * reach * gravity * reach / 2  # N m, when straight

    def moment(angle):
        return -STIFFNESS * (angle - REST) + weight * math.cos(angle)

    rest = brentq(moment, 0.0, 3.0)
    stiffness = STIFFNESS + weight * math.sin(rest)
    period = 2 * math.pi * math.sqrt(plain.inertia / stiffness)
    hinge = pendulum(
        one_hinge,
        start=rest - math.radians(0.2),
        timestep=period / 2000,
        duration=4.5 * period,
        values=values,
    )
    angles, record = hinge.run()
    # small swings: error of second order, (0.2 deg)^2
    assert period_of(record.time, angles - rest) == pytest.approx(period, rel=1e-4)
    balance = energy_balance(record)
    assert balance.hinges is not None
    assert balance.residual < 5e-3


def test_a_structure_without_springs_has_no_spring_terms(one_hinge):
    (record,) = simulate([one_hinge(duration=0.005).wing])
    assert "hinge_energy" not in record.series
    assert energy_balance(record).hinges is None
