import math
import re

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import forficula as ff
from forficula.design import scale_design, with_values
from forficula.dynamics import stable_timestep, timestep_warnings, with_timestep
from forficula.errors import InputError
from tests.plate_sheets import strip

REFERENCE = ff.load_design("binder2025")


def changed(**values):
    return with_values(REFERENCE, {key.replace("__", "."): value for key, value in values.items()})


@pytest.mark.parametrize(
    ("key", "value", "shown"),
    [
        ("tendon.stiffness", 1e300, "1e+298 N/cm"),
        ("tendon.damping", 1e12, "1e+12 N s/m"),
        ("protocol.no_load_speed", math.radians(1e-9), "1e-09 deg/s"),
        ("membrane.youngs_modulus", 1e21, "1e+15 MPa"),
    ],
)
def test_the_value_that_prevents_any_timestep_is_named(reference, key, value, shown):
    with pytest.raises(
        InputError, match=rf"no timestep is short enough: .*, because of {re.escape(f'{key} = {shown}')}$"
    ):
        stable_timestep(reference.with_values({key: value}))


def test_a_given_timestep_is_kept():
    assert with_timestep(REFERENCE) is REFERENCE


@settings(max_examples=10, deadline=None)  # each example compiles and linearizes two wings
@given(st.floats(-1, 1).map(lambda power: 10.0**power), st.integers(1, 3))
def test_the_automatic_timestep_is_at_most_a_quarter_of_the_stable_one_and_has_one_digit(stiffness, units):
    design = changed(
        membrane__youngs_modulus=1e6 * stiffness, pattern__units=units, vein__diameter=0.004, protocol__timestep="auto"
    )
    chosen = with_timestep(design).protocol.timestep
    # four steps to the time constant of a stop, 1 ms
    allowed = min(stable_timestep(design), 4 * 0.25e-3)
    assert allowed / 8 <= chosen <= allowed / 4  # rounded down to one digit, at worst from 1.99 to 1
    assert chosen == float(f"{chosen:.0e}")
    assert timestep_warnings(with_timestep(design)) == []


def test_the_allowed_timestep_does_not_depend_on_the_one_that_is_given():
    assert stable_timestep(changed(protocol__timestep=1e-6)) == stable_timestep(REFERENCE)


def test_the_allowed_timestep_of_a_scaled_wing_is_scaled():
    # time scales with size (docs/model/theory.md, section Similarity); bisection to 1e-4 of a decade
    ratio = stable_timestep(scale_design(REFERENCE, 0.1)) / stable_timestep(REFERENCE)
    assert ratio == pytest.approx(0.1, rel=2e-4 * math.log(10))


def test_a_stiffer_membrane_allows_a_shorter_timestep_with_the_square_root_of_its_modulus():
    # h = 2 / w for an undamped mode, w = sqrt(k / m): symplectic Euler, any textbook
    undamped = {"membrane__damping": 0.0, "hinge__damping": 0.0, "tendon__damping": 0.0}
    soft, stiff = (stable_timestep(changed(**undamped, membrane__youngs_modulus=modulus)) for modulus in (1e8, 1e10))
    # at such moduli the tendons' share of the stiffest mode is below 1e-3
    assert soft / stiff == pytest.approx(10, rel=2e-3)


def test_a_timestep_that_is_too_long_is_named_with_what_is_allowed_and_what_to_do():
    assert timestep_warnings(REFERENCE) == []
    assert timestep_warnings(changed(protocol__timestep="auto")) == []
    (warning,) = timestep_warnings(changed(protocol__timestep=5e-3))
    allowed = 1e3 * stable_timestep(REFERENCE)
    assert f"a timestep of 5 ms is too long: the stiffest mode allows {allowed:.3g} ms" in warning
    assert 'protocol.timestep = "auto"' in warning


def test_a_wing_is_bounded_below_the_allowed_timestep_and_diverges_far_above_it():
    settle = [{"name": "settle", "drive": "none", "until": "time", "hold": 0.0, "time_limit": 0.3}]
    allowed = stable_timestep(REFERENCE)
    stable, unstable = (
        ff.run(changed(protocol__stages=settle, protocol__timestep=share * allowed), confirm=False)
        for share in (0.9, 4)
    )
    assert stable.diverged_at is None
    # largest energy that the tendons released, J: the wing started at rest
    assert stable.data["kinetic_energy"].max() < stable.data["tendon_energy"][0].sum()
    assert unstable.diverged_at is not None or unstable.data["kinetic_energy"].max() > 1


def test_a_wing_without_stiffness_allows_any_timestep():
    limp = changed(membrane__youngs_modulus=1e-3, tendon__stiffness=0.0)
    assert stable_timestep(limp) >= 1
    assert timestep_warnings(limp) == []


