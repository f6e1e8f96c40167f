"""Measure the lifting alone: the true drawing's vertices, with noise, lifted and compared with the true solid.

    python scripts/evaluate_lifting.py                              every set there is, docs/lifting.md rewritten
    python scripts/evaluate_lifting.py --sets committed --page ''   one set, tables on the screen only

Each drawing's truth is taken as the object found; in wireframes f1 and f2 are exchanged at random first, as nothing in
the picture tells them apart. Noise of a given standard deviation is added to every coordinate of every vertex.
"""

from __future__ import annotations

import argparse
import json
import time
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import manifold3d
import numpy as np
from evaluate_round_lifting import table
from lifting_gallery import gallery
from repository import ROOT

from evaluation import metrics
from evaluation.markdown import share
from sketch2shape.lifting import choose_front, lift
from sketch2shape.model.arrays import Floats, Ints
from sketch2shape.model.drawing import FacePair, TwoFaceObject
from sketch2shape.model.solid import Solid
from sketch2shape.solids import tessellated

#: headings of the part that is written by hand, and of what follows it
_BY_HAND, _AFTER = "## What nothing fixes", "## How often"

NOISES = (0.0, 0.5, 1.0, 2.0)
#: times that noise is added anew to each drawing
DRAWS = 5
SETS = {
    "committed": "The committed drawings (data/synthetic)",
    "bench": "Independent drawings (another generator, not in this repository)",
    "cad": "CAD wireframes with their true 3-D shape (not in this repository; the mirror in depth is accepted)",
}
GROUPS = ("oblique", "axonometric, right angles", "axonometric, others", "perspective", "tapered")


@dataclass(frozen=True)
class Case:
    """One lifted drawing.

    group  : row of the table
    right  : is the solid's error within the limit?
    family : is the projection's family right?
    below  : does the truth show a wireframe from below, against the stated reading?
    mesh   : is the mesh valid for manifold3d, with the volume of the solid?
    ms     : processor time of the lifting, milliseconds
    """

    group: str
    right: bool
    family: bool
    below: bool
    mesh: bool
    ms: float


def main() -> None:
    args = _arguments()
    folders = {
        "committed": ROOT / "data" / "synthetic",
        "bench": args.bench / "drawings",
        "cad": args.bench / "real" / "cad",
    }
    parts = []
    for name in args.sets:
        truths = list(_truths(folders[name]))
        if truths:
            parts.append(f"### {SETS[name]}\n\n" + _tables(truths, args.seed))
            print(parts[-1])
    if args.page and parts:
        page = Path(args.page)
        page.parent.mkdir(parents=True, exist_ok=True)
        made = {"{gallery}": gallery(), "{by hand}": by_hand(page), "{round}": table(40, 1)}
        head = _HEAD
        for place, text in made.items():
            head = head.replace(place, text)
        page.write_text(head + "\n".join(parts))


def by_hand(page: Path) -> str:
    """The part of the page that is written by hand, kept as it is; none if there is no page yet."""
    _, found, after = (page.read_text() if page.exists() else "").partition(_BY_HAND)
    return found + after.partition(_AFTER)[0] if found else ""


def _arguments() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--sets", nargs="+", choices=list(SETS), default=list(SETS))
    parser.add_argument("--bench", type=Path, default=ROOT.parent / "shared" / "bench")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--page", default=str(ROOT / "docs" / "lifting.md"))
    return parser.parse_args()


def _truths(folder: Path) -> Iterator[dict[str, Any]]:
    """Truths of drawings that hold one object of straight edges and its true solid."""
    for file in sorted(folder.glob("**/*.json")):
        truth = json.loads(file.read_text())
        if truth.get("solid") and len(truth.get("f1", ())) == len(truth["f2"]) and not truth.get("arcs"):
            truth.setdefault("category", file.parent.name)
            yield truth


