"""Keys of rows that follow from the values of a point are those of the designs at these points."""

import sys
from pathlib import Path

import pytest

from forficula.design import Design
from forficula.study import load_study
from forficula.study.running.evaluate import row_key
from forficula.study.running.plan import StudyPlan

SAMPLED = """
"tendon.stiffness" = { distribution = "uniform", low = "10 N/cm", high = "60 N/cm" }
"tendon.rest_length" = { distribution = "normal", mean = "6 cm", deviation = "1 cm" }
"vein.density" = { distribution = "log-uniform", low = "0.5 g/cm^3", high = "5 g/cm^3" }
"""


@pytest.fixture
def plan(study_file, monkeypatch):
    """Plan a study as if it had many points."""

    def of(*texts, design="binder2025", **options):
        monkeypatch.setattr(sys.modules["forficula.study.running.plan"], "_MOST_DESIGNS", 1)
        path = Path(study_file(*texts, **options))
        path.write_text(path.read_text().replace('"binder2025"', f'"{design}"'))
        return StudyPlan(load_study(path))

    return of


def keys(plan):
    designs = [plan[number] for number in range(len(plan))]
    return [row_key(design) if isinstance(design, Design) else None for design in designs]


@pytest.mark.parametrize(
    "factors",
    [
        '"tendon.stiffness" = "10..60 N/cm step 10"\n"protocol.fold_torque" = ["10 N cm", "0.5 N m"]',
        # two factors with the same values, and a factor with one value
        '"tendon.proximal_attachment" = ["3 cm", "4 cm", "5 cm"]\n"tendon.distal_attachment" = ["3 cm", "4 cm", "5 cm"]'
        '\n"vein.diameter" = ["5 mm"]',
        # a value of the middle tendon alone
        '"tendon.1.stiffness" = "15..65 N/cm step 10"\n"protocol.timestep" = ["0.2 ms", "0.1 ms"]',
    ],
)
def test_keys_of_a_grid_follow_from_its_values(plan, factors):
    planned = plan(factors)
    assert planned.keys_without_designs(range(len(planned))) == keys(planned)
    assert None not in keys(planned)
    assert planned.keys_without_designs(range(1, len(planned), 2)) == keys(planned)[1::2]


@pytest.mark.parametrize("method", ["random", "sobol"])
def test_keys_of_sampled_points_follow_from_their_values(plan, method):
    planned = plan(SAMPLED, tail=f'[sampling]\nmethod = "{method}"\ncount = 40')
    assert planned.keys_without_designs(range(40)) == keys(planned)


def test_words_need_the_design_and_points_without_a_design_have_another_key(plan):
    planned = plan('"protocol.timestep" = ["auto", "0.2 ms", "0.1 ms", "0.05 ms"]\n"vein.diameter" = ["5 mm", "4 mm"]')
    followed = planned.keys_without_designs(range(8))
    assert followed == [None, None, *keys(planned)[2:]]
    # a hub that is larger than the wing cannot be built
    planned = plan('"pattern.hub_radius" = ["1 cm", "2 cm", "3 cm", "90 cm"]')
    built, followed = keys(planned), planned.keys_without_designs(range(4))
    assert built[-1] is None
    assert followed[-1] not in built
    assert followed[:-1] == built[:-1]


@pytest.mark.parametrize(
    ("factors", "head", "design"),
    [
        ('"pattern.units" = [1, 2, 3]', "", "binder2025"),
        # the stiffness follows from the law and the length
        ('"tendon.rest_length" = ["5 cm", "6 cm", "7 cm"]', "", "binder2025-joint"),
        ('"tendon.stiffness" = ["10 N/cm", "20 N/cm"]', 'ask = "least-torques"', "binder2025"),
    ],
)
def test_other_studies_build_their_designs(plan, factors, head, design):
    planned = plan(factors, head, design=design)
    assert planned.keys_without_designs(range(len(planned))) == [None] * len(planned)
