"""Observations files: named observations and those of a user."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Annotated, Any, ClassVar

from pydantic import BeforeValidator, Field

from forficula.design import Design, key_quantity, numbered_key
from forficula.design.file_fields import DESIGN, SETTINGS, DesignName, FolderName, Settings, Whole, entry
from forficula.design.files.rejection import read_section
from forficula.design.section import Quantity, Section
from forficula.errors import InputError, error_prefix
from forficula.goals.deviation import positive_keys
from forficula.goals.identify.fact import Fact
from forficula.goals.identify.fact_file import FactTable, read_fact
from forficula.goals.identify.observations import Observations
from forficula.goals.identify.row_quantity import row_quantities
from forficula.names import listed
from forficula.quantities import as_written
from forficula.study.factors import DISTRIBUTIONS, MOST_VALUES, Factor, Factors
from forficula.study.files.named_file import FileKind, base_design, load_named, named_files
from forficula.study.files.study_file import check_not_settled, read_factors
from forficula.study.new_file import value_text

_Count = Annotated[Whole, Field(le=MOST_VALUES)]


class PriorSampling(Section):
    """Number of samples of the unknown values."""

    samples: _Count = entry("number of samples from the distributions of the unknown values", 256, at_least=1)
    directed: _Count = entry(
        "number of further samples, placed to meet facts together that no earlier sample met together", 128, at_least=0
    )
    seed: _Count = entry("random seed", 0, at_least=0)


def _with_facts_read(tables: object) -> object:
    """Read the tables of facts. An error message begins with the name of its fact."""
    if not isinstance(tables, list) or not tables:
        raise InputError(f"need at least one table [[fact]], got {as_written(tables)}")
    facts = []
    for number, table in enumerate(tables):
        if not isinstance(table, Mapping):
            raise InputError(f"fact {number}: need a table, got {as_written(table)}")
        with error_prefix(f"fact {table.get('name', number)}: "):
            facts.append(read_section(FactTable, table))
    return facts


_FACT_EXAMPLES = (
    """\
name = "it gets $state"
quantity = "$state"  # a state that is reached under all conditions; statistic may be "none", "any" or "count"
until = "$first"  # runs end after this transition""",
    """\
name = "$first within 0.2 to 0.4 s"
quantity = "${first}_time"
until = "$first"
absent = "9 s"  # value for a run that has no such time
equals = "0.3 s"  # or at_least, at_most
tolerance = "0.1 s\"""",
    """\
name = "two of three $first"
quantity = "$state"
statistic = "count"
until = "$first"
over = { "$other" = ["$other_low", "$other_value", "$other_high"] }
equals = 2
tolerance = 0""",
)


class ObservationsFile(Section):
    """Content of an observations file."""

    about: ClassVar[str] = (
        "Forficula observations: facts about a design with some unknown values; forficula keys"
        " --observations lists all keys"
    )

    name: FolderName = entry("name of the observations in outputs", "observations", left_out="the file's name")
    source: str = entry("source of the facts", "")
    design: DesignName = DESIGN
    settings: Settings = SETTINGS
    unknown: Factors = entry(
        "prior of an unknown value: a distribution, or a list of equally likely values",
        {},
        left_out="needed",
        examples=(
            '"$key" = { distribution = "uniform", low = "$low", high = "$high" }',
            '"$key" = { distribution = "log-uniform", low = "$low", high = "$high" }',
            '"$key" = { distribution = "normal", mean = "$value", deviation = "$step" }',
            '"$key" = ["$low", "$value", "$high"]',
        ),
    )
    sampling: PriorSampling = entry("number of samples of the unknown values", PriorSampling())
    fact: Annotated[tuple[FactTable, ...], BeforeValidator(_with_facts_read)] = entry(
        "observations, one table for each fact", (), left_out="needed", examples=_FACT_EXAMPLES
    )