def _tables(truths: list[dict[str, Any]], seed: int) -> str:
    runs = {
        noise: [
            [_case(t, noise, np.random.default_rng([seed, i, k])) for k in range(DRAWS if noise else 1)]
            for i, t in enumerate(truths)
        ]
        for noise in NOISES
    }
    clean = [cases[0] for cases in runs[NOISES[0]]]
    rows = [
        (group, [c.group == group for c in clean], "right") for group in GROUPS if any(c.group == group for c in clean)
    ]
    everything = [True] * len(clean)
    rows += [
        ("**all**", everything, "right"),
        ("all but wireframes seen from below", [not c.below for c in clean], "right"),
        ("family of projection right", everything, "family"),
        ("mesh valid, of the right volume (manifold3d)", everything, "mesh"),
    ]
    head = " | ".join(f"{noise:g} px" for noise in NOISES)
    lines = [f"| solid right, at noise of | drawings | {head} |", "|---|---|" + "---|" * len(NOISES)]
    for name, chosen, field in rows:
        cells = [
            share([bool(getattr(c, field)) for cases, use in zip(run, chosen, strict=True) if use for c in cases])
            for run in runs.values()
        ]
        lines.append(f"| {name} | {sum(chosen)} | {' | '.join(cells)} |")
    ms = np.array([c.ms for run in runs.values() for cases in run for c in cases])
    lines.append("")
    lines.append(f"Time of one lifting: median {np.median(ms):.1f} ms, 95 in 100 below {np.quantile(ms, 0.95):.1f} ms.")
    return "\n".join(lines) + "\n"


def _case(truth: dict[str, Any], noise: float, rng: np.random.Generator) -> Case:
    obj, swapped = _found(truth, noise, rng)
    chosen = choose_front(obj)
    swapped ^= chosen is not obj
    start = time.process_time()
    solid = lift(chosen, picture_size=(truth["width"], truth["height"]))
    ms = 1000.0 * (time.process_time() - start)
    half = len(solid.vertices) // 2
    match: Ints = np.roll(np.arange(2 * half), half if swapped else 0)
    error = metrics.solid_error(truth, {"solid": {"vertices": solid.vertices}}, match)
    family = metrics.family(truth)
    told = solid.projection.family == family or truth["category"].startswith("taper")
    below = swapped and family != "oblique" and "f1_xyz" not in truth["solid"]
    return Case(_group(truth, family), error < metrics.solid_limit(truth), told, below, _valid(solid), ms)


def _found(truth: dict[str, Any], noise: float, rng: np.random.Generator) -> tuple[TwoFaceObject, bool]:
    """The truth as a found object, with noise, and whether its faces were exchanged."""

    def noisy(ring: list[list[float]]) -> Floats:
        return np.array(ring, float) + rng.normal(0.0, noise, (len(ring), 2))

    holes = tuple(FacePair(noisy(h["f1"]), noisy(h["f2"])) for h in truth.get("holes") or [])
    obj = TwoFaceObject(noisy(truth["f1"]), noisy(truth["f2"]), holes, lines=truth["lines"], noise=noise)
    swap = truth["lines"] == "wire" and bool(rng.random() < 0.5)
    return (obj.swapped() if swap else obj), swap


