"""Headers that nothing includes, and those that something does."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from bringup_lint.discover.walk import discover
from bringup_lint.robot import Robot
from bringup_lint.source import Source

TREE = {
    "weir/include/weir/gate.hpp": "// the gate\n",
    "weir/include/weir/lock.hpp": "// the lock\n",
    "weir/src/lock.cpp": '#include "weir/lock.hpp"\n',
}


def leads_to(folder: Path, files: dict[str, str], name: str) -> bool:
    for each, text in (TREE | files).items():
        path = folder / each
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
    source = Source(os.fspath(folder / name), "\n")
    return Robot(discover([str(folder)])).leads_to(source.span(0, 1))


@pytest.mark.parametrize(
    ("files", "expected"),
    [
        ({}, False),
        ({"dam/src/dam.cpp": '#include "dam/gate.hpp"\n'}, False),
        ({"weir/src/gate.cpp": "#include <weir/gate.hpp>\n"}, True),
        ({"weir/include/weir/lock.hpp": '#include "gate.hpp"\n'}, True),
        ({"weir/include/weir/lock.hpp": '#include "../weir/gate.hpp"\n'}, True),
        ({"weir/include/weir/lock.hpp": "#include GATE\n"}, True),
        ({"weir/src/lock.cpp": '#include "lock.hpp"\n'}, True),
        ({"weir/src/gate.cu": '#include "weir/gate.hpp"\n'}, True),
        ({"weir/firmware/firmware.ino": '#include "weir/gate.hpp"\n'}, True),
    ],
)
def test_headers(tmp_path: Path, files: dict[str, str], *, expected: bool) -> None:
    assert leads_to(tmp_path, files, "weir/include/weir/gate.hpp") is expected


def test_what_is_no_header(tmp_path: Path) -> None:
    assert leads_to(tmp_path, {}, "weir/src/lock.cpp")
    assert leads_to(tmp_path, {}, "weir/include/weir/lock.hpp")


def test_too_many_files(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("bringup_lint.graph.unincluded._MOST", 1)
    assert leads_to(tmp_path, {}, "weir/include/weir/gate.hpp")
