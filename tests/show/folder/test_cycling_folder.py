import csv
import json
import re
from dataclasses import replace

import pytest
from matplotlib.backends.backend_agg import FigureCanvasAgg

import forficula as ff
from forficula.show.folder.cycling_folder import CYCLING_FILES, print_cycling, write_cycling
from forficula.show.folder.run_folder import write_run
from forficula.show.run.cycling_figure import draw_cycling
from forficula.structure import structure_of
from forficula.study.cycling import CycleRun, Cycling, driven_transitions

pytestmark = pytest.mark.usefixtures("no_figures")


def run(cycle, **row):
    works = {"status": "folded and opened", "folded": True, "opened": True, "flat_energy_J": 0.5 / cycle}
    works |= {"folded_energy_J": 0.0, "opened_energy_J": 0.5 / cycle, "fold_time_s": 0.05 * cycle}
    return CycleRun(
        cycle=cycle,
        measured=2 <= cycle <= 4,
        stiffness=(1 / cycle, 0.9 / cycle, 1.1 / cycle),
        residual_strain=0.01,
        row=works | {"fold_work_J": 1.0, "unfold_time_s": 0.01, "unfold_work_J": 2.0} | row,
        margins={"fold": 70.0 * cycle, "unfold": 4.0 * cycle},
    )


def files_in(folder):
    return sorted(path.relative_to(folder).as_posix() for path in folder.rglob("*") if path.is_file())


STUCK = {"status": "stuck at -80.0 deg", "folded": False, "opened": False, "fold_time_s": None}


@pytest.fixture
def cycling(reference):
    """Return six cycles: some are covered by tests, and the last two fail."""
    runs = (*(run(cycle) for cycle in range(1, 5)), *(run(cycle, **STUCK) for cycle in (5, 6)))
    return Cycling(
        design=reference,
        runs=runs,
        seen=(2, 4),
        transitions=driven_transitions(structure_of(reference)),
        verdict="up to cycle 4",
        remarks=("[2] to 4 seen",),
    )


def test_the_figure_marks_extrapolated_cycles_and_the_first_failure(cycling):
    figure = draw_cycling(cycling)
    FigureCanvasAgg(figure).draw()
    assert [axes.get_ylabel() for axes in figure.axes] == [
        "energy of the tendons (J)",
        "fold time (s)",
        "margin: torque / least slow torque",
    ]
    assert {axes.get_xlabel() for axes in figure.axes} == {"cycle N"}
    labels = [text.get_text() for text in figure.legends[0].get_texts()]
    assert labels == [
        *("flat", "folded", "opened", "not covered by tests"),
        *("first failure, cycle 5", "did not fold and open"),
    ]
    shaded = [
        patch.get_extents().transformed(axes.transData.inverted()) for axes in figure.axes for patch in axes.patches
    ]
    assert all(box.x1 <= 2.001 or box.x0 >= 3.999 for box in shaded)
    assert len(shaded) == 6


@pytest.mark.parametrize("count", [1, 2])
def test_few_cycles_without_a_failure_can_be_drawn(cycling, count):
    for seen in ((2, 4), (1, 4), None):
        few = replace(
            cycling, runs=tuple(replace(item, measured=seen is not None) for item in cycling.runs[:count]), seen=seen
        )
        FigureCanvasAgg(draw_cycling(few)).draw()


def test_cycles_without_numbers_can_be_drawn(cycling):
    nothing = replace(cycling, runs=tuple(run(n, **STUCK) for n in (1, 2)), transitions=cycling.transitions[:1])
    FigureCanvasAgg(draw_cycling(nothing)).draw()


def test_all_cycles_are_in_the_table_and_in_json(cycling, tmp_path):
    write_cycling(cycling, tmp_path / "run")
    assert files_in(tmp_path / "run") == sorted(CYCLING_FILES)
    with (tmp_path / "run" / "cycles.csv").open() as file:
        rows = list(csv.DictReader(file))
    assert [row["cycle"] for row in rows] == ["1", "2", "3", "4", "5", "6"]
    assert [row["fold_time_s"] for row in rows[3:]] == ["0.2", "", ""]
    content = json.loads((tmp_path / "run" / "cycles.json").read_text("utf-8"))
    assert content["first_failure"] == 5
    assert [row["fold_time_s"] for row in content["cycles"][3:]] == [0.2, None, None]
    assert {key: str(value) if value is not None else "" for key, value in content["cycles"][5].items()} == rows[5]


@pytest.mark.usefixtures("undrawn")
def test_the_cycles_of_an_earlier_run_go_when_another_run_takes_its_place(cycling, tmp_path, reference_run):
    write_cycling(cycling, tmp_path / "run")
    write_run(reference_run, ff.measure(reference_run), tmp_path / "run", engine=False)
    assert not set(CYCLING_FILES) & set(files_in(tmp_path / "run"))
    assert "record.nc" in files_in(tmp_path / "run")


def test_the_page_of_a_run_has_a_section_on_cycles(cycling, tmp_path, reference_run):
    ff.page(reference_run, tmp_path / "report.html")
    alone = (tmp_path / "report.html").read_text("utf-8")
    write_cycling(cycling, tmp_path)
    page = (tmp_path / "report.html").read_text("utf-8")
    before, section, after = re.split(r'(<section id="cycles">.*?</section>\n)', page, flags=re.S)
    assert before + after == alone
    assert after.startswith('<section id="design">')
    assert "<p>Up to cycle 4.</p>" in section
    assert "<li>[2] to 4 seen.</li>" in section
    assert section.count("<small>extrapolated</small>") == 3
    # cycles that did not fold and open
    assert section.count("<mark>stuck at −80.0 deg</mark>") == 2
    assert "<td>1 (0.9 to 1.1)</td><td>1 %</td><td>50 ms</td><td>1 J</td><td>70</td>" in section


def test_the_verdict_and_the_remarks_are_printed(cycling, capsys):
    print_cycling(cycling)
    lines = capsys.readouterr().out.splitlines()
    assert lines == [
        "",
        "Cycles: up to cycle 4",
        "  ratio of the fold torque to the least slow torque: 70 at cycle 1, 420 at cycle 6",
        "  ratio of the unfold torque to the least slow torque: 4 at cycle 1, 24 at cycle 6",
        "  [2] to 4 seen",
    ]
