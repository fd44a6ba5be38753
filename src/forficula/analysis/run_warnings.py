"""What a person should know of a run that only the run itself tells."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from forficula.analysis.crossing_facets import facets_that_cross
from forficula.analysis.crossing_panels import panel_crossing
from forficula.analysis.outcome import early_goal
from forficula.analysis.strength import membrane_peaks, strain_peaks
from forficula.arrays import Array
from forficula.dynamics import Record, energy_balance
from forficula.quantities import show_value
from forficula.structure import goal_of, hinge_bounds

_FAR_FASTER = 100.0  # than the tests of a material: two decades, over which a polymer's modulus can change much
_LINEAR = 0.2  # true strain up to which membranes count as linearly elastic
_CRUSHED = -0.499  # Green's strain; -0.5 is a length of 0
_TRIFLE = 0.5 / 220  # of a structure's size: half a millimetre of the reference wing
TARGET = "target"
# that a sentence names
_NAMED = 4


def run_warnings(record: Record) -> list[str]:
    """What a person should know of a run that only the run itself tells, one sentence each."""
    early = [early_goal(record, end) for end in record.stages]
    return [
        *filter(None, early),
        *_missed(record),
        *_broken(record),
        *_stretched_membranes(record),
        *_crossing_facets(record),
        *_crossing_panels(record),
        *_giving_contacts(record),
        *_fast_tendons(record),
    ]


def _missed(record: Record) -> list[str]:
    """Of creases that were to go to their targets and are not there."""
    missed = missed_targets(record)
    bounded = np.isfinite(goal_of(record.structure, TARGET).least) if missed else np.zeros(0)
    return [missed_text(missed, int(bounded.sum()))] if missed else []


def _broken(record: Record) -> list[str]:
    """Of parts that bear more than their material withstands."""
    if record.structure.strength is None:
        return []
    over = [
        peak for peak in strain_peaks(record) if peak.stress and peak.withstood and abs(peak.stress) > peak.withstood
    ]
    return [
        f"{peak.part} bears {abs(peak.stress or 0.0) / 1e6:.3g} MPa at {peak.stressed_at:.3g} s, more than the"
        f" {(peak.withstood or 0.0) / 1e6:.3g} MPa that its material withstands (facet.strength)"
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
    """Of the facets that are the first to pass through each other, and how many others do."""
    found = facets_that_cross(record)
    if not found:
        return []
    names, more = " and ".join(found[0].names), len(found) - 1
    others = f", and {more} more pair{'s' * (more > 1)} later" if more else ""
    kind = "plates" if record.structure.plates else "facets"
    return [f"{names} pass through each other from {found[0].time:.3g} s{others}: {kind} do not touch each other"]


def _crossing_panels(record: Record) -> list[str]:
    """Of the panels that pass furthest through each other, where that is more than a trifle."""
    found = panel_crossing(record)
    if found is None or found.depth <= _TRIFLE * record.structure.span:
        return []
    told = (
        f"{' and '.join(found.names)} pass through each other by {show_value(found.depth, 'm')} at {found.time:.3g} s"
    )
    if record.structure.contact is None:
        return [f"{told}: nothing keeps them apart, which protocol.contact = true does"]
    return [f"{told}, more than contact should let through: with a shorter timestep it holds better"]


def _giving_contacts(record: Record) -> list[str]:
    """Of contacts that gave more energy than may be missing from a balance."""
    if "contact_work" not in record.series or record.diverged_at is not None:
        return []
    balance = energy_balance(record)
    given = -(balance.contacts or 0.0)
    if not given > record.design.protocol.residual_limit * balance.exchanged:
        return []
    share = f"{100 * given / balance.exchanged:.2g} % of what was exchanged" if balance.exchanged else "from nothing"
    return [
        f"contacts gave {show_value(given, 'J')}, {share}, but real contacts only take energy: the timestep does not"
        " resolve them, and this energy counts as missing"
    ]


def _fast_tendons(record: Record) -> list[str]:
    """Of tendons that move far faster than the tests of their material.

    Those of one material count together; they are named where others are of another one.
    """
    tendons, rates = record.structure.tendons, highest_strain_rates(record)
    told = []
    for material in dict.fromkeys(tendon.material for tendon in tendons):
        if material is None or material.highest_strain_rate is None:
            continue
        own = [number for number, tendon in enumerate(tendons) if tendon.material == material]
        rate = float(np.fmax.reduce(rates[own]))
        if not rate > _FAR_FASTER * material.highest_strain_rate:
            continue
        names = "" if len(own) == len(tendons) else f"{', '.join(tendons[number].name for number in own)}: "
        told.append(
            f"{names}taut tendons move at up to {rate:.3g} 1/s, {_rounded(rate / material.highest_strain_rate)} times"
            f" the {material.highest_strain_rate:.3g} 1/s up to which {material.name or 'their law'} was measured: what"
            " it says of losses and stiffness so fast is extrapolated"
        )
    return told


def highest_strain_rates(record: Record) -> Array:
    """The highest rates at which taut tendons are strained or let go, 1/s, (tendon,).

    By the length that a law counts strain by, from one step to the next; of a record that does not say so, from one
    kept row to the next, which shows less where rows are further apart than a move.

    Returns:
        nan for a tendon that is not taut over two rows, and for all of a run that diverged.
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
    """To two digits, without an exponent."""
    return f"{float(f'{ratio:.2g}'):.0f}"


@dataclass(frozen=True, kw_only=True)
class Missed:
    """A crease that is not at its target.

    Attributes:
        label: what it is called.
        angle: where it is, in its own sense, rad.
        target: where it was to go, rad.
        within: how near would have done, rad.
    """

    label: str
    angle: float
    target: float
    within: float


def missed_targets(record: Record) -> list[Missed]:
    """Creases that were not at their targets when a stage that was to bring them there ended, the furthest first.

    Returns:
        None of a run without such a stage, or in which it reached its goal.
    """
    ends = [end for end in record.stages if end.stage.until == TARGET]
    if not ends or ends[-1].goal_time is not None or record.diverged_at is not None:
        return []
    (lower, upper), hinges = hinge_bounds(record.structure, goal_of(record.structure, TARGET)), record.structure.hinges
    row = max(int(np.searchsorted(record.time, ends[-1].end, side="right")) - 1, 0)
    found = []
    for hinge, angle, least, most in zip(hinges, record.series["hinge_angle"][row], lower, upper, strict=True):
        if not least <= angle <= most:
            target, within = (least + most) / 2, (most - least) / 2
            found.append(Missed(label=hinge.label or hinge.name, angle=float(angle), target=target, within=within))
    return sorted(found, key=lambda each: -abs(each.angle - each.target))


def missed_text(missed: list[Missed], creases: int) -> str:
    """Which creases did not arrive, as a sentence without an end.

    Args:
        missed: one or more.
        creases: how many were to arrive.
    """
    told = [
        f"{each.label} at {np.degrees(each.angle):.4g} deg of {np.degrees(each.target):.4g} deg"
        for each in missed[:_NAMED]
    ]
    more = [f"{len(missed) - _NAMED} more"] if len(missed) > _NAMED else []
    return (
        f"{len(missed)} of {creases} creases did not arrive within {np.degrees(missed[0].within):.3g} deg:"
        f" {', '.join([*told, *more])}; there springs of creases, bending and stretching of facets balance"
    )
