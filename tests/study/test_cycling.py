"""Wings over cycles: effect of the law's drift on the tendons, and the cycle at which the wing stops folding."""

import math
from dataclasses import replace

import numpy as np
import pytest

from forficula.design import design_from_text, design_text, load_design, with_values
from forficula.errors import InputError
from forficula.material.characterisation import characterise
from forficula.material.law.drift import Drift
from forficula.material.law.law_family import family_forms
from forficula.material.law.law_file import load_law, save_law
from forficula.material.law.material_law import MaterialLaw, MaxwellBranch
from forficula.material.law.softening import OgdenRoxburgh
from forficula.structure import built_strains, structure_of
from forficula.study.cycling import check_cycles, cycle_counts, design_at_cycle, run_cycles, why_unchanged
from forficula.study.running.evaluate import evaluate
from tests.material.synthetic import cyclic_test

LAW = MaterialLaw(name="rubber", moduli=(4.8e6, 0.0, 0.0))
FADING = Drift(kind="logarithm", rate=-0.3, interval=(-0.32, -0.28), cycles=0.0, relative=True, seen=(1, 4))
NO_DRIFT = Drift(kind="none", rate=0.0, interval=(0.0, 0.0), cycles=0.0, relative=True, seen=(2, 5))
LONGER = Drift(kind="plateau", rate=0.02, interval=(0.01, 0.03), cycles=1.5, relative=False, seen=(2, 5))
SETTLE = {"name": "settle", "drive": "none", "until": "time", "hold": 0.0, "time_limit": 0.05}
FOLD = {"name": "fold", "drive": "fold", "until": "folded", "hold": 0.0, "time_limit": 0.1}


def folding(law: MaterialLaw | None, **values):
    """The reference, folded within 0.1 s, with tendons of a law."""
    protocol = {"protocol.timestep": "0.4 ms", "stops.time_constant": "2 ms", "protocol.window": "10 ms"}
    design = with_values(load_design("binder2025", protocol), {"protocol.stages": [SETTLE, FOLD], **values})
    return design if law is None else with_values(design, {"tendon.law": law, "tendon.area": 18.75e-6})


@pytest.fixture
def without_statics(monkeypatch):
    """Skip the least slow torques, on which only margins depend."""
    unknown = "forficula.study.cycling.least_slow_torques"
    # for folding and unfolding
    monkeypatch.setattr(unknown, lambda designs: (np.full(len(designs), np.nan),) * 2)


@pytest.mark.usefixtures("without_statics")
def test_specimens_that_soften_give_a_wing_that_softens_as_they_do(tmp_path):
    rate = -0.05
    tests = [
        cyclic_test(lambda strain, n: 4.8e6 * n**rate * strain, samples=60, noise=1e3, seed=seed) for seed in (1, 2, 3)
    ]
    result = characterise(tests, name="rubber", forms=family_forms("linear"))
    save_law(result.law, tmp_path / "law.toml")
    law = load_law(tmp_path / "law.toml")
    assert law == result.law
    assert law.stiffness_drift.kind == "logarithm"
    # three standard errors of noise of 0.02 % of the peak in twelve cycles
    assert law.stiffness_drift.rate == pytest.approx(rate, abs=5e-4)
    assert law.stiffness_drift.seen == (2, 5)
    settings = {"tendon.law": str(tmp_path / "law.toml"), "tendon.area": "18.75 mm^2"}
    cycling = run_cycles(with_values(load_design("binder2025", settings), {"protocol.stages": [SETTLE, FOLD]}), 5)
    energy = [run.row["flat_energy_J"] for run in cycling.runs]
    # the overbend holds the flat wing, so its tendons keep their length except for the compliance of the stops
    assert [item / energy[1] for item in energy[2:]] == pytest.approx([(n / 2) ** rate for n in (3, 4, 5)], rel=1e-3)
    # the data do not contain the first cycle
    assert energy[0] == energy[1]
    assert [run.measured for run in cycling.runs] == [False, True, True, True, True]
    assert "cycle 1 is assumed to be like cycle 2" in cycling.remarks[0]


