"""Reading of binary series files of ZwickRoell testXpert with zs2decode (MIT, an optional extra)."""

from __future__ import annotations

import gzip
import io
import zlib
from collections import defaultdict
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from forficula.arrays import Array
from forficula.errors import InputError
from forficula.material.machine.machine_names import choose_columns
from forficula.material.machine.recording import RecordedColumn, Recording, travel_among
from forficula.optional_module import optional_module
from forficula.quantities import as_written

_CHANNELS = ("SeriesDef", "TestTaskDefs", "Elem0", "ChannelManager", "ChannelManager")
_SERIES = ("Series", "SeriesElements")
_DATA = ("SeriesElements", "Elem0", "RealTimeCapture", "Trs", "SingleGroupDataBlock", "DataChannels")
# The format is not published. Three independent readers interpret values with these unit tables in these units:
# borisgerretzen/zs2decode (mm, N), weltidom/zs2fast (mm, N, s) and a reader of the channels 40400, 40402 and 40403.
_UNITS = {"UT_Time": "s", "UT_Force": "N", "UT_Displacement": "mm", "UT_Stress": "MPa", "UT_Ratio": "%"}
_MARK = b"\xaf\xbe\xad\xde"
_LARGEST, _PIECE = 2**28, 2**20  # bytes, largest unpacked file, and size of pieces
_ARRAY = "DataArray"
_WANTED = frozenset({_ARRAY, "TrsChannelId", "ID", "Text", "UnitTableName"})
_SECTION, _NO_LIST = b"\xdd", b"\xee" + bytes(6)
_FLOATS = {b"\xee\x04\x00": "<f4", b"\xee\x05\x00": "<f8"}

Place = tuple[str, ...]


@dataclass(frozen=True, kw_only=True)
class _Channel:
    """Name and unit of a channel of the series."""

    name: str
    unit: str


def parse_zs2(content: bytes, name: str) -> tuple[Recording, ...]:
    """Read the specimens of a series.

    Their sizes are not read, because the numbers of the parameters with the sizes differ between test programs.

    Args:
        content: content of the file.
        name: name of the series; a number is added for each specimen if there are several.

    Raises:
        InputError: zs2decode is not installed, the file is cut off or not a .zs2 file, or a specimen has no time,
            travel or force.
    """
    values = _values(_stream(content))
    channels = _channels(values)
    series = _below(values, _SERIES)
    specimens = dict.fromkeys(place[0] for place in series)
    columns_of_specimens = [_columns(_below(series, (specimen, *_DATA)), channels) for specimen in specimens]
    measured = [columns for columns in columns_of_specimens if columns]
    if not measured:
        raise InputError("need a series with measured values, found none")
    names = [name] if len(measured) == 1 else [f"{name} {number}" for number in range(1, len(measured) + 1)]
    return tuple(_recording(specimen, columns) for specimen, columns in zip(names, measured, strict=True))


def _stream(content: bytes) -> bytearray:
    """Unpack the file; zs2decode would need a path for this step.

    The file is unpacked in pieces, because a few packed kilobytes may contain more data than fits into memory.
    """
    stream = bytearray()
    try:
        with gzip.open(io.BytesIO(content)) as packed:
            stream += packed.read(len(_MARK))
            while stream.startswith(_MARK) and (piece := packed.read(_PIECE)):
                stream += piece
                if len(stream) > _LARGEST:
                    raise InputError(f"need a .zs2 of at most {_LARGEST // 2**20} MiB unpacked, got more")
    except EOFError:
        raise InputError("need a whole .zs2, got one that is cut off") from None
    except (OSError, zlib.error):
        raise InputError("need a .zs2 of ZwickRoell testXpert, got something else") from None
    if not stream.startswith(_MARK):
        raise InputError("need a .zs2 of ZwickRoell testXpert, got something else")
    return stream


