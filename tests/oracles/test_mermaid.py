"""Mermaid itself reads every flowchart, and shows every label as it was.

The parser is in the npm packages ``mermaid`` and ``jsdom``; the folder that holds their ``node_modules`` is named by
``BRINGUP_LINT_MERMAID``.
"""

from __future__ import annotations

import json
import os
import re
import shutil
import subprocess
from pathlib import Path
from typing import Any

import pytest
from hypothesis import HealthCheck
from hypothesis import Phase
from hypothesis import given
from hypothesis import settings
from hypothesis import strategies as st

from bringup_lint.report.picture.mermaid import render
from tests.conftest import PROJECT
from tests.lint import lint
from tests.oracles.test_graphviz import ODD
from tests.oracles.test_graphviz import drawing

PARSER = Path(__file__).with_name("mermaid_parser.mjs")
_ENTITY = re.compile("ﬂ°°([0-9]+)¶ß")
"""How the parser keeps ``#34;`` until it draws."""


@pytest.fixture(scope="module")
def modules() -> str:
    folder = os.environ.get("BRINGUP_LINT_MERMAID", "")
    if not shutil.which("node") or not os.path.isdir(os.path.join(folder, "node_modules/mermaid")):
        pytest.skip("BRINGUP_LINT_MERMAID names no folder with mermaid")
    return folder


def parsed(modules: str, folder: Path, *charts: str) -> list[dict[str, Any]]:
    files = [folder / f"{at}.mmd" for at in range(len(charts))]
    for file, chart in zip(files, charts, strict=True):
        file.write_text(chart, "utf-8")
    run = subprocess.run(["node", PARSER, modules, *files], capture_output=True, text=True, check=False, timeout=600)
    assert run.returncode == 0, run.stderr[-2000:]
    return [json.loads(line) for line in run.stdout.splitlines()]


def shown(text: str) -> str:
    return _ENTITY.sub(lambda match: chr(int(match[1])), text)


@settings(max_examples=3, deadline=None, phases=[Phase.generate], suppress_health_check=list(HealthCheck))
@given(st.lists(st.lists(ODD.map(str.strip).filter(bool), min_size=1, max_size=5), min_size=40, max_size=60))
def test_odd_labels(modules: str, tmp_path: Path, charts: list[list[str]]) -> None:
    found = parsed(modules, tmp_path, *(render(drawing(*labels)) for labels in charts))
    for labels, chart in zip(charts, found, strict=True):
        assert [shown(text) for _, text in chart["nodes"]] == labels
        assert [shown(text) for *_, text in chart["edges"]] == labels[:-1]


def test_nothing_to_draw(modules: str, tmp_path: Path) -> None:
    chart = lint("graph", "--format", "mermaid", cwd=tmp_path).stdout
    assert parsed(modules, tmp_path, chart) == [{"nodes": [], "edges": [], "groups": []}]


@pytest.mark.parametrize("robot", ["good", "guide"])
def test_robots(modules: str, tmp_path: Path, robot: str) -> None:
    folder = PROJECT / "fixtures/robots" / robot / "tree"
    (chart,) = parsed(modules, tmp_path, lint("graph", "--format", "mermaid", "--root", ".", cwd=folder).stdout)
    document = json.loads(lint("graph", "--format", "json", "--root", ".", cwd=folder).stdout)
    labels = [shown(text).partition("<br")[0] for _, text in chart["nodes"]]
    assert labels == [node["label"] for node in document["nodes"]]
    titles = {layer["id"]: layer["title"] for layer in document["layers"]}
    assert {title for title, _ in chart["groups"]} == {titles[node["layer"]] for node in document["nodes"]}


@pytest.mark.corpus
def test_corpus(modules: str, corpus: Path, tmp_path: Path) -> None:
    repositories = sorted(path for path in corpus.iterdir() if path.is_dir())
    charts = [lint("graph", "--format", "mermaid", repository, cwd=PROJECT).stdout for repository in repositories]
    assert len(parsed(modules, tmp_path, *charts)) == len(repositories)
