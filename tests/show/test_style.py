"""Figures as files: acceptable to journals, the same bytes each time, with a description."""

import io
import os
import re
import subprocess
import sys
import zlib
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import pytest
from matplotlib import rc_context
from matplotlib.colors import to_rgb
from matplotlib.figure import Figure
from matplotlib.font_manager import findfont
from PIL import Image

from forficula.errors import InputError
from forficula.show.style import (
    COLUMN_WIDTH,
    ENERGY_COLOURS,
    PAGE_WIDTH,
    QUANTITY_COLOURS,
    STRAIN_COLOURS,
    colours_of,
    describe,
    figure_files,
    figure_style,
    save_figure,
    save_figures,
)
from tests.show.legible import colours

PLACE = Path(__file__).parents[2]
TEXT = "Energy & moment <of> a hinge. At most 2 J."


def test_a_matplotlibrc_in_the_working_folder_changes_no_figure(tmp_path):
    strange = {"font.size": 30, "axes.facecolor": "red", "savefig.facecolor": "blue", "path.simplify": False}
    strange |= {"axes.grid": True, "figure.dpi": 37, "lines.linestyle": ":", "xtick.direction": "in"}
    for name, settings in (("plain", {}), ("strange", strange)):
        with rc_context(settings):
            for ending in (".png", ".svg"):
                save_figure(drawn(), tmp_path / f"{name}{ending}")
    for ending in (".png", ".svg"):
        assert (tmp_path / f"plain{ending}").read_bytes() == (tmp_path / f"strange{ending}").read_bytes()


def test_a_matplotlibrc_or_backend_that_cannot_be_read_ends_no_command(tmp_path):
    (tmp_path / "matplotlibrc").write_bytes(b"axes.facecolor: \xff\xfe")
    draws = "from forficula.cli import main\ntry:\n    main(['designs', '--quiet'])\nfinally:\n    import matplotlib"
    command = [sys.executable, "-c", draws]
    ended = subprocess.run(
        command, cwd=tmp_path, env=os.environ | {"MPLBACKEND": "nope"}, capture_output=True, text=True, check=False
    )
    assert (ended.returncode, ended.stderr) == (0, "")


def drawn(width=COLUMN_WIDTH):
    with figure_style():
        figure = Figure(figsize=(width, 2), layout="constrained")
        axes = figure.subplots()
        axes.plot([-1, 1], [0, 1])
        axes.set_xlabel("angle (deg), −1 to 1")
        return describe(figure, TEXT)


@pytest.mark.parametrize("ending", [".png", ".svg", ".pdf"])
def test_the_same_figure_is_the_same_file(tmp_path, ending):
    for name in ("a", "b"):
        save_figure(drawn(), tmp_path / f"{name}{ending}")
    assert (tmp_path / f"a{ending}").read_bytes() == (tmp_path / f"b{ending}").read_bytes()


def test_a_pdf_embeds_its_fonts_as_truetype_and_has_the_text(tmp_path):
    save_figure(drawn(), tmp_path / "a.pdf")
    content = (tmp_path / "a.pdf").read_bytes()
    assert b"/Type3" not in content
    assert b"/FontFile2" in content  # of an embedded TrueType font, ISO 32000-1, table 122
    assert b"/Subject (Energy & moment <of> a hinge. At most 2 J.)" in content
    assert b"/Title (Energy & moment <of> a hinge)" in content
    assert b"/CreationDate" not in content
    box = re.search(rb"/MediaBox \[([^\]]*)\]", content)
    assert box is not None
    assert [float(side) for side in box[1].split()] == pytest.approx([0, 0, 72 * COLUMN_WIDTH, 144])


