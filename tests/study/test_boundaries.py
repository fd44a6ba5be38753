"""Boundaries between outcomes: planted in closed form, and in studies."""

from __future__ import annotations

import itertools
import json
import math

import numpy as np
import pytest

from forficula.errors import InputError
from forficula.study import collect, estimate, load_study, run_study, table_csv
from forficula.study.refine.boundary_plan import BoundaryPlan, LatticeAxis, read_plan
from forficula.study.refine.cells import locate
from forficula.study.refine.planes import labels_between
from forficula.study.refine.summary import boundary_map, boundary_sentences, largest_gap
from forficula.study.running.study_status import study_status
from tests.planted import folds_if, soft

REFINE = '[sampling]\nmethod = "refine"\n'
GRID = '"tendon.stiffness" = "10..60 N/cm step 10"\n"tendon.rest_length" = "0..9 cm step 1"'


def unit_axis(intervals, steps, name="x"):
    return LatticeAxis(dimension=name, grid=tuple(np.linspace(0, 1, intervals + 1)), steps=(steps,) * intervals)


def square(intervals=10, steps=10, axes=2, **others):
    return BoundaryPlan(axes=tuple(unit_axis(intervals, steps, name) for name in "xyz"[:axes]), **others)


def located(plan, label, margin=None):
    """Locate the boundaries of a label that is a function of the values; labels by position, and the cells."""
    labels, margins = {}, {}
    while (result := locate(plan, labels, margins)).wanted:
        for position in result.wanted:
            values = [axis.values[place] for axis, place in zip(plan.axes, position, strict=True)]
            labels[position] = label(*values)
            if margin is not None:
                margins[position] = (margin(*values),)
    assert all(cell.located for cell in result.cells)
    return labels, result.cells


def middles(plan, cells):
    """Values in the middle of every located position of a boundary."""
    crossings = {crossing for cell in cells for crossing in cell.crossings}
    places = np.array([crossing.middle for crossing in crossings])
    return np.array([axis.at(column) for axis, column in zip(plan.axes, places.T, strict=True)])


def predicted(cells):
    """The label that the cells predict at every position."""
    labels = {}
    for cell in cells:
        corners = list(itertools.product(*zip(cell.low, cell.high, strict=True)))
        for position in itertools.product(*map(range, cell.low, (place + 1 for place in cell.high))):
            if cell.surfaces:
                label = labels_between(cell.surfaces)[sum(surface.distance(position) > 0 for surface in cell.surfaces)]
            else:
                nearest = min(range(len(corners)), key=lambda index: math.dist(corners[index], position))
                label = cell.corners[nearest]
            labels.setdefault(position, label)
    return labels


def farthest_error(plan, label, cells):
    """The largest number of steps by which a predicted label is on the wrong side of the boundary."""
    at = [axis.values for axis in plan.axes]
    farthest = 0
    for position, predicted_label in predicted(cells).items():
        if label(*(values[place] for values, place in zip(at, position, strict=True))) == predicted_label:
            continue
        for steps in itertools.count(1):
            near = (
                tuple(place + shift * (index == axis) for index, place in enumerate(position))
                for axis in range(len(position))
                for shift in (-steps, steps)
            )
            inside = [p for p in near if all(0 <= place < len(v) for place, v in zip(p, at, strict=True))]
            if any(label(*(v[place] for v, place in zip(at, p, strict=True))) == predicted_label for p in inside):
                farthest = max(farthest, steps)
                break
    return farthest


def circle(x, y):
    return "inside" if math.hypot(x - 0.43, y - 0.52) < 0.31 else "outside"


def test_a_circle_is_located_to_half_a_width():
    plan = square()
    labels, cells = located(plan, circle)
    x, y = middles(plan, cells)
    assert np.abs(np.hypot(x - 0.43, y - 0.52) - 0.31).max() <= 0.005
    assert farthest_error(plan, circle, cells) == 1
    assert len(labels) < 0.04 * plan.full_grid


def test_points_grow_far_less_than_the_full_grid_as_the_width_shrinks():
    coarse, fine = (square(10, steps) for steps in (10, 64))
    counts = [len(located(plan, circle)[0]) for plan in (coarse, fine)]
    assert fine.full_grid > 40 * coarse.full_grid
    assert counts[1] < 2.5 * counts[0]


