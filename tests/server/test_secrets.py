"""The editor is told no secret: neither with a finding nor on hovering, on the lines with secrets and beside them."""

from __future__ import annotations

import asyncio
from pathlib import Path

import pytest

from tests.report.planted import planted
from tests.server.conftest import editing

EVERY = 7
"""Of so many planted files, one is hovered over."""
TRIED = list(planted())[::EVERY]


@pytest.mark.slow
def test_nothing_said_to_the_editor_holds_a_secret(tmp_path: Path) -> None:
    paths = []
    for number, each in enumerate(TRIED):
        paths.append(tmp_path / f"robot{number}" / each.file)
        paths[-1].parent.mkdir(parents=True)
        paths[-1].write_text(each.text)
    said = asyncio.run(asyncio.wait_for(everything_said(tmp_path, paths), 300))
    assert len(said) > 500
    assert [each for each in TRIED if each.secret in said] == []


async def everything_said(folder: Path, paths: list[Path]) -> str:
    said = []
    async with editing(folder, options={"min_severity": "info"}) as editor:
        for path in paths:
            uri = editor.open(path)
            said += map(str, await editor.pulled(uri))
            for number, line in enumerate(path.read_text().splitlines()):
                said += [await editor.hovered(uri, number, at) for at in range(0, len(line), 4)]
    return "\n".join(said)
