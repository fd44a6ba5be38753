"""Shape of a net under its drive as a point of a quasi-static path."""

from __future__ import annotations

from forficula.arrays import Array
from forficula.statics.net.contact.contact_energy import contact_forces
from forficula.statics.net.driven.driven_net import DrivenNet, prescribes_displacement
from forficula.statics.net.driven.net_course import reaction
from forficula.statics.net.energy import remembered
from forficula.statics.net.net import Net, NetShape
from forficula.statics.net.net_of import own_angles, own_memory, place_points, point_positions, valley_angles
from forficula.statics.net.net_state import stored_parts
from forficula.statics.quasi_static_path import QuasiStaticPoint, rest_changes
from forficula.structure import Structure


def net_point(driven: DrivenNet, shape: NetShape, factor: float, *, resting: bool = True) -> QuasiStaticPoint:
    """Return a shape of a net under its drive as a point of a quasi-static path."""
    structure, drive, strength = driven.structure, driven.drive, factor * driven.drive.strength
    further = valley_angles(structure, strength * rest_changes(structure, drive))
    displaced = prescribes_displacement(structure, drive)
    return QuasiStaticPoint(
        strength=float(strength),
        resting=resting,
        angles=own_angles(structure, shape),
        positions=place_positions(structure, driven.net, shape),
        coordinates=(shape.positions - driven.net.nodes).ravel(),
        energy=stored_parts(structure, driven.net, shape, further),
        force=reaction(structure, driven.net, drive, shape) if displaced else 0.0,
        contacts=contact_forces(driven.net, shape) if resting else {},
        memory=own_memory(structure, remembered(driven.net, shape)),
    )


def place_positions(structure: Structure, net: Net, shape: NetShape) -> Array:
    """Return the positions of a structure's points, then of the nodes of its membranes, m, (place, 3)."""
    return point_positions(net, shape)[place_points(structure)]