def test_residual_strain_does_not_also_soften_the_spring():
    def loading(strain, number):
        return 4.8e6 * (strain - 0.02 * math.log(number)).clip(0)

    result = characterise([cyclic_test(loading, samples=400)], name="rubber", forms=family_forms("linear"))
    longer, stiffness = result.law.residual_strain_drift, result.law.stiffness_drift
    assert longer.rate == pytest.approx(0.02, rel=0.02)
    # relative to no residual strain, the peak stress falls by 1.8 %
    assert abs(stiffness.change(5)[0] - 1) < 1e-3


def test_the_cycle_at_which_a_softening_wing_stops_folding_is_found():
    design = folding(replace(LAW, stiffness_drift=FADING))
    cycling = run_cycles(design, 12)
    weaker = [with_values(design, {"tendon.law.linear_modulus": 4.8e6 * n**-0.3}) for n in range(1, 13)]
    rows = sorted(evaluate(weaker), key=lambda row: -row["flat_energy_J"])
    first = [row["folded"] for row in rows].index(False) + 1
    assert 2 < first < 12
    assert cycling.first_failure == first
    assert cycling.verdict.startswith(
        f"folds up to cycle {first - 1}; at cycle {first}: at its goal when its stage ended, but not for long enough"
    )
    assert "cycles beyond 4 are extrapolated: the tests contain cycles 1 to 4" in cycling.remarks
    assert [run.measured for run in cycling.runs] == [n <= 4 for n in range(1, 13)]
    # a softer tendon yields to a smaller torque
    margins = [run.margins["fold"] for run in cycling.runs]
    assert margins == sorted(margins)
    assert margins[0] > 1


@pytest.mark.usefixtures("without_statics")
def test_a_robust_wing_still_folds_after_a_hundred_cycles():
    fading = replace(FADING, rate=-1e-3, interval=(-2e-3, 0.0))
    cycling = run_cycles(folding(replace(LAW, stiffness_drift=fading)), 100)
    assert cycling.verdict == "still folds after 100 cycles"
    assert cycling.first_failure is None
    assert [run.cycle for run in cycling.runs] == list(cycle_counts(100))


@pytest.mark.usefixtures("without_statics")
def test_alternating_success_over_cycles_is_reported(monkeypatch):
    def taking_turns(designs):
        for number, row in enumerate(evaluate(designs), start=1):
            yield row | {"folded": number in (1, 2, 4)}

    monkeypatch.setattr("forficula.study.cycling.evaluate", taking_turns)
    cycling = run_cycles(folding(replace(LAW, stiffness_drift=FADING)), 6)
    assert [cycling.works(run) for run in cycling.runs] == [True, True, False, True, False, False]
    assert cycling.verdict.endswith("; some later cycles do")
    assert not any("at rest" in remark for remark in cycling.remarks)
    (remark,) = [remark for remark in cycling.remarks if "alternates" in remark]
    assert remark.startswith("between cycles 3 and 5 success alternates")


@pytest.mark.usefixtures("without_statics")
def test_rested_maxwell_branches_are_reported():
    law = replace(LAW, stiffness_drift=FADING, branches=(MaxwellBranch(modulus=1e6, time=50.0),))
    assert any("begins with tendons at rest" in remark for remark in run_cycles(folding(law), 1).remarks)


def test_a_wing_that_never_folds_is_reported():
    resting = {"protocol.stages": [SETTLE, FOLD | {"time_limit": 0.5}], "protocol.fold_torque": 0.0}
    design = with_values(folding(replace(LAW, stiffness_drift=FADING)), resting)
    cycling = run_cycles(design, 2)
    assert cycling.verdict == "folds at none of the 2 cycles: did not fold"
    assert [run.margins["fold"] for run in cycling.runs] == [None, None]


