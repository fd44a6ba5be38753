"""Goal files: content and errors."""

import pytest

from forficula.design.files.key_table import key_facts
from forficula.errors import InputError
from forficula.goals.goal_file import GoalFile, goal_of, load_goal, named_goals
from forficula.goals.identify import load_observations
from forficula.study import load_study

TABLES = {
    "name": "a-goal",
    "design": "binder2025",
    "vary": {"tendon": {"stiffness": {"low": "4 N/cm", "high": "30 N/cm"}}},
    "limits": {
        "least_fold_torque": "<= 20 N cm",
        "holding_torque": [">= 1 N cm", "<= 9 N cm"],
        "vein.diameter": "<= 6 mm",
    },
    "objectives": {"mass": "least"},
    "tolerances": {"all": "10 %"},
}


@pytest.mark.parametrize("name", named_goals())
def test_named_goals_can_be_read(name):
    goal = load_goal(name)
    assert goal.source
    assert goal.parameters
    assert goal.objectives


def test_an_upper_limit_on_a_least_torque_is_the_torque_of_the_run():
    goal = goal_of(TABLES)
    assert goal.base.protocol.fold_torque == pytest.approx(0.2)
    assert [str(limit) for limit in goal.torque_limits] == ["least_fold_torque <= 20 N cm"]
    assert [str(limit) for limit in goal.limits] == [
        "holding_torque >= 1 N cm", "holding_torque <= 9 N cm", "vein.diameter <= 6 mm",
    ]  # fmt: skip
    assert goal.sources == ("design", "parts", "fold", "run")
    assert goal.search is None
    assert goal.values([0.5]) == {"tendon.stiffness": "17 N/cm"}


def test_a_least_torque_that_is_to_be_small_is_searched_for():
    goal = goal_of(TABLES | {"objectives": {"least_unfold_torque": "least"}, "search": {"refinements": 1, "runs": 8}})
    assert goal.search is not None
    assert goal.search.refinements == 1
    assert goal.runs == 8


def test_files_may_name_designs_beside_them(tmp_path):
    (tmp_path / "mine.toml").write_text('based_on = "binder2025-joint"\nname = "mine"\n')
    (tmp_path / "goal.toml").write_text(
        'design = "mine.toml"\n[vary]\n"tendon.area" = "4..6 mm^2 step 1 mm^2"\n[objectives]\nmass = "least"\n'
    )
    goal = load_goal(tmp_path / "goal.toml")
    assert (goal.name, goal.base.name) == ("goal", "mine")
    assert not goal.deviations


@pytest.mark.parametrize(
    ("change", "says"),
    [
        ({"limit": {}}, "limit: unknown key, got {}; did you mean limits?"),
        ({"limits": {"holding_torqe": ">= 5 N cm"}}, 'did you mean "holding_torque"'),
        ({"limits": {"holding_torque": "5 N cm"}}, "limits.holding_torque: need a limit such as"),
        ({"limits": {"probability": ">= 95 %"}, "tolerances": {}}, "probability: needs tolerances"),
        ({"objectives": {}}, "objectives: need one to three quantities"),
        ({"objectives": {"mass": "smallest"}}, 'objectives.mass: need "least" or "largest"'),
        (
            {"objectives": {"fold_time": "least"}, "simulate": False, "limits": {}},
            "fold_time: is known by running",
        ),
        ({"vary": {}}, "vary: need at least one key"),
        ({"vary": {"tendon.stifness": ["4 N/cm"]}}, "did you mean tendon.stiffness"),
        ({"vary": {"tendon.stiffness": {"low": "4 N/cm"}}}, "vary.tendon.stiffness.high: is missing"),
        ({"vary": {"tendon.stiffness": {}}}, "vary.tendon.stiffness.low: is missing; give it"),
        ({"limits": {"mass": {}}}, "limits.mass: need a limit such as"),
        ({"objectives": {"mass": {}}}, 'objectives.mass: need "least" or "largest"'),
        ({"tolerances": {"tendon.stiffness": {}}}, "tolerances.tendon.stiffness.size: is missing"),
        ({"settings": {"tendon.stifness": "4 N/cm"}}, "settings.tendon.stifness: unknown key"),
        ({"settings": {"tendon": {"stiffness": "4"}}}, "settings.tendon.stiffness: the unit is missing"),
        ({"settings": 3}, "settings: need a table, got 3"),
        ({"tolerances": {"tendon.stiffness": "200 %"}}, "tolerances.tendon.stiffness: need a tolerance"),
        ({"search": {"runs": 10**12}}, "search.runs: need a whole number >= 1 and <= 1000000, got 1000000000000"),
        ({"search": {"fold_torques": ["1 N cm"]}}, "search.fold_torques: unknown key"),
        ({"design": "binder"}, "binder"),
        ({"simulate": "no"}, "simulate: need true or false"),
        ({"name": "a/b"}, "name: need a name"),
    ],
)
def test_errors_in_a_goal_file_name_the_key(change, says):
    with pytest.raises(InputError) as error:
        goal_of(TABLES | change)
    assert says in str(error.value)
    assert "\n" not in str(error.value)


