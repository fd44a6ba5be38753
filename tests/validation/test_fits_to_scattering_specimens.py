"""Fits to specimens of scattering amplitude recover the planted law, with correct intervals.

The data are generated from closed forms that the fit does not use; amplitudes follow a log-normal distribution.
"""

from dataclasses import replace

import numpy as np
import pytest

from forficula.material.fit.fit import fit_law
from forficula.material.law.law_family import family_forms
from forficula.material.law.law_file import law_values
from forficula.material.law.law_form import LawForm
from forficula.material.law.material_law import MaterialLaw, MaxwellBranch
from forficula.material.tensile.strain_history import StrainHistory
from tests.material.synthetic import loading_program, sampled, viscoelastic_stress

# four rates over two decades, three holds, and slack after fast unloading
STEPS = (
    *((0.3, 0.3), (None, 60), (0.6, 0.01), (None, 200), (0.2, 0.1)),
    *((0.8, 1.0), (None, 300), (0.3, 0.03), (1, 0.01), (0.2, 0.3)),
)
# three specimens, each at its own rate
OWN_RATES = (
    ((0.3, 0.01), (None, 60), (0.8, 0.01), (None, 200), (0.2, 0.01), (1, 0.01), (0.1, 0.01)),
    ((0.5, 0.1), (None, 100), (0.1, 0.1), (0.9, 0.1), (None, 200), (0.1, 0.1)),
    ((0.4, 1.0), (None, 100), (0.0, 1.0), (0.9, 1.0), (None, 300), (0.3, 1.0), (0.9, 1.0), (0.1, 1.0)),
)
CUBIC = (6e6, -5e6, 3e6)
NOISE = 3e4  # Pa
SPRING = MaterialLaw(name="spring", moduli=CUBIC)
VISCOUS = MaterialLaw(name="viscous", moduli=(5e6, 0, 0), viscosity=(1e6, 0, 0))
ZENER = MaterialLaw(name="Zener", moduli=CUBIC, branches=(MaxwellBranch(modulus=3e6, time=20.0),))
THREE = MaterialLaw(
    name="three branches",
    moduli=CUBIC,
    branches=tuple(
        MaxwellBranch(modulus=modulus, time=time) for modulus, time in ((3e6, 0.5), (2e6, 8.0), (2e6, 120.0))
    ),
)
FORMS = {
    "spring": LawForm(order=3),
    "viscous": LawForm(damper=1),
    "Zener": LawForm(order=3, branches=1),
    "three branches": LawForm(order=3, branches=3),
}
RIVALS = [
    LawForm(order=order, damper=damper, branches=branches)
    for damper, branches in ((0, 0), (1, 0), (2, 0), (0, 1), (1, 1), (0, 2))
    for order in (1, 3)
]


def specimens(law, *, scatter, rng, programs=(STEPS,) * 3, rows=12):
    """Histories of a law with scattering amplitude; noise and unknown force offsets are 1 % of the stress."""
    branches = [(branch.modulus, branch.time) for branch in law.branches]
    viscosity = (law.viscosity or (0.0,))[0]
    histories = []
    for steps in programs:
        knots = loading_program(steps)
        time = sampled(knots, rows=rows)
        strain, stress = viscoelastic_stress(knots, time, law.moduli, viscosity=viscosity, branches=branches)
        # a specimen becomes slack rather than push
        scaled = np.exp(scatter * rng.standard_normal()) * np.maximum(stress, 0)
        false = NOISE * (rng.standard_normal() + rng.standard_normal(len(time)))
        histories.append(StrainHistory(time=time, strain=strain, stress=scaled + false))
    return histories


def covered(law, fit):
    """Whether each interval holds the planted value, by key."""
    planted = law_values(law)
    return {interval.key: interval.low <= planted[interval.key] <= interval.high for interval in fit.law.intervals}


