"""Turning bodies: their positions and the forces between them, compared with the engine's."""

import math

import mujoco
import numpy as np
import pytest

from forficula.dynamics import compile_model, simulate
from forficula.dynamics.energies.crease_moments import Past
from forficula.dynamics.energies.creases import engine_rows
from forficula.dynamics.engine.crease_rows import crease_rows
from forficula.dynamics.engine.plate_angles import plate_angles
from forficula.dynamics.engine.plate_creases import plate_rows
from forficula.structure import flap_angles
from tests.plate_sheets import miura, plates, pleats, vertex

OPENS = 'stiffness = "1e-2 N m/rad/m"\nrest_angle = "20 deg"\nextension = "1e4 N/m^2"\nextension_damping = "0 N s/m^2"'
# a fixed plate, one hinged to it, and a free one
MIXED = f'[[support]]\nof = "facet 0"\n[[crease.group]]\nof = "crease 1"\n{OPENS}'
SHEETS = {
    "free": plates(vertex([87.5] * 4), crease=OPENS),
    "mixed": plates(pleats(4, "VMV"), more=MIXED, crease='back_limit = "180 deg"'),
}


@pytest.fixture(params=SHEETS)
def moved(request):
    """Return a model, and its data in a state in which every body is displaced and turns."""
    model = compile_model(SHEETS[request.param])
    data, draw = mujoco.MjData(model.engine), np.random.default_rng(1)
    mujoco.mj_integratePos(model.engine, data.qpos, draw.normal(scale=0.2, size=model.engine.nv), 1.0)
    data.qvel[:] = draw.normal(size=model.engine.nv)
    mujoco.mj_forward(model.engine, data)
    return model, data


def test_bodies_are_where_the_engine_has_them_and_move_as_there(moved):
    model, data = moved
    placement = model.folds.placement
    assert (placement.position_count, placement.velocity_count) == (model.engine.nq, model.engine.nv)
    pose = placement.poses(data.qpos)
    names = [body.name for body in model.structure.bodies]
    for number, name in enumerate(names):
        body = data.body(name)
        np.testing.assert_allclose(pose.origins[number], body.xpos, atol=1e-12)
        np.testing.assert_allclose(pose.frames[number].ravel(), body.xmat, atol=1e-12)
    moves, turns = placement.rates(pose, data.qvel)
    for number, name in enumerate(names):
        velocity = np.zeros(6)
        kind, body = mujoco.mjtObj.mjOBJ_XBODY, model.engine.body(name).id
        mujoco.mj_objectVelocity(model.engine, data, kind, body, velocity, 0)
        np.testing.assert_allclose(turns[number], velocity[:3], atol=1e-12)
        np.testing.assert_allclose(moves[number], velocity[3:], atol=1e-12)


def test_the_parts_of_an_angle_are_that_angle_and_its_slope_is_that_of_differences(moved):
    model, data = moved
    folds, nudge = model.folds, 1e-6
    np.testing.assert_allclose(plate_angles(folds.corners(data.qpos)).angles, flap_angles(folds.corners(data.qpos)))
    ends = []
    for step in (nudge, -nudge):
        position = data.qpos.copy()
        mujoco.mj_integratePos(model.engine, position, data.qvel, step)
        ends.append(folds.angles(position))
    slope = (ends[0] - ends[1]) / (2 * nudge)
    np.testing.assert_allclose(folds.travel(data.qpos, data.qvel), slope, rtol=1e-6, atol=1e-8)


def test_the_engine_pushes_by_the_slope_of_the_energy_of_creases(moved):
    """Compare with differences of k (angle - rest)^2 / 2 and of the springs, for skew creases."""
    model, data = moved
    rows = plate_rows([model])
    near = model.folds.angles(data.qpos)[model.folds.creases][None]
    rest = np.zeros_like(data.qvel)
    past = Past(angles=near, memory=np.zeros((1, *near.shape)), elapsed=np.zeros((1, 1)), block=np.zeros((1, 1)))
    *_, values = rows.follow(data.qpos[None], rest[None], np.zeros((1, 0)), past)
    engine_rows(model.engine)[rows.rows] = values[0]
    # a state at rest: no damping
    data.qvel[:] = 0
    mujoco.mj_forward(model.engine, data)
    force = data.qfrc_passive.copy()

    def energy(shift):
        position = data.qpos.copy()
        mujoco.mj_integratePos(model.engine, position, shift, 1.0)
        other = mujoco.MjData(model.engine)
        other.qpos[:] = position
        mujoco.mj_forward(model.engine, other)
        angles = model.folds.angles(position)[model.folds.creases]
        return other.energy[0] + float(model.creases.law.energy(angles, np.zeros_like(angles)).sum())

    slopes = [(energy(1e-6 * unit) - energy(-1e-6 * unit)) / 2e-6 for unit in np.eye(model.engine.nv)]
    np.testing.assert_allclose(force, -np.array(slopes), rtol=1e-5, atol=1e-7 * np.abs(force).max())


def test_nodes_that_only_slide_have_no_placement():
    model = compile_model(plates(vertex([90] * 4, "VVVM", "20 deg"), facet='kind = "bars"'))
    assert model.folds.placement is None
    assert crease_rows([model]) is not None


def test_structures_side_by_side_are_separate_runs_to_the_last_bit():
    stages = [{"name": "swing", "limit": "20 ms"}]
    designs = [
        plates(vertex([sector] * 4), crease=OPENS, stages=stages, step="0.1 ms", sample="1 ms")
        for sector in (87.5, 86.0, 88.0)
    ]
    models = [compile_model(design) for design in designs]
    for record, model in zip(simulate(models), models, strict=True):
        (alone,) = simulate([model])
        for name, values in record.series.items():
            np.testing.assert_array_equal(values, alone.series[name], err_msg=name)


def test_a_hinged_plate_starts_at_the_angle_at_which_it_is_built():
    model = compile_model(plates(vertex([60, 90, 120, 90], "VVVM", "30 deg"), crease='back_limit = "180 deg"'))
    data = mujoco.MjData(model.engine)
    mujoco.mj_forward(model.engine, data)
    starts = [hinge.sense * hinge.start for hinge in model.structure.hinges]
    assert data.qpos == pytest.approx(starts, abs=1e-12)
    assert max(map(abs, starts)) == pytest.approx(math.radians(30), rel=0.6)
    # closed as built: no constraint is violated
    assert np.abs(data.efc_pos).max() < 1e-9


def test_sheets_with_loops_give_the_same_bits_side_by_side_and_sparse():
    """Also at stops, whose work is separated step by step."""
    drive = '[[drive]]\nname = "fold"\nkind = "torque"\nof = "creases"\nvalue = "2e-3 N cm"\nrise = "20 ms"'
    crease = 'stiffness = "1e-3 N m/rad/m"\ndamping = "1e-5 N m s/rad/m"\nfold_limit = "60 deg"'
    stages = [{"name": "fold", "drive": "fold", "limit": "80 ms"}, {"name": "release", "limit": "30 ms"}]
    models = [
        compile_model(plates(miura(2, fold), crease=crease, more=drive, stages=stages, step="0.1 ms"))
        for fold in ("20 deg", "30 deg", "30 deg")
    ]
    for record, sparse, model in zip(simulate(models), simulate(models, sparse=True), models, strict=True):
        (alone,) = simulate([model])
        assert record.series["stop_work"][-1] < 0
        for name, values in record.series.items():
            np.testing.assert_array_equal(values, alone.series[name], err_msg=name)
            if name in sparse.series:
                np.testing.assert_array_equal(values[-1], sparse.series[name][-1], err_msg=name)
