"""A commented study file to start from."""

from __future__ import annotations

import os
from pathlib import Path

from forficula.design import TORQUE
from forficula.files import write_text
from forficula.quantities import show_quantity
from forficula.structure import structure_of
from forficula.study.start import start_of

_TEMPLATE = """\
# A forficula study: every point of its factors is a run of its design. What is behind # may be left out.
# forficula keys --study tells all keys, forficula keys --kind {kind} those of the design.
design = "{design}"  # a named design, or the path of a design file
# source = "where the values come from"

# What is asked of every point: "run" takes the protocol as it is; "least-torques" looks for the least that fold and
# open, "least-value" for the least value of any key: see [search].
ask = "run"

# Of all points, by key of the design.
[settings]
# protocol.timestep = "0.1 ms"

# What varies, by key of the design: a list, a range, or a distribution; several lists or ranges are crossed.
[factors]
"{key}" = ["{low}", "{value}", "{high}"]
# "{key}" = "{low_range} step {step}"
# "{key}" = {{ distribution = "uniform", low = "{low}", high = "{high}" }}

# With distributions: how many points are drawn, and how.
# [sampling]
# method = "sobol"  # or "random"
# count = 64
# seed = 0

# With ask = "least-torques": what is tried, rising. fold and unfold are names of the design's transitions.
# [search]
# fold_torques = "0..50 N cm step 10"
# fold_with = "{fold_with}"  # folds before unfold_torques are tried; the design's own if left out, as in a run
# unfold_torques = "10..100 N cm step 10"
# refinements = 3  # how often the last step is halved

# With ask = "least-value":
# [search]
# key = "{key}"
# values = ["{low}", "{value}", "{high}"]
# state = "{state}"  # that is to be reached
"""


def write_new_study(path: str | os.PathLike[str], kind: str = "earwig-fan") -> None:
    """Write a study file to start from, which runs as it is: a design, one factor, and what else there may be.

    Args:
        path: of the file.
        kind: of the pattern of the design that it varies, one of `KINDS`.

    Raises:
        InputError: no such kind, or the file exists already, or cannot be written.
    """
    start = start_of(path := Path(path), kind)
    states = [stage.state for stage in start.design.protocol.stages if stage.state is not None]
    texts = start.texts
    drive = next(iter(structure_of(start.design).drives), None)
    torque = 0.5 if drive is None else abs(drive.strength)
    text = _TEMPLATE.format(
        **texts,
        fold_with=show_quantity(torque, TORQUE),
        low_range=f"{texts['low'].split()[0]}..{texts['high']}",
        step=texts["low"],
        state=states[-1] if states else "folded",
    )
    write_text(path, text)
