"""Maps of planted tables: every value and every reason agrees with the table."""

import numpy as np
import pytest
import xarray as xr
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.collections import PathCollection, PolyCollection, QuadMesh

from forficula.errors import InputError
from forficula.show.study.maps import (
    draw_energy_maps,
    draw_first_times,
    draw_moving_maps,
    draw_status_map,
    draw_torque_maps,
    draw_work_maps,
    map_drawings,
)
from forficula.show.style import ENERGY_COLOURS, PAGE_WIDTH
from tests.show.legible import colours
from tests.show.tables import transitions_of_reference

COORDS = {
    "tendon_stiffness": ([1000.0, 2000.0, 3000.0], "tendon.stiffness", "N/m", "N/cm"),
    "tendon_rest_length": ([0.0, 0.03, 0.06, 0.09], "tendon.rest_length", "m", "cm"),
    "pattern_hub_radius": ([0.01, 0.015, 0.02], "pattern.hub_radius", "m", "cm"),
    "pattern_tangent": (["left", "right"], "pattern.tangent", "", ""),
}
TORQUES = [0.1, 0.2, 0.5]
TWO = ("tendon_stiffness", "tendon_rest_length")
UNITS = {"torque": "N m", "time": "s", "work": "J", "energy": "J"}
FLOATS = (
    "least_fold_torque",
    "least_unfold_torque",
    "fold_time",
    "unfold_time",
    "fold_work",
    "unfold_work",
    "flat_energy",
    "folded_energy",
    "opened_energy",
)


NOT_RUN = "not run"
# beginnings of statuses, with their words and verdicts
ENDS = {
    "folded and opened": ("folded and opened", "reached"),
    "did not open": ("did not open", "stuck"),
    "did not fold": ("did not fold", "stuck"),
    "stuck": ("stuck on the way", "stuck"),
    "did not stay folded": ("did not stay folded", "not held"),
    "still moving": ("still folding", "moving"),
    "diverged": ("diverged", "diverged"),
    "unreliable": ("unreliable", "untrusted"),
    "cannot be built": ("cannot be built", "not built"),
    NOT_RUN: (NOT_RUN, "not built"),
}


def end(status):
    """Return the word for a status, and the verdict."""
    if status.startswith("with "):
        torque, rest = status.split(": ", 1)
        word, verdict = end(rest)
        return (word if verdict in ("diverged", "untrusted") else f"{word} {torque}"), verdict
    return next(item for beginning, item in ENDS.items() if status.startswith(beginning))


def planted(factors, status=None, *, fold_outcome=None, sizes=None):
    """Return a search over some factors, in which wings fold and open unless a status says otherwise."""
    coords = {name: COORDS[name][0][: (sizes or {}).get(name)] for name in factors}
    shape = tuple(len(values) for values in coords.values())
    status = np.full(shape, "folded and opened", dtype=object) if status is None else status
    outcome, verdict = np.vectorize(end, otypes=[object, object])(status)
    opens = outcome == "folded and opened"
    folds = opens | (outcome == "did not open")
    tells = np.isin(verdict, ["reached", "stuck", "not held", "moving"])
    rising = 1.0 + np.arange(opens.size).reshape(shape)
    variables = {}
    for name in FLOATS:
        where = tells if name == "flat_energy" else opens if "open" in name or "unfold" in name else folds
        scale = 0.01 if "torque" in name or "time" in name else 1.0
        variables[name] = (factors, np.where(where, scale * rising, np.nan), {"units": UNITS[name.rsplit("_", 1)[1]]})
    fold_outcome = np.where(folds, "folded", outcome) if fold_outcome is None else fold_outcome
    variables["status"] = (factors, status)
    variables["outcome"] = (factors, outcome)
    variables["verdict"] = (factors, verdict)
    variables["residual"] = (
        factors,
        np.where(verdict == "untrusted", 0.1, np.where(tells, 1e-3, np.nan)),
        {"units": ""},
    )
    variables["fold_outcome"] = (factors, fold_outcome.astype(object))
    variables["reference_outcome"] = (factors, np.where(folds, "folded", "").astype(object), {"torque": 5.0})
    times = np.where(folds[..., None], 0.05 / np.array(TORQUES), np.nan) + 0.001 * rising[..., None]
    variables["fold_time_by_torque"] = ((*factors, "fold_torque"), times, {"units": "s"})
    variables["folded_by_torque"] = ((*factors, "fold_torque"), np.isfinite(times))
    by_torque = np.broadcast_to(fold_outcome[..., None], times.shape).astype(object)
    variables["fold_outcome_by_torque"] = ((*factors, "fold_torque"), by_torque)
    attributes = {"ask": "least-torques", **transitions_of_reference()}
    table = xr.Dataset(variables, coords={**coords, "fold_torque": TORQUES}, attrs=attributes)
    for name in factors:
        _, key, si, display = COORDS[name]
        table[name].attrs = {"key": key, "units": si, "display": display, "long_name": key}
    table["fold_torque"].attrs = {"key": "protocol.fold_torque", "units": "N m", "display": "N cm"}
    return table


