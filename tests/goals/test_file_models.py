"""Files of studies, goals and observations: errors contain the key, the value and what is allowed."""

import re

import pytest

from forficula.design.file_fields import by_key
from forficula.design.files.keys import known_keys
from forficula.design.files.rejection import read_section
from forficula.errors import InputError
from forficula.goals.goal_file import GoalFile
from forficula.goals.identify.observations_file import ObservationsFile
from forficula.study.files.study_file import StudyFile

MODELS = (StudyFile, GoalFile, ObservationsFile)


# values by key of the design, and values that depend on the design, are checked together with the design
LATER = re.compile(r".*\.(KEY|QUANTITY)(\..*)?|fact(\..*)?|.*\.(DRIVE_\w+|values)")
CHECKED = [(model, key) for model in MODELS for key in known_keys(model) if not LATER.fullmatch(key)]


@pytest.mark.parametrize(("model", "key"), CHECKED)
def test_a_wrong_value_is_refused_with_its_key_and_what_is_allowed(model, key):
    table, _, inside = key.partition(".")
    needed = {"count": 8} if model is StudyFile and table == "sampling" else {}
    tables = {table: {**needed, inside: 3.5} if inside else 3.5}
    if inside.startswith("0."):  # an entry of a list of tables
        tables = {table: [{inside.removeprefix("0."): 3.5}]}
    with pytest.raises(InputError) as caught:
        read_section(model, tables)
    message = str(caught.value)
    assert message.startswith(f"{key}: need ")
    assert message.endswith("got 3.5")


@pytest.mark.parametrize("model", MODELS)
def test_a_misspelt_key_is_refused_with_the_right_one(model):
    for name in model.model_fields:
        with pytest.raises(InputError) as caught:
            read_section(model, {f"{name}s": 1})
        assert str(caught.value) == f"{name}s: unknown key, got 1; did you mean {name}?"


def test_a_misspelt_word_is_refused_with_the_right_one():
    with pytest.raises(InputError, match=r'ask: need "run", .* got "least-torque"; did you mean "least-torques"\?'):
        read_section(StudyFile, {"ask": "least-torque"})


@pytest.mark.parametrize("model", MODELS)
def test_keys_of_a_design_may_be_written_with_dots_or_in_tables(model):
    table = next(name for name, field in model.model_fields.items() if by_key(field) is not None)
    dotted, nested = (
        getattr(read_section(model, {table: values}), table)
        for values in ({"tendon.stiffness": "1 N/cm"}, {"tendon": {"stiffness": "1 N/cm"}})
    )
    assert dotted == nested == {"tendon.stiffness": "1 N/cm"}
