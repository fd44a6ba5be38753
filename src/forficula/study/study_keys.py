"""The keys of a study file, and what each means."""

from __future__ import annotations

from forficula.design.key_table import file_key

_VALUES = 'list, or range such as "10..60 N/cm step 10"'


# KEY stands for a key of the design, DRIVE for the name of one of its transitions, such as fold
STUDY_KEYS = (
    file_key("name", "text", "the file's name", "what outputs call it"),
    file_key("source", "text", "", "where its values come from"),
    file_key("reproduces", "text", "", "the paper that its maps are set beside"),
    file_key("design", "text", "needed", "a named design, or the path of a design file, that is varied"),
    file_key("ask", '"run", "least-torques" or "least-value"', "run", "what is asked of every point"),
    file_key(
        "vary", '"grid" or "one-at-a-time"', "grid", "whether all values are crossed, or one factor leaves the base"
    ),
    file_key("settings.KEY", "as in a design", "", "replaces a value of the design in every point"),
    file_key("factors.KEY", f"{_VALUES}, or distribution", "needed", "values that the key takes"),
    file_key("factors.KEY.distribution", '"uniform", "log-uniform" or "normal"', "", "the key is drawn from it"),
    file_key("factors.KEY.low", "as in a design", "", "least value that is drawn, of both uniform ones"),
    file_key("factors.KEY.high", "as in a design", "", "largest value that is drawn, alike"),
    file_key("factors.KEY.mean", "as in a design", "", "of the normal distribution"),
    file_key("factors.KEY.deviation", "as in a design", "", "standard deviation of the normal distribution"),
    file_key("grid.KEY", _VALUES, "", "values that are crossed at every choice of factors that vary one at a time"),
    file_key("sampling.method", '"random" or "sobol"', "sobol", "how factors with distributions are drawn"),
    file_key("sampling.count", "whole number, >= 1", "needed", "how many points are drawn"),
    file_key("sampling.seed", "whole number, >= 0", "0", "of the random numbers"),
    file_key(
        "search.DRIVE_torques", _VALUES, "the drive's", "torques that are tried, rising, until one reaches the state"
    ),
    file_key(
        "search.DRIVE_with",
        "N cm",
        "the design's",
        "torque of the first drive before the second, as in a run",
    ),
    file_key("search.key", "a key", "needed", "of which the least value is asked, of least-value"),
    file_key("search.values", _VALUES, "needed", "that are tried, of least-value"),
    file_key("search.state", "text", "the first", "that is to be reached, of least-value"),
    file_key("search.refinements", "whole number, >= 0, <= 20", "0", "how often the last step is halved"),
)
