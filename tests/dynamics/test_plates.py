"""Plates that swing, fold and come to rest, compared with closed forms and a minimum found without the simulator."""

import math

import mujoco
import numpy as np
import pytest
from scipy.optimize import minimize, minimize_scalar
from scipy.special import ellipk

from forficula.design import design_pattern, load_design, with_values
from forficula.dynamics import (
    compile_model,
    energy_balance,
    load_record,
    save_record,
    simulate,
    stable_timestep,
    with_timestep,
)
from forficula.pattern import CreasePattern, folded_coordinates, write_fold
from tests.plate_sheets import DENSITY, INERTIA, LENGTH, MASS, THICK, WIDTH, pushed, stage, strip

LETTER = load_design("letter-fold")


def run(design, **options):
    (record,) = simulate([compile_model(design)], **options)
    return record


def period(time, angle, about):
    """Return the mean time between rising passages of an angle, s."""
    away = angle - about
    rising = np.flatnonzero((away[:-1] < 0) & (away[1:] >= 0))
    at = time[rising] - away[rising] * (time[rising + 1] - time[rising]) / (away[rising + 1] - away[rising])
    assert len(at) > 3
    return float(np.diff(at).mean())


@pytest.mark.parametrize("letters", ["V", "M"])
def test_a_panel_swings_about_its_spring_as_a_pendulum_does(letters):
    """2 pi sqrt(I / k) at any amplitude: the spring is linear and the axis fixed."""
    stiffness, rest = 0.02, math.radians(50)
    by_length = stiffness / WIDTH
    values = {"crease.stiffness": by_length, "crease.rest_angle": rest, "crease.start": math.radians(120)}
    record = run(strip(letters=letters, **values))
    angle = record.measured("creases")[:, 0]
    assert angle.min() == pytest.approx(math.radians(-20), abs=1e-3)
    assert angle.max() == pytest.approx(math.radians(120), abs=1e-3)
    assert period(record.time, angle, rest) == pytest.approx(2 * math.pi * math.sqrt(INERTIA / stiffness), rel=1e-4)


def test_the_energy_of_a_swing_goes_from_the_spring_into_motion_and_back():
    record = run(strip(**{"crease.stiffness": 1 / 3, "crease.start": 1.0}))
    spring, motion = record.series["hinge_energy"].sum(axis=1), record.series["kinetic_energy"]
    assert spring[0] == pytest.approx(0.02 / 2, rel=1e-12)
    assert motion.max() == pytest.approx(0.01, rel=2e-3)
    # error of first order in the timestep, which does not grow
    np.testing.assert_allclose(spring + motion, 0.01, rtol=5e-3)
    balance = energy_balance(record)
    assert balance.hinges is not None
    assert balance.residual < 5e-3


def test_a_panel_hangs_and_swings_under_its_weight():
    """A physical pendulum: 4 sqrt(I / (m g d)) K(sin^2(a / 2)); it hangs at a mountain fold of 90 deg."""
    amplitude, gravity = math.radians(60), 9.81
    values = {"crease.start": math.pi / 2 - amplitude, "protocol.gravity": gravity}
    record = run(strip(letters="M", stages=[stage(limit=4.0)], **values))
    expected = 4 * math.sqrt(INERTIA / (MASS * gravity * LENGTH / 2)) * ellipk(math.sin(amplitude / 2) ** 2)
    angle = record.measured("creases")[:, 0]
    assert period(record.time, angle, math.pi / 2) == pytest.approx(expected, rel=1e-4)
    height = record.series["gravitational_energy"]
    assert np.ptp(height) == pytest.approx(MASS * gravity * LENGTH / 2 * (1 - math.cos(amplitude)), rel=1e-3)
    assert energy_balance(record).residual < 2e-3


