"""Structures in a room agree with closed forms: gravity in any direction, tables, supports and dry friction."""

import math

import numpy as np
import pytest
import scipy.optimize

import forficula as ff
from forficula.analysis.advice import run_advice
from forficula.design.files.design_file import design_from_text, with_values
from forficula.dynamics import energy_balance
from forficula.statics.tree.ensemble import ensemble_of
from forficula.statics.tree.quasi_static import start_state

G = 9.81
SIDE, THICK, DENSITY = 0.05, 1e-3, 1270.0
SHEET = """
name = "two panels"
source = "two square panels of 5 cm"

[pattern]
kind = "pleats"
panels = 2
panel_lengths = ["5 cm"]
width = "5 cm"
assignment = "V"

[facet]
thickness = "1 mm"
density = "1270 kg/m^3"

[protocol]
timestep = "0.1 ms"
gravity = "9.81 m/s^2"
sample_interval = "1 ms"

[[protocol.stages]]
name = "free"
drive = "none"
until = "time"
time_limit = "0.3 s"
"""
RIGID = {"facet.kind": "rigid", "crease.stiffness": "0 N m/rad/m", "crease.damping": "0 N m s/rad/m"}
SOFT = {
    **{"facet.kind": "bars", "facet.youngs_modulus": "5 MPa", "facet.bend_stiffness": "0.1 N m/rad/m"},
    **{"crease.stiffness": "0.1 N m/rad/m", "crease.damping": "1e-4 N m s/rad/m"},
}
PANEL = SIDE**2 * THICK * DENSITY  # kg


def sheet(values, more=""):
    return with_values(design_from_text(SHEET + more), values)


def simulated(values, more=""):
    return ff.run(sheet(values, more), confirm=False).record


def test_a_sheet_falls_onto_a_table_in_the_root_of_two_heights_over_gravity_and_rests_on_its_half_thickness(
    agree, holds
):
    height = 0.1
    record = simulated(SOFT | {"table.height": f"{-height} m", "protocol.sample_interval": "0.1 ms"})
    lowest = record.series["point_position"][..., 2].min(axis=1)
    falling = slice(int(np.argmin(lowest)) + 1)
    met = float(np.interp(height - THICK / 2, -lowest[falling], record.time[falling]))
    agree("time of fall", met, math.sqrt(2 * (height - THICK / 2) / G), unit="s", by="sqrt(2 h / g)", abs=1e-4)
    agree("height at rest", lowest[-1], THICK / 2 - height, unit="m", by="half of the thickness", abs=1e-5)
    balance = energy_balance(record)
    fallen = 2 * PANEL * G * (height - THICK / 2)
    agree(
        "energy dissipated by the table and the sheet", -balance.gravitational, fallen, unit="J", by="m g h", rel=1e-3
    )
    holds("residual of the energy balance", balance.residual, below=0.005, by="the energy balance")


PUSH = """
[[drive]]
name = "push"
kind = "force"
of = ["vertex 0", "vertex 1", "vertex 2", "vertex 3", "vertex 4", "vertex 5"]
direction = [1, 0, 0]
value = "0.01 N"

[[protocol.stages]]
name = "slide"
drive = "none"
until = "time"
time_limit = "0.3 s"
"""


def test_a_push_below_the_limit_of_friction_does_not_move_a_sheet_on_a_table(holds):
    friction, rise = 0.3, 0.01
    values = SOFT | {"table.height": f"{-THICK / 2} m", "table.friction": friction, "drive.push.rise": f"{rise} s"}
    values |= {"protocol.stages.free.drive": "push", "protocol.stages.free.time_limit": f"{3 * rise} s"}
    values |= {"drive.push.value": f"{0.95 * friction * 2 * PANEL * G / 6} N"}
    record = simulated(values, PUSH)
    pushed = (record.time > 1.99 * rise) & (record.time < 3.01 * rise)
    moved = np.ptp(record.series["point_position"][pushed, :, 0].mean(axis=1))
    share = moved / (friction * G * rise**2 / 2)
    holds("displacement in 10 ms / (mu g t^2 / 2)", share, below=1e-6, by="static friction")


