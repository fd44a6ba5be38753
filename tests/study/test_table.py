import csv
import io
import math

import numpy as np
import pytest
import xarray as xr

import forficula as ff
from forficula.design import with_values
from forficula.show.study.maps import map_drawings
from forficula.study import load_study, run_study, table_csv

# the first columns of a table, in this order
COLUMNS = [
    "tendon_stiffness_N_per_m",
    "tendon_rest_length_m",
    "least_fold_torque_N_m",
    "least_unfold_torque_N_m",
    "fold_time_s",
    "fold_work_J",
    "unfold_work_J",
    "flat_energy_J",
    "folded_energy_J",
    "opened_energy_J",
    "status",
]
SEARCH = (
    '[search]\nfold_with = "50 N cm"\nfold_torques = ["10 N cm", "50 N cm"]\nunfold_torques = ["20 N cm", "90 N cm"]'
)


def lines(text):
    return list(csv.DictReader(io.StringIO(text)))


@pytest.fixture(scope="module")
def searched(tmp_path_factory, write_study_file):
    """Return a study of four tendons and its table; some tendons fold and some of these open."""
    study = load_study(
        write_study_file(
            tmp_path_factory.mktemp("searched") / "small.toml",
            '"tendon.stiffness" = ["10 N/cm", "60 N/cm"]\n"tendon.rest_length" = ["5 cm", "9 cm"]',
            head='ask = "least-torques"',
            tail=SEARCH,
        )
    )
    return study, run_study(study, tmp_path_factory.mktemp("searched") / "out")


def test_columns_are_in_si_with_units_in_their_names(searched):
    study, table = searched
    text = table_csv(study, table)
    assert text.splitlines()[0].split(",")[: len(COLUMNS)] == COLUMNS
    rows = lines(text)
    assert [(float(row[COLUMNS[0]]), float(row[COLUMNS[1]])) for row in rows] == [
        (1000.0, 0.05),
        (1000.0, 0.09),
        (6000.0, 0.05),
        (6000.0, 0.09),
    ]


def test_a_cell_is_empty_where_there_is_no_number(searched):
    study, table = searched
    rows = lines(table_csv(study, table))
    assert {row["least_fold_torque_N_m"] for row in rows} <= {"", "0.1", "0.5"}
    assert any(row["least_fold_torque_N_m"] == "" for row in rows)
    assert any(row["least_unfold_torque_N_m"] for row in rows)
    for row in rows:
        assert (row["fold_work_J"] == "") == (row["least_fold_torque_N_m"] == "")
        assert (row["unfold_work_J"] == "") == (row["least_unfold_torque_N_m"] == "")
        assert row["status"]


def test_the_numbers_of_the_text_are_those_of_the_dataset_to_the_last_bit(searched):
    study, table = searched
    rows = lines(table_csv(study, table))
    for column in COLUMNS[2:-1]:
        name = column.rpartition("_N_m" if column.endswith("_N_m") else "_")[0]
        values = table[name].values.ravel()
        assert [float(row[column]) if row[column] else math.nan for row in rows] == pytest.approx(
            values, rel=0, abs=0, nan_ok=True
        )


def test_a_tendons_energy_when_flat_is_that_of_its_length_beyond_rest(searched):
    # three tendons, k (l - l0)^2 / 2 each; the length at rest is near 11 cm and hardly depends on the tendon
    _, table = searched
    stretch = 0.11 - table["tendon_rest_length"]
    expected = 3 * table["tendon_stiffness"] / 2 * stretch**2
    # measured: an overbend of 3 deg shortens 11 cm by 4e-5 m, of 2 cm
    assert table["flat_energy"].values == pytest.approx(expected.transpose(*table["flat_energy"].dims).values, rel=0.2)


def test_coordinates_are_in_si_with_key_and_units(searched):
    _, table = searched
    assert table["least_fold_torque"].dims == ("tendon_stiffness", "tendon_rest_length")
    attributes = table["tendon_rest_length"].attrs
    assert (attributes["units"], attributes["display"], attributes["key"]) == ("m", "cm", "tendon.rest_length")
    assert table["fold_torque"].values == pytest.approx([0.1, 0.5])
    assert table["fold_work"].attrs["units"] == "J"
    # a failed run has them, too
    assert table["fold_work"].attrs["long_name"] == "work of folding, even if it failed"
    assert table["flat_energy"].attrs["long_name"] == "energy of the tendons, flat"
    assert table["folded_energy"].attrs["long_name"] == "energy of the tendons, folded, or where folding ended"
    assert table["fold_time_by_torque"].dims[-1] == "fold_torque"
    assert np.array_equal(table["folded_by_torque"], np.isfinite(table["fold_time_by_torque"]))


