"""The static evaluator of Python launch files."""

from __future__ import annotations

import textwrap

import pytest
from hypothesis import HealthCheck
from hypothesis import given
from hypothesis import settings
from hypothesis import strategies as st

from bringup_lint.model.launch import Action
from bringup_lint.model.launch import DeclareArgument
from bringup_lint.model.launch import EventHandler
from bringup_lint.model.launch import Group
from bringup_lint.model.launch import Include
from bringup_lint.model.launch import LaunchFile
from bringup_lint.model.launch import Node
from bringup_lint.model.launch import Other
from bringup_lint.model.launch import walk_actions
from bringup_lint.model.launch_values import Argument
from bringup_lint.model.launch_values import Choice
from bringup_lint.model.launch_values import Concat
from bringup_lint.model.launch_values import DictValue
from bringup_lint.model.launch_values import Literal
from bringup_lint.model.launch_values import PackageShare
from bringup_lint.model.launch_values import PathJoin
from bringup_lint.model.launch_values import literal
from bringup_lint.model.launch_values import walk
from bringup_lint.parsers.launch_python import parse
from bringup_lint.source import Located
from bringup_lint.source import Source
from bringup_lint.source import Span

HEAD = """\
import os
from launch import LaunchDescription
from launch.actions import *
from launch.actions import (DeclareLaunchArgument, GroupAction, IncludeLaunchDescription, OpaqueFunction,
    RegisterEventHandler, TimerAction, ExecuteProcess)
from launch.conditions import IfCondition, UnlessCondition
from launch.event_handlers import OnProcessExit
from launch.launch_description_sources import PythonLaunchDescriptionSource
from launch.substitutions import LaunchConfiguration, PathJoinSubstitution, PythonExpression
from launch_ros.actions import Node, LifecycleNode, ComposableNodeContainer
from launch_ros.descriptions import ComposableNode
from launch_ros.substitutions import FindPackageShare
from ament_index_python.packages import get_package_share_directory
"""


def read(body: str) -> LaunchFile:
    return parse(Source("robot.launch.py", HEAD + textwrap.dedent(body)))


def described(items: str, before: str = "") -> LaunchFile:
    lines = textwrap.dedent(before).strip().splitlines()
    inner = "\n".join("    " + line for line in [*lines, f"return LaunchDescription([{items}])"])
    return read(f"def generate_launch_description():\n{inner}\n")


def nodes(file: LaunchFile) -> list[Node]:
    return [action for action in walk_actions(file.actions) if isinstance(action, Node)]


def names(file: LaunchFile) -> list[str | None]:
    return [literal(node.name) for node in nodes(file)]


def node(name: str) -> str:
    return f"Node(package='p', executable='e', name='{name}')"


def test_node_fields_are_located() -> None:
    file = described("Node(package='demo', executable='talker', name='chatter', parameters=[{'rate': 5}])")
    (found,) = nodes(file)
    name = literal(found.name)
    assert name == "chatter"
    assert name.span.text == "chatter"
    assert isinstance(found.parameters[0], DictValue)
    assert found.parameters[0].get("rate").value == 5
    assert file.coverage.share == 1.0


