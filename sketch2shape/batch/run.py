"""A whole batch from the options to the exit code."""

from __future__ import annotations

import contextlib
import os
import signal
import sys
import threading
import time
from argparse import Namespace
from collections.abc import Callable, Generator, Iterator
from dataclasses import replace

from sketch2shape.batch.extras import check_extras, keep_files, write_extras
from sketch2shape.batch.manifest import Manifest, Past, load_past, options_hash
from sketch2shape.batch.plan import Plan, common_folder, make_plan, settle
from sketch2shape.batch.pool import run_tasks
from sketch2shape.batch.progress import Progress, follow
from sketch2shape.batch.table import show_summary, summary
from sketch2shape.conversion.convert import Outcome, Settings, Task
from sketch2shape.conversion.options import products_of
from sketch2shape.corrections import check_pictures
from sketch2shape.errors import InterruptedRunError, UsageError
from sketch2shape.pipeline.products import PICTURES, product_of
from sketch2shape.writing import FolderLock, make_folder, sweep, tell, write_stdout

Work = Callable[[Task], Outcome]

_TIMEOUT = 120.0
_MEMORY = 4 * 2**30
#: exit code of a batch in which some inputs failed
_SOME_FAILED = 3


def run_batch(arguments: Namespace, settings: Settings, work: Work) -> int:
    """Plan, work, tell. Returns 0, 3 if some inputs failed, 130 if it was interrupted.

    Raises UsageError, UnreadableError and WriteError before any work starts.
    """
    out, products = _out(arguments), products_of(arguments)
    options = options_hash(settings, products)
    past = load_past(out or common_folder(arguments.inputs))
    plan = _plan(arguments, out, products, past, options)
    keep_files(arguments, plan.items)
    if settings.corrections:
        note = check_pictures(settings.corrections, arguments.vertices, [item.name for item in plan.items])
        if note and not arguments.quiet:
            tell(f"sketch2shape: {note}")
    if arguments.dry_run:
        lines = (f"{item.path}\t{output.path}\n" for item in plan.items for output in item.outputs)
        write_stdout(b"".join(map(os.fsencode, lines)))
        return 0
    make_folder(plan.root)
    with FolderLock(plan.root):
        batch = _Batch(plan, arguments, settings, work)
        if arguments.resume:
            batch.take_over(past)
        return batch.run(Manifest(plan, options))


def _out(arguments: Namespace) -> str | None:
    """The one output folder. Raises UsageError."""
    if "-" in arguments.inputs or "-" in arguments.output:
        raise UsageError("standard input and output are for a single picture", remedy="-o FOLDER")
    if len(arguments.output) > 1:
        raise UsageError("several inputs take one -o", remedy="-o FOLDER, and --format for several formats")
    check_extras(arguments)
    if any(getattr(arguments, kind) for kind in PICTURES):
        raise UsageError(
            "a picture's file is for a single input", remedy="--format obj,overlay and so on, or --index FILE"
        )
    if not arguments.output:
        return None
    out = str(arguments.output[0])
    if not os.path.isdir(out) and (os.path.lexists(out) or _is_product(out)):
        why = "--resume keeps its record in one" if arguments.resume else "several inputs need one"
        raise UsageError(f"{out} is a file, not a folder: {why}", remedy="-o FOLDER")
    return out


def _is_product(name: str) -> bool:
    """Whether a name is that of a mesh, a report or a picture."""
    with contextlib.suppress(UsageError):
        return bool(product_of(name))
    return False


def _plan(arguments: Namespace, out: str | None, products: list[str], past: Past, options: str) -> Plan:
    """The plan; with --resume, inputs that were planned before keep their outputs. Raises as `run_batch`."""
    plan = make_plan(arguments.inputs, out, products, ours=past.files)
    if arguments.resume:
        past.check_options(options)
        items = tuple(replace(item, outputs=past.planned.get(item.name, item.outputs)) for item in plan.items)
        return settle(replace(plan, items=items), versioned=arguments.versioned, ours=past.files)
    return plan if arguments.overwrite else settle(plan, versioned=arguments.versioned)


