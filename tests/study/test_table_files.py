"""Files of a table: those of many points are compressed, and hold the same values."""

import csv
import sys

import pytest
import xarray as xr

from forficula.analysis import Verdict
from forficula.errors import InputError
from forficula.show.folder.study_folder import write_study
from forficula.study import json_rows, load_study, run_study, table_csv
from forficula.study.running.evaluate import row_key
from forficula.study.tables import table_files
from forficula.study.tables.table_files import write_csv, write_netcdf, write_parquet

FACTORS = """
"tendon.stiffness" = { distribution = "uniform", low = "10 N/cm", high = "60 N/cm" }
"vein.density" = { distribution = "uniform", low = "1 g/cm^3", high = "2 g/cm^3" }
"""


def folded(designs, _):
    """Rows without runs: every third structure does not fold, and the first one is unreliable."""
    for number, design in enumerate(designs):
        verdict = Verdict.UNTRUSTED if not number else Verdict.STUCK if number % 3 else Verdict.REACHED
        word = {Verdict.UNTRUSTED: "unreliable", Verdict.STUCK: "did not fold"}.get(verdict, "folded and opened")
        reached = verdict is Verdict.REACHED
        yield {
            "key": row_key(design),
            **{"status": f"{word} µ", "verdict": verdict.value, "outcome": word, "folded": reached, "opened": reached},
            **({"fold_time_s": 0.1 + number / 7, "fold_work_J": number / 3} if reached else {}),
        }


@pytest.fixture(scope="module")
def sampled(tmp_path_factory, write_study_file):
    folder = tmp_path_factory.mktemp("sampled")
    study = load_study(write_study_file(folder / "small.toml", FACTORS, tail="[sampling]\ncount = 9"))
    return study, run_study(study, folder / "out", cluster=folded)


def test_compressed_netcdf_has_the_same_values_and_is_read_in_parts(sampled, tmp_path, monkeypatch):
    _, table = sampled
    write_netcdf(table, tmp_path / "plain.nc")
    monkeypatch.setattr(table_files, "_MANY", 9)
    write_netcdf(table, tmp_path / "compressed.nc")
    with xr.open_dataset(tmp_path / "compressed.nc", engine="h5netcdf") as read:
        assert read["status"].encoding["zlib"]
        assert read["fold_time"].encoding["zlib"]
        assert not read["status"].variable._in_memory
        assert read["status"].isel(sample=slice(2, 4)).values.tolist() == table["status"].values[2:4].tolist()
        assert read.identical(table)
    with xr.open_dataset(tmp_path / "plain.nc", engine="h5netcdf") as read:
        assert not read["status"].encoding.get("zlib")
        assert read.identical(table)


def test_csv_that_is_written_line_by_line_is_the_same(sampled, tmp_path):
    study, table = sampled
    write_csv(study, table, tmp_path / "table.csv")
    text = (tmp_path / "table.csv").read_text("utf-8")
    assert text == table_csv(study, table)
    rows = list(csv.DictReader(text.splitlines()))
    assert [float(row["tendon_stiffness_N_per_m"]) for row in rows] == table["tendon_stiffness"].values.tolist()
    assert [row["folded"] for row in rows[:4]] == ["", "false", "false", "true"]


def test_parquet_has_the_columns_of_the_csv(sampled, tmp_path, monkeypatch):
    parquet = pytest.importorskip("pyarrow.parquet")
    study, table = sampled
    monkeypatch.setattr(table_files, "_BLOCK", 4)
    write_parquet(study, table, tmp_path / "table.parquet")
    read = parquet.read_table(tmp_path / "table.parquet")
    assert read.to_pylist() == list(json_rows(study, table))
    assert [str(read.schema.field(name).type) for name in ("fold_time_s", "folded", "status")] == [
        *("double", "bool", "string"),
    ]


def test_parquet_without_its_library_is_refused(sampled, tmp_path, monkeypatch):
    study, table = sampled
    monkeypatch.setitem(sys.modules, "pyarrow", None)
    with pytest.raises(InputError, match="Parquet needs pyarrow: pip install pyarrow"):
        write_parquet(study, table, tmp_path / "table.parquet")
    assert not list(tmp_path.iterdir())


def test_a_parquet_file_of_an_earlier_table_does_not_stay(sampled, tmp_path):
    study, table = sampled
    (tmp_path / "table.parquet").write_bytes(b"earlier")
    write_study(study, table, tmp_path)
    assert not (tmp_path / "table.parquet").exists()
    assert (tmp_path / "table.csv").exists()
