from dataclasses import replace

import numpy as np
import pytest

from forficula.analysis.energy_by_mechanism import energy_shares
from forficula.design import load_design
from forficula.dynamics import energy_balance
from forficula.structure import Mechanism
from forficula.study.running.runs import run

TOTALS = ("tendon_energy", "membrane_energy", "hinge_energy", "spring_energy", "coupling_energy", "branch_energy")


def total(record):
    """Sum of the recorded energies of all elements, J, (time,)."""
    series = [record.series[name] for name in TOTALS if name in record.series]
    return sum(values.reshape(len(record.time), -1).sum(axis=1) for values in series)


def by_panel(record):
    """The run of a wing in which every panel with the tendon of its vein is a mechanism."""
    mechanisms = (
        Mechanism(name="inner", tendons=(0, 1), membranes=(0,)),
        Mechanism(name="outer", tendons=(2,), membranes=(1,)),
    )
    return replace(record, structure=replace(record.structure, mechanisms=mechanisms))


def test_energies_of_mechanisms_add_up_to_the_recorded_energies(reference_run, letter_run, snap_run):
    for record in (reference_run, letter_run, snap_run):
        stored = sum(energy_shares(record).stored.values())
        np.testing.assert_allclose(stored, total(record), rtol=1e-12, atol=1e-15 * total(record).max())


def test_energies_of_single_membranes_add_up_to_that_of_all(reference_run):
    stored = energy_shares(by_panel(reference_run)).stored
    assert list(stored) == ["inner", "outer"]
    assert min(values.max() for values in stored.values()) > 0.1 * total(reference_run).max()
    np.testing.assert_allclose(
        stored["inner"] + stored["outer"], total(reference_run), rtol=1e-9, atol=1e-9 * total(reference_run).max()
    )


def test_stored_energy_motion_and_losses_equal_the_work_put_in(reference_run, letter_run, snap_run):
    for record in (reference_run, letter_run, snap_run):
        shares, balance = energy_shares(record), energy_balance(record)
        assert shares.missing[0] == pytest.approx(0, abs=1e-15)
        assert shares.missing[-1] == pytest.approx(balance.missing, abs=1e-9 * balance.exchanged)
        # the step in which an axis meets its stop has the largest error
        assert np.abs(shares.missing).max() < 0.02 * shares.supplied.max()


def test_weight_is_measured_from_its_lowest_value():
    stage = {"hold": "0 s", "drive": "none", "until": "time", "name": "fall", "time_limit": "50 ms"}
    record = run(load_design("binder2025-joint", {"protocol.gravity": "9.81 m/s^2", "protocol.stages": [stage]}))
    shares = energy_shares(record)
    assert shares.weight is not None
    assert shares.weight.min() == 0
    assert np.ptp(shares.weight) == pytest.approx(np.ptp(record.series["gravitational_energy"]))
    assert np.abs(shares.missing).max() < 0.02 * shares.supplied.max()


def test_maxwell_branches_belong_to_the_mechanism_of_their_tendons(stored_run):
    stored = energy_shares(stored_run).stored
    branches = stored_run.series["branch_energy"].sum(axis=1)
    assert branches.max() > 0
    np.testing.assert_allclose(
        stored["tendons"], stored_run.series["tendon_energy"].sum(axis=1) + branches, rtol=1e-12, atol=1e-18
    )
