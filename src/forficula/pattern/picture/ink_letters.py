"""Kinds of edges by the colour and the dashes of their lines; a doubtful edge is unassigned."""

from __future__ import annotations

import colorsys
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np
from scipy import ndimage

from forficula.arrays import Array, Flags, Indices
from forficula.pattern.picture.ink import Ink

Dashes = Literal["solid", "dashed", "dash-dotted", "dotted", "broken", "short"]
Ground = Literal["black", "grey", "red", "blue", "yellow", "green", "magenta", ""]

# [chosen] hues of inks in deg: red, orange-red to 36 (also the vermilion of figures), yellow, green, blue from sky blue
# on, magenta; other hues are between two kinds and therefore doubtful
_HUES: tuple[tuple[float, float, Ground], ...] = (
    (0, 36, "red"),
    (46, 72, "yellow"),
    (85, 160, "green"),
    (195, 262, "blue"),
    (284, 326, "magenta"),
    (340, 360, "red"),
)
_LETTERS: dict[Ground, str] = {"red": "M", "blue": "V", "yellow": "F", "green": "C", "magenta": "U"}
_COLOURLESS, _COLOURED = 0.22, 0.4  # [chosen] saturation below and above which an ink is black or coloured
_BLACK, _GREY = 0.8, 0.68  # [chosen] ink relative to the border's, above which it is black and below which grey
# [chosen] least darkness of a border, and largest saturation of a crease, at which black and grey have a meaning:
# pictures of less contrast lose the colours of thin lines
_CONTRAST, _GREY_SATURATION = 0.45, 0.18
_SAME_WIDTH = 0.85  # [chosen] least width of a grey line relative to the border's: a thin black line looks grey, too
_AGREEMENT = 0.8  # [chosen] least share of an edge whose colour agrees
_FAINT = 5.0  # least ink, in standard deviations of its noise along an edge
_PIECE = 8  # [chosen] pixels, least length of a piece whose colour is compared
_CLEAR = 1.5  # [chosen] line widths beside each end that are not used
_FEWEST = 6  # least number of pixels along an edge that decide on its colour
_SOLID = 0.97  # [chosen] share of a solid line that is inked
_BROKEN = 0.7  # [chosen] share of a line that is inked, below which it is broken where its dashes are not recognised
_SPARSE = 0.3  # [chosen] share of a dashed line that is inked, below which it is no line
_PERIODS = 2  # [chosen] least number of dashes and gaps by which dashes are recognised
MERGED = 0.6  # [chosen] share of an edge in which lines merge, above which its colour is doubtful


@dataclass(frozen=True, kw_only=True)
class InkOfEdge:
    """Ink along an edge.

    Attributes:
        ground: name of the colour; empty where it is doubtful.
        dashes: pattern of the dashes.
        doubt: why the colour is doubtful; empty without a doubt.
        share: share of the edge whose colour agrees, 0 to 1.
        hue: deg.
        saturation: 0 for black and grey, 1 for a pure colour.
        darkness: largest absorbed share of the light at the centre of the line.
        width: width of the line: its ink divided by that at its centre, pixels.
    """

    ground: Ground
    dashes: Dashes
    doubt: str
    share: float
    hue: float
    saturation: float
    darkness: float
    width: float


