"""Measure the tool on drawings with truth and write docs/results.md.

    python scripts/evaluate.py                     all sets, page rewritten
    python scripts/evaluate.py --sets fresh --categories 'photo_*' --page ''     one kind, table on the screen only

Sets: `committed` (data/synthetic), `fresh` (every category, drawn anew from --seed),
`bench` and `real` (independent drawings and real pictures outside this repository, when --bench exists).
"""

from __future__ import annotations

import argparse
import fnmatch
import json
import multiprocessing
import os
import shlex
import sys
import tempfile
import time
from pathlib import Path
from typing import Any

os.environ.setdefault("OMP_NUM_THREADS", "1")  # two worker processes, a core each

from PIL import Image
from repository import ROOT

from evaluation.failures import write_sheets
from evaluation.page import summary_table, write_page
from synthetic import metrics
from synthetic.drawing import draw
from synthetic.recipes import RECIPES

SETS = ("committed", "fresh", "bench", "real")

Case = dict[str, Any]


def main() -> None:
    args = _arguments()
    with tempfile.TemporaryDirectory() as scratch:
        cases = [c for name in args.sets for c in collect(name, args, Path(scratch))]
        outcomes = run(cases, args.jobs, args.seconds)
        print(summary_table(outcomes))
        if args.raw:
            Path(args.raw).write_text(json.dumps(outcomes))
        if args.page:
            page = Path(args.page)
            sheets = write_sheets([o for o in outcomes if o["set"] in ("committed", "fresh")], page.parent / "failures")
            write_page(page, outcomes, recorded(sys.argv[1:]), sheets)


def recorded(options: list[str]) -> str:
    """The command for the page, without where things lie on this machine."""
    local = ("--raw", "--page", "--bench")
    kept = [o for i, o in enumerate(options) if o not in local and (i == 0 or options[i - 1] not in local)]
    return shlex.join(["python", "scripts/evaluate.py", *kept])


def _arguments() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--sets", nargs="+", choices=SETS, default=SETS)
    parser.add_argument("--categories", nargs="+", default=["*"], metavar="PATTERN")
    parser.add_argument("--seed", type=int, default=7, help="of the fresh drawings")
    parser.add_argument("--per-category", type=int, default=4, metavar="N", help="fresh drawings of each category")
    parser.add_argument("--bench", type=Path, default=ROOT.parent / "shared" / "bench")
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--seconds", type=float, default=30, help="after which a picture is given up")
    parser.add_argument("--page", default=str(ROOT / "docs" / "results.md"), help="'' writes none")
    parser.add_argument("--raw", help="write every outcome as JSON")
    return parser.parse_args()


def collect(name: str, args: argparse.Namespace, scratch: Path) -> list[Case]:
    """The drawings of a set: path of the picture, truth, name of the set."""
    if name == "fresh":
        folder = scratch / "fresh"
        for category in RECIPES:
            if any(fnmatch.fnmatch(category, p) for p in args.categories):
                for index in range(args.per_category):
                    draw(category, args.seed, index).save(folder)
    else:
        places = {
            "committed": ROOT / "data" / "synthetic",
            "bench": args.bench / "drawings",
            "real": args.bench / "real",
        }
        folder = places[name]
    found = []
    for file in sorted(folder.glob("*/*.json")):
        if any(fnmatch.fnmatch(file.parent.name, p) for p in args.categories):
            truth = json.loads(file.read_text())
            truth.setdefault("category", file.parent.name)
            picture = next(p for p in sorted(file.parent.glob(f"{file.stem}.*")) if p.suffix != ".json")
            with Image.open(picture) as opened:
                truth |= dict(zip(("width", "height"), opened.size, strict=True))
            found.append(
                {"set": name, "picture": str(picture), "id": f"{file.parent.name}/{file.stem}", "truth": truth}
            )
    return found


def run(cases: list[Case], jobs: int, seconds: float) -> list[Case]:
    """Outcome of each case, in order; a crash or a hang costs its own case only."""
    from pebble import ProcessPool

    outcomes = []
    # Not forked from this process, whose pool threads may hold a lock at that moment.
    context = multiprocessing.get_context("forkserver")
    with ProcessPool(max_workers=jobs, initializer=_warm_up, context=context) as pool:
        results = pool.map(measure, cases, timeout=seconds, chunksize=1).result()
        for number, case in enumerate(cases):
            try:
                outcomes.append(next(results))
            except Exception as error:  # whatever ended the worker is this case's outcome
                outcomes.append(_lost(case, error, seconds))
            if sys.stderr.isatty():
                print(f"\r{number + 1} of {len(cases)}", end="", file=sys.stderr)
    return outcomes


