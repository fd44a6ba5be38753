"""Pages of goals contain the question, the result, and no text that acts as HTML."""

import html
import json
import re
from dataclasses import replace

import numpy as np
import pytest

from forficula.goals.kept_designs import designs_to_keep
from forficula.goals.optimise.optimum import candidates_to_keep
from forficula.show.page.goal_page import goal_page, shown_candidate
from forficula.show.page.identify_page import identify_page, unknowns_by_distance
from forficula.show.page.parts.bars import BarRow, bar, bar_table
from forficula.show.page.parts.rich_html import PrintedResult
from forficula.show.page.tolerance_page import ranked_keys, tolerance_page

NOTHING = PrintedResult(heading="", tables=(), sentences=())


@pytest.fixture(scope="module")
def optimised(goals):
    return goals["optimise"][0]


@pytest.fixture(scope="module")
def optimum_page(goals):
    return goals["optimise"][1].read_text("utf-8")


@pytest.fixture(scope="module")
def built(goals):
    return goals["tolerance"][0]


def data(page):
    return json.loads(re.search(r'<script type="application/json" id="data">(.*?)</script>', page, re.DOTALL)[1])


def cells(page, caption):
    """Return the texts of a table's rows, without notes."""
    result = re.search(rf"<caption>{caption}.*?<tbody>(.*?)</tbody>", page, re.DOTALL)[1]
    rows = [re.findall(r"<t[hd][^>]*>(.*?)</t[hd]>", row, re.DOTALL) for row in re.findall(r"<tr>(.*?)</tr>", result)]
    return [[html.unescape(re.sub(r"<small>.*?</small>|<[^>]+>", "", cell)) for cell in row] for row in rows]


def values(page, name):
    """Return a column of the script's data, by a factor's key or a quantity's name."""
    study = data(page)["study"]
    named = [item for item in study["factors"] if item["key"] == name]
    return np.array((named or [item for item in study["quantities"] if item["name"] == name])[0]["values"], dtype=float)


def test_every_design_that_was_tried_is_on_the_page_in_the_units_of_its_goal(optimised, optimum_page):
    table = optimised.table
    for name, factor in (("tendon.rest_length", 100), ("mass", 1e3), ("hinge_holding_torque", 100), ("margin", 100)):
        column = table[name.replace(".", "_")].values
        assert np.allclose(values(optimum_page, name), factor * column, rtol=1e-6)
    shown = data(optimum_page)
    assert shown["views"]["front"] == np.flatnonzero(table["front"].values).tolist()
    words = [shown["study"]["words"][number]["word"] for number in shown["study"]["verdicts"]]
    assert [word == "meets the goal" for word in words] == table["feasible"].values.tolist()


def test_each_limit_is_listed_with_the_value_and_margin_of_the_best_design(optimised, optimum_page):
    best = shown_candidate(optimised.subject)
    torque = float(optimised.table["hinge_holding_torque"].values[best])
    rows = {row[0]: row[2:] for row in cells(optimum_page, "Limits")}
    assert rows["hinge holding torque ≥ 5 N cm"][0] == f"{100 * torque:.4g} N cm"
    assert rows["hinge holding torque ≥ 5 N cm"][1] == f"+{100 * (torque - 0.05) / 0.05:.3g} %"
    assert rows["works in a run"][0] == "yes"
    share, low, high = (float(optimised.table[f"probability{end}"].values[best]) for end in ("", "_low", "_high"))
    assert rows["probability ≥ 90 %"][0] == f"{100 * share:.3g} % ({100 * low:.3g} to {100 * high:.3g})"


def test_the_best_that_is_shown_first_is_verified_and_has_the_largest_margin_of_these(optimised):
    table = optimised.table
    best = table["best"].values
    assert best[shown_candidate(optimised.subject)]
    assert table["margin"].values[shown_candidate(optimised.subject)] == table["margin"].values[best].max()


def test_runs_that_were_made_and_those_that_were_saved_are_counted(optimised, optimum_page):
    effort = optimised.subject.effort
    rows = dict(cells(optimum_page, "Number of runs"))
    assert rows["designs tried"] == str(effort.tried)
    assert rows["runs saved"] == str(effort.spared_runs + effort.spared_neighbours)


def test_without_a_feasible_design_the_page_lists_the_largest_margins(optimised):
    result = optimised.subject
    table = result.table.copy()
    for name in ("best", "front", "feasible"):
        table[name] = table[name].copy(data=np.zeros(table.sizes["candidate"], dtype=bool))
    from forficula.goals.optimise.trials import Relaxation

    provided = (Relaxation(limit=0, best=-0.2, alone=-0.3, unseen=float("nan"), trial=None),)
    page = goal_page(replace(result, best=(), table=table, relaxations=provided), NOTHING)
    assert "which comes nearest: none meets all" in page
    assert cells(page, "Largest margins")[0][2:] == ["−20 %", "−30 %"]
    assert data(page)["views"]["best_word"] == "nearest"


