import math
from dataclasses import replace

import numpy as np
import pytest

import forficula as ff
from forficula import InputError
from forficula.cli import main
from forficula.dynamics.stepping.timestep import stable_timestep
from forficula.goals.clicks.fan_fit import fit_fan
from forficula.goals.clicks.fan_least_squares import FanClicks
from forficula.pattern import EarwigFan, hub_points, ring_vertices, tips

NUMBERS = ("proximal_length", "distal_length", "hub_radius", "sector_angle")
FAN = EarwigFan(proximal_length=0.026, distal_length=0.034, hub_radius=0.0045, sector_angle=math.radians(13), units=3)
SCALE = {"scale": [[0, 0], [100, 0]], "length": "1 cm"}


def points_of(fan, turn=0.0, shift=0j, mirrored=False):
    """Return base, ring vertex and tip of every vein of a placed fan, m, shape (veins, 3, 2)."""
    parts = [part[:, 0] + 1j * part[:, 1] for part in (hub_points(fan), ring_vertices(fan), tips(fan))]
    places = np.stack(parts, axis=1)
    places = (places.conj() if mirrored else places) * np.exp(1j * turn) + shift
    return np.stack([places.real, places.imag], axis=-1)


def in_pixels(points):
    return points * [1e4, -1e4] + [700, 900]


@pytest.mark.parametrize("mirrored", [False, True])
@pytest.mark.parametrize("reverse", [False, True])
def test_an_exact_fan_is_recovered_wherever_it_lies(mirrored, reverse):
    points = points_of(FAN, 2.3, 0.1 - 0.3j, mirrored)[:: -1 if reverse else 1]
    points[:, 0] = np.nan
    fit = fit_fan(FanClicks(points=points))
    for name in NUMBERS:
        assert getattr(fit, name).value == pytest.approx(getattr(FAN, name), rel=1e-6)
    assert fit.tangent == ("left" if mirrored else "right")
    assert fit.rms < 1e-9
    assert fit.vein_count == 7


def test_intervals_of_planted_fans_contain_the_four_numbers_as_often_as_they_state():
    random, inside, count = np.random.default_rng(5), np.zeros(4), 200
    for number in range(count):
        fan = replace(
            FAN,
            proximal_length=(length := random.uniform(0.01, 0.05)),
            distal_length=length * random.uniform(0.5, 1.5),
            hub_radius=length * random.uniform(0.08, 0.3),
            sector_angle=math.radians(random.uniform(8, 22)),
            units=1,
        )
        points = points_of(fan, random.uniform(0, 7), complex(*random.normal(0, 0.1, 2)), number % 2 == 1)
        points += random.normal(0, 0.004 * length, points.shape)
        points[:, 0] = np.nan
        fit = fit_fan(FanClicks(points=points, numbers=(0, 1, 2)))
        ranges = [(getattr(fit, name), getattr(fan, name)) for name in NUMBERS]
        inside += [fitted.low <= planted <= fitted.high for fitted, planted in ranges]
    # 95 % of 200 with four standard deviations of a binomial count
    assert (np.abs(inside - 190) <= 4 * math.sqrt(200 * 0.95 * 0.05)).all(), inside


def test_clicked_bases_and_hub_narrow_the_interval_of_the_hub_radius():
    points = points_of(FAN) + np.random.default_rng(0).normal(0, 1e-4, (7, 3, 2))
    without = points.copy()
    without[:, 0] = np.nan
    numbers = tuple(range(7))
    wide = fit_fan(FanClicks(points=without, numbers=numbers)).hub_radius
    narrow = fit_fan(FanClicks(points=points, hub=np.zeros(2), numbers=numbers)).hub_radius
    assert narrow.high - narrow.low < 0.7 * (wide.high - wide.low)
    assert narrow.low < FAN.hub_radius < narrow.high


def test_a_vein_that_was_not_clicked_is_noticed():
    points = np.delete(points_of(FAN), 3, axis=0)
    points[:, 0] = np.nan
    fit = fit_fan(FanClicks(points=points))
    assert [vein.vein for vein in fit.veins] == [0, 1, 2, 4, 5, 6]
    assert fit.sector_angle.value == pytest.approx(FAN.sector_angle)
    assert "vein 3 was not clicked" in fit.doubts[0]


def test_perspective_is_corrected_by_four_corners():
    from forficula.pattern.picture.homography import homography, mapped_points

    corners = np.array([[100.0, 80], [1100, 130], [1040, 900], [60, 850]])
    sheet = np.array([[0, 0.2], [0.3, 0.2], [0.3, 0], [0, 0]])
    places = mapped_points(homography(sheet, corners), points_of(FAN, 1.0, 0.1 + 0.1j))
    fit = ff.trace_clicks(
        {"corners": corners.tolist(), "size": "30 x 20 cm", "ring": places[:, 1], "tip": places[:, 2]}
    )
    assert fit.hub_radius.value == pytest.approx(FAN.hub_radius, rel=1e-5)


