"""Faces that go round alike: all of them counterclockwise seen from one side of the sheet."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Sequence

from forficula.errors import InputError
from forficula.pattern.crease_pattern import face_sides


def turned_alike(faces: Sequence[Sequence[int]]) -> tuple[list[list[int]], list[int]]:
    """Turn faces round so that two that share an edge go along it either way, as few of each piece as that takes.

    Of a piece of which half would do, those unlike its first face are turned.

    Args:
        faces: the vertices of each, one after another.

    Returns:
        The faces, and the numbers of those that were turned.

    Raises:
        InputError: faces that no turning makes alike: the sheet has one side only.
    """
    neighbours = _neighbours(faces)
    sense: dict[int, bool] = {}
    turned: list[int] = []
    for first in range(len(faces)):
        if first in sense:
            continue
        sense[first], piece = True, [first]
        for face in piece:
            for other, alike in neighbours[face]:
                if other not in sense:
                    sense[other] = sense[face] == alike
                    piece.append(other)
                elif sense[other] != (sense[face] == alike):
                    raise InputError(
                        f"faces_vertices[{other}]: need a sheet of two sides, got one of one side only, as a Moebius"
                        f" strip is: it cannot go round like face {face}"
                    )
        unlike = [face for face in piece if not sense[face]]
        turned += unlike if 2 * len(unlike) <= len(piece) else [face for face in piece if sense[face]]
    over = set(turned)
    return [[*face[::-1]] if number in over else [*face] for number, face in enumerate(faces)], sorted(turned)


def _neighbours(faces: Sequence[Sequence[int]]) -> dict[int, list[tuple[int, bool]]]:
    """Of each face those that share an edge of two faces with it, and whether the two go along it either way."""
    at = defaultdict[frozenset[int], list[tuple[int, tuple[int, int]]]](list)
    for number, face in enumerate(faces):
        for side in face_sides(face):
            at[frozenset(side)].append((number, side))
    found = defaultdict[int, list[tuple[int, bool]]](list)
    for pair in at.values():
        if len(pair) == 2:
            (one, side), (other, opposite) = pair
            found[one].append((other, side != opposite))
            found[other].append((one, side != opposite))
    return found
