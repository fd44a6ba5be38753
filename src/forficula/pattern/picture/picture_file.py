"""Photographs, scans and drawings as arrays of pixels, read with limits on their size."""

from __future__ import annotations

import io
import os
import warnings
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from forficula.allowed_files import check_may_read
from forficula.arrays import Array
from forficula.errors import InputError, error_prefix
from forficula.files import read_bytes, shown_path
from forficula.quantities import as_written

if TYPE_CHECKING:
    from PIL import Image

PICTURE_FILES = {".png": "PNG", ".jpg": "JPEG", ".jpeg": "JPEG"}
_FORMATS = {"PNG": "PNG", "JPEG": "JPEG", "MPO": "JPEG"}  # phones write JPEG files with a second picture as MPO
_LARGEST_FILE = 64 * 2**20  # [chosen] bytes
_MOST_PIXELS = 50_000_000  # [chosen] a trace of 50 million pixels needs about 3 GB of memory
_FEWEST_PIXELS = 100  # [chosen] of the shorter side
_MODES = ("1", "L", "LA", "P", "PA", "RGB", "RGBA")
_BIT_DEPTH = 24  # position of the bits per channel in a PNG file


@dataclass(frozen=True, kw_only=True, eq=False)
class Picture:
    """Pixels of a picture.

    Attributes:
        pixels: red, green and blue, 0 to 1, shape (height, width, 3).
        name: name of the file; empty for an array.
    """

    pixels: Array
    name: str = ""


def read_picture(path: str | os.PathLike[str]) -> Picture:
    """Read a PNG or JPEG file, turned as its EXIF data say; transparent pixels become white.

    Args:
        path: path of the file.

    Raises:
        InputError: the file cannot be read, is too large, is not a picture of its ending's format, is animated, or has
            other colours than 8 bits of grey or red, green and blue. The message names the file.
    """
    file = Path(path)
    check_may_read(file)
    with error_prefix(f"{shown_path(file)}: "):
        ending = file.suffix.lower()
        if ending not in PICTURE_FILES:
            known = ", ".join(PICTURE_FILES)
            raise InputError(f"need a picture that ends with one of {known}, got {as_written(file.suffix)}")
        return Picture(pixels=_decoded(read_bytes(file, _LARGEST_FILE), PICTURE_FILES[ending]), name=file.name)


def picture_of_content(content: bytes, name: str) -> Picture:
    """Decode the content of a PNG or JPEG file, as `read_picture` does.

    Args:
        content: bytes of the file.
        name: name of the file, whose ending may differ from the format of the content.

    Raises:
        InputError: as for `read_picture`.
    """
    return Picture(pixels=_decoded(content, None), name=name)


def picture_of_array(values: object) -> Picture:
    """Return the picture of an array.

    Args:
        values: grey, shape (height, width), or red, green and blue, shape (height, width, 3); whole numbers from 0 to
            255, or numbers from 0 to 1.

    Raises:
        InputError: the array has another shape, other values, or too many or too few pixels.
    """
    array = np.asarray(values)
    if array.ndim not in (2, 3) or (array.ndim == 3 and array.shape[2] != 3):
        raise InputError(f"picture: need an array of shape (height, width) or (height, width, 3), got {array.shape}")
    check_pixels(array.shape[1], array.shape[0])
    if array.dtype.kind not in "uif":
        raise InputError(f"picture: need numbers, got {array.dtype}")
    most = 1.0 if array.dtype.kind == "f" else 255.0
    pixels = array.astype(np.float64)
    if not np.isfinite(pixels).all() or pixels.min() < 0 or pixels.max() > most:
        raise InputError(
            f"picture: need finite numbers from 0 to {most:g}, got {pixels.min():.4g} to {pixels.max():.4g}"
        )
    pixels /= most
    return Picture(pixels=pixels if pixels.ndim == 3 else np.repeat(pixels[:, :, np.newaxis], 3, axis=2))


def check_pixels(width: int, height: int) -> None:
    """Refuse a picture with too many or too few pixels.

    Raises:
        InputError: the size is not allowed.
    """
    if width * height > _MOST_PIXELS:
        raise InputError(
            f"need at most {_MOST_PIXELS // 10**6} million pixels, got {width} x {height}; make the picture smaller"
        )
    if min(width, height) < _FEWEST_PIXELS:
        raise InputError(f"need at least {_FEWEST_PIXELS} pixels along each side, got {width} x {height}")


def _decoded(content: bytes, expected: str | None) -> Array:
    """Return the pixels of a file's content, which must have the expected format if there is one."""
    from PIL import Image, ImageOps, UnidentifiedImageError

    if not content:
        raise InputError("need a picture, got an empty file")
    name = expected or " or ".join(dict.fromkeys(PICTURE_FILES.values()))
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # sizes are checked below
        try:
            with Image.open(io.BytesIO(content), formats=("PNG", "JPEG")) as picture:
                _check_kind(picture, content, expected)
                turned = ImageOps.exif_transpose(picture)
                return _rgb(picture if turned is None else turned)
        except InputError:
            raise
        except UnidentifiedImageError:
            raise InputError(f"need a {name} picture, got another content") from None
        except Image.DecompressionBombError:
            raise InputError(f"need at most {_MOST_PIXELS // 10**6} million pixels, got a larger picture") from None
        except (OSError, ValueError, SyntaxError, ArithmeticError, LookupError, TypeError) as error:
            reason = " ".join(str(error).split()) or type(error).__name__
            raise InputError(f"cannot be read as a {name} picture: {reason}") from None


def _check_kind(picture: Image.Image, content: bytes, expected: str | None) -> None:
    """Refuse a picture of another kind before its pixels are decoded."""
    actual = _FORMATS[str(picture.format)]
    if expected is not None and actual != expected:
        raise InputError(f"need a {expected} picture, as the name ends, got {actual}; rename the file")
    check_pixels(*picture.size)
    if actual == "PNG" and getattr(picture, "is_animated", False):
        raise InputError("need one picture, got an animation; save one of its pictures")
    if actual == "PNG" and content[_BIT_DEPTH] > 8:
        raise InputError(f"need 8 bits per colour, got {content[_BIT_DEPTH]}; save the picture with 8 bits")
    if picture.mode not in _MODES:
        raise InputError(f"need grey, or red, green and blue, got {picture.mode}; save the picture as RGB")


def _rgb(picture: Image.Image) -> Array:
    """Return red, green and blue on white, 0 to 1."""
    from PIL import Image

    if picture.mode in ("LA", "PA", "RGBA") or "transparency" in picture.info:
        layer = picture.convert("RGBA")
        white = Image.new("RGBA", layer.size, "white")
        picture = Image.alpha_composite(white, layer)
    return np.asarray(picture.convert("RGB"), dtype=np.float64) / 255