def test_a_fan_of_different_veins_explains_planted_differences():
    fan = replace(FAN, distal_shares=(0.9, 0.97, 1.02, 1.05, 1.04, 1.0, 0.93))
    places = in_pixels(points_of(fan, 0.4, mirrored=True))
    fit = ff.trace_clicks({**SCALE, "ring": places[:, 1], "tip": places[:, 2]})
    assert fit.rms > 1e-3
    assert fit.different.rms < 1e-6
    np.testing.assert_allclose(sorted(fit.different.distal_lengths), sorted(0.034 * np.array(fan.distal_shares)), 1e-4)
    assert fit.different.design.pattern.distal_shares is not None


def test_the_design_has_the_fitted_pattern():
    places = in_pixels(points_of(replace(FAN, units=1)))
    fit = ff.trace_clicks({**SCALE, "ring": places[:, 1], "tip": places[:, 2]})
    pattern = fit.design.pattern
    for name in NUMBERS:
        assert getattr(pattern, name) == pytest.approx(getattr(FAN, name), rel=1e-5)
    assert pattern.units == 1


def test_the_design_of_an_insects_wing_allows_timesteps_similar_to_those_of_the_reference():
    design, reference = ff.trace_clicks("imitated-wing").design, ff.load_design("binder2025")
    factor = design.protocol.window / reference.protocol.window
    assert factor == pytest.approx(0.0216, rel=1e-2)
    assert design.membrane.damping == pytest.approx(factor * reference.membrane.damping)
    # with the damping of 1 ms of the reference the longest timestep was 0.5 µs
    assert stable_timestep(design) > 0.5 * factor * stable_timestep(reference) > 1e-5
    assert design.shows is None


def test_the_named_wing_is_written_with_figures_and_design(tmp_path, capsys):
    main(["trace", "imitated-wing", "--out", str(tmp_path / "wing")])
    assert "7 veins, 14 clicked points" in capsys.readouterr().out
    names = {path.name for path in (tmp_path / "wing").iterdir()}
    assert {"fan.json", "fan.png", "veins.png", "design.toml", "report.html"} <= names
    # the planted numbers
    fit = ff.trace_clicks("imitated-wing")
    for name, planted in zip(NUMBERS, (2.6e-3, 3.4e-3, 0.45e-3, math.radians(13)), strict=True):
        assert getattr(fit, name).low < planted < getattr(fit, name).high


RING, TIP = in_pixels(points_of(FAN))[:, 1].tolist(), in_pixels(points_of(FAN))[:, 2].tolist()


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"ring": RING[:1], "tip": TIP[:1]}, "need at least 4 clicked points, because a fan and its placement have 7"),
        ({"ring": RING[:3]}, "ring: need the same number of veins, got 3 in ring and 7 in tip"),
        ({"tip": [[]] * 7}, "tip: need at least one point at the tip of a vein, got none"),
        ({"length": None}, "length: is missing"),
        ({"scale": None}, "scale: need two points and their distance .* got neither"),
        ({"corners": [[0, 0]] * 4}, "scale: need .* got both"),
        ({"ring": [*RING[:6], [1, 2, 3]]}, r"ring: entry 6: need a point \[x, y\] in pixels, got \[1, 2, 3\]"),
        ({"numbers": [0, 2, 1, 3, 4, 5, 6]}, "numbers: need 7 whole numbers that begin with 0 and rise"),
        ({"ring": [*RING[:6], [float("nan"), 3]]}, "ring: entry 6: need a point"),
        ({"hub": [1e9, 0]}, "hub: need a point"),
        ({"ring": [[0, 0]] * 2000}, "ring: need at most 1000 points, got 2000"),
        ({"rings": []}, "rings: unknown key"),
        ({"ring": [RING[0]] * 3, "tip": [TIP[0]] * 3}, "do not determine hub radius"),
        ({"ring": [RING[0]] * 3, "tip": [RING[0]] * 3}, "need clicked points at different positions"),
    ],
)
def test_clicks_that_determine_no_fan_are_refused(change, message):
    with pytest.raises(InputError, match=message):
        ff.trace_clicks({**SCALE, "ring": RING, "tip": TIP, **change})


def test_options_of_pictures_are_refused_for_clicks(capsys):
    with pytest.raises(SystemExit):
        main(["trace", "imitated-wing", "--size", "20 cm"])
    assert "cannot be used with --size" in capsys.readouterr().err
