"""What is read of a launch file dies with its last user, and does not wait for a search for garbage."""

from __future__ import annotations

import gc
from collections.abc import Callable

import pytest

from bringup_lint.model.launch import LaunchFile
from bringup_lint.parsers import launch_python
from bringup_lint.parsers import launch_xml
from bringup_lint.source import Source

PYTHON = """\
def nodes(context):
    return [Node(package="a", executable="b")]


def generate_launch_description():
    return LaunchDescription([OpaqueFunction(function=nodes)])
"""
XML = '<launch><group><node pkg="a" exec="b"><param name="rate" value="1"/></node></group></launch>\n'


@pytest.mark.parametrize(("parse", "text"), [(launch_python.parse, PYTHON), (launch_xml.parse, XML)])
def test_no_syntax_is_left_over(parse: Callable[[Source], LaunchFile], text: str) -> None:
    parse(Source("warm", text))
    gc.collect()
    gc.disable()
    try:
        file = parse(Source("a", text))
        left = gc.collect()
    finally:
        gc.enable()
    assert file.actions
    assert left == 0