@pytest.mark.parametrize("friction", [0.2, 0.5])
def test_a_sheet_slides_on_a_table_until_friction_has_taken_its_kinetic_energy(friction, agree, holds):
    pushed = 0.05
    values = SOFT | {"table.height": f"{-THICK / 2} m", "table.friction": friction}
    values |= {"protocol.stages.free.drive": "push", "protocol.stages.free.time_limit": f"{pushed} s"}
    record = simulated(values, PUSH)
    place = record.series["point_position"][..., 0].mean(axis=1)
    speed = np.gradient(place, record.time)
    # shortly after the push, when the sheet slides as a whole
    after = int(np.searchsorted(record.time, pushed + 0.01))
    way = place[-1] - place[after]
    agree("sliding distance", way, speed[after] ** 2 / (2 * friction * G), unit="m", by="v^2 / (2 mu g)", rel=5e-3)
    balance = energy_balance(record)
    agree("energy taken by the table", balance.contacts, balance.work, unit="J", by="work of the push", rel=0.03)
    holds("residual of the energy balance", balance.residual, below=0.005, by="the energy balance")


def swings(moment, start):
    """Return the angles at which a plate that hangs from a crease with dry friction reverses, rad."""
    values = RIGID | {
        **{"protocol.gravity_direction": "x", "crease.start": f"{start} rad", "crease.back_limit": "90 deg"},
        **{"crease.friction": f"{moment / SIDE} N m/m", "protocol.stages.free.time_limit": "1 s"},
    }
    record = simulated(values)
    angle = record.series["hinge_angle"][:, 0]
    turns = np.flatnonzero(np.diff(angle[:-1]) * np.diff(angle[1:]) < 0) + 1
    return record, np.abs(angle[[0, *turns]])


def test_dry_friction_reduces_the_amplitude_of_a_pendulum_at_every_half_swing(agree, holds):
    moment, arm = 1e-5, PANEL * G * SIDE / 2
    record, amplitude = swings(moment, 0.2)
    agree(
        "loss of amplitude per half swing",
        -np.diff(amplitude[:5]),
        2 * moment / arm,
        unit="rad",
        by="2 M / (m g l), small angles",
        rel=0.01,
    )
    before, after = amplitude[:4], amplitude[1:5]
    lost = arm * (np.cos(after) - np.cos(before))
    agree("energy lost per half swing", lost, moment * (before + after), unit="J", by="M times turn", rel=2e-3)
    balance = energy_balance(record)
    turned = np.abs(np.diff(record.series["hinge_angle"][:, 0])).sum()
    agree("work of friction", balance.friction, moment * turned, unit="J", by="M times turn", rel=2e-3)
    holds("residual of the energy balance", balance.residual, below=0.005, by="the energy balance")


def test_dry_friction_of_a_crease_between_facets_that_bend_takes_the_same_energy(agree, holds):
    moment = 2e-5
    values = SOFT | {
        **{"crease.stiffness": "0 N m/rad/m", "crease.damping": "0 N m s/rad/m", "facet.bend_stiffness": "1 N m/rad/m"},
        **{"crease.friction": f"{moment / SIDE} N m/m", "protocol.gravity_direction": [1, 0, -0.3]},
        **{"protocol.timestep": "0.2 ms", "protocol.stages.free.time_limit": "0.4 s"},
    }
    record = simulated(values, HELD)
    angle = record.series["hinge_angle"][:, 0] + math.atan(0.3)
    turns = np.flatnonzero(np.diff(angle[:-1]) * np.diff(angle[1:]) < 0) + 1
    lost = np.abs(angle[0]) - np.abs(angle[turns[0]])
    loss = 2 * moment / (PANEL * G * SIDE / 2)
    agree("loss of amplitude in a half swing", lost, loss, unit="rad", by="2 M / (m g l), small angles", rel=0.02)
    balance = energy_balance(record)
    # before it slides, the crease turns elastically by 5 mrad to each side
    slid = np.abs(np.diff(angle)).sum() - 0.01 * len(turns) - 0.005
    agree("work of friction", balance.friction, moment * slid, unit="J", by="M times turn", rel=0.01)
    holds("residual of the energy balance", balance.residual, below=0.005, by="the energy balance")


