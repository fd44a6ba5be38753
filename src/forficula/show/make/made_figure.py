"""Energy and moment of a joint over its hinge's angle, as designed and as made."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import Patch

from forficula.errors import InputError
from forficula.names import one_of
from forficula.quantities import reading_unit, show_value
from forficula.show.landscape.close_up import add_legend, hinge_panels, write_sentence
from forficula.show.landscape.landscape_marks import show_angle
from forficula.show.style import BLUE, ORANGE, PAGE_WIDTH, describe, figure_style, is_narrow
from forficula.statics import HingeLandscape
from forficula.study.made_comparison import HingePair, MadeComparison

_DESIGNED: dict[str, Any] = {"color": ORANGE, "ls": "--", "lw": 1.4, "zorder": 2}
_MADE: dict[str, Any] = {"color": BLUE, "ls": "-", "lw": 1.4, "zorder": 3}
_STOP = "0.87"
# share of the axis beyond its ends; length of the close-up, as a multiple of the distance to the barrier
_MARGIN, _NEAR = 0.03, 2.5


def draw_made(compared: MadeComparison, width: float = PAGE_WIDTH, hinge: str | None = None) -> Figure:
    """Draw energy and moment of a tendon over the angle of its hinge, as designed and as made.

    Args:
        compared: comparison of a design with its parts as made.
        width: width of the figure, inch.
        hinge: name of the hinge; the first by default.

    Raises:
        InputError: no tendon lies across a single hinge, or none across the named hinge.
    """
    pair = _pair(compared, hinge)
    curves = ((pair.designed, "as designed", _DESIGNED), (pair.made, "as made", _MADE))
    energy_unit, energy_factor = reading_unit("J", max(float(it.energy.max()) for it, *_ in curves))
    torque_unit, torque_factor = reading_unit("N m", max(float(np.abs(it.moment).max()) for it, *_ in curves))
    with figure_style():
        tops = [item for item in (pair.designed, pair.made) if item.barrier and item.barrier_angle is not None]
        figure, top, bottom, near = hinge_panels(width, enlarged=bool(tops))
        for it, name, style in curves:
            label = f"{name}: {_numbers(it)}"
            top.plot(_degrees(it, it.angle), energy_factor * it.energy, label=label, **style)
            bottom.plot(_degrees(it, it.angle), torque_factor * it.moment, **style)
            _mark_stop(bottom, it, torque_factor, style)
        bottom.axhline(0, color="0.6", lw=0.5, zorder=0)
        if tops:
            _close_up(near, pair, tops)
        else:
            write_sentence(near, "no barrier, neither as designed nor as made")
        _shade(pair.made, top, bottom)
        top.set_ylim(bottom=0)
        top.set_ylabel(f"tendon energy ({energy_unit})")
        bottom.set_ylabel(f"moment about the hinge,\npositive opens ({torque_unit})")
        line = chr(10) if is_narrow(width) else " "
        meaning = "overbend > 0, folding < 0" if pair.made.sense > 0 else "folding > 0, overbend < 0"
        bottom.set_xlabel(f"hinge angle of {pair.name} (deg):{line}{meaning}")
        handles, _ = top.get_legend_handles_labels()
        add_legend(figure, [*handles, Patch(color=_STOP, label="beyond the stops as made")])
        return describe(figure, _text(compared, pair))


def _pair(compared: MadeComparison, hinge: str | None) -> HingePair:
    """Return the hinge of a name, or the first."""
    names = [pair.name for pair in compared.hinges]
    if not names:
        raise InputError(f"{compared.designed.name}: no tendon lies across one hinge")
    if hinge is not None and hinge not in names:
        raise InputError(f"hinge: need {one_of(names, hinge)}")
    return compared.hinges[0 if hinge is None else names.index(hinge)]


def _degrees(hinge: HingeLandscape, angle: Any) -> Any:
    return hinge.sense * np.degrees(angle)


def _mark_stop(axes: Axes, hinge: HingeLandscape, factor: float, style: dict[str, Any]) -> None:
    """Mark the torque that presses a hinge onto its overbend stop."""
    if hinge.holding_torque is not None:
        place = float(_degrees(hinge, hinge.hinge.overbend))
        axes.plot(place, factor * hinge.holding_torque, "o", color=style["color"], ms=4, zorder=4)


def _close_up(near: Axes, pair: HingePair, tops: Sequence[HingeLandscape]) -> None:
    """Draw the barriers, relative to the overbend stop."""
    unit, factor = reading_unit("J", max(top.barrier or 0.0 for top in tops))
    stop = max(top.hinge.overbend for top in tops)
    reach = _NEAR * (stop - min(top.barrier_angle or 0.0 for top in tops))
    last = max(stop - reach, -pair.made.hinge.fold_limit)
    for item, style in ((pair.designed, _DESIGNED), (pair.made, _MADE)):
        angle = np.linspace(item.hinge.overbend, last, 121)
        above = item.stored_energy(angle) - item.stored_energy(item.hinge.overbend)
        near.plot(_degrees(item, angle), factor * above, **style)
        if item.barrier and item.barrier_angle is not None:
            place = (float(_degrees(item, item.barrier_angle)), factor * item.barrier)
            near.plot(*place, "o", color=style["color"], ms=3.5, zorder=4)
    top = factor * max(top.barrier or 0.0 for top in tops)
    near.set(xlim=sorted(near.get_xlim(), reverse=pair.made.sense > 0), ylim=(-0.5 * top, 1.35 * top))
    near.set_ylabel(f"energy above the stop ({unit})")
    near.set_xlabel(f"hinge angle of {pair.name} (deg)")


def _shade(hinge: HingeLandscape, *rows: Axes) -> None:
    """Shade the range beyond the stops as made."""
    stop, limit = math.degrees(hinge.hinge.overbend), -math.degrees(hinge.hinge.fold_limit)
    margin, sense = _MARGIN * (stop + 180.0), hinge.sense
    ends = (max(stop, 0.0) + margin, min(limit, -180.0) - margin)
    for axes in rows:
        axes.axvspan(sense * stop, sense * ends[0], color=_STOP, lw=0, zorder=-1)
        axes.axvspan(sense * limit, sense * ends[1], color=_STOP, lw=0, zorder=-1)
        axes.set_xlim(sense * ends[0], sense * ends[1])
        axes.set_xticks([sense * tick for tick in range(180, -181, -30) if ends[1] <= tick <= ends[0]])


def _numbers(hinge: HingeLandscape, top: str = "") -> str:
    """Return barrier and holding torque as text."""
    if hinge.barrier is None:
        return "no barrier"
    torque = show_value(hinge.holding_torque or 0.0, "N m")
    return f"barrier {show_value(hinge.barrier, 'J')}{top}, holding torque {torque}"


def _text(compared: MadeComparison, pair: HingePair) -> str:
    """Describe the tendon as designed and as made."""
    versions = []
    for item, name in ((pair.designed, "as designed"), (pair.made, "as made")):
        top = "" if item.barrier_angle is None else f" at {show_angle(item.sense * item.barrier_angle)}"
        versions.append(f"{name} {_numbers(item, top)}")
    beginning = f"Energy and moment of a tendon of {compared.designed.name} over the angle of {pair.name}"
    return f"{beginning}: {'; '.join(versions)}."
