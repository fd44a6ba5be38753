"""Warnings about a structure that can be built."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

import numpy as np

from forficula.arrays import Array
from forficula.design import Design, part_patterns
from forficula.design.section import TIME
from forficula.pattern import flat_folding_faults
from forficula.quantities import reading_unit, show_quantity
from forficula.structure.mass import mass_of
from forficula.structure.parts import Tendon
from forficula.structure.structure import Structure
from forficula.structure.tree import built_points, built_strains

# identical tendons, and the largest of their strains
_Group = tuple[list[Tendon], float]
# largest added mass without a warning, as a share of the structure's mass: in water the added mass of the reference
# wing has twice its correct kinetic energy
_SMALL_ADDED_MASS = 0.2
# positions along a bar, as shares of its length, at which the distance from its neighbour is computed
_SHARES = np.linspace(0, 1, 1001)


def structure_warnings(design: Design, structure: Structure) -> list[str]:
    """Return warnings about a structure that can be built, as sentences.

    Args:
        design: design with the protocol of the structure.
        structure: structure of the design.

    Returns:
        Sentences. A sentence about tendons names them, unless it applies to all tendons.
    """
    folded = _time_folded(design, structure)
    groups = _identical_tendons(structure)
    built = _as_built(structure)
    faults = [
        f"{f'{part}: ' if part else ''}the sheet does not fold flat: {fault.removesuffix('.')}"
        for part, pattern in part_patterns(design).items()
        for fault in flat_folding_faults(pattern)
    ]
    return [
        *faults,
        *_overlapping_bars(structure),
        *_heavy_medium(structure),
        *_unheld_rests(design),
        *design.idle,
        *design.law_sentences,
        *_sentences(structure, groups, [_unmeasured_strain(built, tendons[0], strain) for tendons, strain in groups]),
        *_sentences(structure, groups, [_relaxing_branches(structure, tendons[0], folded) for tendons, _ in groups]),
        *_sentences(structure, groups, [_softening(built, tendons[0], strain) for tendons, strain in groups]),
    ]


def _identical_tendons(structure: Structure) -> list[_Group]:
    """Group tendons with the same law; return each group with its largest strain as built."""
    groups: dict[str, _Group] = {}
    for tendon, strain in zip(structure.tendons, built_strains(structure).tolist(), strict=True):
        name = repr((tendon.law, tendon.gauge_length, tendon.material))
        tendons, largest = groups.get(name, ([], strain))
        groups[name] = [*tendons, tendon], max(largest, strain)
    return list(groups.values())


def _sentences(structure: Structure, groups: Sequence[_Group], sentences: Sequence[str]) -> list[str]:
    """Combine equal sentences about groups of tendons, with the tendons' names; empty sentences are left out."""
    named: dict[str, list[str]] = {}
    for (tendons, _), sentence in zip(groups, sentences, strict=True):
        if sentence:
            named.setdefault(sentence, []).extend(tendon.name for tendon in tendons)
    count = len(structure.tendons)
    return [text if len(names) == count else f"{', '.join(names)}: {text}" for text, names in named.items()]


def _overlapping_bars(structure: Structure) -> list[str]:
    """Warn of neighbouring bars that overlap near their inner ends in the built shape."""
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
    """Warn of a large added mass, because it acts in every direction."""
    if structure.medium is None:
        return []
    added = sum(mass.mass for mass in structure.medium.masses)
    mass = sum(body.mass + mass_of(structure, number)[0] for number, body in enumerate(structure.bodies))
    if added <= _SMALL_ADDED_MASS * mass:
        return []
    whole = structure.appearance.whole
    return [
        f"the added mass of the medium is {added / mass:.2g} times the mass of the {whole}, and the model also applies"
        f" it to motion in the plane of the panels: the {whole} moves more slowly than it should"
    ]


def _unheld_rests(design: Design) -> list[str]:
    """Warn of simulated stages that end at rest without a time for which the structure must rest."""
    hold = show_quantity(design.protocol.window, TIME)
    return [
        f'protocol.stages.{number}: "{stage.name}" ends at the first moment at which every part is slow, which may be'
        f' a turning point of a swing: hold = "{hold}" ends the stage only after the structure has rested for this time'
        for number, stage in enumerate(design.protocol.stages)
        if stage.until == "rest" and not stage.quasi_static and not stage.hold
    ]


def _overlaps(one: Array, other: Array, least: float) -> list[float]:
    """Return the length from its first end, m, in which a bar, (end, 3), is nearer than `least` to another, if any."""
    close = _SHARES[np.minimum(_gaps(one, other), _gaps(other, one)) < least]
    return [float(close[-1]) * float(np.linalg.norm(one[1] - one[0]))] if len(close) else []


def _gaps(one: Array, other: Array) -> Array:
    """Compute the distances of points along a line, (end, 3), from another line, m, (point,)."""
    points = one[0] + np.outer(_SHARES, one[1] - one[0]) - other[0]
    length = np.linalg.norm(other[1] - other[0])
    along = (other[1] - other[0]) / length
    nearest = np.clip(points @ along, 0, length)
    return np.asarray(np.linalg.norm(points - np.outer(nearest, along), axis=1))


def _as_built(structure: Structure) -> str:
    """Return the words for the structure as built, such as "the flat wing"."""
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
    """Return the longest total duration of the stages between the first two transitions, s; 0 if there are none."""
    driven = [transition.stage for transition in structure.transitions[:2]]
    first, *rest = driven or [None]
    if first is None or not rest or rest[0] is None:
        return 0.0
    return sum(stage.time_limit for stage in design.protocol.stages[first + 1 : rest[0]])


def _relaxing_branches(structure: Structure, tendon: Tendon, folded: float) -> str:
    """Warn of branches that relax while the structure is folded; in a run they follow the distance of the ends."""
    times = [branch.time for branch in tendon.law.branches if branch.time < folded]
    if not times:
        return ""
    shown = ", ".join(f"{factor * time:.3g} {unit}" for time in times for unit, factor in [reading_unit("s", time)])
    return (
        f"Maxwell branches of {shown} relax while the {structure.appearance.whole} is"
        f" {structure.transitions[0].state}, to the distance of the tendon's ends instead of the length of a slack"
        " tendon: they pull too much when it opens"
    )


def _softening(built: str, tendon: Tendon, strain: float) -> str:
    material = tendon.material
    if material is None or material.softening is None or strain <= material.residual_strain:
        return ""
    return (
        "tendons do not soften within a run: they have the stiffness of the first pull; with --cycles, they have the"
        f" stiffness after the stretch of {built} from the second cycle on"
    )


def _readable(length: float) -> str:
    unit, factor = reading_unit("m", length)
    return f"{factor * length:.4g} {unit}"
