"""Facets of a sheet as a tree: each hangs on another by one crease, and no creases close a loop."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from forficula.errors import InputError
from forficula.pattern.crease_pattern import CreasePattern, interior_vertices
from forficula.pattern.shared_edges import SharedEdge, shared_edges


@dataclass(frozen=True, kw_only=True)
class FacetLink:
    """A facet and what it hangs on.

    Attributes:
        facet: its number.
        parent: number of the facet that it hangs on; None of the first.
        edge: number of the edge between the two; None of the first.
        tail: vertex from which that edge runs with its parent on the left, seen from +z.
        head: vertex to which it runs.
    """

    facet: int
    parent: int | None = None
    edge: int | None = None
    tail: int = -1
    head: int = -1


def facet_tree(pattern: CreasePattern, root: int = 0) -> tuple[FacetLink, ...]:
    """Hang all facets of a sheet on one of them.

    Facets hang together along mountains, valleys and flat edges, not along cuts. Flat edges may close loops, for
    nothing moves at them; creases may not, for plates that are hinged in a loop move together.

    Args:
        pattern: with faces counterclockwise.
        root: the facet that the others hang on.

    Returns:
        The facets depth first: each follows its parent, and all that hangs on it follows before anything else.

    Raises:
        InputError: no such facet, a crease without a sense, creases that close a loop, facets that hang on nothing, or
            faces that are not counterclockwise.
    """
    count = len(pattern.faces_vertices)
    if not 0 <= root < count:
        raise InputError(f"need a facet from 0 to {count - 1}, got {root}")
    around = _neighbours(pattern)
    links = [FacetLink(facet=root)]
    seen, waiting = {root}, [iter(around[root])]
    while waiting:
        link = next(waiting[-1], None)
        if link is None:
            waiting.pop()
        elif link.facet not in seen:
            seen.add(link.facet)
            links.append(link)
            waiting.append(iter(around[link.facet]))
    if len(links) < count:
        lost = min(set(range(count)) - seen)
        raise InputError(f"facet {lost} does not hang together with facet {root}: need creases that join all facets")
    return tuple(links)


def edges_between(links: Sequence[FacetLink], one: int, other: int) -> tuple[int, ...]:
    """Numbers of the edges on the way along a tree from one facet to another, in their order."""
    above = {link.facet: link for link in links}

    def way(facet: int) -> list[int]:
        """The edges from a facet up to the first."""
        edges, link = [], above[facet]
        while link.parent is not None and link.edge is not None:
            edges.append(link.edge)
            link = above[link.parent]
        return edges

    up, down = way(one), way(other)
    return (*(edge for edge in up if edge not in down), *(edge for edge in reversed(down) if edge not in up))


def _neighbours(pattern: CreasePattern) -> list[list[FacetLink]]:
    """The neighbours of every facet, in the order of the edges between them."""
    shared = shared_edges(pattern)
    for edge, _, _, left, right in shared:
        if (letter := pattern.edges_assignment[edge]) in "BU":
            raise InputError(
                f'edge {edge} lies between facets {left} and {right}: need "M" (mountain), "V" (valley), "F" (flat) or'
                f' "C" (cut), got "{letter}"'
            )
    _check_loops(pattern, shared)
    around: list[list[FacetLink]] = [[] for _ in pattern.faces_vertices]
    for edge, tail, head, left, right in shared:
        around[left].append(FacetLink(facet=right, parent=left, edge=edge, tail=tail, head=head))
        around[right].append(FacetLink(facet=left, parent=right, edge=edge, tail=head, head=tail))
    return around


def _check_loops(pattern: CreasePattern, shared: list[SharedEdge]) -> None:
    """Refuse creases that close a loop, those at flat edges first, which make one plate of many facets."""
    group = list(range(len(pattern.faces_vertices)))

    def first(facet: int) -> int:
        while group[facet] != facet:
            group[facet] = group[group[facet]]
            facet = group[facet]
        return facet

    letters = pattern.edges_assignment
    for edge, tail, head, left, right in sorted(shared, key=lambda each: letters[each.edge] != "F"):
        one, other = first(left), first(right)
        if one == other and letters[edge] != "F":
            inside = sorted({tail, head} & set(interior_vertices(pattern).tolist()))
            where = f"vertex {inside[0]}, which lies inside the sheet" if inside else "a hole of the sheet"
            raise InputError(
                f"edge {edge} closes a loop of facets around {where}: need creases that join the facets as a tree"
            )
        group[one] = other
