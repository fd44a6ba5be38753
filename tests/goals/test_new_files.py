"""A goal or observations file to start from can be answered as it is, and what it has behind # is right, too."""

import pytest

from forficula.design.kinds import KINDS
from forficula.errors import InputError
from forficula.goals import load_goal
from forficula.goals.goal_file import write_new_goal
from forficula.goals.identify import load_observations
from forficula.goals.identify.observations_file import write_new_observations


@pytest.mark.parametrize("kind", KINDS)
def test_a_new_goal_of_every_kind_varies_one_value_for_one_objective(tmp_path, kind):
    write_new_goal(path := tmp_path / "new.toml", kind)
    goal = load_goal(path)
    assert len(goal.parameters) == len(goal.objectives) == 1


@pytest.mark.parametrize("kind", KINDS)
def test_new_observations_of_every_kind_have_one_unknown_and_one_fact(tmp_path, kind):
    write_new_observations(path := tmp_path / "new.toml", kind)
    seen = load_observations(path)
    assert len(seen.priors) == len(seen.facts) == 1
    assert (seen.samples, seen.directed, seen.seed) == (256, 128, 0)


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("believed", ["uniform", "log-uniform", "normal", "["])
def test_what_new_observations_have_behind_a_hash_can_be_taken(tmp_path, kind, believed):
    write_new_observations(path := tmp_path / "new.toml", kind)
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
    assert seen.source == "who saw it, and where"


@pytest.mark.parametrize("write", [write_new_goal, write_new_observations])
def test_a_new_file_is_not_written_over_another(tmp_path, write):
    write(path := tmp_path / "new.toml")
    with pytest.raises(InputError, match="exists already"):
        write(path)
    with pytest.raises(InputError, match=r'need "earwig-fan", .* got "wing"'):
        write(tmp_path / "other.toml", "wing")
