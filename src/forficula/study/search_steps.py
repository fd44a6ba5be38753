"""Search for least values: the transitions that are searched and the values that are tried."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from forficula.quantities import Unit

# which values a search tries: all of them, or only those whose result does not follow from that of a larger value
Scan = Literal["bracket", "full"]


@dataclass(frozen=True, kw_only=True)
class SearchStep:
    """A transition whose least value is searched for.

    Attributes:
        transition: name of the transition, such as "fold".
        drive: name of its drive.
        state: name of the state that the transition leads to, such as "folded".
        done: one word for the outcome if the transition succeeds.
        missed: word for the outcome if the structure rests in its initial state, such as "did not fold".
        key: key of the design whose values are tried, such as "protocol.fold_torque".
        values: values to try in this order, SI, rising or falling; empty if this transition is not searched.
        unit: unit of the values.
        sign: sign of the drive. A value is multiplied by it before it is assigned to the key.
    """

    transition: str
    drive: str
    state: str
    done: str
    missed: str
    key: str
    values: tuple[float, ...]
    unit: Unit
    sign: float = 1.0

    @property
    def value_name(self) -> str:
        """Name of the values in tables, such as "fold_torque"."""
        return "_".join(self.key.split(".")[1:])

    @property
    def result_name(self) -> str:
        """Name of the result in tables, such as "least_fold_torque", or "largest_gust_force" if the values fall."""
        return f"{self.extreme}_{self.value_name}"

    @property
    def extreme(self) -> str:
        """Which successful value is the result, by size: "largest" if the values fall, else "least"."""
        return "largest" if self.values and abs(self.values[-1]) < abs(self.values[0]) else "least"


@dataclass(frozen=True, kw_only=True)
class Search:
    """Values to try in order to find the least ones with which a structure reaches its states.

    Attributes:
        first: search of the first transition.
        second: search of the next transition; None if there is none or if it is not searched.
        reference: value (SI) of the first transition's key while the second is searched.
        next_drive: drive of the transition after the first. The first transition's release ends before the stage of
            this drive. None if there is no such transition: every value then runs the whole protocol.
        start_state: name of the state before the first transition; "" if there is none.
        refinements: number of times the step below the least successful value is halved.
        scan: which values are tried. A "bracket" takes all values below one that stayed short of its goal to fail.
    """

    first: SearchStep
    second: SearchStep | None
    reference: float
    next_drive: str | None
    start_state: str
    refinements: int
    scan: Scan = "full"

    @property
    def steps(self) -> tuple[SearchStep, ...]:
        """The transitions that are searched."""
        return (self.first,) if self.second is None else (self.first, self.second)
