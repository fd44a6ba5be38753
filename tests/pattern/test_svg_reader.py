import math

import numpy as np
import pytest

from forficula.errors import InputError
from forficula.pattern import read_drawing
from tests.pattern.drawings import line, read, rim, svg

CREASE = 'x1="50" y1="20" x2="50" y2="80"'


def crease(path, text):
    """Letter and fold angle, deg, of the one crease of a drawing."""
    pattern, _ = read(path, text)
    ((letter, angle),) = (
        (letter, angle)
        for letter, angle in zip(pattern.edges_assignment, pattern.edges_fold_angle.tolist(), strict=True)
        if letter != "B"
    )
    return letter, pytest.approx(math.degrees(angle), nan_ok=True)


@pytest.mark.parametrize(
    ("stroke", "letter"),
    [
        ("red", "M"),
        ("#ED1C24", "M"),
        ("rgb(100%, 0%, 0%)", "M"),
        ("blue", "V"),
        ("#2E3192", "V"),
        ("rgb(0 0 255)", "V"),
        ("green", "C"),
        ("#0f0", "C"),
        ("yellow", "F"),
        ("#888", "F"),
        ("lightgray", "F"),
        ("magenta", "U"),
        ("#231F20", "C"),  # black within a sheet
    ],
)
def test_colours_are_read_as_origami_programs_mean_them(tmp_path, stroke, letter):
    beside = line(35, 20, 35, 80, "orange", 'data-assignment="U"') + line(65, 20, 65, 80, "#f0f")
    pattern, _ = read(tmp_path, beside, f'<line {CREASE} stroke="{stroke}"/>')
    assert next(edge for edge in reversed(pattern.edges_assignment) if edge != "B") == letter


@pytest.mark.parametrize(
    ("text", "letter", "angle"),
    [
        (f'<line {CREASE} stroke="red" opacity="0.5"/>', "M", -90),
        (f'<line {CREASE} stroke="blue" stroke-opacity="25%"/>', "V", 45),
        (f'<g opacity=".5"><g opacity="0.5"><line {CREASE} stroke="blue" stroke-opacity="0.5"/></g></g>', "V", 22.5),
        (f'<line {CREASE} style="stroke: rgba(255,0,0,0.5); opacity:1"/>', "M", -90),
        (f'<line {CREASE} stroke="#0000ff80"/>', "V", 180 * 128 / 255),
        (f'<line {CREASE} stroke="red" opacity="0"/>', "M", 0),
        (f'<g stroke="blue"><line {CREASE}/></g>', "V", 180),
        (f'<g style="stroke:blue"><line {CREASE} stroke="red"/></g>', "M", -180),
        (f'<style>.a{{stroke:#00f}} /* x */ .b, line.c {{opacity:.5}}</style><line class="a c" {CREASE}/>', "V", 90),
        (f'<style>#k{{stroke:red}}line{{stroke:blue}}</style><line id="k" {CREASE}/>', "M", -180),
        (f'<style>line{{stroke:blue}}</style><line style="stroke:red" stroke="green" {CREASE}/>', "M", -180),
        (f'<line data-assignment="V" data-foldAngle="30" stroke="black" {CREASE}/>', "V", 30),
        (f'<g id="Valley_folds_1_"><g><line stroke="black" {CREASE}/></g></g>', "V", 180),
        (f'<g id="b"><line stroke="red" {CREASE}/></g>', "M", -180),
        (f'<g class="m" id="cls"><line stroke="blue" {CREASE}/></g>', "V", 180),
        (
            f'<g xmlns:i="http://www.inkscape.org/namespaces/inkscape" i:label="M"><line stroke="#333" {CREASE}/></g>',
            "M",
            -180,
        ),
        (f'<line {CREASE} stroke="#f0f" opacity=".5"/>', "U", math.nan),
    ],
)
def test_styles_groups_and_data_define_the_kind_of_a_line(tmp_path, text, letter, angle):
    assert crease(tmp_path, text) == (letter, angle)


