"""Sentences about a run, for the heading of its page and for readers who cannot see its plots."""

from __future__ import annotations

from collections.abc import Sequence

from forficula.analysis import Outcome, TransitionOutcome
from forficula.analysis.confirmation import confirmation_text
from forficula.analysis.verdict import ENDING_TEXTS
from forficula.arrays import Array
from forficula.dynamics import Record
from forficula.names import listed
from forficula.quantities import reading_unit
from forficula.show.page.playback import Clip, Readings, diverged_rows
from forficula.show.run.outcome_rows import quasi_static_text
from forficula.show.run.release import release_text
from forficula.show.structure.labels import counted, measure_labels
from forficula.structure import Structure, Transition, drive_of, drive_unit, hinge_groups

# sentences about a structure that the engine of the page moves, worded as in `outcome_sentence`; the page fills them in
LIVE_OUTCOME_TEXTS = {
    "transition": "{did} in {time} for {work} of work",
    "then": ", then ",
    "reached": "The {whole} {transitions}.",
    "missed": "The {whole} {transitions}; then: {status}.",
}


def outcome_sentence(name: str, outcome: Outcome) -> str:
    """Return a sentence with a structure's transitions, their times, torques and work."""
    structure = outcome.structure
    tried = [transition for transition in structure.transitions if outcome.transitions[transition.name] is not None]
    if not tried or not outcome.verdict.conclusive:
        return f"{name}: {outcome.status}."
    clauses: list[str] = []
    for transition in tried:
        result = outcome.transitions[transition.name]
        assert result is not None
        torque = _torque_text(structure, result)
        if not (outcome.holds[transition.state] and result.time is not None):
            if not clauses:
                return f"{name}: {outcome.status}, with {torque}."
            return f"{name} {', '.join(clauses)}, and {outcome.status} with {torque}."
        words = transition.wording
        time, work, did = readable(result.time, "s"), readable(result.work, "J"), words.did or words.done
        until = outcome.stages[transition.stage].goal if transition.stage is not None else transition.goal
        if until == transition.goal:
            clauses.append(f"{did} in {time} with {torque} ({work} of work)")
        else:  # the stage ends before the transition is complete, so its time is not that of the whole transition
            clauses.append(f"{did} ({until} in {time} with {torque}, {work} of work)")
        clauses += _after(structure, transition, result, first=len(clauses) == 1)
    if len(clauses) == 1:
        return f"{name} {clauses[0]}."
    *most, last = clauses
    comma = "," * (len(most) > 1)
    return f"{name} {', '.join(most)}{comma} and {last}."


def _torque_text(structure: Structure, result: TransitionOutcome) -> str:
    """Return the strengths of the drives of a transition, and where they act."""
    return listed(
        " ".join(filter(None, (readable(drive.strength, drive_unit(structure, drive)), drive.where)))
        for drive in (drive_of(structure, name) for name in result.drives)
    )


def _after(structure: Structure, transition: Transition, result: TransitionOutcome, *, first: bool) -> list[str]:
    """Return what happened when the structure was released after a transition; empty if no release followed."""
    if result.held is not None:
        return [f"stayed {transition.wording.stays}{' when released' * first}"]
    text = release_text(structure, transition, result)
    return [text] if text else []


