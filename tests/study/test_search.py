import math
from dataclasses import replace

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import forficula as ff
from forficula.analysis import Ending, Verdict
from forficula.structure import structure_of
from forficula.study.files.search_file import read_search
from forficula.study.running.evaluate import ending_row
from forficula.study.search import search_designs, search_result
from forficula.study.study_designs import first_design, point_design, release_design, second_design

DESIGN = ff.load_design("binder2025")
FOLD, UNFOLD = structure_of(DESIGN).transitions
GRID = read_search(
    "least-torques",
    {
        "fold_torques": ["0 N m", "0.1 N m", "0.2 N m", "0.3 N m"],
        "fold_with": "5 N m",
        "unfold_torques": ["0.1 N m", "0.2 N m", "0.3 N m"],
    },
    DESIGN,
)


def no_torque(_):
    return False


def any_torque(_):
    return True


def refined(times):
    return replace(GRID, refinements=times)


ENDINGS = {
    "folded": Ending(verdict=Verdict.REACHED, transition=FOLD, residual=1e-3),
    "did not fold": Ending(verdict=Verdict.STUCK, transition=FOLD, residual=1e-3),
    "did not open": Ending(verdict=Verdict.STUCK, transition=UNFOLD, residual=1e-3),
    "folded and opened": Ending(verdict=Verdict.REACHED, transition=UNFOLD, residual=1e-3),
    "stuck at -134.6 deg": Ending(verdict=Verdict.STUCK, transition=FOLD, reading=math.radians(-134.6), residual=1e-3),
    "did not stay folded": Ending(verdict=Verdict.NOT_HELD, transition=FOLD, residual=1e-3),
    "diverged at t = 0.2 s": Ending(verdict=Verdict.DIVERGED, transition=FOLD, time=0.2),
    "unreliable: the energy balance misses 12 %": Ending(verdict=Verdict.UNTRUSTED, transition=FOLD, residual=0.12),
}


def answer(status, **numbers):
    """A row as from a run."""
    ending = ENDINGS.get(status) or Ending(
        verdict=Verdict.STUCK, transition=FOLD, reading=math.radians(float(status.split()[2])), residual=1e-3
    )
    row = ending_row(ending)
    assert row["status"] == status
    unknown = dict.fromkeys(
        f"{name}_{quantity}" for name in ("fold", "unfold") for quantity in ("time_s", "work_J")
    ) | dict.fromkeys(f"{name}_energy_J" for name in ("flat", "folded", "opened"))
    reached, tells = ending.verdict is Verdict.REACHED, ending.verdict.conclusive
    return {
        **row,
        "folded": (reached or ending.transition is UNFOLD) if tells else None,
        "opened": (reached and ending.transition is UNFOLD) if tells else None,
        **unknown,
        **({"flat_energy_J": 3.0} | numbers if tells else {}),
    }


def answers(design, folds, opens, large="folded", released="folded", untrusted=()):
    """The row that a run of a planted design would give."""
    protocol = design.protocol
    torque, opening = protocol.fold_torque, protocol.unfold_torque
    if torque != GRID.reference:
        if torque in untrusted:
            return answer("unreliable: the energy balance misses 12 %")
        if not folds(torque):
            return answer(f"stuck at -{10 + 100 * torque:.1f} deg")
        if released != "folded" and protocol.stages[-1].drive == "none":
            return answer(released, fold_work_J=torque)
        return answer("folded", fold_time_s=0.1 / torque if torque else 9.0, fold_work_J=torque, folded_energy_J=0.5)
    if large != "folded":
        return answer(large)
    if opening in untrusted:
        return answer("unreliable: the energy balance misses 12 %")
    if not opens(opening):
        return answer("did not open")
    return answer("folded and opened", unfold_time_s=0.1 / opening, unfold_work_J=2 * opening, opened_energy_J=2.9)


def search_with(search, folds, opens=no_torque, large="folded", released="folded", untrusted=()):
    """Repeat until nothing is missing, and return the result and every design that had to run."""
    rows, run = {}, []
    while missing := [item for item in search_designs(DESIGN, search, rows).items() if item[0] not in rows]:
        for key, entry in missing:
            rows[key] = {"key": key, **answers(entry, folds, opens, large, released, untrusted)}
            run.append(entry)
    return search_result(DESIGN, search, rows), run