def test_continuous_margins_replace_halvings():
    plan = square(10, 64)
    plain, secant = (
        len(located(plan, circle, margin)[0]) for margin in (None, lambda x, y: 0.31 - math.hypot(x - 0.43, y - 0.52))
    )
    assert secant < 0.9 * plain


@pytest.mark.parametrize("jump", [(0.9, -1.0), (0.01, -1.0)])
def test_margins_that_jump_cost_at_most_twice_the_halvings(jump):
    plan = BoundaryPlan(axes=(unit_axis(1, 1024),), probes=0)
    labels, _ = located(plan, lambda x: str(x < 0.77), lambda x: jump[int(x >= 0.77)])
    assert len(labels) <= 2 + 2 * 10 + 1


def test_a_thin_island_that_a_probe_meets_is_outlined():
    def island(x, y):
        return "in" if ((x - 0.31) / 0.12) ** 2 + ((y - 0.45) / 0.01) ** 2 < 1 else "out"

    plan = square(10, 32)
    _, cells = located(plan, island)
    x, y = middles(plan, cells)
    assert np.ptp(x) == pytest.approx(0.24, abs=0.02)
    # no position on the outline is further than a step from the ellipse
    scale = np.hypot((x - 0.31) / 0.12, (y - 0.45) / 0.01)
    distance = np.minimum(np.abs(x - 0.31) * np.abs(1 - 1 / scale), np.abs(y - 0.45) * np.abs(1 - 1 / scale))
    assert distance.max() <= 1 / 320
    assert farthest_error(plan, island, cells) <= 1
    assert "in" not in located(square(10, 32, probes=0), island)[0].values()


def test_every_pair_of_outcomes_has_its_own_boundary():
    def lower(x):
        return 0.3 + 0.2 * math.sin(3 * x)

    def label(x, y):
        return "a" if y < lower(x) else "b" if y < 0.55 + 0.1 * x else "c"

    plan = square()
    _, cells = located(plan, label)
    crossings = {crossing for cell in cells for crossing in cell.crossings}
    assert {frozenset(crossing.labels) for crossing in crossings} == {frozenset("ab"), frozenset("bc")}
    for crossing in crossings:
        x, y = (axis.at(np.array([place]))[0] for axis, place in zip(plan.axes, crossing.middle, strict=True))
        true = lower(x) if "a" in crossing.labels else 0.55 + 0.1 * x
        if crossing.axis == 1:
            assert abs(y - true) <= 0.005 + 1e-9
    assert farthest_error(plan, label, cells) <= 1


def test_a_narrow_band_between_two_outcomes_needs_few_points():
    def band(_x, y):
        return "opened" if y < 0.52 else "still opening" if y < 0.57 else "did not open"

    plan = square(4, 64)
    labels, cells = located(plan, band)
    assert farthest_error(plan, band, cells) == 0
    # the initial grid, a probe in each cell, and for each of two boundaries six halvings on five edges and two tests
    assert len(labels) < 25 + 16 + 2 * (5 * 7 + 4 * 3)


def test_a_ball_over_three_factors_is_located_to_half_a_width():
    def ball(x, y, z):
        return "in" if math.dist((x, y, z), (0.43, 0.52, 0.4)) < 0.35 else "out"

    plan = square(4, 6, axes=3)
    labels, cells = located(plan, ball)
    for crossing in {crossing for cell in cells for crossing in cell.crossings}:
        high = tuple(place + (index == crossing.axis) for index, place in enumerate(crossing.low))
        ends = [[axis.values[at] for axis, at in zip(plan.axes, end, strict=True)] for end in (crossing.low, high)]
        assert crossing.labels == tuple(ball(*end) for end in ends)
    assert farthest_error(plan, ball, cells) <= 2
    assert len(labels) < 0.15 * plan.full_grid


def test_logarithmic_axes_have_equal_ratios():
    axis = LatticeAxis(dimension="x", grid=(1.0, 100.0), steps=(4,), logarithmic=True)
    assert axis.values == pytest.approx([1, 10**0.5, 10, 10**1.5, 100])
    assert axis.places(axis.values * 1.01) == [0, 1, 2, 3, 4]
    _, cells = located(BoundaryPlan(axes=(axis,), probes=0), lambda x: str(x < 5))
    assert middles(BoundaryPlan(axes=(axis,)), cells) == pytest.approx(10**0.75)


