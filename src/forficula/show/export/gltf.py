"""Animated glTF 2.0 in one binary file (.glb; Khronos Group, glTF 2.0 specification).

No library packs animation channels: pygltflib holds the same JSON as classes, and trimesh writes scenes without motion.
"""

from __future__ import annotations

import json
import struct
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from scipy.spatial.transform import Rotation

from forficula.arrays import Array, Indices
from forficula.show.export.scene import (
    BASE,
    JOINT,
    Scene,
    SceneRod,
    ball,
    cylinder,
    rigid_bodies,
    rod_directions,
    same_sign,
    turned,
)

_FLOAT, _SHORT, _INT = 5126, 5123, 5125
_VERTICES, _INDICES = 34962, 34963
_SIDES = 12
_Y = np.array([0.0, 1.0, 0.0])
# largest error of vertices of a sheet, as a share of the span: half that of 4-byte floats of its size
_PRECISE = 3e-8
_MAGIC, _JSON, _BIN = 0x46546C67, 0x4E4F534A, 0x004E4942


@dataclass
class _Document:
    """Parts of a glTF file, with all arrays in one buffer."""

    json: dict[str, Any] = field(default_factory=dict)
    buffer: bytearray = field(default_factory=bytearray)

    def add(self, kind: str, value: dict[str, Any]) -> int:
        """Add an entry to a top-level list, and return its index."""
        entries = self.json.setdefault(kind, [])
        entries.append(value)
        return len(entries) - 1

    def array(self, values: Array | Indices, shape: str, *, target: int | None = None, bounds: bool = False) -> int:
        """Add an accessor of an array, as 4-byte floats or as the shortest allowed integers."""
        if values.dtype.kind == "f":
            stored, component = np.ascontiguousarray(values, dtype="<f4"), _FLOAT
        elif values.max(initial=0) < 65535:  # the largest index restarts a primitive
            stored, component = np.ascontiguousarray(values, dtype="<u2"), _SHORT
        else:
            stored, component = np.ascontiguousarray(values, dtype="<u4"), _INT
        self.buffer += b"\0" * (-len(self.buffer) % 4)
        view: dict[str, Any] = {"buffer": 0, "byteOffset": len(self.buffer), "byteLength": stored.nbytes}
        self.buffer += stored.tobytes()
        count = stored.size if shape == "SCALAR" else len(stored)
        accessor: dict[str, Any] = {
            "bufferView": self.add("bufferViews", view if target is None else {**view, "target": target}),
            "componentType": component,
            "count": count,
            "type": shape,
        }
        if bounds:
            rows = stored.reshape(count, -1)
            accessor |= {"min": rows.min(axis=0).tolist(), "max": rows.max(axis=0).tolist()}
        return self.add("accessors", accessor)

    def packed(self) -> bytes:
        """Return the file."""
        self.json["buffers"] = [{"byteLength": len(self.buffer)}]
        text = json.dumps(self.json, separators=(",", ":"), allow_nan=False).encode()
        text += b" " * (-len(text) % 4)
        data = bytes(self.buffer) + b"\0" * (-len(self.buffer) % 4)
        size = 12 + 8 + len(text) + 8 + len(data)
        parts = [struct.pack("<III", _MAGIC, 2, size), struct.pack("<II", len(text), _JSON), text]
        return b"".join([*parts, struct.pack("<II", len(data), _BIN), data])