def test_the_least_torques_are_the_first_steps_that_work():
    result, run = search_with(GRID, lambda torque: torque >= 0.2, lambda torque: torque >= 0.3)
    assert (result["least_fold_torque"], result["least_unfold_torque"]) == (0.2, 0.3)
    assert (result["fold_time"], result["fold_work"], result["folded_energy"]) == (0.5, 0.2, 0.5)
    assert (result["unfold_time"], result["unfold_work"], result["opened_energy"]) == (0.1 / 0.3, 0.6, 2.9)
    assert (result["flat_energy"], result["status"]) == (
        3.0,
        "folded and opened (fold with 500 N cm, unfold with 30 N cm)",
    )
    assert len(run) == 4 + 3 + 1


def test_least_success_counts_even_if_success_is_not_monotone():
    result, _ = search_with(GRID, lambda torque: torque in (0.1, 0.3), lambda torque: torque == 0.2)
    assert (result["least_fold_torque"], result["least_unfold_torque"]) == (0.1, 0.2)


def test_a_tendon_that_folds_with_a_small_but_not_the_large_torque_has_a_row_that_says_so():
    result, _ = search_with(GRID, lambda torque: torque >= 0.1, large="stuck at -134.6 deg")
    assert result["least_fold_torque"] == 0.1
    assert result["least_unfold_torque"] is None
    assert result["status"] == "with 500 N cm: stuck at -134.6 deg"
    assert result["reference_outcome"] == "stuck on the way"
    assert result["fold_work"] == 0.1


@pytest.mark.parametrize(
    ("opens", "large", "after"),
    [
        (any_torque, "folded", "folded and opened"),
        (no_torque, "folded", "did not open"),
        (no_torque, "stuck at -134.6 deg", "stuck at -134.6 deg"),
    ],
)
def test_a_wing_whose_release_fails_has_a_row_that_says_so(opens, large, after):
    released = "did not stay folded"
    result, _ = search_with(GRID, lambda torque: torque >= 0.2, opens, large, released)
    assert result["least_fold_torque"] == 0.2
    assert result["status"] == f"{released}; with 500 N cm: {after}"
    assert (result["fold_outcome"], result["fold_time"]) == (released, None)


NUMBERS = (
    *("least_fold_torque", "fold_time", "fold_work", "flat_energy", "folded_energy"),
    *("least_unfold_torque", "unfold_time", "unfold_work", "opened_energy"),
)


@pytest.mark.parametrize(
    ("released", "word"),
    [
        ("diverged at t = 0.2 s", "diverged"),
        ("unreliable: the energy balance misses 12 %", "unreliable"),
    ],
)
def test_an_inconclusive_release_leaves_the_point_without_numbers(released, word):
    result, _ = search_with(GRID, lambda torque: torque >= 0.2, any_torque, released=released)
    assert [result.get(name) for name in NUMBERS] == [None] * len(NUMBERS)
    assert (result["status"], result["outcome"], result["fold_outcome"]) == (released, word, word)


def test_an_unreliable_run_below_the_least_folding_torque_leaves_the_point_without_numbers():
    result, run = search_with(GRID, lambda torque: torque >= 0.2, any_torque, untrusted=[0.1])
    assert [result.get(name) for name in NUMBERS] == [None] * len(NUMBERS)
    assert (result["verdict"], result["outcome"]) == ("untrusted", "unreliable")
    assert result["status"] == "unreliable: the energy balance misses 12 %"
    assert (result["residual"], result["reference_outcome"]) == (0.12, "")
    # the torque for the next transition is unknown
    assert [item.protocol.stages[-1].drive for item in run] == ["fold"] * 4


def test_an_unreliable_run_above_the_least_folding_torque_is_only_reported():
    result, _ = search_with(GRID, lambda torque: torque == 0.1, any_torque, untrusted=[0.3])
    assert (result["least_fold_torque"], result["least_unfold_torque"]) == (0.1, 0.1)
    assert (result["verdict"], result["residual"]) == ("reached", 0.12)


def test_an_unreliable_run_below_the_least_opening_torque_leaves_none():
    # 0.15 N m is tried for opening only after 0.2 N m has opened
    result, _ = search_with(
        refined(1), lambda torque: torque >= 0.3, lambda torque: torque >= 0.2, untrusted=[(0.1 + 0.2) / 2]
    )
    assert (result["least_fold_torque"], result["fold_work"]) == (0.3, 0.3)
    assert [result.get(name) for name in NUMBERS[5:]] == [None] * 4
    assert (result["verdict"], result["outcome"]) == ("untrusted", "unreliable")
    assert result["status"] == "with 500 N cm: unreliable: the energy balance misses 12 %"


