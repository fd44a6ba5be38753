"""All measures and series of a run as one table of comma-separated values."""

from __future__ import annotations

import itertools

import numpy as np

from forficula.arrays import Array
from forficula.csv_text import csv_text
from forficula.dynamics import Record
from forficula.show.structure.labels import measure_labels


def csv_table(record: Record) -> str:
    """Return a run as a table: one row per sample, one column per reading, with its SI unit in the header."""
    columns: dict[str, Array] = {"time (s)": record.time}
    for measure in record.structure.measures:
        unit = "m" if measure.kind == "distance" else "rad"
        readings = record.measured(measure.name)
        labels = measure_labels(record.structure, measure)
        for column, label in enumerate(labels):
            name = measure.name if readings.shape[1] == 1 else f"{measure.name}[{label}]"
            columns[f"measure {name} ({unit})"] = readings[:, column]
    for key, series in record.data.data_vars.items():
        if series.dims[:1] != ("time",):
            continue
        names = [series[dimension].values.tolist() for dimension in series.dims[1:]]
        parts = [" ".join(map(str, part)) for part in itertools.product(*names)]
        values = np.asarray(series.values).reshape(len(record.time), -1)
        name, unit = str(key), str(series.attrs.get("units", ""))
        for column, part in enumerate(parts):
            columns[f"{name}[{part}] ({unit})" if part else f"{name} ({unit})"] = values[:, column]
    rows = np.stack(list(columns.values()), axis=1).tolist()
    return csv_text([list(columns), *rows])
