"""What goes to a printer."""

from __future__ import annotations

from collections.abc import Callable

from forficula.make.files.lying import file_names, lying_mesh, printed_pieces
from forficula.make.files.stl import stl_bytes
from forficula.make.files.three_mf import Item, three_mf_bytes
from forficula.make.part import PartSet


def print_files(parts: PartSet, progress: Callable[[str], None] = lambda _: None) -> dict[str, bytes]:
    """All printed pieces as STL, one file each, and as one 3MF file, by the places of the files; none without pieces.

    Args:
        parts: of a design.
        progress: is told which file is made.

    >>> list(print_files(ff.make_parts("binder2025-joint")))
    ['stl/proximal0.stl', 'stl/distal0.stl', 'stl/strap0.stl', 'parts.3mf']
    """
    pieces, items = printed_pieces(parts), []
    files: dict[str, bytes] = {}
    for piece, name in zip(pieces, file_names([piece.name for piece in pieces]), strict=True):
        progress(f"writing {name}.stl")
        mesh = lying_mesh(*piece.parts)
        items.append(Item(name=piece.name, material=piece.material, mesh=mesh, count=piece.count))
        files[f"stl/{name}.stl"] = stl_bytes(mesh, piece.name)
    if items:
        progress("writing parts.3mf")
        files["parts.3mf"] = three_mf_bytes(items, parts.design.name)
    return files
