"""A compiled model for another version of the engine: its source, and every number that was computed from it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from forficula.arrays import Array, Indices
from forficula.dynamics.engine.model import Model
from forficula.dynamics.stepping.start_states import start_position

# numerical options with the same meaning in every version
_OPTIONS = ("timestep", "impratio", "tolerance", "ls_tolerance", "ccd_tolerance", "gravity")
# fields for names and drawing, and for the search for contacts
_LEFT_OUT = ("name", "names_map", "text_", "bvh_", "geom_rgba", "site_rgba", "tendon_rgba", "flex_rgba", "mesh_")
_DRAWN = ("_matid", "_texid", "_group", "_user", "_dataid", "_rgba")
# kinds of objects, whose numbers differ between versions
_KINDS = ("_objtype", "_reftype")


@dataclass(frozen=True, kw_only=True)
class PortableModel:
    """Data with which an engine of another version moves a structure in the same way.

    MuJoCo before 4.0 computes another stiffness of membranes from the same source, and the text of a source has only
    six digits. If all computed numbers are replaced, both engines start from the same bits.

    Attributes:
        source: XML, for its layout.
        numbers: of the compiled model, by MuJoCo's names, flat.
        layout: integers of the compiled model, by MuJoCo's names, flat; an engine with another layout must not use the
            numbers.
        options: numerical options, by MuJoCo's names, flat.
        start: positions at the start, (position,).
    """

    source: str
    numbers: Mapping[str, Array]
    layout: Mapping[str, Indices]
    options: Mapping[str, Array]
    start: Array


def portable_model(model: Model) -> PortableModel:
    """Return the data of a compiled model for another version of the engine."""
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
    """Return the floating-point numbers of a compiled model, by MuJoCo's names, flat."""
    return {
        name: np.array(field, dtype=np.float64).ravel()
        for name, field in _fields(model).items()
        if field.dtype == np.float64
    }


def why_not_portable(model: Model) -> str:
    """Return why an older engine alone moves a structure differently, as a clause; empty if it does not."""
    if model.creases is not None and (model.creases.joints >= 0).any():
        return "its creases remember how they were turned, which is computed outside the engine"
    if model.creases is not None:
        return "its creases are not joints, which engines before MuJoCo 4.0 do not support"
    if model.drag is not None:
        return "it moves in air or water, whose drag is computed outside the engine"
    if (model.creep >= 0).any():
        return "its tendons yield, which only MuJoCo 4.0 supports"
    if (model.hinge_creep >= 0).any():
        return "its joints yield, which only MuJoCo 4.0 supports"
    if model.structure.has_contacts:
        return "its parts touch each other or a table, and older engines compute contacts differently"
    if (model.holds >= 0).any():
        return "a drive displaces points"
    if model.pushed_bodies is not None:
        return "a force acts on a body that turns, and a page does not compute its work"
    if any(stage.wait for stage in model.design.protocol.stages):
        return "a stage waits without being stepped"
    if any(stage.quasi_static for stage in model.design.protocol.stages):
        return "a quasi-static stage is computed by statics"
    return ""


def _fields(model: Model) -> dict[str, NDArray[np.generic]]:
    """Return the numerical fields of a compiled model that affect its motion."""
    result = {}
    for name in dir(model.engine):
        if name.startswith(("_", *_LEFT_OUT)) or name.endswith(_DRAWN + _KINDS):
            continue
        field = getattr(model.engine, name)
        if isinstance(field, np.ndarray) and field.size:
            result[name] = field
    return result
