"""Steps that stay on a device: what the protocol, the energy balance and records need of them is fetched."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
import warp as wp

from forficula.arrays import Array, Indices
from forficula.dynamics.gpu import kernels
from forficula.dynamics.stepping.passage import Conditions, Passage
from forficula.dynamics.stepping.steps import Steps

# names of the columns of the result of `kernels.find_ends`
_NUMBERS = ("sound", "end", "carried_goal", "carried_rest", "goal_since")
_FLAGS = ("held", "resting", "reached", "met")


class DeviceValues:
    """Values of every step of structures on a device, (row, step, ...), in the place of an array.

    Two arrays of indices, of rows and of steps, fetch the values there; any other index fetches all values.
    """

    def __init__(self, kept: Any, rows: int, shape: tuple[int, ...]) -> None:
        """Refer to values.

        Args:
            kept: array on the device, (step, world, number).
            rows: number of structures, which are the first worlds.
            shape: of the values of one step of one structure.
        """
        self.kept, self.shape = kept, (rows, kept.shape[0], *shape)
        self._all: Array | None = None

    def __getitem__(self, index: Any) -> Array:
        """Return some values."""
        if isinstance(index, tuple) and len(index) == 2 and all(isinstance(part, np.ndarray) for part in index):
            return self.at(*index).reshape(len(index[0]), *self.shape[2:])
        return np.asarray(self.__array__()[index])

    def at(self, rows: Indices, steps: Indices, part: slice = slice(None)) -> Array:
        """Return the values of some rows at some steps, or columns of them, (value, column)."""
        first, last, _ = part.indices(self.kept.shape[2])
        values = wp.empty((len(rows), last - first), dtype=float, device=self.kept.device)
        places = [wp.array(numbers, dtype=int, device=self.kept.device) for numbers in (steps, rows)]
        wp.launch(
            kernels.gather, values.shape, inputs=[self.kept, *places, first], outputs=[values], device=self.kept.device
        )
        return np.asarray(values.numpy(), dtype=np.float64)

    def __array__(self, dtype: Any = None, copy: bool | None = None) -> Array:
        """Return all values."""
        del copy
        if self._all is None:
            fetched = self.kept.numpy()[:, : self.shape[0]].swapaxes(0, 1)
            self._all = np.ascontiguousarray(fetched, dtype=np.float64).reshape(self.shape)
        return np.asarray(self._all, dtype=dtype)


@dataclass(frozen=True, kw_only=True)
class DeviceSteps(Steps):
    """Steps whose states and derived fields are `DeviceValues`."""

    def passage(self, conditions: Conditions) -> Passage:
        """Return the passage of the structures through the steps, which the device finds."""
        states, lengths = self._values("after"), self._values("ten_length")
        device, rows = states.kept.device, len(self.before)
        watched = conditions.watched
        weights = np.zeros((conditions.least.shape[1], conditions.senses.shape[1]))
        weights[np.arange(len(watched.angles)), watched.hinges[watched.angles]] = 1.0
        if len(watched.sums):
            weights[-len(watched.sums) :, watched.hinges] = watched.sums
        tendons = np.full(len(weights), -1)
        first = len(watched.angles)
        tendons[first : first + len(watched.distances)] = conditions.distances[watched.distances]

        def put(struct: Any, kinds: dict[str, Any]) -> Any:
            filled = struct()
            for name, kind in kinds.items():
                values = np.ascontiguousarray(getattr(conditions, name))
                setattr(filled, name, wp.array(values, dtype=kind, device=device))
            return filled

        flags = dict.fromkeys(("has_bounds", "ends_at_rest", "may_stick"), wp.int32)
        numbers = dict.fromkeys(
            ("hold", "window", "taken", "start", "risen", "limit", "goal_since", "rest_since"), wp.int64
        )
        bounds = dict.fromkeys(("lowest", "highest", "rest_speed", "senses", "least", "most", "least_hold"), wp.float64)
        result = wp.empty((rows, len(_NUMBERS) + len(_FLAGS)), dtype=wp.int64, device=device)
        wp.launch(
            kernels.find_ends,
            rows,
            inputs=[
                self.count,
                self.positions,
                self.dof,
                states.kept,
                lengths.kept,
                wp.array(weights, dtype=wp.float64, device=device),
                wp.array(tendons, dtype=int, device=device),
                put(kernels.MotionBounds, bounds),
                put(kernels.StageNumbers, flags | numbers),
            ],
            outputs=[result],
            device=device,
        )
        columns = dict(zip((*_NUMBERS, *_FLAGS), result.numpy().T, strict=True))
        ended = {name: columns[name].astype(bool) for name in _FLAGS}
        return Passage(**{name: columns[name] for name in _NUMBERS}, **ended, arrived=ended["held"])

    def states(self, structure: Indices, taken: Indices, part: slice = slice(None)) -> Array:
        """Return the states, or parts of them, (state, number), for pairs of structures and numbers of steps."""
        states = self._values("after").at(structure, np.maximum(taken - 1, 0), part)
        states[taken == 0] = self.before[structure[taken == 0], part]
        return states

    def _values(self, name: str) -> DeviceValues:
        values: Any = self.after if name == "after" else self.derived[name]
        assert isinstance(values, DeviceValues)
        return values
