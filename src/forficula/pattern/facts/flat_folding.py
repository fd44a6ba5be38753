"""Check the conditions of flat folding of a crease pattern, and describe the result in sentences."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from forficula.pattern.crease_pattern import (
    CreasePattern,
    big_little_big_residuals,
    creases_inside,
    is_unfolded,
    kawasaki_residuals,
    maekawa_residuals,
)

# of the alternating sum of sectors, rad: the rounding of files with seven digits, far below the accuracy of a sheet
_ALLOWED = 1e-6
_ROUNDING = 256 * float(np.finfo(np.float64).eps)


@dataclass(frozen=True, kw_only=True)
class VertexCheck:
    """Residuals of the flat-folding conditions at an interior vertex; see `kawasaki_residuals` and the others.

    Attributes:
        vertex: number of the vertex.
        creases: number of creases at the vertex, without flat ones.
        kawasaki: alternating sum of the sectors, rad; inf for an odd number of creases.
        allowed: largest `kawasaki` that counts as rounding, rad.
        maekawa: |mountains - valleys| - 2; None where a crease is unassigned.
        big_little_big: number of sectors that are trapped between two larger ones.
    """

    vertex: int
    creases: int
    kawasaki: float
    allowed: float
    maekawa: int | None
    big_little_big: int


def vertex_checks(pattern: CreasePattern) -> tuple[VertexCheck, ...]:
    """Check every interior vertex of a sheet, in the order of `interior_vertices`.

    Raises:
        InputError: the sheet is not flat.
    """
    coords, largest = pattern.vertices_coords, float(np.abs(pattern.vertices_coords).max())
    checks = []
    for (vertex, edges), kawasaki, maekawa, trapped in zip(
        creases_inside(pattern),
        kawasaki_residuals(pattern).tolist(),
        maekawa_residuals(pattern).tolist(),
        big_little_big_residuals(pattern).tolist(),
        strict=True,
    ):
        ends = coords[pattern.edges_vertices[edges]]
        shortest = float(np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1).min()) if len(edges) else 1.0
        unassigned = any(pattern.edges_assignment[edge] == "U" for edge in edges)
        checks.append(
            VertexCheck(
                vertex=vertex,
                creases=len(edges),
                kawasaki=kawasaki,
                allowed=max(_ALLOWED, _ROUNDING * len(edges) * largest / shortest),
                maekawa=None if unassigned else maekawa,
                big_little_big=trapped,
            )
        )
    return tuple(checks)


def flat_folding_faults(pattern: CreasePattern) -> list[str]:
    """List why a sheet does not fold flat, one sentence per condition that fails; empty for a folded sheet."""
    if not is_unfolded(pattern):
        return []
    checks = vertex_checks(pattern)
    return [sentence for fails, sentence in (_kawasaki(checks), _maekawa(checks), _big_little_big(checks)) if fails]


def flat_folding_text(pattern: CreasePattern) -> list[str]:
    """Describe in sentences whether a sheet folds flat, and why."""
    if not is_unfolded(pattern):
        return ["The sheet is not flat, so flat folding is not checked."]
    checks = vertex_checks(pattern)
    if not checks:
        folds = any(letter in "MVU" for letter in pattern.edges_assignment)
        return ["No interior vertex: every crease folds independently." if folds else "No crease to fold."]
    results = _kawasaki(checks), _maekawa(checks), _big_little_big(checks)
    verdict = (
        "It does not fold flat."
        if any(fails for fails, _ in results)
        else "Every vertex folds flat by itself; whether layers collide is not checked."
    )
    return [*(sentence for _, sentence in results), verdict]


def _kawasaki(checks: Sequence[VertexCheck]) -> tuple[bool, str]:
    """Return whether Kawasaki's condition fails, and the sentence about it."""
    odd = [check for check in checks if math.isinf(check.kawasaki)]
    if odd:
        creases = _counted(odd[0].creases, "crease", "creases")
        return True, (
            f"Kawasaki fails at {_places(odd)}: an odd number of creases never folds flat, vertex {odd[0].vertex}"
            f" has {creases}."
        )
    worst = max(checks, key=lambda check: abs(check.kawasaki), default=None)
    if worst is None:
        return False, ""
    failing = [check for check in checks if abs(check.kawasaki) > check.allowed]
    residual = f"{math.degrees(abs(worst.kawasaki)):.3g} deg, at vertex {worst.vertex}"
    if failing:
        return True, f"Kawasaki fails at {_places(failing)}: the alternating sum of sectors is up to {residual}."
    return False, f"Kawasaki holds: the alternating sum of sectors is 0, to {residual}."


def _maekawa(checks: Sequence[VertexCheck]) -> tuple[bool, str]:
    """Return whether Maekawa's condition fails, and the sentence about it."""
    failing = [check for check in checks if check.maekawa]
    unknown = [check for check in checks if check.maekawa is None]
    if failing:
        first = failing[0]
        differ = (first.maekawa or 0) + 2
        return True, (
            f"Maekawa fails at {_places(failing)}: mountains and valleys must differ by 2, at vertex {first.vertex}"
            f" they differ by {differ}."
        )
    if unknown:
        return False, f"Maekawa is not checked at {_places(unknown)}, where creases are unassigned."
    return False, "Maekawa holds: mountains and valleys differ by 2."


def _big_little_big(checks: Sequence[VertexCheck]) -> tuple[bool, str]:
    """Return whether the big-little-big condition fails, and the sentence about it."""
    failing = [check for check in checks if check.big_little_big]
    if failing:
        return True, (
            f"Big-little-big fails at {_places(failing)}: a sector between two larger ones needs a mountain and a"
            f" valley beside it, at vertex {failing[0].vertex} {failing[0].big_little_big} lack them."
        )
    return False, "Big-little-big holds: no sector is trapped between two larger ones."


def _places(checks: Sequence[VertexCheck]) -> str:
    """Name the first few vertices."""
    shown = ", ".join(str(check.vertex) for check in checks[:5])
    more = f" and {len(checks) - 5} more" if len(checks) > 5 else ""
    return f"{'vertex' if len(checks) == 1 else 'vertices'} {shown}{more}"


def _counted(count: int, one: str, many: str | None = None) -> str:
    return f"{count} {one if count == 1 or many is None else many}"
