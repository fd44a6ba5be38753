import codecs
import gzip
import itertools
import sys
import tracemalloc

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from forficula.errors import InputError
from forficula.material import read_tensile_test, read_tensile_tests
from tests.material.synthetic import AREA, LENGTH, bluehill_text, few_rows, plain_text, xpert_text

TEST = few_rows()
SIZE = {"length": LENGTH, "area": AREA}
DIGITS = 1e-8  # nine are written

TABLE = "need a table of time, extension and force, or for a folding test of angle and moment"


def file(folder, text, *, name="tendon.csv", encoding="utf-8"):
    path = folder / name
    path.write_bytes(text if isinstance(text, bytes) else text.encode(encoding))
    return path


def check(test, *, name="tendon"):
    """Check that a test that was read equals the one that was written."""
    assert test.name == name
    for read, written in ((test.time, TEST.time), (test.extension, TEST.extension), (test.force, TEST.force)):
        np.testing.assert_allclose(read, written, rtol=DIGITS, atol=DIGITS * np.abs(written).max())
    assert test.length == pytest.approx(LENGTH, rel=1e-12)
    assert test.area == pytest.approx(AREA, rel=1e-12)


def refusal(path, **size):
    with pytest.raises(InputError) as refused:
        read_tensile_test(path, **size)
    message = str(refused.value)
    assert message.startswith(f"{path}: ")
    assert "\n" not in message
    return message.removeprefix(f"{path}: ")


@given(
    delimiter=st.sampled_from("\t;,"),
    decimal=st.sampled_from(".,"),
    german=st.booleans(),
    force_unit=st.sampled_from(["N", "kN", "MPa"]),
    in_names=st.booleans(),
    encoding=st.sampled_from(["cp1252", "utf-8", "utf-8-sig", "utf-16", "utf-16-le", "utf-16-be"]),
    ending=st.sampled_from(["\n", "\r\n"]),
)
@settings(deadline=None)
def test_testxpert_is_read_in_every_language_encoding_and_sign(
    tmp_path_factory, delimiter, decimal, german, force_unit, in_names, encoding, ending
):
    if delimiter == decimal:
        delimiter = ";"
    text = xpert_text(
        TEST, delimiter=delimiter, decimal=decimal, german=german, force_unit=force_unit, in_names=in_names
    )
    path = tmp_path_factory.getbasetemp() / "tendon.TXT"
    path.write_bytes(text.replace("\n", ending).encode(encoding))
    check(read_tensile_test(path))


@given(
    decimal=st.sampled_from(".,"),
    german=st.booleans(),
    force_unit=st.sampled_from(["N", "kN", "lbf"]),
    encoding=st.sampled_from(["utf-8-sig", "utf-16", "utf-8"]),
    properties=st.booleans(),
)
@settings(deadline=None)
def test_bluehill_is_read_with_and_without_its_header(
    tmp_path_factory, decimal, german, force_unit, encoding, properties
):
    text = bluehill_text(TEST, decimal=decimal, german=german, force_unit=force_unit, properties=properties)
    path = file(tmp_path_factory.getbasetemp(), text, encoding=encoding)
    check(read_tensile_test(path, **({} if properties else SIZE)))


@pytest.mark.parametrize("pattern", ["{name} [{unit}]", "{name} ({unit})", "{name}_{unit}", "{name} in {unit}"])
@pytest.mark.parametrize(("delimiter", "decimal"), [(",", "."), (";", ","), ("\t", ",")])
def test_a_plain_table_has_its_units_in_its_names(tmp_path, pattern, delimiter, decimal):
    text = plain_text(TEST, delimiter=delimiter, decimal=decimal, pattern=pattern)
    check(read_tensile_test(file(tmp_path, text), **SIZE))


@pytest.mark.parametrize(
    "name", ["Prüfzeit", "Pruefzeit", "Prufzeit", "PrÃ¼fzeit", "Pr?fzeit", "PRÜFZEIT", "Pr\x81fzeit"]
)
def test_an_umlaut_may_be_mangled(tmp_path, name):
    check(read_tensile_test(file(tmp_path, xpert_text(TEST).replace("Prüfzeit", name))))


