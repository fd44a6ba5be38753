"""How many runs of a study are done, and how many it needs."""

from __future__ import annotations

from collections.abc import Collection, Sequence

from forficula.study.journal import Row


class RunCount:
    """Runs done and needed, as far as results tell.

    What a search turns out to do without counts as done, so that what is needed never shrinks; it grows where results
    ask for more.

    Attributes:
        needed: runs, those done among them.
    """

    def __init__(self, done: int, later: int = 0, last_state: str = "") -> None:
        """Start with runs that are done, and points that come later, of which each counts as a run for now.

        Args:
            done: runs that are.
            later: points that come later.
            last_state: that a search ends with; of a run that reaches it, none with a larger value is tried.
        """
        self._last_state = last_state
        self.needed = done + later
        self._later, self._spare = later, 0
        self._open: set[str] = set()
        self._points: dict[str, Sequence[str]] = {}

    @property
    def done(self) -> int:
        """Runs done, or not needed any more."""
        return self.needed - len(self._open) - self._later

    def reach(self, points: int, done: int) -> None:
        """Take note of points that came later until now, and of their runs that are done already."""
        self._later -= points
        self._spare = max(points - done, 0)
        self.needed += max(done - points, 0)

    def plan(self, points: Collection[Sequence[str]]) -> None:
        """Take note of the keys of missing runs, by point and in the order in which they are tried."""
        self._points = {key: keys for keys in points for key in keys}
        self.needed += max(len(self._points.keys() - self._open) - self._spare, 0)
        self._spare = 0
        self._open = set(self._points)

    def count(self, row: Row) -> None:
        """Take note of a run that is done; after the one that reaches the last state, no larger value is tried."""
        self._open.discard(row["key"])
        if self._last_state and row.get(self._last_state):
            keys = self._points[row["key"]]
            self._open.difference_update(keys[keys.index(row["key"]) :])
