"""Pages as pictures, beside those in reference/, which people have looked at."""

import io
import os
from pathlib import Path

import numpy as np
from PIL import Image

from tests.show.page.conftest import missing

KEPT = Path(__file__).parent / "reference"
RENEW = (
    "FORFICULA_KEEP_PICTURES=1 .venv/bin/python -m pytest tests/show/page -k looks_as_it_was_kept; look at them, too"
)
WIDEST = 512  # pixels of a picture that is kept
BLOCK = 8  # pixels: letters become grey, panels and plots stay what they are
FONT = "DejaVu Sans"  # which comes with Debian's Chromium
# Mean difference of blocks, of 255. Where the wings are drawn: 0.7 at most between SwiftShader, Mesa and two pixels for
# one; 2.2 at least for a missing membrane, 6 for a blank canvas, 180 for light in place of dark. Beside them: 1.8 at
# most; 3.7 at least for plots that overlap or have lost their columns.
PICTURE, BESIDE = 1.2, 3.0


def check_look(opened, name, top="#player"):
    """Compare a page, from an element on, with the picture of this name; keep it as that where this is asked for."""
    page = opened.page
    if not page.evaluate(_HAS_FONT):
        missing(f"the font {FONT} is missing; install it, as with: apt-get install fonts-dejavu-core")
    style = page.add_style_tag(content=f'* {{ font-family: "{FONT}" !important; }}')
    page.evaluate("top => document.querySelector(top).scrollIntoView()", top)
    opened.settle()
    now, path = _picture(page), KEPT / f"{name.replace(' ', '-')}.png"
    box = page.locator(".stage").bounding_box()
    style.evaluate("each => each.remove()")
    if os.environ.get("FORFICULA_KEEP_PICTURES") == "1":
        KEPT.mkdir(exist_ok=True)
        now.save(path, optimize=True)
    with Image.open(path) as image:
        kept = image.convert("RGB")
    assert now.size == kept.size, f"{name}: {RENEW}"
    block = BLOCK * page.viewport_size["width"] / now.width
    away = _difference(now, kept)
    drawn = np.zeros(away.shape, dtype=bool)
    rows, columns = (
        slice(*(round(max(edge, 0) / block) for edge in (box[start], box[start] + box[size])))
        for start, size in (("y", "height"), ("x", "width"))
    )
    drawn[rows, columns] = True
    for part, most in ((away[drawn], PICTURE), (away[~drawn], BESIDE)):
        assert part.mean() < most, f"{name}: blocks differ by {part.mean():.1f}, not {most}; if that is right: {RENEW}"


# a browser without a font takes the next one of the list
_HAS_FONT = f"""() => {{
    const context = document.createElement("canvas").getContext("2d");
    const width = (font) => {{ context.font = font; return context.measureText("wing").width; }};
    return width('20px "{FONT}", monospace') !== width("20px monospace");
}}"""


def _picture(page):
    """The window as it is, not wider than the pictures that are kept."""
    shot = Image.open(io.BytesIO(page.screenshot())).convert("RGB")
    if shot.width <= WIDEST:
        return shot
    return shot.resize((WIDEST, round(shot.height * WIDEST / shot.width)), Image.Resampling.BOX)


def _difference(first, second):
    """By how much the blocks of two pictures differ in the colour that differs most, 0 to 255, (row, column)."""
    blocks = (
        np.asarray(each.resize((each.width // BLOCK, each.height // BLOCK), Image.Resampling.BOX), dtype=float)
        for each in (first, second)
    )
    return np.abs(np.subtract(*blocks)).max(axis=2)