def ink_along_edge(ink: Ink, start: Array, end: Array, merged: float = 0.0) -> InkOfEdge:
    """Measure the colour and the dashes of the line from one point to another.

    Args:
        ink: the ink.
        start: pixels, shape (2,).
        end: pixels, shape (2,).
        merged: share of the edge at both ends in which it merges with other lines.
    """
    length = float(np.linalg.norm(end - start))
    along = (end - start) / length
    across = np.array([-along[1], along[0]])
    margin = min(max(_CLEAR * ink.line_width + 1, merged * length / 2), 0.35 * length)
    positions = np.arange(margin, length - margin, 0.5)
    if len(positions) < _FEWEST or merged > MERGED:
        why = "lines merge along most of the edge" if merged > MERGED else "the edge is too short to see its colour"
        return InkOfEdge(
            ground="", dashes="short", doubt=why, share=0.0, hue=0.0, saturation=0.0, darkness=0.0, width=0.0
        )
    reach = 1.2 * ink.line_width + 1
    offsets = np.arange(-reach, reach + 0.25, 0.5)
    grid = start + positions[:, np.newaxis, np.newaxis] * along + offsets[:, np.newaxis] * across
    profile = np.stack(
        [
            ndimage.map_coordinates(ink.absorbed[..., channel], [grid[..., 1], grid[..., 0]], order=1, mode="nearest")
            for channel in range(3)
        ],
        axis=-1,
    )  # (position, offset, channel)
    total = 0.5 * profile.sum(axis=1)  # pixels of full ink, (position, channel)
    most = total.max(axis=1)
    smooth = ndimage.gaussian_filter1d(most, 1.0)
    # the middle half, because other lines begin beside the ends
    quarter = len(smooth) // 4
    inked = smooth > 0.5 * float(np.percentile(smooth[quarter : len(smooth) - quarter], 85))
    inked = inked if inked.any() else np.ones(len(smooth), dtype=bool)
    dashes = _dashes(inked, ink.line_width)
    used = ndimage.binary_erosion(inked, iterations=1, border_value=1)
    used = used if used.sum() >= _FEWEST else inked
    colour = np.median(total[used], axis=0)
    hue, saturation = _hue(colour)
    centre = np.abs(offsets) <= max(0.5, ink.line_width / 6)
    darkness = float(np.median(profile[used][:, centre].max(axis=-1).mean(axis=1)))
    width = float(colour.max()) / max(darkness, 1e-6)
    ground, doubt = _ground(hue, saturation)
    # JPEG files store one colour for 2 x 2 pixels and less detail of colours, so that short pieces vary
    size = max(2 * _PIECE, int(6 * ink.line_width))
    pieces = [total[used][at : at + size].mean(axis=0) for at in range(0, int(used.sum()), size)]
    share = float(np.mean([_compatible(piece, ground) for piece in pieces])) if ground else 0.0
    noise = ink.noise * np.sqrt(len(offsets)) / 2 / np.sqrt(max(1.0, used.sum() / 4))
    if float(colour.max()) < _FAINT * noise:
        ground, doubt = "", "the line is as faint as the noise of the picture"
    elif ground and share < _AGREEMENT:
        ground, doubt = "", f"the colour changes along the edge, only {100 * share:.0f} % agree"
    elif inked.mean() < _SPARSE:
        ground, doubt = "", f"the line is broken, only {100 * inked.mean():.0f} % are inked"
    return InkOfEdge(
        ground=ground,
        dashes=dashes,
        doubt=doubt,
        share=share,
        hue=hue,
        saturation=saturation,
        darkness=darkness,
        width=width,
    )


def _hue(colour: Array) -> tuple[float, float]:
    """Return the hue, deg, and the saturation of an ink from the absorbed red, green and blue light."""
    light = 1 - np.clip(colour, 0, None) / max(float(colour.max()), 1e-9)
    hue, _, _ = colorsys.rgb_to_hsv(*light.tolist())
    return 360 * hue, float(np.ptp(light))


def _ground(hue: float, saturation: float) -> tuple[Ground, str]:
    """Return the name of a colour, or why it is doubtful."""
    if saturation <= _COLOURLESS:
        return "black", ""
    if saturation < _COLOURED:
        return "", "the colour is between black and coloured"
    for least, most, name in _HUES:
        if least <= hue <= most:
            return name, ""
    return "", f"the hue, {hue:.0f} deg, is between two kinds of lines"


def _compatible(colour: Array, ground: Ground) -> bool:
    """Return whether the ink of a piece does not contradict a colour."""
    hue, saturation = _hue(colour)
    if ground == "black":
        return saturation < (_COLOURLESS + _COLOURED) / 2 + 0.05
    if saturation < (_COLOURLESS + _COLOURED) / 2 - 0.05:
        return False
    return any(least - 12 <= hue <= most + 12 for least, most, name in _HUES if name == ground)


