"""What a person should know of a structure that can be built all the same."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

import numpy as np

from forficula.arrays import Array
from forficula.design import Design, design_pattern
from forficula.pattern import flat_folding_faults
from forficula.quantities import reading_unit
from forficula.structure.mass import mass_of
from forficula.structure.parts import Tendon
from forficula.structure.structure import Structure
from forficula.structure.tree import built_points, built_strains

# tendons that are alike, and the largest of their strains
_Group = tuple[list[Tendon], float]
# of the mass of a structure: in water the medium has twice the kinetic energy that it should on the reference wing
_SLIGHT = 0.2
# places along a bar at which it is compared with its neighbour
_SHARES = np.linspace(0, 1, 1001)


def structure_warnings(design: Design, structure: Structure) -> list[str]:
    """What a person should know of a structure that can be built all the same, one sentence each.

    Args:
        design: with the protocol that the structure goes through.
        structure: as built.

    Returns:
        One sentence for all tendons of which it is true, naming them where it is not true of all.
    """
    folded = _time_folded(design, structure)
    groups = _alike(structure)
    built = _as_built(structure)
    faults = flat_folding_faults(design_pattern(design))
    return [
        *(f"the sheet does not fold flat: {fault.removesuffix('.')}" for fault in faults),
        *_overlapping_bars(structure),
        *_heavy_medium(structure),
        *design.idle,
        *_told(structure, groups, [_unmeasured_strain(built, tendons[0], strain) for tendons, strain in groups]),
        *_told(structure, groups, [_relaxing_branches(structure, tendons[0], folded) for tendons, _ in groups]),
        *_told(structure, groups, [_softening(built, tendons[0], strain) for tendons, strain in groups]),
    ]


def _alike(structure: Structure) -> list[_Group]:
    """Tendons of the same law, and the largest of their strains as built."""
    groups: dict[str, _Group] = {}
    for tendon, strain in zip(structure.tendons, built_strains(structure).tolist(), strict=True):
        name = repr((tendon.law, tendon.gauge_length, tendon.material))
        tendons, largest = groups.get(name, ([], strain))
        groups[name] = [*tendons, tendon], max(largest, strain)
    return list(groups.values())


def _told(structure: Structure, groups: Sequence[_Group], sentences: Sequence[str]) -> list[str]:
    """What is to be said of groups of tendons; nothing of one is an empty sentence."""
    told: dict[str, list[str]] = {}
    for (tendons, _), sentence in zip(groups, sentences, strict=True):
        if sentence:
            told.setdefault(sentence, []).extend(tendon.name for tendon in tendons)
    every = len(structure.tendons)
    return [text if len(names) == every else f"{', '.join(names)}: {text}" for text, names in told.items()]


def _overlapping_bars(structure: Structure) -> list[str]:
    """Of bars that lie so close where they are built that they overlap, from their first ends on."""
    points = built_points(structure)
    bars = [bar for bar in structure.bars if bar.overlaps]
    within = [
        (reach, one.diameter)
        for one, other in pairwise(bars)
        for reach in _overlaps(
            points[list(one.points)], points[list(other.points)], (one.diameter + other.diameter) / 2
        )
    ]
    if not within:
        return []
    reach, diameter = max(within)
    return [
        f"neighbouring veins of {_readable(diameter)} overlap within {_readable(reach)} of the hub,"
        " which the simulation allows: a part to print needs thinner veins or a larger hub"
    ]


def _heavy_medium(structure: Structure) -> list[str]:
    """Of air or water that moves with panels and counts in every direction, where much of it does."""
    if structure.medium is None:
        return []
    with_it = sum(each.mass for each in structure.medium.masses)
    own = sum(body.mass + mass_of(structure, number)[0] for number, body in enumerate(structure.bodies))
    if with_it <= _SLIGHT * own:
        return []
    whole = structure.appearance.whole
    return [
        f"the medium that moves with the {whole} has {with_it / own:.2g} times its mass, and counts where it moves in"
        " its plane, too: it moves more slowly than it should"
    ]


def _overlaps(one: Array, other: Array, apart: float) -> list[float]:
    """How far from its first end a bar, (end, 3), is nearer to another one than that, m; nothing where it is not."""
    close = _SHARES[np.minimum(_gaps(one, other), _gaps(other, one)) < apart]
    return [float(close[-1]) * float(np.linalg.norm(one[1] - one[0]))] if len(close) else []


def _gaps(one: Array, other: Array) -> Array:
    """How far places along a line, (end, 3), are from another line, m, (place,)."""
    places = one[0] + np.outer(_SHARES, one[1] - one[0]) - other[0]
    length = np.linalg.norm(other[1] - other[0])
    along = (other[1] - other[0]) / length
    nearest = np.clip(places @ along, 0, length)
    return np.asarray(np.linalg.norm(places - np.outer(nearest, along), axis=1))


def _as_built(structure: Structure) -> str:
    """What sentences call the structure as it is built, such as "the flat wing"."""
    whole, state = structure.appearance.whole, structure.states[0].name if structure.states else ""
    return f"the {state} {whole}" if state and state == structure.stage_states[0] else f"the {whole} as built"


def _unmeasured_strain(built: str, tendon: Tendon, strain: float) -> str:
    material = tendon.material
    if material is None or material.largest_strain is None or strain <= material.largest_strain:
        return ""
    return (
        f"{built} stretches its tendons by {100 * strain:.3g} %, beyond the {100 * material.largest_strain:.3g} %"
        f" up to which {material.name or 'their law'} was measured: a longer tendon.rest_length stays within it"
    )


def _time_folded(design: Design, structure: Structure) -> float:
    """How long the stages between the first two transitions take at most, s; 0 where there are none."""
    driven = [transition.stage for transition in structure.transitions[:2]]
    first, *rest = driven or [None]
    if first is None or not rest or rest[0] is None:
        return 0.0
    return sum(stage.time_limit for stage in design.protocol.stages[first + 1 : rest[0]])


def _relaxing_branches(structure: Structure, tendon: Tendon, folded: float) -> str:
    """Of branches that relax while it is folded: in a run their length is the distance of the tendon's ends."""
    times = [branch.time for branch in tendon.law.branches if branch.time < folded]
    if not times:
        return ""
    shown = ", ".join(f"{factor * time:.3g} {unit}" for time in times for unit, factor in [reading_unit("s", time)])
    return (
        f"Maxwell branches of {shown} relax while the {structure.appearance.whole} is"
        f" {structure.transitions[0].state}, to the distance of the tendon's ends and not to"
        " the length of a slack tendon: when it opens they pull too much"
    )


def _softening(built: str, tendon: Tendon, strain: float) -> str:
    material = tendon.material
    if material is None or material.softening is None or strain <= material.residual_strain:
        return ""
    return (
        "tendons do not soften within a run: they have the spring of a first pull; with --cycles, those from the second"
        f" on have the spring that the stretch of {built} leaves"
    )


def _readable(length: float) -> str:
    unit, factor = reading_unit("m", length)
    return f"{factor * length:.4g} {unit}"
