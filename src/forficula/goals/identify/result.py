"""The result of an identification as a labelled table."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from forficula.goals.identify.exclusion import agreeing, best_subsets, pairs_of, smallest_unmet
from forficula.goals.identify.fact import Fact
from forficula.goals.identify.fact_text import asked_text
from forficula.goals.identify.identify import Sample, excess_of, fact_scales, met_of
from forficula.goals.identify.observations import Observations
from forficula.goals.share_interval import share_interval
from forficula.quantities import parse_quantity
from forficula.study.factors import Factor

if TYPE_CHECKING:
    import xarray


def build_result(observations: Observations, samples: Sequence[Sample], runs: int) -> xarray.Dataset:
    """Label what samples say.

    Args:
        observations: what was asked.
        samples: all of them.
        runs: how many runs they took.

    Returns:
        Dimensions "sample", "fact" and "other_fact". Coordinates over the samples are the unknowns, by their key with
        underscores, in SI with `units`, `display` and `key`. Over samples and facts there are `value` (SI of the fact's
        unit), `distance` (alike, at least 0), `scaled_distance` (beyond the tolerance, in units of the fact's scale),
        `met` and `untold` (runs that do not tell); not a number where a sample could not run, whose `status` says why.
        `agrees` names the drawn samples that agree best, `directed` those that were placed. Over facts there are
        `met_share` with `met_share_low` and `met_share_high` of the priors at 95 %, and over pairs of them
        `met_together`, `met_together_placed`, `together_share_high` and `together`, a verdict in words.
    """
    import xarray

    facts, ran = observations.facts, [not sample.why for sample in samples]
    scales = fact_scales(facts, [sample for sample in samples if not sample.directed])
    met, excess = met_of(samples, len(facts)), excess_of(facts, samples, scales)
    placed = np.array([sample.directed for sample in samples])
    inside = np.array(ran)
    agrees = np.zeros(len(samples), dtype=bool)
    agrees[inside] = agreeing(met[inside], excess[inside], placed[inside])
    variables: dict[str, Any] = {
        "value": (("sample", "fact"), _by_fact(samples, facts, "value")),
        "distance": (("sample", "fact"), _by_fact(samples, facts, "distance")),
        "scaled_distance": (("sample", "fact"), np.where(inside[:, None], excess, np.nan)),
        "met": (("sample", "fact"), met),
        "untold": (("sample", "fact"), np.nan_to_num(_by_fact(samples, facts, "untold")).astype(int)),
        "agrees": ("sample", agrees),
        "directed": ("sample", placed),
        "status": ("sample", np.array([sample.why or "ran" for sample in samples], dtype=object)),
        **_of_facts(facts, scales),
        **_shares(met[inside], placed[inside]),
    }
    return xarray.Dataset(
        variables,
        coords={**_unknowns(observations.priors, samples), **_names(facts)},
        attrs=_attributes(observations, samples, met[inside], runs),
    )


def _by_fact(samples: Sequence[Sample], facts: Sequence[Fact], name: str) -> np.ndarray[Any, np.dtype[np.float64]]:
    nothing = [float("nan")] * len(facts)
    return np.array([[float(getattr(each, name)) for each in sample.findings] or nothing for sample in samples])


def _names(facts: Sequence[Fact]) -> dict[str, Any]:
    names = np.array([fact.name for fact in facts], dtype=object)
    return {"fact": ("fact", names), "other_fact": ("other_fact", names)}


def _of_facts(facts: Sequence[Fact], scales: Sequence[float] | np.ndarray[Any, Any]) -> dict[str, Any]:
    """What facts ask for, in words, with their unit, tolerance, scale and source."""
    units = [fact.term.unit for fact in facts]

    def words(values: Sequence[str]) -> tuple[str, Any]:
        return "fact", np.array(values, dtype=object)

    return {
        "fact_units": words([unit.si if unit else "" for unit in units]),
        "fact_display": words([unit.display if unit else "" for unit in units]),
        "fact_asked": words([asked_text(fact) for fact in facts]),
        "fact_source": words([fact.source for fact in facts]),
        "fact_tolerance": ("fact", np.array([fact.tolerance for fact in facts])),
        "fact_scale": ("fact", np.array(scales)),
    }


def _shares(met: Any, placed: Any) -> dict[str, Any]:
    """How often facts are met, alone and in pairs."""
    drawn = met[~placed]
    counts = drawn.sum(axis=0)
    intervals = [share_interval(int(count), len(drawn)) for count in counts]
    size = met.shape[1]
    both, later = (np.zeros((size, size), dtype=int) for _ in range(2))
    most, words = np.full((size, size), np.nan), np.full((size, size), "", dtype=object)
    for fact, count in enumerate(counts):
        both[fact, fact], later[fact, fact] = count, met[placed, fact].sum()
    for pair in pairs_of(met, placed):
        for place in ((pair.first, pair.second), (pair.second, pair.first)):
            both[place], later[place], most[place], words[place] = pair.drawn, pair.placed, pair.most, pair.verdict
    pairs = ("fact", "other_fact")
    return {
        "met_share": ("fact", counts / max(len(drawn), 1)),
        "met_share_low": ("fact", np.array([low for low, _ in intervals])),
        "met_share_high": ("fact", np.array([high for _, high in intervals])),
        "met_together": (pairs, both),
        "met_together_placed": (pairs, later),
        "together_share_high": (pairs, most),
        "together": (pairs, np.array([[str(word) for word in row] for row in words], dtype=object)),
    }


def _unknowns(priors: Sequence[Factor], samples: Sequence[Sample]) -> dict[str, Any]:
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
        coordinates[prior.dimension] = ("sample", np.array(plain, dtype=object if words else float), attributes)
        shares = np.array([sample.shares[number] for sample in samples])
        coordinates[f"{prior.dimension}_share"] = (
            "sample", shares, {"key": prior.key, "long_name": f"share of the prior below {prior.key}"},
        )  # fmt: skip
    return coordinates


def _attributes(observations: Observations, samples: Sequence[Sample], met: Any, runs: int) -> dict[str, Any]:
    best = best_subsets(met)
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
        "most_met": int(met.sum(axis=1).max(initial=0)),
        "met_most": ["; ".join(names[fact] for fact in subset) for subset in best] or [""],
        "unmet": ["; ".join(names[fact] for fact in facts) for facts in smallest_unmet(met) if len(facts) > 2] or [""],
    }
