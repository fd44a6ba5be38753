"""Files of studies, goals and observations: what is wrong is refused with its key, its value and what is allowed."""

import pytest

from forficula.design.file_fields import by_key
from forficula.design.keys import parts_of
from forficula.design.rejection import read_part
from forficula.errors import InputError
from forficula.goals.goal_file import GoalFile
from forficula.goals.identify.observations_file import ObservationsFile
from forficula.study.study_file import StudyFile

MODELS = (StudyFile, GoalFile, ObservationsFile)


def keys_of(model):
    """The keys of a file and of its tables, as lists of parts, but for those of facts and of a design."""
    for name, field in model.model_fields.items():
        tables = [part for part in parts_of(field.annotation) if name != "fact"]
        yield [name]
        for table in tables:
            yield from ([name, key] for key in table.model_fields)


CHECKED = [
    (model, place)
    for model in MODELS
    for place in keys_of(model)
    # values that depend on the design are checked with it
    if place != ["fact"] and place[-1] not in ("DRIVE_torques", "DRIVE_with", "values")
]


@pytest.mark.parametrize(("model", "place"), CHECKED, ids=lambda each: ".".join(each) if isinstance(each, list) else "")
def test_a_wrong_value_is_refused_with_its_key_and_what_is_allowed(model, place):
    needed = {"count": 8} if model is StudyFile and place[0] == "sampling" else {}
    tables = {place[0]: 3.5 if len(place) == 1 else {**needed, place[1]: 3.5}}
    with pytest.raises(InputError) as caught:
        read_part(model, tables)
    message = str(caught.value)
    assert message.startswith(f"{'.'.join(place)}: need ")
    assert message.endswith("got 3.5")


@pytest.mark.parametrize("model", MODELS)
def test_a_misspelt_key_is_refused_with_the_right_one(model):
    for name in model.model_fields:
        with pytest.raises(InputError) as caught:
            read_part(model, {f"{name}s": 1})
        assert str(caught.value) == f"{name}s: unknown key, got 1; did you mean {name}?"


def test_a_misspelt_word_is_refused_with_the_right_one():
    with pytest.raises(InputError, match=r'ask: need "run", .* got "least-torque"; did you mean "least-torques"\?'):
        read_part(StudyFile, {"ask": "least-torque"})


@pytest.mark.parametrize("model", MODELS)
def test_keys_of_a_design_may_be_written_with_dots_or_in_tables(model):
    table = next(name for name, field in model.model_fields.items() if by_key(field) is not None)
    dotted, nested = (
        getattr(read_part(model, {table: values}), table)
        for values in ({"tendon.stiffness": "1 N/cm"}, {"tendon": {"stiffness": "1 N/cm"}})
    )
    assert dotted == nested == {"tendon.stiffness": "1 N/cm"}
