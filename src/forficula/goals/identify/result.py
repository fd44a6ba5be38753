"""Result of an identification as a labelled table."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
import xarray

from forficula.goals.binomial_interval import binomial_interval
from forficula.goals.identify.exclusion import (
    Evidence,
    agreeing,
    best_subsets,
    conjunction,
    pairs_of,
    triples_of,
)
from forficula.goals.identify.fact import Fact
from forficula.goals.identify.fact_text import requirement_text
from forficula.goals.identify.identify import Sample, conclusive_of, excess_of, fact_scales, met_of
from forficula.goals.identify.inference import APART, Inference, infer
from forficula.goals.identify.observations import Observations
from forficula.goals.identify.prior import value_at
from forficula.quantities import parse_quantity
from forficula.results import Result
from forficula.study.factors import Factor

if TYPE_CHECKING:
    import xarray


def build_result(observations: Observations, samples: Sequence[Sample], runs: int) -> xarray.Dataset:
    """Build the labelled table of an identification.

    Args:
        observations: design, unknowns and facts.
        samples: all samples.
        runs: number of runs.

    Returns:
        Dimensions "sample", "fact" and "other_fact". Coordinates over the samples are the unknowns, by their key with
        underscores, in SI with `units`, `display` and `key`. Over samples and facts: `value` (SI of the fact's unit),
        `distance` (same unit, at least 0), `scaled_distance` (beyond the tolerance, in units of the fact's scale),
        `met` and `tells` (certainly met; certainly met or missed; for every possible outcome of inconclusive runs), and
        `untold` (number of inconclusive runs); nan if a sample could not run, whose `status` says why. `agrees` marks
        the drawn samples that agree best, `directed` the placed ones. Over facts: `told` (number of conclusive drawn
        samples), and `met_share` with `met_share_low` and `met_share_high` (fraction of the priors, 95 % interval).
        Over pairs of facts, for drawn samples: `told_together`, `met_together` and `met_alone` (the first fact,
        whatever the other); for placed
        ones: `met_together_placed` and `tried_together` (placed for this pair); `together_share_high` (fraction of the
        priors, one-sided 95 %), `together_near` (smallest deviation from the worse of both, in scales),
        `together_if_independent` (expected `met_together` if the facts were independent) and `together`, a verdict in
        words.

        The agreeing range between the samples comes from emulators of the facts (`infer`): each unknown has the
        attributes `agrees_low` and `agrees_high`, the ends of a range in its unit, or `agrees_choices`. `between_error`
        is the emulator's standard error of each fact in this range, in half-widths of the fact's window. Attributes of
        the table are `emulated` (0 if fewer than `emulator_samples` ran), `between_share` (fraction of the priors that
        meets all facts), `between_apart` (smallest deviation from the worst fact, in standard errors) and
        `between_possible`.
    """
    facts, ran = observations.facts, [not sample.why for sample in samples]
    scales = fact_scales(facts, [sample for sample in samples if not sample.directed])
    met, excess = met_of(samples, len(facts)), excess_of(facts, samples, scales)
    placed = np.array([sample.directed for sample in samples])
    inside = np.array(ran)
    agrees = np.zeros(len(samples), dtype=bool)
    agrees[inside] = agreeing(met[inside], excess[inside], placed[inside])
    inference = infer(
        observations,
        [sample for sample in samples if not sample.why],
        (excess[inside] / (1 + excess[inside])).sum(axis=1),
    )
    seen = Evidence(
        met=met[inside],
        conclusive=conclusive_of(samples, len(facts))[inside],
        excess=excess[inside],
        targets=[sample.target for sample in samples if not sample.why],
        open_between=lambda facts_together: inference.apart(facts_together) <= APART,
    )
    variables: dict[str, Any] = {
        **_samples(samples, facts, met, np.where(inside[:, None], excess, np.nan)),
        "agrees": ("sample", agrees),
        **_of_facts(facts, scales),
        "between_error": ("fact", _between_errors(inference, len(facts))),
        **_shares(seen),
        **_pairs(seen),
    }
    return IdentificationTable(
        variables,
        coords={**_unknowns(observations.priors, samples, inference), **_names(facts)},
        attrs={**_attributes(observations, samples, seen, runs), **_between(inference)},
    )


def _between(inference: Inference) -> dict[str, Any]:
    """Return the predictions of emulators for all facts together; numbers, because attributes in files are numbers."""
    agreement = inference.agreement
    return {
        "emulated": int(agreement is not None),
        "emulator_samples": inference.needed,
        "between_share": np.nan if agreement is None else agreement.share,
        "between_apart": np.nan if agreement is None else agreement.apart,
        "between_possible": int(inference.possible),
    }


def _between_errors(inference: Inference, facts: int) -> Any:
    return np.full(facts, np.nan) if inference.agreement is None else inference.agreement.errors


def _samples(samples: Sequence[Sample], facts: Sequence[Fact], met: Any, excess: Any) -> dict[str, Any]:
    """Return the results of every sample, alone and by fact."""
    over = ("sample", "fact")
    return {
        "value": (over, _by_fact(samples, facts, "value")),
        "distance": (over, _by_fact(samples, facts, "distance")),
        "scaled_distance": (over, excess),
        "met": (over, met),
        "tells": (over, conclusive_of(samples, len(facts))),
        "untold": (over, np.nan_to_num(_by_fact(samples, facts, "untold")).astype(int)),
        "directed": ("sample", np.array([sample.directed for sample in samples])),
        "status": ("sample", np.array([sample.why or "ran" for sample in samples], dtype=object)),
    }


def _by_fact(samples: Sequence[Sample], facts: Sequence[Fact], name: str) -> np.ndarray[Any, np.dtype[np.float64]]:
    missing = [float("nan")] * len(facts)
    return np.array([[float(getattr(finding, name)) for finding in sample.findings] or missing for sample in samples])


def _names(facts: Sequence[Fact]) -> dict[str, Any]:
    names = np.array([fact.name for fact in facts], dtype=object)
    return {"fact": ("fact", names), "other_fact": ("other_fact", names)}


def _of_facts(facts: Sequence[Fact], scales: Sequence[float] | np.ndarray[Any, Any]) -> dict[str, Any]:
    """Return the requirements of facts in words, with unit, tolerance, scale and source."""
    units = [fact.term.unit for fact in facts]

    def words(values: Sequence[str]) -> tuple[str, Any]:
        return "fact", np.array(values, dtype=object)

    return {
        "fact_units": words([unit.si if unit else "" for unit in units]),
        "fact_display": words([unit.display if unit else "" for unit in units]),
        "fact_asked": words([requirement_text(fact) for fact in facts]),
        "fact_source": words([fact.source for fact in facts]),
        "fact_tolerance": ("fact", np.array([fact.tolerance for fact in facts])),
        "fact_scale": ("fact", np.array(scales)),
    }


def _shares(seen: Evidence) -> dict[str, Any]:
    """Return how often each fact is met by conclusive drawn samples; intervals allow any result of the others."""
    met, conclusive = seen.met[~seen.placed], seen.conclusive[~seen.placed]
    counts_conclusive, counts = conclusive.sum(axis=0), (met & conclusive).sum(axis=0)
    ends = [
        (binomial_interval(int(count), len(met))[0], binomial_interval(int(count + len(met) - number), len(met))[1])
        for count, number in zip(counts, counts_conclusive, strict=True)
    ]
    return {
        "told": ("fact", counts_conclusive),
        "met_share": ("fact", counts / np.maximum(counts_conclusive, 1)),
        "met_share_low": ("fact", np.array([low for low, _ in ends])),
        "met_share_high": ("fact", np.array([high for _, high in ends])),
    }


def _pairs(seen: Evidence) -> dict[str, Any]:
    """Return how far facts are met in pairs; on the diagonal, each alone."""
    size = seen.met.shape[1]
    counts = {name: np.zeros((size, size), dtype=int) for name in ("told", "met", "alone", "placed", "tried")}
    numbers = {name: np.full((size, size), np.nan) for name in ("share_high", "near", "independent")}
    words = np.full((size, size), "", dtype=object)
    for pair in [*(conjunction((fact,), seen) for fact in range(size)), *pairs_of(seen)]:
        first, last = pair.facts[0], pair.facts[-1]
        for cell, alone in (((first, last), pair.alone[0]), ((last, first), pair.alone[-1])):
            counts["told"][cell], counts["met"][cell], counts["alone"][cell] = pair.conclusive_count, pair.drawn, alone
            counts["placed"][cell], counts["tried"][cell] = pair.placed, pair.tried
            numbers["share_high"][cell], numbers["near"][cell] = pair.most, pair.near
            numbers["independent"][cell] = pair.independent
            words[cell] = pair.verdict.value if first != last else ""
    names = {
        "told_together": counts["told"],
        "met_together": counts["met"],
        "met_alone": counts["alone"],
        "met_together_placed": counts["placed"],
        "tried_together": counts["tried"],
        "together_share_high": numbers["share_high"],
        "together_near": numbers["near"],
        "together_if_independent": numbers["independent"],
        "together": words,
    }
    return {name: (("fact", "other_fact"), values) for name, values in names.items()}


def _unknowns(priors: Sequence[Factor], samples: Sequence[Sample], inference: Inference) -> dict[str, Any]:
    coordinates: dict[str, Any] = {}
    for number, prior in enumerate(priors):
        unit = prior.unit
        values = [sample.values[prior.key] for sample in samples]
        attributes: dict[str, object] = {
            "key": prior.key,
            "long_name": prior.key.replace(".", " ").replace("_", " "),
            "prior": "values" if prior.distribution is None else prior.distribution.name,
        }
        if unit is not None:
            attributes |= {"units": unit.si, "display": unit.display}
            numbers = [parse_quantity(value, unit) for value in values]
        plain: Any = numbers if unit is not None else values
        words = any(isinstance(value, str) for value in plain)
        attributes |= _agrees(prior, number, inference)
        coordinates[prior.dimension] = ("sample", np.array(plain, dtype=object if words else float), attributes)
        shares = np.array([sample.shares[number] for sample in samples])
        coordinates[f"{prior.dimension}_share"] = (
            "sample", shares, {"key": prior.key, "long_name": f"share of the prior below {prior.key}"},
        )  # fmt: skip
    return coordinates


def _agrees(prior: Factor, number: int, inference: Inference) -> dict[str, object]:
    """Return the agreeing range of an unknown: the ends in SI, or some of its choices."""
    if prior.distribution is None:
        chosen = [prior.values[choice] for choice in inference.choices_of(number)]
        return {"agrees_choices": [str(value) for value in chosen]}
    ends = [value_at(prior, share) for share in inference.range_of(number)]
    numbers = [parse_quantity(end, prior.unit) if prior.unit is not None else float(str(end)) for end in ends]
    return {"agrees_low": numbers[0], "agrees_high": numbers[1]}


def _attributes(observations: Observations, samples: Sequence[Sample], seen: Evidence, runs: int) -> dict[str, Any]:
    best, triples = best_subsets(seen.met), triples_of(seen)
    names = [fact.name for fact in observations.facts]
    return {
        "name": observations.name,
        "source": observations.source,
        "design": observations.base.name,
        "design_hash": observations.base.hash,
        "seed": observations.seed,
        "drawn": sum(not sample.directed for sample in samples),
        "placed": sum(sample.directed for sample in samples),
        "could_not_run": sum(bool(sample.why) for sample in samples),
        "runs": runs,
        "unknowns": [prior.dimension for prior in observations.priors],
        "most_met": int(seen.met.sum(axis=1).max(initial=0)),
        "met_most": ["; ".join(names[fact] for fact in subset) for subset in best] or [""],
        # in files, lists have at least one entry
        "unmet": ["; ".join(names[fact] for fact in triple.facts) for triple in triples] or [""],
        "unmet_verdict": [triple.verdict.value for triple in triples] or [""],
        "unmet_told": [triple.conclusive_count for triple in triples] or [0],
        "unmet_tried": [triple.tried for triple in triples] or [0],
        "unmet_near": [triple.near for triple in triples] or [0.0],
        "unmet_share_high": [triple.most for triple in triples] or [0.0],
    }


class IdentificationTable(Result, xarray.Dataset):  # type: ignore[no-untyped-call]
    """An `xarray.Dataset` that displays its conclusions in notebooks."""

    __slots__ = ()