def test_bluehill_columns_can_have_the_names_of_measured_quantities(tmp_path):
    names = {"Time": "Time measurement", "Load": "Primary load measurement"}
    text = bluehill_text(TEST)
    for plain, measured in names.items():
        text = text.replace(f"{plain},", f"{measured},").replace(f",{plain}\r", f",{measured}\r")
    assert "Time measurement,Extension,Primary load measurement" in text
    check(read_tensile_test(file(tmp_path, text)))


def test_bluehill_in_german_has_semicolons_and_a_travel_of_the_crosshead(tmp_path):
    head = 'Texteingaben : Probenbeschriftung;"a"\r\nAllgemein : Startdatum;16.08.2024 16:07:51\r\n'
    head += "Abmessung : Länge;60,000;mm\r\nAbmessung : Querschnitt;5,00000;mm^2\r\n\r\n"
    names = "Zeit;Traversenweg;Last;Dehnung 1;Zugspannung\r\n(sec);(mm);(kN);(%);(MPa)\r\n"
    columns = (TEST.time, TEST.extension * 1e3, TEST.force / 1e3, TEST.strain * 100, TEST.stress / 1e6)
    rows = [";".join(f"{value:.9g}" for value in row).replace(".", ",") for row in zip(*columns, strict=True)]
    check(read_tensile_test(file(tmp_path, head + names + "\r\n".join(rows), encoding="cp1252")))


def specimens_in_one_file(*tables, between="\n"):
    lines = bluehill_text(TEST, properties=False).splitlines()
    return between.join("\n".join([*above, *lines]) + "\n" for above in tables)


def test_the_specimens_of_one_file_share_column_names(tmp_path):
    sizes = ["Length,60.0,mm", "Area,5.0,mm^2", ""]
    path = file(tmp_path, specimens_in_one_file(["Results Table 1", *sizes], ["Length,50.0,mm"], []))
    first, second, third = read_tensile_tests([path])
    check(first, name="tendon 1")
    check(third, name="tendon 3")
    # its length, and the area at the start of the file
    assert (second.name, second.length, second.area) == ("tendon 2", pytest.approx(0.05), pytest.approx(AREA))
    assert refusal(path) == "need one specimen, got 3: tendon 1, tendon 2, tendon 3"


def test_an_error_in_a_later_specimen_names_its_line(tmp_path):
    lines = specimens_in_one_file([], []).splitlines()
    lines[-1] = lines[-1].rpartition(",")[0]
    assert f"line {len(lines)}: need 3 cells" in refusal(file(tmp_path, "\n".join(lines)), **SIZE)


def test_one_test_in_two_tables_is_refused(tmp_path):
    lines = plain_text(TEST).splitlines()
    halves = [lines[0], *lines[1:20], lines[0], *lines[20:]]
    message = "line 21: the names are repeated, but time continues: join the tables"
    assert refusal(file(tmp_path, "\n".join(halves)), **SIZE) == message


def test_results_above_the_table_are_not_the_table(tmp_path):
    results = 'Results Table 1\n,Maximum Load,Extension at break\n,(N),(mm)\n1,"24.3","61.2"\n\n'
    check(read_tensile_test(file(tmp_path, results + bluehill_text(TEST))))


def test_of_several_travels_the_one_from_the_specimens_length_is_taken(tmp_path):
    columns = ["Prüfzeit [s]", "Traversenweg absolut [mm]", "Dehnung [%]", "Standardweg [mm]", "Standardkraft [N]"]
    path = file(tmp_path, ";".join(columns) + "\n0;250;1;0;0\n1;251;2;3;4\n2;252;3;6;8\n")
    assert read_tensile_test(path, **SIZE).extension.tolist() == [0, 0.003, 0.006]


def test_a_position_of_the_crosshead_counts_from_the_first_row(tmp_path):
    path = file(tmp_path, "Prüfzeit [s];Traversenweg absolut [mm];Standardkraft [N]\n0;250;0\n1;253;4\n")
    np.testing.assert_allclose(read_tensile_test(path, **SIZE).extension, [0, 0.003], atol=1e-15)