def test_the_largest_island_without_a_point_is_an_ellipse_between_points():
    plan = square(4, 10)
    corners = list(itertools.product(range(0, 41, 10), repeat=2))
    for extent in largest_gap(plan, corners):
        assert np.ptp(extent) == pytest.approx(0.25 * math.sqrt(2))
    probed = [*corners, *((5 + x, 5 + y) for x, y in itertools.product(range(0, 40, 10), repeat=2))]
    assert float(np.ptp(largest_gap(plan, probed)[0])) in (
        pytest.approx(0.25),
        pytest.approx(0.125),  # half of it is outside the ranges
    )


def test_the_same_points_follow_whatever_the_order_of_known_labels():
    plan = square()
    labels, _ = located(plan, circle)
    half = dict(list(labels.items())[:200])
    assert locate(plan, half).wanted == locate(plan, dict(reversed(half.items()))).wanted


def test_a_plan_is_read_as_it_was_written():
    plan = square(probes=3, boundary=("folded",))
    assert read_plan(plan.text()) == plan


# ---- studies with planted verdicts


@pytest.fixture
def planted(study_file):
    return load_study(study_file(GRID, tail=REFINE))


@pytest.fixture(scope="module")
def whole_table(tmp_path_factory, write_study_file):
    folder = tmp_path_factory.mktemp("planted")
    study = load_study(write_study_file(folder / "small.toml", GRID, "", REFINE))
    return run_study(study, folder / "out", cluster=folds_if(soft)[0]), folder / "out"


def test_a_study_has_one_row_for_every_point_that_refinement_placed(whole_table):
    table, _ = whole_table
    study = table.study
    assert table["outcome"].dims == ("sample",)
    assert table.attrs["point_runs"] == len(study.points) < 0.05 * study.boundaries.full_grid
    assert len(table_csv(study, table).splitlines()) == 1 + len(study.points)
    for crossing in {crossing for cell in boundary_map(table).located.cells for crossing in cell.crossings}:
        stiffness, length = (
            float(axis.at(np.array([place]))[0])
            for axis, place in zip(study.boundaries.axes, crossing.middle, strict=True)
        )
        if crossing.axis == 0:
            assert stiffness / 1e3 == pytest.approx(1.23 + 4.1 * length * 10, abs=0.051)


def test_conclusions_state_the_width_the_number_of_points_and_the_largest_island_missed(whole_table):
    table, _ = whole_table
    text = " ".join(boundary_sentences(table))
    assert f"{len(table.study.points)} points with {len(table.study.points)} runs" in text
    assert "4641 points of the full grid" in text
    assert "1 N/cm in tendon stiffness or 0.1 cm in tendon rest length" in text
    assert "did not fold | folded and opened" in text
    assert "The largest ellipse without a point extends 10 N/cm in tendon stiffness" in text


def test_an_interrupted_study_continues_with_the_same_points_and_rows(tmp_path, planted, whole_table):
    table, _ = whole_table
    rows, batches = folds_if(soft)

    def interrupted(designs, until_last):
        for count, row in enumerate(rows(designs, until_last)):
            if len(batches) == 3 and count == 2:
                raise KeyboardInterrupt
            yield row

    with pytest.raises(KeyboardInterrupt):
        run_study(planted, tmp_path, cluster=interrupted)
    done = len(rows_of(tmp_path))
    again, later = folds_if(soft)
    assert run_study(planted, tmp_path, cluster=again).identical(table)
    assert sum(later) == len(table.study.points) - done
    assert collect(planted, tmp_path).identical(table)


def rows_of(folder):
    lines = (json.loads(line) for line in (folder / "journal.jsonl").read_text().splitlines() if line)
    return {line["key"] for line in lines if "key" in line}