class _Writer:
    """Builder of the file of one scene."""

    def __init__(self, scene: Scene) -> None:
        self.scene, self.document = scene, _Document()
        self.materials: dict[tuple[str, bool], int] = {}
        self.cylinders: dict[str, int] = {}
        self.nodes: list[int] = []
        self.channels: list[dict[str, Any]] = []
        self.samplers: list[dict[str, Any]] = []
        self.animated = len(scene.time) > 1
        self.time = -1

    def write(self) -> bytes:
        scene, document = self.scene, self.document
        document.json["asset"] = {"version": "2.0", "generator": "forficula"}
        if self.animated:
            self.time = document.array(scene.time - scene.time[0], "SCALAR", bounds=True)
        on_bodies = rigid_bodies(scene)
        for body in on_bodies:
            self._add_body(body)
        self._add_sheets(on_bodies)
        self._add_rods([rod for rod in scene.rods if self._body_of(rod, on_bodies) is None])
        self._add_balls()
        self._add_base()
        # the record's z is up, that of glTF is y
        turn = [-(0.5**0.5), 0.0, 0.0, 0.5**0.5]
        root = document.add("nodes", {"name": scene.name, "rotation": turn, "children": self.nodes})
        document.json |= {"scene": 0, "scenes": [{"name": scene.name, "nodes": [root]}]}
        if self.channels:
            motion = {"name": "motion", "channels": self.channels, "samplers": self.samplers}
            document.json["animations"] = [motion]
        return document.packed()

    def _body_of(self, rod: SceneRod, bodies: Sequence[int]) -> int | None:
        """Return the rigid body on whose faces a line lies; None for bars, tendons and lines on sheets."""
        one, other = self.scene.bodies[list(rod.ends)].tolist()
        return one if one == other and one in bodies and rod.kind not in ("bar", "tendon") else None

    def _material(self, colour: str, *, sheet: bool) -> int:
        key = (colour, sheet)
        if key not in self.materials:
            shade: dict[str, Any] = {
                "name": f"{'sheet' if sheet else 'rod'} {colour}",
                "pbrMetallicRoughness": {
                    "baseColorFactor": [*linear_colour(colour), 1.0],
                    "metallicFactor": 0.0,
                    "roughnessFactor": 0.8 if sheet else 0.5,
                },
            }
            self.materials[key] = self.document.add("materials", {**shade, "doubleSided": True} if sheet else shade)
        return self.materials[key]

    def _node(self, node: dict[str, Any], paths: dict[str, tuple[Array, str]]) -> None:
        """Add a node with its values over time, (frame, ...), by animated property; constant ones are not animated."""
        for path, (values, _) in paths.items():
            node[path] = values[0].tolist()
        number = self.document.add("nodes", node)
        self.nodes.append(number)
        for path, (values, shape) in paths.items():
            stored = values.astype(np.float32)
            if self.animated and (stored != stored[0]).any():
                # weights of all targets follow one another
                output = self.document.array(values.ravel() if shape == "SCALAR" else values, shape)
                self.samplers.append({"input": self.time, "output": output, "interpolation": "LINEAR"})
                target = {"node": number, "path": path}
                self.channels.append({"sampler": len(self.samplers) - 1, "target": target})

    def _faces(self, places: Array, triangles: Indices, colour: str) -> dict[str, Any]:
        """Return a primitive without normals, which viewers shade flat."""
        return {
            "attributes": {"POSITION": self.document.array(places, "VEC3", target=_VERTICES, bounds=True)},
            "indices": self.document.array(triangles.ravel(), "SCALAR", target=_INDICES),
            "material": self._material(colour, sheet=True),
        }

    def _add_body(self, body: int) -> None:
        """Add a rigid body: its faces, and the lines on them, in axes that move with it."""
        scene = self.scene
        moving = np.flatnonzero(scene.bodies == body)
        rotations, centres, local = _rigid_motion(scene.vertices[:, moving])
        places = np.zeros((len(scene.bodies), 3))
        places[moving] = local
        primitives = []
        for region in scene.regions:
            chosen = region.triangles[(scene.bodies[region.triangles] == body).all(axis=1)]
            if len(chosen):
                used, corners = np.unique(chosen, return_inverse=True)
                primitives.append(self._faces(places[used], corners.reshape(-1, 3), region.colour))
        lines = [rod for rod in scene.rods if self._body_of(rod, [body]) is not None]
        for colour in dict.fromkeys(rod.colour for rod in lines):
            chosen = [rod for rod in lines if rod.colour == colour]
            ends = places[np.array([rod.ends for rod in chosen])]
            primitives.append(self._tubes(ends, np.array([rod.radius for rod in chosen]), colour))
        mesh = self.document.add("meshes", {"name": f"body {body}", "primitives": primitives})
        paths = {"translation": (centres, "VEC3"), "rotation": (rotations, "VEC4")}
        self._node({"name": f"body {body}", "mesh": mesh}, paths)

    def _tubes(self, ends: Array, radii: Array, colour: str) -> dict[str, Any]:
        """Return a primitive of round rods, from their ends, m, (rod, end, 3)."""
        places, normals, triangles = tubes(ends, radii)
        return {
            "attributes": {
                "POSITION": self.document.array(places, "VEC3", target=_VERTICES, bounds=True),
                "NORMAL": self.document.array(normals, "VEC3", target=_VERTICES),
            },
            "indices": self.document.array(triangles.ravel(), "SCALAR", target=_INDICES),
            "material": self._material(colour, sheet=False),
        }

    def _add_sheets(self, on_bodies: Sequence[int]) -> None:
        """Add the faces between bodies: a mesh whose shapes are sums of few morph targets."""
        scene, chosen = self.scene, []
        for region in scene.regions:
            bodies = scene.bodies[region.triangles]
            rigid = (bodies == bodies[:, :1]).all(axis=1) & np.isin(bodies[:, 0], on_bodies)
            chosen.append(region.triangles[~rigid])
        if not any(map(len, chosen)):
            return
        used = np.unique(np.concatenate(chosen))
        weights, targets = morph_targets(scene.vertices[:, used], _PRECISE * scene.span)
        places = scene.vertices[0, used]
        primitives = []
        for region, triangles in zip(scene.regions, chosen, strict=True):
            if len(triangles):
                numbers, corners = np.unique(np.searchsorted(used, triangles), return_inverse=True)
                primitive = self._faces(places[numbers], corners.reshape(-1, 3), region.colour)
                shifts = [
                    {"POSITION": self.document.array(target[numbers], "VEC3", target=_VERTICES, bounds=True)}
                    for target in targets
                ]
                primitives.append({**primitive, "targets": shifts} if shifts else primitive)
        mesh: dict[str, Any] = {"name": "sheet", "primitives": primitives}
        if len(targets):
            mesh["extras"] = {"targetNames": [f"shape {number}" for number in range(1, len(targets) + 1)]}
        paths = {"weights": (weights, "SCALAR")} if len(targets) else {}
        self._node({"name": "sheet", "mesh": self.document.add("meshes", mesh)}, paths)

    def _add_rods(self, rods: Sequence[SceneRod]) -> None:
        """Add rods as nodes that move, turn and stretch one cylinder of length 1 for each colour."""
        if not rods:
            return
        ends = self.scene.vertices[:, np.array([rod.ends for rod in rods])]  # (frame, rod, end, 3)
        lines = ends[:, :, 1] - ends[:, :, 0]
        rotations, lengths = rod_directions(lines, _Y), np.linalg.norm(lines, axis=-1)
        radii = np.broadcast_to([rod.radius for rod in rods], lengths.shape)
        scales = np.stack([radii, lengths, radii], axis=-1)
        # a rigid bar keeps its length, up to rounding
        rigid = np.ptp(lengths, axis=0) <= 1e-9 * self.scene.span
        scales[:, rigid] = scales[0, rigid]
        for number, rod in enumerate(rods):
            self._node(
                {"name": f"{rod.kind} {number}", "mesh": self._cylinder(rod.colour)},
                {
                    "translation": (ends[:, number, 0], "VEC3"),
                    "rotation": (rotations[:, number], "VEC4"),
                    "scale": (scales[:, number], "VEC3"),
                },
            )

    def _cylinder(self, colour: str) -> int:
        if colour not in self.cylinders:
            primitive = self._tubes(np.array([[[0.0, 0.0, 0.0], _Y]]), np.ones(1), colour)
            self.cylinders[colour] = self.document.add("meshes", {"name": f"rod {colour}", "primitives": [primitive]})
        return self.cylinders[colour]

    def _add_balls(self) -> None:
        scene = self.scene
        if not len(scene.balls):
            return
        places, triangles = ball()
        primitive = {
            "attributes": {
                "POSITION": self.document.array(scene.ball_radius * places, "VEC3", target=_VERTICES, bounds=True),
                "NORMAL": self.document.array(places, "VEC3", target=_VERTICES),
            },
            "indices": self.document.array(triangles.ravel(), "SCALAR", target=_INDICES),
            "material": self._material(JOINT, sheet=False),
        }
        mesh = self.document.add("meshes", {"name": "joint", "primitives": [primitive]})
        for number, vertex in enumerate(scene.balls.tolist()):
            paths = {"translation": (scene.vertices[:, vertex], "VEC3")}
            self._node({"name": f"joint {number}", "mesh": mesh}, paths)

    def _add_base(self) -> None:
        base = self.scene.base
        if len(base):
            primitive = self._tubes(base, np.full(len(base), self.scene.base_radius), BASE)
            mesh = self.document.add("meshes", {"name": "fixed", "primitives": [primitive]})
            self._node({"name": "fixed", "mesh": mesh}, {})


