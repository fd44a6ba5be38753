"""The timestep of a design whose tendons or creases have a law that needs a shorter one than its reference has."""

from __future__ import annotations

import warnings
from collections.abc import Mapping

from forficula.design import Design, is_timestep_set, load_design, with_values
from forficula.dynamics import timestep_warnings
from forficula.structure import structure_of

_TERMS = ("branches", "quadratic_stiffness", "cubic_stiffness")


def with_timestep_for_law(design: Design) -> Design:
    """Return a design with the timestep "auto", and warn, where a law needs it; see `law_timestep`."""
    changed, warning = law_timestep(design)
    if warning:
        warnings.warn(warning, UserWarning, stacklevel=2)
    return changed


def law_timestep(design: Design) -> tuple[Design, str]:
    """Return a design with the timestep "auto" where a law of it does not allow the timestep of its reference.

    A law of tendons that was fitted to slow tests may have a viscosity, or Maxwell branches, with which the timestep of
    the reference loses energy or diverges. So may Maxwell branches or nonlinear terms of creases. A timestep that was
    set, or another than that of the reference, is kept.

    Returns:
        The design and a warning; the same design and an empty text where its timestep is kept.
    """
    # the limit of the timestep takes longer to compute than the structure
    if not (may_change_timestep(design) and timestep_warnings(design)):
        return design, ""
    timestep = float(design.protocol.timestep)
    return with_values(design, {"protocol.timestep": "auto"}), (
        f'protocol.timestep: "auto" is used, because the {_which(design)} does not allow'
        f" {1e3 * timestep:.3g} ms, the timestep of {design.reference}; a value for protocol.timestep among the"
        " settings is kept"
    )


def may_change_timestep(design: Design) -> bool:
    """Return whether the law of a tendon or a crease may not allow the timestep of the reference of a design."""
    timestep = design.protocol.timestep
    if timestep == "auto" or design.reference is None or is_timestep_set(design):
        return False
    if timestep != load_design(design.reference).protocol.timestep:
        return False
    tables = design.si_tables()
    if _has_terms(tables.get("crease")):
        return True
    return _has_law(tables.get("tendon")) and any(
        any(tendon.law.damping or ()) or tendon.law.branches for tendon in structure_of(design).tendons
    )


def _which(design: Design) -> str:
    """Return which law may not allow the timestep."""
    return "law of the creases" if _has_terms(design.si_tables().get("crease")) else "viscous law of the tendons"


def _has_terms(tables: object) -> bool:
    """Return whether the section of creases, or a group in it, has Maxwell branches or nonlinear terms."""
    if isinstance(tables, Mapping):
        return any(tables.get(key) for key in _TERMS) or _has_terms(tables.get("group"))
    return isinstance(tables, list) and any(_has_terms(table) for table in tables)


def _has_law(tables: object) -> bool:
    """Return whether a table of tendons, or a list of such tables, names a law."""
    if isinstance(tables, Mapping):
        return "law" in tables or any(_has_law(table) for table in tables.values())
    return isinstance(tables, list) and any(_has_law(table) for table in tables)
