"""Facets of a sheet as a tree: each hangs on another by one crease; creases beyond those close loops."""

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
    """A facet and what it hangs on.

    Attributes:
        facet: its number.
        parent: number of the facet that it hangs on; None of the first.
        edge: number of the edge between the two; None of the first.
        tail: vertex from which that edge runs with its parent on the left, seen from +z.
        head: vertex to which it runs.
        closes: whether the crease closes a loop: the facet hangs on another one, too.
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
    """Hang all facets of a sheet on one of them, by as few creases as can be.

    Facets hang together along mountains, valleys, unassigned and flat edges, not along cuts. Nothing moves at a flat
    edge: facets along these hang on each other first. Every crease that the tree leaves out closes a loop.

    Args:
        pattern: with faces counterclockwise.
        root: the facet that the others hang on, or several that do not hang together.
        apart: numbers of edges at which facets do not hang together, like cuts; what hangs on no root then hangs on the
            first of it.

    Returns:
        The facets depth first: each follows its parent, and all that hangs on it follows before anything else, the
        creases that close loops on its right last.

    Raises:
        InputError: no such facet, roots that hang together, an edge between facets that says nothing of them, a crease
            within what flat edges make one plate, facets that hang on nothing, or faces that are not counterclockwise.
    """
    return _hung(pattern, (root,) if isinstance(root, int) else tuple(root), frozenset(apart))


@lru_cache(maxsize=64)  # a pattern is frozen, and each of the values that a design may change is checked with the same
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
    """What every facet hangs on, the facets that hang on nothing, and the neighbours of each."""
    count = len(pattern.faces_vertices)
    for facet in roots:
        if not 0 <= facet < count:
            raise InputError(f"need a facet from 0 to {count - 1}, got {facet}")
    around = _neighbours(pattern, apart)
    above: dict[int, FacetLink] = {}
    starts: list[int] = []
    for facet in [*roots, *range(count)]:
        if facet in above and facet in roots and facet not in starts:
            raise InputError(f"facet {facet} hangs together with another that is held: need one of them")
        if facet in above:
            continue
        if starts and facet not in roots and not apart:
            raise InputError(
                f"facet {facet} does not hang together with facet {starts[0]}: need creases that join all facets"
            )
        above |= _parents(pattern, around, facet)
        starts.append(facet)
    return above, starts, around


def edges_between(links: Sequence[FacetLink], one: int, other: int) -> tuple[int, ...]:
    """Numbers of the edges on the way along a tree from one facet to another, in their order."""
    above = {link.facet: link for link in links if not link.closes}

    def way(facet: int) -> list[int]:
        """The edges from a facet up to the first."""
        edges, link = [], above[facet]
        while link.parent is not None and link.edge is not None:
            edges.append(link.edge)
            link = above[link.parent]
        return edges

    up, down = way(one), way(other)
    return (*(edge for edge in up if edge not in down), *(edge for edge in reversed(down) if edge not in up))


def central_facet(pattern: CreasePattern) -> int:
    """The facet from which the furthest one is the fewest edges away; the first of several.

    Raises:
        InputError: faces that are not counterclockwise.
    """
    pairs = np.array([(each.left, each.right) for each in shared_edges(pattern)], dtype=np.int64).reshape(-1, 2).T
    count = len(pattern.faces_vertices)
    graph = coo_array((np.ones(pairs.shape[1]), (pairs[0], pairs[1])), shape=(count, count)).tocsr()
    return int(np.argmin(shortest_path(graph, directed=False, unweighted=True).max(axis=1)))


def _neighbours(pattern: CreasePattern, apart: Collection[int]) -> list[list[FacetLink]]:
    """The neighbours of every facet, in the order of the edges between them."""
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
    """What every facet that can be reached hangs on, breadth first; along flat edges at once."""
    above: dict[int, FacetLink] = {}
    waiting = deque([FacetLink(facet=root)])
    while waiting:
        link = waiting.popleft()
        if link.facet in above:
            continue
        above[link.facet] = link
        flat = [each for each in around[link.facet] if pattern.edges_assignment[each.edge or 0] == "F"]
        waiting.extendleft(reversed(flat))
        waiting += [each for each in around[link.facet] if each not in flat]
    return above


def _check_plates(pattern: CreasePattern, above: dict[int, FacetLink], apart: Collection[int]) -> None:
    """Refuse a crease between two facets of one plate, which flat edges make of them."""
    plate: dict[int, int] = {}
    for facet, link in above.items():
        flat = link.edge is not None and pattern.edges_assignment[link.edge] == "F"
        plate[facet] = plate[link.parent] if flat and link.parent is not None else facet
    for edge, _, _, left, right in shared_edges(pattern):
        if pattern.edges_assignment[edge] != "F" and edge not in apart and plate[left] == plate[right]:
            raise InputError(
                f"edge {edge} lies between facets {left} and {right}, which flat edges make one plate: need"
                ' "F" (flat) there, too, or a fold that parts the two'
            )
