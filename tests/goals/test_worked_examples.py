"""Named goals start within their ranges, and closed forms agree with their requirements."""

import numpy as np
import pytest

from forficula.design import key_value
from forficula.goals.deviation import deviating_values
from forficula.goals.goal_file import load_goal, named_goals
from forficula.goals.optimise.candidate import neighbour_offsets
from forficula.goals.static_values import static_values
from tests.validation.test_snap_forces_of_a_clasp_and_a_miura_cell import cell_forces, clasp_forces, snaps

EXAMPLES = ("clasp-5-to-8", "light-wing", "servo-wing", "two-heights")
RATIOS = {"fan-ratio-10": 10, "fan-ratio-15": 15, "fan-ratio-18": 18}


def neighbours(goal, design, count=64):
    """Designs within a goal's tolerances of a design."""
    offsets = neighbour_offsets(goal, count, seed=1)
    return [design.with_values(deviating_values(design, goal.deviations, offset.tolist())) for offset in offsets]


def test_the_examples_are_named():
    assert {*EXAMPLES, *RATIOS} <= set(named_goals())


@pytest.mark.parametrize(("name", "ratio"), RATIOS.items())
def test_a_folding_ratio_is_a_goal_of_geometry_alone(name, ratio):
    goal = load_goal(name)
    assert goal.sources == ("sheet",)
    assert [(limit.quantity.name, limit.bound) for limit in goal.limits] == [("folding_ratio", ratio)]
    assert str(goal.limits[0]) == f"folding_ratio >= {ratio} times"
    for parameter in goal.parameters:
        assert 0 <= parameter.share(key_value(goal.base, parameter.key)) <= 1, parameter.key


def test_every_two_panels_of_a_fan_fold_to_a_part_of_less_than_four_layers():
    """The least numbers of units in which a fan with bars of 1 mm reaches the ratios, found by `forficula optimise`."""
    base = load_goal("fan-ratio-10").base
    sizes = {}
    for units, sector, hub in ((4, 14, 2), (5, 15, 7), (6, 12, 2), (7, 10, 3), (8, 13, 2)):
        values = {"pattern.units": units, "pattern.sector_angle": f"{sector} deg", "pattern.hub_radius": f"{hub} mm"}
        sizes[units] = static_values(base.with_values(values), ["sheet"])
        assert sizes[units]["folded_height"] == pytest.approx(4 * units * 0.001)
        assert sizes[units]["folding_ratio"] < 4 * units
    ratios = {units: size["folding_ratio"] for units, size in sizes.items()}
    assert ratios[4] < 10 < ratios[5] < ratios[6] < 15 < ratios[7] < 18 < ratios[8]


@pytest.mark.parametrize("name", EXAMPLES)
def test_an_example_starts_within_its_ranges_and_requires_a_probability(name):
    goal = load_goal(name)
    for parameter in goal.parameters:
        assert 0 <= parameter.share(key_value(goal.base, parameter.key)) <= 1, parameter.key
    assert [limit.bound for limit in goal.limits if limit.quantity.source == "neighbours"] == pytest.approx([0.95])
    assert goal.deviations
    assert goal.source


def test_the_torque_speed_line_of_the_servo_is_in_every_tried_design():
    goal = load_goal("servo-wing")
    assert np.degrees(goal.base.protocol.no_load_speed) == pytest.approx(300)
    assert goal.base.protocol.fold_torque == goal.base.protocol.unfold_torque == pytest.approx(0.3)


def test_clasp_of_the_example_holds_and_opens_within_its_tolerances_by_closed_form():
    goal = load_goal("clasp-5-to-8")
    forces = [snaps(-clasp_forces(neighbour)[1])[1] for neighbour in neighbours(goal, goal.base)]
    assert min(forces) < 6.0 < 7.5 < max(forces)
    assert np.mean([5 <= force <= 8 for force in forces]) > 0.9


def test_cell_of_the_example_holds_and_snaps_within_its_tolerances_by_closed_form():
    goal = load_goal("two-heights")
    up, down = np.transpose([snaps(cell_forces(neighbour)[1]) for neighbour in neighbours(goal, goal.base)])
    assert np.all((up > 1) & (up < 3))
    assert np.mean((down > 5) & (down < 15)) > 0.9
