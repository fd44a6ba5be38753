"""Results in notebooks: a sentence, tables with units, a figure, a run that plays."""

import pytest
import xarray

import forficula as ff
from forficula.analysis.run import Run
from forficula.design import design_text
from forficula.goals import goal_of
from forficula.goals.identify import observations_of
from forficula.material import load_law
from tests.assumptions import ASSUMED
from tests.letters import QUICK
from tests.material.synthetic import cyclic_test


@pytest.fixture(scope="module")
def design(letter_run):
    return letter_run.design


@pytest.fixture(scope="module")
def record(letter_run):
    return letter_run


@pytest.fixture(scope="module")
def results(design, record, surveyed, tmp_path_factory):
    quick = ff.load_design("letter-fold", QUICK)
    study = ff.new_study(quick, {"tendon.left.stiffness": ["0.4 N/cm", "0.5 N/cm"]}, name="letters")
    return {
        "design": design,
        "record": record,
        "run": Run(record),
        "outcome": ff.measure(record),
        "landscape": surveyed("plates"),
        "convergence": ff.converge(quick, timesteps="0.5 0.25 ms"),
        "assumptions": ASSUMED,
        "study": study,
        "table": ff.run_study(study, out=tmp_path_factory.mktemp("study")),
        "material": ff.material.characterise([cyclic_test(lambda strain, _: 5e6 * strain)]),
        "law": load_law("tpu-82a"),
        "parts": ff.make.parts("binder2025-joint", "joint"),
        **_answers(quick, tmp_path_factory.mktemp("answers")),
    }


def _answers(design, folder):
    """A goal and observations with their results."""
    goal = goal_of(
        {
            "name": "light",
            "design": "binder2025-joint",
            "simulate": False,
            "vary": {"tendon.rest_length": ["5 cm", "6 cm"]},
            "limits": {"hinge_holding_torque": ">= 1 N cm"},
            "objectives": {"mass": "least"},
        }
    )
    fact = {"name": "closes", "quantity": "closed", "until": "close"}
    unknown = {"tendon.left.stiffness": ["0.4 N/cm", "0.5 N/cm"]}
    sampling = {"samples": 2, "directed": 0}
    seen = observations_of({"design": design, "unknown": unknown, "sampling": sampling, "fact": [fact]})
    return {
        "goal": goal,
        "optimum": ff.optimise(goal, folder / "optimum"),
        "observations": seen,
        "identified": ff.identify(seen, folder / "identified"),
    }


@pytest.mark.parametrize(
    ("name", "parts"),
    [
        ("design", ("letter-fold", "<img", "Every value", "N/cm")),
        ("record", ("<iframe", "allow-scripts", "letter-fold got closed in")),
        ("run", ("<iframe", "allow-scripts", "letter-fold got closed in")),
        ("outcome", ("letter-fold got closed in", "tendon (cm)", "Energy balance")),
        ("landscape", ("Stable states", "<img", "J</td>")),
        ("convergence", ("0.5 ms", "value of the design", "<img")),
        ("assumptions", ("drives rise over 0.2 s", "Does not apply: gravity", "flap: closed; 1 of 2", "<img")),
        ("study", ("2 points of letter-fold", "0.4 N/cm, 0.5 N/cm")),
        ("table", ("<img", "xarray.StudyTable")),
        ("material", ("MPa", "<img")),
        ("law", ("modulus.linear", "MPa")),
        ("parts", ("<iframe", "binder2025-joint: parts to make", "The parts are not checked yet")),
        ("goal", ("light", "The least mass of binder2025-joint", "tendon.rest_length", "5 cm | 6 cm", "&gt;= 1 N cm")),
        ("optimum", ("light: the least mass of 2 designs", "tendon.rest_length", "<img")),
        ("observations", ("1 fact on letter-fold", "tendon.left.stiffness", "closes", "<td>all</td>")),
        ("identified", ("2 samples of 1 unknown value of letter-fold drawn", "<img", "xarray.IdentificationTable")),
    ],
)
def test_a_result_shows_itself_in_a_notebook(results, name, parts):
    shown = results[name]._repr_html_()
    for part in parts:
        assert part in shown
    assert "http://" not in shown.replace("http://www.w3.org", "")
    assert all("alt=" in picture for picture in shown.split("<img")[1:])


def test_a_name_that_looks_like_a_script_stays_text(design):
    named = design.with_values({"source": "<script>alert(1)<script>", "shows": "<script>alert(2)<script>"})
    assert "<script>alert" not in named._repr_html_()


def test_a_line_of_a_result_has_the_units_of_the_field(results):
    assert repr(results["design"]).startswith("<PleatsDesign letter-fold, hash ")
    outcome = repr(results["outcome"])
    assert outcome.startswith("<Outcome of letter-fold: closed and opened>")
    assert "closed at 1.519 s: creases 105.6, 105.6 deg; mouth 4.586 cm; tendons 0.9959 mJ" in outcome
    assert repr(results["record"]).endswith("rows over 3.264 s: settle, close, release closed, open, release open>")
    assert repr(results["study"]) == "<Study letters: 2 points of letter-fold over tendon.left.stiffness>"
    assert repr(results["landscape"]).startswith("<EnergyLandscape of letter-fold: ")
    assert repr(results["material"]) == "<Characterisation of material: 1 specimen, linear spring>"


def test_a_design_is_printed_as_its_file(design):
    assert str(design) == design_text(design)
    assert 'stiffness = "' in str(design)


def test_a_part_of_an_identification_shows_itself_as_a_table(results):
    result = results["identified"]
    assert isinstance(result, xarray.Dataset)
    assert "2 samples" not in result.isel(fact=0)._repr_html_()


def test_a_table_of_a_study_is_a_dataset_and_stays_one(results):
    table = results["table"]
    assert isinstance(table, xarray.Dataset)
    assert "<img" in table.isel(tendon_left_stiffness=[0])._repr_html_()
    assert "<img" in table._repr_html_()
