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


def test_components_have_the_conditions_that_are_not_known(tmp_path: Path) -> None:
    launch = tree(
        tmp_path,
        {
            "launch/a.launch.py": """\
                from launch import LaunchDescription
                from launch.actions import DeclareLaunchArgument
                from launch.conditions import IfCondition
                from launch.substitutions import LaunchConfiguration
                from launch_ros.actions import LoadComposableNodes
                from launch_ros.descriptions import ComposableNode

                def generate_launch_description():
                    return LaunchDescription([
                        DeclareLaunchArgument('rear'),
                        LoadComposableNodes(target_container='cameras', composable_node_descriptions=[
                            ComposableNode(package='p', plugin='P', name='rear',
                                           condition=IfCondition(LaunchConfiguration('rear'))),
                            ComposableNode(package='p', plugin='P', name='front', condition=IfCondition('true')),
                            ComposableNode(package='p', plugin='P', name='top', condition=IfCondition('false')),
                        ]),
                    ])"""
        },
    )
    (expansion,) = launch.expansions
    assert [(node.fqn, len(node.conditions)) for node in expansion.nodes] == [("/rear", 1), ("/front", 0)]
