"""How long a search takes, guessed from its first designs."""

from __future__ import annotations

import time
from tempfile import TemporaryDirectory

from forficula.goals.assessor import open_assessor
from forficula.goals.goal import Goal
from forficula.goals.optimise.screening import screened

_TRIED = 2


def estimate_batch(goal: Goal) -> tuple[float, int]:
    """Guess how long a batch takes without its neighbours, s, and how many of its designs are run, from two of them.

    Args:
        goal: what is asked.
    """
    values = [goal.values([share] * len(goal.parameters)) for share in (0.5, 1.0)][:_TRIED]
    designs = [goal.base.with_values(dict(each)) for each in values]
    start = time.perf_counter()
    with TemporaryDirectory() as folder, open_assessor(folder, goal.base) as assess:
        found = screened(goal, assess, designs, values)
    share = goal.batch / _TRIED
    ran = sum(goal.simulate and not each.ruled_out for each in found)
    return (time.perf_counter() - start) * share, round(ran * share)
