"""The JSON that commands write conforms to its schema, and the schema rejects other content."""

import json

import jsonschema
import pytest

import forficula as ff
from forficula.analysis import summary
from forficula.cli import main
from forficula.dynamics import versions
from forficula.errors import InputError
from forficula.results import KINDS, json_schema
from forficula.statics import landscape_summary
from forficula.study.tables.table_rows import json_rows
from tests.golden.cases import kept

SHORT = {
    "protocol.stages": [
        {"name": "settle", "drive": "none", "until": "time", "hold": "0 s", "time_limit": "4 ms", "state": "flat"},
        {"name": "fold", "drive": "fold", "until": "folded", "hold": "0 s", "time_limit": "4 ms"},
    ]
}


def summary_of(record):
    return json.loads(json.dumps(summary(record, ff.measure(record), versions()), allow_nan=False))


@pytest.fixture(scope="module")
def letter(letter_run):
    return summary_of(letter_run)


def valid(kind, data):
    jsonschema.Draft202012Validator(json_schema(kind)).validate(data)


def test_schemas_are_schemas():
    for kind in (kind for kind in KINDS if kind.shape):
        jsonschema.Draft202012Validator.check_schema(json_schema(kind.json))


KEPT = {
    "summary": ("run-of-a-joint", "run-of-a-sheet"),
    "identified": ("identification",),
    "landscape": ("landscape-of-a-joint", "landscape-of-a-net", "landscape-of-a-sheet", "landscape-with-a-run"),
    "assumptions": ("assumptions",),
    "material": ("material",),
    "cycles": ("cycles",),
    "convergence": ("convergence",),
    "optimum": ("optimum",),
    "tolerance": ("tolerance",),
}


@pytest.mark.parametrize(("kind", "case"), [(kind, case) for kind, cases in KEPT.items() for case in cases])
def test_earlier_outputs_of_commands_satisfy_the_present_schemas(kind, case):
    left_out = {"versions": {}} if "versions" in json_schema(kind)["properties"] else {}
    valid(kind, kept(case) | left_out)


def test_the_summary_of_plates_is_valid(letter):
    valid("summary", letter)


@pytest.mark.parametrize(
    "values",
    [
        SHORT | {"protocol.contact": True, "medium.density": "1.2 kg/m^3", "medium.viscosity": "1.8e-5 Pa s"},
        SHORT | {"coupling.stiffness": "1 N m/rad", "protocol.gravity": "9.81 m/s^2"},
        SHORT | {"protocol.timestep": "2 ms", "protocol.rise": "0.2 s"},
    ],
)
def test_the_summary_of_a_wing_is_valid(values):
    valid("summary", summary_of(ff.run(ff.load_design("binder2025", values), confirm=False)))


def test_the_summary_of_a_sheet_of_bars_is_valid():
    stage = {"name": "fold", "drive": "fold", "until": "time", "hold": "0 s", "time_limit": "5 ms"}
    sheet = ff.load_design("miura-sheet")
    valid("summary", summary_of(ff.run(sheet.with_values({"protocol.stages": [stage]}), confirm=False)))


@pytest.mark.parametrize("name", ["letter-fold", "binder2025"])
def test_a_landscape_is_valid(name, landscape_of):
    landscape = landscape_of(ff.load_design(name))
    valid("landscape", json.loads(json.dumps(landscape_summary(landscape), allow_nan=False)))


def test_a_row_of_a_study_is_valid(tmp_path):
    study = ff.new_study("letter-fold", {"tendon.left.stiffness": ["0.4 N/cm", "0.5 N/cm"]})
    for row in json_rows(study, ff.run_study(study, out=tmp_path)):
        valid("row", json.loads(json.dumps(row, allow_nan=False)))


@pytest.mark.parametrize(
    "wrong",
    [
        lambda summary: summary.pop("verdict"),
        lambda summary: summary.update(verdict="fine"),
        lambda summary: summary["energy_balance"].update(work_kJ=1.0),
        lambda summary: summary.update(folded="yes"),
        lambda summary: summary["states"]["flat"].update(time_s="soon"),
    ],
)
def test_invalid_data_is_rejected(letter, wrong):
    summary = json.loads(json.dumps(letter))
    wrong(summary)
    with pytest.raises(jsonschema.ValidationError):
        valid("summary", summary)


def test_a_schema_is_printed(capsys):
    main(["schema", "row"])
    assert json.loads(capsys.readouterr().out) == json_schema("row")
    with pytest.raises(InputError, match=r'need "summary", .*, got "sumary"; did you mean "summary"'):
        json_schema("sumary")