@pytest.mark.parametrize(
    "text",
    [
        '<path d="M50 20V80" stroke="red"/>',
        '<path d="m50,20 0,60" stroke="red"/>',
        '<path d="M50 80l0-6e1z" stroke="red"/>',
        '<path d="M10 10m40 10v30M50 80L50 50" stroke="red"/>',
        '<path d="M.5e2 20 50 40 50 80" stroke="red"/>',
        '<polyline points="50,20 50,40,50 80" stroke="red"/>',
        '<polyline points="50 20.0.0.0" stroke="none"/><line x1="50" y1="20" x2="50px" y2="80" stroke="red"/>',
        '<g transform="translate(50)"><path d="M0 20V80" stroke="red"/></g>',
        '<g transform="translate(10, 10) scale(2)"><line x1="20" y1="5" x2="20" y2="35" stroke="red"/></g>',
        '<line x1="20" y1="-50" x2="80" y2="-50" transform="rotate(90)" stroke="red"/>',
        '<line x1="20" y1="50" x2="80" y2="50" transform="rotate(-90 50,50)" stroke="red"/>',
        '<line x1="30" y1="20" x2="-30" y2="80" transform="skewX(45)" stroke="red"/>',
        '<line x1="50" y1="-30" x2="50" y2="30" transform="skewY(45)" stroke="red"/>',
        '<line x1="0" y1="0" x2="1" y2="0" transform="matrix(0 60 1 0 50 20)" stroke="red"/>',
        '<defs><path d="M0 0C1 1 2 2 3 3" stroke="red"/></defs><path d="M50 20V80" stroke="red"/>',
        '<circle r="9"/><text x="9">M</text><path d="M50 20V80" stroke="red"/><circle r="9" stroke="none"/>',
        '<line x1="9" x2="99" stroke="red" display="none"/><path d="M50 20V80" stroke="red"/>',
        '<g visibility="hidden"><line x1="9" x2="99" stroke="red"/></g><path d="M50 20V80" stroke="red"/>',
        '<circle r="9" stroke="cyan"/><path d="M50 20V80" stroke="red"/>',
    ],
)
def test_every_way_to_draw_a_straight_line_gives_the_same_sheet(tmp_path, text):
    pattern, _ = read(tmp_path, text)
    creases = pattern.edges_vertices[np.array(pattern.edges_assignment) == "M"]
    assert set(pattern.edges_assignment) == {"B", "M"}
    np.testing.assert_allclose(pattern.vertices_coords[creases, 0], 0.03, rtol=0, atol=1e-12)
    assert np.ptp(pattern.vertices_coords[creases, 1]) == pytest.approx(0.06)
    assert len(pattern.faces_vertices) == 2


@pytest.mark.parametrize(
    ("head", "side"),
    [
        ('width="100mm" height="100mm" viewBox="0 0 100 100"', 60e-3),
        ('width="10cm" height="10cm" viewBox="0 0 200 200"', 30e-3),
        ('width="4in" height="8in" viewBox="0 0 100 100"', 0.6 * 4 * 0.0254),
        ('width="100" height="100px"', 60 * 0.0254 / 96),
        ('width="200px" viewBox="0 0 100 100"', 120 * 0.0254 / 96),
        ('viewBox="0,0,10,10" width="72pt" height="72pt"', 6 * 0.0254),
        ("", 60 * 0.0254 / 96),
    ],
)
def test_the_page_size_defines_the_unit(tmp_path, head, side):
    pattern, remarks = read_drawing(svg(tmp_path / "sheet.svg", rim(), line(50, 20, 50, 80), head=head))
    assert np.ptp(pattern.vertices_coords, axis=0) == pytest.approx([side, side, 0], rel=1e-12)
    assumed = "the file gives its size in pixels: taken as 1/96 inch, as no unit is given"
    assert (assumed in remarks) == ("px" in head or not head)