def test_dataset_is_read_back_from_its_file(searched, tmp_path):
    _, table = searched
    (tmp_path / "table.nc").write_bytes(table.to_netcdf(engine="h5netcdf"))
    with xr.open_dataset(tmp_path / "table.nc", engine="h5netcdf") as again:
        assert again.load().identical(table)


def test_the_order_of_the_factors_is_the_studys(tmp_path, study_file):
    study = load_study(study_file('"tendon.rest_length" = ["5 cm", "9 cm"]\n"tendon.stiffness" = ["10 N/cm"]'))
    table = run_study(study, tmp_path / "out")
    assert table["status"].dims == ("tendon_rest_length", "tendon_stiffness")
    assert table_csv(study, table).startswith("tendon_rest_length_m,tendon_stiffness_N_per_m,fold_time_s,")


def test_angles_are_in_degrees_and_whole_numbers_have_no_unit(tmp_path, study_file):
    study = load_study(study_file('"pattern.sector_angle" = ["18 deg", "0.3 rad"]\n"pattern.units" = [1]'))
    table = run_study(study, tmp_path / "out")
    rows = lines(table_csv(study, table))
    assert [float(row["pattern_sector_angle_deg"]) for row in rows] == pytest.approx([18, math.degrees(0.3)])
    assert [row["pattern_units"] for row in rows] == ["1", "1"]
    assert table["pattern_sector_angle"].values == pytest.approx([math.radians(18), 0.3])
    # four layers of bars of 5 mm; a narrower fan has the shorter outline and the smaller area
    assert table["folded_height"].values == pytest.approx(0.02)
    assert [float(row["folding_ratio"]) for row in rows] == pytest.approx(table["folding_ratio"].values.ravel())
    assert 2 < table["folding_ratio"].values[1, 0] < table["folding_ratio"].values[0, 0] < 2.1


def test_only_a_study_of_patterns_has_folding_ratios(searched):
    assert "folding_ratio" not in searched[1]


def test_a_plain_run_reports_whether_the_wing_folded_and_opened(tmp_path, study_file):
    table = run_study(load_study(study_file('"tendon.rest_length" = ["5 cm", "9 cm"]')), tmp_path / "out")
    assert table["folded"].dtype == bool
    for number, status in enumerate(table["status"].values):
        assert bool(table["opened"][number]) == (status == "folded and opened")
        assert math.isfinite(table["fold_time"][number]) == bool(table["folded"][number])
    assert "least_fold_torque" not in table


@pytest.mark.parametrize(
    ("factor", "labels"),
    [
        ('"pattern.tangent" = ["left", "right"]', ["left", "right"]),
        ('"protocol.contact" = [false, true]', ["False", "True"]),
        ('"membrane.distal_rows" = [[], [0.5]]', ["[]", "[0.5]"]),
    ],
)
def test_words_and_lists_label_a_table_too(tmp_path, study_file, factor, labels):
    study = load_study(study_file(factor))
    table = run_study(study, tmp_path / "out")
    assert [line.split(",")[0] for line in table_csv(study, table).splitlines()[1:]] == labels
    assert table.to_netcdf(engine="h5netcdf")


def test_automatic_and_given_timesteps_share_a_table(tmp_path, study_file):
    study = load_study(study_file('"protocol.timestep" = ["0.4 ms", "auto", "0.25 ms"]'))
    table = run_study(study, tmp_path / "out")
    # a single word makes all values words, because an axis has no number for it
    assert table["protocol_timestep"].values.tolist() == ["0.4 ms", "auto", "0.25 ms"]
    assert "units" not in table["protocol_timestep"].attrs
    rows = lines(table_csv(study, table))
    assert [row["protocol_timestep"] for row in rows] == ["0.4 ms", "auto", "0.25 ms"]
    assert len({row["fold_work_J"] for row in rows}) == 3
    result = ff.run(with_values(study.base, {"protocol.timestep": "auto"}), confirm=False).design
    assert isinstance(result.protocol.timestep, float)
    alone = ff.measure(ff.run(result, confirm=False))
    assert table["fold_work"].values[1] == alone.transitions["fold"].work
    assert table.to_netcdf(engine="h5netcdf")
    assert map_drawings(table)


def test_drawn_points_are_samples_with_the_values_that_ran(tmp_path, study_file):
    drawn = '"tendon.stiffness" = {distribution = "normal", mean = "20 N/cm", deviation = "2 N/cm"}'
    study = load_study(study_file(drawn, tail="[sampling]\ncount = 3"))
    table = run_study(study, tmp_path / "out")
    assert table.sizes == {"sample": 3}
    assert table["tendon_stiffness"].dims == ("sample",)
    rows = lines(table_csv(study, table))
    assert [float(row["tendon_stiffness_N_per_m"]) for row in rows] == table["tendon_stiffness"].values.tolist()
