"""Comparison of a design with its made parts: barriers, holding torques, outcomes of runs, causes of differences."""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Annotated

from forficula.analysis import Outcome, measure
from forficula.design import Design
from forficula.design.design import DesignIdentity
from forficula.errors import InputError
from forficula.make.as_made import GROUPS, Group, MadeChange, as_made, changes
from forficula.make.made_values import MadeValues, made_values
from forficula.make.part import PartSet
from forficula.make.unkept import Unkept, unkept
from forficula.names import listed
from forficula.serial import Key, WithUnit, Written
from forficula.statics import HingeLandscape, hinge_landscape, tendon_hinges
from forficula.structure import crossing_tendons, structure_of
from forficula.study.running.runs import run_each


@dataclass(frozen=True, kw_only=True)
class HingePair:
    """A hinge with one tendon across it, as designed and as made.

    Attributes:
        name: name of the hinge.
        designed: landscape over its range, as designed.
        made: landscape over its range, as made.
    """

    name: Annotated[str, Key("hinge")]
    designed: Annotated[HingeLandscape, Written.NEVER]
    made: Annotated[HingeLandscape, Written.NEVER]

    @property
    def as_designed(self) -> Annotated[Mapping[str, WithUnit], Key("designed")]:
        """Barrier, holding torque and inertia as designed."""
        return _hinge_numbers(self.designed)

    @property
    def as_made(self) -> Annotated[Mapping[str, WithUnit], Key("made")]:
        """Barrier, holding torque and inertia as made."""
        return _hinge_numbers(self.made)


def _hinge_numbers(hinge: HingeLandscape) -> dict[str, WithUnit]:
    angle = None if hinge.barrier_angle is None else hinge.sense * hinge.barrier_angle
    return {
        "barrier": WithUnit(hinge.barrier, "J"),
        "barrier_angle": WithUnit(angle, "rad"),
        "holding_torque": WithUnit(hinge.holding_torque, "N m"),
        "inertia": WithUnit(hinge.hinge.inertia, "kg m^2"),
    }


@dataclass(frozen=True, kw_only=True)
class MadeTrial:
    """A run with the values of some groups as made, and all others as designed.

    Attributes:
        groups: groups of values that are as made.
        outcome: outcome of the run; None if the design cannot be built.
        why: reason why it cannot be built, else empty.
    """

    groups: Annotated[tuple[Group, ...], Key("as_made")]
    outcome: Annotated[Outcome | None, Written.NEVER]
    why: Annotated[str, Written.NEVER] = ""

    @property
    def held(self) -> Annotated[Mapping[str, bool | None], Key("holds")]:
        """Whether each state was reached and held, by its name; empty without a run."""
        return {} if self.outcome is None else self.outcome.holds

    @property
    def status(self) -> Annotated[str, Written.ALWAYS]:
        """Outcome in a few words."""
        return f"cannot be built: {self.why}" if self.outcome is None else self.outcome.status

    def holds(self, state: str) -> bool | None:
        """Return whether a state was reached and held; None if the run has no answer."""
        return self.held.get(state)


@dataclass(frozen=True, kw_only=True)
class Blame:
    """Causes why the made design misses a state that the designed one reaches.

    Attributes:
        state: such as "folded".
        alone: groups whose change alone, with all others as designed, makes the design miss the state.
        mends: groups that restore the state if they are as designed, with all others as made.
        text: a sentence.
    """

    state: str
    alone: tuple[Group, ...]
    mends: tuple[Group, ...]
    text: str


@dataclass(frozen=True, kw_only=True)
class MadeComparison:
    """Comparison of a design with its made parts.

    Attributes:
        designed: the design.
        made: the design as made.
        changes: values that differ.
        unkept: features of the design that the parts do not have.
        hinges: hinges with one tendon across each.
        trials: runs of the design and of the design as made. If these differ, also runs with each group as designed,
            and with each group alone as made. Empty without simulation.
        blame: causes for each state that only the designed one reaches.
    """

    designed: Annotated[Design, Written.NEVER]
    made: Annotated[Design, Written.NEVER]
    changes: tuple[MadeChange, ...]
    unkept: tuple[Unkept, ...]
    hinges: tuple[HingePair, ...]
    trials: Annotated[tuple[MadeTrial, ...], Key("runs")] = ()
    blame: tuple[Blame, ...] = ()

    @property
    def identity(self) -> Annotated[DesignIdentity, Written.BESIDE, Written.FIRST]:
        """Name and hash of the design."""
        return self.designed.identity

    @property
    def made_hash(self) -> Annotated[str, Written.FIRST]:
        """Hash of the design as made."""
        return self.made.hash

    @property
    def as_designed(self) -> MadeTrial | None:
        """Run of the design; None without simulation."""
        return self.trials[0] if self.trials else None

    @property
    def as_made(self) -> MadeTrial | None:
        """Run of the design as made; None without simulation."""
        return self.trials[1] if self.trials else None

    @property
    def groups(self) -> tuple[Group, ...]:
        """Groups of values that differ."""
        return tuple(group for group in GROUPS if any(change.group == group for change in self.changes))


