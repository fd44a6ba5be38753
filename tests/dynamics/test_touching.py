"""Touching bars and panels, compared with closed forms: one diameter, one thickness, momentum, Coulomb friction."""

import math
from dataclasses import replace

import mujoco
import numpy as np
import pytest

import forficula as ff
from forficula.analysis.crossing_panels import panel_crossing
from forficula.dynamics import compile_model, compile_structure
from forficula.dynamics.engine.units import ModelUnits
from forficula.structure import (
    GROUND,
    Bar,
    Body,
    Contact,
    Hinge,
    Membrane,
    MembraneLaw,
    Point,
    Stops,
    Structure,
    Surface,
    hinges_of,
)

THICK, LENGTH = 0.1, 2.0  # of bars, in a model's units
STEP = 1e-3
STOPS = Stops(time_constant=2 * STEP)
ONE = ModelUnits(length=1.0, mass=1.0, time=1.0)
DOWN = 10.0


def engine_of(reference, **parts):
    """Return the compiled model of a structure in its own units."""
    built = Structure(name="bars", span=1.0, mass=1.0, **parts)
    design = ff.design.with_values(reference, {"protocol.timestep": STEP})
    return compile_structure(design, built, built, ONE).engine


def body(name, position=(0, 0, 0)):
    return Body(name=name, role=name, parent=GROUND, position=np.array(position, float), frame=np.eye(3))


def bar(number, end, overlaps=0.0):
    return Bar(body=number, end=np.array(end, float), diameter=THICK, density=100.0, points=(0, 0), overlaps=overlaps)


def turning(number, axis, **more):
    return Hinge(name=f"turn{number}{axis.index(1)}", role="turn", body=number, axis=np.array(axis, float), **more)


def resting_bar(reference, friction):
    """Return a swivelling bar that rests on a fixed one, 1 from the swivel; level where their axes are one
    diameter apart."""
    return engine_of(
        reference,
        bodies=(body("fixed", (1, -LENGTH / 2, 0)), body("loose", (0, 0, THICK))),
        points=(Point(name="p", role="p", body=0, place=np.zeros(3)),),
        bars=(bar(0, (0, LENGTH, 0)), bar(1, (LENGTH, 0, 0))),
        hinges=(turning(1, (0, 0, 1)), turning(1, (0, 1, 0), damping=3.0)),
        contact=Contact(thickness=THICK, friction=friction, stops=STOPS),
        gravity=DOWN,
    )


def test_a_bar_that_falls_on_another_stops_at_one_diameter(reference):
    engine = resting_bar(reference, 0.0)
    data = mujoco.MjData(engine)
    data.qpos[1] = -0.3
    for _ in range(4000):
        mujoco.mj_step(engine, data)
    # at a distance of 1, it rests at the contact's depth: within 2 % of the diameter
    assert 0 <= math.sin(data.qpos[1]) < 0.02 * THICK
    assert abs(data.qvel[1]) < 1e-9


@pytest.mark.parametrize("friction", [0.0, 0.2, 0.5])
def test_friction_takes_its_coefficient_times_the_normal_force(reference, friction):
    engine = resting_bar(reference, friction)
    engine.opt.timestep = STEP / 10
    data, torque, forces, force = mujoco.MjData(engine), 20.0, [], np.zeros(6)
    data.qfrc_applied[0] = torque
    for _ in range(3500):
        mujoco.mj_step(engine, data)
        force[:] = 0
        if data.ncon:
            mujoco.mj_contactForce(engine, data, 0, force)
        # the other bar is at a distance of 1, at right angles to this one's first direction
        forces.append((force[0], math.hypot(force[1], force[2]), 1 / math.cos(data.qpos[0])))
    normal, along, out = np.array(forces).T
    np.testing.assert_allclose(along, friction * normal, rtol=1e-6, atol=1e-9)
    mass = 100 * math.pi / 4 * THICK**2 * LENGTH
    inertia = mass * (LENGTH**2 / 3 + THICK**2 / 16)
    # it bounces as it starts to slide; its mean moment is half of the bar's weight times its length
    assert (normal * out).mean() == pytest.approx(mass * DOWN * LENGTH / 2, rel=0.07)
    held_back = friction * (normal * out).mean()
    assert data.qvel[0] == pytest.approx((torque - held_back) / inertia * data.time, rel=2e-3)


def test_a_small_push_does_not_overcome_friction(reference):
    engine = resting_bar(reference, 0.5)
    data = mujoco.MjData(engine)
    for _ in range(3000):
        mujoco.mj_step(engine, data)
    start = data.qpos[0]
    mass = 100 * math.pi / 4 * THICK**2 * LENGTH
    data.qfrc_applied[0] = 0.5 * 0.5 * mass * DOWN * LENGTH / 2
    for _ in range(500):
        mujoco.mj_step(engine, data)
    # free, it would turn by 4 rad
    assert abs(data.qpos[0] - start) < 1e-7
    assert abs(data.qvel[0]) < 1e-12