def gltf_bytes(scene: Scene) -> bytes:
    """Return a scene as a .glb file: metres, y up, in real time; one frame is a scene without animation.

    Rigid bodies, bars, tendons and lines are nodes whose translation, rotation and scale are animated. Faces between
    bodies are one mesh with morph targets. Tendons are straight, also where they are slack.
    """
    return _Writer(scene).write()


def linear_colour(colour: str) -> list[float]:
    """Return a colour such as "#50565d" as linear red, green and blue, from 0 to 1 (IEC 61966-2-1)."""
    shares = [int(colour[start : start + 2], 16) / 255 for start in (1, 3, 5)]
    return [share / 12.92 if share <= 0.04045 else ((share + 0.055) / 1.055) ** 2.4 for share in shares]


def tubes(ends: Array, radii: Array) -> tuple[Array, Array, Indices]:
    """Return closed cylinders: positions, m, and normals, (vertex, 3), and triangles.

    Args:
        ends: m, (rod, end, 3).
        radii: m, (rod,).
    """
    places, normals, triangles = cylinder(_SIDES)
    lines = ends[:, 1] - ends[:, 0]
    turns = rod_directions(lines[np.newaxis], _Y)[0][:, np.newaxis]
    lengths = np.linalg.norm(lines, axis=-1)
    sizes = np.stack([radii, lengths, radii], axis=-1)[:, np.newaxis]
    drawn = ends[:, :1] + turned(turns, places * sizes)
    numbers = triangles + len(places) * np.arange(len(ends))[:, np.newaxis, np.newaxis]
    return (
        drawn.reshape(-1, 3),
        turned(turns, np.broadcast_to(normals, drawn.shape)).reshape(-1, 3),
        numbers.reshape(-1, 3),
    )


