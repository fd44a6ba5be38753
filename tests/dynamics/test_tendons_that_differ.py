"""Tendons of one structure with different laws: each follows its own law, and the energy balance closes."""

from dataclasses import replace

import numpy as np
import pytest

import forficula as ff
from forficula.design import with_values
from forficula.dynamics import compile_model, design_in_model_units, simulate
from forficula.structure import structure_of
from tests.structures import compiled

SHORT = {
    "tendon.rest_length": 0.09,
    "protocol.timestep": 2e-4,
    "protocol.window": 0.01,
    "protocol.stages.0.time_limit": 0.02,
    **{f"protocol.stages.{stage}.time_limit": 0.1 for stage in (1, 2, 3, 4)},
    **{f"protocol.stages.{stage}.hold": 0.01 for stage in (2, 3, 4)},
}
BRANCHES = [{"modulus": 1e6, "time": 0.002}, {"modulus": 5e5, "time": 0.02}]
LINEAR = with_values(ff.load_design("binder2025"), SHORT)


def of_law(**law):
    values = {"tendon.area": 18.75e-6, "tendon.law": {"linear_modulus": 4.8e6} | law}
    return with_values(LINEAR, values)


def mixed(*designs):
    """Return the first design's wing with the tendon of another design on each vein; None for no tendon."""

    def build(design, units):
        structure = structure_of(design)
        tendons = [
            replace(structure.tendons[vein], law=structure_of(design_in_model_units(design, units)).tendons[vein].law)
            for vein, design in enumerate(designs)
            if design is not None
        ]
        return replace(structure, tendons=tuple(tendons))

    return compiled(designs[0], build)


def run(model):
    (record,) = simulate([model])
    assert record.diverged_at is None
    return record


def assert_each_has_its_own_energy(record):
    lengths, energies = record.series["tendon_length"], record.series["tendon_energy"]
    crept = np.zeros_like(lengths)
    if "tendon_rest_length" in record.series:
        crept = record.series["tendon_rest_length"] - [tendon.law.rest_length for tendon in record.structure.tendons]
    for number, tendon in enumerate(record.structure.tendons):
        stored = tendon.law.elastic.energy(lengths[:, number] - crept[:, number])
        # rounding
        assert energies[:, number] == pytest.approx(stored, abs=1e-12)


def test_identical_tendons_have_the_bits_of_the_design():
    ours, theirs = run(mixed(LINEAR, LINEAR, LINEAR)), run(compile_model(LINEAR))
    for name, values in theirs.series.items():
        assert values.tobytes() == ours.series[name].tobytes(), name


def test_a_vein_may_be_without_a_tendon():
    record = run(mixed(LINEAR, None, LINEAR))
    assert [tendon.name for tendon in record.structure.tendons] == ["tendon0", "tendon2"]
    assert record.series["tendon_length"].shape[1] == 2
    assert_each_has_its_own_energy(record)
    whole = run(compile_model(LINEAR))
    assert np.array_equal(record.series["tendon_length"][0], whole.series["tendon_length"][0, [0, 2]])
    outcome = ff.measure(record)
    assert outcome.energy_balance.residual < 5e-3
    assert len(outcome.states["flat"].tendon_energy) == 2


def test_a_wing_without_tendons_holds_no_energy_in_them():
    def bare(design, _):
        return replace(structure_of(design), tendons=())

    record = run(compiled(LINEAR, bare))
    outcome = ff.measure(record)
    assert outcome.energy_balance.tendon == 0
    assert outcome.energy_balance.residual < 5e-3
    assert record.series["tendon_energy"].shape[1] == 0


def test_each_tendon_has_the_energy_of_its_own_law():
    stiff = with_values(LINEAR, {"tendon.stiffness": 2000.0, "tendon.rest_length": 0.08})
    stiffening = of_law(quadratic_modulus=-1e6, cubic_modulus=2e6)
    record = run(mixed(LINEAR, stiff, stiffening))
    laws = [tendon.law for tendon in record.structure.tendons]
    assert [law.stiffness[0] for law in laws] == pytest.approx([1000.0, 2000.0, 1000.0])
    assert [law.rest_length for law in laws] == [0.09, 0.08, 0.09]
    assert_each_has_its_own_energy(record)
    assert ff.measure(record).energy_balance.residual < 5e-3
    # a single law does not fit all of them
    stored = record.series["tendon_energy"][0]
    assert len(set(stored.round(6))) == 3


