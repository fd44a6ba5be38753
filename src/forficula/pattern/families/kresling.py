"""Kresling's pattern: towers of twisted prisms, and the lengths that make them snap."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from forficula.arrays import Array
from forficula.errors import InputError
from forficula.pattern.crease_pattern import CreasePattern
from forficula.pattern.dimensions import check_count, check_lengths
from forficula.pattern.facet_sheet import Creases, sheet_of_facets
from forficula.pattern.fold_angles import kept_as_built


class KreslingLengths(NamedTuple):
    """How long the creases between two polygons are.

    Attributes:
        mountain: of the mountain creases, m.
        valley: of the valley creases, m.
    """

    mountain: Array
    valley: Array


class KreslingState(NamedTuple):
    """How two polygons stand to one another.

    Attributes:
        height: of the upper one above the lower one, m.
        twist: by which it is turned, rad.
    """

    height: float
    twist: float


def kresling_pattern(
    sides: int,
    layers: int,
    radius: float,
    height: float,
    twist: float,
    alternating: bool = False,
    end_plates: bool = False,
) -> CreasePattern:
    """Draw a Kresling tower around the z axis, as it stands.

    Regular polygons lie one above another, each turned by the twist against the one below. From a corner a mountain
    crease leads to the same corner of the next polygon and a valley crease to the one after it in the sense of the
    twist, which leaves triangles (Kresling 2008, Proc. IASS-IACM; Cai and others 2015, doi 10.1115/1.4030158).

    Vertices: polygon by polygon, from the bottom, counterclockwise seen from above, the first at the azimuth 0. Facets:
    layer by layer, two for every side, the one that stands on the lower polygon first; then the end plates, the lower
    one first. Roles: "mountain", "valley", and "polygon" for sides of polygons between two facets.

    Args:
        sides: of every polygon.
        layers: one above another.
        radius: of the circle through the corners, m.
        height: of a layer, m.
        twist: of every layer, rad; positive turns counterclockwise, seen from above, on the way up.
        alternating: whether every second layer is twisted the other way.
        end_plates: whether polygons close the tower below and above.

    Returns:
        The pattern, its facets counterclockwise seen from outside, with its fold angles as built: it is folded from no
        flat sheet. Where else its creases let it stand, `kresling_other_state` says. Polygon creases have the letter of
        how they are built.

    Raises:
        InputError: a number that is no whole one, or below 3 sides or 1 layer; a length that is not > 0; a twist that
            is 0, or so large that the valley creases pass one another on the axis, at 180 deg - 360 deg / sides.
    """
    _check_tower(sides, radius, height, twist)
    check_count("layers", layers, 1)
    senses = [(-1 if alternating and layer % 2 else 1) * (1 if twist > 0 else -1) for layer in range(layers)]
    turned = np.concatenate([[0], np.cumsum(senses)]) * abs(twist)
    azimuths = (turned[:, None] + 2 * math.pi * np.arange(sides) / sides).ravel()
    level = np.repeat(np.arange(layers + 1) * height, sides)
    coords = np.column_stack([radius * np.cos(azimuths), radius * np.sin(azimuths), level])
    faces: list[tuple[int, ...]] = []
    creases: Creases = {}
    for layer, sense in enumerate(senses):
        low, high = ([(layer + up) * sides + k % sides for k in range(sides + 1)] for up in (0, 1))
        for k in range(sides):
            for ring in (low, high):
                creases[frozenset((ring[k], ring[k + 1]))] = ("U", "polygon")
            creases[frozenset((low[k], high[k]))] = ("M", "mountain")
            if sense > 0:
                creases[frozenset((low[k], high[k + 1]))] = ("V", "valley")
                faces += [(low[k], low[k + 1], high[k + 1]), (low[k], high[k + 1], high[k])]
            else:
                creases[frozenset((low[k + 1], high[k]))] = ("V", "valley")
                faces += [(low[k], low[k + 1], high[k]), (low[k + 1], high[k + 1], high[k])]
    if end_plates:
        faces += [tuple(reversed(range(sides))), tuple(range(layers * sides, (layers + 1) * sides))]
    title = f"Kresling tower, {sides} sides, {layers} layer{'s' if layers > 1 else ''}"
    return kept_as_built(sheet_of_facets(coords, faces, creases, title))


def kresling_lengths(sides: int, radius: float, height: ArrayLike, twist: ArrayLike) -> KreslingLengths:
    """Measure the creases between two polygons, wherever they stand: all that the energy of a Kresling truss needs.

    Mountain creases are the chord of the twist high, valley creases that of the twist and one side more:
    mountain^2 = height^2 + 4 radius^2 sin^2(twist / 2),
    valley^2 = height^2 + 4 radius^2 sin^2(twist / 2 + 180 deg / sides)
    (Cai and others 2015, doi 10.1115/1.4030158; Liu and Paulino 2017, doi 10.1098/rspa.2017.0348). With bars of the
    axial stiffness EA that are unstressed at lengths b and c, the energy of a layer is
    sides EA / 2 ((mountain - b)^2 / b + (valley - c)^2 / c).

    Args:
        sides: of the polygons.
        radius: of the circles through their corners, m.
        height: of one above the other, m, any shape.
        twist: by which it is turned, in the sense in which the tower is twisted, rad, any shape that fits.

    Returns:
        m, in the shape of both.

    Raises:
        InputError: a number that is no whole one, below 3 sides; a radius that is not > 0.
    """
    check_count("sides", sides, 3)
    check_lengths({"radius": radius})
    half = np.asarray(twist, dtype=np.float64) / 2
    mountain, valley = (
        np.hypot(height, 2 * radius * np.sin(half + more * math.pi / sides)).astype(np.float64) for more in (0, 1)
    )
    return KreslingLengths(mountain, valley)


def kresling_other_state(sides: int, radius: float, height: float, twist: float) -> KreslingState:
    """Find where else a layer can stand with all its creases as long as they are.

    The difference of the squares of the lengths, 4 radius^2 sin(180 deg / sides) sin(twist + 180 deg / sides), fixes
    the sine, and the sine two twists: the other one is 180 deg - 360 deg / sides less the given one. The length of the
    mountain creases then fixes the height.

    Args:
        sides: of the polygons.
        radius: of the circles through their corners, m.
        height: of the layer, m.
        twist: of the layer, rad.

    Returns:
        The other state, twisted in the same sense. At the twist of 90 deg - 180 deg / sides both are one.

    Raises:
        InputError: as `kresling_pattern`; or creases too short for another state.
    """
    _check_tower(sides, radius, height, twist)
    other = math.pi - 2 * math.pi / sides - abs(twist)
    least = 4 * radius**2 * (math.sin(other / 2) ** 2 - math.sin(abs(twist) / 2) ** 2)
    if not height**2 >= least:
        lowest, got = (f"{100 * each:.6g} cm" for each in (math.sqrt(least), height))
        raise InputError(f"pattern.height: need at least {lowest} for a second state, got {got}")
    return KreslingState(math.sqrt(height**2 - least), math.copysign(other, twist))


def _check_tower(sides: int, radius: float, height: float, twist: float) -> None:
    """Refuse what gives no twisted prism."""
    check_count("sides", sides, 3)
    check_lengths({"radius": radius, "height": height})
    most = math.pi - 2 * math.pi / sides
    if not 0 < abs(twist) < most:
        bound = f"{math.degrees(most):.6g} deg"
        raise InputError(
            f"pattern.twist: need > 0 deg and < {bound}, 180 deg - 360 deg / sides, or the same with a minus, got"
            f" {math.degrees(twist):.6g} deg"
        )