@pytest.mark.parametrize("german", [True, False])
def test_a_strain_column_replaces_the_travel(tmp_path, german):
    check(read_tensile_test(file(tmp_path, xpert_text(TEST, german=german, travel="strain"))))


def test_the_area_comes_from_the_edges_or_the_diameter(tmp_path):
    table = plain_text(TEST)
    edges = file(tmp_path, "Probendicke,2.5,mm\nProbenbreite,2.0,mm\nL0,60,mm\n" + table)
    check(read_tensile_test(edges))
    round_one = file(tmp_path, "Specimen : Diameter,2.52313,mm\nlength: 60 mm\n" + table)
    # the area's digits are those of the diameter
    assert read_tensile_test(round_one).area == pytest.approx(AREA, rel=1e-5)


def test_the_file_and_the_user_may_agree_within_the_digits_of_the_file(tmp_path):
    path = file(tmp_path, "L0,60.0,mm\nS0,5.0,mm^2\n" + plain_text(TEST))
    test = read_tensile_test(path, length=0.06004, area=5.04e-6)
    assert (test.length, test.area) == (0.06004, 5.04e-6)


def test_the_file_and_the_user_in_conflict_are_both_quoted(tmp_path):
    path = file(tmp_path, "L0,60.0,mm\nProbendicke,2.5,mm\nProbenbreite,2.0,mm\n" + plain_text(TEST))
    assert refusal(path, length=0.065) == "length: 65 mm was given, but the file has 60 mm (line 1: L0)"
    area = "area: 6 mm^2 was given, but the file has 5 mm^2 (line 3: Probenbreite and line 2: Probendicke)"
    assert refusal(path, area=6e-6) == area


def test_several_files_are_read_in_order_and_an_error_names_its_file(tmp_path):
    paths = [file(tmp_path, plain_text(TEST), name=f"tendon-{number}.csv") for number in (3, 1, 2)]
    assert [test.name for test in read_tensile_tests(paths, **SIZE)] == ["tendon-3", "tendon-1", "tendon-2"]
    empty = file(tmp_path, "", name="empty.csv")
    with pytest.raises(InputError, match=rf"^{empty}: {TABLE}, got an empty file$"):
        read_tensile_tests([*paths, empty], **SIZE)
    with pytest.raises(InputError, match=r"^need at least one file of a tensile test, got none$"):
        read_tensile_tests([])


