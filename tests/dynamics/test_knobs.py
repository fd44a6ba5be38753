import numpy as np
import pytest

from forficula.design import load_design, with_values
from forficula.dynamics import compile_model, knobs_of, stable_timestep, why_not_portable, with_timestep
from forficula.dynamics.engine.portable_model import model_numbers

NAMES = ("binder2025", "letter-fold")


@pytest.fixture(scope="module", params=NAMES)
def model(request):
    return compile_model(with_timestep(load_design(request.param)))


def test_numbers_that_a_knob_changes_are_those_of_the_model_that_is_built_with_its_value(model):
    knobs = knobs_of(model)
    numbers = model_numbers(model)
    assert {"hinge.damping", "crease.damping"} & {knob.key for knob in knobs}
    for knob, share in zip(knobs, np.linspace(0.1, 0.9, len(knobs)), strict=True):
        value = knob.lowest + share * (knob.highest - knob.lowest)
        built = compile_model(with_values(model.design, {knob.key: value}))
        expected = model_numbers(built) | {"opt.gravity": np.array(built.engine.opt.gravity)}
        result = {name: values.copy() for name, values in numbers.items()} | {"opt.gravity": np.zeros(3)}
        for change in knob.changes:
            result[change.field][change.places] = change.low + change.slopes * (value - knob.lowest)
        for name, values in expected.items():
            sprung = np.repeat(built.engine.tendon_stiffness > 0, 2) if name == "tendon_lengthspring" else slice(None)
            assert result[name][sprung] == pytest.approx(values[sprung], rel=1e-9, abs=1e-12), (knob.key, name)


def test_no_knob_changes_what_another_one_changes(model):
    changed = [
        (change.field, place) for knob in knobs_of(model) for change in knob.changes for place in change.places.tolist()
    ]
    assert len(changed) == len(set(changed))


def test_a_range_ends_where_the_design_needs_a_shorter_timestep():
    design = load_design("binder2025", {"protocol.timestep": "0.5 ms"})
    (knob,) = (knob for knob in knobs_of(compile_model(design)) if knob.key == "membrane.youngs_modulus")
    assert knob.value <= knob.highest < 5 * knob.value
    assert stable_timestep(with_values(design, {knob.key: knob.highest})) >= 5e-4
    assert stable_timestep(with_values(design, {knob.key: 5 * knob.value})) < 5e-4


def test_a_value_that_moves_masses_is_not_a_knob_because_inertias_are_not_linear_in_it():
    keys = {knob.key for knob in knobs_of(compile_model(load_design("binder2025")))}
    assert "vein.density" not in keys


@pytest.mark.parametrize(
    ("settings", "why"),
    [
        ({"protocol.contact": True}, "its parts touch"),
        ({"medium.density": "1.2 kg/m^3"}, "air or water"),
        ({"protocol.stages.2.wait": "1 h"}, "a stage waits"),
    ],
)
def test_structures_that_another_engine_moves_differently_are_named(settings, why):
    assert why in why_not_portable(compile_model(with_timestep(load_design("binder2025", settings))))


def test_the_tendons_of_parts_have_knobs_of_their_own():
    keys = {knob.key for knob in knobs_of(compile_model(load_design("two-clasps")))}
    assert {"inner.tendon.0.stiffness", "outer.tendon.0.stiffness"} <= keys
