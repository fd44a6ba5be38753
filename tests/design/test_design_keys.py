"""The keys of one particular design."""

import re

import pytest

from forficula.design import load_design, named_designs
from forficula.design.files.design_keys import design_keys
from forficula.design.files.key_table import key_facts
from forficula.options import read_settings


@pytest.mark.parametrize("name", named_designs())
def test_every_key_of_a_kind_of_design_has_a_meaning_and_allowed_values(name):
    design = load_design(name)
    held = design_keys(design)
    assert all(key.fact.meaning and key.fact.allowed for key in held)
    of_one = {re.sub(r"\.\d+\.", ".0.", key.fact.key) for key in held}
    # an empty list is one key, and so is a law that is given by its name
    wholes = tuple(f"{key}.0." for key in of_one)
    missing = [fact.key for fact in key_facts("", type(design)) if fact.key not in of_one]
    # a drive or a joint has the keys of its own kind
    by_kind = re.compile(r"(.*\.)?(drive|joint)\.0\..*")
    assert [
        key for key in missing if not key.startswith(wholes) and not by_kind.fullmatch(key) and ".law." not in key
    ] == []
    assert len({key.fact.key for key in held}) == len(held)


def test_a_drive_has_the_keys_of_its_kind_and_may_be_of_any_other():
    held = {key.fact.key: key for key in design_keys(load_design("bistable-clasp"))}
    drive_keys = [key.removeprefix("drive.0.") for key in held if key.startswith("drive.0.")]
    assert drive_keys == ["name", "kind", "of", "value", "no_load_speed", "rise"]
    assert held["drive.0.kind"].words == ("torque", "force", "displacement", "rest-angle")


@pytest.mark.parametrize("name", named_designs())
def test_values_are_read_as_the_ones_that_they_are(name):
    design = load_design(name)
    values = {key.fact.key: key.value for key in design_keys(design) if key.value and not key.chosen}
    read = load_design(name, read_settings([f"{key}={text}" for key, text in values.items() if ".law." not in key]))
    values_read = {item.fact.key: item.value for item in design_keys(read)}
    assert {key: values_read[key] for key in values} == values


def test_chosen_values_are_listed_with_the_rule(reference):
    assert not any(key.chosen for key in design_keys(reference))
    chosen = {key.fact.key: key for key in design_keys(load_design("letter-fold")) if key.chosen}
    for choice in load_design("letter-fold").chosen:
        key = chosen[f"{choice.section}.{choice.key}"]
        assert key.chosen == choice.reason
        assert key.value


def test_allowed_words_are_listed_and_marked_as_the_only_values(reference):
    held = {key.fact.key: key for key in design_keys(reference)}
    assert (held["pattern.tangent"].words, held["pattern.tangent"].only_words) == (("left", "right"), True)
    assert (held["protocol.contact"].words, held["protocol.contact"].only_words) == (("true", "false"), True)
    assert (held["protocol.timestep"].words, held["protocol.timestep"].only_words) == (("auto",), False)
    assert "tpu-95a" in held["tendon.law"].words
