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


@pytest.mark.parametrize(
    ("footprint", "line"),
    [('"[]"', 5), ('""', 5), ('"[[0.4, 0.3], [0.4, -0.3], [-0.4, -0.3], [-0.4, 0.3]]"', 4)],
)
def test_the_radius_counts_where_the_footprint_is_empty(footprint: str, line: int, tmp_path: Path) -> None:
    (tmp_path / "nav2.yaml").write_text(COSTMAP.format(footprint=footprint))
    select = ("--select", "params/nav2-contradiction")
    findings = json.loads(lint(*select, "--output-format", "json", "nav2.yaml", cwd=tmp_path).stdout)
    assert [each["location"]["start"]["line"] for each in findings] == [8]
    assert [each["related"][0]["location"]["start"]["line"] for each in findings] == [line]