NAMES = "time [s],extension [mm],force [N]\n"
ROWS = "0,0,0\n1,1.5,2.5\n2,3,4\n"


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("", f"{TABLE}, got an empty file"),
        (" \n\n", f"{TABLE}, got an empty file"),
        (NAMES, 'line 1: need rows of numbers below the names "time [s]", "extension [mm]" and "force [N]", got none'),
        ("a text\nof two lines\n", f"{TABLE}, found no rows of numbers: it is cut off, or its format is unknown"),
        (b"\x89PNG\r\n\x1a\n\xff\xfe binary", f"{TABLE}, found no rows of numbers"),
        (
            "1,2,3\n4,5,6\n",
            'line 1: need a column of time, such as Time or Prüfzeit, got "1", "2", "3"; known are Zwick',
        ),
        (
            "time [s],extension [mm]\n0,0\n1,1\n",
            'line 1: need a column of force, such as Load or Standardkraft, got "time", "extension"',
        ),
        ("time [s],force [N]\n0,0\n1,1\n", "line 1: need a column of travel, such as Extension or Standardweg, got"),
        ("extension [mm],force [N]\n0,0\n1,1\n", "line 1: need a column of time, such as Time or Prüfzeit, got"),
        ("time,extension [mm],force [N]\n" + ROWS, "line 1: time: the unit is missing; need one of s, ms, min"),
        ("Time,Extension,Load\n(s),(mm),\n" + ROWS, "line 1: Load: the unit is missing; need one of N, kN"),
        ("Time,Extension,Load\n" + ROWS, "line 1: Time: the unit is missing"),
        ("time [s],extension [mm],force [mm]\n" + ROWS, 'line 1: force: "mm" is not its unit; need one of N, kN'),
        ("time [s],extension [furlong],force [N]\n" + ROWS, 'line 1: extension: "furlong" is not its unit; need'),
        (
            "time [s],extension [mm],force [N]\ns,mm,kN\n" + ROWS,
            'line 2: force: the units are mixed: "N" in the name and "kN" below it',
        ),
        (
            "time [s],extension [mm],force [N],force [kN]\n0,0,0,0\n1,1,1,1\n",
            'line 1: two columns are named "force"; leave one of them out',
        ),
        (NAMES + "0,0,0\n1,1.5,2 N\n2,3,4\n", 'line 3: need a finite number, got "2 N"'),
        (NAMES + "0,0,0\n1,1.5,nan\n2,3,4\n", 'line 3: need a finite number, got "nan"'),
        (NAMES + "0,0,0\n\n1,,2\n2,3,4\n", 'line 4: need a finite number, got ""'),
        (NAMES + "0,0,0\n1,1.5,2.5\n2,3,\n", 'line 4: need a finite number, got "": is the file cut off?'),
        (NAMES + "0,0,0\n1,1.5,2.5\n2,3", "line 4: need 3 cells, as in the other rows, got 2: is the file cut off?"),
        (NAMES + "0,0,0\n1,1.5\n2,3,4\n", "line 3: need 3 cells, as in the other rows, got 2"),
        (NAMES + "0,0,0\n2,1.5,2.5\n1,3,4\n", "line 4: time: need times that never decrease, got 1 after 2"),
        (NAMES + "0,0,0\n", "line 1: need at least two rows of numbers, got one: is it cut off?"),
        (
            "time [s],extension [mm],force [N]\n0,0,0,0,0,0\n1,5,1,5,2,5\n",
            "line 2: need 3 cells, one for each name, got 6; decimal commas need another delimiter, or quotes",
        ),
        (
            "time [s];extension [mm];force [N]\n0,0;0,1;0,2\n1,5;1.5;2,5\n2,5;3,5;4,5\n",
            'line 3: decimal points and commas are mixed, got "1.5"',
        ),
        (f'note,"{"x" * 200_000}"\n' + NAMES + ROWS, "line 1: need at most 100000 characters on a line, got more"),
        (NAMES + f"0,0,0\n1,1.5,{'2' * 200_000}\n", "line 3: need at most 100000 characters on a line, got more"),
        (
            "time [s];extension [mm];force [N]\n0;0;999\n1;2;1,234\n2;3;12,345\n",
            'line 3: force: "1,234" may be 1.234 or 1234; export without commas between thousands, or with another',
        ),
        (
            'time [s],extension [mm],force [N]\n"1,000","1","2,000"\n"2,000","2","3,000"\n',
            'line 2: force: "2,000" may be 2.000 or 2000; export without',
        ),
        ('"L0";"60\n' + NAMES.replace(",", ";") + ROWS.replace(",", ";"), "line 5: need cells in closed quotes, is it"),
        ("L0,sixty,mm\n" + NAMES + ROWS, "length: is not in the file; give the specimen's length, such as 60 mm"),
        ("L0,60,mm\n" + NAMES + ROWS, "area: is not in the file; give the specimen's area, such as 5 mm^2"),
        ("L0,60\n" + NAMES + ROWS, "line 1: L0: the unit is missing; need one of mm, m"),
        ("x,1\nL0,60,N\n" + NAMES + ROWS, 'line 2: L0: "N" is not its unit; need one of mm, m'),
        ("L0,0,mm\n" + NAMES + ROWS, "line 1: L0: need 0.001 mm to 1e+05 mm, got 0 mm; is its unit wrong?"),
    ],
)
def test_a_file_that_cannot_be_used_is_refused_in_one_line(tmp_path, text, message):
    assert refusal(file(tmp_path, text)).startswith(message)


@pytest.mark.parametrize("row", ["1;2;1,2345", "1;2;0,123", "1,5;2;1,234", "1;0,002;1,234", "1;2;-0,002", "1;2;,125"])
def test_an_unambiguous_decimal_comma_applies_to_the_whole_table(tmp_path, row):
    text = f"time [s];extension [mm];force [N]\n0;0;1,234\n{row}\n2;3;1,236\n"
    assert read_tensile_test(file(tmp_path, text), **SIZE).force[[0, 2]].tolist() == [1.234, 1.236]


