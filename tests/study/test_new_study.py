"""A new study file can be run unchanged, and its commented lines are valid."""

import re
import tomllib

import numpy as np
import pytest

import forficula as ff
from forficula.design.files.key_table import key_facts
from forficula.design.files.kinds import KINDS
from forficula.design.section import STIFFNESS
from forficula.errors import InputError
from forficula.quantities import parse_quantity
from forficula.study.files.study_file import STUDY, StudyFile, named_studies
from forficula.study.new_file import write_new_file


@pytest.mark.parametrize("kind", KINDS)
def test_a_new_study_of_every_kind_is_read_and_varies_one_value(tmp_path, kind):
    write_new_file(path := tmp_path / "new.toml", STUDY, kind)
    study = ff.load_study(path)
    assert len(study.points) == 3
    assert study.search is None


@pytest.mark.parametrize(
    "taken",
    [
        ["[sampling]", "method", "count", "seed", '"tendon.stiffness" = {'],
        ['"tendon.stiffness" = "5..20', 'protocol.timestep = "0.1 ms"'],
        ["[search]", "fold_torques", "fold_with", "unfold_torques", "refinements"],
    ],
)
def test_commented_lines_of_a_new_study_are_valid(tmp_path, taken):
    write_new_file(path := tmp_path / "new.toml", STUDY)
    text = path.read_text("utf-8")
    for start in taken:
        if '"tendon.stiffness"' in start:
            text = text.replace('\n"tendon.stiffness" = [', '\n# "tendon.stiffness" = [', 1)
        text = text.replace(f"\n# {start}", f"\n{start}", 1)
    if "[search]" in taken:
        text = text.replace('# ask = "run"', 'ask = "least-torques"')
    path.write_text(text, "utf-8")
    assert ff.load_study(path).points


def test_a_new_study_is_not_written_over_a_file(tmp_path):
    write_new_file(path := tmp_path / "new.toml", STUDY)
    with pytest.raises(ff.InputError, match="exists already"):
        write_new_file(path, STUDY)
    with pytest.raises(ff.InputError, match=r'need "earwig-fan", .* got "wing"'):
        write_new_file(tmp_path / "other.toml", STUDY, "wing")


@pytest.mark.parametrize("name", ["aux.toml", "a:b.toml"])
def test_a_new_file_whose_name_results_cannot_have_is_not_written(tmp_path, name):
    with pytest.raises(ff.InputError, match=f"{name}: need a name that a folder can have on every system"):
        write_new_file(tmp_path / name, STUDY)
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("name", named_studies())
def test_every_key_of_a_study_is_listed(name):
    from importlib import resources

    tables = tomllib.loads((resources.files("forficula.study") / "references" / f"{name}.toml").read_text("utf-8"))
    known = {fact.key for fact in key_facts("", StudyFile)}
    for key, value in tables.items():
        inside = [key]
        if isinstance(value, dict):
            by_key = [name for name, entry in value.items() if key == "sampling" and isinstance(entry, dict)]
            inside = [f"{key}.{name}{'.KEY' * (name in by_key)}" for name in value]
        if isinstance(value, list) and isinstance(value[0], dict):
            entries = {name: entry for table in value for name, entry in table.items()}
            inside = [f"{key}.0.{name}{'.KEY' * isinstance(entry, dict)}" for name, entry in entries.items()]
        for item in inside:
            output = re.sub(r"^(settings|factors|grid|sampling\.width)\..*", r"\1.KEY", item)
            assert re.sub(r"\.[a-z]+_(torques|with)$", r".DRIVE_\1", output) in known


def test_an_unknown_table_of_a_study_is_rejected():
    assert [fact.key for fact in key_facts("sampling", StudyFile)] == [
        "sampling.method",
        "sampling.count",
        "sampling.seed",
        "sampling.width.KEY",
        "sampling.divisions",
        "sampling.logarithmic",
        "sampling.boundary",
        "sampling.probes",
        "sampling.most_points",
    ]
    with pytest.raises(ff.InputError, match=r"serch: unknown key; did you mean search\?"):
        key_facts("serch", StudyFile)


def test_numbers_of_a_study_in_python_are_in_si():
    length = ff.new_study("binder2025", {"tendon.rest_length": [0.05, "6 cm"]})
    assert [point["tendon.rest_length"] for point in length.points] == ["5 cm", "6 cm"]
    angles = ff.new_study("binder2025", {"hinge.overbend": np.radians([1, 2])})
    assert [float(str(point["hinge.overbend"]).split()[0]) for point in angles.points] == pytest.approx([1, 2])
    counts = ff.new_study("binder2025", {"pattern.units": [1, 2]})
    assert [point["pattern.units"] for point in counts.points] == [1, 2]
    drawn = ff.new_study(
        "binder2025",
        {"tendon.stiffness": {"distribution": "uniform", "low": 900.0, "high": "11 N/cm"}},
        sampling={"count": 4},
    )
    values = [parse_quantity(point["tendon.stiffness"], STIFFNESS) for point in drawn.points]
    assert all(900 <= value <= 1100 for value in values)
    with pytest.raises(InputError, match=r"factors.tendon.length: unknown key"):
        ff.new_study("binder2025", {"tendon.length": [0.05]})
