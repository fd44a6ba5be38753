"""A compiled model for another build of the engine: its source, and every number that was worked out of it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from forficula.arrays import Array, Indices
from forficula.dynamics.engine.model import Model
from forficula.dynamics.stepping.stepper import start_position

# of options: those that are numbers with the same meaning in every version
_OPTIONS = ("timestep", "impratio", "tolerance", "ls_tolerance", "ccd_tolerance", "gravity")
# what only names or draws, and what a search for contacts goes by
_LEFT_OUT = ("name", "names_map", "text_", "bvh_", "geom_rgba", "site_rgba", "tendon_rgba", "flex_rgba", "mesh_")
_DRAWN = ("_matid", "_texid", "_group", "_user", "_dataid", "_rgba")
# kinds of objects, whose numbers go on with the versions
_KINDS = ("_objtype", "_reftype")


@dataclass(frozen=True, kw_only=True)
class PortableModel:
    """What an engine of another version needs to move a structure as this one does.

    Before 4.0 MuJoCo works out another stiffness of membranes of the same source, and text has six digits of a number:
    with all that was worked out here put in its place, both start from the same bits.

    Attributes:
        source: XML, for its layout.
        numbers: of the compiled model, by MuJoCo's names, flat.
        layout: whole numbers of it, alike; an engine that lays it out otherwise must not take the numbers.
        options: numbers of its options, by MuJoCo's names, flat.
        start: positions at the start, (position,).
    """

    source: str
    numbers: Mapping[str, Array]
    layout: Mapping[str, Indices]
    options: Mapping[str, Array]
    start: Array


def portable_model(model: Model) -> PortableModel:
    """Take a compiled model apart for another build of the engine."""
    engine = model.engine
    return PortableModel(
        source=model.xml,
        numbers=model_numbers(model),
        layout={
            name: np.asarray(field, dtype=np.int64).ravel()
            for name, field in _fields(model).items()
            if field.dtype == np.int32
        },
        options={name: np.atleast_1d(np.asarray(getattr(engine.opt, name), dtype=np.float64)) for name in _OPTIONS},
        start=start_position(model),
    )


def model_numbers(model: Model) -> dict[str, Array]:
    """The numbers of a compiled model that are not whole, by MuJoCo's names, flat."""
    return {
        name: np.array(field, dtype=np.float64).ravel()
        for name, field in _fields(model).items()
        if field.dtype == np.float64
    }


def why_not_portable(model: Model) -> str:
    """Why an older engine, alone, does not move a structure as this one does, as a clause; empty where it does."""
    if model.creases is not None:
        return "its creases are no joints, which engines before MuJoCo 4.0 do not take"
    if model.drag is not None:
        return "it moves in air or water, whose drag is set anew between steps"
    if (model.creep >= 0).any():
        return "its tendons yield, which only MuJoCo 4.0 knows"
    if model.structure.contact is not None:
        return "its parts touch, which older engines find otherwise"
    if (model.holds >= 0).any():
        return "a drive displaces points"
    if any(stage.wait for stage in model.design.protocol.stages):
        return "a stage waits for longer than it is stepped"
    return ""


def _fields(model: Model) -> dict[str, NDArray[np.generic]]:
    """The fields of a compiled model that are arrays of numbers and say how it moves."""
    found = {}
    for name in dir(model.engine):
        if name.startswith(("_", *_LEFT_OUT)) or name.endswith(_DRAWN + _KINDS):
            continue
        field = getattr(model.engine, name)
        if isinstance(field, np.ndarray) and field.size:
            found[name] = field
    return found
