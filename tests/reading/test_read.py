"""Reading pictures: every format, every way to spoil a file."""

from __future__ import annotations

import io
import os
import struct
import warnings
import zlib
from concurrent.futures import ThreadPoolExecutor
from importlib import import_module

import numpy as np
import pytest
from PIL import Image, features
from sketches import encoded

from sketch2shape.errors import LimitError, MissingPackageError, UnreadableError, UsageError
from sketch2shape.model.picture import Picture
from sketch2shape.reading.limits import Limits
from sketch2shape.reading.read import PLUGINS, count_pages, parse_page, read_picture, sniff, webp_size

CORE = ["PNG", "JPEG", "WEBP", "TIFF", "BMP", "GIF", "PPM"]


def stroke(size=(40, 30), mode="RGB"):
    """White, with a black bar in the upper left corner."""
    pixels = np.full((size[1], size[0], 3), 255, np.uint8)
    pixels[2:6, 2:20] = 0
    return Image.fromarray(pixels).convert(mode)


@pytest.mark.parametrize("kind", CORE)
def test_core_formats_are_known_by_content_and_read(kind, tmp_path):
    data = encoded(stroke(), kind)
    assert sniff(data) == kind
    path = tmp_path / "name.says.nothing"
    path.write_bytes(data)
    pixels = read_picture(path).pixels
    assert pixels.shape == (30, 40, 3)
    assert pixels.dtype == np.uint8
    assert pixels[4, 10].max() < 60
    assert pixels[20, 30].min() > 200


