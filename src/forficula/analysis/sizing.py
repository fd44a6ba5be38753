"""Thickness of a tendon of a material for a given stiffness."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from forficula.design import AnyDesign
from forficula.errors import InputError
from forficula.material.characterisation import LENGTH, known_length
from forficula.material.law.material_law import MaterialLaw, area_for, known_moduli
from forficula.material.law.softening import spring_stress
from forficula.quantities import show_quantity
from forficula.structure import Structure, built_lengths, structure_of

# limits of lengths, as for a design, m
_SHORTEST, _LONGEST = 1e-12, 1e12


@dataclass(frozen=True, kw_only=True)
class TendonSize:
    """Cross-section of a tendon with a given stiffness.

    Attributes:
        stiffness: N/m.
        area: cross-section for this stiffness at a small extension, m2.
        mean_area: cross-section for this mean stiffness from slack to the built shape, m2; equal to `area` for a linear
            law; None if the tendon is slack in the built shape.
    """

    stiffness: float
    area: float
    mean_area: float | None

    @property
    def diameter(self) -> float:
        """Return the diameter of a round tendon with the cross-section `area`, m."""
        return math.sqrt(4 * self.area / math.pi)


@dataclass(frozen=True, kw_only=True)
class TendonSizes:
    """Tendon sizes for one length.

    Attributes:
        length: of the unstretched tendon, m.
        why: origin of the length, in words.
        flat_strain: strain in the built shape of the longest tendon with this resting length, or of the longest of all
            tendons if none has it; < 0 if it is slack.
        beyond: whether this strain exceeds the range in which the law was measured; None if the law has no range.
        sizes: one per requested stiffness, in their order.
        whole: name of the structure in sentences.
    """

    length: float
    why: str
    flat_strain: float
    beyond: bool | None
    sizes: tuple[TendonSize, ...]
    whole: str


def size_tendons(
    design: AnyDesign, law: MaterialLaw, stiffnesses: Sequence[float], *, length: float | None = None
) -> tuple[TendonSizes, ...]:
    """Compute the size of tendons of a material from the stiffness that they need, A = k L / E.

    Args:
        design: the design whose built shape stretches the tendons.
        law: of the material.
        stiffnesses: N/m, > 0.
        length: of the tendon, m; by default that of the specimens behind the law, if it is known.

    Returns:
        Sizes for that length, and for every other resting length > 0 of the design's tendons.

    Raises:
        InputError: no tendons, a stiffness or length that is not > 0, neither length, a modulus that is absent or
            known as a range only, or a material that is not for tendons.
    """
    structure = structure_of(design)
    if not structure.tendons:
        raise InputError(f"{structure.name} has no tendon")
    lengths = list(_lengths(structure, law, length))
    if not lengths:
        raise InputError("length: is missing: the design's tendon.rest_length is 0, and strain is extension by length")
    for candidate, why in lengths:
        if not _SHORTEST <= candidate <= _LONGEST:
            shown = [show_quantity(bound, LENGTH) for bound in (_SHORTEST, _LONGEST, candidate)]
            raise InputError(f"length: need >= {shown[0]} and <= {shown[1]}, got {shown[2]}, {why}")
    return tuple(_sizes(structure, law, stiffnesses, candidate, why) for candidate, why in lengths)


def _flat_length(structure: Structure, length: float) -> float:
    """Return the length in the built shape of the longest tendon with a resting length, or of all if none has it, m."""
    built = built_lengths(structure)
    matching = [math.isclose(tendon.gauge_length, length, rel_tol=1e-9) for tendon in structure.tendons]
    return float((built[matching] if any(matching) else built).max(initial=0.0))


def _lengths(structure: Structure, law: MaterialLaw, length_given: float | None) -> Iterator[tuple[float, str]]:
    known = known_length(law)
    first = length_given if length_given is not None else known
    if first is not None:
        yield first, "as given" if length_given is not None else f"of the specimens of {law.name}"
    names: dict[float, list[str]] = {}
    for tendon in structure.tendons:
        names.setdefault(tendon.gauge_length, []).append(tendon.name)
    for rest_length, tendons in names.items():
        if rest_length > 0 and (first is None or not math.isclose(rest_length, first, rel_tol=1e-9)):
            which = "" if len(names) == 1 else f", {', '.join(tendons)}"
            yield rest_length, f"resting length of {structure.name}{which}"


def _sizes(
    structure: Structure, law: MaterialLaw, stiffnesses: Sequence[float], length: float, why: str
) -> TendonSizes:
    """Compute sizes of tendons of one length, with the strain of the longest of them in the built shape."""
    areas = [area_for(law, length=length, stiffness=stiffness) for stiffness in stiffnesses]
    strain = _flat_length(structure, length) / length - 1
    share = _mean_share(law, strain - law.residual_strain)
    sizes = [
        TendonSize(stiffness=stiffness, area=area, mean_area=None if share is None else area / share)
        for stiffness, area in zip(stiffnesses, areas, strict=True)
    ]
    beyond = None if law.largest_strain is None else strain > law.largest_strain
    whole = structure.appearance.whole
    return TendonSizes(length=length, why=why, flat_strain=strain, beyond=beyond, sizes=tuple(sizes), whole=whole)


def _mean_share(law: MaterialLaw, strain: float) -> float | None:
    """Return the secant modulus at a strain divided by the modulus at small strain; None if the tendon is slack."""
    if strain <= 0:
        return None
    moduli = known_moduli(law)
    reached = strain if law.yield_strain is None else min(strain, law.yield_strain)
    return float(spring_stress(moduli, reached)) / strain / moduli[0]
