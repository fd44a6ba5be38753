"""Straight segments along the centre lines of strokes, solid or dashed."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from scipy import ndimage

from forficula.arrays import Array, Indices
from forficula.pattern.picture.ink import Ink
from forficula.pattern.picture.ridge_points import RidgePoints

_SAME_ANGLE = np.radians(14)  # [chosen] between a point's direction and that of its segment
_BESIDE = 1.6  # [chosen] pixels between a point and the line of its segment
_START_RESIDUAL = 0.7  # [chosen] pixels, of the points from which a segment grows
_START_SHARE = 0.7  # [chosen] share of the pixels along the start of a segment that have a point
_GAP = 7.0  # [chosen] line widths, the longest gap between dashes
_LEAST_GAP = 9.0  # pixels
_LONG, _SHORTEST = 10.0, 3.0  # [chosen] line widths, least length of a segment in the first and the second round
_SHORTEST_PIXELS = 10.0  # least length of a segment
_LEAST_SHARE = 0.25  # [chosen] least number of points for every pixel of a segment
_FAINT = 0.3  # [chosen] ink of a short segment relative to that of long ones, below which it is left out
_INTO = 10.0  # [chosen] line widths by which a segment continues into a junction, at most
_SAME_INK = 0.5  # [chosen] share of the ink of a segment with which it continues
_ROUNDS = 400  # extensions of one segment
_BEND_GAIN = 1.15  # [chosen] ratio of residuals of one line and of two, above which a segment has a bend
_BEND_OFFSET = 0.5  # [chosen] pixels, least deviation of a bend from one line


@dataclass(frozen=True, kw_only=True, eq=False)
class DrawnSegment:
    """Straight segment of ink.

    Attributes:
        middle: a point of its line, pixels, shape (2,).
        along: its direction, a unit vector, shape (2,).
        start: position of its first point along the line, from `middle`, pixels.
        end: position of its last point, pixels.
        ink_start: position to which the ink continues before the first point, as into a junction, pixels.
        ink_end: position to which the ink continues after the last point, pixels.
        residual: root mean square distance of its points from the line, pixels.
        longest_gap: longest distance between neighbouring points along the line, pixels.
        count: number of its points.
    """

    middle: Array
    along: Array
    start: float
    end: float
    ink_start: float
    ink_end: float
    residual: float
    longest_gap: float
    count: int

    @property
    def length(self) -> float:
        """Length, pixels."""
        return self.end - self.start

    def place(self, position: float) -> Array:
        """Return the point at a position along the line, pixels."""
        return np.asarray(self.middle + position * self.along)

    def standard_error(self, position: float) -> float:
        """Return the standard error of the line across its direction at a position, pixels."""
        centre, spread = (self.start + self.end) / 2, max(self.length, 1.0) / np.sqrt(12)
        count = max(self.count / 4, 2.0)  # neighbouring points share their noise
        lever = (position - centre) / spread
        return float(max(self.residual, 0.05) * np.sqrt((1 + lever**2) / count))


def drawn_segments(ridges: RidgePoints, ink: Ink) -> tuple[list[DrawnSegment], Indices]:
    """Find straight segments: from a short start a segment grows in both directions while its line continues.

    Args:
        ridges: points on centre lines.
        ink: the ink.

    Returns:
        The segments, and the numbers of the points that belong to none of them.
    """
    line_width = ink.line_width
    window = max(6.0, 1.6 * line_width)
    gap = max(_LEAST_GAP, _GAP * line_width)
    free = np.ones(len(ridges.places), dtype=bool)
    segments: list[DrawnSegment] = []
    # long segments first, because strokes that meet at a junction also form short ridges there
    for least in (_LONG * line_width, max(_SHORTEST_PIXELS, _SHORTEST * line_width)):
        tried = ~free
        for seed in np.argsort(-ridges.strengths, kind="stable").tolist():
            if not free[seed] or tried[seed]:
                continue
            tried[seed] = True
            members = _grown(ridges, free, seed, window, gap)
            if members is None:
                continue
            members = _straight_part(ridges, members, seed)
            segment = _fitted(ridges, members, 2 * line_width)
            if segment.length < least or segment.count < _LEAST_SHARE * segment.length:
                tried[members] = True
                continue
            segments.append(segment)
            free[members] = False
            # the ends of dashes, too, whose points have other directions
            reach = (segment.start - line_width, segment.end + line_width)
            for beside, angle in ((line_width, _SAME_ANGLE), (0.6 * line_width, np.pi)):
                free[_band(ridges, segment.middle, segment.along, *reach, beside, angle)] = False
    segments = _without_faint(segments, ink)
    return [_into_junctions(segment, ink) for segment in segments], np.flatnonzero(free)


def _band(
    ridges: RidgePoints,
    middle: Array,
    along: Array,
    start: float,
    end: float,
    beside: float,
    angle: float = _SAME_ANGLE,
) -> Indices:
    """Return the numbers of the points within a distance of a line whose strokes have its direction."""
    height, width = ridges.number_at.shape
    across = np.array([-along[1], along[0]])
    positions = np.arange(start, end + 0.5, 0.7)
    offsets = np.arange(-np.ceil(beside), np.ceil(beside) + 0.5, 0.7)
    grid = middle + positions[:, np.newaxis, np.newaxis] * along + offsets[:, np.newaxis] * across
    x, y = np.rint(grid[..., 0]).astype(np.int64).ravel(), np.rint(grid[..., 1]).astype(np.int64).ravel()
    inside = (x >= 0) & (y >= 0) & (x < width) & (y < height)
    numbers = ridges.number_at[y[inside], x[inside]]
    numbers = np.unique(numbers[numbers >= 0])
    offset = ridges.places[numbers] - middle
    near = np.abs(offset @ across) <= beside
    position = offset @ along
    near &= (position >= start) & (position <= end)
    turn = np.abs((ridges.angles[numbers] - np.arctan2(along[1], along[0]) + np.pi / 2) % np.pi - np.pi / 2)
    return np.asarray(numbers[near & (turn <= angle)], dtype=np.int64)


def _line(places: Array) -> tuple[Array, Array, Array]:
    """Return a point and the direction of the best line, and the distances of the points from it."""
    middle = places.mean(axis=0)
    x, y = (places - middle).T
    turn = 0.5 * np.arctan2(2 * (x @ y), x @ x - y @ y)
    along = np.array([np.cos(turn), np.sin(turn)])
    return middle, along, y * along[0] - x * along[1]


def _grown(ridges: RidgePoints, free: Array, seed: int, window: float, gap: float) -> Indices | None:
    """Return the points of a segment that grows from a point; None where no line begins."""
    turn = ridges.angles[seed]
    middle, along = ridges.places[seed], np.array([np.cos(turn), np.sin(turn)])
    members = _free(free, _band(ridges, middle, along, -window, window, 2.0, np.radians(25)))
    if len(members) < 5:
        return None
    for _ in range(2):
        middle, along, beside = _line(ridges.places[members])
        members = _free(free, _band(ridges, ridges.places[seed], along, -window, window, _BESIDE, np.radians(20)))
        if len(members) < 5:
            return None
    middle, along, beside = _line(ridges.places[members])
    position = (ridges.places[members] - middle) @ along
    if np.sqrt(np.mean(beside**2)) > _START_RESIDUAL or len(members) < _START_SHARE * np.ptp(position) * 0.8:
        return None
    if np.ptp(position) < window:
        return None
    for step in range(_ROUNDS):
        position = (ridges.places[members] - middle) @ along
        low, high = float(position.min()), float(position.max())
        reach = gap + max(4.0, min(0.5 * (high - low), 200.0))
        candidates = _free(free, _band(ridges, middle, along, low - reach, high + reach, _BESIDE))
        candidates = _continuous(candidates, (ridges.places[candidates] - middle) @ along, low, high, gap)
        grew = len(candidates) > len(members) or step == 0
        if len(candidates) >= 5:
            members = candidates
            middle, along, _ = _line(ridges.places[members])
        if not grew:
            break
    return members


def _free(free: Array, numbers: Indices) -> Indices:
    return np.asarray(numbers[free[numbers]], dtype=np.int64)


def _continuous(numbers: Indices, position: Array, low: float, high: float, gap: float) -> Indices:
    """Return the points that are connected to the range from low to high without a longer gap."""
    order = np.argsort(position)
    numbers, position = numbers[order], position[order]
    breaks = np.flatnonzero(np.diff(position) > gap)
    first = breaks[position[breaks + 1] <= low + 1e-9]
    last = breaks[position[breaks] >= high - 1e-9]
    start = int(first[-1]) + 1 if len(first) else 0
    stop = int(last[0]) + 1 if len(last) else len(numbers)
    return numbers[start:stop]


def _straight_part(ridges: RidgePoints, members: Indices, seed: int) -> Indices:
    """Return the part of a segment with a bend that contains the seed; the whole segment without a bend."""
    while True:
        middle, along, beside = _line(ridges.places[members])
        position = (ridges.places[members] - middle) @ along
        order = np.argsort(position)
        split = _bend(position[order], beside[order])
        if split is None:
            return members
        ordered = members[order]
        at = int(np.searchsorted(position[order], float((ridges.places[seed] - middle) @ along)))
        members = ordered[:split] if at < split else ordered[split:]


def _bend(position: Array, beside: Array) -> int | None:
    """Return where two lines fit the points much better than one; None where one line fits."""
    count = len(position)
    if count < 24:
        return None
    sums = [np.cumsum(values) for values in (position, beside, position**2, position * beside, beside**2)]
    sizes = np.arange(1.0, count + 1)

    def rest(n: Array, x: Array, y: Array, xx: Array, xy: Array, yy: Array) -> Array:
        with np.errstate(divide="ignore", invalid="ignore"):
            slope = (n * xy - x * y) / (n * xx - x**2)
            return np.asarray(yy - y**2 / n - slope * (xy - x * y / n))

    before = rest(sizes, *sums)
    after = rest(count - sizes, *(total[-1] - total for total in sums))
    total = before + after
    total[:8] = total[-9:] = np.inf
    total[~np.isfinite(total)] = np.inf
    best = int(np.argmin(total))
    whole, parts = float(beside @ beside), max(float(total[best]), 1e-12)
    if np.sqrt(whole / parts) < _BEND_GAIN:
        return None
    # the largest deviation of the two lines from the one line
    deviation = 0.0
    for part in (slice(None, best + 1), slice(best + 1, None)):
        slope, level = np.polyfit(position[part], beside[part], 1)
        ends = position[part][[0, -1]]
        deviation = max(deviation, float(np.abs(slope * ends + level).max()))
    return best + 1 if deviation > _BEND_OFFSET else None


def _fitted(ridges: RidgePoints, members: Indices, margin: float) -> DrawnSegment:
    """Fit a segment to its points, without those within a margin of its ends, where other lines shift the ridge."""
    every = ridges.places[members]
    middle, along, _ = _line(every)
    position = (every - middle) @ along
    inner = (position > position.min() + margin) & (position < position.max() - margin)
    places = every[inner] if np.count_nonzero(inner) >= max(8, len(every) // 2) else every
    kept = places
    for _ in range(3):
        middle, along, beside = _line(kept)
        limit = max(0.3, 2.5 * 1.4826 * float(np.median(np.abs(beside))))
        offset = places - middle
        kept = places[np.abs(offset[:, 1] * along[0] - offset[:, 0] * along[1]) <= limit]
    middle, along, beside = _line(kept)
    position = np.sort((every - middle) @ along)
    return DrawnSegment(
        middle=middle,
        along=along,
        start=float(position[0]),
        end=float(position[-1]),
        ink_start=float(position[0]),
        ink_end=float(position[-1]),
        residual=float(np.sqrt(np.mean(beside**2))),
        longest_gap=float(np.diff(position).max(initial=0.0)),
        count=len(kept),
    )


def _without_faint(segments: list[DrawnSegment], ink: Ink) -> list[DrawnSegment]:
    """Return the segments without short ones of little ink, such as artefacts of JPEG beside a line."""
    strengths = [
        float(np.percentile(_ink_along(ink, segment, np.linspace(segment.start, segment.end, 48)), 75))
        for segment in segments
    ]
    is_long = [segment.length > _LONG * ink.line_width for segment in segments]
    typical = np.median([strength for strength, long in zip(strengths, is_long, strict=True) if long] or [0.0])
    return [
        segment
        for segment, strength, long in zip(segments, strengths, is_long, strict=True)
        if long or strength > _FAINT * typical
    ]


def _into_junctions(segment: DrawnSegment, ink: Ink) -> DrawnSegment:
    """Extend a segment while there is ink on its line: at junctions other strokes shift the points of the ridge."""
    steps = np.arange(0.0, _INTO * ink.line_width, 0.5)
    inner = _ink_along(ink, segment, np.linspace(segment.start, segment.end, 64))
    level = _SAME_INK * float(np.percentile(inner, 75))
    runs = []
    for end, sign in ((segment.start, -1), (segment.end, 1)):
        faint = _ink_along(ink, segment, end + sign * steps) < level
        runs.append(end + sign * float(steps[int(np.argmax(faint))] if faint.any() else steps[-1]))
    return replace(segment, ink_start=runs[0], ink_end=runs[1])


def _ink_along(ink: Ink, segment: DrawnSegment, positions: Array) -> Array:
    """Return the strength of the ink on the line of a segment."""
    places = segment.middle + positions[:, np.newaxis] * segment.along
    return np.asarray(ndimage.map_coordinates(ink.strength, places.T[::-1], order=1, mode="constant"))
