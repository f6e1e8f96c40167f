"""HEIC, PDF and SVG, where the extra is installed; and what is said where it is not."""

from __future__ import annotations

import io
import sys
from itertools import pairwise

import pytest
from PIL import Image, ImageDraw

from sketch2shape.errors import LimitError, MissingPackageError, UnreadableError
from sketch2shape.reading.limits import Limits
from sketch2shape.reading.read import count_pages, read_picture, sniff

SVG = b'<svg xmlns="http://www.w3.org/2000/svg" width="30mm" height="20mm" viewBox="0 0 300 200">%s</svg>'
LINE = b'<path d="M0 100 H300" stroke="black" stroke-width="20"/>'
OUTLINED = b'<path fill-rule="evenodd" d="M10 90H290V110H10Z M15 95V105H285V95Z"/>'
"""What is traced from pixels: lines by their outlines, which only a picture tells apart."""


def page(width=60, height=40):
    image = Image.new("RGB", (width, height), "white")
    ImageDraw.Draw(image).rectangle((0, 0, width // 2, height // 2), fill="black")
    return image


def pdf(*pages):
    out = io.BytesIO()
    pages[0].save(out, "PDF", save_all=True, append_images=pages[1:], resolution=72)
    return out.getvalue()


def test_a_missing_package_is_named(monkeypatch):
    monkeypatch.setitem(sys.modules, "resvg_py", None)
    with pytest.raises(MissingPackageError, match="resvg_py") as caught:
        read_picture(SVG % OUTLINED)
    assert "sketch2shape[formats]" in caught.value.advice


def test_svg_is_drawn_on_white_in_its_proportions():
    pytest.importorskip("resvg_py")
    pixels = read_picture(SVG % OUTLINED).pixels
    assert pixels.shape[1] / pixels.shape[0] == pytest.approx(1.5, abs=0.02)
    assert 1900 < pixels.shape[1] <= 2000
    assert pixels[613, 1000].max() == 0
    assert pixels[666, 1000].min() == pixels[100, 100].min() == 255


@pytest.mark.parametrize(
    ("size", "ratio"),
    [
        ('width="10cm" height="75mm"', 100 / 75),
        ('width="1in" height="96px"', 1.0),
        ('width="72pt" height="6pc"', 1.0),
        ('width="2e1em" height="160"', 2.0),
        ('width="100%" height="100%" viewBox="0 0 300 200"', 1.5),
        ('width="500" viewBox="0 0 300 200"', 1.5),
        ('height="9cm" viewBox="0 0 300 200"', 1.5),
        ('viewBox="-5,-5,30,10"', 3.0),
        ("", 1.0),
    ],
)
def test_sizes_of_an_svg_in_any_unit(size, ratio):
    pytest.importorskip("resvg_py")
    height, width, _ = read_picture(f'<svg xmlns="http://www.w3.org/2000/svg" {size}/>'.encode()).pixels.shape
    assert width / height == pytest.approx(ratio, abs=0.01)


@pytest.mark.parametrize("encoding", ["utf-8", "utf-8-sig", "latin-1", "cp1252", "utf-16", "utf-16-le", "utf-16-be"])
def test_encodings_of_an_svg(encoding):
    declared = encoding.removesuffix("-sig").removesuffix("-le").removesuffix("-be")
    text = f'<?xml version="1.0" encoding="{declared}"?><!-- \u00e9 -->' + (SVG % LINE).decode()
    data = text.encode(encoding)
    assert sniff(data) == "SVG"
    (line,) = read_picture(data).drawing.lines
    assert line.points[:, 1] == pytest.approx(10 * 10 * 96 / 25.4)  # 113 pixels wide: enlarged by ten


def test_an_svg_that_is_not_in_the_encoding_it_declares():
    pytest.importorskip("resvg_py")
    for data in (b"<?xml version='1.0' encoding='klingon'?>" + SVG % LINE, SVG % b"<!-- \xe9 -->"):
        with pytest.raises(UnreadableError, match="SVG"):
            read_picture(data)


def test_svg_reads_no_other_file(tmp_path):
    pytest.importorskip("resvg_py")
    secret = tmp_path / "secret.png"
    Image.new("RGB", (10, 10), "black").save(secret)
    for quote in ("'", '"'):
        image = f"<image width='300' height='200' href={quote}{secret}{quote}/>"
        assert read_picture(SVG % image.encode()).pixels.min() == 255


@pytest.mark.parametrize(
    "svg",
    [
        b"<svg",
        b"<svg><g></svg>",
        SVG.replace(b"30mm", b"1e30"),
        b"<svg xmlns='http://www.w3.org/2000/svg' width='1' height='900000'/>",
        b"<svg xmlns='http://www.w3.org/2000/svg' width='0' height='0'/>",
        b"\x1f\x8b not gzip <svg",
    ],
)
def test_damaged_svg(svg):
    pytest.importorskip("resvg_py")
    with pytest.raises(UnreadableError):
        read_picture(svg)


def test_entities_do_not_explode():
    pytest.importorskip("resvg_py")
    names = "abcdefghij"
    entities = "".join(f'<!ENTITY {b} "{f"&{a};" * 10}">' for a, b in pairwise(names))
    text = f'<!DOCTYPE svg [<!ENTITY a "aaaaaaaaaa">{entities}]>' + (SVG % b"<text>&j;</text>").decode()
    with pytest.raises(UnreadableError):
        read_picture(text.encode())


def test_pages_of_a_pdf():
    pytest.importorskip("pypdfium2")
    data = pdf(page(), page(100, 30))
    assert sniff(data) == "PDF"
    assert count_pages(data) == 2
    first, second = read_picture(data).pixels, read_picture(data, page=1).pixels
    assert first.shape[1] / first.shape[0] == pytest.approx(1.5, abs=0.02)
    assert second.shape[1] / second.shape[0] == pytest.approx(100 / 30, abs=0.1)
    assert first[5, 5].max() < 40
    assert first[-5, -5].min() > 220
    with pytest.raises(UnreadableError, match="2 pages"):
        read_picture(data, page=2)
    with pytest.raises(UnreadableError):
        read_picture(data[:200])


def test_a_large_pdf_page_is_drawn_smaller():
    pytest.importorskip("pypdfium2")
    assert read_picture(pdf(page(3000, 2000)), Limits(max_pixels=100_000)).pixels.size <= 3 * 101_000


def test_heic():
    heif = pytest.importorskip("pillow_heif")
    out = io.BytesIO()
    heif.from_pillow(page(64, 48)).save(out)
    data = out.getvalue()
    assert sniff(data) == "HEIF"
    pixels = read_picture(data).pixels
    assert pixels.shape == (48, 64, 3)
    assert pixels[5, 5].max() < 40
    with pytest.raises(LimitError):
        read_picture(data, Limits(max_pixels=1000))
    with pytest.raises(UnreadableError):
        read_picture(data[: len(data) // 2])