@pytest.mark.parametrize(("length", "shown"), [(0.0001, "0.1 mm"), (0.001, "1 mm")])
def test_a_specimen_that_is_stretched_a_thousandfold_is_refused_with_both_numbers(tmp_path, length, shown):
    text = plain_text(TEST)
    message = refusal(file(tmp_path, text), length=length, area=AREA)
    assert "extension: need more than -1 and at most 20 times the specimen's length" in message
    assert f"{shown}, got 6 cm; is the unit of one of them wrong?" in message


def test_a_file_larger_than_any_test_is_refused_unread(tmp_path, monkeypatch):
    monkeypatch.setattr("forficula.material.machine.machine_file._LARGEST", 2**20)
    assert refusal(file(tmp_path, b"x" * (2**20 + 1))) == "need a file of at most 1 MiB, got a larger one"


@pytest.mark.parametrize(
    ("size", "message"),
    [
        ({"length": 0.0, "area": AREA}, "length: need 0.001 mm to 1e+05 mm, got 0 mm; is its unit wrong?"),
        ({"length": 1e300, "area": AREA}, "length: need 0.001 mm to 1e+05 mm, got 1e+303 mm; is its unit wrong?"),
        ({"length": LENGTH, "area": -1.0}, "area: need 1e-09 mm^2 to 1e+06 mm^2, got -1e+06 mm^2; is its unit wrong?"),
        (
            {"length": LENGTH, "area": 1e-300},
            "area: need 1e-09 mm^2 to 1e+06 mm^2, got 1e-294 mm^2; is its unit wrong?",
        ),
        ({"length": LENGTH, "area": 1e300}, "area: need 1e-09 mm^2 to 1e+06 mm^2, got 1e+306 mm^2; is its unit wrong?"),
    ],
)
def test_a_size_that_no_specimen_has_is_refused_with_the_sizes_that_one_has(tmp_path, size, message):
    assert message in refusal(file(tmp_path, plain_text(TEST)), **size)


def test_a_missing_file_or_a_folder_is_refused(tmp_path):
    assert refusal(tmp_path / "none.csv") == "no such file"
    assert refusal(tmp_path) == "cannot be read: Is a directory"


def test_a_file_that_is_cut_off_anywhere_is_refused_or_a_shorter_test(tmp_path):
    content = xpert_text(TEST).encode("utf-16")
    whole = read_tensile_test(file(tmp_path, content))
    for length in range(0, len(content), 7):
        path = file(tmp_path, content[:length])
        try:
            test = read_tensile_test(path)
        except InputError:
            refusal(path)
        else:
            # the last number may have lost digits, which the file does not show
            rows = len(test.time) - 1
            assert rows < len(whole.time)
            np.testing.assert_array_equal(test.force[:rows], whole.force[:rows])


@given(st.binary(max_size=300))
@settings(deadline=None)
def test_any_bytes_raise_only_input_error(tmp_path_factory, content):
    for suffix in ("csv", "zs2"):
        path = tmp_path_factory.getbasetemp() / f"noise.{suffix}"
        for mark in (b"", codecs.BOM_UTF16_LE, b"time [s];extension [mm];force [N]\n"):
            path.write_bytes(mark + content)
            with pytest.raises(InputError):
                read_tensile_test(path)


def zs2(tests, *, floats="EE05", channels=(("Standard travel", "UT_Displacement"), ("Standard force", "UT_Force"))):
    """A series of testXpert as zs2decode's own encoder writes it, with the time in seconds."""
    encoder = pytest.importorskip("zs2decode.encoder")
    named = dict(enumerate([("Test time", "UT_Time"), *channels], start=1))
    manager = [
        section(f"Elem{number - 1}", value("ID", "66", number), section("Name", value("Text", "AA", name)), table)
        for number, (name, unit) in named.items()
        for table in [value("UnitTableName", "AA", unit) if unit else []]
    ]
    specimens = []
    for place, test in enumerate(tests):
        data = [test.time, test.extension * 1e3, test.force]
        arrays = [
            section(
                f"Elem{number - 1}", value("DataArray", floats, values.tolist()), value("TrsChannelId", "11", number)
            )
            for number, values in zip(named, data, strict=True)
        ]
        block = nested("SeriesElements/Elem0/RealTimeCapture/Trs/SingleGroupDataBlock/DataChannels", *arrays)
        specimens.append(section(f"Elem{place}", block))
    tree = nested(
        "Document/Body/batch",
        nested("SeriesDef/TestTaskDefs/Elem0/ChannelManager/ChannelManager", *manager),
        nested("Series/SeriesElements", *specimens),
    )
    return gzip.compress(bytes(encoder.make_datastream(encoder.make_raw_chunks(tree))))


