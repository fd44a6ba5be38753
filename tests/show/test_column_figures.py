"""Every figure as wide as a journal's column: its words are large enough, inside it, and not on one another."""

import itertools
from unittest import mock

import pytest
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.text import Text
from matplotlib.transforms import Affine2D

from forficula.design import with_values
from forficula.show.folder.convergence_folder import convergence_drawings
from forficula.show.folder.cycling_folder import cycling_drawings
from forficula.show.folder.landscape_folder import landscape_drawings
from forficula.show.folder.material_folder import material_drawings
from forficula.show.folder.run_folder import run_drawings
from forficula.show.folder.static_map_folder import static_map_drawings
from forficula.show.study.maps import map_drawings
from forficula.show.style import COLUMN_WIDTH, PAGE_WIDTH, description
from forficula.study.convergence import converge
from forficula.study.cycling import Cycling
from forficula.study.refinement import TIMESTEP
from forficula.study.static_map import map_study, static_map
from tests.show.folder.test_cycling_folder import STUCK
from tests.show.folder.test_cycling_folder import run as cycle
from tests.show.study.test_convergence_figure import STAGES
from tests.show.study.test_maps import TWO, many_ends, planted

_FINE = 3
SMALLEST = 6.0  # pt, below which journals refuse
# what is drawn on purpose over something else, or as one word
OVER = ("a", "b", "c")


@pytest.fixture(scope="module")
def drawings(reference, reference_run, reference_outcome, surveyed, tpu_material):
    """What draws every figure there is, by a name."""
    over = {"tendon.stiffness": "10..30 N/cm step 10", "tendon.rest_length": "5..9 cm step 1"}
    folding = with_values(reference, {"protocol.stages": STAGES})
    runs = (*(cycle(number) for number in range(1, 5)), cycle(5, **STUCK))
    cycling = Cycling(design=reference, runs=runs, seen=(2, 4), opens=True, verdict="Up to cycle 4.", remarks=())
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


def words(figure):
    """Every text that is drawn, and its box in points from the lower left corner."""
    # finer than points: at one pixel a point letters are rounded to whole ones, and lines of them are longer
    figure.set_dpi(72 * _FINE)
    canvas = FigureCanvasAgg(figure)
    seen, draw = [], Text.draw

    def note(text, renderer, *others):
        if text.get_visible() and text.get_text().strip():
            seen.append(text)
        return draw(text, renderer, *others)

    with mock.patch.object(Text, "draw", note):
        canvas.draw()
    shrink = Affine2D().scale(1 / _FINE)
    boxes = [Text.get_window_extent(text, canvas.get_renderer()) for text in dict.fromkeys(seen)]
    return [(text, box.transformed(shrink)) for text, box in zip(dict.fromkeys(seen), boxes, strict=True)]


KINDS = [
    *(f"run, {kind}" for kind in ("pattern", "angles", "energy", "folding")),
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
    figure = drawings[kind](width)
    assert figure.get_figwidth() <= width
    boxes = words(figure)
    assert boxes
    assert min(text.get_fontsize() for text, _ in boxes) >= SMALLEST
    across, upwards = 72 * figure.get_size_inches()
    for text, box in boxes:
        outside = max(-box.x0, box.x1 - across, -box.y0, box.y1 - upwards)
        assert outside < 2, f"{text.get_text()!r} sticks out by {outside:.1f} pt"
    for (one, first), (other, second) in itertools.combinations(boxes, 2):
        if one.get_text() in OVER or other.get_text() in OVER:
            continue
        common = (
            min(first.x1, second.x1) - max(first.x0, second.x0),
            min(first.y1, second.y1) - max(first.y0, second.y0),
        )
        assert min(common) < 1.5, f"{one.get_text()!r} lies on {other.get_text()!r}"
    told = description(figure)
    assert told.endswith(".")
    assert len(told) > 60
    assert any(letter.isdigit() for letter in told)
