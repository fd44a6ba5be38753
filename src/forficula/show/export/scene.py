"""A run as a scene that every mesh format shares: moving vertices, coloured faces, and straight rods and balls."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from forficula.arrays import Array, Indices
from forficula.dynamics import Record
from forficula.kept_frames import kept_frames
from forficula.show.page.data.shape_mesh import ShapeMesh, shape_mesh
from forficula.show.page.playback import diverged_rows
from forficula.show.structure.painted_shape import bar_tint, tint
from forficula.show.structure.shape import Shape, shape_of, vertex_places
from forficula.show.style import BLUE, VERMILION
from forficula.structure import GROUND, Structure

# colours of the page in light mode (web/src/page.css); tendons in the middle of its scale of energies
BAR, JOINT, BASE, TENDON = "#50565d", "#23272b", "#7c6a58", "#29af7f"
_CREASES = {"M": VERMILION, "V": BLUE, "B": BAR}
_MOST_FRAMES = 2000
# largest error of linear interpolation between kept frames, as a share of the span
_TOLERANCE = 1e-5
STILL = 1e-9  # displacement below which a structure counts as at rest, as a share of the span


@dataclass(frozen=True, kw_only=True)
class SceneRod:
    """Straight round rod between two vertices.

    Attributes:
        kind: "bar", "crease", "rim", "edge" or "tendon".
        colour: as "#rrggbb".
        ends: two vertices.
        radius: m.
    """

    kind: str
    colour: str
    ends: tuple[int, int]
    radius: float


@dataclass(frozen=True, kw_only=True, eq=False)
class Region:
    """Faces of one colour.

    Attributes:
        name: name of the region, such as "distal panel".
        colour: as "#rrggbb".
        triangles: three vertices each, (triangle, 3).
        solid: whether the faces are those of plates and not of a sheet.
    """

    name: str
    colour: str
    triangles: Indices
    solid: bool


@dataclass(frozen=True, kw_only=True, eq=False)
class Scene:
    """Motion of a structure as vertices, and the coloured parts between them.

    Attributes:
        name: name of the design.
        span: span of the structure, m.
        time: times of the frames, s, (frame,).
        vertices: positions, m, z up, (frame, vertex, 3).
        bodies: number of the rigid body that carries each vertex, (vertex,); -2 for a vertex between bodies.
        regions: faces of sheets and plates.
        rods: bars, creases, rims, edges and tendons.
        balls: vertices of joints, (joint,).
        ball_radius: m.
        base: ends of rods along fixed parts, m, (rod, end, axis).
        base_radius: m.
    """

    name: str
    span: float
    time: Array
    vertices: Array
    bodies: Indices
    regions: tuple[Region, ...]
    rods: tuple[SceneRod, ...]
    balls: Indices
    ball_radius: float
    base: Array
    base_radius: float

    @property
    def moves(self) -> bool:
        """Whether a vertex moves."""
        return float(np.ptp(self.vertices, axis=0).max(initial=0.0)) > STILL * self.span


def sampled(record: Record, name: str, times: Array) -> Array:
    """Return a series at several times (s) within the run, interpolated between samples, in SI, (time, ...)."""
    series, time = record.series[name], record.time
    after = np.clip(np.searchsorted(time, times), 0, len(time) - 1)
    before = np.maximum(after - 1, 0)
    gap = time[after] - time[before]
    share = np.where(gap > 0, (times - time[before]) / np.where(gap > 0, gap, 1.0), 1.0)
    share = share.reshape(-1, *(1,) * (series.ndim - 1))
    # exactly the sample where the time is one
    return np.where(share == 1.0, series[after], (1 - share) * series[before] + share * series[after])


def sampled_points(record: Record, times: Array) -> Array:
    """Return points of a structure, then nodes of its membranes, m, (time, point, 3)."""
    return np.concatenate([sampled(record, name, times) for name in ("point_position", "membrane_position")], axis=1)


def frame_times(record: Record) -> Array:
    """Return the samples of a run between which linear interpolation follows its motion, s, (frame,).

    Rows after a divergence are left out. At most 2000 frames are kept, and always those at the ends of stages.
    """
    points = np.concatenate([record.series["point_position"], record.series["membrane_position"]], axis=1)
    points[diverged_rows(record)] = np.nan
    moments = [moment for end in record.stages for moment in (end.start, end.end)]
    rows = kept_frames(record.time, points, moments, most=_MOST_FRAMES, tolerance=_TOLERANCE * record.structure.span)
    time = record.time[rows]
    # files hold times as 4-byte floats, which must rise
    rising = np.flatnonzero(np.diff(time.astype(np.float32), prepend=-np.inf) > 0)
    return np.asarray(time[rising])


def scene_of(record: Record, times: Array) -> Scene:
    """Return the scene of a run at several times (s)."""
    structure = record.structure
    shape, mesh = shape_of(structure), shape_mesh(structure)
    vertices = vertex_places(shape, sampled_points(record, times)[:, shape.anchors])
    corners = [((face[0], one, other), region) for face, region in _faces(shape) for one, other in pairwise(face[1:])]
    regions = tuple(
        Region(
            name=name,
            colour=tint(number),
            triangles=np.array([corner for corner, region in corners if region == number], dtype=np.int64).reshape(
                -1, 3
            ),
            solid=shape.solid[number],
        )
        for number, name in enumerate(shape.regions)
    )
    return Scene(
        name=record.design.name,
        span=structure.span,
        time=times,
        vertices=vertices,
        bodies=_carriers(structure, shape),
        regions=regions,
        rods=tuple(_rods(shape, mesh)),
        balls=np.concatenate([shape.joints, shape.held]),
        ball_radius=mesh.joint_radius,
        base=mesh.base,
        base_radius=mesh.base_radius,
    )


def _faces(shape: Shape) -> list[tuple[tuple[int, ...], int]]:
    return list(zip(shape.faces, shape.face_region.tolist(), strict=True))


def _rods(shape: Shape, mesh: ShapeMesh) -> list[SceneRod]:
    """Return bars, lines on faces, and tendons; creases are unbroken and distinguished by colour only."""
    radii = {tube.kind: tube.radius for tube in mesh.tubes}
    rods = [
        SceneRod(
            kind="bar",
            colour=_CREASES[bar.crease] if bar.region is None else bar_tint(bar.region),
            ends=bar.ends,
            radius=bar.radius,
        )
        for bar in shape.bars
    ]
    for line in shape.lines:
        colour = _CREASES[line.crease]
        rods += [
            SceneRod(kind=line.kind, colour=colour, ends=ends, radius=radii[line.kind]) for ends in pairwise(line.path)
        ]
    rods += [SceneRod(kind="tendon", colour=TENDON, ends=ends, radius=radii["tendon"]) for ends in shape.tendons]
    return rods


def _carriers(structure: Structure, shape: Shape) -> Indices:
    """Return the body that carries each vertex, (vertex,); -2 for vertices between bodies and of membranes."""
    known = [point.body for point in structure.points]
    known += [body for membrane in structure.membranes for body in membrane.bodies.tolist()]
    carriers = np.array(known, dtype=np.int64)[shape.anchors][shape.between]
    return np.where(carriers[:, 0] == carriers[:, 1], carriers[:, 0], -2)


def rigid_bodies(scene: Scene) -> list[int]:
    """Return the bodies with faces whose corners they all carry, in order."""
    bodies = {
        body
        for region in scene.regions
        for body, *others in scene.bodies[region.triangles].tolist()
        if body >= GROUND and all(other == body for other in others)
    }
    return sorted(bodies)


def rod_directions(lines: Array, up: Array) -> Array:
    """Return rotations that turn an axis along lines, with the least twist from frame to frame.

    Args:
        lines: vectors along the rods, m, (frame, rod, 3).
        up: unit vector that is turned along them, (3,).

    Returns:
        Quaternions x, y, z, w, (frame, rod, 4); neighbours in time have the nearer sign.
    """
    lengths = np.linalg.norm(lines, axis=-1, keepdims=True)
    towards = np.divide(lines, lengths, out=np.broadcast_to(up, lines.shape).copy(), where=lengths > 0)
    turned, now = np.empty((*lines.shape[:2], 4)), np.broadcast_to(up, towards.shape[1:])
    rotation = np.tile([0.0, 0.0, 0.0, 1.0], (lines.shape[1], 1))
    for frame, target in enumerate(towards):
        rotation = _product(_shortest_turn(now, target), rotation)
        rotation /= np.linalg.norm(rotation, axis=-1, keepdims=True)
        turned[frame], now = rotation, target
    return same_sign(turned)


def same_sign(quaternions: Array) -> Array:
    """Return quaternions with the sign that is nearer to their predecessor in time, (frame, ..., 4)."""
    flips = np.sum(quaternions[1:] * quaternions[:-1], axis=-1) < 0
    signs = np.where(np.logical_xor.accumulate(flips, axis=0), -1.0, 1.0)
    return np.concatenate([quaternions[:1], quaternions[1:] * signs[..., np.newaxis]])


def _shortest_turn(one: Array, other: Array) -> Array:
    """Return the shortest rotations from unit vectors to others, (..., 4)."""
    cosine = np.sum(one * other, axis=-1, keepdims=True)
    # any axis across the first vector, for opposite vectors
    across = np.cross(one, np.eye(3)[np.argmin(np.abs(one), axis=-1)])
    across /= np.linalg.norm(across, axis=-1, keepdims=True)
    quaternion = np.concatenate([np.cross(one, other), 1 + cosine], axis=-1)
    opposite = np.concatenate([across, np.zeros_like(cosine)], axis=-1)
    quaternion = np.where(cosine < -1 + 1e-12, opposite, quaternion)
    return np.asarray(quaternion / np.linalg.norm(quaternion, axis=-1, keepdims=True))


def _product(one: Array, other: Array) -> Array:
    """Return the product of quaternions x, y, z, w, (..., 4)."""
    (u, a), (v, b) = ((quaternion[..., :3], quaternion[..., 3:]) for quaternion in (one, other))
    vector = a * v + b * u + np.cross(u, v)
    return np.concatenate([vector, a * b - np.sum(u * v, axis=-1, keepdims=True)], axis=-1)


def cylinder(sides: int) -> tuple[Array, Array, Indices]:
    """Return a closed cylinder of radius 1 from y = 0 to y = 1: positions, normals, (vertex, 3), and triangles."""
    angles = 2 * np.pi * np.arange(sides) / sides
    rim = np.stack([np.cos(angles), np.zeros(sides), -np.sin(angles)], axis=1)
    up = np.array([0.0, 1.0, 0.0])
    places = np.concatenate([rim, rim + up, rim, rim + up])
    normals = np.concatenate([rim, rim, np.tile(-up, (sides, 1)), np.tile(up, (sides, 1))])
    start = np.arange(sides)
    after = (start + 1) % sides
    sheath = [np.stack([start, after, sides + after], axis=1), np.stack([start, sides + after, sides + start], axis=1)]
    fan = np.arange(1, sides - 1)
    bottom = np.stack([np.zeros_like(fan), fan + 1, fan], axis=1) + 2 * sides
    top = np.stack([np.zeros_like(fan), fan, fan + 1], axis=1) + 3 * sides
    return places, normals, np.concatenate([*sheath, bottom, top])


def ball(rings: int = 6, sides: int = 12) -> tuple[Array, Indices]:
    """Return a ball of radius 1, (vertex, 3), and its triangles."""
    polar = np.pi * np.arange(1, rings) / rings
    around = 2 * np.pi * np.arange(sides) / sides
    rows = np.stack(
        [
            np.outer(np.sin(polar), np.cos(around)),
            np.outer(np.sin(polar), np.sin(around)),
            np.repeat(np.cos(polar)[:, np.newaxis], sides, axis=1),
        ],
        axis=-1,
    ).reshape(-1, 3)
    places = np.concatenate([rows, [[0.0, 0.0, 1.0], [0.0, 0.0, -1.0]]])
    number = np.arange(len(rows)).reshape(rings - 1, sides)
    after = np.roll(number, -1, axis=1)
    top, bottom = np.full(sides, len(rows)), np.full(sides, len(rows) + 1)
    pieces = [
        np.stack([top, number[0], after[0]], axis=-1),
        np.stack([number[:-1], number[1:], after[1:]], axis=-1).reshape(-1, 3),
        np.stack([number[:-1], after[1:], after[:-1]], axis=-1).reshape(-1, 3),
        np.stack([bottom, after[-1], number[-1]], axis=-1),
    ]
    return places, np.concatenate(pieces)


def turned(quaternions: Array, vectors: Array) -> Array:
    """Return vectors turned by quaternions x, y, z, w."""
    axis, real = quaternions[..., :3], quaternions[..., 3:]
    twice = 2 * np.cross(axis, vectors)
    return np.asarray(vectors + real * twice + np.cross(axis, twice))
