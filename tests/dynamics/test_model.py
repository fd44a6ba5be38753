import math

import mujoco
import numpy as np
import pytest

from forficula.design import load_design, scale_design
from forficula.dynamics import compile_wing
from forficula.study.runs import run


@pytest.fixture(scope="module")
def wing():
    return compile_wing(load_design("binder2025"))


def test_bars_weigh_what_petg_cylinders_weigh(wing):
    # density times length times the area of a circle, by hand
    proximal, distal = (1270 * length * math.pi / 4 * 0.005**2 for length in (0.12, 0.10))
    masses = wing.units.mass * wing.engine.body_mass[wing.bodies]
    np.testing.assert_allclose(masses, [[proximal, distal]] * 3, rtol=1e-12)


def test_the_flat_wing_lies_where_the_pattern_does(wing):
    data = mujoco.MjData(wing.engine)
    mujoco.mj_forward(wing.engine, data)
    ring = wing.units.length * data.xpos[wing.bodies[:, 1]]
    tips = wing.units.length * data.site_xpos[wing.tips]
    hub = wing.units.length * data.xpos[wing.bodies[:, 0]]
    # straight from the numbers of the design: lengths of the bars and Pythagoras at the hub
    np.testing.assert_allclose(np.linalg.norm(ring - hub, axis=1), 0.12, rtol=1e-12)
    np.testing.assert_allclose(np.linalg.norm(tips - ring, axis=1), 0.10, rtol=1e-12)
    np.testing.assert_allclose(np.linalg.norm(ring, axis=1), math.hypot(0.12, 0.015), rtol=1e-12)
    np.testing.assert_allclose(np.linalg.norm(hub, axis=1), 0.015, rtol=1e-12)


def test_a_vein_folded_by_180_deg_comes_back_beside_itself_at_the_sector_angle(wing):
    # flat-folded degree-4 vertex: the distal crease lies one sector angle beside the proximal one (Kawasaki)
    data = mujoco.MjData(wing.engine)
    data.qpos[wing.joints[:, 3]] = -math.pi * wing.senses
    mujoco.mj_forward(wing.engine, data)
    ring = data.xpos[wing.bodies[:, 1]]
    back, distal = data.xpos[wing.bodies[:, 0]] - ring, data.site_xpos[wing.tips] - ring
    cosines = np.sum(back * distal, axis=1) / np.linalg.norm(back, axis=1) / np.linalg.norm(distal, axis=1)
    np.testing.assert_allclose(np.degrees(np.arccos(cosines)), 20.0, atol=1e-9)


def test_the_model_file_compiles_to_the_wing_that_ran(wing):
    again = mujoco.MjModel.from_xml_string(wing.xml)
    for name in (
        "body_mass",
        "body_inertia",
        "jnt_range",
        "jnt_axis",
        "dof_damping",
        "dof_armature",
        "tendon_stiffness",
        "tendon_lengthspring",
        "tendon_range",
        "flex_stiffness",
        "flex_damping",
        "flex_vert",
        "actuator_gear",
    ):
        # MuJoCo writes six digits; the mesh's stiffness divides by differences of them
        expected = getattr(wing.engine, name)
        np.testing.assert_allclose(getattr(again, name), expected, rtol=2e-4, atol=1e-5 * np.abs(expected).max())
    assert again.opt.timestep * wing.units.time == pytest.approx(2e-4)


def test_a_wing_a_hundredth_of_the_size_still_compiles():
    small = compile_wing(scale_design(load_design("binder2025"), 0.01))
    # in SI its smallest inertia is far below what MuJoCo takes, 1e-15 kg m^2
    smallest = small.engine.body_inertia[1:].min() * small.units.mass * small.units.length**2
    assert smallest < 1e-15
    assert small.engine.body_inertia[1:].min() > 1e-9


def test_gravity_pulls_the_flat_wing_down_and_is_in_the_account():
    short = {
        "protocol.gravity": "9.81 m/s^2",
        "protocol.stages": [
            {"name": "fall", "drive": "none", "until": "time", "hold": "0 s", "time_limit": "50 ms"},
        ],
    }
    record = run(load_design("binder2025", short))
    series = record.data["gravitational_energy"].values
    assert series[-1] < series[0]
    # m g h by hand: the mean height of each bar is that of its middle
    proximal, distal = (1270 * length * math.pi / 4 * 0.005**2 for length in (0.12, 0.10))
    height = record.data["vein_position"].sel(axis="z").values
    middle = (height[:, :, :-1] + height[:, :, 1:]) / 2
    expected = 9.81 * np.sum(middle * [proximal, distal], axis=(1, 2))
    np.testing.assert_allclose(series, expected, rtol=1e-9, atol=1e-12)


def test_distal_bars_touch_only_where_contact_is_switched_on():
    touching = compile_wing(load_design("binder2025", {"protocol.contact": True}))
    free = compile_wing(load_design("binder2025"))
    contacts = []
    for wing in (touching, free):
        data = mujoco.MjData(wing.engine)
        # sweep the first vein by its sector angle: its distal bar then lies on its neighbour's
        data.qpos[wing.joints[0, 0]] = math.radians(20)
        mujoco.mj_forward(wing.engine, data)
        contacts.append(data.ncon)
    assert contacts[0] > 0
    assert contacts[1] == 0
