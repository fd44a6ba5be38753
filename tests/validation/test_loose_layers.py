"""Layers that nothing joins: stacks under their weight, friction of facets, and a strip that sags onto a facet."""

import math

import numpy as np
import pytest

import forficula as ff
from forficula.analysis.contact_overlap import contact_overlap
from forficula.dynamics import energy_balance
from forficula.statics.net.contact.contact_energy import contact_forces
from forficula.statics.net.driven.net_course import released
from forficula.statics.net.net_of import net_of, start_shape
from forficula.structure import structure_of
from tests.loose_layers import DENSITY, LAYER, SIDE, THICK, WIDTH, G, loose_layers, strip_above_facet, support

COUNT = 4


@pytest.fixture(scope="module")
def stack():
    """Design of four equal layers whose corners are guided along z, the lowest one on a table."""
    squares = [(SIDE, 0.0, 0.0, 1.2 * THICK * (layer + 1)) for layer in range(COUNT - 1)]
    guides = "".join(support(f"vertex {vertex}", "xy") for vertex in range(6 + 4 * (COUNT - 1)))
    table = f'[table]\nheight = "{-THICK / 2} m"\n'
    return loose_layers(squares, more=guides + table, time=0.03)


def heights(places):
    """Return the heights of the corners of the layers of a stack, m, (layer, corner)."""
    return np.concatenate([places[None, [0, 2, 3, 5], 2], places[6 : 6 + 4 * (COUNT - 1), 2].reshape(-1, 4)])


@pytest.fixture(scope="module")
def rest(stack):
    """Net of the stack, and its resting shape in statics."""
    structure = structure_of(stack)
    net = net_of(structure)
    return net, released(net, start_shape(structure, net))[0]


def test_middle_surfaces_of_loose_layers_rest_a_thickness_above_each_other_in_statics(rest, agree):
    net, shape = rest
    assert shape.stable
    places = heights(net.points @ shape.shape.positions)
    expected = THICK * np.arange(COUNT)[:, None]
    agree("height of a layer", places, expected, by="(k - 1) t", unit="m", abs=1e-7)


def test_each_contact_of_a_stack_carries_the_weight_of_the_layers_above(rest, agree):
    net, shape = rest
    forces = contact_forces(net, shape.shape)
    on_table = sum(forces.pop(name) for name in list(forces) if name.endswith("and table"))
    lowest = forces.pop("facet 0 and facet 2") + forces.pop("facet 1 and facet 2")
    carried = LAYER * G * np.arange(COUNT - 1, 0, -1)
    agree("contact force", [lowest, *forces.values()], carried, by="weight of the layers above", unit="N", rel=1e-6)
    agree("force on the table", on_table, LAYER * G * COUNT, by="weight of all layers", unit="N", rel=1e-6)


def test_a_stack_that_falls_rests_where_statics_does(stack, rest, agree, holds):
    record = ff.run(stack, confirm=False).record
    net, shape = rest
    ours, theirs = heights(record.series["point_position"][-1]), heights(net.points @ shape.shape.positions)
    # contacts of a run are springs
    agree("height of a layer", ours, theirs, by="statics", unit="m", abs=0.01 * THICK)
    holds("overlap / thickness", contact_overlap(record).largest, below=0.1, by="a tenth of the thickness")
    holds("residual of the energy balance", energy_balance(record).residual, below=0.005, by="the energy balance")


FRICTION = 0.5
ON_BASE = [(0.02, 0.005, 0.02, THICK)]
HELD = support("facet 0") + support("facet 1") + '[contact]\nfriction = {friction}\ntime_constant = "0.4 ms"\n'
PUSH = """
[[drive]]
name = "push"
kind = "force"
of = ["vertex 6", "vertex 7", "vertex 8", "vertex 9"]
direction = [1, 0, 0]
value = "0.004 N"
"""
STAGES = """
[[protocol.stages]]
name = "push"
drive = "push"
until = "time"
time_limit = "0.006 s"

[[protocol.stages]]
name = "slide"
drive = "none"
until = "time"
time_limit = "0.04 s"
"""


