"""Which value a contradiction of Navigation2 is with."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from tests.lint import lint

COSTMAP = """\
local_costmap:
  local_costmap:
    ros__parameters:
      footprint: {footprint}
      robot_radius: 0.3
      plugins: [inflation]
      inflation:
        inflation_radius: 0.1
"""
LAUNCH = """<launch>
  <node pkg="nav2_controller" exec="controller_server"><param from="$(dirname)/nav2.yaml"/></node>
</launch>
"""


@pytest.mark.parametrize(
    ("footprint", "line"),
    [('"[]"', 5), ('""', 5), ('"[[0.4, 0.3], [0.4, -0.3], [-0.4, -0.3], [-0.4, 0.3]]"', 4)],
)
def test_the_radius_counts_where_the_footprint_is_empty(footprint: str, line: int, tmp_path: Path) -> None:
    (tmp_path / "nav2.yaml").write_text(COSTMAP.format(footprint=footprint))
    (tmp_path / "nav.launch.xml").write_text(LAUNCH)
    select = ("--select", "params/nav2-contradiction")
    report = json.loads(lint(*select, "--output-format", "json", ".", cwd=tmp_path).stdout)
    assert [each["location"]["start"]["line"] for each in report["findings"]] == [8]
    assert [each["related"][0]["location"]["start"]["line"] for each in report["findings"]] == [line]
