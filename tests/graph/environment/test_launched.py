"""Variables that launch files set."""

from __future__ import annotations

from pathlib import Path

from bringup_lint.graph.environment.launched import launch_variables
from tests.graph.launch.test_launch import tree


def test_variables_of_unknown_value_are_left_out(tmp_path: Path) -> None:
    launch = tree(
        tmp_path,
        {
            "launch/a.launch.xml": """\
                <launch>
                  <set_env name="KNOWN" value="7"/>
                  <set_env name="UNKNOWN" value="$(env HOME)"/>
                </launch>"""
        },
    )
    assert [(variable.name, variable.text) for variable in launch_variables(launch)] == [("KNOWN", "7")]
