"""Run of a design: its record, and the outcome that is computed from the record when it is needed."""

from __future__ import annotations

import itertools
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any

from forficula.analysis.outcome import Outcome, measure
from forficula.arrays import Array
from forficula.design import Design
from forficula.dynamics import Record
from forficula.results import Result, pandas_module
from forficula.structure import Structure

if TYPE_CHECKING:
    import xarray

    from forficula.results import DataFrame


@dataclass(frozen=True, eq=False)
class Run(Result):
    """Run of a design through its protocol.

    Every function that accepts a record accepts a run. All attributes of the record are attributes of the run, too.

    Attributes:
        record: time series of the run.
    """

    record: Record

    @cached_property
    def outcome(self) -> Outcome:
        """States, transitions, verdict, uncertainty and energy balance of the run."""
        return measure(self.record)

    @property
    def design(self) -> Design:
        """Design that ran. A timestep "auto" is replaced by the timestep that was found."""
        return self.record.design

    @property
    def structure(self) -> Structure:
        """Structure that was built of the design, SI."""
        return self.record.structure

    @property
    def time(self) -> Array:
        """Times of the samples, s, (time,)."""
        return self.record.time

    @property
    def data(self) -> xarray.Dataset:
        """Time series with dimensions, coordinates and units."""
        return self.record.data

    def angles(self, role: str) -> Array:
        """Return the angles of the hinges of a role, in the hinges' own senses, rad, (time, hinge)."""
        return self.record.angles(role)

    def measured(self, name: str) -> Array:
        """Return the readings of a measure: angles, rad, (time, reading), or a distance, m, (time, 1).

        Raises:
            InputError: no such measure, and no hinges of a role of that name.
        """
        return self.record.measured(name)

    def to_dataframe(self) -> DataFrame:
        """Return the time series as a pandas table: one row per time, one column per series and part.

        A column of a part is named like "hinge_angle[vein 0 turn]"; that of a coordinate like "point_position[tip0 x]".
        Units are SI, in the table's `attrs["units"]` by name of the series.
        """
        pandas = pandas_module()

        columns: dict[str, Array] = {}
        units: dict[str, str] = {}
        for name, series in self.data.data_vars.items():
            if series.dims[:1] != ("time",):
                continue
            units[str(name)] = str(series.attrs.get("units", ""))
            if series.ndim == 1:
                columns[str(name)] = series.values
                continue
            labels = [series[dimension].values.tolist() for dimension in series.dims[1:]]
            parts = [" ".join(map(str, part)) for part in itertools.product(*labels)]
            values = series.values.reshape(len(self.time), -1)
            columns |= {f"{name}[{part}]": values[:, column] for column, part in enumerate(parts)}
        table = pandas.DataFrame(columns, index=pandas.Index(self.time, name="time"))
        table.attrs["units"] = units
        return table

    def __repr__(self) -> str:
        """Name of the design and outcome of the run."""
        return f"<Run of {self.design.name}: {self.outcome.status}>"

    def __getattr__(self, name: str) -> Any:
        # copies and unpickled objects have no record at first
        if name == "record" or name.startswith("__"):
            raise AttributeError(f"{type(self).__name__!r} object has no attribute {name!r}")
        return getattr(self.record, name)

    def __dir__(self) -> list[str]:
        """Names of the run and of its record."""
        return sorted({*super().__dir__(), *dir(self.record)})
