import json
import math
from dataclasses import replace

import numpy as np
import pytest

from forficula.design import load_design
from forficula.errors import InputError
from forficula.show.folder.landscape_folder import write_landscape
from forficula.study.running.runs import run

pytestmark = pytest.mark.usefixtures("undrawn")

FILES = ["design.toml", "figures", "landscape.json", "levels.png", "report.html", "tendon.png", "wing.png"]


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
    # t* = sqrt(I / (k a b)), k = 10 N/cm, a = b = 5.5 cm (docs/model/theory.md, section "Snap of a hinge")
    hinge = content["hinge"]
    assert hinge["time_scale_s"] == pytest.approx(math.sqrt(hinge["inertia_kg_m2"] / (1000 * 0.055**2)))
    assert content["simulation"]["status"] == "folded and opened"
    # the wing is damped and its membrane pulls, so it is slower than its hinge alone
    predicted = content["simulation"]["predicted"]["second_hinge"]
    assert predicted["folded_time_s"] < content["simulation"]["folded_time_s"] < 2 * predicted["folded_time_s"]
    assert content["simulation"]["peak_speed_rad_per_s"] < predicted["final_speed_rad_per_s"]


def test_the_folder_of_plates_has_equilibria_and_hinges_in_their_own_senses(surveyed, letter_run, tmp_path):
    landscape = surveyed("plates")
    write_landscape(landscape, tmp_path / "there", letter_run)
    assert sorted(path.name for path in (tmp_path / "there").iterdir()) == sorted({*FILES, "rests.png"} - {"wing.png"})
    content = read(tmp_path / "there")
    assert (content["hinge"], content["wing"], content["tips"]) == (None, None, None)
    assert [(item["tendon"], item["hinge"]) for item in content["tendons"]] == [
        ("left", "crease0"),
        ("right", "crease1"),
    ]
    for tendon in content["tendons"]:
        assert (max(tendon["angle_deg"]), min(tendon["angle_deg"])) == pytest.approx((175, -3))
        # energy of tendon and spring at rest of the whole structure
        stays = [state["angle_deg"] for state in tendon["stable_states"]]
        assert stays == pytest.approx([rest["angles_deg"][0] for rest in content["rests"][:2]], abs=1e-4)
        # d energy / d angle, with the opposite sign
        angle, energy = np.radians(tendon["angle_deg"]), np.array(tendon["energy_J"]) + tendon["spring_energy_J"]
        moment = np.array(tendon["moment_N_m"]) + tendon["spring_moment_N_m"]
        assert energy[-1] - energy[0] == pytest.approx(-np.trapezoid(moment, angle), rel=2e-3)
    for rest in content["rests"]:
        assert sum(rest["stored_J"].values()) == pytest.approx(rest["energy_J"])
    simulation = content["simulation"]
    assert (simulation["status"], simulation["tendon"], simulation["predicted"]) == ("closed and opened", "left", {})
    assert simulation["folded_angle_deg"] == pytest.approx(90)


def test_a_vein_without_a_tendon_has_no_landscape(surveyed, tmp_path):
    write_landscape(surveyed("own tendons"), tmp_path)
    content = read(tmp_path)
    assert [item["hinge"] for item in content["tendons"]] == ["fold0", "fold2"]
    # vein 2: half of 15 N/cm times the square of the stretch of 1.5 cm at straight, apart from the axis
    assert max(content["tendons"][1]["energy_J"]) < 1500 / 2 * 0.015**2
    assert len(content["partial_folds"][-1]["distal_angle_deg"]) == 3


def test_a_barrier_beside_straight_has_its_angle(surveyed, tmp_path):
    write_landscape(surveyed("off the bars"), tmp_path)
    hinge = read(tmp_path)["hinge"]
    # docs/model/theory.md, section "Tendon off the hinge axis": 4.30 mJ at -4.2 deg
    assert (1e3 * hinge["barrier_J"], hinge["barrier_angle_deg"]) == pytest.approx((4.30, -4.2), abs=0.05)


@pytest.mark.parametrize(
    "name", ["without rest length", "without hub", "without overbend", "slack", "without stiffness", "beyond the stop"]
)
def test_missing_values_are_null_and_explained_by_a_sentence(surveyed, tmp_path, name):
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


def test_all_files_of_a_landscape_are_written_or_none(surveyed, tmp_path, no_figures):  # noqa: ARG001
    landscape = surveyed("reference")
    blocked = tmp_path / "blocked"
    (blocked / "wing.png").mkdir(parents=True)
    with pytest.raises(InputError, match=r"wing\.png"):
        write_landscape(landscape, blocked)
    assert [path.name for path in blocked.iterdir()] == ["wing.png"]
    with pytest.raises(TypeError):  # fails after the file of the design is written
        write_landscape(replace(landscape, remarks=None), tmp_path / "broken")
    assert [path.name for path in tmp_path.iterdir()] == ["blocked"]