def test_a_given_unit_takes_precedence_over_pixels(tmp_path):
    path = svg(
        tmp_path / "sheet.svg", rim(), line(50, 20, 50, 80), head='width="100" height="100" viewBox="0 0 100 100"'
    )
    assert np.ptp(read_drawing(path, unit=1e-3)[0].vertices_coords[:, 0]) == pytest.approx(0.06)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        (
            '<path id="p" d="M0 0C1 1 2 2 3 3" stroke="red"/>',
            r'path 1 \(id "p"\): d: need straight .* got a curve \("C"\)',
        ),
        (
            '<path d="M0 0A1 1 0 0 0 2 2" stroke="red"/>',
            r'path 1: d: need straight lines .*, got a curve \("A"\)',
        ),
        ('<path d="M0 0L1" stroke="red"/>', 'path 1: d: need 2 numbers a point after "L", got 1'),
        ('<path d="M0 0L1e999 0" stroke="red"/>', "path 1: d: need finite numbers, got 1e999"),
        ('<circle r="9" stroke="red"/>', "circle 1: need straight lines, got a curve; draw it as short straight lines"),
        ('<rect width="9" height="9" rx="1" stroke="red"/>', "rect 2: need straight lines, got .* round corners"),
        ('<use href="#a"/>', "use 1: need lines themselves, got a copy; unlink"),
        ('<svg><line x2="9" stroke="red"/></svg>', "svg 1: need lines themselves, got a drawing in the drawing"),
        ('<line x1="a" stroke="red"/>', 'line 1: x1: need a number, got "a"'),
        ('<line x2="9" stroke="red" transform="turn(9)"/>', r'line 1: transform: need translate, .*, got "turn\(9\)"'),
        ('<line x2="9" stroke="red" transform="rotate(1 2)"/>', r'line 1: transform: need .*, got "rotate\(1 2\)"'),
        ('<g id="k" transform="x"><line x2="9" stroke="red"/></g>', 'g "k": transform: need translate, .*, got "x"'),
        (
            f'<line data-foldAngle="30" stroke="red" {CREASE}/>',
            'line 1: data-foldAngle: need -1 times 0 to 180 deg, got "30"',
        ),
    ],
)
def test_elements_other_than_straight_lines_are_refused_by_name(tmp_path, text, message):
    with pytest.raises(InputError, match=rf"sheet\.svg: {message}") as refusal:
        read(tmp_path, text)
    assert "\n" not in str(refusal.value)


@pytest.mark.parametrize(
    ("content", "message"),
    [
        ("<svg", "need XML, as SVG files are: unclosed token"),
        ('<?xml version="1.0" encoding="utf-9"?><svg/>', "need XML, as SVG files are: unknown encoding"),
        ("<html/>", "need an SVG drawing, got XML of <html>"),
        ('<svg xmlns="http://www.w3.org/2000/svg"/>', "need lines in red .*, got none"),
    ],
)
def test_an_invalid_svg_file_is_refused(tmp_path, content, message):
    (tmp_path / "sheet.svg").write_text(content, encoding="utf-8")
    with pytest.raises(InputError, match=rf"sheet\.svg: {message}"):
        read_drawing(tmp_path / "sheet.svg")
    with pytest.raises(InputError, match=r"none\.svg: no such file"):
        read_drawing(tmp_path / "none.svg")


def test_groups_nested_too_deeply_are_refused(tmp_path):
    path = svg(tmp_path / "deep.svg", "<g>" * 5000, rim(), "</g>" * 5000)
    with pytest.raises(InputError, match="need groups nested less deeply"):
        read_drawing(path, 1e-3)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        (
            '<polygon points="0,0 NaN,0 100,100 0,100" stroke="black"/>',
            'polygon 1: points: need numbers, got "NaN"',
        ),
        ('<polyline points="0,0 100%,0" stroke="red"/>', 'polyline 1: points: need numbers, got "100%"'),
        ('<polyline points="0,0 50mm,0" stroke="red"/>', 'polyline 1: points: need numbers, got "50mm"'),
        ('<polyline points="0,0 ,,5 9,9" stroke="red"/>', "polyline 1: points: need a number before every comma"),
        ('<polyline points="0,0 5 9,9" stroke="red"/>', "polyline 1: points: need two numbers for every point, got 5"),
        ('<path d="M0 20 L 50 # 20" stroke="red"/>', 'path 1: d: need numbers, got "#"'),
        ('<path d="M0 20 L 50% 20" stroke="red"/>', 'path 1: d: need numbers, got "50%"'),
        ('<path d="9 9 M0 20 L 50 20" stroke="red"/>', "path 1: d: need a path that begins with M"),
        ('<path d="M0 20 L 50,,20" stroke="red"/>', "path 1: d: need a number before every comma"),
        ('<g transform="scale(2 %)"><path d="M0 0L1 1" stroke="red"/></g>', 'g "": transform: need numbers, got "%"'),
        (
            '<g transform="scale(1e308)"><g transform="scale(1e308)"><path d="M0 0L1 1" stroke="red"/></g></g>',
            "path 1: transform: need coordinates that are finite numbers, got",
        ),
    ],
)
def test_text_between_the_numbers_of_a_drawing_is_refused_and_not_left_out(tmp_path, text, message):
    with pytest.raises(InputError, match=rf"sheet\.svg: {message}"):
        read(tmp_path, text)


