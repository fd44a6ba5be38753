"""The keys of an observations file, and what each means."""

from __future__ import annotations

from forficula.design.key_table import KeyFact, facts_within

_STATISTICS = "count, all, none, any; or least, largest, mean, least at, largest at"
_VALUES = 'list, or range such as "10..60 N/cm step 10"'


def _of_file(key: str, allowed: str, default: str, meaning: str) -> KeyFact:
    return KeyFact(key=key, allowed=allowed, default=default, meaning=meaning)


# KEY stands for a key of the design
OBSERVATION_KEYS = (
    _of_file("name", "text", "the file's name", "what outputs call it"),
    _of_file("source", "text", "", "where the facts come from"),
    _of_file("design", "text", "needed", "a named design, or the path of a design file, with all that is known"),
    _of_file("settings.KEY", "as in a design", "", "replaces a value of the design in every run"),
    _of_file("unknown.KEY", f"{_VALUES}, or distribution", "needed", "what is believed of a value that is unknown"),
    _of_file("unknown.KEY.distribution", '"uniform", "log-uniform" or "normal"', "", "of the unknown value"),
    _of_file("unknown.KEY.low", "as in a design", "", "its least value, of both uniform ones"),
    _of_file("unknown.KEY.high", "as in a design", "", "its largest value, alike"),
    _of_file("unknown.KEY.mean", "as in a design", "", "of the normal distribution"),
    _of_file("unknown.KEY.deviation", "as in a design", "", "standard deviation of the normal distribution"),
    _of_file("sampling.samples", "whole number, >= 1", "256", "how many are drawn from what is believed"),
    _of_file("sampling.directed", "whole number, >= 0", "128", "how many more try to meet what no sample met together"),
    _of_file("sampling.seed", "whole number, >= 0", "0", "of the random numbers"),
    _of_file("fact.name", "text", "needed", "short, of its own"),
    _of_file("fact.source", "text", "", "who says so, and where"),
    _of_file("fact.quantity", "text", "needed", 'a state, a number of runs, a sum of some, or "least value"'),
    _of_file("fact.statistic", _STATISTICS, '"all" or "least"', "of it over all conditions, of a state or of a number"),
    _of_file("fact.over.KEY", _VALUES, "", "conditions, crossed"),
    _of_file("fact.settings.KEY", "as in a design", "", "of all conditions"),
    _of_file("fact.until", "text", "", "the transition with whose stage runs end; without it, the whole protocol"),
    _of_file("fact.where", "text", "", "the state without which a run does not count"),
    _of_file("fact.absent", "as the quantity", "needed of numbers", "number of a run that has none"),
    _of_file("fact.rising", "list of keys of over", "[]", "along which the state, once it holds, goes on holding"),
    _of_file("fact.falling", "list of keys of over", "[]", "along which it does so the other way"),
    _of_file("fact.least.key", "a key", "", "whose least value that reaches a state is looked for"),
    _of_file("fact.least.values", _VALUES, "", "that are tried, rising"),
    _of_file("fact.least.state", "text", "the first", "that is to be reached"),
    _of_file("fact.least.monotone", "true or false", "false", "whether all larger values reach it, too"),
    _of_file("fact.equals", "number, text with a unit, or table", "", "what it is to be: a value, or another quantity"),
    _of_file("fact.at_least", "as equals", "", "what it is to be at least"),
    _of_file("fact.at_most", "as equals", "", "what it is to be at most"),
    _of_file("fact.at.KEY", "list", "", "values of a condition under which it is to be least or largest"),
    _of_file("fact.tolerance", "number, or text with a unit", "0", "by how much the fact may be missed"),
    _of_file("fact.scale", "as tolerance", "the samples' spread", "of the distances in sums over facts"),
)


def observation_key_facts(within: str = "") -> list[KeyFact]:
    """Tell all keys of an observations file, or those in a table of it, such as "fact".

    Raises:
        InputError: there is no such table or key.
    """
    return facts_within(within, OBSERVATION_KEYS)


def names_in(table: str = "") -> tuple[str, ...]:
    """The keys that a table of the file may have; of the file itself if empty."""
    start = f"{table}." if table else ""
    inside = [fact.key.removeprefix(start) for fact in OBSERVATION_KEYS if fact.key.startswith(start)]
    return tuple(dict.fromkeys(key.split(".")[0] for key in inside))
