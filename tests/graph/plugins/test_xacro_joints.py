"""Descriptions that are made to keep the reader of their joints busy."""

from __future__ import annotations

from bringup_lint.graph.plugins.xacro_joints import FixedJoint
from bringup_lint.graph.plugins.xacro_joints import XacroJoints
from bringup_lint.parsers.xml import parse
from bringup_lint.source import Source

ROBOT = '<robot name="mole" xmlns:xacro="http://www.ros.org/wiki/xacro">{}</robot>'
JOINT = '<joint name="j" type="fixed"><parent link="base"/><child link="nose"/><origin xyz="${tip} 0 1"/></joint>'


def joints(body: str) -> list[FixedJoint]:
    root = parse(Source("mole.urdf.xacro", ROBOT.format(body))).root
    assert root is not None
    return list(XacroJoints([root], {}).fixed())


def properties(*pairs: tuple[str, str]) -> str:
    return "".join(f'<xacro:property name="{name}" value="{value}"/>' for name, value in pairs)


def test_a_property_of_properties_is_known() -> None:
    (joint,) = joints(properties(("tip", "${half + half}"), ("half", "${0.5 * pole}"), ("pole", "3")) + JOINT)
    assert joint.xyz == (3.0, 0.0, 1.0)


def test_properties_that_need_each_other_have_no_value() -> None:
    (joint,) = joints(properties(("tip", "${half}"), ("half", "${tip}")) + JOINT)
    assert joint.xyz is None


def test_properties_that_double_have_no_value() -> None:
    steps = [(f"p{at}", f"${{p{at + 1}}}${{p{at + 1}}}") for at in range(40)]
    (joint,) = joints(properties(("tip", "${p0}"), *steps, ("p40", "1")) + JOINT)
    assert joint.xyz is None


def test_a_long_way_of_properties_ends() -> None:
    steps = [(f"p{at}", f"${{p{at + 1}}}") for at in range(2_000)]
    (joint,) = joints(properties(("tip", "${p0}"), *steps, ("p2000", "1")) + JOINT)
    assert joint.xyz is None
