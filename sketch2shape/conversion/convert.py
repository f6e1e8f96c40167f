"""One input from start to end: read, reconstruct, encode, write; what happened comes back as a small record."""

from __future__ import annotations

import hashlib
import time
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import Any, Literal

from sketch2shape.conversion.summary import Measures, describe, least_confidence, measures_of
from sketch2shape.corrections import parse_corrections
from sketch2shape.errors import CrashError, LimitError, NoObjectError, Sketch2ShapeError, WriteError
from sketch2shape.model import Answer, Picture
from sketch2shape.pipeline.products import encode_product, infixed
from sketch2shape.pipeline.report import encode_report, report
from sketch2shape.reading.limits import Limits
from sketch2shape.reading.read import count_pages, read_bytes, read_picture
from sketch2shape.writing import quiet_stderr, write_file, write_stdout


@dataclass(frozen=True, slots=True)
class Output:
    """A file to write: the product (a mesh format, "json", ...) and its path, "-" for standard output."""

    product: str
    path: str


@dataclass(frozen=True)
class Settings:
    """What holds for all inputs of a run.

    page    : page of a TIFF or PDF, from 0; None for all
    stages  : keyword arguments of `reconstruct`
    corrections : text of the corrections file, "" for none
    mesh    : keyword arguments of `encode`
    timings : whether the reports tell the time of each stage (they then differ from run to run)
    """

    limits: Limits = field(default_factory=Limits)
    page: int | None = 0
    stages: Mapping[str, Any] = field(default_factory=dict)
    corrections: str = ""
    mesh: Mapping[str, Any] = field(default_factory=dict)
    timings: bool = False


@dataclass(frozen=True)
class Task:
    """One input and the files to make of it.

    source    : path to read
    name      : what reports and messages call it
    outputs   : what to write
    overwrite : whether a file that is there may be replaced
    data      : the encoded picture, where it does not come from a path
    """

    source: str
    name: str
    outputs: tuple[Output, ...]
    overwrite: bool = False
    settings: Settings = field(default_factory=Settings)
    data: bytes | None = None


@dataclass(frozen=True, slots=True)
class Outcome:
    """What became of one input.

    exit_code  : 0, or that of the error
    message    : what went wrong, and `remedy` what to try
    objects    : how many objects were found; `confidence` is the least of theirs
    found      : what they are, how large, and what was assumed, in a line of words
    measures   : sizes, surface and volume of each
    digest     : sha256 of the input's bytes, "" if it could not be read
    written    : path -> sha256 of the bytes written there
    seconds    : time taken
    """

    name: str
    exit_code: int = 0
    message: str | None = None
    remedy: str | None = None
    objects: int = 0
    confidence: float | None = None
    digest: str = ""
    written: Mapping[str, str] = field(default_factory=dict)
    seconds: float = 0.0
    found: str = ""
    measures: tuple[Measures, ...] = ()

    @property
    def status(self) -> Literal["ok", "failed"]:
        """In one word."""
        return "ok" if self.exit_code == 0 else "failed"


def failure(task: Task, error: BaseException) -> Outcome:
    """The record of an input that failed with this error; an error that is none of ours is a bug."""
    known = as_known(error)
    return Outcome(task.name, type(known).exit_code, known.message, known.advice)


def as_known(error: BaseException) -> Sketch2ShapeError:
    """The same error in our own tree: lack of memory is a limit, anything unforeseen a bug."""
    if isinstance(error, Sketch2ShapeError):
        return error
    if isinstance(error, MemoryError) or "Insufficient memory" in str(error) or "bad_alloc" in str(error):
        return LimitError("not enough memory", remedy="a smaller picture, or raise --max-memory")
    text = (str(error).splitlines() or [""])[0][:200]
    return CrashError(f"internal error ({type(error).__name__}: {text})")


def convert(task: Task) -> Outcome:
    """Do one task. Never raises an ordinary exception: the outcome tells what went wrong.

    The mesh is written before the report, so that a report that is there speaks of files that are there.
    """
    begin = time.perf_counter()
    written: dict[str, str] = {}
    digest = ""
    try:
        data = read_bytes(task.source if task.data is None else task.data, task.settings.limits)
        digest = hashlib.sha256(data).hexdigest()
        outcome = _convert_pages(task, data, written)
    except Exception as error:
        outcome = report_failure(task, error, written=written)
    return replace(outcome, digest=digest, written=written, seconds=time.perf_counter() - begin)


