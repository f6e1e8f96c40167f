"""Refining: one hypothesis moved to the ink, without needless vertices, and held against the drawing."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from sketch2shape.evidence import Evidence, Sheet, View, compare, is_dashed, judge
from sketch2shape.fit import on_map, refine, simplified
from sketch2shape.hypotheses import Rings, plausible, split
from sketch2shape.model import Floats
from sketch2shape.search.found import Found
from sketch2shape.search.tolerances import Traced

HOPELESS = 0.1
"""Refinement rarely gains more score than this."""


def refined(traced: Traced, rings: Rings, evidence: Evidence, sheet: Sheet) -> Found:
    """The hypothesis moved to the ink and without needless vertices, judged as strictly as the lines allow."""
    points = traced.skeleton.outside_blots
    moved, noise = refine(rings, points, sheet.reach, evidence.drawn)
    strict = replace(sheet, reach=min(sheet.reach, max(2.0, 3.0 * noise + 0.1 * sheet.pen + 1.0)))
    judged = judge(moved, strict) if plausible(moved, 0.0) else None
    least = evidence.score - 0.01
    if judged is None or (judged.score < least and judge(moved, sheet).score < least):
        moved, judged = rings, judge(rings, strict)
    moved, judged = _put_right(moved, judged, strict, points)
    simpler, judged = simplified(moved, judged, strict, noise, points)
    if len(simpler.vertices) < len(moved.vertices):
        again, noise = refine(simpler, points, sheet.reach, judged.drawn)
        if plausible(again, 0.0):
            better = judge(again, strict)
            if better.score >= judged.score - 0.01:
                simpler, judged = again, better
    if judged.lines == "wire" and traced.group.pieces > 1:
        # a wide reach bridges the gaps of dashes; and only a front that is seen whole can be in front
        for way in (simpler, simpler.swapped()):
            if is_dashed(way, strict):
                return Found(way, replace(judge(way, strict), lines="dashed"), noise, sheet=strict)
    return Found(simpler, judged, noise, sheet=strict)


def _put_right(rings: Rings, judged: Evidence, sheet: Sheet, points: Floats) -> tuple[Rings, Evidence]:
    """With a vertex that was caught by the wrong ink put where the plane map has it, if that explains more."""
    for _ in range(3):
        for way in on_map(rings, judged.drawn, 3.0 * sheet.reach):
            moved, _ = refine(way, points, sheet.reach, judged.drawn)
            if plausible(moved, 0.0):
                better = judge(moved, sheet)
                if better.score > judged.score:
                    rings, judged = moved, better
                    break
        else:
            break
    return rings, judged


def at_dashes(rings: Rings, evidence: Evidence, sheet: Sheet, traced: Traced) -> tuple[Rings, Evidence]:
    """Hidden vertices moved to where dashed lines meet, where that explains the drawing better."""
    if evidence.lines == "wire" or evidence.drawn.all() or evidence.score < 0.6:
        return rings, evidence
    m, dashes = len(evidence.drawn), traced.dash_ends
    for i in np.flatnonzero(~evidence.drawn)[:8]:
        vertices = rings.vertices
        off = np.linalg.norm(dashes - vertices[m + i], axis=1)
        for k in np.argsort(off)[:5]:
            if off[k] > 0.12 * sheet.size:
                break
            moved = vertices.copy()
            moved[m + i] = dashes[k]
            other = split(moved, rings.sizes)
            judged = judge(other, sheet) if plausible(other, 0.0) else evidence
            more = judged.explained > evidence.explained + 0.003
            if more and judged.lines == "dashed" and judged.score > evidence.score - 0.01:
                rings, evidence = other, judged
    return rings, evidence


def compared_with(found: Found, view: View) -> Found:
    """The hypothesis held against the drawing."""
    return replace(found, compared=compare(found.rings, view, found.evidence.drawn, 1.5 * found.sheet.reach))