def _dashes(inked: Flags, line_width: float) -> Dashes:
    """Recognise the pattern of dashes from the inked positions, which are half a pixel apart."""
    if inked.mean() >= _SOLID:
        return "solid"
    changes = np.flatnonzero(np.diff(inked.astype(np.int8)))
    runs = np.diff(changes) / 2  # the first and the last run are cut off
    state: Flags = ~inked[changes[:-1]] if len(changes) > 1 else np.zeros(0, dtype=bool)
    on, off = runs[state], runs[~state]
    if len(on) < _PERIODS or len(off) < _PERIODS:
        # a few gaps say nothing about a pattern
        return "short" if inked.mean() > _BROKEN else "broken"
    if np.std(off) > 0.6 * np.mean(off) or off.max() > 12 * line_width:
        return "broken"
    if on.max() <= 2.0 * line_width:
        return "dotted"
    if on.max() <= 2.2 * on.min():
        return "dashed"
    middle = (on.max() + on.min()) / 2
    long: Flags = on > middle
    alternate = np.mean(long[1:] != long[:-1])
    return "dash-dotted" if alternate >= 0.75 and on[~long].max() < 0.6 * on[long].min() else "broken"


def letters_of_ink(inks: Sequence[InkOfEdge], face_counts: Indices) -> tuple[list[str], list[str]]:
    """Decide on the letters of edges: by colour, and by the dashes of black lines; a doubtful edge is "U".

    Red is mountain, blue valley, yellow flat, green cut and magenta unassigned. Black is border at the rim of the
    sheet. Between two faces a dashed black line is a valley and a dash-dotted one a mountain (Yoshizawa and Randlett);
    a solid black line is unassigned, because it may be a crease or a cut. Grey lines are flat.

    Args:
        inks: ink of every edge.
        face_counts: number of faces at every edge, shape (E,).

    Returns:
        Letters, and the reason of each doubt, empty without one.
    """
    rim = [ink for ink, count in zip(inks, face_counts.tolist(), strict=True) if count == 1 and ink.ground == "black"]
    black = float(np.median([ink.darkness for ink in rim])) if rim else np.nan
    width = float(np.median([ink.width for ink in rim])) if rim else np.nan
    letters, doubts = [], []
    for ink, count in zip(inks, face_counts.tolist(), strict=True):
        letter, doubt = _letter(ink, count == 1, black, ink.width / width)
        letters.append(letter)
        doubts.append(doubt)
    return letters, doubts


def _letter(ink: InkOfEdge, at_rim: bool, black: float, width: float) -> tuple[str, str]:
    """Return the letter of one edge, and why it is doubtful.

    Args:
        ink: ink of the edge.
        at_rim: whether the edge is at the rim of the sheet.
        black: darkness of the black border; nan without one.
        width: width of the line relative to that of the border.
    """
    if at_rim:
        if ink.ground == "black":
            return "B", ""
        seen = f"drawn in {ink.ground}" if ink.ground else ink.doubt
        return "U", f"at the rim of the sheet, but not a black border: {seen}"
    if not ink.ground:
        return "U", ink.doubt
    if ink.ground != "black":
        return _LETTERS[ink.ground], ""
    if np.isnan(black):
        return "U", "no black border to compare with"
    if black < _CONTRAST or ink.saturation > _GREY_SATURATION:
        return "U", "black or grey, or a colour that the picture does not show"
    darkness = ink.darkness / black
    if darkness < _GREY and width >= _SAME_WIDTH:
        if ink.dashes in ("solid", "dotted"):
            return "F", ""
        return "U", "grey dashes have no meaning"
    if darkness < _BLACK:
        return "U", "the line is between black and grey, or thinner than the border"
    if ink.dashes == "dashed":
        return "V", ""
    if ink.dashes == "dash-dotted":
        return "M", ""
    if ink.dashes == "solid":
        return "U", "a solid black line between two faces may be a crease or a cut"
    return "U", "the dashes of the black line are not clear"
