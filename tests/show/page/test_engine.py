"""The engine of the pages, in Node.js without a browser, compared with the engine of the package."""

import gzip
import hashlib
import json
import os
import re
import shutil
import subprocess
from importlib import resources
from pathlib import Path

import numpy as np
import pytest

from forficula.analysis import measure
from forficula.analysis.advice import SHORTER_STEP
from forficula.analysis.verdict import ENDING_TEXTS
from forficula.design import load_design, with_values
from forficula.dynamics import compile_model, simulate, with_timestep
from forficula.dynamics.engine.closures import APART_TEXT
from forficula.quantities import READING_UNITS
from forficula.show.page.data.live_data import live_data
from forficula.show.page.data.shape_mesh import shape_mesh
from forficula.show.page.page import built
from forficula.show.page.parts.outcome_words import _PATTERNS
from forficula.show.page.parts.run_sentences import LIVE_OUTCOME_TEXTS
from forficula.show.page.study_live import study_live
from forficula.structure import structure_of
from forficula.study.running.runs import run
from forficula.study.search import SEARCH_TEXTS
from tests.elastic_joint import joint, stage
from tests.plate_sheets import miura, plates, vertex
from tests.show.page.live_wing import check_as_recorded, shown_measures

BUILT = resources.files("forficula.show.page") / "built"
WEB = Path(__file__).parents[3] / "web" / "src"
TIME = 1e-4  # s, tolerance of a record's times


def node_path():
    """Node.js of the system, or the one that comes with the driver of the browsers."""
    if result := shutil.which("node"):
        return result
    try:
        import playwright
    except ImportError:
        return None
    beside = Path(playwright.__file__).parent / "driver" / "node"
    return str(beside) if beside.is_file() else None


@pytest.fixture(scope="module")
def run_in_page(tmp_path_factory):
    """Return outcomes of the pages' engine for a design with several settings, each of dotted keys in SI."""
    node = node_path()
    if node is None:
        reason = "Node.js is missing; install it, as with: apt-get install nodejs: the pages' engine is not tested"
        if os.environ.get("FORFICULA_NEED_BROWSER") == "1":
            pytest.fail(reason)
        pytest.skip(reason)
    folder = tmp_path_factory.mktemp("engine")

    def answers(design, settings):
        (folder / "live.json").write_text(json.dumps(live_of(design)), "utf-8")
        (folder / "settings.json").write_text(json.dumps(settings), "utf-8")
        script = Path(__file__).with_name("engine.mjs")
        files = [BUILT, folder / "live.json", folder / "settings.json"]
        done = subprocess.run([node, script, *files], capture_output=True, text=True, check=True, timeout=600)
        return json.loads(done.stdout)

    return answers


def live_of(design):
    structure = structure_of(design)
    return live_data(design, shown_measures(structure), shape_mesh(structure).anchors.tolist())


def outcomes(answered):
    assert answered["loaded"]["said"] == "loaded", answered["loaded"]
    return [answer["outcome"] for answer in answered["answers"]]


def test_the_engine_is_the_published_one_and_its_script_contains_its_hash():
    stamp = built("engine.js").partition("\n")[0]
    program = gzip.decompress((BUILT / "engine.wasm.gz").read_bytes())
    assert f"engine.wasm {hashlib.sha256(program).hexdigest()} " in stamp
    licences = built("LICENSES.txt")
    for words in ("mujoco 3.14.0", "Apache License", "Qhull", "Emscripten authors"):
        assert words in licences


def test_the_script_of_the_engine_makes_no_functions_from_text():
    assert re.search(r"\bnew Function\b|\bFunction\(|\beval\(", built("engine.js")) is None


def test_the_reference_folds_and_opens_in_a_page_as_it_is_recorded(run_in_page):
    record = run(load_design("binder2025"))
    (result,) = outcomes(run_in_page(record.design, [{}]))
    check_as_recorded(result, record)


def test_a_page_simulates_the_design_with_only_the_requested_values_changed(run_in_page):
    """Independent of what a reader has changed meanwhile, as while a map is refined."""
    stages = load_design("binder2025").as_tables()["protocol"]["stages"][:2]
    design = with_timestep(load_design("binder2025", {"protocol.stages": stages}))
    alone, _, after = outcomes(run_in_page(design, [{}, {"tendon.damping": 0.9, "protocol.fold_torque": 0.4}, {}]))
    assert after["transitions"] == alone["transitions"]


@pytest.mark.parametrize("name", ["binder2025-coupled", "binder2025-joint", "letter-fold"])
def test_other_structures_move_in_a_page_as_recorded(run_in_page, name):
    record = run(load_design(name))
    (result,) = outcomes(run_in_page(record.design, [{}]))
    check_as_recorded(result, record)


