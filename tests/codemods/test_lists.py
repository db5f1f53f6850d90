"""Elements of list literals move with their comments, and every other byte stays."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from bringup_lint.codemods.lists import move_after
from bringup_lint.codemods.lists import move_before
from bringup_lint.codemods.lists import remove
from bringup_lint.finding import Codemod
from bringup_lint.source import Source
from bringup_lint.source import Span
from tests.lint import lint

DESCRIPTION = """\
# The launch file of the rover.
from launch import LaunchDescription

def generate_launch_description():
    return LaunchDescription([
        # what drives
        node(name),  # the base

        # the name of it
        declare('name'),   # needed
        other()
    ])  # end
"""
MOVED = """\
# The launch file of the rover.
from launch import LaunchDescription

def generate_launch_description():
    return LaunchDescription([

        # the name of it
        declare('name'),   # needed
        # what drives
        node(name),  # the base
        other()
    ])  # end
"""


def change(text: str, make: Callable[..., Codemod | None], *words: str) -> str:
    source = Source("robot.launch.py", text)
    codemod = make(*(Span(source, text.index(word), text.index(word) + len(word)) for word in words))
    return codemod.change(text) if codemod else "no"


def test_comments_move_with_their_element() -> None:
    assert change(DESCRIPTION, move_before, "declare", "node(") == MOVED


def test_line_ends_and_byte_order_mark_stay() -> None:
    before, after = (("\ufeff" + text).replace("\n", "\r\n") for text in (DESCRIPTION, MOVED))
    assert change(before, move_before, "declare", "node(") == after


def test_last_element_without_a_comma_moves() -> None:
    assert change("x = [\n    a,\n    b  # last\n]\n", move_before, "b ", "a,") == "x = [\n    b,  # last\n    a\n]\n"


@pytest.mark.parametrize(
    ("make", "words", "after"),
    [
        (move_after, ("'amcl'", "'map'"), "names = ['map', 'amcl', 'é']\n"),
        (move_after, ("'map'", "'amcl'"), "names = ['amcl', 'map', 'é']\n"),
        (move_before, ("'é'", "'amcl'"), "names = ['é', 'amcl', 'map']\n"),
        (remove, ("'é'",), "names = ['amcl', 'map']\n"),
        (remove, ("'amcl'",), "names = ['map', 'é']\n"),
    ],
)
def test_one_line(make: Callable[..., Codemod | None], words: tuple[str, ...], after: str) -> None:
    assert change("names = ['amcl', 'map', 'é']\n", make, *words) == after


def test_comma_after_the_last_element_stays() -> None:
    assert (
        change("x = [\n    a,  # a\n    b,  # b\n]\n", move_before, "b, ", "a,")
        == "x = [\n    b,  # b\n    a,  # a\n]\n"
    )


def test_removed_element_takes_its_comments_along() -> None:
    assert change("x = [\n    a,\n    # why b\n    b,  # b\n    c,\n]\n", remove, "b, ") == "x = [\n    a,\n    c,\n]\n"


@pytest.mark.parametrize("text", ["f(a, b)\n", "x = [a]\ny = [b]\n", "x = [a + b]\n", "x = [a, b\n"])
def test_what_shares_no_list_is_left_alone(text: str) -> None:
    assert change(text, move_before, "b", "a") == "no"


LAUNCH = {
    "arg-used-before-declare": """\
LaunchDescription([
        # the driver
        Node(package='rover', executable='drive', namespace=LaunchConfiguration('robot_name')),  # drives
        # the name of the robot
        DeclareLaunchArgument('robot_name', default_value='rover'),
    ])""",
    "env-set-too-late": """\
LaunchDescription([
        Node(package='rover', executable='drive'),
        SetEnvironmentVariable('RMW_IMPLEMENTATION', 'rmw_cyclonedds_cpp'),  # the fleet's
        Node(package='rover', executable='scan'),
    ])""",
    "remap-duplicate": """\
LaunchDescription([
        Node(package='rover', executable='drive', remappings=[
            ('scan', '/front/scan'),  # the front one
            ('odom', '/odom'),
            ('scan', '/rear/scan'),
        ]),
    ])""",
    "lifecycle-order": """\
LaunchDescription([
        Node(package='nav2_lifecycle_manager', executable='lifecycle_manager', name='manager', parameters=[{
            'autostart': True,
            'node_names': ['bt_navigator', 'planner_server'],  # navigation
        }]),
    ])""",
}
HEAD = """\
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, SetEnvironmentVariable
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node


def generate_launch_description():
    return """


@pytest.mark.parametrize("line_end", ["\n", "\r\n"], ids=["lf", "crlf"])
@pytest.mark.parametrize("rule", LAUNCH)
def test_fix_removes_the_finding_and_makes_no_other(rule: str, line_end: str, tmp_path: Path) -> None:
    path = tmp_path / "robot.launch.py"
    text = (HEAD + LAUNCH[rule] + "\n").replace("\n", line_end)
    path.write_bytes(text.encode())
    options = ("--output-format", "concise", "--min-severity", "info", ".")
    before = lint(*options, cwd=tmp_path).stdout.splitlines()
    assert sum(f"[launch/{rule}]" in line for line in before) == 1
    lint("--fix", "--unsafe-fixes", "--select", f"launch/{rule}", *options, cwd=tmp_path)
    fixed = path.read_bytes().decode()
    compile(fixed, "robot.launch.py", "exec")
    after = lint(*options, cwd=tmp_path).stdout.splitlines()
    assert sorted(map(rules_of, after)) == sorted(rules_of(line) for line in before if f"[launch/{rule}]" not in line)
    assert [line for line in comments(text) if line not in comments(fixed)] == []
    assert fixed.count("\r") == (fixed.count("\n") if line_end == "\r\n" else 0)
    lint("--fix", "--unsafe-fixes", "--select", f"launch/{rule}", *options, cwd=tmp_path)
    assert path.read_bytes().decode() == fixed


def rules_of(line: str) -> str:
    return line.partition("[")[2].partition("]")[0]


def comments(text: str) -> list[str]:
    return [line.partition("# ")[2].strip() for line in text.splitlines() if "# " in line]
