import numpy as np
import pytest
from matplotlib.backends.backend_agg import FigureCanvasAgg

from forficula.errors import InputError
from forficula.material.characterisation import characterise
from forficula.material.law.law_family import family_forms
from forficula.show.material.cycles_figure import draw_cycles
from forficula.show.material.drift_figure import draw_drift
from forficula.show.material.law_figure import draw_fit
from forficula.show.material.modulus_figure import draw_moduli
from forficula.show.style import VERMILION
from tests.material.synthetic import cyclic_test

DRAW = {"cycles": draw_cycles, "moduli": draw_moduli, "fit": draw_fit, "drift": draw_drift}


def drawn(figure):
    canvas = FigureCanvasAgg(figure)
    canvas.draw()
    return canvas, np.asarray(canvas.buffer_rgba())[..., :3]


@pytest.mark.parametrize("name", DRAW)
@pytest.mark.parametrize("which", ["tpu_material", "elastic_material"])
def test_every_figure_has_units_on_its_axes_and_its_legend_on_the_page(request, name, which):
    figure = DRAW[name](request.getfixturevalue(which))
    canvas, pixels = drawn(figure)
    assert len(np.unique(pixels @ [1, 256, 65536])) > 10  # not blank
    for axes in figure.axes:
        for label in (axes.get_xlabel(), axes.get_ylabel()):
            assert label in ("", "cycle N") or label.endswith(("(%)", "(MPa)", "(min)", "(MJ/m³)", "(kJ/m³)", "(h)"))
    for legend in figure.legends:
        assert figure.bbox.padded(1).containsx(legend.get_window_extent(canvas.get_renderer()).x0)
        assert figure.bbox.padded(1).containsx(legend.get_window_extent(canvas.get_renderer()).x1)


def test_each_cycle_s_panel_has_every_specimen_and_the_medians_of_loading_and_unloading(tpu_material):
    figure = draw_cycles(tpu_material)
    panels = [axes for axes in figure.axes if axes.lines]
    assert [axes.get_title("left") for axes in panels] == ["cycle 1, left out", "cycle 2", "cycle 3", "cycle 4"]
    for axes in panels:
        thick = [line for line in axes.lines if line.get_linewidth() > 1 and len(line.get_xdata()) > 1]
        thin = [line for line in axes.lines if line.get_linewidth() == 0.5 and len(line.get_xdata()) > 10]
        assert [line.get_linestyle() for line in thick] == ["-", "--"]
        assert len(thin) == 2 * 3


def test_the_median_curve_is_the_middle_specimen(tpu_material):
    (loading,) = [line for line in draw_cycles(tpu_material).axes[1].lines if line.get_linewidth() == 1.6][:1]
    ends = sorted(specimen.cycles[0].loading.stress[-1] / 1e6 for specimen in tpu_material.specimens)
    assert loading.get_ydata()[-1] == pytest.approx(ends[1], rel=1e-6)


def test_many_cycles_are_drawn_as_six(elastic_material):
    test = cyclic_test(lambda strain, _: 4.8e6 * strain, cycles=30, samples=40)
    figure = draw_cycles(characterise([test], forms=family_forms("linear")))
    titles = [axes.get_title("left") for axes in figure.axes]
    assert len(titles) == 6
    assert titles[0] == "cycle 1, left out"
    assert titles[-1] == "cycle 30"
    assert len(draw_cycles(elastic_material).axes) == 3


def test_the_band_of_moduli_is_drawn_where_the_papers_tendon_needs_it(tpu_material):
    for axes in draw_moduli(tpu_material).axes:
        band = axes.patches[0].get_extents().transformed(axes.transData.inverted())
        # 10 and 60 N/cm at 5 mm^2 and 60 mm, in MPa
        assert (band.y0, band.y1) == pytest.approx((12, 72))


def test_the_boxes_are_the_quartiles_of_the_classes(tpu_material):
    secant, local = draw_moduli(tpu_material).axes
    pooled = tpu_material.pooled
    for axes, kind in ((secant, "secant_modulus"), (local, "local_modulus")):
        boxes = axes.patches[1:]
        assert len(boxes) == len(pooled)
        heights = sorted(patch.get_path().vertices[:, 1].max() for patch in boxes)
        assert heights == pytest.approx(sorted(getattr(item, kind).upper / 1e6 for item in pooled))


def test_the_residual_is_the_law_minus_the_data(tpu_material):
    panels = draw_fit(tpu_material).axes
    left = np.concatenate([line.get_ydata() for line in panels[2].lines if len(line.get_xdata()) > 2])
    assert np.sqrt(np.mean(left**2)) * 1e6 == pytest.approx(tpu_material.fit.misfit, rel=1e-6)


def test_a_law_is_drawn_without_the_offset_and_drift_of_the_force(elastic_material):
    law = next(line for line in draw_fit(elastic_material).axes[0].lines if line.get_color() == VERMILION)
    strain, stress = law.get_xdata() / 100, law.get_ydata() * 1e6
    assert stress == pytest.approx(elastic_material.law.moduli[0] * strain, abs=1e3)  # of 4.8 MPa


def test_a_drift_is_drawn_through_the_specimens_with_its_size(tpu_material):
    peak, loss, _ = draw_drift(tpu_material).axes
    fitted = next(line for line in peak.lines if line.get_linestyle() == "--").get_ydata()
    measured = [line.get_ydata() for line in peak.lines if line.get_linestyle() == "-"]
    assert fitted == pytest.approx(np.median(measured, axis=0), rel=5e-3)
    assert peak.get_title("left").startswith("−")
    assert loss.get_ylabel().startswith("loss per cycle (")


def test_an_unknown_drift_and_a_missing_law_are_reported(elastic_material, lawless_material):
    # two cycles are too few for a drift
    assert {axes.get_title("left") for axes in draw_drift(elastic_material).axes} == {"drift unknown"}
    with pytest.raises(InputError, match="tpu: there is no law to draw"):
        draw_fit(lawless_material)


def test_moduli_without_slack_fill_a_linear_axis_and_the_required_range_is_named(elastic_material):
    for axes in draw_moduli(elastic_material).axes:
        assert axes.get_yscale() == "linear"
        low, high = axes.get_ylim()
        boxes = [patch.get_path().vertices[:, 1] for patch in axes.patches[1:]]
        assert low < min(box.min() for box in boxes) < max(box.max() for box in boxes) < high
        # 12 MPa are required, and the specimens have 4.8 MPa
        assert high < 12
        assert "↑ required from 12 MPa" in [text.get_text() for text in axes.texts]


@pytest.mark.parametrize("name", DRAW)
def test_every_entry_of_a_legend_is_drawn_and_every_panel_has_a_letter(elastic_material, tpu_material, name):
    for material in (elastic_material, tpu_material):
        figure = DRAW[name](material)
        panels = [axes for axes in figure.axes if axes.get_visible() and axes.axison]
        letters = [text.get_text() for axes in figure.axes for text in axes.texts if text.get_weight() == "bold"]
        assert letters == list("ABCDEF"[: len(panels)]) * (len(panels) > 1)
        legends = [*figure.legends, *(axes.get_legend() for axes in figure.axes if axes.get_legend())]
        looks = {(line.get_color(), line.get_linestyle(), line.get_marker()) for axes in panels for line in axes.lines}
        for legend in legends:
            for text, handle in zip(legend.get_texts(), legend.legend_handles, strict=True):
                if text.get_text() in ("unloading carries no force below", "fitted drift and its 95 % interval"):
                    assert (handle.get_color(), handle.get_linestyle(), handle.get_marker()) in looks
