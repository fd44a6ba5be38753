"""The Kresling pattern: towers of twisted prisms, their crease lengths and their second stable state."""

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
from forficula.pattern.fold_angles import with_built_fold_angles


class KreslingLengths(NamedTuple):
    """Lengths of the creases between two polygons.

    Attributes:
        mountain: length of the mountain creases, m.
        valley: length of the valley creases, m.
    """

    mountain: Array
    valley: Array


class KreslingState(NamedTuple):
    """Position of the upper polygon of a layer relative to the lower one.

    Attributes:
        height: height of the upper polygon above the lower one, m.
        twist: rotation of the upper polygon against the lower one, rad.
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
    """Draw a Kresling tower around the z axis in its built state.

    Regular polygons lie one above another, each rotated by the twist against the one below. From every corner a
    mountain crease leads to the same corner of the next polygon and a valley crease to the corner after it in the sense
    of the twist, which gives triangles (Kresling 2008, Proc. IASS-IACM; Cai and others 2015, doi 10.1115/1.4030158).

    Vertices: polygon by polygon, from the bottom, counterclockwise seen from above, the first at the azimuth 0. Facets:
    layer by layer, two for every side, the one with its side on the lower polygon first; then the end plates, the lower
    one first. Roles: "mountain", "valley", and "polygon" for sides of polygons between two facets.

    Args:
        sides: number of sides of every polygon.
        layers: number of layers.
        radius: radius of the circle through the corners, m.
        height: height of a layer, m.
        twist: twist of every layer, rad; positive is counterclockwise upwards, seen from above.
        alternating: whether every second layer is twisted in the opposite sense.
        end_plates: whether polygons close the tower at the bottom and at the top.

    Returns:
        The pattern with facets counterclockwise seen from outside and with its fold angles as built; the tower does not
        unfold to a flat sheet. `kresling_other_state` gives its second state. Polygon creases are assigned by their
        fold angles as built.

    Raises:
        InputError: a number is not whole, or below 3 sides or 1 layer; a length is not > 0; the twist is 0, or so large
            that the valley creases meet on the axis, at 180 deg - 360 deg / sides.
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
    return with_built_fold_angles(sheet_of_facets(coords, faces, creases, title))


def kresling_lengths(sides: int, radius: float, height: ArrayLike, twist: ArrayLike) -> KreslingLengths:
    """Compute the lengths of the creases between two polygons, from which the energy of a Kresling truss follows.

    A mountain crease spans the height and the chord of the twist, a valley crease the height and the chord of the twist
    plus one side:
    mountain^2 = height^2 + 4 radius^2 sin^2(twist / 2),
    valley^2 = height^2 + 4 radius^2 sin^2(twist / 2 + 180 deg / sides)
    (Cai and others 2015, doi 10.1115/1.4030158; Liu and Paulino 2017, doi 10.1098/rspa.2017.0348). With bars of the
    axial stiffness EA that are unstressed at lengths b and c, the energy of a layer is
    sides EA / 2 ((mountain - b)^2 / b + (valley - c)^2 / c).

    Args:
        sides: number of sides of the polygons.
        radius: radius of the circles through their corners, m.
        height: height of the upper polygon above the lower one, m, any shape.
        twist: rotation of the upper polygon in the sense of the tower's twist, rad, any shape that fits `height`.

    Returns:
        Lengths, m, in the common shape of `height` and `twist`.

    Raises:
        InputError: the number of sides is not whole or is below 3, or the radius is not > 0.
    """
    check_count("sides", sides, 3)
    check_lengths({"radius": radius})
    half = np.asarray(twist, dtype=np.float64) / 2
    mountain, valley = (
        np.hypot(height, 2 * radius * np.sin(half + more * math.pi / sides)).astype(np.float64) for more in (0, 1)
    )
    return KreslingLengths(mountain, valley)


def kresling_other_state(sides: int, radius: float, height: float, twist: float) -> KreslingState:
    """Compute the second state of a layer in which all creases have the same lengths.

    The difference of the squared lengths, 4 radius^2 sin(180 deg / sides) sin(twist + 180 deg / sides), determines the
    sine, and two twists have this sine: the other one is 180 deg - 360 deg / sides minus `twist`. The length of the
    mountain creases then determines the height.

    Args:
        sides: number of sides of the polygons.
        radius: radius of the circles through their corners, m.
        height: height of the layer, m.
        twist: twist of the layer, rad.

    Returns:
        The other state, twisted in the same sense. At a twist of 90 deg - 180 deg / sides both states are the same.

    Raises:
        InputError: as for `kresling_pattern`; or the creases are too short for a second state.
    """
    _check_tower(sides, radius, height, twist)
    other = math.pi - 2 * math.pi / sides - abs(twist)
    least = 4 * radius**2 * (math.sin(other / 2) ** 2 - math.sin(abs(twist) / 2) ** 2)
    if not height**2 >= least:
        lowest, got = (f"{100 * item:.6g} cm" for item in (math.sqrt(least), height))
        raise InputError(f"pattern.height: need at least {lowest} for a second state, got {got}")
    return KreslingState(math.sqrt(height**2 - least), math.copysign(other, twist))


def _check_tower(sides: int, radius: float, height: float, twist: float) -> None:
    """Raise InputError for values that do not give a twisted prism."""
    check_count("sides", sides, 3)
    check_lengths({"radius": radius, "height": height})
    most = math.pi - 2 * math.pi / sides
    if not 0 < abs(twist) < most:
        bound = f"{math.degrees(most):.6g} deg"
        raise InputError(
            f"pattern.twist: need > 0 deg and < {bound}, 180 deg - 360 deg / sides, or the same with a minus, got"
            f" {math.degrees(twist):.6g} deg"
        )
