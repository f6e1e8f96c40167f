"""Writing: whole or not at all, never over another file."""

from __future__ import annotations

import errno
import io
import os
import signal
import subprocess
import sys

import pytest

from sketch2shape.errors import WriteError
from sketch2shape.writing import files as write
from sketch2shape.writing.files import FolderLock, sweep, write_file
from sketch2shape.writing.streams import write_stdout


def test_folders_are_made_and_bytes_written(tmp_path):
    write_file(tmp_path / "a" / "b" / "c.obj", b"hello")
    assert (tmp_path / "a" / "b" / "c.obj").read_bytes() == b"hello"
    assert os.listdir(tmp_path / "a" / "b") == ["c.obj"]


def test_nothing_is_overwritten_unless_asked(tmp_path):
    path = tmp_path / "a.obj"
    write_file(path, b"1")
    with pytest.raises(WriteError, match="exists already"):
        write_file(path, b"2")
    assert path.read_bytes() == b"1"
    write_file(path, b"3", overwrite=True)
    assert path.read_bytes() == b"3"
    assert os.listdir(tmp_path) == ["a.obj"]


@pytest.mark.posix
def test_a_link_that_leads_nowhere_is_not_written_through(tmp_path):
    (tmp_path / "a.obj").symlink_to("elsewhere")
    with pytest.raises(WriteError, match="exists already"):
        write_file(tmp_path / "a.obj", b"1")
    assert not (tmp_path / "elsewhere").exists()


def test_without_hard_links_nothing_is_overwritten_either(tmp_path, monkeypatch):
    def no_links(*_):
        raise PermissionError(errno.EPERM, "no links here")

    monkeypatch.setattr(os, "link", no_links)
    write_file(tmp_path / "a", b"1")
    with pytest.raises(WriteError, match="exists already"):
        write_file(tmp_path / "a", b"2")
    assert (tmp_path / "a").read_bytes() == b"1"


@pytest.mark.parametrize("step", ["fsync", "link"])
def test_a_full_disk_leaves_nothing_behind(tmp_path, monkeypatch, step):
    def full(*_):
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

    monkeypatch.setattr(os, step, full)
    if step == "link":
        monkeypatch.setattr(os, "replace", full)
    with pytest.raises(WriteError, match="No space left"):
        write_file(tmp_path / "a", b"1")
    assert os.listdir(tmp_path) == []


def test_impossible_targets(tmp_path):
    (tmp_path / "file").write_text("")
    for target in (tmp_path / "file" / "a.obj", tmp_path / ("x" * 300), "a\0b", "/proc/a.obj"):
        with pytest.raises(WriteError, match="cannot"):
            write_file(target, b"1")


@pytest.mark.posix
def test_permissions_follow_the_umask(tmp_path):
    before = os.umask(0o027)
    try:
        write_file(tmp_path / "a", b"1")
    finally:
        os.umask(before)
    assert (tmp_path / "a").stat().st_mode & 0o777 == 0o640


@pytest.mark.parametrize("mode", [0o600, 0o640, 0o666, 0o444, 0o755])
@pytest.mark.posix
def test_a_replaced_file_hands_its_permissions_on(tmp_path, mode):
    path = tmp_path / "a"
    path.write_bytes(b"old")
    path.chmod(mode)
    write_file(path, b"new", overwrite=True)
    assert (path.read_bytes(), path.stat().st_mode & 0o7777) == (b"new", mode)


@pytest.mark.posix
def test_and_its_owner_where_the_system_allows_it(tmp_path, monkeypatch):
    asked = []
    monkeypatch.setattr(os, "chown", lambda _, *who: asked.append(who))
    (tmp_path / "a").write_bytes(b"old")
    status = (tmp_path / "a").stat()
    write_file(tmp_path / "a", b"new", overwrite=True)
    assert asked == [(status.st_uid, status.st_gid)]


@pytest.mark.posix
def test_no_one_else_may_read_a_private_file_while_it_is_written(tmp_path, monkeypatch):
    (tmp_path / "a").write_bytes(b"old")
    (tmp_path / "a").chmod(0o600)
    modes = []
    monkeypatch.setattr(os, "fsync", lambda number: modes.append(os.fstat(number).st_mode & 0o777))
    write_file(tmp_path / "a", b"new", overwrite=True)
    assert modes == [0o600]


