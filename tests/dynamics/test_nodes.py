"""Sheets of nodes in motion: creases, bars, drives and the energy balance, compared with closed forms."""

import copy
import math

import mujoco
import numpy as np
import pytest

from forficula.design import load_design, with_values
from forficula.dynamics import compile_model, energy_balance, simulate, stable_timestep
from forficula.dynamics.energies.crease_moments import Past
from forficula.dynamics.energies.creases import engine_rows
from forficula.dynamics.engine.crease_rows import crease_rows
from forficula.structure import built_points, crease_flaps, flap_angles, structure_of

MIURA, LETTER = load_design("miura-sheet"), load_design("letter-fold")
LENGTH, WIDTH = 0.05, 0.04


def stage(drive="none", until="time", limit=0.1):
    return {"name": f"{drive} {until}", "drive": drive, "until": until, "hold": 0.0, "time_limit": limit}


# soft enough for long steps, without damping
PLAIN = {
    "facet.kind": "bars",
    "facet.youngs_modulus": 2e7,
    "facet.poisson_ratio": 0.3,
    "facet.stretch_damping": 0.0,
    "crease.stiffness": 0.02,
    "crease.damping": 0.0,
    "support": [],
    "tendon": [],
    "measure": [],
    "protocol.least_hold": 0.0,
    "protocol.timestep": 2e-5,
    "protocol.sample_interval": 1e-3,
}


def miura(**values):
    """Return two by two parallelograms without supports."""
    changes = {"pattern.columns": 2, "pattern.rows": 2, "protocol.stages": [stage("fold")]}
    return with_values(MIURA, PLAIN | changes | values)


def strip(**values):
    """Return two panels of 5 cm by 4 cm, the first held."""
    changes = {
        "pattern.panels": 2,
        "pattern.panel_lengths": [LENGTH],
        "pattern.width": WIDTH,
        "crease.rest_angle": 0.0,
        "crease.start": 0.0,
        "crease.fold_limit": None,
        "crease.back_limit": None,
        "support": [{"of": "facet 0"}],
        "drive": [],
        "protocol.stages": [stage()],
    }
    return with_values(LETTER, PLAIN | changes | values)


def run(*designs):
    return simulate([compile_model(design) for design in designs])


def total_energy(record):
    series = record.series
    stored = series["hinge_energy"].sum(axis=1) + series["spring_energy"].sum(axis=1)
    return series["kinetic_energy"] + stored


@pytest.mark.parametrize("seed", range(4))
def test_the_engine_pushes_nodes_by_the_moments_of_creases_and_in_no_other_way(seed):
    """Force = -moment times gradient of the fold angle, by differences, far from the built shape."""
    model = compile_model(miura(**{"facet.youngs_modulus": 1e-9, "facet.stretch_damping": 0.0}))
    rows, random = crease_rows([model]), np.random.default_rng(seed)
    size, dof = 0.3 * np.ptp(model.folds.built, axis=0).max(), model.engine.nv
    position = size * random.normal(size=dof)
    effort = random.normal(size=(1, len(model.structure.motors)))
    start = model.folds.angles(position)[None, model.folds.creases]
    past = Past(angles=start, memory=np.zeros((1, *start.shape)), elapsed=np.zeros((1, 1)), block=np.zeros((1, 1)))
    angles, _, values = rows.follow(position[None], np.zeros((1, dof)), effort, past)
    engine = copy.copy(model.engine)
    engine_rows(engine)[rows.rows] = values[0]
    data = mujoco.MjData(engine)
    data.qpos[:] = position
    mujoco.mj_forward(engine, data)
    rests, _ = model.settings(effort)
    moments = rows.moments.law.moment(angles, rests)[0]
    step = 1e-6 * size
    gradient = [
        (model.folds.angles(position + step * item) - model.folds.angles(position - step * item)) / (2 * step)
        for item in np.eye(dof)
    ]
    expected = -np.array(gradient)[:, model.folds.creases] @ moments
    assert data.qfrc_passive == pytest.approx(expected, abs=1e-7 * np.abs(expected).max())


def test_the_energy_loss_of_a_free_swing_is_proportional_to_the_timestep():
    worst = []
    for timestep in (8e-6, 4e-6, 2e-6):
        values = {"crease.rest_angle": 1.2, "protocol.timestep": timestep, "protocol.stages": [stage(limit=0.02)]}
        values |= {"facet.youngs_modulus": 4e8}
        energy = total_energy(run(miura(**values))[0])
        worst.append(np.abs(energy / energy[0] - 1).max())
    assert worst[0] < 0.05
    assert np.log2(np.array(worst[:-1]) / worst[1:]) == pytest.approx([1, 1], abs=0.25)


