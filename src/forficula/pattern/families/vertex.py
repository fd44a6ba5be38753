"""One vertex with any sectors around it: flat, a cone, a saddle, or four folded facets."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NoReturn

import numpy as np
import scipy

from forficula.arrays import Array
from forficula.errors import InputError
from forficula.pattern.crease_pattern import CreasePattern
from forficula.pattern.dimensions import check_angle, check_lengths
from forficula.pattern.facet_sheet import Creases, sheet_of_facets
from forficula.pattern.fold_angles import with_built_fold_angles

_LETTERS = "MVFU"
_ROUNDING = 1e-9  # rad; sectors whose sum differs from 360 deg by no more are flat


def vertex_pattern(
    sectors: Sequence[float], lengths: float | Sequence[float], assignment: str = "", fold: float | None = None
) -> CreasePattern:
    """Draw one vertex with triangles around it, with any sum of sectors.

    With a sum of 360 deg the vertex is flat. With a smaller sum it is a cone: all creases have the same inclination
    below the plane of the vertex, or above it if there are more valleys than mountains. With a larger sum it is a
    saddle: creases are alternately above and below the plane by the same inclination, the first one above, or below if
    it is a valley; with an odd number of creases the last one lies in the plane. The azimuth between two creases with
    the inclinations e and f and the sector s between them follows from the law of cosines on the sphere,
    sin^2(azimuth / 2) = (sin^2(s / 2) - sin^2((e - f) / 2)) / (cos e cos f), and all azimuths add up to 360 deg.

    Instead, a vertex of four creases can be folded by `fold` at the first crease. This determines the second and the
    fourth crease; the third has two possible positions (a spherical four-bar linkage; Huffman 1976), between which its
    letter decides.

    Vertices: the vertex, at the origin, then the ends of the creases, counterclockwise, the first crease on or above
    +x. Facet k lies between creases k and k + 1, and crease k is edge k. Role: "crease".

    Args:
        sectors: angles between neighbouring creases, counterclockwise, three or more, rad.
        lengths: length of the creases, m; one for all, or one per crease.
        assignment: one letter per crease, M, V, F or U; if empty, the fold angles as built decide.
        fold: size of the fold angle of the first crease as built, for four creases that are mountains or valleys, rad;
            with None the vertex is flat, a cone or a saddle.

    Returns:
        The pattern as built. With letters, its fold angles are those of the flat-folded vertex, even if it cannot fold
        flat; without letters, they are as built, and nan where it is flat.

    Raises:
        InputError: there are fewer than three sectors, or one is outside 0 to 180 deg; a length is not > 0; there is
            another letter, or not one letter per crease; the sectors or the fold do not close around the vertex.
    """
    total, crease_lengths = _checked(sectors, lengths, assignment)
    count, flat = len(sectors), abs(total - 2 * math.pi) <= _ROUNDING
    letters = assignment or "U" * count
    if fold is None or (flat and fold == 0):
        directions = _evenly(np.array(sectors), _senses(letters, 0 if flat else total - 2 * math.pi))
    else:
        directions = _folded_four(sectors, letters, fold)
    creases: Creases = {frozenset((0, k + 1)): (letter, "crease") for k, letter in enumerate(letters)}
    drawn = sheet_of_facets(
        np.concatenate([np.zeros((1, 3)), np.array(crease_lengths)[:, None] * directions]),
        [(0, k + 1, (k + 1) % count + 1) for k in range(count)],
        creases,
        f"vertex of {count} creases, sectors of {math.degrees(total):.6g} deg",
    )
    return drawn if assignment or flat else with_built_fold_angles(drawn)


def _checked(
    sectors: Sequence[float], lengths: float | Sequence[float], assignment: str
) -> tuple[float, Sequence[float]]:
    """Check the arguments, and return the sum of the sectors, rad, and a length per crease, m."""
    count = len(sectors)
    if count < 3:
        raise InputError(f"pattern.sectors: need 3 or more, got {count}")
    for number, sector in enumerate(sectors):
        check_angle(f"sectors.{number}", sector, 0, math.pi)
    total = math.fsum(sectors)
    if not 2 * max(sectors) < total:
        largest, others = (f"{math.degrees(angle):.6g} deg" for angle in (max(sectors), total - max(sectors)))
        raise InputError(f"pattern.sectors: need none as large as all others together, {others}, got {largest}")
    crease_lengths = [lengths] * count if isinstance(lengths, int | float) else lengths
    if len(crease_lengths) != count:
        raise InputError(f"pattern.lengths: need one for each of the {count} creases, got {len(crease_lengths)}")
    check_lengths({f"lengths.{crease}": length for crease, length in enumerate(crease_lengths)})
    if assignment and (len(assignment) != count or set(assignment) - set(_LETTERS)):
        raise InputError(
            f'pattern.assignment: need "M", "V", "F" or "U" for each of the {count} creases, got "{assignment}"'
        )
    return total, crease_lengths


def _senses(letters: str, surplus: float) -> Array:
    """Return 1 for creases above the plane of the vertex, -1 for those below; all 0 for a flat vertex."""
    count = len(letters)
    if surplus < 0:
        return np.full(count, 1.0 if letters.count("V") > letters.count("M") else -1.0)
    senses = np.where(np.arange(count) % 2, -1.0, 1.0) * (-1.0 if letters[0] == "V" else 1.0) * (surplus > 0)
    if count % 2:
        senses[-1] = 0.0
    return senses


def _evenly(sectors: Array, senses: Array) -> Array:
    """Return the directions of creases with the same inclination to the plane, shape (creases, 3)."""
    inclined = _inclination(sectors, senses) * senses
    angles, largest = _azimuths(sectors, inclined), int(np.argmax(sectors))
    # the largest sector closes the circle: on a cone it may take more than half a turn
    angles[largest] = 2 * math.pi - (angles.sum() - angles[largest])
    azimuth = np.concatenate([[0.0], np.cumsum(angles[:-1])])
    directions = np.column_stack(
        [np.cos(inclined) * np.cos(azimuth), np.cos(inclined) * np.sin(azimuth), np.sin(inclined)]
    )
    cosines = np.einsum("ij,ij->i", directions, np.roll(directions, -1, axis=0))
    if not np.abs(cosines - np.cos(sectors)).max() < _ROUNDING:
        _refuse_saddle(sectors)
    return directions


def _azimuths(sectors: Array, inclined: Array) -> Array:
    """Return the azimuths between neighbouring creases, by the law of cosines on the sphere, 0 to pi, rad."""
    following = np.roll(inclined, -1)
    square = np.sin(sectors / 2) ** 2 - np.sin((inclined - following) / 2) ** 2
    share = np.clip(square / (np.cos(inclined) * np.cos(following)), 0, 1)
    angles: Array = 2 * np.arcsin(np.sqrt(share))
    return angles


def _inclination(sectors: Array, senses: Array) -> float:
    """Return the inclination of the creases at which the azimuths add up to a whole turn, rad."""
    largest = int(np.argmax(sectors))
    apart = np.abs(senses - np.roll(senses, -1))
    saddle = apart > 0

    def surplus(inclination: float) -> float:
        return float(_azimuths(sectors, inclination * senses).sum()) - 2 * math.pi

    def surplus_of_others(inclination: float) -> float:
        angles = _azimuths(sectors, inclination * senses)
        return float(angles.sum() - 2 * angles[largest])

    if not senses.any():
        return 0.0
    if not saddle.any():
        most = (math.pi - float(sectors[largest])) / 2  # where the largest sector takes half a turn
        return float(scipy.optimize.brentq(surplus if surplus(most) >= 0 else surplus_of_others, 0.0, most, xtol=1e-15))
    most = min(float(np.min(sectors[saddle] / apart[saddle])), math.pi / 2)  # where a facet is vertical
    if surplus(most) > 0:
        _refuse_saddle(sectors)
    return float(scipy.optimize.brentq(surplus, 0.0, most, xtol=1e-15))


def _refuse_saddle(sectors: Array) -> NoReturn:
    """Raise InputError because the creases cannot alternate above and below the plane."""
    listed = ", ".join(f"{angle:.6g}" for angle in np.degrees(sectors).tolist())
    raise InputError(
        f"pattern.sectors: need sectors that close with creases alternately above and below the plane, got {listed} deg"
    )


def _folded_four(sectors: Sequence[float], letters: str, fold: float) -> Array:
    """Return the directions of four creases, the first along +x, the first facet in z = 0, shape (4, 3)."""
    check_angle("fold", fold, 0, math.pi, low_too=True)
    if len(sectors) != 4:
        raise InputError(f"pattern.fold: need four creases to fold by one angle, got {len(sectors)}")
    if letters[0] not in "MV" or letters[2] not in "MV":
        raise InputError(
            f'pattern.assignment: need "M" or "V" at creases 0 and 2 where pattern.fold is given, got "{letters}"'
        )
    first, second, third, fourth = sectors
    rho = fold if letters[0] == "V" else -fold
    one = np.array([math.cos(first), math.sin(first), 0.0])
    other = np.array([math.cos(fourth), -math.sin(fourth) * math.cos(rho), math.sin(fourth) * math.sin(rho)])
    across, middle = one - other, one + other
    sine, cosine = float(np.linalg.norm(across)) / 2, float(np.linalg.norm(middle)) / 2
    if min(sine, cosine) < _ROUNDING:
        raise InputError(
            "pattern.fold: need a fold at which creases 1 and 3 do not lie on one line, got"
            f" {math.degrees(fold):.6g} deg"
        )
    along = math.sin((second + third) / 2) * math.sin((third - second) / 2) / sine
    outwards = math.cos((second + third) / 2) * math.cos((third - second) / 2) / cosine
    left = 1 - along**2 - outwards**2
    if left < -_ROUNDING:
        least, most = (
            math.degrees(math.acos(_clipped(math.cos(first) * math.cos(fourth) - math.cos(apart), first, fourth)))
            for apart in (min(second + third, 2 * math.pi - second - third), abs(second - third))
        )
        raise InputError(
            f"pattern.fold: need {least:.6g} deg to {most:.6g} deg for the facets to meet, got"
            f" {math.degrees(fold):.6g} deg"
        )
    up = math.sqrt(max(left, 0.0)) * (-1 if letters[2] == "V" else 1)
    normal = np.cross(across, middle)
    third_crease = along * across / (2 * sine) + outwards * middle / (2 * cosine) + up * normal / np.linalg.norm(normal)
    return np.array([[1.0, 0, 0], one, third_crease, other])


def _clipped(difference: float, first: float, fourth: float) -> float:
    """Return a cosine from its product with two sines, limited to -1 to 1."""
    return min(max(difference / (math.sin(first) * math.sin(fourth)), -1.0), 1.0)
