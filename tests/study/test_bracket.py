"""Searches that take smaller torques to fail where a larger one stays short of its goal."""

import functools
import itertools
import math
from dataclasses import replace

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import forficula as ff
from forficula.design import with_values
from forficula.errors import InputError
from forficula.structure import structure_of
from forficula.study import load_study, run_study
from forficula.study import search as search_module
from forficula.study.files.search_file import read_search
from forficula.study.running.evaluate import evaluate
from forficula.study.running.run_study import Trials
from forficula.study.search import is_checked, search_designs, search_result
from tests.study.test_search import DESIGN, GRID, answer, answers

BRACKET = replace(GRID, scan="bracket")
VALUES = (0.0, 0.1, 0.2, 0.3)


def planted_row(design, folds, opens, bounces, undecided):
    """The row of a planted run, with whether the run met its goal at no time."""
    torque, opening = design.protocol.fold_torque, design.protocol.unfold_torque
    unfolds = torque == GRID.reference
    tried = opening if unfolds else torque
    if unfolds and tried in undecided:
        row = answer("unreliable: the energy balance misses 12 %")
    elif not unfolds and torque < 0.15 and not folds(torque):
        row = answer("did not fold")
    else:
        row = answers(design, folds, opens)
    short = row["verdict"] == "stuck" and not (unfolds and tried in bounces)
    return {**row, "short_of_goal": short}


def search_with(search, folds, opens, bounces=(), undecided=()):
    """Do the missing runs in order, except those that earlier results make needless; return result and runs."""
    rows, run = {}, []
    while missing := {key: item for key, item in search_designs(DESIGN, search, rows).items() if key not in rows}:
        left, trials = dict(missing), Trials(structure_of(DESIGN), missing)
        while left:
            key = next(iter(left))
            design = left.pop(key)
            rows[key] = {"key": key, **planted_row(design, folds, opens, bounces, undecided)}
            run.append(design)
            for needless in trials.needless(rows[key]):
                left.pop(needless, None)
    return search_result(DESIGN, search, rows), run


@pytest.fixture
def unchecked(monkeypatch):
    monkeypatch.setattr(search_module, "is_checked", lambda _: False)


@pytest.fixture
def checked(monkeypatch):
    monkeypatch.setattr(search_module, "is_checked", lambda _: True)


def above(least):
    return lambda torque: torque >= least


def without(result):
    return {name: value for name, value in result.items() if name not in ("monotony", "tried")}


@pytest.mark.usefixtures("unchecked")
@pytest.mark.parametrize("refinements", [0, 2])
@pytest.mark.parametrize(("fold", "unfold"), list(itertools.product((*VALUES, 1.0), (0.1, 0.2, 0.3, 1.0))))
def test_a_bracket_gives_the_same_result_as_a_full_scan(fold, unfold, refinements):
    full, every = search_with(replace(GRID, refinements=refinements), above(fold), above(unfold))
    result, run = search_with(replace(BRACKET, refinements=refinements), above(fold), above(unfold))
    assert without(result) == without(full)
    assert {design.hash for design in run} <= {design.hash for design in every} or unfold == 0.1
    assert len(run) <= len(every) + 1


@pytest.mark.usefixtures("unchecked")
@settings(max_examples=60, deadline=None)
@given(
    st.sampled_from((*VALUES, 1.0)),
    st.sampled_from((0.1, 0.2, 0.3, 1.0)),
    st.sets(st.sampled_from((0.1, 0.2, 0.3))),
    st.sets(st.sampled_from((0.1, 0.2, 0.3))),
)
def test_bounces_and_unreliable_runs_above_the_failures_do_not_change_the_result(fold, unfold, bounces, undecided):
    def monotone(values):
        # a bounce or an unreliable run below a torque that stays short of its goal would contradict the assumption
        short = [value for value in (0.1, 0.2, 0.3) if value < unfold and value not in (*bounces, *undecided)]
        return {value for value in values if not short or value > max(short)}

    planted = above(fold), above(unfold), monotone(bounces), monotone(undecided)
    if planted[2] != bounces or planted[3] != undecided:
        return
    full, result = search_with(GRID, *planted)[0], search_with(BRACKET, *planted)[0]
    assert without(result) == without(full)


@pytest.mark.usefixtures("unchecked")
def test_one_run_shows_that_no_torque_opens_the_wing():
    result, run = search_with(BRACKET, above(0.2), lambda _: False)
    assert [design.protocol.fold_torque for design in run] == [0.3, 0.2, 0.1, 0.2, GRID.reference]
    assert run[-1].protocol.unfold_torque == 0.3
    assert result["least_unfold_torque"] is None
    assert result["monotony"] == "assumed"
    # torques that did not run have the outcome of the larger one
    assert result["outcomes_tried"][0.0] == "did not fold"
    assert 0.0 not in result["times_tried"]


@pytest.mark.usefixtures("unchecked")
def test_a_wing_that_rebounds_from_its_goal_says_nothing_about_smaller_torques():
    result, run = search_with(BRACKET, above(0.0), lambda torque: torque == 0.1, bounces=(0.2, 0.3))
    assert result["least_unfold_torque"] == 0.1
    assert sum(design.protocol.fold_torque == GRID.reference for design in run) == 3
    assert result["monotony"] == "checked"


@pytest.mark.usefixtures("unchecked")
def test_a_success_below_a_torque_that_stays_short_is_reported_and_all_torques_are_tried():
    result, run = search_with(
        replace(BRACKET, second=replace(GRID.second, values=(0.1, 0.2, 0.3, 0.4, 0.5, 0.6))),
        above(0.0),
        lambda torque: torque in (0.2, 0.6),
        bounces=(0.5,),
    )
    # 0.3 N m stays short, and 0.4 N m too, so that 0.6 N m is the answer of a bracket without a check
    assert (result["least_unfold_torque"], result["monotony"]) == (0.6, "assumed")
    assert len([design for design in run if design.protocol.fold_torque == GRID.reference]) < 6