def test_refinement_reuses_the_rows_of_a_grid_and_a_grid_those_of_refinement(tmp_path, study_file, planted):
    rows, batches = folds_if(soft)
    run_study(load_study(study_file(GRID)), tmp_path, cluster=rows)
    table = run_study(planted, tmp_path, cluster=rows)
    assert sum(batches) == len(table.study.points)
    fine = '"tendon.stiffness" = "10..60 N/cm step 1"\n"tendon.rest_length" = "0..9 cm step 0.1"'
    batches.clear()
    full = run_study(load_study(study_file(fine)), tmp_path, cluster=rows)
    assert sum(batches) == planted.boundaries.full_grid - len(table.study.points)
    regions = predicted(boundary_map(table).located.cells)
    words = full["outcome"].values
    wrong = [position for position, word in regions.items() if words[position] != word]
    # next to the boundary the label of a position without a point is not certain
    for position in wrong:
        beside = words[max(position[0] - 1, 0) : position[0] + 2, max(position[1] - 1, 0) : position[1] + 2]
        assert regions[position] in beside
    assert len(wrong) < 0.02 * len(regions)


def test_a_boundary_may_be_that_of_a_state_or_a_verdict(tmp_path, study_file):
    rows, _ = folds_if(soft)
    expected = {
        '["folded", "opened"]': {"folded, opened", "not folded, not opened"},
        '"verdict"': {"reached", "stuck"},
    }
    for boundary, words in expected.items():
        study = load_study(study_file(GRID, tail=f"{REFINE}boundary = {boundary}"))
        assert set(boundary_map(run_study(study, tmp_path, cluster=rows)).words) == words


def test_refinement_stops_at_the_largest_number_of_points_and_says_so(tmp_path, study_file):
    study = load_study(study_file(GRID, tail=f"{REFINE}most_points = 80"))
    table = run_study(study, tmp_path, cluster=folds_if(soft)[0])
    assert len(table.study.points) == 80
    assert "Refinement stopped at 80 points (sampling.most_points)" in " ".join(boundary_sentences(table))


def test_refinement_that_stops_before_the_points_inside_cells_says_so(tmp_path, study_file):
    study = load_study(study_file(GRID, tail=f"{REFINE}most_points = 60"))
    table = run_study(study, tmp_path, cluster=folds_if(lambda *_: True)[0])
    text = " ".join(boundary_sentences(table))
    assert "Refinement stopped at 60 points (sampling.most_points). Some cells of the initial grid lack" in text


def test_two_results_without_a_located_boundary_are_not_called_the_same(tmp_path, study_file):
    tail = f"{REFINE}most_points = 2\nprobes = 0"
    study = load_study(study_file('"tendon.stiffness" = ["1 N/cm", "600 N/cm"]', tail=tail))
    text = " ".join(boundary_sentences(run_study(study, tmp_path, cluster=folds_if(soft)[0])))
    assert "No boundary is located between the results of the points" in text
    assert "the same result" not in text


def test_a_grid_that_ran_in_shards_runs_again_as_a_whole(tmp_path, study_file, planted):
    run_study(load_study(study_file(GRID)), tmp_path, shard=(1, 3), cluster=folds_if(soft)[0])
    status = study_status(planted, tmp_path)
    assert (len(status.shards), status.points_done, status.points) == (1, 20, 60)
    assert (status.shards[0].state.value, status.run_again) == ("missing", "1")


def test_the_status_counts_the_points_of_all_rounds(tmp_path, study_file, planted):
    rows, _ = folds_if(soft)
    run_study(load_study(study_file(GRID)), tmp_path, cluster=rows)
    status = study_status(planted, tmp_path)
    assert (status.complete, status.points_done, status.points) == (False, 60, 118)
    assert "no process has started the points that follow" in status.shards[0].why
    with pytest.raises(InputError, match="58 runs are missing; run the study without --collect"):
        collect(planted, tmp_path)
    count = len(run_study(planted, tmp_path, cluster=rows).study.points)
    status = study_status(planted, tmp_path)
    assert (status.complete, status.points_done, status.points) == (True, count, count)


def test_without_a_boundary_only_the_grid_and_probes_run(tmp_path, planted):
    table = run_study(planted, tmp_path, cluster=folds_if(lambda *_: True)[0])
    assert len(table.study.points) == 60 + 45
    assert "No boundary was found" in " ".join(boundary_sentences(table))


def test_an_estimate_counts_the_initial_grid(tmp_path, planted):
    run_study(planted, tmp_path, cluster=folds_if(soft)[0])
    assert estimate(planted, tmp_path) == (60, 0, 0.0)