def test_bars_that_meet_keep_their_momentum_and_a_diameter(reference):
    """Two bars on one axis, solid beyond a distance from it, meet where these points are one diameter apart."""
    begins = 0.6
    engine = engine_of(
        reference,
        bodies=(body("one"), body("other")),
        points=(Point(name="p", role="p", body=0, place=np.zeros(3)),),
        bars=(bar(0, (LENGTH, 0, 0), begins), bar(1, (1.5, 0, 0), begins)),
        hinges=(turning(0, (0, 0, 1)), turning(1, (0, 0, 1))),
        contact=Contact(thickness=THICK, stops=STOPS),
    )
    inertias = [100 * math.pi / 4 * THICK**2 * length * (length**2 / 3 + THICK**2 / 16) for length in (LENGTH, 1.5)]
    data = mujoco.MjData(engine)
    data.qpos[:], data.qvel[:] = [0.0, 1.0], [2.0, -1.0]
    momentum, nearest = np.dot(inertias, data.qvel), np.inf
    for _ in range(1000):
        mujoco.mj_step(engine, data)
        nearest = min(nearest, data.qpos[1] - data.qpos[0])
        assert np.dot(inertias, data.qvel) == pytest.approx(momentum, rel=1e-12)
    # they met at 3 rad/s, and separate slightly
    assert 0 <= data.qvel[1] - data.qvel[0] < 0.1 * 3
    expected = 2 * math.asin(THICK / 2 / begins)
    # the penetration is less than the travel of a step
    assert expected - 3 * STEP < nearest < expected


def strip(number, sides):
    """Return a rectangle on a body: strips along y between these values of x, two triangles each."""
    places = np.array([[x, y, 0.0] for x in sides for y in (0.0, 1.0)])
    first = 2 * np.arange(len(sides) - 1)[:, None]
    triangles = np.concatenate([first + np.array(corners) for corners in ([0, 2, 3], [0, 3, 1])])
    surface = Surface(
        bodies=np.full(len(places), number),
        places=places,
        triangles=triangles,
        panels=np.zeros(len(triangles), dtype=np.int64),
        names=(f"panel {number}",),
    )
    law = MembraneLaw(youngs_modulus=1.0, poisson_ratio=0.3, thickness=0.01, damping=0.0)
    return Membrane(
        name=f"panel{number}",
        bodies=surface.bodies,
        places=places,
        built=places,
        triangles=triangles,
        law=law,
        margin=0.0,
        surface=surface,
    )


def test_panels_that_fold_on_each_other_end_one_thickness_apart(reference):
    """Panels on a common hinge line, one solid beyond a distance c from it: c sin(angle) is the thickness."""
    thickness, beside = 0.02, 0.2
    lid = strip(1, (0.0, beside, 1.0))
    floor = strip(0, (0.0, 1.1))
    common = replace(floor.surface, bodies=np.array([1, 1, 0, 0]))  # the common line is on both
    engine = engine_of(
        reference,
        bodies=(body("floor"), body("lid")),
        points=(Point(name="p", role="p", body=0, place=np.zeros(3)),),
        bars=(bar(1, (0.0, 1.0, 0)),),
        hinges=(turning(1, (0, 1, 0), damping=2.0, armature=1.0),),
        membranes=(replace(floor, surface=common), lid),
        contact=Contact(thickness=thickness, stops=STOPS),
    )
    data = mujoco.MjData(engine)
    data.qpos[0] = -0.5
    data.qfrc_applied[0] = 0.5
    for _ in range(8000):
        mujoco.mj_step(engine, data)
    assert beside * math.sin(-data.qpos[0]) == pytest.approx(thickness, rel=0.02)


@pytest.fixture(scope="module")
def folded_by_contact():
    """Return the reference wing folded without waiting, its panels in contact."""
    stages = [
        {"name": "settle", "drive": "none", "until": "time", "hold": "0 s", "time_limit": "0.1 s"},
        {"name": "fold", "drive": "fold", "until": "folded", "hold": "0 s", "time_limit": "0.2 s"},
    ]
    values = {"protocol.contact": True, "protocol.timestep": "0.05 ms", "protocol.stages": stages}
    return ff.run(ff.load_design("binder2025", values), confirm=False)


def test_a_fast_fold_lets_panels_through_by_less_than_three_millimetres(folded_by_contact):
    rows = range(0, len(folded_by_contact.time), 2)
    assert np.degrees(folded_by_contact.angles("ring").min()) < -120
    assert panel_crossing(folded_by_contact, rows).depth < 3e-3