def _group(truth: dict[str, Any], family: str) -> str:
    if truth["category"].startswith("taper"):
        return "tapered"
    if family != "axonometric":
        return family
    want = metrics.true_solid(truth)
    ring = want[: len(want) // 2] if want is not None else np.zeros((3, 3))
    before, after = np.roll(ring, 1, axis=0) - ring, np.roll(ring, -1, axis=0) - ring
    cosine = (before * after).sum(axis=1) / np.linalg.norm(before, axis=1) / np.linalg.norm(after, axis=1)
    return "axonometric, right angles" if np.abs(cosine).min() < 0.005 else "axonometric, others"


def _valid(solid: Solid) -> bool:
    size = np.abs(solid.vertices - solid.vertices.mean(axis=0)).max()
    vertices = (solid.vertices - solid.vertices.mean(axis=0)) / size
    mesh = manifold3d.Mesh(vertices.astype(np.float32), tessellated(solid.boundary).triangles.astype(np.uint32))
    body = manifold3d.Manifold(mesh)
    volume = body.volume() * size**3
    return body.status() == manifold3d.Error.NoError and abs(volume - solid.volume) <= 1e-3 * solid.volume


_HEAD = """# Lifting

How the flat object becomes a solid, and how often it becomes the one that is meant.

## How

All ways to read a drawing are weighed against each other in one currency, log odds: oblique (cabinet or cavalier),
isometric, dimetric (ISO 5456-3), any other axonometric view, one-point and any other perspective, tapered objects; for
four-sided faces each of the three pairs of sides.

1. **How are the two faces related?** Alike, similar, or by lines that meet. Residuals are taken as Student's t around
   the noise told, as a hand shakes more than its lines show. A far face that is a little off in size is a careless
   hand; only one clearly smaller is farther away, or tapers. Perspective has to earn its two more parameters.
2. **How regular is the solid?** Right and other simple angles, parallels, mirror symmetry and equal lengths of the true
   face, and a depth of once, twice or half an edge, each as sharp as the noise makes it.
3. **How usual is the view?** Level edges mean oblique; edges along all three axes at 30, 90 and 150 degrees mean
   isometric; what is drawn plumb is vertical; nothing is much longer than it looks. In a named view what is drawn near
   an axis runs along it: how far astray it was drawn counts once.
4. **Which solid is likeliest?** Readings that give the same proportions count together. The others are the
   `alternatives`: `--reading 2` takes the second. A slant that the drawing leaves vague is the mean of those it may be.
5. **Tidying.** Nearly parallel, right-angled, equal, symmetric or regular is made exact if that is likelier than chance
   and moves no vertex further than the noise.
6. **Standing.** The solid stands on z = 0, centred, x to the right and y away. `Solid.camera` takes its vertices back
   to the pixels of the drawing.

`Solid.confidence` is the part of the likelihood in solids of these proportions, times how well the noise leaves them
known. Its weights are fitted by `scripts/calibrate_lifting.py` on one half of drawings made there; on the other half
98.4 % of the solids at 0.9 or more are what was meant. A depth that an oblique drawing leaves free does not count: it
is a stated default.

What no wireframe tells: which of its two faces is in front (it is seen from above then); in an axonometric one of a
prism over a parallelogram, which two of its six sides are the parallelograms (each choice is a prism that gives this
very drawing).

## Arcs and points

Circles in parallel planes all look like ellipses of one form, so one good arc tells how the face is held: its ratio
is the cosine of the slant, its shorter axis runs along the connecting edges.

1. **Points of arcs are points of the face.** Points of an ellipse where its tangents have fixed directions, and
   points at fixed parts of an arc's length, are the same ones on both faces. They tell with the vertices how the
   faces are related.
2. **Roundness is evidence.** In each guess at the true face the points of an arc should lie on a circle; how far they
   miss the best one, in pixels of the drawing, counts beside right angles and equal lengths. So short arcs say
   little, long ones nearly all, and in an oblique drawing circles of the front stay circles.
3. **A point lies over the middle.** The apex of a pyramid or a cone stands over the centroid of its base; that gives
   the direction of the axis. A base of four sides is mostly a parallelogram in the drawing, and mostly a square or
   another regular polygon in truth. A base with a level edge under a plumb height is drawn as textbooks do: it
   is a rectangle that recedes, and the point may stand over a corner or the middle of an edge as well.
4. **What is in front.** A round or pointed object that stands is seen from above, so its upper end is the nearer one;
   the base of a lying cone is the nearer end unless the apex is drawn lower.
5. **Tidying.** Smooth joints, right angles, half and quarter turns become equations, then common centres and equal
   radii; the face is the one that obeys them and moves least. If a point would have to move further than the noise
   allows, fewer are asked for. Arcs are arcs of circles in any case.

## Twelve ambiguous drawings

Made by `python scripts/lifting_gallery.py`. Sizes are width x height x depth, pixels.

{gallery}
{by hand}## How often

Written by `python scripts/evaluate_lifting.py`. The vertices of each drawing are taken from its truth, so that only
the step from the flat object to the solid is measured; normal noise is added to every coordinate, five times anew.

A solid is right if, after the best similarity (no mirror), its vertices are within 5 % of the true ones (relative
root mean square; 10 % for drawings by hand, 12 % in perspective). Oblique drawings and tapered objects are judged by
their front face, as the drawing does not fix their depth. A wireframe alone can be read from above or from below; it
is read from above, so those that were drawn from below come out mirrored in depth: the very same solid, as the
mirror image of a right prism is that prism with its two faces exchanged, but not the same vertices in front. They
count as wrong in all rows but one.

### Arcs and points

Written by `python scripts/evaluate_round_lifting.py`. Objects and views are the generator's; noise is added to vertices
and arcs. Right means area over squared perimeter of the face, and depth over the root of its area, within 5 %; the
depth of oblique drawings is free and does not count. Tapered faces without symmetry stay ambiguous: nothing tells over
which point the axis stands.

{round}
"""


if __name__ == "__main__":
    main()