def _values(stream: bytearray) -> dict[Place, object]:
    """Return all values of the file by their path below Body/batch."""
    parser = optional_module("zs2decode.parser", "a .zs2 file needs zs2decode", "forficula[zs2]")
    try:
        raw = parser.data_stream_to_chunks(stream)
        arrays = {address: _array(bytes(data)) for address, name, data in raw if name == _ARRAY}
        chunks = parser.parse_chunks([_slim(chunk) for chunk in raw if _matters(*chunk[1:])])
    except Exception as error:  # a damaged file may raise any exception
        reason = " ".join(str(error).split())
        raise InputError(f"need a whole .zs2, got one that cannot be decoded ({as_written(reason)})") from None
    values: dict[Place, object] = {}
    place: list[str] = []
    for address, name, kind, value in chunks:
        if kind == "end":
            place = place[:-1]
        elif kind == "DD":
            place.append(name)
        else:
            values[(*place, name)] = arrays[address] if name == _ARRAY else value
    batch = next((key.index("batch") + 1 for key in values if "batch" in key), None)
    if batch is None:
        raise InputError("need a series of tests, found none")
    return {key[batch:]: value for key, value in values.items()}


def _matters(name: str | None, data: bytearray) -> bool:
    """Return whether a chunk begins or ends a section, or has a needed value; a file has 100 000 other chunks."""
    return name is None or name in _WANTED or data[:1] == _SECTION


def _slim(chunk: list[Any]) -> list[Any]:
    """Return a chunk without its array, because zs2decode needs 2 s to convert 100 000 samples to text and back."""
    address, name, data = chunk
    return [address, name, bytearray(_NO_LIST) if name == _ARRAY else data]


def _array(data: bytes) -> Array | None:
    """Decode the samples of a channel, shape (row,): a byte 0xEE, the type of number, their count, and the numbers."""
    kind = _FLOATS.get(data[:3])
    return None if kind is None else np.frombuffer(data[7:], dtype=kind).astype(np.float64)


def _below(values: dict[Place, object], place: Sequence[str]) -> dict[Place, object]:
    """Return the values below a path."""
    depth = len(place)
    return {key[depth:]: value for key, value in values.items() if key[:depth] == tuple(place) and len(key) > depth}


def _channels(values: dict[Place, object]) -> dict[object, _Channel]:
    """Return the channels of the series by number."""
    parts: dict[str, dict[Place, object]] = defaultdict(dict)
    for (element, *rest), value in _below(values, _CHANNELS).items():
        parts[element][tuple(rest)] = value
    return {
        part["ID",]: _Channel(name=str(part.get(("Name", "Text"), "")), unit=_unit(part.get(("UnitTableName",))))
        for part in parts.values()
        if ("ID",) in part
    }


def _unit(table: object) -> str:
    """Return the unit of a unit table, or the name of an unknown table, for error messages."""
    return _UNITS.get(str(table), str(table)) if table else ""


def _columns(data: dict[Place, object], channels: dict[object, _Channel]) -> dict[str, RecordedColumn]:
    """Return the columns of one specimen by role; none if nothing was measured."""
    arrays: dict[object, Array] = {}
    for element in dict.fromkeys(place[0] for place in data):
        values, number = data.get((element, "DataArray")), data.get((element, "TrsChannelId"))
        if isinstance(values, np.ndarray) and len(values) and number in channels:
            arrays[number] = values
    if not arrays:
        return {}
    numbers = list(arrays)
    places = choose_columns([channels[number].name for number in numbers])
    columns = {role: numbers[place] for role, place in places.items()}
    return {
        role: RecordedColumn(name=channels[number].name, unit=channels[number].unit, values=arrays[number])
        for role, number in columns.items()
    }


def _recording(name: str, columns: dict[str, RecordedColumn]) -> Recording:
    """Return one specimen in the same form as that of a text file, but without lines."""
    time, travel, force = columns["time"], travel_among(columns), columns["force"]
    rows = {column.name: len(column.values) for column in (time, travel, force)}
    if len(set(rows.values())) > 1:
        raise InputError(f"{name}: need channels of one length, got {rows}")
    lines = np.zeros(len(time.values), dtype=np.int64)
    return Recording(name=name, time=time, travel=travel, force=force, properties=(), names_line=0, lines=lines)
