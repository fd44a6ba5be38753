"""Equilibria and barriers of mechanisms other than wings: a von Mises truss and a Kresling cell of elastic bars.

Von Mises truss (von Mises 1923; Bazant and Cedolin 1991, Stability of Structures, section 4.4): two bars of length L0
from two supports, half a span s on either side, meet at an apex at the height r, L0^2 = s^2 + r^2. With springs of
stiffness k, U = k / 2 sum (L - L0)^2: no energy at heights r and -r, a barrier of k (s - L0)^2 between them, and a snap
where the slope s / L of the bars has the cosine (s / L0)^(1/3), at a load of 2 k L0 (1 - (s / L0)^(2/3))^(3/2).

Kresling cell (Cai et al. 2015, doi 10.1115/1.4030158; Masana and Daqaq 2019, doi 10.1103/PhysRevE.100.063001): two
n-gons of radius R, a height h apart and twisted by phi, joined at every corner by a mountain crease of
length^2 = h^2 + 2 R^2 (1 - cos phi) and a valley crease of length^2 = h^2 + 2 R^2 (1 - cos(phi + 2 pi / n)). Both have
the same two lengths in two states: equal differences of length^2 give phi1 + phi2 = pi - 2 pi / n, and equal lengths
h1^2 - h2^2 = 4 R^2 cos(pi / n) sin((phi2 - phi1) / 2).
"""

import math

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st
from scipy.optimize import minimize, minimize_scalar

from forficula.statics.tree.equilibrium import barrier_between, descend, states_along

FREE = (-math.inf, math.inf)
FORCE = 1e-9  # slope that counts as zero


def springs(squares, slopes, curvatures, stiffness, lengths):
    """Return the sum of k / 2 (L - L0)^2 and its derivatives, from those of L^2, (case, bar), (..., i), (..., i, j)."""
    length = np.sqrt(squares)
    by = slopes / (2 * length[..., None])
    outer = by[..., :, None] * by[..., None, :]
    curved = curvatures / (2 * length[..., None, None]) - outer / length[..., None, None]
    pull = stiffness * (length - lengths)
    energy = np.sum(pull * (length - lengths), axis=1) / 2
    curvature = np.sum(stiffness[:, None, None] * outer + pull[..., None, None] * curved, axis=1)
    return energy, np.sum(pull[..., None] * by, axis=1), curvature


class Truss:
    """A von Mises truss, its apex at (x, z), under a load (x, z)."""

    def __init__(self, span=1.0, rise=0.2, stiffness=50.0, load=(0.0, 0.0)):
        self.span, self.rise, self.stiffness, self.load = span, rise, stiffness, np.array(load)
        self.length = math.hypot(span, rise)

    @property
    def barrier(self):
        return self.stiffness * (self.span - self.length) ** 2

    @property
    def snap_load(self):
        return 2 * self.stiffness * self.length * (1 - (self.span / self.length) ** (2 / 3)) ** 1.5

    @property
    def snap_height(self):
        # cos = (s / L0)^(1/3), Bazant and Cedolin, equation 4.4.5
        return self.span * math.tan(math.acos((self.span / self.length) ** (1 / 3)))

    def energy(self, position, _cases=None):
        x, z = position.T
        squares = np.stack([(x + self.span) ** 2 + z**2, (x - self.span) ** 2 + z**2], axis=1)
        slopes = 2 * np.stack([np.stack([x + self.span, z], axis=1), np.stack([x - self.span, z], axis=1)], axis=1)
        curvatures = np.broadcast_to(2 * np.eye(2), (len(x), 2, 2, 2))
        energy, slope, curvature = springs(squares, slopes, curvatures, np.full(2, self.stiffness), self.length)
        return energy - position @ self.load, slope - self.load, curvature

    def path(self, heights):
        """Return the path along the vertical, x = 0."""
        energy, slope, _ = self.energy(np.stack([np.zeros_like(heights), heights], axis=1))
        return energy, slope[:, 1]

    def rest(self, start, lower=(-math.inf,) * 2, upper=(math.inf,) * 2):
        return descend(self.energy, np.atleast_2d(start), lower, upper, longest_step=0.05, force=FORCE * self.stiffness)


