"""The facets of a sheet as a tree: a crease connects each facet to its parent, and all other creases close loops."""

from __future__ import annotations

from collections import deque
from collections.abc import Collection, Sequence
from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from scipy.sparse import coo_array
from scipy.sparse.csgraph import shortest_path

from forficula.errors import InputError
from forficula.pattern.crease_pattern import CreasePattern
from forficula.pattern.shared_edges import shared_edges


@dataclass(frozen=True, kw_only=True)
class FacetLink:
    """The connection of a facet to its parent.

    Attributes:
        facet: number of the facet.
        parent: number of the parent; None for a root.
        edge: number of the edge between the two facets; None for a root.
        tail: start vertex of the edge, with the parent on the left, seen from +z.
        head: end vertex of the edge.
        closes: whether the crease closes a loop, so that the facet is also connected to another parent.
    """

    facet: int
    parent: int | None = None
    edge: int | None = None
    tail: int = -1
    head: int = -1
    closes: bool = False


def facet_tree(
    pattern: CreasePattern, root: int | Sequence[int] = 0, apart: Collection[int] = ()
) -> tuple[FacetLink, ...]:
    """Connect all facets of a sheet to a root by a tree with the shortest paths.

    Mountains, valleys, unassigned and flat edges connect facets, cuts do not. Facets along flat edges are connected
    first, because nothing moves there. Every crease that is not in the tree closes a loop.

    Args:
        pattern: pattern with faces counterclockwise.
        root: root of the tree, or several roots that are not connected.
        apart: numbers of edges that do not connect facets, like cuts. A group of facets without a root then has its
            first facet as a root.

    Returns:
        The facets depth first: each follows its parent, and its subtree follows before all others. Creases that close
        loops follow last among the children of the facet on their left.

    Raises:
        InputError: a facet that does not exist, connected roots, a border edge between facets, a crease inside a plate
            of facets that flat edges join, facets that are not connected, or faces that are not counterclockwise.
    """
    return _hung(pattern, (root,) if isinstance(root, int) else tuple(root), frozenset(apart))


@lru_cache(maxsize=64)  # a pattern is frozen, and designs that differ in other values have the same pattern
def _hung(pattern: CreasePattern, roots: Sequence[int], apart: Collection[int]) -> tuple[FacetLink, ...]:
    above, starts, around = _rooted(pattern, roots, apart)
    _check_plates(pattern, above, apart)
    below: list[list[FacetLink]] = [[] for _ in around]
    used = {link.edge for link in above.values()}
    for facet, links in enumerate(around):
        below[facet] += [link for link in links if above[link.facet] == link]
    for edge, tail, head, left, right in shared_edges(pattern):
        if edge not in used and edge not in apart and pattern.edges_assignment[edge] != "F":
            below[left].append(FacetLink(facet=right, parent=left, edge=edge, tail=tail, head=head, closes=True))
    listed, waiting = list[FacetLink](), [above[start] for start in reversed(starts)]
    while waiting:
        link = waiting.pop()
        listed.append(link)
        if not link.closes:
            waiting += reversed(below[link.facet])
    return tuple(listed)


def _rooted(
    pattern: CreasePattern, roots: Sequence[int], apart: Collection[int]
) -> tuple[dict[int, FacetLink], list[int], list[list[FacetLink]]]:
    """Return the link of every facet to its parent, the roots, and the neighbours of each facet."""
    count = len(pattern.faces_vertices)
    for facet in roots:
        if not 0 <= facet < count:
            raise InputError(f"need a facet from 0 to {count - 1}, got {facet}")
    around = _neighbours(pattern, apart)
    above: dict[int, FacetLink] = {}
    starts: list[int] = []
    for facet in [*roots, *range(count)]:
        if facet in above and facet in roots and facet not in starts:
            raise InputError(f"facet {facet} is connected to another facet that is held: need one of them")
        if facet in above:
            continue
        if starts and facet not in roots and not apart:
            raise InputError(f"facet {facet} is not connected to facet {starts[0]}: need creases that join all facets")
        above |= _parents(pattern, around, facet)
        starts.append(facet)
    return above, starts, around


def edges_between(links: Sequence[FacetLink], one: int, other: int) -> tuple[int, ...]:
    """Return the numbers of the edges on the path along a tree from one facet to another, in order."""
    above = {link.facet: link for link in links if not link.closes}

    def path(facet: int) -> list[int]:
        """Return the edges from a facet to the root."""
        edges, link = [], above[facet]
        while link.parent is not None and link.edge is not None:
            edges.append(link.edge)
            link = above[link.parent]
        return edges

    up, down = path(one), path(other)
    return (*(edge for edge in up if edge not in down), *(edge for edge in reversed(down) if edge not in up))


def central_facet(pattern: CreasePattern) -> int:
    """Return the facet with the smallest number of edges to the furthest facet; the first one if there are several.

    Raises:
        InputError: faces that are not counterclockwise.
    """
    pairs = np.array([(edge.left, edge.right) for edge in shared_edges(pattern)], dtype=np.int64).reshape(-1, 2).T
    count = len(pattern.faces_vertices)
    graph = coo_array((np.ones(pairs.shape[1]), (pairs[0], pairs[1])), shape=(count, count)).tocsr()
    return int(np.argmin(shortest_path(graph, directed=False, unweighted=True).max(axis=1)))


def _neighbours(pattern: CreasePattern, apart: Collection[int]) -> list[list[FacetLink]]:
    """Return the neighbours of every facet, in the order of the edges between them."""
    around: list[list[FacetLink]] = [[] for _ in pattern.faces_vertices]
    for edge, tail, head, left, right in shared_edges(pattern):
        if (letter := pattern.edges_assignment[edge]) == "B":
            raise InputError(
                f'edge {edge} lies between facets {left} and {right}: need "M" (mountain), "V" (valley),'
                f' "U" (unassigned), "F" (flat) or "C" (cut), got "{letter}"'
            )
        if edge in apart:
            continue
        around[left].append(FacetLink(facet=right, parent=left, edge=edge, tail=tail, head=head))
        around[right].append(FacetLink(facet=left, parent=right, edge=edge, tail=head, head=tail))
    return around


def _parents(pattern: CreasePattern, around: Sequence[Sequence[FacetLink]], root: int) -> dict[int, FacetLink]:
    """Return the link of every reachable facet to its parent, breadth first; flat edges count as no distance."""
    above: dict[int, FacetLink] = {}
    waiting = deque([FacetLink(facet=root)])
    while waiting:
        link = waiting.popleft()
        if link.facet in above:
            continue
        above[link.facet] = link
        flat = [child for child in around[link.facet] if pattern.edges_assignment[child.edge or 0] == "F"]
        waiting.extendleft(reversed(flat))
        waiting += [child for child in around[link.facet] if child not in flat]
    return above


def _check_plates(pattern: CreasePattern, above: dict[int, FacetLink], apart: Collection[int]) -> None:
    """Refuse a crease between two facets that flat edges join to one plate."""
    plate: dict[int, int] = {}
    for facet, link in above.items():
        flat = link.edge is not None and pattern.edges_assignment[link.edge] == "F"
        plate[facet] = plate[link.parent] if flat and link.parent is not None else facet
    for edge, _, _, left, right in shared_edges(pattern):
        if pattern.edges_assignment[edge] != "F" and edge not in apart and plate[left] == plate[right]:
            raise InputError(
                f"edge {edge} lies between facets {left} and {right}, which flat edges join to one plate: need"
                ' "F" (flat) for this edge, too, or a fold that separates the facets'
            )
