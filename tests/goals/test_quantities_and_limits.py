"""Input of goals: quantities, limits, parameters, and tolerances."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from forficula.design import load_design, with_values
from forficula.errors import InputError
from forficula.goals.deviation import default_deviations, deviating_values, read_deviations
from forficula.goals.limit import read_limit
from forficula.goals.outcome_quantity import quantities_of, quantity_of
from forficula.goals.parameter import read_parameter
from forficula.goals.static_values import static_values
from forficula.statics import energy_landscape
from forficula.study.running.evaluate import evaluate

WING, JOINT, CLASP = (load_design(name) for name in ("binder2025", "binder2025-joint", "force-clasp"))


@pytest.mark.parametrize("name", ["binder2025", "binder2025-joint", "letter-fold", "bistable-clasp", "kresling-cell"])
def test_every_kind_of_design_has_quantities_of_its_states_and_transitions(name):
    design = load_design(name)
    known = quantities_of(design)
    assert {"mass", "residual", "package_area", "probability"} <= known.keys()
    assert all(quantity.name == key for key, quantity in known.items())
    assert any(key.startswith("slow_") for key in known)


def test_static_quantities_are_those_of_the_landscape():
    landscape = energy_landscape(JOINT)
    values = static_values(JOINT, ["parts", "hinges", "slow"])
    (hinge,) = landscape.tendons
    assert values["hinge_barrier"] == pytest.approx(hinge.barrier, rel=1e-12)
    assert values["hinge_holding_torque"] == pytest.approx(hinge.holding_torque, rel=1e-12)
    assert values["slow_fold"] == pytest.approx(landscape.least_torques["fold"], rel=0.02)  # each to 1 %
    # two PETG rods of 5.5 mm diameter, 22 cm in total, and a tendon
    assert values["mass"] == pytest.approx(1270 * math.pi * 0.00275**2 * 0.22 + 1200 * 5e-6 * 0.06, rel=1e-9)


def test_the_folding_ratio_is_that_of_the_flat_folded_sheet():
    letter = static_values(load_design("letter-fold"), ["sheet"])
    # a letter in three parts; the thickness of 0.5 mm adds a margin to the folded outline
    assert 2.9 < letter["folding_ratio"] < 3
    assert letter["folded_height"] == pytest.approx(3 * 0.5e-3)
    # two ring folds violate Kawasaki's condition, and a Kresling cell is built folded
    for name in ("binder2025-thick", "kresling-cell"):
        assert static_values(load_design(name), ["sheet"]) == {"folding_ratio": None, "folded_height": None}
    assert read_limit(quantity_of(WING, "folding_ratio"), ">= 10 times").margin(12.0) == pytest.approx(0.2)


def test_barriers_along_the_fold_are_those_of_the_landscape(landscape_of):
    landscape = landscape_of(WING)
    values = static_values(WING, ["fold"])
    assert values["barrier"] == pytest.approx(landscape.fold_barrier, rel=1e-3)
    assert values["opening_barrier"] == pytest.approx(landscape.unfold_barrier, rel=1e-3)
    assert values["holding_torque"] == pytest.approx(landscape.fold_path.states[0].press * 2 / 3, rel=1e-6)


def test_an_unknown_quantity_is_answered_with_the_nearest():
    with pytest.raises(InputError, match='did you mean "holding_torque"'):
        quantity_of(WING, "holding_torqe")
    with pytest.raises(InputError, match=r"did you mean tendon\.stiffness"):
        quantity_of(WING, "tendon.stifness")
    with pytest.raises(InputError, match="value has a unit"):
        quantity_of(WING, "pattern.units")
    assert quantity_of(WING, "vein.diameter").source == "design"


@given(value=st.floats(-1e6, 1e6), bound=st.floats(-1e3, 1e3), above=st.booleans())
def test_a_limit_is_met_where_its_margin_is_not_negative(value, bound, above):
    kind = ">=" if above else "<="
    limit = read_limit(quantity_of(WING, "holding_torque"), f"{kind} {bound!r} N m")
    margin = limit.margin(value)
    assert -1 <= margin <= 1
    if abs(value - limit.bound) > 1e-6 * max(abs(limit.bound), 0.01):
        assert (margin >= 0) == (value >= limit.bound if above else value <= limit.bound)


def test_a_limit_without_a_value_has_margin_minus_one():
    limit = read_limit(quantity_of(WING, "fold_time"), "<= 0.1 s")
    assert limit.margin(None) == limit.margin(math.nan) == -1
    assert limit.margin(0.05) == pytest.approx(0.5)
    assert str(limit) == "fold_time <= 0.1 s"


@pytest.mark.parametrize("text", ["5 N cm", "= 5 N cm", ">= 5", ">= 5 kg", "", None, 5])
def test_an_invalid_limit_is_rejected_with_a_correct_example(text):
    with pytest.raises(InputError, match=r"N cm"):
        read_limit(quantity_of(WING, "holding_torque"), text)


@pytest.mark.parametrize(
    ("key", "given_as"),
    [
        ("tendon.stiffness", {"low": "4 N/cm", "high": "30 N/cm"}),
        ("tendon.rest_length", {"low": "0 cm", "high": "9 cm", "step": "0.5 cm"}),
        ("pattern.tangent", ["left", "right"]),
        ("vein.diameter", "2..6 mm step 0.5 mm"),
        ("pattern.units", [1, 2, 3]),
        ("membrane.poisson_ratio", {"low": 0.1, "high": 0.3}),
    ],
)
def test_a_fraction_of_a_parameters_range_gives_an_allowed_value(key, given_as):
    parameter = read_parameter(key, given_as, WING)
    for share in np.linspace(0, 1, 9):
        value = parameter.value(float(share))
        assert WING.with_values({key: value})
        assert parameter.value(parameter.share(value)) == value


def test_steps_are_round_and_choices_in_their_order():
    assert read_parameter("vein.diameter", {"low": "3 mm", "high": "6 mm", "step": "0.5 mm"}, WING).choices == (
        "3 mm", "3.5 mm", "4 mm", "4.5 mm", "5 mm", "5.5 mm", "6 mm",
    )  # fmt: skip
    assert read_parameter("tendon.stiffness", ["20 N/cm", "500 N/m"], WING).choices == ("500 N/m", "20 N/cm")


@pytest.mark.parametrize(
    ("given_as", "says"),
    [
        ({"low": "4 N/cm"}, r"high: is missing"),
        ({"low": "4 N/cm", "hihg": "5 N/cm"}, r"did you mean high"),
        ({"low": "5 N/cm", "high": "4 N/cm"}, r"need > low"),
        ({"low": "4 N", "high": "5 N/cm"}, r"low: "),
        ({"low": "4 N/cm", "high": "5 N/cm", "step": "2 N/cm"}, r"step: "),
        (
            {"low": "4 N/cm", "high": "9 N/cm", "step": "2 N/cm"},
            r"step: need one that divides high - low, such as an end of 8 or 10 or a step of 2\.5 \(in N/cm\), got ",
        ),
        (["4 N/cm", "400 N/m"], r"values that differ"),
        ("4", r"range"),
    ],
)
def test_an_invalid_parameter_is_rejected(given_as, says):
    with pytest.raises(InputError, match=says):
        read_parameter("tendon.stiffness", given_as, WING)


def test_default_tolerance_is_ten_per_cent_on_every_positive_number():
    deviations = default_deviations(WING)
    keys = {deviation.key for deviation in deviations}
    assert {"pattern.hub_radius", "tendon.stiffness", "hinge.armature", "membrane.margin"} <= keys
    assert not any(key.startswith(("protocol", "make")) for key in keys)
    assert "tendon.proximal_offset" not in keys  # this value is 0
    off = WING.with_values(deviating_values(WING, deviations, [1.0] * len(deviations)))
    assert off.tendons[0].stiffness == pytest.approx(1.1 * 1000)
    assert off.hinge.fold_limit == WING.hinge.fold_limit  # limited by the bounds of the key


@given(share=st.floats(0.01, 0.5), offsets=st.lists(st.floats(-1, 1), min_size=2, max_size=2))
def test_built_values_lie_within_their_tolerance(share, offsets):
    deviations = read_deviations({"tendon.stiffness": f"{100 * share!r} %", "vein.diameter": "0.2 mm"}, WING)
    off = WING.with_values(deviating_values(WING, deviations, offsets))
    assert abs(off.tendons[0].stiffness / 1000 - 1) <= share * (1 + 1e-9)
    assert abs(off.vein.diameter - WING.vein.diameter) <= 0.2e-3 * (1 + 1e-9)


def test_normal_tolerances_have_their_deviation():
    (deviation,) = read_deviations({"tendon.stiffness": {"distribution": "normal", "size": "5 %"}}, WING)
    offsets = deviation.offsets((np.arange(4000) + 0.5) / 4000)
    assert np.std(offsets) == pytest.approx(1, abs=0.01)
    assert deviation.width(1000.0) == pytest.approx(50)


def test_the_intervals_of_a_fitted_law_are_tolerances(tmp_path):
    law = tmp_path / "fitted.toml"
    law.write_text(
        'name = "fitted"\nsource = "a test"\n[modulus]\nlinear = "4.8 MPa"\n[interval]\n'
        '"modulus.linear" = ["4.6 MPa", "5.0 MPa"]\n'
    )
    (deviation,) = read_deviations({"tendon.law": {"intervals_of": str(law)}}, JOINT)
    assert (deviation.key, deviation.distribution) == ("tendon.law.linear_modulus", "normal")
    assert 2 * 1.959964 * deviation.size == pytest.approx(0.4e6, rel=1e-6)
    with pytest.raises(InputError, match="no intervals"):
        read_deviations({"tendon.law": {"intervals_of": "tpu-95a"}}, JOINT)


def test_the_intervals_of_a_law_of_creases_are_tolerances(tmp_path):
    law = tmp_path / "fold.toml"
    law.write_text(
        'name = "fold"\nsource = "a test"\nthickness = "0.1 mm"\nwidth = "30 mm"\n[crease]\n'
        'stiffness = "4.8 N m/rad/m"\n[interval]\nstiffness = ["4.6 N m/rad/m", "5.0 N m/rad/m"]\n'
    )
    design = load_design("letter-fold", {"crease.law": str(law)})
    (deviation,) = read_deviations({"crease.law": {"intervals_of": str(law)}}, design)
    assert (deviation.key, deviation.distribution) == ("crease.law.stiffness", "normal")
    assert 2 * 1.959964 * deviation.size == pytest.approx(0.4, rel=1e-6)
    everything = {deviation.key for deviation in read_deviations({"all": "10 %"}, design)}
    assert "crease.law.stiffness" in everything
    assert not {"crease.law.thickness", "crease.law.width"} & everything
    with pytest.raises(InputError, match="no intervals"):
        read_deviations({"crease.law": {"intervals_of": "paper"}}, design)


@pytest.mark.parametrize(
    ("given_as", "says"),
    [
        ({"tendon.stiffness": "0 %"}, "> 0"),
        ({"tendon.stiffness": "100 %"}, "< 100 %"),
        ({"tendon.stiffness": 0.1}, "unit is missing"),
        ({"tendon.stiffness": "none"}, "has no tolerance"),
        ({"tendon.proximal_offset": "10 %"}, "is 0 in binder2025"),
        ({"pattern.units": "10 %"}, "number with fractions"),
        ({"tendon.stifness": "10 %"}, r"did you mean tendon\.stiffness"),
        ({"tendon.stiffness": {"distribution": "norma", "size": "5 %"}}, '"uniform" or "normal"'),
        ({"tendon.stiffness": {"sizes": "5 %"}}, "did you mean size"),
        ({"all": "0.1 mm"}, "%"),
    ],
)
def test_an_invalid_tolerance_is_rejected(given_as, says):
    with pytest.raises(InputError, match=says):
        read_deviations(given_as, WING)


def test_a_tolerance_of_all_may_exclude_keys():
    every = read_deviations({"all": "5 %"}, WING)
    some = read_deviations({"all": "5 %", "tendon.stiffness": "none", "vein.diameter": "0.1 mm"}, WING)
    assert len(some) == len(every) - 1
    assert {item.key: item.relative for item in some}["vein.diameter"] is False


def test_energy_of_a_state_is_all_stored_energy_and_that_of_tendons_has_its_own_name():
    clasp = with_values(CLASP, {"protocol.stages": CLASP.as_tables()["protocol"]["stages"][:1]})
    known, row = quantities_of(clasp), next(evaluate([clasp], threads=1))
    whole, band = (row[known[name].column] for name in ("closed_energy", "closed_tendon_energy"))
    # by hand at 60 deg: a band of 8 N/cm, 5 cm at rest, and a hinge of 0.02 N m/rad turned by 30 deg; the film opens
    length = math.sqrt(0.03**2 + 0.04**2 + 2 * 0.03 * 0.04 * math.cos(math.radians(60)))
    assert band == pytest.approx(800 / 2 * (length - 0.05) ** 2, rel=0.06)
    hinge, film = row["closed_hinge_energy_J"], row["closed_spring_energy_J"]
    assert hinge == pytest.approx(0.01 * math.radians(30) ** 2, rel=0.25)  # plus the energy of its stop
    assert whole == pytest.approx(band + hinge + film, rel=1e-12)
    assert "all stored" in known["closed_energy"].meaning
    # sparse records do not contain the energy of membranes
    assert quantities_of(WING)["flat_energy"].source == "record"
    assert quantities_of(WING)["flat_tendon_energy"].source == "run"