@pytest.mark.parametrize("direction", [(1, 0, -1), (1, 0, 0.5), (2, 3, -1)])
def test_a_hinged_plate_rests_along_tilted_gravity(direction, agree):
    values = RIGID | {"protocol.gravity_direction": list(direction), "crease.back_limit": "180 deg"}
    landscape = ff.landscape(sheet(values), points=11)
    down = np.array(direction) / np.linalg.norm(direction)
    # a fold raises the panel along z
    angle = math.atan2(down[2], down[0])
    agree("angle at rest", landscape.rests[0].angles[0], angle, unit="rad", by="direction of gravity", abs=1e-6)
    energy = -PANEL * G * (down[0] * SIDE + down[1] * SIDE / 2 + math.hypot(down[0], down[2]) * SIDE / 2)
    weight = landscape.rests[0].stored["weight"]
    agree("energy of the weight of the turned panel", weight, energy, unit="J", by="-m g.r", rel=1e-9)


def test_the_gravitational_energy_of_a_run_is_minus_weight_times_position_of_all_masses(agree):
    direction = np.array([1.0, -2.0, 0.5])
    values = {"protocol.gravity_direction": direction.tolist(), "protocol.stages.free.time_limit": "0.02 s"}
    record = simulated(SOFT | values, HELD)
    masses = np.array([body.mass for body in record.structure.bodies])
    moved = record.series["point_position"] - record.series["point_position"][0]
    gained = -G * (moved @ (direction / np.linalg.norm(direction))) @ masses
    energy = record.series["gravitational_energy"]
    agree("gravitational energy gained", energy - energy[0], gained, unit="J", by="-m g.r", abs=1e-15)


HELD = """
[[support]]
of = "facet 0"
"""
ON_TWO_EDGES = """
[[support]]
of = "edge 1"
axes = "xyz"

[[support]]
of = "edge 2"
axes = "yz"
"""


def test_a_strip_on_two_edges_sags_under_its_weight_until_its_crease_carries_it(agree):
    stiffness = 0.2  # N m/rad/m
    values = SOFT | {
        **{"facet.youngs_modulus": "1000 MPa", "facet.bend_stiffness": "1000 N m/rad/m"},
        **{"crease.stiffness": f"{stiffness} N m/rad/m"},
    }
    landscape = ff.landscape(sheet(values, ON_TWO_EDGES))
    fold = landscape.states[0].rest.shape.angles[0]
    # with the slope a of both panels the energy is k w (2 a)^2 / 2 - m g L sin a
    slope = scipy.optimize.brentq(lambda a: 4 * stiffness * SIDE * a - PANEL * G * SIDE * math.cos(a), 0, math.pi / 2)
    agree("fold angle of the crease", fold, 2 * slope, unit="rad", by="4 k a = m g L cos a", rel=2e-3)


def test_dry_friction_holds_a_fold_within_its_moment_over_its_stiffness(agree):
    values = {
        **{"facet.kind": "rigid", "crease.stiffness": "0.1 N m/rad/m", "crease.rest_angle": "40 deg"},
        **{"crease.friction": "0.02 N m/m", "protocol.gravity": "0 m/s^2"},
    }
    bands = ff.landscape(sheet(values), points=11).friction_bands
    rest, half = math.radians(40), 0.02 / 0.1
    agree("lower end of the band", bands[0].lower, rest - half, unit="rad", by="rest - M / k", abs=1e-8)
    agree("upper end of the band", bands[0].upper, rest + half, unit="rad", by="rest + M / k", abs=1e-8)


def test_hinges_that_supports_tie_together_have_no_bands_of_friction():
    values = {"facet.kind": "rigid", "crease.back_limit": "170 deg", "crease.stiffness": "0.2 N m/rad/m"}
    landscape = ff.landscape(sheet(values | {"crease.friction": "0.02 N m/m"}, ON_TWO_EDGES), points=11)
    assert landscape.friction_bands == ()


def test_a_slow_drive_needs_the_moment_of_friction_in_addition(agree):
    path = ff.quasi_static_path(ff.load_design("binder2025-joint", {"hinge.friction": "0.5 N cm"}))
    agree("half width of the range of the drive", path.friction, 5e-3, unit="N m", by="M", rel=1e-9)


LIFT = """
[[drive]]
name = "lift"
kind = "force"
of = ["vertex 2", "vertex 5"]
direction = [0, 0, 1]
value = "0.01 N"
"""