class Kresling:
    """A Kresling cell of radius 1 with zero energy at two heights; coordinates are height and twist."""

    def __init__(self, high=2.0, low=1.3, corners=6, mountain=3.0, valley=1.0):
        step = 2 * math.pi / corners
        turn = 2 * math.asin((high**2 - low**2) / (4 * math.cos(step / 2)))
        self.states = np.array([[high, (math.pi - step - turn) / 2], [low, (math.pi - step + turn) / 2]])
        self.shift = np.array([0.0, step])
        self.stiffness = corners * np.array([mountain, valley])
        self.lengths = np.sqrt(high**2 + 2 * (1 - np.cos(self.states[0, 1] + self.shift)))

    def energy(self, position, _cases=None):
        height, twist = position[:, :1], position[:, 1:] + self.shift
        squares = height**2 + 2 * (1 - np.cos(twist))
        slopes = np.stack([np.broadcast_to(2 * height, twist.shape), 2 * np.sin(twist)], axis=2)
        curvatures = np.zeros((*twist.shape, 2, 2))
        curvatures[..., 0, 0], curvatures[..., 1, 1] = 2, 2 * np.cos(twist)
        return springs(squares, slopes, curvatures, self.stiffness, self.lengths)

    def path(self, twists):
        """Return the least energy over all heights at every twist, and its slope (envelope theorem)."""
        start = np.stack([np.full_like(twists, self.states[:, 0].mean()), twists], axis=1)
        result = descend(
            self.energy,
            start,
            np.stack([np.zeros_like(twists), twists], axis=1),
            np.stack([np.full_like(twists, np.inf), twists], axis=1),
            longest_step=0.1,
            force=FORCE,
        )
        return result.energy, result.slope[:, 1]


shapes = st.tuples(st.floats(0.5, 2), st.floats(0.05, 0.5), st.floats(1, 1e3))


@given(shapes, st.floats(0.01, 2), st.sampled_from([-1, 1]))
def test_a_truss_falls_to_the_side_on_which_it_starts(shape, share, side):
    truss = Truss(*shape)
    result = truss.rest([0.0, side * share * truss.rise])
    assert result.rests.all()
    # both bars, vertically and sideways: 2 k (r / L0)^2, 2 k (s / L0)^2
    stiffness = 2 * truss.stiffness * min(truss.span, truss.rise) ** 2 / truss.length**2
    assert result.position[0] == pytest.approx([0, side * truss.rise], abs=2 * FORCE * truss.stiffness / stiffness)
    assert result.energy[0] == pytest.approx(0, abs=2 * (FORCE * truss.stiffness) ** 2 / stiffness)
    # error from the height, at most 4e-7 of 0.05
    assert result.stiffness[0] == pytest.approx(stiffness, rel=1e-4)


@given(shapes)
def test_the_states_and_the_barrier_of_a_truss_are_those_of_the_closed_form(shape):
    truss = Truss(*shape)
    heights = np.linspace(-1.5 * truss.rise, 1.5 * truss.rise, 30)
    states = states_along(truss.path, heights, force=1e-9)
    assert [state.kind for state in states] == ["minimum", "maximum", "minimum"]
    assert [state.stable for state in states] == [True, False, True]
    # rounding of a length divided by the slope of the bars
    assert [state.coordinate for state in states] == pytest.approx([-truss.rise, 0, truss.rise], abs=1e-12)
    barrier = pytest.approx(truss.barrier, rel=1e-9)
    assert barrier_between(states, states[0], states[2]) == barrier
    assert barrier_between(states, states[2], states[0]) == barrier
    assert states[1].energy == barrier


@settings(max_examples=20)
@given(shapes)
def test_a_truss_snaps_at_its_snap_load(shape):
    unloaded = Truss(*shape)
    below, above = (Truss(*shape, load=(0, -share * unloaded.snap_load)) for share in (0.9999, 1.0001))
    held = below.rest([0.0, below.rise])
    assert held.rests.all()
    assert held.position[0, 1] > below.snap_height
    # load over height is a parabola at its maximum: 1e-4 of the load is about 1e-2 of the height
    assert held.position[0, 1] == pytest.approx(below.snap_height, rel=0.03)
    gone = above.rest([0.0, above.rise])
    assert gone.rests.all()
    assert gone.position[0, 1] < -above.rise


@given(shapes, st.floats(-0.9, 0.9), st.floats(-0.5, 0.5))
def test_a_truss_under_a_skewed_load_rests_where_another_minimiser_finds_it(shape, down, aside):
    unloaded = Truss(*shape)
    truss = Truss(*shape, load=(aside * unloaded.snap_load, -down * unloaded.snap_load))
    result = truss.rest([0.0, truss.rise])
    other = minimize(
        lambda x: truss.energy(x[None])[0][0],
        result.position[0] + 1e-3 * truss.rise,
        jac=lambda x: truss.energy(x[None])[1][0],
        method="BFGS",
        options={"gtol": 1e-9 * truss.stiffness},
    )
    assert result.rests.all()
    # BFGS stops at the rounding of the energy, the square of the position's
    assert result.position[0] == pytest.approx(other.x, abs=1e-6)
    assert result.energy[0] <= other.fun + 1e-12 * truss.stiffness