def outcome_remarks(record: Record, outcome: Outcome) -> list[str]:
    """Return remarks on an outcome and advice, each of one or two sentences."""
    remarks = [f"{outcome.status[:1].upper()}{outcome.status[1:]}. {outcome.advice}"] if outcome.advice else []
    if outcome.confirmation is not None and outcome.confirmation.agree:
        words = confirmation_text(outcome.ending, outcome.confirmation)
        remarks.append(f"The verdict is {words}. The number after ± is the numerical uncertainty.")
    whole = record.structure.appearance.whole
    swinging = [outcome.state_names[name] for name, state in outcome.states.items() if state and state.swings]
    if swinging:
        remarks.append(
            f"In the {' and the '.join(swinging)} state the {whole} still moves: its values are"
            " means, with half the range after ±."
        )
    if text := quasi_static_text(record.structure, outcome):
        remarks.append(text)
    for end in record.stages:
        if end.stage.until == "rest" and end.goal_time is None and record.diverged_at is None:
            limit = readable(end.stage.time_limit, "s")
            remarks.append(f'In the stage "{end.stage.name}" the {whole} did not come to rest within {limit}.')
    if record.diverged_at is not None and diverged_rows(record).any():
        remarks.append("The last rows of the record, in which a hinge is a full turn beyond its stops, are not shown.")
    return remarks


def unbuilt_text(noun: str) -> str:
    """Return why a point, a sample or a design of a page has no run to play back."""
    return f"There is nothing to play: this {noun} {ENDING_TEXTS['not built']}."


def structure_text(structure: Structure) -> str:
    """Return a sentence that describes the moving picture of a structure."""
    return f"{shape_text(structure)}, moving over time."


def shape_text(structure: Structure) -> str:
    """Return the description of a structure's picture, without a full stop."""
    return structure.appearance.text or _counted_parts(structure)


def _counted_parts(structure: Structure) -> str:
    counts = (
        ("plate", structure.plates),
        ("facet", structure.facets),
        ("bar", (*structure.bars, *structure.springs)),
        ("membrane", structure.membranes),
    )
    hinges = tuple((kind.removesuffix("s"), hinges) for kind, hinges in hinge_groups(structure).items())
    rest = (*hinges, ("tendon", structure.tendons))
    parts = [f"{len(parts)} {kind}{'s' * (len(parts) != 1)}" for kind, parts in (*counts, *rest) if parts]
    return f"A {structure.appearance.whole} of {listed(parts)}, {readable(structure.span, 'm')} in size"


def reading_text(readings: Readings, in_states: Sequence[Array], clip: Clip) -> str:
    """Return a sentence about a plot of readings: their range in every state, in their unit, (state, reading)."""
    parts = [
        f"{reading_range(values, readings.unit)} {mark.name}"
        for values, mark in zip(in_states, clip.marks, strict=True)
    ]
    title, several = readings.title, readings.measure.kind == "angle"
    of = f" of {counted(measure_labels(clip.structure, readings.measure), 'hinge')}" * several
    subject = f"{title[:1].upper()}{title[1:]}{of}"
    return f"{subject}: {', '.join(parts)}." if parts else f"{subject} over time."


def energy_text(clip: Clip) -> str:
    """Return sentences about a plot of energies: tendon energy in the states, and the largest value of each line."""
    held = [f"{readable(float(mark.state.tendon_energy.sum()), 'J')} {mark.name}" for mark in clip.marks]
    most = [f"{name} {readable(value, 'J')}" for name, value in clip.largest_energy.items()]
    first = f"Energy of the tendons: {', '.join(held)}. " if held and clip.structure.tendons else ""
    return f"{first}Largest values: {', '.join(most)}."


def reading_range(values: Array, unit: str) -> str:
    """Return the range of some numbers with their unit, or the single value."""
    if unit == "deg":
        return angle_range(values)
    low, high = (f"{value:.4g}".replace("-", "−") for value in (values.min(), values.max()))
    return f"{low} {unit}" if low == high else f"{low} to {high} {unit}"


def angle_range(degrees: Array) -> str:
    """Return the range of some angles, deg, or the single value."""
    low, high = (f"{value:.1f}".replace("-0.0", "0.0").replace("-", "−") for value in (degrees.min(), degrees.max()))
    return f"{low}°" if low == high else f"{low}° to {high}°"


def readable(value: float, si: str) -> str:
    """Return a value in a legible unit, with at most four digits."""
    unit, factor = reading_unit(si, abs(value))
    return f"{factor * value:.4g} {unit}".replace("-", "−")
