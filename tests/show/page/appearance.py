"""Required appearance of a page with a structure and plots, independent of exact pixels."""

import io

import numpy as np
from PIL import Image

_DARKEST, _LIGHTEST = 60, 200  # of 255: bounds of the backgrounds of dark and light pages
_COLOURED = 24  # of 255: difference between the channels of a colour that is not grey
_LEAST, _MOST = 0.02, 0.9  # share of a stage that a structure covers
_INK = 1000  # least number of pixels of a plot
_PARTS = """() => { const box = (each) => { const { x, y, width, height } = each.getBoundingClientRect();
    return [x, y, x + width, y + height]; };
  const shown = (each) => each.checkVisibility();
  const boxes = (selector) => [...document.querySelectorAll(selector)].filter(shown).map(box);
  const inks = [...document.querySelectorAll(".chart canvas")].map((canvas) => {
    const { data } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
    let ink = 0;
    for (let at = 3; at < data.length; at += 4) ink += data[at] > 0;
    return ink; });
  return { stage: boxes(".stage"), plots: boxes(".chart"), legend: boxes(".legend"), inks,
    ground: getComputedStyle(document.body).backgroundColor.match(/\\d+/g).slice(0, 3).map(Number) }; }"""


def check_shown(opened, scheme="light", *, rows=None):
    """Check that a structure is drawn, on the ground of the scheme, with plots and a legend, none over another.

    Args:
        opened: a page.
        scheme: light or dark.
        rows: number of rows of its plots; None if it does not matter.
    """
    page = opened.page
    page.locator(".stage").first.scroll_into_view_if_needed()
    opened.settle()
    result = page.evaluate(_PARTS)
    (left, top, right, bottom), *_ = result["stage"]
    clip = {"x": left, "y": top, "width": right - left, "height": bottom - top}
    picture = np.asarray(Image.open(io.BytesIO(page.screenshot(clip=clip))).convert("RGB"), dtype=int)
    # text over it is grey
    drawn = np.ptp(picture, axis=2) > _COLOURED
    assert _LEAST < drawn.mean() < _MOST, "nothing is drawn, or it fills all"
    for ground in (result["ground"], picture[0, 0]):
        assert np.mean(ground) < _DARKEST if scheme == "dark" else np.mean(ground) > _LIGHTEST, f"not a {scheme} page"
    assert result["legend"], "no legend"
    assert min(result["inks"]) > _INK, "an empty plot"
    boxes = [*result["stage"], *result["legend"], *result["plots"]]
    for number, first in enumerate(boxes):
        for second in boxes[:number]:
            across, upwards = (min(first[at + 2], second[at + 2]) - max(first[at], second[at]) for at in (0, 1))
            assert min(across, upwards) < 1, "one thing lies on another"
    if rows is not None:
        assert len({round(top) for _, top, _, _ in result["plots"]}) == rows, "plots below one another"
