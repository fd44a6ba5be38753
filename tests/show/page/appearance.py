"""Pages as pictures, beside those in reference/, which people have looked at."""

import io
import os
from pathlib import Path

import numpy as np
from PIL import Image

KEPT = Path(__file__).parent / "reference"
RENEW = "FORFICULA_KEEP_PICTURES=1 .venv/bin/python -m pytest tests/show/page -k looks; then look at them"
WIDEST = 640  # pixels of a picture that is kept
BLOCK = 8  # pixels: letters become grey, panels and plots stay what they are
# of 255: see the measurements in test_appearance.py
MEAN, SHARE, FAR = 4.0, 0.04, 40


def picture(page):
    """The window as it is, not wider than the pictures that are kept."""
    shot = Image.open(io.BytesIO(page.screenshot())).convert("RGB")
    if shot.width <= WIDEST:
        return shot
    return shot.resize((WIDEST, round(shot.height * WIDEST / shot.width)), Image.Resampling.BOX)


def difference(first, second):
    """Mean difference of the blocks of two pictures, 0 to 255, and the share of blocks that are far off."""
    small = [
        np.asarray(each.resize((each.width // BLOCK, each.height // BLOCK), Image.Resampling.BOX), dtype=float)
        for each in (first, second)
    ]
    away = np.abs(small[0] - small[1]).max(axis=2)
    return away.mean(), (away > FAR).mean()


def check_look(opened, name):
    """Compare a page with the picture of this name, or keep it as that picture where this is asked for."""
    opened.settle()
    now, path = picture(opened.page), KEPT / f"{name}.png"
    if os.environ.get("FORFICULA_KEEP_PICTURES") == "1":
        KEPT.mkdir(exist_ok=True)
        now.quantize(128, dither=Image.Dither.NONE).save(path, optimize=True)
    kept = Image.open(path).convert("RGB")
    assert now.size == kept.size, f"{name}: {RENEW}"
    mean, share = difference(now, kept)
    assert mean < MEAN, f"{name}: blocks differ by {mean:.1f} on average; if that is right: {RENEW}"
    assert share < SHARE, f"{name}: {100 * share:.1f} % of the blocks differ much; if that is right: {RENEW}"
