"""From Python: what every command does is one call, by name, path or design, and every example in it is true."""

import doctest
import importlib
import os
from importlib import metadata

import pytest
import xarray

import forficula as ff
import forficula.calls
import forficula.results
from forficula.design import with_values
from tests.letters import QUICK


@pytest.fixture(scope="module")
def design():
    return ff.load_design("letter-fold", QUICK)


@pytest.fixture(scope="module")
def record(letter_run):
    return letter_run


@pytest.mark.usefixtures("undrawn")
def test_every_example_is_true(tmp_path, monkeypatch, record):
    monkeypatch.chdir(tmp_path)
    known = {"ff": ff, "design": ff.load_design("letter-fold", QUICK), "result": record}
    parts = ("designs", "goals", "patterns", "output", "progress", "runs", "studies")
    calls = [importlib.import_module(f"forficula.calls.{part}") for part in parts]
    modules = (*calls, forficula.results)
    result = [item for module in modules for item in doctest.DocTestFinder().find(module, extraglobs=known)]
    examples = [item for item in result if item.examples]
    runner = doctest.DocTestRunner(optionflags=doctest.ELLIPSIS)
    for example in examples:
        runner.run(example)
    assert runner.summarize(verbose=False).failed == 0
    shown = {example.name.rpartition(".")[2] for example in examples}
    functions = {name for name in forficula.calls.__all__ if name[0].islower()}
    assert functions <= shown
    # `collect`, `estimate` and `study_status` are methods of a study
    assert functions - {"collect", "estimate", "study_status"} <= set(ff.__all__)


def test_every_public_name_exists_and_is_listed_once():
    assert len(set(ff.__all__)) == len(ff.__all__)
    assert set(ff.__all__) == set(dir(ff))
    for name in ff.__all__:
        assert getattr(ff, name) is not None
    assert ff.__version__ == metadata.version("forficula")
    with pytest.raises(AttributeError, match="runn"):
        ff.runn  # noqa: B018


def test_values_are_replaced_by_text_with_a_unit_or_in_si(design):
    changed = ff.load_design("binder2025").with_values({"tendon.stiffness": "20 N/cm", "pattern.units": 2})
    assert changed == with_values(ff.load_design("binder2025"), {"tendon.stiffness": 2000.0, "pattern.units": 2})
    with pytest.raises(ff.InputError, match=r"did you mean tendon\.stiffness"):
        ff.load_design("binder2025").with_values({"tendon.stifness": "20 N/cm"})
    assert design.with_values({}) == design


@pytest.mark.parametrize(
    "call",
    [
        ff.run,
        ff.landscape,
        ff.assumptions,
        ff.check_design,
        ff.structure_of,
        ff.pattern_facts,
        lambda design: ff.new_study(design, {}),
    ],
)
def test_what_is_no_design_gets_a_sentence(call):
    with pytest.raises(
        ff.InputError, match=r"^design: need a design, its name or the path of its file.*, got 3 \(int\)"
    ):
        call(3)
    with pytest.raises(ff.InputError, match='did you mean "binder2025"'):
        call("binder2026")


def test_a_run_is_looked_for_in_its_folder(tmp_path, record):
    (tmp_path / "there").mkdir()
    record.save(tmp_path / "there" / "record.nc")
    loaded = ff.load_run(tmp_path / "there")
    assert loaded.data.equals(record.data)
    ff.page(os.fspath(tmp_path / "there"), tmp_path / "page.html")
    assert "letter-fold" in (tmp_path / "page.html").read_text("utf-8")
    with pytest.raises(ff.InputError, match=r"record.nc: no such file"):
        ff.load_run(tmp_path)
    with pytest.raises(
        ff.InputError, match=r"^run: need a run \(as run or load_run returns it\), its record, or a path, got "
    ):
        ff.film([record], tmp_path / "film.gif")


def test_figures_are_drawn_of_whatever_a_call_hands_back(tmp_path, record):
    surveyed = ff.landscape("binder2025-joint")
    assert ff.figure(surveyed, "rests", width="page").get_size_inches()[0] == pytest.approx(7.1)
    assert ff.figure(record, "angles", width=5.0).get_size_inches()[0] == pytest.approx(5.0)
    record.save(tmp_path / "record.nc")
    assert ff.figure(tmp_path, "energy").get_size_inches()[0] == pytest.approx(3.5)
    with pytest.raises(ff.InputError, match=r'kind: need "angles", .* got "angels"; did you mean "angles"'):
        ff.figure(record, "angels")
    with pytest.raises(ff.InputError, match="need results of forficula or their folder, got a int"):
        ff.figure(3)
    with pytest.raises(ff.InputError, match=r"need results of forficula or their folder, got a dict"):
        ff.save({}, tmp_path)


