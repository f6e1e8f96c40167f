"""Formats of the extra `formats`: HEIC photos, pages of PDF, SVG."""

from __future__ import annotations

import io
import math
import re
from typing import TYPE_CHECKING, Any

from sketch2shape.errors import MissingPackageError, UnreadableError
from sketch2shape.reading.limits import Limits

if TYPE_CHECKING:
    from PIL.Image import Image

_INSTALL = "pip install 'sketch2shape[formats]'"
_POINTS_PER_INCH = 72
#: vector pages are drawn at this resolution, or lower if that would pass this many pixels
_PAGE_DPI = 200
_PAGE_PIXELS = 16_000_000
#: longest side a drawn SVG is given, pixels
_SVG_SIDE = 2000


def decode_extra(name: str, data: bytes, limits: Limits, page: int) -> Image:
    """Decode HEIF, PDF or SVG bytes to a PIL image. Raises MissingPackageError, UnreadableError, LimitError."""
    if name == "HEIF":
        return _heif(data, limits)
    if name == "PDF":
        return _pdf(data, limits, page)
    return _svg(data, limits)


def _package(name: str, what: str) -> Any:
    from importlib import import_module

    try:
        return import_module(name)
    except ImportError:
        raise MissingPackageError(f"{what} needs the package {name}", remedy=_INSTALL) from None


def _heif(data: bytes, limits: Limits) -> Image:
    image = _package("pillow_heif", "HEIC").open_heif(io.BytesIO(data))  # reads the header; decodes on `to_pillow`
    limits.check_size(*image.size)
    decoded: Image = image.to_pillow()
    return decoded


def count_pdf_pages(data: bytes) -> int:
    """Number of pages of a PDF. Raises MissingPackageError, UnreadableError."""
    document = opened_pdf(data)
    try:
        return len(document)
    finally:
        document.close()


def opened_pdf(data: bytes) -> Any:
    """A document of pypdfium2. Raises MissingPackageError, UnreadableError."""
    pdfium = _package("pypdfium2", "PDF")
    try:
        return pdfium.PdfDocument(data)
    except pdfium.PdfiumError as error:
        reason = "the PDF has a password" if "password" in str(error).lower() else "damaged PDF"
        raise UnreadableError(reason, remedy="print it to a new PDF") from None


def _pdf(data: bytes, limits: Limits, page: int) -> Image:
    document = opened_pdf(data)
    try:
        if page >= len(document):
            raise UnreadableError(f"the PDF has {len(document)} pages", remedy="a lower --pages")
        sheet = document[page]
        width, height = sheet.get_size()
        scale = _page_scale(width, height, limits)
        image: Image = sheet.render(scale=scale).to_pil()
        return image
    finally:
        document.close()


def _page_scale(width: float, height: float, limits: Limits) -> float:
    """Pixels per point: 200 dpi, less for large pages; an absurd page is refused."""
    if not (0 < width < 1e6 and 0 < height < 1e6):
        raise UnreadableError(f"a PDF page of {width:g} x {height:g} points", remedy="print it to a new PDF")
    pixels = min(_PAGE_PIXELS, limits.max_pixels)
    fitting = math.sqrt(pixels / (width * height))
    scale = min(_PAGE_DPI / _POINTS_PER_INCH, fitting, limits.max_side / max(width, height))
    limits.check_size(math.ceil(width * scale * 0.99), math.ceil(height * scale * 0.99))
    return scale


def _svg(data: bytes, limits: Limits) -> Image:
    """Draw an SVG on white, its longest side _SVG_SIDE pixels. Nothing outside the file is read."""
    from PIL import Image, PngImagePlugin  # noqa: F401  (the plugin registers itself)

    resvg = _package("resvg_py", "SVG")
    text = xml_text(inflated(data, limits))
    width, height = svg_size(text)
    side = min(_SVG_SIDE, limits.max_side, math.isqrt(limits.max_pixels))
    shrink = side / max(width, height)
    if min(width, height) * shrink < 1:
        raise UnreadableError(f"an SVG of {width:g} x {height:g}", remedy="another page size")
    try:
        png = resvg.svg_to_bytes(
            svg_string=_without_links(text),
            background="#ffffff",
            dpi=96,
            skip_system_fonts=True,  # labels are not looked at; without them the same bytes everywhere
            width=round(width * shrink),
            height=round(height * shrink),
        )
    except BaseException as error:  # a panic of the renderer is no subclass of Exception
        if isinstance(error, KeyboardInterrupt | SystemExit):
            raise
        raise UnreadableError(f"damaged SVG ({str(error)[:80]})", remedy="save it as PNG") from None
    return Image.open(io.BytesIO(png), formats=["PNG"])


