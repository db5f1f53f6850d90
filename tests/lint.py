"""Runs the real command inside this process: the same arguments, the same output, the same exit code."""

from __future__ import annotations

import contextlib
import io
import os
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

from bringup_lint.cli import dispatch


class Run(NamedTuple):
    code: int
    stdout: str
    stderr: str


def lint(*arguments: str | Path, cwd: Path) -> Run:
    """``bringup-lint ARGUMENTS`` in a folder."""
    out, err = io.StringIO(), io.StringIO()
    with _inside(cwd), contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
        try:
            dispatch([str(argument) for argument in arguments])
            code = 0
        except SystemExit as stop:
            code = stop.code if isinstance(stop.code, int) else int(stop.code is not None)
    return Run(code, out.getvalue(), err.getvalue())


@contextlib.contextmanager
def _inside(folder: Path) -> Iterator[None]:
    before = os.getcwd()
    os.chdir(folder)
    try:
        yield
    finally:
        os.chdir(before)
