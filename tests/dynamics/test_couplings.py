"""Coupled joints: the frequencies of two pendulums have closed forms, and work is counted at the driven joint.

Two equal ones, I phi'' = -k phi, with a spring kc between them: sqrt(k / I) in phase, sqrt((k + 2 kc) / I) in
antiphase. Rigidly coupled at a ratio r: sqrt((k0 + r^2 k1) / (I (1 + r^2))).
"""

import math
from dataclasses import replace

import numpy as np
import pytest

import forficula as ff
from forficula.analysis import summary
from forficula.design import load_design, with_values
from forficula.dynamics import compile_model, energy_balance, simulate
from forficula.show.run.outcome_rows import state_rows
from forficula.structure import Coupling, hinges_of
from forficula.structure.fans.veins import structure_of_veins
from forficula.study.running.runs import run_each, topology
from tests.structures import compiled, motor_work, straight_vein

STIFFNESS, TIE, START = 0.05, 0.2, math.radians(5)  # N m/rad
TIED = with_values(load_design("binder2025-coupled"), {"protocol.rise": 0.0})
# folding only, under torques without rise
FOLDING = [
    {"name": "fold", "drive": "none", "until": "time", "hold": 0.0, "time_limit": 0.02},
    {"name": "fold", "drive": "fold", "until": "time", "hold": 0.0, "time_limit": 0.06},
]


def pendulums(one_hinge, starts, *, tie, ratio=1.0, springs=(STIFFNESS, STIFFNESS), senses=(1, -1), **values):
    """Return two bars side by side, each on a sprung hinge, with a spring between them and slack tendons."""
    hinge = one_hinge(0.11, start=0.0, **values)

    def build(design, units):
        veins = []
        for place, sense in enumerate(senses):
            vein = straight_vein(design)
            beside = place * np.array([0.0, design.pattern.proximal_length, 0.0])
            veins.append(replace(vein, sense=sense, places=tuple(place + beside for place in vein.places)))
        built = structure_of_veins(design, veins)
        hinges = tuple(
            replace(hinge, stiffness=spring / units.energy, start=start, lower=-math.inf, upper=math.inf)
            for hinge, spring, start in zip(built.hinges, springs, starts, strict=True)
        )
        coupling = Coupling(name="tie", hinges=(0, 1), stiffness=tie / units.energy, ratio=ratio)
        return replace(built, hinges=hinges, couplings=(coupling,), membranes=(), limits=(), tendons=())

    return hinge.inertia, compiled(hinge.wing.design, build)


def swing(model):
    """Return times, and angles in the hinges' own senses."""
    record = simulate([model])[0]
    return record, record.time, record.series["hinge_angle"]


@pytest.mark.parametrize("senses", [(1, 1), (1, -1)])
@pytest.mark.parametrize(("way", "added"), [(1.0, 0.0), (-1.0, 2.0)])
def test_two_tied_pendulums_swing_side_by_side_and_against_each_other_as_in_closed_form(one_hinge, senses, way, added):
    inertia = one_hinge().inertia
    speed = math.sqrt((STIFFNESS + added * TIE) / inertia)
    timestep = 2 * math.pi / speed / 2000
    _, model = pendulums(
        one_hinge, (START, way * START), tie=TIE, senses=senses, timestep=timestep, duration=2500 * timestep
    )
    record, times, angles = swing(model)
    # phase error of semi-implicit Euler: half a timestep
    assert angles[:, 0] == pytest.approx(START * np.cos(speed * times), abs=4e-3 * START)
    assert angles[:, 1] == pytest.approx(way * angles[:, 0], abs=1e-9)
    twist = angles[:, 1] - angles[:, 0]
    assert record.series["coupling_energy"][:, 0] == pytest.approx(TIE / 2 * twist**2, abs=1e-12)
    assert energy_balance(record).residual < 1e-4


@pytest.mark.parametrize("ratio", [1.0, 2.0, -0.5])
def test_two_pendulums_tied_rigidly_turn_in_their_ratio_with_the_inertia_of_both(one_hinge, ratio):
    inertia, springs = one_hinge().inertia, (0.05, 0.02)
    speed = math.sqrt((springs[0] + ratio**2 * springs[1]) / (inertia * (1 + ratio**2)))
    timestep = 2 * math.pi / speed / 2000
    _, model = pendulums(
        one_hinge,
        (START, ratio * START),
        tie=math.inf,
        ratio=ratio,
        springs=springs,
        timestep=timestep,
        duration=2500 * timestep,
    )
    record, times, angles = swing(model)
    assert angles[:, 1] == pytest.approx(ratio * angles[:, 0], abs=1e-4 * START)
    assert angles[:, 0] == pytest.approx(START * np.cos(speed * times), abs=4e-3 * START)
    assert "coupling_energy" not in record.series
    balance = energy_balance(record)
    # the coupling does no work
    assert abs(balance.stops) < 1e-4 * balance.at_hand
    assert balance.couplings is None