def test_numbers_need_no_space_before_a_sign_or_a_decimal_point(tmp_path):
    pattern, _ = read(tmp_path, '<path d="M50,20l0+60" stroke="red"/>')
    tight, _ = read(tmp_path, '<path d="M5e1 .2e2V80.0" stroke="red"/>')
    assert np.array_equal(pattern.vertices_coords, tight.vertices_coords)


@pytest.mark.parametrize(
    ("fit", "width", "height"),
    [
        ("", 5, 5),
        ('preserveAspectRatio="xMinYMax"', 5, 5),
        ('preserveAspectRatio="xMidYMid meet"', 5, 5),
        ('preserveAspectRatio="none"', 10, 5),
        ('preserveAspectRatio="defer none slice"', 10, 5),
        ('preserveAspectRatio="xMidYMid slice"', 10, 10),
        ('preserveAspectRatio="none" transform="rotate(90)"', 5, 10),
    ],
)
def test_preserve_aspect_ratio_scales_the_drawing(tmp_path, fit, width, height):
    head = f'width="10cm" height="10cm" viewBox="0 0 100 200" {fit}'
    pattern, _ = read_drawing(svg(tmp_path / "sheet.svg", '<rect width="100" height="100" stroke="black"/>', head=head))
    assert np.ptp(pattern.vertices_coords, axis=0)[:2] * 100 == pytest.approx([width, height])


@pytest.mark.parametrize(
    ("head", "message"),
    [
        ('preserveAspectRatio="fill"', 'preserveAspectRatio: need none, or an alignment .*, got "fill"'),
        ('preserveAspectRatio="none stretch"', "preserveAspectRatio: need none"),
        ('viewBox="0 0 100%  100"', 'viewBox: need numbers, got "100%"'),
        ('viewBox="0 0 100"', "viewBox: need four numbers, the last two > 0, got"),
        ('viewBox="0 0 0 100"', "viewBox: need four numbers, the last two > 0, got"),
    ],
)
def test_an_invalid_page_size_is_refused(tmp_path, head, message):
    box = "" if "viewBox" in head else 'viewBox="0 0 100 200"'
    with pytest.raises(InputError, match=message):
        read_drawing(svg(tmp_path / "sheet.svg", rim(), head=f'width="10cm" height="10cm" {box} {head}'))


@pytest.mark.parametrize(
    ("text", "size"),
    [
        ('<g style="transform:scale(2)">{}</g>', (20, 20)),
        ('<g style="transform: scaleX(2) translate(3px, 0)">{}</g>', (20, 10)),
        ('<g transform="scale(3)" style="transform:scale(1, 2)">{}</g>', (10, 20)),
        ('<g transform="scale(3)" style="transform:none">{}</g>', (10, 10)),
        ('<style>.a{{transform:scaleY(2) rotate(0.25turn)}}</style><g class="a">{}</g>', (10, 20)),
        ('<g style="transform:matrix(2,0,0,1,0,0)" transform-origin="0 0">{}</g>', (20, 10)),
    ],
)
def test_a_transform_in_the_style_acts_as_in_browsers(tmp_path, text, size):
    square = '<rect width="100" height="100" stroke="black"/>'
    head = 'width="10cm" height="10cm" viewBox="0 0 100 100"'
    pattern, _ = read_drawing(svg(tmp_path / "sheet.svg", text.format(square), head=head))
    assert np.ptp(pattern.vertices_coords, axis=0)[:2] * 100 == pytest.approx(size)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ('<g style="transform:rotate3d(1,0,0,9deg)">{}</g>', "transform: need translate, .*, got .rotate3d"),
        ('<g style="transform:translate(50%,0)">{}</g>', "transform: need translate, .*, got .translate"),
        ('<g style="transform:scale(2);transform-origin:center">{}</g>', "transform-origin: need 0 0, got .center"),
        ('<g transform="scale(2)" transform-origin="5 5">{}</g>', "transform-origin: need 0 0, got .5 5"),
        ('<g style="scale:2">{}</g>', "scale: need transform instead, got .2. in the style"),
        ("<style>g > rect{{transform:scale(2)}}</style>{}", "style: need a transform on the element itself, got one"),
    ],
)
def test_unsupported_css_that_moves_an_element_is_refused(tmp_path, text, message):
    with pytest.raises(InputError, match=message):
        read_drawing(svg(tmp_path / "sheet.svg", text.format('<rect width="9" height="9" stroke="black"/>')))
