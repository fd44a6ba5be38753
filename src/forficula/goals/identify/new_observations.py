"""A commented observations file to start from."""

from __future__ import annotations

import os
from pathlib import Path

from forficula.files import write_text
from forficula.goals.deviation import positive_keys
from forficula.goals.identify.row_quantity import row_quantities
from forficula.names import listed
from forficula.structure import structure_of
from forficula.study.start import Start, commented, start_of

_TEMPLATE = """\
# Forficula observations: what was seen of a design some of whose values are unknown.
# forficula keys --observations tells all keys, forficula keys --kind {kind} those of the design. What is behind # may
# be left out.
design = "{design}"  # a named design, or the path of a design file, with all that is known
# source = "who saw it, and where"

# Of every run, by key of the design.
[settings]
# protocol.timestep = "0.1 ms"

# What is believed of each value that is unknown: a distribution, or a list of values that are as likely as one another.
[unknown]
"{key}" = {{ distribution = "uniform", low = "{low}", high = "{high}" }}
# "{key}" = {{ distribution = "log-uniform", low = "{low}", high = "{high}" }}
# "{key}" = {{ distribution = "normal", mean = "{value}", deviation = "{step}" }}
# "{key}" = ["{low}", "{value}", "{high}"]

[sampling]
# samples = 256  # drawn from what is believed
# directed = 128  # placed where they may meet what none of these met together
# seed = 0

# What was seen, a table for each fact. A quantity is one of these, a sum of some in one unit, or "least value":
# {quantities}
[[fact]]
name = "{first}"
quantity = "{state}"  # a state that all conditions reach; statistic = "none", "any" or "count" says otherwise
until = "{transition}"  # nothing after it is run

# [[fact]]
# name = "{transition} within 0.2 to 0.4 s"
# quantity = "{transition}_time"
# until = "{transition}"
# absent = "9 s"  # of a run that has none
# equals = "0.3 s"  # or at_least, at_most
# tolerance = "0.1 s"

# [[fact]]
# name = "two of three {transition}"
# quantity = "{state}"
# statistic = "count"
# until = "{transition}"
# over = {{ "{other}" = ["{other_low}", "{other_value}", "{other_high}"] }}
# equals = 2
# tolerance = 0
"""


def write_new_observations(path: str | os.PathLike[str], kind: str = "earwig-fan") -> None:
    """Write an observations file to start from, which can be identified as it is: an unknown, and what was seen.

    Args:
        path: of the file.
        kind: of the pattern of the design that was seen, one of `KINDS`.

    Raises:
        InputError: no such kind, or the file exists already, or cannot be written.
    """
    start = start_of(path := Path(path), kind)
    other = next(key for key in positive_keys(start.design) if key != start.key)
    varied = Start(kind=start.kind, name=start.name, design=start.design, key=other)
    transition = structure_of(start.design).transitions[0]
    text = _TEMPLATE.format(
        **start.texts,
        step=start.about(0.05),
        first=f"it gets {transition.state}",
        transition=transition.name,
        state=transition.state,
        other=other,
        other_low=varied.about(0.9),
        other_value=varied.times(1.0),
        other_high=varied.about(1.1),
        quantities=commented(f"{listed(list(row_quantities(start.design)))}."),
    )
    write_text(path, text)