def many_ends():
    status = np.array(
        [
            ["folded and opened", "folded and opened", "did not open", "did not fold"],
            ["folded and opened", "did not open", "stuck at -134.6 deg", "diverged at t = 0.3 s"],
            ["did not stay folded", NOT_RUN, "did not fold", "did not fold"],
        ],
        dtype=object,
    )
    return planted(TWO, status)


UNTRUSTED = "unreliable: the energy balance misses 12 %"


def doubtful():
    """As with a timestep that is too long for some wings, and a time limit that is too short for others."""
    status = np.array(
        [
            ["folded and opened", UNTRUSTED, "still moving at -34.0 deg when its time to fold was over", UNTRUSTED],
            ["diverged at t = 0.3 s", "diverged at t = 0.1 s", "did not open", "did not fold"],
            ["folded and opened"] * 4,
        ],
        dtype=object,
    )
    return planted(TWO, status)


def as_run(table):
    names = ["least_fold_torque", "least_unfold_torque", "fold_outcome", "reference_outcome"]
    by_torque = ["fold_time_by_torque", "folded_by_torque", "fold_outcome_by_torque", "fold_torque"]
    return table.drop_vars(names + by_torque).assign_attrs(ask="run", **transitions_of_reference("run"))


def sampled(table):
    return table.stack(sample=TWO).reset_index("sample").transpose("sample", ...)


def draw(figure):
    canvas = FigureCanvasAgg(figure)
    canvas.draw()
    return np.asarray(canvas.buffer_rgba())[..., :3]


def written(axes):
    """Return the numbers in cells by column and row."""
    numbers = [text for text in axes.texts if text.get_weight() != "bold"]  # and not the panel's letter
    return {tuple(map(round, text.get_position())): float(text.get_text()) for text in numbers}


def marked(axes):
    """Return the number of cells for each reason, fewest first."""
    polygons = [
        item for item in axes.collections if isinstance(item, PolyCollection) and not isinstance(item, QuadMesh)
    ]
    return sorted(len(item.get_paths()) for item in polygons)


def legend(figure):
    return [text.get_text() for item in figure.legends for text in item.get_texts()]


def panels(figure):
    return {axes.get_title(): axes for axes in figure.axes if axes.get_title()}


