"""A stable state of a net: stored energies, readings, modes, and the loads that it withstands."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import Literal

import numpy as np

from forficula.arrays import Array
from forficula.errors import InputError
from forficula.quantities import show_value
from forficula.statics.net.collapse import Collapse, collapse
from forficula.statics.net.contact.contact_energy import contact_forces
from forficula.statics.net.energy import membrane_stresses, sides_of, stored_by_part
from forficula.statics.net.load import Load, acceleration, pressure, same_load
from forficula.statics.net.minimum import NetRest
from forficula.statics.net.modes import natural_modes
from forficula.statics.net.net import Net, NetShape, Springs
from forficula.statics.net.net_of import bends, motor_load, own_angles, panels, point_positions
from forficula.statics.net.panel_crossing import panels_cross
from forficula.statics.net.path_increment import PathPoint
from forficula.statics.net.rigidity import rigidity
from forficula.structure import Measure, Motor, Structure, read_angles, springs_name

_MODES = 4  # reported for every state, besides rigid-body motions
_STEPS, _INCREMENTS = (0.04, 0.01), 40  # first increments of a path to collapse, of the net's size, and their number
STRAINED = 0.05  # strain of a bar that ends a path to collapse, because panels tear or crumple
_CRUSHED = 0.02  # rad beyond a stop that end a path to collapse with contact [chosen]
_ROUNDING = 1e-15
_LARGEST = 1500  # free coordinates up to which mechanisms are counted


@dataclass(frozen=True, kw_only=True)
class Mobility:
    """Mobility of a net without stretching bars or bending panels.

    Attributes:
        degrees_of_freedom: number of first-order mechanisms, besides rigid-body motions.
        self_stresses: number of states of self-stress, which are stresses in equilibrium without a load.
    """

    degrees_of_freedom: int
    self_stresses: int


@dataclass(frozen=True, kw_only=True)
class Withstood:
    """Largest load of one kind that a state withstands.

    Attributes:
        load: name of the load.
        unit: SI unit of the value.
        value: at which the state is lost, or the largest value reached.
        kind: "limit", beyond which there is no equilibrium nearby; "bifurcation", beyond which the net deflects
            sideways; "none" if the state held as far as the load was followed, at most until a bar is strained by 5 %.
    """

    load: str
    unit: str
    value: float
    kind: Literal["limit", "bifurcation", "none"]


@dataclass(frozen=True, kw_only=True, eq=False)
class NetState:
    """A stable state of a net.

    Attributes:
        name: name in the protocol; otherwise a number by energy, such as "state 2".
        rest: the equilibrium.
        energy: stored energy, including that of the weight (0 at the origin), J.
        stored: energy by the part that stores it, J; parts that the structure does not have are left out.
        readings: of the measures, rad or m, by name, each (coordinate,).
        frequencies: of the slowest modes that are not rigid-body motions, Hz, (mode,).
        modes: shapes of these modes, kinetic energy 1/2 J at 1 m/s, (mode, node, 3).
        mobility: in this state; None for a net that is too large, or of plates.
        strain: largest magnitude of the strain of a bar; 0 without bars.
        stress: largest magnitude of the stress of a bar with a cross-section or of a membrane, Pa.
        extension: largest extension of a tendon divided by its resting length.
        withstands: largest loads, for states that a protocol names.
        passing: whether panels pass through one another.
        hits: how often the search reached this state.
        contacts: force between every pair of parts that touch, N, by the names of both.
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
    hits: int
    contacts: Mapping[str, float] = field(default_factory=dict)

    def __repr__(self) -> str:
        """Name and energy."""
        return f"<NetState {self.name}: {show_value(self.energy, 'J')}>"


