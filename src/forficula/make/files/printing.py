"""Files for printers: 3MF and binary STL."""

from __future__ import annotations

import struct
from collections.abc import Callable

import numpy as np

from forficula.make.files.print_orientation import file_names, print_mesh, printed_pieces
from forficula.make.files.three_mf import Item, three_mf_bytes
from forficula.make.part import PartSet
from forficula.make.solid.mesh import Mesh
from forficula.pattern.geometry import triangle_normals

_TRIANGLE = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])
_HEADER = 80  # bytes


def print_files(parts: PartSet, progress: Callable[[str], None] = lambda _: None) -> dict[str, bytes]:
    """Return all printed pieces as STL, one file each, and as one 3MF file, by file path; empty without pieces.

    Args:
        parts: parts of a design.
        progress: called with a text for each file.

    >>> list(print_files(ff.make.parts("binder2025-joint")))
    ['stl/proximal0.stl', 'stl/distal0.stl', 'stl/strap0.stl', 'parts.3mf']
    """
    pieces, items = printed_pieces(parts), []
    files: dict[str, bytes] = {}
    for piece, name in zip(pieces, file_names([piece.name for piece in pieces]), strict=True):
        progress(f"writing {name}.stl")
        mesh = print_mesh(*piece.parts)
        items.append(Item(name=piece.name, material=piece.material, mesh=mesh, count=piece.count))
        files[f"stl/{name}.stl"] = stl_bytes(mesh, piece.name)
    if items:
        progress("writing parts.3mf")
        files["parts.3mf"] = three_mf_bytes(items, parts.design.name)
    return files


def stl_bytes(mesh: Mesh, name: str) -> bytes:
    """Return a mesh as binary STL, which has no units: every slicer assumes mm.

    Args:
        mesh: mm.
        name: for the header; it must not begin with "solid", which marks STL in text form.
    """
    triangles = np.zeros(len(mesh.triangles), dtype=_TRIANGLE)
    corners = mesh.points[mesh.triangles].astype("<f4")
    normals = triangle_normals(corners)
    lengths = np.linalg.norm(normals, axis=1, keepdims=True)
    # a triangle without area has no normal
    triangles["normal"] = np.divide(normals, lengths, out=np.zeros_like(normals), where=lengths > 0)
    triangles["corners"] = corners
    header = f"forficula, mm: {name}".encode("ascii", "replace")[:_HEADER].ljust(_HEADER)
    return b"".join([header, struct.pack("<I", len(triangles)), triangles.tobytes()])
