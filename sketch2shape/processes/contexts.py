"""Contexts of multiprocessing whose workers leave this process as it is.

Strategy. Workers come from a fork server, which has no threads that could hold a lock, or are spawned where there is
none or it cannot be started. The fork server is one of our own, so that what it loads is nobody else's business. Both
ways of starting a worker would import the user's main script there, and a script without a `__name__` guard would then
start workers of workers; so the workers are not told of it. multiprocessing offers no argument for either, and what it
reads is global to the process: its launching functions are therefore copied, with two of the names they use replaced.
"""

from __future__ import annotations

import multiprocessing
import os
import sys
from collections.abc import Callable, Iterator, Sequence
from importlib import import_module
from multiprocessing import spawn
from types import FunctionType, SimpleNamespace
from typing import Any

from sketch2shape.processes.threads import compute_in_one_thread

#: seconds a first worker may take to start: an interpreter, and what the fork server loads, on a busy machine
_PATIENCE = 120.0
#: descriptors that a pool takes: its two pipes, the fork server, what is open for a moment as a worker starts ...
_DESCRIPTORS = 20
#: ... and those of each worker
_DESCRIPTORS_EACH = 4
#: functions of multiprocessing that the copies are made for
_REPLACED = frozenset({"get_preparation_data", "connect_to_new_process", "read_signed"})


class NoWorkersError(Exception):
    """No worker process can be started; the message says why."""


def working_context(preload: Sequence[str], workers: int) -> Any:
    """A context that has been seen to start a worker.

    preload : modules that the fork server loads once for all workers
    workers : how many are meant to be started

    Raises NoWorkersError.
    """
    if getattr(sys, "frozen", False):
        raise NoWorkersError("a frozen application would start itself again")
    _check_descriptors(_DESCRIPTORS + _DESCRIPTORS_EACH * workers)
    key = os.getpid()  # a forked child has the memory of its parent, but not its fork server
    if key not in _WORKING:
        reasons = []
        for context in _contexts(preload):
            reason = _why_not(context)
            if reason is None:
                _WORKING[key] = context
                break
            reasons.append(reason)
        else:
            raise NoWorkersError(" and ".join(dict.fromkeys(reasons)) or "this system has no processes")
    return _WORKING[key]


#: number of this process -> the context that works in it
_WORKING: dict[int, Any] = {}


def _check_descriptors(count: int) -> None:
    """Raise NoWorkersError if fewer files than this can be opened: a pool that runs out of them breaks in silence."""
    taken: list[int] = []
    try:
        taken.extend(os.dup(taken[0]) if taken else os.open(os.devnull, os.O_RDONLY) for _ in range(count))
    except OSError as error:
        raise NoWorkersError(error.strerror or str(error)) from None
    finally:
        for number in taken:
            os.close(number)


def _contexts(preload: Sequence[str]) -> Iterator[Any]:
    """All there are, the best first."""
    methods = multiprocessing.get_all_start_methods()
    if "forkserver" in methods:
        yield _fork_server_context(preload)
    if "spawn" in methods:
        yield _SpawnContext()


def _why_not(context: Any) -> str | None:
    """Why no worker can be started, None if one was."""
    try:
        context.RLock()
        first = context.Process(target=int)
        first.start()
        first.join(_PATIENCE)
    except Exception as error:  # whatever the system objects to; a daemonic process is an AssertionError
        return str(error) or type(error).__name__
    if first.exitcode is None:
        first.kill()
        return f"a worker did not start within {_PATIENCE:g} s"
    return None if first.exitcode == 0 else f"a worker ended with {first.exitcode} as it started"


def _preparation(name: str) -> dict[str, Any]:
    """What a new worker is told of this process: everything but the main script."""
    data = spawn.get_preparation_data(name)
    return {key: value for key, value in data.items() if not key.startswith("init_main_from")}


def _launcher(module: str, **names: Any) -> Any:
    """The class that starts a process, its functions seeing `names` in place of those of their module."""
    base = import_module(f"multiprocessing.{module}").Popen
    spawn_names = {**vars(spawn), "get_preparation_data": _preparation}
    names = {"spawn": SimpleNamespace(**spawn_names), **names}
    changed = {
        name: FunctionType(f.__code__, {**f.__globals__, **names}, f.__name__, f.__defaults__, f.__closure__)
        for name, f in vars(base).items()
        if isinstance(f, FunctionType) and _REPLACED & set(f.__code__.co_names)
    }
    return type(base.__name__, (base,), changed)


def _in_worker(kind: type[Any]) -> Any:
    """The process object, in the worker: made before anything that it carries, and all that this loads, is."""
    compute_in_one_thread(whatever_was_asked=True)
    return object.__new__(kind)


class _SpawnProcess(multiprocessing.get_context("spawn").Process):  # type: ignore[misc]
    """A worker that is spawned."""

    def __reduce__(self) -> tuple[Callable[..., Any], tuple[Any, ...], dict[str, Any]]:
        return _in_worker, (type(self),), self.__dict__

    @staticmethod
    def _Popen(process: Any) -> Any:  # noqa: N802  (the name multiprocessing gives it)
        return _launcher("popen_spawn_win32" if sys.platform == "win32" else "popen_spawn_posix")(process)


class _SpawnContext(type(multiprocessing.get_context("spawn"))):  # type: ignore[misc]
    Process = _SpawnProcess


def _fork_server_context(preload: Sequence[str]) -> Any:
    """A context with a fork server of its own."""
    from multiprocessing import forkserver

    server = forkserver.ForkServer()
    server.set_forkserver_preload(["sketch2shape.processes.one_thread", *preload])
    own = SimpleNamespace(**{**vars(forkserver), "connect_to_new_process": server.connect_to_new_process})
    launcher = _launcher("popen_forkserver", forkserver=own)

    class Process(_ForkedProcess):
        @staticmethod
        def _Popen(process: Any) -> Any:  # noqa: N802  (the name multiprocessing gives it)
            return launcher(process)

    class Context(type(multiprocessing.get_context("forkserver"))):  # type: ignore[misc]
        pass

    context = Context()
    context.Process = Process
    return context


def _forked_base() -> Any:
    known = "forkserver" in multiprocessing.get_all_start_methods()
    return multiprocessing.get_context("forkserver" if known else "spawn").Process  # type: ignore[attr-defined]


class _ForkedProcess(_forked_base()):  # type: ignore[misc]
    """A worker that a fork server starts."""

    def __reduce__(self) -> tuple[Callable[..., Any], tuple[Any, ...], dict[str, Any]]:
        return _in_worker, (_ForkedProcess,), self.__dict__