def test_a_panel_comes_to_rest_where_tendon_and_spring_are_in_balance():
    """The minimum of k/2 (L - L0)^2 + c/2 (a - r)^2 with L by the law of cosines."""
    near, far, spring = 0.05, 0.03, 0.01
    tendon = {"name": "t", "from": "facet 0 at 0.5, 0.5", "to": "facet 1 at 0.3, 0.5", "damping": 0.5}
    tendon |= {"stiffness": 20.0, "rest_length": 0.04}
    values = {"crease.stiffness": spring / WIDTH, "crease.rest_angle": math.radians(20), "crease.start": 0.3}
    values |= {"tendon": [tendon], "crease.damping": 2e-3, "protocol.rest_speed": 1e-6, "protocol.window": 0.5}
    record = run(strip(stages=[stage("rest", limit=20.0, hold=0.5)], **values))

    def length(angle):
        return math.sqrt(near**2 + far**2 + 2 * near * far * math.cos(angle))

    def energy(angle):
        return 10.0 * max(length(angle) - 0.04, 0) ** 2 + spring / 2 * (angle - math.radians(20)) ** 2

    least = minimize_scalar(energy, bounds=(0, math.pi), method="bounded", options={"xatol": 1e-10})
    assert record.stages[0].at_rest
    assert least.x > math.radians(30)
    assert record.measured("creases")[-1, 0] == pytest.approx(least.x, abs=1e-6)
    assert record.series["tendon_length"][-1, 0] == pytest.approx(length(least.x), abs=1e-8)
    assert record.series["tendon_energy"][-1, 0] + record.series["hinge_energy"][-1, 0] == pytest.approx(
        least.fun, rel=1e-6
    )


def test_a_tendon_across_three_creases_rests_where_the_least_energy_is():
    """Four panels in a plane, as a chain of angles written out in this test."""
    spring, rests = 0.01, np.radians([30, -10, 40])
    tendon = {"name": "t", "from": "facet 0 at 0.2, 0.5", "to": "facet 3 at 0.7, 0.5", "damping": 1.0}
    tendon |= {"stiffness": 8.0, "rest_length": 0.12}
    groups = [{"of": f"crease {k}", "rest_angle": float(rest)} for k, rest in enumerate(rests)]
    values = {"crease.stiffness": spring / WIDTH, "crease.damping": 5e-3, "crease.group": groups}
    values |= {"tendon": [tendon], "protocol.rest_speed": 1e-5, "protocol.window": 0.5, "support": [{"of": "facet 1"}]}
    values |= {"measure": [{"name": "each", "kind": "fold-angle", "of": "creases"}]}
    record = run(strip(4, letters="VMV", stages=[stage("rest", limit=30.0, hold=0.5)], **values))

    def energy(angles):
        # valley positive: each crease turns the next panel upwards
        directions = np.cumsum([0.0, *angles])
        steps = np.array([0.8, 1, 1, 0.7]) * LENGTH
        end = steps @ np.column_stack([np.cos(directions), np.sin(directions)])
        fold_angles = angles * [1, -1, 1]
        return 4.0 * max(np.linalg.norm(end) - 0.12, 0) ** 2 + spring / 2 * np.sum((fold_angles - rests) ** 2)

    least = minimize(
        energy, rests * [1, -1, 1], method="Nelder-Mead", options={"xatol": 1e-9, "fatol": 1e-16, "maxiter": 5000}
    )
    assert record.stages[0].at_rest
    assert record.measured("each")[-1] == pytest.approx(least.x, abs=1e-5)


def test_a_drive_brings_creases_to_their_goal_and_its_work_is_in_the_energy_balance():
    record = run(LETTER)
    ends = {end.stage.name: end for end in record.stages}
    assert len(ends) == 5
    assert ends["close"].goal_time is not None
    last = {name: int(np.argmin(np.abs(record.time - end.end))) for name, end in ends.items()}
    angles = np.degrees(record.measured("creases"))
    assert angles[last["settle"]] == pytest.approx([-3, -3], abs=0.01)
    assert (angles[last["close"]] > 90).all()
    assert (angles[last["release closed"]] > 90).all()
    assert (angles[last["open"]] < 0).all()
    assert angles[last["release open"]] == pytest.approx([-3, -3], abs=0.01)
    balance = energy_balance(record)
    assert balance.work > 0.1
    assert balance.residual < 1e-4
    assert balance.hinges is not None
    # the outer edges meet in the folded letter; before, they are an A4 sheet apart
    assert record.measured("mouth")[0, 0] == pytest.approx(0.297, abs=1e-4)
    assert record.measured("mouth")[last["close"], 0] < 0.1


