import math

import numpy as np
import pytest

import forficula as ff
from forficula import InputError
from forficula.cli import main
from forficula.goals.clicks.clicked_angles import foreshortened_angles, turn_angles

PRIOR = {"crease.damping": {"distribution": "log-uniform", "low": "0.02 N m s/rad/m", "high": "0.08 N m s/rad/m"}}
DAMPING = 0.04  # N m s/rad/m


def clicked_film(turns, times, accuracy=1.0, seed=0):
    """Return the tables of a film that looks along a crease with these turns, rad."""
    random, frames = np.random.default_rng(seed), []
    for time, turn in zip(times, turns, strict=True):
        places = {
            "middle": np.array([200.0, 300]),
            "hinge": np.array([400.0, 300]),
            "rim": np.array([400 + 200 * math.cos(turn), 300 - 200 * math.sin(turn)]),
        }
        clicks = {name: (random.normal(0, accuracy, 2) + place).tolist() for name, place in places.items()}
        frames.append({"time": f"{time:.4f} s", **clicks})
    return {
        "design": "letter-fold",
        "transition": "close",
        "accuracy": accuracy,
        "angle": {"creases": {"points": ["middle", "hinge", "rim"]}},
        "frame": frames,
    }


TIMES = np.arange(0, 0.4, 0.04)
RAMP = clicked_film(np.radians(200 * TIMES), TIMES)


def test_uncertainty_of_a_turn_agrees_with_the_spread_of_repeated_clicks():
    random, turn = np.random.default_rng(1), math.radians(50)
    points = np.array([[200, 300], [400, 300], [400 + 120 * math.cos(turn), 300 - 120 * math.sin(turn)]])
    angles, deviations = turn_angles(points + random.normal(0, 1.5, (4000, 3, 2)), 1.5)
    assert angles.mean() == pytest.approx(turn, abs=1e-3)
    assert angles.std() == pytest.approx(deviations.mean(), rel=0.05)
    expected = 1.5 * math.sqrt(2 / 200**2 + 2 / 120**2 + 2 * math.cos(turn) / (200 * 120))
    assert deviations.mean() == pytest.approx(expected, rel=0.01)


def test_foreshortening_gives_the_inclination_but_not_near_zero():
    angles, deviations = foreshortened_angles(0.1 * np.cos(np.radians([0, 30, 60])), 0.1, 1e-4)
    np.testing.assert_allclose(np.degrees(angles), [0, 30, 60], atol=1e-5)
    np.testing.assert_allclose(deviations[1:], math.sqrt(2) * 1e-3 / np.sin(np.radians([30, 60])), rtol=1e-6)
    assert deviations[0] == pytest.approx(math.sqrt(2 * math.sqrt(2) * 1e-3))


def test_a_planted_damping_is_identified_from_a_film():
    design = ff.load_design("letter-fold").with_values({"crease.damping": f"{DAMPING} N m s/rad/m"})
    record = ff.run(design).record.data
    turns = np.interp(0.3 + TIMES, record["time"].values, record["hinge_angle"].values[:, 1])
    film = {**clicked_film(turns, TIMES), "facts": 2, "unknown": PRIOR, "sampling": {"samples": 8, "directed": 0}}
    motion = ff.trace_clicks(film)
    assert len(motion.passages) == 2
    agrees = ff.identify(motion.observations)["crease_damping"].attrs
    assert agrees["agrees_low"] < DAMPING < agrees["agrees_high"]
    assert agrees["agrees_high"] / agrees["agrees_low"] < 1.5


def test_facts_are_passages_of_the_goal_up_to_that_of_the_design():
    motion = ff.trace_clicks(RAMP)
    assert 0 < len(motion.passages) <= 4
    assert all(passage.angle < math.radians(90) for passage in motion.passages)
    for passage, fact in zip(motion.passages, motion.observations["fact"], strict=True):
        assert abs(passage.angle - math.radians(200 * passage.time)) < 3 * 0.012
        assert fact["settings"]["protocol.stages.1.until"].startswith("creases > ")
    assert any("one view" in remark.lower() for remark in motion.remarks)


def test_a_film_in_which_a_facet_is_foreshortened_gives_inclinations():
    film = {**RAMP, "scale": [[0, 0], [100, 0]], "length": "5 cm"}
    # the camera looks at the sheet from above: the rim moves towards the hinge
    places = [400 + 200 * math.cos(math.radians(200 * time)) for time in TIMES]
    film["frame"] = [
        {"time": f"{t:.2f} s", "hinge": [400, 300], "rim": [x, 300]} for t, x in zip(TIMES, places, strict=True)
    ]
    film["angle"] = {"creases": {"points": ["hinge", "rim"], "length": "10 cm"}}
    (angle,) = ff.trace_clicks(film).angles
    np.testing.assert_allclose(np.degrees(angle.angles), 200 * TIMES, atol=1e-4)
    assert angle.deviations[0] > 5 * angle.deviations[-1]
    with pytest.raises(
        InputError, match="need at least the longest clicked distance, 10 cm, got 8 cm; check the scale"
    ):
        ff.trace_clicks({**film, "angle": {"creases": {"points": ["hinge", "rim"], "length": "8 cm"}}})


def test_a_film_is_written_as_observations_file(tmp_path, capsys):
    import tomli_w

    film = tmp_path / "film.toml"
    film.write_text(tomli_w.dumps({**RAMP, "unknown": PRIOR}), encoding="utf-8")
    main(["trace", str(film), "--out", str(tmp_path / "out")])
    assert "forficula identify" in capsys.readouterr().out
    from forficula.goals.identify import load_observations

    assert len(load_observations(tmp_path / "out" / "observations.toml").facts) == 4
    assert (tmp_path / "out" / "motion.png").is_file()


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"frame": RAMP["frame"][:2]}, "frame: need at least 3 tables .* got 2"),
        ({"frame": RAMP["frame"][::-1]}, "frame: need pictures in the order of their times"),
        ({"frame": [*RAMP["frame"], {"time": "1 s"}]}, "frame 10: middle: is missing"),
        ({"transition": "shut"}, 'transition: need "close" or "open", got "shut"'),
        ({"accuracy": 0}, "accuracy: need a number > 0, got 0"),
        (
            {"angle": {"mouth": {"points": ["middle", "hinge", "rim"]}}},
            "angle.mouth.name: need creases, on which the goal of the stage close",
        ),
        (
            {"design": "binder2025", "transition": "fold"},
            "angle.creases.key: is missing; give the key that sets the angle of the goal folded",
        ),
        ({"angle": {"creases": {"points": ["hinge", "rim"]}}}, "angle.creases.length: is missing"),
        (
            {"angle": {"creases": {"points": ["a", "hinge", "rim"]}}},
            'angle.creases.points: need "middle", "hinge" or "rim"',
        ),
    ],
)
def test_films_that_determine_no_angle_are_refused(change, message):
    with pytest.raises(InputError, match=message):
        ff.trace_clicks({**RAMP, **change})
