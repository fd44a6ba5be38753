"""What is checked of the mesh of a part, which its files have."""

from __future__ import annotations

from collections.abc import Iterator

from forficula.make.check import Check
from forficula.make.files.lying import lying_mesh, open_edges
from forficula.make.part import Part


def mesh_checks(part: Part) -> Iterator[Check]:
    """Whether a part is one piece, with a surface that is closed."""
    pieces, gaps = len(part.shape.decompose()), open_edges(lying_mesh(part))
    fall = f"{part.name} falls into {pieces} pieces; look for a length of [make] that is too small for its neighbours"
    yield Check(
        name="one piece",
        part=part.name,
        ok=pieces == 1,
        value=pieces,
        limit=1,
        unit="",
        text=f"{part.name} is one piece" if pieces == 1 else fall,
    )
    torn = f"the surface of {part.name} is open at {gaps} edges, which slicers mend as they like; report it"
    yield Check(
        name="closed surface",
        part=part.name,
        ok=gaps == 0,
        value=gaps,
        limit=0,
        unit="",
        text=torn if gaps else f"the surface of {part.name} is closed",
    )