def test_a_sheet_leans_on_a_table_in_statics_until_a_force_takes_its_weight_off(agree):
    height, stiffness = 0.005, 0.005  # m, N m/rad/m
    values = SOFT | {
        **{"facet.youngs_modulus": "100 MPa", "facet.bend_stiffness": "10 N m/rad/m"},
        **{"crease.stiffness": f"{stiffness} N m/rad/m", "table.height": f"{-height} m"},
        **{"protocol.stages.free.drive": "lift"},
    }
    path = ff.quasi_static_path(sheet(values, LIFT + HELD))
    angle = math.asin((height - THICK / 2) / SIDE)
    agree("fold angle on the table", path.angles[0, 0], -angle, unit="rad", by="asin(h / L)", abs=1e-5)
    depth = THICK / 2 - height - path.positions[:, :6, 2].min()
    agree("depth to which the sheet sinks in", depth, 0, unit="m", by="a table", abs=1e-7)
    raised = path.strength[np.argmax(path.positions[:, 2, 2] > THICK / 2 - height + 1e-6)]
    carried = PANEL * G / 2 - stiffness * angle / math.cos(angle)
    agree("force on each corner at lift-off", raised, carried / 2, unit="N", by="m g / 2 - k a / (L cos a)", rel=1e-3)


HEIGHT, STIFFNESS = 0.005, 0.05  # m, N m/rad/m
RESTING = math.asin((HEIGHT - THICK / 2) / SIDE)  # rad, of a hinged plate on the table
ON_TABLE = RIGID | {
    **{"table.height": f"{-HEIGHT} m", "crease.back_limit": "90 deg", "crease.damping": "1e-4 N m s/rad/m"},
    "crease.stiffness": f"{STIFFNESS} N m/rad/m",
}
TURN = """
[[drive]]
name = "turn"
kind = "torque"
of = "creases"
value = "0.12 N cm"

[[protocol.stages]]
name = "lift"
drive = "turn"
motion = "quasi-static"
until = "time"
time_limit = "1 s"
"""
TURNING = 1.2e-3  # N m, of the drive


def holding(angle):
    """Return the torque that holds the plate at an angle without a table, N m."""
    return PANEL * G * SIDE / 2 * math.cos(angle) + STIFFNESS * SIDE * angle


LIFT_OFF = holding(-RESTING)  # N m, takes the weight of the plate off the table
LIFTED = scipy.optimize.brentq(lambda angle: holding(angle) - TURNING, 0, 1)  # rad


@pytest.mark.parametrize("contact", [False, True], ids=["joints", "loose plates"])
def test_a_hinged_plate_rests_on_a_table_at_the_angle_of_its_height(contact, agree):
    landscape = ff.landscape(sheet(ON_TABLE | {"protocol.contact": contact}), points=11)
    angle, state = landscape.rests[0].angles[0], landscape.states[0]
    agree("angle on the table", angle, -RESTING, unit="rad", by="asin(h / L)", abs=5e-6)
    force = LIFT_OFF / (SIDE * math.cos(RESTING))
    agree("force of the table", state.contacts["facet 1 and table"], force, unit="N", by="moments", rel=1e-4)


def test_the_depth_in_the_table_vanishes_as_its_springs_become_stiffer(monkeypatch, agree):
    errors = []
    for depth in (1e-4, 1e-5):
        monkeypatch.setattr("forficula.statics.planes.SUNK", depth)
        errors.append(RESTING + ff.landscape(sheet(ON_TABLE), points=11).rests[0].angles[0])
    agree("ratio of the errors of the angle", errors[0] / errors[1], 10, unit="", by="a linear spring", rel=1e-2)


def test_a_torque_takes_the_weight_of_a_plate_off_a_table(agree):
    path = ff.quasi_static_path(sheet(ON_TABLE | {"protocol.stages.free.drive": "turn"}, TURN))
    force = path.contacts["facet 1 and table"]
    raised = path.strength[np.argmax(force == 0)]
    agree("torque at lift-off", raised, LIFT_OFF, unit="N m", by="moments", rel=2e-2)
    fallen = force[0] * (1 - path.strength / LIFT_OFF)
    agree("force under the growing torque", force, np.maximum(fallen, 0), unit="N", by="moments", abs=1e-4 * force[0])
    work = np.sum((path.strength[1:] + path.strength[:-1]) / 2 * np.diff(path.angles[:, 0]))
    stored = sum(path.energy.values())
    agree("stored energy", stored[-1] - stored[0], work, unit="J", by="work of the torque", rel=2e-3)
    agree("last angle", path.angles[-1, 0], LIFTED, unit="rad", by="moments", abs=1e-6)


