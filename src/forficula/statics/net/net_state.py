"""A state in which a net rests: what it stores, what it reads, how it moves and what it withstands."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Literal

import numpy as np

from forficula.arrays import Array
from forficula.errors import InputError
from forficula.quantities import show_value
from forficula.statics.net.collapse import Collapse, collapse
from forficula.statics.net.energy import membrane_stresses, sides_of, stored_by_part
from forficula.statics.net.load import Load, acceleration, pressure
from forficula.statics.net.load_path import PathPoint
from forficula.statics.net.minimum import NetRest
from forficula.statics.net.modes import natural_modes
from forficula.statics.net.net import Net, NetShape, Springs
from forficula.statics.net.net_of import bends, motor_load, own_angles, panels, places
from forficula.statics.net.passing import panels_pass
from forficula.statics.net.rigidity import rigidity
from forficula.structure import Measure, Motor, Structure, read_angles, springs_name

_MODES = 4  # told of every state, beside motions of the whole
_STEPS, _INCREMENTS = (0.04, 0.01), 40  # first increments of a path to collapse, of the net's size, and how many
_STRAINED = 0.05  # of a bar: where a path to collapse ends, for panels tear or crumple
_ROUNDING = 1e-15
_LARGEST = 1500  # free coordinates up to which mechanisms are counted


@dataclass(frozen=True, kw_only=True)
class Mobility:
    """How a net can move without stretching bars or bending panels, and what it can hold by itself.

    Attributes:
        degrees_of_freedom: mechanisms of first order, beside motions of the whole.
        self_stresses: stresses in equilibrium without a load.
    """

    degrees_of_freedom: int
    self_stresses: int


@dataclass(frozen=True, kw_only=True)
class Withstood:
    """How much of a load a state withstands.

    Attributes:
        load: what it is, in words.
        unit: SI, of the value.
        value: at which the state is lost, or the largest reached.
        kind: "limit", past which nothing holds it near by; "bifurcation", past which it gives way sideways; "none"
            where it held as far as the load was followed, at most until a bar is strained by 5 %.
    """

    load: str
    unit: str
    value: float
    kind: Literal["limit", "bifurcation", "none"]


@dataclass(frozen=True, kw_only=True, eq=False)
class NetState:
    """A stable state.

    Attributes:
        name: that a protocol gives it; "state 2" where none does, the second by its energy.
        rest: where it is.
        energy: stored, J, that of the weight included (0 at z = 0).
        stored: the same by what stores it, J; what the structure does not have is left out.
        readings: of the measures, rad or m, by name, each (coordinate,).
        frequencies: of the slowest modes that are no motions of the whole, Hz, (mode,).
        modes: these, kinetic energy 1/2 J at 1 m/s, (mode, node, 3).
        mobility: there; None for a net too large, or of plates.
        strain: the largest of a bar, by size; 0 without bars.
        stress: the largest of a bar with a cross-section or of a membrane, by size, Pa.
        extension: the largest of a tendon, beyond its resting length and by that.
        withstands: loads that grow from none, of states that a protocol names.
        passing: whether panels pass through one another.
        found: how often the search came to it.
    """

    name: str
    rest: NetRest
    energy: float
    stored: Mapping[str, float]
    readings: Mapping[str, Array]
    frequencies: Array
    modes: Array
    mobility: Mobility | None
    strain: float
    stress: float
    extension: float
    withstands: tuple[Withstood, ...]
    passing: bool
    found: int

    def __repr__(self) -> str:
        """Name and energy."""
        return f"<NetState {self.name}: {show_value(self.energy, 'J')}>"


def net_state(structure: Structure, net: Net, rest: NetRest, name: str, found: int, *, loads: bool) -> NetState:
    """What is to be told of a stable state.

    Args:
        structure: that the net is of.
        net: of it.
        rest: where it is.
        name: of the state.
        found: how often the search came to it.
        loads: whether to find out what it withstands.
    """
    borne = strength(net, rest.shape)
    modes = natural_modes(net, rest.shape, 6 + _MODES)
    own = np.flatnonzero(~modes.rigid)[:_MODES]
    areas = np.array([spring.area for spring in structure.springs])
    by_area = np.divide(borne.forces[: len(areas)], areas, out=np.zeros_like(areas), where=areas > 0)
    return NetState(
        name=name,
        rest=rest,
        energy=known(net, rest.energy),
        stored=stored_parts(structure, net, rest.shape),
        readings={each.name: readings(structure, net, each, rest.shape) for each in structure.measures},
        frequencies=modes.frequencies[own],
        modes=modes.shapes[own],
        mobility=mobility(structure, net, rest.shape),
        strain=float(np.abs(borne.strains).max(initial=0.0)),
        stress=float(max(np.abs(by_area).max(initial=0.0), np.abs(borne.stresses).max(initial=0.0))),
        extension=float(borne.extensions.max(initial=0.0)),
        withstands=tuple(_withstands(structure, net, rest)) if loads else (),
        passing=panels_pass(net, rest.shape, panels(structure)),
        found=found,
    )


def readings(structure: Structure, net: Net, measure: Measure, shape: NetShape) -> Array:
    """What a measure reads in a shape, rad of each of its hinges, or m, (coordinate,)."""
    if measure.points is not None:
        one, other = places(net, shape)[list(measure.points)]
        return np.array([np.linalg.norm(other - one)])
    return read_angles(measure, own_angles(structure, shape))


def stored_parts(structure: Structure, net: Net, shape: NetShape) -> dict[str, float]:
    """Energy by what stores it, J; what the structure does not have is left out."""
    bars, folds, tendons, membranes, weight = stored_by_part(net, shape)
    flat = bends(structure)
    parts = {
        "creases": (not flat.all(), float(folds[~flat].sum())),
        "facet bends": (flat.any(), float(folds[flat].sum())),
        springs_name(structure): (bool(structure.springs), bars),
        "tendons": (bool(structure.tendons), tendons),
        "membranes": (bool(structure.membranes), membranes),
        "weight": (bool(structure.gravity), weight),
    }
    return {name: known(net, energy) for name, (there, energy) in parts.items() if there}


def known(net: Net, energy: float) -> float:
    """An energy, J, without what is rounding beside that of all creases and bars turned and stretched by 1."""
    springs = np.sum(net.springs.stiffness * net.springs.rest_length**2)
    scale = float(np.sum(net.creases.law.stiffness)) + float(springs)
    return energy if abs(energy) > _ROUNDING * scale else 0.0


def mobility(structure: Structure, net: Net, shape: NetShape) -> Mobility | None:
    """Mechanisms and states of self-stress, where panels stay flat; None for a net too large, or of plates."""
    if np.count_nonzero(net.free) > _LARGEST or structure.plates:
        return None
    found = rigidity(_unstretched(net), shape, bends(structure))
    return Mobility(degrees_of_freedom=found.degrees_of_freedom, self_stresses=found.self_stresses)


def _unstretched(net: Net) -> Net:
    """A net whose membranes are bars along their sides, for they stretch as little."""
    if net.membranes is None:
        return net
    corners = net.membranes.points
    ends = np.unique(np.sort(np.concatenate([corners[:, [0, 1]], corners[:, [1, 2]], corners[:, [2, 0]]])), axis=0)
    places = net.points @ net.nodes
    length = np.linalg.norm(places[ends[:, 1]] - places[ends[:, 0]], axis=1)
    springs = Springs(points=ends, stiffness=np.ones(len(ends)), rest_length=length)
    return replace(net, springs=springs, membranes=None)


def _withstands(structure: Structure, net: Net, rest: NetRest) -> list[Withstood]:
    """Every load that is tried; those that would carry the whole away are left out."""
    found = []
    for words, unit, load in _loads(structure, net, rest.shape):
        lost = _lost(net, rest, load)
        if lost is not None:
            found.append(Withstood(load=words, unit=unit, value=float(lost.factor), kind=lost.kind))
    return found


def _lost(net: Net, rest: NetRest, load: Load) -> Collapse | None:
    """Where a load carries a state away; None where the whole would go, or no path is found."""

    def strained(point: PathPoint) -> bool:
        return bool(np.abs(strength(net, point.shape).strains).max(initial=0.0) > _STRAINED)

    for step in _STEPS:
        try:
            lost = collapse(net, rest, load, stop=strained, step=step * net.size, increments=_INCREMENTS)
        except InputError:
            return None
        # a load that grew from nothing acts its own way; else an increment took another path for its own
        if lost.factor > 0:
            return lost
    return None


def _loads(structure: Structure, net: Net, shape: NetShape) -> list[tuple[str, str, Load]]:
    """Loads in words, with the SI unit of their size: forces of drives, accelerations, pressure, torques on creases."""
    loads = []
    for number, motor in enumerate(structure.motors):
        if motor.kind == "force":
            settings = tuple(float(number == each) for each in range(len(structure.motors)))
            each = " on each point" if len(motor.points) > 1 else ""
            loads.append((f"force {motor.name}{each}", "N", motor_load(structure, net, settings)))
    if not net.free.all():
        for axis, letter in enumerate("xyz"):
            for sign, mark in ((1.0, "+"), (-1.0, "−")):
                push = acceleration(net, sign * np.eye(3)[axis])
                loads.append((f"supports accelerated along {mark}{letter}", "m/s^2", push))
        triangles = panels(structure)
        if len(triangles):
            loads.append(("pressure on the backs of all facets", "Pa", pressure(net, shape, triangles)))
            loads.append(("pressure on their fronts", "Pa", pressure(net, shape, triangles[:, ::-1])))
    for name, motor in _groups(structure):
        for sign, words in ((1.0, "folding"), (-1.0, "unfolding")):
            load = motor_load(replace(structure, motors=(motor,)), net, (sign,))
            of = "" if name == "creases" else f" of {name}"
            loads.append((f"torque on each crease{of}, {words}", "N m", load))
    return loads


def _groups(structure: Structure) -> list[tuple[str, Motor]]:
    """The creases that measures watch, as what a torque could act on; all of them where none is chosen."""
    watched = [each for each in structure.measures if each.kind == "angle"]
    chosen = [each for each in watched if each.name != "creases"] or watched
    return [(each.name, Motor(name=each.name, hinges=each.hinges)) for each in chosen if each.hinges]


@dataclass(frozen=True, kw_only=True, eq=False)
class Strength:
    """Strains, forces and moments, in the order of the net's parts.

    Attributes:
        strains: of the bars, (spring,); 0 for those without a resting length.
        forces: of the bars, tension positive, N, (spring,).
        moments: of the creases, slopes of their energies by their angles, N m, (crease,).
        pulls: of the tendons, N, (tendon,).
        extensions: of the tendons beyond their resting lengths, over these, (tendon,).
        stresses: of the membranes, principal second Piola-Kirchhoff stresses, the larger first, Pa, (triangle, 2).
    """

    strains: Array
    forces: Array
    moments: Array
    pulls: Array
    extensions: Array
    stresses: Array


def strength(net: Net, shape: NetShape) -> Strength:
    """What every part bears."""
    bars, tendons, _, _ = sides_of(net, shape.positions)
    rest, length = net.springs.rest_length, np.linalg.norm(bars, axis=1)
    law, span = net.tendons.law, np.linalg.norm(tendons, axis=1)
    longer = np.maximum(span - law.rest_length, 0.0)
    return Strength(
        strains=np.divide(length - rest, rest, out=np.zeros_like(rest), where=rest > 0),
        forces=net.springs.stiffness * (length - rest),
        moments=net.creases.law.moment(shape.angles),
        pulls=law.force(span),
        extensions=np.divide(longer, law.rest_length, out=np.zeros_like(span), where=np.asarray(law.rest_length) > 0),
        stresses=membrane_stresses(net, shape),
    )