def sliding(design):
    """Run a small facet on a larger one that is held: the record, and mean x of the facet, m, and its speed, m/s."""
    record = ff.run(design, confirm=False).record
    place = record.series["point_position"][:, 6:10, 0].mean(axis=1)
    return record, place, np.gradient(place, record.time)


def test_a_facet_slides_on_another_one_until_friction_has_taken_its_kinetic_energy(agree, holds):
    record, place, speed = sliding(
        loose_layers(ON_BASE, 0.06, more=HELD.format(friction=FRICTION) + PUSH, stages=STAGES)
    )
    after = int(np.searchsorted(record.time, 0.008))
    expected = speed[after] ** 2 / (2 * FRICTION * G)
    agree("sliding distance", place[-1] - place[after], expected, by="v^2 / (2 mu g)", unit="m", rel=5e-3)
    holds("residual of the energy balance", energy_balance(record).residual, below=0.005, by="the energy balance")


def inclined(friction, slope, time=0.02, **values):
    """Run a small facet on a larger one that is held, both inclined, as `sliding` returns it."""
    design = loose_layers(ON_BASE, 0.06, more=HELD.format(friction=friction), time=time)
    return sliding(design.with_values({"protocol.gravity_direction": [slope, 0, -1], **values}))


@pytest.mark.parametrize(("slope", "friction", "within"), [(0.2, 0.1, 1e-3), (0.303, 0.3, 0.05)])
def test_a_facet_on_an_inclined_one_accelerates_by_its_weight_minus_friction(slope, friction, within, agree):
    record, _, speed = inclined(friction, slope)
    gained = (speed[-2] - speed[5]) / (record.time[-2] - record.time[5])
    expected = G * (slope - friction) / math.hypot(1, slope)
    agree("acceleration", gained, expected, by="g (sin a - mu cos a)", unit="m/s^2", rel=within)


@pytest.mark.parametrize("slope", [0.2, 0.297])
def test_friction_holds_a_facet_on_an_inclined_one_without_a_creep(slope, agree, holds):
    record, place, _ = inclined(0.3, slope, 0.015)
    constant, pull = record.structure.contact.stops.time_constant, G * slope / math.hypot(1, slope)
    # springs of the stiffness m / T^2 at all corners; corners that begin to touch slide first
    deflection = pull * constant**2
    shift = (place[-1] - place[0]) / deflection
    holds("displacement / (g T^2 sin a)", shift, below=1.25, by="deflection of the springs")
    later = int(np.searchsorted(record.time, record.time[-1] - 10 * constant))
    crept = np.ptp(place[later:]) / deflection
    holds("displacement in ten time constants / (g T^2 sin a)", crept, below=1e-6, by="static friction")
    stored, mass = record.series["friction_spring_energy"][-1], DENSITY * THICK * ON_BASE[0][0] ** 2
    agree(
        "energy of the springs", stored, mass * pull**2 * constant**2 / 2, unit="J", by="m (g T sin a)^2 / 2", rel=0.05
    )
    balance = energy_balance(record)
    assert balance.friction_springs == pytest.approx(stored)
    holds("residual of the energy balance", balance.residual, below=0.005, by="the energy balance")


def test_a_facet_on_friction_springs_swings_with_the_time_constant_and_damping_ratio_of_contact(agree, holds):
    constant, ratio, force, lasts = 1e-3, 0.5, 3e-4, (0.01, 0.005)
    tables = HELD.format(friction=1.0).replace("0.4 ms", "1 ms") + f"damping_ratio = {ratio}\n"
    design = loose_layers(
        ON_BASE,
        0.06,
        more=tables + PUSH.replace("0.004", str(force)),
        stages=STAGES.replace("0.006", str(lasts[0])).replace("0.04", str(lasts[1])),
    )
    # panels are stiff in comparison with the springs
    values = {"facet.youngs_modulus": 5e7, "protocol.sample_interval": 1e-4}
    record, place, _ = sliding(design.with_values(values))
    start = int(np.searchsorted(record.time, lasts[0] - 1e-9))
    time, mass = record.time[start:] - record.time[start], DENSITY * THICK * ON_BASE[0][0] ** 2
    stretch = 4 * force * (constant * ratio) ** 2 / mass
    rate = math.sqrt(1 / ratio**2 - 1) / constant
    swing = np.exp(-time / constant) * (np.cos(rate * time) + np.sin(rate * time) / (rate * constant))
    ours = (place[start:] - place[-1]) / stretch
    agree("displacement / (F / k)", ours, swing, by="damped oscillator", unit="1", abs=0.05, over=("t, s", time))
    holds("residual of the energy balance", energy_balance(record).residual, below=0.005, by="the energy balance")


