"""What a person should know of a structure that can be built all the same."""

from __future__ import annotations

from forficula.design import Design, design_warnings
from forficula.structure.structure import Structure


def structure_warnings(design: Design, structure: Structure) -> list[str]:  # noqa: ARG001
    """What a person should know of a structure that can be built all the same, one sentence each."""
    return design_warnings(design)