@pytest.mark.usefixtures("undrawn")
def test_every_result_that_is_saved_is_written_as_a_page_too(tmp_path, design):
    results = {
        "landscape": ff.landscape("binder2025-joint"),
        "assumptions": ff.assumptions(design, only=["timestep"]),
        "study": ff.run_study(ff.new_study(design, {"tendon.left.stiffness": ["0.4 N/cm"]}), tmp_path / "runs"),
        "tolerance": ff.tolerance(design, tmp_path / "built", tolerances={"facet.thickness": "1 %"}, runs=8),
    }
    for name, result in results.items():
        ff.page(result, tmp_path / f"{name}.html")
        ff.save(result, tmp_path / name)
        assert "</html>" in (tmp_path / f"{name}.html").read_text("utf-8")
    # the page of a folder is the one in it
    ff.page(tmp_path / "landscape", tmp_path / "again.html")
    assert (tmp_path / "again.html").read_bytes() == (tmp_path / "landscape" / "report.html").read_bytes()
    (tmp_path / "parts").mkdir()
    (tmp_path / "parts" / "parts.html").write_text("of parts")
    ff.page(tmp_path / "parts", tmp_path / "again.html")
    assert (tmp_path / "again.html").read_text("utf-8") == "of parts"
    for other in ({}, xarray.Dataset({"a": ("x", [1.0])})):
        with pytest.raises(ff.InputError, match="need results of forficula or their folder, got a "):
            ff.page(other, tmp_path / "none.html")


@pytest.mark.usefixtures("undrawn")
def test_a_table_is_saved_with_the_files_that_its_command_writes(tmp_path, design):
    study = ff.new_study(design, {"tendon.left.stiffness": ["0.4 N/cm", "0.5 N/cm"]})
    table = ff.run_study(study, tmp_path / "runs")
    ff.save(table, tmp_path / "study")
    assert {"table.csv", "table.nc", "report.html"} <= {path.name for path in (tmp_path / "study").iterdir()}
    ff.page(table, tmp_path / "light.html", engine=False)
    assert (tmp_path / "light.html").stat().st_size < (tmp_path / "study" / "report.html").stat().st_size
    built = ff.tolerance(design, tmp_path / "built", tolerances={"facet.thickness": "1 %"}, runs=8)
    ff.save(built, tmp_path / "there")
    assert {"design.toml", "tolerance.json", "tolerance.nc", "table.csv", "report.html"} == {
        path.name for path in (tmp_path / "there").iterdir()
    }
    with pytest.raises(ff.InputError, match=r"need a folder of its own, got .*, which holds a tolerance"):
        ff.save(table, tmp_path / "there")
    # what belongs to a part of a table is not known
    for part in (table.isel(tendon_left_stiffness=[0]), xarray.load_dataset(tmp_path / "study" / "table.nc")):
        with pytest.raises(ff.InputError, match="need the whole table of a study as run_study or collect returns it"):
            ff.save(part, tmp_path / "part")
    with pytest.raises(ff.InputError, match="need the whole table as tolerance returns it"):
        ff.page(built.isel(sample=[0]), tmp_path / "part.html")


def test_a_study_is_built_without_a_file(design):
    requested = ff.new_study(design, {"tendon.left.stiffness": "0.4..0.5 N/cm step 0.1"}, name="mine", source="own")
    assert (requested.name, requested.source, len(requested.points)) == ("mine", "own", 2)
    assert requested.base == design
    with pytest.raises(ff.InputError, match='askk: unknown key, got "run"; did you mean ask'):
        ff.new_study(design, {"tendon.left.stiffness": ["0.4 N/cm"]}, askk="run")


def test_convergence_asks_for_one_of_three(design):
    with pytest.raises(ff.InputError, match="converge: need one of timesteps, moduli, meshes, got none"):
        ff.converge(design)
    with pytest.raises(ff.InputError, match=r'timesteps: need numbers .* got "often"'):
        ff.converge(design, timesteps="often")


def test_assumptions_to_change_are_given_by_name(design):
    for only, said in (
        (["slow rice"], r'^only: need .*slow rise.*got "slow rice"; did you mean "slow rise"'),
        ("gravity", r'^only: need a list of texts, got "gravity"'),
        ([], "^only: need at least one name of an assumption, got none"),
    ):
        with pytest.raises(ff.InputError, match=said):
            ff.assumptions(design, only=only)


