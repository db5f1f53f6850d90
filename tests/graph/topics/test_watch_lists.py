"""Which of two names of a node is the typo: the one that fewer places have."""

from __future__ import annotations

import json
import shutil
from pathlib import Path

import pytest

from tests.conftest import PROJECT
from tests.lint import lint

MOWER = PROJECT / "fixtures/node/heartbeat_unknown_node/bad/mower"


def fixes(tree: Path) -> dict[str, str | None]:
    """Missing name -> what the fix writes."""
    run = lint("--select", "node/heartbeat-unknown-node", "--output-format", "json", cwd=tree)
    found = json.loads(run.stdout)["findings"]
    return {
        each["message"].split("'")[1]: each["fix"] and each["fix"]["edits"][0]["text"]
        for each in found
        if each["location"]["path"].endswith("guard.yaml")
    }


@pytest.mark.parametrize(
    ("watched", "better"),
    [
        ('["basse", "base"]', "base"),
        ('["basse"]', "base"),
        ('["lidra"]', "lidar"),
        ('["lidra", "base"]\n    required_nodes: ["lidra"]', None),
        ('["lidra", "base"]\n    required_nodes: ["lidra"]\n    nodes_to_watch: ["lidra"]', None),
    ],
)
def test_the_typo_is_what_fewer_places_have(watched: str, better: str | None, tmp_path: Path) -> None:
    shutil.copytree(MOWER, tmp_path / "mower")
    guard = tmp_path / "mower/config/guard.yaml"
    guard.write_text(f"guard:\n  ros__parameters:\n    heartbeat_nodes: {watched}\n")
    assert set(fixes(tmp_path).values()) == {better}
