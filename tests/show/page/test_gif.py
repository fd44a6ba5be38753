"""Films of a page as GIF, decoded by Pillow."""

import io
import json
import subprocess
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from tests.show.page.test_engine import node_path

ROOT = Path(__file__).parents[3]
SCRIPT = """import { readFileSync } from "node:fs";
import { makeGif } from "./web/src/gif.js";
const [width, height, frames] = JSON.parse(readFileSync(0, "utf8"));
const gif = makeGif(width, height, 0.08);
for (const frame of frames) gif.add(Uint8ClampedArray.from(frame));
process.stdout.write(gif.bytes());
"""


@pytest.mark.skipif(node_path() is None, reason="Node.js is missing")
def test_frames_of_a_gif_are_those_of_the_film():
    """Frames with more code words than a table holds, and with a part that does not change."""
    random = np.random.default_rng(1)
    frames = np.full((3, 90, 120, 4), 255, dtype=np.uint8)
    frames[:, 10:60, 10:100, :3] = random.choice([0, 74, 132, 206], size=(3, 50, 90, 3))
    data = json.dumps([120, 90, frames.reshape(3, -1).tolist()])
    command = [node_path(), "--input-type=module", "-e", SCRIPT]
    done = subprocess.run(command, input=data.encode(), capture_output=True, cwd=ROOT, check=True)
    film = Image.open(io.BytesIO(done.stdout))
    assert (film.size, film.n_frames, film.info["duration"], film.info["loop"]) == ((120, 90), 3, 80, 0)
    for number, frame in enumerate(frames):
        film.seek(number)
        # colours have five bits for each channel
        assert np.abs(np.asarray(film.convert("RGB"), dtype=int) - frame[..., :3]).max() <= 8
