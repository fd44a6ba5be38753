"""Facts about a crease pattern: its pieces, vertices, flat folding, rigid folding and number of mechanisms."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from forficula.errors import InputError
from forficula.pattern.crease_pattern import ASSIGNMENTS, CreasePattern, is_unfolded
from forficula.pattern.drawings.flat_faces import parts_of
from forficula.pattern.facet_nodes import FacetNodes, facet_nodes
from forficula.pattern.facet_tree import facet_tree
from forficula.pattern.facts.flat_fold import flat_fold_text
from forficula.pattern.facts.flat_folding import flat_folding_text
from forficula.pattern.facts.rigid_folding import begins_as_assigned, folded_as_assigned
from forficula.pattern.facts.rigidity import Rigidity, rigidity
from forficula.pattern.facts.vertex_facts import VertexFacts, vertex_facts
from forficula.pattern.kinematics import folded_coordinates


@dataclass(frozen=True, kw_only=True)
class Freedoms:
    """Degrees of freedom of a sheet.

    Attributes:
        rigid: rigidity of the sheet in its drawn shape, with rigid facets.
        bending: rigidity in the drawn shape where facets bend along diagonals.
        begins: whether every crease can begin to fold in its sense, to first order; None for a sheet that is not flat.
        folded: rigidity with rigid facets in a state where every crease is folded in its sense; None where no such
            state was found.
        fold_range: smallest and largest fold angle of a mountain or valley in that state, rad.
    """

    rigid: Rigidity
    bending: Rigidity
    begins: bool | None = None
    folded: Rigidity | None = None
    fold_range: tuple[float, float] | None = None


@dataclass(frozen=True, kw_only=True)
class PatternFacts:
    """Facts about a crease pattern.

    Attributes:
        title: title of the pattern.
        vertices: number of vertices.
        facets: number of facets.
        edges: number of edges by letter, for the letters that occur, in the order of `ASSIGNMENTS`.
        roles: roles of edges that occur.
        size: size along x, y and z, m.
        flat: whether the sheet lies unfolded in one plane of constant z.
        flat_folding: sentences about whether the sheet folds flat, and why, and about the size of the folded sheet.
        loop: why the facets do not form a tree across their shared edges; empty where they do.
        not_counted: why the facts that follow are missing; empty where they are present.
        inside: facts about every interior vertex.
        parts: number of pieces that no edge joins.
        holes: number of borders beyond the first of every piece; a tube has one.
        freedoms: degrees of freedom of the sheet.
    """

    title: str
    vertices: int
    facets: int
    edges: dict[str, int]
    roles: tuple[str, ...]
    size: tuple[float, float, float]
    flat: bool
    flat_folding: tuple[str, ...]
    loop: str
    not_counted: str = ""
    inside: tuple[VertexFacts, ...] = ()
    parts: int = 1
    holes: int = 0
    freedoms: Freedoms | None = None


def pattern_facts(pattern: CreasePattern) -> PatternFacts:
    """Compute the facts about a crease pattern."""
    x, y, z = np.ptp(pattern.vertices_coords, axis=0).tolist()
    counts = {letter: pattern.edges_assignment.count(letter) for letter in ASSIGNMENTS}
    facts = PatternFacts(
        title=pattern.title or "crease pattern",
        vertices=len(pattern.vertices_coords),
        facets=len(pattern.faces_vertices),
        edges={letter: count for letter, count in counts.items() if count},
        roles=tuple(dict.fromkeys(role for role in pattern.edges_role if role)),
        size=(x, y, z),
        flat=is_unfolded(pattern),
        flat_folding=(*flat_folding_text(pattern), *flat_fold_text(pattern)),
        loop=_loop(pattern),
    )
    try:
        nodes = facet_nodes(pattern)
        return replace(
            facts,
            inside=vertex_facts(pattern),
            parts=int(nodes.parts.max()) + 1,
            holes=_holes(nodes),
            freedoms=_freedoms(pattern, facts.flat),
        )
    except InputError as error:
        return replace(facts, not_counted=str(error))


def _freedoms(pattern: CreasePattern, flat: bool) -> Freedoms:
    """Count the freedoms in the drawn shape, and in a folded state if one is found."""
    freedoms = Freedoms(
        rigid=rigidity(pattern),
        bending=rigidity(pattern, bending=True),
        begins=begins_as_assigned(pattern) if flat else None,
    )
    angles = folded_as_assigned(pattern) if freedoms.begins else None
    if angles is None:
        return freedoms
    sizes = np.abs(angles[angles != 0])
    return replace(
        freedoms,
        folded=rigidity(pattern, folded_coordinates(pattern, angles)),
        fold_range=(float(sizes.min()), float(sizes.max())),
    )


def _loop(pattern: CreasePattern) -> str:
    """Return why the facets do not form a tree; empty if they do."""
    try:
        closing = sorted(link.edge for link in facet_tree(pattern) if link.closes and link.edge is not None)
    except InputError as error:
        return str(error)
    others = f", and {len(closing) - 1} more do" if len(closing) > 1 else ""
    return f"edge {closing[0]} closes a loop of facets{others}" if closing else ""


def _holes(nodes: FacetNodes) -> int:
    """Count the borders, closed lines of sides that belong to one facet only, beyond the first of every piece."""
    sides: dict[tuple[int, int], list[int]] = {}
    for facet, points in enumerate(nodes.facets):
        for one, other in zip(points.tolist(), np.roll(points, -1).tolist(), strict=True):
            sides.setdefault((min(one, other), max(one, other)), []).append(facet)
    borders = {side: facets[0] for side, facets in sides.items() if len(facets) == 1}
    line = parts_of(len(nodes.vertices), [*borders])
    lines = {(int(nodes.parts[facet]), int(line[side[0]])) for side, facet in borders.items()}
    return len(lines) - len({part for part, _ in lines})