def test_a_tendon_that_yields_beside_others_that_do_not():
    record = run(mixed(LINEAR, of_law(yield_strain=0.15), LINEAR))
    rests = record.series["tendon_rest_length"]
    assert rests[:, [0, 2]].tolist() == [[0.09, 0.09]] * len(rests)
    # 11 cm are more than 1.15 * 9 cm
    assert rests[0, 1] == pytest.approx(record.series["tendon_length"][0, 1] - 0.15 * 0.09, abs=1e-12)
    assert_each_has_its_own_energy(record)
    balance = ff.measure(record).energy_balance
    force = record.structure.tendons[1].law.yield_force
    assert balance.yielding == pytest.approx(force * (rests[-1, 1] - rests[0, 1]), rel=1e-9, abs=1e-12)
    assert balance.residual < 5e-3


def maxwell_energy(record, number):
    """Return the energy of a tendon's branches, J, by the exact solution for lengths linear between rows."""
    length, timestep = record.series["tendon_length"][:, number], record.design.protocol.timestep
    # one row per step, two where stages meet
    rows = np.concatenate([[True], np.diff(record.time) > timestep / 2])
    length = length[rows]
    energy = np.zeros(len(length))
    for branch in record.structure.tendons[number].law.branches:
        force, kept = np.zeros(len(length)), np.exp(-timestep / branch.time)
        for step, rate in enumerate(np.diff(length) / timestep):
            force[step + 1] = kept * force[step] + branch.stiffness * branch.time * (1 - kept) * rate
        energy += force**2 / (2 * branch.stiffness)
    return energy, rows


@pytest.mark.parametrize("order", [(0, 1, 2), (2, 0, 1), (1, 2, 0)])
def test_numbers_of_branches_may_differ_from_tendon_to_tendon(order):
    every_step = {"protocol.timestep": 1e-4, "protocol.sample_interval": 1e-4}
    kinds = [LINEAR, of_law(branches=BRANCHES[:1]), of_law(branches=BRANCHES)]
    model = mixed(*(with_values(kinds[kind], every_step) for kind in order))
    assert [(row >= 0).sum() for row in model.branches] == list(order)
    assert sorted(model.branches[model.branches >= 0].tolist()) == [0, 1, 2]
    record = run(model)
    assert_each_has_its_own_energy(record)
    energies = record.series["branch_energy"]
    for number, kind in enumerate(order):
        if kind == 0:
            assert not energies[:, number].any()
            continue
        expected, rows = maxwell_energy(record, number)
        # the engine uses the velocity of the previous step: 0.1 ms of 2 ms
        assert np.abs(energies[rows, number] - expected).max() < 0.1 * expected.max()
    balance = ff.measure(record).energy_balance
    assert balance.branch_damping > 0
    assert balance.residual < 5e-3


def test_only_pull_only_tendons_are_clamped():
    lets_go = of_law(branches=BRANCHES)
    linear, holds = (with_values(item, {"tendon.pushes_when_slack": True}) for item in (LINEAR, lets_go))
    models = [mixed(linear, holds, lets_go), mixed(linear, holds, holds), mixed(lets_go, lets_go, lets_go)]
    assert [model.lets_go.tolist() for model in models] == [
        [False, False, True],
        [False, False, False],
        [True, True, True],
    ]
    one, none, every = (run(model) for model in models)
    assert "letting_go_work" not in none.series
    assert 0 < one.series["letting_go_work"][-1] < every.series["letting_go_work"][-1]
    for record in (one, none, every):
        assert_each_has_its_own_energy(record)
        balance = ff.measure(record).energy_balance
        assert balance.residual < 5e-3
    assert (ff.measure(none).energy_balance.letting_go, ff.measure(one).energy_balance.letting_go < 0) == (None, True)


def test_wings_whose_tendons_differ_run_side_by_side_without_a_bit_of_difference():
    models = [mixed(LINEAR, of_law(branches=BRANCHES), of_law(branches=BRANCHES[:1])) for _ in range(2)]
    models.append(mixed(of_law(branches=BRANCHES), LINEAR, of_law(branches=BRANCHES[:1])))
    alone = [run(model) for model in models]
    for record, other in zip(simulate(models, threads=2), alone, strict=True):
        for name, values in other.series.items():
            assert values.tobytes() == record.series[name].tobytes(), name
    (sparse,) = simulate(models[:1], sparse=True)
    assert repr(ff.measure(sparse).energy_balance) == repr(ff.measure(alone[0]).energy_balance)
