"""The keys of a study file, and what each means."""

from __future__ import annotations

from forficula.design.key_table import KeyFact, facts_within

_VALUES = 'list, or range such as "10..60 N/cm step 10"'


def _of_file(key: str, allowed: str, default: str, meaning: str) -> KeyFact:
    return KeyFact(key=key, allowed=allowed, default=default, meaning=meaning)


# KEY stands for a key of the design, DRIVE for the name of one of its transitions, such as fold
STUDY_KEYS = (
    _of_file("name", "text", "the file's name", "what outputs call it"),
    _of_file("source", "text", "", "where its values come from"),
    _of_file("reproduces", "text", "", "the paper that its maps are set beside"),
    _of_file("design", "text", "needed", "a named design, or the path of a design file, that is varied"),
    _of_file("ask", '"run", "least-torques" or "least-value"', "run", "what is asked of every point"),
    _of_file(
        "vary", '"grid" or "one-at-a-time"', "grid", "whether all values are crossed, or one factor leaves the base"
    ),
    _of_file("settings.KEY", "as in a design", "", "replaces a value of the design in every point"),
    _of_file("factors.KEY", f"{_VALUES}, or distribution", "needed", "values that the key takes"),
    _of_file("factors.KEY.distribution", '"uniform", "log-uniform" or "normal"', "", "the key is drawn from it"),
    _of_file("factors.KEY.low", "as in a design", "", "least value that is drawn, of both uniform ones"),
    _of_file("factors.KEY.high", "as in a design", "", "largest value that is drawn, alike"),
    _of_file("factors.KEY.mean", "as in a design", "", "of the normal distribution"),
    _of_file("factors.KEY.deviation", "as in a design", "", "standard deviation of the normal distribution"),
    _of_file("grid.KEY", _VALUES, "", "values that are crossed at every choice of factors that vary one at a time"),
    _of_file("sampling.method", '"random" or "sobol"', "sobol", "how factors with distributions are drawn"),
    _of_file("sampling.count", "whole number, >= 1", "needed", "how many points are drawn"),
    _of_file("sampling.seed", "whole number, >= 0", "0", "of the random numbers"),
    _of_file(
        "search.DRIVE_torques", _VALUES, "the drive's", "torques that are tried, rising, until one reaches the state"
    ),
    _of_file("search.DRIVE_with", "N cm", "the drive's", "torque with which the first drive goes on to the second"),
    _of_file("search.key", "a key", "needed", "of which the least value is asked, of least-value"),
    _of_file("search.values", _VALUES, "needed", "that are tried, of least-value"),
    _of_file("search.state", "text", "the first", "that is to be reached, of least-value"),
    _of_file("search.refinements", "whole number, >= 0, <= 20", "0", "how often the last step is halved"),
)


def study_key_facts(within: str = "") -> list[KeyFact]:
    """Tell all keys of a study file, or those in a table of it, such as "search".

    Raises:
        InputError: there is no such table or key.
    """
    return facts_within(within, STUDY_KEYS)


def names_in(table: str = "") -> tuple[str, ...]:
    """The keys that a table of the file may have; of the file itself if empty."""
    start = f"{table}." if table else ""
    inside = [fact.key.removeprefix(start) for fact in STUDY_KEYS if fact.key.startswith(start)]
    return tuple(dict.fromkeys(key.split(".")[0] for key in inside))
