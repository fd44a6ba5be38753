import math

import mujoco
import numpy as np
import pytest

from forficula.design import load_design, scale_design
from forficula.dynamics import compile_model, with_timestep
from forficula.structure import hinges_of
from forficula.study.running.runs import run
from tests.places import places


@pytest.fixture(scope="module")
def wing():
    return compile_model(load_design("binder2025"))


def ring_hinges(wing):
    return list(hinges_of(wing.structure, "ring"))


def placed(wing, data, role):
    """Return the points of a role in a state of the engine, m, (point, 3)."""
    points = [number for number, point in enumerate(wing.structure.points) if point.role == role]
    at_origin = wing.sites[points] < 0
    if at_origin.all():
        return wing.units.length * data.xpos[wing.carriers[points]]
    assert not at_origin.any()
    return wing.units.length * data.site_xpos[wing.sites[points]]


def test_bars_weigh_what_petg_cylinders_weigh(wing):
    # density times length times the area of a circle, by hand
    proximal, distal = (1270 * length * math.pi / 4 * 0.005**2 for length in (0.12, 0.10))
    assert [body.role for body in wing.structure.bodies] == ["proximal", "distal"] * 3
    masses = [wing.units.mass * wing.engine.body(body.name).mass[0] for body in wing.structure.bodies]
    np.testing.assert_allclose(masses, [proximal, distal] * 3, rtol=1e-12)


def test_the_flat_wing_lies_where_the_pattern_does(wing):
    data = mujoco.MjData(wing.engine)
    mujoco.mj_forward(wing.engine, data)
    hub, ring, tips = (placed(wing, data, role) for role in ("hub", "ring", "tip"))
    # straight from the numbers of the design: lengths of the bars and Pythagoras at the hub
    np.testing.assert_allclose(np.linalg.norm(ring - hub, axis=1), 0.12, rtol=1e-12)
    np.testing.assert_allclose(np.linalg.norm(tips - ring, axis=1), 0.10, rtol=1e-12)
    np.testing.assert_allclose(np.linalg.norm(ring, axis=1), math.hypot(0.12, 0.015), rtol=1e-12)
    np.testing.assert_allclose(np.linalg.norm(hub, axis=1), 0.015, rtol=1e-12)


def test_a_vein_folded_by_180_deg_comes_back_beside_itself_at_the_sector_angle(wing):
    # flat-folded degree-4 vertex: one sector angle between distal and proximal crease (Kawasaki)
    data = mujoco.MjData(wing.engine)
    data.qpos[ring_hinges(wing)] = -math.pi * wing.folds.senses[ring_hinges(wing)]
    mujoco.mj_forward(wing.engine, data)
    hub, ring, tips = (placed(wing, data, role) for role in ("hub", "ring", "tip"))
    back, distal = hub - ring, tips - ring
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


YIELDING = {"tendon.area": "12.5 mm^2", "tendon.law": "tpu-95a", "tendon.law.yield_strain": "40 %"}


@pytest.mark.parametrize(
    ("name", "keys", "viewers"),
    [
        ("letter-fold", {}, "MuJoCo 3.9 or later"),
        ("binder2025-joint", {}, "MuJoCo 3.9 or later"),
        ("binder2025", {}, "MuJoCo 4.0 or later: earlier versions stretch membranes differently"),
        ("binder2025-joint", YIELDING, "MuJoCo 4.0 or later: in earlier versions no tendon yields"),
        ("binder2025-built", {}, "layout only: creases or drag are updated outside the engine between steps"),
        ("miura-sheet", {}, "layout only: creases or drag are updated outside the engine between steps"),
    ],
)
def test_the_model_file_names_the_viewers_that_show_the_same_motion(name, keys, viewers):
    spec = mujoco.MjSpec.from_string(compile_model(with_timestep(load_design(name, keys))).xml)
    assert {text.name: text.data for text in spec.texts}["viewers"].rstrip("\0") == viewers


def test_a_wing_a_hundredth_of_the_size_still_compiles():
    small = compile_model(scale_design(load_design("binder2025"), 0.01))
    # in SI its smallest inertia is far below MuJoCo's minimum of 1e-15 kg m^2
    smallest = small.engine.body_inertia[1:].min() * small.units.mass * small.units.length**2
    assert smallest < 1e-15
    assert small.engine.body_inertia[1:].min() > 1e-9


def test_gravity_pulls_the_flat_wing_down_and_is_in_the_energy_balance():
    short = {
        "protocol.gravity": "9.81 m/s^2",
        "protocol.stages": [
            {"name": "fall", "drive": "none", "until": "time", "hold": "0 s", "time_limit": "50 ms"},
        ],
    }
    record = run(load_design("binder2025", short))
    series = record.data["gravitational_energy"].values
    assert series[-1] < series[0]
    # m g h by hand: the mean height of a bar is that of its centre
    proximal, distal = (1270 * length * math.pi / 4 * 0.005**2 for length in (0.12, 0.10))
    height = np.stack([places(record, role)[:, :, 2] for role in ("hub", "ring", "tip")], axis=2)
    middle = (height[:, :, :-1] + height[:, :, 1:]) / 2
    expected = 9.81 * np.sum(middle * [proximal, distal], axis=(1, 2))
    np.testing.assert_allclose(series, expected, rtol=1e-9, atol=1e-12)


def test_distal_bars_touch_only_where_contact_is_switched_on():
    touching = compile_model(load_design("binder2025", {"protocol.contact": True}))
    free = compile_model(load_design("binder2025"))
    contacts = []
    for wing in (touching, free):
        data = mujoco.MjData(wing.engine)
        # sweep the first vein by its sector angle: its distal bar then lies on its neighbour's
        data.qpos[hinges_of(wing.structure, "sweep")[0]] = math.radians(20)
        mujoco.mj_forward(wing.engine, data)
        contacts.append(data.ncon)
    assert contacts[0] > 0
    assert contacts[1] == 0
