"""The content of a FOLD file: its JSON, its frames with the keys that they inherit, and the choice of a frame."""

from __future__ import annotations

import json
from collections.abc import Sequence
from pathlib import Path
from typing import NoReturn

from forficula.errors import InputError
from forficula.files import read_bytes
from forficula.names import one_of
from forficula.quantities import as_written

FoldFrame = dict[str, object]


def fold_document(file: Path) -> FoldFrame:
    """Parse the JSON of a file; the result is also the key frame.

    Raises:
        InputError: the file cannot be read, or is not a FOLD file of version 1.
    """
    try:
        document = json.loads(read_bytes(file).decode("utf-8-sig"), parse_constant=_refuse_constant)
    except InputError:
        raise
    except json.JSONDecodeError as error:
        reason = f"{error.msg} (at line {error.lineno}, column {error.colno})"
        raise InputError(f"need JSON, as FOLD files are: {reason}") from error
    except UnicodeDecodeError as error:
        raise InputError(f"need JSON, as FOLD files are: not UTF-8 text from byte {error.start} on") from error
    except (ValueError, RecursionError) as error:
        reason = "nested too deeply" if isinstance(error, RecursionError) else "a whole number has too many digits"
        raise InputError(f"need JSON, as FOLD files are: {reason}") from error
    if not isinstance(document, dict):
        raise InputError(f"need a JSON object with FOLD keys, got {type(document).__name__}")
    spec = document.get("file_spec", 1)
    if isinstance(spec, bool) or not isinstance(spec, int | float) or not 1 <= spec < 2:
        raise InputError(f"file_spec: need a version from 1 to below 2 of the FOLD format, got {as_written(spec)}")
    return document


def _refuse_constant(name: str) -> NoReturn:
    """Raise InputError for NaN and Infinity, which are not part of JSON."""
    raise InputError(f"need finite numbers only, got {name}")


def list_at(frame: FoldFrame, key: str) -> list[object]:
    """Return the list of a key that is required.

    Raises:
        InputError: the key is missing, or its value is not a list.
    """
    if key not in frame:
        raise InputError(f"{key}: need a list, but the key is missing")
    values = frame[key]
    if not isinstance(values, list):
        raise InputError(f"{key}: need a list, got {type(values).__name__}")
    return values


def all_frames(document: FoldFrame) -> list[FoldFrame]:
    """List the frames of a file, the key frame first, with the keys that they inherit from their parents.

    A frame that inherits without a parent inherits from the key frame, as Origami Simulator writes it. Every frame
    without a `frame_unit` has that of the file.

    Raises:
        InputError: a frame is not an object, has a parent that does not exist, inherits from itself, or has another
            number of vertices than the parent whose edges it inherits.
    """
    others = list_at(document, "file_frames") if "file_frames" in document else []
    known = {0: document}
    for number in range(len(others)):
        try:
            _inherit(others, number + 1, known)
        except InputError as error:
            raise InputError(f"file_frames[{number}]: {error}") from error
    unit = {"frame_unit": document.get("frame_unit")}
    return [document, *(unit | known[number + 1] for number in range(len(others)))]


def _inherit(frames: Sequence[object], number: int, known: dict[int, FoldFrame]) -> None:
    """Add a frame with its inherited keys to the known frames; number 0 is the key frame.

    Parents are looked up in a loop and not by recursion, because the chain of parents of an animation can be long.
    """
    below: dict[int, FoldFrame] = {}
    while number not in known:
        frame = frames[number - 1]
        if not isinstance(frame, dict):
            raise InputError(f"need a JSON object with FOLD keys, got {type(frame).__name__}")
        if frame.get("frame_inherit", False) is not True:
            known[number] = frame
            break
        below[number] = frame
        number = _parent(frame, len(frames))
        if number in below:
            raise InputError(f"frame_parent: need a parent that does not inherit from the frame itself, got {number}")
    above = known[number]
    for number, frame in reversed(below.items()):
        if "vertices_coords" in frame and "vertices_coords" in above and "edges_vertices" not in frame:
            count, needed = (len(list_at(item, "vertices_coords")) for item in (frame, above))
            if count != needed:
                raise InputError(f"vertices_coords: need {needed} positions, as many as in the parent, got {count}")
        above = known[number] = above | frame


def _parent(frame: FoldFrame, count: int) -> int:
    """Return the number of the parent of a frame."""
    parent = frame.get("frame_parent", 0)
    if isinstance(parent, bool) or not isinstance(parent, int) or not 0 <= parent <= count:
        raise InputError(f"frame_parent: need the number of a frame, 0 to {count}, got {as_written(parent)}")
    return parent


def frame_classes(frame: FoldFrame) -> list[object]:
    """Return the classes of a frame, such as "creasePattern" or "foldedForm".

    Raises:
        InputError: the classes are not a list.
    """
    return list_at(frame, "frame_classes") if "frame_classes" in frame else []


def chosen_frame(frames: Sequence[FoldFrame], chosen: int | str | None) -> int:
    """Find the number of the chosen frame.

    Args:
        frames: frames of a file, as `all_frames` lists them.
        chosen: a number, 0 for the key frame; a title; or a class, for the first frame with this class. With None: the
            key frame, or, if it has no vertices, the first crease pattern with vertices, or else the first frame with
            vertices.

    Raises:
        InputError: there is no such frame.
    """
    if chosen is None:
        placed = [number for number, frame in enumerate(frames) if frame.get("vertices_coords")]
        if "vertices_coords" in frames[0] or not placed:
            return 0
        return next((number for number in placed if "creasePattern" in frame_classes(frames[number])), placed[0])
    if isinstance(chosen, bool) or not isinstance(chosen, int | str):
        raise InputError(f"frame: need a number or a title, got {as_written(chosen)}")
    if isinstance(chosen, int):
        if not 0 <= chosen < len(frames):
            last = "0" if len(frames) == 1 else f"0 to {len(frames) - 1}"
            raise InputError(f"frame: need the number of a frame, {last}, got {chosen}")
        return chosen
    titles = [str(frame.get("frame_title", "")) for frame in frames]
    if chosen in titles:
        return titles.index(chosen)
    for number, frame in enumerate(frames):
        if chosen in frame_classes(frame):
            return number
    known = dict.fromkeys(title for title in titles if title)
    others = ["the number of one", "a class such as creasePattern"]
    raise InputError(f"frame: need the title of a frame, {one_of(known, chosen, others)}")