def test_a_quasi_static_stage_begins_on_a_table(agree, holds):
    record = simulated(ON_TABLE | {"protocol.stages.free.time_limit": "0.5 s"}, TURN)
    angle = record.series["hinge_angle"][:, 0]
    # the torque grows evenly for 1 s
    raised = record.stages[1].end - record.time[np.flatnonzero(angle < 1e-4 - RESTING)[-1]]
    agree("time from lift-off to the end", raised, 1 - LIFT_OFF / TURNING, unit="s", by="moments", abs=0.04)
    agree("last angle", angle[-1], LIFTED, unit="rad", by="moments", abs=1e-5)
    balance = energy_balance(record)
    holds("residual of the energy balance", balance.residual, below=0.005, by="the energy balance")


def test_the_wing_rests_on_a_table_as_in_a_slow_run(agree):
    values = {"protocol.stages.fold.time_limit": "0.2 ms"} | {
        "table.friction": 0,
        "protocol.stages.settle.time_limit": "1 s",
    }
    wing = ff.load_design("binder2025-on-table", values)
    record = ff.run(wing, confirm=False).record
    resting = record.series["hinge_angle"][np.searchsorted(record.time, record.stages[0].end) - 1]
    structures = ensemble_of([wing])
    agree("angles at rest", start_state(structures).position[0], resting, unit="rad", by="a run", abs=2e-3)


ON_FOUR_VERTICES = """
[[support]]
of = "vertex 0"

[[support]]
of = "vertex 3"
axes = "xz"

[[support]]
of = "vertex 2"
axes = "yz"

[[support]]
of = "vertex 5"
axes = "z"
"""


@pytest.mark.parametrize("supports", [ON_TWO_EDGES, ON_FOUR_VERTICES], ids=["two edges", "four vertices"])
def test_a_strip_of_rigid_facets_on_supports_sags_until_its_crease_carries_it(supports, agree, holds):
    stiffness = 0.2  # N m/rad/m
    values = {
        **{"facet.kind": "rigid", "crease.back_limit": "170 deg", "protocol.stages.free.time_limit": "0.5 s"},
        **{"crease.stiffness": f"{stiffness} N m/rad/m", "crease.damping": "2e-3 N m s/rad/m"},
    }
    slope = scipy.optimize.brentq(lambda a: 4 * stiffness * SIDE * a - PANEL * G * SIDE * math.cos(a), 0, math.pi / 2)
    rest = ff.landscape(sheet(values, supports), points=11).rests[0].angles[-1]
    agree("fold angle in statics", rest, 2 * slope, unit="rad", by="4 k a = m g L cos a", rel=1e-6)
    record = simulated(values, supports)
    angle = record.series["hinge_angle"][-1, -1]
    agree("fold angle in a run", angle, 2 * slope, unit="rad", by="4 k a = m g L cos a", rel=1e-6)
    holds("residual of the energy balance", energy_balance(record).residual, below=1e-6, by="the energy balance")
    holds("gap of the supports", record.series["closure_gap"].max() / SIDE, below=1e-6, by="rigid supports")


def test_a_torque_on_a_strip_on_vertices_does_the_work_that_crease_and_weight_store(agree, holds):
    """The bodies of this strip begin at a free plate, whose coordinates come before those of the crease."""
    torque, stiffness = 5e-3, 0.2
    values = {
        **{"facet.kind": "rigid", "crease.back_limit": "170 deg", "protocol.stages.free.time_limit": "0.3 s"},
        **{"crease.stiffness": f"{stiffness} N m/rad/m", "crease.damping": "2e-3 N m s/rad/m"},
        **{"protocol.stages.free.drive": "fold"},
    }
    drive = f'[[drive]]\nname = "fold"\nkind = "torque"\nof = "creases"\nvalue = "{torque} N m"\nrise = "0 s"\n'
    record = simulated(values, ON_FOUR_VERTICES + drive)
    balance, angle = energy_balance(record), record.series["hinge_angle"][-1, 0]
    agree("work of the torque", balance.work, torque * abs(angle), unit="J", by="torque times angle", rel=1e-3)
    holds("residual of the energy balance", balance.residual, below=1e-4, by="the energy balance")


