"""Reading a picture from a path, bytes, a PIL image or an array, without trusting it.

Strategy: open the file without blocking and refuse whatever is no regular file; read at most `max_bytes`; know the
format by its first bytes, never by its name; let Pillow read the header with the one plugin that this format needs
(never the plugins that start other programs); check the size; only then decode.
"""

from __future__ import annotations

import io
import os
import stat
from collections.abc import Callable
from typing import IO, TYPE_CHECKING, Any, TypeVar

from sketch2shape.errors import LimitError, MissingPackageError, Sketch2ShapeError, UnreadableError, UsageError
from sketch2shape.model import Picture
from sketch2shape.reading.limits import Limits
from sketch2shape.reading.pixels import from_array, from_image

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray
    from PIL.Image import Image

    Source = str | os.PathLike[str] | bytes | bytearray | memoryview | IO[bytes] | Image | NDArray[Any] | Picture
    Pixels = NDArray[np.uint8]

R = TypeVar("R")

ENOUGH = 960
"""Long side down to which a reduced copy goes: about the working size of the ink."""

#: format -> Pillow plugin module
PLUGINS = {
    "PNG": "PngImagePlugin",
    "JPEG": "JpegImagePlugin",
    "WEBP": "WebPImagePlugin",
    "TIFF": "TiffImagePlugin",
    "BMP": "BmpImagePlugin",
    "GIF": "GifImagePlugin",
    "PPM": "PpmImagePlugin",
    "TGA": "TgaImagePlugin",
    "ICO": "IcoImagePlugin",
    "JPEG2000": "Jpeg2KImagePlugin",
    "AVIF": "AvifImagePlugin",
}
#: formats that not every build of Pillow decodes -> what Pillow calls the decoder
_OPTIONAL = {"JPEG2000": "jpg_2000", "AVIF": "avif"}
#: formats that need the extra `formats`
EXTRA = ("HEIF", "PDF", "SVG")
#: formats that hold lines
VECTORS = ("JSON", "INKML", "SVG", "PDF")

#: file name endings that make a file of a folder an input; an icon is one only if it is given by name
SUFFIXES = frozenset(
    f".{ending}"
    for ending in (
        *("png", "apng", "jpg", "jpeg", "jpe", "jfif", "webp", "tif", "tiff", "bmp", "dib", "gif"),
        *("pnm", "pbm", "pgm", "ppm", "heic", "heif", "hif", "pdf", "svg", "svgz"),
        *("avif", "tga", "jp2", "j2k", "jpx", "jpf"),
        *("excalidraw", "tldr", "inkml", "ink"),
    )
)

_PREFIXES = (
    (b"\x89PNG\r\n\x1a\n", "PNG"),
    (b"\xff\xd8\xff", "JPEG"),
    (b"II*\0", "TIFF"),
    (b"MM\0*", "TIFF"),
    (b"II+\0", "TIFF"),
    (b"MM\0+", "TIFF"),
    (b"BM", "BMP"),
    (b"GIF87a", "GIF"),
    (b"GIF89a", "GIF"),
    (b"%PDF-", "PDF"),
    (b"\x1f\x8b", "SVG"),
    (b"\0\0\1\0", "ICO"),
    (b"\0\0\0\x0cjP  \r\n\x87\n", "JPEG2000"),
    (b"\xff\x4f\xff\x51", "JPEG2000"),
)
_AVIF_BRANDS = (b"avif", b"avis")
_HEIF_BRANDS = (b"heic", b"heix", b"heim", b"heis", b"hevc", b"mif1", b"msf1")


