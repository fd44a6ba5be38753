"""Every figure as wide as a journal's column: its words are large enough, inside it, and not on one another."""

import pytest

from forficula.design import with_values
from forficula.show.folder.convergence_folder import convergence_drawings
from forficula.show.folder.cycling_folder import cycling_drawings
from forficula.show.folder.landscape_folder import landscape_drawings
from forficula.show.folder.material_folder import material_drawings
from forficula.show.folder.run_folder import run_drawings
from forficula.show.folder.static_map_folder import static_map_drawings
from forficula.show.study.maps import map_drawings
from forficula.show.style import COLUMN_WIDTH, PAGE_WIDTH
from forficula.structure import structure_of
from forficula.study.convergence import converge
from forficula.study.cycling import Cycling, driven_transitions
from forficula.study.refinement import TIMESTEP
from forficula.study.static_map import map_study, static_map
from tests.show.folder.test_cycling_folder import STUCK
from tests.show.folder.test_cycling_folder import run as cycle
from tests.show.legible import check_words
from tests.show.study.test_convergence_figure import STAGES
from tests.show.study.test_maps import TWO, many_ends, planted


@pytest.fixture(scope="module")
def drawings(reference, reference_run, reference_outcome, surveyed, tpu_material):
    """What draws every figure there is, by a name."""
    over = {"tendon.stiffness": "10..30 N/cm step 10", "tendon.rest_length": "5..9 cm step 1"}
    folding = with_values(reference, {"protocol.stages": STAGES})
    runs = (*(cycle(number) for number in range(1, 5)), cycle(5, **STUCK))
    driven = driven_transitions(structure_of(reference))
    cycling = Cycling(
        design=reference, runs=runs, seen=(2, 4), transitions=driven, verdict="Up to cycle 4.", remarks=()
    )
    statics = static_map(map_study(reference, over))
    every = {
        "run": run_drawings(reference_run, reference_outcome),
        "landscape": landscape_drawings(surveyed("reference"), reference_run),
        "material": material_drawings(tpu_material),
        "converge": convergence_drawings(converge(folding, TIMESTEP, [4e-4, 3e-4])),
        "study": map_drawings(planted(TWO)),
        "failures": map_drawings(many_ends()),
        "map": static_map_drawings(statics),
        "cycling": cycling_drawings(cycling),
    }
    return {f"{of}, {kind}": draw for of, kinds in every.items() for kind, draw in kinds.items()}


KINDS = [
    *(f"run, {kind}" for kind in ("pattern", "angles", "energy", "folding", "package")),
    *(f"landscape, {kind}" for kind in ("tendon", "wing", "levels")),
    *(f"material, {kind}" for kind in ("cycles", "modulus", "drift", "fit")),
    *(f"converge, {kind}" for kind in ("angles", "times")),
    *(f"{of}, {kind}" for of in ("study", "failures") for kind in ("status", "torques", "works", "energy")),
    "study, fold_times",
    "map, map",
    "cycling, cycles",
]


@pytest.mark.parametrize("width", [COLUMN_WIDTH, PAGE_WIDTH])
@pytest.mark.parametrize("kind", KINDS)
def test_all_words_of_a_figure_can_be_read_and_a_text_tells_its_numbers(drawings, kind, width):
    check_words(drawings[kind](width), width)