def inflated(data: bytes, limits: Limits) -> bytes:
    """Undo the gzip of .svgz, no further than the limit on bytes."""
    if data[:2] != b"\x1f\x8b":
        return data
    import zlib

    plain = zlib.decompressobj(wbits=31).decompress(data, limits.max_bytes + 1)
    limits.check_bytes(len(plain))
    return plain


def _without_links(text: str) -> str:
    """Blank links other than `#part` and `data:`, so that a drawing cannot pull in files of the machine."""
    return re.sub(r"(href\s*=\s*)([\"'])\s*(?!#|data:)[^\"']*\2", r"\1\2\2", text)


class _RootSeen(Exception):  # noqa: N818  (ends the parse, is no error)
    """The root element has been read."""


def svg_size(text: str) -> tuple[float, float]:
    """Width and height of the page in user units, from the root element alone."""
    from xml.parsers import expat

    found: dict[str, str] = {}

    def start(name: str, attributes: dict[str, str]) -> None:
        if name.rpartition(":")[2] == "svg":
            found.update(attributes)
        raise _RootSeen

    parser = expat.ParserCreate()
    parser.StartElementHandler = start
    try:
        parser.Parse(text, True)
    except _RootSeen:
        pass
    except expat.ExpatError as error:
        raise UnreadableError(f"damaged SVG ({error})", remedy="save it as PNG") from None
    return _box(found)


def _box(attributes: dict[str, str]) -> tuple[float, float]:
    """Width and height by the attributes of the root element: its sizes, its view box, or 100.

    Where one size is missing, or a part of a page that is not known, the view box tells the ratio.
    """
    view = [float(x) for x in _NUMBERS.findall(attributes.get("viewBox", ""))]
    page = (view[2], view[3]) if len(view) == 4 and view[2] > 0 and view[3] > 0 else None
    width, height = (_pixels(attributes.get(key, "")) for key in ("width", "height"))
    if page and width is None and height is None:
        width, height = page
    elif page:
        width = width if width is not None else (height or 0.0) * page[0] / page[1]
        height = height if height is not None else width * page[1] / page[0]
    sizes = (100.0 if width is None else width, 100.0 if height is None else height)
    if not all(0 < size < 1e9 for size in sizes):
        raise UnreadableError(f"an SVG of {sizes[0]:g} x {sizes[1]:g}", remedy="another page size")
    return sizes


def _pixels(length: str) -> float | None:
    """A length of SVG in pixels, None where it is missing or a part of the page."""
    match = _LENGTH.fullmatch(length)
    return float(match[1]) * _PIXELS_PER[match[2] or "px"] if match else None


_NUMBERS = re.compile(r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?")
_LENGTH = re.compile(r"\s*\+?(\d*\.?\d+(?:[eE][-+]?\d+)?)\s*(px|pt|pc|mm|cm|in|em|ex|)\s*")
#: CSS pixels in each unit of length, with letters of the usual size
_PIXELS_PER = {"px": 1.0, "pt": 4 / 3, "pc": 16.0, "mm": 96 / 25.4, "cm": 96 / 2.54, "in": 96.0, "em": 16.0, "ex": 8.0}


def xml_text(data: bytes) -> str:
    """The text of XML by its byte order mark, else by the encoding it declares, else UTF-8. Raises UnreadableError."""
    declared = _ENCODING.match(data.replace(b"\0", b"")[:200])
    name = declared[1].decode("ascii") if declared else "utf-8"
    if data.startswith((b"\xff\xfe", b"\xfe\xff")):
        name = "utf-16"
    elif data[:2] in (b"<\0", b"\0<"):
        name = "utf-16-le" if data[0] else "utf-16-be"
    elif data.startswith(b"\xef\xbb\xbf"):
        name = "utf-8-sig"
    try:
        return data.decode(name)
    except (LookupError, UnicodeDecodeError) as error:
        raise UnreadableError(f"damaged SVG ({error})"[:120], remedy="save it as PNG") from None


_ENCODING = re.compile(rb"\s*<\?xml[^>]*?encoding\s*=\s*[\"']([A-Za-z0-9._-]+)[\"']")
