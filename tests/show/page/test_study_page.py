"""The page of a study has its numbers, a limited size of its runs, and no text that acts as HTML."""

import csv
import html
import io
import json
import re
from dataclasses import replace

import numpy as np
import pytest

from forficula.reproduction import compare
from forficula.show.page.parts.points_table import places
from forficula.show.page.study_page import study_page, study_sentence
from forficula.study import load_study, table_csv
from forficula.study.running.kept_runs import KeptRun
from tests.show.study.test_choices_figure import planted as choices_table
from tests.show.study.test_maps import TWO, as_run, many_ends, planted, sampled

GRID = '"tendon.stiffness" = ["10 N/cm", "20 N/cm", "30 N/cm"]\n"tendon.rest_length" = ["0 cm", "3 cm", "6 cm", "9 cm"]'


@pytest.fixture
def study(study_file):
    return load_study(study_file(GRID, 'ask = "least-torques"'))


@pytest.fixture
def kept(reference_run, reference_outcome):
    """Return a kept run at a point."""

    def keep(point, part="opening"):
        folder = f"runs/{point + 1}-{part}"
        return KeptRun(point=point, part=part, folder=folder, record=reference_run, outcome=reference_outcome)

    return keep


def data(page):
    return json.loads(re.search(r'<script type="application/json" id="data">(.*?)</script>', page, re.DOTALL)[1])


def rows(page):
    """Return the texts of the table of all points."""
    body = re.search(r"<caption>One row for each point[^<]*</caption>.*?<tbody>(.*?)</tbody>", page, re.DOTALL)[1]
    return [re.findall(r"<t[hd][^>]*>(.*?)</t[hd]>", row) for row in re.findall(r"<tr>(.*?)</tr>", body)]


def test_a_page_of_sixty_points_with_two_runs_each_is_below_ten_megabytes(study, kept):
    runs = (kept(point % 12, part) for point in range(60) for part in ("folding", "opening"))
    page = study_page(study, many_ends(), runs, 120)
    assert len(data(page)["runs"]) == 120
    assert len(page.encode()) < 10e6


def test_few_runs_have_more_frames_than_many(study, kept):
    one = data(study_page(study, many_ends(), [kept(0)], 1))["runs"][0]["play"]["clips"][0]
    many = data(study_page(study, many_ends(), [kept(0)], 120))["runs"][0]["play"]["clips"][0]
    assert len(one["points"]) > 2 * len(many["points"])


def test_the_states_are_among_the_frames_however_few_there_are(study, kept, reference_outcome):
    clip = data(study_page(study, many_ends(), [kept(0)], 500))["runs"][0]["play"]["clips"][0]
    times = [mark["time"] for mark in clip["marks"]]
    outcome = reference_outcome
    assert times == [state.time for state in outcome.states.values()]


def test_every_run_says_which_point_it_is_what_it_did_and_where_it_lies(study, kept):
    run = data(study_page(study, many_ends(), [kept(3)], 1))["runs"][0]
    assert (run["point"], run["part"], run["folder"]) == (3, "opening", "runs/4-opening")
    assert run["title"] == "folding with 50 N cm, opening with 100 N cm"
    assert "opened again" in run["text"]


def test_the_table_on_the_page_has_one_row_for_each_point_with_the_numbers_of_the_file(study):
    table = many_ends()
    result = rows(study_page(study, table, (), 0))
    expected = list(csv.DictReader(io.StringIO(table_csv(study, table))))
    assert len(result) == len(expected) == 12
    for point, (cells, row) in enumerate(zip(result, expected, strict=True)):
        assert cells[0] == str(point + 1)
        assert float(cells[1]) * 100 == pytest.approx(float(row["tendon_stiffness_N_per_m"]))
        assert float(cells[2]) / 100 == pytest.approx(float(row["tendon_rest_length_m"]))
        assert html.unescape(cells[3]) == row["status"] or not row["status"]
        torque = row["least_fold_torque_N_m"]
        assert cells[4] == "—" if not torque else float(cells[4]) == pytest.approx(100 * float(torque), rel=1e-3)


def test_the_file_to_download_is_the_file_of_the_folder(study):
    table = many_ends()
    assert data(study_page(study, table, (), 0))["csv"] == table_csv(study, table)


def test_a_study_with_many_points_has_a_map_and_a_reference_to_the_file(study_file):
    factors = '"tendon.stiffness" = "1..61 N/cm step 1"\n"tendon.rest_length" = "0..49 mm step 1"'
    study = load_study(study_file(factors, 'ask = "least-torques"'))
    table = planted(TWO)
    places = {name: np.arange(size) % table.sizes[name] for name, size in zip(TWO, (61, 50), strict=True)}
    page = study_page(study, table.isel(places), (), 0)
    assert "A table of 3050 points is too long for this page; table.csv lists all." in page
    assert data(page)["csv"] is None
    assert len(data(page)["study"]["statuses"]) == 3050