CONSTRUCTS = {
    "add_action": ("ld", "ld = []\nld.append({a})\nld += [{b}]"),
    "loop": ("*out", "out = []\nfor n in ('a', 'b'):\n    out.append(Node(package='p', executable='e', name=n))"),
    "comprehension": ("*[Node(package='p', executable='e', name=n) for n in ['a', 'b']]", ""),
    "nested function": ("make('a'), make('b')", "def make(n): return Node(package='p', executable='e', name=n)"),
    "lambda": ("*map(make, ['a', 'b'])", "make = lambda n: Node(package='p', executable='e', name=n)"),
    "f-string": (
        "*out",
        "out = [Node(package='p', executable='e', name=f'{n}') for n in 'a b'.split()]",
    ),
    "dictionary": (
        "*out",
        "base = {'package': 'p', 'executable': 'e'}\nout = [Node(**base, name=n) for n in ('a', 'b')]",
    ),
    "merge": (
        "*out",
        "base = {'package': 'p'}\nout = [Node(**{**base, 'executable': 'e', 'name': n}) for n in ('a', 'b')]",
    ),
    "enumerate": (
        "*out",
        "out = []\nfor i, n in enumerate(['a', 'b']):\n    out.insert(i, Node(package='p', executable='e', name=n))",
    ),
    "zip": (
        "*out",
        "out = [Node(package=p, executable='e', name=n) for p, n in zip(['x', 'y'], ['a', 'b'])]",
    ),
    "known branch": ("*out", "if True:\n    out = [{a}, {b}]\nelse:\n    out = []"),
    "format": (
        "*out",
        "out = [Node(package='p', executable='e', name='{}'.format(n)) for n in ('a', 'b')]",
    ),
    "percent": ("*out", "out = [Node(package='p', executable='e', name='%s' % n) for n in ('a', 'b')]"),
    "generator": ("*make()", "def make():\n    yield {a}\n    yield from [{b}]"),
    "unpacking": ("x, y", "x, y = {a}, {b}"),
    "group": ("GroupAction([{a}, GroupAction(actions=[{b}])])", ""),
    "timer": ("TimerAction(period=3.0, actions=[{a}]), {b}", ""),
    "opaque": ("OpaqueFunction(function=setup)", "def setup(context, *args):\n    return [{a}, {b}]"),
    "handler": (
        "{a}, RegisterEventHandler(OnProcessExit(target_action=None, on_exit=[{b}]))",
        "",
    ),
    "handler function": (
        "{a}, RegisterEventHandler(OnProcessExit(on_exit=lambda event, context: [{b}]))",
        "",
    ),
    "description in description": ("", "return LaunchDescription([{a}, LaunchDescription([{b}])])"),
}


@pytest.mark.parametrize("construct", CONSTRUCTS)
def test_construct_gives_both_nodes(construct: str) -> None:
    items, before = CONSTRUCTS[construct]
    fill = {"a": node("a"), "b": node("b")}
    for key, value in fill.items():
        items, before = items.replace(f"{{{key}}}", value), before.replace(f"{{{key}}}", value)
    file = described(items if items != "ld" else "*ld", before)
    assert names(file) == ["a", "b"]
    assert not [action for action in walk_actions(file.actions) if isinstance(action, Other)]


def test_description_is_built_up() -> None:
    file = read(
        """
        def generate_launch_description():
            ld = LaunchDescription()
            ld.add_action(Node(package='p', executable='e', name='a'))
            for n in ['b', 'c']:
                ld.add_action(Node(package='p', executable='e', name=n))
            return ld
        """
    )
    assert names(file) == ["a", "b", "c"]


def test_unknown_branches_are_kept_with_their_conditions() -> None:
    file = read(
        f"""
        def generate_launch_description():
            ld = LaunchDescription()
            if os.path.exists('/dev/lidar'):
                ld.add_action({node("real")})
            else:
                ld.add_action({node("fake")})
            ld.add_action({node("always")})
            return ld
        """
    )
    real, fake, always = nodes(file)
    assert [condition.wanted for condition in real.conditions + fake.conditions] == [True, False]
    assert real.conditions[0].predicate is fake.conditions[0].predicate
    assert always.conditions == ()


def test_early_return_leaves_a_condition_on_the_rest() -> None:
    file = read(
        f"""
        def generate_launch_description():
            if os.getenv('MODE') == 'dry':
                return LaunchDescription([{node("dry")}])
            return LaunchDescription([{node("wet")}])
        """
    )
    dry, wet = nodes(file)
    assert dry.conditions[0].wanted is True
    assert wet.conditions[0].wanted is False


def test_variable_of_two_branches_is_a_choice() -> None:
    file = described("Node(package='p', executable='e', name=n)", "n = 'a'\nif os.getenv('X') == '1':\n    n = 'b'")
    name = nodes(file)[0].name
    assert isinstance(name, Choice)
    assert [option.value for _, option in name.options] == ["b", "a"]