def test_opening_creases_on_vertices_sag_as_hinges_and_their_damping_counts(agree, holds):
    stiffness = 0.2  # N m/rad/m
    values = {
        **{"facet.kind": "rigid", "crease.back_limit": "170 deg", "protocol.stages.free.time_limit": "0.05 s"},
        **{"crease.stiffness": f"{stiffness} N m/rad/m", "crease.damping": "2e-3 N m s/rad/m"},
        **{"crease.extension": "1e6 N/m^2", "crease.extension_damping": "1 N s/m^2"},
    }
    slope = scipy.optimize.brentq(lambda a: 4 * stiffness * SIDE * a - PANEL * G * SIDE * math.cos(a), 0, math.pi / 2)
    rest = ff.landscape(sheet(values, ON_FOUR_VERTICES), points=11).rests[0].angles[-1]
    agree("fold angle in statics", rest, 2 * slope, unit="rad", by="4 k a = m g L cos a", rel=1e-6)
    balance = energy_balance(simulated(values, ON_FOUR_VERTICES))
    assert balance.hinge_damping > 0.1 * balance.exchanged
    holds("residual of the energy balance", balance.residual, below=1e-5, by="the energy balance")


def test_the_spring_of_an_opening_crease_counts_while_another_crease_is_at_its_stop(holds):
    begin = SHEET.index("[facet]")
    text = SHEET[:begin].replace("panels = 2", "panels = 3").replace('"V"', '"VV"') + '[facet]\nkind = "rigid"'
    group = '[[crease.group]]\nof = "crease 1"\nextension = "1e5 N/m^2"\n'
    values = {
        **{"crease.stiffness": "0.02 N m/rad/m", "crease.damping": "1e-4 N m s/rad/m", "crease.fold_limit": "10 deg"},
        **{"crease.back_limit": "10 deg", "protocol.stages.free.time_limit": "0.06 s"},
    }
    supports = '[[support]]\nof = "facet 0"\n[[support]]\nof = "vertex 3"\naxes = "y"\n'
    design = design_from_text(text + SHEET[begin + len("[facet]") :] + group + supports)
    balance = energy_balance(ff.run(with_values(design, values), confirm=False).record)
    assert balance.stops > 0.1 * balance.exchanged
    holds("residual of the energy balance", balance.residual, below=1e-4, by="the energy balance")


@pytest.mark.parametrize("friction", [0.0, 0.5])
def test_a_strip_on_vertices_sags_until_its_crease_lies_on_a_table(friction, agree, holds):
    height = 0.01
    values = {
        **{"facet.kind": "rigid", "crease.back_limit": "170 deg", "protocol.stages.free.time_limit": "0.15 s"},
        **{"crease.stiffness": "0.02 N m/rad/m", "crease.damping": "1e-4 N m s/rad/m"},
        **{"table.height": f"{-height} m", "table.friction": friction},
    }
    record = simulated(values, ON_FOUR_VERTICES)
    angle, fold = record.series["hinge_angle"][-1, -1], 2 * math.asin((height - THICK / 2) / SIDE)
    agree("fold angle at rest", angle, fold, unit="rad", by="2 asin((h - t / 2) / L)", abs=1e-5)
    touched = ff.landscape(sheet(values, ON_FOUR_VERTICES), points=11).states[0].contacts
    carried = 4 * 0.02 * (fold / 2) / math.cos(fold / 2)
    agree("force of the table", sum(touched.values()), PANEL * G - carried, unit="N", by="virtual work", rel=1e-4)
    balance = energy_balance(record)
    stored = 0.02 * SIDE * fold**2 / 2
    lost = PANEL * G * (height - THICK / 2) - stored
    dissipated = balance.contacts + balance.hinge_damping + balance.elastic_damping
    agree("energy that table and crease dissipate", dissipated, lost, unit="J", by="m g h - k a^2 / 2", rel=2e-3)
    holds("residual of the energy balance", balance.residual, below=0.001, by="the energy balance")
    holds("gap of the supports", record.series["closure_gap"].max() / SIDE, below=1e-5, by="rigid supports")