TABLES = {
    "nothing folds": lambda: planted(TWO, np.full((3, 4), "did not fold", dtype=object)),
    "nothing ran": lambda: planted(TWO, np.full((3, 4), NOT_RUN, dtype=object)),
    "one cell": lambda: planted(TWO, sizes={"tendon_stiffness": 1, "tendon_rest_length": 1}),
    "one factor": lambda: planted(("tendon_stiffness",)),
    "one factor of words, one value": lambda: planted(
        ("pattern_tangent",), np.array(["did not open"], dtype=object), sizes={"pattern_tangent": 1}
    ),
    "three factors": lambda: planted(("tendon_stiffness", "pattern_tangent", "pattern_hub_radius")),
    "samples": lambda: sampled(doubtful()),
    "samples of one factor": lambda: sampled(many_ends()).drop_vars("tendon_stiffness"),
    "runs": lambda: as_run(many_ends()),
    "runs of which none folds": lambda: as_run(planted(TWO, np.full((3, 4), "did not fold", dtype=object))),
}


# maps of two factors with every outcome are drawn in tests of words
@pytest.mark.parametrize("name", TABLES)
def test_every_table_can_be_drawn(name):
    for drawing in map_drawings(TABLES[name]()).values():
        assert colours(draw(drawing(PAGE_WIDTH))) > 10  # not blank


def test_a_search_has_every_figure_and_plain_runs_those_without_torques():
    assert set(map_drawings(planted(TWO))) == {"status", "torques", "works", "energy", "fold_times"}
    assert set(map_drawings(as_run(planted(TWO)))) == {"status", "works", "energy"}
    assert set(map_drawings(sampled(planted(TWO)))) == {"status", "torques", "works", "energy"}


def test_a_map_over_three_factors_is_drawn_at_every_value_of_the_third_with_how_many_have_one():
    table = planted(("tendon_stiffness", "tendon_rest_length", "pattern_hub_radius"))
    table["least_fold_torque"][1:, 1, 2] = np.nan
    assert "torques_moving" in map_drawings(table)
    assert "torques_moving" not in map_drawings(planted(("tendon_stiffness", "tendon_rest_length"))), (
        "two have no third"
    )
    drawn = panels(draw_moving_maps(table))
    assert list(drawn) == ["1 cm: 12 of 12 fold", "1.5 cm: 12 of 12 fold", "2 cm: 10 of 12 fold"]
    for place, axes in enumerate(drawn.values()):
        values = table["least_fold_torque"].values[:, :, place]
        expected = {(column, row): 100 * value for (row, column), value in np.ndenumerate(values) if np.isfinite(value)}
        assert written(axes) == pytest.approx(expected, rel=1e-2)  # N cm, three digits


def opening(axes):
    """Return the panel of the least torques that open, whose title names the folding torque."""
    return next(panel for title, panel in axes.items() if title.startswith("least unfold torque"))


def test_each_cell_contains_its_value_in_display_units():
    table = many_ends()
    axes = panels(draw_torque_maps(table))
    for title, name in (("least fold torque", "least_fold_torque"), ("least unfold torque", "least_unfold_torque")):
        values = table[name].values
        expected = {(column, row): 100 * value for (row, column), value in np.ndenumerate(values) if np.isfinite(value)}
        panel = axes[title] if title in axes else opening(axes)
        assert written(panel) == pytest.approx(expected)  # N cm


def test_each_cell_without_a_value_is_marked_by_its_reason():
    figure = draw_torque_maps(many_ends())
    # 5 fold; 3 did not fold, 1 stuck, 1 diverged, 1 did not stay folded, 1 not run
    assert marked(panels(figure)["least fold torque"]) == [1, 1, 1, 1, 3]
    # 3 open; 2 did not open, 1 diverged, 1 not run, and 5 that did not fold were not tried
    assert marked(opening(panels(figure))) == [1, 1, 2, 5]
    assert set(legend(figure)) == {
        "did not fold",
        "stuck on the way",
        "did not stay folded",
        "diverged",
        "not run",
        "did not open",
        "not tried: did not fold",
    }


