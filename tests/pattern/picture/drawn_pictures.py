"""Drawings of crease patterns by Pillow, photographed with distortions: pictures that know their truth."""

from __future__ import annotations

import io
import math
from dataclasses import dataclass

import numpy as np
from PIL import Image, ImageDraw, ImageFilter

from forficula.pattern import CreasePattern

INKS = {
    "B": (20, 20, 20),
    "M": (205, 30, 30),
    "V": (30, 50, 190),
    "F": (225, 190, 20),
    "U": (200, 30, 190),
    "C": (20, 160, 60),
}
DASHES = {"M": (4, 1, 0.8, 1), "V": (2, 1), "F": (0.7, 1), "U": (6, 2), "C": (1, 0.5)}  # in units of 4 line widths
TABLE = (70, 60, 50)
_MARGIN = 0.15  # of the pattern's longer side, around it


@dataclass(frozen=True)
class Photograph:
    """A picture and its truth.

    Attributes:
        picture: the picture.
        corners: corners of the page, pixels, clockwise from the upper left one, shape (4, 2).
        vertices: positions of the pattern's vertices, pixels, shape (N, 2).
        page: width and height of the page, m.
    """

    picture: Image.Image
    corners: np.ndarray
    vertices: np.ndarray
    page: tuple[float, float]

    @property
    def pixels(self) -> np.ndarray:
        return np.asarray(self.picture.convert("RGB"))


@dataclass(frozen=True)
class Distortion:
    """How a page is photographed.

    Attributes:
        size: width and height of the picture, pixels.
        perspective: largest movement of a corner, as a share of the smaller side.
        turn: rotation, deg.
        light: share by which the light falls from one side to the other.
        cast: largest relative change of the brightness of a colour.
        blur: standard deviation, pixels.
        noise: standard deviation, as a share of white.
        quality: of the JPEG file, 1 to 95.
    """

    size: tuple[int, int] = (1200, 1000)
    perspective: float = 0.05
    turn: float = 0.0
    light: float = 0.35
    cast: float = 0.0
    blur: float = 1.0
    noise: float = 0.015
    quality: int = 85


def drawn_page(
    pattern: CreasePattern,
    pixels: int,
    *,
    line: float = 0.003,
    dashed: bool = False,
    inks: dict[str, tuple[int, int, int]] = INKS,
) -> tuple[Image.Image, np.ndarray, tuple[float, float]]:
    """Draw a flat pattern on a page with a margin.

    Args:
        pattern: the pattern.
        pixels: number along the longer side of the page.
        line: width of a line, as a share of the pattern's longer side.
        dashed: whether creases are dashed.
        inks: colours by letter.

    Returns:
        The page, the vertices on it, pixels from its upper left corner, shape (N, 2), and its width and height, m.
    """
    points = pattern.vertices_coords[:, :2]
    extent = np.ptp(points, axis=0)
    margin = _MARGIN * extent.max()
    scale = pixels / float((extent + 2 * margin).max())
    width, height = (math.ceil(side) for side in scale * (extent + 2 * margin))
    places = scale * (points - points.min(axis=0) + margin) * [1, -1] + [0, height]
    finer, thick = 3, line * scale * extent.max()
    page = Image.new("RGB", (width * finer, height * finer), (250, 250, 248))
    pen = ImageDraw.Draw(page)
    edges = list(zip(pattern.edges_vertices.tolist(), pattern.edges_assignment, strict=True))
    for (one, other), letter in sorted(edges, key=lambda edge: edge[1] == "B"):
        start, end = finer * places[one], finer * places[other]
        length = float(np.linalg.norm(end - start))
        along = (end - start) / length
        aside = np.array([-along[1], along[0]]) * finer * thick / 2
        dashes = [4 * thick * finer * share for share in DASHES.get(letter, ())] if dashed else []
        for low, high in _runs(length, dashes):
            corners = (start + along * low + aside, start + along * high + aside)
            corners += (start + along * high - aside, start + along * low - aside)
            pen.polygon([tuple(corner) for corner in corners], fill=inks[letter])
        if not dashes:
            for place in (start, end):
                pen.ellipse([*(place - finer * thick / 2), *(place + finer * thick / 2)], fill=inks[letter])
    return page.resize((width, height), Image.Resampling.BOX), places, (width / scale, height / scale)


def _runs(length: float, dashes: list[float]) -> list[tuple[float, float]]:
    """Return the inked parts of a line."""
    runs, at, number = [], 0.0, 0
    while dashes and at < length:
        step = dashes[number % len(dashes)]
        if number % 2 == 0:
            runs.append((at, min(length, at + step)))
        at, number = at + step, number + 1
    return runs or [(0.0, length)]


def scanned(page: Image.Image, places: np.ndarray, size: tuple[float, float]) -> Photograph:
    """Return a page as a scanner sees it: nothing but the page."""
    width, height = page.size
    corners = np.array([[0, 0], [width, 0], [width, height], [0, height]]) - 0.5
    return Photograph(picture=page, corners=corners, vertices=places - 0.5, page=size)


