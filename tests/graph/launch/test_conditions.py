"""Nodes of which launch starts one or the other, and variables that launch files set."""

from __future__ import annotations

from pathlib import Path

from bringup_lint.graph.launch.started import exclusive
from tests.graph.launch.test_launch import tree


def test_nodes_of_different_values_exclude_each_other(tmp_path: Path) -> None:
    launch = tree(
        tmp_path,
        {
            "launch/a.launch.xml": """\
                <launch>
                  <arg name="mode"/>
                  <node pkg="p" exec="e" name="a" if="$(equals $(var mode) map)"/>
                  <node pkg="p" exec="e" name="b" if="$(equals $(var mode) nav)"/>
                  <node pkg="p" exec="e" name="c" if="$(equals $(var mode) nav)"/>
                </launch>"""
        },
    )
    (expansion,) = launch.expansions
    one, other, same = expansion.nodes
    assert exclusive(one, other) and exclusive(other, one)
    assert not exclusive(other, same)
