"""Run the tool on the cases, in processes of their own, and judge what it says."""

from __future__ import annotations

import multiprocessing
import sys
import time
from collections.abc import Callable, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any, TypeVar

from evaluation import curves, metrics
from evaluation.cases import ROOT, Case, case_of
from evaluation.outcome import NAN, Outcome

Reconstruct = Callable[[str], Any]
Answer = TypeVar("Answer")


def run(cases: Sequence[Case], jobs: int, seconds: float) -> list[Outcome]:
    """Outcome of each case, in order; a crash or a hang costs its own case only.

    seconds : after which a case is given up
    """
    answers = in_processes(measure, [(case,) for case in cases], jobs, seconds)
    return [lost(c, a, seconds) if isinstance(a, Exception) else a for c, a in zip(cases, answers, strict=True)]


def in_processes(
    work: Callable[..., Answer], calls: Sequence[tuple[Any, ...]], jobs: int, seconds: float
) -> list[Answer | Exception]:
    """What `work` returns for each tuple of arguments, in order, or the error that ended its worker."""
    from pebble import ProcessPool

    out: list[Answer | Exception] = []
    # Not forked from this process, whose pool threads may hold a lock at that moment.
    context = multiprocessing.get_context("forkserver")
    with ProcessPool(max_workers=jobs, initializer=_warm_up, context=context) as pool:
        results = pool.map(_called, [(work, call) for call in calls], timeout=seconds, chunksize=1).result()
        for number in range(len(calls)):
            try:
                out.append(next(results))
            except Exception as error:  # whatever ended the worker is this call's answer
                out.append(error)
            if sys.stderr.isatty():
                print(f"\r{number + 1} of {len(calls)}", end="", file=sys.stderr)
    return out


def _called(call: tuple[Callable[..., Answer], tuple[Any, ...]]) -> Answer:
    return call[0](*call[1])


def lost(case: Case, error: Exception, seconds: float) -> Outcome:
    """The outcome of a case whose worker ended or was ended."""
    message = f"{type(error).__name__}: {error}"
    return Outcome(case, "lost", message, ms=seconds * 1e3, cause=message)


def _warm_up() -> None:
    """Imports and first calls are not part of a drawing's time in a warm process."""
    import cv2

    cv2.setNumThreads(1)
    for picture in sorted((ROOT / "data" / "synthetic" / "clean_wire_oblique").glob("*.png"))[:1]:
        measure(case_of(picture))


def measure(case: Case, reconstruct: Reconstruct | None = None) -> Outcome:
    """Run the tool (or `reconstruct` in its place) on one picture and judge what it says."""
    import sketch2shape as s2s
    from sketch2shape.pipeline.report import report

    ask = reconstruct or s2s.reconstruct
    start = time.perf_counter()
    try:
        result = ask(case.picture)
    except s2s.Sketch2ShapeError as error:
        outcome = Outcome(case, "refused", f"{type(error).__name__}: {error.message}")
        return judged(_timed(outcome, start), [])
    except Exception as error:  # a bug is an outcome to be counted, not the end of the evaluation
        message = f"{type(error).__name__}: {error}"
        return _timed(Outcome(case, "crashed", message, cause=message), start)
    outcome = _timed(Outcome(case), start)
    return judged(replace(outcome, answers=tuple(report(result)["objects"])), list(result.solids))


def _timed(outcome: Outcome, start: float) -> Outcome:
    return replace(outcome, ms=(time.perf_counter() - start) * 1e3)


def judged(outcome: Outcome, solids: list[Any]) -> Outcome:
    """The outcome with its answers judged against the truth, by the kind of truth there is."""
    truth = outcome.case.truth
    if "mesh" in truth:
        return _by_mesh(outcome, solids)
    if curves.has_curves(truth):
        return _by_curves(outcome, solids)
    if truth.get("objects", ()) is None:
        refused = not outcome.answered
        return replace(outcome, right=refused or None, mesh=refused, solid=refused)
    return _by_rings(outcome, solids)


def _by_rings(outcome: Outcome, solids: list[Any]) -> Outcome:
    from evaluation import meshes
    from sketch2shape.export import to_trimesh

    truth, answers = outcome.case.truth, outcome.answers
    verdict = metrics.judge(truth, answers)
    if not verdict.exact:
        return replace(outcome, right=False, cause=outcome.message or verdict.cause)
    if any(answer.get("arcs") for answer in answers):
        return replace(outcome, right=False, cause="arcs between the right vertices")
    bodies = [to_trimesh([s]) for s in solids]
    sound = all(
        meshes.is_sound(body, len(solid.vertices), len(answer["holes"]))
        for body, solid, answer in zip(bodies, solids, answers, strict=True)
    )
    error, iou, chamfer, limit = NAN, NAN, NAN, NAN
    if verdict.match is not None:
        limit = metrics.solid_limit(truth)
        error = metrics.solid_error(truth, answers[0], verdict.match)
        iou, chamfer = meshes.overlap(truth, answers[0], bodies[0].faces, verdict.match)
    return replace(
        outcome,
        right=True,
        vertex_error=verdict.error,
        mesh=sound,
        solid_error=error,
        solid=not error > limit,
        iou=iou,
        chamfer=chamfer,
    )


def _by_curves(outcome: Outcome, solids: list[Any]) -> Outcome:
    """The mesh of a curved solid has as many vertices as its tolerance asks for; its proportions are not measured."""
    from sketch2shape.export import to_trimesh

    verdict = curves.judge(outcome.case.truth, outcome.answers)
    if not verdict.exact:
        return replace(outcome, right=False, cause=outcome.message or verdict.cause)
    body = to_trimesh(solids)
    through = len(outcome.case.truth["holes"])
    tight = body.is_watertight and body.is_winding_consistent and body.volume > 0
    sound = bool(tight and body.euler_number == 2 - 2 * through)
    return replace(outcome, right=True, vertex_error=verdict.error, mesh=sound, solid=sound)


def _by_mesh(outcome: Outcome, solids: list[Any]) -> Outcome:
    from evaluation import meshes
    from sketch2shape.export import to_trimesh

    if len(solids) != 1:
        return replace(outcome, right=False, cause=outcome.message or f"{len(solids)} objects reported")
    camera = outcome.answers[0]["solid"].get("camera")
    mesh = meshes.in_picture(to_trimesh(solids), camera)
    truth = meshes.true_mesh(Path(outcome.case.truth["mesh"]), Path(outcome.case.picture))
    cause = meshes.difference(mesh, truth)
    return replace(outcome, right=not cause, cause=cause, mesh=not cause, solid=not cause)