def _convert_pages(task: Task, data: bytes, written: dict[str, str]) -> Outcome:
    """Convert the page asked for, or all of them: then the input is done if one page holds an object."""
    if task.settings.page is not None:
        return _convert_page(task, data, task.settings.page, written)
    with quiet_stderr():
        pages = count_pages(data)
    outcomes = [_convert_page(_for_page(task, p), data, p, written) for p in range(pages)]
    good = [o for o in outcomes if o.exit_code == 0]
    if not good:
        return outcomes[0]
    confidence = min(o.confidence for o in good if o.confidence is not None)
    found = "; ".join(f"page {p + 1}: {o.found}" for p, o in enumerate(outcomes) if o.exit_code == 0)
    return replace(
        good[0],
        name=task.name,
        objects=sum(o.objects for o in good),
        confidence=confidence,
        found=found,
        measures=tuple(measures for o in good for measures in o.measures),
    )


def _for_page(task: Task, page: int) -> Task:
    """The task for a page of many: NAME.obj for the first, NAME.p2.obj and so on for the others."""
    if page == 0:
        return task
    outputs = tuple(replace(o, path=infixed(o.path, o.product, f".p{page + 1}")) for o in task.outputs)
    return replace(task, outputs=outputs, name=f"{task.name} (page {page + 1})")


def _convert_page(task: Task, data: bytes, page: int, written: dict[str, str]) -> Outcome:
    size: tuple[int, int] | None = None
    try:
        begin = time.perf_counter()
        with quiet_stderr():
            picture = read_picture(data, task.settings.limits, page=page, name=task.name, reduced=True)
        size = picture.size
        read_ms = (time.perf_counter() - begin) * 1000
        result = _reconstruct(picture, task.settings, read_ms)
        _write_all(task, result, written)
        found = "; ".join([describe(result), *_notes(task, result)])
    except Exception as error:
        return report_failure(task, error, size=size, written=written)
    return Outcome(
        task.name,
        objects=len(result.objects),
        confidence=least_confidence(result),
        found=found,
        measures=measures_of(result),
    )


def _notes(task: Task, result: Answer) -> list[str]:
    """What had to be assumed to write the outputs."""
    from sketch2shape.export import note_of

    options = {name: value for name, value in task.settings.mesh.items() if name in ("paper", "angle")}
    notes = (note_of(result, output.product, **options) for output in task.outputs)
    return list(dict.fromkeys(note for note in notes if note))


def _reconstruct(picture: Picture, settings: Settings, read_ms: float) -> Answer:
    from sketch2shape.pipeline import reconstruct

    given = parse_corrections(settings.corrections, picture.source) if settings.corrections else None
    result = reconstruct(picture, limits=settings.limits, corrections=given, **settings.stages)
    return replace(result, timings_ms={**result.timings_ms, "read": read_ms})


def _write_all(task: Task, result: Answer, written: dict[str, str]) -> None:
    """Encode everything, then write it, the report last: a failure to encode leaves no file."""
    ordered = sorted(task.outputs, key=lambda o: o.product == "json")
    timings = result.timings_ms if task.settings.timings else {}
    encoded = []
    for output in ordered:
        if output.product == "json":
            data = encode_report(report(result, source=task.name, timings_ms=timings))
        else:
            data = encode_product(output.product, result, dict(task.settings.mesh))
        encoded.append((output, data))
    for output, data in encoded:
        _write(output, data, task.overwrite, written)


def report_failure(
    task: Task,
    error: BaseException,
    *,
    size: tuple[int, int] | None = None,
    written: dict[str, str] | None = None,
) -> Outcome:
    """The outcome of a task that failed; writes what is asked for and can be: its report, and an overlay of a guess.

    size    : (width, height) of the picture, if it could be read
    written : receives path -> sha256 of the report
    """
    outcome = failure(task, error)
    done: dict[str, str] = {} if written is None else written
    try:
        for output in () if isinstance(error, WriteError) else task.outputs:
            if output.product == "json":
                data = encode_report(report(as_known(error), source=task.name, size=size))
                _write(output, data, task.overwrite, done)
            elif output.product == "overlay" and isinstance(error, NoObjectError) and error.guess is not None:
                _write(output, encode_product("overlay", error.guess, {}), task.overwrite, done)
    except WriteError as second:
        return replace(outcome, message=f"{outcome.message}; {second.message}")
    return replace(outcome, written=done)


def _write(output: Output, data: bytes, overwrite: bool, written: dict[str, str]) -> None:
    if output.path == "-":
        write_stdout(data)
        return
    write_file(output.path, data, overwrite=overwrite)
    written[output.path] = hashlib.sha256(data).hexdigest()