def test_a_wing_that_sticks_when_folded_for_the_unfolding_says_with_which_torque():
    table = planted(TWO)
    table["least_unfold_torque"][0, 3] = np.nan
    table["status"][0, 3] = "with 500 N cm: stuck at -134.6 deg"
    table["outcome"][0, 3] = "stuck on the way with 500 N cm"
    table["reference_outcome"][0, 3] = "stuck on the way"
    assert legend(draw_torque_maps(table)) == ["stuck on the way with 500 N cm"]


def test_a_wing_that_only_the_large_torque_folds_was_asked_to_open():
    table = many_ends()
    table["reference_outcome"][2, 3] = "folded"
    # as before, except that one more did not open, and one fewer was not tried
    assert marked(opening(panels(draw_torque_maps(table)))) == [1, 1, 3, 4]


def test_a_status_map_names_the_torque_of_a_fold_that_failed_and_leaves_out_long_reasons():
    status = np.full((3, 4), "folded and opened", dtype=object)
    status[0, 0], status[1, 1] = "with 500 N cm: stuck at -134.6 deg", "cannot be built: vein.diameter: need < 3 mm"
    assert legend(draw_status_map(planted(TWO, status))) == [
        "folded and opened",
        "cannot be built",
        "stuck on the way with 500 N cm",
    ]
    assert "cannot be built" in legend(draw_torque_maps(planted(TWO, status)))


def test_a_wing_whose_release_failed_is_marked_by_that_whatever_the_large_torque_did():
    status = np.full((3, 4), "folded and opened", dtype=object)
    status[0, 0] = "did not stay folded; with 500 N cm: stuck at -134.6 deg"
    assert legend(draw_status_map(planted(TWO, status))) == ["folded and opened", "did not stay folded"]


def test_untrusted_runs_are_marked_in_every_map_and_not_counted_as_failures():
    table = doubtful()
    for figure in (draw_torque_maps(table), draw_work_maps(table), draw_energy_maps(table), draw_status_map(table)):
        assert colours(draw(figure)) > 10
        assert {"diverged", "unreliable"} <= set(legend(figure))
        handles = {handle.get_label(): handle for handle in figure.legends[0].legend_handles}
        hatches = [handle.get_hatch() for handle in handles.values() if handle.get_hatch()]
        assert len(hatches) == len(set(hatches))
        for axes in panels(figure).values():
            assert marked(axes).count(2) >= 2
    # by torque, too: two wings at three torques each
    figure = draw_first_times(table)
    assert set(legend(figure)) == {"diverged", "unreliable", "still folding", "did not fold"}


def test_an_untrusted_sample_is_not_drawn_as_a_value():
    axes = panels(draw_torque_maps(sampled(doubtful())))["least fold torque"]
    markers = [line.get_marker() for line in axes.lines]
    assert len(set(markers)) == len(markers) == 4
    assert not {"o", "8", "."} & set(markers)


def test_untrusted_torques_are_marked_beside_trusted_ones():
    table = planted(TWO)
    table["fold_time_by_torque"][0, 1, 2] = table["fold_time_by_torque"][0, 2, 1] = np.nan
    table["fold_outcome_by_torque"][0, 1, 2] = "unreliable"
    table["fold_outcome_by_torque"][0, 2, 1] = "diverged"
    figure = draw_first_times(table)
    assert legend(figure) == ["diverged", "unreliable"]
    assert marked(panels(figure)["tendon stiffness 10 N/cm"]) == [1, 1]


def test_an_untrusted_reference_run_has_its_hatch_at_every_torque():
    table = planted(TWO)
    table["least_unfold_torque"][0, 3] = table["least_unfold_torque"][1, 3] = np.nan
    for place, word in (((0, 3), "unreliable"), ((1, 3), "diverged")):
        table["outcome"][place] = table["reference_outcome"][place] = word
    assert legend(draw_torque_maps(table)) == ["diverged", "unreliable"]


def test_runs_that_did_not_fold_were_not_asked_to_open():
    figure = draw_work_maps(as_run(many_ends()))
    assert {"did not fold", "did not open", "not tried: did not fold"} <= set(legend(figure))


