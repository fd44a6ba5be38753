"""Animated USD as text (.usda; Pixar, Universal Scene Description): meshes of faces and curves with a width.

The library of USD takes 80 MB, and the text of moving points is short.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

import numpy as np

from forficula.arrays import Array
from forficula.show.export.gltf import linear_colour
from forficula.show.export.scene import BASE, JOINT, Scene

_CODES = 1000  # time codes per second: a code is 1 ms


def usd_text(scene: Scene) -> str:
    """Return a scene as USD text: m, z up, in real time with time codes in ms; one frame is a scene without motion."""
    return "\n".join(_lines(scene)) + "\n"


def _lines(scene: Scene) -> Iterator[str]:
    codes = _CODES * (scene.time - scene.time[0])
    yield "#usda 1.0"
    yield '(\n    defaultPrim = "forficula"\n    metersPerUnit = 1\n    upAxis = "Z"'
    yield f"    timeCodesPerSecond = {_CODES}\n    startTimeCode = 0\n    endTimeCode = {_number(codes[-1])}\n)"
    yield 'def Xform "forficula"\n{'
    for number, region in enumerate(scene.regions):
        used, corners = np.unique(region.triangles, return_inverse=True)
        yield f'    def Mesh "region_{number}"\n    {{'
        yield '        uniform token subdivisionScheme = "none"\n        uniform bool doubleSided = 1'
        yield f"        int[] faceVertexCounts = [{', '.join(['3'] * len(region.triangles))}]"
        yield f"        int[] faceVertexIndices = [{', '.join(map(str, corners.ravel().tolist()))}]"
        yield from _points(codes, scene.vertices[:, used])
        yield from _colour(region.colour)
        yield "    }"
    for number, (kind, colour) in enumerate(dict.fromkeys((rod.kind, rod.colour) for rod in scene.rods)):
        rods = [rod for rod in scene.rods if (rod.kind, rod.colour) == (kind, colour)]
        ends = [end for rod in rods for end in rod.ends]
        widths = [2 * rod.radius for rod in rods]
        yield from _curves(f"{kind}_{number}", codes, scene.vertices[:, ends], widths, colour)
    if len(scene.balls):
        yield '    def Points "joints"\n    {'
        yield from _points(codes, scene.vertices[:, scene.balls])
        yield f"        float[] widths = [{', '.join([_number(2 * scene.ball_radius)] * len(scene.balls))}]"
        yield from _colour(JOINT)
        yield "    }"
    if len(scene.base):
        widths = [2 * scene.base_radius] * len(scene.base)
        yield from _curves("fixed", codes, scene.base.reshape(1, -1, 3), widths, BASE)
    yield "}"


def _curves(name: str, codes: Array, places: Array, widths: Sequence[float], colour: str) -> Iterator[str]:
    """Yield straight curves of two points each."""
    yield f'    def BasisCurves "{name}"\n    {{'
    yield f'        uniform token type = "linear"\n        int[] curveVertexCounts = [{", ".join(["2"] * len(widths))}]'
    yield from _points(codes, places)
    yield f'        float[] widths = [{", ".join(map(_number, widths))}] (interpolation = "uniform")'
    yield from _colour(colour)
    yield "    }"


def _points(codes: Array, places: Array) -> Iterator[str]:
    """Yield positions over time, (frame, point, 3), or the only ones."""
    low, high = places.min(axis=(0, 1)), places.max(axis=(0, 1))
    yield f"        float3[] extent = [{_tuple(low)}, {_tuple(high)}]"
    if (places == places[0]).all():
        yield f"        point3f[] points = [{_tuples(places[0])}]"
        return
    yield "        point3f[] points.timeSamples = {"
    for code, frame in zip(codes.tolist(), places, strict=True):
        yield f"            {_number(code)}: [{_tuples(frame)}],"
    yield "        }"


def _colour(colour: str) -> Iterator[str]:
    yield f"        color3f[] primvars:displayColor = [{_tuple(linear_colour(colour))}]"


def _tuples(places: Array) -> str:
    return ", ".join(map(_tuple, places))


def _tuple(place: Iterable[float]) -> str:
    return f"({', '.join(map(_number, place))})"


def _number(value: float) -> str:
    return f"{float(value):.9g}"
