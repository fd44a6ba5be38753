"""Studies that vary their factors one at a time, around the base, alone or with a grid at each choice."""

import csv
import io
import re

import numpy as np
import pytest
import xarray as xr

import forficula as ff
from forficula.design import with_values
from forficula.errors import InputError
from forficula.show import print_study, write_study
from forficula.study import collect, estimate, load_study, run_study, table_csv
from forficula.study.assumptions.choice_groups import choice_groups, count_all, count_first
from forficula.study.running.journal import read_rows
from forficula.study.running.kept_runs import runs_to_keep
from forficula.study.study_designs import point_design

ALONE = 'vary = "one-at-a-time"'
# the second equals the value of binder2025, written differently
DAMPING = '"hinge.damping" = ["1e-4 N m s/rad", "0.001 N m s/rad", "1e-2 N m s/rad"]'
UNITS = '"pattern.units" = [1, 2, 30]'  # the last value gives no valid wing
TENDONS = '[grid]\n"tendon.stiffness" = ["10 N/cm", "60 N/cm"]\n"tendon.rest_length" = ["5 cm", "9 cm"]'
ONLY_FOLDING = '[search]\nfold_torques = ["10 N cm", "50 N cm"]\nunfold_torques = []'


@pytest.fixture(scope="module")
def alone(tmp_path_factory, write_study_file):
    """A study of single wings and its table."""
    folder = tmp_path_factory.mktemp("alone")
    study = load_study(write_study_file(folder / "alone.toml", f"{DAMPING}\n{UNITS}", ALONE))
    return study, run_study(study, folder / "out")


@pytest.fixture(scope="module")
def gridded(tmp_path_factory, write_study_file):
    """A search for folding torques over tendons at each choice, its table and its folder."""
    folder = tmp_path_factory.mktemp("gridded")
    head, tail = f'{ALONE}\nask = "least-torques"', f"{TENDONS}\n{ONLY_FOLDING}"
    study = load_study(write_study_file(folder / "gridded.toml", DAMPING, head, tail))
    return study, run_study(study, folder / "out"), folder / "out"


def lines(text):
    return list(csv.DictReader(io.StringIO(text)))


def test_every_value_is_one_choice_and_the_base_occurs_once(alone):
    study, _ = alone
    assert study.points == (
        {},
        {"hinge.damping": "1e-4 N m s/rad"},
        {"hinge.damping": "1e-2 N m s/rad"},
        {"pattern.units": 2},
        {"pattern.units": 30},
    )
    assert point_design(study.base, study.points[0]).hash == study.base.hash


def test_a_grid_is_repeated_whole_at_every_choice(gridded):
    study, _, _ = gridded
    tendons = [(stiffness, length) for stiffness in ("10 N/cm", "60 N/cm") for length in ("5 cm", "9 cm")]
    dampings = [None, "1e-4 N m s/rad", "1e-2 N m s/rad"]
    assert [
        (point.get("hinge.damping"), point["tendon.stiffness"], point["tendon.rest_length"]) for point in study.points
    ] == [(damping, *tendon) for damping in dampings for tendon in tendons]


def test_factors_are_a_grid_by_default(study_file):
    rows = f"{DAMPING}\n{UNITS}"
    plain, named = (load_study(study_file(rows, head)) for head in ("", 'vary = "grid"'))
    assert len(plain.points) == 9
    assert named.points == plain.points
    assert plain.choices == ()


def test_a_choice_gives_the_same_run_as_a_design_with_this_value(alone):
    study, table = alone
    for place, values in enumerate(study.points[:4]):
        outcome = ff.measure(ff.run(with_values(study.base, dict(values)), confirm=False))
        assert table["status"].values[place] == outcome.status
        # an unreliable run has no numbers
        work = outcome.transitions["fold"].work if outcome.verdict.conclusive else np.nan
        assert np.array_equal(table["fold_work"].values[place], work, equal_nan=True)
    assert np.isfinite(table["fold_work"].values[:4]).sum() > 1


def test_a_value_with_which_no_wing_can_be_built_has_a_row(alone):
    _, table = alone
    assert str(table["status"].values[4]).startswith("cannot be built: ")


