"""Meshes as binary STL."""

from __future__ import annotations

import struct

import numpy as np

from forficula.make.mesh import Mesh
from forficula.pattern.geometry import triangle_normals

_TRIANGLE = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])
_HEADER = 80  # bytes


def stl_bytes(mesh: Mesh, name: str) -> bytes:
    """A mesh as binary STL, which says nothing of units: every slicer takes them for mm.

    Args:
        mesh: mm.
        name: for the header; it must not begin with "solid", by which readers know STL in text.
    """
    triangles = np.zeros(len(mesh.triangles), dtype=_TRIANGLE)
    corners = mesh.points[mesh.triangles].astype("<f4")
    normals = triangle_normals(corners)
    lengths = np.linalg.norm(normals, axis=1, keepdims=True)
    # a triangle without area has none
    triangles["normal"] = np.divide(normals, lengths, out=np.zeros_like(normals), where=lengths > 0)
    triangles["corners"] = corners
    header = f"forficula, mm: {name}".encode("ascii", "replace")[:_HEADER].ljust(_HEADER)
    return b"".join([header, struct.pack("<I", len(triangles)), triangles.tobytes()])
