import io
import struct
import zlib

import numpy as np
import pytest
from PIL import Image

from forficula import InputError
from forficula.pattern.picture.picture_file import picture_of_array, read_picture


def encoded(picture, kind, **options):
    content = io.BytesIO()
    picture.save(content, kind, **options)
    return content.getvalue()


def png_of_size(width, height, depth=8, colour=2):
    """A PNG file whose header promises a size, with almost no data."""

    def chunk(name, data):
        return struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))

    header = struct.pack(">IIBBBBB", width, height, depth, colour, 0, 0, 0)
    data = zlib.compress(bytes(1000))
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", data) + chunk(b"IEND", b"")


def text_bomb():
    data = b"Comment\0\0" + zlib.compress(bytes(100 << 20))
    name = b"zTXt"
    chunk = struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))
    whole = encoded(Image.new("RGB", (120, 120)), "PNG")
    return whole[:33] + chunk + whole[33:]


SQUARE = Image.new("RGB", (120, 120), "white")
HOSTILE = {
    "empty.png": (b"", "need a picture, got an empty file"),
    "text.jpg": (b"not a picture at all", "need a JPEG picture, got another content"),
    "short.png": (encoded(SQUARE, "PNG")[:60], "cannot be read as a PNG picture"),
    "cut.jpg": (encoded(Image.effect_noise((300, 300), 90), "JPEG")[:4000], "cannot be read as a JPEG picture"),
    "picture.txt": (encoded(SQUARE, "PNG"), "need a picture that ends with one of .png, .jpg, .jpeg"),
    "wrong.jpg": (encoded(SQUARE, "PNG"), "need a JPEG picture, as the name ends, got PNG"),
    "huge.png": (png_of_size(20_000, 20_000), "need at most 50 million pixels"),
    "large.png": (png_of_size(9_000, 9_000), "need at most 50 million pixels, got 9000 x 9000"),
    "bomb.png": (png_of_size(60_000, 60_000), "need at most 50 million pixels"),
    "texts.png": (text_bomb(), "cannot be read as a PNG picture"),
    "small.png": (encoded(Image.new("RGB", (40, 300)), "PNG"), "need at least 100 pixels along each side"),
    "deep.png": (encoded(Image.fromarray(np.zeros((120, 120), np.uint16)), "PNG"), "need 8 bits per colour, got 16"),
    "deep-colour.png": (png_of_size(120, 120, depth=16), "need 8 bits per colour, got 16"),
    "print.jpg": (encoded(Image.new("CMYK", (120, 120)), "JPEG"), "need grey, or red, green and blue, got CMYK"),
    "moving.png": (
        encoded(SQUARE, "PNG", save_all=True, append_images=[Image.new("RGB", (120, 120))]),
        "need one picture, got an animation",
    ),
}


@pytest.mark.parametrize("name", HOSTILE)
def test_pictures_that_cannot_be_traced_end_in_one_clear_line(name, tmp_path):
    content, message = HOSTILE[name]
    (tmp_path / name).write_bytes(content)
    with pytest.raises(InputError) as error:
        read_picture(tmp_path / name)
    assert str(error.value).startswith(f"{tmp_path / name}: {message}")
    assert "\n" not in str(error.value)


def test_a_picture_is_turned_as_its_exif_data_say(tmp_path):
    upright = Image.new("RGB", (160, 120), "white")
    upright.paste("black", (0, 0, 40, 30))  # upper left
    exif = Image.Exif()
    exif[0x0112] = 6  # to be turned by 90 deg clockwise
    upright.transpose(Image.Transpose.ROTATE_90).save(tmp_path / "phone.jpg", exif=exif, quality=95)
    pixels = read_picture(tmp_path / "phone.jpg").pixels
    assert pixels.shape == (120, 160, 3)
    assert pixels[:25, :35].max() < 0.1
    assert pixels[40:].min() > 0.9


def test_transparent_pixels_are_white_paper(tmp_path):
    Image.new("RGBA", (120, 120), (0, 0, 0, 0)).save(tmp_path / "clear.png")
    assert read_picture(tmp_path / "clear.png").pixels.min() == 1


@pytest.mark.parametrize(
    ("values", "message"),
    [
        (np.zeros((120, 120, 4), np.uint8), r"need an array of shape \(height, width\) or \(height, width, 3\)"),
        (np.full((120, 120), 2.0), "need finite numbers from 0 to 1, got 2 to 2"),
        (np.full((120, 120), np.nan), "need finite numbers"),
        (np.zeros((10, 120)), "need at least 100 pixels"),
        (np.full((120, 120), "a"), "need numbers"),
    ],
)
def test_arrays_that_are_no_pictures_are_refused(values, message):
    with pytest.raises(InputError, match=message):
        picture_of_array(values)


def test_whole_numbers_and_shares_give_the_same_picture():
    grey = np.arange(120 * 120).reshape(120, 120) % 256
    assert np.array_equal(picture_of_array(grey).pixels, picture_of_array(grey / 255).pixels)
