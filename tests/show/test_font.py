"""Our letters are those of DejaVu Sans, and a figure with others in it has these, too."""

from importlib.resources import files

import pytest
from fontTools.pens.recordingPen import DecomposingRecordingPen
from fontTools.ttLib import TTFont
from matplotlib import get_data_path
from matplotlib.figure import Figure

from forficula.show.style import figure_style, save_figure

SOURCES = {"ForficulaSans": "DejaVuSans", "ForficulaSans-Bold": "DejaVuSans-Bold"}
NEEDED = "abcxyzABCXYZ0123456789 .,:;()[]%+-−±×·°²³µÅÄÖÜäöüß≤≥≈√∞→ΔΣαβγεθλμπρσφω–—…“”"


def outline(font, letter):
    glyphs = font.getGlyphSet()
    pen = DecomposingRecordingPen(glyphs)
    glyphs[font.getBestCmap()[ord(letter)]].draw(pen)
    return pen.value


@pytest.mark.parametrize("name", SOURCES)
def test_every_letter_that_figures_need_is_the_one_of_dejavu_sans(name):
    ours = TTFont(str(files("forficula.show") / "font" / f"{name}.ttf"))
    source = TTFont(f"{get_data_path()}/fonts/ttf/{SOURCES[name]}.ttf")
    for letter in NEEDED:
        assert outline(ours, letter) == outline(source, letter)
        assert ours["hmtx"][ours.getBestCmap()[ord(letter)]] == source["hmtx"][source.getBestCmap()[ord(letter)]]
    assert ours["OS/2"].fsType == 0  # may be embedded


def test_the_licence_lies_beside_the_letters_and_their_name_is_not_the_one_it_forbids():
    folder = files("forficula.show") / "font"
    assert "Bitstream Vera Fonts Copyright" in (folder / "LICENSE").read_text("utf-8")
    for name in SOURCES:
        names = TTFont(str(folder / f"{name}.ttf"))["name"]
        assert {names.getDebugName(number).split()[0] for number in (1, 4)} == {"Forficula"}


def test_a_pdf_with_a_letter_that_ours_lack_takes_it_from_dejavu_sans(tmp_path):
    with figure_style():
        figure = Figure(figsize=(2, 1))
        figure.text(0.1, 0.5, "Wing ж")
        save_figure(figure, tmp_path / "a.pdf")
    content = (tmp_path / "a.pdf").read_bytes()
    assert b"+ForficulaSans" in content
    assert b"+DejaVuSans" in content