@pytest.mark.parametrize(
    ("law", "programs", "draws"),
    [(VISCOUS, (STEPS,) * 3, 100), (ZENER, (STEPS,) * 3, 100), (ZENER, OWN_RATES, 100), (THREE, (STEPS,) * 3, 30)],
    ids=["viscous", "Zener", "Zener, a rate each", "three branches"],
)
def test_intervals_of_95_percent_contain_the_true_value_in_at_least_90_of_100_draws(holds, law, programs, draws):
    form, held = FORMS[law.name], dict.fromkeys(FORMS[law.name].keys, 0)
    for draw in range(draws):
        rng = np.random.default_rng(draw)
        histories = specimens(law, scatter=rng.uniform(0, 0.1), rng=rng, programs=programs)
        fit = fit_law(histories, forms=[form])
        for key, inside in covered(law, fit).items():
            held[key] += inside
    # counts are integers: up to half a sample below 90 % counts as 90 %
    holds(
        f"intervals with the true value, of {draws} draws, {law.name}",
        min(held.values()),
        above=0.9 * draws - 0.5,
        by="intervals of 95 %",
    )


@pytest.mark.parametrize("law", [SPRING, VISCOUS, ZENER, THREE], ids=lambda law: law.name)
@pytest.mark.parametrize("scatter", [0.0, 0.01, 0.03, 0.1])
def test_the_true_law_is_chosen_for_any_scatter_of_the_specimens(agree, law, scatter):
    fit = fit_law(specimens(law, scatter=scatter, rng=np.random.default_rng(5)), forms=RIVALS)
    assert fit.form == FORMS[law.name]
    # the residual is the noise, and with a damper the error between samples where the rate reverses
    if law is not VISCOUS:
        agree("misfit", 1e-3 * fit.misfit, 1e-3 * NOISE, unit="kPa", by="the noise", rel=0.1)


def test_the_planted_scatter_is_recovered(agree):
    rng = np.random.default_rng(2)
    fit = fit_law(specimens(ZENER, scatter=0.05, rng=rng, programs=(STEPS,) * 40), forms=[FORMS["Zener"]])
    # a standard deviation from 40 samples has the relative error 1 / sqrt(78)
    agree("scatter of 40 specimens", fit.scatter, 0.05, by="planted value", rel=0.3)
    amplitudes = np.array([residual.amplitude for residual in fit.residuals])
    assert np.log(amplitudes).mean() == pytest.approx(0, abs=1e-9)
    assert np.log(amplitudes).std(ddof=1) == pytest.approx(fit.scatter)


def test_the_interval_of_the_modulus_of_three_specimens_depends_on_their_scatter(agree, holds):
    """The half width is Student's t of 2 times the scatter divided by sqrt(3), whatever the number of rows."""
    histories = specimens(ZENER, scatter=0.05, rng=np.random.default_rng(3), rows=60)
    fit = fit_law(histories, forms=[FORMS["Zener"]])
    (modulus,) = [interval for interval in fit.law.intervals if interval.key == "modulus.linear"]
    width = 2 * 4.303 * fit.scatter / np.sqrt(3)
    agree("width of the interval", np.log(modulus.high / modulus.low), width, by="Student's t of 2", rel=0.05)
    # relaxation times do not scatter
    (time,) = [interval for interval in fit.law.intervals if interval.key == "branches.0.time"]
    holds("upper divided by lower end of the interval of a time", time.high / time.low, below=1.05)


def test_a_single_specimen_has_no_scatter():
    fit = fit_law(
        specimens(ZENER, scatter=0.05, rng=np.random.default_rng(3), programs=(STEPS,)), forms=[FORMS["Zener"]]
    )
    assert fit.scatter is None
    assert [residual.amplitude for residual in fit.residuals] == [1.0]


def test_a_series_has_as_many_branches_as_the_data_can_distinguish(agree):
    """Three branches of 0.5, 8 and 120 s; at most two had been tried."""
    rng = np.random.default_rng(1)
    cubic = [form for form in family_forms("prony") if form.order == 3]
    fit = fit_law(specimens(THREE, scatter=0.05, rng=rng), forms=cubic)
    times = [branch.time for branch in fit.law.branches]
    agree("times of the branches", times, [0.5, 8.0, 120.0], unit="s", by="planted value", rel=0.3)
    tried = {candidate.form.branches for candidate in fit.candidates}
    assert tried == {2, 3, 4}
    shortened = replace(THREE, branches=THREE.branches[1:])
    fit = fit_law(specimens(shortened, scatter=0.05, rng=rng), forms=cubic)
    assert len(fit.law.branches) == 2