def read_picture(
    source: Source, limits: Limits | None = None, *, page: int = 0, name: str | None = None, reduced: bool = False
) -> Picture:
    """Read one picture, as a viewer would show it.

    source : path, encoded bytes, open file, PIL image, or array (h, w), (h, w, 3) RGB or (h, w, 4) RGBA of integers,
             booleans or floats in 0..1 (OpenCV's own are BGR: give `image[..., ::-1]`); a Picture is returned as it is
    page   : page of a TIFF or PDF, from 0; an animation gives its first frame
    name   : what messages and reports call it; default: the path, or a word for the kind of source
    reduced : decode a large JPEG no finer than the ink is looked for, in a fraction of the time; `Picture.size` is
              that of the whole

    EXIF orientation is applied, palettes and CMYK become RGB, 16 bits are scaled to 8, transparency is composited over
    white (over black where the ink itself is light).

    Raises UnreadableError, LimitError, MissingPackageError.
    """
    limits = limits or Limits()
    if isinstance(source, Picture):
        return source
    label = name or source_name(source)
    if not isinstance(source, str | os.PathLike | bytes | bytearray | memoryview) and not hasattr(source, "read"):
        return Picture(_pixels(source, limits), label)
    data = read_bytes(source, limits)
    drawing = _vectors(data, limits, page, label)
    if drawing is not None:
        return drawing
    pixels, full_size = _decode(data, limits, page, reduced)
    return Picture(pixels, label, full_size)


def _vectors(data: bytes, limits: Limits, page: int, label: str) -> Picture | None:
    """The lines of a vector drawing; None for what is read as pixels."""
    name = sniff(data)
    if name not in VECTORS:
        return None
    from sketch2shape.reading.vector_formats import read_vectors

    return _guarded(lambda: read_vectors(name, data, limits, page, label))


def source_name(source: Source) -> str:
    """What to call a source in messages: its path, or a word for its kind."""
    if isinstance(source, str | os.PathLike):
        return os.fspath(source)
    if isinstance(source, Picture):
        return source.source
    if isinstance(source, bytes | bytearray | memoryview):
        return "<bytes>"
    filename = getattr(source, "filename", None) or getattr(source, "name", None)
    return filename if isinstance(filename, str) and filename else f"<{type(source).__name__.lower()}>"


def _pixels(source: Any, limits: Limits) -> Pixels:
    """Of what has been decoded already."""
    if hasattr(source, "__array_interface__") and not hasattr(source, "getbands"):
        return from_array(source, limits)
    if hasattr(source, "getbands"):
        limits.check_size(*source.size)
        return _guarded(lambda: from_image(source))
    raise UnreadableError(
        f"{type(source).__name__} is no picture", remedy="a path, bytes, a PIL image or an array of integers"
    )


def read_bytes(source: Any, limits: Limits) -> bytes:
    """The encoded bytes of a path, an open binary file or a bytes-like object. Raises UnreadableError, LimitError."""
    if isinstance(source, bytes | bytearray | memoryview):
        limits.check_bytes(len(source))
        data = bytes(source)
    elif isinstance(source, str | os.PathLike):
        data = _read_file(source, limits)
    else:
        data = _read_open(source, limits)
        limits.check_bytes(len(data))
    if not data:
        raise UnreadableError("the file is empty")
    return data


def _read_open(file: Any, limits: Limits) -> bytes:
    """The rest of an open file; all of it where it stands at its end, as one does that has just been written."""
    binary = getattr(file, "buffer", file)  # a file opened as text holds the same bytes
    try:
        data = binary.read(limits.max_bytes + 1)
        if not data and binary.seekable() and binary.tell():
            binary.seek(0)
            data = binary.read(limits.max_bytes + 1)
    except (OSError, ValueError, AttributeError) as error:
        raise UnreadableError(
            f"the open file cannot be read ({_first_line(error)})", remedy="a path or bytes"
        ) from None
    if isinstance(data, str):  # text in memory: an SVG
        return data.encode("utf-8", "surrogateescape")
    if not isinstance(data, bytes):
        raise UnreadableError(f"the open file gives {type(data).__name__}, not bytes", remedy="open it in binary mode")
    return data


