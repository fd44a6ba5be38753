"""Ink on a sheet in uneven light: the share of light that it absorbs, and the width of its lines."""

from __future__ import annotations

import math
import warnings
from dataclasses import dataclass

import numpy as np
from scipy import ndimage

from forficula.arrays import Array, Flags
from forficula.errors import InputError

_BLOCKS = 32  # [chosen] blocks along the longer side in which the brightness of the paper is measured
_BRIGHT = 65  # [chosen] percentile of the brightness in a block that is paper; lines may cover a third of a block
_EVERY = 2  # pixels between measured pixels, along each axis
_DARKEST = 0.08  # [chosen] brightness of paper below which colours are not distinguished
_INK = 0.08  # [chosen] absorbed share above which a pixel counts as ink, at least
_SMOOTH = 1.0  # pixels, of the smoothing before the width of lines is measured
_WIDEST = 0.02  # [chosen] of the picture's longer side, width of a line


@dataclass(frozen=True, kw_only=True, eq=False)
class Ink:
    """Light that is absorbed in a picture of a sheet.

    Attributes:
        absorbed: share of red, green and blue light that is absorbed, 0 for paper, shape (height, width, 3).
        strength: largest of the three shares, smoothed, shape (height, width).
        inside: pixels of the sheet, shape (height, width).
        noise: standard deviation of `strength` on empty paper.
        line_width: typical width of a line, pixels.
    """

    absorbed: Array
    strength: Array
    inside: Flags
    noise: float
    line_width: float


def ink_of(pixels: Array, inside: Flags) -> Ink:
    """Compute the absorbed light, relative to the paper around every pixel.

    The brightness of the paper is a percentile over blocks, in which lines cover less than a third of the area.

    Args:
        pixels: red, green and blue, 0 to 1, shape (height, width, 3).
        inside: pixels of the sheet, shape (height, width).

    Raises:
        InputError: the paper is too dark, or there are no lines on it.
    """
    paper = _paper(pixels, inside)
    absorbed = np.where(inside[..., np.newaxis], 1 - pixels / np.maximum(paper, 1e-3), 0.0)
    absorbed -= np.where(inside[..., np.newaxis], np.median(absorbed[inside][::7], axis=0), 0.0)
    np.clip(absorbed, -0.5, 1.0, out=absorbed)
    strength = np.max([ndimage.gaussian_filter(absorbed[..., channel], 0.8) for channel in range(3)], axis=0)
    sample = strength[inside][:: max(1, int(inside.sum()) // 200_000)]
    level = float(np.median(sample))
    noise = float(1.4826 * np.median(np.abs(sample - level)))
    strength = np.where(inside, strength - level, 0.0)
    return Ink(
        absorbed=absorbed,
        strength=strength,
        inside=inside,
        noise=noise,
        line_width=_line_width(strength, noise),
    )


def _paper(pixels: Array, inside: Flags) -> Array:
    """Return the colour of the paper at every pixel."""
    height, width = inside.shape
    step = max(8, -(-max(height, width) // _BLOCKS))
    rows, columns = -(-height // step), -(-width // step)
    padded = np.full((rows * step, columns * step, 3), np.nan, dtype=np.float32)
    padded[:height, :width][inside] = pixels[inside]
    blocks = padded[::_EVERY, ::_EVERY] if step % _EVERY == 0 else padded
    side = step // _EVERY if step % _EVERY == 0 else step
    blocks = blocks.reshape(rows, side, columns, side, 3).transpose(0, 2, 4, 1, 3).reshape(rows, columns, 3, -1)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", RuntimeWarning)  # blocks without paper
        level = np.nanpercentile(blocks, _BRIGHT, axis=-1).astype(np.float64)
    few = np.isfinite(blocks[:, :, 0]).mean(axis=-1) < 0.25
    level[few] = np.nan
    known = np.isfinite(level[..., 0])
    if not known.any() or np.nanmedian(level.max(axis=-1)) < _DARKEST:
        raise InputError("need a sheet that is brighter than its lines, got a dark picture; take it in more light")
    nearest = ndimage.distance_transform_edt(~known, return_distances=False, return_indices=True)
    level = level[tuple(nearest)]
    level = np.stack([ndimage.median_filter(level[..., channel], 3, mode="nearest") for channel in range(3)], axis=-1)
    y, x = ((np.arange(size) + 0.5) / step - 0.5 for size in (height, width))
    grid = np.meshgrid(y, x, indexing="ij")
    return np.stack(
        [ndimage.map_coordinates(level[..., channel], grid, order=1, mode="nearest") for channel in range(3)], axis=-1
    )


def _line_width(strength: Array, noise: float) -> float:
    """Return the typical width of lines at half their ink, pixels, from the mean distance of pixels from the rim."""
    smooth = ndimage.gaussian_filter(strength, _SMOOTH)
    # smoothing of the already smoothed noise
    dark = smooth > max(_INK, 5 * noise / (2 * _SMOOTH))
    if not dark.any():
        raise InputError("need lines on the sheet, got none that are darker than its noise")
    dark = smooth > 0.5 * float(np.percentile(smooth[dark], 80))
    # in a strip of odd width the mean distance of pixels from the rim is (width + 1)^2 / (4 width)
    seen = 4 * float(ndimage.distance_transform_edt(dark)[dark].mean()) - 2.2
    width = math.sqrt(max(seen**2 - (2.355 * _SMOOTH) ** 2, 0.0))
    if width > _WIDEST * max(strength.shape) + 10:
        raise InputError(f"need thin lines on bright paper, got dark areas about {width:.0f} pixels wide")
    return max(1.5, width)


def full_places(places: Array, reduced: int) -> Array:
    """Return positions in a whole picture, pixels, of positions in one that is reduced by a whole number."""
    return np.asarray(reduced * (places + 0.5) - 0.5)
