"""Film of a run, drawn without a screen: an .mp4 through ffmpeg, or an animated .gif."""

from __future__ import annotations

import shutil
import subprocess
import tempfile
from collections.abc import Callable, Iterable, Iterator
from itertools import pairwise
from pathlib import Path
from typing import IO, TYPE_CHECKING

import numpy as np

from forficula.analysis import measure
from forficula.dynamics import Record
from forficula.errors import InputError
from forficula.files import replacing
from forficula.optional_module import optional_module
from forficula.show.film.film_clock import FilmCut, film_cuts, moment
from forficula.show.film.film_frame import FilmFrame, Picture

if TYPE_CHECKING:
    from PIL import Image

SMALLEST, LARGEST = 160, 4096  # pixels
_DEFAULTS = {".mp4": ((1280, 720), 30), ".gif": ((800, 450), 15)}
_PALETTE, _WHITE = 255, (255, 255, 255)  # number of colours of a .gif, and one more colour


def check_film(path: Path) -> None:
    """Check that a film can be written.

    Raises:
        InputError: the file's ending is neither .mp4 nor .gif, or there is no ffmpeg for .mp4.
    """
    if path.suffix not in _DEFAULTS:
        raise InputError(f"need a file that ends with .mp4 or .gif, got {path}")
    if path.suffix == ".mp4":
        _ffmpeg()


def check_choices(size: object, fps: object, slower: object) -> None:
    """Check the size, the frame rate and the speed of a film; None selects the default.

    Raises:
        InputError: the size is too small, too large or odd, or the rate or the speed is out of range.
    """
    sides = size if isinstance(size, tuple | list) else ()
    even = [side for side in sides if isinstance(side, int) and SMALLEST <= side <= LARGEST and side % 2 == 0]
    if size is not None and not len(even) == len(sides) == 2:
        raise InputError(f"size: need two even numbers from {SMALLEST} to {LARGEST} such as (1280, 720), got {size!r}")
    if fps is not None and not (isinstance(fps, int) and 1 <= fps <= 60):
        raise InputError(f"fps: need 1 to 60, got {fps!r}")
    if slower is not None and not (isinstance(slower, int | float) and 0.01 <= slower <= 10_000):
        raise InputError(f"slower: need 0.01 to 10000, got {slower!r}")


def write_film(
    record: Record,
    path: Path,
    *,
    size: tuple[int, int] | None = None,
    rate: int | None = None,
    slowed: float | None = None,
    strain: bool = False,
    progress: Callable[[int, int], None] | None = None,
) -> None:
    """Write a film of a run.

    Args:
        record: the run.
        path: path that ends with .mp4 or .gif.
        size: pixels across and upwards, both even; 1280 x 720, or 800 x 450 for .gif.
        rate: pictures per second; 30, or 15 for .gif.
        slowed: factor by which moves are slower than in the run; by default each move takes about 3.5 s.
        strain: whether membranes are coloured by their largest strains.
        progress: receives the number of pictures drawn and the total.

    Raises:
        InputError: another ending, no ffmpeg for .mp4, or the file cannot be written.
    """
    check_film(path)
    usual_size, usual_rate = _DEFAULTS[path.suffix]
    size, rate = size or usual_size, rate or usual_rate
    cuts = film_cuts(record, measure(record), slowed)
    if strain and not record.structure.membranes:
        raise InputError(f"{record.design.name}: strain: need a structure with a membrane")
    pictures = _pictures(FilmFrame(record, cuts, size, strain=strain), cuts, rate, progress)
    with replacing(path) as temporary:
        if path.suffix == ".mp4":
            _write_mp4(pictures, temporary, path, size, rate, _title(record))
        else:
            _write_gif(pictures, temporary, rate)


def _title(record: Record) -> str:
    """Return the title of a film, such as "The wing binder2025 folds and opens"."""
    verbs = [transition.wording.does for transition in record.structure.transitions if transition.stage is not None]
    does = " and ".join(verbs) or "moves"
    return f"The {record.structure.appearance.whole} {record.design.name} {does}"