def test_a_closed_letter_rests_where_its_springs_and_tendons_are_in_balance():
    """Each crease of a letter by itself: tendon and spring, by the law of cosines, from the closed side."""
    record = run(with_values(LETTER, {"protocol.rest_speed": 1e-6, "protocol.stages.2.time_limit": 20.0}))
    near, far, spring = 0.5 * 0.099, 0.4 * 0.099, 2e-2 * 0.21

    def energy(angle):
        length = math.sqrt(near**2 + far**2 + 2 * near * far * math.cos(angle))
        return 25.0 * max(length - 0.05, 0) ** 2 + spring / 2 * angle**2

    least = minimize_scalar(energy, bounds=(1, math.pi), method="bounded", options={"xatol": 1e-10})
    at = int(np.argmin(np.abs(record.time - record.stages[2].end)))
    assert record.measured("creases")[at] == pytest.approx([least.x] * 2, abs=1e-6)


def test_the_work_of_a_torque_is_the_energy_of_the_moved_plates():
    """A constant torque alone gives I w^2 / 2 = T a."""
    drive = [{"name": "push", "kind": "torque", "of": "creases", "value": 1e-3}]
    record = run(strip(letters="M", drive=drive, stages=[stage("creases > 120 deg", "push")]))
    end = record.stages[0]
    assert end.goal_time == pytest.approx(math.sqrt(2 * math.radians(120) * INERTIA / 1e-3), rel=2e-3)
    assert record.series["kinetic_energy"][-1] == pytest.approx(record.work[-1], rel=1e-9)
    assert record.work[-1] == pytest.approx(1e-3 * record.measured("creases")[-1, 0], rel=1e-3)


def test_drives_that_share_creases_add_up():
    one = {"name": "one", "kind": "torque", "of": "crease 0", "value": 1e-3}
    every = {"name": "every", "kind": "torque", "of": "creases", "value": 5e-4}
    values = {"drive": [one, every], "support": [{"of": "facet 1"}]}
    both = run(strip(3, stages=[stage("time", ["one", "every"], 0.02)], **values))
    speed = np.diff(both.series["hinge_angle"], axis=0)[-1] / np.diff(both.time)[-1]
    by_name = dict(zip([hinge.name for hinge in both.structure.hinges], speed, strict=True))
    # T t / I on either side of the fixed panel
    assert by_name["crease0"] == pytest.approx(1.5e-3 * 0.02 / INERTIA, rel=1e-2)
    assert by_name["crease1"] == pytest.approx(5e-4 * 0.02 / INERTIA, rel=1e-2)


def test_a_goal_may_be_a_distance():
    """The free ends of three panels approach to less than 8 cm, whatever the model's units."""
    drive = [{"name": "push", "kind": "torque", "of": "creases", "value": 1e-3}]
    measure = [{"name": "gap", "kind": "distance", "from": "edge 2 at 0.5", "to": "edge 3 at 0.5"}]
    design = strip(3, drive=drive, measure=measure, stages=[stage("gap < 8 cm", "push")], support=[{"of": "facet 1"}])
    record = run(design)
    assert record.stages[0].goal_time is not None
    # both outer panels at the same angle a: gap = L (1 + 2 cos a)
    angle = math.acos((0.8 - 1) / 2)
    reached = int(np.argmin(np.abs(record.time - record.stages[0].goal_time)))
    assert record.measured("creases")[reached] == pytest.approx([angle] * 2, abs=0.02)
    assert record.measured("gap")[0, 0] == pytest.approx(0.3, abs=1e-9)


@pytest.mark.parametrize("held", [0, 2, 4])
def test_the_engine_puts_plates_where_the_pattern_folds_to(held):
    design = strip(5, letters="MVVM", support=[{"of": f"facet {held}"}])
    model, pattern = compile_model(design), design_pattern(design)
    sizes = np.radians([20, 50, 110, 170])
    signed = np.full(len(pattern.edges_assignment), np.nan)
    signed[:4] = sizes * [1 if letter == "V" else -1 for letter in pattern.edges_assignment[:4]]
    folded = folded_coordinates(pattern, signed, fixed_face=held)
    data = mujoco.MjData(model.engine)
    fold_angles = [sizes[int(hinge.name.removeprefix("crease"))] for hinge in model.structure.hinges]
    data.qpos[:] = model.folds.senses * fold_angles
    mujoco.mj_forward(model.engine, data)
    for number, point in enumerate(model.structure.points):
        place = data.xpos[model.carriers[number]] if model.sites[number] < 0 else data.site_xpos[model.sites[number]]
        vertex = int(point.name.partition("vertex")[2])
        assert model.units.length * place == pytest.approx(folded[vertex], abs=1e-9)