def _read_file(path: str | os.PathLike[str], limits: Limits) -> bytes:
    """Read a regular file; anything else (a pipe would block, a device never end) is refused unread."""
    try:
        descriptor = os.open(path, os.O_RDONLY | getattr(os, "O_NONBLOCK", 0) | getattr(os, "O_BINARY", 0))
    except (OSError, ValueError) as error:
        raise UnreadableError(_why(error), remedy=_remedy(error)) from None
    try:
        status = os.fstat(descriptor)
        if not stat.S_ISREG(status.st_mode):
            raise UnreadableError(f"{_kind(status.st_mode)}, not a picture file")
        limits.check_bytes(status.st_size)
        with open(descriptor, "rb", buffering=0, closefd=False) as file:
            data = file.read(limits.max_bytes + 1)
    except OSError as error:
        raise UnreadableError(_why(error)) from None
    finally:
        os.close(descriptor)
    limits.check_bytes(len(data))
    return data


def _why(error: OSError | ValueError) -> str:
    """The reason the system gives, as the middle of a sentence."""
    reason = error.strerror if isinstance(error, OSError) and error.strerror else str(error)
    return reason[:1].lower() + reason[1:]


def _remedy(error: OSError | ValueError) -> str:
    if isinstance(error, FileNotFoundError):
        return "check the path"
    if isinstance(error, PermissionError):
        return "chmod +r, or another user"
    return "another file"


def _kind(mode: int) -> str:
    kinds = ((stat.S_ISDIR, "a folder"), (stat.S_ISFIFO, "a named pipe"), (stat.S_ISSOCK, "a socket"))
    return next((word for test, word in kinds if test(mode)), "a device")


def sniff(data: bytes) -> str | None:
    """The format of encoded bytes, by their first bytes: a key of PLUGINS, one of EXTRA, or None."""
    for prefix, name in _PREFIXES:
        if data.startswith(prefix):
            return name
    if data[:4] == b"RIFF" and data[8:12] == b"WEBP":
        return "WEBP"
    if data[4:8] == b"ftyp" and data[8:12] in (*_HEIF_BRANDS, *_AVIF_BRANDS):
        return "AVIF" if data[8:12] in _AVIF_BRANDS else "HEIF"
    if data[:1] == b"P" and data[1:2] in b"123456" and data[2:3].isspace():
        return "PPM"
    if _is_xml_with(b"<svg", data) or _is_xml_with(b":svg", data):
        return "SVG"
    if _is_xml_with(b"InkML", data):
        return "INKML"
    if data[:64].lstrip(b"\xef\xbb\xbf \t\r\n")[:1] in (b"{", b"["):
        return "JSON"
    return "TGA" if _is_tga(data) else None


def _is_xml_with(mark: bytes, data: bytes) -> bool:
    """Whether it is XML with a mark near its beginning, in any encoding that writes ASCII as ASCII, or UTF-16."""
    head = data[:65536].lstrip(b"\xef\xbb\xbf\xff\xfe")
    head = head.replace(b"\0", b"") if b"\0" in head[:4] else head
    return head.lstrip(b" \t\r\n").startswith(b"<") and mark in head


def _is_tga(data: bytes) -> bool:
    """By its footer or, as the older version has none and no first bytes of its own, by a header that makes sense."""
    if data[-18:] == b"TRUEVISION-XFILE.\0":
        return True
    header = data[:18]
    if len(header) < 18 or header[1] > 1 or header[2] not in (1, 2, 3, 9, 10, 11) or header[17] & 0xC0:
        return False
    sized = any(header[12:14]) and any(header[14:16])
    return sized and header[16] in (8, 16, 24, 32) and (header[1] == 1) == (header[2] in (1, 9))


def _format(data: bytes) -> str:
    name = sniff(data)
    if name is None:
        text = b"\0" not in data[:4096]
        raise UnreadableError("not a picture (it looks like text)" if text else "not a picture of a known format")
    return name


def count_pages(data: bytes) -> int:
    """How many pages encoded bytes hold: those of a TIFF or PDF, else 1. Raises UnreadableError."""
    name = _format(data)
    if name == "PDF":
        from sketch2shape.reading.extra_formats import count_pdf_pages

        return _guarded(lambda: count_pdf_pages(data))
    if name != "TIFF":
        return 1
    return int(_guarded(lambda: getattr(_open(data, name), "n_frames", 1)))


