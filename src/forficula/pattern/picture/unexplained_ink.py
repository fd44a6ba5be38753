"""Lines and ink in a picture that are not part of the traced pattern."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from scipy import ndimage
from scipy.spatial import cKDTree

from forficula.arrays import Array, Indices
from forficula.pattern.drawings.flat_faces import parts_of
from forficula.pattern.picture.ink import Ink, full_places
from forficula.pattern.picture.junctions import Junctions
from forficula.pattern.picture.ridge_points import RidgePoints
from forficula.pattern.picture.trace import PicturePoint
from forficula.pattern.picture.traced_pattern import EnclosedFaces

_LEFT_OVER = 4.0  # [chosen] line widths, length of ink without a line that is reported
_APART = 8.0  # [chosen] line widths between pieces of ink that are reported as one
_DARK = 0.35  # [chosen] ink relative to that of the edges, above which it is reported


def free_ends_of(network: Junctions, enclosed: EnclosedFaces, reduced: int) -> tuple[PicturePoint, ...]:
    """Return the ends of lines that lead nowhere."""
    ends = [(place, "end of a line") for place in network.free_ends]
    for edge in enclosed.left_out.tolist():
        one, other = network.edges[edge].tolist()
        ends.append(((network.places[one] + network.places[other]) / 2, "line that encloses no face, left out"))
    return tuple(
        PicturePoint(x=float(x), y=float(y), what=what)
        for (x, y), what in ((full_places(place, reduced), what) for place, what in ends)
    )


def left_over_ink(
    ridges: RidgePoints, left: Indices, places: Array, edges: Indices, ink: Ink, reduced: int
) -> tuple[PicturePoint, ...]:
    """Return longer pieces of ink that no edge explains."""
    points = ridges.places[left]
    if not len(points):
        return ()
    near = np.full(len(points), np.inf)
    for one, other in edges.tolist():
        along = places[other] - places[one]
        share = np.clip((points - places[one]) @ along / (along @ along), 0, 1)
        np.minimum(near, np.linalg.norm(places[one] + share[:, np.newaxis] * along - points, axis=1), out=near)
    rows, columns = (np.array(ink.strength.shape) - 1).tolist()
    x, y = np.rint(points).astype(np.int64).T
    least = _DARK * float(np.median(_ink_of_edges(ink, places, edges)))
    inked = ink.strength[np.clip(y, 0, rows), np.clip(x, 0, columns)] > least
    points = points[(near > 1.5 * ink.line_width + 1) & inked]
    if not len(points):
        return ()
    # dots and letters that are not far from each other are one piece
    pairs = cKDTree(points).query_pairs(_APART * ink.line_width, output_type="ndarray")
    parts = parts_of(len(points), pairs)
    pieces = []
    for part in np.flatnonzero(np.bincount(parts) >= _LEFT_OVER * ink.line_width + 2).tolist():
        x, y = full_places(points[parts == part].mean(axis=0), reduced).tolist()
        pieces.append(PicturePoint(x=x, y=y, what="ink that is no line of the pattern"))
    return tuple(pieces)


def _ink_of_edges(ink: Ink, places: Array, edges: Indices) -> Array:
    """Return the strength of the ink in the middle of every edge."""
    middles = places[edges].mean(axis=1)
    grid = [middles[:, 1], middles[:, 0]]
    return np.asarray(ndimage.map_coordinates(ndimage.maximum_filter(ink.strength, 5), grid, order=1))


def unexplained_sentences(free_ends: Sequence[PicturePoint], left_over: Sequence[PicturePoint]) -> list[str]:
    """Return sentences on lines and ink that are not part of the pattern."""
    sentences = []
    if free_ends:
        one = "1 line leads nowhere and is not part of the pattern; it is marked in the picture."
        several = f"{len(free_ends)} lines or ends of lines lead nowhere and are not part of the pattern; marked in the"
        sentences.append(one if len(free_ends) == 1 else f"{several} picture.")
    if left_over:
        count = "1 piece" if len(left_over) == 1 else f"{len(left_over)} pieces"
        sentences.append(f"{count} of other ink, such as text or curves; marked in the picture.")
    return sentences
