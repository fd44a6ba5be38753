"""The timestep of a design whose tendons have a law that needs a shorter one than its reference has."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

from forficula.terminal import warn

if TYPE_CHECKING:
    from forficula.design import Design


def with_timestep_for_law(design: Design, settings: Mapping[str, object]) -> Design:
    """Return a design with the timestep "auto" where its tendon law does not allow the timestep of its reference.

    A law that was fitted to slow tests may have a viscosity with which the timestep of the reference loses energy or
    diverges. A timestep of --set, or another than that of the reference, is kept.

    Args:
        design: as read.
        settings: values of --set by dotted key.
    """
    from forficula.design import load_design, with_values
    from forficula.dynamics import timestep_warnings

    timestep = design.protocol.timestep
    if timestep == "auto" or design.reference is None or any(key.startswith("protocol.timestep") for key in settings):
        return design
    if timestep != load_design(design.reference).protocol.timestep:
        return design
    if not (_has_law(design.as_tables().get("tendon")) and timestep_warnings(design)):
        return design
    warn(
        f'protocol.timestep: "auto" is used, because the law of the tendons does not allow {1e3 * timestep:.3g} ms, the'
        f" timestep of {design.reference}; --set protocol.timestep=... keeps a timestep"
    )
    return with_values(design, {"protocol.timestep": "auto"})


def _has_law(tables: object) -> bool:
    """Return whether a table of tendons, or a list of such tables, names a law."""
    if isinstance(tables, Mapping):
        return "law" in tables or any(_has_law(table) for table in tables.values())
    return isinstance(tables, list) and any(_has_law(table) for table in tables)