def test_paths() -> None:
    file = described(
        """IncludeLaunchDescription(PythonLaunchDescriptionSource(os.path.join(share, 'launch', 'x.launch.py')),
             launch_arguments={'map': LaunchConfiguration('map', default='m'), 'n': '1'}.items()),
           IncludeLaunchDescription(PathJoinSubstitution([FindPackageShare('other'), 'launch', 'y.launch.py']))""",
        "share = get_package_share_directory('mine')",
    )
    first, second = file.actions
    assert isinstance(first, Include)
    assert isinstance(first.file, PathJoin)
    assert isinstance(first.file.parts[0], PackageShare)
    assert [literal(key) for key, _ in first.arguments] == ["map", "n"]
    assert isinstance(first.arguments[0][1], Argument)
    assert literal(second.file.parts[0].package) == "other"


def test_arguments_and_reads() -> None:
    file = described(
        "DeclareLaunchArgument('map', default_value='', choices=['', 'a']), Node(package='p', executable='e', "
        "name=[LaunchConfiguration('map'), '_x'])"
    )
    declare, started = file.actions
    assert isinstance(declare, DeclareArgument)
    assert [literal(choice) for choice in declare.choices] == ["", "a"]
    assert isinstance(started.name, Concat)
    assert [str(read.name) for read in file.reads] == ["map"]


def test_opaque_function_compares_arguments() -> None:
    file = read(
        f"""
        def setup(context):
            mode = LaunchConfiguration('mode').perform(context)
            if mode == 'real':
                return [{node("driver")}]
            return [{node("mock")}]

        def generate_launch_description():
            return LaunchDescription([DeclareLaunchArgument('mode'), OpaqueFunction(function=setup)])
        """
    )
    driver, mock = nodes(file)
    assert driver.conditions[0].wanted is True
    assert mock.conditions[0].wanted is False


def test_components_and_handlers_keep_identity() -> None:
    file = read(
        """
        def generate_launch_description():
            check = ExecuteProcess(cmd=['test', '-e', '/dev/lidar'])
            container = ComposableNodeContainer(name='c', namespace='', package='rclcpp_components',
                executable='component_container', composable_node_descriptions=[
                    ComposableNode(package='p', plugin='p::A', name='a')])
            return LaunchDescription([check, container, RegisterEventHandler(
                OnProcessExit(target_action=check, on_exit=[GroupAction([container])]))])
        """
    )
    check, container, handler = file.actions
    assert isinstance(handler, EventHandler)
    assert handler.target == check.key
    assert isinstance(handler.actions[0], Group)
    assert handler.actions[0].actions[0].key == container.key
    assert literal(container.components[0].plugin) == "p::A"


@pytest.mark.parametrize(
    "body",
    [
        "def generate_launch_description():\n    return generate_launch_description()\n",
        "def generate_launch_description():\n    x = []\n    x.append(x)\n    return LaunchDescription(x)\n",
        "def generate_launch_description():\n    while True:\n        pass\n    return LaunchDescription([])\n",
        "def generate_launch_description():\n    x = 'a'\n    for i in range(60):\n        x = x + x\n    return "
        "LaunchDescription([Node(name=x)])\n",
        "def generate_launch_description():\n    x = LaunchConfiguration('a')\n    for i in range(60):\n        x = "
        "[x, x]\n    return LaunchDescription([Node(package='p', executable='e', name=x)])\n",
        "x = [y for a in range(9999) for b in range(9999) for y in range(9999)]\n",
        "def f(n):\n    return [f(n), f(n), f(n)]\ndef generate_launch_description():\n    return "
        "LaunchDescription(f(1))\n",
        "x = " + "(" * 90 + "1" + ")" * 90,
        "x = " + "+".join(["1"] * 3000),
        "x = " + "a." * 3000 + "b",
        "x = 1 << 1000000\ny = 'a' * 10**12\nz = 10 ** 10 ** 10\n",
        "if x:\n" + "".join("  " * i + f" if x{i}:\n" for i in range(1, 30)) + "  " * 30 + " pass\n",
        "\ufeffdef generate_launch_description():\n    return LaunchDescription([Node(package='é', executable='ü', "
        "name='ñ')])\n",
        "def generate_launch_description(:\n",
        "\x00",
    ],
)
def test_hostile_input_ends_quickly(body: str) -> None:
    file = parse(Source("robot.launch.py", body))
    check_spans(file)