def test_a_pdf_embeds_only_tables_that_draw_letters(tmp_path):
    from fontTools.ttLib import TTFont

    save_figure(drawn(), tmp_path / "a.pdf")
    content = (tmp_path / "a.pdf").read_bytes()
    streams = (zlib.decompress(part) for part in re.findall(rb"stream\n(.*?)\nendstream", content, re.DOTALL))
    fonts = [TTFont(io.BytesIO(stream)) for stream in streams if stream.startswith(b"\x00\x01\x00\x00")]
    # the minus sign is in a font of its own, because a simple font of a PDF has 256 letters
    assert len(fonts) == 2
    for font in fonts:
        assert {"glyf", "hmtx", "loca"} <= set(font.keys())
        assert not {"GDEF", "GPOS", "GSUB", "MATH", "kern"} & set(font.keys())
    # the kept letters have the outlines of the whole font
    with TTFont(findfont("DejaVu Sans")) as whole:
        for name in ("a", "n", "g", "l", "e", "one"):
            assert max(fonts, key=lambda font: len(font.getGlyphOrder()))["glyf"][name] == whole["glyf"][name]


def test_an_svg_is_as_wide_as_a_column_and_says_what_it_shows(tmp_path):
    save_figure(drawn(), tmp_path / "a.svg")
    root = ElementTree.parse(tmp_path / "a.svg").getroot()
    assert float(root.attrib["width"].removesuffix("pt")) == pytest.approx(72 * COLUMN_WIDTH)
    assert root.attrib["role"] == "img"
    space = "{http://www.w3.org/2000/svg}"
    assert root.findtext(f"{space}title") == "Energy & moment <of> a hinge"
    assert root.findtext(f"{space}desc") == TEXT
    # letters are outlines: a missing font would change their widths
    assert root.find(f".//{space}text") is None


def test_a_png_has_its_text_and_enough_pixels_for_print(tmp_path):
    save_figure(drawn(PAGE_WIDTH), tmp_path / "a.png")
    with Image.open(tmp_path / "a.png") as picture:
        assert picture.info["Description"] == TEXT
        assert picture.size == (1420, 400)  # 200 dots per inch
        assert colours(np.asarray(picture)) > 10


def test_a_figure_without_a_text_can_be_written(tmp_path):
    for ending in (".png", ".svg", ".pdf"):
        save_figure(Figure(figsize=(1, 1)), tmp_path / f"a{ending}")


def test_another_ending_is_refused(tmp_path):
    with pytest.raises(InputError, match=r"a\.eps: need a file that ends with \.png, \.svg or \.pdf"):
        save_figure(drawn(), tmp_path / "a.eps")
    assert not list(tmp_path.iterdir())


def test_every_figure_is_left_for_the_screen_at_page_width_and_for_papers_at_column_width(tmp_path):
    widths = []

    def draw(width):
        widths.append(width)
        return drawn(width)

    save_figures({"energy": draw}, tmp_path)
    assert widths == [PAGE_WIDTH, COLUMN_WIDTH]
    files = {path.relative_to(tmp_path).as_posix() for path in tmp_path.rglob("*") if path.is_file()}
    assert files == set(figure_files("energy")) == {"energy.png", "figures/energy.svg", "figures/energy.pdf"}
    assert 'width="252pt"' in (tmp_path / "figures" / "energy.svg").read_text("utf-8")


@pytest.mark.parametrize(
    ("name", "colours"), [("ENERGY", ENERGY_COLOURS), ("QUANTITY", QUANTITY_COLOURS), ("STRAIN", STRAIN_COLOURS)]
)
def test_figures_films_and_pages_show_a_quantity_in_the_same_colours(name, colours):
    scheme = (PLACE / "web" / "src" / "scheme.js").read_text("utf-8")
    of_page = re.findall(r"#[0-9a-f]{6}", scheme[scheme.index(f"const {name} = ") :].partition(";")[0])
    of_figures = colours(np.linspace(0, 1, len(of_page)))[:, :3]
    assert of_figures == pytest.approx(np.array([to_rgb(colour) for colour in of_page]), abs=0.01)


def test_the_colours_of_quantities_are_chosen_in_one_place():
    """Another module that selects a colour map by name could draw an energy in any colours."""
    chosen = re.compile(r"colormaps|get_cmap|cmap=\s*[\"']|[\"'](viridis|cividis|plasma|inferno|magma)[\"']")
    result = {path.name for path in (PLACE / "src").rglob("*.py") if chosen.search(path.read_text("utf-8"))}
    assert result == {"style.py"}
    assert colours_of("J") is ENERGY_COLOURS
    assert colours_of("N m") is colours_of("s") is QUANTITY_COLOURS