def folded(torque, veins, **values):
    design = with_values(
        TIED,
        {
            "protocol.fold_torque": torque,
            "protocol.driven_veins": veins,
            "protocol.timestep": 1e-4,
            "protocol.stages": FOLDING,
            **values,
        },
    )
    return simulate([compile_model(design)])[0]


@pytest.fixture(scope="module")
def by_one():
    return folded(0.3, [0])


@pytest.mark.parametrize(("torque", "veins"), [(0.1, [0, 1, 2]), (0.15, [0, 2]), (0.3, [1])])
def test_veins_tied_rigidly_fold_under_one_motor_as_under_motors_with_the_same_torque_together(by_one, torque, veins):
    by_more = folded(torque, veins)
    angles, others = by_one.series["hinge_angle"], by_more.series["hinge_angle"]
    assert np.ptp(angles, axis=0).max() > math.radians(90)
    # the engine's constraints yield slightly
    assert others == pytest.approx(angles, abs=math.radians(0.1))
    assert by_more.work[-1] == pytest.approx(by_one.work[-1], rel=1e-4)


def test_the_work_is_that_of_the_motor_on_its_own_vein(by_one):
    turns = hinges_of(by_one.structure, "turn")
    # the torque is constant in the stage
    turned = (
        by_one.series["hinge_angle"][-1, turns[0]] - by_one.series["hinge_angle"][by_one.time <= 0.02][-1, turns[0]]
    )
    assert motor_work(by_one, "proximal")[-1] == pytest.approx(0.3 * turned, rel=1e-3)
    assert motor_work(by_one, "distal")[-1] == 0
    twisted = np.abs(np.diff(by_one.series["hinge_angle"][:, turns], axis=1)).max()
    assert twisted < math.radians(0.01)


@pytest.mark.parametrize("stiffness", [0.3, 3.0, "rigid"])
def test_the_energy_balance_of_a_wing_with_rigid_couplings_closes(stiffness):
    record = folded(0.3, [0], **{"coupling.stiffness": stiffness})
    balance = energy_balance(record)
    assert balance.residual < 1e-3
    if stiffness == "rigid":
        assert balance.couplings is None
    else:
        energy = record.series["coupling_energy"]
        assert energy.shape[1] == 2
        assert energy.max() > 1e-3
        assert balance.couplings == pytest.approx(energy[-1].sum() - energy[0].sum())
        assert record.data["coupling_energy"].dims == ("time", "coupling")


def test_stiffer_couplings_converge_to_a_rigid_coupling(by_one):
    off = []
    for stiffness in (10.0, 40.0):
        record = folded(0.3, [0], **{"coupling.stiffness": stiffness, "protocol.timestep": 5e-5})
        off.append(np.abs(record.series["hinge_angle"][-1] - by_one.series["hinge_angle"][-1]).max())
    assert off[1] < off[0]


def test_wings_with_motors_on_other_veins_run_side_by_side_as_each_alone():
    designs = [
        with_values(
            TIED, {"protocol.driven_veins": [vein], "protocol.stages": FOLDING, "coupling.stiffness": stiffness}
        )
        for vein in (0, 2)
        for stiffness in (1.0, "rigid")
    ]
    assert len({topology(compile_model(design)) for design in designs}) == 4
    results = dict(run_each(designs))
    for number, design in enumerate(designs):
        assert np.array_equal(
            results[number].series["hinge_angle"], ff.run(design, confirm=False).series["hinge_angle"]
        )
        assert np.array_equal(results[number].work, ff.run(design, confirm=False).work)


def test_the_energy_of_elastic_couplings_is_reported_for_every_state():
    stages = [{**FOLDING[0], "state": "flat"}, {**FOLDING[1], "state": "folded"}]
    record = ff.run(
        with_values(TIED, {"protocol.stages": stages, "coupling.stiffness": 0.5, "protocol.window": 0.01}),
        confirm=False,
    )
    twist = np.diff(record.series["hinge_angle"][:, list(hinges_of(record.structure, "turn"))], axis=1)
    outcome, last = ff.measure(record), record.time >= record.time[-1] - 0.01 - 1e-9
    state = outcome.states["folded"]
    assert state.coupling_energy == pytest.approx((0.5 / 2 * twist[last] ** 2).mean(axis=0))
    assert summary(record, outcome, {})["states"]["folded"]["coupling_energy_J"] == state.coupling_energy.tolist()
    assert ["couplings", f"{1e3 * state.coupling_energy.sum():.4g}"] in [
        [row[0], row[-1]] for row in state_rows(record.structure, {"folded": state}).parts
    ]