@pytest.mark.parametrize(
    "drive",
    [
        {"kind": "rest-angle", "of": "creases", "angle": 0.5, "rise": 0.05},
        {"kind": "torque", "of": "role:zigzag", "value": 2e-4, "rise": 0.05},
        {"kind": "force", "of": "vertex 8", "force": 0.02, "direction": (0.0, 0.6, 0.8), "rise": 0.05},
    ],
)
def test_the_energy_balance_closes_for_every_kind_of_drive(drive):
    changes = {"drive": [{"name": "fold"} | drive], "support": [{"of": "facet 0"}], "crease.damping": 1e-4}
    changes["protocol.stages"] = [stage("fold", limit=0.04)]
    balances = [
        energy_balance(run(miura(**changes, **{"protocol.timestep": timestep}))[0]) for timestep in (8e-5, 4e-5)
    ]
    assert balances[0].work > 0
    assert balances[0].residual < 5e-3
    assert balances[1].residual < 0.6 * balances[0].residual + 1e-6


@pytest.mark.parametrize(
    "held", [{"crease.law": "locking", "crease.lock_angle": math.radians(60)}, {"crease.fold_limit": math.radians(60)}]
)
def test_the_energy_balance_closes_for_rest_angles_beyond_locking_or_stops(held):
    """Only the spring's rest angle moves: the work on a stop is 0."""
    drive = {"name": "fold", "kind": "rest-angle", "of": "creases", "angle": math.radians(150), "rise": 0.1}
    values = {"drive": [drive], "crease.damping": 1e-4, "protocol.stages": [stage("fold", limit=0.15)]}
    (record,) = run(strip(**values, **held))
    assert record.series["hinge_angle"][:, 0].max() > math.radians(60)
    assert energy_balance(record).work > 1e-3
    assert energy_balance(record).residual < 3e-4


def test_a_free_sheet_keeps_its_centre_and_its_angular_momentum():
    design = miura()
    (record,) = run(design)
    places = record.series["point_position"]
    masses = np.array([body.mass for body in record.structure.bodies])
    centres = np.einsum("i,tix->tx", masses, places[:, : len(masses)]) / masses.sum()
    assert np.ptp(centres, axis=0) == pytest.approx(np.zeros(3), abs=1e-13)
    # velocities between rows: means over a millisecond, with an error of its square
    speeds = np.gradient(places[:, : len(masses)], record.time, axis=0)[5:-5]
    around = places[5:-5, : len(masses)] - centres[5:-5, None]
    spin = np.einsum("i,tix->tx", masses, np.cross(around, speeds))
    size = np.einsum("i,ti->t", masses, np.linalg.norm(around, axis=2) * np.linalg.norm(speeds, axis=2)).max()
    assert np.abs(spin).max() < 1e-3 * size


def test_a_panel_swings_on_its_crease_like_a_pendulum_of_its_nodes():
    """2 pi sqrt(I / k), I that of the two outer nodes at the panel's length; the period agrees to 0.5 %."""
    design = strip(
        **{
            "crease.rest_angle": 0.05,
            "crease.stiffness": 0.5,
            "facet.bend_stiffness": 20.0,
            "protocol.sample_interval": 1e-4,
        }
    )
    built = structure_of(design)
    swinging = [hinge for hinge in built.hinges if hinge.role == "crease"]
    (hinge,) = swinging
    free = [body for body in built.bodies if body.slides]
    inertia = sum(body.mass for body in free) * LENGTH**2
    (record,) = run(design)
    angle = record.series["hinge_angle"][:, built.hinges.index(hinge)] - 0.05
    crossings = np.flatnonzero((angle[:-1] < 0) & (angle[1:] >= 0))
    share = angle[crossings] / (angle[crossings] - angle[crossings + 1])
    times = record.time[crossings] + share * np.diff(record.time)[crossings]
    assert len(times) > 1
    assert np.diff(times).mean() == pytest.approx(2 * math.pi * math.sqrt(inertia / hinge.stiffness), rel=5e-3)


