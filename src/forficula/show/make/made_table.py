"""A design compared with its parts as made, as lines of text."""

from __future__ import annotations

import textwrap
from collections.abc import Iterator

from forficula.quantities import show_value
from forficula.show.landscape.landscape_marks import show_angle
from forficula.statics import HingeLandscape
from forficula.study.made_comparison import HingePair, MadeComparison


def print_made(compared: MadeComparison | str | None) -> None:
    """Print a comparison, or the reason why there is none; nothing if there is nothing to compare."""
    if compared is None:
        return
    lines = [compared] if isinstance(compared, str) else made_lines(compared)
    print("\nas its parts are made")
    for line in lines:
        print(textwrap.fill(line, 110, initial_indent="  ", subsequent_indent="    "))


def made_lines(compared: MadeComparison) -> Iterator[str]:
    """Yield a comparison in lines: barrier and holding torque, differences, outcomes of runs, and their causes."""
    pairs = compared.hinges
    alike = [pair for pair in pairs if pairs and _numbers(pair) == _numbers(pairs[0])]
    for pair in pairs if len(alike) < len(pairs) else pairs[:1]:
        name = pair.name if len(alike) < len(pairs) or len(pairs) == 1 else f"{pair.name} and all others"
        yield f"{name}: as designed {_landscape(pair.designed)}; as made {_landscape(pair.made)}"
    for change in compared.changes:
        yield f"{change.key}: {change.designed or 'nothing'} as designed, {change.made or 'nothing'} as made"
    if compared.as_designed is not None and compared.as_made is not None:
        yield f"run as designed: {compared.as_designed.status}; as made: {compared.as_made.status}"
    for trial in compared.trials[2:]:
        yield f"with {' and '.join(trial.groups)} as made, all else as designed: {trial.status}"
    for blame in compared.blame:
        yield blame.text


def _numbers(pair: HingePair) -> tuple[str, str]:
    return _landscape(pair.designed), _landscape(pair.made)


def _landscape(hinge: HingeLandscape) -> str:
    """Return barrier and holding torque as text."""
    if hinge.barrier is None or hinge.barrier_angle is None:
        return "no barrier"
    return (
        f"barrier {show_value(hinge.barrier, 'J')} at {show_angle(hinge.sense * hinge.barrier_angle)}, holding torque"
        f" {show_value(hinge.holding_torque or 0.0, 'N m')}"
    )