def net_state(structure: Structure, net: Net, rest: NetRest, name: str, hits: int, *, loads: bool) -> NetState:
    """Compute the properties of a stable state.

    Args:
        structure: the structure.
        net: net of the structure.
        rest: the equilibrium.
        name: of the state.
        hits: how often the search reached the state.
        loads: whether to compute the loads that the state withstands.
    """
    strained = strength(net, rest.shape)
    modes = natural_modes(net, rest.shape, 6 + _MODES)
    deforming = np.flatnonzero(~modes.rigid)[:_MODES]
    areas = np.array([spring.area for spring in structure.springs])
    by_area = np.divide(strained.forces[: len(areas)], areas, out=np.zeros_like(areas), where=areas > 0)
    return NetState(
        name=name,
        rest=rest,
        energy=rounded_energy(net, rest.energy),
        stored=stored_parts(structure, net, rest.shape),
        readings={measure.name: readings(structure, net, measure, rest.shape) for measure in structure.measures},
        frequencies=modes.frequencies[deforming],
        modes=modes.shapes[deforming],
        mobility=mobility(structure, net, rest.shape),
        strain=float(np.abs(strained.strains).max(initial=0.0)),
        stress=float(max(np.abs(by_area).max(initial=0.0), np.abs(strained.stresses).max(initial=0.0))),
        extension=float(strained.extensions.max(initial=0.0)),
        withstands=tuple(_tried_loads(structure, net, rest)) if loads else (),
        passing=panels_cross(net, rest.shape, panels(structure)),
        hits=hits,
        contacts=contact_forces(net, rest.shape),
    )


def readings(structure: Structure, net: Net, measure: Measure, shape: NetShape) -> Array:
    """Return the readings of a measure in a shape: rad for each of its hinges, or m, (coordinate,)."""
    if measure.points is not None:
        one, other = point_positions(net, shape)[list(measure.points)]
        return np.array([np.linalg.norm(other - one)])
    return read_angles(measure, own_angles(structure, shape))


def stored_parts(structure: Structure, net: Net, shape: NetShape, further: Array | float = 0.0) -> dict[str, float]:
    """Return the energy by the part that stores it, J; parts that the structure does not have are left out.

    Args:
        structure: the structure.
        net: net of the structure.
        shape: shape of the net.
        further: changes of the rest angles of valleys, rad, (crease,).
    """
    bars, folds, tendons, membranes, weight = stored_by_part(net, shape, further)
    flat = bends(structure)
    parts = {
        "creases": (not flat.all(), float(folds[~flat].sum())),
        "facet bends": (flat.any(), float(folds[flat].sum())),
        springs_name(structure): (bool(structure.springs), bars),
        "tendons": (bool(structure.tendons), tendons),
        "membranes": (bool(structure.membranes), membranes),
        "weight": (bool(structure.gravity), weight),
    }
    return {name: rounded_energy(net, energy) for name, (present, energy) in parts.items() if present}


def rounded_energy(net: Net, energy: float) -> float:
    """Return an energy, J; 0 if it is rounding relative to the energy of all creases and bars at a strain of 1."""
    springs = np.sum(net.springs.stiffness * net.springs.rest_length**2)
    scale = float(np.sum(net.creases.law.stiffness)) + float(springs)
    return energy if abs(energy) > _ROUNDING * scale else 0.0


def mobility(structure: Structure, net: Net, shape: NetShape) -> Mobility | None:
    """Count mechanisms and states of self-stress with flat panels; None for a net that is too large, or of plates."""
    if np.count_nonzero(net.free) > _LARGEST or structure.plates:
        return None
    result = rigidity(_unstretched(net), shape, bends(structure))
    return Mobility(degrees_of_freedom=result.degrees_of_freedom, self_stresses=result.self_stresses)


def _unstretched(net: Net) -> Net:
    """Return a net with bars along the sides of membranes, because both hardly stretch."""
    if net.membranes is None:
        return net
    corners = net.membranes.points
    ends = np.unique(np.sort(np.concatenate([corners[:, [0, 1]], corners[:, [1, 2]], corners[:, [2, 0]]])), axis=0)
    point_positions = net.points @ net.nodes
    length = np.linalg.norm(point_positions[ends[:, 1]] - point_positions[ends[:, 0]], axis=1)
    springs = Springs(points=ends, stiffness=np.ones(len(ends)), rest_length=length)
    return replace(net, springs=springs, membranes=None)


