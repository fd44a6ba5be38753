"""Creases of a sheet of plates, and groups of them, as a design file writes them."""

from __future__ import annotations

import re

from forficula.errors import InputError
from forficula.names import listed, near_name
from forficula.pattern import CreasePattern, edges_between, facet_tree
from forficula.quantities import as_written

_CREASE = re.compile(r"crease (\d{1,9})")


def creases_of(pattern: CreasePattern, text: str) -> tuple[int, ...]:
    """Numbers of the edges of a group of creases, rising.

    "creases" are all, "mountains" and "valleys" those of that sense, "crease 2" is edge number 2, and a role stands for
    all creases of that role.

    Raises:
        InputError: there are no such creases.
    """
    creases, written = fold_edges(pattern), " ".join(text.split())
    if found := _CREASE.fullmatch(written):
        edge = int(found[1])
        if edge not in creases:
            named = [f'"crease {each}"' for each in creases]
            shown = [*named[:11], "...", named[-1]] if len(named) > 12 else named
            raise InputError(f"need {listed(shown, 'or')}, got {as_written(text)}")
        return (edge,)
    groups = crease_groups(pattern)
    if written not in groups:
        known = ", ".join(f'"{name}"' for name in groups)
        example = f' or one such as "crease {creases[0]}"' if creases else ""
        raise InputError(f"need {known}{example}, got {as_written(text)}{near_name(written, groups)}")
    return groups[written]


def crease_groups(pattern: CreasePattern) -> dict[str, tuple[int, ...]]:
    """The groups of creases that have a name, each with the numbers of its edges."""
    creases = fold_edges(pattern)
    groups = {"creases": creases}
    for name, letter in (("mountains", "M"), ("valleys", "V")):
        groups[name] = tuple(edge for edge in creases if pattern.edges_assignment[edge] == letter)
    for role in dict.fromkeys(crease_role(pattern, edge) for edge in creases):
        groups.setdefault(role, tuple(edge for edge in creases if crease_role(pattern, edge) == role))
    return {name: edges for name, edges in groups.items() if edges}


def crease_role(pattern: CreasePattern, edge: int) -> str:
    """What a crease is called with others of its kind: "crease" where the pattern does not say."""
    return pattern.edges_role[edge] or "crease"


def fold_edges(pattern: CreasePattern) -> tuple[int, ...]:
    """Numbers of the edges at which a sheet of plates folds: mountains and valleys between two facets, rising.

    Raises:
        InputError: its facets form no tree.
    """
    edges = (link.edge for link in facet_tree(pattern))
    return tuple(sorted(edge for edge in edges if edge is not None and pattern.edges_assignment[edge] in "MV"))


def creases_between(pattern: CreasePattern, one: int, other: int) -> tuple[int, ...]:
    """Numbers of the edges at which a sheet of plates folds on the way from one facet to another, in their order.

    Raises:
        InputError: its facets form no tree.
    """
    way = edges_between(facet_tree(pattern), one, other)
    return tuple(edge for edge in way if pattern.edges_assignment[edge] in "MV")
