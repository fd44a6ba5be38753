"""Check that the words of a figure are legible: large enough, inside the figure, and without overlap."""

import itertools
from unittest import mock

import numpy as np
from matplotlib._tight_bbox import adjust_bbox
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.text import Text
from matplotlib.transforms import Affine2D, Bbox

from forficula.show.style import description

_FINE = 3
_BEYOND, _DOTS, _WHITE = 0.5, 72 * _FINE, 0.95  # inch, dots per inch as in `words`, and what is as good as white
_ROUNDED = 2.0  # pt, tolerance for words: a layout in whole pixels may deviate
SMALLEST = 6.0  # pt, least size that journals accept
# text that is drawn over something on purpose, or that is one word
OVER = ("a", "b", "c")


def check_words(figure, width):
    """Check the words of a figure of a largest width, inch, and its description; returns the words."""
    assert figure.get_figwidth() <= width
    boxes, sides = _drawn(figure)
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
    _check_sides(sides)
    output = description(figure)
    assert output.endswith(".")
    assert len(output) > 60
    assert any(letter.isdigit() for letter in output)
    return [text.get_text() for text, _ in boxes]


def check_inside(figure):
    """Check that nothing is drawn beyond the edges of a figure, where files and pages cut it off."""
    _check_sides(_drawn(figure)[1])


def words(figure):
    """Return every text that is drawn, with its box in points from the lower left corner."""
    return _drawn(figure)[0]


def _check_sides(sides):
    for edge, side in sides.items():
        assert 72 * side < _ROUNDED, f"something sticks out {edge} by {72 * side:.1f} pt"


def _drawn(figure):
    """Return the words of a figure, as `words` returns them, and how far the drawing extends beyond each edge, inch.

    The figure is drawn once for both, in a window that shows what lies beyond its edges. A legend of the whole figure
    would be drawn at the edges of this window, so the legend is drawn separately.
    """
    # finer than points: at one pixel per point letters are rounded, and lines of text are longer
    figure.set_dpi(_DOTS)
    renderer = FigureCanvasAgg(figure).get_renderer()
    _lay_out(figure)
    beyond, boxes = [-np.inf] * 4, []
    for legend in figure.legends:
        boxes += _boxes(lambda legend=legend: legend.draw(renderer), renderer, 0.0)[1]
        beyond = np.maximum(beyond, _beyond(figure, legend.get_window_extent().extents / _DOTS))
        legend.set_visible(False)
    pixels, others = _boxes(lambda: pixels_with_margin(figure), renderer, _BEYOND)
    red, green, blue = np.moveaxis(pixels, 2, 0)
    marks = np.minimum(np.minimum(red, green), blue) < 255 * _WHITE
    rows, columns = (np.flatnonzero(marks.any(axis=axis)) for axis in (1, 0))
    left, right, top, bottom = np.array([columns[0], columns[-1] + 1, rows[0], rows[-1] + 1]) / _DOTS - _BEYOND
    height = figure.get_figheight()
    sides = np.maximum(beyond, _beyond(figure, (left, height - bottom, right, height - top)))
    return boxes + others, dict(zip(("to the left", "below", "to the right", "above"), sides.tolist(), strict=True))


def _boxes(draw, renderer, margin):
    """Return the result of a drawing, and the texts that it draws with their boxes, less a margin."""
    boxes, draw_text = {}, Text.draw
    shrink = Affine2D().scale(1 / _FINE).translate(-72 * margin, -72 * margin)

    def note(text, *others):
        if text.get_visible() and text.get_text().strip():
            # ticks move once the window is set
            boxes[text] = Text.get_window_extent(text, renderer).transformed(shrink)
        return draw_text(text, *others)

    with mock.patch.object(Text, "draw", note):
        drawn = draw()
    return drawn, list(boxes.items())


def _beyond(figure, extents):
    """Return the distances by which a box exceeds a figure to the left, below, to the right and above, inch."""
    (left, bottom, right, top), (width, height) = extents, figure.get_size_inches()
    return [-left, -bottom, right - width, top - height]


def _lay_out(figure):
    """Compute the positions of axes and words once, and keep them."""
    if (layout := figure.get_layout_engine()) is not None:
        layout.execute(figure)
    figure.set_layout_engine("none")
    for axes in figure.axes:
        locator = axes.get_axes_locator()
        axes.apply_aspect(locator(axes, None) if locator else None)


def pixels_with_margin(figure):
    """Red, green and blue, (row, column, 3), of a figure and of what is drawn within `_BEYOND` of its edges.

    As `savefig` with `bbox_inches` draws it, which draws everything twice and packs it as a file.
    """
    width, height = figure.get_size_inches()
    canvas = FigureCanvasAgg(figure)
    window = Bbox([[-_BEYOND, -_BEYOND], [width + _BEYOND, height + _BEYOND]])
    put_back = adjust_bbox(figure, window, canvas.get_renderer())
    try:
        canvas.draw()
        return np.array(canvas.buffer_rgba())[..., :3]
    finally:
        put_back()


def colours(pixels):
    """Count the colours of a picture, (row, column, 3 or 4) of bytes; one number per pixel: rows sort slowly."""
    return np.unique(pixels.astype(np.uint32) @ (1 << 8 * np.arange(pixels.shape[-1], dtype=np.uint32))).size