def test_a_load_moves_the_states_and_lowers_the_barrier():
    truss = Truss(load=(0, -0.5 * Truss().snap_load))
    states = states_along(truss.path, np.linspace(-0.4, 0.4, 81), force=1e-9)
    assert [state.kind for state in states] == ["minimum", "maximum", "minimum"]
    inverted, saddle, upright = states
    assert 0 < saddle.coordinate < truss.snap_height < upright.coordinate < truss.rise
    assert barrier_between(states, upright, inverted) < truss.barrier < barrier_between(states, inverted, upright)


def test_beyond_the_snap_load_there_is_no_barrier():
    truss = Truss(load=(0, -1.1 * Truss().snap_load))
    states = states_along(truss.path, np.linspace(-0.4, 0.2, 61), force=1e-9)
    (inverted,) = states
    assert inverted.kind == "minimum"
    assert inverted.coordinate < -truss.rise
    assert barrier_between(states, inverted, inverted) == 0


def test_the_ends_of_a_path_are_stops_where_the_slope_presses_on_them():
    truss = Truss()
    low, high = -0.1, 0.15
    states = states_along(truss.path, np.linspace(low, high, 20), force=1e-9)
    assert [state.kind for state in states] == ["stop", "maximum", "stop"]
    # force of two bars at that height: 2 k (L0 - L) z / L
    for state, place in ((states[0], low), (states[2], high)):
        length = math.hypot(truss.span, place)
        force = 2 * truss.stiffness * (truss.length - length) * abs(place) / length
        assert (state.coordinate, state.press) == (place, pytest.approx(force))
        assert state.stable
    assert barrier_between(states, states[0], states[2]) == pytest.approx(truss.barrier - states[0].energy)


def test_a_wide_stretch_without_a_slope_is_a_neutral_range():
    def slack(x):
        taut = np.maximum(np.abs(x) - 1, 0)
        return taut**2 / 2, np.sign(x) * taut

    (neutral,) = states_along(slack, np.linspace(-3, 3, 61), force=1e-9)
    assert (neutral.kind, neutral.energy, neutral.press) == ("neutral", 0, 0)
    # resolution of the sampled positions
    assert (neutral.coordinate, neutral.far_coordinate) == pytest.approx((-1, 1))
    (everything,) = states_along(lambda x: (0 * x, 0 * x), np.linspace(-3, 3, 61), force=0)
    assert (everything.coordinate, everything.far_coordinate) == (-3, 3)


def test_a_slope_that_keeps_its_sign_leaves_one_stop():
    (stop,) = states_along(lambda x: (x, np.ones_like(x)), np.array([0.0, 1.0]), force=0.1)
    assert (stop.kind, stop.coordinate, stop.press) == ("stop", 0, 1)


def test_a_coordinate_on_its_bound_is_pressed_there_and_the_others_move_on():
    truss = Truss(load=(0.3, 0.0))
    result = truss.rest([[0.0, 0.1], [0.02, 0.3]], upper=(0.05, 0.1))
    assert result.rests.all()
    assert result.position == pytest.approx(np.array([[result.position[0, 0], 0.1]] * 2))
    assert (result.slope[:, 1] < 0).all()
    alone = minimize_scalar(lambda x: truss.energy(np.array([[x, 0.1]]))[0][0], bounds=(-0.05, 0.05), method="bounded")
    assert result.position[:, 0] == pytest.approx([min(alone.x, 0.05)] * 2, abs=1e-5)
    assert np.abs(result.slope[result.position[:, 0] < 0.05, 0]).max(initial=0) <= FORCE * truss.stiffness


def test_a_place_without_freedom_rests_where_it_is_put():
    result = Truss().rest([[0.3, 0.4]], lower=(0.1, -0.1), upper=(0.1, -0.1))
    assert result.rests.all()
    assert result.position.tolist() == [[0.1, -0.1]]
    assert result.stiffness.tolist() == [math.inf]


def test_exactly_between_two_states_it_rests_on_the_barrier_with_a_negative_stiffness():
    truss = Truss()
    result = truss.rest([0.0, 0.0])
    assert result.rests.all()
    assert result.energy[0] == pytest.approx(truss.barrier)
    # sideways stiffness of both bars, compressed by L0 - s: -2 k (L0 - s) / s
    assert result.stiffness[0] == pytest.approx(-2 * truss.stiffness * (truss.length - truss.span) / truss.span)


def test_what_has_no_bottom_or_no_number_does_not_rest():
    def slope(position, _cases):
        return position[:, 0], np.ones_like(position), np.zeros((len(position), 1, 1))

    def broken(position, _cases):
        return np.full(len(position), np.nan), np.ones_like(position), np.zeros((len(position), 1, 1))

    for energy in (slope, broken):
        result = descend(energy, np.zeros((1, 1)), *FREE, longest_step=0.1, force=1e-9)
        assert not result.rests.any()