@pytest.mark.parametrize("values", [None, 5, "x", [("tendon.left.stiffness", 1.0)], {5: 6}])
def test_values_are_given_by_key(design, values):
    with pytest.raises(ff.InputError, match=r'need values by key, such as {"tendon.stiffness": "20 N/cm"}, got '):
        design.with_values(values)


@pytest.mark.parametrize("factors", [None, 5, []])
def test_factors_of_a_study_are_given_by_key(design, factors):
    with pytest.raises(ff.InputError, match="factors: need a table "):
        ff.new_study(design, factors)


@pytest.mark.parametrize("width", ["colum", 0, -1, float("nan"), 1e9, None, (3, 4)])
def test_a_width_that_no_figure_has_is_refused(record, width):
    with pytest.raises(ff.InputError, match=r'^width: need .*"column"(, | or )"page".*, got '):
        ff.figure(record, "angles", width=width)


@pytest.mark.parametrize(
    ("choice", "value"),
    [("size", value) for value in (5, (5,), (161, 161), "160x160", (0, 0), (10**9, 10**9))]
    + [("fps", value) for value in (0, -1, "x", 2.5)]
    + [("slower", value) for value in (0, -3, "x", float("nan"), 1e12)],
)
def test_a_film_that_nobody_could_watch_is_refused(tmp_path, record, choice, value):
    with pytest.raises(ff.InputError, match=rf"^{choice}: need .* got "):
        ff.film(record, tmp_path / "film.gif", **{choice: value})
    assert not list(tmp_path.iterdir())


def test_a_study_varies_what_its_design_leaves_out():
    requested = ff.new_study(
        "binder2025", {"medium.density": ["0 kg/m^3", "1.2 kg/m^3"], "contact.friction": [0.0, 0.5]}
    )
    assert len(requested.points) == 4
    with pytest.raises(ff.InputError, match=r"tendon\.law\.linear_modulus: binder2025 has no tendon\.law"):
        ff.new_study("binder2025", {"tendon.law.linear_modulus": ["1 MPa"]})


@pytest.mark.parametrize("folders", ["out/one", 5])
def test_one_folder_is_no_list_of_them(tmp_path, folders):
    with pytest.raises(ff.InputError, match=r"^runs: need a list of runs or paths, got "):
        ff.compare(folders, tmp_path / "both.html")


@pytest.mark.parametrize("name", ["a\0b", "\ud800"])
def test_a_figure_of_a_folder_that_cannot_exist_is_refused(name):
    with pytest.raises(ff.InputError, match="need a folder that forficula wrote, got no such folder"):
        ff.figure(name, "energy")


def test_a_wait_that_would_never_end_is_refused():
    with pytest.raises(ff.InputError, match=r"stages\.2\.wait: need <= 1e\+09 d, got 1e300 d"):
        ff.load_design("binder2025-stored", {"protocol.stages.2.wait": "1e300 d"})


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda _: ff.load_run(5), r"^path: need a path, got 5 \(int\)"),
        (lambda _: ff.load_design(5), r"^name_or_path: need a path, got 5 \(int\)"),
        (lambda _: ff.load_design("binder2025", 5), r"^settings: need a table of values by key, got 5 \(int\)"),
        (lambda _: ff.load_study(None), r"^name_or_path: need a path, got None"),
        (lambda _: ff.load_study("binder2025-serch"), r'did you mean "binder2025-search"'),
        (lambda _: ff.measure(5), r"^run: need a run .* or a path, got 5 \(int\)"),
        (lambda _: ff.converge("letter-fold", timesteps=5), r"^timesteps: need text or a list of numbers, got 5"),
        (lambda _: ff.converge("letter-fold", timesteps=["a"]), r"^timesteps: need text or a list of numbers, got "),
        (lambda _: ff.scale_design("binder2025", "small"), r'^factor: need a number, got "small" \(str\)'),
        (lambda record: ff.compare([record, 3], "both.html"), r"^runs: need a list of runs or paths, got "),
        (lambda record: ff.page(record, "run.txt"), r"need a file that ends with \.html, got run\.txt"),
        (lambda record: ff.save(record, ""), r'need a folder, got ""'),
        (lambda record: ff.film(record, 3), r"^path: need a path, got 3"),
    ],
)
def test_what_is_no_path_and_no_result_gets_a_sentence(record, call, message):
    with pytest.raises(ff.InputError, match=message):
        call(record)


@pytest.mark.usefixtures("undrawn")
def test_what_takes_a_design_or_a_run_takes_its_name_or_folder(tmp_path, record):
    assert ff.scale_design("letter-fold", 0.5) == ff.scale_design(ff.load_design("letter-fold"), 0.5)
    ff.save(record, tmp_path / "there")
    assert ff.measure(tmp_path / "there").status == ff.measure(record).status
