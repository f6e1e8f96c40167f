"""XML of strangers is bounded before any library sees it."""

import pytest

from sketch2shape.errors import LimitError, UnreadableError
from sketch2shape.reading.guarded_xml import local, parsed


def test_a_tree_with_name_spaces():
    root = parsed(b'<a:x xmlns:a="http://a" a:k="1" l="2"><a:y>t</a:y></a:x>')
    assert root.tag == "{http://a}x"
    assert root.attrib == {"{http://a}k": "1", "l": "2"}
    assert (local(root[0].tag), root[0].text) == ("y", "t")


def test_plain_entities_are_replaced():
    data = b'<!DOCTYPE x [<!ENTITY n "http://a">]><x xmlns="&n;"/>'
    assert parsed(data).tag == "{http://a}x"


@pytest.mark.parametrize(
    "declared",
    [
        '<!ENTITY a "aaaa"><!ENTITY b "&a;&a;">',
        '<!ENTITY a SYSTEM "file:///etc/passwd">',
        '<!ENTITY % a "aaaa">%a;<!ENTITY b "%a;">',
        f'<!ENTITY a "{"a" * 1000}">',
        "".join(f'<!ENTITY a{k} "b">' for k in range(100)),
    ],
)
def test_entities_that_could_grow_or_read_files_are_refused(declared):
    with pytest.raises(UnreadableError):
        parsed(f"<!DOCTYPE x [{declared}]><x>&a;</x>".encode())


def test_depth_elements_and_text_are_bounded():
    with pytest.raises(LimitError, match="deep"):
        parsed(b"<g>" * 10_000 + b"</g>" * 10_000)
    with pytest.raises(LimitError, match="elements"):
        parsed(b"<g>" + b"<a/>" * 30_000 + b"</g>")
    with pytest.raises(LimitError, match="points"):
        parsed(b'<g d="' + b"1 " * 2**20 + b'"/>')
    with pytest.raises(LimitError, match="too large"):
        parsed(b"<g>" + b" " * 9 * 2**20 + b"</g>")


def test_embedded_pictures_do_not_count():
    root = parsed(b'<g><image href="data:image/png;base64,' + b"A" * 9 * 2**20 + b'"/></g>')
    assert root[0].attrib == {}


@pytest.mark.parametrize("data", [b"", b"<a", b"<a></b>", b"text", b"\x00\x01", b"<a>&b;</a>"])
def test_what_is_no_xml_is_refused(data):
    with pytest.raises(UnreadableError):
        parsed(data)
