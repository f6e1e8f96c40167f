"""The house as one picture: rooms in the order of their layers, an arrow for each edge. Drawn by scripts/house.py."""

from __future__ import annotations

import ast
import re
from html import escape

from house import House, reachable

WIDTH = 1000
TOP = 58
ROW = 34
"""px from one room to the next"""
BOX = (235, 555)
"""px, left border and width of every room"""
HIGH = 26
"""px, height of a room"""

STYLE = """
  text { font: 13px system-ui, sans-serif; fill: #1f2328 }
  .name { font-weight: 600 } .small { font-size: 12px; fill: #59636e }
  rect { fill: #f6f8fa; stroke: #8c959f }
  path { fill: none }
  .direct { stroke: #0969da; stroke-width: 1.6; marker-end: url(#tip) }
  .implied { stroke: #8c959f; stroke-width: 0.8; opacity: 0.75; marker-end: url(#pale) }
  #tip path { fill: #0969da } #pale path { fill: #8c959f }
  @media (prefers-color-scheme: dark) {
    text { fill: #e6edf3 } .small { fill: #9198a1 }
    rect { fill: #151b23; stroke: #656c76 }
    .direct { stroke: #4493f8 } #tip path { fill: #4493f8 }
    .implied { stroke: #656c76 } #pale path { fill: #656c76 }
  }
"""


def picture(house: House, rows: list[list[str]]) -> str:
    """SVG text, the same for the same house. Left: edges that no longer way explains; right: all others."""
    known = [room for row in rows for room in row]
    order = [room for room in known if room in house.rooms] + [room for room in house.rooms if room not in known]
    y = {room: TOP + at * ROW for at, room in enumerate(order)}
    direct, implied = _told_apart(house.edges)
    high = TOP + len(order) * ROW + 10
    parts = [
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {high}" role="img" aria-labelledby="t">',
        f'<title id="t">The rooms of sketch2shape and their {len(house.edges)} edges</title>',
        f"<style>{STYLE}</style>",
        "<defs>" + _tip("tip", 7) + _tip("pale", 5) + "</defs>",
        '<text x="18" y="24" class="small">imports that no longer way explains</text>',
        f'<text x="{WIDTH - 18}" y="24" class="small" text-anchor="end">all other imports</text>',
        f'<text x="{BOX[0] + BOX[1] / 2}" y="24" class="small" text-anchor="middle">imports run down only</text>',
        *(_arrow(y, a, b, left=False) for a, b in sorted(implied)),
        *(_arrow(y, a, b, left=True) for a, b in sorted(direct)),
        *(_box(room, y[room], _purpose(house, room)) for room in order),
        "</svg>",
    ]
    return "\n".join(parts) + "\n"


def _told_apart(edges: set[tuple[str, str]]) -> tuple[set[tuple[str, str]], set[tuple[str, str]]]:
    """Edges that are the only way between their rooms, and the others."""
    far = reachable(edges)
    implied = {(a, c) for a, c in edges if any(c in far.get(b, ()) for d, b in edges if d == a and b != c)}
    return edges - implied, implied


def _purpose(house: House, room: str) -> str:
    """What a room is for: its docstring up to the first full stop or colon."""
    file = house.modules[f"sketch2shape.{room}"]
    text = (ast.get_docstring(ast.parse(file.read_text("utf-8"))) or "").replace("`", "")
    return re.split(r"[.:;](?:\s|$)", " ".join(text.split()), maxsplit=1)[0]


def _tip(name: str, size: int) -> str:
    shape = f'<path d="M0,0 L{size},{size / 2} L0,{size} z"/>'
    return (
        f'<marker id="{name}" markerUnits="userSpaceOnUse" markerWidth="{size}" markerHeight="{size}" refX="{size}" '
        f'refY="{size / 2}" orient="auto">{shape}</marker>'
    )


def _arrow(y: dict[str, int], a: str, b: str, *, left: bool) -> str:
    """A bow beside the boxes, wider the further apart the rooms are."""
    start, end = y[a] + HIGH * 0.7, y[b] + HIGH * 0.3
    border = BOX[0] if left else BOX[0] + BOX[1]
    bow = 18 + min(0.5 * abs(end - start), 270)
    aside = border - bow if left else border + bow
    kind = "direct" if left else "implied"
    way = f"M{border},{start:.1f} C{aside:.1f},{start:.1f} {aside:.1f},{end:.1f} {border},{end:.1f}"
    return f'<path class="{kind}" d="{way}"><title>{a} imports from {b}</title></path>'


def _box(room: str, top: int, purpose: str) -> str:
    left, width = BOX
    middle = top + HIGH / 2 + 4.5
    return (
        f'<rect x="{left}" y="{top}" width="{width}" height="{HIGH}" rx="4"/>'
        f'<text x="{left + 12}" y="{middle}" class="name">{room}</text>'
        f'<text x="{left + 112}" y="{middle}" class="small">{escape(purpose)}</text>'
    )
