"""Creases of a sheet, and groups of them, as a design file writes them."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from functools import lru_cache

from forficula.design.sheets.sheet_parts import CreaseGroup
from forficula.errors import InputError
from forficula.names import listed, near_name
from forficula.pattern import CreasePattern, edges_between, facet_tree
from forficula.pattern.shared_edges import shared_edges
from forficula.quantities import as_written

_CREASE = re.compile(r"crease (\d{1,9})")
_FOLDS = {"mountains": "M", "valleys": "V", "unassigned": "U"}


def creases_of(pattern: CreasePattern, text: str, groups: Sequence[CreaseGroup] = ()) -> tuple[int, ...]:
    """Numbers of the edges of a group of creases, rising.

    "creases" are all, "mountains", "valleys" and "unassigned" those of that sense, "crease 2" is edge number 2, and a
    role or the name of a group stands for all creases of it. "role:ring" and "assignment:M" say what the word is, and
    of several joined by "and" those creases count that all of them name.

    Args:
        pattern: of the sheet.
        text: as a design file has it.
        groups: those with a name may be named.

    Raises:
        InputError: there are no such creases.
    """
    return _named_creases(pattern, text, tuple(groups))


@lru_cache(maxsize=1024)  # checks, structures and tables of designs on one sheet ask for the same
def _named_creases(pattern: CreasePattern, text: str, groups: tuple[CreaseGroup, ...]) -> tuple[int, ...]:
    named = crease_groups(pattern, groups)
    terms = [" ".join(term.split()) for term in text.split(" and ")]
    found = [_of_a_term(pattern, term, named, text) for term in terms]
    edges = set(found[0]).intersection(*found[1:])
    if not edges:
        each = listed(f"{len(one)} {as_written(term)}" for term, one in zip(terms, found, strict=True))
        raise InputError(f"need creases that are all of these at once, got none of {each}")
    return tuple(sorted(edges))


def crease_groups(pattern: CreasePattern, groups: Sequence[CreaseGroup] = ()) -> dict[str, tuple[int, ...]]:
    """The groups of creases that have a name, each with the numbers of its edges; a group may name those before it.

    Raises:
        InputError: a group of no creases.
    """
    creases = fold_edges(pattern)
    named = {"creases": creases}
    for name, letter in _FOLDS.items():
        named[name] = tuple(edge for edge in creases if pattern.edges_assignment[edge] == letter)
    for role in dict.fromkeys(crease_role(pattern, edge) for edge in creases):
        named.setdefault(role, tuple(edge for edge in creases if crease_role(pattern, edge) == role))
    named = {name: edges for name, edges in named.items() if edges}
    for number, group in enumerate(groups):
        if group.name is not None:
            named[group.name] = creases_of(pattern, group.of, groups[:number])
    return named


def crease_role(pattern: CreasePattern, edge: int) -> str:
    """What a crease is called with others of its kind: "crease" where the pattern does not say."""
    return pattern.edges_role[edge] or "crease"


def crease_sense(pattern: CreasePattern, edge: int) -> int:
    """+1 where a crease folds as a valley, -1 as a mountain; one that is not assigned, the way that its angle has."""
    letter = pattern.edges_assignment[edge]
    return -1 if letter == "M" or (letter == "U" and pattern.edges_fold_angle[edge] < 0) else 1


@lru_cache(maxsize=64)
def fold_edges(pattern: CreasePattern) -> tuple[int, ...]:
    """Numbers of the edges at which a sheet folds, rising: mountains, valleys, unassigned ones between two facets."""
    return tuple(sorted(each.edge for each in shared_edges(pattern) if pattern.edges_assignment[each.edge] in "MVU"))


def creases_between(pattern: CreasePattern, one: int, other: int) -> tuple[int, ...]:
    """Numbers of the edges at which a sheet of plates folds on the way from one facet to another, in their order.

    Raises:
        InputError: its facets form no tree.
    """
    way = edges_between(facet_tree(pattern), one, other)
    return tuple(edge for edge in way if pattern.edges_assignment[edge] in "MVU")


def _of_a_term(pattern: CreasePattern, term: str, named: Mapping[str, tuple[int, ...]], text: str) -> tuple[int, ...]:
    """The creases of one word of a text."""
    creases = named.get("creases", ())
    if found := _CREASE.fullmatch(term):
        edge = int(found[1])
        if edge not in creases:
            shown = [f'"crease {each}"' for each in creases]
            shown = [*shown[:11], "...", shown[-1]] if len(shown) > 12 else shown
            raise InputError(f"need {listed(shown, 'or')}, got {as_written(text)}")
        return (edge,)
    kind, colon, value = term.partition(":")
    if colon:
        kinds = {"role": pattern.edges_role, "assignment": pattern.edges_assignment}
        if kind not in kinds:
            raise InputError(f"need role: or assignment: before a word, got {as_written(text)}{near_name(kind, kinds)}")
        edges = tuple(edge for edge in creases if kinds[kind][edge] == value)
        if not edges:
            words = list(dict.fromkeys(f"{kind}:{kinds[kind][edge]}" for edge in creases if kinds[kind][edge]))
            known = listed((f'"{word}"' for word in words), "or") or f"a sheet whose creases have a {kind}"
            raise InputError(f"need {known}, got {as_written(text)}{near_name(term, words)}")
        return edges
    if term not in named:
        known = ", ".join(f'"{name}"' for name in named)
        example = f' or one such as "crease {creases[0]}"' if creases else ""
        raise InputError(f"need {known}{example}, got {as_written(text)}{near_name(term, named)}")
    return named[term]
