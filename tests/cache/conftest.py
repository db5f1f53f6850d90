from __future__ import annotations

from collections.abc import Iterable
from functools import cache
from pathlib import Path

import pytest

from bringup_lint.cache import program as program_module
from tests.cache.running import Program
from tests.conftest import PROJECT

files_of, times_of, names_in = program_module._files, program_module._times, program_module._names


@cache
def files_of_the_project(folder: str, by_content: bool) -> tuple[program_module.Mark, ...]:
    return tuple(files_of(folder, by_content))


times_of_the_project = cache(lambda: tuple(times_of(str(PROJECT))))
names_in_the_project = cache(lambda: tuple(names_in(str(PROJECT))))


def _files(folder: str, by_content: bool) -> Iterable[program_module.Mark]:
    is_own = folder.startswith(f"{PROJECT}/")
    return files_of_the_project(folder, by_content) if is_own else files_of(folder, by_content)


def _times(folder: str) -> Iterable[str]:
    return times_of_the_project() if folder == str(PROJECT) else times_of(folder)


def _names(folder: str) -> Iterable[str]:
    return names_in_the_project() if folder == str(PROJECT) else names_in(folder)


@pytest.fixture
def program(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], tmp_path: Path) -> Program:
    """No test changes the files of the project, so that they are looked at once. Its folder is in ``sys.path`` and does
    change: tools that run beside leave their caches in it."""
    monkeypatch.setattr(program_module, "_files", _files)
    monkeypatch.setattr(program_module, "_times", _times)
    monkeypatch.setattr(program_module, "_names", _names)
    return Program(monkeypatch, capsys, tmp_path)
