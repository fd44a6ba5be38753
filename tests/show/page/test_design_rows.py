import pytest

from forficula.design import Design, load_design, scale_design, with_values
from forficula.design.section import Section
from forficula.show.page.parts.design_rows import ABSENT, base_design, design_rows, design_title, differing_rows
from forficula.show.page.parts.design_tables import design_tables


def differences(design):
    rows = design_rows(design, base_design(design))
    return {f"{row.section}.{row.key}": (row.base, row.value) for row in rows if row.differs}


def test_a_named_design_differs_in_nothing_from_itself(reference):
    assert differences(reference) == {}
    assert "Every value is that of the named design binder2025." in "".join(design_tables(reference))


def test_explanations_of_sections_do_not_depend_on_docstrings():
    # PYTHONOPTIMIZE=2 removes docstrings
    parts = list(_subclasses(Section))
    assert {"TendonSection", "MakeSection", "FanProtocol", "MiuraOri", "FacetSection"} <= {
        part.__name__ for part in parts
    }
    for part in parts:
        if part.__doc__ and part.__module__.startswith("forficula.design") and not issubclass(part, Design):
            assert part.about == (part.__doc__ or "").splitlines()[0].removesuffix("."), part


def _subclasses(part):
    for subclass in part.__subclasses__():
        yield subclass
        yield from _subclasses(subclass)


def test_exactly_what_was_changed_differs_with_both_values_and_units():
    changed = load_design(
        "binder2025", {"tendon.stiffness": "25 N/cm", "pattern.units": 2, "protocol.stages.1.time_limit": "2 s"}
    )
    assert differences(changed) == {
        "tendon.stiffness": ("10 N/cm", "25 N/cm"),
        "pattern.units": ("1", "2"),
        "protocol.stages.1.time_limit": ("1 s", "2 s"),
    }


@pytest.mark.parametrize(
    ("values", "title"),
    [
        ({}, "binder2025"),
        ({"tendon.stiffness": "20 N/cm"}, "binder2025, tendon.stiffness 20 N/cm"),
        ({"tendon.stiffness": "0.02 N/mm"}, "binder2025, tendon.stiffness 0.2 N/cm"),
        ({"pattern.units": 3, "tendon.rest_length": "2 cm"}, "binder2025, pattern.units 3, tendon.rest_length 2 cm"),
        ({"name": "my wing", "pattern.units": 3}, "my wing"),
    ],
)
def test_the_title_lists_differences_from_the_named_design(values, title):
    assert design_title(load_design("binder2025", values)) == title


def test_with_many_differences_the_title_has_their_number_and_the_hash():
    wings = [
        load_design("binder2025", {"pattern.units": 2, "tendon.rest_length": "2 cm", "tendon.stiffness": stiffness})
        for stiffness in ("20 N/cm", "30 N/cm")
    ]
    titles = [design_title(wing) for wing in wings]
    assert titles == [f"binder2025 with 3 other values ({wing.hash})" for wing in wings]
    assert titles[0] != titles[1]


def test_the_tables_mark_what_differs_and_show_the_old_value():
    tables = "".join(design_tables(load_design("binder2025", {"tendon.stiffness": "25 N/cm"})))
    assert "<mark>25 N/cm</mark><small>binder2025: 10 N/cm</small>" in tables
    assert tables.count("<mark>") == 1
    assert "1 value differs from the named design binder2025, marked below: tendon.stiffness." in tables


def test_every_value_of_a_design_has_a_row_with_its_unit_and_its_meaning(reference):
    rows = {f"{row.section}.{row.key}": row for row in design_rows(reference, reference)}
    assert rows["pattern.proximal_length"].value == "12 cm"
    assert rows["protocol.stages.4.hold"].value == "0.1 s"
    assert rows["membrane.proximal_rows"].value == "[0.3]"
    assert rows["protocol.contact"].value == "false"
    assert all(row.meaning for row in rows.values())


def test_a_law_and_stages_that_only_one_of_two_designs_has_are_absent_in_the_other(reference):
    stages = [stage.model_dump() for stage in reference.protocol.stages[:2]]
    other = load_design("binder2025", {"tendon.law": "tpu-82a", "tendon.area": "12.5 mm^2"})
    other = with_values(other, {"protocol.stages": stages})
    result = differences(other)
    assert result["tendon.area"] == (ABSENT, "12.5 mm^2")
    assert result["protocol.stages.4.name"] == ("release opened", ABSENT)
    assert any(key.startswith("tendon.law.") for key in result)
    assert "tpu-82a" in "".join(design_tables(other))


def test_the_rounding_errors_of_a_scaled_design_are_not_shown_and_do_not_count(reference):
    there_and_back = scale_design(scale_design(reference, 1 / 7), 7)
    assert there_and_back.hash != reference.hash
    assert differences(there_and_back) == {}
    tables = "".join(design_tables(there_and_back))
    assert "Every value is that of the named design binder2025, to 9 digits." in tables
    assert "0000000000" not in tables


@pytest.mark.parametrize(("name", "base"), [("my wing", "binder2025"), ("binder2025", "binder2025")])
def test_a_design_of_another_name_is_compared_with_the_reference(reference, name, base):
    assert base_design(with_values(reference, {"name": name})).name == base


def test_only_keys_that_differ_between_designs_are_listed():
    designs = [load_design("binder2025", {"tendon.stiffness": f"{value} N/cm"}) for value in (10, 20, 20)]
    assert differing_rows(designs) == [("tendon.stiffness", ["10 N/cm", "20 N/cm", "20 N/cm"])]
    assert differing_rows(designs[1:]) == []