def test_a_truss_that_has_snapped_through_is_not_followed_to_its_rest():
    truss = Truss(load=(0, -1.1 * Truss().snap_load))
    starts = np.array([[0.0, truss.rise], [0.0, -truss.rise]])

    def snapped(position, cases):
        return (cases == 0) & (position[:, 1] < 0)

    stopped = descend(truss.energy, starts, *FREE, longest_step=0.05, force=1e-9, enough=snapped)
    rested = descend(truss.energy, starts, *FREE, longest_step=0.05, force=1e-9)
    assert stopped.rests.tolist() == [False, True]
    assert rested.position[0, 1] < -truss.rise < -0.05 <= stopped.position[0, 1] < 0
    assert stopped.position[1] == pytest.approx(rested.position[1], abs=1e-9)


def test_zero_cases_give_empty_results():
    result = Truss().rest(np.zeros((0, 2)))
    assert result.position.shape == (0, 2)


cells = st.builds(
    Kresling,
    high=st.floats(1.8, 2.0),
    low=st.floats(1.3, 1.5),
    corners=st.integers(5, 9),
    mountain=st.floats(0.5, 5),
    valley=st.floats(0.5, 5),
)


@given(cells)
def test_a_kresling_cell_has_its_creases_lengths_in_two_states(cell):
    energy, slope, _ = cell.energy(cell.states)
    # rounding
    assert energy == pytest.approx(np.zeros(2), abs=1e-26)
    assert slope == pytest.approx(np.zeros((2, 2)), abs=1e-12)


@given(cells, st.floats(-0.1, 0.1), st.floats(-0.1, 0.1))
def test_a_kresling_cell_falls_into_its_two_states(cell, higher, further):
    result = descend(
        cell.energy,
        cell.states + np.array([higher, further]),
        [0, -math.pi],
        [math.inf, math.pi],
        longest_step=0.05,
        force=1e-11,
    )
    assert result.rests.all()
    assert result.energy == pytest.approx(np.zeros(2), abs=1e-20)
    assert result.position == pytest.approx(cell.states, abs=1e-8)
    assert (result.stiffness > 0).all()


@settings(deadline=None, max_examples=10)
@given(cells)
@example(Kresling())
def test_the_barrier_of_a_kresling_cell_is_that_of_another_minimiser(cell):
    def least(twist):
        result = minimize_scalar(
            lambda height: cell.energy(np.array([[height, twist]]))[0][0],
            bounds=(0.5, 2.5),
            method="bounded",
            options={"xatol": 1e-10},
        )
        return result.fun

    first, second = cell.states[:, 1]
    states = states_along(cell.path, np.linspace(first - 0.1, second + 0.1, 40), force=1e-8)
    assert [state.kind for state in states] == ["minimum", "maximum", "minimum"]
    assert [state.coordinate for state in states if state.stable] == pytest.approx([first, second], abs=1e-6)
    top = minimize_scalar(
        lambda twist: -least(twist), bounds=(first, second), method="bounded", options={"xatol": 1e-8}
    )
    # the search along the twist: 1e-8 squared, by the curvature, is far below that of the height
    barrier = barrier_between(states, states[0], states[2])
    assert barrier == pytest.approx(-top.fun, rel=1e-8)
    assert barrier > 0


def test_between_its_states_a_kresling_cell_has_a_saddle():
    cell = Kresling()
    states = states_along(cell.path, np.linspace(*cell.states[:, 1], 40), force=1e-8)
    twist = next(state.coordinate for state in states if state.kind == "maximum")
    top = descend(cell.energy, np.array([[1.5, twist]]), [0, twist], [math.inf, twist], longest_step=0.1, force=1e-10)
    _, slope, curvature = cell.energy(top.position)
    assert slope == pytest.approx(np.zeros((1, 2)), abs=1e-8)
    low, high = np.linalg.eigvalsh(curvature[0])
    assert low < 0 < high


@given(cells, st.floats(1.0, 2.0), st.floats(0.1, 2.0))
def test_the_slopes_and_curvatures_of_this_tests_own_cell_are_derivatives(cell, height, twist):
    current, small = np.array([[height, twist]]), 1e-5
    _, slope, curvature = cell.energy(current)
    for axis in range(2):
        step = small * np.eye(2)[axis]
        ahead, behind = cell.energy(current + step), cell.energy(current - step)
        # central differences: third derivatives times 1e-10, rounding by 1e-5
        assert slope[0, axis] == pytest.approx((ahead[0] - behind[0])[0] / (2 * small), rel=1e-6, abs=1e-7)
        assert curvature[0, axis] == pytest.approx((ahead[1] - behind[1])[0] / (2 * small), rel=1e-6, abs=1e-6)
