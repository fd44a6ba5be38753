import itertools
import math
import re
from dataclasses import replace

import numpy as np
import pytest
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.lines import Line2D

from forficula.errors import InputError
from forficula.show.folder.landscape_folder import landscape_drawings
from forficula.show.landscape.barriers_figure import draw_barriers
from forficula.show.landscape.equilibria_figure import draw_equilibria
from forficula.show.landscape.landscape_figure import draw_fold_path
from forficula.show.landscape.levels_figure import draw_levels
from forficula.show.landscape.tendon_figure import draw_tendon
from forficula.show.style import COLUMN_WIDTH, PAGE_WIDTH
from forficula.statics.friction import FrictionBand
from tests.show.legible import check_words

# the reference is drawn by tests of words at every width
NAMES = (
    "small",
    "without rest length",
    "without hub",
    "without overbend",
    "slack",
    "without stiffness",
    "off the bars",
    "beyond the stop",
    "own tendons",
    "plates",
    "soft plates",
)


def pixels(figure):
    canvas = FigureCanvasAgg(figure)
    canvas.draw()
    return np.asarray(canvas.buffer_rgba())[..., :3]


def texts(figure):
    return " ".join(text.get_text().replace("\n", " ") for axes in all_axes(figure) for text in axes.texts)


def all_axes(figure):
    return [axis for axes in figure.axes for axis in (axes, *axes.child_axes)]


def labelled(figure, start) -> Line2D:
    return next(line for axes in figure.axes for line in axes.lines if str(line.get_label()).startswith(start))


@pytest.mark.parametrize("name", NAMES)
def test_every_landscape_can_be_drawn_with_units_on_its_axes(surveyed, name):
    units = ("(J)", "(mJ)", "(µJ)", "(nJ)", "(deg)", "N cm)")
    for draw in landscape_drawings(surveyed(name)).values():
        figure = draw(PAGE_WIDTH)
        check_words(figure, PAGE_WIDTH)
        for axes in all_axes(figure):
            assert not axes.get_ylabel() or axes.get_ylabel().endswith(units)
            words = ("deg", "hinges", "left to right")
            assert not axes.get_xlabel() or any(word in axes.get_xlabel() for word in words)
            bounds = [*axes.get_xlim(), *axes.get_ylim()]
            assert np.all(np.isfinite(bounds))


def test_the_energy_drawn_is_the_integral_of_the_moment_drawn_under_it(surveyed):
    figure = draw_tendon(surveyed("reference"))
    top, bottom, *_ = figure.axes
    energy, moment = (
        next(line for line in axes.lines if len(line.get_xdata()) > 60 and line.get_linestyle() == "-")
        for axes in (top, bottom)
    )
    assert (top.get_ylabel(), "(N cm)" in bottom.get_ylabel()) == ("tendon energy (J)", True)
    angle = np.radians(energy.get_xdata())
    fall = np.trapezoid(moment.get_ydata() / 100, angle)  # the moment is in N cm
    # the moment is - d energy / d angle; trapezoids of 3 deg err by about (3 deg)^2 / 12
    assert energy.get_ydata()[0] - energy.get_ydata()[-1] == pytest.approx(fall, rel=3e-3)


def test_the_simulated_tendon_lies_on_the_closed_form_folding_and_opening(surveyed, reference_run):
    figure = draw_tendon(surveyed("reference"), reference_run)
    hinge = surveyed("reference").tendons[1].hinge
    for name in ("simulated, folding", "simulated, opening"):
        points = labelled(figure, name)
        angle = np.radians(points.get_xdata())
        inside = (angle > -math.pi) & (angle < math.pi)
        # the engine's tendon is the same spring, so only rounding errors differ
        assert points.get_ydata()[inside] == pytest.approx(hinge.energy(angle[inside]), abs=1e-9)
        assert np.ptp(points.get_xdata()) > 120


def test_a_missing_simulation_is_not_in_the_legend(surveyed):
    legend = draw_tendon(surveyed("reference"), width=COLUMN_WIDTH).legends[0]
    assert not [text.get_text() for text in legend.get_texts() if "simulated" in text.get_text()]


def test_a_missing_barrier_is_explained_by_a_sentence(surveyed):
    assert "slack at every angle" in texts(draw_tendon(surveyed("slack")))
    assert "slack at every angle" in texts(draw_fold_path(surveyed("slack")))
    assert "no stiffness" in texts(draw_tendon(surveyed("without stiffness")))
    assert "overbend is 0 deg" in texts(draw_tendon(surveyed("without overbend")))
    assert "hub_radius is 0" in texts(draw_fold_path(surveyed("without hub")))


def test_the_barrier_close_up_has_its_height(surveyed):
    landscape = surveyed("reference")
    assert f"barrier {1e3 * landscape.tendons[1].barrier:.4g} mJ" in texts(draw_tendon(landscape))
    assert f"barrier {1e3 * landscape.fold_barrier:.4g} mJ" in texts(draw_fold_path(landscape))