class _Batch:
    """A planned batch and what has become of its inputs so far."""

    def __init__(self, plan: Plan, arguments: Namespace, settings: Settings, work: Work) -> None:
        self.plan, self.arguments, self.settings, self.work = plan, arguments, settings, work
        self.outcomes: dict[str, Outcome] = {}
        self.begin = time.monotonic()

    def take_over(self, past: Past) -> None:
        """Keep what an earlier run has done."""
        for item in self.plan.items:
            outcome = past.still_done(item)
            if outcome is not None:
                self.outcomes[item.name] = outcome

    def run(self, manifest: Manifest) -> int:
        """Do what is left to do, and tell."""
        self._sweep()
        manifest.begin()
        for outcome in self.outcomes.values():
            manifest.add(outcome)
        left = [item for item in self.plan.items if item.name not in self.outcomes]
        interrupted = False
        with follow(len(left), quiet=self.arguments.quiet) as progress:
            self._announce(progress)
            try:
                with _terminate_as_interrupt():
                    self._work_off(manifest, progress)
            except KeyboardInterrupt:
                interrupted = True
            finally:
                manifest.close()
        self._sweep()
        if len(self.outcomes) == len(self.plan.items):
            manifest.finish()
        self._tell()
        if interrupted:
            tell("sketch2shape: interrupted. Try: --resume")
            return InterruptedRunError.exit_code
        return _SOME_FAILED if any(o.exit_code for o in self._all()) else 0

    def _announce(self, progress: Progress) -> None:
        if self.arguments.quiet:
            return
        if self.outcomes:
            progress.say(f"{len(self.outcomes)} of {len(self.plan.items)} are done already")
        if self.plan.renamed:
            progress.say(f"{self.plan.renamed} inputs share their stem; their outputs carry the full name")

    def _work_off(self, manifest: Manifest, progress: Progress) -> None:
        with contextlib.closing(self._start(progress)) as run:
            for task, outcome in run:
                self.outcomes[outcome.name] = outcome
                manifest.add(outcome)
                progress.advance(task, outcome)
                if outcome.exit_code and self.arguments.fail_fast:
                    return

    def _start(self, progress: Progress) -> Generator[tuple[Task, Outcome], None, None]:
        """Begin to work, on this machine or on a cluster; paths in the outcomes are those of the plan."""
        timeout = self.arguments.timeout or _TIMEOUT
        if self.arguments.scheduler:
            from sketch2shape.batch.cluster import run_on_cluster

            return run_on_cluster(self._tasks(), self.work, scheduler=self.arguments.scheduler, timeout=timeout)
        memory = self.arguments.max_memory or _MEMORY
        jobs = self.arguments.jobs

        def notice(text: str) -> None:
            progress.say(f"sketch2shape: {text}")

        return run_tasks(self._tasks(), self.work, jobs=jobs, timeout=timeout, max_memory=memory, notice=notice)

    def _tasks(self) -> Iterator[Task]:
        replace_files = self.arguments.overwrite or self.arguments.resume
        for item in self.plan.items:
            if item.name not in self.outcomes:
                yield Task(item.path, item.name, item.outputs, replace_files, self.settings)

    def _sweep(self) -> None:
        """Remove temporary files that killed workers left in the output folders."""
        for folder in {os.path.dirname(o.path) for item in self.plan.items for o in item.outputs} | {self.plan.root}:
            sweep(folder or ".")

    def _all(self) -> list[Outcome]:
        """An outcome for each input, in the order of the plan."""
        missing = InterruptedRunError("not started")
        return [
            self.outcomes.get(item.name)
            or Outcome(item.name, InterruptedRunError.exit_code, missing.message, missing.advice)
            for item in self.plan.items
        ]

    def _tell(self) -> None:
        """Write the table and show the summary. Raises WriteError."""
        write_extras(self.arguments, zip(self.plan.items, self._all(), strict=True))
        if not self.arguments.quiet and sys.stderr is not None:
            with contextlib.suppress(OSError, ValueError):
                show_summary(summary(self._all(), time.monotonic() - self.begin), sys.stderr)


@contextlib.contextmanager
def _terminate_as_interrupt() -> Iterator[None]:
    """Let SIGTERM, and SIGHUP of a terminal that is closed, stop the batch as cleanly as Ctrl-C does."""
    if threading.current_thread() is not threading.main_thread():
        yield
        return
    known = [getattr(signal, name) for name in ("SIGTERM", "SIGHUP") if hasattr(signal, name)]
    before = {number: signal.getsignal(number) for number in known}
    for number, handler in before.items():
        if handler is not signal.SIG_IGN:  # nohup
            signal.signal(number, signal.default_int_handler)
    try:
        yield
    finally:
        for number, handler in before.items():
            signal.signal(number, handler)
