import math
import subprocess
import sys

import h5netcdf
import numpy as np
import pytest
import xarray
from hypothesis import given, settings
from hypothesis import strategies as st

import forficula as ff
from forficula.design import with_values
from forficula.dynamics import Record, StageEnd, load_record, save_record
from forficula.dynamics.record import VARIABLES
from forficula.errors import InputError
from forficula.structure import structure_of
from tests.places import places
from tests.structures import motor_work

REFERENCE = ff.load_design("binder2025")
STRUCTURE = structure_of(REFERENCE)
SIZES = {"hinge": 12, "tendon": 3, "motor": 2, "point": 15, "axis": 3, "node": 20}


def planted(seed=0, goal_times=(None, 0.02), diverged_at=None, times=5):
    """Return a record of random numbers, without a run."""
    random = np.random.default_rng(seed)
    series = {
        name: random.normal(size=(times, *(SIZES[dimension] for dimension in dimensions)))
        for name, (dimensions, _, _) in VARIABLES.items()
    }
    ends = tuple(
        StageEnd(stage=stage, start=0.01 * index, end=0.01 * (index + 1), goal_time=goal, at_rest=goal is None)
        for index, (stage, goal) in enumerate(zip(REFERENCE.protocol.stages, goal_times, strict=False))
    )
    return Record(
        design=REFERENCE,
        structure=STRUCTURE,
        time=np.sort(random.uniform(size=times)),
        series=series,
        stages=ends,
        diverged_at=diverged_at,
    )


@pytest.fixture(scope="module")
def short_run():
    """Return a run of 30.4 ms, or 152 steps: at rest up to 10.4 ms, then folding up to its time limit."""
    stages = [
        {"name": "settle", "drive": "none", "until": "time", "hold": 0.0, "time_limit": 0.0104},
        {"name": "fold", "drive": "fold", "until": "folded", "hold": 0.0, "time_limit": 0.02},
    ]
    return ff.run(with_values(REFERENCE, {"protocol.stages": stages}), confirm=False)


@settings(max_examples=10, deadline=None)  # each writes and reads a file
@given(
    st.integers(0, 2**32 - 1),
    st.lists(st.none() | st.floats(0, 10), min_size=1, max_size=5),
    st.none() | st.floats(1e-9, 10),
    st.integers(1, 30),
)
def test_a_record_read_from_a_file_has_the_same_bits(tmp_path_factory, seed, goal_times, diverged_at, times):
    record = planted(seed, goal_times, diverged_at, times)
    path = tmp_path_factory.mktemp("record", numbered=True) / "record.nc"
    save_record(record, path)
    back = load_record(path)
    xarray.testing.assert_identical(back.data.drop_attrs(deep=False), record.data)
    assert (back.design, back.stages, back.diverged_at) == (record.design, record.stages, record.diverged_at)
    assert np.array_equal(back.triangles, record.triangles)


def test_a_record_of_a_run_is_read_back_whole(tmp_path, short_run):
    save_record(short_run, tmp_path / "record.nc")
    back = load_record(tmp_path / "record.nc")
    xarray.testing.assert_identical(back.data.drop_attrs(deep=False), short_run.data)
    assert back.stages == short_run.stages
    assert ff.measure(back).energy_balance == ff.measure(short_run).energy_balance


def test_the_most_kinetic_energy_is_that_of_every_step_and_not_only_of_the_rows(tmp_path, short_run):
    every = ff.run(with_values(short_run.design, {"protocol.sample_interval": "0.2 ms"}), confirm=False)
    most = every.series["kinetic_energy"]
    assert short_run.kinetic_peak == every.kinetic_peak == (every.time[most.argmax()], most.max())
    assert short_run.kinetic_peak[1] >= short_run.series["kinetic_energy"].max()
    save_record(short_run, tmp_path / "record.nc")
    assert load_record(tmp_path / "record.nc").kinetic_peak == short_run.kinetic_peak


def test_every_series_says_its_unit_in_the_file(tmp_path):
    save_record(planted(), tmp_path / "record.nc")
    with h5netcdf.File(tmp_path / "record.nc", "r") as file:
        units = {name: variable.attrs.get("units") for name, variable in file.variables.items()}
    assert units["time"] == "s"
    for ending, unit in {"_angle": "rad", "_length": "m", "_energy": "J", "_work": "J", "_power": "W"}.items():
        named = {name: said for name, said in units.items() if name.endswith(ending)}
        assert named
        assert set(named.values()) == {unit}
    assert units["point_position"] == units["membrane_position"] == "m"


