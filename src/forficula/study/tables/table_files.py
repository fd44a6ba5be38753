"""Tables of studies as files. A file of many points is written block by block and compressed."""

from __future__ import annotations

from itertools import islice
from pathlib import Path
from typing import TYPE_CHECKING, Any

from forficula.files import replacing
from forficula.optional_module import optional_module
from forficula.study.study import Study
from forficula.study.tables.table_rows import column_types, csv_lines, json_rows

if TYPE_CHECKING:
    import xarray

# Number of points from which a netCDF file is compressed; smaller ones take less than 2 MB. [chosen]
_MANY = 10_000
# Number of rows of a Parquet file that are written together. [chosen]
_BLOCK = 50_000


def write_netcdf(table: xarray.Dataset, path: Path) -> None:
    """Write a table as netCDF, from which xarray reads single columns and slices; that of many points is compressed.

    Raises:
        InputError: the file cannot be written.
    """
    encoding: dict[str, dict[str, Any]] = {}
    for name, values in table.variables.items():
        if values.size >= _MANY:
            # only texts of one length can be compressed
            fixed = {"dtype": "S1"} if values.dtype.kind == "O" else {"shuffle": True}
            encoding[str(name)] = {"zlib": True, "complevel": 4, **fixed}
    with replacing(path) as temporary:
        table.to_netcdf(temporary, engine="h5netcdf", encoding=encoding)


def write_csv(study: Study, table: xarray.Dataset, path: Path) -> None:
    """Write a table as CSV, line by line.

    Raises:
        InputError: the file cannot be written.
    """
    with replacing(path) as temporary, temporary.open("w", encoding="utf-8", newline="\n") as file:
        file.writelines(csv_lines(study, table))


def check_parquet() -> None:
    """Check that the library that writes Parquet is installed.

    Raises:
        InputError: it is not.
    """
    _pyarrow()


def write_parquet(study: Study, table: xarray.Dataset, path: Path) -> None:
    """Write a table as Parquet with the columns of the CSV file, block by block.

    Raises:
        InputError: pyarrow is not installed, or the file cannot be written.
    """
    pyarrow = _pyarrow()
    parquet = optional_module("pyarrow.parquet", "Parquet needs pyarrow", "pyarrow")
    types = column_types(study, table)
    kinds = {float: pyarrow.float64(), int: pyarrow.int64(), bool: pyarrow.bool_(), str: pyarrow.string()}
    schema = pyarrow.schema([(name, kinds[kind]) for name, kind in types.items()])
    rows = json_rows(study, table)
    with replacing(path) as temporary, parquet.ParquetWriter(temporary, schema, compression="zstd") as writer:
        while block := list(islice(rows, _BLOCK)):
            columns = {
                name: [None if row[name] is None else kind(row[name]) for row in block] for name, kind in types.items()
            }
            writer.write_table(pyarrow.table(columns, schema=schema))


def _pyarrow() -> Any:
    return optional_module("pyarrow", "Parquet needs pyarrow", "pyarrow")
