"""Named changes of a design, which a study makes one at a time or in pairs."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

# a dimension of the table, and the coordinate that names its entries
CHANGE = "change"


@dataclass(frozen=True, kw_only=True)
class Change:
    """A named change of a design, such as a tendon that is removed or a coupling that is weakened.

    Attributes:
        name: name in tables and figures.
        values: changed values by dotted key, as in a design file.
    """

    name: str
    values: Mapping[str, object]


@dataclass(frozen=True, kw_only=True)
class OmittedPair:
    """A pair of changes that a study does not make together.

    Attributes:
        names: names of both changes.
        why: reason, in a clause.
    """

    names: tuple[str, str]
    why: str


@dataclass(frozen=True, kw_only=True)
class ChangePlan:
    """The changes that a study makes.

    Attributes:
        changes: the named changes.
        together: for every point, the indices of the changes that are made together; none for the unchanged design.
        omitted: pairs that are not made.
    """

    changes: tuple[Change, ...] = ()
    together: tuple[tuple[int, ...], ...] = ()
    omitted: tuple[OmittedPair, ...] = ()

    def __bool__(self) -> bool:
        """Whether there are changes."""
        return bool(self.changes)

    def names(self, point: int) -> tuple[str, ...]:
        """Return the names of the changes of a point."""
        return tuple(self.changes[index].name for index in self.together[point])

    def values(self, point: int) -> dict[str, object]:
        """Return all changed values of a point, by dotted key."""
        return together_values([self.changes[index] for index in self.together[point]])


NO_CHANGES = ChangePlan()


def together_values(changes: Sequence[Change]) -> dict[str, object]:
    """Return the values of several changes that set no key twice."""
    return {key: value for change in changes for key, value in change.values.items()}