@pytest.mark.usefixtures("unchecked")
def test_torques_above_one_whose_result_is_unknown_are_not_needed():
    search = replace(BRACKET, second=replace(GRID.second, values=(0.1, 0.2, 0.3, 0.4, 0.5, 0.6)))
    rows = {}

    def add_rows(unfold_torques):
        for key, run in search_designs(DESIGN, search, rows).items():
            if run.protocol.fold_torque != GRID.reference or run.protocol.unfold_torque in unfold_torques:
                rows[key] = {"key": key, **planted_row(run, above(0.0), above(0.3), (), (0.3,))}

    add_rows(())
    add_rows((0.2, 0.3))
    assert search_designs(DESIGN, search, rows).keys() == rows.keys()
    result = search_result(DESIGN, search, rows)
    assert (result["least_unfold_torque"], result["verdict"]) == (None, "untrusted")
    # 0.5 N m might stay short of its goal and contradict the assumption, so that the assumption is not checked
    assert result["monotony"] == "unknown"


@pytest.mark.usefixtures("checked")
def test_a_checked_point_finds_a_success_below_a_torque_that_stays_short():
    result, _ = search_with(BRACKET, above(0.0), lambda torque: torque == 0.2)
    assert (result["least_unfold_torque"], result["monotony"]) == (0.2, "violated")
    full, _ = search_with(GRID, above(0.0), lambda torque: torque == 0.2)
    assert without(result) == without(full)


@pytest.mark.usefixtures("checked")
@pytest.mark.parametrize(("fold", "unfold"), [(0.2, 0.2), (0.0, 1.0), (1.0, 1.0)])
def test_a_checked_point_has_the_result_of_a_full_scan(fold, unfold):
    full, _ = search_with(GRID, above(fold), above(unfold))
    result, _ = search_with(BRACKET, above(fold), above(unfold))
    assert without(result) == without(full)
    assert result["monotony"] == "checked"


def test_one_point_in_twenty_is_checked():
    designs = [with_values(DESIGN, {"tendon.stiffness": f"{1 + 0.01 * number} N/cm"}) for number in range(400)]
    assert sum(map(is_checked, designs)) == pytest.approx(20, abs=12)


def test_other_values_than_torques_are_all_tried():
    table = {"key": "tendon.stiffness", "values": ["1 N/cm", "2 N/cm"]}
    assert read_search("least-value", table, DESIGN).scan == "full"
    with pytest.raises(InputError, match=r'search.scan: needs ask = "least-torques"'):
        read_search("least-value", table | {"scan": "bracket"}, DESIGN)
    assert read_search("least-torques", {}, DESIGN).scan == "bracket"
    assert read_search("least-torques", {"scan": "full"}, DESIGN).scan == "full"


FALLING = ("50 N cm", "30 N cm", "20 N cm", "0 N cm")
FOLDING = with_values(
    ff.load_design("binder2025"), {"tendon.rest_length": "5 cm", "protocol.stages": DESIGN.protocol.stages[:2]}
)


@functools.cache
def rows_of(torques):
    designs = [with_values(FOLDING, {"protocol.fold_torque": torque}) for torque in torques]
    return list(evaluate(designs, until_last=True))


def test_falling_torques_run_until_one_stays_short_of_its_goal():
    assert [(row["folded"], row["short_of_goal"]) for row in rows_of(FALLING)] == [
        (True, False),
        (True, False),
        (True, False),
        (False, True),
    ]
    # rising torques of a transition that is not the last one all run
    assert rows_of(FALLING[-2:]) == rows_of(FALLING)[-2:]
    rising = {row["key"]: row for row in rows_of((*FALLING[::-1], "60 N cm"))}
    assert len(rising) == 5
    assert all(rising[row["key"]] == row for row in rows_of(FALLING))


def test_a_run_that_meets_its_goal_for_a_moment_does_not_count_as_short_of_it():
    stages = [stage.model_dump() for stage in DESIGN.protocol.stages[:2]]
    stages[1] |= {"hold": 1.0, "time_limit": 0.1}
    (row,) = evaluate([with_values(FOLDING, {"protocol.stages": stages})])
    assert (row["verdict"], row["short_of_goal"]) == ("moving", False)


STUDY = """
design = "binder2025"
ask = "least-torques"
[settings]
"protocol.timestep" = "0.2 ms"
"protocol.rest_speed" = "10 deg/s"
[factors]
"tendon.rest_length" = ["5 cm", "9 cm"]
[search]
fold_torques = ["0 N cm", "20 N cm", "50 N cm"]
fold_with = "50 N cm"
unfold_torques = ["30 N cm", "40 N cm", "60 N cm"]
"""


@pytest.mark.usefixtures("unchecked")
def test_the_table_of_a_bracket_equals_that_of_a_full_scan(tmp_path):
    tables, runs = {}, {}
    for scan in ("bracket", "full"):
        path = tmp_path / f"{scan}.toml"
        path.write_text(f'{STUDY}scan = "{scan}"\n', "utf-8")
        tables[scan] = run_study(load_study(path), tmp_path / scan)
        runs[scan] = tables[scan].attrs["runs"]
    assert "assumed" in tables["bracket"]["monotony"].values
    bracket, full = tables["bracket"].drop_vars(["monotony", "fold_tried_by_torque"]), tables["full"]
    assert bracket.equals(full)
    assert runs["bracket"] <= runs["full"]
    assert math.isnan(full["least_unfold_torque"].values[0]) != math.isnan(full["least_unfold_torque"].values[1])