def cross_file(path):
    """Return a pattern file of a square facet with a chain of two facets on each side: a branching tree."""
    vertices, faces, edges, letters = [(0, 0), (1, 0), (1, 1), (0, 1)], [(0, 1, 2, 3)], [], []
    square = np.array(vertices, dtype=float)
    for side in range(4):
        one, other = (side + 1) % 4, (side + 2) % 4
        out = np.array([(1, 0), (0, 1), (-1, 0), (0, -1)][side])
        for step in (1, 2):
            count = len(vertices)
            vertices += [tuple(square[(side + 1) % 4] + step * out), tuple(square[(side + 2) % 4] + step * out)]
            faces.append((one, count, count + 1, other))
            edges += [(one, other), (one, count), (count + 1, other)]
            letters += ["V" if (side + step) % 2 else "M", "B", "B"]
            one, other = count, count + 1
        edges.append((one, other))
        letters.append("B")
    pattern = CreasePattern(
        vertices_coords=0.05 * np.column_stack([np.array(vertices, dtype=float), np.zeros(len(vertices))]),
        edges_vertices=np.array(edges),
        edges_assignment=tuple(letters),
        edges_fold_angle=np.full(len(edges), np.nan),
        faces_vertices=tuple(faces),
    )
    write_fold(pattern, path)
    return pattern


def test_hinges_of_a_tree_that_branches_are_in_the_order_of_the_engine(tmp_path):
    pattern = cross_file(tmp_path / "cross.fold")
    values = {"pattern.kind": "fold-file", "pattern.path": str(tmp_path / "cross.fold"), "support": [{"of": "facet 3"}]}
    design = with_values(LETTER, values | {"tendon": [], "measure": [], "drive": [], "protocol.stages": [stage()]})
    model = compile_model(design)
    names = [mujoco.mj_id2name(model.engine, mujoco.mjtObj.mjOBJ_JOINT, joint) for joint in range(model.engine.njnt)]
    assert names == [hinge.name for hinge in model.structure.hinges]
    assert len(names) == 8
    assert model.engine.body_mass[1:].sum() * model.units.mass == pytest.approx(9 * 1270 * 0.5e-3 * 0.05**2)
    data = mujoco.MjData(model.engine)
    rng = np.random.default_rng(5)
    fold_angles = rng.uniform(0, math.pi, 8)
    data.qpos[:] = model.folds.senses * fold_angles
    mujoco.mj_forward(model.engine, data)
    signed = np.full(len(pattern.edges_assignment), np.nan)
    for hinge, angle in zip(model.structure.hinges, fold_angles, strict=True):
        signed[int(hinge.name.removeprefix("crease"))] = hinge.sense * angle
    folded = folded_coordinates(pattern, signed, fixed_face=3)
    for number, point in enumerate(model.structure.points):
        place = data.xpos[model.carriers[number]] if model.sites[number] < 0 else data.site_xpos[model.sites[number]]
        assert model.units.length * place == pytest.approx(folded[int(point.name.partition("vertex")[2])], abs=1e-9)


def test_inertia_of_many_plates_is_that_of_the_engine_s_own_boxes():
    """The mass matrix of three panels agrees with that of boxes whose inertia the engine computes."""
    model = compile_model(strip(3, letters="VM"))
    unit = model.units
    box = '<geom type="box" size="{} {} {}" pos="{} {} 0" density="{}"/>'
    length, width, thick = (item / 2 / unit.length for item in (LENGTH, WIDTH, THICK))
    plate = box.format(length, width, thick, length, -width, DENSITY / unit.mass * unit.length**3)
    joint = '<joint axis="0 -1 0"/>'
    body = f'<body pos="{2 * length} 0 0">{joint}{plate}'
    xml = f"<mujoco><worldbody>{body}{body}</body></body></worldbody></mujoco>"
    boxes = mujoco.MjModel.from_xml_string(xml)
    matrices = []
    for engine in (model.engine, boxes):
        data = mujoco.MjData(engine)
        data.qpos[:] = [0.3, -0.7]
        mujoco.mj_forward(engine, data)
        full = np.zeros((2, 2))
        mujoco.mj_fullM(engine, data, full)
        matrices.append(full)
    np.testing.assert_allclose(matrices[0], matrices[1], rtol=1e-9)


