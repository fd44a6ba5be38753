"""What a search looks for: the transitions whose least values it finds, and the values that it tries."""

from __future__ import annotations

from dataclasses import dataclass

from forficula.quantities import Unit


@dataclass(frozen=True, kw_only=True)
class SearchStep:
    """A transition whose least value is looked for.

    Attributes:
        transition: its name, such as "fold".
        drive: name of its drive.
        state: name of the state that it leads to, such as "folded".
        done: what it comes to where it succeeds, in a word.
        key: of the design's value that is tried, such as "protocol.fold_torque".
        values: that are tried, SI, one after another, rising or falling; none where it is not asked for.
        unit: of the values.
        sign: by which a value is multiplied before it is the key's: that of the drive.
    """

    transition: str
    drive: str
    state: str
    done: str
    key: str
    values: tuple[float, ...]
    unit: Unit
    sign: float = 1.0

    @property
    def value_name(self) -> str:
        """What tables call the values, such as "fold_torque"."""
        return "_".join(self.key.split(".")[1:])

    @property
    def least_name(self) -> str:
        """What tables call the least value that does it, such as "least_fold_torque"."""
        return f"least_{self.value_name}"


@dataclass(frozen=True, kw_only=True)
class Search:
    """Which values are tried for the least that bring a structure to its states.

    Attributes:
        first: the first transition.
        second: the next one; None where there is none, or where it is not asked for.
        reference: value of the first one's key, SI, at which the second one is tried.
        next_drive: of the transition after the first one, before whose stage its release ends; None where there is
            none: the whole protocol then runs with every value.
        start_state: name of the state before the first transition; "" where there is none.
        refinements: how often the step below the least value that worked is halved.
    """

    first: SearchStep
    second: SearchStep | None
    reference: float
    next_drive: str | None
    start_state: str
    refinements: int

    @property
    def steps(self) -> tuple[SearchStep, ...]:
        """The transitions that are asked for."""
        return (self.first,) if self.second is None else (self.first, self.second)