def test_the_work_of_contacts_is_separate_from_that_of_stops(folded_by_contact, reference_run):
    series = folded_by_contact.series
    balance = ff.measure(folded_by_contact).energy_balance
    assert balance.residual < 0.005
    assert balance.contacts == pytest.approx(-series["contact_work"][-1])
    assert balance.contacts > 0.05
    # nothing touches while the flat wing settles, so stops act as without contact
    settled = int(np.searchsorted(folded_by_contact.time, 0.1))
    assert np.all(series["contact_work"][: settled + 1] == 0)
    assert series["stop_work"][settled] != 0
    assert "contact_work" not in reference_run.series
    assert ff.measure(reference_run).energy_balance.contacts is None


def test_a_slow_fold_lets_nothing_through():
    """Damping is 300 times the reference's, with a tendon that pulls along nearly the whole fold."""
    stages = [
        {"name": "settle", "drive": "none", "until": "time", "hold": "0 s", "time_limit": "10 ms"},
        {"name": "fold", "drive": "fold", "until": "folded", "hold": "0 s", "time_limit": "3 s"},
    ]
    values = {
        "protocol.contact": True,
        "protocol.timestep": "0.05 ms",
        "hinge.damping": "0.3 N m s/rad",
        "hinge.overbend": "1 deg",
        "protocol.initial_overbend": "0.7 deg",
        "tendon.rest_length": "3 cm",
        "protocol.stages": stages,
    }
    record = ff.run(ff.load_design("binder2025", values), confirm=False)
    fold = ff.measure(record).transitions["fold"]
    assert fold.succeeded
    assert fold.time > 1.0
    assert panel_crossing(record).depth <= 0.1e-3


def test_bars_touch_their_neighbours_from_the_membrane_on_without_friction():
    wing = compile_model(ff.load_design("binder2025", {"protocol.contact": True}))
    data = mujoco.MjData(wing.engine)
    mujoco.mj_forward(wing.engine, data)
    assert data.ncon == 0
    # the first vein is swept onto the next one, so the proximal bars coincide, too
    data.qpos[hinges_of(wing.structure, "sweep")[0]] = math.radians(12)
    mujoco.mj_forward(wing.engine, data)
    touching = {tuple(sorted(wing.engine.geom_bodyid[list(item.geom)])) for item in data.contact if item.geom[0] >= 0}
    names = {tuple(wing.engine.body(number).name for number in pair) for pair in touching}
    assert ("proximal0", "proximal1") in names
    assert {item.dim for item in data.contact} == {1}
    rubbing = compile_model(ff.load_design("binder2025", {"protocol.contact": True, "contact.friction": 0.3}))
    data = mujoco.MjData(rubbing.engine)
    data.qpos[hinges_of(wing.structure, "sweep")[0]] = math.radians(12)
    mujoco.mj_forward(rubbing.engine, data)
    assert {(item.dim, item.friction[0]) for item in data.contact} == {(3, 0.3)}


def test_a_contact_without_a_section_has_the_documented_time_constant_in_the_units_of_the_model():
    silent = ff.load_design("binder2025", {"protocol.contact": True})
    stated = silent.with_values({"contact.time_constant": "0.4 ms"})
    for design in (silent, stated):
        model = compile_model(design)
        for kinds, solref in (("geom_contype", "geom_solref"), ("flex_contype", "flex_solref")):
            touching = getattr(model.engine, kinds) != 0
            assert touching.any()
            assert getattr(model.engine, solref)[touching, 0] * model.units.time == pytest.approx(4e-4)


@pytest.mark.parametrize("units", [1, 3])
def test_panels_that_contact_would_push_apart_as_built_are_refused(units):
    """Nothing touches in the flat fan up to the thickness in the message; beyond, contact would add energy."""
    wing = ff.load_design("binder2025", {"protocol.contact": True, "pattern.units": units})
    with pytest.raises(ff.InputError, match=r"contact.thickness: .* need <= 3.632 mm, got 5 mm"):
        compile_model(wing.with_values({"contact.thickness": "5 mm"}))
    model = compile_model(wing.with_values({"contact.thickness": "3.63 mm"}))
    data = mujoco.MjData(model.engine)
    mujoco.mj_forward(model.engine, data)
    assert not data.ncon


def test_bars_that_overlap_up_to_their_ring_fold_touch_nothing_there():
    wing = compile_model(ff.load_design("binder2025", {"protocol.contact": True, "vein.diameter": "40.13 mm"}))
    data = mujoco.MjData(wing.engine)
    mujoco.mj_forward(wing.engine, data)
    assert not data.ncon