def test_each_outcome_of_a_run_is_in_the_legend_once():
    figure = draw_status_map(as_run(many_ends()))
    assert legend(figure) == [
        "folded and opened",
        "did not open",
        "did not fold",
        "stuck on the way",
        "did not stay folded",
        "diverged",
        "not run",
    ]
    assert sum(len(item.get_paths()) for item in figure.axes[0].collections) == 12


def test_the_first_factor_is_vertical_and_the_second_horizontal_by_default():
    axes = panels(draw_torque_maps(planted(TWO)))["least fold torque"]
    assert (axes.get_xlabel(), axes.get_ylabel()) == ("tendon rest length (cm)", "tendon stiffness (N/cm)")
    assert [text.get_text() for text in axes.get_xticklabels()] == ["0", "3", "6", "9"]
    turned = panels(draw_torque_maps(planted(TWO), x="tendon.stiffness"))["least fold torque"]
    assert (turned.get_ylabel(), turned.get_xlabel()) == ("tendon rest length (cm)", "tendon stiffness (N/cm)")
    assert written(turned) == {(row, column): value for (column, row), value in written(axes).items()}


def test_of_more_factors_the_middle_is_drawn_and_the_title_says_so():
    table = planted(("tendon_stiffness", "tendon_rest_length", "pattern_hub_radius"))
    figure = draw_work_maps(table)
    assert figure.get_suptitle() == "at pattern hub radius 1.5 cm"
    middle = table.fold_work.isel(pattern_hub_radius=1).values
    drawn = written(panels(figure)["work of folding"])
    assert drawn == {(column, row): value for (row, column), value in np.ndenumerate(middle)}
    chosen = draw_work_maps(table, x="pattern.hub_radius", y="tendon_stiffness")
    assert chosen.get_suptitle() == "at tendon rest length 6 cm"


def test_factors_with_one_value_are_no_axes():
    table = planted(("pattern_tangent", *TWO), sizes={"pattern_tangent": 1})
    axes = panels(draw_torque_maps(table))["least fold torque"]
    assert (axes.get_xlabel(), axes.get_ylabel()) == ("tendon rest length (cm)", "tendon stiffness (N/cm)")


def test_one_factor_is_drawn_as_a_line_with_the_failures_along_the_bottom():
    table = planted(
        ("tendon_stiffness",), np.array(["did not fold", "did not open", "folded and opened"], dtype=object)
    )
    figure = draw_torque_maps(table)
    axes = panels(figure)["least fold torque"]
    line, failures = (line for line in axes.lines if line.get_marker() != "None")
    np.testing.assert_allclose(line.get_xdata(), [10, 20, 30])  # N/cm
    np.testing.assert_allclose(line.get_ydata(), [np.nan, 2, 3])  # N cm
    assert list(failures.get_xdata()) == [10]
    assert axes.get_ylabel() == "torque (N cm)"
    # the axis is as wide as the values; failures are in a strip below, which has no numbers
    assert min(axes.get_yticks()) >= 1.9
    low, high = axes.get_ylim()
    assert 1.5 < low < 2 < 3 < high < 3.2
    assert low + failures.get_ydata()[0] * (high - low) < 1.95


def test_samples_lie_where_their_factors_say():
    table = sampled(many_ends())
    axes = panels(draw_torque_maps(table))["least fold torque"]
    result = table.where(table.least_fold_torque > 0, drop=True)
    places = np.column_stack([100 * result.tendon_stiffness / 1e4, 100 * result.tendon_rest_length])
    drawn = axes.collections[0]
    # the first factor is vertical
    np.testing.assert_allclose(np.asarray(drawn.get_offsets())[:, ::-1], places)
    np.testing.assert_allclose(drawn.get_array(), 100 * result.least_fold_torque)
    assert sum(len(line.get_xdata()) for line in axes.lines) == 7