def test_the_umask_of_the_process_is_never_touched(tmp_path, monkeypatch):
    def forbidden(_):
        raise AssertionError("the umask belongs to the whole process")

    monkeypatch.setattr(os, "umask", forbidden)
    write_file(tmp_path / "a", b"1")
    write_file(tmp_path / "a", b"2", overwrite=True)


@pytest.mark.posix
def test_a_link_is_followed_and_stays(tmp_path):
    (tmp_path / "far").mkdir()
    (tmp_path / "far" / "real").write_bytes(b"old")
    (tmp_path / "link").symlink_to("far/real")
    write_file(tmp_path / "link", b"new", overwrite=True)
    assert (tmp_path / "link").is_symlink()
    assert (tmp_path / "far" / "real").read_bytes() == b"new"
    write_file(tmp_path / "link", b"own", overwrite=True, follow_links=False)
    assert not (tmp_path / "link").is_symlink()
    assert (tmp_path / "far" / "real").read_bytes() == b"new"


@pytest.mark.posix
def test_links_in_a_circle_are_refused(tmp_path):
    (tmp_path / "a").symlink_to("b")
    (tmp_path / "b").symlink_to("a")
    with pytest.raises(WriteError, match="symbolic links"):
        write_file(tmp_path / "a", b"1", overwrite=True)
    assert (tmp_path / "a").is_symlink()


_HOLD = """
import sys, time, tempfile
from sketch2shape.writing.files import _lock
f = tempfile.NamedTemporaryFile(dir=sys.argv[1], prefix=".sketch2shape-", suffix=".tmp", delete=False)
_lock(f.fileno())
print("ready", flush=True)
time.sleep(60)
"""


@pytest.mark.posix
def test_sweep_removes_what_a_killed_process_left_and_nothing_in_use(tmp_path):
    (tmp_path / "mine.tmp").write_text("not ours")
    with subprocess.Popen([sys.executable, "-c", _HOLD, str(tmp_path)], stdout=subprocess.PIPE) as process:
        process.stdout.readline()
        assert sweep(tmp_path) == 0
        process.send_signal(signal.SIGKILL)
        process.wait()
    assert sweep(tmp_path) == 1
    assert os.listdir(tmp_path) == ["mine.tmp"]
    assert sweep(tmp_path / "missing") == 0


def test_a_second_run_is_kept_out_of_a_folder(tmp_path):
    with FolderLock(tmp_path), pytest.raises(WriteError, match="another run"), FolderLock(tmp_path):
        pass
    with FolderLock(tmp_path):
        pass


class _Pipe(io.RawIOBase):
    def __init__(self, error):
        self.error = error

    def writable(self):
        return True

    def write(self, _):
        raise self.error


def test_a_reader_that_went_away_is_no_error():
    write_stdout(b"x", _Pipe(BrokenPipeError()))


@pytest.mark.posix
def test_a_full_device_behind_stdout_is():
    with pytest.raises(WriteError, match="No space"):
        write_stdout(b"x", _Pipe(OSError(errno.ENOSPC, "No space left on device")))


def test_without_a_lock_module_files_are_written_all_the_same(tmp_path, monkeypatch):
    monkeypatch.setattr(write, "fcntl", None)
    with FolderLock(tmp_path):
        write_file(tmp_path / "a", b"1")
        write_file(tmp_path / "a", b"2", overwrite=True)
    assert (tmp_path / "a").read_bytes() == b"2"
    fresh, old = tmp_path / ".sketch2shape-1.tmp", tmp_path / ".sketch2shape-2.tmp"
    fresh.touch()
    old.touch()
    os.utime(old, (1e9, 1e9))
    assert sweep(tmp_path) == 1
    assert fresh.exists()


@pytest.mark.posix
def test_a_pipe_is_no_leftover(tmp_path):
    os.mkfifo(tmp_path / ".sketch2shape-1.tmp")
    assert sweep(tmp_path) == 0