def value(name, kind, content):
    return [[None, name, kind, content]]


def section(name, *inside):
    return [[None, name, "DD", ""], *itertools.chain(*inside), [None, "", "end", []]]


def nested(path, *inside):
    first, _, rest = path.partition("/")
    return section(first, *([nested(rest, *inside)] if rest else inside))


def test_a_zs2_is_read_through_its_library(tmp_path):
    check(read_tensile_test(file(tmp_path, zs2([TEST]), name="tendon.zs2"), **SIZE))


def test_a_zs2_holds_measured_values_in_single_precision(tmp_path):
    test = read_tensile_test(file(tmp_path, zs2([TEST], floats="EE04"), name="tendon.zs2"), **SIZE)
    np.testing.assert_array_equal(test.force, TEST.force.astype(np.float32))


def test_the_specimens_of_a_zs2_are_read_one_by_one(tmp_path):
    path = file(tmp_path, zs2([TEST, TEST]), name="tendon.zs2")
    first, second = read_tensile_tests([path], **SIZE)
    check(first, name="tendon 1")
    check(second, name="tendon 2")
    assert refusal(path, **SIZE) == "need one specimen, got 2: tendon 1, tendon 2"


@pytest.mark.parametrize(
    ("channels", "message"),
    [
        ((("Standard travel", "UT_Displacement"), ("Work", "UT_Energy")), "need a column of force, such as Load"),
        ((("Standard travel", "UT_Displacement"), ("Standard force", "")), "Standard force: the unit is missing; need"),
        ((("Standard travel", "UT_Angle"), ("Standard force", "UT_Force")), 'Standard travel: "UT_Angle" is not its'),
    ],
)
def test_a_zs2_without_force_or_with_an_unknown_unit_is_refused(tmp_path, channels, message):
    assert refusal(file(tmp_path, zs2([TEST], channels=channels), name="tendon.zs2"), **SIZE).startswith(message)


def test_a_zs2_that_is_cut_off_or_something_else_is_refused(tmp_path):
    whole = zs2([TEST])
    assert (
        refusal(file(tmp_path, whole[: len(whole) // 2], name="a.zs2")) == "need a whole .zs2, got one that is cut off"
    )
    cut = gzip.compress(gzip.decompress(whole)[:1000])
    assert "need a whole .zs2" in refusal(file(tmp_path, cut, name="a.zs2"))
    for other in (b"", b"text", gzip.compress(b"text")):
        assert refusal(file(tmp_path, other, name="a.zs2")) == "need a .zs2 of ZwickRoell testXpert, got something else"


@pytest.mark.parametrize("mark", [b"\xaf\xbe\xad\xde", b""])
def test_a_zs2_that_unpacks_to_a_gigabyte_is_refused_without_loading_it(tmp_path, mark):
    path = file(tmp_path, gzip.compress(mark) + 1024 * gzip.compress(bytes(2**20)), name="a.zs2")
    tracemalloc.start()
    try:
        message = refusal(path)
        most = tracemalloc.get_traced_memory()[1]
    finally:
        tracemalloc.stop()
    expected = "need a .zs2 of at most 256 MiB unpacked, got more"
    assert message == (expected if mark else "need a .zs2 of ZwickRoell testXpert, got something else")
    assert most < (2**29 if mark else 2**26)


def test_a_zs2_without_its_library_says_what_to_install(tmp_path, monkeypatch):
    path = file(tmp_path, zs2([TEST]), name="a.zs2")
    monkeypatch.setitem(sys.modules, "zs2decode.parser", None)
    assert refusal(path) == 'a .zs2 file needs zs2decode: pip install "forficula[zs2]"'
