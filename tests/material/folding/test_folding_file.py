"""Folding tests are read from tables of angle and moment, or of travel and force with a lever arm."""

import numpy as np
import pytest

from forficula.errors import InputError
from forficula.material import read_folding_tests
from forficula.material.machine.folding_file import has_angles
from tests.material.folding.strips import WIDTH, folded_strip

LEVER = 0.03
STRIP = folded_strip(peaks=(0.9, -0.2), rows=20)


def table(path, names, *columns, above=(), sign="."):
    rows = [",".join(f"{cell:.9g}" for cell in row) for row in zip(*columns, strict=True)]
    if sign == ",":
        rows = [row.replace(",", ";").replace(".", ",") for row in rows]
    path.write_text("\n".join([*above, names, *rows, ""]), encoding="utf-8")
    return path


@pytest.fixture
def angles(tmp_path):
    return table(
        tmp_path / "a.csv",
        "Time (s),Angle (deg),Moment (N mm)",
        STRIP.time,
        np.rad2deg(STRIP.angle),
        1e3 * STRIP.moment,
    )


def test_angle_and_moment_are_read_in_the_units_of_their_names(angles):
    (read,) = read_folding_tests([angles], width=WIDTH, thickness=1e-4)
    assert has_angles(angles)
    assert read.angle == pytest.approx(STRIP.angle, rel=1e-7)
    assert read.moment == pytest.approx(STRIP.moment, rel=1e-7)
    assert read.time == pytest.approx(STRIP.time)
    assert (read.width, read.thickness) == (WIDTH, 1e-4)


def test_a_german_table_without_a_time_is_read(tmp_path):
    names = "Biegewinkel [°];Biegemoment [mN m]"
    path = table(
        tmp_path / "w.csv", names, np.rad2deg(STRIP.angle), 1e3 * STRIP.moment, above=["Breite;20;mm"], sign=","
    )
    (read,) = read_folding_tests([path])
    assert read.time is None
    assert read.width == WIDTH
    assert read.moment == pytest.approx(STRIP.moment, rel=1e-7)


def test_the_work_of_force_and_travel_equals_that_of_moment_and_angle(tmp_path):
    travel = LEVER * np.tan(STRIP.angle)
    force = STRIP.moment * LEVER / (LEVER**2 + travel**2)
    names = "Time (s),Extension (mm),Load (mN)"
    path = table(tmp_path / "f.csv", names, STRIP.time, 1e3 * travel, 1e3 * force)
    (read,) = read_folding_tests([path], width=WIDTH, lever=LEVER)
    assert read.angle == pytest.approx(STRIP.angle, abs=1e-7)
    assert read.moment == pytest.approx(STRIP.moment, abs=1e-9)
    assert np.trapezoid(read.moment, read.angle) == pytest.approx(np.trapezoid(force, travel), rel=1e-2)


def test_a_moment_per_width_is_multiplied_by_the_width(tmp_path):
    path = table(tmp_path / "m.csv", "Angle [rad],Moment per width [N m/m]", STRIP.angle, STRIP.moment / WIDTH)
    assert read_folding_tests([path], width=WIDTH)[0].moment == pytest.approx(STRIP.moment, rel=1e-7)


@pytest.mark.parametrize(
    ("names", "sizes", "message"),
    [
        ("Angle (deg),Moment (N mm)", {}, "width: is not in the file; give the width of the strip, such as 20 mm"),
        (
            "Extension (mm),Load (N)",
            {"width": WIDTH},
            "lever: is not in the file.*the file has Extension and Load instead",
        ),
        ("Angle (deg),Moment (kPa)", {"width": WIDTH}, 'line 1: Moment: "kPa" is not its unit; need one of N m'),
        ("Angle (mm),Moment (N m)", {"width": WIDTH}, 'line 1: Angle: "mm" is not its unit; need one of deg'),
        ("Angle (deg),Moment (N)", {"width": WIDTH}, 'line 1: Moment: "N" is not its unit; need one of N m.*N m/m'),
        ("Angle (deg),Temperature (N mm)", {"width": WIDTH}, "need a column of force, such as Moment, or Load"),
    ],
)
def test_files_without_what_a_moment_needs_are_refused(tmp_path, names, sizes, message):
    path = table(tmp_path / "t.csv", names, STRIP.angle, STRIP.moment)
    with pytest.raises(InputError, match=message):
        read_folding_tests([path], **sizes)


def test_a_file_with_names_alone_is_refused_with_its_line_and_the_names(tmp_path):
    path = tmp_path / "h.csv"
    path.write_text("Strip;1\nAngle (deg);Moment (N m)\n")
    with pytest.raises(InputError, match=r'line 2: need rows of numbers below the names "Angle .deg.*, got none$'):
        read_folding_tests([path], width=WIDTH)


def test_an_angle_in_a_wrong_unit_is_still_a_folding_test(tmp_path):
    assert has_angles(table(tmp_path / "a.csv", "Angle (mm),Moment (N)", STRIP.angle, STRIP.moment))
