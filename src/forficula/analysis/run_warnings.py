"""Warnings about a run that follow from its record and not from its design alone."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from forficula.analysis.contact_overlap import contact_overlap
from forficula.analysis.crossing_facets import facets_that_cross
from forficula.analysis.crossing_panels import panel_crossing
from forficula.analysis.precision import precision_text
from forficula.analysis.strength import membrane_peaks, strain_peaks
from forficula.analysis.transition_runs import early_goal
from forficula.arrays import Array
from forficula.dynamics import SLIGHT_OVERLAP, Record, energy_balance, resolving_time_constant
from forficula.quantities import show_value
from forficula.structure import goal_of, hinge_bounds

_FAR_FASTER = 100.0  # times the strain rate of the tests: a polymer's modulus can change much over two decades
_LINEAR = 0.2  # true strain up to which membranes count as linearly elastic
_CRUSHED = -0.499  # Green's strain; -0.5 is a length of 0
_TRIFLE = 0.5 / 220  # share of a structure's size: half a millimetre in the reference wing
TARGET = "target"
# number of creases that a sentence names
_NAMED = 4


def run_warnings(record: Record) -> list[str]:
    """Return the warnings about a run, one sentence each."""
    early = [early_goal(record, end) for end in record.stages]
    return [
        *filter(None, (*early, precision_text(record.design))),
        *_missed(record),
        *_overstressed_parts(record),
        *_stretched_membranes(record),
        *_crossing_facets(record),
        *_overlapping_parts(record),
        *_crossing_panels(record),
        *_energy_adding_contacts(record),
        *_fast_tendons(record),
    ]


def _missed(record: Record) -> list[str]:
    """Warn of creases that did not reach their targets."""
    missed = missed_targets(record)
    bounded = np.isfinite(goal_of(record.structure, TARGET).least) if missed else np.zeros(0)
    return [missed_text(missed, int(bounded.sum()))] if missed else []


def _overstressed_parts(record: Record) -> list[str]:
    """Warn of parts whose stress exceeds the strength of their material."""
    if record.structure.strength is None:
        return []
    over = [
        peak for peak in strain_peaks(record) if peak.stress and peak.withstood and abs(peak.stress) > peak.withstood
    ]
    return [
        f"{peak.part} reaches a stress of {abs(peak.stress or 0.0) / 1e6:.3g} MPa at {peak.stressed_at:.3g} s, more"
        f" than the strength of its material, {(peak.withstood or 0.0) / 1e6:.3g} MPa (facet.strength)"
        for peak in over
    ]


def _stretched_membranes(record: Record) -> list[str]:
    """Warn of membranes whose largest strain is beyond linear elasticity; name the one with the largest."""
    # true strain ln(s) of a stretch s, of Green's strain (s^2 - 1) / 2
    strains = {peak: math.log1p(2 * max(peak.strain, _CRUSHED)) / 2 for peak in membrane_peaks(record)}
    beyond = [peak for peak, strain in strains.items() if abs(strain) > _LINEAR]
    if not beyond:
        return []
    most = max(beyond, key=lambda peak: abs(strains[peak]))
    others = f" ({len(beyond)} membranes exceed {100 * _LINEAR:.0f} %)" if len(beyond) > 1 else ""
    return [
        f"membrane {most.part} reaches a true strain of {100 * strains[most]:.3g} %,"
        f" {math.exp(strains[most]):.3g} times its length as built, at {most.time:.3g} s{others}: membranes are"
        f" modelled as linearly elastic, which holds up to about {100 * _LINEAR:.0f} %, so forces and energies of"
        " membranes at larger strains are extrapolated"
    ]


def _crossing_facets(record: Record) -> list[str]:
    """Warn of the first two facets that pass through each other, with the number of further pairs."""
    result = facets_that_cross(record)
    if not result:
        return []
    names, more = " and ".join(result[0].names), len(result) - 1
    others = f", and {more} more pair{'s' * (more > 1)} later" if more else ""
    crossing = f"{names} pass through each other from {result[0].time:.3g} s{others}"
    if record.structure.contact is None:
        return [f"{crossing}: contact is switched off; protocol.contact = true keeps them apart"]
    return [f"{crossing}, which contact should prevent: a shorter contact.time_constant keeps them apart"]


def _overlapping_parts(record: Record) -> list[str]:
    """Warn of parts that touch and overlap by more than a tenth of their thickness."""
    overlap, contact = contact_overlap(record), record.structure.contact
    if overlap is None or contact is None or overlap.largest <= SLIGHT_OVERLAP:
        return []
    names = f" ({' and '.join(overlap.parts)} at {overlap.time:.3g} s)" if overlap.parts else ""
    need = resolving_time_constant(contact, overlap.largest)
    return [
        f"parts that touch overlap by up to {100 * overlap.largest:.2g} % of their thickness{names}: a"
        f" contact.time_constant of {show_value(need, 's')} or shorter reduces this to about"
        f" {100 * SLIGHT_OVERLAP:.0f} %"
    ]


def _crossing_panels(record: Record) -> list[str]:
    """Warn of the two panels that pass furthest through each other, unless the depth is negligible."""
    result = panel_crossing(record)
    if result is None or result.depth <= _TRIFLE * record.structure.span:
        return []
    names, depth = " and ".join(result.names), show_value(result.depth, "m")
    crossing = f"{names} pass through each other by {depth} at {result.time:.3g} s"
    if record.structure.contact is None:
        return [f"{crossing}: contact is switched off; protocol.contact = true keeps panels apart"]
    return [f"{crossing}, more than contact should allow: a shorter timestep reduces the depth"]


def _energy_adding_contacts(record: Record) -> list[str]:
    """Warn of contacts that supplied more energy than may be missing from the balance."""
    if "contact_work" not in record.series or record.diverged_at is not None:
        return []
    balance = energy_balance(record)
    energy = -(balance.contacts or 0.0)
    if not energy > record.design.protocol.residual_limit * balance.exchanged:
        return []
    share = f", {100 * energy / balance.exchanged:.2g} % of the exchanged energy," if balance.exchanged else ""
    return [
        f"contacts supplied {show_value(energy, 'J')}{share} although real contacts only dissipate energy: the timestep"
        " does not resolve them, and the energy balance counts this energy as missing"
    ]


def _fast_tendons(record: Record) -> list[str]:
    """Warn of tendons whose strain rate is far above that of the tests of their material.

    Tendons of one material share a warning, which names them if other tendons have another material.
    """
    tendons, rates = record.structure.tendons, highest_strain_rates(record)
    warnings = []
    for material in dict.fromkeys(tendon.material for tendon in tendons):
        if material is None or material.highest_strain_rate is None:
            continue
        numbers = [number for number, tendon in enumerate(tendons) if tendon.material == material]
        rate = float(np.fmax.reduce(rates[numbers]))
        if not rate > _FAR_FASTER * material.highest_strain_rate:
            continue
        names = "" if len(numbers) == len(tendons) else f"{', '.join(tendons[number].name for number in numbers)}: "
        warnings.append(
            f"{names}taut tendons reach a strain rate of {rate:.3g} 1/s,"
            f" {_rounded(rate / material.highest_strain_rate)} times the {material.highest_strain_rate:.3g} 1/s up to"
            f" which {material.name or 'their law'} was measured: their losses and stiffness are extrapolated"
        )
    return warnings


def highest_strain_rates(record: Record) -> Array:
    """Return the highest rates at which taut tendons lengthen or shorten, 1/s, (tendon,).

    Rates are relative to the gauge length of the law and are taken from one step to the next. A record without these
    rates gives them from one kept row to the next, which underestimates motions that are shorter than a row.

    Returns:
        nan for a tendon that is not taut in two consecutive rows, and for all tendons of a run that diverged.
    """
    tendons = record.structure.tendons
    if record.diverged_at is not None:
        return np.full(len(tendons), np.nan)
    if record.strain_rates is not None:
        return record.strain_rates
    length = record.series["tendon_length"]
    slack = record.series.get("tendon_rest_length", np.array([tendon.law.rest_length for tendon in tendons]))
    taut = length > slack
    spans = np.diff(record.time)[:, None]
    both = taut[1:] & taut[:-1] & (spans > 0)
    speeds = np.divide(np.abs(np.diff(length, axis=0)), spans, out=np.full(both.shape, np.nan), where=both)
    fastest = np.fmax.reduce(speeds, axis=0, initial=np.nan)
    return np.asarray(fastest / [tendon.gauge_length or np.nan for tendon in tendons])


def _rounded(ratio: float) -> str:
    """Return a ratio with two digits and without an exponent."""
    return f"{float(f'{ratio:.2g}'):.0f}"


@dataclass(frozen=True, kw_only=True)
class MissedTarget:
    """A crease that is not at its target.

    Attributes:
        label: name of the crease in sentences.
        angle: reached angle in the crease's own sense, rad.
        target: target angle, rad.
        within: tolerance of the target, rad.
    """

    label: str
    angle: float
    target: float
    within: float


def missed_targets(record: Record) -> list[MissedTarget]:
    """Return creases that were not at their targets when the stage with this goal ended, the furthest first.

    Returns:
        The creases; empty for a run without such a stage, and for one in which the stage reached its goal.
    """
    ends = [end for end in record.stages if end.stage.until == TARGET]
    if not ends or ends[-1].goal_time is not None or record.diverged_at is not None:
        return []
    (lower, upper), hinges = hinge_bounds(record.structure, goal_of(record.structure, TARGET)), record.structure.hinges
    row = max(int(np.searchsorted(record.time, ends[-1].end, side="right")) - 1, 0)
    result = []
    for hinge, angle, least, most in zip(hinges, record.series["hinge_angle"][row], lower, upper, strict=True):
        if not least <= angle <= most:
            target, within = (least + most) / 2, (most - least) / 2
            result.append(
                MissedTarget(label=hinge.label or hinge.name, angle=float(angle), target=target, within=within)
            )
    return sorted(result, key=lambda hinge: -abs(hinge.angle - hinge.target))


def missed_text(missed: list[MissedTarget], creases: int) -> str:
    """Return which creases missed their targets, as a clause.

    Args:
        missed: one or more creases.
        creases: number of creases with a target.
    """
    angles = [
        f"{crease.label} at {np.degrees(crease.angle):.4g} deg instead of {np.degrees(crease.target):.4g} deg"
        for crease in missed[:_NAMED]
    ]
    more = [f"{len(missed) - _NAMED} more"] if len(missed) > _NAMED else []
    return (
        f"{len(missed)} of {creases} creases did not reach their targets within {np.degrees(missed[0].within):.3g} deg:"
        f" {', '.join([*angles, *more])}; at these angles crease springs and the bending and stretching of facets"
        " balance"
    )