def test_a_record_file_contains_design_and_versions(tmp_path):
    save_record(planted(diverged_at=0.5), tmp_path / "record.nc")
    with xarray.open_dataset(tmp_path / "record.nc", engine="h5netcdf") as file:
        attributes = file.attrs
        assert list(file["stage_name"].values) == ["settle", "fold"]
    assert attributes["design_hash"] == REFERENCE.hash
    assert 'stiffness = "10 N/cm"' in attributes["design"]
    assert attributes["diverged_at"] == 0.5
    assert {"version_forficula", "version_mujoco", "version_numpy"} <= set(attributes)


def test_rows_lie_at_the_sample_interval_and_where_stages_begin_and_end(short_run):
    every_millisecond = 1e-3 * np.arange(31)
    expected = np.sort([*every_millisecond, 0.0104, 0.0304])
    # s; multiples of the timestep, except for rounding
    assert short_run.data["time"].values == pytest.approx(expected, abs=1e-15)
    (settle, fold) = short_run.stages
    assert (settle.start, settle.end, fold.start, fold.end) == pytest.approx((0, 0.0104, 0.0104, 0.0304), abs=1e-15)
    assert settle.goal_time is None
    assert fold.goal_time is None


def test_the_wing_starts_flat_bent_into_the_overbend_and_at_rest(short_run):
    ring = short_run.angles("ring")[0]
    assert ring == pytest.approx(np.full(3, math.radians(2)), rel=1e-12)  # deg to rad and back
    for role in ("sweep", "lift", "turn"):
        assert np.array_equal(short_run.angles(role)[0], np.zeros(3))
    start = short_run.data.isel(time=0)
    for name in ("kinetic_energy", "motor_work", "hinge_damping_work"):
        assert not start[name].values.any()


def test_no_torque_works_at_rest_and_no_distal_one_while_folding(short_run):
    proximal, distal = (motor_work(short_run, name) for name in ("proximal", "distal"))
    assert not proximal[short_run.time <= 0.0104].any()
    assert not distal.any()
    assert proximal[-1] > 0


def test_work_of_folding_is_the_torque_times_the_angles_turned(short_run):
    # 50 N cm about every proximal axis. A step turns with its final velocity; power uses the mean velocity, so the
    # works differ by half a step (0.1 ms) at the last velocity, below 100 rad/s for three veins
    angle = short_run.angles("turn").sum(axis=1)
    turned = angle[-1] - angle[np.argmin(np.abs(short_run.time - 0.0104))]
    assert motor_work(short_run, "proximal")[-1] == pytest.approx(0.5 * turned, abs=0.5 * 1e-4 * 3 * 100)


def test_veins_keep_their_lengths(short_run):
    hub, ring, tip = (places(short_run, role) for role in ("hub", "ring", "tip"))
    # rigid bodies in double precision, in metres
    assert np.linalg.norm(ring - hub, axis=-1) == pytest.approx(np.full((33, 3), 0.12), abs=1e-12)
    assert np.linalg.norm(tip - ring, axis=-1) == pytest.approx(np.full((33, 3), 0.10), abs=1e-12)


def refusal(path):
    with pytest.raises(InputError) as caught:
        load_record(path)
    message = str(caught.value)
    assert len(message.splitlines()) == 1
    return message


@pytest.mark.parametrize("content", [b"", b"not a netCDF file", b"\x89HDF\r\n\x1a\n" + bytes(200)])
def test_a_file_that_is_no_netcdf_is_one_error(tmp_path, content):
    (tmp_path / "a.nc").write_bytes(content)
    assert refusal(tmp_path / "a.nc").startswith(f"{tmp_path}/a.nc: not a record of forficula: ")


def test_a_record_that_was_cut_off_is_one_error(tmp_path):
    save_record(planted(), tmp_path / "a.nc")
    whole = (tmp_path / "a.nc").read_bytes()
    for share in (0.01, 0.5, 0.99):
        (tmp_path / "a.nc").write_bytes(whole[: int(share * len(whole))])
        assert refusal(tmp_path / "a.nc").startswith(f"{tmp_path}/a.nc: not a record of forficula: ")


def flips(size, count):
    """Return positions of bits spread over a file, and those of its checksum."""
    random = np.random.default_rng(11)
    return sorted({*random.integers(0, 8 * size, count).tolist(), *range(8 * (size - 90), 8 * size, 3)})