def frame_times(cuts: tuple[FilmCut, ...], rate: int) -> list[float]:
    """Return the times of the pictures of a film, s from its start."""
    return [number / rate for number in range(max(1, round(rate * sum(cut.length for cut in cuts))))]


def _pictures(
    frame: FilmFrame,
    cuts: tuple[FilmCut, ...],
    rate: int,
    progress: Callable[[int, int], None] | None,
) -> Iterator[Picture]:
    times = frame_times(cuts, rate)
    for number, time in enumerate(times, start=1):
        yield frame.draw(*moment(cuts, time))
        if progress is not None:
            progress(number, len(times))


def _ffmpeg() -> str:
    """Return the path of ffmpeg: the system's, or that of imageio-ffmpeg."""
    if result := shutil.which("ffmpeg"):
        return result
    imageio_ffmpeg = optional_module(
        "imageio_ffmpeg", "an .mp4 needs ffmpeg", "forficula[film]", "or install ffmpeg otherwise, or write a .gif"
    )
    return str(imageio_ffmpeg.get_ffmpeg_exe())


def _write_mp4(
    pictures: Iterable[Picture], path: Path, called: Path, size: tuple[int, int], rate: int, title: str
) -> None:
    """Pass the pictures to ffmpeg: H.264 in 4:2:0, which all players support, with the index at the start.

    Error messages name the final path of the film.
    """
    command = [_ffmpeg(), "-loglevel", "error", "-y", "-f", "rawvideo", "-pix_fmt", "rgb24"]
    command += ["-s", f"{size[0]}x{size[1]}", "-r", str(rate), "-i", "-", "-metadata", f"title={title}"]
    command += ["-c:v", "libx264", "-crf", "18", "-preset", "fast", "-pix_fmt", "yuv420p", "-movflags", "+faststart"]
    with tempfile.TemporaryFile() as messages:
        with subprocess.Popen([*command, str(path)], stdin=subprocess.PIPE, stderr=messages) as encoder:
            try:
                assert encoder.stdin is not None
                _feed(encoder.stdin, pictures)
            except BaseException:
                encoder.kill()
                raise
        if encoder.returncode:
            messages.seek(0)
            reason = " ".join(messages.read().decode(errors="replace").replace(str(path), str(called)).split())
            raise InputError(
                f"{called}: ffmpeg could not write the film: {reason or f'it ended with {encoder.returncode}'}"
            )


def _feed(pipe: IO[bytes], pictures: Iterable[Picture]) -> None:
    try:
        for picture in pictures:
            pipe.write(np.ascontiguousarray(picture).data)
        pipe.close()
    except BrokenPipeError:
        pass  # ffmpeg has ended and reports the reason


def _write_gif(pictures: Iterable[Picture], path: Path, rate: int) -> None:
    """Write pictures with one palette, so that unchanged parts are the same in all pictures and compress to nothing."""
    from PIL import Image

    drawn = [Image.fromarray(picture) for picture in pictures]
    some = drawn[:: max(1, len(drawn) // 12)]
    sheet = Image.new("RGB", (some[0].width, sum(item.height for item in some)))
    for place, item in enumerate(some):
        sheet.paste(item, (0, place * item.height))
    palette = sheet.quantize(_PALETTE, method=Image.Quantize.MEDIANCUT)
    palette.putpalette([*(palette.getpalette() or [])[: 3 * _PALETTE], *_WHITE])
    first, *others = (_with_palette(item, palette) for item in drawn)
    # a .gif measures time in hundredths of a second
    ends = [round(100 * number / rate) for number in range(len(drawn) + 1)]
    lengths = [10 * (end - start) for start, end in pairwise(ends)]
    first.save(path, save_all=True, append_images=others, duration=lengths, loop=0, optimize=False)


def _with_palette(picture: Image.Image, palette: Image.Image) -> Image.Image:
    """Map a picture to a palette, and keep white: Pillow's nearest colour would tint the background."""
    from PIL import Image

    indices = np.array(picture.quantize(palette=palette, dither=Image.Dither.NONE))
    indices[(np.asarray(picture) == _WHITE).all(axis=2)] = _PALETTE
    chosen = Image.fromarray(indices, mode="P")
    chosen.putpalette(palette.getpalette() or [])
    return chosen