def _decode(data: bytes, limits: Limits, page: int, reduced: bool) -> tuple[Pixels, tuple[int, int] | None]:
    """The pixels and, where they are a reduced copy, the width and height of the picture."""
    name = _format(data)
    if name in EXTRA:
        from sketch2shape.reading.extra_formats import decode_extra

        return _guarded(lambda: from_image(decode_extra(name, data, limits, page))), None
    if name == "WEBP":
        limits.check_size(*webp_size(data))

    def decode() -> tuple[Pixels, tuple[int, int] | None]:
        image = _open(data, name)
        if page:
            image.seek(page)
        limits.check_size(*image.size)
        full_size = image.size
        if not (reduced and _reduce(image)):
            return from_image(image), None
        pixels = from_image(image)
        upright = (pixels.shape[1] > pixels.shape[0]) == (full_size[0] > full_size[1])
        return pixels, full_size if upright else full_size[::-1]

    return _guarded(decode)


def _open(data: bytes, name: str) -> Image:
    """Read the header, with the plugin for this format alone."""
    from importlib import import_module

    from PIL import Image, features

    if name in _OPTIONAL and not features.check(_OPTIONAL[name]):
        raise MissingPackageError(f"this Pillow does not decode {name}", remedy="pip install --upgrade pillow")
    import_module(f"PIL.{PLUGINS[name]}")
    return Image.open(io.BytesIO(data), formats=[name])


def _reduce(image: Image) -> bool:
    """Have a large JPEG decoded at a half, a quarter or an eighth, by its cosine transform; whether that will be."""
    w, h = image.size
    step = next((s for s in (8, 4, 2) if max(w, h) >= s * ENOUGH), 1)
    return step > 1 and min(w, h) >= step and image.draft(None, (w // step, h // step)) is not None


def webp_size(data: bytes) -> tuple[int, int]:
    """Width and height from the header of a WebP file, whose decoder reserves memory for them as soon as it is opened.

    Source: RFC 9649, sections 2.5 to 2.7. Raises UnreadableError.
    """
    kind, body = data[12:16], data[20:30]
    if len(body) == 10:
        if kind == b"VP8X":
            return 1 + int.from_bytes(body[4:7], "little"), 1 + int.from_bytes(body[7:10], "little")
        if kind == b"VP8L":
            bits = int.from_bytes(body[1:5], "little")
            return 1 + (bits & 0x3FFF), 1 + (bits >> 14 & 0x3FFF)
        if kind == b"VP8 ":
            return int.from_bytes(body[6:8], "little") & 0x3FFF, int.from_bytes(body[8:10], "little") & 0x3FFF
    raise UnreadableError("damaged WebP header")


def _guarded(decode: Callable[[], R]) -> R:
    """Run a decoder on bytes of a stranger and turn whatever it raises into an error of ours.

    Decoders raise nearly every class of exception on damaged input (struct.error, KeyError, SyntaxError, ...), so this
    is the one place that catches them all.
    """
    try:
        return decode()
    except Sketch2ShapeError:
        raise
    except MemoryError:
        raise LimitError("not enough memory to decode it") from None
    except EOFError:
        raise UnreadableError("damaged, or it has no such page", remedy="a complete file, or a lower --pages") from None
    except Exception as error:
        if type(error).__name__.startswith("DecompressionBomb"):  # the warning, where warnings are errors
            pixels = next((int(word) for word in str(error).replace("(", "").split() if word.isdigit()), 0)
            raise LimitError(f"{pixels / 1e6:.0f} megapixels are too many", remedy="a smaller picture") from None
        raise UnreadableError(f"damaged ({_first_line(error)})", remedy="save or download it again") from error


def _first_line(error: Exception) -> str:
    """What a decoder said, short, without object addresses, which would differ from run to run."""
    lines = str(error).splitlines()
    text = lines[0] if lines else ""
    return type(error).__name__ if not text or " object at 0x" in text else text[:120]


def parse_page(text: str) -> int | None:
    """Read `--pages`: a page number from 1, returned from 0, or "all" (None). Raises UsageError."""
    if text == "all":
        return None
    if text.isdigit() and int(text) > 0:
        return int(text) - 1
    raise UsageError(f"--pages {text}", remedy="--pages 1, another page number, or --pages all")
