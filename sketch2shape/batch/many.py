"""Many pictures from Python: one result for each, whatever happens to it."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace
from functools import partial
from os import PathLike
from typing import Any

import numpy as np

from sketch2shape.batch.pool import run_each
from sketch2shape.conversion.convert import as_known
from sketch2shape.errors import NoObjectError, Sketch2ShapeError, UsageError
from sketch2shape.model import Picture, checked_count, checked_number
from sketch2shape.pipeline import Result, reconstruct
from sketch2shape.pipeline.options import limits_of, refuse_unknown
from sketch2shape.reading.limits import Limits
from sketch2shape.reading.read import source_name


def reconstruct_many(
    sources: Iterable[Any],
    *,
    jobs: int | None = None,
    timeout: float | None = 120.0,
    max_memory: int | None = 4 * 2**30,
    limits: Limits | None = None,
    **options: Any,
) -> Iterator[Result]:
    """Reconstruct pictures in worker processes; yield one result for each source, in their order.

    sources    : paths, bytes or arrays, in any iterable; it is read no further than a few items ahead
    jobs       : number of workers; None: one for each core
    timeout    : seconds of computing for one picture, or five times as many by the clock
    max_memory : bytes for one picture on top of the program itself
    options    : as for `reconstruct`

    A source that fails gives a result without objects whose `error` says why; nothing is raised for it. Options that
    make no sense raise UsageError at once. The pictures in the results are white and of the right size: the pixels stay
    in the workers.
    """
    if isinstance(sources, str | bytes | PathLike) or not isinstance(sources, Iterable):
        raise UsageError(
            f"sources is {type(sources).__name__}, not several pictures", remedy="[source], or reconstruct"
        )
    refuse_unknown(reconstruct, options)
    jobs = None if jobs is None else checked_count("jobs", jobs)
    timeout = None if timeout is None else checked_number("timeout", timeout, 1e-3)
    max_memory = None if max_memory is None else checked_count("max_memory", max_memory)
    return _results(enumerate(sources), jobs, timeout, max_memory, limits_of(limits), options)


def _results(
    numbered: Iterable[tuple[int, Any]],
    jobs: int | None,
    timeout: float | None,
    max_memory: int | None,
    limits: Limits,
    options: dict[str, Any],
) -> Iterator[Result]:
    work = partial(_reconstruct, limits=limits, options=options)
    waiting: dict[int, Result] = {}
    turn = 0
    for (number, source), answer in run_each(numbered, work, jobs=jobs, timeout=timeout, max_memory=max_memory):
        waiting[number] = _as_result(answer, source)
        while turn in waiting:
            yield waiting.pop(turn)
            turn += 1


@dataclass(frozen=True)
class _Answer:
    """A result on its way out of a worker: without pixels, of which only the size (width, height) travels."""

    result: Result
    size: tuple[int, int]


def _reconstruct(numbered: tuple[int, Any], limits: Limits, options: dict[str, Any]) -> _Answer | Sketch2ShapeError:
    """Run in the worker."""
    from sketch2shape.pipeline import reconstruct

    try:
        result = reconstruct(numbered[1], limits=limits, **options)
    except NoObjectError as error:
        error.guess = None  # whose picture would travel with it
        return error
    except Exception as error:
        return as_known(error)
    width, height = result.picture.size
    return _Answer(replace(result, picture=_white(result.picture.source, 0, 0)), (width, height))


def _as_result(answer: _Answer | Sketch2ShapeError, source: Any) -> Result:
    if isinstance(answer, Sketch2ShapeError):
        return Result((), (), _white(source_name(source), 0, 0), error=answer)
    return replace(answer.result, picture=_white(answer.result.picture.source, *answer.size))


def _white(name: str, width: int, height: int) -> Picture:
    """A white picture that takes no memory."""
    return Picture(np.broadcast_to(np.uint8(255), (height, width, 3)), name)
