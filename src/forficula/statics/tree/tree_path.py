"""Quasi-static path of bodies on joints in a tree under one of its drives."""

from __future__ import annotations

import numpy as np

from forficula.arrays import Array
from forficula.statics.quasi_static_path import NumberedEvent, QuasiStaticPath, QuasiStaticPoint, last_event, path_of
from forficula.statics.tree.hinge_landscape import crossed_hinges
from forficula.statics.tree.pose import carried_points, places_of, pose, tree_of
from forficula.statics.tree.potential import Ensemble, ensemble, potential, stored_energy
from forficula.statics.tree.quasi_static import TorquePath, largest_torque, least_slow_torque, start_state, state_after
from forficula.structure import Drive, Structure, Transition, drive_of


def tree_path(structure: Structure, drive: Drive, transition: Transition) -> QuasiStaticPath:
    """Follow a tree under a slowly growing drive; see `forficula.statics.survey.quasi_static_path`."""
    structures = ensemble([structure])
    before, hinges = start_state(structures), crossed_hinges(structure)
    for earlier in structure.transitions:
        most = largest_torque(structures, earlier, hinges)
        slow = least_slow_torque(structures, before.position, earlier, most, recorded=True)
        if earlier is transition:
            break
        before = state_after(structures, earlier, slow.torque, slow.position)
    path, reached = slow.paths[0], bool(np.isfinite(slow.torque[0]))
    points, events = tree_points(structures, drive, path), _snaps(structures, drive, path)
    events.append(last_event(points, reached=reached))
    return path_of(structure, transition.name, drive, points, events, reached=reached)


def _snaps(structures: Ensemble, drive: Drive, path: TorquePath) -> list[NumberedEvent]:
    """Return the snaps of a path, each with the energy that it releases at its constant torque."""
    unit, events = np.array(drive.shares) * (-1.0 if drive.strength < 0 else 1.0), list[NumberedEvent]()
    for first, last in path.snaps:
        energy = potential(structures.repeated(2), path.position[[first, last]], path.torque[last] * unit)[0]
        events.append(
            NumberedEvent(
                kind="snap",
                first=first,
                last=last,
                strength=float(path.torque[last]) * (-1.0 if drive.strength < 0 else 1.0),
                released=float(energy[0] - energy[1]),
            )
        )
    return events


def tree_points(structures: Ensemble, drive: Drive, path: TorquePath) -> list[QuasiStaticPoint]:
    """Return the steps of a path as points of a quasi-static path."""
    structure, count = structures.structure, len(path.torque)
    energy = stored_energy(structures.repeated(count), path.position)
    positions = place_positions(structure, path.position)
    resting = np.ones(count, dtype=np.bool_)
    for first, last in path.snaps:
        resting[first + 1 : last] = False
    sign = -1.0 if drive.strength < 0 else 1.0
    return [
        QuasiStaticPoint(
            strength=sign * float(path.torque[number]),
            resting=bool(resting[number]),
            angles=path.position[number],
            positions=positions[number],
            coordinates=path.position[number],
            energy={part: float(values[number]) for part, values in energy.items()},
        )
        for number in range(count)
    ]


def place_positions(structure: Structure, angles: Array) -> Array:
    """Return the positions of a structure's points, then of the nodes of its membranes, m, (case, place, 3).

    Args:
        structure: a tree.
        angles: of all hinges, in their own senses, rad, (case, hinge).
    """
    tree = tree_of(structure)
    bodies = [np.array([point.body for point in structure.points], dtype=np.int64)]
    places = [np.array([point.place for point in structure.points]).reshape(-1, 3)]
    for membrane in structure.membranes:
        bodies.append(membrane.bodies)
        places.append(membrane.places)
    carried = carried_points(tree, np.concatenate(bodies), np.concatenate(places))
    return np.moveaxis(places_of(carried, pose(tree, angles)), 0, -1)
