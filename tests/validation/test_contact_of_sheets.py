"""Contact of plates against closed forms: rebound, touching angle, height of a stack, and order of convergence."""

import math

import numpy as np
import pytest

import forficula as ff
from forficula.analysis.contact_overlap import contact_overlap
from tests.plate_sheets import LENGTH, stage, strip

THICK = 1e-3
PUSH = [{"name": "push", "kind": "torque", "of": "creases", "value": "0.02 N m"}]


def thrown(ratio, step):
    """Run of a panel that a torque throws against another, without a torque at the impact."""
    stages = [stage(until="time", drive="push", limit=1.2e-3), stage(until="time", limit=0.045)]
    return ff.run(
        strip(
            stages=stages,
            drive=PUSH,
            **{
                "protocol.contact": True,
                "protocol.timestep": step,
                "protocol.sample_interval": 1e-3,
                "crease.start": math.radians(177.5),
                "contact.time_constant": 1e-3,
                "contact.damping_ratio": ratio,
            },
        ),
        confirm=False,
    )


def rebound(record):
    """Speed after the impact divided by the speed before it."""
    kinetic, work = record.series["kinetic_energy"], record.series["contact_work"]
    before = int(np.flatnonzero(work < 0)[0]) - 1
    return math.sqrt(kinetic[-1] / kinetic[before])


@pytest.mark.parametrize("ratio", [1.0, 0.5, 0.2])
def test_the_rebound_of_a_panel_is_that_of_a_spring_and_a_damper(ratio, agree):
    # Schwager and Poeschel 2007, doi 10.1007/s10035-007-0065-z: the contact ends where the force is 0
    root = math.sqrt(1 - ratio**2)
    expected = math.exp(-2 * ratio / root * math.atan2(root, ratio)) if root else math.exp(-2)
    agree(
        f"rebound of a panel, damping ratio {ratio:g}",
        rebound(thrown(ratio, 1e-5)),
        expected,
        unit="1",
        by="spring and damper that never pull",
        abs=0.02,
    )


def pressed(step):
    """Angle of a panel 2 ms after a torque begins to press it against another, which it touches from the start."""
    values = {
        "protocol.contact": True,
        "protocol.timestep": step,
        "protocol.sample_interval": 1e-3,
        "crease.start": math.pi - math.asin(THICK / LENGTH),
        "contact.time_constant": 1e-3,
    }
    stages = [stage(until="time", drive="push", limit=2e-3)]
    return ff.run(strip(stages=stages, drive=PUSH, **values), confirm=False).series["hinge_angle"][-1, 0]


def test_contact_converges_with_the_first_power_of_the_timestep(agree):
    angles = [pressed(step) for step in (4e-5, 2e-5, 1e-5)]
    order = math.log2(abs(angles[0] - angles[1]) / abs(angles[1] - angles[2]))
    agree("order of convergence of contact", order, 1, unit="1", by="semi-implicit Euler", abs=0.15)


@pytest.fixture(scope="module")
def stack():
    """Run of a zigzag of four panels that a torque closes."""
    push = [{"name": "push", "kind": "torque", "of": "creases", "value": "0.02 N m", "rise": "2 ms"}]
    values = {
        "protocol.contact": True,
        "protocol.timestep": 5e-5,
        "protocol.sample_interval": 1e-3,
        "crease.start": math.radians(178),
        "crease.damping": 0.02,
    }
    stages = [stage(until="time", drive="push", limit=0.03)]
    return ff.run(strip(4, letters="VM", stages=stages, drive=push, **values), confirm=False)


def test_panels_at_a_crease_touch_at_the_angle_at_which_their_ends_are_a_thickness_apart(stack, agree):
    angles = np.degrees(stack.series["hinge_angle"][-1])
    expected = 180 - math.degrees(math.asin(THICK / LENGTH))
    agree("fold angles of touching panels", angles, expected, unit="deg", by="180 deg - asin(t / L)", abs=0.03)


def test_a_zigzag_stack_is_half_as_many_thicknesses_high_as_it_has_panels(stack, agree):
    height = np.ptp(stack.series["point_position"][-1][:, 2])
    agree("height of the middle surfaces of four panels", 1e3 * height, 2, unit="mm", by="2 t", abs=0.03)
    assert contact_overlap(stack).largest < 0.1
    assert ff.measure(stack).energy_balance.residual < 0.005
