"""What a run did, in sentences: for its heading, and for those who do not see its plots."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from forficula.analysis import Outcome
from forficula.dynamics import Record
from forficula.quantities import reading_unit
from forficula.show.page.playback import Clip, blown_up

Array = NDArray[np.float64]


def outcome_sentence(name: str, outcome: Outcome) -> str:
    """What the wing did, how fast, with which torque and for how much work."""
    fold, unfold = outcome.fold, outcome.unfold
    if fold is None or not outcome.verdict.tells:
        return f"{name}: {outcome.status}."
    if not (outcome.folded and fold.time is not None):
        return f"{name}: {outcome.status}, with {readable(fold.torque, 'N m')} on every proximal joint."
    folding = (
        f"{name} folded in {readable(fold.time, 's')} with {readable(fold.torque, 'N m')} on every proximal joint"
        f" ({readable(fold.work, 'J')} of work)"
    )
    if unfold is None:
        return f"{folding} and stayed folded when released."
    torque = f"{readable(unfold.torque, 'N m')} on every joint"
    if not (outcome.opened and unfold.time is not None):
        return f"{folding}, stayed folded when released, and {outcome.status} with {torque}."
    return (
        f"{folding}, stayed folded when released, opened again in {readable(unfold.time, 's')} with {torque}"
        f" ({readable(unfold.work, 'J')} of work), and stayed open."
    )


def outcome_remarks(record: Record, outcome: Outcome) -> list[str]:
    """What to know of an outcome, and what to try, one sentence or two each."""
    remarks = [f"{outcome.status[:1].upper()}{outcome.status[1:]}. {outcome.advice}"] if outcome.advice else []
    states = (
        (outcome.flat_name, outcome.flat),
        (outcome.folded_name, outcome.folded_state),
        (outcome.opened_name, outcome.opened_state),
    )
    swinging = [name for name, state in states if state is not None and state.swings]
    if swinging:
        remarks.append(
            f"Where the {' and the '.join(swinging)} state is taken, hinges still swing by more than 0.1 deg: its"
            " angles are means, with half the swing behind ±."
        )
    for end in record.stages:
        if end.stage.until == "rest" and end.goal_time is None and record.diverged_at is None:
            limit = readable(end.stage.time_limit, "s")
            remarks.append(f'In the stage "{end.stage.name}" the wing did not come to rest within {limit}.')
    if record.diverged_at is not None and blown_up(record).any():
        remarks.append(
            "The last rows of the record, in which a hinge has passed its stops by a full turn, are not shown."
        )
    return remarks


def wing_text(clip: Clip, record: Record) -> str:
    """What the picture of the wing shows."""
    pattern, veins = record.design.pattern, clip.distal_angle.shape[1]
    return (
        f"A fan of {veins} veins and {veins - 1} membrane panels, each vein {readable(pattern.proximal_length, 'm')}"
        f" long up to the ring fold and {readable(pattern.distal_length, 'm')} beyond it, which moves with the time."
    )


def angle_text(title: str, degrees: Sequence[Array], clip: Clip) -> str:
    """A plot of angles in a sentence: where they are in every state, deg, (state, vein)."""
    parts = [f"{angle_range(angles)} {mark.name}" for angles, mark in zip(degrees, clip.marks, strict=True)]
    subject = f"{title[:1].upper()}{title[1:]} of {clip.distal_angle.shape[1]} veins"
    return f"{subject}: {', '.join(parts)}." if parts else f"{subject} over the time."


def energy_text(clip: Clip) -> str:
    """The plot of a clip's energies in sentences: what the tendons hold in the states, and the largest of each line."""
    held = [f"{readable(float(mark.state.tendon_energy.sum()), 'J')} {mark.name}" for mark in clip.marks]
    most = [f"{name} {readable(float(values.max()), 'J')}" for name, values in clip.stored_energy.items()]
    first = f"The tendons hold {', '.join(held)}. " if held else ""
    return f"{first}At most: {', '.join(most)}."


def angle_range(degrees: Array) -> str:
    """From the smallest to the largest of some angles, deg, or the one that all are."""
    low, high = (f"{value:.1f}".replace("-0.0", "0.0").replace("-", "−") for value in (degrees.min(), degrees.max()))
    return f"{low}°" if low == high else f"{low}° to {high}°"


def readable(value: float, si: str) -> str:
    """A value in the unit in which it reads well, with four digits at most."""
    unit, factor = reading_unit(si, abs(value))
    return f"{factor * value:.4g} {unit}"
