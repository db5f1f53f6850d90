"""Graphviz itself reads every drawing, and shows every label as it was."""

from __future__ import annotations

import os
import shutil
import subprocess
import xml.etree.ElementTree as ElementTree
from itertools import pairwise
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given
from hypothesis import settings
from hypothesis import strategies as st

from bringup_lint.report.picture.dot import render
from tests.conftest import PROJECT
from tests.lint import lint

pytestmark = pytest.mark.skipif(shutil.which("dot") is None, reason="Graphviz is not installed")

SVG = "{http://www.w3.org/2000/svg}"
ODD = st.text(st.characters(codec="utf-8") | st.sampled_from('"\\&<>{}|;\n%#'), min_size=1, max_size=40)


def svg(dot: str) -> ElementTree.Element:
    run = subprocess.run(["dot", "-Tsvg"], input=dot.encode(), capture_output=True, check=False, timeout=300)
    assert (run.returncode, run.stderr) == (0, b"")
    return ElementTree.fromstring(run.stdout)


def drawing(*labels: str) -> dict[str, Any]:
    """A document with these nodes, each leading to the next."""
    nodes = [
        {
            "id": f"unit:{at}{label}",
            "kind": "unit",
            "layer": "boot",
            "label": label,
            "path": label,
            "line": 1,
            "findings": [],
        }
        for at, label in enumerate(labels)
    ]
    edges = [
        {
            "source": one["id"],
            "target": other["id"],
            "kind": "orders",
            "why": one["label"],
            "origin": "setting",
            "condition": "",
            "findings": [],
        }
        for one, other in pairwise(nodes)
    ]
    layers = [{"id": "boot", "title": labels[0]}]
    return {"layers": layers, "focus": [], "nodes": nodes, "edges": edges, "findings": []}


@settings(max_examples=40, deadline=None)
@given(st.lists(ODD, min_size=1, max_size=5))
def test_odd_labels(labels: list[str]) -> None:
    drawn = svg(render(drawing(*labels)))
    assert len(drawn.findall(f".//{SVG}g[@class='node']")) == len(labels)
    assert len(drawn.findall(f".//{SVG}g[@class='edge']")) == len(labels) - 1


@pytest.mark.parametrize(
    "label", ['a"b', "a\\b", "a\\nb", "a&amp;b", "<b>a</b>", "{a|b}", "a -> b;", "%a #b", "\\N \\G \\"]
)
def test_labels_come_out_as_they_were(label: str) -> None:
    texts = [text.text for text in svg(render(drawing(label))).findall(f".//{SVG}text")]
    assert [text.replace("\N{NO-BREAK SPACE}", " ") for text in texts] == [label, label]


@pytest.mark.parametrize("robot", ["good", "guide"])
def test_robots(robot: str) -> None:
    drawn = svg(lint("graph", "--root", ".", cwd=PROJECT / "fixtures/robots" / robot / "tree").stdout)
    assert len(drawn.findall(f".//{SVG}g[@class='cluster']")) >= 6


@pytest.mark.corpus
def test_corpus(corpus: Path) -> None:
    for repository in sorted(path for path in corpus.iterdir() if path.is_dir()):
        run = lint("graph", os.fspath(repository), cwd=PROJECT)
        assert run.code == 0, repository.name
        parsed = subprocess.run(["nop", "-p"], input=run.stdout.encode(), capture_output=True, check=False)
        assert (parsed.returncode, parsed.stderr) == (0, b""), repository.name
