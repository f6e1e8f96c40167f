"""Pipes, devices and open descriptors: written into, never replaced."""

from __future__ import annotations

import os
import stat
import sys
import threading

import pytest

from sketch2shape.errors import WriteError
from sketch2shape.writing import is_stream, write_file, write_stdout
from sketch2shape.writing import streams as streams_module


@pytest.mark.parametrize("overwrite", [False, True])
@pytest.mark.posix
def test_a_named_pipe_is_written_into(tmp_path, overwrite):
    pipe = tmp_path / "pipe"
    os.mkfifo(pipe)
    read = []
    reader = threading.Thread(target=lambda: read.append(pipe.read_bytes()))
    reader.start()
    write_file(pipe, b"x" * 200_000, overwrite=overwrite)
    reader.join(timeout=20)
    assert read == [b"x" * 200_000]
    assert stat.S_ISFIFO(pipe.stat().st_mode)


@pytest.mark.posix
def test_a_device_stays_a_device():
    write_file("/dev/null", b"1", overwrite=True)
    assert stat.S_ISCHR(os.stat("/dev/null").st_mode)
    if os.path.exists("/dev/full"):
        with pytest.raises(WriteError, match="No space"):
            write_file("/dev/full", b"1")


@pytest.mark.posix
def test_an_open_descriptor_is_written_on_from_where_it_stands(tmp_path):
    with open(tmp_path / "a", "wb") as file:
        file.write(b"before ")
        file.flush()
        write_file(f"/dev/fd/{file.fileno()}", b"after")
    assert (tmp_path / "a").read_bytes() == b"before after"


@pytest.mark.posix
def test_a_closed_descriptor_is_named(tmp_path):
    with pytest.raises(WriteError, match="/dev/fd/999"):
        write_file("/dev/fd/999", b"1")


@pytest.mark.posix
def test_a_reader_that_went_away_is_no_error():
    read, write = os.pipe()
    os.close(read)
    write_file(f"/dev/fd/{write}", b"1")
    os.close(write)


@pytest.mark.posix
def test_a_disk_is_refused(tmp_path, monkeypatch):
    monkeypatch.setattr(streams_module.stat, "S_ISBLK", lambda _: True)
    with pytest.raises(WriteError, match="is a disk"):
        write_file("/dev/null", b"1")


def test_files_and_folders_are_no_streams(tmp_path):
    (tmp_path / "a").touch()
    assert not any(map(is_stream, (tmp_path, tmp_path / "a", tmp_path / "new", "a\0b")))


def test_without_standard_output_the_error_says_so(monkeypatch):
    monkeypatch.setattr(sys, "stdout", None)
    with pytest.raises(WriteError, match="standard output is closed"):
        write_stdout(b"1")
