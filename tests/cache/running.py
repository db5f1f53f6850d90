"""The program in this process, with a cache of its own."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Any
from typing import NamedTuple

import pytest

from bringup_lint import __main__
from bringup_lint.cache import answers
from bringup_lint.cli import streams


class Run(NamedTuple):
    """What a run said, and whether it looked at anything to do so."""

    text: str
    said: str
    code: int
    is_answered: bool

    @property
    def shown(self) -> tuple[str, str, int]:
        return self[:3]


class Program:
    """bringup-lint in a folder; the cache is empty at first."""

    def __init__(self, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], top: Path):
        self.patch, self.capsys = monkeypatch, capsys
        self.tree, self.base = top / "tree", top / "cache"
        self.tree.mkdir()
        monkeypatch.delenv("BRINGUP_LINT_NO_CACHE")
        monkeypatch.setenv("XDG_CACHE_HOME", str(self.base))
        monkeypatch.chdir(self.tree)
        monkeypatch.setattr(__main__, "_settle", lambda: None)

    @property
    def folder(self) -> Path:
        return self.base / "bringup-lint"

    @property
    def entries(self) -> list[Path]:
        if not self.folder.is_dir():
            return []
        return sorted(path for path in self.folder.iterdir() if path.name != "key")

    def run(self, *arguments: str) -> Run:
        streams.said.clear()
        streams.written.clear()
        self.capsys.readouterr()
        ran: list[object] = []
        with self.patch.context() as patch:
            patch.setattr(sys, "argv", ["bringup-lint", "--output-format", "concise", *arguments])
            dispatch = sys.modules["bringup_lint.cli"].dispatch
            patch.setattr("bringup_lint.cli.dispatch", lambda *words, **more: (ran.append(1), dispatch(*words, **more)))
            with pytest.raises(SystemExit) as ended:
                __main__.main()
        shown = self.capsys.readouterr()
        return Run(shown.out, shown.err, int(ended.value.code or 0), not ran)


def entry(path: Path) -> dict[str, Any]:
    """What a file of the cache holds."""
    found = answers._entry(path.read_bytes()[len(answers._FORMAT) + answers._SEAL :])
    assert found is not None
    return found