def test_the_three_states_share_one_scale():
    figure = draw_energy_maps(planted(TWO))
    scales = [mesh.norm for axes in panels(figure).values() for mesh in axes.collections if isinstance(mesh, QuadMesh)]
    assert len(scales) == 3
    assert len({(norm.vmin, norm.vmax) for norm in scales}) == 1


@pytest.mark.parametrize("table", [planted(TWO), sampled(many_ends())], ids=["grid", "samples"])
def test_energies_have_the_colours_that_all_energies_have_and_nothing_else_has(table):
    for draw in (draw_energy_maps, draw_work_maps, draw_torque_maps):
        drawn = [
            item.cmap
            for axes in panels(draw(table)).values()
            for item in axes.collections
            if isinstance(item, QuadMesh | PathCollection) and item.get_array() is not None
        ]
        assert {item is ENERGY_COLOURS for item in drawn} == {draw is not draw_torque_maps}


def test_fold_times_have_one_panel_for_each_value_of_the_first_factor():
    table = many_ends()
    figure = draw_first_times(table)
    titles = [f"tendon stiffness {value} N/cm" for value in (10, 20, 30)]
    assert list(panels(figure)) == titles
    axes = panels(figure)[titles[0]]
    expected = {
        (column, row): 1e3 * value  # ms
        for (row, column), value in np.ndenumerate(table.fold_time_by_torque.values[0])
        if np.isfinite(value)
    }
    assert written(axes) == pytest.approx(expected, rel=5e-3)  # three digits
    assert panels(figure)[titles[2]].get_xlabel() == "fold torque (N cm)"
    turned = draw_first_times(table, panels="tendon.rest_length")
    assert list(panels(turned)) == [f"tendon rest length {value} cm" for value in (0, 3, 6, 9)]


def test_unknown_factors_are_refused_by_name():
    table = planted(TWO)
    with pytest.raises(InputError, match=r"hub\.radius: need a factor of the study, one of tendon_stiffness"):
        draw_torque_maps(table, x="hub.radius")
    with pytest.raises(InputError, match="two factors, got tendon_stiffness twice"):
        draw_torque_maps(table, x="tendon_stiffness", y="tendon_stiffness")
    with pytest.raises(InputError, match="grid of factors"):
        draw_first_times(sampled(table))
    with pytest.raises(InputError, match="two factors"):
        draw_first_times(table, panels="tendon_stiffness", y="tendon_stiffness")


def test_small_designs_are_written_in_small_units():
    table = planted(TWO)
    for name in ("least_fold_torque", "least_unfold_torque"):
        table[name] = (table[name] * 1e-6).assign_attrs(units="N m")
    figure = draw_torque_maps(table)
    assert [axes.get_ylabel() for axes in figure.axes if axes.get_label() == "<colorbar>"] == ["torque (nN m)"] * 2


def test_panels_of_one_quantity_have_one_unit_and_letters():
    table = planted(TWO)
    # folding requires a tenth of the torque of opening
    table["least_fold_torque"] = 0.02 * table["least_fold_torque"] / table["least_fold_torque"].max()
    table["least_unfold_torque"] = 0.2 * table["least_unfold_torque"] / table["least_unfold_torque"].max()
    figure = draw_torque_maps(table)
    bars = [axes.get_ylabel() for axes in figure.axes if axes.get_label() == "<colorbar>"]
    assert len(bars) == 2
    assert len(set(bars)) == 1
    letters = [text.get_text() for axes in figure.axes for text in axes.texts if text.get_weight() == "bold"]
    assert letters == ["A", "B"]


def test_a_colour_bar_of_a_single_value_has_this_value_only():
    table = planted(TWO)
    least = table["least_fold_torque"]
    table["least_fold_torque"] = least.where(least == least.max())
    bar = next(axes for axes in draw_torque_maps(table).axes if axes.get_label() == "<colorbar>")
    assert bar.get_yticks() == pytest.approx([100 * float(least.max())])
