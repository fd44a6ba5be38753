"""Specimens side by side in one table, and workbooks."""

import io
import sys
import zipfile
from xml.sax.saxutils import escape

import numpy as np
import pytest

from forficula.errors import InputError
from forficula.material.machine.machine_file import read_tensile_tests

SIZE = {"length": 0.06, "area": 5e-6}
HEADER = ["Prüfzeit [s]", "Dehnung [%]", "Kraft [N]"]
LONG = [[0.1 * row, 0.5 * row, 0.25 * row] for row in range(8)]
SHORT = [[0.2 * row, 1.0 * row, 0.75 * row] for row in range(5)]


def beside(first, second, header=HEADER):
    """Two specimens side by side, the second one shorter."""
    blank = [""] * len(second[0])
    return [[*header, *header], *([*row, *(second[n] if n < len(second) else blank)] for n, row in enumerate(first))]


def csv_text(rows):
    return "\n".join(";".join(map(str, row)) for row in rows) + "\n"


def workbook(*sheets):
    """The bytes of an .xlsx with sheets of a title and rows."""

    def cell(value):
        if isinstance(value, str):
            return f'<c t="inlineStr"><is><t>{escape(value)}</t></is></c>' if value else "<c/>"
        return f"<c><v>{value!r}</v></c>"

    main = "http://schemas.openxmlformats.org/spreadsheetml/2006/main"
    office = "http://schemas.openxmlformats.org/officeDocument/2006/relationships"
    package = "http://schemas.openxmlformats.org/package/2006"
    numbers = range(1, len(sheets) + 1)
    names = "".join(f'<sheet name="{sheets[n - 1][0]}" sheetId="{n}" r:id="rId{n}"/>' for n in numbers)
    links = "".join(
        f'<Relationship Id="rId{n}" Type="{office}/worksheet" Target="worksheets/sheet{n}.xml"/>' for n in numbers
    )
    parts = "".join(
        f'<Override PartName="/xl/worksheets/sheet{n}.xml" ContentType="application/vnd.openxmlformats-officedocument'
        f'.spreadsheetml.worksheet+xml"/>'
        for n in numbers
    )
    files = {
        "[Content_Types].xml": f'<Types xmlns="{package}/content-types"><Default Extension="rels" ContentType='
        '"application/vnd.openxmlformats-package.relationships+xml"/><Override PartName="/xl/workbook.xml" ContentType='
        '"application/vnd.openxmlformats-officedocument.spreadsheetml.sheet.main+xml"/>'
        f"{parts}</Types>",
        "_rels/.rels": f'<Relationships xmlns="{package}/relationships"><Relationship Id="rId1" '
        f'Type="{office}/officeDocument" Target="xl/workbook.xml"/></Relationships>',
        "xl/workbook.xml": f'<workbook xmlns="{main}" xmlns:r="{office}"><sheets>{names}</sheets></workbook>',
        "xl/_rels/workbook.xml.rels": f'<Relationships xmlns="{package}/relationships">{links}</Relationships>',
    }
    for number, (_, rows) in enumerate(sheets, start=1):
        body = "".join(f"<row>{''.join(map(cell, row))}</row>" for row in rows)
        files[f"xl/worksheets/sheet{number}.xml"] = (
            f'<worksheet xmlns="{main}"><sheetData>{body}</sheetData></worksheet>'
        )
    content = io.BytesIO()
    with zipfile.ZipFile(content, "w") as archive:
        for name, text in files.items():
            archive.writestr(name, text)
    return content.getvalue()


def check_both(tests):
    assert [test.name for test in tests] == ["series 1", "series 2"]
    for test, rows in zip(tests, (LONG, SHORT), strict=True):
        time, strain, force = np.transpose(rows)
        assert np.allclose(test.time, time)
        assert np.allclose(test.extension, 0.06 * strain / 100)
        assert np.allclose(test.force, force)


def test_specimens_side_by_side_are_read(tmp_path):
    (tmp_path / "series.csv").write_text(csv_text(beside(LONG, SHORT)))
    check_both(read_tensile_tests([tmp_path / "series.csv"], **SIZE))


def test_specimens_side_by_side_may_leave_out_delimiters_and_have_units_below_their_names(tmp_path):
    names, *rows = beside(LONG, SHORT, header=["Prüfzeit", "Dehnung", "Kraft"])
    lines = csv_text([names, ["s", "%", "N"] * 2, *rows]).splitlines()
    (tmp_path / "series.csv").write_text("\n".join(line.rstrip(";") for line in lines))
    check_both(read_tensile_tests([tmp_path / "series.csv"], **SIZE))


def test_specimens_side_by_side_may_share_their_time(tmp_path):
    rows = [[0.1 * n, 0.5 * n, 0.25 * n, 0.5 * n, 0.75 * n] for n in range(8)]
    (tmp_path / "series.csv").write_text(csv_text([[*HEADER, *HEADER[1:]], *rows]))
    first, second = read_tensile_tests([tmp_path / "series.csv"], **SIZE)
    assert np.allclose(first.time, second.time)
    assert np.allclose(3 * first.force, second.force)


def test_a_column_that_is_repeated_alone_is_refused(tmp_path):
    rows = [[0.1 * n, 0.5 * n, 0.25 * n, 0.5 * n] for n in range(8)]
    (tmp_path / "twice.csv").write_text(csv_text([[*HEADER, HEADER[1]], *rows]))
    with pytest.raises(InputError, match='two columns are named "Dehnung"; leave one of them out'):
        read_tensile_tests([tmp_path / "twice.csv"], **SIZE)


def test_a_workbook_is_read_and_sheets_of_results_are_left_out(tmp_path):
    pytest.importorskip("python_calamine")
    results = ("Results", [["Specimen", "Modulus"], ["1", 4.8]])
    (tmp_path / "series.xlsx").write_bytes(workbook(results, ("Curves", beside(LONG, SHORT))))
    check_both(read_tensile_tests([tmp_path / "series.xlsx"], **SIZE))
    sheets = [("one", [HEADER, *LONG]), ("two", [HEADER, *SHORT])]
    (tmp_path / "series.xlsx").write_bytes(workbook(results, *sheets))
    check_both(read_tensile_tests([tmp_path / "series.xlsx"], **SIZE))


@pytest.mark.parametrize(
    ("content", "message"),
    [
        (b"no workbook", "need a workbook"),
        (workbook(("Results", [["a", 1.0]])), "need a sheet with columns of time, travel and force, got Results"),
        (workbook(("Curves", [HEADER, [0.0, "much", 1.0]])), 'sheet "Curves": line 2: need'),
    ],
)
def test_a_workbook_that_cannot_be_used_is_refused(tmp_path, content, message):
    pytest.importorskip("python_calamine")
    (tmp_path / "series.xlsx").write_bytes(content)
    with pytest.raises(InputError, match=message):
        read_tensile_tests([tmp_path / "series.xlsx"], **SIZE)


def test_without_its_library_a_workbook_is_refused_with_what_to_install(tmp_path, monkeypatch):
    monkeypatch.setitem(sys.modules, "python_calamine", None)
    (tmp_path / "series.xlsx").write_bytes(b"")
    with pytest.raises(InputError, match=r'needs python-calamine: pip install "forficula\[xlsx\]"'):
        read_tensile_tests([tmp_path / "series.xlsx"], **SIZE)
