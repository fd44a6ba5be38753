import json
import math
from dataclasses import replace

import pytest

from forficula.design import load_design
from forficula.errors import InputError
from forficula.show.folder.landscape_folder import write_landscape
from forficula.study.runs import run

FILES = ["design.toml", "figures", "landscape.json", "levels.png", "tendon.png", "wing.png"]


def read(folder):
    def refuse(word):
        raise AssertionError(f"{word} is not JSON")

    return json.loads((folder / "landscape.json").read_text("utf-8"), parse_constant=refuse)


def test_a_landscape_leaves_its_files_and_the_design_gives_the_same_again(surveyed, reference, reference_run, tmp_path):
    write_landscape(surveyed("reference"), tmp_path / "there", reference_run)
    assert sorted(path.name for path in (tmp_path / "there").iterdir()) == FILES
    assert load_design(tmp_path / "there" / "design.toml").hash == reference.hash
    content = read(tmp_path / "there")
    assert content["design_hash"] == reference.hash
    # theory.md, section 3: t* = sqrt(I / (k a b)), k = 10 N/cm, a = b = 5.5 cm
    hinge = content["hinge"]
    assert hinge["time_scale_s"] == pytest.approx(math.sqrt(hinge["inertia_kg_m2"] / (1000 * 0.055**2)))
    assert content["simulation"]["status"] == "folded and opened"
    # the wing is damped, and its membrane pulls: it is slower than its hinge alone
    predicted = content["simulation"]["predicted"]["second_hinge"]
    assert predicted["folded_time_s"] < content["simulation"]["folded_time_s"] < 2 * predicted["folded_time_s"]
    assert content["simulation"]["peak_speed_rad_per_s"] < predicted["final_speed_rad_per_s"]


@pytest.mark.parametrize(
    "name", ["without rest length", "without hub", "without overbend", "slack", "without stiffness"]
)
def test_what_does_not_exist_is_null_and_said_in_a_sentence(surveyed, tmp_path, name):
    write_landscape(surveyed(name), tmp_path)
    content = read(tmp_path)
    assert content["simulation"] is None
    missing = [hinge["barrier_J"] is None for hinge in (content["hinge"], *content["tendons"])]
    assert not any(missing) or content["hinge"]["remarks"][0] in content["remarks"]
    assert all(remark.strip() and "nan" not in remark.split() for remark in content["remarks"])


def test_a_simulation_that_diverged_is_named_and_the_rest_is_written(surveyed, tmp_path):
    wild = run(load_design("binder2025", {"protocol.timestep": "5 ms"}))
    write_landscape(surveyed("reference"), tmp_path, wild)
    simulation = read(tmp_path)["simulation"]
    assert simulation["status"].startswith("diverged")
    assert simulation["folded_time_s"] is None
    assert (tmp_path / "tendon.png").exists()


def test_a_landscape_leaves_all_files_or_none(surveyed, tmp_path):
    landscape = surveyed("reference")
    blocked = tmp_path / "blocked"
    (blocked / "wing.png").mkdir(parents=True)
    with pytest.raises(InputError, match=r"wing\.png"):
        write_landscape(landscape, blocked)
    assert [path.name for path in blocked.iterdir()] == ["wing.png"]
    with pytest.raises(IndexError):  # a landscape that cannot be drawn, halfway through the files
        write_landscape(replace(landscape, ideal_hinges=()), tmp_path / "broken")
    assert [path.name for path in tmp_path.iterdir()] == ["blocked"]
