"""The commands that write the HTML page, over a robot of the fixtures."""

from __future__ import annotations

import json
import re
from pathlib import Path
from typing import Any

from tests.conftest import PROJECT
from tests.lint import lint

GUIDE = PROJECT / "fixtures/robots/guide/tree"


def data_of(text: str) -> dict[str, Any]:
    return json.loads(re.search(r'id="data">(.*?)</script>', text)[1])


def test_report_holds_the_findings_and_the_picture(tmp_path: Path) -> None:
    file = tmp_path / "bringup.html"
    run = lint("--root", ".", "--output-format", "concise", "--output-format", "html", "--output-file", file, cwd=GUIDE)
    text = file.read_text("utf-8")
    assert text.count("<article") == len(run.stdout.splitlines())
    data = data_of(text)
    stack = next(node for node in data["nodes"] if node["label"] == "heron-stack.service")
    assert {data["findings"][index]["path"] for index in stack["findings"]} == {stack["path"]}
    placed = {index for item in (*data["nodes"], *data["edges"]) for index in item["findings"]}
    assert len(placed) > len(data["findings"]) / 2


def test_graph_is_the_picture_alone() -> None:
    run = lint("graph", "--format", "html", "--root", ".", cwd=GUIDE)
    assert run.code == 0, run.stderr
    assert "<article" not in run.stdout
    assert any(node["label"] == "heron-stack.service" for node in data_of(run.stdout)["nodes"])


def test_a_secret_of_the_tree_is_not_on_the_page(tmp_path: Path) -> None:
    (tmp_path / "robot.service").write_text(
        "[Service]\nEnvironment=UPLOAD_TOKEN=winter-harbour-91\nExecStart=/usr/bin/upload --token winter-harbour-91\n"
    )
    for arguments in (("--output-format", "html"), ("graph", "--format", "html")):
        text = lint(*arguments, ".", cwd=tmp_path).stdout
        assert "robot.service" in text
        assert "winter-harbour-91" not in text
