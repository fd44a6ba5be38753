from dataclasses import replace

import numpy as np
import pytest
from matplotlib.backends.backend_agg import FigureCanvasAgg

from forficula.design import with_values
from forficula.errors import InputError
from forficula.show.folder.convergence_folder import write_convergence
from forficula.show.page.parts.html import escaped
from forficula.show.study.convergence_figure import draw_convergence_angles, draw_convergence_times
from forficula.show.study.convergence_table import convergence_rows
from forficula.study.convergence.convergence import converge
from forficula.study.convergence.refinement import MESH, TIMESTEP, YOUNGS_MODULUS
from tests.plate_sheets import stage, strip

STAGES = [
    {"name": "settle", "drive": "none", "until": "time", "hold": 0.0, "time_limit": 0.1},
    {"name": "fold", "drive": "fold", "until": "folded", "hold": 0.0, "time_limit": 0.2},
]
VALUES = {TIMESTEP: [5e-3, 4e-4, 3e-4, 2e-4], YOUNGS_MODULUS: [5e5, 1e6], MESH: [1, 2]}


@pytest.fixture(scope="module")
def studies(reference):
    """Studies by key, one with a diverged run, and one in which nothing folds."""
    reference = with_values(reference, {"stops.time_constant": 2e-3})
    folding = with_values(reference, {"protocol.stages": STAGES})
    settling = with_values(reference, {"protocol.stages": STAGES[:1]})
    nothing = {"nothing": converge(settling, TIMESTEP, [4e-4, 2e-4])}
    return {key: converge(folding, key, values) for key, values in VALUES.items()} | nothing


@pytest.mark.parametrize("name", [*VALUES, "nothing"])
def test_every_study_can_be_drawn_and_every_axis_has_its_unit(studies, name):
    angles, times = draw_convergence_angles(studies[name]), draw_convergence_times(studies[name])
    for figure in (angles, times):
        FigureCanvasAgg(figure).draw()
    assert angles.axes[0].get_ylabel() == "third distal angle (deg)"
    assert all(axes.get_xlabel().endswith(("(s)", "(ms)")) for axes in angles.axes)
    assert [axes.get_ylabel() for axes in times.axes] == ["fold time (ms)", "opening time (ms)"]
    assert all(axes.get_xlabel().endswith(("(ms)", "(MPa)", "rows of the mesh")) for axes in times.axes)


def test_all_timesteps_are_in_one_figure_and_distinguishable_without_colour(studies):
    lines = [line for line in draw_convergence_angles(studies[TIMESTEP]).axes[0].lines if line.get_label()[0] != "_"]
    assert [line.get_label() for line in lines] == ["5 ms", "0.4 ms", "0.3 ms", "0.2 ms"]
    # luminance of sRGB, Rec. 709
    shades = [np.dot(line.get_color()[:3], [0.2126, 0.7152, 0.0722]) for line in lines]
    assert np.all(np.diff(shades) < -0.05)
    assert len({(line.get_linestyle(), line.get_linewidth()) for line in lines}) == len(lines)


def test_the_drawn_angle_is_the_simulated_one_at_the_time_since_the_stage_began(studies):
    study = studies[TIMESTEP]
    line = draw_convergence_angles(study).axes[1].lines[3]
    assert line.get_xdata() == pytest.approx(1e3 * (study.times[3] - study.starts["fold"][3]))
    assert line.get_ydata() == pytest.approx(np.degrees(study.angles[3]))


def test_the_law_is_drawn_through_its_limit(studies):
    study = studies[TIMESTEP]
    law = next(line for line in draw_convergence_times(study).axes[0].lines if "order" in line.get_label())
    assert (law.get_xdata()[0], law.get_ydata()[0]) == (0, pytest.approx(1e3 * study.orders["fold"].limit))


def test_a_missing_time_is_displayed_as_none(studies):
    rows = convergence_rows(studies[TIMESTEP])
    assert rows[0]["fold_time_s"] is None
    assert rows[0]["status"].startswith("diverged")
    assert all(row["unfold_time_s"] is None for row in rows)


@pytest.mark.usefixtures("no_figures")
def test_the_page_of_a_study_has_every_run_the_limit_its_order_and_the_curves(studies, tmp_path):
    study = studies[TIMESTEP]
    write_convergence(study, tmp_path)
    page, fit = (tmp_path / "report.html").read_text("utf-8"), study.orders["fold"]
    assert page.count("<img ") == page.count('alt="') == 2
    for value, time in zip(study.values[1:], study.transition_times["fold"][1:], strict=True):
        assert f'<th scope="row">{1e3 * value:g} ms</th><td>{1e3 * time:.5g} ms</td>' in page
    assert (
        f"Limit of the fold time: {1e3 * fit.limit:.5g} ms, order {fit.order:{'.2f' if fit.observed else 'g'}}, "
        in page
    )
    assert escaped(study.verdict.rstrip(".")) in page


@pytest.mark.usefixtures("no_figures")
def test_all_files_of_a_convergence_study_are_written_or_none(studies, tmp_path):
    study = studies[TIMESTEP]
    blocked = tmp_path / "blocked"
    (blocked / "times.png").mkdir(parents=True)
    with pytest.raises(InputError, match=r"times\.png"):
        write_convergence(study, blocked)
    assert [path.name for path in blocked.iterdir()] == ["times.png"]
    with pytest.raises(ValueError, match="zip"):  # drawing fails halfway through the files
        write_convergence(replace(study, statuses=()), tmp_path / "broken")
    assert [path.name for path in tmp_path.iterdir()] == ["blocked"]


def test_a_run_without_a_reliable_time_is_marked_and_one_legend_serves_all_panels(studies):
    figure = draw_convergence_times(studies[TIMESTEP])
    fold = figure.axes[0]
    crosses = next(line for line in fold.lines if line.get_marker() == "x")
    assert crosses.get_xdata() == pytest.approx([5])  # ms, diverged
    assert "no reliable time" in [text.get_text() for text in figure.legends[0].get_texts()]
    assert not any(axes.get_legend() for axes in figure.axes)


def test_the_axis_of_the_angle_is_as_wide_as_the_angles(studies):
    study = studies[YOUNGS_MODULUS]
    low, high = draw_convergence_angles(study).axes[0].get_ylim()
    angles = np.degrees(np.concatenate(study.angles))
    assert low <= angles.min()
    assert angles.max() <= high
    assert high - low < 1.3 * np.ptp(angles)


def test_a_design_without_transitions_has_no_figure_of_times(tmp_path):
    design = strip(stages=[stage(limit=2e-3)], **{"crease.start": 0.1})
    write_convergence(converge(design, TIMESTEP, [1e-4, 5e-5]), tmp_path / "study")
    assert {path.stem for path in (tmp_path / "study").glob("*.png")} == {"angles"}