@pytest.mark.parametrize(
    ("key", "value"),
    [("tendon.stiffness", 1e300), ("vein.density", 1e-300), ("membrane.proximal_rows", [0.1, 0.100000001])],
)
def test_a_wing_that_no_timestep_fits_is_refused_in_one_line(key, value):
    with pytest.raises(InputError) as caught:
        stable_timestep(changed(**{key: value}))
    assert str(caught.value).startswith("binder2025: ")
    assert len(str(caught.value).splitlines()) == 1


def test_the_tendons_limit_is_that_of_a_hinge_that_they_hold_at_their_longest_lever():
    # h = 2 / w for an undamped mode, w^2 = (E1 + sum of the branches) A / L arm^2 / inertia; a branch that relaxes
    # slowly is a spring. Inertia of the distal bar, a cylinder about its end, and the armature
    law = {"linear_modulus": 2e9, "branches": [{"modulus": 3e9, "time": 10.0}]}
    design = changed(
        tendon__law=law,
        tendon__area=12.5e-6,
        tendon__rest_length=0.06,
        hinge__damping=0.0,
        membrane__youngs_modulus=1.0,
    )
    mass = 1270 * math.pi / 4 * 0.005**2 * 0.1
    inertia = mass * 0.1**2 / 3 + 1e-5
    expected = 2 / math.sqrt(5e9 * 12.5e-6 / 0.06 * 0.055**2 / inertia)
    # the crease is at least 3 deg off the bar's normal, and the vein that carries it yields
    assert stable_timestep(design) == pytest.approx(expected, rel=0.1)


@pytest.mark.parametrize(
    "law",
    [
        {"linear_modulus": 1e9},
        {"linear_modulus": 1e6, "cubic_modulus": 1e9},
        {"linear_modulus": 1e6, "linear_viscosity": 1e6},
        {"linear_modulus": 1e6, "cubic_viscosity": 1e3},  # also pushes
        {"linear_modulus": 1e6, "branches": [{"modulus": 5e9, "time": 1.0}]},
        {"linear_modulus": 1e6, "branches": [{"modulus": 5e9, "time": 1e-4}]},
    ],
)
def test_a_stiff_or_viscous_law_needs_a_shorter_timestep_at_which_the_wing_is_bounded(law):
    short = {f"protocol__stages__{stage}__time_limit": 0.05 for stage in range(5)}
    design = changed(
        tendon__law=law,
        tendon__pushes_when_slack="cubic_viscosity" in law,
        tendon__area=12.5e-6,
        tendon__rest_length=0.08,
        **short,
    )
    allowed = stable_timestep(design)
    assert allowed < stable_timestep(changed(tendon__rest_length=0.08))
    (warning,) = timestep_warnings(changed_step(design, 1.1 * allowed))
    assert "is too long" in warning
    record = ff.run(changed_step(design, 0.9 * allowed), confirm=False)
    assert record.diverged_at is None
    # energy that torques and tendons can release, J
    assert record.data["kinetic_energy"].max() < 6


def test_a_short_edge_of_a_sheet_is_named_as_the_cause_of_a_short_timestep():
    bars = {
        "facet.kind": "bars",
        "facet.youngs_modulus": 2e7,
        "facet.poisson_ratio": 0.3,
        "crease.stiffness": 1e-3,
        "crease.damping": 2e-3,
        "crease.fold_limit": None,
        "crease.back_limit": None,
    }

    def sliver(width, timestep=2e-4):
        values = {"pattern.panel_lengths": ["5 cm", width, "5 cm"], "protocol.timestep": timestep}
        return strip(3, letters="VM", **bars, **values)

    (warning,) = timestep_warnings(sliver("0.5 mm"))
    assert warning.endswith(
        "; the cause is the edge between vertex 1 and vertex 2, which is only 0.5 mm long: merge both vertices, or move"
        " them apart"
    )
    # the remedy helps
    assert stable_timestep(sliver("2 cm")) > 100 * stable_timestep(sliver("0.5 mm"))
    (other,) = timestep_warnings(sliver("2 cm", 0.01))
    assert "edge" not in other
    with pytest.raises(InputError, match=r"need >= .* the cause is the edge between vertex 1 and vertex 2"):
        with_timestep(sliver("1 nm", "auto"))


def changed_step(design, timestep):
    return with_values(design, {"protocol.timestep": timestep})


def test_a_tendon_without_a_largest_length_affects_the_timestep():
    """Across opening creases; a stiff tendon's mode is the fastest and sets the timestep."""
    snap, band = ff.load_design("four-plate-snap"), {"name": "band", "from": "vertex 1", "to": "vertex 3"}
    soft, stiff = (
        stable_timestep(
            with_values(snap, {"tendon": [{**band, "stiffness": stiffness, "rest_length": 0.02, "damping": 0.0}]})
        )
        for stiffness in (1.0, 1e7)
    )
    assert soft == pytest.approx(stable_timestep(snap), rel=0.01)
    assert 0 < stiff < 0.1 * soft