def test_a_held_facet_keeps_its_place_where_a_stage_ends():
    (whole, place, _), times = inclined(0.3, 0.2, 0.006), (0.00235, 0.00365)
    stages = [
        {"name": f"rest {time}", "drive": "none", "until": "time", "hold": 0.0, "time_limit": time} for time in times
    ]
    divided, again, _ = inclined(0.3, 0.2, **{"protocol.stages": stages})
    assert again[-1] == place[-1]
    for name in ("friction_spring_energy", "contact_work"):
        assert divided.series[name][-1] == whole.series[name][-1]


def test_the_deflection_of_static_friction_converges_with_the_first_power_of_the_timestep(agree):
    timesteps = [2.5e-5, 1.25e-5, 6.25e-6]
    ends = [inclined(0.3, 0.2, 0.001, **{"protocol.timestep": step})[1] for step in timesteps]
    shifts = [place[-1] - place[0] for place in ends]
    order = math.log2((shifts[0] - shifts[1]) / (shifts[1] - shifts[2]))
    agree("order of convergence in the timestep", order, 1, by="forces that are constant in a step", unit="1", abs=0.3)


LENGTH, LIFTED, HEIGHT = 0.1, 0.06, 2e-3
WEIGHT = DENSITY * G * THICK  # per area, N/m^2
# a slender strip on which nothing but its weight acts is lifted by H over (72 B H / q)^(1/4)
BENDING = WEIGHT * LIFTED**4 / (72 * HEIGHT)
PANELS = {5: 0.05, 10: 0.015, 20: 0.005, 40: 0.0025}  # allowed error of the contact force


@pytest.fixture(scope="module")
def sagging():
    """Contact force, N, and x and height of the middle surface, m, of a clamped strip that sags onto a facet."""
    result = {}
    for panels in PANELS:
        structure = structure_of(strip_above_facet(panels, LENGTH, HEIGHT, BENDING))
        net = net_of(structure)
        shape, _ = released(net, start_shape(structure, net))
        assert shape.stable
        places = (net.points @ shape.shape.positions)[5 : panels + 6]
        result[panels] = sum(contact_forces(net, shape.shape).values()), places[:, 0], places[:, 2]
    return result


def test_a_strip_that_sags_onto_a_facet_converges_in_its_panels_to_a_heavy_beam_with_a_free_touchdown(sagging, agree):
    # at the touchdown the beam has no moment, so y = q (4 a x^3 - 3 x^4) / (72 B) at a distance x from it
    force = WIDTH * WEIGHT * (LENGTH - 2 * LIFTED / 3)
    errors = [abs(sagging[panels][0] / force - 1) for panels in PANELS]
    for panels, allowed in PANELS.items():
        name = f"contact force of {panels} panels"
        agree(name, sagging[panels][0], force, by="w q (L - 2 a / 3)", unit="N", rel=allowed)
    order = math.log2(errors[0] / errors[2]) / 2
    agree("order of convergence in the panels", order, 2, by="spring hinges for a beam", unit="1", abs=0.4)
    _, x, height = sagging[20]
    free = np.maximum(LIFTED - x, 0)
    beam = WEIGHT * (4 * LIFTED * free**3 - 3 * free**4) / (72 * BENDING)
    agree("height of 20 panels", height, beam, by="heavy beam", unit="m", abs=0.02 * HEIGHT, over=("x, m", x))
