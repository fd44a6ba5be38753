import numpy as np
import pytest

from forficula.design import load_design
from forficula.make.flat.sheet import cut_sheet
from forficula.show.structure.cut_sheet_figure import draw_cut_sheet
from forficula.show.style import COLUMN_WIDTH, PAGE_WIDTH, description


@pytest.mark.parametrize(("name", "width"), [("kresling-cell", COLUMN_WIDTH), ("binder2025", PAGE_WIDTH)])
def test_a_sheet_is_drawn_to_scale_with_its_layers_and_its_size(name, width):
    sheet = cut_sheet(load_design(name).with_values({"make.crease_style": "perforation"}))
    figure = draw_cut_sheet(sheet, width)
    (axes,) = figure.axes
    assert figure.get_figwidth() == width
    assert axes.get_aspect() == 1
    output = {text.get_text() for text in axes.texts}
    assert {f"{1e3 * length:.1f} mm" for length in sheet.size} <= output
    slits = [line for line in axes.lines if line.get_color() == "#0072B2"]
    assert len(slits) == sum(line.layer == "valley" for line in sheet.lines)
    named = [text.get_text() for text in figure.legends[0].get_texts() if text.get_text() != "fails a check"]
    assert named[:4] == ["sheet", "cut through", "mountain, cut as dashes", "valley, cut as dashes"]
    assert named[4:] == ["join edges with the same number" if sheet.labels else "end of the membrane"]
    # the scale bar has the stated length
    bar = next(line for line in axes.lines if line.get_linewidth() == 2)
    assert f"{np.ptp(bar.get_xdata()):g} mm" in output
    assert description(figure).startswith(f"Sheet to cut of {name}. ")
    assert "kerf of 0.1 mm, creases as perforation" in description(figure)