@pytest.mark.parametrize(
    ("kind", "options"),
    [
        ("TGA", {}),
        ("TGA", {"compression": "tga_rle"}),
        ("ICO", {"sizes": [(40, 30)]}),
        ("JPEG2000", {"irreversible": False}),
        ("JPEG2000", {"no_jp2": True}),
        ("AVIF", {}),
    ],
)
def test_formats_that_most_builds_of_pillow_read(kind, options):
    module = import_module(f"PIL.{PLUGINS[kind]}") if kind != "AVIF" or features.check("avif") else None
    if module is None or (kind == "JPEG2000" and not features.check("jpg_2000")):
        pytest.skip(f"this Pillow has no decoder for {kind}")
    data = encoded(stroke(), kind, **options)
    assert sniff(data) == kind
    pixels = read_picture(data).pixels
    assert pixels.shape == (30, 40, 3)
    assert pixels[4, 10].max() < 60
    assert pixels[20, 30].min() > 200
    with pytest.raises(UnreadableError):
        read_picture(data[: len(data) // 3])
    with pytest.raises(LimitError):
        read_picture(data, Limits(max_pixels=1000))


def test_an_old_targa_file_is_known_by_its_header():
    data = encoded(stroke(mode="L"), "TGA")
    assert sniff(data.removesuffix(data[-26:])) == "TGA"
    assert sniff(bytes(200)) is None


def test_a_decoder_that_this_pillow_lacks_is_named(monkeypatch):
    monkeypatch.setattr(features, "check", lambda _: False)
    for data in (b"\xff\x4f\xff\x51" + bytes(60), b"\0\0\0\x20ftypavif" + bytes(60)):
        with pytest.raises(MissingPackageError, match="does not decode"):
            read_picture(data)


def test_all_kinds_of_source_give_the_same_pixels(tmp_path):
    image = stroke()
    data = encoded(image, "PNG")
    path = tmp_path / "a.png"
    path.write_bytes(data)
    sources = [path, str(path), data, bytearray(data), memoryview(data), io.BytesIO(data), image, np.asarray(image)]
    for source in sources:
        assert (read_picture(source).pixels == np.asarray(image)).all()


def test_a_picture_is_returned_as_it_is():
    picture = Picture(np.zeros((3, 4, 3), np.uint8))
    assert read_picture(picture) is picture


def test_names_of_sources(tmp_path):
    path = tmp_path / "a.png"
    path.write_bytes(encoded(stroke(), "PNG"))
    assert read_picture(path).source == str(path)
    assert read_picture(path, name="b").source == "b"
    assert read_picture(encoded(stroke(), "PNG")).source == "<bytes>"
    assert read_picture(np.zeros((4, 4), np.uint8)).source == "<ndarray>"


@pytest.mark.parametrize("orientation", range(1, 9))
def test_exif_orientation_is_applied(orientation):
    upright = stroke()
    back = {2: 0, 3: 3, 4: 1, 5: 5, 6: 2, 7: 6, 8: 4}  # the transposition that undoes each orientation
    stored = upright if orientation == 1 else upright.transpose(Image.Transpose(back[orientation]))
    exif = Image.Exif()
    exif[0x0112] = orientation
    assert (read_picture(encoded(stored, "PNG", exif=exif)).pixels == np.asarray(upright)).all()


def large(width, height):
    """A black bar from a quarter to a half of the width, at the middle of the height, on white."""
    pixels = np.full((height, width, 3), 255, np.uint8)
    pixels[height // 2 : height // 2 + 64, width // 4 : width // 2] = 0
    return Image.fromarray(pixels)


@pytest.mark.parametrize(("size", "step"), [((4001, 3003), 4), ((2000, 900), 2), ((1900, 900), 1), ((900, 8000), 8)])
def test_large_jpegs_are_read_reduced_where_that_is_enough(size, step):
    data = encoded(large(*size), "JPEG")
    picture = read_picture(data, reduced=True)
    assert picture.size == size
    assert picture.reduction == step
    assert picture.pixels.shape == (-(-size[1] // step), -(-size[0] // step), 3)
    dark = np.flatnonzero(picture.pixels[(size[1] // 2 + 32) // step, :, 0] < 128)
    ends = (dark[[0, -1]] + 0.5) * step - 0.5
    assert np.abs(ends - [size[0] // 4, size[0] // 2 - 1]).max() <= step
    assert read_picture(data).size == read_picture(data).pixels.shape[1::-1] == size


def test_a_reduced_jpeg_is_turned_as_a_whole_one():
    exif = Image.Exif()
    exif[0x0112] = 6
    picture = read_picture(encoded(large(4000, 3000), "JPEG", exif=exif), reduced=True)
    assert picture.size == (3000, 4000)
    assert picture.pixels.shape == (1000, 750, 3)


def test_only_jpegs_are_read_reduced():
    assert read_picture(encoded(large(2400, 1000), "PNG"), reduced=True).pixels.shape == (1000, 2400, 3)


def test_damaged_exif_does_not_hide_the_picture():
    assert read_picture(encoded(stroke(), "JPEG", exif=b"Exif\0\0garbage!")).pixels.shape == (30, 40, 3)


@pytest.mark.parametrize("kind", [k for k in CORE if k != "PPM"])
def test_truncated_files_are_refused(kind):
    image = Image.fromarray(np.random.default_rng(1).integers(0, 255, (60, 60, 3), np.uint8))
    data = encoded(image, kind)
    with pytest.raises(UnreadableError):
        read_picture(data[: len(data) // 2])


@pytest.mark.parametrize(
    ("data", "word"),
    [
        (b"", "empty"),
        (b"hello, I am a text file called a.png", "text"),
        (b"\x00\x01\x02\x03" * 9, "known format"),
        (b"\x89PNG\r\n\x1a\n", "damaged"),
        (b"RIFF\0\0\0\0WEBPVP8 ", "WebP"),
        (b"<html><body></body></html>", "text"),
    ],
)
def test_what_is_no_picture_is_said(data, word):
    with pytest.raises(UnreadableError, match=word):
        read_picture(data)


def test_missing_file():
    with pytest.raises(UnreadableError, match="no such file"):
        read_picture("/no/such/file.png")


@pytest.mark.parametrize("path", ["a\0b.png", "\ud800.png"])
def test_impossible_names(path):
    with pytest.raises(UnreadableError):
        read_picture(path)


@pytest.mark.posix
def test_things_that_are_no_regular_files_are_refused_unread(tmp_path):
    os.mkfifo(tmp_path / "pipe.png")
    (tmp_path / "folder.png").mkdir()
    (tmp_path / "loop.png").symlink_to("loop.png")
    (tmp_path / "gone.png").symlink_to("nowhere.png")
    for name in ("pipe.png", "folder.png", "loop.png", "gone.png"):
        with pytest.raises(UnreadableError):
            read_picture(tmp_path / name)
    with pytest.raises(UnreadableError, match="device"):
        read_picture("/dev/zero")


def png_header(width, height):
    """A PNG of this size that ends after its header and a few bytes of data."""

    def chunk(kind, body):
        return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))

    header = struct.pack(">IIBBBBB", width, height, 8, 0, 0, 0, 0)
    return (
        b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(bytes(1000))) + chunk(b"IEND", b"")
    )


def test_too_many_pixels_are_refused_from_the_header():
    with pytest.raises(LimitError, match="900 megapixels"):
        read_picture(png_header(30000, 30000))
    with pytest.raises(LimitError, match="side"):
        read_picture(png_header(40000, 2))
    with pytest.raises(LimitError, match="megapixels"):
        read_picture(stroke(), Limits(max_pixels=1000))
    with pytest.raises(LimitError, match="megapixels"):
        read_picture(np.zeros((100, 100), np.uint8), Limits(max_pixels=1000))


def test_photos_of_twenty_megapixels_are_within_the_default():
    Limits().check_size(5472, 3648)
    Limits().check_size(8160, 6120)


@pytest.mark.parametrize("lossless", [True, False])
@pytest.mark.parametrize("mode", ["RGB", "RGBA"])
def test_webp_size_agrees_with_the_decoder(mode, lossless):
    data = encoded(stroke((321, 123), mode), "WEBP", lossless=lossless, exif=b"Exif\0\0")
    assert webp_size(data) == (321, 123)


def test_too_many_bytes(tmp_path):
    path = tmp_path / "a.bmp"
    path.write_bytes(encoded(stroke(), "BMP"))
    for source in (path, path.read_bytes(), io.BytesIO(path.read_bytes())):
        with pytest.raises(LimitError, match="larger"):
            read_picture(source, Limits(max_bytes=500))


def test_pages_of_a_tiff():
    data = encoded(stroke(), "TIFF", save_all=True, append_images=[stroke((50, 60)), stroke((20, 21))])
    assert count_pages(data) == 3
    assert read_picture(data).pixels.shape == (30, 40, 3)
    assert [read_picture(data, page=k).pixels.shape[:2] for k in range(3)] == [(30, 40), (60, 50), (21, 20)]
    with pytest.raises(UnreadableError, match="no such page"):
        read_picture(data, page=3)


def test_an_animation_gives_its_first_frame():
    data = encoded(stroke(), "GIF", save_all=True, append_images=[Image.new("RGB", (40, 30), "red")])
    assert count_pages(data) == 1
    assert read_picture(data).pixels[4, 10].max() < 10


def test_text_streams_and_odd_objects_are_refused():
    with pytest.raises(UnreadableError, match="text"):
        read_picture(io.StringIO("hello"))
    closed = io.BytesIO(b"x")
    closed.close()
    with pytest.raises(UnreadableError, match="closed"):
        read_picture(closed)
    with pytest.raises(UnreadableError, match="empty"):
        read_picture(io.BytesIO())
    for thing in (None, 3, ["a.png"]):
        with pytest.raises(UnreadableError, match="no picture"):
            read_picture(thing)


def test_open_files_in_text_mode_and_at_their_end(tmp_path):
    image = Image.new("L", (7, 5), 99)
    image.save(tmp_path / "a.png")
    with open(tmp_path / "a.png") as text:
        assert read_picture(text).size == (7, 5)
    buffer = io.BytesIO()
    image.save(buffer, "PNG")  # which leaves it at its end
    assert read_picture(buffer).size == (7, 5)


def test_reading_leaves_the_filters_of_warnings_alone(tmp_path):
    before = list(warnings.filters)
    Image.new("L", (7, 5), 99).save(tmp_path / "a.png")
    sources = [str(tmp_path / "a.png")] * 200
    with ThreadPoolExecutor(8) as pool:
        seen = list(pool.map(lambda path: (read_picture(path).size, list(warnings.filters) == before), sources))
    assert seen == [((7, 5), True)] * 200


def test_parse_page():
    assert parse_page("1") == 0
    assert parse_page("12") == 11
    assert parse_page("all") is None
    for text in ("0", "-1", "x", ""):
        with pytest.raises(UsageError):
            parse_page(text)


def test_limits_that_cannot_be_kept():
    for wrong in ({"max_pixels": 0}, {"max_pixels": 10**9}, {"max_side": 0}, {"max_bytes": -1}):
        with pytest.raises(UsageError):
            Limits(**wrong)