def test_the_model_file_compiles_to_the_plates_that_ran():
    model = compile_model(LETTER)
    again = mujoco.MjModel.from_xml_string(model.xml)
    for name in ("body_mass", "body_inertia", "jnt_range", "jnt_stiffness", "qpos_spring", "dof_damping"):
        np.testing.assert_allclose(getattr(again, name), getattr(model.engine, name), rtol=1e-5, atol=1e-12)


def test_a_record_of_plates_is_kept_and_read_again(tmp_path):
    record = run(with_values(LETTER, {"protocol.stages": [stage(limit=0.05)], "crease.start": 0.5}))
    save_record(record, tmp_path / "record.nc")
    again = load_record(tmp_path / "record.nc")
    assert again.design == record.design
    for name, values in record.series.items():
        assert again.series[name].tobytes() == values.tobytes()
    assert list(again.data.coords["hinge_role"].values) == ["crease", "crease"]
    assert again.data["distance"].dims == ("time", "measure")
    assert list(again.data.coords["measure"].values) == ["mouth"]


def test_a_sparse_record_has_the_same_bits():
    full, sparse = run(LETTER), run(LETTER, sparse=True)
    assert [end.goal_time for end in full.stages] == [end.goal_time for end in sparse.stages]
    assert sparse.series["hinge_angle"][-1].tobytes() == full.series["hinge_angle"][-1].tobytes()
    assert energy_balance(sparse).residual == pytest.approx(energy_balance(full).residual, rel=1e-6, abs=1e-12)


def test_the_longest_timestep_of_a_spring_is_that_of_its_mode():
    """Half of 2 / w, w = sqrt(k / I): a margin for stiffer folded states."""
    design = strip(**{"crease.stiffness": 0.02 / WIDTH, "stops.time_constant": 1.0})
    assert stable_timestep(design) == pytest.approx(math.sqrt(INERTIA / 0.02), rel=1e-3)
    chosen = with_timestep(with_values(design, {"protocol.timestep": "auto"})).protocol.timestep
    assert 0.1 < chosen / (0.25 * math.sqrt(INERTIA / 0.02)) <= 1


def test_a_strip_without_springs_tendons_or_drives_stays_at_rest():
    record = run(strip(3, **{"crease.start": 0.5}))
    assert record.measured("creases")[-1] == pytest.approx([0.5, 0.5], abs=1e-12)
    assert energy_balance(record).residual == 0.0


def test_the_drives_of_a_stage_rise_each_in_its_own_time():
    """Both torques alone give the momentum I w = T t + U (t - rise / 2)."""
    at_once, slowly, rise, end = 1e-3, 2e-3, 0.1, 0.15
    drives = [
        {"name": "jerk", "kind": "torque", "of": "creases", "value": at_once, "rise": 0.0},
        {"name": "swell", "kind": "torque", "of": "creases", "value": slowly, "rise": rise},
    ]
    record = run(strip(drive=drives, stages=[stage(drive=["jerk", "swell"], limit=end)]))
    speed = np.gradient(record.measured("creases")[:, 0], record.time)
    expected = (at_once * record.time + slowly * np.where(record.time < rise, record.time**2 / (2 * rise), 0)) / INERTIA
    expected += np.where(record.time < rise, 0, slowly * (record.time - rise / 2)) / INERTIA
    # error of first order in the timestep
    assert speed[100:-5] == pytest.approx(expected[100:-5], rel=1e-2)


def test_the_largest_kinetic_energy_is_the_work_up_to_a_stop_though_no_row_is_there():
    """Undamped panel from rest: torque times angle, which the stop absorbs between two rows."""
    torque, stop = 0.01, math.pi / 2
    values = {"crease.fold_limit": stop, "protocol.sample_interval": 20e-3}
    record = run(pushed(torque, [stage("time", "push", 0.3)], **values))
    at, most = record.kinetic_peak
    assert most == pytest.approx(torque * stop, rel=5e-3)
    # from rest under a constant torque
    assert at == pytest.approx(math.sqrt(2 * INERTIA * stop / torque), rel=5e-3)
    assert record.series["kinetic_energy"].max() < 0.9 * most