def miura(fold, supports="", **values):
    """Return four facets around a vertex."""
    pattern = f"""kind = "miura-ori"
columns = 2
rows = 2
long_side = "5 cm"
short_side = "5 cm"
acute_angle = "60 deg"
fold = "{fold} deg"

"""
    begin, end = SHEET.index('kind = "pleats"'), SHEET.index("[facet]")
    text = SHEET[:begin] + pattern + SHEET[end:] + supports
    return with_values(design_from_text(text), {"facet.kind": "rigid", "crease.back_limit": "170 deg"} | values)


ON_THREE_VERTICES = ON_FOUR_VERTICES.replace('"vertex 3"', '"vertex 6"').replace('axes = "xz"', 'axes = "z"')
ON_THREE_VERTICES = ON_THREE_VERTICES[: ON_THREE_VERTICES.index('[[support]]\nof = "vertex 5"')]
SPRUNG = {
    **{"crease.stiffness": "0.2 N m/rad/m", "crease.damping": "2e-3 N m s/rad/m", "crease.rest_angle": "40 deg"},
    "protocol.gravity_direction": [0, 0.3, -1],
}


def test_a_loop_of_rigid_facets_on_vertices_rests_in_statics_as_in_a_run(agree, holds):
    design = miura(60, ON_THREE_VERTICES, **SPRUNG)
    record = ff.run(design, confirm=False).record
    rest, angles = ff.landscape(design).rests[0].angles, record.series["hinge_angle"][-1]
    agree("fold angles", rest, angles, unit="rad", by="a run", abs=1e-4)
    holds("residual of the energy balance", energy_balance(record).residual, below=0.005, by="the energy balance")


def test_a_loop_of_rigid_facets_falls_onto_a_table_and_rests_as_in_statics(agree, holds):
    values = {"crease.stiffness": "2e-3 N m/rad/m", "crease.damping": "1e-4 N m s/rad/m", "table.height": "-3 mm"}
    design = miura(60, **values, **{"protocol.stages.free.time_limit": "0.2 s"})
    record = ff.run(design, confirm=False).record
    balance = energy_balance(record)
    assert balance.contacts > 0.05 * balance.exchanged
    holds("residual of the energy balance", balance.residual, below=0.001, by="the energy balance")
    height = record.series["point_position"][-1, :, 2].min() + 3e-3
    agree("height at rest", height, THICK / 2, unit="m", by="half of the thickness", abs=1e-7)
    rest, angles = ff.landscape(design, points=11).rests[0].angles, record.series["hinge_angle"][-1]
    agree("fold angles", rest, angles, unit="rad", by="a run", abs=5e-4)


def test_a_loop_that_starts_flat_misses_energy_like_the_timestep_to_the_power_two_thirds(agree):
    """A flat loop can move in more ways than a folded one; the constraint ends these motions and takes their energy.

    Moments accelerate the angles a as t^2, the constraint resists with a^2 / h^2 and acts from t^3 = h on, and the
    energy is proportional to a.
    """
    values = SPRUNG | {"protocol.stages.free.time_limit": "0.02 s", "protocol.residual_limit": 1e-3}
    steps = 1e-4, 5e-5, 2.5e-5
    runs = [
        ff.run(miura(0, ON_THREE_VERTICES, **values, **{"protocol.timestep": step}), confirm=False) for step in steps
    ]
    residuals = [energy_balance(run.record).residual for run in runs]
    orders = np.diff(np.log(residuals)) / np.diff(np.log(steps))
    agree("order of the residual", orders, 2 / 3, by="a^2 / h^2 and a = t^2", abs=0.07)
    advised = run_advice(runs[0].record, ff.measure(runs[0]).ending)
    agree("advised timestep", advised.values["protocol.timestep"], 1e-5, unit="s", by="the order", rel=1e-6)
    folded = ff.run(miura(1, ON_THREE_VERTICES, **values), confirm=False).record
    assert energy_balance(folded).residual < 1e-3
