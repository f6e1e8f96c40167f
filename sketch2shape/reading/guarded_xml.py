"""XML of strangers: parsed once with bounds on everything that can grow, before any library sees it."""

from __future__ import annotations

from xml.etree.ElementTree import Element, TreeBuilder
from xml.parsers import expat

from sketch2shape.errors import LimitError, UnreadableError

MOST_BYTES = 8 * 2**20
"""Size of a file; those of drawings are some kilobytes, photos within them do not count here (see `MOST_TEXT`)."""
MOST_DEPTH = 100
"""Elements within each other; programs nest ten."""
MOST_ELEMENTS = 20_000
"""Elements in all, those that <use> repeats included."""
MOST_TEXT = 2**20
"""Characters of shapes in all: attributes and text, but for embedded pictures."""
LONGEST_ENTITY, MOST_ENTITIES = 200, 64
"""Illustrator declares some twenty entities, addresses of name spaces; those that contain others are refused."""


def parsed(data: bytes) -> Element:
    """The root element. Raises LimitError where it is too large or deep, UnreadableError where it is no XML."""
    return _Reader().read(data)


class _Reader:
    """Counts while expat reads."""

    def __init__(self) -> None:
        self._references = 0
        self._depth = self._elements = self._text = self._entities = 0
        self._tree = TreeBuilder()

    def read(self, data: bytes) -> Element:
        if len(data) > MOST_BYTES and b"data:" not in data:
            raise LimitError("it is too large for a drawing of lines", remedy="a drawing, not a map")
        self._references = data.count(b"&")
        parser = expat.ParserCreate(namespace_separator="}")
        parser.buffer_text = True
        parser.StartElementHandler = self._start
        parser.EndElementHandler = self._end
        parser.CharacterDataHandler = self._characters
        parser.EntityDeclHandler = self._entity
        try:
            parser.Parse(data, True)
        except expat.ExpatError as error:
            raise UnreadableError(f"damaged XML ({error})", remedy="save it again") from None
        return self._tree.close()

    def _start(self, name: str, attributes: dict[str, str]) -> None:
        self._depth += 1
        self._elements += 1
        if self._depth > MOST_DEPTH:
            raise LimitError(f"its groups lie more than {MOST_DEPTH} deep", remedy="ungroup them")
        if self._elements > MOST_ELEMENTS:
            raise LimitError("it has too many elements", remedy="a drawing, not a map")
        kept = {key: value for key, value in attributes.items() if not value.startswith("data:")}
        self._count(sum(map(len, kept.values())))
        self._tree.start(_braced(name), {_braced(key): value for key, value in kept.items()})

    def _end(self, name: str) -> None:
        self._depth -= 1
        self._tree.end(_braced(name))

    def _characters(self, text: str) -> None:
        self._count(len(text))
        self._tree.data(text)

    def _count(self, characters: int) -> None:
        self._text += characters
        if self._text > MOST_TEXT:
            raise LimitError("its lines have too many points", remedy="a drawing, not a map or a traced photo")

    def _entity(self, name: str, is_parameter: bool, value: str | None, *_where: object) -> None:
        self._entities += 1
        if is_parameter or value is None or "&" in value or len(value) > LONGEST_ENTITY:
            raise UnreadableError(f"it declares the entity {name[:20]!r}", remedy="save it as plain SVG")
        # an attribute is put together before anyone can count it
        if self._references * len(value) > MOST_TEXT:
            raise LimitError("its entities grow too large", remedy="save it as plain SVG")
        if self._entities > MOST_ENTITIES:
            raise UnreadableError("it declares too many entities", remedy="save it as plain SVG")


def _braced(name: str) -> str:
    """ElementTree's way to write a name with its name space."""
    return "{" + name if "}" in name else name


def local(name: str) -> str:
    """A name without its name space."""
    return name.rpartition("}")[2]