def test_shards_of_a_study_of_boundaries_are_refused_with_the_remedy(tmp_path, planted):
    with pytest.raises(InputError, match=r"shard: .* depend on the results of earlier points.*without \[sampling\]"):
        run_study(planted, tmp_path, shard=(1, 2))


@pytest.mark.parametrize(
    ("factors", "tail", "message"),
    [
        (GRID, "count = 5", 'sampling.count: needs method = "random" or "sobol", got "refine"'),
        (GRID, 'width = { "tendon.stiffness" = "1 cm" }', "sampling.width.tendon.stiffness: "),
        (GRID, 'width = { "tendon.stiffness" = "0 N/cm" }', "sampling.width.tendon.stiffness: need > 0"),
        (GRID, 'width = { "vein.diameter" = "1 mm" }', "sampling.width: need a key under [factors]"),
        (GRID, 'width = { "tendon.stiffness" = "1e-9 N/cm" }', "need at most 100000 values"),
        (GRID, 'width = { "tendon.stiffness" = "1e-322 N/cm" }', "tendon.stiffness, got more than 1000000000"),
        (
            GRID,
            f'logarithmic = ["tendon.stiffness"]\nwidth = {{ "tendon.stiffness" = "0.{16 * "0"}1 %" }}',
            "sampling.width.tendon.stiffness: need at most 100000 values",
        ),
        (GRID, "divisions = 50000", "sampling.divisions: need at most 100000 values of tendon.stiffness, got 250001"),
        (GRID, 'logarithmic = ["tendon.rest_length"]', "sampling.logarithmic: needs values > 0"),
        (
            GRID,
            'boundary = "gripped"',
            'need "outcome", "verdict" or a list of states (folded, opened)',
        ),
        (GRID, 'boundary = ["gripped"]', 'or a list of states (folded, opened), got "gripped"'),
        (GRID, "boundary = []", "got an empty list"),
        (GRID, "most_points = 59", "sampling.most_points: need at least the 60 points of the initial grid"),
        (GRID, "probes = -1", "sampling.probes"),
        (GRID, 'logarithmic = ["tendon.stiffness"]\nwidth = { "tendon.stiffness" = "1 N/cm" }', "need a percentage"),
        ('"tendon.stiffness" = ["10 N/cm"]', "", "need at least two rising values"),
        ('"tendon.stiffness" = ["20 N/cm", "10 N/cm"]', "", "need at least two rising values"),
        ('"tendon.law" = ["none", "tpu-82a"]', "", "factors.tendon.law: need numbers"),
        ('"pattern.units" = [1, 2, 3]', "", "pattern.units needs steps between whole numbers"),
        (
            '"tendon.stiffness" = { distribution = "uniform", low = "10 N/cm", high = "20 N/cm" }',
            "",
            "need a list or a range, whose values are the initial grid",
        ),
    ],
)
def test_wrong_use_is_refused_with_the_key_and_what_is_allowed(study_file, factors, tail, message):
    with pytest.raises(InputError) as error:
        load_study(study_file(factors, tail=f"{REFINE}{tail}"))
    assert message in str(error.value)


def test_other_methods_refuse_the_keys_of_refinement(study_file):
    drawn = '"tendon.stiffness" = { distribution = "uniform", low = "10 N/cm", high = "20 N/cm" }'
    with pytest.raises(InputError, match=r'sampling\.probes: needs method = "refine", got "sobol"'):
        load_study(study_file(drawn, tail="[sampling]\ncount = 4\nprobes = 2"))
    with pytest.raises(InputError, match=r"sampling.count: is missing"):
        load_study(study_file(drawn, tail='[sampling]\nmethod = "random"'))
    with pytest.raises(InputError, match='vary: need "grid" for method = "refine"'):
        load_study(study_file(GRID, 'vary = "one-at-a-time"', REFINE))


def test_whole_numbers_may_be_refined_in_whole_steps(study_file):
    study = load_study(study_file('"pattern.units" = [1, 5]', tail=f'{REFINE}width = {{ "pattern.units" = 1 }}'))
    assert study.boundaries.axes[0].values.tolist() == [1, 2, 3, 4, 5]


def test_the_named_study_refines_the_papers_grid_ten_times():
    study = load_study("binder2025-boundary")
    assert [len(study.points), study.boundaries.full_grid] == [60, 51 * 91]
    assert list(study.points) == list(load_study("binder2025-search").points)