def _tried_loads(structure: Structure, net: Net, rest: NetRest) -> list[Withstood]:
    """Return every load that is tried, without those that would move the net as a rigid body."""
    result, tried = [], list[tuple[Load, Collapse | None]]()
    for words, unit, load in _loads(structure, net, rest.shape):
        # several drives may exert the same force
        same = next((number for number, (other, _) in enumerate(tried) if same_load(other, load)), None)
        lost = _loss_under(net, rest, load) if same is None else tried[same][1]
        tried.append((load, lost))
        if lost is not None:
            result.append(Withstood(load=words, unit=unit, value=float(lost.factor), kind=lost.kind))
    return result


def _loss_under(net: Net, rest: NetRest, load: Load) -> Collapse | None:
    """Find the loss of a state under a load; None for a rigid-body motion, and if no path is found."""

    def strained(point: PathPoint) -> bool:
        if net.contact is not None and _is_beyond_stops(net, point.shape):
            return True
        return bool(np.abs(strength(net, point.shape).strains).max(initial=0.0) > STRAINED)

    for step in _STEPS:
        try:
            lost = collapse(net, rest, load, stop=strained, step=step * net.size, increments=_INCREMENTS)
        except InputError:
            return None
        # a load that grows from zero has a positive factor; otherwise an increment switched to another path
        if lost.factor > 0:
            return lost
    return None


def _is_beyond_stops(net: Net, shape: NetShape) -> bool:
    """Return whether a load turns creases far beyond their stops, which are stiff springs."""
    law = net.creases.law
    return bool(np.any((shape.angles < law.lower - _CRUSHED) | (shape.angles > law.upper + _CRUSHED)))


def _loads(structure: Structure, net: Net, shape: NetShape) -> list[tuple[str, str, Load]]:
    """Return names, SI units and loads: forces of drives, accelerations, pressure, torques on creases."""
    loads = []
    for number, motor in enumerate(structure.motors):
        if motor.kind == "force":
            settings = tuple(float(number == other) for other in range(len(structure.motors)))
            suffix = " on each point" if len(motor.points) > 1 else ""
            loads.append((f"force {motor.name}{suffix}", "N", motor_load(structure, net, settings)))
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
    """Return the groups of creases that measures use, as motors for a torque; all creases if no group is chosen."""
    watched = [measure for measure in structure.measures if measure.kind == "angle"]
    chosen = [drive for drive in watched if drive.name != "creases"] or watched
    return [(drive.name, Motor(name=drive.name, hinges=drive.hinges)) for drive in chosen if drive.hinges]


@dataclass(frozen=True, kw_only=True, eq=False)
class Strength:
    """Strains, forces and moments, in the order of the net's parts.

    Attributes:
        strains: of the bars, (spring,); 0 for those without a resting length.
        forces: of the bars, tension positive, N, (spring,).
        moments: of the creases, derivatives of their energies by their angles, N m, (crease,).
        pulls: of the tendons, N, (tendon,).
        extensions: of the tendons, divided by their resting lengths, (tendon,).
        stresses: of the membranes, principal second Piola-Kirchhoff stresses, the larger first, Pa, (triangle, 2).
    """

    strains: Array
    forces: Array
    moments: Array
    pulls: Array
    extensions: Array
    stresses: Array


def strength(net: Net, shape: NetShape) -> Strength:
    """Compute strains, forces and moments of all parts of a net in a shape."""
    bars, tendons, _, _ = sides_of(net, shape.positions)
    rest, length = net.springs.rest_length, np.linalg.norm(bars, axis=0)
    law, span = net.tendons.law, np.linalg.norm(tendons, axis=0)
    longer = np.maximum(span - law.rest_length, 0.0)
    return Strength(
        strains=np.divide(length - rest, rest, out=np.zeros_like(rest), where=rest > 0),
        forces=net.springs.stiffness * (length - rest),
        moments=net.creases.law.moment(shape.angles),
        pulls=law.force(span),
        extensions=np.divide(longer, law.rest_length, out=np.zeros_like(span), where=np.asarray(law.rest_length) > 0),
        stresses=membrane_stresses(net, shape),
    )