def _texts(design: Design) -> dict[str, str]:
    """Return the texts of a new file that depend on its design."""
    other = next(key for key in positive_keys(design) if key != design.varied_key)
    return {
        "other": other,
        "other_low": value_text(design, other, 0.9, few_digits=True),
        "other_value": value_text(design, other, 1.0),
        "other_high": value_text(design, other, 1.1, few_digits=True),
        "fact": (
            f"A quantity can be {listed(row_quantities(design), 'or')}, a sum of some of these in one unit, or"
            ' "least value"'
        ),
    }


OBSERVATIONS = FileKind(
    word="observations file",
    several="observations",
    package="forficula.goals.identify",
    model=ObservationsFile,
    texts=_texts,
)


def load_observations(name_or_path: str | Path) -> Observations:
    """Read named observations or an observations file.

    Args:
        name_or_path: one of `named_observations`, or the path of a TOML file.

    Raises:
        InputError: unknown name or file, not TOML, an unknown key, or a value that is not allowed.
    """
    return load_named(name_or_path, OBSERVATIONS, _observations)


def observations_of(tables: Mapping[str, Any]) -> Observations:
    """Build observations from tables as in an observations file; `design` may be a `Design`.

    Raises:
        InputError: an unknown key, or a value that is not allowed.
    """
    return _observations(read_section(ObservationsFile, tables), Path())


def named_observations() -> list[str]:
    """Return the names of the observations that the package contains."""
    return named_files(OBSERVATIONS)


def _observations(file: ObservationsFile, folder: Path) -> Observations:
    base = base_design(file.design, file.settings, folder)
    priors = _priors(file, folder, base)
    return Observations(
        name=file.name,
        source=file.source,
        base=base,
        priors=priors,
        facts=_facts(file.fact, base, folder, priors),
        samples=file.sampling.samples,
        directed=file.sampling.directed,
        seed=file.sampling.seed,
    )


def _priors(file: ObservationsFile, folder: Path, base: Design) -> tuple[Factor, ...]:
    priors = read_factors(file.unknown, "unknown", folder, base)
    check_not_settled(file.settings, "unknown", priors, base)
    for prior in priors:
        if (quantity := key_quantity(prior.key, prior.model)) is not None:
            _check_allowed(prior, quantity)
    return priors


def _check_allowed(prior: Factor, quantity: Quantity) -> None:
    """Reject a prior with values that the key does not allow, because no design can be built from them."""
    ends_by_name: list[tuple[str, object]] = [("", value) for value in prior.values]
    if (drawn := prior.distribution) is not None:
        # a normal distribution has no end: values beyond a bound of the key are not built, and are counted
        ends = (drawn.first,) if drawn.name == "normal" else (drawn.first, drawn.second)
        ends_by_name = [(f".{name}", end) for name, end in zip(DISTRIBUTIONS[drawn.name], ends, strict=False)]
    for place, value in ends_by_name:
        with error_prefix(f"unknown.{prior.key}{place}: "):
            quantity.read(value, in_si=drawn is not None)


def _facts(tables: Sequence[FactTable], base: Design, folder: Path, priors: Sequence[Factor]) -> tuple[Fact, ...]:
    if not tables:
        raise InputError("fact: is missing; need at least one table [[fact]]")
    facts: list[Fact] = []
    for table in tables:
        with error_prefix(f"fact {table.name}: "):
            facts.append(read_fact(table, base, folder))
            _check_known(facts[-1], base, priors)
            if facts[-1].name in [fact.name for fact in facts[:-1]]:
                raise InputError("need a name of its own")
    return tuple(facts)


def _check_known(fact: Fact, base: Design, priors: Sequence[Factor]) -> None:
    """Reject conditions over an unknown key: a sample has one value of the key, but the fact would set others."""
    unknown = {numbered_key(base, prior.key): prior.key for prior in priors}
    for term in fact.terms:
        keys = [(f"over.{factor.key}", factor.key) for factor in term.over]
        keys += [] if term.least is None else [("least.key", term.least.key)]
        for key_in_fact, key in keys:
            if (prior_key := unknown.get(numbered_key(base, key))) is not None:
                alias = "" if key_in_fact.endswith(prior_key) else f", as {prior_key}"
                raise InputError(f"{key_in_fact}: is under [unknown], too{alias}; need it in one of them")
