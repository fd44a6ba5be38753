"""Short texts that describe the requirement of a fact."""

from __future__ import annotations

from forficula.goals.identify.fact import PLACES, Fact, Term
from forficula.names import listed
from forficula.quantities import Unit, reading_unit


def requirement_text(fact: Fact) -> str:
    """Return the requirement, such as "32 within 2", "none", "least at tendon.rest_length 7 cm or 8 cm"."""
    term, within = fact.term, f" within {value_text(fact.tolerance, fact.term.unit)}" if fact.tolerance else ""
    if term.statistic in PLACES:
        positions = [f"{key} {listed(map(str, values), 'or')}" for key, values in fact.places.items()]
        return f"{term.statistic} {listed(positions)}{within}"
    if term.statistic in ("all", "none", "any"):
        return f"{term.statistic}{within}"
    bound = quantity_text(fact.bound) if isinstance(fact.bound, Term) else value_text(fact.bound, term.unit)
    return f"{fact.order} {bound}{within}".removeprefix("equals ")


def quantity_text(term: Term) -> str:
    """Return the quantity of a term, such as "2 fold_work"; for a searched value, its key."""
    if not term.quantity:
        assert term.least is not None
        return term.least.key
    parts = [f"{'-' if share < 0 else '+'} {'' if abs(share) == 1 else f'{abs(share):g} '}{part.name}"
             for share, part in term.quantity]  # fmt: skip
    return " ".join(parts).removeprefix("+ ")


def value_text(value: float, unit: Unit | None) -> str:
    """Return a value with its unit, with three digits."""
    if unit is None:
        return f"{value:.3g}"
    if value == 0:
        return f"0 {unit.display}"
    name, factor = reading_unit(unit.si, abs(value))
    return f"{factor * value:.3g} {name}"