def morph_targets(places: Array, tolerance: float) -> tuple[Array, Array]:
    """Return the shapes of a mesh over time as sums of few displacements from the first, by singular values.

    Args:
        places: positions, m, (frame, vertex, 3).
        tolerance: largest error of a coordinate, m.

    Returns:
        Weights, (frame, target), at most 1 in size, and displacements, m, (target, vertex, 3).
    """
    shifts = (places - places[0]).reshape(len(places), -1)
    left, sizes, right = np.linalg.svd(shifts, full_matrices=False)
    weights = left * sizes
    count, error = 0, shifts.copy()
    while count < len(sizes) and np.abs(error).max(initial=0.0) > tolerance:
        error -= np.outer(weights[:, count], right[count])
        count += 1
    weights, right = weights[:, :count] - weights[:1, :count], right[:count]
    largest = np.abs(weights).max(axis=0, initial=0.0)
    largest[largest == 0] = 1.0
    return weights / largest, (largest[:, np.newaxis] * right).reshape(count, *places.shape[1:])


def _rigid_motion(places: Array) -> tuple[Array, Array, Array]:
    """Return the motion of a rigid body from that of its points.

    Args:
        places: positions, m, (frame, point, 3).

    Returns:
        Rotations from the first frame, x, y, z, w, (frame, 4); positions of the centre, m, (frame, 3); and the points
        from the centre in the first frame, m, (point, 3).
    """
    centres = places.mean(axis=1)
    arms = places - centres[:, np.newaxis]
    # Kabsch 1976: the rotation with the least squared distances
    first, _, last = np.linalg.svd(np.einsum("fpi,pj->fij", arms, arms[0]))
    signs = np.ones((len(places), 3))
    signs[:, 2] = np.linalg.det(first) * np.linalg.det(last)
    matrices = (first * signs[:, np.newaxis]) @ last
    return same_sign(Rotation.from_matrix(matrices).as_quat()), centres, arms[0]
