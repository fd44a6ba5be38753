"""Mechanisms of a structure: named groups of the elements that store energy."""

from __future__ import annotations

import math

from forficula.structure.parts import Hinge, Mechanism
from forficula.structure.sheets.facets import hinge_groups, springs_name
from forficula.structure.structure import Structure

# kinds of elements that store energy, as fields of a structure and of a mechanism
ELEMENT_KINDS = ("hinges", "springs", "tendons", "membranes", "couplings")


def mechanisms_of(structure: Structure) -> tuple[Mechanism, ...]:
    """Return the mechanisms of a structure; without any, one mechanism for each kind of element that stores energy.

    Raises:
        ValueError: an element that stores energy belongs to no mechanism or to several.
    """
    if not structure.mechanisms:
        return _mechanisms_by_kind(structure)
    for kind, numbers in storing_elements(structure).items():
        named = [number for mechanism in structure.mechanisms for number in getattr(mechanism, kind)]
        for number in numbers:
            if named.count(number) != 1:
                name = getattr(structure, kind)[number].name
                raise ValueError(
                    f"{structure.name}: {kind}: {name} belongs to {named.count(number)} mechanisms, need exactly one"
                )
    return structure.mechanisms


def storing_elements(structure: Structure) -> dict[str, tuple[int, ...]]:
    """Return the numbers of the elements that store energy, by kind."""
    return {
        "hinges": tuple(number for number, hinge in enumerate(structure.hinges) if _stores_energy(hinge)),
        "springs": tuple(range(len(structure.springs))),
        "tendons": tuple(range(len(structure.tendons))),
        "membranes": tuple(range(len(structure.membranes))),
        "couplings": tuple(number for number, coupling in enumerate(structure.couplings) if not coupling.rigid),
    }


def _mechanisms_by_kind(structure: Structure) -> tuple[Mechanism, ...]:
    """Return one mechanism for each kind of element that stores energy."""
    numbers = storing_elements(structure)
    storing = set(numbers["hinges"])
    groups = {kind: tuple(filter(storing.__contains__, every)) for kind, every in hinge_groups(structure).items()}
    mechanisms = (
        Mechanism(name="tendons", tendons=numbers["tendons"]),
        Mechanism(name="membrane", membranes=numbers["membranes"]),
        *(Mechanism(name=kind, hinges=hinges) for kind, hinges in groups.items()),
        Mechanism(name=springs_name(structure), springs=numbers["springs"]),
        Mechanism(name="couplings", couplings=numbers["couplings"]),
    )
    return tuple(item for item in mechanisms if any(getattr(item, kind) for kind in ELEMENT_KINDS))


def _stores_energy(hinge: Hinge) -> bool:
    """Return whether a hinge has a spring or Maxwell branches, or is a crease with a stop, whose stops are springs."""
    stopped = math.isfinite(hinge.lower) or math.isfinite(hinge.upper)
    return hinge.stiffness > 0 or bool(hinge.branches) or (hinge.flaps is not None and stopped)
