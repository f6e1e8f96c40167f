"""Strokes as InkML, in the manners of its Recommendation and of the programs that write it."""

from __future__ import annotations

import numpy as np

from sketch2shape.model import Floats
from synthetic.hand import Stroke
from synthetic.json_files import dashed

Size = tuple[int, int]
_SPACE = 'xmlns="http://www.w3.org/2003/InkML"'


def _pulls(strokes: list[Stroke]) -> list[Floats]:
    """What the pen draws: dashes are traces of their own."""
    return [p for s in strokes for p in (dashed(s.path) if s.hidden else [s.path])]


def plain(strokes: list[Stroke], _size: Size, _rng: np.random.Generator) -> bytes:
    """X and Y alone."""
    traces = "\n".join(f"<trace>{', '.join(f'{x:.2f} {y:.2f}' for x, y in p)}</trace>" for p in _pulls(strokes))
    return f'<?xml version="1.0" encoding="UTF-8"?>\n<ink {_SPACE}>\n{traces}\n</ink>\n'.encode()


def differences(strokes: list[Stroke], _size: Size, _rng: np.random.Generator) -> bytes:
    """Whole numbers: the first point as it is, then first and second differences."""

    def words(path: Floats) -> str:
        at = np.rint(path * 10).astype(int)
        speed = np.diff(at, axis=0)
        change = np.diff(speed, axis=0)
        parts = [f"{at[0][0]} {at[0][1]}"]
        parts += [f"'{x}'{y}" for x, y in speed[:1]]
        parts += [f'"{x}"{y}' if k == 0 else f"{x} {y}" for k, (x, y) in enumerate(change)]
        return ",".join(parts)

    traces = "\n".join(f"<trace>{words(p)}</trace>" for p in _pulls(strokes))
    return f'<?xml version="1.0"?>\n<ink {_SPACE}>\n{traces}\n</ink>\n'.encode()


def channels(strokes: list[Stroke], _size: Size, rng: np.random.Generator) -> bytes:
    """Pressure first, then Y, X and time; hovering between the strokes."""
    names = "".join(f'<channel name="{n}" type="decimal"/>' for n in "FYXT")
    traces, clock = [], 0
    for p in _pulls(strokes):
        points = [f"{rng.integers(200, 900)} {y:.1f} {x:.1f} {clock + 10 * k}" for k, (x, y) in enumerate(p)]
        clock += 10 * len(p) + 200
        traces.append(f"<trace type='penDown'>{', '.join(points)}</trace>")
        traces.append(f"<trace type='penUp'>0 {p[-1][1]:.1f} {p[-1][0]:.1f} {clock}, 0 0 0 {clock + 5}</trace>")
    head = f"<definitions><traceFormat xml:id='f'>{names}</traceFormat></definitions>"
    return f"<ink {_SPACE}>{head}{''.join(traces)}</ink>".encode()


def office(strokes: list[Stroke], _size: Size, _rng: np.random.Generator) -> bytes:
    """A prefix for the name space, an ink source with its channels, brushes, hundredths of a millimetre."""
    unit = 2540 / 96
    limits = {"X": 32767, "Y": 32767, "F": 1023}
    channels = "".join(f'<inkml:channel name="{n}" type="integer" max="{m}"/>' for n, m in limits.items())
    source = f'<inkml:inkSource xml:id="s0"><inkml:traceFormat>{channels}</inkml:traceFormat></inkml:inkSource>'
    brush = '<inkml:brush xml:id="br0"><inkml:brushProperty name="width" value="0.05" units="cm"/></inkml:brush>'
    time = '<inkml:timestamp xml:id="ts0" timeString="2024-03-01T10:00:00"/>'
    context = f'<inkml:context xml:id="ctx0">{source}{time}</inkml:context>'
    traces = "".join(
        f'<inkml:trace contextRef="#ctx0" brushRef="#br0">{points}</inkml:trace>'
        for points in (",".join(f"{x:.0f} {y:.0f} 512" for x, y in p * unit) for p in _pulls(strokes))
    )
    space = 'xmlns:inkml="http://www.w3.org/2003/InkML"'
    return f"<inkml:ink {space}><inkml:definitions>{context}{brush}</inkml:definitions>{traces}</inkml:ink>".encode()


def upward(strokes: list[Stroke], size: Size, _rng: np.random.Generator) -> bytes:
    """Groups of traces with a note, in inches, Y counted upwards as the channel says."""
    form = '<traceFormat><channel name="X"/><channel name="Y" orientation="-ve"/></traceFormat>'
    note = "<annotation type='truth'>a box</annotation>"
    traces = "".join(
        f"<trace id='t{k}'>{', '.join(f'{x / 96:.5f} {(size[1] - y) / 96:.5f}' for x, y in p)}</trace>"
        for k, p in enumerate(_pulls(strokes))
    )
    return f"<ink {_SPACE}>{form}<traceGroup>{note}<traceGroup>{traces}</traceGroup></traceGroup></ink>".encode()


MANNERS = {f"inkml/{f.__name__}": f for f in (plain, differences, channels, office, upward)}
