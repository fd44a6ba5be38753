"""Results print with units."""

import re
from dataclasses import replace

import forficula as ff
from forficula.dynamics import energy_balance
from forficula.make.checks.check import count_check, least_check
from forficula.material import MaterialLaw, MaxwellBranch, load_law


def test_laws_print_their_values_with_units():
    assert repr(load_law("tpu-82a")) == "<MaterialLaw tpu-82a: modulus.linear 4.8 MPa, largest_strain 100 %>"
    law = MaterialLaw(name="gel", viscosity=(2e5, 0.0, 0.0), branches=(MaxwellBranch(modulus=1e6, time=0.5),))
    assert repr(law) == (
        "<MaterialLaw gel: viscosity.linear 0.2 MPa s, branches.0.modulus 1 MPa, branches.0.time 0.5 s>"
    )


def test_hinges_of_a_landscape_print_their_states_with_units(landscape_of):
    landscape = landscape_of(ff.load_design("binder2025-joint"))
    (hinge,) = landscape.hinges
    assert repr(hinge) == (
        "<CrossedHinge 0 under tendon 0: stop at 3 deg with 0.4801 J, neutral at -123.2 deg with 0 J, barrier 7.025 mJ>"
    )
    assert repr(hinge.actual).startswith("<HingeLandscape from 3 deg to -180 deg: stop at 3 deg")


def test_balances_print_their_energies_with_units(letter_run):
    energy = r"-?[\d.]+ [nµm]?J"
    text = rf"<EnergyBalance: work {energy}, exchanged {energy}, missing {energy} \(.* %\)>"
    assert re.fullmatch(text, repr(energy_balance(letter_run)))


def test_checks_print_value_and_limit_with_their_unit():
    passed = least_check("wall", "bar", measured=1.2e-3, least=1e-3, text="")
    assert repr(passed) == "<Check wall of bar: passed, 1.2 mm (limit 1 mm)>"
    failed = count_check("bodies", "bar", measured=2, wanted=1, held="", missed="")
    assert repr(failed) == "<Check bodies of bar: failed, 2 (limit 1)>"
    assert repr(replace(failed, ok=None)) == "<Check bodies of bar: not checked>"
