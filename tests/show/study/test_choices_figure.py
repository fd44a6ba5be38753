"""Choices of planted tables: bars have the lengths of the counts, and undecided points are visible."""

import numpy as np
import pytest
import xarray as xr
from matplotlib.backends.backend_agg import FigureCanvasAgg

from forficula.show.folder.study_folder import study_drawings
from forficula.show.study.choices_figure import draw_choices
from forficula.show.study.maps import map_drawings
from forficula.show.style import COLUMN_WIDTH, PAGE_WIDTH, description
from tests.show.tables import transitions_of_reference

DAMPING = [1e-3, 1e-4, 1e-2, 1e-3, 1e-3]
DIAMETER = [0.005, 0.005, 0.005, 0.003, 0.01]
FOLDS = [4, 6, 0, 2, 3]  # of six wings, for each choice
# in their order from the top
BY_ROW = {"1e-4": 6, "1e-3": 4, "1e-2": 0, "3": 2, "5": 4, "10": 3}


def planted(name="mine", *, verdict="", outcome="", opens=False):
    """Return five choices of two factors with six tendons each; three of the last have a given outcome."""
    dims = ("choice", "tendon_stiffness", "tendon_rest_length")
    folds = np.array([np.arange(6) < count for count in FOLDS]).reshape(5, 2, 3)
    words = np.where(folds, "folded", "did not fold").astype(object)
    verdicts = np.where(folds, "reached", "stuck").astype(object)
    if verdict:
        words[4, 1], verdicts[4, 1] = outcome, verdict
    number = np.where(folds, 0.3, np.nan)
    variables = {
        "least_fold_torque": (dims, number, {"units": "N m"}),
        "fold_work": (dims, 2 * number, {"units": "J"}),
        "folded_by_torque": ((*dims, "fold_torque"), np.stack([np.zeros_like(folds), folds], axis=-1)),
        **dict.fromkeys(("status", "outcome", "fold_outcome"), (dims, words)),
        "verdict": (dims, verdicts),
    }
    if opens:
        variables["least_unfold_torque"] = (dims, np.where(np.arange(6).reshape(2, 3) < 2, number, np.nan))
    coordinates = {
        "choice": ["binder2025", *"abcd"],
        "hinge_damping": ("choice", DAMPING, {"key": "hinge.damping", "units": "N m s/rad"}),
        "vein_diameter": ("choice", DIAMETER, {"key": "vein.diameter", "units": "m", "display": "mm"}),
        "tendon_stiffness": ("tendon_stiffness", [1e3, 2e3], {"key": "tendon.stiffness"}),
        "tendon_rest_length": ("tendon_rest_length", [0.0, 0.03, 0.06], {"key": "tendon.rest_length"}),
    }
    attributes = {"name": name, "design": "binder2025", "ask": "least-torques"}
    return xr.Dataset(variables, coordinates, attributes | transitions_of_reference(opens=opens))


def single(table):
    """Return only the third tendon."""
    return table.isel(tendon_stiffness=0, tendon_rest_length=2, drop=True)


def drawn(figure):
    FigureCanvasAgg(figure).draw()
    return figure


def bars(figure):
    """Return the lengths of the bars by row, by the text beside the row."""
    axes = figure.axes[0]
    rows = {round(tick.get_position()[1], 6): tick.get_text() for tick in axes.get_yticklabels()}
    lengths = {text: [] for text in rows.values()}
    for patch in axes.patches:
        lengths[rows[round(patch.get_y() + patch.get_height() / 2, 6)]].append(patch.get_width())
    return lengths


def words(figure):
    return [text.get_text() for axes in figure.axes for text in axes.texts]


def legend(figure):
    return [text.get_text() for item in figure.legends for text in item.get_texts()]


@pytest.mark.parametrize("width", [COLUMN_WIDTH, PAGE_WIDTH])
def test_every_bar_has_the_length_and_number_of_wings_that_fold(width):
    figure = drawn(draw_choices(planted(), width=width))
    assert {text: lengths[0] for text, lengths in bars(figure).items()} == BY_ROW
    assert words(figure) == [
        *map(str, (6, 4, 0, 2, 4, 3)),
        "hinge damping (N m s/rad)",
        "vein diameter (mm)",
    ]
    assert figure.axes[0].get_xlabel() == "wings that fold, of 6"


