"""Statements of the documentation on chosen values: share of the armature, and use of the work of a constant torque.

Semi-implicit Euler moves a hinge by its velocity times the timestep, so rows at every step give velocities exactly.
"""

import math

import numpy as np
import pytest

import forficula as ff
from forficula.design import with_values
from forficula.pattern import hub_points, ring_vertices, tips


def folding(design, **settings):
    """A run of settling and folding with a row at every step."""
    values = {key.replace("__", "."): value for key, value in settings.items()}
    step = design.protocol.timestep
    design = with_values(design, {"protocol.sample_interval": step, **values})
    stages = design.protocol.stages[:2]
    return ff.run(
        design.model_copy(update={"protocol": design.protocol.model_copy(update={"stages": stages})}), confirm=False
    )


def test_the_armature_is_twenty_times_the_inertia_of_a_vein_about_its_axis(reference, agree):
    """The inertia is that of two thin rods, one along the axis and one at the angle of the creases, m l^2 sin^2 / 3."""
    hubs, rings, ends = hub_points(reference.fan), ring_vertices(reference.fan), tips(reference.fan)
    proximal, distal = (rings - hubs)[0], (ends - rings)[0]
    lengths = [np.linalg.norm(bar) for bar in (proximal, distal)]
    cosine = float(proximal @ distal / np.prod(lengths))
    radius = reference.vein.diameter / 2
    line = reference.vein.density * math.pi * radius**2
    inertia = line * lengths[1] ** 3 * (1 - cosine**2) / 3 + line * lengths[0] * radius**2 / 2
    agree(
        "armature divided by the inertia of a vein",
        reference.hinge.armature / inertia,
        20,
        by="documentation",
        rel=0.05,
    )


@pytest.mark.parametrize(("stiffness", "rest_length"), [("10 N/cm", "9 cm"), ("10 N/cm", "4 cm"), ("60 N/cm", "8 cm")])
def test_the_armature_carries_more_than_half_of_the_kinetic_energy_at_its_peak(
    holds, reference, stiffness, rest_length
):
    record = folding(reference, tendon__stiffness=stiffness, tendon__rest_length=rest_length)
    step, armature = record.design.protocol.timestep, record.design.hinge.armature
    speeds = np.diff(record.series["hinge_angle"], axis=0) / step
    carried = armature / 2 * np.sum(speeds**2, axis=1)
    start = np.searchsorted(record.time, record.stages[1].start)
    kinetic = record.series["kinetic_energy"][1:]
    peak = start + int(np.argmax(kinetic[start:]))
    assert record.stages[1].goal_time is not None
    holds("share of the armature in the largest kinetic energy", carried[peak] / kinetic[peak], above=0.55, below=0.81)


@pytest.mark.parametrize("stiffness", ["10 N/cm", "30 N/cm", "60 N/cm"])
def test_the_work_of_a_constant_torque_hardly_depends_on_the_tendon(holds, reference, stiffness):
    outcome = ff.measure(ff.run(with_values(reference, {"tendon.stiffness": stiffness}), confirm=False))
    veins = reference.fan.vein_count
    for name, least, most in (("fold", 85, 91), ("unfold", 250, 278)):
        # a vein turns by 90 deg; a distal hinge bends by 183 deg and the vein turns back by 95
        transition = outcome.transitions[name]
        turned = math.degrees(transition.work / veins / transition.strength)
        holds(f"work divided by torque of a vein, {name}", turned, above=least, below=most, unit="deg")


def test_stops_dissipate_two_fifths_of_the_work_of_folding_and_half_of_the_work_of_opening(reference_run, agree):
    series, time = reference_run.series, reference_run.time
    shares = {}
    for place, stage in enumerate(reference_run.stages):
        if stage.stage.drive != "none":
            # until the wing is at rest again
            rows = np.searchsorted(time, [stage.start, reference_run.stages[place + 1].end - 1e-9])
            work = np.diff(reference_run.work[rows])
            shares[stage.stage.drive] = float(np.diff(-series["stop_work"][rows])[0] / work[0])
    agree("share of the work of folding dissipated by stops", shares["fold"], 0.41, by="documentation", abs=0.02)
    agree("share of the work of opening dissipated by stops", shares["unfold"], 0.5, by="documentation", abs=0.03)