def spans(file: LaunchFile):
    for action in walk_actions(file.actions):
        yield from spans_of(action)
    for problem in file.problems:
        yield problem.where.span if isinstance(problem.where, Located) else problem.where
    for argument in file.reads:
        yield argument.span
        yield argument.name.span
    for call in file.calls:
        yield call.span


def spans_of(action: Action):
    yield action.span
    for name in ("package", "executable", "name", "namespace", "file", "value", "default", "plugin"):
        value = getattr(action, name, None)
        if value is not None:
            for inner in walk(value):
                yield inner.span
                if isinstance(inner, Literal) and isinstance(inner.value, Located):
                    yield inner.value.span


def check_spans(file: LaunchFile) -> None:
    length = len(file.source.text)
    for span in spans(file):
        assert isinstance(span, Span)
        assert 0 <= span.start <= span.end <= length


WORDS = st.sampled_from(
    [
        "\n",
        "\n    ",
        "\n        ",
        " ",
        *"""LaunchDescription Node LaunchConfiguration GroupAction OpaqueFunction 'x' f'{x}' x y ld [ ] ( ) { } , :
    = + . * ** if else for in not and or lambda def return generate_launch_description os.path.join 'é' add_action
    append while try except context perform [0] == items() 1 2.5 None True""".split(),
    ]
)


@settings(suppress_health_check=[HealthCheck.too_slow])
@given(st.lists(WORDS, max_size=40))
def test_no_token_soup_makes_it_raise(words: list[str]) -> None:
    body = "def generate_launch_description():\n    " + " ".join(words) + "\n"
    check_spans(parse(Source("robot.launch.py", HEAD + body)))


@given(st.text(max_size=200))
def test_no_text_makes_it_raise(text: str) -> None:
    check_spans(parse(Source("robot.launch.py", text)))


NAMES = st.text(
    st.characters(codec="utf-8", exclude_characters="'\\\r\n", exclude_categories=("Cc", "Cs")), max_size=12
)


@given(NAMES, NAMES)
def test_columns_count_code_points(before: str, name: str) -> None:
    file = described(f"Node(package='{before}', executable='e', name='{name}')")
    (found,) = nodes(file)
    assert literal(found.name) == name
    assert literal(found.name).span.text == name


def test_third_word_of_an_argument_describes_it() -> None:
    (argument,) = described("DeclareLaunchArgument('map', 'hall', 'Which map to load')").actions
    assert isinstance(argument, DeclareArgument)
    assert argument.description is not None and literal(argument.description) == "Which map to load"


def test_an_item_beyond_the_end_of_a_list_is_not_known() -> None:
    file = described("*nodes", "nodes = [Node(package='a', executable='a')]\nnodes.pop(3)")
    assert len(list(walk_actions(file.actions))) >= 1
    assert [node.executable for node in walk_actions(file.actions) if isinstance(node, Node)]


def test_conditions_that_are_partly_known_keep_what_is_unknown() -> None:
    file = read(
        """
        def setup(context):
            if LaunchConfiguration('sim').perform(context) == 'true' and True:
                return [Node(package='a', executable='a')]

        def generate_launch_description():
            return LaunchDescription([OpaqueFunction(function=setup)])
        """
    )
    (node,) = (action for action in walk_actions(file.actions) if isinstance(action, Node))
    (condition,) = node.conditions
    assert [type(operand).__name__ for operand in condition.predicate.operands] == ["Operation", "Literal"]


def test_a_decorator_of_any_depth_is_read() -> None:
    file = read(
        f"""
        class Rover:
            @({"+".join("1" * 2000)})
            def made():
                return []

            @staticmethod
            def started():
                return []

        def generate_launch_description():
            return LaunchDescription([*Rover.started(1), *Rover.made(1)])
        """
    )
    assert [call.owner for call in file.calls_refused] == ["Rover.started"]


def test_calls_of_functions_with_very_many_arguments_are_not_judged() -> None:
    file = read(
        f"""
        def started({", ".join(f"a{each}" for each in range(300))}):
            return []

        def generate_launch_description():
            return LaunchDescription(started(1))
        """
    )
    assert not file.calls_refused
