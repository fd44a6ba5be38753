"""Pages of a structure without veins."""

import json
import re
from dataclasses import replace

import numpy as np
import pytest

from forficula.analysis.groups import dominance, groups_of
from forficula.show.page import run_page as page_of_a_run
from forficula.show.page.compare_page import ComparedRun, compare_page
from forficula.show.page.parts.design_tables import design_tables
from forficula.show.page.parts.outcome_tables import groups_table, outcome_tables
from forficula.show.page.playback import legend_data, make_clip
from forficula.show.page.run_page import playback_data, run_page
from tests.show.plates import PARTS


@pytest.fixture(autouse=True)
def without_warnings(monkeypatch):
    """Without a file that describes the plates, and without code that builds them again."""
    for name in ("structure_warnings", "timestep_warnings", "run_warnings"):
        monkeypatch.setattr(page_of_a_run, name, lambda *_: [])


@pytest.mark.parametrize("name", PARTS)
def test_every_run_has_a_page_with_its_own_words(plates_runs, name):
    record, outcome = plates_runs[name]
    page = run_page(record, outcome)
    body = re.sub(r"<script>.*?</script>|<style>.*?</style>", "", page.partition("Design</h2>")[0], flags=re.S)
    assert not re.search(r"\b(vein|wing|panel|membrane|distal)", body)
    data = playback_data(make_clip(record, outcome))
    assert data["whole"] == "structure"
    assert data["text"].startswith("A structure of 3 plates")
    titles = [plot["title"] for plot in data["plots"]]
    assert titles == [*(["crease angle"] if name == "unmeasured" else ["fold angle", "mouth"]), "energy"]
    json.dumps(data, allow_nan=False)


def test_the_page_reports_the_outcome(plates_runs):
    record, outcome = plates_runs["whole"]
    page = run_page(record, outcome)
    assert "three-plates closed in 64 ms with 6 N cm on a crease" in page
    assert "stayed closed when released, opened again in 40 ms with 20 N cm on a crease" in page
    assert "<caption>Closing and opening</caption>" in page
    samples = [entry["sample"] for entry in legend_data([make_clip(record, outcome)])]
    assert samples == ["edge", "region 0", "region 1", "base", "tendon"]
    patterned = [entry["text"] for entry in legend_data([make_clip(*plates_runs["with a pattern"])])]
    assert patterned[:2] == ["mountain (dash-dotted crease)", "valley (dashed crease)"]


def test_names_keep_their_hyphens_where_numbers_have_minus_signs(plates_runs):
    record, outcome = plates_runs["whole"]
    structure = record.structure
    tendons = tuple(replace(tendon, name=f"{tendon.name}-b") for tendon in structure.tendons)
    first, *rest = structure.transitions
    closing = replace(first, wording=replace(first.wording, noun="re-closing"))
    turned = {
        name: replace(transition, strength=-transition.strength) for name, transition in outcome.transitions.items()
    }
    renamed = replace(structure, tendons=tendons, transitions=(closing, *rest))
    tables = "".join(outcome_tables(replace(outcome, transitions=turned, structure=renamed)))
    assert f"{tendons[0].name}<" in tables
    assert "re-closing<" in tables
    assert re.search(r">−6 N cm<", tables)
    assert not re.search(r">[^<]*-\d", tables)


def test_structures_of_all_kinds_are_compared(plates_runs, short_run, short_outcome):
    chosen = [
        ComparedRun(label=name, record=record, outcome=outcome) for name, (record, outcome) in plates_runs.items()
    ]
    fan = ComparedRun(label="fan", record=short_run, outcome=short_outcome)
    data = json.loads(
        re.search(r'id="data">(.*?)</script>', compare_page([*chosen[:2], fan]).replace("\\u003c", "<"), re.S)[1]
    )
    assert data["whole"] == "structure"
    assert [plot["title"] for plot in data["plots"]] == [
        "reading furthest from its goal",
        # the fan stores far more energy than the sheets
        "energy of all tendons, whole and with a pattern",
        "energy of all tendons, fan",
    ]
    assert [span["name"] for span in data["spans"]] == ["closing", "opening", "whole runs from their start"]
    page = compare_page(chosen)
    assert '<tr><th scope="row">mouth after closing</th><td>11.48 cm</td>' in page
    assert "elastic energy" in page


def test_a_design_of_a_kind_without_a_named_design_is_not_compared(plates_runs):
    tables = "".join(design_tables(plates_runs["whole"][0].design))
    assert "named design" not in tables
    assert "<mark>" not in tables
    assert "Stages of the protocol (protocol.stages)" in tables


def test_the_page_of_plates_works_in_a_browser(plates_runs, watch, tmp_path):
    record, outcome = plates_runs["with a pattern"]
    (tmp_path / "plates.html").write_text(run_page(record, outcome), "utf-8")
    opened = watch(tmp_path / "plates.html")
    page = opened.page
    page.get_by_role("button", name="b closed").click()
    opened.settle()
    assert opened.messages == []
    vertices = np.array(page.evaluate("Array.from(forficula.player.stage.views[0].shape.vertices)")).reshape(-1, 3)
    corners = record.series["point_position"][np.argmin(np.abs(record.time - outcome.states["closed"].time)), :13]
    assert np.linalg.norm(corners[:, None] - vertices[None], axis=2).min(axis=1).max() < 1e-6
    cells = page.locator("#readout tr:has(th:text-is('fold angle (deg)')) td").all_inner_texts()
    assert cells == ["172.0", "160.0", "", ""]
    assert page.locator("#readout thead th").all_inner_texts() == ["crease 1", "crease 2", "mouth", "pull"]


def test_the_page_has_dimensionless_groups_and_what_dominates(plates_runs):
    record, _ = plates_runs["whole"]
    output = re.sub(r"<[^>]*>", " ", groups_table(record))
    groups = groups_of(record.structure, record.design.protocol.timestep)
    # quotes are escaped
    assert dominance(groups).replace("'", "&#x27;") in output
    for group in groups.every:
        assert re.search(rf"\b{group.name}\s+{re.escape(f'{group.value:.3g}')}\s", output), group.name


def test_a_page_without_groups_has_no_section_about_them(plates_runs):
    record, _ = plates_runs["whole"]
    bare = replace(
        record.structure, tendons=(), hinges=tuple(replace(h, stiffness=0.0) for h in record.structure.hinges)
    )
    assert groups_table(replace(record, structure=bare)) == ""
