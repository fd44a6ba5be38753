"""The keys of an observations file, and what each means."""

from __future__ import annotations

from forficula.design.key_table import file_key

_STATISTICS = "count, all, none, any; or least, largest, mean, least at, largest at"
_VALUES = 'list, or range such as "10..60 N/cm step 10"'


# KEY stands for a key of the design
OBSERVATION_KEYS = (
    file_key("name", "text", "the file's name", "what outputs call it"),
    file_key("source", "text", "", "where the facts come from"),
    file_key("design", "text", "needed", "a named design, or the path of a design file, with all that is known"),
    file_key("settings.KEY", "as in a design", "", "replaces a value of the design in every run"),
    file_key("unknown.KEY", f"{_VALUES}, or distribution", "needed", "what is believed of a value that is unknown"),
    file_key("unknown.KEY.distribution", '"uniform", "log-uniform" or "normal"', "", "of the unknown value"),
    file_key("unknown.KEY.low", "as in a design", "", "its least value, of both uniform ones"),
    file_key("unknown.KEY.high", "as in a design", "", "its largest value, alike"),
    file_key("unknown.KEY.mean", "as in a design", "", "of the normal distribution"),
    file_key("unknown.KEY.deviation", "as in a design", "", "standard deviation of the normal distribution"),
    file_key("sampling.samples", "whole number, >= 1", "256", "how many are drawn from what is believed"),
    file_key("sampling.directed", "whole number, >= 0", "128", "how many more try to meet what no sample met together"),
    file_key("sampling.seed", "whole number, >= 0", "0", "of the random numbers"),
    file_key("fact.name", "text", "needed", "short, of its own"),
    file_key("fact.source", "text", "", "who says so, and where"),
    file_key("fact.quantity", "text", "needed", 'a state, a number of runs, a sum of some, or "least value"'),
    file_key("fact.statistic", _STATISTICS, '"all" or "least"', "of it over all conditions, of a state or of a number"),
    file_key("fact.over.KEY", _VALUES, "", "conditions, crossed"),
    file_key("fact.settings.KEY", "as in a design", "", "of all conditions"),
    file_key("fact.until", "text", "", "the transition with whose stage runs end; without it, the whole protocol"),
    file_key("fact.where", "text", "", "the state without which a run does not count"),
    file_key("fact.absent", "as the quantity", "needed of numbers", "number of a run that has none"),
    file_key("fact.rising", "list of keys of over", "[]", "along which the state, once it holds, goes on holding"),
    file_key("fact.falling", "list of keys of over", "[]", "along which it does so the other way"),
    file_key("fact.least.key", "a key", "", "whose least value that reaches a state is looked for"),
    file_key("fact.least.values", _VALUES, "", "that are tried, rising"),
    file_key("fact.least.state", "text", "the first", "that is to be reached"),
    file_key("fact.least.monotone", "true or false", "false", "whether all larger values reach it, too"),
    file_key("fact.equals", "number, text with a unit, or table", "", "what it is to be: a value, or another quantity"),
    file_key("fact.at_least", "as equals", "", "what it is to be at least"),
    file_key("fact.at_most", "as equals", "", "what it is to be at most"),
    file_key("fact.at.KEY", "list", "", "values of a condition under which it is to be least or largest"),
    file_key("fact.tolerance", "number, or text with a unit", "0", "by how much the fact may be missed"),
    file_key("fact.scale", "as tolerance", "the samples' spread", "of the distances in sums over facts"),
)