def test_the_table_has_the_values_of_every_factor_at_every_choice_in_si(alone, tmp_path):
    study, table = alone
    assert table["status"].dims == ("choice",)
    assert table["choice"].values.tolist() == [
        "binder2025",
        "hinge.damping = 1e-4 N m s/rad",
        "hinge.damping = 1e-2 N m s/rad",
        "pattern.units = 2",
        "pattern.units = 30",
    ]
    assert table["hinge_damping"].values.tolist() == [1e-3, 1e-4, 1e-2, 1e-3, 1e-3]
    assert table["pattern_units"].values.tolist() == [1, 1, 1, 2, 30]
    assert table["hinge_damping"].attrs["units"] == "N m s/rad"
    rows = lines(table_csv(study, table))
    assert [float(row["hinge_damping_N_m_s_per_rad"]) for row in rows] == [1e-3, 1e-4, 1e-2, 1e-3, 1e-3]
    assert [row["pattern_units"] for row in rows] == ["1", "1", "1", "2", "30"]
    (tmp_path / "table.nc").write_bytes(table.to_netcdf(engine="h5netcdf"))
    with xr.open_dataset(tmp_path / "table.nc", engine="h5netcdf") as again:
        assert again.load().identical(table)


def test_the_table_of_a_grid_at_each_choice_has_both_as_dimensions(gridded):
    study, table, _ = gridded
    assert table["status"].dims == ("choice", "tendon_stiffness", "tendon_rest_length")
    rows = lines(table_csv(study, table))
    for place, row in enumerate(rows):
        point = table.isel(dict(zip(table["status"].dims, np.unravel_index(place, table["status"].shape), strict=True)))
        for name, unit in (("hinge_damping", "N_m_s_per_rad"), ("tendon_stiffness", "N_per_m"), ("flat_energy", "J")):
            assert float(row[f"{name}_{unit}"]) == float(point[name])


def test_shards_of_choices_are_collected_and_nothing_is_left_to_do(tmp_path, alone):
    study, table = alone
    assert estimate(study, tmp_path)[:2] == (5, 4)  # the invalid wing needs no run
    assert run_study(study, tmp_path, shard=(1, 2)) is None
    run_study(study, tmp_path, shard=(2, 2))
    assert collect(study, tmp_path).identical(table)
    assert estimate(study, tmp_path)[:2] == (5, 0)


def test_choices_of_a_factor_are_grouped_by_size_with_the_base(alone, gridded):
    _, table = alone
    groups = {group.factor: group.places for group in choice_groups(table)}
    assert groups == {"hinge_damping": (1, 0, 2), "pattern_units": (0, 3, 4)}
    assert [group.places for group in choice_groups(gridded[1])] == [(1, 0, 2)]


def test_folded_and_opened_points_are_counted_at_every_choice(alone, gridded):
    _, table = alone
    assert count_first(table).tolist() == table["folded"].values.astype(int).tolist()
    assert count_all(table).tolist() == table["opened"].values.astype(int).tolist()
    _, table, _ = gridded
    by_hand = [sum(np.isfinite(table["least_fold_torque"].values[place].ravel())) for place in range(3)]
    assert count_first(table).tolist() == by_hand
    assert len(set(by_hand)) > 1
    assert count_all(table) is None


@pytest.mark.usefixtures("undrawn")
def test_a_search_without_unfold_torques_only_folds_and_releases(gridded, tmp_path, capsys):
    study, table, folder = gridded
    # three dampings, four tendons, two torques, and a release for each that folds
    folds = int(np.isfinite(table["least_fold_torque"]).sum())
    assert len(read_rows(folder, study.base)) == 24 + folds
    assert not {name for name in table if "unfold" in name or "opened" in name or "reference" in name}
    assert "least_unfold_torque_N_m" not in table_csv(study, table)
    assert {run.part for run in runs_to_keep(study, table)} == {"folding"}
    write_study(study, table, tmp_path)
    assert {path.stem for path in tmp_path.glob("*.png")} == {
        "choices",
        "energy",
        "fold_times",
        "status",
        "torques",
        "works",
    }
    print_study(study, table)
    output = capsys.readouterr().out
    assert "open" not in output
    for count, words in zip(count_first(table)[[1, 0, 2]], ("0.0001", "0.001", "0.01"), strict=True):
        assert re.search(rf"^hinge damping {words} N m s/rad(, as in binder2025)? +{count} *$", output, re.MULTILINE)


def test_folding_results_do_not_depend_on_the_search_for_opening(gridded, write_study_file, tmp_path):
    _, table, _ = gridded
    grid = TENDONS.removeprefix("[grid]\n")
    search = ONLY_FOLDING.replace("[]", '["90 N cm"]')
    study = load_study(write_study_file(tmp_path / "both.toml", grid, 'ask = "least-torques"', search))
    both = run_study(study, tmp_path / "out")
    for name in ("least_fold_torque", "fold_work", "folded_energy"):
        assert np.array_equal(both[name].values, table[name].values[0], equal_nan=True)
    assert np.array_equal(both["fold_outcome"].values, table["outcome"].values[0])


