"""Natural frequencies of nets agree with closed forms: strings of masses, a molecule of four atoms, a pendulum."""

from dataclasses import replace
from itertools import combinations

import numpy as np
import pytest

from forficula.statics.net.energy import built_shape
from forficula.statics.net.minimum import minimum
from forficula.statics.net.modes import natural_modes
from tests.statics.net.nets import truss


@pytest.mark.parametrize("count", [5, 120])
def test_a_taut_string_of_masses_has_lagranges_frequencies(agree, count):
    # Lagrange 1788: 2 sqrt(k / m) sin(j pi / (2 (n + 1))) along it, sqrt(T / (m a)) for sqrt(k / m) across, twice
    stiffness, mass, apart, rest = 50.0, 0.1, 0.2, 0.15
    nodes = np.zeros((count + 2, 3))
    nodes[:, 0] = apart * np.arange(count + 2)
    bars = np.stack((np.arange(count + 1), np.arange(1, count + 2)), axis=1)
    net = truss(nodes, bars, stiffness=stiffness, rest=rest, held=[0, count + 1], masses=np.full(count + 2, mass))
    shares = 2 * np.sin(np.arange(1, count + 1) * np.pi / (2 * (count + 1)))
    tension = stiffness * (apart - rest)
    across, along = np.sqrt(tension / (mass * apart)) * shares, np.sqrt(stiffness / mass) * shares
    known = np.sort(np.concatenate((across, across, along)))[:12]
    modes = natural_modes(net, built_shape(net), 12)
    result = 2 * np.pi * modes.frequencies
    agree(f"frequencies of a string of {count} masses", result, known, unit="rad/s", by="Lagrange 1788", rel=1e-7)
    assert not modes.rigid.any()


def test_a_free_tetrahedron_has_six_rigid_body_motions_and_the_frequencies_of_a_molecule(agree):
    # four equal masses, central forces: 4, 2 and 1 k / m, of one, three and two modes (Herzberg 1945, II.4)
    nodes = np.array([(1, 1, 1), (1, -1, -1), (-1, 1, -1), (-1, -1, 1)])
    net = truss(nodes, list(combinations(range(4), 2)), stiffness=3.0, masses=np.full(4, 0.5))
    modes = natural_modes(net, built_shape(net), 12)
    squares = (2 * np.pi * modes.frequencies[6:]) ** 2 / 6.0
    agree("squared frequencies by k / m", squares, [1, 1, 2, 2, 2, 4], by="Herzberg 1945", rel=1e-9)
    assert list(modes.rigid) == [True] * 6 + [False] * 6
    agree("frequencies of rigid-body motions", modes.frequencies[:6], 0, unit="Hz", by="free motion", abs=1e-6)


def test_stiff_bars_and_light_masses_do_not_disturb_slow_modes(agree):
    # two masses m on a soft spring k have 2 k / m; a stiff bar K to a mass of m / 1e4 has about 1e4 K / m
    nodes = np.array([(0, 0, 0), (1, 0, 0), (1, 1, 0)])
    free = np.zeros((3, 3), dtype=np.bool_)
    free[0, 0] = free[1, 0] = free[2, 1] = True
    bars, stiffness = [[0, 1], [1, 2]], np.array([1.0, 1e7])
    net = replace(truss(nodes, bars, stiffness=1.0, masses=np.array([1.0, 1.0, 1e-4])), free=free)
    net = replace(net, springs=replace(net.springs, stiffness=stiffness))
    modes = natural_modes(net, built_shape(net), 3)
    result = (2 * np.pi * modes.frequencies) ** 2
    agree("square of the slow mode", result[1], 2.0, unit="1/s^2", by="2 k / m", rel=1e-9)
    assert abs(result[0]) < 1e-4 * result[1]


def test_an_unstable_shape_has_a_growth_rate():
    net = truss([[-1, 0, 0], [0, 0, 0], [1, 0, 0]], [[0, 1], [1, 2]], stiffness=50.0, rest=1.1, held=[0, 2])
    modes = natural_modes(net, built_shape(net), 3)
    assert np.sum(modes.frequencies < 0) == 2  # compressed bars move sideways
    assert (2 * np.pi * modes.frequencies[2]) ** 2 == pytest.approx(100.0)


def test_a_pendulum_has_the_frequency_of_its_length(agree):
    net = truss([[0, 0, 0], [0.3, 0, -0.4]], [[0, 1]], stiffness=1e7, held=[0], gravity=9.81)
    hanging = minimum(net, built_shape(net))
    modes = natural_modes(net, hanging.shape)
    result = 2 * np.pi * modes.frequencies[:2]
    agree("frequencies of a pendulum", result, np.sqrt(9.81 / 0.5), unit="rad/s", by="√(g / L)", rel=1e-5)
    agree(
        "position of the hanging mass", hanging.shape.positions[1], (0, 0, -0.5), unit="m", by="straight down", abs=1e-5
    )
