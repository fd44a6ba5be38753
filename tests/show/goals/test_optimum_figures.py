"""Figures of a search: its limits are drawn, and the front where designs meet the goal."""

import numpy as np
import pytest

from forficula.goals.goal_file import goal_of
from forficula.goals.optimise import optimise_goal
from forficula.show.goals.optimum_figures import draw_candidates, draw_front
from forficula.show.style import COLUMN_WIDTH, PAGE_WIDTH, description
from tests.show.legible import check_words

# both torques have closed forms, so nothing is simulated
GOAL = {
    "name": "joint",
    "design": "binder2025-joint",
    "simulate": False,
    "settings": {"tendon.stiffness": "4 N/cm"},
    "vary": {
        "tendon.stiffness": {"low": "1 N/cm", "high": "20 N/cm"},
        "tendon.rest_length": {"low": "40 mm", "high": "80 mm"},
    },
    "limits": {"hinge_opening_torque": "<= 30 N cm", "hinge_holding_torque": ">= 2 N cm"},
    "objectives": {"hinge_holding_torque": "largest", "hinge_opening_torque": "least"},
    "search": {"runs": 32, "batch": 16},
}


@pytest.fixture(scope="module")
def optimum(tmp_path_factory):
    return optimise_goal(goal_of(GOAL), tmp_path_factory.mktemp("search"))


def legend(figure):
    return [text.get_text() for text in figure.legends[0].get_texts()]


def test_the_part_of_an_axis_beyond_its_limit_is_shaded_and_the_limit_is_named(optimum):
    figure = draw_candidates(optimum)
    (axes,) = figure.axes
    names = {
        label.get_text().replace("\n", " "): place
        for label, place in zip(axes.get_xticklabels(), axes.get_xticks(), strict=True)
    }
    opening = optimum.table["hinge_opening_torque"].values * 100  # N cm
    low, high = min(opening.min(), 30), max(opening.max(), 30)
    (above,) = [patch for patch in axes.patches if patch.get_y() > 0]
    assert above.get_y() == pytest.approx((30 - low) / (high - low))
    assert above.get_y() + above.get_height() == pytest.approx(1)
    assert above.get_x() + above.get_width() / 2 == names["hinge opening torque ≤ 30 N cm"]
    (below,) = [patch for patch in axes.patches if patch.get_y() == 0]
    assert below.get_x() + below.get_width() / 2 == names["hinge holding torque ≥ 2 N cm"]
    assert "beyond a limit" in legend(figure)
    assert "Limits: hinge opening torque ≤ 30 N cm; hinge holding torque ≥ 2 N cm." in description(figure)


def test_the_front_is_drawn_where_designs_meet_the_goal(optimum):
    figure = draw_front(optimum)
    (axes,) = figure.axes
    holding, opening = (100 * optimum.table[f"hinge_{name}_torque"].values for name in ("holding", "opening"))
    good = optimum.table["feasible"].values.astype(bool)
    (left, right), (low, high) = axes.get_xlim(), axes.get_ylim()
    assert np.all((left < holding[good]) & (holding[good] < right) & (low < opening[good]) & (opening[good] < high))
    # one bad design requires many times the limit
    assert opening.max() > 2 * high
    drawn = next(line for line in axes.lines if str(line.get_label()).startswith("other designs"))
    beyond = (~good).sum() - len(drawn.get_xdata())
    assert f"other designs ({beyond} beyond the axes)" in legend(figure)
    # shaded above the largest opening torque, and left of the least holding torque
    edges = {round(float(patch.get_extents().transformed(axes.transData.inverted()).bounds[number]), 6)
             for patch in axes.patches for number in (0, 1)}  # fmt: skip
    assert 30 in edges
    assert any(round(patch.get_x() + patch.get_width(), 6) == 2 for patch in axes.patches)


@pytest.mark.parametrize("draw", [draw_candidates, draw_front])
@pytest.mark.parametrize("width", [COLUMN_WIDTH, PAGE_WIDTH])
def test_all_words_can_be_read(optimum, draw, width):
    check_words(draw(optimum, width), width)
