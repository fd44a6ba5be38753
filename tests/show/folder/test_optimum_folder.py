"""Files of an optimisation: all are written, or earlier ones are kept."""

import pytest

import forficula as ff
from forficula.design import load_design
from forficula.errors import InputError
from forficula.goals.goal_file import goal_of
from forficula.goals.optimise import optimise_goal
from forficula.show.folder import optimum_folder
from forficula.show.folder.presentation import write_figure

GOAL = {
    "name": "light",
    "design": load_design("binder2025-joint"),
    "simulate": False,
    "vary": {"tendon.rest_length": ["5 cm", "6 cm"]},
    "objectives": {"mass": "least"},
}


def test_a_full_disk_keeps_earlier_files_and_outdated_best_designs_are_removed(tmp_path, monkeypatch):
    optimum_folder.write_optimum(optimise_goal(goal_of(GOAL), tmp_path), tmp_path)
    before = {name: (tmp_path / name).read_text("utf-8") for name in ("best.toml", "optimum.json", "table.csv")}
    none = optimise_goal(goal_of({**GOAL, "limits": {"mass": "<= 1 mg"}}), tmp_path)

    def full(_path, _content):
        raise InputError("table.nc: cannot be written: No space left on device")

    with monkeypatch.context() as patch:
        patch.setattr(optimum_folder, "write_bytes", full)
        with pytest.raises(InputError, match="No space left"):
            optimum_folder.write_optimum(none, tmp_path)
    assert {name: (tmp_path / name).read_text("utf-8") for name in before} == before
    optimum_folder.write_optimum(none, tmp_path)
    assert not (tmp_path / "best.toml").exists()
    assert "mass <= 0.001 g" in (tmp_path / "optimum.json").read_text("utf-8")


def test_a_search_is_saved_drawn_and_its_figures_handed_out(tmp_path):
    result = ff.optimise(GOAL, tmp_path / "runs")
    ff.save(result, tmp_path / "there")
    names = {path.name for path in (tmp_path / "there").iterdir()}
    assert {"best.toml", "optimum.json", "table.csv", "table.nc", "candidates.png", "report.html"} <= names
    assert ff.load_design(str(tmp_path / "there" / "best.toml")).hash == result.designs[0].hash
    assert ff.figure(result, "candidates").get_figwidth() == pytest.approx(3.5, rel=0.1)
    write_figure(tmp_path / "there", "candidates", tmp_path / "again.svg")
    kept = tmp_path / "there" / "figures" / "candidates.svg"
    assert (tmp_path / "again.svg").read_bytes() == kept.read_bytes()
    with pytest.raises(InputError, match="--kind: need one of candidates for"):
        write_figure(tmp_path / "there", "candidate", tmp_path / "again.svg")
    with pytest.raises(InputError, match="figures of a search are not drawn again; they are in its folder figures"):
        ff.figure(tmp_path / "there")
