"""A commented goal file to start from."""

from __future__ import annotations

import os
from pathlib import Path

from forficula.files import write_text
from forficula.goals.outcome_quantity import quantities_of
from forficula.names import listed
from forficula.study.start import commented, start_of

_TEMPLATE = """\
# A forficula goal: what a structure must do, what may vary, and how far off it may be built.
# forficula keys --goal tells all keys, forficula keys --kind {kind} those of the design. What is behind # may be left
# out.
design = "{design}"  # a named design, or the path of a design file
# source = "where the question comes from"
# simulate = false  # statics alone decides, without any run

# Of all that is tried, by key of the design.
[settings]
# protocol.timestep = "0.1 ms"

# What may vary: between two values, with a step or without; or among choices.
[vary]
"{key}" = {{ low = "{low}", high = "{high}" }}
# "{key}" = {{ low = "{low}", high = "{high}", step = "{step}" }}
# "{key}" = ["{low}", "{value}", "{high}"]

# What it must do beside what its protocol asks for: these are the quantities that there are, and keys of the design.
# {quantities}
[limits]
# {transition}_time = "<= 0.5 s"
# probability = ">= 95 %"  # that it works within the tolerances

# What is to be least or largest; with two or three the answer is a front.
[objectives]
{objective} = "least"

# How far off it may be built: shares are of the design's values, uniform either way.
[tolerances]
# all = "10 %"  # of every positive number with a unit that is not the protocol's
# "{key}" = "5 %"
# "{key}" = {{ distribution = "normal", size = "{step}" }}

[search]
# runs = 512  # designs that are tried at most
# batch = 32  # side by side
# neighbours = 64  # of one design, within the tolerances
# seed = 0
"""


def write_new_goal(path: str | os.PathLike[str], kind: str = "earwig-fan") -> None:
    """Write a goal file to start from, which can be optimised as it is: a design, what varies, and what else may be.

    Args:
        path: of the file.
        kind: of the pattern of the design that it varies, one of `KINDS`.

    Raises:
        InputError: no such kind, or the file exists already, or cannot be written.
    """
    start = start_of(path := Path(path), kind)
    names = list(quantities_of(start.design))
    text = _TEMPLATE.format(
        **start.texts,
        step=start.about(0.05),
        quantities=commented(f"{listed(names)}."),
        transition=next((name.removesuffix("_time") for name in names if name.endswith("_time")), "fold"),
        objective=next((name for name in names if name.endswith("_work")), "mass"),
    )
    write_text(path, text)
