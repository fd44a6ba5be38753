"""A design beside what its parts make of it: barriers, holding torques, what runs come to, and what did it."""

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
    """A hinge that one tendon lies across, as designed and as made.

    Attributes:
        name: of the hinge.
        designed: over its range.
        made: alike.
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
        groups: as made.
        outcome: what it came to; None of what cannot be built.
        why: it cannot be built; mostly empty.
    """

    groups: Annotated[tuple[Group, ...], Key("as_made")]
    outcome: Annotated[Outcome | None, Written.NEVER]
    why: Annotated[str, Written.NEVER] = ""

    @property
    def held(self) -> Annotated[Mapping[str, bool | None], Key("holds")]:
        """By name of a state, whether it was reached and held; empty where nothing was run."""
        return {} if self.outcome is None else self.outcome.holds

    @property
    def status(self) -> Annotated[str, Written.ALWAYS]:
        """What it came to, in a few words."""
        return f"cannot be built: {self.why}" if self.outcome is None else self.outcome.status

    def holds(self, state: str) -> bool | None:
        """Whether a state was reached and held; None where the run tells nothing of it."""
        return self.held.get(state)


@dataclass(frozen=True, kw_only=True)
class Blame:
    """Which of what was made otherwise keeps the design from a state that it reaches as designed.

    Attributes:
        state: such as "folded".
        alone: groups each of which is enough to keep it from there, with all others as designed.
        mends: groups each of which is enough to let it get there again, put back as designed with all others as made.
        text: a sentence.
    """

    state: str
    alone: tuple[Group, ...]
    mends: tuple[Group, ...]
    text: str


@dataclass(frozen=True, kw_only=True)
class MadeComparison:
    """A design beside what its parts make of it.

    Attributes:
        designed: the design.
        made: as it is made.
        changes: its values that are other ones.
        unkept: what it cannot have of the parts.
        hinges: that one tendon lies across each.
        trials: runs: of the design, of it as made, and where the two differ with each group put back, and each alone;
            empty where nothing was to be run.
        blame: for each state that the design reaches and the design as made does not.
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
        """The run of the design; None where nothing was run."""
        return self.trials[0] if self.trials else None

    @property
    def as_made(self) -> MadeTrial | None:
        """The run of the design as made; None where nothing was run."""
        return self.trials[1] if self.trials else None

    @property
    def groups(self) -> tuple[Group, ...]:
        """Of what is otherwise."""
        return tuple(group for group in GROUPS if any(each.group == group for each in self.changes))


def made_comparison(
    parts: PartSet, simulate: bool = False, steps: Callable[[str], None] = lambda _: None
) -> MadeComparison:
    """Set a design beside what its parts make of it.

    Args:
        parts: with joints.
        simulate: whether to run both; where the design as made misses a state that the design reaches, also with each
            group of values put back, and with each alone.
        steps: is told what is done.

    Raises:
        InputError: as of `as_made`.

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
    steps("run it as designed and as made")
    groups = compared.groups
    trials = _trials(parts, values, [(), groups])
    lost = [state for state, held in _holds(trials[0]) if held and trials[1].holds(state) is False]
    if lost and len(groups) > 1:
        steps("run it with each change put back, and each alone")
        without = [tuple(each for each in groups if each != group) for group in groups]
        alone = [(group,) for group in groups]
        trials += _trials(parts, values, list(dict.fromkeys([*without, *alone])))
    return replace(compared, trials=tuple(trials), blame=tuple(_blame(state, groups, trials) for state in lost))


def comparison_or_why(
    parts: PartSet, simulate: bool = False, steps: Callable[[str], None] = lambda _: None
) -> MadeComparison | str:
    """As `made_comparison`; or why there is none, in a sentence: parts may be made that make no design."""
    try:
        return made_comparison(parts, simulate, steps)
    except InputError as error:
        return str(error)


def _hinges(designed: Design, made: Design) -> tuple[HingePair, ...]:
    """The hinges that one tendon lies across each, over their ranges."""
    before, after = structure_of(designed), structure_of(made)
    crossings = [before.tendons[tendon].crossing for tendon in crossing_tendons(before)]
    names = [before.hinges[crossing.hinge].name for crossing in crossings if crossing is not None]
    pairs = zip(names, tendon_hinges(before), tendon_hinges(after), strict=True)
    return tuple(
        HingePair(name=name, designed=hinge_landscape(here), made=hinge_landscape(there)) for name, here, there in pairs
    )


def _trials(parts: PartSet, values: MadeValues, chosen: Sequence[Collection[Group]]) -> list[MadeTrial]:
    """Run the design with some groups as made, one run for each choice."""
    built: dict[int, Design] = {}
    trials = {}
    for number, groups in enumerate(chosen):
        try:
            built[number] = as_made(parts, groups, values) if groups else parts.design
        except InputError as error:
            trials[number] = MadeTrial(groups=tuple(groups), outcome=None, why=str(error))
    order = list(built)
    for place, record in run_each([built[number] for number in order], sparse=True):
        groups = tuple(chosen[order[place]])
        if isinstance(record, InputError):
            trials[order[place]] = MadeTrial(groups=groups, outcome=None, why=str(record))
        else:
            trials[order[place]] = MadeTrial(groups=groups, outcome=measure(record))
    return [trials[number] for number in range(len(chosen))]


def _holds(trial: MadeTrial) -> list[tuple[str, bool | None]]:
    return [] if trial.outcome is None else list(trial.outcome.holds.items())


def _blame(state: str, groups: tuple[Group, ...], trials: Sequence[MadeTrial]) -> Blame:
    """Which groups keep the design from a state."""
    by_groups = {trial.groups: trial.holds(state) for trial in trials}
    alone = tuple(group for group in groups if by_groups.get((group,)) is False)
    mends = tuple(group for group in groups if by_groups.get(tuple(each for each in groups if each != group)) is True)
    return Blame(state=state, alone=alone, mends=mends, text=_sentence(state, groups, alone, mends))


def _sentence(state: str, groups: tuple[Group, ...], alone: tuple[Group, ...], mends: tuple[Group, ...]) -> str:
    """Which groups keep the design from a state, in words."""
    missed = f'as made it does not come to "{state}", as designed it does'
    if len(groups) == 1:
        return f"{missed}: nothing but the {groups[0]} differs."
    told = []
    if alone:
        told.append(f"{'each of ' if len(alone) > 1 else ''}the {listed(alone)} as made would do for that alone")
    else:
        told.append("no change is enough for that alone")
    if mends:
        told.append(f"with the {' or with the '.join(mends)} put back as designed it does")
    else:
        told.append("putting back any one of them is not enough")
    return f"{missed}: {', and '.join(told)}."