def test_rest_ends_a_driven_stage_in_a_page_only_once_its_drive_has_risen(run_in_page):
    loaded = stage("load", "fold", "rest", limit=0.2)
    values = {"protocol.rise": 0.02, "protocol.fold_torque": 0.05}
    record = run(joint(**values, **{"protocol.stages": [stage("settle", limit=0.05), loaded]}))
    (result,) = outcomes(run_in_page(record.design, [{}]))
    check_as_recorded(result, record)


LOOPS = """stiffness = "1e-3 N m/rad/m"
rest_angle = "60 deg"
damping = "1e-5 N m s/rad/m"
fold_limit = "120 deg"
back_limit = "180 deg"
"""
TURNED = """[[drive]]
name = "fold"
kind = "torque"
of = "creases"
value = "2e-3 N cm"
rise = "20 ms"
no_load_speed = "2000 deg/s"
[[measure]]
name = "width"
kind = "distance"
from = "vertex 0"
to = "vertex 3"
"""


ON_VERTICES = """
[[support]]
of = "vertex 0"
[[support]]
of = "vertex 1"
axes = "yz"
[[support]]
of = "vertex 3"
axes = "z"
"""


@pytest.mark.parametrize(
    ("pattern", "supports"),
    [(miura(2), ON_VERTICES), (vertex([60, 95, 120, 85], "VVVM", fold="25 deg"), "")],
    ids=["Miura sheet on vertices", "degree-4 vertex"],
)
def test_plates_in_loops_move_in_a_page_as_recorded(run_in_page, pattern, supports):
    """With Runge-Kutta steps and torques that depend on speed."""
    stages = [{"name": "fold", "drive": "fold", "limit": "0.1 s"}]
    design = plates(pattern, crease=LOOPS, more=TURNED + supports, stages=stages, step="0.1 ms")
    settings = [
        {"crease.stiffness": stiffness, "crease.rest_angle": np.radians(angle), "drive.fold.value": torque}
        for stiffness, angle, torque in ((1e-3, 60.0, 2e-5), (2e-3, -30.0, 2e-5), (5e-4, 100.0, 5e-5))
    ]
    answered = outcomes(run_in_page(design, settings))
    for values, result in zip(settings, answered, strict=True):
        (record,) = simulate([compile_model(with_values(design, values))])
        check_as_recorded(result, record)
        assert result["stages"][0]["work_J"] != 0


def test_loops_that_come_apart_are_untrusted_in_a_page(run_in_page):
    """With timesteps that are too long for welds."""
    stages = [{"name": "swing", "limit": "0.2 s"}]
    stiff = LOOPS.replace("1e-3", "2e-2").replace("1e-5", "0")
    design = plates(miura(3), crease=stiff, stages=stages, step="3 ms")
    (record,) = simulate([compile_model(design)])
    (result,) = outcomes(run_in_page(design, [{}]))
    assert result["verdict"] == "untrusted"
    # the outcome is far from any threshold
    assert result["advice"] == measure(record).advice != ""
    check_as_recorded(result, record)


def test_work_of_torques_that_depend_on_speed_is_that_of_the_record(run_in_page):
    """For servos, which do a small part of the work of constant torques."""
    stages = load_design("binder2025").as_tables()["protocol"]["stages"][:2]
    keys = {"protocol.no_load_speed": "3000 deg/s", "protocol.stages": stages}
    record = run(with_timestep(load_design("binder2025", keys)))
    (result,) = outcomes(run_in_page(record.design, [{}]))
    check_as_recorded(result, record)


def test_tendons_fold_and_fail_in_a_page_as_in_the_study(run_in_page):
    """Some designs of Binder et al. 2025, table 1, with 50 N cm and at the design's own timestep."""
    design = with_timestep(load_design("binder2025"))
    settle, fold, release = design.as_tables()["protocol"]["stages"][:3]
    # by then it is known whether they stay folded; two more seconds of swinging would add nothing
    design = with_values(design, {"protocol.stages": [settle, fold, release | {"time_limit": "0.15 s"}]})
    tendons = [
        {"tendon.stiffness": 1000.0 * tens, "tendon.rest_length": length / 100}
        for tens in (1, 3, 6)
        for length in (0, 2, 4, 6, 8)
    ]
    records = simulate([compile_model(with_values(design, tendon)) for tendon in tendons], sparse=True)
    result = outcomes(run_in_page(design, tendons))
    assert len({outcome["verdict"] for outcome in result}) > 1
    for outcome, record in zip(result, records, strict=True):
        measured = measure(record)
        assert outcome["status"] == measured.status
        took = measured.transitions["fold"]
        time = outcome["transitions"][0]["took"]["time_s"]
        assert time == (None if took.time is None else pytest.approx(took.time, abs=TIME))


