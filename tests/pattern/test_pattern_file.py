import pytest

from forficula.errors import InputError
from forficula.pattern import read_pattern
from tests.pattern.drawings import dxf, dxf_line, line, rim, svg
from tests.pattern.fold_files import written


def test_the_ending_defines_the_format(tmp_path):
    square = [(0, 0, 10, 0), (10, 0, 10, 10), (10, 10, 0, 10), (0, 10, 0, 0)]
    lines = [dxf_line(*ends, (62, 7)) for ends in square]
    files = [
        written(tmp_path / "square.FOLD"),
        svg(tmp_path / "square.svg", rim(), line(20, 20, 80, 80)),
        dxf(tmp_path / "square.DXF", *lines, dxf_line(0, 0, 10, 10, (62, 1))),
    ]
    for file in files:
        pattern, remarks = read_pattern(file)
        assert len(pattern.faces_vertices) == 2
        assert remarks


@pytest.mark.parametrize(
    ("name", "choices", "message"),
    [
        (
            "sheet.obj",
            {},
            r'need a file that ends with one of \.fold \(FOLD\), \.svg \(SVG\), \.dxf \(DXF\), got "\.obj"',
        ),
        ("sheet", {}, 'need a file that ends with one of .*, got ""'),
        ("square.fold", {"tolerance": 1e-3}, "tolerance: need none for a FOLD file"),
        ("square.svg", {"frame": 1}, "frame: need none for a drawing, got 1"),
    ],
)
def test_files_and_options_without_a_reader_are_refused(tmp_path, name, choices, message):
    with pytest.raises(InputError, match=rf"{name}: {message}"):
        read_pattern(tmp_path / name, **choices)