def _lost(case: Case, error: Exception, seconds: float) -> Case:
    found = {"status": "lost", "message": f"{type(error).__name__}: {error}", "answers": [], "ms": seconds * 1e3}
    return case | found | scored(case["truth"], found)


def _warm_up() -> None:
    """Imports and first calls are not part of a drawing's time in a warm process."""
    import cv2

    cv2.setNumThreads(1)
    first = next(iter(sorted((ROOT / "data" / "synthetic" / "clean_wire_oblique").glob("*.png"))), None)
    if first:
        measure(
            {"set": "", "picture": str(first), "id": "", "truth": json.loads(first.with_suffix(".json").read_text())}
        )


def measure(case: Case) -> Case:
    """Run the tool on one picture and score what it says."""
    from sketch2shape.conversion.report import report
    from sketch2shape.errors import Sketch2ShapeError
    from sketch2shape.pipeline import reconstruct

    start = time.perf_counter()
    found: Case = {"status": "ok", "message": "", "answers": []}
    result = None
    try:
        result = reconstruct(case["picture"])
    except Sketch2ShapeError as error:
        found |= {"status": "refused", "message": f"{type(error).__name__}: {error.message}"}
    except Exception as error:  # a bug is an outcome to be counted, not the end of the evaluation
        found |= {"status": "crashed", "message": f"{type(error).__name__}: {error}"}
    found["ms"] = (time.perf_counter() - start) * 1e3
    if result is not None:
        objects = report(result)["objects"]
        found["answers"] = [o | {"mesh_ok": mesh_ok(s)} for o, s in zip(objects, result.solids, strict=True)]
    return case | found | scored(case["truth"], found)


def mesh_ok(solid: Any) -> bool:
    """Watertight, outward, of the right genus, with exactly the object's vertices."""
    from sketch2shape.export import to_trimesh

    mesh = to_trimesh([solid])
    through = len(solid.ring_sizes) - 1
    tight = mesh.is_watertight and mesh.is_winding_consistent and mesh.volume > 0
    return bool(tight and len(mesh.vertices) == len(solid.vertices) and mesh.euler_number == 2 - 2 * through)


def scored(truth: Case, found: Case) -> Case:
    """Exactness, its cause, and the solid's error."""
    answers = found["answers"]
    verdict = metrics.judge(truth, answers)
    cause = verdict.cause
    if found["status"] != "ok" and not (verdict.exact and found["status"] == "refused"):
        cause = found["message"]
    error = float("nan")
    if verdict.exact and verdict.match is not None:
        error = metrics.solid_error(truth, answers[0], verdict.match)
    exact = verdict.exact and found["status"] in ("ok", "refused")
    return {
        "exact": exact,
        "cause": cause,
        "vertex_error": verdict.error,
        "mesh": exact and all(a["mesh_ok"] for a in answers),
        "solid_error": error,
        "solid": exact and not error > metrics.solid_limit(truth if "f1" in truth else {"projection": "mixed"}),
        "confidence": max((a["confidence"] for a in answers), default=float("nan")),
        **(overlap(truth, answers[0], verdict.match) if verdict.match is not None else {}),
    }


def overlap(truth: Case, answer: Case, match: Any) -> Case:
    """Intersection over union and Chamfer distance (part of the diagonal) of the solids, after alignment.

    Where the drawing fixes the depth and the faces have no holes; {} elsewhere.
    """
    import numpy as np
    import trimesh
    from scipy.spatial import cKDTree

    from sketch2shape.export import to_trimesh
    from sketch2shape.model import Projection, Solid, two_face_boundary

    want = metrics.true_solid(truth)
    if want is None or truth.get("holes") or metrics.family(truth) == "oblique":
        return {}
    got = metrics.aligned(metrics.outer_vertices(truth, answer, match), want)
    sizes, projection = (len(truth["f1"]),), Projection("axonometric")
    meshes = [to_trimesh([Solid(two_face_boundary(v, sizes), projection)]) for v in (want, got)]
    common = trimesh.boolean.intersection(meshes, engine="manifold").volume
    clouds = [trimesh.sample.sample_surface(m, 2000, seed=0)[0] for m in meshes]
    apart = [cKDTree(a).query(b)[0].mean() for a, b in (clouds, clouds[::-1])]
    union = sum(m.volume for m in meshes) - common
    return {"iou": float(common / union), "chamfer": float(np.mean(apart) / np.linalg.norm(np.ptp(want, axis=0)))}


if __name__ == "__main__":
    main()
