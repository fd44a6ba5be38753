"""Families of laws by their common names."""

from __future__ import annotations

from forficula.errors import InputError
from forficula.material.law.law_form import LawForm, all_forms
from forficula.material.law.law_keys import nearest

FAMILIES = {
    "linear": "a linear spring",
    "polynomial": "a spring of second or third order",
    "kelvin-voigt": "a spring and a damper side by side",
    "zener": "a spring and one Maxwell branch",
    "prony": "a spring and two Maxwell branches, or more if the data distinguish them",
    "softening": "a spring that softens below the largest previous strain (Ogden-Roxburgh), with or without a branch",
}


def family_forms(name: str) -> tuple[LawForm, ...]:
    """Return the forms of a family, with and, except for softening, without a permanent set.

    Args:
        name: one of `FAMILIES`.

    Raises:
        InputError: there is no such family.
    """
    forms = tuple(form for form in all_forms() if _family(form) == name)
    if not forms:
        raise InputError(f'need a law such as "zener", got "{name}"; {nearest(name, list(FAMILIES))}')
    return forms


def _family(form: LawForm) -> str:
    """Return the family of a form; "" if it has no common name."""
    if form.softening != "none":
        return "softening"
    if form.branches:
        return "" if form.damper else ("zener" if form.branches == 1 else "prony")
    if form.damper:
        return "kelvin-voigt"
    return "linear" if form.order == 1 else "polynomial"