def made_comparison(
    parts: PartSet, simulate: bool = False, steps: Callable[[str], None] = lambda _: None
) -> MadeComparison:
    """Compare a design with its made parts.

    Args:
        parts: parts with joints.
        simulate: whether to run both. If the design as made misses a state that the design reaches, it is also run with
            each group as designed, and with each group alone as made.
        steps: called with a text for each step.

    Raises:
        InputError: see `as_made`.

    Example:
        >>> from forficula.make.make_parts import make_parts
        >>> compared = made_comparison(make_parts("binder2025", "joint"))
        >>> compared.groups
        ('stops', 'stiffness', 'masses')
    """
    steps("measure parts")
    values = made_values(parts)
    made = as_made(parts, values=values)
    compared = MadeComparison(
        designed=parts.design,
        made=made,
        changes=changes(parts, made),
        unkept=unkept(parts, made),
        hinges=_hinges(parts.design, made),
    )
    if not simulate:
        return compared
    steps("run the design as designed and as made")
    groups = compared.groups
    trials = _trials(parts, values, [(), groups])
    missed = [state for state, held in _holds(trials[0]) if held and trials[1].holds(state) is False]
    if missed and len(groups) > 1:
        steps("run the design without each change, and with each change alone")
        without = [tuple(kept for kept in groups if kept != group) for group in groups]
        alone = [(group,) for group in groups]
        trials += _trials(parts, values, list(dict.fromkeys([*without, *alone])))
    return replace(compared, trials=tuple(trials), blame=tuple(_blame(state, groups, trials) for state in missed))


def comparison_or_why(
    parts: PartSet, simulate: bool = False, steps: Callable[[str], None] = lambda _: None
) -> MadeComparison | str:
    """Return `made_comparison`, or a sentence that says why there is none: not all parts correspond to a design."""
    try:
        return made_comparison(parts, simulate, steps)
    except InputError as error:
        return str(error)


def _hinges(designed: Design, made: Design) -> tuple[HingePair, ...]:
    """Return the hinges with one tendon across each, over their ranges."""
    before, after = structure_of(designed), structure_of(made)
    crossings = [before.tendons[tendon].crossing for tendon in crossing_tendons(before)]
    names = [before.hinges[crossing.hinge].name for crossing in crossings if crossing is not None]
    pairs = zip(names, tendon_hinges(before), tendon_hinges(after), strict=True)
    return tuple(
        HingePair(name=name, designed=hinge_landscape(hinge_before), made=hinge_landscape(hinge_after))
        for name, hinge_before, hinge_after in pairs
    )


def _trials(parts: PartSet, values: MadeValues, chosen: Sequence[Collection[Group]]) -> list[MadeTrial]:
    """Run the design with each choice of groups as made."""
    designs: dict[int, Design] = {}
    trials = {}
    for choice, groups in enumerate(chosen):
        try:
            designs[choice] = as_made(parts, groups, values) if groups else parts.design
        except InputError as error:
            trials[choice] = MadeTrial(groups=tuple(groups), outcome=None, why=str(error))
    order = list(designs)
    for index, record in run_each([designs[choice] for choice in order], sparse=True):
        groups = tuple(chosen[order[index]])
        if isinstance(record, InputError):
            trials[order[index]] = MadeTrial(groups=groups, outcome=None, why=str(record))
        else:
            trials[order[index]] = MadeTrial(groups=groups, outcome=measure(record))
    return [trials[choice] for choice in range(len(chosen))]


def _holds(trial: MadeTrial) -> list[tuple[str, bool | None]]:
    return [] if trial.outcome is None else list(trial.outcome.holds.items())


def _blame(state: str, groups: tuple[Group, ...], trials: Sequence[MadeTrial]) -> Blame:
    """Return the groups that make the design miss a state."""
    by_groups = {trial.groups: trial.holds(state) for trial in trials}
    alone = tuple(group for group in groups if by_groups.get((group,)) is False)
    mends = tuple(group for group in groups if by_groups.get(tuple(kept for kept in groups if kept != group)) is True)
    return Blame(state=state, alone=alone, mends=mends, text=_sentence(state, groups, alone, mends))


def _sentence(state: str, groups: tuple[Group, ...], alone: tuple[Group, ...], mends: tuple[Group, ...]) -> str:
    """Return a sentence on the groups that make the design miss a state."""
    missed = f'the design reaches "{state}" as designed, but not as made'
    if len(groups) == 1:
        return f"{missed}; the only difference is in the {groups[0]}."
    if alone:
        causes = f"{'each of ' if len(alone) > 1 else ''}the {listed(alone)} as made would alone prevent this"
    else:
        causes = "no single change prevents this"
    if mends:
        repairs = f"it is reached again with the {' or the '.join(mends)} as designed"
    else:
        repairs = "undoing a single change does not restore it"
    return f"{missed}: {causes}, and {repairs}."