def test_every_flipped_bit_is_refused_or_does_not_matter(tmp_path, short_run):
    path = tmp_path / "record.nc"
    save_record(short_run, path)
    whole = path.read_bytes()
    for place in flips(len(whole), 1000):
        damaged = bytearray(whole)
        damaged[place // 8] ^= 1 << place % 8
        path.write_bytes(damaged)
        assert refusal(path).startswith(f"{path}: not a record of forficula")
    path.write_bytes(whole)
    assert load_record(path).data.drop_attrs(deep=False).identical(short_run.data)


def test_bytes_lost_or_added_anywhere_are_noticed(tmp_path):
    path = tmp_path / "record.nc"
    save_record(planted(), path)
    whole = path.read_bytes()
    for place in np.linspace(0, len(whole) - 1, 60).astype(int):
        path.write_bytes(whole[:place] + whole[place + 1 :])
        assert refusal(path).startswith(f"{path}: not a record of forficula")
    path.write_bytes(whole + b"x")
    assert (
        refusal(path)
        == f"{path}: not a record of forficula any more: damaged since it was written; run its design again"
    )


def test_a_record_without_a_checksum_is_refused_with_what_to_do(tmp_path):
    path = tmp_path / "record.nc"
    save_record(planted(), path)
    path.write_bytes(path.read_bytes().rpartition(b"\nforficula sha256 ")[0])
    why = "no checksum ends it: it is cut off, or not of this version"
    assert refusal(path) == f"{path}: not a record of forficula: {why}; run its design again"


def test_a_checksum_does_not_keep_other_programs_from_reading_a_record(tmp_path, short_run):
    save_record(short_run, tmp_path / "record.nc")
    with xarray.open_dataset(tmp_path / "record.nc", engine="h5netcdf") as file:
        assert np.array_equal(file["tendon_length"].values, short_run.data["tendon_length"].values)


def test_a_netcdf_file_of_another_program_is_one_error(tmp_path):
    xarray.Dataset({"a": ("x", [1.0])}).to_netcdf(tmp_path / "a.nc", engine="h5netcdf")
    assert refusal(tmp_path / "a.nc").startswith(f"{tmp_path}/a.nc: not a record of forficula: ")


@pytest.mark.parametrize(("name", "looked_for"), [("none.nc", "none.nc"), (".", "record.nc")])
def test_a_record_that_is_not_there_is_one_error(tmp_path, name, looked_for):
    assert refusal(tmp_path / name) == f"{tmp_path / looked_for}: no such file"


def test_the_path_of_a_record_may_be_text(tmp_path):
    record = planted()
    save_record(record, str(tmp_path / "record.nc"))
    assert load_record(str(tmp_path / "record.nc")).data.equals(record.data)


@pytest.mark.parametrize(("kept", "age"), [(1, "an earlier"), (3, "a later")])
def test_a_record_of_another_format_is_refused_with_its_age_and_what_to_do(tmp_path, monkeypatch, kept, age):
    with monkeypatch.context() as before:
        before.setattr("forficula.dynamics.record_file._FORMAT", kept)
        save_record(planted(), tmp_path / "a.nc")
    other = f"written by {age} state of forficula (format {kept}, this one reads 2): run `forficula run"
    assert refusal(tmp_path / "a.nc") == f"{tmp_path}/a.nc: {other} {tmp_path}/design.toml`"


def test_a_record_that_cannot_be_written_is_one_error_and_leaves_nothing(tmp_path):
    (tmp_path / "file").write_text("old")
    with pytest.raises(InputError, match=r"cannot be written: .*file is a file, not a folder$"):
        save_record(planted(), tmp_path / "file" / "record.nc")
    assert [path.name for path in tmp_path.iterdir()] == ["file"]


FULL_DISK = """
import pathlib, resource, sys
from forficula.dynamics import load_record, save_record
from forficula.errors import InputError
record = load_record(pathlib.Path(sys.argv[1]))
resource.setrlimit(resource.RLIMIT_FSIZE, (20_000, 20_000))
try:
    save_record(record, pathlib.Path(sys.argv[2]))
except InputError as error:
    print(error)
"""


def test_a_disk_that_fills_up_is_one_error_and_leaves_nothing(tmp_path):
    save_record(planted(), tmp_path / "old.nc")
    (tmp_path / "new").mkdir()
    target = tmp_path / "new" / "record.nc"
    # a limit on file size emulates a full disk; in a process of its own, because HDF5 then fails for good
    done = subprocess.run(
        [sys.executable, "-c", FULL_DISK, tmp_path / "old.nc", target], capture_output=True, text=True, check=False
    )
    assert (done.returncode, done.stderr) == (0, "")
    assert done.stdout == f"{target}: cannot be written: File too large\n"
    assert list((tmp_path / "new").iterdir()) == []


def test_a_record_is_written_without_xarray(tmp_path, monkeypatch):
    """Its import would take 0.6 s of every run."""
    record = planted()
    monkeypatch.setitem(sys.modules, "xarray", None)
    save_record(record, tmp_path / "record.nc")
    monkeypatch.undo()
    assert load_record(tmp_path / "record.nc").data.identical(record.data)
