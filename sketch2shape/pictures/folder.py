"""Pictures of a whole folder of results: a contact sheet and an HTML index with links."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from html import escape
from itertools import islice
from urllib.parse import quote

import numpy as np

from sketch2shape.model import TRUSTED
from sketch2shape.pictures.canvas import Canvas, Pixels, encode_jpeg, fit, shorten, shown
from sketch2shape.pictures.palette import BACKDROP, DONE, DOUBT, FAILED, INK, MUTED, PAPER, RULE, Colour, css
from sketch2shape.pictures.viewer import data_uri

_WIDTH, _HEIGHT, _GAP, _CAPTION = 300, 220, 16, 46
_CARDS = 60
"""Cards on one contact sheet: 12 rows of 5, a picture that can be printed on one page and that viewers open."""


@dataclass(frozen=True)
class Entry:
    """One input of a batch.

    name       : how it is called, relative to the folder
    thumbnail  : (h, w, 3) uint8 RGB, such as its overlay, or None if there is nothing to show
    confidence : of the best object, or None if none was found
    message    : why it failed, or None
    links      : (words, address relative to the index) of what was written for it
    """

    name: str
    thumbnail: Pixels | None = None
    confidence: float | None = None
    message: str | None = None
    links: Sequence[tuple[str, str]] = field(default=())

    @property
    def status(self) -> str:
        """The line of words under the thumbnail."""
        if self.message is not None:
            return self.message
        if self.confidence is None:
            return "done"
        return f"{'done' if self.confidence >= TRUSTED else 'please check'}, confidence {self.confidence:.2f}"

    @property
    def colour(self) -> Colour:
        """Of its mark: failed, to be checked, or done."""
        if self.message is not None:
            return FAILED
        return DONE if self.confidence is None or self.confidence >= TRUSTED else DOUBT


def contact_sheet(entries: Iterable[Entry], columns: int = 5) -> Pixels:
    """Thumbnails on one sheet with name and status, failed ones marked, however many; (h, w, 3) uint8 RGB.

    For long folders see `contact_sheets`.
    """
    return _sheet(list(entries), columns)


def contact_sheets(entries: Iterable[Entry], columns: int = 5, cards: int = _CARDS) -> Iterator[Pixels]:
    """All thumbnails on as many sheets as it takes (`count_sheets`), `cards` on each; one sheet at a time in memory."""
    rest = iter(entries)
    page = list(islice(rest, cards))
    yield _sheet(page, columns)
    while page := list(islice(rest, cards)):
        yield _sheet(page, columns)


def count_sheets(count: int, cards: int = _CARDS) -> int:
    """How many sheets `contact_sheets` makes of `count` entries."""
    return max(1, -(-count // cards))


def _sheet(cards: Sequence[Entry], columns: int) -> Pixels:
    columns = max(1, min(columns, len(cards)))
    rows = [_row(cards[k : k + columns], columns) for k in range(0, len(cards), columns)]
    if not cards:
        foot = Canvas(_GAP + columns * (_WIDTH + _GAP), 60, BACKDROP)
        foot.words((foot.width / 2, 26), "nothing to show", 14, MUTED, "mm")
        rows.append(foot.finish())
    return np.concatenate(rows)


def _row(cards: Sequence[Entry], columns: int) -> Pixels:
    canvas = Canvas(_GAP + columns * (_WIDTH + _GAP), _GAP + _HEIGHT + _CAPTION, BACKDROP)
    for k, entry in enumerate(cards):
        _card(canvas, entry, _GAP + k * (_WIDTH + _GAP), _GAP)
    return canvas.finish()


def folder_index(entries: Iterable[Entry], title: str) -> str:
    """An HTML page with a card for each input: thumbnail, status and links; it loads nothing from elsewhere."""
    cards, failed, doubtful = [], 0, 0
    for entry in entries:  # one at a time, so that a long folder's thumbnails are never all in memory
        cards.append(_html_card(entry))
        failed += entry.colour == FAILED
        doubtful += entry.colour == DOUBT
    return _PAGE.format(
        title=escape(shown(title)),
        count=len(cards),
        done=len(cards) - failed,
        failed=failed,
        check=f", {doubtful} of them to be checked" if doubtful else "",
        cards="\n".join(cards),
        good=css(DONE),
        bad=css(FAILED),
        doubt=css(DOUBT),
    )


def _card(canvas: Canvas, entry: Entry, left: int, top: int) -> None:
    canvas.box(left - 1, top - 1, _WIDTH + 2, _HEIGHT + 2, RULE)
    canvas.box(left, top, _WIDTH, _HEIGHT, PAPER)
    if entry.thumbnail is None:
        canvas.words((left + _WIDTH / 2, top + _HEIGHT / 2), "no picture", 13, MUTED, "mm")
    else:
        small, _ = fit(entry.thumbnail, _WIDTH, _HEIGHT)
        h, w = small.shape[:2]
        canvas.paste(small, left + (_WIDTH - w) // 2, top + (_HEIGHT - h) // 2)
    canvas.box(left, top + _HEIGHT + 11, 8, 8, entry.colour)
    canvas.words((left + 14, top + _HEIGHT + 6), shorten(entry.name, 14, _WIDTH - 14, "end"), 14, INK)
    canvas.words(
        (left + 14, top + _HEIGHT + 25),
        shorten(entry.status, 12, _WIDTH - 14),
        12,
        MUTED if entry.colour == DONE else entry.colour,
    )


def _html_card(entry: Entry) -> str:
    name, status = escape(shown(entry.name)), escape(shown(entry.status))
    broken = _BREAKS.sub(r"\1<wbr>", name)
    picture = '<div class="none">no picture</div>'
    if entry.thumbnail is not None:
        small, _ = fit(entry.thumbnail, _WIDTH * 2, _HEIGHT * 2)
        picture = f'<img src="{data_uri(encode_jpeg(small), "jpeg")}" alt="The object found in {name}">'
    links = " ".join(f'<a href="{escape(_address(to))}">{escape(words)}</a>' for words, to in entry.links)
    return (
        f'<li class="{_CLASSES[entry.colour]}" style="--sure:{_rank(entry)}">{picture}<h2>{broken}</h2>'
        f'<p>{status}</p><p class="links">{links}</p></li>'
    )


def _address(path: str) -> str:
    """The path as an address: byte by byte, whatever its encoding."""
    return quote(path, errors="surrogateescape")


def _rank(entry: Entry) -> int:
    """Its place where the least sure come first: failures, then by confidence."""
    return -1 if entry.message is not None else round(1000 * (1.0 if entry.confidence is None else entry.confidence))


_BREAKS = re.compile(r"([/_\-. ])(?=\w)")
"""Where a long name may be broken: after what separates its words, not within a word or an entity."""
_CLASSES = {FAILED: "bad", DOUBT: "doubt", DONE: "good"}
_PAGE = """<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; style-src 'unsafe-inline'; img-src data:">
<title>{title}</title>
<style>
  * {{ box-sizing: border-box }}
  body {{ margin: 0; padding: 20px; font: 16px/1.45 system-ui, sans-serif; color: #1c2028; background: #f6f7f9 }}
  h1 {{ font-size: 1.35rem; margin: 0; font-weight: 600 }}
  .sum {{ color: #59616d; margin: 4px 0 20px }}
  ul {{ list-style: none; margin: 0; padding: 0; display: grid; gap: 16px;
       grid-template-columns: repeat(auto-fill, minmax(240px, 1fr)) }}
  li {{ background: #fff; border: 1px solid #dadee4; border-top: 4px solid {good}; border-radius: 8px;
       padding: 12px; overflow-wrap: anywhere }}
  li.bad {{ border-top-color: {bad} }}
  li.doubt {{ border-top-color: {doubt} }}
  img, .none {{ width: 100%; height: 180px; object-fit: contain; display: grid; place-items: center; color: #59616d }}
  h2 {{ font-size: 1rem; font-weight: 600; margin: 10px 0 2px }}
  p {{ margin: 0; font-size: .9rem; color: #59616d }}
  .bad p:not(.links) {{ color: {bad} }}
  .doubt p:not(.links) {{ color: {doubt} }}
  .links {{ margin-top: 8px; display: flex; flex-wrap: wrap; gap: 4px 14px }}
  a {{ color: #0062b2 }}
  fieldset {{ display: inline-flex; flex-wrap: wrap; gap: 4px 14px; border: 0; padding: 0; margin: 0 28px 16px 0 }}
  legend {{ float: left; margin-right: 10px; color: #59616d }}
  form:has(#bad:checked) ~ ul li:not(.bad), form:has(#check:checked) ~ ul li:not(.doubt),
  form:has(#done:checked) ~ ul li.bad {{ display: none }}
  form:has(#sure:checked) ~ ul li {{ order: var(--sure) }}
</style>
</head>
<body>
<h1>{title}</h1>
<p class="sum">{count} pictures: {done} done{check}, {failed} failed</p>
<form>
<fieldset><legend>Show</legend>
<label><input type="radio" name="show" checked> all</label>
<label><input type="radio" name="show" id="done"> done</label>
<label><input type="radio" name="show" id="check"> to be checked</label>
<label><input type="radio" name="show" id="bad"> failed</label></fieldset>
<fieldset><legend>Sort by</legend>
<label><input type="radio" name="sort" checked> name</label>
<label><input type="radio" name="sort" id="sure"> least sure first</label></fieldset>
</form>
<ul>
{cards}
</ul>
</body>
</html>
"""