def test_the_sentence_counts_what_folds_and_opens(study, study_file):
    assert study_sentence(study, many_ends()) == (
        "12 points: 5 fold, with 1 N cm to 6 N cm; 3 open again, with 1 N cm to 5 N cm."
    )
    nothing = planted(TWO, np.full((3, 4), "did not fold", dtype=object))
    assert study_sentence(study, nothing) == "12 points: none can fold; none can open again."
    plain = as_run(many_ends()).assign(folded=(TWO, np.eye(3, 4) > 0), opened=(TWO, np.zeros((3, 4), dtype=bool)))
    assert study_sentence(load_study(study_file(GRID)), plain) == "12 points: 3 fold, 0 fold and open again."


def test_the_last_factor_varies_fastest_and_drawn_points_have_their_own_values():
    factors = [{"values": [1, 2, 3]}, {"values": [1, 2, 3, 4]}]
    assert [places({"sampled": False, "factors": factors}, point) for point in (0, 1, 4, 11)] == [
        [0, 0],
        [0, 1],
        [1, 0],
        [2, 3],
    ]
    assert places({"sampled": True, "factors": factors}, 2) == [2, 2]


def test_the_page_lists_the_claims_of_the_paper_if_there_are_any(study):
    table = many_ends()
    assert "Comparison with the paper" not in study_page(study, table, (), 0)
    compared = compare(replace(study, reproduces="binder2025"), table)
    page = study_page(study, table, (), 0, compared)
    assert "Comparison with the paper" in page
    assert "claims of Binder, Costi, Izzo, Seidl (Biomimetics 11(1):9, 2025, doi 10.3390/biomimetics11010009)" in page
    for claim in compared.claims:
        assert html.escape(claim.claim) in page


def test_a_name_that_looks_like_a_script_stays_text(study, kept):
    hostile = replace(study, name="</script><script>alert(1)</script>", source="<img src=x onerror=alert(1)>")
    page = study_page(hostile, many_ends(), [kept(0)], 1)
    assert "<script>alert" not in page
    assert "<img" not in page
    assert data(page)["study"]["name"] == hostile.name


def test_drawn_points_and_plain_runs_have_a_page_too(study_file):
    drawn = '"tendon.stiffness" = {distribution = "uniform", low = "10 N/cm", high = "30 N/cm"}\n'
    drawn += '"tendon.rest_length" = {distribution = "uniform", low = "0 cm", high = "9 cm"}'
    study = load_study(study_file(drawn, 'ask = "least-torques"\n[sampling]\ncount = 12\n'))
    page = study_page(study, sampled(many_ends()), (), 0)
    assert len(rows(page)) == 12
    assert "12 values drawn" in page


def test_choices_are_listed_with_the_number_of_wings_that_fold(study_file):
    dampings = '"hinge.damping" = ["1e-4 N m s/rad", "1e-2 N m s/rad"]\n"vein.diameter" = ["3 mm", "10 mm"]'
    grid = '[grid]\n"tendon.stiffness" = ["10 N/cm", "20 N/cm"]\n"tendon.rest_length" = ["0 cm", "3 cm", "6 cm"]'
    head = 'vary = "one-at-a-time"\nask = "least-torques"'
    study = load_study(study_file(dampings, head, f"{grid}\n[search]\nunfold_torques = []"))
    page = study_page(study, choices_table(), [], 0)
    body = re.search(r"<caption>One value is changed[^<]*</caption>.*?<tbody>(.*?)</tbody>", page, re.DOTALL)[1]
    assert [re.findall(r"<t[hd][^>]*>(.*?)</t[hd]>", row) for row in re.findall(r"<tr>(.*?)</tr>", body)] == [
        ["hinge damping 0.0001 N m s/rad", "6"],
        ["hinge damping 0.001 N m s/rad, as in binder2025", "4"],
        ["hinge damping 0.01 N m s/rad", "0"],
        ["vein diameter 3 mm", "2"],
        ["vein diameter 5 mm, as in binder2025", "4"],
        ["vein diameter 10 mm", "3"],
    ]
    # maps show the grid, and begin with the base design
    shown = data(page)["study"]
    assert [factor["key"] for factor in shown["factors"]] == ["choice", "tendon.stiffness", "tendon.rest_length"]
    assert (shown["axes"], shown["cuts"]) == ([1, 2, 0], [0, 1, 1])
    assert rows(page)[6][1:4] == ["a", "1000", "0"]


def test_a_grid_has_no_choices_side_by_side(study):
    assert "Choices side by side" not in study_page(study, many_ends(), [], 0)
