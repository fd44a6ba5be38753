"""How thick a tendon of a material must be to have a stiffness."""

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

# as a design's, m
_SHORTEST, _LONGEST = 1e-12, 1e12


@dataclass(frozen=True, kw_only=True)
class TendonSize:
    """A tendon that has a stiffness.

    Attributes:
        stiffness: N/m.
        area: of its cross-section, if the stiffness is that of a small extension, m2.
        mean_area: if it is the mean stiffness from slack to the built shape, m2; as `area` for a linear law, None where
            that leaves the tendon slack.
    """

    stiffness: float
    area: float
    mean_area: float | None

    @property
    def diameter(self) -> float:
        """Of a round tendon of `area`, m."""
        return math.sqrt(4 * self.area / math.pi)


@dataclass(frozen=True, kw_only=True)
class TendonSizes:
    """The tendons of one length.

    Attributes:
        length: of the unstretched tendon, m.
        why: whose length it is.
        flat_strain: of the longest tendon of that resting length in the built shape, or of all where none has it; < 0
            where it is slack.
        beyond: whether that is more than the law was measured for; None where the law does not say.
        sizes: by stiffness, as asked.
        whole: what sentences call the structure.
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
    """Size tendons of a material by the stiffness that they need, A = k L / E.

    Args:
        design: whose built shape stretches them.
        law: of the material.
        stiffnesses: N/m, > 0.
        length: of the tendon, m; where it is not given, that of the specimens behind the law, if it is known.

    Returns:
        For that length, and for each resting length of the design's tendons that is another one > 0.

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
    for each, why in lengths:
        if not _SHORTEST <= each <= _LONGEST:
            shown = [show_quantity(bound, LENGTH) for bound in (_SHORTEST, _LONGEST, each)]
            raise InputError(f"length: need >= {shown[0]} and <= {shown[1]}, got {shown[2]}, {why}")
    return tuple(_sizes(structure, law, stiffnesses, each, why) for each, why in lengths)


def _flat_length(structure: Structure, length: float) -> float:
    """Of the longest tendon in the built shape, m: of those with a resting length, or of all where none has it."""
    built = built_lengths(structure)
    own = [math.isclose(tendon.gauge_length, length, rel_tol=1e-9) for tendon in structure.tendons]
    return float((built[own] if any(own) else built).max(initial=0.0))


def _lengths(structure: Structure, law: MaterialLaw, given: float | None) -> Iterator[tuple[float, str]]:
    known = known_length(law)
    first = given if given is not None else known
    if first is not None:
        yield first, "as given" if given is not None else f"of the specimens of {law.name}"
    names: dict[float, list[str]] = {}
    for tendon in structure.tendons:
        names.setdefault(tendon.gauge_length, []).append(tendon.name)
    for own, tendons in names.items():
        if own > 0 and (first is None or not math.isclose(own, first, rel_tol=1e-9)):
            which = "" if len(names) == 1 else f", {', '.join(tendons)}"
            yield own, f"resting length of {structure.name}{which}"


def _sizes(
    structure: Structure, law: MaterialLaw, stiffnesses: Sequence[float], length: float, why: str
) -> TendonSizes:
    """Sizes of tendons of a length, the longest of which the built shape stretches to another one."""
    areas = [area_for(law, length=length, stiffness=each) for each in stiffnesses]
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
    """The spring's secant modulus at a strain of its own by that at small strain; None where it is slack."""
    if strain <= 0:
        return None
    moduli = known_moduli(law)
    reached = strain if law.yield_strain is None else min(strain, law.yield_strain)
    return float(spring_stress(moduli, reached)) / strain / moduli[0]
