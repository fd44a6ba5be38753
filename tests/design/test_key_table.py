"""The table of design keys: every key with its allowed values and its meaning."""

import pytest

import forficula as ff
from forficula.design import key_quantity, with_values
from forficula.design.files.key_table import key_facts
from forficula.design.files.kinds import KINDS
from forficula.quantities import parse_quantity


@pytest.mark.parametrize("kind", KINDS)
def test_every_key_of_a_kind_is_listed_once_with_its_meaning(kind):
    facts = key_facts(model=KINDS[kind])
    assert len({fact.key for fact in facts}) == len(facts)
    assert all(fact.meaning and fact.allowed for fact in facts)
    assert f'"{kind}"' in {fact.key: fact.allowed for fact in facts}["pattern.kind"]


def _keys(tables, prefix=""):
    for name, value in tables.items():
        if isinstance(value, dict):
            yield from _keys(value, f"{prefix}{name}.")
        elif isinstance(value, list) and all(isinstance(entry, dict) for entry in value):
            # an empty list of tables has no keys, and a list of values only its own key
            for entry in value:
                yield from _keys(entry, f"{prefix}{name}.0.")
        else:
            yield f"{prefix}{name}"


@pytest.mark.parametrize("name", [design.reference for design in KINDS.values() if design.reference])
def test_every_key_of_a_written_design_is_listed(name):
    design = ff.load_design(name)
    assert set(_keys(design.as_tables())) <= {fact.key for fact in key_facts(model=type(design))}


@pytest.mark.parametrize(
    ("key", "allowed", "default"),
    [
        ("pattern.sector_angle", "deg, > 0, < 180 deg", "needed"),
        ("pattern.units", "whole number, >= 1, <= 10000", "needed"),
        ("pattern.tangent", '"left" or "right"', "needed"),
        ("protocol.timestep", 'ms, > 0 or "auto"', "needed"),
        ("protocol.contact", "true or false", "needed"),
        ("protocol.rise", "s, >= 0", "0 s"),
        ("membrane.distal_rows", "list of: number", "needed"),
        ("protocol.driven_veins", "list of: whole number", ""),
        ("pattern.sector_shares", "list of: number", ""),
        ("tendon.area", "mm^2, > 0", ""),
    ],
)
def test_what_a_key_may_be_has_its_unit_its_bounds_and_its_default(key, allowed, default):
    (fact,) = key_facts(key)
    assert (fact.allowed, fact.default) == (allowed, default)


def test_values_beyond_the_listed_bounds_are_refused():
    # a table is complete only with its height
    design = ff.load_design("binder2025").with_values({"table.height": -1.0})
    for fact in key_facts():
        quantity = key_quantity(fact.key)
        if quantity is None or ".law." in fact.key or ", > 0" not in fact.allowed:
            continue
        with pytest.raises(ff.InputError, match="need > 0"):
            with_values(design, {fact.key: parse_quantity(f"0 {quantity.unit.display}", quantity.unit)})


def test_an_unknown_section_is_refused_with_the_nearest_name():
    assert [fact.key for fact in key_facts("guard")] == ["guard.stretch"]
    with pytest.raises(ff.InputError, match=r"tendn: unknown key; did you mean tendon\?"):
        key_facts("tendn")


@pytest.mark.parametrize("key", ["protocol.stages.2.wait", "tendon.1.stiffness", "tendon.law.branches.1.time"])
def test_an_entry_of_a_list_may_be_named_by_any_number(key):
    (fact,) = key_facts(key)
    assert fact.key.endswith(key.rpartition(".")[2])
