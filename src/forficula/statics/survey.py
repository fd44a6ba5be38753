"""What statics says of any design: the one place that chooses how its energy is surveyed."""

from __future__ import annotations

import numpy as np

from forficula.design import AnyDesign, as_design
from forficula.statics.landscape import EnergyLandscape, Rest, tree_landscape
from forficula.statics.net.net_of import is_net, own_angles
from forficula.statics.net_landscape import NetLandscape, Progress, net_landscape
from forficula.statics.net_state import known, stored_parts
from forficula.structure import Structure, structure_of

_SAME = 1e-3  # rad; hinges that rest no farther apart do so at one place, to what tables show


def energy_landscape(design: AnyDesign, points: int = 181, progress: Progress = lambda _: None) -> EnergyLandscape:
    """Survey the statics of a design.

    What hangs on the one way in which rigid panels fold is left out where there is none; so are stable states, saddles
    and paths where the structure is a tree of bodies on joints.

    Args:
        design: what to build; its protocol says what counts as folded and as opened, and the largest fold torque.
        points: places on every curve.
        progress: is told what is worked out.

    Raises:
        InputError: it cannot be built, or a transition does not say where it leads.
    """
    design = as_design(design)
    structure = structure_of(design)
    if not is_net(structure):
        return tree_landscape(design, structure, points)
    found = net_landscape(structure, progress)
    return EnergyLandscape(
        design=design,
        structure=structure,
        hinge=None,
        tendons=(),
        ideal_hinges=(),
        fold_path=None,
        levels=None,
        partial_folds=(),
        hinge_barriers=np.zeros(0),
        rests=_rests(structure, found),
        least_torques={},
        least_torque_ranges={},
        inertial_help={},
        tips=None,
        remarks=found.remarks,
        net=found,
    )


def _rests(structure: Structure, found: NetLandscape) -> tuple[Rest, ...]:
    rests = list[Rest]()
    for name, rest, within in found.rests:
        angles = own_angles(structure, rest.shape)
        rests.append(
            Rest(
                name=name,
                angles=angles,
                energy=known(found.net, rest.energy),
                stored=stored_parts(structure, found.net, rest.shape),
                stable=rest.stable,
                within=within,
                same_as=next((each.name for each in rests if np.all(np.abs(each.angles - angles) <= _SAME)), ""),
            )
        )
    return tuple(rests)