def photographed(
    page: Image.Image, places: np.ndarray, size: tuple[float, float], distortion: Distortion, seed: int
) -> Photograph:
    """Photograph a page on a dark table."""
    rng = np.random.default_rng(seed)
    width, height = distortion.size
    long, tall = page.size
    rectangle = np.array([[0, 0], [long, 0], [long, tall], [0, tall]], dtype=float)
    turn = math.radians(distortion.turn)
    turned = (rectangle - [long / 2, tall / 2]) @ [
        [math.cos(turn), math.sin(turn)],
        [-math.sin(turn), math.cos(turn)],
    ]
    extent = np.ptp(turned, axis=0)
    scale = 0.94 * min(width / extent[0], height / extent[1]) * (1 - distortion.perspective)
    corners = scale * turned + [width / 2, height / 2]
    reach = 0.5 * (np.array([width, height]) - np.ptp(corners, axis=0)).min() - 4
    most = min(distortion.perspective * min(width, height), max(0.0, reach))
    corners = corners + rng.uniform(-most, most, (4, 2))
    to_page, to_picture = _projection(corners, rectangle), _projection(rectangle, corners)
    around = 24
    wider = Image.new("RGB", (long + 2 * around, tall + 2 * around), TABLE)
    wider.paste(page, (around, around))
    shifted = np.array([[1, 0, around], [0, 1, around], [0, 0, 1]]) @ to_page
    picture = wider.transform(
        (width, height),
        Image.Transform.PERSPECTIVE,
        tuple((shifted / shifted[2, 2]).ravel()[:8]),
        Image.Resampling.BICUBIC,
        fillcolor=TABLE,
    )
    y, x = np.mgrid[0:height, 0:width]
    direction = rng.uniform(0, 2 * math.pi)
    side = ((x / width - 0.5) * math.cos(direction) + (y / height - 0.5) * math.sin(direction)) / math.sqrt(2)
    light = (1 - distortion.light * (0.5 + side))[..., np.newaxis] * (1 + distortion.cast * rng.uniform(-1, 0, 3))
    picture = _image(np.asarray(picture) / 255 * light)
    if distortion.blur:
        picture = picture.filter(ImageFilter.GaussianBlur(distortion.blur))
    picture = _image(np.asarray(picture) / 255 + rng.normal(0, distortion.noise, (height, width, 3)))
    content = io.BytesIO()
    picture.save(content, "JPEG", quality=distortion.quality)
    return Photograph(
        picture=Image.open(io.BytesIO(content.getvalue())),
        corners=corners - 0.5,
        vertices=_mapped(to_picture, places) - 0.5,
        page=size,
    )


def _image(values: np.ndarray) -> Image.Image:
    return Image.fromarray((np.clip(values, 0, 1) * 255).round().astype(np.uint8))


def _projection(start: np.ndarray, end: np.ndarray) -> np.ndarray:
    rows, right = [], []
    for (x, y), (u, v) in zip(start, end, strict=True):
        rows += [[x, y, 1, 0, 0, 0, -u * x, -u * y], [0, 0, 0, x, y, 1, -v * x, -v * y]]
        right += [u, v]
    return np.append(np.linalg.solve(np.array(rows), np.array(right)), 1).reshape(3, 3)


def _mapped(matrix: np.ndarray, points: np.ndarray) -> np.ndarray:
    lifted = points @ matrix[:, :2].T + matrix[:, 2]
    return lifted[:, :2] / lifted[:, 2:]


@dataclass(frozen=True)
class Comparison:
    """A trace compared with the drawn pattern.

    Attributes:
        vertices: number of drawn vertices, and of those that were found within 1 % of the size.
        error: largest error of a found vertex on the sheet, as a share of the pattern's size.
        edges: number of drawn edges, and of those that were found.
        right: number of edges with the right letter.
        wrong: number of edges with another letter than the right one and "U".
        unassigned: number of edges with "U" in the place of another letter.
        extra: number of edges that were not drawn.
        silent: whether something is missing, extra or unassigned, but nothing is doubtful.
    """

    vertices: tuple[int, int]
    error: float
    edges: tuple[int, int]
    right: int
    wrong: int
    unassigned: int
    extra: int
    silent: bool

    @property
    def complete(self) -> bool:
        """Whether every vertex, edge and letter is right and nothing is extra."""
        return self.vertices[0] == self.vertices[1] and self.edges[0] == self.right and not self.extra


def compared(pattern: CreasePattern, photograph: Photograph, trace) -> Comparison:
    """Compare a trace with the pattern that was drawn."""
    seen = np.array([(vertex.picture_x, vertex.picture_y) for vertex in trace.vertices])
    distance = np.linalg.norm(photograph.vertices[:, np.newaxis] - seen, axis=2)
    nearest = distance.argmin(axis=1)
    near = distance.min(axis=1) < 0.01 * np.ptp(photograph.vertices, axis=0).max()
    drawn, traced = pattern.vertices_coords[near, :2], trace.pattern.vertices_coords[nearest[near], :2]
    offset = (
        np.full((1, 2), np.nan) if not near.any() else (traced - traced.mean(axis=0)) - (drawn - drawn.mean(axis=0))
    )
    back = {int(place): int(vertex) for vertex, place in enumerate(nearest) if near[vertex]}
    letters = {
        frozenset(ends): letter
        for ends, letter in zip(pattern.edges_vertices.tolist(), pattern.edges_assignment, strict=True)
    }
    right = wrong = unassigned = extra = 0
    for edge in trace.edges:
        letter = letters.get(frozenset(back.get(vertex, -1) for vertex in edge.vertices))
        extra += letter is None
        right += letter == edge.letter
        unassigned += letter not in (None, edge.letter) and edge.letter == "U"
        wrong += letter not in (None, edge.letter) and edge.letter != "U"
    matched = right + wrong + unassigned
    incomplete = not near.all() or matched < len(letters) or extra or unassigned or wrong
    return Comparison(
        vertices=(len(near), int(near.sum())),
        error=float(np.linalg.norm(offset, axis=1).max() / np.ptp(pattern.vertices_coords, axis=0).max()),
        edges=(len(letters), matched),
        right=right,
        wrong=wrong,
        unassigned=unassigned,
        extra=extra,
        silent=bool(incomplete) and not trace.is_doubtful,
    )
