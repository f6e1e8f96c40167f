"""What a worker process does before its first task: limit itself, and tie its life to that of the parent."""

from __future__ import annotations

import contextlib
import multiprocessing
import os
import signal
import sys
import threading
import warnings
from collections.abc import Iterator

#: modules that the fork server imports once for all workers: what one picture or another needs, also inside functions
PRELOAD = (
    *("numpy", "numpy.ma", "cv2", "PIL.PngImagePlugin", "PIL.JpegImagePlugin", "shapely"),
    *(
        "sketch2shape.conversion.convert",
        "sketch2shape.pipeline.reconstruction",
        "sketch2shape.reading.pen_strokes",
        "sketch2shape.ink.find",
        "sketch2shape.lifting",
    ),
    *("sketch2shape.export.mesh", "sketch2shape.export.obj"),
)

_PR_SET_PDEATHSIG = 1


def prepare(max_memory: int | None) -> None:
    """Set this process up as a worker.

    max_memory : bytes that may be taken on top of what the program itself takes now
    """
    warnings.simplefilter("ignore")  # decoders warn of what is odd in a file; a worker has no one to tell
    signal.signal(signal.SIGTERM, signal.SIG_DFL)  # ended at once, also in the middle of a long computation
    die_with_parent()
    with contextlib.suppress(ImportError):
        import cv2

        cv2.setNumThreads(1)
    if max_memory is not None:
        limit_memory(max_memory)


#: whether the system can end a process by the time it has computed
HAS_TIMER = hasattr(signal, "setitimer")


@contextlib.contextmanager
def limited_time(seconds: float | None) -> Iterator[None]:
    """Have the system end this process (SIGPROF) if it computes for longer, even where Python gets no turn."""
    if seconds is None or not HAS_TIMER:
        yield
        return
    signal.signal(signal.SIGPROF, signal.SIG_DFL)
    signal.setitimer(signal.ITIMER_PROF, seconds)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_PROF, 0.0)


def die_with_parent() -> None:
    """End this process when its parent ends, however that ends."""
    if sys.platform == "linux":
        import ctypes

        ctypes.CDLL(None).prctl(_PR_SET_PDEATHSIG, signal.SIGKILL)  # the kernel does it, even if Python is busy
    elder = multiprocessing.parent_process()
    if elder is not None:
        threading.Thread(target=_watch, args=(elder,), daemon=True).start()


def _watch(elder: multiprocessing.process.BaseProcess) -> None:
    elder.join()
    os._exit(1)


def limit_memory(allowance: int) -> None:
    """Let this process take `allowance` bytes more than it has; then allocation fails (MemoryError)."""
    try:
        import resource
    except ImportError:  # Windows
        return
    limit = _address_space() + allowance
    _, hard = resource.getrlimit(resource.RLIMIT_AS)
    resource.setrlimit(resource.RLIMIT_AS, (limit if hard == resource.RLIM_INFINITY else min(limit, hard), hard))


def _address_space() -> int:
    """Bytes of address space in use; 1 GB where the system does not say."""
    try:
        with open("/proc/self/statm", "rb") as file:
            return int(file.read().split()[0]) * os.sysconf("SC_PAGE_SIZE")
    except (OSError, ValueError, AttributeError):
        return 2**30
