"""What xacro may put for a variable, in descriptions that are made to keep the expansion busy."""

from __future__ import annotations

from bringup_lint.graph.plugins.xacro_values import HOLE
from bringup_lint.graph.plugins.xacro_values import XacroValues
from bringup_lint.parsers.xml import parse
from bringup_lint.source import Source
from tests.growth import is_linear

ROBOT = '<robot xmlns:xacro="http://www.ros.org/wiki/xacro">{}</robot>'


def names(description: str) -> set[str]:
    root = parse(Source("a.urdf.xacro", ROBOT.format(description))).root
    assert root is not None
    values = XacroValues()
    values.take(root)
    link = next(each for each in root.walk() if each.name == "link")
    return values.names(str(link.get("name")), link)


def calling_itself(calls: int) -> str:
    again = '<xacro:arm side="${side}"/>' * calls
    macro = f'<xacro:macro name="arm" params="side"><link name="${{side}}_arm"/>{again}</xacro:macro>'
    return f'{macro}<xacro:arm side="left"/>'


def test_a_macro_may_call_itself_many_times() -> None:
    assert "left_arm" in names(calling_itself(3))
    assert is_linear(lambda size: names(calling_itself(size)), 40)


def test_a_name_of_very_many_parts_is_not_known() -> None:
    call = '<xacro:property name="a" value="x"/><xacro:property name="a" value="y"/>'
    found = names(f'{call}<link name="{"${a}" * 5000}"/>')
    assert found == {HOLE * 5000}
