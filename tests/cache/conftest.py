from __future__ import annotations

from collections.abc import Iterable
from functools import cache
from pathlib import Path

import pytest

from bringup_lint.cache import program as program_module
from tests.cache.running import Program
from tests.conftest import PROJECT

files_of = program_module._files


@cache
def files_of_the_project(folder: str, by_content: bool) -> tuple[str, ...]:
    return tuple(files_of(folder, by_content))


def _files(folder: str, by_content: bool) -> Iterable[str]:
    is_own = folder.startswith(f"{PROJECT}/")
    return files_of_the_project(folder, by_content) if is_own else files_of(folder, by_content)


@pytest.fixture
def program(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], tmp_path: Path) -> Program:
    """No test changes the files of the project, so that they are looked at once."""
    monkeypatch.setattr(program_module, "_files", _files)
    return Program(monkeypatch, capsys, tmp_path)
