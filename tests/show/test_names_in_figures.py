"""Names given by a user are displayed unchanged, even if they mean something to TeX."""

import pytest
from matplotlib.text import Text

import forficula as ff
from forficula.design import with_values
from forficula.show import draw_angles, write_run

NAMES = ["$\\frac{", "a$_b^{$", "\\$ & < _x"]


@pytest.mark.usefixtures("no_column_figures")
def test_a_run_whose_names_are_broken_tex_is_kept_and_drawn_with_these_names(tmp_path):
    stage = {"drive": "none", "until": "time", "hold": 0.0, "time_limit": 0.01}
    drives = ("none", "fold", "unfold")
    stages = [{**stage, "drive": drive, "name": name} for drive, name in zip(drives, NAMES, strict=True)]
    design = with_values(ff.load_design("binder2025"), {"name": "$^{", "protocol.stages": stages})
    record = ff.run(design, confirm=False)
    outcome = ff.measure(record)
    write_run(record, outcome, tmp_path, engine=False)
    assert {"angles.png", "energy.png", "folding.png", "summary.json"} < {path.name for path in tmp_path.iterdir()}
    texts = draw_angles(record, outcome).findobj(Text)
    assert set(NAMES[1:]) <= {text.get_text() for text in texts}
    assert not any(text.get_parse_math() for text in texts if text.get_text())