@pytest.mark.parametrize("width", [COLUMN_WIDTH, PAGE_WIDTH])
def test_the_enlarged_barrier_covers_no_other_panel(surveyed, width):
    for name in ("reference", "plates", "off the bars"):
        figure = draw_tendon(surveyed(name), width=width)
        pixels(figure)
        panels = [axes.get_window_extent() for axes in figure.axes[:3]]
        assert not any(one.overlaps(other) for one, other in itertools.combinations(panels, 2))
        letters = [text.get_text() for axes in figure.axes for text in axes.texts if text.get_weight() == "bold"]
        assert letters == ["A", "B", "C"]


def test_the_ring_axis_stands_where_the_ring_creases_have_that_angle(surveyed):
    figure = draw_fold_path(surveyed("reference"))
    above = next(axes for axes in figure.axes if "ring" in axes.get_xlabel())
    fan = surveyed("reference").design.fan
    ratio = math.sin(fan.epsilon) / math.cos(fan.sector_angle / 2)
    for place, text in zip(above.get_xticks(), above.get_xticklabels(), strict=True):
        ring = math.radians(float(text.get_text().replace("−", "-")))
        if ring < math.radians(179):
            # tan(ring / 2) = m tan(pleat / 2) (docs/model/theory.md, section "Fan pattern"); the axis is interpolated
            # between its ticks
            assert math.tan(ring / 2) == pytest.approx(ratio * math.tan(math.radians(place) / 2), rel=0.02, abs=1e-9)


@pytest.mark.parametrize("width", [COLUMN_WIDTH, PAGE_WIDTH])
def test_a_dot_on_the_moment_is_labelled_with_the_moment_that_it_marks(surveyed, width):
    landscape = surveyed("reference")
    axes = next(axes for axes in draw_fold_path(landscape, width).axes if "moment" in axes.get_ylabel())
    dots = [float(line.get_ydata()[0]) for line in axes.lines if line.get_marker() == "o"]
    labels = [text.get_text() for text in axes.texts if "requires" in text.get_text()]
    marked = [float(re.search(r"requires ([\d.]+) N cm:", label)[1]) for label in labels]
    assert marked == pytest.approx(np.abs(dots), rel=5e-3)


def test_every_partly_folded_state_has_a_bar_that_ends_at_its_energy(surveyed):
    landscape = surveyed("without rest length")
    top, bottom = draw_levels(landscape).axes
    tops = [bar.get_y() + bar.get_height() for bar in top.patches[1::2]]
    assert tops == pytest.approx([fold.energy for fold in landscape.partial_folds])
    dark = [line for line in bottom.lines if line.get_color() == "0.15"]
    # every vein is folded in half of the eight states
    assert sum(len(line.get_xdata()) for line in dark) == 12


@pytest.mark.parametrize("name", ["off the bars", "beyond the stop", "own tendons", "plates", "soft plates"])
def test_all_words_of_the_figures_of_any_structure_can_be_read_in_a_column(surveyed, name):
    for draw in landscape_drawings(surveyed(name)).values():
        check_words(draw(COLUMN_WIDTH), COLUMN_WIDTH)


def test_a_barrier_beside_straight_is_drawn_at_its_own_angle(surveyed):
    landscape = surveyed("off the bars")
    figure = draw_tendon(landscape)
    near = figure.axes[2]
    (arrow,) = [text for text in near.texts if text.get_text() == ""]
    hinge = landscape.tendons[1]
    assert arrow.xy == (pytest.approx(math.degrees(hinge.barrier_angle)), pytest.approx(1e3 * hinge.barrier))
    assert math.degrees(hinge.barrier_angle) < -4
    for line in [line for line in near.lines if len(line.get_xdata()) > 60]:
        # both tops are within what is shown, and the stop is its zero
        assert max(line.get_ydata()) > 0
        assert min(near.get_xlim()) < line.get_xdata()[np.argmax(line.get_ydata())] < max(near.get_xlim())
    assert "is not beyond it, so there is no barrier" in texts(draw_tendon(surveyed("beyond the stop")))


def test_a_vein_without_a_tendon_has_no_curve_and_the_others_have_one_each(surveyed):
    landscape = surveyed("own tendons")
    figure = draw_tendon(landscape)
    names = [str(line.get_label()) for line in figure.axes[0].lines if "hinge of the wing" in str(line.get_label())]
    assert names == [f"hinge of the wing, its ring crease (vein {vein})" for vein in (0, 2)]
    # every state has its own level of independent hinges, for any set of folded hinges
    top, bottom = draw_levels(landscape).axes
    dashed = [line.get_ydata()[0] for line in top.lines if line.get_linestyle() == "--"]
    assert sorted(dashed) == pytest.approx(sorted(fold.independent_energy for fold in landscape.partial_folds))
    assert [label.get_text() for label in bottom.get_yticklabels()] == ["vein 0", "vein 1", "vein 2"]