def test_a_tendon_that_no_torque_folds_says_how_it_failed_with_the_largest_of_the_grid():
    result, run = search_with(GRID, no_torque)
    assert result["least_fold_torque"] is None
    assert "fold_work" not in result
    # opening is searched only for tendons that fold
    assert (result["status"], result["reference_outcome"]) == ("stuck at -40.0 deg (fold with 30 N cm)", "")
    assert [item.protocol.stages[-1].drive for item in run] == ["fold"] * 4


def test_a_tendon_that_no_torque_opens_says_so():
    result, _ = search_with(GRID, any_torque)
    assert result["least_fold_torque"] == 0.0
    assert (result["least_unfold_torque"], result["status"]) == (
        None,
        "did not open (fold with 500 N cm, unfold with 30 N cm)",
    )
    assert "unfold_work" not in result


def test_the_wing_is_released_at_the_least_torque_that_folds_only():
    _, run = search_with(GRID, lambda torque: torque >= 0.2)
    released = [item for item in run if item.protocol.stages[-1].name == "release folded"]
    assert [item.protocol.fold_torque for item in released] == [0.2]


def test_every_run_of_a_search_differs_from_the_design_in_torques_and_last_stages_only():
    kept = {"fold_torque", "unfold_torque", "stages"}
    for item in (first_design(DESIGN, GRID, 0.1), release_design(DESIGN, GRID, 0.1), second_design(DESIGN, GRID, 0.1)):
        assert item.model_dump(exclude={"protocol"}) == DESIGN.model_dump(exclude={"protocol"})
        assert item.protocol.model_dump(exclude=kept) == DESIGN.protocol.model_dump(exclude=kept)
        assert item.protocol.stages == DESIGN.protocol.stages[: len(item.protocol.stages)]
    designs = [first_design(DESIGN, GRID, 0.1), second_design(DESIGN, GRID, 0.1)]
    assert [design.protocol.stages[-1].name for design in designs] == ["fold", "release opened"]
    assert [design.protocol.fold_torque for design in designs] == [0.1, 5.0]


@settings(max_examples=40, deadline=None)
@given(st.floats(0.001, 0.3), st.integers(0, 8))
def test_bisection_halves_the_step_below_the_least_torque_that_works(barrier, times):
    result, _ = search_with(refined(times), lambda torque: torque >= barrier, lambda torque: torque >= barrier)
    width = 0.1 / 2**times
    # up to rounding of the middles
    assert barrier <= result["least_fold_torque"] <= barrier + width * (1 + 1e-9)
    # there is no step below the first value to bisect
    assert barrier <= result["least_unfold_torque"] <= max(0.1, barrier + width * (1 + 1e-9))


def test_bisection_costs_one_run_a_halving_and_keeps_the_grid():
    _, coarse = search_with(GRID, lambda torque: torque >= 0.17)
    _, fine = search_with(refined(3), lambda torque: torque >= 0.17)
    torques = [
        {item.protocol.fold_torque for item in run if item.protocol.stages[-1].drive == "fold"}
        for run in (coarse, fine)
    ]
    added = sorted(torques[1] - torques[0])
    assert torques[0] < torques[1]
    assert added == pytest.approx([0.15, 0.1625, 0.175])


def test_bisection_stays_below_the_least_that_works_where_success_is_not_monotone():
    def folds(torque):
        return 0.1 <= torque < 0.13 or torque >= 0.27

    result, _ = search_with(refined(4), folds)
    assert result["least_fold_torque"] == 0.1
    result, _ = search_with(refined(4), lambda torque: 0.14 <= torque < 0.16 or torque >= 0.17)
    assert math.isclose(result["least_fold_torque"], 0.14375)


def test_where_nothing_works_nothing_is_bisected():
    _, run = search_with(refined(5), no_torque)
    assert len(run) == 4


def test_a_point_replaces_values_of_the_design():
    design = point_design(DESIGN, {"tendon.stiffness": "33 N/cm", "pattern.units": 2})
    assert (design.tendon.stiffness, design.pattern.units) == (3300.0, 2)


def test_default_torque_before_the_second_drive_is_that_of_a_run():
    design = DESIGN.with_values({"protocol.fold_torque": "40 N cm"})
    assert read_search("least-torques", {}, design).reference == pytest.approx(0.4)
    assert read_search("least-torques", {"fold_with": "500 N cm"}, design).reference == pytest.approx(5.0)
