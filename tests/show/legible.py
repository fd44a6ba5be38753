"""Whether the words of a figure can be read: large enough, inside it, and not on one another."""

import itertools
from unittest import mock

import numpy as np
from matplotlib._tight_bbox import adjust_bbox
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.layout_engine import ConstrainedLayoutEngine
from matplotlib.text import Text
from matplotlib.transforms import Affine2D, Bbox

from forficula.show.style import description

_FINE = 3
_BEYOND, _DOTS, _WHITE = 0.5, 72 * _FINE, 0.95  # inch, dots per inch as in `words`, and what is as good as white
_ROUNDED = 2.0  # pt, as for words: a layout in whole pixels may be off
SMALLEST = 6.0  # pt, below which journals refuse
# what is drawn on purpose over something else, or as one word
OVER = ("a", "b", "c")


def check_words(figure, width):
    """Check the words of a figure of at most a width, inch, and the text that stands for it."""
    assert figure.get_figwidth() <= width
    boxes = words(figure)
    assert boxes
    assert min(text.get_fontsize() for text, _ in boxes) >= SMALLEST
    across, upwards = 72 * figure.get_size_inches()
    for text, box in boxes:
        outside = max(-box.x0, box.x1 - across, -box.y0, box.y1 - upwards)
        assert outside < 2, f"{text.get_text()!r} sticks out by {outside:.1f} pt"
    for (one, first), (other, second) in itertools.combinations(boxes, 2):
        if one.get_text() in OVER or other.get_text() in OVER:
            continue
        common = (
            min(first.x1, second.x1) - max(first.x0, second.x0),
            min(first.y1, second.y1) - max(first.y0, second.y0),
        )
        assert min(common) < 1.5, f"{one.get_text()!r} lies on {other.get_text()!r}"
    figure.set_layout_engine("none")  # it has the places that were found for its words
    check_inside(figure)
    told = description(figure)
    assert told.endswith(".")
    assert len(told) > 60
    assert any(letter.isdigit() for letter in told)


def check_inside(figure):
    """Check that nothing is drawn beyond the edges of a figure, where files and pages cut it off."""
    width, height = figure.get_size_inches()
    if isinstance(figure.get_layout_engine(), ConstrainedLayoutEngine):
        figure.draw_without_rendering()
    outside = {"above": 0.0, "below": 0.0, "to the left": 0.0, "to the right": 0.0}
    for legend in figure.legends:
        box = legend.get_window_extent().transformed(Affine2D().scale(1 / figure.dpi))
        sides = (box.y1 - height, -box.y0, -box.x0, box.x1 - width)
        outside = {edge: max(before, side) for (edge, before), side in zip(outside.items(), sides, strict=True)}
        # in a larger window they would stand at its edges
        legend.set_visible(False)
    figure.set_layout_engine("none")
    drawn = (pixels_with_margin(figure) < 255 * _WHITE).any(axis=2)
    rows, columns = (np.flatnonzero(drawn.any(axis=axis)) for axis in (1, 0))
    first, last = np.array([rows[0], columns[0]]) / _DOTS, np.array([rows[-1] + 1, columns[-1] + 1]) / _DOTS
    sides = (_BEYOND - first[0], last[0] - _BEYOND - height, _BEYOND - first[1], last[1] - _BEYOND - width)
    for (edge, of_legend), side in zip(outside.items(), sides, strict=True):
        out = 72 * max(of_legend, side)
        assert out < _ROUNDED, f"something sticks out {edge} by {out:.1f} pt"


def pixels_with_margin(figure):
    """Red, green and blue, (row, column, 3), of a figure and of what is drawn within `_BEYOND` of its edges.

    As `savefig` with `bbox_inches` draws it, which draws everything twice and packs it as a file.
    """
    width, height = figure.get_size_inches()
    figure.set_dpi(_DOTS)
    canvas = FigureCanvasAgg(figure)
    window = Bbox([[-_BEYOND, -_BEYOND], [width + _BEYOND, height + _BEYOND]])
    put_back = adjust_bbox(figure, window, canvas.get_renderer())
    try:
        canvas.draw()
        return np.array(canvas.buffer_rgba())[..., :3]
    finally:
        put_back()


def colours(pixels):
    """How many a picture has, (row, column, 3 or 4) of bytes; one number a pixel, for rows are slow to sort."""
    return np.unique(pixels.astype(np.uint32) @ (1 << 8 * np.arange(pixels.shape[-1], dtype=np.uint32))).size


def words(figure):
    """Every text that is drawn, and its box in points from the lower left corner."""
    # finer than points: at one pixel a point letters are rounded to whole ones, and lines of them are longer
    figure.set_dpi(72 * _FINE)
    canvas = FigureCanvasAgg(figure)
    seen, draw = [], Text.draw

    def note(text, renderer, *others):
        if text.get_visible() and text.get_text().strip():
            seen.append(text)
        return draw(text, renderer, *others)

    with mock.patch.object(Text, "draw", note):
        figure.draw_without_rendering()  # words are asked for their places only
    shrink = Affine2D().scale(1 / _FINE)
    boxes = [Text.get_window_extent(text, canvas.get_renderer()) for text in dict.fromkeys(seen)]
    return [(text, box.transformed(shrink)) for text, box in zip(dict.fromkeys(seen), boxes, strict=True)]
