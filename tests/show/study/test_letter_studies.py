"""Studies of plates, by searches and by runs, with two transitions, one, or none: table, figures and page."""

import json
import re

import numpy as np
import pytest
from matplotlib.backends.backend_agg import FigureCanvasAgg

from forficula.design import design_text, load_design, with_values
from forficula.show.folder.study_folder import study_drawings, write_study
from forficula.show.page.study_page import study_page, study_sentence
from forficula.show.study.study_table import print_study
from forficula.show.style import COLUMN_WIDTH, PAGE_WIDTH, description
from forficula.study import load_study, run_study

# every figure is drawn by `check` and not written
pytestmark = pytest.mark.usefixtures("undrawn")

STIFFNESS = '"crease.stiffness" = ["1e-2 N m/rad/m", "0.2 N m/rad/m"]'
DRIVE = '"drive.close.value" = ["1 N cm", "6 N cm"]'
TENDON = '"tendon.left.stiffness" = ["0.2 N/cm", "1 N/cm"]'
CLOSE = 'close_torques = ["1 N cm", "6 N cm"]'
STIFF = '[search]\nkey = "crease.stiffness"\nvalues = ["1e-2 N m/rad/m", "0.2 N m/rad/m"]'
CHOICES = f'vary = "one-at-a-time"\n[factors]\n"crease.damping" = ["2e-2 N m s/rad/m"]\n{TENDON}\n'


@pytest.fixture(scope="module")
def studied(tmp_path_factory):
    """Return a study of the letter fold, with its stages up to one, and its table."""
    place = tmp_path_factory.mktemp("letter")

    def study(stages: int, rest: str):
        letter = load_design("letter-fold")
        kept = letter.protocol.stages[:stages]
        stages_kept = [stage.model_dump() for stage in kept]
        # Creases that hardly damp, so that the letter comes to where its torques take it within the time of a stage.
        design = with_values(letter, {"protocol.stages": stages_kept, "crease.damping": 5e-3})
        folder = place / f"{len(list(place.iterdir()))}"
        folder.mkdir()
        (folder / "design.toml").write_text(design_text(design), "utf-8")
        settings = '"protocol.timestep" = "1 ms"\n"stops.time_constant" = "4 ms"'
        text = f'name = "letter"\ndesign = "design.toml"\n{rest}\n[settings]\n{settings}\n'
        (folder / "study.toml").write_text(text, "utf-8")
        result = load_study(str(folder / "study.toml"))
        return result, run_study(result, folder / "out")

    return study


def check(study, table, tmp_path, kinds, sentence, *, engine=False):
    """Draw all figures at the smallest width, and make a page and a summary."""
    drawings = study_drawings(table)
    assert set(drawings) == kinds
    for drawing in drawings.values():
        figure = drawing(COLUMN_WIDTH)
        FigureCanvasAgg(figure).draw()
        assert not re.search("wing| fold", description(figure))
    write_study(study, table, tmp_path / "written")
    print_study(study, table)
    # followed by the number of repeated runs
    assert study_sentence(study, table).partition(f". {table.attrs['runs_repeated']} of ")[0].rstrip(
        "."
    ) == sentence.rstrip(".")
    page = study_page(study, table, (), 0, engine=engine)
    return json.loads(re.search(r'<script type="application/json" id="data">(.*?)</script>', page, re.DOTALL)[1])


def words(data):
    return {item["word"]: item["sign"] for item in data["study"]["words"]}


def test_a_search_finds_torques_that_close_and_open_a_letter(studied, tmp_path):
    search = f'[search]\n{CLOSE}\nopen_torques = ["1 N cm", "3 N cm"]'
    study, table = studied(5, f'ask = "least-torques"\n[factors]\n{STIFFNESS}\n{TENDON}\n{search}')
    kinds = {"status", "torques", "works", "energy", "fold_times"}
    sentence = "4 points: 4 get closed, with 1 N cm to 6 N cm (2 did not stay closed); 1 get opened again, with 3 N cm."
    data = check(study, table, tmp_path, kinds, sentence, engine=True)
    assert table["least_close_value"].values.tolist() == [[0.01, 0.01], [0.06, 0.06]]
    assert table["least_close_value"].attrs["long_name"] == "least torque with which the structure gets closed"
    np.testing.assert_array_equal(table["least_open_value"].values, [[0.03, np.nan], [np.nan, np.nan]])
    came = {"closed and opened": "●", "did not get opened": "■", "did not stay closed": "↺", "did not get closed": "×"}
    assert words(data) == came | {"did not get closed with 3 N cm": "⊗"}