def test_a_hinge_with_a_spring_is_drawn_with_it_in_its_own_sense(surveyed):
    figure = draw_tendon(surveyed("plates"))
    top, bottom, *_ = figure.axes
    tendon, spring, both = (labelled(figure, name) for name in ("tendon (", "spring of", "tendon and"))
    assert both.get_ydata() == pytest.approx(tendon.get_ydata() + spring.get_ydata())
    # it folds to positive angles, and its spring (0.02 N m/rad/m times 21 cm) is at rest when flat
    angle = np.radians(spring.get_xdata())
    assert (math.degrees(angle.min()), math.degrees(angle.max())) == pytest.approx((-3, 175))
    assert spring.get_ydata() == pytest.approx(1e3 * 0.02 * 0.21 / 2 * angle**2)
    moment = next(line for line in bottom.lines if line.get_color() == both.get_color() and len(line.get_xdata()) > 60)
    # the moment is in N cm and opens where positive: d energy / d angle for a hinge that folds to positive angles
    fall = np.trapezoid(moment.get_ydata() / 100, np.radians(moment.get_xdata()))
    assert both.get_ydata()[-1] - both.get_ydata()[0] == pytest.approx(1e3 * fall, rel=3e-3)
    assert top.get_ylabel() == "stored energy (mJ)"


def test_a_simulated_hinge_with_a_spring_is_on_the_line_of_the_sum(surveyed, letter_run):
    landscape = surveyed("plates")
    figure = draw_tendon(landscape, letter_run)
    both = labelled(figure, "tendon and")
    for name in ("simulated, folding", "simulated, opening"):
        points = labelled(figure, name)
        expected = np.interp(points.get_xdata(), both.get_xdata(), both.get_ydata())
        assert points.get_ydata() == pytest.approx(expected, abs=0.02 * both.get_ydata().max())
    words = [axes.get_xlabel() for axes in (figure.axes[1], draw_levels(landscape).axes[-1])]
    assert not any("overbend" in text for text in words)
    assert all("back bend" in text for text in words)


def test_equilibria_of_plates_are_drawn_with_stored_energies_and_angles(surveyed):
    landscape = surveyed("plates")
    top, bottom = draw_equilibria(landscape).axes
    assert [label.get_text() for label in bottom.get_xticklabels()] == ["flat", "closed", "opened\n(as flat)"]
    heights = [bar.get_height() for bar in top.patches]
    stored = [1e3 * energy for rest in landscape.rests for energy in rest.stored.values()]
    assert heights == pytest.approx(stored)
    for rest in landscape.rests:
        assert sum(rest.stored.values()) == pytest.approx(rest.energy)
    drawn = np.array([line.get_ydata() for line in bottom.lines if line.get_marker() == "o"])
    np.testing.assert_allclose(drawn.T, np.degrees([rest.angles for rest in landscape.rests]), rtol=1e-12)
    words = " ".join(text.get_text().replace("\n", " ") for text in top.texts)
    assert f"close {100 * landscape.least_torques['close']:.3g} N cm" in words


def test_angles_at_which_dry_friction_holds_a_hinge_are_drawn_as_a_band_in_their_state(surveyed):
    landscape = surveyed("plates")
    hinge = landscape.structure.hinges[0].name
    band = FrictionBand(state="closed", hinge=hinge, lower=math.radians(80), upper=math.radians(110))
    figure = draw_equilibria(replace(landscape, friction_bands=(band,)))
    segments = [lines.get_segments() for lines in figure.axes[1].collections]
    lengths = np.array([[np.ptp(segment[:, 1]) for segment in state] for state in segments])
    np.testing.assert_allclose(lengths, [[0, 30, 0], [0, 0, 0]], atol=1e-9)
    assert "held by dry friction" in [text.get_text() for text in figure.legends[0].get_texts()]


def test_rounding_is_not_drawn_as_energies_and_angles(surveyed):
    top, bottom = draw_equilibria(surveyed("plates without tendons")).axes
    assert [bar.get_height() for bar in top.patches] == [0, 0, 0]
    assert (top.get_ylim(), np.ptp(bottom.get_ylim())) == ((0, 1), pytest.approx(1))


def test_figures_without_contents_are_left_out(surveyed):
    assert list(landscape_drawings(surveyed("reference"))) == ["tendon", "wing", "levels"]
    assert list(landscape_drawings(surveyed("plates"))) == ["tendon", "rests", "levels"]
    with pytest.raises(InputError, match="letter-fold: has no single folding path"):
        draw_fold_path(surveyed("plates"))


def test_a_small_wing_is_drawn_in_small_units(surveyed):
    assert draw_tendon(surveyed("small")).axes[0].get_ylabel() == "tendon energy (µJ)"


def test_the_figure_of_barriers_draws_what_either_solver_finds(surveyed):
    landscape = surveyed("reference")
    words = draw_barriers(landscape).get_label()
    assert f"Barriers: flat to folded {1e3 * landscape.fold_barrier:.3g} mJ and back" in words
