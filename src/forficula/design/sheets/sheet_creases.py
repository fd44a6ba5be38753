"""Creases of a sheet and groups of creases, by their names in a design file."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from functools import lru_cache

from forficula.design.sheets.crease_sections import CreaseGroup
from forficula.errors import InputError
from forficula.names import listed, near_name
from forficula.pattern import CreasePattern, edges_between, facet_tree
from forficula.pattern.shared_edges import shared_edges
from forficula.quantities import as_written

_CREASE = re.compile(r"crease (\d{1,9})")
_FOLDS = {"mountains": "M", "valleys": "V", "unassigned": "U"}


def creases_of(pattern: CreasePattern, text: str, groups: Sequence[CreaseGroup] = ()) -> tuple[int, ...]:
    """Return the numbers of the edges of a group of creases, in ascending order.

    "creases" are all creases; "mountains", "valleys" and "unassigned" those of that sense; "crease 2" is edge number 2,
    with the second one of two parallel folds that replace a fold.
    A role, or the name of a group, means all creases with it. "role:ring" and "assignment:M" select by role or by
    letter. Several terms joined by "and" select the creases that match all of them.

    Args:
        pattern: crease pattern of the sheet.
        text: text of a design file.
        groups: groups of creases, which the text may name.

    Raises:
        InputError: there are no such creases.
    """
    return _named_creases(pattern, text, tuple(groups))


@lru_cache(maxsize=1024)  # checks, structures and tables of designs with the same sheet need the same creases
def _named_creases(pattern: CreasePattern, text: str, groups: tuple[CreaseGroup, ...]) -> tuple[int, ...]:
    named = crease_groups(pattern, groups)
    terms = [" ".join(term.split()) for term in text.split(" and ")]
    matches = [_of_a_term(pattern, term, named, text) for term in terms]
    edges = set(matches[0]).intersection(*matches[1:])
    if not edges:
        counts = listed(f"{len(match)} {as_written(term)}" for term, match in zip(terms, matches, strict=True))
        raise InputError(f"need creases that are all of these at once, got none of {counts}")
    return tuple(sorted(edges))


def crease_groups(pattern: CreasePattern, groups: Sequence[CreaseGroup] = ()) -> dict[str, tuple[int, ...]]:
    """Return the named groups of creases with the numbers of their edges; a group may name groups before it.

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
    """Return the role of a crease; "crease" if the pattern gives none."""
    return pattern.edges_role[edge] or "crease"


def crease_sense(pattern: CreasePattern, edge: int) -> int:
    """Return +1 for a valley and -1 for a mountain; for an unassigned crease, the sign of its target angle."""
    letter = pattern.edges_assignment[edge]
    return -1 if letter == "M" or (letter == "U" and pattern.edges_fold_angle[edge] < 0) else 1


@lru_cache(maxsize=64)
def fold_edges(pattern: CreasePattern) -> tuple[int, ...]:
    """Return the numbers of the edges at which a sheet folds, ascending: M, V and U edges between two facets."""
    return tuple(
        sorted(shared.edge for shared in shared_edges(pattern) if pattern.edges_assignment[shared.edge] in "MVU")
    )


def creases_between(pattern: CreasePattern, one: int, other: int) -> tuple[int, ...]:
    """Return the numbers of the creases on the path from one facet to another of a sheet of plates, in order.

    Raises:
        InputError: the facets do not form a tree.
    """
    path = edges_between(facet_tree(pattern), one, other)
    return tuple(edge for edge in path if pattern.edges_assignment[edge] in "MVU")


def _of_a_term(pattern: CreasePattern, term: str, named: Mapping[str, tuple[int, ...]], text: str) -> tuple[int, ...]:
    """Return the creases that one term of a text selects."""
    creases = named.get("creases", ())
    if match := _CREASE.fullmatch(term):
        edge = int(match[1])
        if edge not in creases:
            shown = [f'"crease {crease}"' for crease in creases]
            shown = [*shown[:11], "...", shown[-1]] if len(shown) > 12 else shown
            raise InputError(f"need {listed(shown, 'or')}, got {as_written(text)}")
        return tuple(crease for crease in creases if pattern.edges_fold[crease] == pattern.edges_fold[edge])
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
