"""Facts about every interior vertex of a sheet."""

from __future__ import annotations

import math
from dataclasses import dataclass

from forficula.pattern.crease_pattern import CreasePattern, is_unfolded
from forficula.pattern.facts.flat_folding import VertexCheck, vertex_checks
from forficula.pattern.facts.rigid_folding import vertex_folds
from forficula.pattern.facts.vertex_closure import vertex_freedoms
from forficula.pattern.facts.vertex_creases import VertexCreases, vertex_creases

_SURROUNDED = 1e-6  # rad; error of 360 deg in files with seven digits


@dataclass(frozen=True, kw_only=True)
class VertexFacts:
    """Facts about an interior vertex.

    Attributes:
        vertex: number of the vertex.
        creases: number of creases at the vertex, without flat ones.
        total: sum of the facet angles around the vertex, rad.
        missing: half the difference between the sums of every second sector and of the others, rad: the angle to move
            from one set to the other for the vertex to fold flat; inf for an odd number of creases (Kawasaki 1989;
            Justin 1986).
        check: residuals of the flat-folding conditions; None where the sheet is not flat.
        freedoms: number of free fold angles in a folded state.
        folds: whether rigid panels can leave the flat state with every crease in its sense; None where creases are
            unassigned or the sheet is not flat.
    """

    vertex: int
    creases: int
    total: float
    missing: float
    check: VertexCheck | None
    freedoms: int
    folds: bool | None

    @property
    def developable(self) -> bool:
        """Whether the angles around the vertex add up to 360 deg."""
        return abs(self.total - 2 * math.pi) < _SURROUNDED


def vertex_facts(pattern: CreasePattern) -> tuple[VertexFacts, ...]:
    """Compute the facts about every interior vertex, in the order of `interior_vertices`.

    Raises:
        InputError: faces are not counterclockwise.
    """
    flat = is_unfolded(pattern)
    around = vertex_creases(pattern)
    checks = vertex_checks(pattern) if flat else (None,) * len(around)
    return tuple(
        VertexFacts(
            vertex=item.vertex,
            creases=len(item.edges),
            total=item.total,
            missing=_missing(item),
            check=check,
            freedoms=vertex_freedoms(len(item.edges)),
            folds=vertex_folds(pattern, item) if flat else None,
        )
        for item, check in zip(around, checks, strict=True)
    )


def fault_labels(facts: VertexFacts) -> tuple[str, ...]:
    """Return short labels of the flat-folding conditions that a flat vertex fails."""
    check, words = facts.check, []
    if check is None:
        return ()
    if math.isinf(check.kawasaki):
        words.append(f"{check.creases} creases: odd" if check.creases > 1 else "a single crease")
    elif abs(check.kawasaki) > check.allowed:
        words.append(f"{math.degrees(facts.missing):.2g}° missing")
    if check.maekawa and not math.isinf(check.kawasaki):
        words.append(f"|M − V| = {check.maekawa + 2}")
    if check.big_little_big:
        words.append("trapped sector")
    return tuple(words)


def _missing(around: VertexCreases) -> float:
    """Return half the alternating sum of sectors."""
    if len(around.edges) % 2:
        return math.inf
    return abs(math.fsum([*around.sectors[0::2], *-around.sectors[1::2]])) / 2