def test_a_moving_miura_vertex_obeys_the_relation_of_half_angles():
    """tan(straight / 2) = cos(acute) tan(zigzag / 2) (Huffman 1976; Tachi 2009), to 0.05 deg with stiff bars."""
    design = miura(
        **{
            "facet.youngs_modulus": 2e9,
            "facet.bend_stiffness": 5.0,
            "protocol.timestep": 4e-6,
            "protocol.stages": [stage("fold", limit=0.03)],
        }
    )
    (record,) = run(design)
    roles = np.array([hinge.role for hinge in record.structure.hinges])
    angles = record.series["hinge_angle"]
    assert np.ptp(angles[:, roles == "zigzag"]) > math.radians(1)
    expected = 2 * np.arctan(
        math.cos(design.pattern.acute_angle) * np.tan(angles[:, roles == "zigzag"].mean(axis=1) / 2)
    )
    off = np.degrees(np.abs(angles[:, roles == "straight"] - expected[:, None]))
    assert off.max() < 0.05


def test_sheets_side_by_side_move_as_each_alone_to_the_bit(monkeypatch):
    # two workers have two each; when one run ends, one worker has three
    monkeypatch.setattr("forficula.dynamics.stepping.stepper._TOGETHER", 3)
    limits = {0.02: 0.012, 0.021: 0.012, 0.018: 0.012, 0.019: 0.005}
    designs = [
        miura(**{"crease.stiffness": stiffness, "protocol.stages": [stage("fold", limit=limit)]})
        for stiffness, limit in limits.items()
    ]
    together = simulate([compile_model(design) for design in designs], threads=2)
    for design, record in zip(designs, together, strict=True):
        (alone,) = run(design)
        for name, values in alone.series.items():
            assert np.array_equal(values, record.series[name]), name


def test_the_angle_of_a_panel_past_180_deg_has_no_jump():
    drive = {"name": "turn", "kind": "torque", "of": "creases", "value": 5e-4}
    values = {"drive": [drive], "crease.stiffness": 0.0, "protocol.stages": [stage("turn", limit=0.2)]}
    (record,) = run(strip(**values))
    angle = record.series["hinge_angle"][:, 0]
    assert angle[-1] > 1.5 * math.pi
    assert np.abs(np.diff(angle)).max() < 0.3
    assert energy_balance(record).residual < 5e-3


def test_a_locking_crease_keeps_its_panels_from_passing_through_each_other():
    """At rest: torque k (lock + 2 w / pi tan(pi x / (2 w))); x: angle beyond the lock, w: lock to 180 deg."""
    torque, stiffness = 3e-3, 0.02 * WIDTH
    drive = {"name": "turn", "kind": "torque", "of": "creases", "value": torque, "rise": 0.1}
    values = {"drive": [drive], "crease.law": "locking", "crease.damping": 2e-3, "facet.bend_stiffness": 5.0}
    (record,) = run(strip(**values, **{"protocol.stages": [stage("turn", limit=0.35)], "protocol.timestep": 1e-4}))
    angle = record.series["hinge_angle"][:, 0]
    lock, room = math.radians(135), math.radians(45)
    beyond = 2 * room / math.pi * math.atan((torque / stiffness - lock) * math.pi / (2 * room))
    assert angle[-1] == pytest.approx(lock + beyond, abs=0.02)
    assert angle.max() < math.pi


def test_a_stop_of_a_crease_holds_it():
    drive = {"name": "turn", "kind": "torque", "of": "creases", "value": 1e-3, "rise": 0.05}
    values = {"drive": [drive], "crease.fold_limit": math.radians(60), "crease.damping": 1e-3}
    (record,) = run(strip(**values, **{"protocol.stages": [stage("turn", limit=0.2)]}))
    assert np.degrees(record.series["hinge_angle"][-1, 0]) == pytest.approx(60, abs=1.5)


@pytest.mark.parametrize(("share", "sound"), [(1.0, True), (1.5, False)])
def test_the_longest_timestep_is_about_that_at_which_bars_blow_up(share, sound):
    """The recommended timestep is four fifths of the limit: 1.5 times as much is beyond it."""
    design = miura()
    longest = stable_timestep(design)
    (record,) = run(with_values(design, {"protocol.timestep": share * longest}))
    blown = record.diverged_at is not None or energy_balance(record).residual > 1
    assert blown is not sound


def test_creases_begin_where_they_are_built():
    built = structure_of(miura())
    angles = flap_angles(built_points(built)[crease_flaps(built)])
    assert [hinge.sense * hinge.start for hinge in built.hinges] == pytest.approx(angles, abs=1e-12)