def test_a_base_value_that_is_a_word_is_distinguished_from_numbers(tmp_path):
    path = tmp_path / "steps.toml"
    path.write_text(
        f'design = "binder2025"\n{ALONE}\nsettings.protocol.timestep = "auto"\n'
        'settings.protocol.stages.0.time_limit = "10 ms"\nsettings.protocol.stages.1.time_limit = "20 ms"\n'
        '[factors]\n"protocol.timestep" = ["0.4 ms", "0.2 ms"]\n'
        '"tendon.area" = ["12.5 mm^2"]\n"tendon.law" = ["tpu-82a"]'
    )
    study = load_study(path)
    # without a law there is no area, and without an area no law
    table = run_study(study, tmp_path / "out", batch=2)
    assert table["protocol_timestep"].values.tolist() == ["auto", "0.4 ms", "0.2 ms", "auto", "auto"]
    assert table["tendon_law"].values.tolist() == ["none", "none", "none", "none", "tpu-82a"]
    nan = np.nan
    assert table["tendon_area"].values == pytest.approx([nan, nan, nan, 12.5e-6, nan], nan_ok=True)
    assert [str(status).startswith("cannot be built") for status in table["status"].values] == [False] * 3 + [True] * 2
    assert [group.places for group in choice_groups(table)] == [(0, 1, 2), (0, 3), (0, 4)]


@pytest.mark.parametrize(
    ("head", "tail", "message"),
    [
        ('vary = "one at a time"', "", 'vary: need "grid", "one-at-a-time" or "pairs", got "one at a time"'),
        ("vary = 3", "", 'vary: need "grid", "one-at-a-time" or "pairs", got 3'),
        ("", TENDONS, 'grid: needs vary = "one-at-a-time"; otherwise all factors are a grid, under [factors]'),
        (ALONE, "[grid]", 'grid: need a table with at least one, such as "tendon.stiffness" = '),
        (ALONE, f"[grid]\n{DAMPING}", "grid.hinge.damping: is under [factors], too; need it in one of them"),
        (ALONE, '[grid]\n"tendon.stifness" = ["1 N/cm"]', 'tendon.stifness: unknown key, got ["1 N/cm"]; did you mean'),
        (
            ALONE,
            '[grid]\n"tendon.stiffness" = {distribution = "uniform", low = "1 N/cm", high = "2 N/cm"}',
            "grid.tendon.stiffness: need a list or a range, got a distribution",
        ),
        (
            f'{ALONE}\nask = "least-torques"',
            '[grid]\n"protocol.fold_torque" = ["1 N cm"]',
            'factors.protocol.fold_torque: is what "least-torques" looks for',
        ),
        (
            ALONE,
            '[grid]\n"tendon.stiffness" = "1..1000 N/cm step 1"\n"tendon.rest_length" = "0..9 cm step 0.01"',
            "factors: need at most 1000000 points, got 2703000",
        ),
    ],
)
def test_invalid_choices_are_rejected_in_one_line(study_file, head, tail, message):
    with pytest.raises(InputError) as caught:
        load_study(study_file(DAMPING, head, tail))
    assert message in str(caught.value)
    assert len(str(caught.value).splitlines()) == 1


def test_distributions_are_not_varied_one_at_a_time(study_file):
    drawn = '"tendon.stiffness" = {distribution = "uniform", low = "10 N/cm", high = "20 N/cm"}'
    with pytest.raises(InputError, match='vary: needs factors that are lists or ranges, got distributions with "one'):
        load_study(study_file(drawn, ALONE, "[sampling]\ncount = 3"))


def test_the_named_study_has_the_papers_tendons_at_every_value_that_had_to_be_chosen():
    study = ff.load_study("binder2025-choices")
    papers = ff.load_study("binder2025-search")
    tendons = [dict(point) for point in papers.points]
    for place, choice in enumerate(study.choices):
        assert [dict(point) for point in study.points[60 * place : 60 * (place + 1)]] == [
            {**choice, **tendon} for tendon in tendons
        ]
    # the base's value of every factor is in the list, and is not repeated as a choice
    assert len(study.choices) == 1 + sum(len(factor.values) - 1 for factor in study.factors)
    assert max(study.search.first.values) == 0.5
