"""A strip with one crease across it: the sheet around two bars that a hinge joins."""

from __future__ import annotations

import math

import numpy as np

from forficula.pattern.crease_pattern import CreasePattern
from forficula.pattern.dimensions import check_angle, check_lengths

# role, vertices and letter; the crease as a mountain
_EDGES = (
    ("proximal", (1, 4), "F"),
    ("distal", (4, 7), "F"),
    *(("ring", ends, "M") for ends in ((3, 4), (4, 5))),
    *(("hub", ends, "B") for ends in ((0, 1), (1, 2))),
    *(("outer", ends, "B") for ends in ((6, 7), (7, 8))),
    *(("side", ends, "B") for ends in ((0, 3), (2, 5), (3, 6), (5, 8))),
)
# by letter, rad
_FLAT_FOLDED = {"B": math.nan, "F": 0.0, "V": math.pi, "M": -math.pi}


def strip_pattern(
    proximal_length: float,
    distal_length: float,
    proximal_sector: float,
    distal_sector: float,
    width: float,
    *,
    valley: bool,
) -> CreasePattern:
    """Draw a strip along two bars with the crease of their hinge across it.

    Both bars lie in the middle of the strip. Its sides are parallel to the bars and its ends parallel to the crease:
    two parallelograms, both halved by their bar. The crease lies on the y axis, the proximal bar on the side of -x.
    Folded by 180 deg, the angle between the bars is the difference of their sectors.

    Vertices: three at the inner end, three on the crease and three at the outer end, with ascending y. Edges, by role:
    "proximal" and "distal" along the bars, which do not fold, "ring" for the two halves of the crease, "hub" and
    "outer" at the ends, and "side". Faces: the proximal ones, then the distal ones.

    Args:
        proximal_length: length of the bar up to the crease, m.
        distal_length: length of the bar beyond the crease, m.
        proximal_sector: angle between the proximal bar and the half of the crease on +y, rad.
        distal_sector: the same angle at the distal bar, rad; the sum is 180 deg where the bars are in line.
        width: width of the strip along the crease, m.
        valley: whether the crease is a valley; otherwise it is a mountain.

    Returns:
        The pattern, flat in z = 0, with the fold angles of the flat-folded strip.

    Raises:
        InputError: a length is not > 0, or a sector is not between 0 and 180 deg.
    """
    check_lengths({"proximal_length": proximal_length, "distal_length": distal_length, "width": width})
    check_angle("proximal_sector", proximal_sector, 0, math.pi)
    check_angle("distal_sector", distal_sector, 0, math.pi)
    inner = -proximal_length * np.array([math.sin(proximal_sector), -math.cos(proximal_sector), 0.0])
    outer = distal_length * np.array([math.sin(distal_sector), math.cos(distal_sector), 0.0])
    across = np.array([[0.0, share * width, 0.0] for share in (-0.5, 0.0, 0.5)])
    places = np.concatenate([inner + across, across, outer + across])
    letters = tuple("V" if valley and letter == "M" else letter for _, _, letter in _EDGES)
    return CreasePattern(
        title="strip along two bars, a hinge between them",
        vertices_coords=places,
        edges_vertices=np.array([ends for _, ends, _ in _EDGES]),
        edges_assignment=letters,
        edges_fold_angle=np.array([_FLAT_FOLDED[letter] for letter in letters]),
        edges_role=tuple(role for role, _, _ in _EDGES),
        faces_vertices=((0, 3, 4, 1), (1, 4, 5, 2), (3, 6, 7, 4), (4, 7, 8, 5)),
    )
