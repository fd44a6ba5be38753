"""The binary series files of ZwickRoell testXpert, through zs2decode (MIT, an optional extra)."""

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
from forficula.quantities import as_written

_CHANNELS = ("SeriesDef", "TestTaskDefs", "Elem0", "ChannelManager", "ChannelManager")
_SERIES = ("Series", "SeriesElements")
_DATA = ("SeriesElements", "Elem0", "RealTimeCapture", "Trs", "SingleGroupDataBlock", "DataChannels")
# The format is not published. Three independent readers of it take measured values in these units of its unit tables:
# borisgerretzen/zs2decode (mm, N), weltidom/zs2fast (mm, N, s) and a reader of its channels 40400, 40402 and 40403.
_UNITS = {"UT_Time": "s", "UT_Force": "N", "UT_Displacement": "mm", "UT_Stress": "MPa", "UT_Ratio": "%"}
_MARK = b"\xaf\xbe\xad\xde"
_LARGEST, _PIECE = 2**28, 2**20  # bytes, unpacked
_ARRAY = "DataArray"
_WANTED = frozenset({_ARRAY, "TrsChannelId", "ID", "Text", "UnitTableName"})
_SECTION, _NO_LIST = b"\xdd", b"\xee" + bytes(6)
_FLOATS = {b"\xee\x04\x00": "<f4", b"\xee\x05\x00": "<f8"}

Place = tuple[str, ...]


@dataclass(frozen=True, kw_only=True)
class _Channel:
    """What a channel of the series is called, and its unit."""

    name: str
    unit: str


def parse_zs2(content: bytes, name: str) -> tuple[Recording, ...]:
    """Read the specimens of a series.

    Their sizes are not read: which of the file's numbered parameters holds them differs between test programs.

    Args:
        content: of the file.
        name: of the series; its specimens get a number where there are several.

    Raises:
        InputError: zs2decode is not installed, the file is cut off or no .zs2, or a specimen has no time, travel or
            force.
    """
    values = _values(_stream(content))
    channels = _channels(values)
    series = _below(values, _SERIES)
    specimens = dict.fromkeys(place[0] for place in series)
    found = [_columns(_below(series, (specimen, *_DATA)), channels) for specimen in specimens]
    measured = [columns for columns in found if columns]
    if not measured:
        raise InputError("need a series with measured values, found none")
    names = [name] if len(measured) == 1 else [f"{name} {number}" for number in range(1, len(measured) + 1)]
    return tuple(_recording(each, columns) for each, columns in zip(names, measured, strict=True))


def _stream(content: bytes) -> bytearray:
    """The unpacked file; zs2decode takes a path only, so this one step is done here.

    It is unpacked piece by piece: a few kilobytes may hold more than any memory.
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
    """Every value of the file by its place below Body/batch."""
    try:
        from zs2decode import parser
    except ImportError:
        raise InputError('a .zs2 is read by zs2decode; pip install "forficula[zs2]"') from None
    try:
        raw = parser.data_stream_to_chunks(stream)
        arrays = {address: _array(bytes(data)) for address, name, data in raw if name == _ARRAY}
        chunks = parser.parse_chunks([_slim(chunk) for chunk in raw if _matters(*chunk[1:])])
    except Exception as error:  # a broken file raises whatever the broken place raises
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
    """Whether a chunk opens or ends a section, or holds what is asked for: a file has 100 000 others."""
    return name is None or name in _WANTED or data[:1] == _SECTION


def _slim(chunk: list[Any]) -> list[Any]:
    """A chunk without its array: zs2decode turns the single precision of 100 000 samples into text and back, in 2 s."""
    address, name, data = chunk
    return [address, name, bytearray(_NO_LIST) if name == _ARRAY else data]


def _array(data: bytes) -> Array | None:
    """The samples of a channel, shape (row,): a byte 0xEE, the kind of number, how many, and the numbers."""
    kind = _FLOATS.get(data[:3])
    return None if kind is None else np.frombuffer(data[7:], dtype=kind).astype(np.float64)


def _below(values: dict[Place, object], place: Sequence[str]) -> dict[Place, object]:
    """The values below a place."""
    depth = len(place)
    return {key[depth:]: value for key, value in values.items() if key[:depth] == tuple(place) and len(key) > depth}


def _channels(values: dict[Place, object]) -> dict[object, _Channel]:
    """The channels of the series by their number."""
    parts: dict[str, dict[Place, object]] = defaultdict(dict)
    for (element, *rest), value in _below(values, _CHANNELS).items():
        parts[element][tuple(rest)] = value
    return {
        part["ID",]: _Channel(name=str(part.get(("Name", "Text"), "")), unit=_unit(part.get(("UnitTableName",))))
        for part in parts.values()
        if ("ID",) in part
    }


def _unit(table: object) -> str:
    """The unit of a unit table, or the table's name, so that an error can say it."""
    return _UNITS.get(str(table), str(table)) if table else ""


def _columns(data: dict[Place, object], channels: dict[object, _Channel]) -> dict[str, RecordedColumn]:
    """The columns of one specimen by role; none where nothing was measured."""
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
    """One specimen as a file of text would have it, without lines."""
    time, travel, force = columns["time"], travel_among(columns), columns["force"]
    rows = {each.name: len(each.values) for each in (time, travel, force)}
    if len(set(rows.values())) > 1:
        raise InputError(f"{name}: need channels of one length, got {rows}")
    lines = np.zeros(len(time.values), dtype=np.int64)
    return Recording(name=name, time=time, travel=travel, force=force, properties=(), names_line=0, lines=lines)
