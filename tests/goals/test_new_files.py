"""New goal and observations files can be run unchanged, and their commented lines are valid."""

import pytest

from forficula.design.files.kinds import KINDS
from forficula.errors import InputError
from forficula.goals import load_goal
from forficula.goals.goal_file import GOAL
from forficula.goals.identify import load_observations
from forficula.goals.identify.observations_file import OBSERVATIONS
from forficula.study.new_file import write_new_file


@pytest.mark.parametrize("kind", KINDS)
def test_a_new_goal_of_every_kind_varies_one_value_for_one_objective(tmp_path, kind):
    write_new_file(path := tmp_path / "new.toml", GOAL, kind)
    goal = load_goal(path)
    assert len(goal.parameters) == len(goal.objectives) == 1


@pytest.mark.parametrize("kind", KINDS)
def test_new_observations_of_every_kind_have_one_unknown_and_one_fact(tmp_path, kind):
    write_new_file(path := tmp_path / "new.toml", OBSERVATIONS, kind)
    seen = load_observations(path)
    assert len(seen.priors) == len(seen.facts) == 1
    assert (seen.samples, seen.directed, seen.seed) == (256, 128, 0)


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("believed", ["uniform", "log-uniform", "normal", "["])
def test_commented_lines_of_new_observations_are_valid(tmp_path, kind, believed):
    write_new_file(path := tmp_path / "new.toml", OBSERVATIONS, kind)
    lines, inside = [], ""
    for line in path.read_text("utf-8").splitlines():
        inside = line.removeprefix("# ") if line.removeprefix("# ").startswith("[") else inside
        bare = line.removeprefix("# ")
        if inside == "[unknown]" and " = " in bare:
            lines.append(bare if f'"{believed}"' in bare or f" = {believed}" in bare else f"# {bare}")
        else:
            lines.append(bare if " = " in bare or bare == "[[fact]]" else line)
    path.write_text("\n".join(lines), "utf-8")
    seen = load_observations(path)
    assert len(seen.facts) == 3
    assert seen.source == ""


@pytest.mark.parametrize("file", [GOAL, OBSERVATIONS])
def test_a_new_file_does_not_overwrite_another(tmp_path, file):
    write_new_file(path := tmp_path / "new.toml", file)
    with pytest.raises(InputError, match="exists already"):
        write_new_file(path, file)
    with pytest.raises(InputError, match=r'need "earwig-fan", .* got "wing"'):
        write_new_file(tmp_path / "other.toml", file, "wing")