def test_every_key_of_a_goal_file_is_listed():
    assert {fact.key.split(".")[0] for fact in key_facts("", GoalFile)} >= {
        *TABLES,
        "search",
        "settings",
        "simulate",
        "source",
    }
    with pytest.raises(InputError, match=r"did you mean limits\?"):
        key_facts("limit", GoalFile)


LETTER = {
    "name": "a-letter",
    "design": "letter-fold",
    "vary": {"tendon.left.stiffness": ["0.4 N/cm", "0.5 N/cm"]},
    "objectives": {"mass": "least"},
}


@pytest.mark.parametrize(
    ("change", "says"),
    [
        (
            {"vary": {"tendon.0.stiffness": ["0.4 N/cm"], "tendon.left.stiffness": ["0.5 N/cm"]}},
            "vary.tendon.left.stiffness: is given twice, also as tendon.0.stiffness",
        ),
        (
            {"tolerances": {"tendon.0.stiffness": "5 %", "tendon.left.stiffness": "9 %"}},
            "tolerances.tendon.left.stiffness: is given twice, also as tendon.0.stiffness",
        ),
        (
            {"settings": {"tendon.0.stiffness": "0.4 N/cm", "tendon.left.stiffness": "0.5 N/cm"}},
            "tendon.left.stiffness: is given twice, also as tendon.0.stiffness",
        ),
        ({"limits": {"close_time": []}}, "limits.close_time: need at least one limit, got an empty list"),
        (
            {"limits": {"close_time": [">= 1 s", "<= 0.5 s"]}},
            "limits.close_time: nothing is both >= 1 s and <= 0.5 s",
        ),
        (
            {"limits": {"probability": ">= 120 %"}, "tolerances": {"all": "5 %"}},
            "limits.probability: need a share from 0 % to 100 %, got 120 %",
        ),
        (
            {"limits": {"probability": [">= 50 %", "<= 99 %"]}, "tolerances": {"all": "5 %"}},
            "limits.probability: need a lower limit",
        ),
        ({"limits": {"least_close_value": "<= -2 N cm"}}, "limits.least_close_value: need > 0"),
        (
            {"limits": {"least_close_value": "<= 2 N cm"}, "simulate": False},
            "least_close_value: is known by running a design",
        ),
        (
            {"limits": {"least_close_value": "<= 2 N cm"}, "vary": {"drive.0.value": ["1 N cm", "9 N cm"]}},
            "vary.drive.0.value: is what least_close_value is about",
        ),
        (
            {"tolerances": {"tendon.left.stiffness": {"distribution": "normal"}}},
            "tolerances.tendon.left.stiffness.size: is missing",
        ),
        (
            {"tolerances": {"tendon.left.law": {"intervals_of": "tpu95a"}}},
            "tolerances.tendon.left.law.intervals_of: ",
        ),
        ({"tolerances": {"tendon.left.area": "5 %"}}, "tolerances.tendon.left.area: has no value in letter-fold"),
    ],
)
def test_entries_without_full_effect_are_rejected(change, says):
    with pytest.raises(InputError) as error:
        goal_of(LETTER | change)
    assert says in str(error.value)
    assert "\n" not in str(error.value)


@pytest.mark.parametrize("limits", [["<= 2 N cm", "<= 1 N cm"], ["<= 1 N cm", "<= 2 N cm"]])
def test_of_several_limits_on_a_least_torque_the_strictest_counts(limits):
    goal = goal_of(LETTER | {"limits": {"least_close_value": limits}})
    assert goal.base.drive[0].value == pytest.approx(0.01)


def test_one_tolerance_overrides_all_under_either_name():
    tolerances = {"all": "10 %", "tendon.0.stiffness": "5 %", "tendon.1.stiffness": "none"}
    sizes = {deviation.key: deviation.size for deviation in goal_of(LETTER | {"tolerances": tolerances}).deviations}
    assert sizes["tendon.left.stiffness"] == 0.05
    assert "tendon.0.stiffness" not in sizes
    assert "tendon.right.stiffness" not in sizes


@pytest.mark.parametrize(
    ("read", "text", "says"),
    [
        (
            load_goal,
            "[[fact]]",
            "need a goal, got an observations file, because it has fact; give it to forficula ident",
        ),
        (load_goal, "[factors]", "need a goal, got a study, because it has factors; give it to forficula study"),
        (
            load_observations,
            "[objectives]",
            "need an observations file, got a goal, because it has objectives; give it to",
        ),
        (
            load_study,
            "[[fact]]",
            "need a study, got an observations file, because it has fact; give it to forficula ident",
        ),
    ],
)
def test_a_file_of_another_kind_is_rejected_with_its_command(tmp_path, read, text, says):
    (tmp_path / "some.toml").write_text(f'design = "letter-fold"\n{text}\n', "utf-8")
    with pytest.raises(InputError) as error:
        read(tmp_path / "some.toml")
    assert f"some.toml: {says}" in str(error.value)