def test_a_wing_that_folds_but_never_opens_is_reported():
    unfold = {"name": "unfold", "drive": "unfold", "until": "opened", "hold": 0.0, "time_limit": 0.02}
    design = folding(replace(LAW, stiffness_drift=FADING))
    stages = {"protocol.stages": [SETTLE, FOLD, unfold], "protocol.unfold_torque": 1e-3}
    cycling = run_cycles(with_values(design, stages), 2)
    assert cycling.verdict == "opens at none of the 2 cycles; still folds after 2 cycles"
    assert cycling.first_failure is None
    # such a small torque does not open the wing slowly either
    assert all(run.margins["unfold"] is None or run.margins["unfold"] < 1 for run in cycling.runs)


@pytest.mark.parametrize(
    ("law", "sentence"),
    [
        (
            None,
            "the design has no tendon.law that says how cycles change its tendons: every cycle is like the first",
        ),
        (
            LAW,
            "the law of rubber has no drift, so the effect of cycles on it is unknown: every cycle is like the first",
        ),
        (
            replace(LAW, stiffness_drift=NO_DRIFT),
            "the tests of rubber, cycles 2 to 5, show no drift: every cycle is like the first",
        ),
    ],
)
def test_unchanging_tendons_are_reported_with_the_reason(law, sentence):
    assert why_unchanged(folding(law)) == sentence
    with pytest.raises(InputError, match=sentence):
        run_cycles(folding(law), 100)


def test_softening_after_the_first_stretch_applies_from_the_second_cycle():
    soft = OgdenRoxburgh(r=2.0, m=1e5)
    design = folding(replace(LAW, softening=soft))
    assert why_unchanged(design) == ""
    first, second, third = (design_at_cycle(design, cycle) for cycle in (1, 2, 3))
    assert first.hash == design.hash
    assert second.hash == third.hash
    law, peak = second.tendon.law, built_strains(structure_of(design)).max()
    # Ogden and Roxburgh 1999; a cubic deviates by at most 5 % of the largest stress
    half, top = (
        law.linear_modulus * e + law.quadratic_modulus * e**2 + law.cubic_modulus * e**3 for e in (peak / 2, peak)
    )
    assert top == pytest.approx(4.8e6 * peak, rel=0.05)
    share = 1 - math.erf((4.8e6 / 2) * (peak**2 - peak**2 / 4) / 1e5) / 2
    assert half == pytest.approx(share * 4.8e6 * peak / 2, abs=0.05 * 4.8e6 * peak)


def test_a_design_file_keeps_the_drift(tmp_path):
    law = replace(LAW, stiffness_drift=FADING, residual_strain_drift=LONGER)
    design = folding(law)
    assert design_from_text(design_text(design)) == design
    assert design.tendon.law.material == law
    (tmp_path / "wing.toml").write_text(design_text(design), "utf-8")
    assert load_design(tmp_path / "wing.toml").hash == design.hash
    # the law at a cycle does not drift further
    later = design_at_cycle(design, 7).tendon.law
    assert (later.stiffness_drift, later.residual_strain_drift) == (None, None)
    assert later.residual_strain == pytest.approx(0.02 * (math.exp(-1 / 1.5) - math.exp(-6 / 1.5)))


def test_cycles_are_all_up_to_20_and_ten_per_decade_beyond():
    assert cycle_counts(1) == (1,)
    assert cycle_counts(5) == (1, 2, 3, 4, 5)
    assert cycle_counts(21) == (*range(1, 21), 21)
    assert cycle_counts(100)[20:] == (25, 32, 40, 50, 63, 79, 100)
    with pytest.raises(InputError, match="need a whole number >= 1, got 0"):
        cycle_counts(0)


def test_a_protocol_that_does_not_fold_is_refused():
    design = with_values(folding(replace(LAW, stiffness_drift=FADING)), {"protocol.stages": [SETTLE]})
    with pytest.raises(InputError, match=r'need a stage with drive = "fold" in protocol\.stages, got none'):
        run_cycles(design, 3)


def test_cycles_without_a_transition_name_the_end_that_a_stage_needs():
    push = {"name": "push", "drive": "close", "until": "rest", "hold": "0.1 s", "time_limit": "1 s"}
    design = load_design("letter-fold", {"protocol.stages": [push]})
    with pytest.raises(InputError, match=r'ends at a goal, such as until = "creases > 90 deg".* got until = "rest"'):
        check_cycles(design, 3)
