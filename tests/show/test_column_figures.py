"""Every figure at both widths of a journal: everything is inside, and words are large enough and do not overlap."""

import numpy as np
import pytest
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from forficula.analysis import measure
from forficula.design import with_values
from forficula.show.folder.assumptions_folder import assumptions_drawings
from forficula.show.folder.convergence_folder import convergence_drawings
from forficula.show.folder.cycling_folder import cycling_drawings
from forficula.show.folder.landscape_folder import landscape_drawings
from forficula.show.folder.material_folder import material_drawings
from forficula.show.folder.run_folder import run_drawings
from forficula.show.folder.static_map_folder import static_map_drawings
from forficula.show.study.maps import map_drawings
from forficula.show.style import COLUMN_WIDTH, PAGE_WIDTH, figure_style, fit_legend
from forficula.structure import structure_of
from forficula.study.convergence.convergence import converge
from forficula.study.convergence.refinement import TIMESTEP
from forficula.study.cycling import Cycling, driven_transitions
from forficula.study.running.runs import run
from forficula.study.tables.static_map import map_study, static_map
from tests.assumptions import ASSUMED
from tests.show.folder.test_cycling_folder import STUCK
from tests.show.folder.test_cycling_folder import run as cycle
from tests.show.legible import check_inside, check_words
from tests.show.study.test_convergence_figure import STAGES
from tests.show.study.test_maps import TWO, many_ends, planted

# stays where it is
SHORT = {
    "protocol.stages.0.time_limit": "20 ms",
    "protocol.stages.1.time_limit": "0.15 s",
    "tendon.rest_length": "5 cm",
}


def simulated(statics):
    """Return a search compared with statics, with agreement and every kind of difference."""
    table = statics.copy(deep=True)
    for name in ("least_fold_torque", "least_unfold_torque"):
        values = table[name].values
        values[0, :3] = [0.3, np.nan, 0.02]
        values[1:, 1:4] = 0.4
    return table


@pytest.fixture(scope="module")
def drawings(reference, reference_run, reference_outcome, surveyed, tpu_material, elastic_material):
    """Return the drawings of every figure, by name."""
    over = {"tendon.stiffness": "10..30 N/cm step 10", "tendon.rest_length": "5..9 cm step 1"}
    folding = with_values(reference, {"protocol.stages": STAGES})
    runs = (*(cycle(number) for number in range(1, 5)), cycle(5, **STUCK))
    driven = driven_transitions(structure_of(reference))
    cycling = Cycling(
        design=reference, runs=runs, seen=(2, 4), transitions=driven, verdict="Up to cycle 4.", remarks=()
    )
    statics = static_map(map_study(reference, over))
    stuck = run(with_values(reference, SHORT | {"protocol.fold_torque": "1 N cm"}))
    every = {
        "run": run_drawings(reference_run, reference_outcome),
        "landscape": landscape_drawings(surveyed("reference"), reference_run),
        "material": material_drawings(tpu_material),
        "three cycles": material_drawings(elastic_material),
        "converge": convergence_drawings(converge(folding, TIMESTEP, [4e-4, 3e-4])),
        "assumptions": assumptions_drawings(ASSUMED),
        "study": map_drawings(planted(TWO)),
        "failures": map_drawings(many_ends()),
        "map": static_map_drawings(statics),
        "beside": static_map_drawings(statics, simulated(statics)),
        "stuck": run_drawings(stuck, measure(stuck)),
        "cycling": cycling_drawings(cycling),
    }
    return {f"{of}, {kind}": draw for of, kinds in every.items() for kind, draw in kinds.items()}


KINDS = [
    *(f"run, {kind}" for kind in ("pattern", "angles", "energy", "folding", "package", "strain")),
    *(f"landscape, {kind}" for kind in ("tendon", "wing", "levels")),
    *(f"material, {kind}" for kind in ("cycles", "modulus", "drift", "fit")),
    "three cycles, cycles",
    *(f"converge, {kind}" for kind in ("angles", "times")),
    "assumptions, assumptions",
    *(f"failures, {kind}" for kind in ("status", "torques", "works", "energy")),
    # without failures, and without a legend that takes space from the numbers
    *(f"study, {kind}" for kind in ("torques", "energy", "fold_times")),
    "map, map",
    "beside, map",
    *(f"stuck, {kind}" for kind in ("angles", "energy", "folding")),
    "cycling, cycles",
]
# drawn by the code of another kind with other words; the page width, which has more space, is tested with that kind
DRAWN_BEFORE = (
    *("three cycles, cycles", "study, torques", "study, energy", "beside, map"),
    *("stuck, angles", "stuck, energy", "stuck, folding"),
)


@pytest.mark.parametrize("width", [COLUMN_WIDTH, PAGE_WIDTH])
def test_a_wide_legend_gets_fewer_columns_and_then_wrapped_words(width):
    for names in (["short"] * 3, ["of a length that is no longer short"] * 5, ["longer than a page is wide " * 6]):
        with figure_style():
            figure = Figure(figsize=(width, 3), layout="constrained")
            figure.subplots()
            handles = [Line2D([], [], label=f"{number} {name}") for number, name in enumerate(names)]
            legend = fit_legend(figure, handles, 3, loc="outside lower center")
            check_inside(figure)
        output = " ".join(text.get_text() for text in legend.get_texts()).split()
        assert output == " ".join(handle.get_label() for handle in handles).split()


@pytest.mark.parametrize(
    ("kind", "width"),
    [*((kind, COLUMN_WIDTH) for kind in KINDS), *((kind, PAGE_WIDTH) for kind in KINDS if kind not in DRAWN_BEFORE)],
)
def test_all_words_of_a_figure_can_be_read_and_a_text_reports_its_numbers(drawings, kind, width):
    check_words(drawings[kind](width), width)