def test_structures_that_the_engine_simulates_differently_are_refused_with_a_reason():
    for name, why in (
        ("miura-sheet", "its creases are not joints"),
        ("binder2025-built", "air or water"),
        ("binder2025-thick", "its parts touch"),
    ):
        refused = live_of(with_timestep(load_design(name)))
        assert list(refused) == ["refused"]
        assert why in refused["refused"]


def test_an_engine_with_another_model_layout_is_refused(run_in_page, monkeypatch):
    """As with an engine of another version. A control: otherwise numbers could go to wrong positions silently."""
    design = with_timestep(load_design("binder2025"))
    live = live_of(design)
    live["layout"]["jnt_dofadr"][3] += 1
    monkeypatch.setitem(globals(), "live_of", lambda _: live)
    answered = run_in_page(design, [])
    assert answered["loaded"] == {
        "said": "refused",
        "why": "the engine in this page has another layout of the model (jnt_dofadr)",
        "to": 0,
    }


def test_numbers_are_needed_because_older_engines_stretch_membranes_differently(run_in_page, monkeypatch):
    """Why numbers are needed: with the source alone the wing takes an eighth longer."""
    design = with_timestep(load_design("binder2025"))
    live = live_of(design) | {"numbers": {}}
    monkeypatch.setitem(globals(), "live_of", lambda _: live)
    (result,) = outcomes(run_in_page(design, [{}]))
    assert result["transitions"][0]["took"]["time_s"] == pytest.approx(0.0602, abs=5e-4)


def test_a_page_answers_as_a_study_would_at_points_that_fold_stick_and_open(run_in_page, monkeypatch, searched):
    """The search of the paper's table with fewer torques: least values and outcomes in words."""
    study, table = searched
    live = study_live(study)
    assert "refused" not in live
    monkeypatch.setitem(globals(), "live_of", lambda _: live)
    requested = [{"values": point, "search": live["search"]} for point in live["points"]]
    answered = run_in_page(study.base, requested)
    assert answered["loaded"]["said"] == "loaded", answered["loaded"]
    rows = [answer["answer"] for answer in answered["answers"]]
    assert [row["status"] for row in rows] == [str(status) for status in table["status"].values.ravel()]
    assert [row["word"] for row in rows] == [str(word) for word in table["outcome"].values.ravel()]
    assert len({row["word"] for row in rows}) > 1
    for name in ("least_fold_torque", "least_unfold_torque"):
        expected = [None if np.isnan(value) else value for value in table[name].values.ravel().tolist()]
        assert [row["least"][name] for row in rows] == pytest.approx(expected)


@pytest.mark.skipif(not WEB.is_dir(), reason="the sources of the script are not there")
def test_no_script_of_a_page_repeats_a_sentence_of_the_package():
    """Sentences are provided as data, with their fields in braces: copies would diverge."""
    sources = "\n".join(path.read_text(encoding="utf-8") for path in WEB.glob("*.js"))
    texts = [*ENDING_TEXTS.values(), *SEARCH_TEXTS.values(), APART_TEXT, SHORTER_STEP, "moving over time"]
    texts += ["time by torque", *LIVE_OUTCOME_TEXTS.values()]
    pieces = {piece.strip() for text in texts for piece in re.split(r"\{\w+\}", text)}
    long = {piece for piece in pieces if piece.count(" ") > 1}
    assert len(long) > 8
    assert [piece for piece in sorted(long) if piece in sources] == []


@pytest.mark.skipif(not WEB.is_dir(), reason="the sources of the script are not there")
def test_no_script_of_a_page_has_signs_of_outcomes_or_units_of_its_own():
    """Outcomes of points and legible units are decided in one place."""
    sources = "\n".join(path.read_text(encoding="utf-8") for path in WEB.glob("*.js"))
    written = re.sub(r"\\u([0-9a-f]{4})", lambda escape: chr(int(escape[1], 16)), sources)
    signs = [sign for sign in _PATTERNS if sign not in "·×–"]  # these are also punctuation
    assert [sign for sign in signs if sign in written] == []
    units = {unit for names in READING_UNITS.values() for unit, _, _ in names if len(unit) > 1} - {"deg", "cm", "mm"}
    assert [unit for unit in sorted(units) if f'"{unit}"' in written] == []