def test_opening_may_be_left_out_and_closing_is_found_all_the_same(studied, tmp_path):
    search = f"[search]\n{CLOSE}\nopen_torques = []"
    study, table = studied(5, f'ask = "least-torques"\n[factors]\n{STIFFNESS}\n{search}')
    kinds = {"status", "torques", "works", "energy", "fold_times"}
    check(study, table, tmp_path, kinds, "2 points: 2 get closed, with 1 N cm to 6 N cm (1 did not stay closed).")


def test_one_transition_is_searched_for_with_all_of_its_protocol(studied, tmp_path):
    study, table = studied(3, f'ask = "least-torques"\n[factors]\n{STIFFNESS}\n{TENDON}\n[search]\n{CLOSE}')
    kinds = {"status", "torques", "works", "energy", "fold_times"}
    data = check(study, table, tmp_path, kinds, "4 points: 2 get closed, with 1 N cm.")
    assert words(data)["closed"] == "●"
    assert table["outcome"].values.tolist() == [["closed"] * 2, ["did not stay closed"] * 2]


def test_a_least_value_of_any_unit_has_its_figures_and_page(studied, tmp_path):
    study, table = studied(3, f'ask = "least-value"\n[factors]\n{DRIVE}\n{STIFF}')
    kinds = {"status", "torques", "works", "energy", "fold_times"}
    data = check(study, table, tmp_path, kinds, "2 points: 2 get closed, with 0.01 N m/rad/m.")
    result = next(item for item in data["study"]["quantities"] if item["name"] == "least_stiffness")
    assert (result["unit"], result["values"]) == ("N m/rad/m", [0.01, 0.01])


def test_a_least_value_of_a_later_transition_is_reported_for_that_transition(studied, tmp_path):
    search = '[search]\nkey = "drive.open.value"\nvalues = ["-0.2 N cm", "-3 N cm"]\nstate = "opened"'
    study, table = studied(5, f'ask = "least-value"\n[factors]\n{STIFFNESS}\n{search}')
    kinds = {"status", "torques", "works", "energy", "fold_times"}
    check(study, table, tmp_path, kinds, "2 points: 1 get opened, with -3 N cm.")
    assert table["outcome"].values.tolist() == ["closed and opened", "did not get closed"]


def test_a_letter_that_did_not_stay_closed_was_not_opened_by_its_drive(studied, tmp_path):
    study, table = studied(5, f'ask = "run"\n[factors]\n{STIFFNESS}\n{DRIVE}')
    sentence = "4 points: 2 get closed, 2 get closed and get opened again."
    check(study, table, tmp_path, {"status", "works", "energy"}, sentence)
    assert table["opened"].values.tolist() == table["closed"].values.tolist() == [[True, True], [False, False]]


def test_single_letters_of_a_search_have_their_numbers(studied, tmp_path):
    study, table = studied(5, f'ask = "least-torques"\n{CHOICES}[search]\n{CLOSE}')
    sentence = "4 points: 4 get closed, with 1 N cm; 3 get opened again, with 2.7 N cm to 3 N cm."
    check(study, table, tmp_path, {"choices"}, sentence)
    figure = study_drawings(table)["choices"](PAGE_WIDTH)
    opens = figure.axes[1]
    assert opens.get_xlabel() == "least open value (N cm)"
    low, high = opens.get_xlim()
    # as wide as the values
    assert 2 < low < 2.7 < 3 < high < 3.5


def test_a_protocol_that_drives_nothing_has_its_figures(studied, tmp_path):
    study, table = studied(1, f'ask = "run"\n[factors]\n{STIFFNESS}\n{TENDON}')
    assert words(check(study, table, tmp_path, {"status", "energy"}, "4 points.")) == {"settled": "●"}
    study, table = studied(1, f'ask = "run"\n{CHOICES}[grid]\n{STIFFNESS}')
    check(study, table, tmp_path, {"choices", "status", "energy"}, "8 points.")
    assert study_drawings(table)["choices"](PAGE_WIDTH).axes[0].get_xlabel() == "structures that settle, of 2"
    study, table = studied(1, f'ask = "run"\n{CHOICES}')
    check(study, table, tmp_path, {"choices"}, "4 points.")
    axes = study_drawings(table)["choices"](PAGE_WIDTH).axes
    assert [axis.get_xlabel() for axis in axes] == ["tendons' energy when flat (J)"]