def test_the_values_of_the_base_design_are_distinguished_from_changed_ones():
    figure = drawn(draw_choices(planted()))
    bold = [tick.get_text() for tick in figure.axes[0].get_yticklabels() if tick.get_fontweight() == "bold"]
    assert bold == ["1e-3", "5"]
    rows = dict(zip(BY_ROW, (patch.get_facecolor() for patch in figure.axes[0].patches), strict=True))
    assert rows["1e-3"] == rows["5"] != rows["1e-4"] == rows["10"]


@pytest.mark.parametrize(
    ("verdict", "outcome"),
    [
        ("diverged", "diverged"),
        ("untrusted", "unreliable"),
        ("not built", "cannot be built"),
    ],
)
def test_undecided_wings_make_the_count_a_range_and_are_hatched(verdict, outcome):
    figure = drawn(draw_choices(planted(verdict=verdict, outcome=outcome)))
    assert bars(figure)["10"] == [3, 3]
    assert "3 to 6" in words(figure)
    assert legend(figure)[2:] == [outcome]


def test_a_wing_that_is_still_folding_when_its_time_is_over_does_not_fold():
    figure = drawn(draw_choices(planted(verdict="moving", outcome="still folding")))
    assert bars(figure)["10"] == [3]


def test_a_wing_that_folds_counts_even_if_a_smaller_torque_is_untrusted():
    table = planted()
    table["least_fold_torque"][0] = np.nan
    assert bars(drawn(draw_choices(table))) == bars(drawn(draw_choices(planted())))


def test_wings_that_open_again_are_marked_where_opening_was_asked_for():
    without, with_marks = (drawn(draw_choices(planted(opens=opens))) for opens in (False, True))
    assert "open again" not in legend(without)
    marks = [line.get_xdata()[0] for line in with_marks.axes[0].lines if line.get_marker() == "D"]
    assert marks == [2, 2, 0, 2, 2, 2]


def test_the_count_of_the_paper_is_drawn_if_the_study_names_the_paper():
    assert "paper: 32" in legend(drawn(draw_choices(planted().assign_attrs(reproduces="binder2025"))))
    assert "paper: 32" not in legend(drawn(draw_choices(planted("binder2025-choices"))))


def test_single_wings_have_results_or_reasons_for_their_absence():
    figure = drawn(draw_choices(single(planted())))
    assert [axes.get_xlabel() for axes in figure.axes] == ["least fold torque (N cm)", "work of folding (J)"]
    dots = [line.get_xdata()[0] for line in figure.axes[1].lines if line.get_marker() == "o"]
    assert dots == pytest.approx([0.6] * 4)  # in rows: the third wing folds where three do
    assert words(figure).count("did not fold") == 4


def test_nothing_is_written_outside_the_figure():
    for table in (
        planted(),
        single(planted()),
        planted("binder2025-choices", verdict="diverged", outcome="diverged", opens=True),
    ):
        for width in (COLUMN_WIDTH, PAGE_WIDTH):
            figure = drawn(draw_choices(table, width=width))
            renderer = figure.canvas.get_renderer()
            for axes in figure.axes:
                for text in (*axes.texts, *axes.get_yticklabels()):
                    box = text.get_window_extent(renderer)
                    assert box.x0 >= -1
                    assert box.x1 <= figure.bbox.x1 + 1


def test_the_description_of_the_figure_has_every_count():
    text = description(draw_choices(planted()))
    assert text.startswith("Number of 6 wings that fold, with values of binder2025 varied one at a time. ")
    assert "hinge damping (N m s/rad) 1e-2: 0; vein diameter (mm) 3: 2;" in text


def test_maps_are_of_the_grid_around_the_base():
    table = planted()
    assert set(study_drawings(table)) == {"choices", "status", "torques", "works"}
    assert set(study_drawings(single(table))) == {"choices"}
    figure = drawn(map_drawings(table)["torques"](PAGE_WIDTH))
    shown = next(axes for axes in figure.axes if axes.get_title())
    assert (shown.get_xlabel(), shown.get_ylabel()) == ("tendon rest length", "tendon stiffness")
    assert len(shown.texts) == FOLDS[0]
