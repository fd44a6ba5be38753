"""Saddles between two stable states of a tree, and the highest one on a path through further states."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field
from functools import partial

import numpy as np

from forficula.arrays import Array, Flags
from forficula.statics.tree.elements import Expansion
from forficula.statics.tree.ensemble import Ensemble, slight_energy, torque_scale
from forficula.statics.tree.equilibrium import Cases
from forficula.statics.tree.partial_folds import soft_stiffness
from forficula.statics.tree.potential import potential, rest

_STATION = 0.05  # largest change of a joint's angle between two prescribed positions, rad
_JUMP = 0.2  # larger changes of a joint's angle between two positions are jumps, rad
_FIRST, _SHORTEST = 1 / 8, 1 / 64  # first and shortest distance between two positions, as a share of the largest one
_STIFFER = 10.0  # stiffness that holds a position, relative to the stiffest direction
_STEPS, _LONGEST = 300, 0.05  # steps of the search for a saddle, and the longest step, rad
_QUIET = 1e-7  # torque at a saddle that counts as zero, as a share of the largest torque of the stiffest part
_SHIFT = 5e-3  # random shift of the start of a search, which leaves shapes with several unstable directions, rad
_SEED = 31  # of random shifts
_OFF = 0.01  # push off a saddle, rad
_SHORT = 0.02  # longest step downhill from a saddle, rad
# change of a joint's angle from position to position on the line between two shapes, rad, and their largest number
_NARROW, _ON_LINE = 0.01, 400
_HARDLY = 0.05  # rise between two shapes in one valley, as a share of that to the saddle
_MOST = 6  # states from which a search continues
_TOPS, _RISE = 8, 1e-3  # number of tried tops of a path, and least rise to a top, as a share of the largest rise
_LEAST = 1e-12  # least stiffness of a direction, as a share of the largest one
_AT = 1e-9  # distance from a stop that counts as zero, rad


@dataclass(frozen=True, kw_only=True)
class TreeSaddle:
    """A stationary point with one unstable direction, or the highest of several on a path between two states.

    Attributes:
        position: angles of the joints, rad, (joint,).
        energy: J.
    """

    position: Array
    energy: float


@dataclass(frozen=True, kw_only=True)
class _Crossing:
    """A saddle between two of some states, by their numbers."""

    ends: tuple[int, int]
    energy: float
    position: Array


@dataclass(frozen=True, kw_only=True)
class _Map:
    """States and the saddles between them.

    Attributes:
        structures: the structure as the only case.
        states: angles of the joints, (joint,) each; the first two are to be connected.
        crossings: known saddles.
    """

    structures: Ensemble
    states: list[Array]
    crossings: list[_Crossing] = field(default_factory=list)

    def add(self, top: Array) -> None:
        """Add the saddle near a shape, and the states downhill from it, if there is one."""
        saddle = _saddle_near(self.structures, top)
        if saddle is None:
            return
        energy = _energy(self.structures, saddle[0])
        one, other = (self._number(end, energy) for end in _ends(self.structures, *saddle))
        if one != other:
            self.crossings.append(_Crossing(ends=(one, other), energy=energy, position=saddle[0]))

    def _number(self, end: Array, top: float) -> int:
        for number, state in enumerate(self.states):
            if _in_one_valley(self.structures, end, state, top):
                return number
        self.states.append(end)
        return len(self.states) - 1

    def path(self) -> list[_Crossing]:
        """Return the saddles on the known path between the first two states whose highest saddle is lowest."""
        chains: dict[int, list[_Crossing]] = {0: []}
        for _ in self.states:
            for crossing in self.crossings:
                for start, end in (crossing.ends, crossing.ends[::-1]):
                    if start in chains and end != 0:
                        chain = [*chains[start], crossing]
                        if end not in chains or _highest(chain).energy < _highest(chains[end]).energy:
                            chains[end] = chain
        return chains.get(1, [])

    def reached(self) -> list[int]:
        """Return the numbers of the states that known saddles connect to the first."""
        joined = {0}
        for _ in self.states:
            joined |= {end for crossing in self.crossings if joined & set(crossing.ends) for end in crossing.ends}
        return sorted(joined)


def saddle_between(structures: Ensemble, first: Array, second: Array, paths: Sequence[Array] = ()) -> TreeSaddle | None:
    """Find a path over saddles from one stable state to another.

    Searches start at the tops of the energy along given paths. Further ones start from shapes of highest energy on a
    straight line between both states in the space of the joints' angles: positions on the line are prescribed one after
    another, up to a jump, while all other directions minimise the energy. From such a shape, eigenvector following
    (Cerjan and Miller 1981) leads to a saddle: uphill along the softest direction and downhill along all others.
    Descents from both sides of the saddle lead to the states that it connects.

    Args:
        structures: only the first case is used.
        first: angles of the joints in a stable state, rad, (joint,).
        second: in another one.
        paths: shapes through which the structure moves from one state to the other, rad, (step, joint) each.

    Returns:
        The highest saddle on the path; another path may be lower. None if no path was found.
    """
    known, begun = _Map(structures=structures.repeated(1), states=[first, second]), set[int]()
    for path in paths:
        for top in _path_tops(known.structures, np.concatenate([first[None], path, second[None]])):
            known.add(top)
    while not (chain := known.path()) and len(begun) < _MOST:
        left = [number for number in known.reached() if number not in begun]
        if not left:
            return None
        start = min(left, key=lambda number: float(np.linalg.norm(known.states[number] - second)))
        begun.add(start)
        for top in _tops(known.structures, known.states[start], second):
            known.add(top)
            if known.path():
                break
    if not chain:
        return None
    highest = _highest(chain)
    return TreeSaddle(position=highest.position, energy=highest.energy)


def level_between(structures: Ensemble, one: Array, other: Array) -> bool:
    """Return whether two shapes at rest have the same energy and the straight line between them is level.

    A structure moves between them without force, for example about a hinge without a spring.

    Args:
        structures: only the first case is used.
        one: angles of the joints, rad, (joint,).
        other: of another shape.
    """
    energies = _line_energies(structures, one, other)
    return float(np.ptp(energies)) <= slight_energy(structures)


def _line_energies(structures: Ensemble, one: Array, other: Array) -> Array:
    """Return the energies on the straight line between two shapes, J, (position,)."""
    count = min(2 + int(np.abs(other - one).max() / _NARROW), _ON_LINE)
    return potential(structures.repeated(count), np.linspace(one, other, count))[0]


def _highest(chain: Sequence[_Crossing]) -> _Crossing:
    return max(chain, key=lambda crossing: crossing.energy)


def _path_tops(structures: Ensemble, path: Array) -> list[Array]:
    """Return the shapes of a path at which the energy is largest between two lower ones, the highest ones first."""
    energies = potential(structures.repeated(len(path)), path)[0]
    rise = _RISE * float(np.ptp(energies))
    tops, low, top = list[int](), energies[0], 0
    for number, energy in enumerate(energies):
        if energy > energies[top]:
            top = number
        elif energies[top] - energy > rise and energies[top] - low > rise:
            tops.append(top)
            low, top = energy, number
        if energy < low:
            low, top = energy, number
    return [path[number] for number in sorted(tops, key=lambda number: -energies[number])[:_TOPS]]


def _tops(structures: Ensemble, start: Array, target: Array) -> Iterator[Array]:
    """Return the shape of highest energy on the way from the start to the target, and on the way back."""
    for one, other in ((start, target), (target, start)):
        length = float(np.linalg.norm(other - one))
        along = (other - one) / length
        longest = _STATION / float(np.abs(along).max())
        # a state at a stop may be close to the top
        step, jumps = _FIRST * longest, False
        stiffness = _STIFFER * float(np.abs(potential(structures, one[None])[2]).max())
        position, gone = one, 0.0
        shapes, energies = [one], [_energy(structures, one)]
        while gone < length:
            tried = min(gone + step, length)
            aim = float(along @ one) + tried
            ahead = np.clip(position + (tried - gone) * along, structures.lower, structures.upper)
            holding, jumped = _holding(along, aim, stiffness), partial(_jumped, position)
            moved = rest(structures, ahead[None], pull=holding, enough=jumped).position
            if jumped(moved)[0]:
                if step <= _SHORTEST * longest:
                    break
                step, jumps = step / 2, True
                continue
            position, gone = moved[0], tried
            step = step if jumps else min(2 * step, longest)
            shapes.append(position)
            energies.append(_energy(structures, position))
        yield shapes[int(np.argmax(energies))]


def _jumped(position: Array, angles: Array, _cases: Cases | None = None) -> Flags:
    """Return which angles, (case, joint), are a jump away from a position, (joint,)."""
    return np.asarray(np.abs(angles - position).max(axis=1) > _JUMP)


def _holding(along: Array, aim: float, stiffness: float) -> Callable[[Array], Expansion]:
    """Return the energy of a spring that holds the angles in a plane: their product with a direction is at an aim."""

    def energy(angles: Array) -> Expansion:
        off = angles @ along - aim
        curvature = np.tile(stiffness * np.outer(along, along), (len(angles), 1, 1))
        return stiffness / 2 * off**2, stiffness * off[:, None] * along, curvature

    return energy


def _energy(structures: Ensemble, angles: Array) -> float:
    return float(potential(structures, angles[None])[0][0])


def _saddle_near(structures: Ensemble, start: Array) -> tuple[Array, Array] | None:
    """Return the saddle to which eigenvector following leads, and its unstable direction, both (joint,)."""
    ties, random = structures.ties, np.random.default_rng(_SEED)
    spread = np.eye(structures.size) if ties is None else ties.spread
    lower, upper = structures.lower, structures.upper
    position = start
    if ties is not None:
        lower, upper = (bound[0] for bound in ties.bounds(lower[None], upper[None]))
        position = ties.start(start[None])[0]
    position = np.clip(position + _SHIFT * random.standard_normal(len(position)), lower, upper)
    quiet, soft = _QUIET * torque_scale(structures), soft_stiffness(structures)
    followed: Array | None = None
    for _ in range(_STEPS):
        angles = position if ties is None else ties.angles(position[None])[0]
        _, slope, curvature = (part[0] for part in potential(structures, angles[None]))
        slope, curvature = slope @ spread, spread.T @ curvature @ spread
        free = np.flatnonzero(~_held(position, slope, lower, upper))
        if not len(free):
            return None
        values, modes = np.linalg.eigh(curvature[np.ix_(free, free)])
        along = slope[free] @ modes
        if np.abs(along).max() <= quiet and values[0] < 0:
            direction = np.zeros(len(position))
            direction[free] = modes[:, 0]
            return (angles, spread @ direction) if np.sum(values < -soft) == 1 else None
        climbed = 0 if followed is None else int(np.argmax(np.abs(followed[free] @ modes)))
        followed = np.zeros(len(position))
        followed[free] = modes[:, climbed]
        # Newton's step downhill along all directions but one, in which it is reversed
        step = -along / np.maximum(np.abs(values), _LEAST * np.abs(values).max())
        step[climbed] *= -1
        step *= min(1.0, _LONGEST / max(float(np.linalg.norm(step)), 1e-300))
        moved = position.copy()
        moved[free] += modes @ step
        position = np.clip(moved, lower, upper)
    return None


def _held(position: Array, slope: Array, lower: Array, upper: Array) -> Flags:
    """Return which coordinates press on a bound."""
    return np.asarray(((position <= lower + _AT) & (slope > 0)) | ((position >= upper - _AT) & (slope < 0)))


def _ends(structures: Ensemble, saddle: Array, direction: Array) -> tuple[Array, Array]:
    """Return the states downhill from both sides of a saddle, (joint,) each."""
    off = _OFF * direction / np.abs(direction).max()
    starts = np.clip([saddle + off, saddle - off], structures.lower, structures.upper)
    one, other = rest(structures.repeated(2), starts, longest_step=_SHORT).position
    return one, other


def _in_one_valley(structures: Ensemble, one: Array, other: Array, top: float) -> bool:
    """Return whether the energy hardly rises on the straight line between two shapes, relative to a saddle.

    Two descents into a soft valley end at different positions.
    """
    energies = _line_energies(structures, one, other)
    level = max(float(energies[0]), float(energies[-1]))
    return float(energies.max()) - level <= _HARDLY * (top - level)