def test_runs_are_kept_of_the_best_first_and_of_what_failed_too(optimised):
    table = optimised.table
    kept = [run.point for run in candidates_to_keep(optimised.subject, 100)]
    best = np.flatnonzero(table["best"].values).tolist()
    assert kept[: len(best)] == best
    assert not table["feasible"].values[kept].all()
    assert sorted(set(kept)) == sorted(kept)
    assert [run.point for run in candidates_to_keep(optimised.subject, 1)] == best[:1]
    for run in candidates_to_keep(optimised.subject, 100):
        assert run.design == optimised.subject.candidates[run.point].screened.design


def test_designs_that_cannot_be_built_are_not_kept(optimised):
    designs = ["why not", optimised.subject.goal.base]
    assert [(run.point, run.name) for run in designs_to_keep(designs, [0, 1, 1])] == [(1, "2")]


def test_probabilities_have_intervals_and_the_most_sensitive_factor_is_first(goals, built):
    page = goals["tolerance"][1].read_text("utf-8")
    share = float(built.table["probability"].values[0])
    assert cells(page, "Probability")[0][2].startswith(f"{100 * share:.3g} % (")
    rows = cells(page, "Shares of the variance")
    assert [row[0] for row in rows] == ["tendon rest length", "tendon area", "the others"]
    assert rows[0][2:] == ["60 % (52 to 70)", "72 % (63 to 85)"]


def test_groups_are_ordered_by_sensitivity_and_the_remaining_factors_are_last(built):
    table = built.table.copy(deep=True)
    table["total_index"].values[0] = [0.2, 0.5, 0.9]
    assert ranked_keys(table) == ["tendon.area", "tendon.rest_length"]
    table["total_index"].values[:] = np.nan
    assert ranked_keys(table) == ["tendon.rest_length", "tendon.area"]
    design, deviations = built.subject
    page = tolerance_page(design, deviations, table, NOTHING)
    assert [len(row) for row in cells(page, "Shares of the variance")] == [3, 3, 3]


def test_the_nearest_failure_is_listed_in_both_directions(goals):
    rows = {row[0]: row[2:] for row in cells(goals["tolerance"][1].read_text("utf-8"), "Smallest deviation")}
    assert next(iter(rows)) == "tendon rest length"
    assert rows["tendon rest length"] == ["0.4", "beyond 3"]
    assert rows["tendon distal offset"] == ["1.6", "2.4"]


def test_the_design_itself_is_marked_in_the_cloud(goals, built):
    design, _ = built.subject
    nominal = {item["key"]: item["own"] for item in data(goals["tolerance"][1].read_text("utf-8"))["study"]["factors"]}
    assert nominal["tendon.rest_length"] == pytest.approx(100 * design.tendon.rest_length)


def test_facts_are_listed_with_their_shares_and_exclusive_pairs_are_marked(goals):
    tried, path = goals["identify"]
    page = path.read_text("utf-8")
    facts = cells(page, "Share of the drawn samples")
    assert [row[0] for row in facts] == ["1. it works", "2. stiff", "3. slack", "4. never"]
    pairs = cells(page, "Number of the")
    both = tried.table["met"].values.astype(int)
    assert [[int(re.sub(r"\D", "", cell)) for cell in row[1:]] for row in pairs] == (both.T @ both).tolist()
    assert [[cell.startswith("✕") for cell in row[1:]].count(True) for row in pairs] == [0, 1, 1, 0]


def test_unknowns_that_the_facts_narrow_most_come_first(goals):
    table = goals["identify"][0].table.copy(deep=True)
    names = list(table.attrs["unknowns"])
    for name in names:
        values = table[name].values
        table["agrees"].values[:] = values > np.median(values)
        assert unknowns_by_distance(table)[0] == name
    table["agrees"].values[:] = False
    assert unknowns_by_distance(table) == names
    assert data(identify_page(table, NOTHING))["views"]["marginals"] == [table[name].attrs["key"] for name in names]


def test_bars_end_where_their_values_lie_and_stay_within_their_scale():
    rows = [
        BarRow(name="half", lanes=((bar(0.5, "first", interval=(0.25, 2.0)),),), cells=("50 %",)),
        BarRow(name="missed", lanes=((bar(-3.0, "bad"),),), cells=("",)),
        BarRow(name="unknown", lanes=((bar(float("nan"), "good"),),), cells=("",)),
    ]
    made = bar_table("", ("", "share", ""), rows, (-1.0, 1.0))
    assert 'class="first" style="left:50.00%;width:25.00%"' in made
    assert 'class="cut" style="left:62.50%;width:37.50%"' in made
    assert 'class="bad" style="left:0.00%;width:50.00%"' in made
    assert "nan" not in made


def test_a_name_that_looks_like_a_script_stays_text(optimised, built):
    hostile = "</script><script>alert(1)</script>"
    goal = replace(optimised.subject.goal, name=hostile, source="<img src=x onerror=alert(1)>")
    design, deviations = built.subject
    for page in (
        goal_page(replace(optimised.subject, goal=goal), NOTHING),
        tolerance_page(design.model_copy(update={"name": hostile}), deviations, built.table, NOTHING),
    ):
        assert "<script>alert" not in page
        assert "<img" not in page
        assert data(page)["study"]["name"] == hostile
